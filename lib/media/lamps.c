/* Light of lamps that media scatter towards the beginning of a segment. */
#include "base/elementary.h"
#include "light/reach.h"
#include "media/march.h"
#include "media/phase.h"

#include <string.h>

/* Shadow rays to a light on a segment: limits to what the scene says, and where it says nothing: for each unit of the
 * light that is seen if nothing shadows it. */
enum { RAYS_LEAST = 6, RAYS_MOST = LANES_MAX, RAYS_FEW = 4, RAYS_MANY = 32 };
static const double rays_by_light = 30.0;
/* Lights beyond so many lengths of a segment are far from it. */
static const double far_off = 4.0;
/* Points of the segment, one in each of some strata, and by channel what is left of light from there, times the length
 * that the point stands for. */
typedef struct places {
    uint32_t count;
    bool reused;                 /* they are those of the table */
    double at[LANES_MAX], weight[3][LANES_MAX];
} places;

/* ---- places ---- */

/* The mean loss by length; 0: there is none, or it varies. */
static double even_loss(const media_march *l)
{
    const media_table *t = &l->table;
    const double sum = t->depth[0][t->strata.count] + t->depth[1][t->strata.count] + t->depth[2][t->strata.count];

    return !l->set->varies && sum > 0.0 && l->on.length > 0.0 ? sum / (3.0 * l->on.length) : 0.0;
}

SIMD_CLONES static void leave(const double *restrict depth, const double *restrict length, uint32_t n, double *restrict weight)
{
    for (uint32_t i = 0; i < n; i++)
        weight[i] = length[i] * elementary_exp(-depth[i]);
}

/* Depths at places that are in order. */
static void find_depths(const media_table *t, int channel, const places *p, double *out)
{
    const double *edge = t->strata.edge, *depth = t->depth[channel];
    uint32_t k = 0;

    for (uint32_t i = 0; i < p->count; i++) {
        double length;

        while (k + 1 < t->strata.count && edge[k + 1] < p->at[i])
            k++;
        length = edge[k + 1] - edge[k];
        out[i] = depth[k] + (length > 0.0 ? (p->at[i] - edge[k]) / length * (depth[k + 1] - depth[k]) : 0.0);
    }
}

static void set_weights(const media_march *l, const double *length, places *p)
{
    const media_table *t = &l->table;
    const uint32_t whole = t->strata.count;
    double depth[LANES_MAX];

    for (int c = 0; c < 3; c++) {
        if (c > 0 && !l->set->varies && t->depth[c][whole] == t->depth[c - 1][whole]) {
            memcpy(p->weight[c], p->weight[c - 1], p->count * sizeof *depth);
            continue;
        }
        find_depths(t, c, p, depth);
        leave(depth, length, p->count, p->weight[c]);
    }
}

static void fill_places(const media_march *l, const media_strata *s, uint32_t number, places *p)
{
    double length[LANES_MAX];

    p->count = s->count;
    for (uint32_t i = 0; i < s->count; i++) {
        length[i] = s->edge[i + 1] - s->edge[i];
        p->at[i] = s->edge[i] + media_jitter(&l->random, (number + 1) * MEDIA_STRATA_MAX + i) * length[i];
    }
    set_weights(l, length, p);
}

/* Is a light so far from the segment that it comes from almost the same direction everywhere? */
static bool is_far(const media_division *by, double off)
{
    const double length = by->hi - by->lo, before = pov_max(by->lo - by->middle, by->middle - by->hi), gap = pov_max(before, 0.0);

    return off * off + gap * gap > far_off * far_off * length * length;
}

/* Around a light that is near, light and angles change fast. */
static void set_middle(const media_march *l, const light *from, bool alike, media_division *by)
{
    const pov_vec3 to = pov_add(pov_sub(from->position, l->on.from), from->position_lo);
    const double least = (by->hi - by->lo) * 0x1p-10, faded = light_fades(from) ? from->fade_distance : 0.0;
    pov_vec3 off;

    by->has_middle = (from->type == LIGHT_POINT || from->type == LIGHT_SPOT) &&
                     (light_fades(from) || !alike || by->hi - by->lo >= MEDIA_ENDLESS);
    if (!by->has_middle)
        return;
    by->middle = pov_dot(to, l->on.dir);
    off = pov_sub(to, pov_scale(l->on.dir, by->middle));
    by->has_middle = !is_far(by, sqrt(pov_dot(off, off)));
    by->distance = sqrt(pov_dot(off, off) + faded * faded);
    if (!(by->distance > least))
        by->distance = least;
}

/* The points of the table, if the light reaches all of them alike. */
static bool reuse_table(const media_march *l, const media_division *by, places *p)
{
    const media_table *t = &l->table;
    double length[LANES_MAX];

    p->reused = t->reused && !by->has_middle && by->lo == 0.0 && by->hi == l->on.length && l->model->light_groups.count == 0;
    if (!p->reused)
        return false;
    p->count = t->strata.count;
    for (uint32_t i = 0; i < p->count; i++) {
        length[i] = t->strata.edge[i + 1] - t->strata.edge[i];
        p->at[i] = t->at[i];
    }
    set_weights(l, length, p);
    return true;
}

