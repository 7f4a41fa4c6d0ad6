/* query.h - queries of rays to a compiled scene: nearest hits and occlusion.
 *
 * Every query is [render]: many threads on one const world, each with its own query context. */
#ifndef QUERY_QUERY_H
#define QUERY_QUERY_H

#include "bvh/group.h"
#include "bvh/shaft.h"
#include "world/surface.h"

#include <povtrace/shape_fast.h>

typedef struct query_context query_context;   /* one thread's memory for queries */

pov_status query_context_create(query_context **out, const world *w, pov_error *err);
void query_context_destroy(query_context *k);
/* Number of intersections that escalated to double-double so far. */
uint64_t query_context_escalated(const query_context *k);
/* Add the counts since the last call to `sum`. */
void query_context_take_classes(query_context *k, class_counts *sum);
/* True if memory ended in a query, whose results are then invalid. Stays so. */
bool query_context_failed(const query_context *k);

/* Object space rays of the last query_nearest(), valid until the next query. */
const object_space_rays *query_context_own(const query_context *k);

/* The nearest crossings of up to WORLD_MANY rays in the open interval (0, tmax). Rays of similar origin and direction
 * cost a fraction of single ones, and each gets the same result as unaided. Fills crossing, object and coincident only;
 * bit i of the result: ray i has a hit; without one its hit is undefined. Of several coincident crossings the result is
 * the one that the ray crosses first: coincidence_crossed(). */
uint64_t query_nearest(const world *w, query_context *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out);

/* Crossings of light: for each ray in `crossed` its crossings of transparent surfaces, those of one object from near to
 * far, and earlier objects first. They are owned by the query context, until its next query. Distances are valid for
 * objects that are not plain; the caller may reorder them. */
typedef struct occlusion {
    uint64_t near_end;           /* rays with a crossing so near the end that doubles do not tell on which side it lies:
                                  * left out, query_occlusion_exact() decides */
    uint64_t crossed;
    pov_crossing *at[WORLD_MANY];
    uint32_t count[WORLD_MANY];
} occlusion;

/* Bit i: nothing opaque is on ray i's open segment org .. org + tmax dir. Objects of no_shadow do not count. */
uint64_t query_occlusion(const world *w, query_context *k, const pov_ray *const *rays, uint32_t n, double tmax,
                         occlusion *out);
/* Rays by lane, of which records are made when something needs them; origin: the surfaces that they start on. enters: some may go into a
 * closed solid that lets light through, so that records are needed. */
typedef struct lane_rays {
    bvh_ray_lanes lanes;
    const uint32_t *origin;
    const pov_ray *const *(*make)(void *user);
    void *user;
    bool enters;
} lane_rays;

/* The same of n rays by lane. */
uint64_t query_occlusion_lanes(const world *w, query_context *k, const lane_rays *rays, uint32_t n, double tmax, occlusion *out);
/* The same for one ray, the result of which takes the place of ray `which`: the direction counts in double-double, and so
 * do crossings. A surface at the end itself is not on the segment. */
bool query_occlusion_exact(const world *w, query_context *k, const pov_ray *ray, uint32_t which, double tmax,
                           occlusion *out);
/* A solid of a shape class's `ring`, of these radii, in a space of its own; hollowed: if it hides it does not within `hollow`, in the world. */
typedef struct blocker_ring { double radii[2]; pov_own_map own; bool hollowed; pov_outline hollow; } blocker_ring;

