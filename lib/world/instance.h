/* instance.h - transforms of shapes that could not absorb their transformation: rays are transformed to object space,
 * results back to the world. */
#ifndef WORLD_INSTANCE_H
#define WORLD_INSTANCE_H

#include "bvh/bvh.h"
#include "plug/shape_class.h"

#include <povtrace/exact.h>

/* Knowledge about a shape for filters; it is in the range of filters unless unknown. */
enum { INSTANCE_UNKNOWN, INSTANCE_IN_BOX, INSTANCE_IS_BOX, INSTANCE_IS_SPHERE };

/* Filter record of a shape in a frame, in one cache line: rows that transform points relative to the anchor to a space
 * where its box reaches from -1 to 1, or where it is the unit sphere; and the error of a ray there, in units of 1 + S,
 * for a sphere the sum over all rows. */
typedef struct instance_filter {
    float row[3][3], lost[3], anchor[3];
    uint32_t known;              /* INSTANCE_* */
} instance_filter;

/* Vectors of four doubles are loaded from all members except the last. */
typedef struct instance_xform {
    pov_vec3 anchor;                           /* world space, near the shape */
    float per_half[3];           /* inverse half extents of a box in object space around the anchor that holds the
                                  * shape */
    uint8_t known;               /* INSTANCE_* */
    bool axes;                   /* the inverse is diagonal */
    uint8_t reserved;            /* a byte of the leaf batch: see leaf_batch.h */
    pov_vec3 column[3], column_lo[3];          /* columns of the inverse, in double-double */
    pov_vec3 own_anchor, own_anchor_lo;        /* the anchor in object space */
} instance_xform;

/* The box around a transformed box, rounded outward. */
void instance_box(const pov_affine *map, const pov_box *own, pov_box *out);
/* The same of a sphere: shrink the result of instance_box() for its bounding box to the sphere. */
void instance_shrink_box(const pov_affine *map, const pov_box *own, pov_box *around);
/* own, around: the shape's box in object space and in the world, or NULL for an infinite shape. flags: those of its
 * class. */
void instance_init(instance_xform *p, const pov_affine *map, const pov_box *own, const pov_box *around, uint32_t flags);

/* Make the filter record for a frame around the shape. False: rays there cannot be filtered. */
bool instance_filter_make(const instance_xform *p, const bvh_frame *frame, instance_filter *out);
/* The same of an ellipsoid, by its centre and the rows of shape_class. */
bool instance_filter_make_ellipsoid(const pov_ellipsoid *e, const bvh_frame *frame, instance_filter *out);
/* As block_filter() of a block with this shape only. */
uint32_t instance_filter_rays(const instance_filter *s, uint32_t owner, const pov_rays *rays, uint64_t lanes,
                              pov_candidate *out);

/* Transform a ray to object space. */
void instance_ray(const instance_xform *p, const pov_ray *ray, pov_ray *own);
/* The same n times, bit for bit, for rays whose dir_lo is zero. */
void instance_rays(const instance_xform *const *p, const pov_ray *const *rays, pov_ray *const *own, uint32_t n);

/* As the class's functions, for a ray in the world. Distances along the ray do not change. */
void instance_intersect(const instance_xform *p, const shape_class *shape, const void *self, const pov_ray *ray,
                        pov_hits *hits);
void instance_normal(const instance_xform *p, const shape_class *shape, const void *self, const pov_ray *ray,
                     const pov_crossing *at, pov_vec3 *out);
/* Transform a normal from object space to the world. */
void instance_world_normal(const instance_xform *p, pov_vec3 *normal);
/* The same n times, bit for bit. */
void instance_world_normals(const instance_xform *const *p, pov_vec3 *const *normals, uint32_t n);
/* Of up to four of one instance. */
void instance_rotate_normals(const instance_xform *p, pov_vec3 *normals, uint32_t n);
/* A point of the world in object space. */
pov_two3 instance_point(const instance_xform *p, pov_vec3 point, pov_vec3 point_lo);
/* The same n times, bit for bit, in place. */
void instance_points(const instance_xform *const *p, pov_vec3 *const *points, pov_vec3 *const *points_lo, uint32_t n);
/* Move the outline of an instanced shape to the world, in doubles. False: the shape is too small for where it is. */
bool instance_outline(const instance_xform *p, pov_outline *io);
bool instance_inside(const instance_xform *p, const shape_class *shape, const void *self, pov_vec3 point,
                     pov_vec3 point_lo);

/* Constants of instance filters: docs/numerics.md ("Block filters") derives them. */
#define INSTANCE_LEAST 1e-30
#define INSTANCE_LARGE 1e30        /* upper limit of a half extent: its inverse must be a float */
#define INSTANCE_SMALL 1e-20       /* lower limit of a half extent of a shape that fills its box */
#define INSTANCE_THIN 0x1p-24      /* lower limit of a half extent relative to the sum of sizes of its row, for points
                                    * of the box */
#define INSTANCE_RANGE 1e100
#define INSTANCE_ROUNDED 0x1p-48   /* relative excess of bounds */

#define INSTANCE_E 0x1p-24f
#define INSTANCE_LOST (48.0f * INSTANCE_E)
#define INSTANCE_MOST 0x1p20f      /* upper limit of the error, for the range of floats */
#define INSTANCE_UNSURE 0x1p-4f    /* with a larger error nothing is definite */
#define INSTANCE_SNUG (1.0 - 0x1p-18)
#define INSTANCE_OUTER (1.0f + 0x1p-17f)    /* outer radius of a sphere, whose centre is off by as much as its sides */
#define INSTANCE_INNER (1.0f - 0x1p-16f)

#endif
