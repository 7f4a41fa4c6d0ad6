#include "media/march.h"

#include "base/elementary.h"
#include "light/reach.h"
#include "media/phase.h"

#include <string.h>

/* Samples of a light on a segment where the scene does not say, and limits to what it says; there are twice as many places
 * among which they are chosen. */
enum { STRATA = 16, STRATA_LEAST = 16, STRATA_MOST = LANES_MAX };
/* Strata in which densities are asked for: at least, and for each that the scene wants; and of a shadow ray. */
enum { DENSITIES = 64, DENSITIES_EACH = 2, DENSITIES_SHADOW = 8 };

static uint32_t strata_of(const media_set *s)
{
    const uint32_t wanted = s->strata > 0 ? s->strata : STRATA;

    return wanted < STRATA_LEAST ? STRATA_LEAST : wanted > STRATA_MOST ? STRATA_MOST : wanted;
}

/* (1 - exp(-x)) / x: the mean of what is left over a stratum of that depth. */
static double mean_left(double x)
{
    if (fabs(x) < 0x1p-10)
        return 1.0 - x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0)));
    return (1.0 - elementary_exp(-x)) / x;
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

/* Points of n strata from the first one on. */
static void find_points(const media_march *l, uint32_t first, uint32_t n, double *at)
{
    const double *edge = l->table.strata.edge;

    for (uint32_t i = first; i < first + n; i++)
        at[i - first] = edge[i] + media_jitter(l->seed, i) * (edge[i + 1] - edge[i]);
}

/* One channel of n strata: the depths at their ends, behind that at their beginning; returns the own light. */
static double add_up(const double *edge, const double *loss, const double *emitted, uint32_t n, double *depth)
{
    double given = 0.0;

    for (uint32_t i = 0; i < n; i++) {
        const double length = edge[i + 1] - edge[i], x = loss[i] * length;

        depth[i + 1] = depth[i] + x;
        if (emitted[i] != 0.0)
            given += elementary_exp(-depth[i]) * emitted[i] * length * mean_left(x);
    }
    return given;
}

/* Depths and own light, in strata that are set. */
static void fill_table(media_march *l, double given[3])
{
    media_table *t = &l->table;
    media_optics o;

    for (int c = 0; c < 3; c++)
        given[c] = t->depth[c][0] = 0.0;
    for (uint32_t first = 0, n; first < t->strata.count; first += n) {
        n = t->strata.count - first < LANES_MAX ? t->strata.count - first : LANES_MAX;
        find_points(l, first, n, t->at);
        media_set_at(l->model, l->set, &l->on, t->at, n, NULL, &o);
        for (int c = 0; c < 3; c++)
            given[c] += add_up(t->strata.edge + first, o.loss[c], o.emitted[c], n, t->depth[c] + first);
    }
    t->reused = l->set->varies && l->set->scatters && t->strata.count <= LANES_MAX;
    if (t->reused)
        memcpy(t->scatter, o.scatter, sizeof t->scatter);
}

/* Where light comes to an end early the strata are made anew, up to there. */
static void make_table(media_march *l, uint32_t wanted)
{
    enum { ROUNDS = 4 };
    media_table *t = &l->table;
    double given[3], through[3];

    divide(l, l->set->varies ? wanted : 1, HUGE_VAL);
    fill_table(l, given);
    for (uint32_t round = 1, k; l->set->varies && round < ROUNDS && 2 * (k = find_dense(t)) < t->strata.count; round++) {
        l->seed = mix_bits(l->seed + round);
        divide(l, wanted, t->strata.edge[k + (k == 0)]);
        fill_table(l, given);
    }
    for (int c = 0; c < 3; c++)
        through[c] = elementary_exp(-t->depth[c][t->strata.count]);
    l->given = colour_of_double(given);
    l->through = colour_of_double(through);
}

void media_march_begin(media_march *l)
{
    l->seed = media_seed(&l->on);
    make_table(l, l->set->strata * DENSITIES_EACH > DENSITIES ? l->set->strata * DENSITIES_EACH : DENSITIES);
}

colour media_transmittance(const model *m, const media_set *s, const media_segment *on)
{
    media_march l;

    l.model = m;
    l.set = s;
    l.on = *on;
    l.scale = 0.0;
    l.seed = s->varies ? media_seed(on) : 0;
    make_table(&l, DENSITIES_SHADOW);
    return l.through;
}

/* ---- scattered light ---- */

