#include "base/elementary.h"
#include "texture/cube.h"
#include "texture/pattern.h"

#include <stdlib.h>

/* A random point in each cube of side 1; the value is a sum over the distances to the three nearest ones.
 *
 * The points of the 27 cubes around a cube are made once for neighbouring lanes. Only where a distance that counts is
 * larger than that to the next layer of cubes are these searched too. */
typedef struct crackle {
    pov_vec3 form;
    double metric, offset;
    bool solid;
} crackle;

/* Points relative to the lowest corner of the cube in the middle. */
enum { CUBES = 27, CUBES_WHOLE = 28, NEAREST = 3 };
typedef struct neighbourhood {
    SIMD_ALIGNED double x[CUBES_WHOLE], y[CUBES_WHOLE], z[CUBES_WHOLE];
    pov_vec3 corner;
} neighbourhood;

static const double far_off = 1e100;

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
    out->corner = corner;
    out->x[CUBES] = out->y[CUBES] = out->z[CUBES] = far_off;
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
    return elementary_pow(measured + elementary_pow(c->offset, metric), 1.0 / metric);
}

/* The smallest three of columns: each of four holds its own, ordered. */
typedef struct columns { double least[NEAREST][4]; } columns;

SIMD_INLINE double smaller(double a, double b) { return a < b ? a : b; }
SIMD_INLINE double larger(double a, double b) { return a > b ? a : b; }

/* The last one is left out where it does not count. */
SIMD_INLINE void put_four(columns *c, int last, const double *measured)
{
    for (int l = 0; l < 4; l++) {
        const double a = measured[l], b = larger(c->least[0][l], a), d = larger(c->least[1][l], b);

        c->least[0][l] = smaller(c->least[0][l], a);
        c->least[1][l] = smaller(c->least[1][l], b);
        if (last > 1)
            c->least[2][l] = smaller(c->least[2][l], d);
    }
}

SIMD_INLINE void put_one(double least[NEAREST], double a)
{
    const double b = larger(least[0], a), d = larger(least[1], b);

    least[0] = smaller(least[0], a);
    least[1] = smaller(least[1], b);
    least[2] = smaller(least[2], d);
}

SIMD_INLINE void find_least(double metric, int last, const neighbourhood *near, pov_vec3 p, double *least)
{
    SIMD_ALIGNED double measured[CUBES_WHOLE];
    columns c;

    for (int i = 0; i < CUBES_WHOLE; i++)
        measured[i] = measure(metric, near->x[i] - p.x, near->y[i] - p.y, near->z[i] - p.z);
    for (int l = 0; l < 4; l++)
        c.least[0][l] = c.least[1][l] = c.least[2][l] = HUGE_VAL;
    for (int i = 0; i < CUBES_WHOLE; i += 4)
        put_four(&c, last, measured + i);
    least[0] = least[1] = least[2] = HUGE_VAL;
    for (int k = 0; k <= last; k++)
        for (int l = 0; l < 4; l++)
            put_one(least, c.least[k][l]);
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

static inline bool is_same(pov_vec3 a, pov_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

SIMD_INLINE double value_of(const crackle *c, double metric, const double least[NEAREST])
{
    double value = c->form.x * distance(c, metric, least[0]);

    if (c->form.y != 0.0)
        value = value + c->form.y * distance(c, metric, least[1]);
    if (c->form.z != 0.0)
        value = value + c->form.z * distance(c, metric, least[2]);
    return value < 0.0 ? 0.0 : value > 1.0 ? 1.0 : value;
}

/* last: of the three distances, the last that counts. */
SIMD_INLINE void find_values(const pattern_input *in, double metric, int last, double *value)
{
    const crackle *c = in->of->self;
    neighbourhood near;

    near.corner = pov_vec3_of(NAN, NAN, NAN);
    for (uint32_t i = 0; i < in->n; i++) {
        const pov_vec3 p = lanes_at(in->at, i), corner = corner_of(p), f = pov_sub(p, corner);
        double least[NEAREST];

        if (!is_same(corner, near.corner))
            fill(in->noise, corner, &near);
        find_least(metric, last, &near, f, least);
        if (least[last] > reach_of(metric, f))
            search_shell(in->noise, metric, last, corner, f, least);
        value[i] = value_of(c, metric, least);
    }
}

/* The usual metric with two distances and with three, and all else. */
SIMD_CLONES static void find_two(const pattern_input *in, double *value) { find_values(in, 2.0, 1, value); }
SIMD_CLONES static void find_three(const pattern_input *in, double *value) { find_values(in, 2.0, 2, value); }
SIMD_CLONES static void find_other(const pattern_input *in, double metric, double *value) { find_values(in, metric, 2, value); }

static pov_vec3 nearest(const noise_tables *t, double metric, pov_vec3 p)
{
    const pov_vec3 corner = corner_of(p), f = pov_sub(p, corner);
    double least = HUGE_VAL;
    pov_vec3 best = p;

    for (int i = -2; i <= 2; i++)
        for (int j = -2; j <= 2; j++)
            for (int k = -2; k <= 2; k++) {
                const double *random = &t->cell[noise_hash(t, cube_of(corner.x + i), cube_of(corner.y + j), cube_of(corner.z + k))];
                const double measured = measure(metric, i + random[0] - f.x, j + random[1] - f.y, k + random[2] - f.z);

                if (measured < least) {
                    least = measured;
                    best = pov_vec3_of(corner.x + i + random[0], corner.y + j + random[1], corner.z + k + random[2]);
                }
            }
    return best;
}

pov_vec3 cube_nearest(const noise_tables *t, pov_vec3 at)
{
    return nearest(t, 2.0, at);
}

static void evaluate(const pattern_input *in, double *value)
{
    const crackle *c = in->of->self;

    if (!c->solid && c->metric != 2.0)
        find_other(in, c->metric, value);
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
