/* noise_sums.h - noise is a sum over the corners of the cube that a point stands in: cubes by lane, and these sums. */
#ifndef TEXTURE_NOISE_SUMS_H
#define TEXTURE_NOISE_SUMS_H

#include "texture/noise.h"

#include <math.h>

/* Points of one cell go side by side where vectors hold eight of them. */
#if defined(__AVX512F__) && defined(__GNUC__) && !defined(POV_NARROW)
#define NOISE_RUNS 1
#else
#define NOISE_RUNS 0
#endif

/* ---- the cubes that points stand in ---- */

/* Numbers of a point that are added up side by side: one of four terms at each corner. */
enum { CORNERS = NOISE_CORNERS, PARTS = NOISE_PARTS };

/* The lattice's cells by axis; the corners' weights; places in the cells, and these by point where set_places() put them. */
enum { ROW = LANES_MAX + 16 };   /* rows have room for a whole vector from any lane on, and to look at the lane behind each */
typedef struct SIMD_ALIGNED lattice {
    double weight[CORNERS][ROW], inside[3][ROW];
    double place[LANES_MAX][PARTS];
    uint32_t low[3][ROW];
} lattice;

SIMD_INLINE double smooth(double u) { return u * u * (3.0 - 2.0 * u); }

/* What no 32-bit integer holds counts as the lowest one, as POV-Ray's conversion gives. */
SIMD_INLINE double limit(double whole) { return whole >= -2147483648.0 && whole < 2147483648.0 ? whole : -2147483648.0; }

SIMD_INLINE void set_weights(lattice *restrict out, uint32_t i, double x, double y, double z)
{
    const double x0 = 1.0 - x, y0 = 1.0 - y, z0 = 1.0 - z;

    out->weight[0][i] = x0 * y0 * z0;
    out->weight[1][i] = x * y0 * z0;
    out->weight[2][i] = x0 * y * z0;
    out->weight[3][i] = x * y * z0;
    out->weight[4][i] = x0 * y0 * z;
    out->weight[5][i] = x * y0 * z;
    out->weight[6][i] = x0 * y * z;
    out->weight[7][i] = x * y * z;
}

SIMD_INLINE void set_inside(lattice *restrict out, uint32_t i, double x, double y, double z)
{
    out->inside[0][i] = x;
    out->inside[1][i] = y;
    out->inside[2][i] = z;
    set_weights(out, i, smooth(x), smooth(y), smooth(z));
}

/* Behind `first`, which is 1/2 or 0. */
SIMD_INLINE void set_places(lattice *l, double first, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        l->place[i][0] = first;
        l->place[i][1] = l->inside[0][i];
        l->place[i][2] = l->inside[1][i];
        l->place[i][3] = l->inside[2][i];
    }
}

enum { CELL_MASK = NOISE_HASH - 1 };

SIMD_INLINE void set_cell(lattice *restrict out, int axis, uint32_t i, double whole)
{
    enum { SHIFT = 10000 };

    out->low[axis][i] = ((uint32_t)(int32_t)whole + SHIFT) & CELL_MASK;
}

/* near: is_near() said so. */
SIMD_INLINE void locate_lanes(const vec_lanes *restrict at, double scale, bool near, uint32_t n, lattice *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = at->x[i] * scale, y = at->y[i] * scale, z = at->z[i] * scale;
        const double xi = near ? floor(x) : limit(floor(x)), yi = near ? floor(y) : limit(floor(y)), zi = near ? floor(z) : limit(floor(z));

        set_cell(out, 0, i, xi);
        set_cell(out, 1, i, yi);
        set_cell(out, 2, i, zi);
        set_inside(out, i, x - xi, y - yi, z - zi);
    }
}

SIMD_CLONES static void locate_near(const vec_lanes *restrict at, double scale, uint32_t n, lattice *restrict out)
{
    locate_lanes(at, scale, true, n, out);
}

SIMD_CLONES static void locate_far(const vec_lanes *restrict at, double scale, uint32_t n, lattice *restrict out)
{
    locate_lanes(at, scale, false, n, out);
}

static void locate(const vec_lanes *at, double scale, bool near, uint32_t n, lattice *out)
{
    if (near)
        locate_near(at, scale, n, out);
    else
        locate_far(at, scale, n, out);
}

