#include "base/elementary.h"
#include "texture/cube.h"
#include "texture/pattern.h"

#include <stdlib.h>

/* A random point in each cube of side 1; the value is a sum over the distances to the three nearest ones.
 *
 * The points of the 27 cubes around a cube are made once for all lanes in it. Only where a distance that counts is larger
 * than that to the next layer of cubes are these searched too. */
typedef struct crackle {
    pov_vec3 form;
    double metric, offset;
    bool solid;
} crackle;

/* Points relative to the lowest corner of the cube in the middle. */
enum { CUBES = 27, NEAREST = 3, BUFFER = 32, FEW = 3 };
typedef struct neighbourhood { double x[CUBES], y[CUBES], z[CUBES]; } neighbourhood;

/* Numbers of the three cubes along an axis. */
SIMD_INLINE void find_cubes(double middle, uint32_t out[3])
{
    const uint32_t mask = NOISE_HASH - 1, first = (uint32_t)cube_of(middle) + mask;

    for (uint32_t i = 0; i < 3; i++)
        out[i] = (first + i) & mask;
}

/* Rows and planes of cubes are hashed once. */
SIMD_INLINE void fill(const noise_tables *t, pov_vec3 corner, neighbourhood *out)
{
    uint32_t x[3], y[3], z[3];
    int at = 0;

    find_cubes(corner.x, x);
    find_cubes(corner.y, y);
    find_cubes(corner.z, z);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const uint32_t row = t->hash[t->hash[x[i]] ^ y[j]];

            for (int k = 0; k < 3; k++, at++) {
                const double *random = &t->cell[t->hash[row ^ z[k]]];

                out->x[at] = i - 1 + random[0];
                out->y[at] = j - 1 + random[1];
                out->z[at] = k - 1 + random[2];
            }
        }
}

/* ---- distances ---- */

/* What is compared: the square, the sum, or the sum of powers of the components. */
SIMD_INLINE double measure(double metric, double x, double y, double z)
{
    if (metric == 2.0)
        return (x * x + y * y) + z * z;
    if (metric == 1.0)
        return (fabs(x) + fabs(y)) + fabs(z);
    return (elementary_pow(fabs(x), metric) + elementary_pow(fabs(y), metric)) + elementary_pow(fabs(z), metric);
}

SIMD_INLINE double distance(const crackle *c, double metric, double measured)
{
    if (metric == 2.0)
        return sqrt(measured + c->offset * c->offset);
    if (metric == 1.0)
        return measured + c->offset;
    return elementary_pow(c->offset == 0.0 ? measured : measured + elementary_pow(c->offset, metric), 1.0 / metric);
}

SIMD_INLINE double smaller(double a, double b) { return a < b ? a : b; }
SIMD_INLINE double larger(double a, double b) { return a > b ? a : b; }

SIMD_INLINE void put_one(double least[NEAREST], double a)
{
    const double b = larger(least[0], a), d = larger(least[1], b);

    least[0] = smaller(least[0], a);
    least[1] = smaller(least[1], b);
    least[2] = smaller(least[2], d);
}

/* Lanes in one cube: which they are, their places in it, and the smallest distances, in order. */
typedef struct members {
    vec_lanes at;
    SIMD_ALIGNED double least[NEAREST][LANES_MAX];
    uint8_t lane[LANES_MAX];
    uint32_t n;
} members;

/* The third one is left out where it does not count. */
SIMD_INLINE void put_point(double metric, int last, double x, double y, double z, uint32_t n, members *restrict m)
{
    double *restrict first = m->least[0], *restrict second = m->least[1], *restrict third = m->least[2];

    for (uint32_t i = 0; i < n; i++) {
        const double a = measure(metric, x - m->at.x[i], y - m->at.y[i], z - m->at.z[i]);
        const double b = larger(first[i], a);

        first[i] = smaller(first[i], a);
        if (last > 1)
            third[i] = smaller(third[i], larger(second[i], b));
        second[i] = smaller(second[i], b);
    }
}

