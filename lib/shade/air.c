#include "shade/air.h"

#include "base/elementary.h"
#include "shade/accumulate.h"
#include "shade/haze.h"
#include "texture/texture.h"

#include <string.h>

/* A segment of a path: length HUGE_VAL where nothing is hit. */
typedef struct segment { pov_vec3 from, dir; double length; } segment;
/* What is behind becomes by x behind + given. */
typedef struct veil { colour by, given; } veil;

static const veil clear = { { 1.0f, 1.0f, 1.0f }, { 0.0f, 0.0f, 0.0f } };

static veil veil_before(veil near, veil far)
{
    const veil v = { colour_mul(near.by, far.by), colour_add(colour_mul(near.by, far.given), near.given) };

    return v;
}

/* ---- fog ---- */

static inline veil fogs_at(const fog_veils *f, uint32_t i)
{
    const veil v = { colour_of(f->by[0][i], f->by[1][i], f->by[2][i]), colour_of(f->given[0][i], f->given[1][i], f->given[2][i]) };

    return v;
}

/* ---- rainbows ---- */

static pigment map_colour(const rainbow *r, double at)
{
    uint32_t k = 0;
    float share;
    pigment a, b;

    while (k + 1 < r->count && (double)r->values[k + 1] <= at)
        k++;
    if (k + 1 == r->count || at <= (double)r->values[0])
        return r->colours[at <= (double)r->values[0] ? 0 : k];
    a = r->colours[k];
    b = r->colours[k + 1];
    share = (float)((at - (double)r->values[k]) / ((double)r->values[k + 1] - (double)r->values[k]));
    a.color = colour_add(colour_scale(a.color, 1.0f - share), colour_scale(b.color, share));
    a.filter += share * (b.filter - a.filter);
    a.transmit += share * (b.transmit - a.transmit);
    return a;
}

static const double degree = 3.14159265358979323846 / 180.0;

/* How much of the bow is there, by the angle around its direction from `up`, on both sides. */
static double arc_share(const rainbow *r, pov_vec3 dir)
{
    const pov_vec3 side = pov_unit(pov_cross_product(r->direction, r->up)), top = pov_cross_product(side, r->direction);
    const double around = fabs(elementary_atan2(pov_dot(dir, side), pov_dot(dir, top))) / degree;
    const double inner = 0.5 * r->falloff, outer = 0.5 * r->arc;
    const double u = (around - inner) / (outer - inner);

    if (around >= outer && outer < 180.0)
        return 0.0;
    return around <= inner ? 1.0 : 1.0 - u * u * (3.0 - 2.0 * u);
}

/* False: the ray misses the bow, which is in the half of the sky that it is directed to. What is behind is filtered as far as
 * the bow is there. */
static bool rainbow_veil(const rainbow *r, const segment *s, veil *out)
{
    const double cosine = pov_dot(s->dir, r->direction);
    double angle, at, share, passed;
    float weight, filter;
    pigment c;

    if (cosine < r->least_cosine || cosine > r->most_cosine)
        return false;
    angle = elementary_acos(pov_min(1.0, pov_max(-1.0, cosine))) / degree;
    at = (angle - r->angle + 0.5 * r->width) / r->width;
    if (!(at >= 0.0 && at <= 1.0 && angle < 90.0))
        return false;
    share = arc_share(r, s->dir);
    if (share == 0.0)
        return false;
    passed = elementary_exp(-s->length / r->distance);
    c = map_colour(r, at);
    weight = (float)pov_min(1.0 - passed, (1.0 - (double)c.transmit) * share);
    filter = c.filter * weight;
    out->by = colour_add(colour_of(1.0f - filter, 1.0f - filter, 1.0f - filter), colour_scale(c.color, filter));
    out->by = colour_scale(out->by, 1.0f - weight);
    out->given = colour_scale(c.color, weight);
    return true;
}

/* The mean of those that the ray meets. */
static veil all_rainbows(const shading *scene, const segment *s)
{
    veil sum = { { 0.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 0.0f } }, one;
    uint32_t count = 0;

    for (size_t i = 0; i < scene->model->rainbows.count; i++) {
        if (!rainbow_veil(&scene->model->rainbows.items[i], s, &one))
            continue;
        sum.by = colour_add(sum.by, one.by);
        sum.given = colour_add(sum.given, one.given);
        count++;
    }
    if (count == 0)
        return clear;
    sum.by = colour_scale(sum.by, 1.0f / (float)count);
    sum.given = colour_scale(sum.given, 1.0f / (float)count);
    return sum;
}

