/* leaf_batch.h - up to eight shapes of one class that are asked together: what leaves and lists are made of. */
#ifndef WORLD_LEAF_BATCH_H
#define WORLD_LEAF_BATCH_H

#include "base/simd.h"
#include "world/instance.h"

enum { RUN_WIDTH = 8 };

enum {
    RUN_PACKED = 1,              /* a filter: a block, or a stand of one shape, RUN_HEAD bytes behind the run's start */
    RUN_ROOM = 2,                /* there is room for a block there, packed or not; behind a placement, for its stand */
    RUN_MORE = 4,                /* another run follows */
    RUN_PLACED = 8,              /* one shape only, and its placement behind its object */
    RUN_CLASS_SHIFT = 4          /* the bits above are the number of the class: see class_counts */
};

typedef struct run {
    const shape_class *shape;
    const unsigned char *instances;   /* of the first, the others `stride` bytes apart */
    uint8_t count, flags;             /* RUN_* */
    uint8_t casts, opaque;            /* by lane: throws a shadow; lets nothing through */
    uint32_t object[RUN_WIDTH];
    uint32_t stride;
    uint8_t unused[6];
    uint8_t plain;                    /* by lane: what its marks say of the shape holds of the object: it looks the same
                                       * everywhere, is no member of a group, not clipped, and absorbs nothing inside.
                                       * Of an instance this byte is one that its transform leaves free */
} run;

/* Bytes before a block, before a placement, and of a run with a placement: what follows begins a line of memory. */
enum { RUN_HEAD = 64, RUN_PLACE = 24, RUN_PLACED_BYTES = (RUN_PLACE + sizeof(placement) + 63) / 64 * 64 };

/* One byte for both kinds of batches, else this divides by zero. */
enum { RUN_PLAIN_AGREES = 1 / (offsetof(run, plain) == RUN_PLACE + offsetof(placement, reserved)) };

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

static inline const placement *run_placement(const run *r)
{
    return (const placement *)(const void *)((const unsigned char *)r + RUN_PLACE);
}

/* Of one shape that shares no block. A placement that has no room for its stand makes it anew for each question. */
static inline const stand *run_stand(const run *r)
{
    return (const stand *)(const void *)((const unsigned char *)r + (r->flags & RUN_PLACED ? RUN_PLACED_BYTES : RUN_HEAD));
}

/* Are shapes of a class that share no block to be looked at as ellipsoids? Each stands alone then. */
static inline bool run_may_stand(const shape_class *shape) { return shape->ellipsoid != NULL; }

static inline size_t run_block_size(const shape_class *shape, uint32_t count)
{
    return count == 1 && shape->single_block_size > 0 ? shape->single_block_size : shape->block_size;
}

/* Bytes from a run of so many to the next: blocks are rounded up to whole lines of memory. */
static inline size_t run_bytes(const shape_class *shape, uint32_t count, unsigned flags)
{
    if (flags & RUN_PLACED)
        return RUN_PLACED_BYTES + (flags & RUN_ROOM ? sizeof(stand) : 0);
    if (flags & RUN_ROOM)
        return RUN_HEAD + (run_block_size(shape, count) + 63) / 64 * 64;
    return RUN_HEAD + (run_may_stand(shape) ? sizeof(stand) : 0);
}

static inline uint32_t run_class(const run *r) { return r->flags >> RUN_CLASS_SHIFT; }

static inline const run *run_next(const run *r)
{
    if (!(r->flags & RUN_MORE))
        return NULL;
    return (const run *)(const void *)((const unsigned char *)r + run_bytes(r->shape, r->count, r->flags));
}

/* Of one that is RUN_PACKED; frame: what the rays stand in. */
static inline uint32_t run_filter(const run *r, const bvh_frame *frame, const pov_rays *rays, uint64_t lanes,
                                  pov_meeting *out)
{
    const unsigned kind = r->flags & (RUN_PLACED | RUN_ROOM);
    stand s;

    if (kind == RUN_ROOM)
        return r->shape->block_filter(run_block(r), r->object, rays, lanes, out);
    if (kind != RUN_PLACED)
        return placement_filter(run_stand(r), r->object[0], rays, lanes, out);
    placement_stand(run_placement(r), frame, &s);
    return placement_filter(&s, r->object[0], rays, lanes, out);
}

/* The record of a placed shape, which its ray is taken to first. */
static inline void run_expect(const run *r)
{
    SIMD_EXPECT(r->instances);
    SIMD_EXPECT(r->instances + 64);
    SIMD_EXPECT(r->instances + 128);
    SIMD_EXPECT(r->instances + 192);
}

static inline void run_intersect(const run *r, uint32_t lane, const pov_ray *ray, pov_hits *hits)
{
    if (r->flags & RUN_PLACED) {
        run_expect(r);
        placement_intersect(run_placement(r), r->shape, r->instances, ray, hits);
    } else {
        r->shape->intersect(run_instance(r, lane), ray, hits);
    }
}

#endif
