/* ray_soa.h - rays as a structure of arrays, as filters need them. */
#ifndef BVH_RAY_SOA_H
#define BVH_RAY_SOA_H

#include "base/simd.h"

#include <povtrace/shape_fast.h>

static inline uint32_t ray_soa_excluded(const pov_ray *ray)
{
    return ray->origin_mark.flags & POV_MARK_OUTWARD ? ray->origin_surface : POV_NO_OWNER;
}

/* Store four rays, from lane i on. */
static inline void ray_soa_put_four(pov_rays *s, uint32_t i, const pov_ray *const rays[4])
{
    const void *const from[4] = { rays[0], rays[1], rays[2], rays[3] };
    double other[3][4];
    uint32_t j;

    simd_transpose(from, offsetof(pov_ray, org), s->org[0] + i, s->org[1] + i, s->org[2] + i, s->org_lo[0] + i);
    simd_transpose(from, offsetof(pov_ray, org_lo.y), s->org_lo[1] + i, s->org_lo[2] + i, s->dir[0] + i, s->dir[1] + i);
    simd_transpose(from, offsetof(pov_ray, dir.z), s->dir[2] + i, other[0], other[1], other[2]);
    for (j = 0; j < 4; j++)
        s->excluded[i + j] = ray_soa_excluded(rays[j]);
}

/* -1 or 0, as wide as a double: loops over lanes vectorise best with it. */
static inline int64_t ray_soa_is_in(double x, double least, double most)
{
    const double size = fabs(x);

    return ((size <= most) & ((size >= least) | (size == 0.0))) ? -1 : 0;
}

/* Is a lane's ray in the range that filters are promised? -1 or 0. */
static inline int64_t ray_soa_is_promised(const pov_rays *restrict s, uint32_t i)
{
    const double x = s->dir[0][i], y = s->dir[1][i], z = s->dir[2][i];

    return ray_soa_is_in(x, 1e-80, 1e80) & ray_soa_is_in(y, 1e-80, 1e80) & ray_soa_is_in(z, 1e-80, 1e80) &
           (s->size[i] <= 1e100 ? -1 : 0) & (x * x + y * y + z * z > 0.0 ? -1 : 0);
}

static inline double ray_soa_lesser(double a, double b) { return a < b ? a : b; }

/* Compute the derived members of a lane, and the length of its direction. Returns -1 for most of the rays that are in the
 * range that filters are promised: those without a component of zero, which take fewer comparisons. */
static inline int64_t ray_soa_derive(pov_rays *restrict s, uint32_t i, double tmax, double *restrict length)
{
    const double x = s->dir[0][i], y = s->dir[1][i], z = s->dir[2][i], square = x * x + y * y + z * z;

    s->inverse[i] = 1.0 / square;
    s->per_length[i] = sqrt(s->inverse[i]);
    length[i] = square * s->per_length[i];
    s->size[i] = fabs(s->org[0][i]) + fabs(s->org[1][i]) + fabs(s->org[2][i]);
    s->tmax[i] = tmax;
    return ((ray_soa_lesser(ray_soa_lesser(fabs(x), fabs(y)), fabs(z)) >= 1e-80) & (square <= 1e160) & (s->size[i] <= 1e100)) ? -1 : 0;
}

#endif
