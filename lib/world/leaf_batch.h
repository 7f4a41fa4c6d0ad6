/* leaf_batch.h - up to eight shapes of one class that are tested together: the contents of leaves and lists. */
#ifndef WORLD_LEAF_BATCH_H
#define WORLD_LEAF_BATCH_H

#include "base/simd.h"
#include "world/instance.h"

enum { LEAF_WIDTH = 8 };

enum {
    LEAF_PACKED = 1,             /* a filter: a block, or an instance filter of one shape, LEAF_HEAD bytes behind the
                                  * leaf batch's start */
    LEAF_RESERVED = 2,           /* memory for a block is reserved there, packed or not; behind an instance transform,
                                  * for its filter */
    LEAF_MORE = 4,               /* another leaf batch follows */
    LEAF_INSTANCED = 8,          /* one shape only, with its instance transform behind its object */
    LEAF_CLASS_SHIFT = 4         /* the bits above are the number of the class: see class_counts */
};

typedef struct leaf_batch {
    const shape_class *shape;
    const unsigned char *instances;   /* the first instance, the others `stride` bytes apart */
    uint8_t count, flags;             /* LEAF_* */
    uint8_t casts, opaque;            /* by lane: casts a shadow; is opaque */
    uint32_t object[LEAF_WIDTH];
    uint32_t stride;
    uint8_t unused[6];
    uint8_t plain;                    /* by lane, plain: the shape's marks are valid for the object: it looks the same
                                       * everywhere, is no member of a group, not clipped, and absorbs nothing inside.
                                       * For an instance this byte is an unused byte of its transform */
} leaf_batch;

/* Bytes before a block, before an instance transform, and of a leaf batch with an instance transform: the next part
 * begins a cache line. */
enum { LEAF_HEAD = 64, LEAF_XFORM = 24, LEAF_INSTANCED_BYTES = (LEAF_XFORM + sizeof(instance_xform) + 63) / 64 * 64 };

/* One byte for both kinds of batches, else this divides by zero. */
enum { LEAF_PLAIN_AGREES = 1 / (offsetof(leaf_batch, plain) == LEAF_XFORM + offsetof(instance_xform, reserved)) };

/* Lanes that hold a shape; a filter that declines returns all lanes. */
static inline uint32_t leaf_batch_lanes(const leaf_batch *r) { return (1u << r->count) - 1; }
static inline const void *leaf_batch_block(const leaf_batch *r)
{
    return (const unsigned char *)r + LEAF_HEAD;
}

static inline const void *leaf_batch_instance(const leaf_batch *r, uint32_t lane)
{
    return r->instances + (size_t)lane * r->stride;
}

static inline const instance_xform *leaf_batch_xform(const leaf_batch *r)
{
    return (const instance_xform *)(const void *)((const unsigned char *)r + LEAF_XFORM);
}

/* The instance filter of a shape that shares no block. An instance transform without memory for it makes it anew for
 * each query. */
static inline const instance_filter *leaf_batch_instance_filter(const leaf_batch *r)
{
    return (const instance_filter *)(const void *)((const unsigned char *)r
                                                   + (r->flags & LEAF_INSTANCED ? LEAF_INSTANCED_BYTES : LEAF_HEAD));
}

/* Are shapes of a class that share no block filtered as ellipsoids? Each is in a batch of its own then. */
static inline bool leaf_batch_may_filter(const shape_class *shape) { return shape->ellipsoid != NULL; }

static inline size_t leaf_batch_block_size(const shape_class *shape, uint32_t count)
{
    return count == 1 && shape->single_block_size > 0 ? shape->single_block_size : shape->block_size;
}

/* Bytes of a leaf batch of so many shapes: blocks are rounded up to whole cache lines. */
static inline size_t leaf_batch_bytes(const shape_class *shape, uint32_t count, unsigned flags)
{
    if (flags & LEAF_INSTANCED)
        return LEAF_INSTANCED_BYTES + (flags & LEAF_RESERVED ? sizeof(instance_filter) : 0);
    if (flags & LEAF_RESERVED)
        return LEAF_HEAD + (leaf_batch_block_size(shape, count) + 63) / 64 * 64;
    return LEAF_HEAD + (leaf_batch_may_filter(shape) ? sizeof(instance_filter) : 0);
}

static inline uint32_t leaf_batch_class(const leaf_batch *r) { return r->flags >> LEAF_CLASS_SHIFT; }

static inline const leaf_batch *leaf_batch_next(const leaf_batch *r)
{
    if (!(r->flags & LEAF_MORE))
        return NULL;
    return (const leaf_batch *)(const void *)((const unsigned char *)r
                                              + leaf_batch_bytes(r->shape, r->count, r->flags));
}

/* Candidates by the box of an instanced shape, which its class may know more of. In copies rays go by other names. */
static inline uint32_t leaf_batch_narrow(const leaf_batch *r, const pov_rays *rays, pov_candidate *io, uint32_t n)
{
    const instance_xform *x = leaf_batch_xform(r);
    const pov_own_map map = { x->anchor, { x->column[0], x->column[1], x->column[2] }, x->own_anchor };

    return n > 0 && r->shape->narrow && rays->rays ? r->shape->narrow(r->instances, &map, r->object[0], rays, io, n) : n;
}

/* Filter a batch that is LEAF_PACKED; frame: the frame of the rays. */
static inline uint32_t leaf_batch_filter(const leaf_batch *r, const bvh_frame *frame, const pov_rays *rays,
                                         uint64_t lanes, pov_candidate *out)
{
    const unsigned kind = r->flags & (LEAF_INSTANCED | LEAF_RESERVED);
    instance_filter s;
    uint32_t n;

    if (kind == LEAF_RESERVED)
        return r->shape->block_filter(leaf_batch_block(r), r->object, rays, lanes, out);
    if (kind == LEAF_INSTANCED)
        instance_filter_make(leaf_batch_xform(r), frame, &s);
    n = instance_filter_rays(kind == LEAF_INSTANCED ? &s : leaf_batch_instance_filter(r), r->object[0], rays, lanes, out);
    return kind & LEAF_INSTANCED ? leaf_batch_narrow(r, rays, out, n) : n;
}

/* Prefetch the record of an instanced shape, whose ray is transformed first. */
static inline void leaf_batch_prefetch(const leaf_batch *r)
{
    SIMD_PREFETCH(r->instances);
    SIMD_PREFETCH(r->instances + 64);
    SIMD_PREFETCH(r->instances + 128);
    SIMD_PREFETCH(r->instances + 192);
}

static inline void leaf_batch_intersect(const leaf_batch *r, uint32_t lane, const pov_ray *ray, pov_hits *hits)
{
    if (r->flags & LEAF_INSTANCED) {
        leaf_batch_prefetch(r);
        instance_intersect(leaf_batch_xform(r), r->shape, r->instances, ray, hits);
    } else {
        r->shape->intersect(leaf_batch_instance(r, lane), ray, hits);
    }
}

#endif
