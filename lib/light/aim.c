#include "light/aim.h"

#include "base/elementary.h"
#include "base/simd.h"

#include <povtrace/exact.h>

/* ---- directions ---- */

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

static inline void aim_all(const light_origin *restrict l, const vec_lanes *restrict point,
                           const vec_lanes *restrict point_lo, uint32_t n, vec_lanes *restrict dir, bool low)
{
    const pov_vec3 at = l->from, at_lo = l->from_lo;

    for (uint32_t i = 0; i < n; i++) {
        dir->x[i] = towards(at.x, at_lo.x, point->x[i], point_lo->x[i], low);
        dir->y[i] = towards(at.y, at_lo.y, point->y[i], point_lo->y[i], low);
        dir->z[i] = towards(at.z, at_lo.z, point->z[i], point_lo->z[i], low);
    }
}

SIMD_CLONES static void aim_plain(const light_origin *restrict l, const vec_lanes *restrict point,
                                  const vec_lanes *restrict point_lo, uint32_t n, vec_lanes *restrict dir)
{
    aim_all(l, point, point_lo, n, dir, false);
}

SIMD_CLONES static void aim_low(const light_origin *restrict l, const vec_lanes *restrict point,
                                const vec_lanes *restrict point_lo, uint32_t n, vec_lanes *restrict dir)
{
    aim_all(l, point, point_lo, n, dir, true);
}

void light_aim(const light_origin *from, const light_points *at, vec_lanes *dir)
{
    const pov_vec3 lo = from->from_lo;

    if (lo.x != 0.0 || lo.y != 0.0 || lo.z != 0.0)
        aim_low(from, at->point, at->point_lo, lanes_whole(at->n), dir);
    else
        aim_plain(from, at->point, at->point_lo, lanes_whole(at->n), dir);
}

SIMD_CLONES static void aim_axis(const double *restrict from, const double *restrict from_lo, const double *restrict point,
                                 const double *restrict point_lo, uint32_t n, double *restrict dir)
{
    for (uint32_t i = 0; i < n; i++)
        dir[i] = towards(from[i], from_lo[i], point[i], point_lo[i], true);
}

void light_aim_each(const vec_lanes *from, const vec_lanes *from_lo, const light_points *at, vec_lanes *dir)
{
    const uint32_t n = lanes_whole(at->n);

    aim_axis(from->x, from_lo->x, at->point->x, at->point_lo->x, n, dir->x);
    aim_axis(from->y, from_lo->y, at->point->y, at->point_lo->y, n, dir->y);
    aim_axis(from->z, from_lo->z, at->point->z, at->point_lo->z, n, dir->z);
}

void light_aim_parallel(const light *l, const light_origin *from, const light_points *at, vec_lanes *dir, double *distance)
{
    const double hardly = 0x1p-100;

    light_aim(from, at, dir);
    for (uint32_t i = 0; i < lanes_whole(at->n); i++) {
        const double d = -pov_dot(lanes_at(dir, i), l->axis);

        distance[i] = d;
        lanes_put(dir, i, pov_scale(l->axis, d > hardly ? -d : -hardly));
    }
}

/* ---- colours ---- */

/* How far light goes, to the power. Whole powers that many lights have are products, which are as near or nearer. */
enum { FADES_NOT, FADES_LINEARLY, FADES_BY_SQUARE, FADES_BY_POWER };

static inline double course_of(const light *l, double distance, int fades)
{
    const double x = fabs(distance) / l->fade_distance;

    if (fades == FADES_BY_POWER)
        return elementary_pow(x, l->fade_power);
    return fades == FADES_BY_SQUARE ? x * x : x;
}

/* Compiled for each kind. */
static inline void dim(const light *restrict l, const double *restrict factor, const double *restrict distance, uint32_t n, light_lanes *restrict out,
                       int fades)
{
    for (uint32_t i = 0; i < n; i++) {
        const float by = (float)(fades ? factor[i] * 2.0 / (1.0 + course_of(l, distance[i], fades)) : factor[i]);

        out->red[i] = l->color.r * by;
        out->green[i] = l->color.g * by;
        out->blue[i] = l->color.b * by;
    }
}

SIMD_CLONES static void dim_plain(const light *restrict l, const double *restrict factor, const double *restrict distance,
                                  uint32_t n, light_lanes *restrict out)
{
    dim(l, factor, distance, n, out, FADES_NOT);
}

SIMD_CLONES static void dim_linearly(const light *restrict l, const double *restrict factor, const double *restrict distance,
                                     uint32_t n, light_lanes *restrict out)
{
    dim(l, factor, distance, n, out, FADES_LINEARLY);
}

SIMD_CLONES static void dim_by_square(const light *restrict l, const double *restrict factor, const double *restrict distance,
                                      uint32_t n, light_lanes *restrict out)
{
    dim(l, factor, distance, n, out, FADES_BY_SQUARE);
}

SIMD_CLONES static void dim_by_power(const light *restrict l, const double *restrict factor, const double *restrict distance,
                                     uint32_t n, light_lanes *restrict out)
{
    dim(l, factor, distance, n, out, FADES_BY_POWER);
}

void light_dim(const light *l, const double *factor, const double *distance, uint32_t n, light_lanes *out)
{
    out->uniform = false;
    out->color = l->color;
    if (!light_fades(l))
        dim_plain(l, factor, distance, lanes_whole(n), out);
    else if (l->fade_power == 1.0)
        dim_linearly(l, factor, distance, lanes_whole(n), out);
    else if (l->fade_power == 2.0)
        dim_by_square(l, factor, distance, lanes_whole(n), out);
    else
        dim_by_power(l, factor, distance, lanes_whole(n), out);
}

SIMD_CLONES static void find_lengths(const vec_lanes *restrict dir, uint32_t n, double *restrict length)
{
    for (uint32_t i = 0; i < n; i++)
        length[i] = light_length(lanes_at(dir, i));
}

void light_lengths(const vec_lanes *dir, uint32_t n, double *length) { find_lengths(dir, lanes_whole(n), length); }
