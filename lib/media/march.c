#include "media/matter.h"

#include "base/elementary.h"

#include <string.h>

/* Strata in which densities are asked for, before some are split: where the scene says nothing, at least, and for each sample of many
 * that it wants; and of a shadow ray, where none is split. */
enum { DENSITIES = 32, DENSITIES_LEAST = 16, DENSITIES_EACH = 2, DENSITIES_SHADOW = 8 };

/* (1 - exp(-x)) / x: the mean of what is left over a stratum of that depth. */
SIMD_INLINE double mean_left(double x)
{
    const double thin = 1.0 - x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0))), thick = (1.0 - elementary_exp(-x)) / x;

    return fabs(x) < 0x1p-10 ? thin : thick;
}

static colour colour_of_double(const double c[3]) { return colour_of((float)c[0], (float)c[1], (float)c[2]); }

/* ---- loss and own light ---- */

/* Beyond this depth hardly anything is seen. */
static const double opaque_depth = 8.0;

/* Equal strata; most of them before `dense`, where the ray does not come to an end there. */
static void divide(media_march *l, uint32_t wanted, double dense)
{
    media_division by = { .lo = 0.0, .hi = l->on.length, .scale = l->scale, .wanted = wanted };
    media_strata *s = &l->table.strata;
    const uint32_t rest = wanted / 4;

    if (!(dense < by.hi)) {
        media_divide(&by, s);
        return;
    }
    by.hi = dense;
    by.wanted = wanted - rest;
    media_divide(&by, s);
    for (uint32_t i = 1; i <= rest; i++)
        s->edge[++s->count] = dense + (l->on.length - dense) * ((double)i / (double)rest);
}

/* The first edge where no channel has light left; the last one if there is none. */
static uint32_t find_dense(const media_table *t)
{
    uint32_t k = 0;

    while (k < t->strata.count && !(t->depth[0][k] > opaque_depth && t->depth[1][k] > opaque_depth && t->depth[2][k] > opaque_depth))
        k++;
    return k;
}

/* One channel of n strata: the depths at their ends, behind that at their beginning. */
static void put_depths(const double *edge, const double *loss, uint32_t n, double *depth)
{
    for (uint32_t i = 0; i < n; i++)
        depth[i + 1] = depth[i] + loss[i] * (edge[i + 1] - edge[i]);
}

static void add_depths(media_march *l, const media_matter *m)
{
    media_table *t = &l->table;

    for (int c = 0; c < 3; c++) {
        t->depth[c][0] = 0.0;
        if (!l->set->dims)
            memset(t->depth[c], 0, (t->strata.count + 1) * sizeof *t->depth[c]);
        for (uint32_t first = 0; l->set->dims && first < t->strata.count; first += LANES_MAX)
            put_depths(t->strata.edge + first, m->of[first / LANES_MAX].loss[c], matter_block(&t->strata, first), t->depth[c] + first);
    }
}

/* Of light from strata: what is left before them, and the mean of what is left within. */
typedef struct leftover { double before[LANES_MAX], within[LANES_MAX]; } leftover;

SIMD_CLONES static void find_leftover(const double *restrict edge, const double *restrict loss, const double *restrict depth, uint32_t n,
                                      leftover *restrict out)
{
    for (uint32_t i = 0; i < n; i++) {
        out->before[i] = elementary_exp(-depth[i]);
        out->within[i] = mean_left(loss[i] * (edge[i + 1] - edge[i]));
    }
}

static double add_up(const double *edge, const double *emitted, const leftover *left, uint32_t n)
{
    double given = 0.0;

    for (uint32_t i = 0; i < n; i++)
        if (emitted[i] != 0.0)
            given += left->before[i] * emitted[i] * (edge[i + 1] - edge[i]) * left->within[i];
    return given;
}

/* Where nothing is lost. */
static double add_all(const double *edge, const double *emitted, uint32_t n)
{
    double given = 0.0;

    for (uint32_t i = 0; i < n; i++)
        given += emitted[i] * (edge[i + 1] - edge[i]);
    return given;
}

