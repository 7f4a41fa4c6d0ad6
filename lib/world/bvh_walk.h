/* bvh_walk.h - one ray through a tree.
 *
 * In a frame the ray is p(u) = o + u d with o near the cube -1..1, and u = (t - shift) * scale >= 0 within it. A slab's
 * planes are met at u = b * inverse - offset. What floats lose there is, in units of |inverse| * 2^-24: |b| for the
 * inverse, |b| for the product, |o| for the offset, |b| + |o| for the difference, together at most 3 + 2 |o|; all of it
 * is put into the offsets, once a ray and axis (4 + 4 |o|), so that entries are never late and exits never early: what
 * Ize (JCGT 2013) gets by widening each exit. Direction components below 1e-18 of the others count as that: over the
 * length of the cube they then move by far less than the boxes are rounded outward, and no NaN arises. */
#ifndef WORLD_BVH_WALK_H
#define WORLD_BVH_WALK_H

#include "world/bvh.h"

#include <povtrace/plugin.h>

typedef struct bvh_slabs {
    float inverse[3], near_offset[3], far_offset[3];
    float limit;                 /* u beyond which nothing counts */
    uint32_t near_row[3];        /* rows of a node's bounds: where the ray enters; row ^ 1 is where it leaves */
    double scale, shift;
} bvh_slabs;

/* A walk under way; queries put their own members behind it. */
typedef struct bvh_walk {
    const bvh *tree;
    const pov_ray *ray;
    double limit;                /* nothing beyond this t counts; leaves may lower it */
    /* What lies in a leaf. True: the walk may end. */
    bool (*leaf)(struct bvh_walk *walk, const void *leaf);
} bvh_walk;

/* Visit the leaves that the ray may meet before the limit. True: a leaf ended it. Near ones first, or in any order. */
typedef struct bvh_walks {
    const char *name;
    bool (*nearest_first)(bvh_walk *walk);
    bool (*any_order)(bvh_walk *walk);
} bvh_walks;

/* The best that this processor can do; `portable` is what every processor can. */
const bvh_walks *bvh_walks_best(void);
extern const bvh_walks bvh_walks_portable;

/* Set up the ray in a frame. False: it passes by. */
bool bvh_enter(const bvh_frame *frame, const pov_ray *ray, double limit, bvh_slabs *out);

/* The walk's limit in the frame, rounded up. The t of a crossing may be off by a few units in its last place, which
 * must not hide the box that it lies in: 64 of them are allowed for. */
static inline void bvh_set_limit(bvh_slabs *s, double limit)
{
    double u = (limit - s->shift) * s->scale + (fabs(limit) + fabs(s->shift)) * s->scale * 0x1p-46;

    u += fabs(u) * 0x1p-22;
    s->limit = u < 1e38 ? (float)u : HUGE_VALF;
}

#endif
