#include "light/light.h"

#include "base/simd.h"

#include <povtrace/exact.h>

/* Vector from a point to the light along one axis, rounded once: both ends are double-double, so that a light may be
 * near or far. A light without a low part takes fewer operations for the same bits. */
static inline double towards(double l, double l_lo, double p, double p_lo, bool low)
{
    pov_two dir;

    if (low)
        return pov_two_sub(pov_two_of(l, l_lo), pov_two_of(p, p_lo)).hi;
    dir = pov_two_sum(l, -p);
    return dir.hi + (dir.lo + (0.0 - p_lo));
}

static inline void aim_all(const light *restrict l, const vec_lanes *restrict point, const vec_lanes *restrict point_lo,
                           uint32_t n, vec_lanes *restrict dir, bool low)
{
    const pov_vec3 at = l->position, at_lo = l->position_lo;

    for (uint32_t i = 0; i < n; i++) {
        dir->x[i] = towards(at.x, at_lo.x, point->x[i], point_lo->x[i], low);
        dir->y[i] = towards(at.y, at_lo.y, point->y[i], point_lo->y[i], low);
        dir->z[i] = towards(at.z, at_lo.z, point->z[i], point_lo->z[i], low);
    }
}

SIMD_CLONES static void aim_plain(const light *restrict l, const vec_lanes *restrict point,
                                  const vec_lanes *restrict point_lo, uint32_t n, vec_lanes *restrict dir)
{
    aim_all(l, point, point_lo, n, dir, false);
}

SIMD_CLONES static void aim_low(const light *restrict l, const vec_lanes *restrict point,
                                const vec_lanes *restrict point_lo, uint32_t n, vec_lanes *restrict dir)
{
    aim_all(l, point, point_lo, n, dir, true);
}

static uint32_t samples(const light *l)
{
    (void)l;
    return 1;
}

static void sample(const light *l, uint32_t k, const light_points *at, light_lanes *out)
{
    const pov_vec3 lo = l->position_lo;
    const uint32_t whole = lanes_whole(at->n);

    (void)k;
    if (lo.x != 0.0 || lo.y != 0.0 || lo.z != 0.0)
        aim_low(l, at->point, at->point_lo, whole, &out->dir);
    else
        aim_plain(l, at->point, at->point_lo, whole, &out->dir);
    out->tmax = 1.0;
    out->uniform = true;
    out->color = l->color;
}

const light_class light_point = { samples, sample };
