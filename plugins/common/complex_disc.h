/* complex_disc.h - complex numbers known to within a radius. Each function's result holds its values over the whole disc;
 * a disc that meets a pole or a branch cut gives an infinite radius. Rounding is not covered: it is far below the radii
 * that count. */
#ifndef COMMON_COMPLEX_DISC_H
#define COMMON_COMPLEX_DISC_H

#include "base/elementary.h"

#include <math.h>

typedef struct disc { double re, im, off; } disc;

static inline disc disc_of(double re, double im, double off)
{
    const disc d = { re, im, off };

    return d;
}

static inline double disc_square(disc a) { return a.re * a.re + a.im * a.im; }
static inline double disc_size(disc a) { return sqrt(disc_square(a)); }
static inline disc disc_add(disc a, disc b) { return disc_of(a.re + b.re, a.im + b.im, a.off + b.off); }
static inline disc disc_sub(disc a, disc b) { return disc_of(a.re - b.re, a.im - b.im, a.off + b.off); }
static inline disc disc_scale(disc a, double s) { return disc_of(a.re * s, a.im * s, a.off * fabs(s)); }
/* Times i, times -i. */
static inline disc disc_turn(disc a) { return disc_of(-a.im, a.re, a.off); }
static inline disc disc_turn_back(disc a) { return disc_of(a.im, -a.re, a.off); }
static inline disc disc_plus(disc a, double real) { return disc_of(a.re + real, a.im, a.off); }

static inline disc disc_times(disc a, disc b)
{
    const double off = a.off + b.off > 0.0 ? disc_size(a) * b.off + disc_size(b) * a.off + a.off * b.off : 0.0;

    return disc_of(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re, off);
}

static inline disc disc_squared(disc a)
{
    return disc_of(a.re * a.re - a.im * a.im, 2.0 * a.re * a.im, a.off > 0.0 ? (2.0 * disc_size(a) + a.off) * a.off : 0.0);
}

disc disc_reciprocal(disc a);
disc disc_exp(disc a);
disc disc_log(disc a);
disc disc_sqrt(disc a);
disc disc_sin(disc a);
disc disc_cos(disc a);
disc disc_sinh(disc a);
disc disc_cosh(disc a);
disc disc_tan(disc a);
disc disc_tanh(disc a);
disc disc_asin(disc a);
disc disc_acos(disc a);
disc disc_asinh(disc a);
disc disc_acosh(disc a);
disc disc_atan(disc a);
disc disc_atanh(disc a);

#endif
