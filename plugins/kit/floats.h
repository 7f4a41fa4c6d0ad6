/* floats.h - what block filters in floats share: eight lanes, of shapes that one ray is asked of, or of rays that are
 * asked of one shape. */
#ifndef KIT_FLOATS_H
#define KIT_FLOATS_H

#include "kit/simd.h"

enum { KIT_FLOATS = 8 };

/* Half a unit in the last place of a float of one. */
#define KIT_E 0x1p-24f

/* Of rays with a size in the frame beyond this nothing is known. */
#define KIT_NEAR 1024.0f

/* As those for doubles. */
static inline float kit_float_greater(float a, float b) { return a > b ? a : b; }
static inline float kit_float_lesser(float a, float b) { return a < b ? a : b; }
static inline float kit_float_sum(float a, float b, float c)
{
#ifdef __FMA__
    return fmaf(a, b, c);
#else
    return a * b + c;
#endif
}

/* What is found, by lane: as of meetings, but for the bounds, which are lengths in the frame. */
typedef struct kit_chords { float lo[KIT_FLOATS], hi[KIT_FLOATS]; uint32_t maybe, surely, twice; } kit_chords;

/* Are more than n of these bits set? */
static inline bool kit_are_more(uint32_t bits, uint32_t n)
{
    for (; n > 0 && bits; n--)
        bits &= bits - 1;
    return bits != 0;
}

/* Puts what one lane says after the n meetings that there are. */
KIT_INLINE void kit_tell_chord(const kit_chords *c, uint32_t i, const pov_rays *rays, uint32_t ray, uint32_t shape,
                               pov_meeting *out)
{
    const double shift = rays->framed.shift[ray], unit = rays->framed.unit[ray];

    out->lo = shift + (double)c->lo[i] * unit;
    out->hi = shift + (double)c->hi[i] * unit;
    out->ray = (uint8_t)ray;
    out->lane = (uint8_t)shape;
    out->surely = c->surely >> i & 1;
    out->twice = c->twice >> i & 1;
}

/* Both give how many meetings there are then: of a shape and the rays from `from` on, of a ray and the shapes. */
static inline uint32_t kit_tell_rays_chords(const kit_chords *c, const pov_rays *rays, uint32_t from, uint32_t shape,
                                            pov_meeting *out, uint32_t n)
{
    uint32_t mask;

    for (mask = c->maybe; mask; mask &= mask - 1, n++) {
        const uint32_t i = kit_first_lane(mask);
        kit_tell_chord(c, i, rays, from + i, shape, &out[n]);
    }
    return n;
}

static inline uint32_t kit_tell_shapes_chords(const kit_chords *c, const pov_rays *rays, uint32_t ray, pov_meeting *out,
                                              uint32_t n)
{
    uint32_t mask;

    for (mask = c->maybe; mask; mask &= mask - 1, n++) {
        const uint32_t i = kit_first_lane(mask);
        kit_tell_chord(c, i, rays, ray, i, &out[n]);
    }
    return n;
}

#endif
