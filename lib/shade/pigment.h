/* pigment.h - what a surface's colour does to light. */
#ifndef SHADE_PIGMENT_H
#define SHADE_PIGMENT_H

#include "world/plan.h"

/* A product of n factors is off by less than n 2^-53 of it, and pow() by less than 2^-52; so it lies between these, and
 * where they are the same float, that is the one. What lies below double's range on the way is no float either. */
static inline float pigment_lo(double product) { return (float)(product * (1.0 - 0x1p-42)); }
static inline float pigment_hi(double product) { return (float)(product * (1.0 + 0x1p-42)); }

/* gloss^phong_size, rounded to float as pow()'s would be. */
static inline float pigment_power(double gloss, const plan_look *look)
{
    double product = 1.0, square = gloss;

    for (uint32_t n = look->power; n; n >>= 1, square *= square)
        if (n & 1)
            product *= square;
    if (look->power && pigment_lo(product) == pigment_hi(product))
        return pigment_lo(product);
    return (float)pow(gloss, look->material->phong_size);
}

/* That product for a power of up to PLAN_POWER_EASY, without loops and branches: for many side by side. */
static inline double pigment_factor(double square, int64_t bit) { return bit ? square : 1.0; }

static inline double pigment_product(double gloss, int64_t power)
{
    const double of2 = gloss * gloss, of4 = of2 * of2, of8 = of4 * of4, of16 = of8 * of8, of32 = of16 * of16;
    const double of64 = of32 * of32;
    double product = pigment_factor(gloss, power & 1);

    product *= pigment_factor(of2, power & 2);
    product *= pigment_factor(of4, power & 4);
    product *= pigment_factor(of8, power & 8);
    product *= pigment_factor(of16, power & 16);
    product *= pigment_factor(of32, power & 32);
    product *= pigment_factor(of64, power & 64);
    return product * pigment_factor(of64 * of64, power & 128);
}

/* What a highlight is multiplied by; cosine is the one between normal and light. Of a metal: */
colour pigment_metal(const model *m, const material *of, double cosine);
/* Of any material: */
static inline colour pigment_highlight(const model *m, const material *of, double cosine)
{
    return of->metallic == 0.0f ? colour_of(1.0f, 1.0f, 1.0f) : pigment_metal(m, of, cosine);
}

#endif
