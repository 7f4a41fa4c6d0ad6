/* noise_sums.h - noise is a sum over the corners of the cube that a point stands in: cubes by lane, and these sums. */
#ifndef TEXTURE_NOISE_SUMS_H
#define TEXTURE_NOISE_SUMS_H

#include "texture/noise.h"

#include <math.h>

/* Points of one cell go side by side where vectors hold eight of them: see noise_runs.h. */
#if defined(__AVX512F__) && defined(__GNUC__) && !defined(POV_NARROW)
#define NOISE_RUNS 1
#else
#define NOISE_RUNS 0
#endif

/* ---- the cubes that points stand in ---- */

/* Numbers of a point that are added up side by side: one of four terms at each corner. The first is half the corner's weight times a
 * number, the others are the weight times a coordinate times a number: half the weight times twice the coordinate is the same. */
enum { CORNERS = NOISE_CORNERS, PARTS = NOISE_PARTS };

/* The lattice's cells by axis; half the corners' weights; twice the places in the cells, and these by point where set_places() put
 * them. */
enum { ROW = LANES_MAX + 16 };   /* rows have room for a whole vector from any lane on, and to look at the lane behind each */
typedef struct SIMD_ALIGNED lattice {
    double half_weight[CORNERS][ROW], inside[3][ROW];
    double place[LANES_MAX][PARTS];
    uint32_t low[3][ROW];
    bool near;                   /* is_near() said so: what is inside is in 0..2 */
} lattice;

/* Runs take whole vectors from any lane on, past the first n, which locate() sets. What stands there is not used, but must not be what is
 * left from elsewhere: numbers that are subnormal take a hundred times as long. */
SIMD_INLINE void clear_behind(lattice *l, uint32_t n)
{
    for (int c = 0; NOISE_RUNS && c < CORNERS; c++)
        memset(l->half_weight[c] + n, 0, 8 * sizeof **l->half_weight);
    for (int axis = 0; NOISE_RUNS && axis < 3; axis++)
        memset(l->inside[axis] + n, 0, 8 * sizeof **l->inside);
}

/* Half of 3 u^2 - 2 u^3. */
SIMD_INLINE double half_smooth(double u) { return u * u * (1.5 - u); }

/* What no 32-bit integer holds counts as the lowest one, as POV-Ray's conversion gives. */
SIMD_INLINE double limit(double whole) { return whole >= -2147483648.0 && whole < 2147483648.0 ? whole : -2147483648.0; }

/* half_x: half of what the corners behind have of the weight along x. */
SIMD_INLINE void set_weights(lattice *restrict out, uint32_t i, double half_x, double y, double z)
{
    const double half_x0 = 0.5 - half_x, y0 = 1.0 - y, z0 = 1.0 - z;

    out->half_weight[0][i] = half_x0 * y0 * z0;
    out->half_weight[1][i] = half_x * y0 * z0;
    out->half_weight[2][i] = half_x0 * y * z0;
    out->half_weight[3][i] = half_x * y * z0;
    out->half_weight[4][i] = half_x0 * y0 * z;
    out->half_weight[5][i] = half_x * y0 * z;
    out->half_weight[6][i] = half_x0 * y * z;
    out->half_weight[7][i] = half_x * y * z;
}

SIMD_INLINE void set_inside(lattice *restrict out, uint32_t i, double x, double y, double z)
{
    out->inside[0][i] = 2.0 * x;
    out->inside[1][i] = 2.0 * y;
    out->inside[2][i] = 2.0 * z;
    set_weights(out, i, half_smooth(x), 2.0 * half_smooth(y), 2.0 * half_smooth(z));
}

/* Behind `first`, which is 1 or 0. */
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
    out->near = near;            /* first, it would keep compilers from making those loops vectors */
}

/* Do 32-bit integers hold the cells of all points, at this scale and at smaller ones? It is asked once for all octaves. */
SIMD_CLONES static bool is_near(const vec_lanes *restrict at, double scale, uint32_t n)
{
    const double most = 2147483000.0 / fabs(scale);
    int64_t near = -1;

    for (uint32_t i = 0; i < n; i++)
        near &= ((fabs(at->x[i]) < most) & (fabs(at->y[i]) < most) & (fabs(at->z[i]) < most)) ? -1 : 0;
    return near != 0;
}

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

/* ---- sums ---- */

/* The corners of a cube: hashes of their x and y, and z below and above. */
typedef struct corners { const noise_tables *of; size_t hash[CORNERS / 2], z[2]; } corners;

SIMD_INLINE corners corners_of(const noise_tables *t, const lattice *l, uint32_t lane)
{
    const size_t x = l->low[0][lane], y0 = l->low[1][lane], z0 = l->low[2][lane], y1 = (y0 + 1) & CELL_MASK;
    const size_t low = t->hash[x], high = t->hash[x + 1];

    return (corners){ t, { t->hash[low ^ y0], t->hash[high ^ y0], t->hash[low ^ y1], t->hash[high ^ y1] }, { z0, (z0 + 1) & CELL_MASK } };
}

