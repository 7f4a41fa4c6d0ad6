/* placement.h - where a shape stands that could not take its transformation into itself: its rays are taken into the
 * shape's own space, its answers back into the world. */
#ifndef WORLD_PLACEMENT_H
#define WORLD_PLACEMENT_H

#include <povtrace/exact.h>
#include <povtrace/plugin.h>

typedef struct placement {
    pov_vec3 column[3], column_lo[3];          /* of the inverse, in two parts */
    pov_vec3 own_anchor, own_anchor_lo;        /* the anchor in the shape's own space */
    pov_vec3 anchor;                           /* world space, near the shape */
    float half[3];               /* own space, from the anchor to the sides of a box that holds the shape, and more */
    bool axes;                   /* the inverse has a diagonal only */
    bool boxed;                  /* there is that box, and nothing is out of range: rays are filtered */
} placement;

/* The box around a transformed box, rounded outward. */
void placement_box(const pov_affine *map, const pov_box *own, pov_box *out);
/* own, around: the shape's box in its own space and in the world, or NULL for an infinite shape. */
void placement_init(placement *p, const pov_affine *map, const pov_box *own, const pov_box *around);

/* As the class's own calls, for a ray in the world (its dir_lo is zero). Distances along the ray stay what they are.
 * intersect() first asks the filter, but for hits that are always exact. */
void placement_intersect(const placement *p, const pov_shape_class *shape, const void *self, const pov_ray *ray,
                         pov_hits *hits);
void placement_normal(const placement *p, const pov_shape_class *shape, const void *self, const pov_ray *ray,
                      const pov_crossing *at, pov_vec3 *out);
bool placement_inside(const placement *p, const pov_shape_class *shape, const void *self, pov_vec3 point,
                      pov_vec3 point_lo);

/* What a processor does in its own way, the same bits in each. `misses` is the filter: in plain double, true where the
 * ray surely does not meet the shape's own box between tmin and tmax. */
typedef struct placement_code {
    void (*own_ray)(const placement *p, const pov_ray *ray, pov_ray *own);
    bool (*misses)(const placement *p, const pov_ray *ray, double tmin, double tmax);
} placement_code;

extern const placement_code placement_portable;
#if defined(__x86_64__) && defined(__GNUC__) && !defined(POV_PORTABLE)
extern const placement_code placement_avx2;   /* only where the processor has AVX2 and fma */
#endif

#endif
