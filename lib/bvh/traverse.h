/* traverse.h - traversal of a tree.
 *
 * In a frame the ray is p(u) = o + u d with o near the cube -1..1, d a unit vector, and u = (t - shift) * scale >= 0
 * within it. A slab's planes are crossed at u = b * inverse - offset. In units of |inverse| * 2^-24 floats lose |b| for
 * the inverse, |b| for the product, |o| for the offset, |b| + |o| for the difference, together at most 3 + 2 |o|. All
 * of it is put into the offsets, once for each ray and axis (4 + 4 |o|), so that entries are never late and exits never
 * early; Ize (JCGT 2013) widens each exit instead. Direction components below 1e-18 of the others are replaced by that:
 * over the length of the cube they move by far less than boxes are rounded outward, and no NaN arises. */
#ifndef BVH_TRAVERSE_H
#define BVH_TRAVERSE_H

#include "base/simd.h"
#include "bvh/bvh.h"

#include <povtrace/shape_fast.h>

#include <string.h>

/* A ray in a frame. */
typedef struct bvh_local {
    pov_vec3 org, dir;           /* dir has a length of one */
    double scale, shift;
    double slack;                /* slack of the offsets, relative to |inverse| (1 + |o|) */
} bvh_local;

#define BVH_SLACK 0x1p-22
#define BVH_LEAST 1e-18

enum { BVH_LANES = POV_RAYS_MAX };

/* State of a traversal of up to BVH_LANES rays; queries append their own members. */
typedef struct bvh_traversal {
    const bvh *tree;
    const pov_ray *const *rays;  /* NULL: they are not made yet */
    void (*make_rays)(struct bvh_traversal *traversal);
    uint32_t count;
    uint64_t lanes;              /* active lanes */
    bool start;                  /* some rays may start on a surface */
    SIMD_ALIGNED pov_rays soa;   /* the rays as a structure of arrays; lanes from count to the next multiple of eight
                                  * hold the last ray */
    const bvh_frame *in;         /* the frame that they are in */
    double length[BVH_LANES];    /* lengths of directions */
    double limit[BVH_LANES];     /* hits beyond this t do not count; leaves may lower it */
    uint64_t lowered;            /* lanes whose limit a leaf lowered; the reader clears the bits */
    /* Intersect a leaf's contents with some lanes. Returns the lanes that may end. */
    uint64_t (*leaf)(struct bvh_traversal *traversal, const void *leaf, uint64_t lanes);
} bvh_traversal;

/* A lane's ray. */
static inline const pov_ray *bvh_ray(bvh_traversal *t, uint32_t lane)
{
    if (!t->rays)
        t->make_rays(t);
    return t->rays[lane];
}

/* Visit the leaves that lanes may hit before their limits. Bit i: a leaf ended lane i. */
typedef uint64_t bvh_traverse_fn(bvh_traversal *traversal);

/* Traversal functions, near leaves first, or in any order. */
typedef struct bvh_kernels {
    const char *name;
    bvh_traverse_fn *nearest_packet, *any_packet;            /* packets of one octant */
    bvh_traverse_fn *nearest_single, *any_single;            /* single rays, one after the other */
    /* Interleaved, in a tree of one frame: while one ray waits for memory others continue. NULL: no faster here. */
    bvh_traverse_fn *nearest_interleaved, *any_interleaved;
} bvh_kernels;

/* The best functions for this processor; `portable` runs on every processor. */
const bvh_kernels *bvh_kernels_best(void);
extern const bvh_kernels bvh_kernels_portable;

bvh_traverse_fn bvh_nearest_packet_portable, bvh_any_packet_portable;
#if defined(__x86_64__) && defined(__GNUC__) && !defined(POV_PORTABLE)
extern const bvh_kernels bvh_kernels_avx2;   /* only where the processor has AVX2 */
bvh_traverse_fn bvh_nearest_packet_avx2, bvh_any_packet_avx2;
bvh_traverse_fn bvh_nearest_interleaved, bvh_any_interleaved;   /* AVX-512 */
#endif

/* Traverse a single lane from a reference in a frame, whatever its ray's numbers. True: a leaf ended it. */
bool bvh_go_single(bvh_traversal *traversal, uint32_t lane, uint32_t frame, uint32_t at);

/* All directions of a packet have the same signs. */
static inline uint32_t bvh_octant(const pov_ray *ray)
{
#if defined(__AVX__) && defined(__GNUC__)
    /* Eight more bytes of the ray follow the direction. */
    typedef double doubles __attribute__((vector_size(32)));
    doubles d;

    memcpy(&d, (const char *)ray + offsetof(pov_ray, dir), sizeof d);
    return (uint32_t)__builtin_ia32_movmskpd256(d) & 7;
#else
    return (signbit(ray->dir.x) ? 1u : 0u) | (signbit(ray->dir.y) ? 2u : 0u) | (signbit(ray->dir.z) ? 4u : 0u);
#endif
}