/* Do 32-bit integers hold the cells of all points, at this scale and at smaller ones? It is asked once for all octaves. */
SIMD_CLONES static bool is_near(const vec_lanes *restrict at, double scale, uint32_t n)
{
    const double most = 2147483000.0 / fabs(scale);
    int64_t near = -1;

    for (uint32_t i = 0; i < n; i++)
        near &= (fabs(at->x[i]) < most) & (fabs(at->y[i]) < most) & (fabs(at->z[i]) < most) ? -1 : 0;
    return near != 0;
}

/* ---- generators 1 and 2, vector noise ---- */

/* Where the numbers of each corner begin. */
SIMD_INLINE void find_corners(const noise_tables *t, const lattice *l, uint32_t lane, const double *from[CORNERS])
{
    const uint16_t *const hx = t->hash + l->low[0][lane];   /* and of the cell behind */
    const uint32_t y[2] = { l->low[1][lane], (l->low[1][lane] + 1) & CELL_MASK };
    const uint32_t z[2] = { l->low[2][lane], (l->low[2][lane] + 1) & CELL_MASK };
    const double *const copies = (const double *)(const void *)t->measured;   /* one behind the other */

    for (int c = 0; c < CORNERS / 2; c++) {
        const uint32_t hxy = t->hash[hx[c & 1] ^ y[c >> 1]];

        from[c] = copies + t->last[hxy ^ z[0]];
        from[c + 4] = copies + t->last[hxy ^ z[1]];
    }
}

/* Add the numbers of a corner, 4 of each component, times the place as it is seen from there and the corner's weight. */
SIMD_INLINE void add_corner(const lattice *l, uint32_t lane, int c, const double *restrict numbers, int count, double sum[][PARTS])
{
    double by[PARTS];

    for (int k = 0; k < PARTS; k++)
        by[k] = (l->place[lane][k] - noise_corner[c][k]) * l->weight[c][lane];
    for (int j = 0; j < count; j++)
        for (int k = 0; k < PARTS; k++)
            sum[j][k] = c == 0 ? by[k] * numbers[PARTS * j + k] : sum[j][k] + by[k] * numbers[PARTS * j + k];
}

/* The four parts of each component are yet to be added up: stored side by side, they become one vector. Corner by corner,
 * so that the components' sums do not wait for each other. */
SIMD_INLINE void sum_corners(const lattice *l, uint32_t lane, const double *const from[CORNERS], int count, double sum[][PARTS])
{
    add_corner(l, lane, 0, from[0], count, sum);
    add_corner(l, lane, 1, from[1], count, sum);
    add_corner(l, lane, 2, from[2], count, sum);
    add_corner(l, lane, 3, from[3], count, sum);
    add_corner(l, lane, 4, from[4], count, sum);
    add_corner(l, lane, 5, from[5], count, sum);
    add_corner(l, lane, 6, from[6], count, sum);
    add_corner(l, lane, 7, from[7], count, sum);
}

/* Sums of the parts of each point, four points at a time; there is room for whole vectors. */
SIMD_INLINE void join(double parts[][PARTS], uint32_t n, double *restrict out)
{
    for (uint32_t i = n; i < lanes_whole(n); i++)
        memcpy(parts[i], parts[n - 1], sizeof parts[i]);
#if defined(__AVX__)
    for (uint32_t i = 0; i < n; i += 4) {
        const __m256d ab = _mm256_hadd_pd(_mm256_load_pd(parts[i]), _mm256_load_pd(parts[i + 1]));
        const __m256d cd = _mm256_hadd_pd(_mm256_load_pd(parts[i + 2]), _mm256_load_pd(parts[i + 3]));

        _mm256_storeu_pd(out + i, _mm256_add_pd(_mm256_permute2f128_pd(ab, cd, 0x20), _mm256_permute2f128_pd(ab, cd, 0x31)));
    }
#else
    for (uint32_t i = 0; i < n; i++)
        out[i] = (parts[i][0] + parts[i][1]) + (parts[i][2] + parts[i][3]);
#endif
}

/* A point by itself, as films have one. */
static double sum_point(const noise_tables *t, lattice *l, uint32_t lane)
{
    const double *from[CORNERS];
    double sum[1][PARTS];

    set_places(l, 0.5, lane + 1);
    find_corners(t, l, lane, from);
    sum_corners(l, lane, from, 1, sum);
    return (sum[0][0] + sum[0][1]) + (sum[0][2] + sum[0][3]);
}

