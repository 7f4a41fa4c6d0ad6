/* superellipsoid.h - the size of a point, which a superellipsoid is the points of size one of, and its value along a ray. */
#ifndef COMMON_SUPERELLIPSOID_H
#define COMMON_SUPERELLIPSOID_H

#include "common/clip.h"
#include "common/powers.h"
#include "common/simd.h"

typedef struct superellipsoid {
    double e, n;
    bool convex;
    bool approx;                  /* are approximate sizes of use? Large powers multiply their errors */
} superellipsoid;

/* What sizes may be off: computed as exactly as may be, and approximate ones. */
static const double FINE = 0x1p-50, APPROX = 0x1p-14;

/* ---- the size of a point ---- */

/* A power within 2^-22 of it, and 2^-24 y, for x from 0 to 3 and y that makes no number below 2^-1000 of it. */
COMMON_INLINE double approx_power(double x, double y)
{
    const uint64_t sqrt_half = 0x3fe6a09e667f3bcd, two = 0x4000000000000000;
    const uint64_t above = (elementary_bits(x) + (two - sqrt_half)) >> 52;   /* the exponent + 1024 */
    const double k = elementary_of_bits(above | 0x4330000000000000) - (0x1p52 + 1024.0);
    const double m = elementary_of_bits(elementary_bits(x) - ((above - 1024) << 52)), s = (m - 1.0) / (m + 1.0), z = s * s;
    const double log2 = k + s * (2.885390081777927 + z * (0.9617966939259757 + z * (0.5770780163555854 + z * 0.41219858311113244)));
    const double all = y * log2, held = all > -1000.0 ? all : -1000.0, n = elementary_round(held), r = held - n;

    return (1.0 + r * (0.6931471805599453 + r * (0.24022650695910072 + r * (0.05550410866482158 + r * (0.009618129107628477 +
            r * (0.0013333558146428443 + r * 0.00015403530393381608)))))) * elementary_power_of_two(n);
}

COMMON_INLINE double power_of(double x, double y, bool approx) { return approx ? approx_power(x, y) : common_power(x, y); }

/* (a^(2/e) + b^(2/e))^(e/2), and the share of a in the sum. */
COMMON_INLINE double norm_of(double a, double b, double e, bool approx, double *share)
{
    const double most = a > b ? a : b, least = a > b ? b : a, ratio = most > 0.0 ? least / most : 0.0;
    const double rest = ratio > 0x1p-1000 ? power_of(ratio, 2.0 / e, approx) : 0.0;

    *share = (a >= b ? 1.0 : rest) / (1.0 + rest);
    return rest > 0.0 ? most * power_of(1.0 + rest, 0.5 * e, approx) : most;
}

static inline double size_at(const superellipsoid *s, pov_vec3 p)
{
    double share;

    return norm_of(norm_of(fabs(p.x), fabs(p.y), s->e, false, &share), fabs(p.z), s->n, false, &share);
}

/* How a norm grows with one of its numbers: the share of it, over its part of the whole. */
COMMON_INLINE double growth(double share, double whole, double x) { return x != 0.0 ? share * whole / x : 0.0; }

COMMON_INLINE double size_and_slope(const superellipsoid *s, pov_vec3 p, bool approx, pov_vec3 *slope)
{
    double of_x, of_ring;
    const double ring = norm_of(fabs(p.x), fabs(p.y), s->e, approx, &of_x);
    const double size = norm_of(ring, fabs(p.z), s->n, approx, &of_ring), by_ring = growth(of_ring, size, ring);

    slope->x = by_ring * growth(of_x, ring, p.x);
    slope->y = by_ring * growth(1.0 - of_x, ring, p.y);
    slope->z = growth(1.0 - of_ring, size, p.z);
    return size;
}

/* ---- along a ray ---- */

typedef struct line {
    const superellipsoid *s;
    pov_vec3 o, d;
    double base;
    common_span span;            /* from the base */
} line;

COMMON_INLINE double value_along(const line *n, double t, bool approx, double *slope)
{
    pov_vec3 by;
    const double size = size_and_slope(n->s, pov_add(n->o, pov_scale(n->d, t)), approx, &by);

    *slope = pov_dot(by, n->d);
    return size - 1.0;
}

static inline double size_along(const line *n, double t, double *slope) { return value_along(n, t, false, slope); }
static inline double approx_along(const line *n, double t, double *slope) { return value_along(n, t, true, slope); }

static inline bool report(const line *n, const common_ray *k, double t, pov_hits *hits)
{
    const pov_two at = pov_two_sum(n->base, t);
    const pov_mark mark = { 0, 0, 0.0, 0.0 };

    return pov_cross(hits, at.hi * k->unit, at.lo * k->unit, mark);
}

/* The crossings of a shape that is not convex, from a distance on. */
void common_superellipsoid_star(const line *n, const common_ray *k, double from, pov_hits *hits);

#endif