/* ---- segments ---- */

uint32_t air_solids_across(const shading *scene, const surface *s)
{
    const uint32_t before = s->from->solids;

    if (!shading_info(scene, s->at->object)->filled || s->appearance == &scene->unseen)
        return before;
    return s->at->entering ? before + 1 : before - (before > 0);
}

void air_begin(air_segments *s, batch *b, uint32_t first, uint32_t count)
{
    s->paths = b->paths + first;
    s->rays = b->rays + first;
    s->camera = b->camera;
    s->first = first;
    s->on.count = count;
}

/* Starts and directions of the rays; lanes behind the last one are filled with it. */
static void take_rays(air_segments *s)
{
    const uint32_t last = s->on.count - 1, n = lanes_whole(s->on.count);

    for (uint32_t i = 0; i < n; i += 4) {
        const void *from[4];
        double unused[4];

        for (uint32_t k = 0; k < 4; k++)
            from[k] = s->rays[i + k < last ? i + k : last];
        simd_transpose(from, offsetof(pov_ray, org), s->on.from.x + i, s->on.from.y + i, s->on.from.z + i, unused);
        simd_transpose(from, offsetof(pov_ray, dir), s->dir.x + i, s->dir.y + i, s->dir.z + i, unused);
    }
    for (uint32_t i = last + 1; i < n; i++)
        s->on.length[i] = s->on.length[last];
}

/* From ray parameters to lengths, and directions to unit vectors, as pov_unit() makes them. False: some is out of range. */
SIMD_CLONES static bool measure_lanes(const vec_lanes *restrict dirs, fog_segments *restrict s, uint32_t n)
{
    int64_t plain = -1;

    for (uint32_t i = 0; i < n; i++) {
        const pov_vec3 dir = lanes_at(dirs, i);
        const double size = pov_largest(dir);
        const pov_vec3 d = pov_scale(dir, 1.0 / size);
        const double t = s->length[i], length = t * size * sqrt(pov_dot(d, d));
        pov_vec3 unit;

        plain &= geometry_unit(dir.x, dir.y, dir.z, &unit);
        lanes_put(&s->dir, i, unit);
        s->length[i] = t == HUGE_VAL ? t : length;
    }
    return plain != 0;
}

/* A ray that crosses what it does not see is one segment. */
static void join(air_segments *s)
{
    for (uint32_t i = 0; i < s->on.count; i++) {
        const double before = s->paths[i].travelled;

        lanes_put(&s->on.from, i, pov_sub(lanes_at(&s->on.from, i), pov_scale(lanes_at(&s->on.dir, i), before)));
        s->on.length[i] += before;
    }
}

void air_measure(const shade_context *c, air_segments *s)
{
    const uint32_t n = lanes_whole(s->on.count);

    take_rays(s);
    if (!measure_lanes(&s->dir, &s->on, n))
        for (uint32_t i = 0; i < n; i++)
            lanes_put(&s->on.dir, i, pov_unit(lanes_at(&s->dir, i)));
    if (c->scene->plan->hidden)
        join(s);
    fog_find(c->scene->model, &s->on, &s->fogs);
}

/* Length of a ray that hits nothing, where media fill the scene. */
static const double endless = 2e10;

/* Media on the last part of a segment. */
static veil media_veil(shade_context *c, const path *p, const segment *s)
{
    const bool ends = s->length < HUGE_VAL;
    const media_segment on = { pov_add(s->from, pov_scale(s->dir, p->travelled)), s->dir, ends ? s->length - p->travelled : endless };
    veil v = clear;

    haze_cross(c, p, &on, ends, &v.by, &v.given);
    return v;
}

/* There are no media that radiosity does not see. */
static bool sees_media(const shade_context *c, const path *p)
{
    return c->scene->plan->media && (p->gathers == 0 || c->scene->model->radiosity.sees_media);
}

/* Rainbows over media. */
SIMD_APART static veil veil_below(shade_context *c, const air_segments *on, uint32_t i, bool bows, bool hazy)
{
    const segment s = { lanes_at(&on->on.from, i), lanes_at(&on->on.dir, i), on->on.length[i] };
    const veil v = hazy ? media_veil(c, &on->paths[i], &s) : clear;

    return bows ? veil_before(all_rainbows(c->scene, &s), v) : v;
}