/* weight: of the path. */
static uint32_t rays_for(const media_march *l, double whole)
{
    const double wanted = ceil(whole * l->weight * rays_by_light);
    const uint32_t asked = l->set->strata;

    if (asked > 0)
        return asked < RAYS_LEAST ? RAYS_LEAST : asked < RAYS_MOST ? asked : RAYS_MOST;
    return wanted < RAYS_FEW ? RAYS_FEW : wanted < RAYS_MANY ? (uint32_t)wanted : RAYS_MANY;
}

/* The same before the light is known: from what is scattered of its own colour. */
static uint32_t places_for(const media_march *l, const light *from, double length)
{
    const media_table *t = &l->table;
    const colour c = from->color;
    const double sum = fabs((double)c.r * t->scatter[0][0]) + fabs((double)c.g * t->scatter[1][0]) + fabs((double)c.b * t->scatter[2][0]);
    const double loss = even_loss(l), most = loss > 0.0 && loss * length > 1.0 ? 1.0 / loss : length;

    return l->set->varies ? LANES_MAX : 2 * rays_for(l, sum / 3.0 * most);
}

/* alike: light is scattered alike in all directions. */
static void find_places(const media_march *l, const light *from, bool alike, double lo, double hi, uint32_t number, places *p)
{
    const uint32_t wanted = places_for(l, from, hi - lo);
    media_division by = { .lo = lo, .hi = hi, .scale = l->scale, .wanted = wanted < LANES_MAX ? wanted : LANES_MAX,
                          .loss = even_loss(l) };
    media_strata s;

    set_middle(l, from, alike, &by);
    if (reuse_table(l, &by, p))
        return;
    media_divide(&by, &s);
    fill_places(l, &s, number, p);
}

/* ---- light at the places ---- */

/* As lights ask for them; behind the last one they are like it. */
SIMD_CLONES static void set_points(const media_segment *on, const double *restrict at, uint32_t n, vec_lanes *restrict point,
                                   vec_lanes *restrict low)
{
    for (uint32_t i = 0; i < n; i++) {
        point->x[i] = on->from.x + at[i] * on->dir.x;
        point->y[i] = on->from.y + at[i] * on->dir.y;
        point->z[i] = on->from.z + at[i] * on->dir.z;
        low->x[i] = low->y[i] = low->z[i] = 0.0;
    }
}

static bool scatters_alike(const media_set *s)
{
    for (uint32_t i = 0; i < s->count; i++)
        if (s->of[i].medium->type > SCATTER_ISOTROPIC)
            return false;
    return true;
}

/* POV-Ray scatters the sum of what the media scatter by the plain mean of their phase functions. */
static double mean_phase(const media_set *s, double cosine)
{
    double sum = 0.0;

    for (uint32_t i = 0; i < s->count; i++)
        sum += media_phase(s->of[i].medium, cosine);
    return sum / (double)s->count;
}

static void set_phases(const media_march *l, const media_samples *s, bool alike, double *phase)
{
    for (uint32_t i = 0; i < s->count; i++)
        phase[i] = alike ? 1.0 : mean_phase(l->set, pov_dot(pov_unit(lanes_at(&s->in.dir, i)), l->on.dir));
}

static void set_values(const places *p, const double *phase, double scatter[3][LANES_MAX], media_samples *s)
{
    const light_lanes *in = &s->in;

    for (uint32_t i = 0; i < s->count; i++) {
        const colour c = in->uniform ? in->color : colour_of(in->red[i], in->green[i], in->blue[i]);

        s->value[i].r = (float)((double)c.r * phase[i] * scatter[0][i] * p->weight[0][i]);
        s->value[i].g = (float)((double)c.g * phase[i] * scatter[1][i] * p->weight[1][i]);
        s->value[i].b = (float)((double)c.b * phase[i] * scatter[2][i] * p->weight[2][i]);
    }
}

static void repeat(const double of[3][LANES_MAX], uint32_t n, double scatter[3][LANES_MAX])
{
    for (int c = 0; c < 3; c++)
        for (uint32_t i = 0; i < n; i++)
            scatter[c][i] = of[c][0];
}

static void find_values(const media_march *l, const light *from, const places *p, bool alike, media_samples *s)
{
    double phase[LANES_MAX];
    media_optics o;

    if (p->reused)
        memcpy(o.scatter, l->table.scatter, sizeof o.scatter);
    else if (!l->set->varies && l->model->light_groups.count == 0)
        repeat(l->table.scatter, s->count, o.scatter);
    else
        media_set_at(l->model, l->set, &l->on, s->at, s->count, from, &o);
    set_phases(l, s, alike, phase);
    set_values(p, phase, o.scatter, s);
}

/* ---- light from elsewhere ---- */

/* The last of the strata that begins at or before a place of the segment. */
static uint32_t stratum_at(const media_strata *s, double at)
{
    uint32_t lo = 0, hi = s->count;

    while (hi - lo > 1) {
        const uint32_t middle = (lo + hi) / 2;

        if (s->edge[middle] <= at)
            lo = middle;
        else
            hi = middle;
    }
    return lo;
}

