/* heights.h - heights over the unit square, in cells of two triangles, as rays meet them: alone (heights.c), or many (heights_many.c). */
#ifndef COMMON_HEIGHTS_H
#define COMMON_HEIGHTS_H

#include "common/boxed.h"
#include "common/relief_walk.h"
#include "common/steep.h"
#include "common/triangle.h"

typedef struct common_heights {
    common_boxed boxed;
    uint32_t wide, deep;         /* corners along x and z */
    const uint16_t *height;      /* in 1/65536, rows from z = 0 */
    const double *column, *row;  /* x and z of corners, rounded once, alike for each face that has them */
    common_relief relief;
    common_relief_ranges ranges;
    common_steeps steeps;        /* of a smooth one */
    double water, low, high;
    bool smooth;
} common_heights;

static inline double common_height_at(const common_heights *f, uint32_t x, uint32_t z) { return f->height[(size_t)z * f->wide + x] * 0x1p-16; }
static inline pov_vec3 common_heights_centre(void) { return pov_vec3_of(0.5, 0.5, 0.5); }

static inline pov_vec3 common_height_corner(const common_heights *f, uint32_t x, uint32_t z)
{
    return pov_vec3_of(f->column[x], common_height_at(f, x, z), f->row[z]);
}

/* Does the line of the ray pass through a triangle? */
typedef enum common_passing { COMMON_BESIDE, COMMON_THROUGH, COMMON_UNCLEAR } common_passing;

/* One above zero tells: it passes beside the triangle, or through it for certain. */
typedef struct common_judged { double across, sure; } common_judged;

/* In double: at t the ray is `above` + t `rise` over the triangle's plane, and at u + t du, v + t dv in it; its sides are u = 0, v = 0
 * and u + v = 1. Where the ray crosses the plane these are, times `rise`, the three numbers below: it passes on one side of all edges
 * or on different ones. */
COMMON_INLINE common_judged common_judge_face(double above, double rise, double u, double v, double du, double dv, double off)
{
    const double p = u * rise - above * du, q = v * rise - above * dv, r = rise - p - q;
    const double least = p < q ? p < r ? p : r : q < r ? q : r, most = p > q ? p > r ? p : r : q > r ? q : r;
    const double below = -off - least, beyond = most - off, over = least - off, under = -off - most;
    const common_judged out = { below < beyond ? below : beyond, over > under ? over : under };

    return out;
}

static inline common_passing common_passing_of(common_judged of)
{
    return of.across > 0.0 ? COMMON_BESIDE : of.sure > 0.0 ? COMMON_THROUGH : COMMON_UNCLEAR;
}

/* Of one ray that comes near, and intersect_many() of the class. */
void common_heights_cross(const void *self, const pov_ray *ray, const common_entry *e, pov_hits *hits);
void common_heights_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);

#endif
