/* local.h - a ray in a shape's local space: moved by the shape's anchor, and scaled so that shape and direction are of
 * the order of one. The scales are powers of two. So only the sum of the low parts is rounded, squares neither overflow
 * nor underflow, and a scene scaled by a power of two gives the same bits. */
#ifndef COMMON_LOCAL_H
#define COMMON_LOCAL_H

#include <povtrace/exact.h>
#include <povtrace/shape_fast.h>

#include <string.h>

/* A function that is called in loops over lanes: it must be inlined, or the loop is not vectorised. */
#if defined(__GNUC__)
#define COMMON_INLINE __attribute__((always_inline)) static inline
#else
#define COMMON_INLINE static inline
#endif

/* Before a loop of up to eight turns whose number is known where it is inlined. */
#if defined(__GNUC__) && !defined(__clang__)
#define COMMON_UNROLLED _Pragma("GCC unroll 8")
#else
#define COMMON_UNROLLED
#endif

/* Does a host ask a class for the fast extension that this code has? */
static inline bool common_is_fast(const char *name) { return strcmp(name, POV_SHAPE_FAST) == 0; }

/* Half a unit in the last place of one: the relative error of a rounding. */
#define COMMON_U 0x1p-53
/* For origins further away than this many sizes of the shape, re-centring to one double is no longer far more accurate
 * than a rounding (2^-102 of the distance against 2^-53 of the size), and double-double is used. */
#define COMMON_FAR 0x1p44

/* Second-order coefficients below this, for shapes and directions of the order of one, come from products that may have
 * underflowed, which error bounds do not cover. */
#define COMMON_TINY 0x1p-600

/* A direction's largest component is below 2, so it is shorter than sqrt(12) = 1 / 0.288: a point is accurate to a
 * given length if the distance along the ray is accurate to this fraction of it. */
#define COMMON_SLOWEST 0.28

typedef struct common_ray {
    pov_two3 f;            /* from the anchor to the origin */
    pov_vec3 d, d_lo;      /* the largest component of d is in [1, 2) */
    double unit, per_unit; /* a local distance times unit is a distance along the ray, and conversely */
} common_ray;

/* Inverse of a power of two in the range of pov_inverse_power(): a division takes ten times as long. */
static inline double common_inverse(double power)
{
    uint64_t bits;

    memcpy(&bits, &power, sizeof bits);
    bits = ((uint64_t)2046 << 52) - bits;
    memcpy(&power, &bits, sizeof power);
    return power;
}

static inline common_ray common_enter(const pov_ray *ray, pov_two3 anchor, double scale)
{
    double power = pov_inverse_power(pov_largest(ray->dir));
    common_ray k;

    k.f.x = pov_two_scale(pov_two_offset(ray->org.x, ray->org_lo.x, anchor.x), scale);
    k.f.y = pov_two_scale(pov_two_offset(ray->org.y, ray->org_lo.y, anchor.y), scale);
    k.f.z = pov_two_scale(pov_two_offset(ray->org.z, ray->org_lo.z, anchor.z), scale);
    k.d = pov_scale(ray->dir, power);
    k.d_lo = pov_scale(ray->dir_lo, power);
    k.unit = power * common_inverse(scale);
    k.per_unit = scale * common_inverse(power);
    return k;
}

static inline pov_vec3 common_along(const common_ray *k, double t)
{
    return pov_vec3_of(pov_along(k->f.x, t, k->d.x, k->d_lo.x), pov_along(k->f.y, t, k->d.y, k->d_lo.y),
                       pov_along(k->f.z, t, k->d.z, k->d_lo.z));
}

/* Re-centring loses 10 u^2 of the distance besides the rounding of each component: equivalent to components larger by
 * this much. */
static inline double common_far_slack(const common_ray *k) { return 10.0 * COMMON_U * pov_largest(pov_two3_hi(k->f)); }

COMMON_INLINE pov_two3 common_along_two(const common_ray *k, double t)
{
    pov_two3 w;

    w.x = pov_two_along(k->f.x, t, k->d.x, k->d_lo.x);
    w.y = pov_two_along(k->f.y, t, k->d.y, k->d_lo.y);
    w.z = pov_two_along(k->f.z, t, k->d.z, k->d_lo.z);
    return w;
}

COMMON_INLINE pov_two3 common_along_dd(const common_ray *k, pov_two t)
{
    pov_two3 w = common_along_two(k, t.hi);

    w.x = pov_two_add(w.x, pov_two_product(t.lo, k->d.x));
    w.y = pov_two_add(w.y, pov_two_product(t.lo, k->d.y));
    w.z = pov_two_add(w.z, pov_two_product(t.lo, k->d.z));
    return w;
}

/* The point of a crossing, relative to the anchor. */
static inline pov_two3 common_point(const common_ray *k, const pov_crossing *at)
{
    return common_along_dd(k, pov_two_of(at->t * k->per_unit, at->t_lo * k->per_unit));
}

/* point + point_lo - anchor, scaled. */
static inline pov_two3 common_offset(pov_vec3 point, pov_vec3 point_lo, pov_two3 anchor, double scale)
{
    pov_two3 w;

    w.x = pov_two_scale(pov_two_offset(point.x, point_lo.x, anchor.x), scale);
    w.y = pov_two_scale(pov_two_offset(point.y, point_lo.y, anchor.y), scale);
    w.z = pov_two_scale(pov_two_offset(point.z, point_lo.z, anchor.z), scale);
    return w;
}

static inline pov_two3 common_direction(const common_ray *k) { return pov_two3_of(k->d, k->d_lo); }

static inline double common_sum_of_sizes(pov_vec3 a, pov_vec3 b)
{
    return fabs(a.x * b.x) + fabs(a.y * b.y) + fabs(a.z * b.z);
}

/* a . b with exact products and sums of high parts, and a double sum of all small terms. That sum is below 5 u of the
 * sum of the terms' sizes, so its six roundings lose less than 2^-100 of the latter. */
static inline pov_two common_fast_dot(pov_two3 a, pov_two3 b)
{
    const pov_two x = pov_two_product(a.x.hi, b.x.hi), y = pov_two_product(a.y.hi, b.y.hi);
    const pov_two z = pov_two_product(a.z.hi, b.z.hi), xy = pov_two_sum(x.hi, y.hi), all = pov_two_sum(xy.hi, z.hi);
    const double low = (x.lo + y.lo) + (z.lo + xy.lo) + all.lo;
    const double mixed = (a.x.hi * b.x.lo + a.x.lo * b.x.hi) + (a.y.hi * b.y.lo + a.y.lo * b.y.hi)
                         + (a.z.hi * b.z.lo + a.z.lo * b.z.hi);

    return pov_two_sum(all.hi, low + mixed);
}

/* A bound moved outward by more than the few roundings that made it. */
static inline double common_below(double x) { return -pov_next(4.0 * COMMON_U * fabs(x) - x); }
static inline double common_above(double x) { return pov_next(x + 4.0 * COMMON_U * fabs(x)); }

#endif
