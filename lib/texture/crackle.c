#include "base/elementary.h"
#include "base/powers.h"
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

/* Powers of up to `count` numbers, with room for whole vectors behind them. */
static void raise(double exponent, uint32_t count, double *value)
{
    const uint32_t whole = (count + 7) & ~7u;

    for (uint32_t i = count; i < whole; i++)
        value[i] = 1.0;
    for (uint32_t i = 0; i < whole; i += LANES_MAX)
        powers_raise(exponent, whole - i < LANES_MAX ? whole - i : LANES_MAX, value + i);
}

/* What a component of this size counts for in a measure. */
SIMD_INLINE void find_parts(double metric, uint32_t n, double *value)
{
    if (metric == 2.0)
        for (uint32_t i = 0; i < n; i++)
            value[i] = value[i] * value[i];
    else if (metric != 1.0)
        raise(metric, n, value);
}

/* Distances, from what was measured. */
SIMD_INLINE void find_distances(const crackle *c, double metric, uint32_t n, double *value)
{
    if (metric == 2.0) {
        for (uint32_t i = 0; i < n; i++)
            value[i] = sqrt(value[i] + c->offset * c->offset);
        return;
    }
    if (metric == 1.0 || c->offset != 0.0) {
        const double more = metric == 1.0 ? c->offset : elementary_pow(c->offset, metric);

        for (uint32_t i = 0; i < n; i++)
            value[i] = value[i] + more;
    }
    if (metric != 1.0)
        raise(1.0 / metric, n, value);
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

/* Sizes of the components of vectors to points that may count, one vector behind the other, and where those of each lane end. */
typedef struct candidates {
    SIMD_ALIGNED double size[3 * LANES_MAX];
    uint32_t end[LANES_MAX], n;
} candidates;

SIMD_INLINE void choose(double spread, int last, const neighbourhood *near, pov_vec3 at, candidates *out)
{
    double square[CUBES], least[NEAREST] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
    uint32_t chosen = 0;

    for (int c = 0; c < CUBES; c++)
        square[c] = measure(2.0, near->x[c] - at.x, near->y[c] - at.y, near->z[c] - at.z);
    for (int c = 0; c < CUBES; c++)
        put_one(least, square[c]);
    for (int c = 0; c < CUBES; c++)
        chosen |= (uint32_t)!(square[c] > least[last] * spread) << c;
    for (; chosen; chosen &= chosen - 1) {
        const uint32_t c = first_of64(chosen);
        double *size = &out->size[3 * out->n++];

        size[0] = fabs(near->x[c] - at.x);
        size[1] = fabs(near->y[c] - at.y);
        size[2] = fabs(near->z[c] - at.z);
    }
}

/* The smallest of the candidates of lanes from `first` on. */
static void take_least(double metric, candidates *some, uint32_t first, uint32_t end, members *m)
{
    find_parts(metric, 3 * some->n, some->size);
    for (uint32_t i = first, k = 0; i < end; i++) {
        double least[NEAREST] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };

        for (; k < some->end[i]; k++)
            put_one(least, (some->size[3 * k] + some->size[3 * k + 1]) + some->size[3 * k + 2]);
        for (int j = 0; j < NEAREST; j++)
            m->least[j][i] = least[j];
    }
}

SIMD_INLINE void find_least_other(double metric, double spread, int last, const neighbourhood *near, members *m)
{
    candidates some;
    uint32_t first = 0;

    some.n = 0;
    for (uint32_t i = 0; i < m->n; i++) {
        if (some.n + CUBES > LANES_MAX) {
            take_least(metric, &some, first, i, m);
            some.n = 0;
            first = i;
        }
        choose(spread, last, near, lanes_at(&m->at, i), &some);
        some.end[i] = some.n;
    }
    take_least(metric, &some, first, m->n, m);
}

/* ---- the cubes behind the neighbours ---- */

SIMD_INLINE double margin(double f) { return f < 0.5 ? f : 1.0 - f; }

/* Distance within which no point of a cube behind the neighbours lies. */
SIMD_INLINE double reach_of(double x, double y, double z) { return 1.0 + smaller(margin(x), smaller(margin(y), margin(z))); }

