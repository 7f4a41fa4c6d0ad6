/* noise_runs.h - sums by 512 bits. Points that follow one another in one cell have the same numbers, and stand side by side. Where
 * points are level, at 0 of their cells, the corners above have no weight. */
#ifndef TEXTURE_NOISE_RUNS_H
#define TEXTURE_NOISE_RUNS_H

#include "texture/noise_sums.h"

/* Compilers would add up one sum behind the other, for which there are not registers enough. */
#define KEEP_ORDER(value) __asm__("" : "+v"(value))

/* Points are level along y, as those of floors, or along z, as those of images. Corners above add zeros, and so do heights of the
 * corners below. */
enum { NOT_LEVEL = 0, LEVEL_Y = 1, LEVEL_Z = 2 };
SIMD_INLINE bool is_above(int level, int corner) { return level != NOT_LEVEL && (corner >> level & 1); }
SIMD_INLINE bool is_height(int level, int part) { return level != NOT_LEVEL && part == level + 1; }

#define RUN sum_eight
#define RUN_LANES 8
#define RUN_LOAD _mm512_loadu_pd
#define RUN_STORE _mm512_mask_storeu_pd
#include "texture/noise_run.h"
#define RUN sum_four
#define RUN_LANES 4
#define RUN_LOAD _mm256_loadu_pd
#define RUN_STORE _mm256_mask_storeu_pd
#include "texture/noise_run.h"

/* ---- points by themselves ---- */

/* The sums of the four parts of each. */
SIMD_INLINE void join_parts(__m512d xy, __m256d z, uint32_t lane, int count, double *const out[])
{
    const __m256d two = _mm256_hadd_pd(_mm512_castpd512_pd256(xy), _mm512_extractf64x4_pd(xy, 1)), last = _mm256_hadd_pd(z, z);
    const __m128d both = _mm_add_pd(_mm256_castpd256_pd128(two), _mm256_extractf128_pd(two, 1));

    _mm_storel_pd(out[0] + lane, both);
    _mm_storeh_pd(out[1] + lane, both);
    if (count == 3)
        _mm_storel_pd(out[2] + lane, _mm_add_sd(_mm256_castpd256_pd128(last), _mm256_extractf128_pd(last, 1)));
}

/* Of two or three components; of the first two the parts stand in one vector. set_places() was called. */
SIMD_INLINE void sum_some(const noise_tables *t, const lattice *l, uint32_t lane, int count, int level, double *const out[])
{
    const __m512d place = _mm512_broadcast_f64x4(_mm256_load_pd(l->place[lane]));
    const corners all = corners_of(t, l, lane);
    __m512d xy = _mm512_setzero_pd();
    __m256d z = _mm256_setzero_pd();

#pragma GCC unroll 8
    for (int c = 0; c < CORNERS; c++) {
        const double *const from = numbers_at(&all, c);
        const __m512d corner = _mm512_broadcast_f64x4(_mm256_loadu_pd(noise_corner[c]));
        const __m512d by = _mm512_mul_pd(_mm512_sub_pd(place, corner), _mm512_set1_pd(l->half_weight[c][lane]));
        const __m512d more_xy = _mm512_mul_pd(by, _mm512_loadu_pd(from));
        const __m256d more_z = _mm256_mul_pd(_mm512_castpd512_pd256(by), _mm256_loadu_pd(from + 2 * PARTS));

        if (is_above(level, c))
            continue;
        xy = c == 0 ? more_xy : _mm512_add_pd(xy, more_xy);
        KEEP_ORDER(xy);
        if (count == 2)
            continue;
        z = c == 0 ? more_z : _mm256_add_pd(z, more_z);
        KEEP_ORDER(z);
    }
    join_parts(xy, z, lane, count, out);
}

