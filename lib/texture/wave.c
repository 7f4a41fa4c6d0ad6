#include "texture/wave.h"

#include "base/elementary.h"
#include "base/powers.h"

/* Values repeat with this period, which is not 1, so that 1 stays 1. Its upper half has so few bits that products with
 * whole numbers up to wave_near are exact. */
static const double period = 1.00001, period_upper = 0x1.0000a7cp+0, period_lower = 0x1.6b11c8p-30;
static const double wave_near = 1048576.0;

/* fmod(v, period), exactly, for |v| < wave_near. The quotient may be one off where it was rounded to a whole number;
 * the rest is then negative against v, and the sum with the period exact. */
SIMD_INLINE double near_rest(double v)
{
    const double a = fabs(v), whole = floor(a / period), rest = (a - whole * period_upper) - whole * period_lower;

    return copysign(rest < 0.0 ? rest + period : rest, v);
}

SIMD_CLONES static void fold_near(double frequency, double phase, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++) {
        const double rest = near_rest(value[i] * frequency + phase);

        value[i] = rest < 0.0 ? rest + 1.0 : rest;
    }
}

static void fold_far(double frequency, double phase, uint32_t n, double *value)
{
    for (uint32_t i = 0; i < n; i++) {
        const double rest = fmod(value[i] * frequency + phase, period);

        value[i] = rest < 0.0 ? rest + 1.0 : rest;
    }
}

SIMD_CLONES static bool are_near(double frequency, double phase, uint32_t n, const double *restrict value)
{
    int64_t near = -1;

    for (uint32_t i = 0; i < n; i++)
        near &= fabs(value[i] * frequency + phase) < wave_near ? -1 : 0;
    return near != 0;
}

/* Without a frequency values keep their place, but for negative ones. */
SIMD_CLONES static void fold_negative(uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = value[i] < 0.0 ? value[i] - floor(value[i]) : value[i];
}

static void fold(const wave *w, uint32_t n, double *value)
{
    if (w->frequency == 0.0f)
        fold_negative(n, value);
    else if (are_near(w->frequency, w->phase, n, value))
        fold_near(w->frequency, w->phase, n, value);
    else
        fold_far(w->frequency, w->phase, n, value);
}

SIMD_CLONES static void to_triangle(uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++) {
        const double t = value[i] - floor(value[i]);

        value[i] = t < 0.5 ? 2.0 * t : 2.0 - 2.0 * t;
    }
}

SIMD_CLONES static void to_sine(uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = 0.5 * (1.0 + elementary_sin_turns(value[i]));
}

SIMD_CLONES static void to_scallop(uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = fabs(elementary_sin_turns(0.5 * value[i]));
}

SIMD_CLONES static void to_cubic(uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = value[i] * value[i] * (3.0 - 2.0 * value[i]);
}

void wave_shape(const wave *w, uint32_t n, double *value)
{
    n = lanes_whole(n);
    fold(w, n, value);
    switch (w->form) {
    case WAVE_RAMP:
        break;
    case WAVE_TRIANGLE:
        to_triangle(n, value);
        break;
    case WAVE_SINE:
        to_sine(n, value);
        break;
    case WAVE_SCALLOP:
        to_scallop(n, value);
        break;
    case WAVE_CUBIC:
        to_cubic(n, value);
        break;
    case WAVE_POLY:
        powers_raise(w->exponent, n, value);
        break;
    }
}
