/* bvh_avx2.h - distances along rays, for the walks that are compiled for AVX2.
 *
 * As whole numbers, the bits of floats that are not negative have the order of the floats, and all others are less than
 * zero. Entries are the greatest of some distances and zero, so that whole numbers give the same. Exits are the least:
 * where one is negative, a negative one is found, if not the same; unless it is minus zero, nothing is entered before
 * it, and a box too many does no harm. Twice as many such comparisons as those of floats go side by side. */
#ifndef WORLD_BVH_AVX2_H
#define WORLD_BVH_AVX2_H

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

#endif
