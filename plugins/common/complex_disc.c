#include "common/complex_disc.h"

disc disc_reciprocal(disc a)
{
    const double square = disc_square(a), size = sqrt(square), gap = size - a.off;

    return disc_of(a.re / square, -a.im / square, gap > 0.0 ? a.off / (size * gap) : HUGE_VAL);
}

disc disc_exp(disc a)
{
    const double size = elementary_exp(a.re), off = a.off > 0.0 ? size * (elementary_exp(a.off) - 1.0) : 0.0;

    return disc_of(size * elementary_cos(a.im), size * elementary_sin(a.im), off);
}

/* How far the negative real axis is. */
static double gap_to_cut(disc a) { return a.re < 0.0 ? fabs(a.im) : disc_size(a); }

disc disc_log(disc a)
{
    const double size = disc_size(a);
    const double off = a.off == 0.0 ? 0.0 : a.off < gap_to_cut(a) ? -elementary_log(1.0 - a.off / size) : HUGE_VAL;

    return disc_of(elementary_log(size), elementary_atan2(a.im, a.re), off);
}

/* The root whose real part is not negative. */
disc disc_sqrt(disc a)
{
    const double size = disc_size(a), re = sqrt(0.5 * (size + fabs(a.re))), other = re > 0.0 ? 0.5 * fabs(a.im) / re : 0.0;
    const double off = a.off == 0.0 ? 0.0 : a.off < gap_to_cut(a) ? a.off / sqrt(size) : HUGE_VAL;

    return a.re >= 0.0 ? disc_of(re, copysign(other, a.im), off) : disc_of(other, copysign(re, a.im), off);
}

disc disc_sinh(disc a) { return disc_scale(disc_sub(disc_exp(a), disc_exp(disc_scale(a, -1.0))), 0.5); }
disc disc_cosh(disc a) { return disc_scale(disc_add(disc_exp(a), disc_exp(disc_scale(a, -1.0))), 0.5); }
disc disc_sin(disc a) { return disc_turn_back(disc_sinh(disc_turn(a))); }
disc disc_cos(disc a) { return disc_cosh(disc_turn(a)); }
disc disc_tanh(disc a) { return disc_times(disc_sinh(a), disc_reciprocal(disc_cosh(a))); }
disc disc_tan(disc a) { return disc_turn_back(disc_tanh(disc_turn(a))); }

disc disc_asinh(disc a) { return disc_log(disc_add(a, disc_sqrt(disc_plus(disc_squared(a), 1.0)))); }
disc disc_acosh(disc a) { return disc_log(disc_add(a, disc_sqrt(disc_plus(disc_squared(a), -1.0)))); }
disc disc_asin(disc a) { return disc_turn_back(disc_asinh(disc_turn(a))); }
disc disc_acos(disc a) { return disc_turn_back(disc_acosh(a)); }

disc disc_atanh(disc a)
{
    return disc_scale(disc_sub(disc_log(disc_plus(a, 1.0)), disc_log(disc_plus(disc_scale(a, -1.0), 1.0))), 0.5);
}

disc disc_atan(disc a) { return disc_turn_back(disc_atanh(disc_turn(a))); }
