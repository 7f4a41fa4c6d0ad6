/* elementary.h - exponentials, logarithms, powers and angles in double. They are made of sums, products, quotients and
 * bits only, so they have the same bits on every machine, for one number and in a loop over lanes. Errors are below two
 * units in the last place. */
#ifndef BASE_ELEMENTARY_H
#define BASE_ELEMENTARY_H

#include "base/simd.h"

#include <povtrace/exact.h>

#include <math.h>

/* ---- bits ---- */

SIMD_INLINE uint64_t elementary_bits(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits;
}

SIMD_INLINE double elementary_of_bits(uint64_t bits)
{
    double x;

    memcpy(&x, &bits, sizeof x);
    return x;
}

/* The upper 26 bits: products of two of these are exact. */
SIMD_INLINE double elementary_upper(double x) { return elementary_of_bits(elementary_bits(x) & ~(uint64_t)0x7ffffff); }

/* The nearest whole number, for |x| < 2^51. */
SIMD_INLINE double elementary_round(double x) { return (x + 0x1.8p52) - 0x1.8p52; }

/* 2^n for whole n from -1022 to 1023: the sum has n + 1023 in its lowest bits. */
SIMD_INLINE double elementary_power_of_two(double n) { return elementary_of_bits(elementary_bits(n + (0x1p52 + 1023.0)) << 52); }

/* ---- logarithms ---- */

/* hi + lo, lo below half a unit of hi's last place. */
typedef struct elementary_sum { double hi, lo; } elementary_sum;

/* log2 of a normal number: k + log2(m) with m from sqrt(1/2) to sqrt(2), and log(m) = 2 atanh(s), s = (m-1)/(m+1). */
SIMD_INLINE elementary_sum elementary_log2_sum(double x)
{
    const uint64_t sqrt_half = 0x3fe6a09e667f3bcd, two = 0x4000000000000000;
    const uint64_t above = (elementary_bits(x) + (two - sqrt_half)) >> 52;   /* k + 1024 */
    const double k = elementary_of_bits(above | 0x4330000000000000) - (0x1p52 + 1024.0);
    const double m = elementary_of_bits(elementary_bits(x) - ((above - 1024) << 52)), f = m - 1.0, d = m + 1.0;
    const double d_lo = m > 1.0 ? 1.0 - (d - m) : m - (d - 1.0), d_upper = elementary_upper(d);
    const double s = elementary_upper(f / d);
    const double s_lo = (((f - s * d_upper) - s * (d - d_upper)) - s * d_lo) / d, all = s + s_lo, z = all * all;
    const double odd = 0x1.5555555555555p-2 + z * (0x1.9999999999a38p-3 + z * (0x1.2492492476c87p-3 + z * (0x1.c71c720160b47p-4 +
                       z * (0x1.745cf901605f7p-4 + z * (0x1.3b1c360763b8ap-4 + z * (0x1.0fbe83c2cbcf3p-4 + z * 0x1.0c04595972ab8p-4))))));
    const double upper = 0x1.715476p+1, lower = 0x1.4ae0bf85ddf44p-25;   /* 2 / log(2) */
    const double hi = s * upper, lo = s * lower + (s_lo + all * z * odd) * (upper + lower);
    const double sum = k + hi, rest = (hi - (sum - k)) + lo;
    elementary_sum out;

    out.hi = sum + rest;
    out.lo = rest - (out.hi - sum);
    return out;
}

/* Numbers below the normal ones are scaled up first; `shift` is the logarithm of that. */
SIMD_INLINE double elementary_normal(double x, double *shift)
{
    const int small = x < 0x1p-1022;

    *shift = small ? -54.0 : 0.0;
    return small ? x * 0x1p54 : x;
}

/* What a logarithm is where the formula does not hold. */
SIMD_INLINE double elementary_log_edges(double x, double log)
{
    const double ends = x == 0.0 ? -HUGE_VAL : x < HUGE_VAL ? log : HUGE_VAL;

    return x >= 0.0 ? ends : (double)NAN;
}

SIMD_INLINE double elementary_log2(double x)
{
    double shift;
    const elementary_sum l = elementary_log2_sum(elementary_normal(x, &shift));

    return elementary_log_edges(x, (l.hi + shift) + l.lo);
}

SIMD_INLINE double elementary_log(double x)
{
    const double upper = 0x1.62e42f8p-1, lower = 0x1.be8e7bcd5e4f2p-27;   /* log(2) */
    double shift, hi, rest;
    const elementary_sum l = elementary_log2_sum(elementary_normal(x, &shift));

    hi = elementary_upper(l.hi + shift);
    rest = ((l.hi + shift) - hi) + l.lo;
    return elementary_log_edges(x, hi * upper + (hi * lower + rest * (upper + lower)));
}