SIMD_INLINE void find_least(double metric, int last, const neighbourhood *near, members *m)
{
    const uint32_t n = lanes_whole(m->n);

    for (int k = 0; k < NEAREST; k++)
        for (uint32_t i = 0; i < n; i++)
            m->least[k][i] = HUGE_VAL;
    for (int c = 0; c < CUBES; c++)
        put_point(metric, last, near->x[c], near->y[c], near->z[c], n, m);
}

/* The same of one lane: the points stand side by side instead. */
SIMD_INLINE void find_least_alone(const neighbourhood *near, uint32_t i, members *m)
{
    const pov_vec3 at = lanes_at(&m->at, i);
    double square[CUBES], least[NEAREST] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };

    for (int c = 0; c < CUBES; c++)
        square[c] = measure(2.0, near->x[c] - at.x, near->y[c] - at.y, near->z[c] - at.z);
    for (int c = 0; c < CUBES; c++)
        put_one(least, square[c]);
    for (int k = 0; k < NEAREST; k++)
        m->least[k][i] = least[k];
}

/* ---- other metrics ---- */

/* Their distances d take powers, and lie between the usual distance e and e times this one: d <= e <= d f for metrics above
 * 2, e <= d <= e f for those below. So points that are farther than the last one that counts by more than f do not count. The
 * square, and a little more, as both are rounded. */
static double spread_of(double metric)
{
    return metric > 0.0 ? elementary_pow(3.0, fabs(1.0 - 2.0 / metric)) * (1.0 + 0x1p-20) : HUGE_VAL;
}

/* Vectors to the points that may count. The rest of a vector repeats the last one. */
typedef struct candidates {
    SIMD_ALIGNED double x[BUFFER];
    SIMD_ALIGNED double y[BUFFER];
    SIMD_ALIGNED double z[BUFFER];
    uint32_t n;
} candidates;

SIMD_INLINE void choose(double spread, int last, const neighbourhood *near, pov_vec3 at, candidates *out)
{
    double square[CUBES], least[NEAREST] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
    uint32_t n = 0;

    for (int c = 0; c < CUBES; c++)
        square[c] = measure(2.0, near->x[c] - at.x, near->y[c] - at.y, near->z[c] - at.z);
    for (int c = 0; c < CUBES; c++)
        put_one(least, square[c]);
    for (int c = 0; c < CUBES; c++) {
        out->x[n] = near->x[c] - at.x;
        out->y[n] = near->y[c] - at.y;
        out->z[n] = near->z[c] - at.z;
        n += !(square[c] > least[last] * spread);
    }
    out->n = n;
    for (uint32_t i = n; i < lanes_whole(n); i++) {
        out->x[i] = out->x[n - 1];
        out->y[i] = out->y[n - 1];
        out->z[i] = out->z[n - 1];
    }
}

SIMD_INLINE void find_least_other(double metric, double spread, int last, const neighbourhood *near, members *m)
{
    for (uint32_t i = 0; i < m->n; i++) {
        SIMD_ALIGNED double measured[BUFFER];
        double least[NEAREST] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
        candidates some;

        choose(spread, last, near, lanes_at(&m->at, i), &some);
        for (uint32_t k = 0; k < lanes_whole(some.n); k++)
            measured[k] = measure(metric, some.x[k], some.y[k], some.z[k]);
        for (uint32_t k = 0; k < some.n; k++)
            put_one(least, measured[k]);
        for (int k = 0; k < NEAREST; k++)
            m->least[k][i] = least[k];
    }
}

/* ---- the cubes behind the neighbours ---- */

SIMD_INLINE double margin(double f) { return f < 0.5 ? f : 1.0 - f; }

/* Distance, in the measure, within which no point of a cube behind the neighbours lies. */
SIMD_INLINE double reach_of(double metric, pov_vec3 f)
{
    const double reach = 1.0 + smaller(margin(f.x), smaller(margin(f.y), margin(f.z)));

    return measure(metric, reach, 0.0, 0.0);
}

