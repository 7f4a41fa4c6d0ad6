/* traverse.h - one ray through a tree.
 *
 * In a frame the ray is p(u) = o + u d with o near the cube -1..1, d a unit vector, and u = (t - shift) * scale >= 0
 * within it. A slab's planes are met at u = b * inverse - offset. What floats lose there is, in units of |inverse| * 2^-24: |b| for the
 * inverse, |b| for the product, |o| for the offset, |b| + |o| for the difference, together at most 3 + 2 |o|; all of it
 * is put into the offsets, once a ray and axis (4 + 4 |o|), so that entries are never late and exits never early: what
 * Ize (JCGT 2013) gets by widening each exit. Direction components below 1e-18 of the others count as that: over the
 * length of the cube they then move by far less than the boxes are rounded outward, and no NaN arises. */
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
    double slack;                /* of the offsets: relative to |inverse| (1 + |o|) */
} bvh_local;

#define BVH_SLACK 0x1p-22
#define BVH_LEAST 1e-18

/* A walk under way; queries put their own members behind it. */
typedef struct bvh_walk {
    const bvh *tree;
    const pov_ray *ray;
    double length, per_length;   /* of the ray's direction, and the inverse */
    pov_rays *framed;            /* whose first lane is to stand in the frame, for blocks; or NULL */
    const bvh_frame *in;         /* what it stands in */
    uint32_t frame, at;          /* where it begins: a reference in a frame */
    double limit;                /* nothing beyond this t counts; leaves may lower it */
    /* What lies in a leaf. True: the walk may end. */
    bool (*leaf)(struct bvh_walk *walk, const void *leaf);
} bvh_walk;

enum { BVH_COMPANY = POV_RAYS_MAX };

/* Walks under way together, of rays whose directions have the same signs; queries put their own members behind it. */
typedef struct bvh_party {
    const bvh *tree;
    const pov_ray *const *rays;
    pov_ray *written;            /* the rays, lane by lane, whose directions are only in `ways` until bvh_write() is called;
                                  * NULL: they are complete */
    const double *ways[3];
    uint32_t count;
    uint64_t lanes;              /* those that walk */
    SIMD_ALIGNED pov_rays side;  /* the rays by component; lanes from count to the next multiple of eight hold the last */
    const bvh_frame *in;         /* what they stand in */
    double length[BVH_COMPANY];  /* of directions */
    double limit[BVH_COMPANY];   /* as a walk's, by lane */
    uint64_t lowered;            /* a leaf lowered the limit of these: whoever sees that takes the bits out */
    /* What lies in a leaf, for some lanes. Gives those that may end. */
    uint64_t (*leaf)(struct bvh_party *party, const void *leaf, uint64_t lanes);
    /* Take one lane on alone from a reference in a frame. True: a leaf ended it. */
    bool (*alone)(struct bvh_party *party, uint32_t lane, uint32_t frame, uint32_t at);
} bvh_party;

/* Before anybody looks at a lane's ray. */
static inline void bvh_write(const bvh_party *party, uint32_t lane)
{
    if (party->written)
        party->written[lane].dir = pov_vec3_of(party->ways[0][lane], party->ways[1][lane], party->ways[2][lane]);
}

/* From the root. Bit i: a leaf ended lane i. */
typedef uint64_t bvh_travel(bvh_party *party);

/* Visit the leaves that the ray may meet before the limit. True: a leaf ended it. Near ones first, or in any order. */
typedef struct bvh_walks {
    const char *name;
    bool (*nearest_first)(bvh_walk *walk);
    bool (*any_order)(bvh_walk *walk);
    bvh_travel *nearest_together, *any_together;
    /* Each by itself, of any octant, in a tree of one frame. NULL: that is no better than one after the other. */
    bvh_travel *nearest_by_turns, *any_by_turns;
} bvh_walks;

/* The best that this processor can do; `portable` is what every processor can. */
const bvh_walks *bvh_walks_best(void);
extern const bvh_walks bvh_walks_portable;
#if defined(__x86_64__) && defined(__GNUC__) && !defined(POV_PORTABLE)
extern const bvh_walks bvh_walks_avx2;   /* only where the processor has AVX2 */
#endif

/* A ray that starts further away than BVH_NEAR half-sizes of the frame is brought near. False: it passes by. */
#define BVH_NEAR 8.0
/* Directions of a length between these are taken as they are. */
#define BVH_SHORT 0x1p-300
#define BVH_LONG 0x1p300
/* Frames of a scale between these are met by such directions without more ado. */
#define BVH_SMALL 0x1p-600
#define BVH_LARGE 0x1p600
bool bvh_enter_far(const bvh_frame *frame, const pov_ray *ray, bvh_local *out);

/* The ray in a frame, with the length of its direction and the inverse of that. False: it passes by. */
static inline bool bvh_enter(const bvh_frame *frame, const pov_ray *ray, double length, double per_length, bvh_local *out)
{
    pov_vec3 o = pov_sub(ray->org, frame->centre);

    o = pov_scale(pov_add(o, ray->org_lo), frame->scale);
    out->org = o;
    out->dir = pov_scale(ray->dir, per_length);
    out->scale = frame->scale * length;
    out->shift = 0.0;
    out->slack = BVH_SLACK;
    if (length > BVH_SHORT && length < BVH_LONG && frame->scale > BVH_SMALL && frame->scale < BVH_LARGE
        && fabs(o.x) <= BVH_NEAR && fabs(o.y) <= BVH_NEAR && fabs(o.z) <= BVH_NEAR)
        return true;
    return bvh_enter_far(frame, ray, out);
}

/* What blocks are told of a ray in a frame. */
static inline void bvh_stand(pov_rays *rays, uint32_t lane, const bvh_local *l, float limit)
{
    const bool blind = l->slack > BVH_SLACK;
    const float x = (float)l->org.x, y = (float)l->org.y, z = (float)l->org.z;
    const float far = (float)(fabs(l->shift) * l->scale * 0x1p-22);

    rays->framed.org[0][lane] = x;
    rays->framed.org[1][lane] = y;
    rays->framed.org[2][lane] = z;
    rays->framed.dir[0][lane] = (float)l->dir.x;
    rays->framed.dir[1][lane] = (float)l->dir.y;
    rays->framed.dir[2][lane] = (float)l->dir.z;
    rays->framed.size[lane] = blind ? HUGE_VALF : fabsf(x) + fabsf(y) + fabsf(z) + far;
    rays->framed.smax[lane] = limit;
    rays->framed.shift[lane] = l->shift;
    rays->framed.unit[lane] = blind ? 1.0 : 1.0 / l->scale;
}

/* What the entries of a stack are: the entry's distance, a float that is not negative and so sorts as its bits do,
 * above the reference. */
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

/* The u of a limit, rounded up. The t of a crossing may be off by a few units in its last place, which must not hide
 * the box that it lies in: 64 of them are allowed for. */
static inline float bvh_limit(double scale, double shift, double limit)
{
    double u = (limit - shift) * scale + (fabs(limit) + fabs(shift)) * scale * 0x1p-46;

    u += fabs(u) * 0x1p-22;
    return u < 1e38 ? (float)u : HUGE_VALF;
}

#endif
