/* lane_mask.h - lanes as bits of a mask. */
#ifndef BASE_LANE_MASK_H
#define BASE_LANE_MASK_H

#include "base/lanes.h"

/* The first n lanes, of up to LANES_MAX. */
static inline uint64_t lane_mask_all(uint32_t n) { return n > 0 ? ~(uint64_t)0 >> (LANES_MAX - n) : 0; }

/* Of `of`, which has LANES_MAX lanes that are 0 or 1, the ones of the first n. */
static inline uint64_t lane_mask_of(const uint32_t *of, uint32_t n)
{
    uint64_t out = 0;

#if defined(__AVX512F__) && defined(__GNUC__)
    for (uint32_t i = 0; i < n; i += 16) {
        const __m512i some = _mm512_loadu_si512((const void *)(of + i));

        out |= (uint64_t)_mm512_test_epi32_mask(some, some) << i;
    }
#elif defined(__AVX2__) && defined(__GNUC__)
    for (uint32_t i = 0; i < n; i += 8) {
        const __m256i some = _mm256_slli_epi32(_mm256_loadu_si256((const __m256i *)(const void *)(of + i)), 31);

        out |= (uint64_t)(uint32_t)_mm256_movemask_ps(_mm256_castsi256_ps(some)) << i;
    }
#else
    for (uint32_t i = 0; i < n; i++)
        out |= (uint64_t)of[i] << i;
#endif
    return out & lane_mask_all(n);
}

/* The first n lanes where a is below b; both have LANES_MAX entries. */
static inline uint64_t lane_mask_below(const double *a, const double *b, uint32_t n)
{
    uint64_t out = 0;

#if defined(__AVX512F__) && defined(__GNUC__)
    for (uint32_t i = 0; i < n; i += 8)
        out |= (uint64_t)_mm512_cmp_pd_mask(_mm512_loadu_pd(a + i), _mm512_loadu_pd(b + i), _CMP_LT_OQ) << i;
#elif defined(__AVX2__) && defined(__GNUC__)
    for (uint32_t i = 0; i < n; i += 4)
        out |= (uint64_t)(uint32_t)_mm256_movemask_pd(_mm256_cmp_pd(_mm256_loadu_pd(a + i), _mm256_loadu_pd(b + i), _CMP_LT_OQ)) << i;
#else
    for (uint32_t i = 0; i < n; i++)
        out |= (uint64_t)(a[i] < b[i]) << i;
#endif
    return out & lane_mask_all(n);
}

static inline uint32_t lane_mask_count(uint64_t lanes)
{
    uint32_t n = 0;

#if defined(__POPCNT__) && defined(__GNUC__)
    n = (uint32_t)__builtin_popcountll(lanes);
#else
    for (; lanes; lanes &= lanes - 1)
        n++;
#endif
    return n;
}

/* Their numbers, in order. Returns how many there are. */
static inline uint32_t lane_mask_list(uint64_t lanes, uint8_t out[LANES_MAX])
{
    uint32_t n = 0;

    if ((lanes & (lanes + 1)) == 0) {
        for (uint32_t i = 0; i < LANES_MAX; i++)
            out[i] = (uint8_t)i;
        return lane_mask_count(lanes);
    }
    for (; lanes; lanes &= lanes - 1)
        out[n++] = (uint8_t)first_of64(lanes);
    return n;
}

#endif