/* From a point to the nearest side of the cubes whose number, from the point's own on, is i. */
static double gap(int i, double f)
{
    return i < 0 ? f - (i + 1) : i > 0 ? i - f : 0.0;
}

/* Cubes that are too far away to count are left out. */
SIMD_NOINLINE static void search_shell(const noise_tables *t, double metric, int last, pov_vec3 corner, pov_vec3 f,
                                       double least[NEAREST])
{
    for (int i = -2; i <= 2; i++)
        for (int j = -2; j <= 2; j++)
            for (int k = -2; k <= 2; k++) {
                const double *random;

                if ((abs(i) < 2 && abs(j) < 2 && abs(k) < 2) ||
                    measure(metric, gap(i, f.x), gap(j, f.y), gap(k, f.z)) > least[last])
                    continue;
                random = &t->cell[noise_hash(t, cube_of(corner.x + i), cube_of(corner.y + j), cube_of(corner.z + k))];
                put_one(least, measure(metric, i + random[0] - f.x, j + random[1] - f.y, k + random[2] - f.z));
            }
}

/* ---- the pattern ---- */

static inline pov_vec3 corner_of(pov_vec3 p) { return pov_vec3_of(floor(p.x), floor(p.y), floor(p.z)); }

SIMD_INLINE double value_of(const crackle *c, double metric, const double least[NEAREST])
{
    double value = c->form.x * distance(c, metric, least[0]);

    if (c->form.y != 0.0)
        value = value + c->form.y * distance(c, metric, least[1]);
    if (c->form.z != 0.0)
        value = value + c->form.z * distance(c, metric, least[2]);
    return value < 0.0 ? 0.0 : value > 1.0 ? 1.0 : value;
}

SIMD_INLINE void find_corners(const vec_lanes *restrict at, uint32_t n, vec_lanes *restrict corner)
{
    for (uint32_t i = 0; i < n; i++)
        lanes_put(corner, i, corner_of(lanes_at(at, i)));
}

/* Those of the lanes that are in this cube. The rest of a vector repeats the last one. */
static uint64_t collect(const vec_lanes *at, const vec_lanes *corner, pov_vec3 of, uint64_t lanes, members *out)
{
    uint64_t found = 0;
    uint32_t n = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = first_of64(lanes);

        if (corner->x[i] != of.x || corner->y[i] != of.y || corner->z[i] != of.z)
            continue;
        out->lane[n] = (uint8_t)i;
        lanes_put(&out->at, n++, pov_sub(lanes_at(at, i), of));
        found |= (uint64_t)1 << i;
    }
    out->n = n;
    for (uint32_t i = n; i < lanes_whole(n); i++)
        lanes_put(&out->at, i, lanes_at(&out->at, n - 1));
    return found;
}

SIMD_INLINE void put_values(const pattern_input *in, double metric, int last, pov_vec3 corner, const members *m, double *value)
{
    for (uint32_t i = 0; i < m->n; i++) {
        const pov_vec3 f = lanes_at(&m->at, i);
        double least[NEAREST] = { m->least[0][i], m->least[1][i], m->least[2][i] };

        if (least[last] > reach_of(metric, f))
            search_shell(in->noise, metric, last, corner, f, least);
        value[m->lane[i]] = value_of(in->of->self, metric, least);
    }
}