/* Depth at a place, which moves up the strata from call to call. */
static double depth_at(const media_table *t, int channel, uint32_t *stratum, double at)
{
    const double *edge = t->strata.edge, *depth = t->depth[channel];
    uint32_t k = *stratum;
    double length;

    while (k + 1 < t->strata.count && edge[k + 1] < at)
        k++;
    *stratum = k;
    length = edge[k + 1] - edge[k];
    return depth[k] + (length > 0.0 ? (at - edge[k]) / length * (depth[k + 1] - depth[k]) : 0.0);
}

/* Places for one light: a random point in each of its strata, and by channel what is left on the way from there, times
 * the length that it stands for. */
typedef struct places { uint32_t count; bool reused; double at[LANES_MAX], weight[3][LANES_MAX]; } places;

/* The mean loss, where it is the same everywhere and not negative: points are chosen by what it leaves. */
static double even_loss(const media_march *l)
{
    const media_table *t = &l->table;
    double sum = 0.0;

    if (l->set->varies || !(l->on.length > 0.0))
        return 0.0;
    for (int c = 0; c < 3; c++)
        sum += t->depth[c][t->strata.count];
    return sum > 0.0 ? sum / (3.0 * l->on.length) : 0.0;
}

/* A point of the stratum, and the length that it stands for where the ray begins: the inverse of its probability. */
static double choose_point(double lo, double hi, double loss, double u, double *inverse)
{
    const double length = hi - lo, x = loss * length, step = x > 0x1p-20 ? -elementary_log(1.0 - u * (1.0 - elementary_exp(-x))) / loss : u * length;

    *inverse = length * mean_left(x) * elementary_exp(loss * step);
    return lo + step;
}

static void fill_places(const media_march *l, const media_strata *s, uint32_t number, places *out)
{
    const double loss = even_loss(l);
    uint32_t stratum[3] = { 0, 0, 0 };

    out->count = s->count;
    for (uint32_t i = 0; i < s->count; i++) {
        const double u = media_jitter(l->seed, (number + 1) * MEDIA_STRATA_MAX + i);
        double inverse;

        out->at[i] = choose_point(s->edge[i], s->edge[i + 1], loss, u, &inverse);
        for (int c = 0; c < 3; c++)
            out->weight[c][i] = inverse * elementary_exp(-depth_at(&l->table, c, &stratum[c], out->at[i]));
    }
}

static bool is_even(const media_set *s)
{
    for (uint32_t i = 0; i < s->count; i++)
        if (s->of[i].medium->type > SCATTER_ISOTROPIC)
            return false;
    return true;
}

/* Around a light that is near, light and angles change fast. */
static void set_middle(const media_march *l, const light *from, media_division *by)
{
    const pov_vec3 to = pov_add(pov_sub(from->position, l->on.from), from->position_lo);
    const double least = (by->hi - by->lo) * 0x1p-10, faded = light_fades(from) ? from->fade_distance : 0.0;
    pov_vec3 off;

    by->has_middle = (from->type == LIGHT_POINT || from->type == LIGHT_SPOT) &&
                     (light_fades(from) || !is_even(l->set) || by->hi - by->lo >= MEDIA_ENDLESS);
    by->middle = pov_dot(to, l->on.dir);
    off = pov_sub(to, pov_scale(l->on.dir, by->middle));
    by->distance = sqrt(pov_dot(off, off) + faded * faded);
    if (!(by->distance > least))
        by->distance = least;
}

/* The points of the table, if the light reaches all of them alike. */
static bool reuse_table(const media_march *l, const media_division *by, places *out)
{
    const media_table *t = &l->table;
    uint32_t stratum[3] = { 0, 0, 0 };

    out->reused = t->reused && !by->has_middle && by->lo == 0.0 && by->hi == l->on.length && l->model->light_groups.count == 0;
    if (!out->reused)
        return false;
    out->count = t->strata.count;
    for (uint32_t i = 0; i < out->count; i++) {
        out->at[i] = t->at[i];
        for (int c = 0; c < 3; c++)
            out->weight[c][i] = (t->strata.edge[i + 1] - t->strata.edge[i]) * elementary_exp(-depth_at(t, c, &stratum[c], t->at[i]));
    }
    return true;
}

static void find_places(const media_march *l, const light *from, double lo, double hi, uint32_t number, places *out)
{
    const uint32_t wanted = l->set->varies ? DENSITIES : 2 * strata_of(l->set);
    media_division by = { .lo = lo, .hi = hi, .scale = l->scale, .wanted = wanted < LANES_MAX ? wanted : LANES_MAX, .loss = even_loss(l) };
    media_strata s;

    set_middle(l, from, &by);
    if (reuse_table(l, &by, out))
        return;
    media_divide(&by, &s);
    fill_places(l, &s, number, out);
}

