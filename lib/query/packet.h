/* packet.h - state of queries of 1 to 64 rays: the only engine. A single ray is a packet of one lane. */
#ifndef QUERY_PACKET_H
#define QUERY_PACKET_H

#include "base/simd.h"
#include "bvh/group.h"
#include "bvh/ray_soa.h"
#include "query/context.h"

/* Deferred shapes by lane: each is a definite hit, at lo or later; the nearest of all hits is determined later. */
typedef struct deferred {
    SIMD_ALIGNED double lo[WORLD_MANY];
    const leaf_batch *batch[WORLD_MANY];
    uint32_t lane[WORLD_MANY], note[WORLD_MANY];   /* note: the candidate's */
} deferred;

/* Most rays never need hits of their own, so these are initialised on demand. */
typedef struct packet {
    bvh_traversal traversal;     /* first: passed to leaves */
    const world *world;
    query_context *context;
    const pov_ray *rays[WORLD_MANY];
    const lane_rays *by_lane;    /* what `rays` are made of as soon as one is needed; NULL: they are there */
    uint8_t of[WORLD_MANY];      /* by lane: index of the caller's ray */
    double tmax, slack;          /* slack: of pov_hits, for light */
    uint64_t exact;              /* lanes that filters cannot take */
    uint64_t asked;              /* lanes whose hits are initialised */
    const coincident_set *from;  /* coincident set that the only ray starts on, or NULL; it is `named` then */
    bool candidates_only;        /* for the only ray, whose lane is exact, filters may name candidates: no hit is definite */
    pov_ray named;
    hit *out;                    /* the caller's hits, in queries for the nearest */
    uint64_t deferred_lanes;     /* lanes with a deferred shape */
    uint64_t crossed;            /* of these, lanes whose hit is known without hits of their own, as they asked nothing else */
    uint32_t left;               /* in occlusion queries: the object that all rays are known to have left, or POV_NO_OWNER */
    bool any_blocks;             /* in occlusion queries: shapes block, transparent or not */
    bool whole;                  /* in occlusion queries: objects that cast no shadow block, too, but for `end` */
    uint32_t end;                /* then: an object that no ray crosses, or POV_NO_OWNER */
    deferred deferred;
    pov_hits hits[WORLD_MANY], filter_hits[WORLD_MANY];   /* filter_hits: transparent shapes on a light path */
    pov_candidate candidates[POV_CANDIDATES_MAX];
} packet;

static inline uint64_t bit_of(uint32_t i) { return (uint64_t)1 << i; }
static inline uint64_t all_of(uint32_t n) { return ~(uint64_t)0 >> (WORLD_MANY - n); }

/* Shapes that may tie with the nearest must be intersected. A limit is at least the true distance of the nearest
 * crossing, and a filter's bounds are for true distances. Reported ones are off by 32 units in the last place, 2^-47 of
 * them, and tie within POV_COINCIDENT, 2^-46. Two that tie differ by less than 2 * 2^-47 + 2^-46 = 2^-45 in truth,
 * except for products of these and the rounding here. */
#define PACKET_TIE 0x1p-44

static inline double just_beyond(double limit)
{
    return limit + limit * PACKET_TIE + 0x1p-1074;
}

/* Can a hit of the lane at lo or later be excluded? */
static inline bool is_beyond(const packet *p, uint32_t i, double lo) { return lo > p->traversal.soa.tmax[i]; }

static inline void lower(packet *p, uint32_t i, double limit)
{
    p->traversal.limit[i] = limit;
    p->traversal.soa.tmax[i] = just_beyond(limit);
    p->traversal.lowered |= bit_of(i);
}

/* ---- lanes and shapes ---- */

/* A convex shape that a ray left outward cannot be hit, and the exit of a closed shape that it entered is known.
 * excluded: that shape. */