/* usual: the metric is 2. last: of the three distances, the last that counts. A lane that is not a number is in no cube. */
SIMD_INLINE void find_values(const pattern_input *in, bool usual, double metric, int last, double *value)
{
    const double spread = usual ? 1.0 : spread_of(metric);
    vec_lanes corners;
    neighbourhood near;
    members m;

    find_corners(in->at, lanes_whole(in->n), &corners);
    for (uint64_t rest = ~(uint64_t)0 >> (64 - in->n); rest;) {
        const uint32_t first = first_of64(rest);
        const pov_vec3 corner = lanes_at(&corners, first);
        const uint64_t found = collect(in->at, &corners, corner, rest, &m);

        value[first] = 0.0;
        fill(in->noise, corner, &near);
        if (usual && m.n <= FEW)
            for (uint32_t i = 0; i < m.n; i++)
                find_least_alone(&near, i, &m);
        else if (usual)
            find_least(metric, last, &near, &m);
        else
            find_least_other(metric, spread, last, &near, &m);
        put_values(in, metric, last, corner, &m, value);
        rest &= ~(found | (uint64_t)1 << first);
    }
}

/* The usual metric with two distances and with three, and all else. */
SIMD_CLONES static void find_two(const pattern_input *in, double *value) { find_values(in, true, 2.0, 1, value); }
SIMD_CLONES static void find_three(const pattern_input *in, double *value) { find_values(in, true, 2.0, 2, value); }
SIMD_CLONES static void find_other(const pattern_input *in, double metric, int last, double *value)
{
    find_values(in, false, metric, last, value);
}

/* The nearest point so far, and the distance to it, in the measure. */
typedef struct found_point { double least; pov_vec3 at; } found_point;

/* Ask the cubes around a point, or those behind these. */
static void ask_cubes(const noise_tables *t, double metric, pov_vec3 corner, pov_vec3 f, bool behind, found_point *out)
{
    for (int i = -2; i <= 2; i++)
        for (int j = -2; j <= 2; j++)
            for (int k = -2; k <= 2; k++) {
                const double *random;
                double measured;

                if (behind != (abs(i) == 2 || abs(j) == 2 || abs(k) == 2))
                    continue;
                random = &t->cell[noise_hash(t, cube_of(corner.x + i), cube_of(corner.y + j), cube_of(corner.z + k))];
                measured = measure(metric, i + random[0] - f.x, j + random[1] - f.y, k + random[2] - f.z);
                if (measured < out->least) {
                    out->least = measured;
                    out->at = pov_vec3_of(corner.x + i + random[0], corner.y + j + random[1], corner.z + k + random[2]);
                }
            }
}

static pov_vec3 nearest(const noise_tables *t, double metric, pov_vec3 p)
{
    const pov_vec3 corner = corner_of(p), f = pov_sub(p, corner);
    found_point best = { HUGE_VAL, p };

    ask_cubes(t, metric, corner, f, false, &best);
    if (best.least > reach_of(metric, f))
        ask_cubes(t, metric, corner, f, true, &best);
    return best.at;
}

pov_vec3 cube_nearest(const noise_tables *t, pov_vec3 at)
{
    return nearest(t, 2.0, at);
}

static void evaluate(const pattern_input *in, double *value)
{
    const crackle *c = in->of->self;

    if (!c->solid && c->metric != 2.0)
        find_other(in, c->metric, c->form.z != 0.0 ? 2 : 1, value);
    else if (!c->solid)
        (c->form.z != 0.0 ? find_three : find_two)(in, value);
    if (!c->solid)
        return;
    for (uint32_t i = 0; i < in->n; i++)
        value[i] = noise_value_at(in->noise, in->generator, nearest(in->noise, c->metric, lanes_at(in->at, i)));
}

static const crackle usual = { { -1.0, 1.0, 0.0 }, 2.0, 0.0, false };
static const pattern_word words[] = {
    { "form", PATTERN_VECTOR, offsetof(crackle, form), false },
    { "metric", PATTERN_NUMBER, offsetof(crackle, metric), false },
    { "offset", PATTERN_NUMBER, offsetof(crackle, offset), false },
    { "solid", PATTERN_FLAG, offsetof(crackle, solid), false },
};

const pattern_class pattern_crackle = {
    .keyword = "crackle",
    .self_size = sizeof(crackle),
    .self = &usual,
    .words = words,
    .word_count = sizeof words / sizeof words[0],
    .flags = PATTERN_NEEDS_NOISE,
    .evaluate = evaluate,
};
