/* batch.h - the order in which batches of paths are traced. */
#ifndef SHADE_BATCH_H
#define SHADE_BATCH_H

#include "shade/context.h"
#include "shade/path.h"

/* A waiting batch, and the stack sizes of dielectrics and coincident sets below it; the last one on top. Or a sum that is
 * complete when its turn comes. Origins of rays that gather light wait for all their draws; draw: the next one. */
typedef struct wait { batch *paths; power_sum *sum; size_t dielectrics, coincident_sets; uint32_t draw; } wait;
typedef struct wait_stack { wait *items; size_t count, capacity; } wait_stack;

/* Batches that continue from one batch, in their order: each has at most one path of a camera ray. There is always a
 * first one; it may be empty. */
typedef struct branches { batch **items; size_t count, capacity; } branches;

typedef struct batch_queue {
    batch *now;                  /* the present batch */
    branches mirrored, powered, transmitted, gathered;   /* those that continue from it, in this order; of powered and gathered
                                                * ones there may be none */
    colour *out;                 /* where their colours are added */
    batch *spare;
    power_sum *spare_power;
    gather_origins *spare_gather;
    struct reuse *spare_reuse;
    wait_stack waits;
} batch_queue;

/* now, mirrored and transmitted, empty. False: no memory. */
bool batch_make(batch_queue *q, const env *e);
/* Drop all waiting batches; no path is in a dielectric or on coincident surfaces. */
void batch_forget(batch_queue *q, shade_context *c);
/* Free all batches. */
void batch_free(batch_queue *q, const env *e);
/* Empty the branches, for those of a batch whose colours are added to `out`. */
void batch_begin(batch_queue *q, colour *out);
/* The branch of the list that has no path of this camera ray and none behind it, for one more path; with a sum of its own in
 * the list of powered ones, with room for its origins in that of gathered ones. NULL: no memory. */
batch *batch_grow(batch_queue *q, const env *e, branches *list, uint32_t lane);
/* Give the batch a sum of its own. False: no memory. */
bool batch_add_power(batch_queue *q, const env *e, batch *b);
/* Room for what its samples find. False: no memory. */
bool batch_add_reuse(batch_queue *q, const env *e, power_sum *p);

static inline batch *batch_branch(batch_queue *q, const env *e, branches *list, uint32_t lane)
{
    batch *b = list->items[0];

    return b->last != lane ? b : batch_grow(q, e, list, lane);
}

/* Move the next of the branches and the waiting batches to q->now. False: none, or c->failed. */
bool batch_next(batch_queue *q, shade_context *c);

#endif