static void find_depths_at(const media_table *t, const media_light *in, double depth[3][LANES_MAX])
{
    for (uint32_t i = 0; i < in->count; i++) {
        const uint32_t k = stratum_at(&t->strata, in->at[i]);
        const double *edge = t->strata.edge + k, width = edge[1] - edge[0];
        const double share = width > 0.0 ? (in->at[i] - edge[0]) / width : 0.0;

        for (int c = 0; c < 3; c++)
            depth[c][i] = t->depth[c][k] + share * (t->depth[c][k + 1] - t->depth[c][k]);
    }
}

colour media_scattered(const media_march *l, const media_light *in)
{
    double sum[3] = { 0.0, 0.0, 0.0 }, depth[3][LANES_MAX], left[3][LANES_MAX];
    media_optics o;

    if (l->set->varies)
        media_set_at(l->model, l->set, &l->on, in->at, in->count, NULL, &o);
    else
        repeat(l->table.scatter, in->count, o.scatter);
    find_depths_at(&l->table, in, depth);
    for (int c = 0; c < 3; c++)
        leave(depth[c], o.scatter[c], in->count, left[c]);
    for (uint32_t i = 0; i < in->count; i++) {
        const double phase = mean_phase(l->set, pov_dot(in->from[i], l->on.dir));

        sum[0] += (double)in->light[i].r * phase * left[0][i];
        sum[1] += (double)in->light[i].g * phase * left[1][i];
        sum[2] += (double)in->light[i].b * phase * left[2][i];
    }
    return colour_of((float)sum[0], (float)sum[1], (float)sum[2]);
}

/* ---- choice ---- */

static double size_of(colour c) { return fabs((double)c.r) + fabs((double)c.g) + fabs((double)c.b); }

/* The size of each and the sum of them. */
static double find_sizes(const media_samples *s, double *size)
{
    double sum = 0.0;

    for (uint32_t i = 0; i < s->count; i++) {
        size[i] = size_of(s->value[i]);
        sum += size[i];
    }
    return sum;
}

static void keep(media_samples *s, uint32_t from, uint32_t to, float by)
{
    s->at[to] = s->at[from];
    lanes_put(&s->point, to, lanes_at(&s->point, from));
    lanes_put(&s->point_lo, to, lanes_at(&s->point_lo, from));
    lanes_put(&s->in.dir, to, lanes_at(&s->in.dir, from));
    s->value[to] = colour_scale(s->value[from], by);
}

/* Drop those that give nothing. */
static void keep_all(media_samples *s)
{
    uint32_t kept = 0;

    for (uint32_t i = 0; i < s->count; i++)
        if (!colour_is_black(s->value[i]))
            keep(s, i, kept++, 1.0f);
    s->count = kept;
}

/* Of all samples choose `wanted` by what they give, at equal steps through the whole, the first after `first` of a step: how
 * many of them see the light through gaps is then a matter of the gaps' widths alone. One that is chosen several times is
 * kept once. The sum's mean stays what it was. */
static void keep_some(media_samples *s, const double *size, double whole, uint32_t wanted, double first)
{
    const double part = whole / (double)wanted;
    double before = 0.0, next = first * part;
    uint32_t kept = 0, drawn = 0;

    for (uint32_t i = 0; i < s->count; i++) {
        const double end = before + size[i];
        uint32_t times = 0;

        for (; drawn < wanted && next < end; times++) {
            drawn++;
            next = ((double)drawn + first) * part;
        }
        before = end;
        if (times > 0)
            keep(s, i, kept++, (float)((double)times * part / size[i]));
    }
    s->count = kept;
}

/* Of light between two places. */
SIMD_APART static bool sample(const media_march *l, const light *from, const light_class *class, double lo, double hi, uint32_t number,
                              media_samples *out)
{
    const light_origin origin = light_own_origin(from);
    const bool alike = scatters_alike(l->set);
    const media_random choice = { ~l->random.key, l->random.turn };
    double whole, size[LANES_MAX];
    light_points at;
    uint32_t wanted;
    places p;

    find_places(l, from, alike, lo, hi, number, &p);
    out->count = p.count;
    for (uint32_t i = 0; i < lanes_whole(p.count); i++)
        out->at[i] = p.at[i < p.count ? i : p.count - 1];
    set_points(&l->on, out->at, lanes_whole(p.count), &out->point, &out->point_lo);
    at = (light_points){ &out->point, &out->point_lo, out->count };
    class->incident(from, &origin, &at, &out->in);
    find_values(l, from, &p, alike, out);
    whole = find_sizes(out, size);
    wanted = rays_for(l, whole / 3.0);
    if (wanted < out->count)
        keep_some(out, size, whole, wanted, media_number(&choice, number));
    else
        keep_all(out);
    return out->count > 0;
}

bool media_sample_light(const media_march *l, const light *from, const light_class *class, uint32_t number, media_samples *out)
{
    double lo = 0.0, hi = l->on.length;

    return light_reach(from, l->on.from, l->on.dir, &lo, &hi) && media_set_scatters(l->model, l->set, from) &&
           sample(l, from, class, lo, hi, number, out);
}
