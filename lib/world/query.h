/* query.h - a query under way, for single rays and many. */
#ifndef WORLD_QUERY_H
#define WORLD_QUERY_H

#include "world/bits.h"
#include "world/parts.h"

/* A lane that is surely crossed, before or at the limit; which crossing is nearest of all is settled later. */
typedef struct pending { const run *run; uint32_t lane; double lo; } pending;

enum { PENDING_MAX = 8 };

typedef struct query {
    bvh_walk walk;               /* first: leaves are handed this */
    walker *walker;
    pov_hits hits;
    uint32_t waiting;
    bool any_blocks;             /* transparent or not */
    pending pending[PENDING_MAX];
    pov_hits tints;              /* of transparent shapes on a light path */
} query;

/* A filter's interval is open, and a crossing at the limit may still win by its lower part or its owner. */
static inline double just_beyond(double limit)
{
    return limit + limit * 0x1p-52 + 0x1p-1074;
}

/* Whether something at lo or later can be left out: a reported distance may be off by some units in its last place. */
static inline bool is_beyond(double lo, double limit)
{
    return lo > limit + limit * 0x1p-46;
}

/* Lanes of a run that the ray cannot meet: the convex shape that it went away from. */
static inline uint32_t left_behind(const run *r, const pov_ray *ray)
{
    uint32_t lane;

    if (!(r->shape->flags & POV_SHAPE_CONVEX) || !(ray->left_mark.flags & POV_MARK_AWAY))
        return 0;
    for (lane = 0; lane < r->count; lane++)
        if (r->object[lane] == ray->left)
            return 1u << lane;
    return 0;
}

static inline void begin_hits(pov_hits *hits, const world *w, double tmax, pov_want want, pov_crossing *at)
{
    hits->tmin = 0.0;
    hits->tmax = tmax;
    hits->want = want;
    hits->always_exact = w->always_exact;
    hits->count_only = false;
    hits->owner = POV_NOBODY;
    hits->count = 0;
    hits->capacity = 1;
    hits->decided = 0;
    hits->at = at;
    hits->grow = NULL;
    hits->user = NULL;
    hits->crowded = false;
}

/* Transparent shapes that light surely enters and leaves on its way are noted as crossed twice, and are not asked. Gives
 * the rest of the mask. */
static inline uint32_t pass_through(const run *r, const pov_block_answer *answer, uint32_t left, uint32_t mask,
                                    pov_hits *tints)
{
    const pov_mark mark = { 0, 0, 0.0, 0.0 };
    uint32_t through = mask & answer->twice & ~(uint32_t)r->opaque;

    for (; through; through &= through - 1) {
        const uint32_t lane = first_of(through);

        if (r->object[lane] == left)
            continue;
        tints->owner = r->object[lane];
        if (pov_cross(tints, answer->lo[lane], 0.0, mark))
            pov_cross(tints, answer->lo[lane], 0.0, mark);
        mask &= ~(1u << lane);
    }
    return mask;
}

/* From the hits of the shapes that block to those of the transparent ones. */
void begin_tints(pov_hits *tints, const pov_hits *hits, tint_room *room);

/* blocked: something that blocks stands on the way; tints: what transparent shapes were crossed, or NULL. False: nothing
 * is left of the light. */
bool end_light(const world *w, bool blocked, pov_hits *tints, colour *through);

/* Who is nearest, but for what waits to be asked: of that all but one can be settled, and this is given, if there is any. */
void query_nearest(query *q, const world *w, walker *k, const pov_ray *ray, double tmax, pov_crossing *at);
bool query_settle_but_one(query *q, pending *one);

/* Go on from the middle of a tree, with the walk and the hits of whoever has begun it. True: the light ends. */
void query_go_on_nearest(query *q, const world *w);
bool query_go_on_light(query *q, const world *w);

#endif
