/* batch.h - which paths are followed next. */
#ifndef SHADE_BATCH_H
#define SHADE_BATCH_H

#include "shade/context.h"
#include "shade/path.h"

/* A batch that waits, and how many dielectrics and coincident sets there are behind it; the last of them on top. */
typedef struct wait { batch *paths; size_t dielectrics, coincident_sets; } wait;
typedef struct wait_stack { wait *items; size_t count, capacity; } wait_stack;

typedef struct batch_queue {
    batch *now, *reflected, *transmitted;   /* being followed, and those that go on from it */
    batch *spare;
    wait_stack waits;            /* transmitted rays, at most one batch a level */
} batch_queue;

/* now, reflected and transmitted, empty. False: no memory. */
bool batch_make(batch_queue *q, const env *e);
/* Nothing waits any more, and no path is in a dielectric or on coincident surfaces. */
void batch_forget(batch_queue *q, shade_context *c);
/* All there are. */
void batch_free(batch_queue *q, const env *e);
/* Of q->reflected, q->transmitted and those that wait, the next batch into q->now. False: none, or c->failed. */
bool batch_next(batch_queue *q, shade_context *c);

#endif
