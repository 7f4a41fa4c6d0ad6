/* floats.h - shared parts of block filters in floats. Lanes are the shapes of a block for one ray, or rays for one
 * shape. */
#ifndef COMMON_FLOATS_H
#define COMMON_FLOATS_H

#include "common/simd.h"

/* Rays of one vector: as many as a vector of the processor holds, and no fewer than a block holds shapes. */
#ifdef __AVX512F__
enum { COMMON_FLOATS = 16 };
#else
enum { COMMON_FLOATS = 8 };
#endif

/* Half a unit in the last place of a float of one. */
#define COMMON_E 0x1p-24f

/* As the functions for doubles. */
static inline float common_float_greater(float a, float b) { return a > b ? a : b; }
static inline float common_float_lesser(float a, float b) { return a < b ? a : b; }
static inline float common_float_sum(float a, float b, float c)
{
#ifdef __FMA__
    return fmaf(a, b, c);
#else
    return a * b + c;
#endif
}

typedef struct common_three { float x, y, z; } common_three;

COMMON_INLINE float common_dot(common_three a, common_three b)
{
    return common_float_sum(a.z, b.z, common_float_sum(a.y, b.y, a.x * b.x));
}

/* A ray in the frame. Where nothing is known of it, the size is so large that error bounds cover the frame. Points
 * before `sure` are certainly not beyond tmax. */
typedef struct common_beam { common_three org, dir; float size, smax, sure; } common_beam;

COMMON_INLINE common_beam common_beam_of(const pov_rays *rays, size_t at)
{
    const float size = rays->local.size[at], smax = rays->local.smax[at];
    const common_beam r = { { rays->local.org[0][at], rays->local.org[1][at], rays->local.org[2][at] },
                         { rays->local.dir[0][at], rays->local.dir[1][at], rays->local.dir[2][at] },
                         size < 1024.0f ? size : 0x1p116f, smax,
                         smax * (1.0f - 16.0f * COMMON_E) - 8.0f * COMMON_E * size };
    return r;
}

/* Results by lane: as candidates, but with bounds as lengths in the frame. */
typedef struct common_chords { float lo[COMMON_FLOATS], hi[COMMON_FLOATS]; uint32_t maybe, definite,
                               definite_pair; } common_chords;

/* Masks of comparisons as in common_bits, for as many lanes as are in use. */
typedef struct common_outcomes { int32_t lane[COMMON_FLOATS]; } common_outcomes;

/* The bits of n lanes, of a block or COMMON_FLOATS of them. Lanes are stored as vectors of 256 bits; a load of 512 bits
 * would stall on two stores. */
COMMON_INLINE uint32_t common_bits_of(const common_outcomes *o, uint32_t n)
{
#ifdef __AVX512F__
    if (n > POV_BLOCK_MAX)
        return common_gather_lanes(o->lane) | common_gather_lanes(o->lane + POV_BLOCK_MAX) << POV_BLOCK_MAX;
#else
    (void)n;
#endif
    return common_gather_lanes(o->lane);
}

/* Conditions of chords, before they are packed into bits. */
typedef struct common_conditions { common_outcomes maybe, definite, definite_pair; } common_conditions;

/* Pack n lanes; maybe: only those of `some`. */
COMMON_INLINE void common_gather(const common_conditions *c, uint32_t n, uint32_t some, common_chords *out)
{
    out->maybe = some & common_bits_of(&c->maybe, n);
    out->definite = common_bits_of(&c->definite, n);
    out->definite_pair = common_bits_of(&c->definite_pair, n);
}

/* The lanes of COMMON_FLOATS whose owner is `whose`. */
COMMON_INLINE uint32_t common_rays_of(const uint32_t *owners, uint32_t whose)
{
    common_outcomes same;
    uint32_t i;

    for (i = 0; i < COMMON_FLOATS; i++)
        same.lane[i] = -(owners[i] == whose);
    return common_bits_of(&same, COMMON_FLOATS);
}

/* Append a candidate for each lane of `maybe` to the n candidates of `out`; returns their new number. Lanes are rays,
 * from `ray` on, at one shape; or shapes, from the first on, at one ray. */
COMMON_INLINE uint32_t common_chord_candidates(const common_chords *c, const pov_rays *rays, uint32_t ray,
                                               uint32_t shape, bool of_rays, pov_candidate *out, uint32_t n)
{
    uint32_t mask;

    for (mask = c->maybe; mask; mask &= mask - 1, n++) {
        const uint32_t i = common_first_lane(mask), at = of_rays ? ray + i : ray;
        const uint32_t bit = mask & (0u - mask);
        const double shift = rays->local.shift[at], unit = rays->local.unit[at];

        out[n].lo = shift + (double)c->lo[i] * unit;
        out[n].hi = shift + (double)c->hi[i] * unit;
        out[n].ray = (uint8_t)at;
        out[n].lane = (uint8_t)(of_rays ? shape : i);
        out[n].definite = (c->definite & bit) != 0;
        out[n].definite_pair = (c->definite_pair & bit) != 0;
    }
    return n;
}

/* Are more than n of these bits set? */
static inline bool common_are_more(uint32_t bits, uint32_t n)
{
    for (; n > 0 && bits; n--)
        bits &= bits - 1;
    return bits != 0;
}

/* Test `some` of COMMON_FLOATS rays, from `from` on, against one shape of a block; or one ray against all of its
 * shapes. */
typedef void common_filter_rays(const void *block, uint32_t which, const pov_rays *rays, size_t from, uint32_t some,
                                common_chords *restrict out);
typedef void common_filter_shapes(const void *block, const pov_rays *rays, size_t at, uint32_t some,
                                  common_chords *restrict out);

/* The filter. Lanes are rays or shapes, whichever are more. */
COMMON_INLINE uint32_t common_filter_in_lanes(const void *block, uint32_t count, const uint32_t *owners,
                                              const pov_rays *rays,
                                         uint64_t lanes, common_filter_rays *filter_rays,
                                             common_filter_shapes *filter_shapes,
                                         pov_candidate *out)
{
    const uint32_t all = (1u << count) - 1, together = (uint32_t)((UINT64_C(1) << COMMON_FLOATS) - 1);
    uint32_t n = 0, which;
    common_chords c;

    while (lanes) {
        const uint32_t from = common_first_lane64(lanes) / COMMON_FLOATS * COMMON_FLOATS;
        uint32_t some = (uint32_t)(lanes >> from) & together;
        const bool of_rays = common_are_more(some, count);

        lanes &= ~((uint64_t)together << from);
        for (which = 0; of_rays && which < count; which++) {
            const uint32_t kept_lanes = some & ~common_rays_of(rays->excluded + from, owners[which]);

            if (!kept_lanes)
                continue;
            filter_rays(block, which, rays, from, kept_lanes, &c);
            n = common_chord_candidates(&c, rays, from, which, true, out, n);
        }
        for (; !of_rays && some; some &= some - 1) {
            const uint32_t at = from + common_first_lane(some),
                kept_lanes = all & ~common_owned_by(owners, rays->excluded[at]);

            if (!kept_lanes)
                continue;
            filter_shapes(block, rays, at, kept_lanes, &c);
            n = common_chord_candidates(&c, rays, at, 0, false, out, n);
        }
    }
    return n;
}

#endif