SIMD_INLINE void sum_one(const noise_tables *t, const lattice *l, uint32_t lane, int level, double *out)
{
    const __m256d place = _mm256_setr_pd(1.0, l->inside[0][lane], l->inside[1][lane], l->inside[2][lane]);
    const corners all = corners_of(t, l, lane);
    __m256d sum = _mm256_setzero_pd(), pairs;

#pragma GCC unroll 8
    for (int c = 0; c < CORNERS; c++) {
        const __m256d by = _mm256_mul_pd(_mm256_sub_pd(place, _mm256_loadu_pd(noise_corner[c])), _mm256_set1_pd(l->half_weight[c][lane]));
        const __m256d more = _mm256_mul_pd(by, _mm256_loadu_pd(numbers_at(&all, c)));

        if (is_above(level, c))
            continue;
        sum = c == 0 ? more : _mm256_add_pd(sum, more);
    }
    pairs = _mm256_hadd_pd(sum, sum);
    _mm_storel_pd(out + lane, _mm_add_sd(_mm256_castpd256_pd128(pairs), _mm256_extractf128_pd(pairs, 1)));
}

/* ---- runs ---- */

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

/* Bit i: lane i is at 0 of its cell, and no number is infinite there. Where the points in the middle and at the ends are not,
 * others may be left out. */
SIMD_INLINE uint64_t find_level(const lattice *l, int axis, uint32_t n)
{
    const double *const height = l->inside[axis];
    uint64_t level = 0;

    if (!l->near || (height[0] != 0.0 && height[n / 2] != 0.0 && height[n - 1] != 0.0))
        return 0;
    for (uint32_t i = 0; i < n; i += 8)
        level |= (uint64_t)_mm512_cmpeq_pd_mask(_mm512_load_pd(height + i), _mm512_setzero_pd()) << i;
    return level;
}

/* Bits of lanes: where runs of six points or more begin, and of three to five, the fifth of which goes by itself; single points; and
 * what find_same() says within runs. */
typedef struct runs { uint64_t eights, fours, single, same; } runs;

/* Runs end where a multiple of eight lanes does. */
SIMD_INLINE runs find_runs(uint64_t same, uint32_t n)
{
    const uint64_t all = ~(uint64_t)0 >> (LANES_MAX - n), within = same & all >> 1 & 0x7f7f7f7f7f7f7f7fu, begin = all & ~(within << 1);
    const uint64_t two = begin & within, three = two & within >> 1, five = three & within >> 2 & within >> 3, six = five & within >> 4;
    const uint64_t of_two = two & ~three;

    return (runs){ six, three & ~six, (begin & ~two) | of_two | of_two << 1 | (five & ~six) << 4, within };
}

SIMD_INLINE uint32_t length_at(const runs *r, uint32_t lane) { return first_of64(~(r->same >> lane)) + 1; }

SIMD_INLINE void sum_runs_of(const noise_tables *t, const lattice *l, const runs *r, uint64_t lanes, int count, int level, double *const out[])
{
    const double *from[CORNERS];

    for (uint64_t rest = r->eights & lanes; rest; rest &= rest - 1) {
        const uint32_t lane = first_of64(rest);

        find_corners(t, l, lane, from);
        sum_eight(l, lane, length_at(r, lane), from, count, level, out);
    }
    for (uint64_t rest = r->fours & lanes; rest; rest &= rest - 1) {
        const uint32_t lane = first_of64(rest), length = length_at(r, lane);

        find_corners(t, l, lane, from);
        sum_four(l, lane, length < 4 ? length : 4, from, count, level, out);
    }
    for (uint64_t rest = r->single & lanes; rest; rest &= rest - 1)
        if (count == 1)
            sum_one(t, l, first_of64(rest), level, out[0]);
        else
            sum_some(t, l, first_of64(rest), count, level, out);
}

SIMD_INLINE void sum_runs(const noise_tables *t, lattice *l, uint32_t n, int count, double *const out[])
{
    const uint64_t by_y = find_level(l, 1, n), by_z = by_y ? 0 : find_level(l, 2, n), level = by_y | by_z;
    const runs r = find_runs(find_same(l, n) & ~(level ^ level >> 1), n);

    if (count > 1 && r.single)
        set_places(l, 1.0, n);
    if (~level)
        sum_runs_of(t, l, &r, ~level, count, NOT_LEVEL, out);
    if (by_y)
        sum_runs_of(t, l, &r, by_y, count, LEVEL_Y, out);
    if (by_z)
        sum_runs_of(t, l, &r, by_z, count, LEVEL_Z, out);
}

#endif
