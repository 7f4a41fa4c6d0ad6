/* query.h - what rays ask of a compiled scene: what is nearest, and what is left of light.
 *
 * Every query is [render]: many threads on one const world, each with its own walker. */
#ifndef QUERY_QUERY_H
#define QUERY_QUERY_H

#include "world/surface.h"

typedef struct walker walker;     /* one thread's memory for queries */

pov_status walker_create(walker **out, const world *w, pov_error *err);
void walker_destroy(walker *k);
/* Intersections so far that two-part arithmetic had to decide. */
uint64_t walker_decided(const walker *k);
/* The counts since they were last taken are added. */
void walker_take_classes(walker *k, class_counts *sum);
/* True when memory ended in a query; what the query said is then worth nothing. Stays so. */
bool walker_failed(const walker *k);

/* What the last world_nearest_many() knows of the hits that it found, and no later query. */
const own_rays *walker_own(const walker *k);

/* The nearest crossing in the open interval (0, tmax). Fills crossing, object and company only; false: none. Of several
 * in one place it is the one that the ray crosses first: spot_crossed(). */
bool world_nearest(const world *w, walker *k, const pov_ray *ray, double tmax, hit *out);
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
