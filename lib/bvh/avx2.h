/* avx2.h - distances along rays, for the traversals that are compiled for AVX2.
 *
 * As whole numbers, the bits of floats that are not negative have the order of the floats, and all others are less than
 * zero. Entries are the greatest of some distances and zero, so that whole numbers give the same. Exits are the least:
 * where one is negative, a negative one is found, if not the same; unless it is minus zero, nothing is entered before
 * it, and a box too many does no harm. Twice as many such comparisons as those of floats go side by side. */
#ifndef BVH_AVX2_H
#define BVH_AVX2_H

#include <immintrin.h>

#define BVH_AVX2 __attribute__((target("avx2,fma")))

BVH_AVX2 static inline __m256 sooner(__m256 a, __m256 b)
{
    return _mm256_castsi256_ps(_mm256_min_epi32(_mm256_castps_si256(a), _mm256_castps_si256(b)));
}

BVH_AVX2 static inline __m256 later(__m256 a, __m256 b)
{
    return _mm256_castsi256_ps(_mm256_max_epi32(_mm256_castps_si256(a), _mm256_castps_si256(b)));
}

#ifdef __AVX512VL__

/* To put met children in order without a branch for each: their entries side by side, the place in the node in the
 * three lowest bits. Vectors keep to 256 bits: while wider ones are under way, Intel's processors do fewer of these. */
BVH_AVX2 static inline __m256i slot_entries_avx512(__m256 entry, __mmask8 hit)
{
    const __m256i slots = _mm256_set_epi32(7, 6, 5, 4, 3, 2, 1, 0);
    const __m256i rest = _mm256_andnot_si256(_mm256_set1_epi32(7), _mm256_castps_si256(entry));

    return _mm256_maskz_compress_epi32(hit, _mm256_or_si256(rest, slots));
}

/* What lies before each: entries without places, a little less than they were, so that nothing is passed by too soon. */
BVH_AVX2 static inline __m256 entries_avx512(__m256i order)
{
    return _mm256_castsi256_ps(_mm256_andnot_si256(_mm256_set1_epi32(7), order));
}

/* The greatest first, by bitonic sorting: by stage, whom each is held against, and who keeps the greater. */
BVH_AVX2 static inline __m256i sort_avx512(__m256i v, uint32_t count)
{
#define STAGE(other, greater) v = _mm256_blend_epi32(_mm256_min_epu32(v, other), _mm256_max_epu32(v, other), greater)
    STAGE(_mm256_shuffle_epi32(v, 0xb1), 0x99);
    STAGE(_mm256_shuffle_epi32(v, 0x4e), 0xc3);
    STAGE(_mm256_shuffle_epi32(v, 0xb1), 0xa5);
    if (count > 4) {
        STAGE(_mm256_permute2x128_si256(v, v, 0x01), 0x0f);
        STAGE(_mm256_shuffle_epi32(v, 0x4e), 0x33);
        STAGE(_mm256_shuffle_epi32(v, 0xb1), 0x55);
    }
#undef STAGE
    return v;
}

BVH_AVX2 static inline void store_avx512(uint32_t *at, __m256i v)
{
    _mm256_storeu_si256((__m256i *)(void *)at, v);
}

#endif

#endif
