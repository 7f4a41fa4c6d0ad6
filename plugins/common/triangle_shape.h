/* triangle_shape.h - a triangle that is a shape of its own, flat or smooth. */
#ifndef COMMON_TRIANGLE_SHAPE_H
#define COMMON_TRIANGLE_SHAPE_H

#include "common/planar_block.h"
#include "common/triangle.h"

typedef struct common_triangle {
    pov_vec3 corner[3];          /* times the scale */
    double scale;                /* a power of two that makes the longest edge of the order of one */
    bool seen;                   /* the corners do not lie on a line */
    pov_vec3 normal;             /* unit */
    pov_vec3 at_corner[3];       /* smooth: normals at the corners, unit */
} common_triangle;

/* Make it of corners as written; one whose corners lie on a line is never met. */
void common_triangle_make(common_triangle *t, const pov_vec3 corner[3]);

/* Functions of the class. */
bool common_triangle_bounds(const void *self, pov_box *out);
bool common_triangle_face(const void *self, uint32_t number, pov_face *out);
void common_triangle_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
void common_triangle_plane_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
uint32_t common_triangle_shading_normals(const void *self, pov_vec3 point, pov_vec3 point_lo, const pov_mark *mark,
                                         pov_vec3 *normal, double *share);
bool common_triangle_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n);

#endif