static inline bool is_excluded(const leaf_batch *r, uint32_t lane, const pov_ray *ray, uint32_t excluded)
{
    return r->object[lane] == excluded && (r->plain >> lane & 1) &&
           ((r->shape->flags & POV_SHAPE_CONVEX) || (ray->origin_mark.flags & POV_MARK_CLOSED));
}

static inline uint32_t excluded_of(const packet *p, uint32_t i, const leaf_batch *r)
{
    const uint32_t excluded = p->traversal.soa.excluded[i];
    uint32_t lane;

    for (lane = 0; excluded != POV_NO_OWNER && lane < r->count; lane++)
        if (is_excluded(r, lane, p->rays[i], excluded))
            return 1u << lane;
    return 0;
}

/* Lanes that are not filtered: all, if a ray starts on the only shape. A filter would report a possible hit; the shape
 * knows the root to leave out. */
static inline uint64_t exact_of(const packet *p, const leaf_batch *r, uint64_t lanes)
{
    const bool left = r->count == 1 && (lanes & (lanes - 1)) == 0 &&
        p->rays[first_of64(lanes)]->origin_surface == r->object[0];

    return !(r->flags & LEAF_PACKED) || left ? lanes : lanes & p->exact;
}

/* Shapes of a batch that a lane may hit which filters cannot take. */
static inline uint32_t possible_of(packet *p, uint32_t i, const leaf_batch *r)
{
    uint32_t n, found = 0;

    if (!p->candidates_only || !(r->flags & LEAF_PACKED))
        return leaf_batch_lanes(r) & ~excluded_of(p, i, r);
    n = leaf_batch_filter(r, p->traversal.in, &p->traversal.soa, 1, p->candidates);
    for (uint32_t k = 0; k < n; k++)
        found |= 1u << p->candidates[k].lane;
    return found;
}

/* Do the shapes of a batch take several rays side by side, one shape after the other, and are there several that filters cannot take? */
static inline bool packet_asks_together(const packet *p, const leaf_batch *r, uint64_t lanes)
{
    return (lanes & (lanes - 1)) != 0 && (r->count == 1 || !(r->flags & LEAF_INSTANCED)) && !(r->flags & LEAF_PACKED) &&
           r->shape->intersect_many && !p->from;
}

/* Set the origin surfaces of `from` when their owners are intersected: each by its own mark, others not at all. */
void packet_name(packet *p, uint32_t owner);

static inline void packet_intersect(packet *p, uint32_t i, const leaf_batch *r, uint32_t lane, pov_hits *hits)
{
    hits->owner = r->object[lane];
    if (p->from)
        packet_name(p, hits->owner);
    leaf_batch_intersect(r, lane, p->rays[i], hits);
}

static inline void packet_begin_hits(const packet *p, uint32_t i, pov_hits *hits, pov_want want, pov_crossing *at)
{
    hits_begin(hits, &p->context->hit_buffers[p->of[i]], p->tmax, want, at);
}

/* ---- shapes of one crossing ---- */

/* By lane: no crossing of a shape is outside lo to hi. maybe: lanes whose crossing may be within their interval; definite: it is there. */
typedef struct shape_bounds {
    SIMD_ALIGNED double lo[WORLD_MANY], hi[WORLD_MANY];
    uint64_t maybe, definite;
} shape_bounds;

/* Does a batch bound its shapes' crossings by lane? */
static inline bool packet_has_bounds(const leaf_batch *r, uint64_t lanes)
{
    return r->shape->block_bounds && (r->flags & (LEAF_PACKED | LEAF_INSTANCED | LEAF_RESERVED)) == (LEAF_PACKED | LEAF_RESERVED) &&
           (lanes & (lanes - 1)) != 0;
}

void packet_bounds(const packet *p, const leaf_batch *r, uint32_t which, uint64_t lanes, shape_bounds *out);
/* Candidates of some of those lanes, from p->candidates[n] on. Returns how many there are then. */
uint32_t packet_put_bounds(packet *p, const shape_bounds *of, uint32_t which, uint64_t lanes, uint32_t n);

/* ---- a query ---- */

