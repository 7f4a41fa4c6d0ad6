/* simd.h - what block filters share. A filter is a plain loop over POV_BLOCK_MAX lanes, compiled for
 * several instruction sets; the loader picks one. None of them contracts products and sums, so all give
 * the same bits. */
#ifndef KIT_SIMD_H
#define KIT_SIMD_H

#include "kit/local.h"

/* Sanitizers cannot run in the resolvers that pick a clone, and what is built for wide processors needs none. */
#if defined(__AVX2__)
#define KIT_ONE_CLONE 1
#endif
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

static inline double kit_sum_of_components(pov_vec3 a) { return fabs(a.x) + fabs(a.y) + fabs(a.z); }

/* Is a ray within the range, too? */
static inline bool kit_block_takes(const pov_ray *ray)
{
    const double speed = kit_sum_of_components(ray->dir);

    return kit_block_range(kit_sum_of_components(ray->org)) && speed > 1e-120 && speed < 1e120;
}

/* Every lane is in question. */
static inline void kit_block_decline(double tmin, pov_block_answer *out)
{
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        out->lo[i] = tmin;
        out->hi[i] = HUGE_VAL;
    }
    out->maybe = (1u << POV_BLOCK_MAX) - 1;
    out->surely = 0;
}

/* One instruction each; of what is not a number the second. */
static inline double kit_greater(double a, double b) { return a > b ? a : b; }
static inline double kit_lesser(double a, double b) { return a < b ? a : b; }

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

static inline uint32_t kit_first_lane64(uint64_t mask)
{
#ifdef __GNUC__
    return (uint32_t)__builtin_ctzll(mask);
#else
    return (uint32_t)mask ? kit_first_lane((uint32_t)mask) : 32 + kit_first_lane((uint32_t)(mask >> 32));
#endif
}

/* a b + c for filters, whose bounds hold for one rounding as for two. */
static inline double kit_sum_of(double a, double b, double c)
{
#ifdef __FMA__
    return fma(a, b, c);
#else
    return a * b + c;
#endif
}

#endif
