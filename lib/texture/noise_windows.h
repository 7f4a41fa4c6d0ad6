/* noise_windows.h - sums by 512 bits. Lanes go four by four, as windows: where all points of one are in one cell, they have the same
 * numbers, and stand side by side. On a floor at height 0, the corners above have no weight. */
#ifndef TEXTURE_NOISE_WINDOWS_H
#define TEXTURE_NOISE_WINDOWS_H

#include "texture/noise_sums.h"

/* Compilers would add up one sum behind the other, for which there are not registers enough. */
#define KEEP_ORDER(value) __asm__("" : "+v"(value))

/* The first part is half a weight times a number: a weight times half the number is the same, but for what is so small that the
 * other corners' parts, whose weights add up to 1 with it, do not change by it. */
enum { HALVES = NOISE_COPIES * NOISE_COPY };

/* Where points are level, at height 0 of their cells, corners above add zeros, and heights from the corners below are zeros. */
enum { HEIGHT = 2 };             /* the part of a place */
SIMD_INLINE bool is_above(int corner) { return corner >> 1 & 1; }

#define RUN sum_eight
#define RUN_LANES 8
#include "texture/noise_run.h"
#define RUN sum_four
#define RUN_LANES 4
#include "texture/noise_run.h"

/* ---- points by themselves ---- */

SIMD_INLINE __m256d place_at(const lattice *l, uint32_t lane)
{
    return _mm256_setr_pd(0.5, l->inside[0][lane], l->inside[1][lane], l->inside[2][lane]);
}

/* The parts of its components, of the first two in one vector. */
SIMD_INLINE void sum_parts_of_three(const noise_tables *t, const lattice *l, uint32_t lane, bool level, double *x, double *y, double *z)
{
    const __m512d place = _mm512_broadcast_f64x4(place_at(l, lane));
    const double *from[CORNERS];
    __m512d xy = _mm512_setzero_pd();
    __m256d last = _mm256_setzero_pd();

    find_corners(t, l, lane, from);
#pragma GCC unroll 8
    for (int c = 0; c < CORNERS; c++) {
        const __m512d corner = _mm512_broadcast_f64x4(_mm256_loadu_pd(noise_corner[c]));
        const __m512d by = _mm512_mul_pd(_mm512_sub_pd(place, corner), _mm512_set1_pd(l->weight[c][lane]));
        const __m512d more_xy = _mm512_mul_pd(by, _mm512_loadu_pd(from[c]));
        const __m256d more = _mm256_mul_pd(_mm512_castpd512_pd256(by), _mm256_loadu_pd(from[c] + 2 * PARTS));

        if (level && is_above(c))
            continue;
        xy = c == 0 ? more_xy : _mm512_add_pd(xy, more_xy);
        last = c == 0 ? more : _mm256_add_pd(last, more);
        KEEP_ORDER(xy);
        KEEP_ORDER(last);
    }
    _mm256_store_pd(x, _mm512_castpd512_pd256(xy));
    _mm256_store_pd(y, _mm512_extractf64x4_pd(xy, 1));
    _mm256_store_pd(z, last);
}

SIMD_INLINE void sum_parts_of_one(const noise_tables *t, const lattice *l, uint32_t lane, bool level, double *out)
{
    const __m256d place = place_at(l, lane);
    const double *from[CORNERS];
    __m256d sum = _mm256_setzero_pd();

    find_corners(t, l, lane, from);
#pragma GCC unroll 8
    for (int c = 0; c < CORNERS; c++) {
        const __m256d by = _mm256_mul_pd(_mm256_sub_pd(place, _mm256_loadu_pd(noise_corner[c])), _mm256_set1_pd(l->weight[c][lane]));
        const __m256d more = _mm256_mul_pd(by, _mm256_loadu_pd(from[c]));

        if (level && is_above(c))
            continue;
        sum = c == 0 ? more : _mm256_add_pd(sum, more);
    }
    _mm256_store_pd(out, sum);
}

SIMD_INLINE void sum_points_of(const noise_tables *t, const lattice *l, uint32_t first, int count, bool level, double *const out[])
{
    SIMD_ALIGNED double parts[3][4][PARTS];

#pragma GCC unroll 1
    for (uint32_t i = 0; i < 4; i++)
        if (count == 1)
            sum_parts_of_one(t, l, first + i, level, parts[0][i]);
        else
            sum_parts_of_three(t, l, first + i, level, parts[0][i], parts[1][i], parts[2][i]);
    for (int j = 0; j < count; j++)
        join(parts[j], 4, out[j] + first);
}

/* ---- windows ---- */

/* Bit i: the lane behind lane i stands in the same cell. */
SIMD_INLINE uint64_t find_same(const lattice *l, uint32_t n)
{
    uint64_t same = 0;

    for (uint32_t i = 0; i < n; i += 16) {
        uint32_t other = 0;

        for (int axis = 0; axis < 3; axis++)
            other |= _mm512_cmpneq_epu32_mask(_mm512_loadu_si512(l->low[axis] + i), _mm512_loadu_si512(l->low[axis] + i + 1));
        same |= (uint64_t)(uint16_t)~other << i;
    }
    return same;
}

/* Bit i: lane i is at height 0 of its cell, and no number is infinite there. Where the points in the middle and at the ends are not,
 * others may be left out. */
SIMD_INLINE uint64_t find_level(const lattice *l, uint32_t n)
{
    const double *const height = l->inside[1];
    uint64_t level = 0;

    if (!l->near || (height[0] != 0.0 && height[n / 2] != 0.0 && height[n - 1] != 0.0))
        return 0;
    for (uint32_t i = 0; i < n; i += 8)
        level |= (uint64_t)_mm512_cmpeq_pd_mask(_mm512_load_pd(height + i), _mm512_setzero_pd()) << i;
    return level;
}

SIMD_INLINE void sum_windows(const noise_tables *t, const lattice *l, uint32_t n, int count, double *const out[])
{
    const uint64_t windows = 0x1111111111111111u & ~(uint64_t)0 >> (LANES_MAX - n), same = find_same(l, n), at_0 = find_level(l, n);
    const uint64_t level = windows & at_0 & at_0 >> 1 & at_0 >> 2 & at_0 >> 3, run = windows & same & same >> 1 & same >> 2;
    const uint64_t two = run & run >> 4 & same >> 3 & 0x0101010101010101u & ~level & ~(level >> 4);
    const uint64_t one = run & ~level & ~two & ~(two << 4);
    const double *from[CORNERS];

    for (uint64_t rest = two; rest; rest &= rest - 1) {
        find_corners(t, l, first_of64(rest), from);
        sum_eight(l, first_of64(rest), from, count, false, out);
    }
    for (uint64_t rest = one; rest; rest &= rest - 1) {
        find_corners(t, l, first_of64(rest), from);
        sum_four(l, first_of64(rest), from, count, false, out);
    }
    for (uint64_t rest = run & level; rest; rest &= rest - 1) {
        find_corners(t, l, first_of64(rest), from);
        sum_four(l, first_of64(rest), from, count, true, out);
    }
    for (uint64_t rest = windows & ~run & ~level; rest; rest &= rest - 1)
        sum_points_of(t, l, first_of64(rest), count, false, out);
    for (uint64_t rest = level & ~run; rest; rest &= rest - 1)
        sum_points_of(t, l, first_of64(rest), count, true, out);
}

#endif
