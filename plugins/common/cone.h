/* cone.h - cylinders and cones, capped or open, round or squeezed by a map: one implementation for both keywords. */
#ifndef COMMON_CONE_H
#define COMMON_CONE_H

#include "common/report.h"

/* A point's local coordinates are the rows times (point - anchor). In these the shape is x^2 + y^2 <= (radius + slope
 * z)^2 with 0 <= z <= height; the larger radius and the height are in [1, 2). A mark's part: 0 and 1 for the ray's
 * entry and exit through the side, 2 for the cap at z = 0, 3 for the cap at the height. The anchor is the narrower end:
 * near a cone's apex nothing cancels then. */
typedef struct common_cone_size { double radii[2], length; } common_cone_size;

typedef struct common_cone {
    pov_two3 anchor;
    pov_two3 row[3];             /* for points scaled by `scale` */
    double loss[3];              /* number of roundings in the product of a row and a rounded point */
    pov_two radius, slope, height;
    double scale;
    bool open, empty, slender;   /* slender: much longer than wide */
    bool moved;                  /* it has absorbed a map, and its box is known: the rows no longer tell the written
                                  * shape */
    pov_two3 axis;               /* from the anchor to the other end */
    union { common_cone_size written; pov_box box; } of;
} common_cone;

/* As written; the ends are two different points. */
typedef struct common_cone_parsed {
    pov_vec3 base, top;
    double base_radius, top_radius;
    bool open;
} common_cone_parsed;

void common_cone_prepare(void *self, const void *parsed);
/* The narrower end is the base, and of equal ends the one that comes first. */
void common_cone_reorder(void *parsed);

bool common_cone_bounds(const void *self, pov_box *out);
void common_cone_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
void common_cone_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                uint32_t n);
void common_cone_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
void common_cone_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                             pov_vec3 *const *out, uint32_t n);
bool common_cone_inside(const void *self, pov_vec3 point, pov_vec3 point_lo);
bool common_cone_absorb(void *self, const pov_affine *map);
bool common_cone_open(const void *self);
bool common_cone_outline(const void *self, pov_outline *out);

/* ---- blocks ---- */

/* The numbers of a common_one by lane; or one behind the other for a block of a single shape: a ray then reads two
 * cache lines, and not ten. Rows begin with whole vectors. */
enum { COMMON_CONE_NUMBERS = 18 };

typedef struct common_cone_block {
    uint32_t count, unused[7];
    float number[COMMON_CONE_NUMBERS][POV_BLOCK_MAX];
} common_cone_block;

/* Size of a block of a single shape, whose numbers stand one behind the other. */
enum { COMMON_CONE_SINGLE = offsetof(common_cone_block, number) + COMMON_CONE_NUMBERS * sizeof(float) };

bool common_cone_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n);
uint32_t common_cone_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                            pov_candidate *out);

#endif
