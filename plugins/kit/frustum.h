/* frustum.h - cylinders and cones, capped or open, round or squeezed by a map: one implementation for both keywords. */
#ifndef KIT_FRUSTUM_H
#define KIT_FRUSTUM_H

#include "kit/report.h"

/* A point's local coordinates are the rows times (point - anchor). In these the shape is x^2 + y^2 <= (radius + slope
 * z)^2 with 0 <= z <= height; the larger radius and the height are in [1, 2). A mark's part: 0 and 1 for the ray's
 * entry and exit through the side, 2 for the cap at z = 0, 3 for the cap at the height. The anchor is the narrower end:
 * near a cone's apex nothing cancels then. */
typedef struct kit_frustum_size { double radii[2], length; } kit_frustum_size;

typedef struct kit_frustum {
    pov_two3 anchor;
    pov_two3 row[3];             /* for points scaled by `scale` */
    double loss[3];              /* number of roundings in the product of a row and a rounded point */
    pov_two radius, slope, height;
    double scale;
    bool open, empty, slender;   /* slender: much longer than wide */
    bool moved;                  /* it has absorbed a map, and its box is known: the rows no longer tell the written
                                  * shape */
    pov_two3 axis;               /* from the anchor to the other end */
    union { kit_frustum_size written; pov_box box; } of;
} kit_frustum;

/* As written; the ends are two different points. */
typedef struct kit_frustum_text {
    pov_vec3 base, top;
    double base_radius, top_radius;
    bool open;
} kit_frustum_text;

void kit_frustum_prepare(void *self, const void *text);

bool kit_frustum_bounds(const void *self, pov_box *out);
void kit_frustum_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
void kit_frustum_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                uint32_t n);
void kit_frustum_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
void kit_frustum_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                             pov_vec3 *const *out, uint32_t n);
bool kit_frustum_inside(const void *self, pov_vec3 point, pov_vec3 point_lo);
bool kit_frustum_absorb(void *self, const pov_affine *map);

/* ---- blocks ---- */

/* The numbers of a kit_one by lane; or one behind the other for a block of a single shape: a ray then reads two cache
 * lines, and not ten. Rows begin with whole vectors. */
enum { KIT_FRUSTUM_NUMBERS = 18 };

typedef struct kit_frustum_block {
    uint32_t count, unused[7];
    float number[KIT_FRUSTUM_NUMBERS][POV_BLOCK_MAX];
} kit_frustum_block;

/* Size of a block of a single shape, whose numbers stand one behind the other. */
enum { KIT_FRUSTUM_ALONE = offsetof(kit_frustum_block, number) + KIT_FRUSTUM_NUMBERS * sizeof(float) };

bool kit_frustum_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n);
uint32_t kit_frustum_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                            pov_meeting *out);

#endif
