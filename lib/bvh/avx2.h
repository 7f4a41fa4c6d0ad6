/* avx2.h - comparisons of distances along rays, for traversals compiled for AVX2.
 *
 * Read as integers, the bits of non-negative floats have the order of the floats, and all others are negative. An entry
 * is the maximum of some distances and zero, so that integers give the same result. An exit is the minimum: if one
 * distance is negative, a negative one is found, if not the same. Unless that is minus zero, nothing is entered before
 * it, and one box too many does no harm. The processor does twice as many of these comparisons at a time as of
 * floats. */
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

/* Sort keys of children that were hit, without a branch for each: their entries side by side, with the slot of the node
 * in the three lowest bits. Vectors stay at 256 bits: while wider ones are in use, Intel's processors start fewer of
 * these. */
BVH_AVX2 static inline __m256i slot_entries_avx512(__m256 entry, __mmask8 hit)
{
    const __m256i slots = _mm256_set_epi32(7, 6, 5, 4, 3, 2, 1, 0);
    const __m256i rest = _mm256_andnot_si256(_mm256_set1_epi32(7), _mm256_castps_si256(entry));

    return _mm256_maskz_compress_epi32(hit, _mm256_or_si256(rest, slots));
}

/* Entry distances of the keys: slot bits are cleared, so they are a little smaller, and no child is skipped too
 * soon. */
BVH_AVX2 static inline __m256 entries_avx512(__m256i order)
{
    return _mm256_castsi256_ps(_mm256_andnot_si256(_mm256_set1_epi32(7), order));
}

/* Bitonic sort, greatest first: for each stage the partner of each lane, and the lanes that keep the greater value. */
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