/* The same by channel, of n strata. Channels are often alike. */
static void add_block(const media_march *l, uint32_t first, uint32_t n, const media_optics *o, double given[3])
{
    const media_table *t = &l->table;
    const double *edge = t->strata.edge + first;
    leftover left;

    for (int c = 0; c < 3; c++) {
        if (!l->set->dims) {
            given[c] += add_all(edge, o->emitted[c], n);
            continue;
        }
        if (c == 0 || t->depth[c][first] != t->depth[c - 1][first] || memcmp(o->loss[c], o->loss[c - 1], n * sizeof *edge) != 0)
            find_leftover(edge, o->loss[c], t->depth[c] + first, n, &left);
        given[c] += add_up(edge, o->emitted[c], &left, n);
    }
}

static void add_own(const media_march *l, const media_matter *m, double given[3])
{
    const media_strata *s = &l->table.strata;

    given[0] = given[1] = given[2] = 0.0;
    for (uint32_t first = 0; l->set->shines && first < s->count; first += LANES_MAX)
        add_block(l, first, matter_block(s, first), &m->of[first / LANES_MAX], given);
}

static void find_matter(media_march *l, media_matter *m)
{
    matter_find(l, m);
    add_depths(l, m);
}

/* The points are of use for lights, too. */
static void keep_points(media_march *l, const media_matter *m)
{
    media_table *t = &l->table;

    t->reused = l->set->scatters && t->strata.count <= LANES_MAX;
    if (t->reused) {
        memcpy(t->at, m->at, sizeof t->at);
        memcpy(t->scatter, m->of[0].scatter, sizeof t->scatter);
    }
}

/* The whole segment is one stratum. */
static void fill_even_table(media_march *l, double given[3])
{
    media_table *t = &l->table;
    media_channel o[3];

    t->strata.count = 1;
    t->strata.edge[0] = 0.0;
    t->strata.edge[1] = l->on.length;
    media_set_even(l->model, l->set, NULL, o);
    t->reused = false;
    for (int c = 0; c < 3; c++) {
        t->depth[c][0] = 0.0;
        put_depths(t->strata.edge, &o[c].loss, 1, t->depth[c]);
        given[c] = o[c].emitted != 0.0 ? o[c].emitted * l->on.length * mean_left(t->depth[c][1]) : 0.0;
        t->scatter[c][0] = o[c].scatter;
    }
}

/* Where light comes to an end early the strata are made anew, up to there. */
static void find_strata(media_march *l, uint32_t wanted, media_matter *m)
{
    enum { ROUNDS = 4 };
    media_table *t = &l->table;

    divide(l, wanted, HUGE_VAL);
    find_matter(l, m);
    for (uint32_t round = 1, k; l->set->dims && round < ROUNDS && 2 * (k = find_dense(t)) < t->strata.count; round++) {
        l->random.key = mix_bits(l->random.key + round);
        divide(l, wanted, t->strata.edge[k + (k == 0)]);
        find_matter(l, m);
    }
}

static void make_table(media_march *l, uint32_t wanted, double given[3])
{
    media_matter few, split;
    uint64_t uneven;

    find_strata(l, wanted, &few);
    uneven = wanted > DENSITIES_SHADOW && wanted <= LANES_MAX ? matter_uneven(l, &few) : 0;
    if (uneven) {
        matter_split(l, &few, uneven, &split);
        add_depths(l, &split);
    }
    add_own(l, uneven ? &split : &few, given);
    keep_points(l, uneven ? &split : &few);
}

/* What is left of light behind these depths, which are often alike. */
static colour left_at(const double depth[3])
{
    double through[3];

    for (int c = 0; c < 3; c++)
        through[c] = c > 0 && depth[c] == depth[c - 1] ? through[c - 1] : elementary_exp(-depth[c]);
    return colour_of_double(through);
}

static void fill(media_march *l, uint32_t wanted)
{
    const media_table *t = &l->table;
    double given[3];

    if (l->set->varies)
        make_table(l, wanted, given);
    else
        fill_even_table(l, given);
    l->given = colour_of_double(given);
    l->through = colour_of(1.0f, 1.0f, 1.0f);
    if (l->set->dims)
        l->through = left_at((const double[3]){ t->depth[0][t->strata.count], t->depth[1][t->strata.count], t->depth[2][t->strata.count] });
}

static uint32_t densities_for(uint32_t asked)
{
    if (asked == 0)
        return DENSITIES;
    if (asked > DENSITIES)
        return asked * DENSITIES_EACH;
    return asked > DENSITIES_LEAST ? asked : DENSITIES_LEAST;
}

void media_march_begin(media_march *l)
{
    fill(l, densities_for(l->set->strata));
}

