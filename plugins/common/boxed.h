/* boxed.h - rays that come near the box of a shape: each in the shape's local space, with its stretch within the box. Several are
 * computed side by side. */
#ifndef COMMON_BOXED_H
#define COMMON_BOXED_H

#include "common/clip.h"

/* A local space, and the shape's box in it. */
typedef struct common_boxed { pov_two3 anchor; double scale; pov_vec3 lo, hi; } common_boxed;

typedef struct common_entry { common_ray k; common_span span; } common_entry;

/* What a shape does with a ray that comes near. */
typedef void common_cross_entry(const void *self, const pov_ray *ray, const common_entry *e, pov_hits *hits);

/* Rays side by side: by lane an entry, `least`, the local distance before which nothing counts, and one more than the feature of the shape that
 * it starts on, or 0, in `own`. A ray that misses the box has a span
 * that ends before it begins. */
enum { COMMON_ENTRIES = 8 };
typedef double common_by_entry[COMMON_ENTRIES];
typedef struct common_entries { common_by_entry f[6], d[3], d_lo[3], unit, per_unit, lo, hi, least, own; } common_entries;

/* Of up to COMMON_ENTRIES rays of one shape; `least` and `own` are left out. Lanes past the end hold the last ray again. */
void common_boxed_enter(const common_boxed *b, const pov_ray *const *rays, uint32_t n, common_entries *out);
common_entry common_boxed_entry(const common_entries *l, uint32_t i);
/* Does it reach the box, within the interval? */
bool common_boxed_reaches(const common_entries *l, uint32_t i, const pov_hits *hits);

/* By lane the first crossing behind `least`, in local distances, with its mark: its bits are those that cross() reports, infinite where there is none. Only where
 * `known` is above 0. */
typedef struct common_first_crossings { common_by_entry known, t, t_lo, feature, u, v; } common_first_crossings;

/* What a shape does with rays that come near, where their first crossings are wanted. */
typedef void common_first_of_entries(const void *self, const common_entries *restrict l, common_first_crossings *restrict out);

/* The unit normal at a crossing, whose point in the local space is known. */
typedef void common_normal_at(const void *self, pov_vec3 p, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
void common_boxed_normal_many(size_t boxed_at, common_normal_at *normal_at, const void *const *selves, const pov_ray *const *rays,
                              const pov_crossing *const *at, pov_vec3 *const *out, uint32_t n);

/* intersect() of a class, and intersect_many(): `boxed_at` is where in an instance its box is; `first` may be NULL, and is asked
 * for rays that start on the shape where `starts`. */
void common_boxed_intersect(const common_boxed *b, common_cross_entry *cross, const void *self, const pov_ray *ray, pov_hits *hits);
void common_boxed_intersect_many(size_t boxed_at, common_cross_entry *cross, common_first_of_entries *first, bool starts, const void *const *selves,
                                 const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);

/* A class whose instances have a member `boxed` does all that by its cross(). */
#define COMMON_BOXED_CLASS(type, cross)                                                                                      \
    COMMON_BOXED_RAYS(type, cross, NULL, false)                                                                              \
    static const pov_shape_fast fast = { .size = sizeof(pov_shape_fast), .intersect_many = intersect_many };                 \
    static const void *extension(const char *name) { return common_is_fast(name) ? &fast : NULL; }

/* The same of one that finds first crossings side by side, and looks at candidates closer, which needs narrow.h. */
#define COMMON_NARROW_CLASS(type, cross, first, starts, closer)                                                              \
    COMMON_BOXED_RAYS(type, cross, first, starts)                                                                            \
    COMMON_NARROW_PACK(closer)                                                                                               \
    static const pov_shape_fast fast = { .size = sizeof(pov_shape_fast), .intersect_many = intersect_many,                   \
                                         COMMON_NARROW_BLOCKS(closer) };                                                     \
    static const void *extension(const char *name) { return common_is_fast(name) ? &fast : NULL; }

/* And whose normals need points, which are found side by side: its normal_at() does the rest. */
#define COMMON_ROUND_CLASS(type, cross, first, starts, closer, normal_at)                                                    \
    COMMON_BOXED_RAYS(type, cross, first, starts)                                                                            \
    COMMON_BOXED_NORMALS(type, normal_at)                                                                                    \
    COMMON_NARROW_PACK(closer)                                                                                               \
    static const pov_shape_fast fast = { .size = sizeof(pov_shape_fast), .intersect_many = intersect_many,                   \
                                         .normal_many = normal_many, COMMON_NARROW_BLOCKS(closer) };                         \
    static const void *extension(const char *name) { return common_is_fast(name) ? &fast : NULL; }

#define COMMON_BOXED_NORMALS(type, normal_at)                                                                                \
    static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)                          \
    {                                                                                                                        \
        const common_boxed *b = &((const type *)self)->boxed;                                                                \
        const common_ray k = common_enter(ray, b->anchor, b->scale);                                                         \
                                                                                                                             \
        normal_at(self, pov_two3_hi(common_point(&k, at)), ray, at, out);                                                    \
    }                                                                                                                        \
    static void normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,            \
                            pov_vec3 *const *out, uint32_t n)                                                                \
    {                                                                                                                        \
        common_boxed_normal_many(offsetof(type, boxed), normal_at, selves, rays, at, out, n);                                \
    }

#define COMMON_BOXED_RAYS(type, cross, first, starts)                                                                        \
    static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)                                              \
    {                                                                                                                        \
        common_boxed_intersect(&((const type *)self)->boxed, cross, self, ray, hits);                                       \
    }                                                                                                                        \
    static void intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)     \
    {                                                                                                                        \
        common_boxed_intersect_many(offsetof(type, boxed), cross, first, starts, selves, rays, hits, n);                     \
    }

#endif