SIMD_CLONES static void sum_points(const noise_tables *t, lattice *l, uint32_t n, double *restrict out)
{
    SIMD_ALIGNED double parts[LANES_MAX][PARTS];

    set_places(l, 0.5, n);
    for (uint32_t i = 0; i < n; i++) {
        const double *from[CORNERS];
        double sum[1][PARTS];

        find_corners(t, l, i, from);
        sum_corners(l, i, from, 1, sum);
        memcpy(parts[i], sum[0], sizeof parts[i]);
    }
    join(parts, n, out);
}

#if NOISE_RUNS
/* ---- the same by 512 bits: points that follow one another in one cell have the same numbers, and stand side by side ---- */

/* Compilers would add up one sum behind the other, for which there are not registers enough. */
#define KEEP_ORDER(value) __asm__("" : "+v"(value))

/* Bit i: the lane behind lane i stands in another cell. */
SIMD_INLINE uint64_t find_ends(const lattice *l, uint32_t n)
{
    uint64_t ends = (uint64_t)1 << (n - 1);

    for (uint32_t i = 0; i < n; i += 16) {
        uint32_t other = 0;

        for (int axis = 0; axis < 3; axis++)
            other |= _mm512_cmpneq_epu32_mask(_mm512_loadu_si512(l->low[axis] + i), _mm512_loadu_si512(l->low[axis] + i + 1));
        ends |= (uint64_t)other << i;
    }
    return ends;
}

/* The first part is half a weight times a number: a weight times half the number is the same, but for what is so small that the
 * other corners' parts, whose weights add up to 1 with it, do not change by it. */
enum { HALVES = NOISE_COPIES * NOISE_COPY };

/* `count` components of eight lanes; of those that are not of the run too, whose turn comes later. */
SIMD_INLINE void sum_run(const lattice *l, uint32_t lane, const double *const from[CORNERS], int count, double sums[][ROW])
{
    const __m512d x = _mm512_loadu_pd(l->inside[0] + lane), y = _mm512_loadu_pd(l->inside[1] + lane);
    const __m512d z = _mm512_loadu_pd(l->inside[2] + lane), one = _mm512_set1_pd(1.0);
    const __m512d by_x[2] = { x, _mm512_sub_pd(x, one) }, by_y[2] = { y, _mm512_sub_pd(y, one) }, by_z[2] = { z, _mm512_sub_pd(z, one) };
    __m512d sum[3][PARTS];

#pragma GCC unroll 8
    for (int c = 0; c < CORNERS; c++) {
        const __m512d weight = _mm512_loadu_pd(l->weight[c] + lane);
        const __m512d by[PARTS] = { weight, _mm512_mul_pd(by_x[c & 1], weight),
                                    _mm512_mul_pd(by_y[c >> 1 & 1], weight), _mm512_mul_pd(by_z[c >> 2], weight) };

#pragma GCC unroll 3
        for (int j = 0; j < count; j++)
#pragma GCC unroll 4
            for (int k = 0; k < PARTS; k++) {
                const __m512d more = _mm512_mul_pd(by[k], _mm512_set1_pd(from[c][PARTS * j + k + (k == 0 ? HALVES : 0)]));

                sum[j][k] = c == 0 ? more : _mm512_add_pd(sum[j][k], more);
                KEEP_ORDER(sum[j][k]);
            }
    }
#pragma GCC unroll 3
    for (int j = 0; j < count; j++)
        _mm512_storeu_pd(sums[j] + lane, _mm512_add_pd(_mm512_add_pd(sum[j][0], sum[j][1]), _mm512_add_pd(sum[j][2], sum[j][3])));
}