/* Points of the segment, as lights ask for them. */
static void set_points(const media_march *l, media_samples *s)
{
    const pov_vec3 none = pov_vec3_of(0.0, 0.0, 0.0);

    for (uint32_t i = 0; i < lanes_whole(s->count); i++) {
        const double at = s->at[i < s->count ? i : s->count - 1];

        lanes_put(&s->point, i, pov_add(l->on.from, pov_scale(l->on.dir, at)));
        lanes_put(&s->point_lo, i, none);
    }
}

/* POV-Ray scatters the sum of what the media scatter by the plain mean of their phase functions. */
static double mean_phase(const media_set *s, double cosine)
{
    double sum = 0.0;

    for (uint32_t i = 0; i < s->count; i++)
        sum += media_phase(s->of[i].medium, cosine);
    return sum / (double)s->count;
}

static colour light_at(const light_lanes *in, uint32_t i)
{
    return in->uniform ? in->color : colour_of(in->red[i], in->green[i], in->blue[i]);
}

static void set_values(const media_march *l, const light *from, const places *p, media_samples *s)
{
    media_optics o;

    if (p->reused)
        memcpy(o.scatter, l->table.scatter, sizeof o.scatter);
    else
        media_set_at(l->model, l->set, &l->on, s->at, s->count, from, &o);
    for (uint32_t i = 0; i < s->count; i++) {
        const double phase = mean_phase(l->set, pov_dot(pov_unit(lanes_at(&s->in.dir, i)), l->on.dir));
        const colour c = light_at(&s->in, i);

        s->value[i].r = (float)((double)c.r * phase * o.scatter[0][i] * p->weight[0][i]);
        s->value[i].g = (float)((double)c.g * phase * o.scatter[1][i] * p->weight[1][i]);
        s->value[i].b = (float)((double)c.b * phase * o.scatter[2][i] * p->weight[2][i]);
    }
}

/* ---- choice ---- */

static double size_of(colour c) { return fabs((double)c.r) + fabs((double)c.g) + fabs((double)c.b); }

static void keep(media_samples *s, uint32_t from, uint32_t to, float by)
{
    s->at[to] = s->at[from];
    lanes_put(&s->point, to, lanes_at(&s->point, from));
    lanes_put(&s->in.dir, to, lanes_at(&s->in.dir, from));
    s->value[to] = colour_scale(s->value[from], by);
}

/* Of all samples choose `wanted` by what they give, one in each equal part of the whole; one that is chosen several times
 * is kept once. The sum's mean stays what it was. */
static void choose(media_samples *s, uint64_t seed, uint32_t number, uint32_t wanted)
{
    const bool all = wanted == s->count;
    double whole = 0.0, before = 0.0;
    uint32_t kept = 0, drawn = 0;

    for (uint32_t i = 0; i < s->count; i++)
        whole += size_of(s->value[i]);
    for (uint32_t i = 0; i < s->count; i++) {
        const double own = size_of(s->value[i]), end = before + own;
        uint32_t times = 0;

        for (; !all && drawn < wanted; drawn++, times++) {
            const double at = ((double)drawn + media_random(~seed, number * LANES_MAX + drawn)) * whole / (double)wanted;

            if (!(at < end))
                break;
        }
        before = end;
        if (all && own > 0.0)
            keep(s, i, kept++, 1.0f);
        else if (times > 0)
            keep(s, i, kept++, (float)((double)times * whole / ((double)wanted * own)));
    }
    s->count = kept;
}

bool media_sample_light(const media_march *l, const light *from, const light_class *class, uint32_t number,
                        media_samples *out)
{
    const light_origin origin = light_own_origin(from);
    const uint32_t wanted = strata_of(l->set);
    double lo = 0.0, hi = l->on.length;
    light_points at;
    places p;

    if (!media_set_scatters(l->model, l->set, from) || !light_reach(from, l->on.from, l->on.dir, &lo, &hi))
        return false;
    find_places(l, from, lo, hi, number, &p);
    out->count = p.count;
    memcpy(out->at, p.at, p.count * sizeof *p.at);
    set_points(l, out);
    at = (light_points){ &out->point, &out->point_lo, out->count };
    class->incident(from, &origin, &at, &out->in);
    set_values(l, from, &p, out);
    choose(out, l->seed, number, wanted < out->count ? wanted : out->count);
    return out->count > 0;
}
