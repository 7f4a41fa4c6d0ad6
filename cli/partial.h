/* partial.h - long renders: what there is, now and then, so that a later run may go on from it. */
#ifndef CLI_PARTIAL_H
#define CLI_PARTIAL_H

#include "messages.h"

typedef struct partial {
    const args *args;
    const messages *messages;
    pov_job *job;
    char path[4096];             /* of the checkpoint, beside the output; empty: none is kept */
    double every, last;          /* seconds between two, and when the last one was */
} partial;

/* Go on from the checkpoint, if one is wanted and there. */
pov_status partial_begin(partial *p, const args *a, const messages *m, pov_job *job, pov_error *err);
/* Is the next one due, `now` seconds after the start? */
bool partial_due(partial *p, double now);
/* One that cannot be written is no reason to end: it is said. */
void partial_save(const partial *p);
/* The picture is complete. */
void partial_forget(const partial *p);

#endif
