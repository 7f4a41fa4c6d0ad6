/* instance.h - where a shape stands that could not take its transformation into itself: its rays are taken into the
 * shape's own space, its answers back into the world. */
#ifndef WORLD_INSTANCE_H
#define WORLD_INSTANCE_H

#include "bvh/bvh.h"
#include "plug/shape_class.h"

#include <povtrace/exact.h>

/* What is known of a shape, so that rays can be filtered; it is in the range of filters then. */
enum { PLACEMENT_UNKNOWN, PLACEMENT_IN_BOX, PLACEMENT_IS_BOX, PLACEMENT_IS_BALL };

/* A shape in a frame, as its filter sees it, in one line of memory: rows that take points seen from the anchor to a space
 * where its box reaches from -1 to 1, or where it is the ball of radius one; and what a ray is off by there, in units of
 * 1 + S, for a ball that of all rows together. */
typedef struct stand {
    float row[3][3], lost[3], anchor[3];
    uint32_t known;              /* PLACEMENT_* */
} stand;

/* Vectors of four are read of all doubles but the last. */
typedef struct placement {
    pov_vec3 anchor;                           /* world space, near the shape */
    float per_half[3];           /* the inverse of half a box in the shape's own space, around the anchor, that holds it */
    uint8_t known;               /* PLACEMENT_* */
    bool axes;                   /* the inverse has a diagonal only */
    uint8_t reserved;            /* the batch's: see leaf_batch.h */
    pov_vec3 column[3], column_lo[3];          /* of the inverse, in two parts */
    pov_vec3 own_anchor, own_anchor_lo;        /* the anchor in the shape's own space */
} placement;

/* The box around a transformed box, rounded outward. */
void placement_box(const pov_affine *map, const pov_box *own, pov_box *out);
/* The same of a ball: what placement_box() gave of the box that it touches is drawn in to the ball. */
void placement_draw_in(const pov_affine *map, const pov_box *own, pov_box *around);
/* own, around: the shape's box in its own space and in the world, or NULL for an infinite shape. flags: its class's. */
void placement_init(placement *p, const pov_affine *map, const pov_box *own, const pov_box *around, uint32_t flags);

/* The same of up to PLACEMENT_MANY at once, to the bit: they cost little more than one. */
enum { PLACEMENT_MANY = 8 };
typedef struct placement_wish {
    const pov_affine *map;
    const pov_box *own, *around;
    uint32_t flags;
} placement_wish;
void placement_boxes(const pov_affine *const *maps, const pov_box *own, int n, pov_box *out);
void placement_init_many(placement *out, const placement_wish *wishes, int n);

/* Where it stands in a frame around it. False: rays there cannot be filtered. */
bool placement_stand(const placement *p, const bvh_frame *frame, stand *out);
/* The same of an ellipsoid, by its centre and the rows of shape_class. */
bool placement_stand_ellipsoid(const pov_ellipsoid *e, const bvh_frame *frame, stand *out);
/* As block_filter() of a block that holds it alone. */
uint32_t placement_filter(const stand *s, uint32_t owner, const pov_rays *rays, uint64_t lanes, pov_meeting *out);

/* The ray in the shape's own space. */
void placement_ray(const placement *p, const pov_ray *ray, pov_ray *own);
/* The same n times, to the bit. */
void placement_rays(const placement *const *p, const pov_ray *const *rays, pov_ray *const *own, uint32_t n);

/* As the class's own calls, for a ray in the world (its dir_lo is zero). Distances along the ray stay what they are. */
void placement_intersect(const placement *p, const shape_class *shape, const void *self, const pov_ray *ray,
                         pov_hits *hits);
void placement_normal(const placement *p, const shape_class *shape, const void *self, const pov_ray *ray,
                      const pov_crossing *at, pov_vec3 *out);
/* From the shape's own space to the world. */
void placement_turn_normal(const placement *p, pov_vec3 *normal);
/* The same n times, to the bit. */
void placement_turn_normals(const placement *const *p, pov_vec3 *const *normals, uint32_t n);
bool placement_inside(const placement *p, const shape_class *shape, const void *self, pov_vec3 point,
                      pov_vec3 point_lo);

/* Numbers of the filter before an instance: docs/numerics.md ("Block filters") derives them. */
#define PLACEMENT_LEAST 1e-30
#define PLACEMENT_LARGE 1e30       /* no half is larger: its inverse is a float */
#define PLACEMENT_SMALL 1e-20      /* nor smaller, of what is more than in its box */
#define PLACEMENT_FLAT 0x1p-24     /* no half is less of the sum of sizes of its row, for points of the box */
#define PLACEMENT_RANGE 1e100
#define PLACEMENT_ROUNDED 0x1p-48  /* of their coordinates bounds may be too wide */

#define PLACEMENT_E 0x1p-24f
#define PLACEMENT_LOST (48.0f * PLACEMENT_E)
#define PLACEMENT_MOST 0x1p20f     /* of what is lost; else no float would hold what comes of it */
#define PLACEMENT_UNSURE 0x1p-4f   /* with more lost than that nothing is certain */
#define PLACEMENT_SNUG (1.0 - 0x1p-18)
#define PLACEMENT_OUTER (1.0f + 0x1p-17f)   /* of a ball, whose centre is as far from the anchor as its sides tell */
#define PLACEMENT_INNER (1.0f - 0x1p-16f)

#endif
