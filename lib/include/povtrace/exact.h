/* povtrace/exact.h - double-double numbers. Header only, for plugins and library alike.
 *
 * A double-double number is the unevaluated sum hi + lo of doubles with |lo| <= ulp(hi)/2, about 106 bits. The
 * error-free transformations are Knuth's TwoSum, Dekker's FastTwoSum and Veltkamp's and Dekker's TwoProduct. The
 * arithmetic and its bounds are those of Joldes, Muller and Popescu, "Tight and rigorous error bounds for basic
 * building blocks of double-word arithmetic" (ACM TOMS 44, 2017). Compile with -ffp-contract=off and without
 * -ffast-math: both destroy what these functions are for. Neither overflow nor underflow is caught here; TwoProduct is
 * exact for products within 1e-290 .. 1e300. */
#ifndef POVTRACE_EXACT_H
#define POVTRACE_EXACT_H

#include <povtrace/math.h>

#include <stdint.h>
#include <string.h>

typedef struct pov_two { double hi, lo; } pov_two;
typedef struct pov_two3 { pov_two x, y, z; } pov_two3;

static inline pov_two pov_two_of(double hi, double lo) { pov_two r; r.hi = hi; r.lo = lo; return r; }

/* a + b exactly; needs |a| >= |b| or a == 0. */
static inline pov_two pov_fast_two_sum(double a, double b)
{
    double s = a + b;
    return pov_two_of(s, b - (s - a));
}

/* a + b exactly. */
static inline pov_two pov_two_sum(double a, double b)
{
    double s = a + b, bb = s - a;
    return pov_two_of(s, (a - (s - bb)) + (b - bb));
}

/* a * b exactly. A hardware fma gives the same two doubles as the splitting does. */
static inline pov_two pov_two_product(double a, double b)
{
    double p = a * b;
#if defined(__FMA__) || defined(__aarch64__)
    return pov_two_of(p, fma(a, b, -p));
#else
    double t = 134217729.0 * a, ah = t - (t - a), al = a - ah, bh, bl;
    t = 134217729.0 * b;
    bh = t - (t - b);
    bl = b - bh;
    return pov_two_of(p, ((ah * bh - p) + ah * bl + al * bh) + al * bl);
#endif
}

/* a / by, bit for bit, from inverse = 1 / by, so that several quotients take one division. by > 0, and a is 0 or neither near the
 * range's ends nor by: see pov_is_moderate(). Two steps towards the quotient; as 1 / by is rounded to nearest, the last one rounds as a
 * division does (Markstein, IBM Journal of Research and Development 34, 1990), but for the sign of 0. */
static inline double pov_quotient(double a, double by, double inverse)
{
#if defined(__FMA__) || defined(__aarch64__)
    const double first = a * inverse, second = fma(fma(-first, by, a), inverse, first);

    return copysign(fma(fma(-second, by, a), inverse, second), a);
#else
    (void)inverse;
    return a / by;
#endif
}

/* Has pov_quotient() these bits for a? by is from 1e-120 to 1e120. */
static inline int pov_is_moderate(double a)
{
#if defined(__FMA__) || defined(__aarch64__)
    return (a == 0.0) | ((fabs(a) > 1e-150) & (fabs(a) < 1e150));
#else
    (void)a;
    return 1;
#endif
}

static inline pov_two pov_two_neg(pov_two a) { return pov_two_of(-a.hi, -a.lo); }

/* Relative error at most 3 u^2 (u = 2^-53). */
static inline pov_two pov_two_add(pov_two a, pov_two b)
{
    pov_two s = pov_two_sum(a.hi, b.hi), t = pov_two_sum(a.lo, b.lo);

    s = pov_fast_two_sum(s.hi, s.lo + t.hi);
    return pov_fast_two_sum(s.hi, s.lo + t.lo);
}

static inline pov_two pov_two_sub(pov_two a, pov_two b) { return pov_two_add(a, pov_two_neg(b)); }

/* Relative error at most 2 u^2. */
static inline pov_two pov_two_add_double(pov_two a, double b)
{
    pov_two s = pov_two_sum(a.hi, b);
    return pov_fast_two_sum(s.hi, a.lo + s.lo);
}