/* The same of four lanes. */
SIMD_INLINE void sum_short_run(const lattice *l, uint32_t lane, const double *const from[CORNERS], int count, double sums[][ROW])
{
    const __m256d x = _mm256_loadu_pd(l->inside[0] + lane), y = _mm256_loadu_pd(l->inside[1] + lane);
    const __m256d z = _mm256_loadu_pd(l->inside[2] + lane), one = _mm256_set1_pd(1.0);
    const __m256d by_x[2] = { x, _mm256_sub_pd(x, one) }, by_y[2] = { y, _mm256_sub_pd(y, one) }, by_z[2] = { z, _mm256_sub_pd(z, one) };
    __m256d sum[3][PARTS];

#pragma GCC unroll 8
    for (int c = 0; c < CORNERS; c++) {
        const __m256d weight = _mm256_loadu_pd(l->weight[c] + lane);
        const __m256d by[PARTS] = { weight, _mm256_mul_pd(by_x[c & 1], weight),
                                    _mm256_mul_pd(by_y[c >> 1 & 1], weight), _mm256_mul_pd(by_z[c >> 2], weight) };

#pragma GCC unroll 3
        for (int j = 0; j < count; j++)
#pragma GCC unroll 4
            for (int k = 0; k < PARTS; k++) {
                const __m256d more = _mm256_mul_pd(by[k], _mm256_set1_pd(from[c][PARTS * j + k + (k == 0 ? HALVES : 0)]));

                sum[j][k] = c == 0 ? more : _mm256_add_pd(sum[j][k], more);
                KEEP_ORDER(sum[j][k]);
            }
    }
#pragma GCC unroll 3
    for (int j = 0; j < count; j++)
        _mm256_storeu_pd(sums[j] + lane, _mm256_add_pd(_mm256_add_pd(sum[j][0], sum[j][1]), _mm256_add_pd(sum[j][2], sum[j][3])));
}

SIMD_APART static void sum_short_run_of_one(const lattice *l, uint32_t lane, const double *const from[CORNERS], double sums[][ROW])
{
    sum_short_run(l, lane, from, 1, sums);
}

SIMD_APART static void sum_short_run_of_three(const lattice *l, uint32_t lane, const double *const from[CORNERS], double sums[][ROW])
{
    sum_short_run(l, lane, from, 3, sums);
}

/* Of one point: the parts of three components, of the first two in one vector. */
SIMD_INLINE void sum_point_of_three(const noise_tables *t, const lattice *l, uint32_t lane, double parts[][LANES_MAX][PARTS])
{
    const __m512d place = _mm512_broadcast_f64x4(_mm256_load_pd(l->place[lane]));
    const double *from[CORNERS];
    __m512d xy = _mm512_setzero_pd();
    __m256d z = _mm256_setzero_pd();

    find_corners(t, l, lane, from);
#pragma GCC unroll 8
    for (int c = 0; c < CORNERS; c++) {
        const __m512d corner = _mm512_broadcast_f64x4(_mm256_loadu_pd(noise_corner[c]));
        const __m512d by = _mm512_mul_pd(_mm512_sub_pd(place, corner), _mm512_set1_pd(l->weight[c][lane]));
        const __m512d more_xy = _mm512_mul_pd(by, _mm512_loadu_pd(from[c]));
        const __m256d more_z = _mm256_mul_pd(_mm512_castpd512_pd256(by), _mm256_loadu_pd(from[c] + 2 * PARTS));

        xy = c == 0 ? more_xy : _mm512_add_pd(xy, more_xy);
        z = c == 0 ? more_z : _mm256_add_pd(z, more_z);
        KEEP_ORDER(xy);
        KEEP_ORDER(z);
    }
    _mm256_store_pd(parts[0][lane], _mm512_castpd512_pd256(xy));
    _mm256_store_pd(parts[1][lane], _mm512_extractf64x4_pd(xy, 1));
    _mm256_store_pd(parts[2][lane], z);
}

/* Run by run, each of eight lanes at most. */
SIMD_INLINE void sum_runs(const noise_tables *t, const lattice *l, uint32_t n, uint64_t ends, int count, double *const out[])
{
    SIMD_ALIGNED double sums[3][ROW];
    const double *from[CORNERS];
    bool begins = true;

    for (uint32_t i = 0; i < n;) {
        if (begins)
            find_corners(t, l, i, from);
        if (ends >> i & 15 && count == 1)
            sum_short_run_of_one(l, i, from, sums);
        else if (ends >> i & 15)
            sum_short_run_of_three(l, i, from, sums);
        else
            sum_run(l, i, from, count, sums);
        begins = (ends >> i & 255) != 0;
        i += first_of((uint32_t)(ends >> i) | 128) + 1;
    }
    for (int j = 0; j < count; j++)
        for (uint32_t i = 0; i < n; i += 4)
            _mm256_storeu_pd(out[j] + i, _mm256_load_pd(sums[j] + i));
}

