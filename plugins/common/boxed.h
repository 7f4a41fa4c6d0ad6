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

/* intersect() of a class, and intersect_many(): `boxed_at` is where in an instance its box is. */
void common_boxed_intersect(const common_boxed *b, common_cross_entry *cross, const void *self, const pov_ray *ray, pov_hits *hits);
void common_boxed_intersect_many(size_t boxed_at, common_cross_entry *cross, const void *const *selves, const pov_ray *const *rays,
                                 pov_hits *const *hits, uint32_t n);

/* A class whose instances have a member `boxed` does all that by its cross(). */
#define COMMON_BOXED_CLASS(type, cross) COMMON_NARROW_CLASS(type, cross, NULL)

/* The same of one that looks at candidates closer (narrow.h). */
#define COMMON_NARROW_CLASS(type, cross, closer)                                                                             \
    static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)                                              \
    {                                                                                                                        \
        common_boxed_intersect(&((const type *)self)->boxed, cross, self, ray, hits);                                       \
    }                                                                                                                        \
    static void intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)     \
    {                                                                                                                        \
        common_boxed_intersect_many(offsetof(type, boxed), cross, selves, rays, hits, n);                                    \
    }                                                                                                                        \
    static const pov_shape_fast fast = { .size = sizeof(pov_shape_fast), .intersect_many = intersect_many, .narrow = closer };   \
    static const void *extension(const char *name) { return common_is_fast(name) ? &fast : NULL; }

#endif