/* The same of lanes, in the measure. */
SIMD_INLINE void find_reaches(double metric, const members *m, double *restrict reach)
{
    const double zero = metric > 0.0 ? 0.0 : elementary_pow(0.0, metric);

    for (uint32_t i = 0; i < m->n; i++)
        reach[i] = reach_of(m->at.x[i], m->at.y[i], m->at.z[i]);
    find_parts(metric, m->n, reach);
    for (uint32_t i = 0; i < m->n && zero != 0.0; i++)
        reach[i] = (reach[i] + zero) + zero;
}

/* From a point to the nearest side of the cubes whose number, from the point's own on, is i. */
static double gap(int i, double f)
{
    return i < 0 ? f - (i + 1) : i > 0 ? i - f : 0.0;
}

/* Cubes behind the neighbours, by their numbers from the point's own on. */
enum { SIDE = 5, BEHIND = SIDE * SIDE * SIDE - CUBES };
typedef struct shell { int8_t at[BEHIND][3]; uint32_t n; } shell;

/* Those that are not too far away to count. */
SIMD_NOINLINE static void find_shell(double metric, pov_vec3 f, double most, shell *out)
{
    SIMD_ALIGNED double part[16];

    for (int i = 0; i < SIDE; i++) {
        part[i] = gap(i - 2, f.x);
        part[SIDE + i] = gap(i - 2, f.y);
        part[2 * SIDE + i] = gap(i - 2, f.z);
    }
    find_parts(metric, 3 * SIDE, part);
    out->n = 0;
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++)
            for (int k = 0; k < SIDE; k++) {
                const bool near = i % 4 != 0 && j % 4 != 0 && k % 4 != 0;
                int8_t *at = out->at[out->n];

                if (near || (part[i] + part[SIDE + j]) + part[2 * SIDE + k] > most)
                    continue;
                at[0] = (int8_t)(i - 2);
                at[1] = (int8_t)(j - 2);
                at[2] = (int8_t)(k - 2);
                out->n++;
            }
}

static const double *random_of(const noise_tables *t, pov_vec3 corner, int i, int j, int k)
{
    return &t->cell[noise_hash(t, cube_of(corner.x + i), cube_of(corner.y + j), cube_of(corner.z + k))];
}

static void search_shell(const noise_tables *t, double metric, int last, pov_vec3 corner, pov_vec3 f, double least[NEAREST])
{
    shell behind;

    find_shell(metric, f, least[last], &behind);
    for (uint32_t c = 0; c < behind.n; c++) {
        const int8_t *at = behind.at[c];
        const double *random = random_of(t, corner, at[0], at[1], at[2]);

        put_one(least, measure(metric, at[0] + random[0] - f.x, at[1] + random[1] - f.y, at[2] + random[2] - f.z));
    }
}

/* ---- the pattern ---- */

static inline pov_vec3 corner_of(pov_vec3 p) { return pov_vec3_of(floor(p.x), floor(p.y), floor(p.z)); }

