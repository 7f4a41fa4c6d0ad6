/* partial.h - checkpoints of long renders, from which a later run can continue. */
#ifndef CLI_PARTIAL_H
#define CLI_PARTIAL_H

#include "messages.h"

typedef struct partial {
    const args *args;
    const messages *messages;
    pov_job *job;
    char path[4096];             /* path of the checkpoint, beside the output; empty: none */
    double every, last;          /* seconds between two checkpoints, and the time of the last */
} partial;

/* Continue from the checkpoint, if one is wanted and exists. */
pov_status partial_begin(partial *p, const args *a, const messages *m, pov_job *job, pov_error *err);
/* Is the next one due, `now` seconds after the start? */
bool partial_due(partial *p, double now);
/* Write a checkpoint. A failure does not end the render: it prints a message. */
void partial_save(const partial *p);
/* The picture is complete. */
void partial_forget(const partial *p);

#endif
