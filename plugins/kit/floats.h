/* floats.h - shared parts of block filters in floats. Lanes are the shapes of a block for one ray, or rays for one
 * shape. */
#ifndef KIT_FLOATS_H
#define KIT_FLOATS_H

#include "kit/simd.h"

/* Rays of one vector: as many as a vector of the processor holds, and no fewer than a block holds shapes. */
#ifdef __AVX512F__
enum { KIT_FLOATS = 16 };
#else
enum { KIT_FLOATS = 8 };
#endif

/* Half a unit in the last place of a float of one. */
#define KIT_E 0x1p-24f

/* As the functions for doubles. */
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

typedef struct kit_three { float x, y, z; } kit_three;

KIT_INLINE float kit_dot(kit_three a, kit_three b)
{
    return kit_float_sum(a.z, b.z, kit_float_sum(a.y, b.y, a.x * b.x));
}

/* A ray in the frame. Where nothing is known of it, the size is so large that error bounds cover the frame. Points
 * before `sure` are certainly not beyond tmax. */
typedef struct kit_beam { kit_three org, dir; float size, smax, sure; } kit_beam;

KIT_INLINE kit_beam kit_beam_of(const pov_rays *rays, size_t at)
{
    const float size = rays->framed.size[at], smax = rays->framed.smax[at];
    const kit_beam r = { { rays->framed.org[0][at], rays->framed.org[1][at], rays->framed.org[2][at] },
                         { rays->framed.dir[0][at], rays->framed.dir[1][at], rays->framed.dir[2][at] },
                         size < 1024.0f ? size : 0x1p116f, smax,
                         smax * (1.0f - 16.0f * KIT_E) - 8.0f * KIT_E * size };
    return r;
}

/* Results by lane: as candidates, but with bounds as lengths in the frame. */
typedef struct kit_chords { float lo[KIT_FLOATS], hi[KIT_FLOATS]; uint32_t maybe, surely, twice; } kit_chords;

/* Masks of comparisons as in kit_bits, for as many lanes as are in use. */
typedef struct kit_outcomes { int32_t lane[KIT_FLOATS]; } kit_outcomes;

/* The bits of n lanes: those of a block, or KIT_FLOATS. Lanes are stored as vectors of 256 bits; a load of 512 bits
 * would stall on two stores. */
KIT_INLINE uint32_t kit_bits_of(const kit_outcomes *o, uint32_t n)
{
#ifdef __AVX512F__
    if (n > POV_BLOCK_MAX)
        return kit_gather_lanes(o->lane) | kit_gather_lanes(o->lane + POV_BLOCK_MAX) << POV_BLOCK_MAX;
#else
    (void)n;
#endif
    return kit_gather_lanes(o->lane);
}

/* Conditions of chords, before they are packed into bits. */
typedef struct kit_conditions { kit_outcomes maybe, surely, twice; } kit_conditions;

/* Pack n lanes; maybe: only those of `some`. */
KIT_INLINE void kit_gather(const kit_conditions *c, uint32_t n, uint32_t some, kit_chords *out)
{
    out->maybe = some & kit_bits_of(&c->maybe, n);
    out->surely = kit_bits_of(&c->surely, n);
    out->twice = kit_bits_of(&c->twice, n);
}

/* The lanes of KIT_FLOATS whose owner is `whose`. */
KIT_INLINE uint32_t kit_rays_of(const uint32_t *owners, uint32_t whose)
{
    kit_outcomes same;
    uint32_t i;

    for (i = 0; i < KIT_FLOATS; i++)
        same.lane[i] = -(owners[i] == whose);
    return kit_bits_of(&same, KIT_FLOATS);
}

/* Append a candidate for each lane of `maybe` to the n candidates of `out`; returns their new number. Lanes are rays,
 * from `ray` on, at one shape; or shapes, from the first on, at one ray. */
KIT_INLINE uint32_t kit_tell_chords(const kit_chords *c, const pov_rays *rays, uint32_t ray, uint32_t shape, bool of_rays,
                                    pov_meeting *out, uint32_t n)
{
    uint32_t mask;

    for (mask = c->maybe; mask; mask &= mask - 1, n++) {
        const uint32_t i = kit_first_lane(mask), at = of_rays ? ray + i : ray;
        const uint32_t bit = mask & (0u - mask);
        const double shift = rays->framed.shift[at], unit = rays->framed.unit[at];

        out[n].lo = shift + (double)c->lo[i] * unit;
        out[n].hi = shift + (double)c->hi[i] * unit;
        out[n].ray = (uint8_t)at;
        out[n].lane = (uint8_t)(of_rays ? shape : i);
        out[n].surely = (c->surely & bit) != 0;
        out[n].twice = (c->twice & bit) != 0;
    }
    return n;
}

/* Are more than n of these bits set? */
static inline bool kit_are_more(uint32_t bits, uint32_t n)
{
    for (; n > 0 && bits; n--)
        bits &= bits - 1;
    return bits != 0;
}

/* Test `some` of KIT_FLOATS rays, from `from` on, against one shape of a block; or one ray against all of its
 * shapes. */
typedef void kit_meet_rays(const void *block, uint32_t which, const pov_rays *rays, size_t from, uint32_t some,
                           kit_chords *restrict out);
typedef void kit_meet_shapes(const void *block, const pov_rays *rays, size_t at, uint32_t some, kit_chords *restrict out);

/* The filter. Lanes are rays or shapes, whichever are more. */
KIT_INLINE uint32_t kit_filter_in_lanes(const void *block, uint32_t count, const uint32_t *owners, const pov_rays *rays,
                                         uint64_t lanes, kit_meet_rays *meet_rays, kit_meet_shapes *meet_shapes,
                                         pov_meeting *out)
{
    const uint32_t all = (1u << count) - 1, together = (uint32_t)((UINT64_C(1) << KIT_FLOATS) - 1);
    uint32_t n = 0, which;
    kit_chords c;

    while (lanes) {
        const uint32_t from = kit_first_lane64(lanes) / KIT_FLOATS * KIT_FLOATS;
        uint32_t some = (uint32_t)(lanes >> from) & together;
        const bool of_rays = kit_are_more(some, count);

        lanes &= ~((uint64_t)together << from);
        for (which = 0; of_rays && which < count; which++) {
            const uint32_t stay = some & ~kit_rays_of(rays->away + from, owners[which]);

            if (!stay)
                continue;
            meet_rays(block, which, rays, from, stay, &c);
            n = kit_tell_chords(&c, rays, from, which, true, out, n);
        }
        for (; !of_rays && some; some &= some - 1) {
            const uint32_t at = from + kit_first_lane(some), stay = all & ~kit_owned_by(owners, rays->away[at]);

            if (!stay)
                continue;
            meet_shapes(block, rays, at, stay, &c);
            n = kit_tell_chords(&c, rays, at, 0, false, out, n);
        }
    }
    return n;
}

#endif