/* Fog lies over rainbows, and both over media. There are neither in solids, nor for radiosity, nor before what is not seen. */
static inline veil veil_of(shade_context *c, const air_segments *on, uint32_t i, bool seen)
{
    const path *p = &on->paths[i];
    const bool open = seen && p->solids == 0 && p->gathers == 0, bows = open && c->scene->model->rainbows.count > 0;
    const bool hazy = sees_media(c, p);
    const veil below = bows || hazy ? veil_below(c, on, i, bows, hazy) : clear;

    return open ? veil_before(fogs_at(&on->fogs, i), below) : below;
}

/* The path behind what dims it by `by`. Its weight stays. */
static inline void go_on(path *p, colour by, bool shows)
{
    p->factor.by = colour_mul(p->factor.by, by);
    if (shows)
        p->clear *= colour_grey(by);
}

/* Fogs over nothing, as veil_before() has it. False: some is not finite. */
SIMD_CLONES static bool put_over_nothing(fog_veils *restrict f, uint32_t n)
{
    int finite = 1;

    for (int k = 0; k < 3; k++)
        for (uint32_t i = 0; i < n; i++) {
            f->given[k][i] += f->by[k][i] * 0.0f + 0.0f;
            finite &= fabsf(f->given[k][i]) <= FLT_MAX;
        }
    return finite;
}

/* Where fogs are all there is. Camera rays are white, and the first to add to their colours. */
static void cross_fogs(const shade_context *c, air_segments *s, uint64_t which, colour *out)
{
    const bool first = put_over_nothing(&s->fogs, s->on.count) && s->camera && !c->alpha;

    for (; which; which &= which - 1) {
        const uint32_t i = first_of64(which);
        path *p = &s->paths[i];
        const veil v = fogs_at(&s->fogs, i);

        if (p->solids > 0 || p->gathers > 0)
            continue;
        if (first) {
            out[p->lane] = v.given;
            p->factor.by = v.by;
            continue;
        }
        accumulate(p, v.given, out);
        go_on(p, v.by, c->alpha != NULL);
    }
}

void air_cross(shade_context *c, air_segments *s, uint64_t which, uint64_t seen, colour *out)
{
    if (c->scene->model->rainbows.count == 0 && !c->scene->plan->media) {
        cross_fogs(c, s, which & seen, out);
        return;
    }
    for (; which; which &= which - 1) {
        const uint32_t i = first_of64(which);
        const veil v = veil_of(c, s, i, seen >> i & 1);

        accumulate(&s->paths[i], v.given, out);
        go_on(&s->paths[i], v.by, c->alpha != NULL);
    }
}

/* ---- behind all ---- */

/* What a ray without hits sees, and the part of it that would come from behind: 0 in pictures without alpha. */
typedef struct backdrop { colour seen, through; } backdrop;

static const backdrop nothing = { { 0.0f, 0.0f, 0.0f }, { 1.0f, 1.0f, 1.0f } };

/* What a pigment lets through. */
static colour filter_of(const pigment *p)
{
    const colour t = colour_of(p->transmit, p->transmit, p->transmit);

    return colour_add(t, colour_scale(p->color, p->filter));
}

/* A pigment before it, of a light of its own. */
static void put_before(backdrop *b, const pigment *p, colour own, colour by)
{
    const float opaque = 1.0f - p->filter - p->transmit;

    b->seen = colour_add(colour_scale(own, opaque), colour_mul(by, b->seen));
    b->through = colour_mul(by, b->through);
}

/* Before version 3.7 what all pigments above it filter and what all of them transmit is counted apart, and reaches a pigment
 * without their colours. */
typedef struct old_sky { pigment above; colour sum; } old_sky;

static void put_below(old_sky *sky, bool first, const pigment *p, colour emission)
{
    const float left = (first ? 1.0f : sky->above.filter + sky->above.transmit) * (1.0f - p->filter - p->transmit);

    sky->sum = colour_add(sky->sum, colour_scale(colour_mul(p->color, emission), left));
    sky->above.color = first ? p->color : colour_mul(sky->above.color, p->color);
    sky->above.filter = first ? p->filter : sky->above.filter * p->filter;
    sky->above.transmit = first ? p->transmit : sky->above.transmit * p->transmit;
}