/* What may cast a shadow: something in a box, which is off by a few units in the last place of its coordinates, or a plane. */
typedef struct blocker {
    pov_box box;
    pov_half_space plane;        /* which it is the surface of, if is_plane */
    bool is_box, is_sphere;      /* its surface lies on the box's, or on the sphere inscribed in it */
    bool is_plane;
    bool outlined, hides;        /* its surface lies on that of `solid`, in the world; all of its inside stops light, and is convex, or of
                                  * a ring, within `clip`, where it ends */
    bool dims;                   /* it is such a solid of which each crossing leaves the same part of light */
    uint32_t object;             /* then, or of a member: its leaf */
    const blocker_ring *ring;    /* or on that of this one; or NULL */
    bool clipped;                /* it shows within this only: `clip`, in the world */
    uint32_t tree;               /* not 0: it is a member of this tree. What hides is then all that is in no other member of it, and
                                  * nothing of the tree is outside of it. */
    bool unaided;                  /* what hides does so whatever other members there are */
    pov_outline solid, clip;
} blocker;

/* The object whose surface all rays of a shaft start on; outward: they leave to the side of its own normals. */
typedef struct departure { uint32_t object; bool outward; } departure;

/* Bit i: nothing at all is on ray i's open segment org .. org + tmax dir: objects of no_shadow and what is transparent count, too.
 * n is not 0. All end on `end`, from the side that rays in its direction would leave to; its object may be POV_NO_OWNER. */
uint64_t query_visible(const world *w, query_context *k, const pov_ray *const *rays, uint32_t n, double tmax, departure end);

/* Name what may cast a shadow in a shaft, until `add` says false. False: `add` said so, or something has neither box nor plane. */
typedef bool query_blocker_fn(void *user, const blocker *b);
bool query_blockers(const world *w, const shaft *s, departure left, query_blocker_fn *add, void *user);
/* Is nothing in a shaft but what its rays leave, and what the segments that count end on from its own outside? False: there may be
 * something. */
bool query_is_clear(const world *w, const shaft *s, departure from, departure to);
/* The nearest crossing in (tmin, tmax) with the objects that these leaves are, whoever sees them. False: there is none. */
bool query_crossing_of(const world *w, query_context *k, const pov_ray *ray, uint32_t leaf, uint32_t leaf_count,
                       double tmin, double tmax, double *t);
/* Is anything on the segment, transparent or not? For pov_trace_blocked(). */
bool query_blocked(const world *w, query_context *k, const pov_ray *ray, double tmax);

/* ---- surfaces that lie on each other ----
 *
 * They share a point and have no distance. So what starts there is said to lie on this or that side of each of them,
 * and a ray crosses at once all those that part it from where it goes: first what it enters, then what it leaves, and
 * of these the earlier object first. Nothing there depends on roundings. More than COINCIDENT_MAX are not told apart:
 * the last objects of them count as any surface near by. */

/* The coincident set of a hit that has coincident surfaces; sides are those of the ray. `from`: the set that the ray
 * started on, or NULL. */
void world_coincident(const world *w, query_context *k, const pov_ray *ray, const coincident_set *from, const hit *h,
                      coincident_set *out);
/* The first surface that a ray of this direction crosses at once, or the set's count. */
uint32_t coincidence_crossed(const coincident_set *s, pov_vec3 dir);
/* Cross the surface: the ray is on its other side. */
static inline void coincidence_pass(coincident_set *s, uint32_t which) { s->above ^= 1u << which; }
/* As query_nearest() and query_occlusion(), for one ray that starts on a coincident set. Surfaces that it crosses at
 * once are left to coincidence_crossed() by the first; the second returns them as bits, all of them transparent, which
 * come first. */
bool query_nearest_from(const world *w, query_context *k, const coincident_set *from, const pov_ray *ray, double tmax,
                        hit *out);
/* The first beyond tmin, wherever the set's surfaces lie. */
bool query_nearest_beyond(const world *w, query_context *k, const coincident_set *from, const pov_ray *ray, double tmin,
                          double tmax, hit *out);
/* As query_blocked(); the surfaces of the set block nothing where it starts. */
bool query_blocked_from(const world *w, query_context *k, const coincident_set *from, const pov_ray *ray, double tmax);
bool query_occlusion_from(const world *w, query_context *k, const coincident_set *from, const pov_ray *ray, double tmax,
                          occlusion *out, uint32_t *crossed);

#endif
