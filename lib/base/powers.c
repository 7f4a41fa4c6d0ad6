#include "base/powers.h"

#include "base/elementary.h"
#include "base/lanes.h"

/* Logarithms first, then what they belong to: in one loop the steps of a number wait for each other, and are more than processors
 * look ahead to the next numbers. */
SIMD_CLONES static void find_logs(const double *restrict value, const double *restrict exponent, uint32_t n, double *restrict hi,
                                  double *restrict lo)
{
    for (uint32_t i = 0; i < n; i++) {
        const elementary_sum log = elementary_pow_log(value[i], exponent[i]);

        hi[i] = log.hi;
        lo[i] = log.lo;
    }
}

SIMD_CLONES static void find_powers(const double *restrict hi, const double *restrict lo, const double *restrict exponent, uint32_t n,
                                    double *restrict value)
{
    for (uint32_t i = 0; i < n; i++) {
        const elementary_sum log = { hi[i], lo[i] };

        value[i] = elementary_pow_of(log, value[i], exponent[i]);
    }
}

void powers_raise_each(const double *exponent, uint32_t n, double *value)
{
    SIMD_ALIGNED double hi[LANES_MAX], lo[LANES_MAX];

    find_logs(value, exponent, n, hi, lo);
    find_powers(hi, lo, exponent, n, value);
}

void powers_raise(double exponent, uint32_t n, double *value)
{
    SIMD_ALIGNED double each[LANES_MAX];

    for (uint32_t i = 0; i < n; i++)
        each[i] = exponent;
    powers_raise_each(each, n, value);
}