/* Mirrored rays see a background that is transparent in the picture by its plain colour. */
static backdrop background_of(const shade_context *c, const path *p)
{
    const model *m = c->scene->model;
    backdrop b = { m->background, { 0.0f, 0.0f, 0.0f } };

    if (!c->alpha)
        return b;
    b.seen = m->sky_colour.color;
    if (p->mirrored || p->gathers > 0)
        return b;
    b = nothing;
    if (!m->sky_is_old)
        put_before(&b, &m->sky_colour, m->sky_colour.color, filter_of(&m->sky_colour));
    return b;
}

static void add_old_sky(const model *m, const texture_points *points, const uint32_t *lanes, uint32_t n, backdrop *seen)
{
    old_sky sky[BATCH_MAX];
    pigment p[BATCH_MAX];

    memset(sky, 0, n * sizeof *sky);
    for (uint32_t k = m->sky->count; k-- > 0 && n > 0; ) {
        pigment_eval(m, m->sky->layers[k], points, n, p);
        for (uint32_t i = 0; i < n; i++)
            put_below(&sky[i], k + 1 == m->sky->count, &p[i], m->sky->emission);
    }
    for (uint32_t i = 0; i < n; i++) {
        backdrop *b = &seen[lanes[i]];
        const colour by = filter_of(&sky[i].above);

        b->seen = colour_add(sky[i].sum, colour_mul(by, b->seen));
        b->through = colour_mul(by, b->through);
    }
}

/* The sky's pigments, one over the other. */
static void put_sky(const model *m, const texture_points *points, const uint32_t *lanes, uint32_t n, backdrop *seen)
{
    pigment p[BATCH_MAX];

    if (m->sky_is_old) {
        add_old_sky(m, points, lanes, n, seen);
        return;
    }
    for (uint32_t k = 0; k < m->sky->count && n > 0; k++) {
        pigment_eval(m, m->sky->layers[k], points, n, p);
        for (uint32_t i = 0; i < n; i++)
            put_before(&seen[lanes[i]], &p[i], colour_mul(p[i].color, m->sky->emission), filter_of(&p[i]));
    }
}

bool air_is_plain(const model *m)
{
    for (uint32_t k = 0; m->sky && k < m->sky->count; k++)
        if (m->sky->layers[k]->pattern || m->sky->layers[k]->pigments)
            return false;
    return true;
}

colour air_plain_colour(const model *m)
{
    const uint32_t lane = 0;
    backdrop seen = { m->background, { 0.0f, 0.0f, 0.0f } };
    texture_points none;

    none.has_surface = false;
    none.parts = NULL;
    texture_point(&none, lane, pov_vec3_of(0.0, 0.0, 1.0), pov_vec3_of(0.0, 0.0, 0.0));
    if (m->sky)
        put_sky(m, &none, &lane, 1, &seen);
    return seen.seen;
}

static void add_sky(const shade_context *c, const batch *b, uint64_t rays, backdrop *seen)
{
    const model *m = c->scene->model;
    uint32_t lanes[BATCH_MAX], n = 0;
    texture_points points;

    points.has_surface = false;
    points.parts = NULL;
    for (; rays; rays &= rays - 1) {
        const uint32_t i = first_of64(rays);

        if (c->alpha && m->sky_is_old && !b->paths[i].mirrored && b->paths[i].gathers == 0)
            continue;
        lanes[n] = i;
        texture_point(&points, n, pov_unit(b->rays[i]->dir), pov_vec3_of(0.0, 0.0, 0.0));
        n++;
    }
    put_sky(m, &points, lanes, n, seen);
}

void air_background(shade_context *c, batch *b, uint64_t rays, const air_segments *on, colour *out)
{
    const model *m = c->scene->model;
    backdrop seen[BATCH_MAX];

    if (!rays)
        return;
    for (uint64_t rest = rays; rest; rest &= rest - 1)
        seen[first_of64(rest)] = background_of(c, &b->paths[first_of64(rest)]);
    if (m->sky)
        add_sky(c, b, rays, seen);
    for (; rays; rays &= rays - 1) {
        const uint32_t i = first_of64(rays);
        const path *p = &b->paths[i];
        const veil v = on ? veil_of(c, on, i - on->first, true) : clear;

        accumulate(p, colour_add(colour_mul(v.by, seen[i].seen), v.given), out);
        if (c->alpha)
            c->alpha[p->lane] -= p->clear * colour_grey(v.by) * colour_grey(seen[i].through);
    }
}