/* As fill_even_table() has it. */
static colour even_transmittance(const model *m, const media_set *s, double length)
{
    media_channel of[3];
    double depth[3];

    media_set_even(m, s, NULL, of);
    for (int c = 0; c < 3; c++)
        depth[c] = of[c].loss * length;
    return left_at(depth);
}

colour media_transmittance(const model *m, const media_set *s, const media_segment *on)
{
    media_march l;

    if (!s->dims)
        return colour_of(1.0f, 1.0f, 1.0f);
    if (!s->varies)
        return even_transmittance(m, s, on->length);
    l.model = m;
    l.set = s;
    l.on = *on;
    l.scale = 0.0;
    l.random = media_random_of(on);
    fill(&l, DENSITIES_SHADOW);
    return l.through;
}

/* ---- segments side by side ---- */

/* The strata of some segments of light, as fill() has them, side by side. */
typedef struct shadow_strata { uint32_t count; double edge[MEDIA_TOGETHER][DENSITIES_SHADOW + 1]; texture_points points; } shadow_strata;

static void add_shadow(const media_segment *on, shadow_strata *out)
{
    const media_random r = media_random_of(on);
    const media_division by = { .lo = 0.0, .hi = on->length, .wanted = DENSITIES_SHADOW };
    double *edge = out->edge[out->count];
    media_strata s;

    media_divide(&by, &s);
    memcpy(edge, s.edge, sizeof out->edge[0]);
    for (uint32_t i = 0; i < DENSITIES_SHADOW; i++) {
        const double at = edge[i] + media_jitter(&r, i) * (edge[i + 1] - edge[i]);

        texture_point(&out->points, out->count * DENSITIES_SHADOW + i, pov_add(on->from, pov_scale(on->dir, at)), pov_vec3_of(0.0, 0.0, 0.0));
    }
    out->count++;
}

/* Does light come to an end so early that strata are made anew? */
static bool ends_early(double depth[3][DENSITIES_SHADOW + 1])
{
    bool early = false;

    for (uint32_t k = 0; 2 * k < DENSITIES_SHADOW; k++)
        early = early || (depth[0][k] > opaque_depth && depth[1][k] > opaque_depth && depth[2][k] > opaque_depth);
    return early;
}

void media_transmittances(const model *m, const media_set *s, const media_segment *on, uint32_t n, colour *out)
{
    shadow_strata strata;
    media_optics o;

    if (n == 0)
        return;
    strata.count = 0;
    strata.points.has_surface = false;
    strata.points.parts = NULL;
    for (uint32_t i = 0; i < n; i++)
        add_shadow(&on[i], &strata);
    media_set_at_points(m, s, &strata.points, n * DENSITIES_SHADOW, NULL, &o);
    for (uint32_t i = 0; i < n; i++) {
        double depth[3][DENSITIES_SHADOW + 1] = { { 0.0 } };

        for (int c = 0; c < 3; c++)
            put_depths(strata.edge[i], o.loss[c] + i * DENSITIES_SHADOW, DENSITIES_SHADOW, depth[c]);
        out[i] = ends_early(depth) ? media_transmittance(m, s, &on[i])
                                   : left_at((const double[3]){ depth[0][DENSITIES_SHADOW], depth[1][DENSITIES_SHADOW], depth[2][DENSITIES_SHADOW] });
    }
}

/* As even_transmittance() has it. */
void media_depths_put(const model *m, const media_set *s, double length, uint32_t i, media_depths *out)
{
    media_channel of[3];

    media_set_even(m, s, NULL, of);
    for (int c = 0; c < 3; c++)
        out->by[c][i] = of[c].loss * length;
}

SIMD_CLONES static void find_left(const double *restrict depth, uint32_t n, float *restrict left)
{
    for (uint32_t i = 0; i < n; i++)
        left[i] = (float)elementary_exp(-depth[i]);
}

void media_depths_left(const media_depths *d, uint32_t n, colour *out)
{
    float left[3][LANES_MAX];

    for (int c = 0; c < 3; c++)
        if (c > 0 && memcmp(d->by[c], d->by[c - 1], n * sizeof *d->by[c]) == 0)
            memcpy(left[c], left[c - 1], n * sizeof *left[c]);
        else
            find_left(d->by[c], n, left[c]);
    for (uint32_t i = 0; i < n; i++)
        out[i] = colour_of(left[0][i], left[1][i], left[2][i]);
}
