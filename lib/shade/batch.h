/* batch.h - the order in which batches of paths are traced. */
#ifndef SHADE_BATCH_H
#define SHADE_BATCH_H

#include "shade/context.h"
#include "shade/path.h"

/* A waiting batch, and the stack sizes of dielectrics and coincident sets below it; the last one on top. */
typedef struct wait { batch *paths; size_t dielectrics, coincident_sets; } wait;
typedef struct wait_stack { wait *items; size_t count, capacity; } wait_stack;

typedef struct batch_queue {
    batch *now, *reflected, *transmitted;   /* the present batch, and the batches that continue from it */
    batch *spare;
    wait_stack waits;            /* transmitted rays, at most one batch a level */
} batch_queue;

/* now, reflected and transmitted, empty. False: no memory. */
bool batch_make(batch_queue *q, const env *e);
/* Drop all waiting batches; no path is in a dielectric or on coincident surfaces. */
void batch_forget(batch_queue *q, shade_context *c);
/* Free all batches. */
void batch_free(batch_queue *q, const env *e);
/* Move the next of q->reflected, q->transmitted and the waiting batches to q->now. False: none, or c->failed. */
bool batch_next(batch_queue *q, shade_context *c);

#endif