/* ---- exponentials ---- */

/* 2^(hi + lo), lo much smaller than hi. */
SIMD_INLINE double elementary_exp2_sum(double hi, double lo)
{
    const double high = hi < 1100.0 ? hi : 1100.0, held = high > -1200.0 ? high : -1200.0;
    const double n = elementary_round(held), r = (held - n) + (held == hi ? lo : 0.0), half = elementary_round(0.5 * n);
    const double q = 0x1.62e42fefa39efp-1 + r * (0x1.ebfbdff82c58fp-3 + r * (0x1.c6b08d704a0c7p-5 + r * (0x1.3b2ab6fba4e79p-7 +
                     r * (0x1.5d87fe78a3e53p-10 + r * (0x1.430912f86b758p-13 + r * (0x1.ffcbfc6e29fe3p-17 +
                     r * (0x1.62c02242ec602p-20 + r * (0x1.b524ea8189e6fp-24 + r * (0x1.e4cf0fd4e7081p-28 +
                     r * (0x1.e9ee7233d69dep-32 + r * 0x1.c4a469e32e6cbp-36))))))))));

    return (1.0 + r * q) * elementary_power_of_two(half) * elementary_power_of_two(n - half);
}

SIMD_INLINE double elementary_exp2(double x) { return x == x ? elementary_exp2_sum(x, 0.0) : x; }

SIMD_INLINE double elementary_exp(double x)
{
    const double upper = 0x1.715476p+0, lower = 0x1.4ae0bf85ddf44p-26;   /* 1 / log(2) */
    const double high = x < 800.0 ? x : 800.0, held = high > -800.0 ? high : -800.0, hi = elementary_upper(held);

    return x == x ? elementary_exp2_sum(hi * upper, hi * lower + (held - hi) * (upper + lower)) : x;
}

/* The logarithm of x^y by 2, and what 2^ it is; loops over lanes take one after the other, see powers.h. */
SIMD_INLINE elementary_sum elementary_pow_log(double x, double y)
{
    double shift;
    const elementary_sum l = elementary_log2_sum(elementary_normal(x, &shift));
    const double hi = elementary_upper(l.hi + shift), lo = ((l.hi + shift) - hi) + l.lo, y_upper = elementary_upper(y);
    const elementary_sum out = { y_upper * hi, (y - y_upper) * hi + y * lo };

    return out;
}

SIMD_INLINE double elementary_pow_of(elementary_sum log, double x, double y)
{
    double power = elementary_exp2_sum(log.hi, log.lo);
    const double zero = y > 0.0 ? 0.0 : HUGE_VAL;

    power = x == 0.0 ? zero : power;
    power = x == HUGE_VAL ? (y > 0.0 ? HUGE_VAL : 0.0) : power;
    power = y == 0.0 ? 1.0 : power;
    return x >= 0.0 && y == y ? power : (double)NAN;
}

/* x^y, x >= 0; 0^0 is 1. */
SIMD_INLINE double elementary_pow(double x, double y) { return elementary_pow_of(elementary_pow_log(x, y), x, y); }

/* ---- angles ---- */

/* Sine of x in radians, plus `quarters` quarter turns. The remainder of a quarter turn is exact but for one rounding
 * where |x| < 10^6; up to 10^9 the error is below 2^-40. Larger ones give NaN. */
SIMD_INLINE double elementary_turned_sin(double x, double quarters)
{
    const double n = elementary_round(x * 0x1.45f306dc9c883p-1), turns = n + quarters;
    const double r = ((x - n * 0x1.921fb54p+0) - n * 0x1.10b46118p-30) - n * 0x1.313198a2e0370p-61, z = r * r;
    const double sine = r + r * z * (-0x1.5555555555555p-3 + z * (0x1.1111111111110p-7 + z * (-0x1.a01a01a019926p-13 +
                        z * (0x1.71de3a545e700p-19 + z * (-0x1.ae64540f0ba18p-26 + z * (0x1.61217c1864fa1p-33 - z * 0x1.ab161757f0c63p-41))))));
    const double cosine = (1.0 - 0.5 * z) + z * z * (0x1.5555555555555p-5 + z * (-0x1.6c16c16c16c16p-10 + z * (0x1.a01a01a019d02p-16 +
                          z * (-0x1.27e4fb7711e1dp-22 + z * (0x1.1eed8de9ef73ep-29 + z * (-0x1.9394b76d1f265p-37 + z * 0x1.ab76cf6e9b365p-45))))));
    const double quarter = turns - 4.0 * floor(0.25 * turns);
    const double half_wave = quarter == 1.0 || quarter == 3.0 ? cosine : sine;

    return fabs(x) <= 1e9 ? (quarter >= 2.0 ? -half_wave : half_wave) : (double)NAN;
}

