/* accumulate.h - accumulates the colours of paths. */
#ifndef SHADE_ACCUMULATE_H
#define SHADE_ACCUMULATE_H

#include "shade/layers.h"
#include "shade/lighting.h"

#include <float.h>

/* Overflow of extreme colours is clamped: NaN becomes 0, infinity the largest number. */
static inline float accumulate_float(float x)
{
    if (x >= -FLT_MAX && x <= FLT_MAX)
        return x;
    return isnan(x) ? 0.0f : copysignf(FLT_MAX, x);
}

/* A sum with a non-finite term is not finite itself. */
static inline colour accumulate_finite(colour c)
{
    if (isfinite(c.r + c.g + c.b))
        return c;
    return colour_of(accumulate_float(c.r), accumulate_float(c.g), accumulate_float(c.b));
}

/* Add a path's contribution to the colour of its camera ray. */
static inline void accumulate(const path *p, colour seen, colour *out)
{
    out[p->lane] = colour_add(out[p->lane], accumulate_finite(colour_mul(p->factor.by, seen)));
}

/* Add the light that surfaces emit and reflect along their rays. firsts: they are the first to add to their rays' colours, all of one
 * batch of the camera. Light by lane of one appearance, and of stacks, is overwritten. */
void accumulate_surfaces(surfaces *s, bool firsts, colour *out);
/* The same of surfaces of which some are flat stacks, and of layers. */
void accumulate_stacks(const surfaces *s, lit_stacks *from, colour *out);
void accumulate_layers(const layers *l, colour *out);
/* End with sums that are finite. */
void accumulate_end(colour *out, uint32_t n);

#endif
