/* pigment.h - what a surface's colour does to light. */
#ifndef SHADE_PIGMENT_H
#define SHADE_PIGMENT_H

#include "world/plan.h"

/* gloss^phong_size, rounded to float as pow()'s would be. A product of n factors is off by less than n 2^-53 of it, and
 * pow() by less than 2^-52; so where floats on both sides of 2^-42 are the same, that is the one. What lies below
 * double's range on the way is no float either. */
static inline float pigment_power(double gloss, const plan_look *look)
{
    double product = 1.0, square = gloss;

    for (uint32_t n = look->power; n; n >>= 1, square *= square)
        if (n & 1)
            product *= square;
    if (look->power && (float)(product * (1.0 - 0x1p-42)) == (float)(product * (1.0 + 0x1p-42)))
        return (float)product;
    return (float)pow(gloss, look->material->phong_size);
}

/* What a highlight is multiplied by; cosine is the one between normal and light. Of a metal: */
colour pigment_metal(const model *m, const material *of, double cosine);
/* Of any material: */
static inline colour pigment_highlight(const model *m, const material *of, double cosine)
{
    return of->metallic == 0.0f ? colour_of(1.0f, 1.0f, 1.0f) : pigment_metal(m, of, cosine);
}

#endif