SIMD_INLINE double value_of(const crackle *c, double first, double second, double third)
{
    double value = c->form.x * first;

    if (c->form.y != 0.0)
        value = value + c->form.y * second;
    if (c->form.z != 0.0)
        value = value + c->form.z * third;
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

SIMD_INLINE void put_values(const pattern_input *in, double metric, int last, pov_vec3 corner, members *m, double *value)
{
    const crackle *c = in->of->self;
    SIMD_ALIGNED double reach[LANES_MAX];

    find_reaches(metric, m, reach);
    for (uint32_t i = 0; i < m->n; i++)
        if (m->least[last][i] > reach[i]) {
            double least[NEAREST] = { m->least[0][i], m->least[1][i], m->least[2][i] };

            search_shell(in->noise, metric, last, corner, lanes_at(&m->at, i), least);
            for (int k = 0; k < NEAREST; k++)
                m->least[k][i] = least[k];
        }
    for (int k = 0; k <= last; k++)
        find_distances(c, metric, m->n, m->least[k]);
    for (uint32_t i = 0; i < m->n; i++)
        value[m->lane[i]] = value_of(c, m->least[0][i], m->least[1][i], m->least[2][i]);
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

/* ---- the nearest point itself ---- */

static pov_vec3 point_in(const noise_tables *t, pov_vec3 corner, int i, int j, int k)
{
    const double *random = random_of(t, corner, i, j, k);

    return pov_vec3_of(corner.x + i + random[0], corner.y + j + random[1], corner.z + k + random[2]);
}

/* Of the cubes behind the neighbours, where a point is nearer than this. */
static pov_vec3 nearest_behind(const noise_tables *t, double metric, pov_vec3 corner, pov_vec3 f, double least, pov_vec3 at)
{
    shell behind;

    find_shell(metric, f, least, &behind);
    for (uint32_t c = 0; c < behind.n; c++) {
        const int i = behind.at[c][0], j = behind.at[c][1], k = behind.at[c][2];
        const double *random = random_of(t, corner, i, j, k);
        const double measured = measure(metric, i + random[0] - f.x, j + random[1] - f.y, k + random[2] - f.z);

        if (measured < least) {
            least = measured;
            at = point_in(t, corner, i, j, k);
        }
    }
    return at;
}

/* near: of the corner. A place that is not a number is its own. */
SIMD_INLINE pov_vec3 find_nearest(const noise_tables *t, double metric, const neighbourhood *near, pov_vec3 corner, pov_vec3 p)
{
    const pov_vec3 f = pov_sub(p, corner);
    SIMD_ALIGNED double size[3 * CUBES + 7];
    double least = HUGE_VAL;
    int which = -1;
    pov_vec3 at = p;

    for (int c = 0; c < CUBES; c++) {
        size[c] = fabs(near->x[c] - f.x);
        size[CUBES + c] = fabs(near->y[c] - f.y);
        size[2 * CUBES + c] = fabs(near->z[c] - f.z);
    }
    find_parts(metric, 3 * CUBES, size);
    for (int c = 0; c < CUBES; c++)
        size[c] = (size[c] + size[CUBES + c]) + size[2 * CUBES + c];
    for (int c = 0; c < CUBES; c++) {
        which = size[c] < least ? c : which;
        least = smaller(size[c], least);
    }
    if (which >= 0)
        at = point_in(t, corner, which / 9 - 1, which / 3 % 3 - 1, which % 3 - 1);
    if (least > measure(metric, reach_of(f.x, f.y, f.z), 0.0, 0.0))
        return nearest_behind(t, metric, corner, f, least, at);
    return at;
}

pov_vec3 cube_nearest(const noise_tables *t, pov_vec3 at)
{
    const pov_vec3 corner = corner_of(at);
    neighbourhood near;

    fill(t, corner, &near);
    return find_nearest(t, 2.0, &near, corner, at);
}

SIMD_INLINE void find_all_nearest(const pattern_input *in, double metric, vec_lanes *out)
{
    pov_vec3 corner = pov_vec3_of(NAN, NAN, NAN);
    neighbourhood near;

    for (uint32_t i = 0; i < in->n; i++) {
        const pov_vec3 own = corner_of(lanes_at(in->at, i));

        if (own.x != corner.x || own.y != corner.y || own.z != corner.z)
            fill(in->noise, own, &near);
        corner = own;
        lanes_put(out, i, find_nearest(in->noise, metric, &near, own, lanes_at(in->at, i)));
    }
    for (uint32_t i = in->n; i < lanes_whole(in->n); i++)
        lanes_put(out, i, lanes_at(out, in->n - 1));
}

SIMD_CLONES static void find_nearest_usual(const pattern_input *in, vec_lanes *out) { find_all_nearest(in, 2.0, out); }
SIMD_CLONES static void find_nearest_other(const pattern_input *in, double metric, vec_lanes *out) { find_all_nearest(in, metric, out); }

/* Noise at the nearest points. */
static void evaluate_solid(const pattern_input *in, double metric, double *value)
{
    vec_lanes at;

    if (metric == 2.0)
        find_nearest_usual(in, &at);
    else
        find_nearest_other(in, metric, &at);
    noise_values(in->noise, in->generator, &at, 1.0, in->n, value);
}

static void evaluate(const pattern_input *in, double *value)
{
    const crackle *c = in->of->self;

    if (c->solid)
        evaluate_solid(in, c->metric, value);
    else if (c->metric != 2.0)
        find_other(in, c->metric, c->form.z != 0.0 ? 2 : 1, value);
    else
        (c->form.z != 0.0 ? find_three : find_two)(in, value);
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
