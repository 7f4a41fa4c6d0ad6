/* highlight.h - the strength and the colour of highlights. */
#ifndef SHADE_HIGHLIGHT_H
#define SHADE_HIGHLIGHT_H

#include "base/elementary.h"
#include "shade/appearance.h"

/* Bounds of a product: n factors are off by less than n 2^-53 of it, and elementary_pow() by less than 2^-51. Where both bounds
 * are the same float, that is the rounded power. Underflow on the way does not change a float either. */
static inline float highlight_lo(double product) { return (float)(product * (1.0 - 0x1p-42)); }
static inline float highlight_hi(double product) { return (float)(product * (1.0 + 0x1p-42)); }

/* cosine^phong_size, rounded to float as that of elementary_pow(). */
static inline float highlight_power(double cosine, const appearance *of)
{
    double product = 1.0, square = cosine;

    for (uint32_t n = of->power; n; n >>= 1, square *= square)
        if (n & 1)
            product *= square;
    if (of->power && highlight_lo(product) == highlight_hi(product))
        return highlight_lo(product);
    return (float)elementary_pow(cosine, (double)of->finish->phong_size);
}

/* The product for a power of up to APPEARANCE_POWER_LANES, without loops and branches: for lanes. */
static inline double highlight_factor(double square, int64_t bit) { return bit ? square : 1.0; }

/* low: the power is below 64. */
static inline double highlight_product(double cosine, int64_t power, bool low)
{
    const double of2 = cosine * cosine, of4 = of2 * of2, of8 = of4 * of4, of16 = of8 * of8, of32 = of16 * of16;
    const double of64 = of32 * of32;
    double product = highlight_factor(cosine, power & 1);

    product *= highlight_factor(of2, power & 2);
    product *= highlight_factor(of4, power & 4);
    product *= highlight_factor(of8, power & 8);
    product *= highlight_factor(of16, power & 16);
    product *= highlight_factor(of32, power & 32);
    if (low)
        return product;
    product *= highlight_factor(of64, power & 64);
    return product * highlight_factor(of64 * of64, power & 128);
}

/* A rational fit of metal's loss of colour towards grazing light, by the angle of incidence as a fraction of 90
 * degrees. */
SIMD_INLINE double highlight_fresnel_loss(double angle)
{
    const double quarter = 1.57079632679489661923, x = angle / quarter - 1.12;
    const double loss = 0.014567225 / (x * x) - 0.011612903, most = loss < 1.0 ? loss : 1.0;

    return loss > 0.0 ? most : 0.0;
}

SIMD_INLINE double highlight_known(double cosine)
{
    const double most = cosine < 1.0 ? cosine : 1.0;

    return most > -1.0 ? most : -1.0;
}

static inline double highlight_fresnel(double cosine) { return highlight_fresnel_loss(elementary_acos(highlight_known(cosine))); }
/* The same for cosines side by side, in their place. */
void highlight_fresnel_lanes(double *value, uint32_t n);

/* Colour of a highlight; cosine is the one between normal and light. For a metal: */
colour highlight_metal(const model *m, const appearance *of, double cosine);
/* For any material: */
static inline colour highlight_colour(const model *m, const appearance *of, double cosine)
{
    return of->finish->metallic == 0.0f ? colour_of(1.0f, 1.0f, 1.0f) : highlight_metal(m, of, cosine);
}

#endif