/* Divide those of the first n rays that `which` selects into groups. Returns the number of groups. */
static inline uint32_t packet_divide(const world *w, const pov_ray *const *rays, uint32_t n, uint64_t which, bool nearest,
                                     bvh_group groups[BVH_GROUPS])
{
    return bvh_divide(w->has_tree ? &w->tree : NULL, w->kernels, rays, n, which, nearest, groups);
}

/* Begin with the rays that `which` selects; filters look up to `end`. */
void packet_begin(packet *p, const world *w, query_context *k, const pov_ray *const *rays, uint64_t which, double tmax,
                  double end);
/* The same with rays to light by lane. False: they do not make one packet. */
bool packet_begin_lanes(packet *p, const world *w, query_context *k, const lane_rays *rays, uint32_t n, double tmax);
/* Make the records of rays by lane. */
void packet_make_rays(packet *p);
/* Traverse the lists and the tree. Returns the lanes that a leaf ended. */
uint64_t packet_traverse(packet *p, bvh_traverse_fn *traverse, bool nearest);
/* The nearest hits of all lanes, before coincident ones are resolved. */
void packet_nearest(packet *p, bvh_traverse_fn *traverse);
/* Find lanes whose light is blocked. */
uint64_t packet_occlusion(packet *p, bvh_traverse_fn *traverse);
void packet_begin_light(packet *p, uint32_t i);
/* Slack of a segment's end for crossings in double. */
double packet_near_end(double tmax);
/* Return the crossings of unblocked lanes, and the blocked ones as bits of the caller's. */
uint64_t packet_end_light(packet *p, uint64_t blocked, occlusion *out);

/* ---- shapes and rays that are asked side by side ---- */

/* Pairs of one class. */
typedef struct pairs {
    uint32_t count;
    const void *selves[WORLD_MANY];
    const pov_ray *rays[WORLD_MANY];
    pov_hits *hits[WORLD_MANY];
} pairs;

static inline void pairs_put(pairs *some, const void *self, const pov_ray *ray, pov_hits *hits)
{
    const uint32_t n = some->count++;

    some->selves[n] = self;
    some->rays[n] = ray;
    some->hits[n] = hits;
}

/* crossed: all of them are definite hits. */
void pairs_ask(query_context *k, const shape_class *shape, uint32_t class_number, pairs *some, bool crossed);

/* Pairs of one class whose crossings are written to where they belong. */
typedef struct sure_pairs {
    uint32_t count;
    const void *selves[WORLD_MANY];
    const pov_ray *rays[WORLD_MANY];
    pov_crossing *at[WORLD_MANY];
    pov_contact *contacts[WORLD_MANY];
    uint8_t lanes[WORLD_MANY];
} sure_pairs;

/* One whose object is known to be hit. */
static inline void sure_pairs_put(sure_pairs *some, const world *w, const void *self, uint32_t owner, const pov_ray *ray, uint32_t lane, hit *out)
{
    const uint32_t n = some->count++;

    out->object = out->crossing.owner = owner;
    out->coincident = 0;
    SIMD_PREFETCH(&w->objects_info[owner]);
    some->selves[n] = self;
    some->rays[n] = ray;
    some->at[n] = &out->crossing;
    some->contacts[n] = hit_contact(out);
    some->lanes[n] = (uint8_t)lane;
}

/* Cross them, with points and normals where something is lit. Returns the lanes that are left open. */
uint64_t sure_pairs_cross(sure_pairs *some, const world *w, query_context *k, const shape_class *shape, uint32_t class_number);

/* The ray in an instance's object space, which is transformed with the others of `some`; it is kept for the normal. */
static inline const pov_ray *own_ray(query_context *k, xform_batch *some, const instance_xform *at, const pov_ray *ray,
                                     uint32_t which, uint32_t owner)
{
    pov_ray *own = &k->own.rays[which];

    k->own.of[which] = owner;
    k->own.known |= bit_of(which);
    xform_batch_add(some, at, ray, own);
    return own;
}

#endif