/* So much takes less time by runs: a run is as three points. */
SIMD_INLINE bool are_runs_long(uint64_t ends, uint32_t n) { return 5 * (uint32_t)__builtin_popcountll(ends) < 2 * n; }

static void sum_scalar(const noise_tables *t, lattice *l, uint32_t n, double *restrict out)
{
    const uint64_t ends = n > 1 ? find_ends(l, n) : 1;
    double *const to[] = { out };

    if (n == 1)
        out[0] = sum_point(t, l, 0);
    else if (are_runs_long(ends, n))
        sum_runs(t, l, n, ends, 1, to);
    else
        sum_points(t, l, n, out);
}

static void sum_vector(const noise_tables *t, lattice *l, uint32_t n, vec_lanes *restrict out)
{
    SIMD_ALIGNED double parts[3][LANES_MAX][PARTS];
    const uint64_t ends = find_ends(l, n);
    double *const to[] = { out->x, out->y, out->z };

    if (are_runs_long(ends, n)) {
        sum_runs(t, l, n, ends, 3, to);
        return;
    }
    set_places(l, 0.5, n);
    for (uint32_t i = 0; i < n; i++)
        sum_point_of_three(t, l, i, parts);
    for (int j = 0; j < 3; j++)
        join(parts[j], n, to[j]);
}
#else
static void sum_scalar(const noise_tables *t, lattice *l, uint32_t n, double *out)
{
    if (n == 1)
        out[0] = sum_point(t, l, 0);
    else
        sum_points(t, l, n, out);
}

SIMD_CLONES static void sum_vector(const noise_tables *t, lattice *l, uint32_t n, vec_lanes *restrict out)
{
    SIMD_ALIGNED double parts[3][LANES_MAX][PARTS];

    set_places(l, 0.5, n);
    for (uint32_t i = 0; i < n; i++) {
        const double *from[CORNERS];
        double sum[3][PARTS];

        find_corners(t, l, i, from);
        sum_corners(l, i, from, 3, sum);
        for (int j = 0; j < 3; j++)
            memcpy(parts[j][i], sum[j], sizeof parts[j][i]);
    }
    join(parts[0], n, out->x);
    join(parts[1], n, out->y);
    join(parts[2], n, out->z);
}
#endif

/* ---- generator 3 ---- */

/* The shift is so large that it rounds the points: values keep steps of 2^-29 in them. */
SIMD_INLINE double shifted(double at, double scale) { return at * scale + 10000000.023157213; }

SIMD_INLINE double whole_of(double v)
{
    const double down = floor(v);

    return limit(v < 0.0 && down < v ? down + 1.0 : down);
}

SIMD_CLONES static void locate_3(const vec_lanes *restrict at, double scale, uint32_t n, lattice *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = shifted(at->x[i], scale), y = shifted(at->y[i], scale), z = shifted(at->z[i], scale);
        const double xi = whole_of(x), yi = whole_of(y), zi = whole_of(z);

        out->low[0][i] = (uint32_t)(int32_t)xi;
        out->low[1][i] = (uint32_t)(int32_t)yi;
        out->low[2][i] = (uint32_t)(int32_t)zi;
        set_inside(out, i, x - xi, y - yi, z - zi);
    }
}

SIMD_INLINE void find_corners_3(const noise_tables *t, const lattice *l, uint32_t lane, const double *from[CORNERS])
{
    enum { MASK = NOISE_GRADIENTS - 1 };
    const uint32_t x = l->low[0][lane], y = l->low[1][lane], z = l->low[2][lane];

    for (uint32_t c = 0; c < CORNERS; c++) {
        const uint32_t a = t->order[(x + (c & 1)) & MASK], b = t->order[(a + y + (c >> 1 & 1)) & MASK];

        from[c] = t->gradient[(b + z + (c >> 2)) & MASK];
    }
}

SIMD_CLONES static void sum_gradients(const noise_tables *t, lattice *l, uint32_t n, double *restrict out)
{
    SIMD_ALIGNED double parts[LANES_MAX][PARTS];

    set_places(l, 0.0, n);
    for (uint32_t i = 0; i < n; i++) {
        const double *from[CORNERS];
        double sum[1][PARTS];

        find_corners_3(t, l, i, from);
        sum_corners(l, i, from, 1, sum);
        memcpy(parts[i], sum[0], sizeof parts[i]);
    }
    join(parts, n, out);
}

#endif
