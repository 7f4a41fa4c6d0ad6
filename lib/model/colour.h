/* colour.h - red, green, blue, linear, 1 is full. */
#ifndef MODEL_COLOUR_H
#define MODEL_COLOUR_H

#include <math.h>
#include <stdbool.h>

typedef struct colour { float r, g, b; } colour;

static inline colour colour_of(float r, float g, float b) { colour c = { r, g, b }; return c; }
static inline colour colour_add(colour a, colour b) { return colour_of(a.r + b.r, a.g + b.g, a.b + b.b); }
static inline colour colour_mul(colour a, colour b) { return colour_of(a.r * b.r, a.g * b.g, a.b * b.b); }
static inline colour colour_scale(colour a, float s) { return colour_of(a.r * s, a.g * s, a.b * s); }
static inline bool colour_equal(colour a, colour b) { return a.r == b.r && a.g == b.g && a.b == b.b; }
/* One comparison: the sum of absolute values is zero only if all are. */
static inline bool colour_is_black(colour a) { return fabsf(a.r) + fabsf(a.g) + fabsf(a.b) == 0.0f; }
/* POV-Ray's. */
static inline float colour_grey(colour a) { return 0.297f * a.r + 0.589f * a.g + 0.114f * a.b; }
/* The largest absolute component. */
static inline float colour_weight(colour a)
{
    /* Plain comparisons: no NaN comes here. */
    float r = fabsf(a.r), g = fabsf(a.g), b = fabsf(a.b);

    g = g > b ? g : b;
    return r > g ? r : g;
}

static inline float colour_luminance(colour a) { return 0.297f * a.r + 0.589f * a.g + 0.114f * a.b; }

/* Factor that light is multiplied by on its path, with its weight; or a product of such factors. */
typedef struct coefficient { colour by; float weight; } coefficient;

static inline coefficient coefficient_of(colour c) { coefficient k = { c, colour_weight(c) }; return k; }
static inline coefficient coefficient_mul(coefficient a, coefficient b)
{
    coefficient k = { colour_mul(a.by, b.by), a.weight * b.weight };
    return k;
}

#endif
