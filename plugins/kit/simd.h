/* simd.h - what block filters share. A filter is a plain loop over POV_BLOCK_MAX lanes, compiled for
 * several instruction sets; the loader picks one. None of them contracts products and sums, so all give
 * the same bits. */
#ifndef KIT_SIMD_H
#define KIT_SIMD_H

#include "kit/local.h"

/* Sanitizers cannot run in the resolvers that pick a clone. */
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(undefined_behavior_sanitizer)
#define KIT_ONE_CLONE 1
#endif
#endif
/* What is compiled for AVX2 as a whole needs no clone for it, and POV_PORTABLE asks for plain C alone. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(__AVX2__) || defined(POV_PORTABLE)
#define KIT_ONE_CLONE 1
#endif

#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(KIT_ONE_CLONE)
#define KIT_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define KIT_CLONES
#endif

/* Filters square lengths in plain double: coordinates and sizes must leave room for that. */
static inline bool kit_block_range(double coordinate) { return coordinate < 1e120; }
static inline bool kit_block_size(double size) { return size > 1e-120 && size < 1e120; }

static inline bool kit_block_slope(double d) { return d == 0.0 || fabs(d) > 1e-120; }

/* Rays whose squares or inverses would leave the range are not filtered: every lane is in question. */
static inline bool kit_block_declines(const pov_ray *ray, double tmin, pov_block_answer *out)
{
    const double largest = pov_largest(ray->dir);
    uint32_t i;

    if (largest > 0.0 && largest < 1e120 && kit_block_slope(ray->dir.x) && kit_block_slope(ray->dir.y)
        && kit_block_slope(ray->dir.z) && kit_block_range(pov_largest(ray->org)))
        return false;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        out->lo[i] = tmin;
        out->hi[i] = HUGE_VAL;
    }
    out->maybe = (1u << POV_BLOCK_MAX) - 1;
    out->surely = 0;
    return true;
}

/* The lowest bit that is set; some must be. */
static inline uint32_t kit_first_lane(uint32_t mask)
{
#ifdef __GNUC__
    return (uint32_t)__builtin_ctz(mask);
#else
    uint32_t i = 0;

    while (!(mask >> i & 1))
        i++;
    return i;
#endif
}

static inline void kit_block_masks(const double *maybe, const double *surely, pov_block_answer *out)
{
    uint32_t i;

    out->maybe = out->surely = 0;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        out->maybe |= (uint32_t)(maybe[i] != 0.0) << i;
        out->surely |= (uint32_t)(surely[i] != 0.0) << i;
    }
    out->surely &= out->maybe;
}

#endif