/* The octant of all of several rays; 8: they have several. */
static inline uint32_t bvh_common_octant(const pov_ray *const *rays, uint32_t n)
{
#if defined(__AVX__) && defined(__GNUC__)
    typedef long long bits __attribute__((vector_size(32)));
    typedef double doubles __attribute__((vector_size(32)));
    bits any = { 0, 0, 0, 0 }, all = ~any;
    uint32_t octant;

    if (bvh_octant(rays[0]) != bvh_octant(rays[n - 1]))
        return 8;
    for (uint32_t i = 0; i < n; i++) {
        bits d;

        memcpy(&d, (const char *)rays[i] + offsetof(pov_ray, dir), sizeof d);
        any |= d;
        all &= d;
    }
    octant = (uint32_t)__builtin_ia32_movmskpd256((doubles)any) & 7;
    return octant == ((uint32_t)__builtin_ia32_movmskpd256((doubles)all) & 7) ? octant : 8;
#else
    uint32_t any = 0, all = 7;

    for (uint32_t i = 0; i < n; i++) {
        any |= bvh_octant(rays[i]);
        all &= bvh_octant(rays[i]);
    }
    return any == all ? any : 8;
#endif
}

/* A ray that starts further away than BVH_NEAR half-sizes of the frame is moved near it, in double-double, one by one: nearer, the slack of
 * floats is little to boxes. False: it misses. */
#define BVH_NEAR 64.0
/* Directions with lengths in this range need no rescaling. */
#define BVH_SHORT 0x1p-300
#define BVH_LONG 0x1p300
/* For frame scales in this range no rescaling of the direction is needed. */
#define BVH_SMALL 0x1p-600
#define BVH_LARGE 0x1p600
bool bvh_enter_far(const bvh_frame *frame, const pov_ray *ray, bvh_local *out);
/* Move the start to just before the cube; the direction has unit length. */
bool bvh_bring_near(const bvh_frame *frame, const pov_ray *ray, bvh_local *l);

/* Transform a ray to a frame, given the length of its direction and the inverse of that. False: it misses. */
static inline bool bvh_enter(const bvh_frame *frame, const pov_ray *ray, double length, double per_length, bvh_local *out)
{
    pov_vec3 o = pov_sub(ray->org, frame->centre);

    o = pov_scale(pov_add(o, ray->org_lo), frame->scale);
    out->org = o;
    out->dir = pov_scale(ray->dir, per_length);
    out->scale = frame->scale * length;
    out->shift = 0.0;
    out->slack = BVH_SLACK;
    if (!(length > BVH_SHORT && length < BVH_LONG && frame->scale > BVH_SMALL && frame->scale < BVH_LARGE))
        return bvh_enter_far(frame, ray, out);
    if (fabs(o.x) <= BVH_NEAR && fabs(o.y) <= BVH_NEAR && fabs(o.z) <= BVH_NEAR)
        return true;
    return bvh_bring_near(frame, ray, out);
}

/* Store a ray in a frame for block filters. */
static inline void bvh_to_frame(pov_rays *rays, uint32_t lane, const bvh_local *l, float limit)
{
    const bool blind = l->slack > BVH_SLACK;
    const float x = (float)l->org.x, y = (float)l->org.y, z = (float)l->org.z;
    const float far = (float)(fabs(l->shift) * l->scale * 0x1p-22);

    rays->local.org[0][lane] = x;
    rays->local.org[1][lane] = y;
    rays->local.org[2][lane] = z;
    rays->local.dir[0][lane] = (float)l->dir.x;
    rays->local.dir[1][lane] = (float)l->dir.y;
    rays->local.dir[2][lane] = (float)l->dir.z;
    rays->local.size[lane] = blind ? HUGE_VALF : fabsf(x) + fabsf(y) + fabsf(z) + far;
    rays->local.smax[lane] = limit;
    rays->local.shift[lane] = l->shift;
    rays->local.unit[lane] = blind ? 1.0 : 1.0 / l->scale;
}

/* Key of a stack entry: the entry distance above the reference. Non-negative floats sort as their bits do. */
static inline uint64_t key_of(float entry, uint32_t child)
{
    uint32_t bits;

    memcpy(&bits, &entry, sizeof bits);
    return (uint64_t)bits << 32 | child;
}

static inline float entry_of(uint64_t key)
{
    uint32_t bits = (uint32_t)(key >> 32);
    float entry;

    memcpy(&entry, &bits, sizeof entry);
    return entry;
}

/* The u of a limit, rounded up. The t of a crossing may be off by a few units in its last place, which must not exclude
 * its box: 64 units are allowed. */
static inline float bvh_limit(double scale, double shift, double limit)
{
    double u = (limit - shift) * scale + (fabs(limit) + fabs(shift)) * scale * 0x1p-46;

    u += fabs(u) * 0x1p-22;
    return u < 1e38 ? (float)u : HUGE_VALF;
}

#endif
