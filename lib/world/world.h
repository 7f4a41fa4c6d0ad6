/* world.h - a scene compiled for rays: what the plan found needed, and nothing else.
 *
 * Object indices are the model's. Every query is [render]: many threads on one const world, each with its own walker.
 */
#ifndef WORLD_WORLD_H
#define WORLD_WORLD_H

#include "base/simd.h"
#include "model/model.h"
#include "world/plan.h"

typedef struct world world;
typedef struct walker walker;     /* one thread's memory for queries */

typedef struct world_options {
    pov_accel accel;
    int threads;                 /* for building; 0: one a core */
    bool always_exact;           /* two-part arithmetic for every intersection, and no filters before it */
    const registry *plugins;     /* for the plan's rows on plugins that were not needed; may be NULL */
    model *last;                 /* the model itself, if no other world is to come of it: its transformations go as soon
                                  * as shapes have their places, a quarter of a large scene's memory; else NULL */
} world_options;

/* The model must outlive the world and is not changed, but for what options->last says. */
pov_status world_create(world **out, const model *m, const world_options *options, pov_error *err);
void world_destroy(world *w);
const plan *world_plan(const world *w);
/* Box around all finite objects; false: there is none. */
bool world_bounds(const world *w, pov_box *out);
/* What is looked at of each object that is met, by object: in one line of memory, and in few pages. slot, group: the
 * world's own affair. */
typedef struct world_thing { uint32_t slot, material; uint16_t group; bool inverse, tints; } world_thing;
const world_thing *world_things(const world *w);
/* Objects without a finite box, which every ray is asked for. */
size_t world_infinite_count(const world *w);
/* Were its options to use two-part arithmetic for every intersection? */
bool world_is_exact(const world *w);

/* What each class of primitives was asked, after boxes and filters, and what two-part arithmetic had to decide of it. */
enum { WORLD_CLASSES = 16 };
typedef struct class_counts { struct { uint64_t asked, decided; } of[WORLD_CLASSES]; } class_counts;

/* The keyword of a class by its number; NULL past the last. */
const char *world_class(const world *w, size_t number);

pov_status walker_create(walker **out, const world *w, pov_error *err);
void walker_destroy(walker *k);
/* Intersections so far that two-part arithmetic had to decide. */
uint64_t walker_decided(const walker *k);
/* The counts since they were last taken are added. */
void walker_take_classes(walker *k, class_counts *sum);
/* True when memory ended in a query; what the query said is then worth nothing. Stays so. */
bool walker_failed(const walker *k);

/* A ray's meeting with an object: two lines of memory where it begins with one, and what is known at first in one of
 * them. */
typedef struct hit {
    pov_vec3 point, point_lo;    /* world space, the sum of both */
    pov_vec3 normal;             /* unit, world space, out of the solid (inverse objects: into it) */
    bool entering;               /* the ray goes against that normal */
    bool outside;                /* the ray goes against the shape's own: it comes from where no convex shape is */
    uint16_t company;            /* how many surfaces lie on each other here, this one among them; 0: it is alone */
    uint32_t object;
    pov_crossing crossing;
} hit;

/* The nearest crossing in the open interval (0, tmax). Fills crossing, object and company only; false: none. Of several
 * in one place it is the one that the ray crosses first: spot_crossed(). */
bool world_nearest(const world *w, walker *k, const pov_ray *ray, double tmax, hit *out);
/* Fill the rest of what world_nearest() found. */
void world_surface(const world *w, const pov_ray *ray, hit *h);

/* Vectors by lane, so that loops over lanes become vectors of the processor. */
enum { WORLD_MANY = 64 };
typedef struct SIMD_ALIGNED vec_lanes { double x[WORLD_MANY], y[WORLD_MANY], z[WORLD_MANY]; } vec_lanes;

static inline pov_vec3 lanes_at(const vec_lanes *l, uint32_t i) { return pov_vec3_of(l->x[i], l->y[i], l->z[i]); }
static inline void lanes_put(vec_lanes *l, uint32_t i, pov_vec3 v)
{
    l->x[i] = v.x;
    l->y[i] = v.y;
    l->z[i] = v.z;
}

/* How rays come to surfaces, by lane. */
typedef struct approaches {
    vec_lanes way;               /* direction of the ray */
    vec_lanes point, point_lo;
    vec_lanes normal;            /* unit, turned towards the ray's start */
} approaches;

/* Of a hit that is filled. */
void world_approach(approaches *out, uint32_t lane, const pov_ray *ray, const hit *h);
/* Of up to WORLD_MANY rays with a hit each: what world_surface() fills, to the bit, and the approaches; many cost less
 * than as many alone. k: the walker that found the hits, and no others since, as world_nearest_many(), and so knows more
 * of them; else NULL. */
