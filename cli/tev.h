/* tev.h - the growing picture, sent to the viewer tev by its protocol. */
#ifndef CLI_TEV_H
#define CLI_TEV_H

#include "messages.h"

typedef struct tev {
    const messages *messages;
    int socket;                  /* below zero: none, or the viewer is gone */
    char name[256];              /* of the picture there */
} tev;

/* Connect to a->tev, and make a picture there. Without --tev nothing happens, here and below. */
pov_status tev_begin(tev *t, const args *a, const messages *m, int width, int height, pov_error *err);
/* Send all tiles that have changed. If the viewer is gone, say so, once. */
void tev_send(tev *t, pov_job *job);
void tev_end(tev *t);

#endif