SIMD_INLINE double elementary_sin(double x) { return elementary_turned_sin(x, 0.0); }
SIMD_INLINE double elementary_cos(double x) { return elementary_turned_sin(x, 1.0); }

/* The angle of y/x, both >= 0 and not both 0: from 0 to a quarter turn. */
SIMD_INLINE double elementary_first_quarter(double y, double x)
{
    const double quarter = 0x1.921fb54442d18p+0, quarter_lo = 0x1.1a62633145c07p-54, diagonal = 0.5 * quarter;
    const double least = y < x ? y : x, largest = y < x ? x : y, t = least / largest;
    const int steep = t > 0.41421356237309503;
    const double u = steep ? (least - largest) / (least + largest) : t, z = u * u;
    const double angle = u + u * z * (-0x1.5555555555555p-2 + z * (0x1.999999999933dp-3 + z * (-0x1.24924924355d5p-3 + z * (0x1.c71c7184c32bfp-4 +
                         z * (-0x1.745d0b153ffadp-4 + z * (0x1.3b126143b5cbcp-4 + z * (-0x1.10fa5ee9ab25cp-4 + z * (0x1.dfe49b2919c4ep-5 +
                         z * (-0x1.a090d1950d2b4p-5 + z * (0x1.41495cefb6c73p-5 - z * 0x1.39f38ad451ea6p-6))))))))));
    const double below = steep ? diagonal + (angle + 0.5 * quarter_lo) : angle;

    return y < x ? below : quarter - (below - quarter_lo);
}

/* As atan2() of libm; the angle of (0, 0) is 0. */
SIMD_INLINE double elementary_atan2(double y, double x)
{
    const double half = 0x1.921fb54442d18p+1, half_lo = 0x1.1a62633145c07p-53;
    const double first = elementary_first_quarter(fabs(y), fabs(x));
    const double known = x == 0.0 && y == 0.0 ? 0.0 : first;
    const double angle = x < 0.0 ? half - (known - half_lo) : known;

    return y < 0.0 ? -angle : angle;
}

SIMD_INLINE double elementary_atan(double x) { return elementary_atan2(x, 1.0); }
SIMD_INLINE double elementary_acos(double x) { return elementary_atan2(sqrt((1.0 - x) * (1.0 + x)), x); }
SIMD_INLINE double elementary_asin(double x) { return elementary_atan2(x, sqrt((1.0 - x) * (1.0 + x))); }

/* ---- angles in turns: patterns repeat ---- */

/* sin(2 pi r) for |r| <= 1/4; the polynomial's own error is below 2^-59. */
SIMD_INLINE double elementary_sine_of_turn(double r)
{
    const double z = r * r;

    return r * (0x1.921fb54442d18p+2 + z * (-0x1.4abbce625be52p+5 + z * (0x1.466bc6775aa7dp+6 + z * (-0x1.32d2cce627c86p+6 +
                z * (0x1.5078348551854p+5 + z * (-0x1.e3074dfaf87afp+3 + z * (0x1.e8f3675ee37ddp+1 +
                z * (-0x1.6f7acdb8f6580p-1 + z * 0x1.9d462020fcc78p-4))))))));
}

/* sin(2 pi x) and cos(2 pi x), errors below 3 * 2^-53 for every finite x: whole turns are taken away exactly. */
SIMD_INLINE double elementary_sin_turns(double x)
{
    const double r = x - floor(x + 0.5), a = fabs(r);

    return copysign(elementary_sine_of_turn(a > 0.25 ? 0.5 - a : a), r);
}

SIMD_INLINE double elementary_cos_turns(double x) { return elementary_sine_of_turn(0.25 - fabs(x - floor(x + 0.5))); }

/* x / (2 pi) without its whole turns, error below 2^-53 for |x| < 2^30; farther out an angle in -1/2..1/2 all the same. */
SIMD_INLINE double elementary_turns_of(double x)
{
    const pov_two turns = pov_two_mul_double(pov_two_of(0x1.45f306dc9c883p-3, -0x1.6b01ec5417056p-57), x);

    return (turns.hi - floor(turns.hi + 0.5)) + turns.lo;
}

#endif
