/* query.h - what rays ask of a compiled scene: what is nearest, and what is left of light.
 *
 * Every query is [render]: many threads on one const world, each with its own query context. */
#ifndef QUERY_QUERY_H
#define QUERY_QUERY_H

#include "world/surface.h"

typedef struct query_context query_context;   /* one thread's memory for queries */

pov_status query_context_create(query_context **out, const world *w, pov_error *err);
void query_context_destroy(query_context *k);
/* Intersections so far that double-double arithmetic had to decide. */
uint64_t query_context_escalated(const query_context *k);
/* The counts since they were last taken are added. */
void query_context_take_classes(query_context *k, class_counts *sum);
/* True when memory ended in a query; what the query said is then worth nothing. Stays so. */
bool query_context_failed(const query_context *k);

/* What the last query_nearest() knows of the hits that it found, and no later query. */
const object_space_rays *query_context_own(const query_context *k);

/* Of up to WORLD_MANY rays the nearest crossing in the open interval (0, tmax). Rays that start and go alike cost a
 * fraction of single ones, and each gets the answer that it would get alone. Fills crossing, object and coincident
 * only; bit i of what is returned is ray i's, and nothing is said in out of a ray that hits nothing. Of several
 * crossings in one place it is the one that the ray crosses first: coincidence_crossed(). */
uint64_t query_nearest(const world *w, query_context *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out);

/* What light crosses: of the rays that `crossed` has a bit for their crossings of transparent surfaces, those of one
 * object from near to far, and earlier objects first. They are the query context's, until its next query. Distances are
 * to be relied on for objects that are not plain. */
typedef struct occlusion {
    uint64_t crossed;
    const pov_crossing *at[WORLD_MANY];
    uint32_t count[WORLD_MANY];
} occlusion;

/* On the open segments org .. org + tmax dir: bit i: nothing opaque stands on the way of ray i. Objects of no_shadow do
 * not count. */
uint64_t query_occlusion(const world *w, query_context *k, const pov_ray *const *rays, uint32_t n, double tmax,
                         occlusion *out);
/* Is anything there at all, transparent or not? For pov_trace_blocked(). */
bool query_blocked(const world *w, query_context *k, const pov_ray *ray, double tmax);

/* ---- surfaces that lie on each other ----
 *
 * They share a point and have no distance. So what starts there is said to lie on this or that side of each of them,
 * and a ray crosses at once all those that part it from where it goes: first what it enters, then what it leaves, and
 * of these the earlier object first. Nothing there depends on roundings. More than COINCIDENT_MAX are not told apart:
 * the last objects of them count as any surface near by. */

enum { COINCIDENT_MAX = 16 };

typedef struct coincident_set {
    uint32_t count;
    uint32_t above;              /* bit i: the point lies where the normal of at[i] points to */
    uint32_t solid;              /* bit i: at[i] is a solid's */
    hit at[COINCIDENT_MAX];      /* by object */
} coincident_set;

/* What lies where query_nearest() or query_nearest_from() found coincident surfaces; sides are the ray's own. `from`:
 * what the ray started on, or NULL. */
void world_coincident(const world *w, query_context *k, const pov_ray *ray, const coincident_set *from, const hit *h,
                      coincident_set *out);
/* The first surface that a ray of this direction crosses at once, or the coincident set's count. */
uint32_t coincidence_crossed(const coincident_set *s, pov_vec3 dir);
/* It is crossed: the ray is on its other side. */
static inline void coincidence_pass(coincident_set *s, uint32_t which) { s->above ^= 1u << which; }
/* As query_nearest() and query_occlusion(), for one ray that starts on the coincident set. What it crosses at once is
 * left to coincidence_crossed() by the one; the other gives bits of the coincident set's surfaces, all of them
 * transparent, which come first. */
bool query_nearest_from(const world *w, query_context *k, const coincident_set *from, const pov_ray *ray, double tmax,
                        hit *out);
bool query_occlusion_from(const world *w, query_context *k, const coincident_set *from, const pov_ray *ray, double tmax,
                          occlusion *out, uint32_t *crossed);

#endif