void world_surface_many(const world *w, const walker *k, const pov_ray *const *rays, hit *const *hits, uint32_t n,
                        approaches *out);

/* Some hundred times what normals may be off by. */
#define WORLD_AWAY 0x1p-36

/* What a ray leaves, with what more is known of it. The mark is put together before it is stored: who waits for it reads
 * it at once. */
static inline void world_name_left(pov_ray *ray, const hit *h, uint32_t known)
{
    const pov_mark *mark = &h->crossing.mark;

    ray->left = h->object;
    ray->left_mark.part = mark->part;
    ray->left_mark.flags = mark->flags | known;
    ray->left_mark.u = mark->u;
    ray->left_mark.v = mark->v;
}

/* Name what a ray leaves that goes back to the side that it came from, at this cosine to the normal there. Up to
 * WORLD_AWAY nothing is said of whether it goes away. */
static inline void world_leave(pov_ray *ray, const hit *h, double cosine)
{
    world_name_left(ray, h, cosine > WORLD_AWAY ? (h->outside ? POV_MARK_AWAY : POV_MARK_INTO) : 0);
}

/* The same of a ray that goes on to the other side. */
static inline void world_cross(pov_ray *ray, const hit *h, double cosine)
{
    world_name_left(ray, h, cosine > WORLD_AWAY ? (h->outside ? POV_MARK_INTO : POV_MARK_AWAY) : 0);
}

/* What is left of light on the open segment org .. org + tmax dir: white when nothing stands there, the product of
 * what transparent surfaces let through, crossing by crossing from near to far. False: nothing is left, an opaque
 * surface or enough black ones stand there. Objects of no_shadow do not count. */
bool world_light_path(const world *w, walker *k, const pov_ray *ray, double tmax, colour *through);
/* The same of up to WORLD_MANY rays in company, with their answers to the bit: those of rays that start and go alike
 * cost a fraction of single ones. out and through have room for n; bit i of what is returned is ray i's, and
 * nothing is said in out of a ray that meets nothing. */
uint64_t world_nearest_many(const world *w, walker *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out);
/* The same of rays that start at one point and on nothing. ways: their directions, by lane; those of the rays are only
 * written where they are wanted, of all that meet anything among others. */
uint64_t world_nearest_fan(const world *w, walker *k, pov_ray *rays, const vec_lanes *ways, uint32_t n, double tmax,
                           hit *out);
uint64_t world_light_path_many(const world *w, walker *k, const pov_ray *const *rays, uint32_t n, double tmax,
                               colour *through);
/* Is anything there at all, transparent or not? For pov_trace_blocked(). */
bool world_blocked(const world *w, walker *k, const pov_ray *ray, double tmax);

/* The media (transparent solids) that a point lies in, the largest first. Calls see for each. Only of use where the
 * plan has media_at_start. */
void world_media_at(const world *w, pov_vec3 point, pov_vec3 point_lo, void (*see)(void *user, uint32_t object),
                    void *user);

/* ---- surfaces that lie on each other ----
 *
 * They share a point and have no distance. So what starts there is said to lie on this or that side of each of them, and
 * a ray crosses at once all those that part it from where it goes: first what it enters, then what it leaves, and of
 * these the earlier object first. Nothing there depends on roundings. More than SPOT_MAX are not told apart: the last
 * objects of them count as any surface near by. */

enum { SPOT_MAX = 16 };

typedef struct spot {
    uint32_t count;
    uint32_t above;              /* bit i: the point lies where the normal of at[i] points to */
    uint32_t solid;              /* bit i: at[i] is a solid's */
    hit at[SPOT_MAX];            /* by object */
} spot;

/* What lies where world_nearest() or world_nearest_from() found company; sides are the ray's own. `from`: what the ray
 * started on, or NULL. */
void world_spot(const world *w, walker *k, const pov_ray *ray, const spot *from, const hit *h, spot *out);
/* The first surface that a ray of this direction crosses at once, or the spot's count. */
uint32_t spot_crossed(const spot *s, pov_vec3 dir);
/* It is crossed: the ray is on its other side. */
static inline void spot_pass(spot *s, uint32_t which) { s->above ^= 1u << which; }
/* As world_nearest() and world_light_path(), for a ray that starts on the spot. What it crosses at once comes first for
 * light; world_nearest_from() leaves it to spot_crossed(). */
bool world_nearest_from(const world *w, walker *k, const spot *from, const pov_ray *ray, double tmax, hit *out);
bool world_light_path_from(const world *w, walker *k, const spot *from, const pov_ray *ray, double tmax,
                           colour *through);

#endif