/* Relative error at most 7 u^2. */
static inline pov_two pov_two_mul(pov_two a, pov_two b)
{
    pov_two p = pov_two_product(a.hi, b.hi);
    return pov_fast_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/* Relative error at most 3 u^2. */
static inline pov_two pov_two_mul_double(pov_two a, double b)
{
    pov_two p = pov_two_product(a.hi, b);
    return pov_fast_two_sum(p.hi, p.lo + a.lo * b);
}

/* Relative error at most 15 u^2. */
static inline pov_two pov_two_div(pov_two a, pov_two b)
{
    double q = a.hi / b.hi;
    pov_two r = pov_two_sub(a, pov_two_mul_double(b, q));

    return pov_fast_two_sum(q, r.hi / b.hi);
}

/* The root of a negative number is zero. Relative error below 4 u^2. */
static inline pov_two pov_two_sqrt(pov_two a)
{
    double s;

    if (!(a.hi > 0.0))
        return pov_two_of(0.0, 0.0);
    s = sqrt(a.hi);
    return pov_fast_two_sum(s, pov_two_sub(a, pov_two_product(s, s)).hi / (2.0 * s));
}

static inline bool pov_two_less(pov_two a, pov_two b) { return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo); }

static inline pov_two3 pov_two3_of(pov_vec3 hi, pov_vec3 lo)
{
    pov_two3 r;
    r.x = pov_two_of(hi.x, lo.x);
    r.y = pov_two_of(hi.y, lo.y);
    r.z = pov_two_of(hi.z, lo.z);
    return r;
}

static inline pov_two pov_two3_dot(pov_two3 a, pov_two3 b)
{
    return pov_two_add(pov_two_add(pov_two_mul(a.x, b.x), pov_two_mul(a.y, b.y)), pov_two_mul(a.z, b.z));
}

static inline pov_two3 pov_two3_cross(pov_two3 a, pov_two3 b)
{
    pov_two3 r;
    r.x = pov_two_sub(pov_two_mul(a.y, b.z), pov_two_mul(a.z, b.y));
    r.y = pov_two_sub(pov_two_mul(a.z, b.x), pov_two_mul(a.x, b.z));
    r.z = pov_two_sub(pov_two_mul(a.x, b.y), pov_two_mul(a.y, b.x));
    return r;
}

/* Re-centring of one coordinate: (o + o_lo - anchor) + t d in double-double. The error is of the order u^2 of the
 * terms, so that the result near the anchor is accurate however far the ray starts. */
static inline pov_two pov_recentre(double o, double o_lo, double anchor, double t, double d)
{
    pov_two f = pov_two_add_double(pov_two_sum(o, -anchor), o_lo);
    return pov_two_add(f, pov_two_product(t, d));
}

/* Offset from the anchor: o + o_lo - anchor. Exact except for the sum of the low parts. */
static inline pov_two pov_two_offset(double o, double o_lo, pov_two anchor)
{
    pov_two s = pov_two_sum(o, -anchor.hi);
    return pov_two_sum(s.hi, s.lo + (o_lo - anchor.lo));
}

/* f + t (d + d_lo) in double-double, d_lo being the low part of d. */
static inline pov_two pov_two_along(pov_two f, double t, double d, double d_lo)
{
    pov_two p = pov_two_product(t, d);
    return pov_two_add(f, pov_fast_two_sum(p.hi, p.lo + t * d_lo));
}

/* The same, rounded once: within 2^-53 of the result and 2^-102 of |f|. */
static inline double pov_along(pov_two f, double t, double d, double d_lo)
{
    pov_two p = pov_two_product(t, d), s = pov_two_sum(f.hi, p.hi);
    return s.hi + (s.lo + (f.lo + (p.lo + t * d_lo)));
}

/* The power of two that scales x into [1, 2); for zero and denormals the largest power of two. The sign of x is
 * ignored. Multiplying by it is exact. */
static inline double pov_inverse_power(double x)
{
    uint64_t bits, exponent;

    memcpy(&bits, &x, sizeof bits);
    exponent = (bits >> 52) & 0x7ff;
    exponent = exponent < 1 ? 1 : exponent > 2045 ? 2045 : exponent;
    bits = (2046 - exponent) << 52;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* The next double above x, as nextafter() has it, which is a call; the next below is -pov_next(-x). */
static inline double pov_next(double x)
{
    uint64_t bits;

    if (!(x < HUGE_VAL))
        return x;
    x += 0.0;   /* of two zeros the positive one */
    memcpy(&bits, &x, sizeof bits);
    bits += x >= 0.0 ? 1 : UINT64_MAX;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline pov_two pov_two_scale(pov_two a, double power_of_two)
{
    return pov_two_of(a.hi * power_of_two, a.lo * power_of_two);
}

static inline pov_vec3 pov_two3_hi(pov_two3 a) { return pov_vec3_of(a.x.hi, a.y.hi, a.z.hi); }
static inline pov_vec3 pov_two3_lo(pov_two3 a) { return pov_vec3_of(a.x.lo, a.y.lo, a.z.lo); }

#endif
