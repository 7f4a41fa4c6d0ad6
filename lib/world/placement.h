/* placement.h - where a shape stands that could not take its transformation into itself: its rays are taken into the
 * shape's own space, its answers back into the world. */
#ifndef WORLD_PLACEMENT_H
#define WORLD_PLACEMENT_H

#include <povtrace/exact.h>
#include <povtrace/plugin.h>

typedef struct placement {
    pov_two inverse[3][3];
    pov_two own_anchor[3];       /* the anchor in the shape's own space */
    pov_vec3 anchor;             /* world space, near the shape */
    bool axes;                   /* the inverse has a diagonal only */
} placement;

/* The box around a transformed box, rounded outward. */
void placement_box(const pov_affine *map, const pov_box *own, pov_box *out);
/* around: the shape's box in the world, or NULL for an infinite shape. */
void placement_init(placement *p, const pov_affine *map, const pov_box *around);

/* As the class's own calls, for a ray in the world (its dir_lo is zero). Distances along the ray stay what they are. */
void placement_intersect(const placement *p, const pov_shape_class *shape, const void *self, const pov_ray *ray,
                         pov_hits *hits);
void placement_normal(const placement *p, const pov_shape_class *shape, const void *self, const pov_ray *ray,
                      const pov_crossing *at, pov_vec3 *out);
bool placement_inside(const placement *p, const pov_shape_class *shape, const void *self, pov_vec3 point,
                      pov_vec3 point_lo);

#endif
