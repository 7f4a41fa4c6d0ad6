/* query.h - a query under way, for single rays and many. */
#ifndef WORLD_QUERY_H
#define WORLD_QUERY_H

#include "world/parts.h"

/* A lane that is surely crossed, before or at the limit; which crossing is nearest of all is settled later. */
typedef struct pending { const run *run; uint32_t lane; double lo; } pending;

enum { PENDING_MAX = 8 };

typedef struct query {
    bvh_walk walk;               /* first: leaves are handed this */
    pov_hits hits;
    uint32_t waiting;
    bool any_blocks;             /* transparent or not */
    pending pending[PENDING_MAX];
    pov_hits tints;              /* of transparent shapes on a light path */
} query;

/* The nearest crossing is put into out; a tree, if there is one, is to be walked in between. */
void query_begin_nearest(query *q, const world *w, const pov_ray *ray, double tmax, hit *out);
bool query_end_nearest(query *q, const world *w, walker *k, hit *out);
/* True: the light ends here, before the tree is asked. room is for the crossings of transparent shapes. */
bool query_begin_light(query *q, const world *w, tint_room *room, const pov_ray *ray, double tmax);
/* blocked: something that blocks stands on the way. False: nothing is left of the light. */
bool query_end_light(query *q, const world *w, walker *k, bool blocked, colour *through);

#endif