/* Where the numbers of a corner begin. It is asked as they are needed: the places of all would take more registers than there are. */
SIMD_INLINE const double *numbers_at(const corners *of, int c)
{
    const double *const copies = (const double *)(const void *)of->of->measured;   /* one behind the other */

    return copies + of->of->last[of->hash[c % (CORNERS / 2)] ^ of->z[c / (CORNERS / 2)]];
}

SIMD_INLINE void find_corners(const noise_tables *t, const lattice *l, uint32_t lane, const double *from[CORNERS])
{
    const corners all = corners_of(t, l, lane);

    for (int c = 0; c < CORNERS; c++)
        from[c] = numbers_at(&all, c);
}

/* Of generator 3. */
SIMD_INLINE void find_corners_3(const noise_tables *t, const lattice *l, uint32_t lane, const double *from[CORNERS])
{
    enum { MASK = NOISE_GRADIENTS - 1 };
    const uint32_t x = l->low[0][lane], y = l->low[1][lane], z = l->low[2][lane];

    for (uint32_t c = 0; c < CORNERS; c++) {
        const uint32_t a = t->order[(x + (c & 1)) & MASK], b = t->order[(a + y + (c >> 1 & 1)) & MASK];

        from[c] = t->gradient[(b + z + (c >> 2)) & MASK];
    }
}

/* Add the numbers of a corner, 4 of each component, times the place as it is seen from there and the corner's weight. */
SIMD_INLINE void add_corner(const lattice *l, uint32_t lane, int c, const double *restrict numbers, int count, double sum[][PARTS])
{
    double by[PARTS];

    for (int k = 0; k < PARTS; k++)
        by[k] = (l->place[lane][k] - noise_corner[c][k]) * l->half_weight[c][lane];
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

/* `count` components, of gradients or of measured numbers. */
SIMD_INLINE void sum_components(const noise_tables *t, lattice *l, uint32_t n, bool of_gradients, int count,
                                double parts[][LANES_MAX][PARTS], double *const out[])
{
    set_places(l, of_gradients ? 0.0 : 1.0, n);
    for (uint32_t i = 0; i < n; i++) {
        const double *from[CORNERS];
        double sum[3][PARTS];

        if (of_gradients)
            find_corners_3(t, l, i, from);
        else
            find_corners(t, l, i, from);
        sum_corners(l, i, from, count, sum);
        for (int j = 0; j < count; j++)
            memcpy(parts[j][i], sum[j], sizeof parts[j][i]);
    }
    for (int j = 0; j < count; j++)
        join(parts[j], n, out[j]);
}

SIMD_CLONES static void sum_gradients(const noise_tables *t, lattice *l, uint32_t n, double *restrict out)
{
    SIMD_ALIGNED double parts[1][LANES_MAX][PARTS];
    double *const to[] = { out };

    sum_components(t, l, n, true, 1, parts, to);
}

/* A point by itself, as films have one. */
static double sum_point(const noise_tables *t, lattice *l, uint32_t lane)
{
    const double *from[CORNERS];
    double sum[1][PARTS];

    set_places(l, 1.0, lane + 1);
    find_corners(t, l, lane, from);
    sum_corners(l, lane, from, 1, sum);
    return (sum[0][0] + sum[0][1]) + (sum[0][2] + sum[0][3]);
}

#if NOISE_RUNS
#include "texture/noise_runs.h"

static void sum_scalar(const noise_tables *t, lattice *l, uint32_t n, double *restrict out)
{
    double *const to[] = { out };

    if (n == 1)
        out[0] = sum_point(t, l, 0);
    else
        sum_runs(t, l, n, 1, to);
}

static void sum_vector(const noise_tables *t, lattice *l, uint32_t n, vec_lanes *restrict out)
{
    double *const to[] = { out->x, out->y, out->z };

    sum_runs(t, l, n, 3, to);
}

/* x and y alone. */
static void sum_flat(const noise_tables *t, lattice *l, uint32_t n, vec_lanes *restrict out)
{
    double *const to[] = { out->x, out->y };

    sum_runs(t, l, n, 2, to);
}
#else
SIMD_CLONES static void sum_points(const noise_tables *t, lattice *l, uint32_t n, double *restrict out)
{
    SIMD_ALIGNED double parts[1][LANES_MAX][PARTS];
    double *const to[] = { out };

    sum_components(t, l, n, false, 1, parts, to);
}

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
    double *const to[] = { out->x, out->y, out->z };

    sum_components(t, l, n, false, 3, parts, to);
}

/* x and y alone. */
SIMD_CLONES static void sum_flat(const noise_tables *t, lattice *l, uint32_t n, vec_lanes *restrict out)
{
    SIMD_ALIGNED double parts[2][LANES_MAX][PARTS];
    double *const to[] = { out->x, out->y };

    sum_components(t, l, n, false, 2, parts, to);
}
#endif

#endif
