/* instance.h - where a shape stands that could not take its transformation into itself: its rays are taken into the
 * shape's own space, its answers back into the world. */
#ifndef WORLD_INSTANCE_H
#define WORLD_INSTANCE_H

#include "bvh/bvh.h"
#include "plug/shape_class.h"

#include <povtrace/exact.h>

/* What is known of a shape, so that rays can be filtered; it is in the range of filters then. */
enum { INSTANCE_UNKNOWN, INSTANCE_IN_BOX, INSTANCE_IS_BOX, INSTANCE_IS_SPHERE };

/* A shape in a frame, as its filter sees it, in one line of memory: rows that take points seen from the anchor to a
 * space where its box reaches from -1 to 1, or where it is the sphere of radius one; and what a ray is off by there, in
 * units of 1 + S, for a sphere that of all rows together. */
typedef struct instance_filter {
    float row[3][3], lost[3], anchor[3];
    uint32_t known;              /* INSTANCE_* */
} instance_filter;

/* Vectors of four are read of all doubles but the last. */
typedef struct instance_xform {
    pov_vec3 anchor;                           /* world space, near the shape */
    float per_half[3];           /* the inverse of half a box in the shape's own space, around the anchor, that holds it */
    uint8_t known;               /* INSTANCE_* */
    bool axes;                   /* the inverse has a diagonal only */
    uint8_t reserved;            /* the batch's: see leaf_batch.h */
    pov_vec3 column[3], column_lo[3];          /* of the inverse, in double-double */
    pov_vec3 own_anchor, own_anchor_lo;        /* the anchor in the shape's own space */
} instance_xform;

/* The box around a transformed box, rounded outward. */
void instance_box(const pov_affine *map, const pov_box *own, pov_box *out);
/* The same of a sphere: what instance_box() gave of the box that it touches is drawn in to the sphere. */
void instance_shrink_box(const pov_affine *map, const pov_box *own, pov_box *around);
/* own, around: the shape's box in its own space and in the world, or NULL for an infinite shape. flags: its class's. */
void instance_init(instance_xform *p, const pov_affine *map, const pov_box *own, const pov_box *around, uint32_t flags);

/* Where it stands in a frame around it. False: rays there cannot be filtered. */
bool instance_filter_make(const instance_xform *p, const bvh_frame *frame, instance_filter *out);
/* The same of an ellipsoid, by its centre and the rows of shape_class. */
bool instance_filter_make_ellipsoid(const pov_ellipsoid *e, const bvh_frame *frame, instance_filter *out);
/* As block_filter() of a block that holds it alone. */
uint32_t instance_filter_rays(const instance_filter *s, uint32_t owner, const pov_rays *rays, uint64_t lanes,
                              pov_candidate *out);

/* The ray in the shape's own space. */
void instance_ray(const instance_xform *p, const pov_ray *ray, pov_ray *own);
/* The same n times, bit for bit. */
void instance_rays(const instance_xform *const *p, const pov_ray *const *rays, pov_ray *const *own, uint32_t n);

/* As the class's own calls, for a ray in the world (its dir_lo is zero). Distances along the ray stay what they are. */
void instance_intersect(const instance_xform *p, const shape_class *shape, const void *self, const pov_ray *ray,
                        pov_hits *hits);
void instance_normal(const instance_xform *p, const shape_class *shape, const void *self, const pov_ray *ray,
                     const pov_crossing *at, pov_vec3 *out);
/* From the shape's own space to the world. */
void instance_world_normal(const instance_xform *p, pov_vec3 *normal);
/* The same n times, bit for bit. */
void instance_world_normals(const instance_xform *const *p, pov_vec3 *const *normals, uint32_t n);
bool instance_inside(const instance_xform *p, const shape_class *shape, const void *self, pov_vec3 point,
                     pov_vec3 point_lo);

/* Numbers of the filter before an instance: docs/numerics.md ("Block filters") derives them. */
#define INSTANCE_LEAST 1e-30
#define INSTANCE_LARGE 1e30        /* no half is larger: its inverse is a float */
#define INSTANCE_SMALL 1e-20       /* nor smaller, of what is more than in its box */
#define INSTANCE_THIN 0x1p-24      /* no half is less of the sum of sizes of its row, for points of the box */
#define INSTANCE_RANGE 1e100
#define INSTANCE_ROUNDED 0x1p-48   /* of their coordinates bounds may be too wide */

#define INSTANCE_E 0x1p-24f
#define INSTANCE_LOST (48.0f * INSTANCE_E)
#define INSTANCE_MOST 0x1p20f      /* of what is lost; else no float would hold what comes of it */
#define INSTANCE_UNSURE 0x1p-4f    /* with more lost than that nothing is certain */
#define INSTANCE_SNUG (1.0 - 0x1p-18)
#define INSTANCE_OUTER (1.0f + 0x1p-17f)    /* of a sphere, whose centre is as far from the anchor as its sides tell */
#define INSTANCE_INNER (1.0f - 0x1p-16f)

#endif
