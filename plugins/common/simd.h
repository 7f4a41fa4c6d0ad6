/* simd.h - shared parts of block filters. A filter is a plain loop over POV_BLOCK_MAX lanes, compiled for several
 * instruction sets; the loader picks one. None of them contracts products and sums, so all give the same bits. */
#ifndef COMMON_SIMD_H
#define COMMON_SIMD_H

#include "common/local.h"

#include <string.h>

/* Sanitizers cannot run in the resolvers that choose a clone, and code built for wide processors needs none. */
#if defined(__AVX2__)
#define COMMON_ONE_CLONE 1
#endif
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(undefined_behavior_sanitizer)
#define COMMON_ONE_CLONE 1
#endif
#endif
/* Code that is compiled for AVX2 as a whole needs no clone for it, and POV_PORTABLE asks for plain C only. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(__AVX2__) || defined(POV_PORTABLE)
#define COMMON_ONE_CLONE 1
#endif

#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(COMMON_ONE_CLONE)
#define COMMON_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define COMMON_CLONES
#endif

/* COMMON_SEPARATE: clones that are not inlined either, as their arguments are restrict no more where they are: loops over lanes are then tested
 * for overlaps, and may be left scalar. */
#if defined(__GNUC__) && (!defined(__x86_64__) || !defined(__gnu_linux__) || defined(COMMON_ONE_CLONE))
#define COMMON_SEPARATE __attribute__((noinline))
#else
#define COMMON_SEPARATE COMMON_CLONES
#endif

/* Before a loop over a few lanes, which is to become vectors and not first be unrolled. */
#if defined(__GNUC__) && !defined(__clang__)
#define COMMON_LOOP _Pragma("GCC unroll 1")
#else
#define COMMON_LOOP
#endif

static inline double common_sum_of_components(pov_vec3 a) { return fabs(a.x) + fabs(a.y) + fabs(a.z); }

/* Origin and direction of a ray in lane `at`. */
static inline pov_vec3 common_origin(const pov_rays *rays, uint32_t at)
{
    return pov_vec3_of(rays->org[0][at], rays->org[1][at], rays->org[2][at]);
}

static inline pov_vec3 common_dir(const pov_rays *rays, uint32_t at)
{
    return pov_vec3_of(rays->dir[0][at], rays->dir[1][at], rays->dir[2][at]);
}

/* Results of a block for one ray: lanes of possible hits, of definite hits, and of definite pairs; and bounds on the
 * nearest crossing of each lane of `maybe`. hi is valid for lanes of `definite` only. */
typedef struct common_result {
    uint32_t maybe, definite, definite_pair;
    double lo[POV_BLOCK_MAX], hi[POV_BLOCK_MAX];
} common_result;

/* All used lanes are possible hits. */
static inline void common_decline(uint32_t lanes, common_result *out)
{
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        out->lo[i] = 0.0;
        out->hi[i] = HUGE_VAL;
    }
    out->maybe = lanes;
    out->definite = out->definite_pair = 0;
}

/* One instruction each; if an operand is NaN, the second one. */
static inline double common_greater(double a, double b) { return a > b ? a : b; }
static inline double common_lesser(double a, double b) { return a < b ? a : b; }

/* Results of a comparison by lane, all bits or none; and packed, one bit for each. */
typedef struct common_bits { int32_t lane[POV_BLOCK_MAX]; } common_bits;

static inline uint32_t common_gather_lanes(const int32_t *lanes)
{
#if defined(__AVX2__) && defined(__GNUC__)
    typedef float floats __attribute__((vector_size(32)));
    floats f;

    memcpy(&f, lanes, sizeof f);
    return (uint32_t)__builtin_ia32_movmskps256(f);
#else
    uint32_t bits = 0, i;

    for (i = 0; i < POV_BLOCK_MAX; i++)
        bits |= (uint32_t)lanes[i] & 1u << i;
    return bits;
#endif
}

static inline uint32_t common_gather_bits(const common_bits *b) { return common_gather_lanes(b->lane); }

/* Lanes whose owner is `whose`, as bits. */
static inline uint32_t common_owned_by(const uint32_t *owners, uint32_t whose)
{
    common_bits same;
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++)
        same.lane[i] = -(owners[i] == whose);
    return common_gather_bits(&same);
}

/* Index of the lowest set bit; the mask must not be zero. */
static inline uint32_t common_first_lane(uint32_t mask)
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

static inline uint32_t common_first_lane64(uint64_t mask)
{
#ifdef __GNUC__
    return (uint32_t)__builtin_ctzll(mask);
#else
    return (uint32_t)mask ? common_first_lane((uint32_t)mask) : 32 + common_first_lane((uint32_t)(mask >> 32));
#endif
}

/* Number of set bits. */
static inline uint32_t common_count(uint64_t mask)
{
#ifdef __GNUC__
    return (uint32_t)__builtin_popcountll(mask);
#else
    uint32_t n;

    for (n = 0; mask; mask &= mask - 1)
        n++;
    return n;
#endif
}

/* Append a ray's results to the n candidates of `out`; returns their new number. */
static inline uint32_t common_candidates(const common_result *a, uint32_t ray, pov_candidate *out, uint32_t n)
{
    uint32_t mask;

    for (mask = a->maybe; mask; mask &= mask - 1, n++) {
        const uint32_t i = common_first_lane(mask);

        out[n].lo = a->lo[i];
        out[n].hi = a->hi[i];
        out[n].ray = (uint8_t)ray;
        out[n].lane = (uint8_t)i;
        out[n].definite = a->definite >> i & 1;
        out[n].definite_pair = a->definite_pair >> i & 1;
    }
    return n;
}

/* a b + c for filters, whose bounds hold for one rounding as for two. */
static inline double common_sum_of(double a, double b, double c)
{
#ifdef __FMA__
    return fma(a, b, c);
#else
    return a * b + c;
#endif
}

#endif
