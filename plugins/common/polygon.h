/* polygon.h - a planar polygon, and computations shared by one ray and many. */
#ifndef COMMON_POLYGON_H
#define COMMON_POLYGON_H

#include "common/planar_block.h"
#include "common/report.h"

typedef struct common_corner {
    pov_vec3 world;        /* as written */
    pov_vec3 local;        /* relative to the anchor, scaled, rounded */
    bool starts;           /* the first corner of a loop; no edge leads to it */
} common_corner;

enum { COMMON_POLYGON_SIDES = 5 };

/* Members that rays need come first; a small polygon has no others. */
typedef struct common_polygon {
    pov_two3 anchor, normal;   /* the plane; the normal's largest component is in [1, 2), or it is zero */
    double scale;
    pov_vec3 near[COMMON_POLYGON_SIDES + 1];   /* small: the corners as in `local`, the last one repeated */
    uint32_t count;
    bool small;                /* one loop of three to five corners, then the first of them again */
    const common_corner *corners; /* not small: each loop ends with its first corner again */
    pov_vec3 unit;
    pov_box box;
    pov_vec3 world[COMMON_POLYGON_SIDES + 1];   /* small: the corners as written */
} common_polygon;

/* A ray that leaves a plane, to either side, never hits it again. */
#define COMMON_POLYGON_MARK POV_MARK_OUTWARD

/* The distance to the plane: a first quotient, and its correction. */
COMMON_INLINE common_root common_polygon_distance(pov_vec3 n, const common_ray *k, double slope, double slope_error,
                                                  double first,
                                   pov_vec3 w)
{
    const double rest = -pov_dot(n, w) / slope,
        off = 7.0 * COMMON_U * common_sum_of_sizes(n, w) + fabs(rest) * slope_error;
    const double error = off / fabs(slope) + COMMON_U * fabs(rest);
    const int sound = (int)(fabs(slope) > 1024.0 * slope_error) & (int)(pov_largest(pov_two3_hi(k->f)) < COMMON_FAR);
    common_root root;

    root.t = pov_two_sum(first, rest);
    root.error = sound ? error : HUGE_VAL;
    root.feature = root.flags = 0;
    return root;
}

/* Small polygons in lanes, and larger ones, several rays of each; what is undecided by `one`. */
void common_polygon_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                   uint32_t n, void (*one)(const void *self, const pov_ray *ray, pov_hits *hits));
/* Any polygons, for definite hits. */
void common_polygon_cross_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n,
                               void (*one)(const void *self, const pov_ray *ray, pov_hits *hits));

#endif
