/* srgb.h - the curve of sRGB (IEC 61966-2-1), with the same bits on every machine; straight near zero and below it. */
#ifndef BASE_SRGB_H
#define BASE_SRGB_H

#include "base/elementary.h"

static inline double srgb_encode(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * elementary_pow(linear, 1.0 / 2.4) - 0.055;
}

static inline double srgb_decode(double stored)
{
    return stored <= 0.04045 ? stored / 12.92 : elementary_pow((stored + 0.055) / 1.055, 2.4);
}

#endif
