/* run.h - up to eight shapes of one class that are asked together: what leaves and lists are made of. */
#ifndef WORLD_RUN_H
#define WORLD_RUN_H

#include "world/placement.h"

enum { RUN_WIDTH = 8 };

enum {
    RUN_PACKED = 1,              /* a block stands RUN_HEAD bytes behind the run's start */
    RUN_ROOM = 2,                /* there is room for a block there, packed or not */
    RUN_MORE = 4                 /* another run follows */
};

typedef struct run {
    const pov_shape_class *shape;
    const unsigned char *instances;   /* of the first, the others `stride` bytes apart */
    const placement *placements;      /* NULL: the shapes' own space is the world */
    uint32_t object[RUN_WIDTH];
    uint8_t count, flags;             /* RUN_* */
    uint8_t casts, opaque;            /* by lane: throws a shadow; lets nothing through */
    uint32_t stride;
} run;

enum { RUN_HEAD = 64 };

/* The lanes that hold a shape; a filter that declines answers for all there could be. */
static inline uint32_t run_lanes(const run *r) { return (1u << r->count) - 1; }
static inline const void *run_block(const run *r)
{
    return (const unsigned char *)r + RUN_HEAD;
}

static inline const void *run_instance(const run *r, uint32_t lane)
{
    return r->instances + (size_t)lane * r->stride;
}

/* Bytes from a run to the next: blocks are rounded up to whole lines of memory. */
static inline size_t run_bytes(const pov_shape_class *shape, bool room)
{
    return RUN_HEAD + (room ? (shape->block_size + 63) / 64 * 64 : 0);
}

static inline const run *run_next(const run *r)
{
    if (!(r->flags & RUN_MORE))
        return NULL;
    return (const run *)(const void *)((const unsigned char *)r + run_bytes(r->shape, (r->flags & RUN_ROOM) != 0));
}

static inline void run_intersect(const run *r, uint32_t lane, const pov_ray *ray, pov_hits *hits)
{
    if (r->placements)
        placement_intersect(&r->placements[lane], r->shape, run_instance(r, lane), ray, hits);
    else
        r->shape->intersect(run_instance(r, lane), ray, hits);
}

#endif
