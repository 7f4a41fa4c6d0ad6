#include "shade/air.h"

#include "base/elementary.h"
#include "shade/accumulate.h"
#include "shade/haze.h"
#include "texture/noise.h"
#include "texture/texture.h"

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

/* The integral of the density 1 below 0, 1/(1 + y^2) above. */
static double layered_integral(double y) { return y <= 0.0 ? y : elementary_atan(y); }

/* Mean density times length of a layered fog between two heights, in its units above the offset. */
static double layered_course(double y0, double y1, double length)
{
    const double rise = y1 - y0;

    if (rise == 0.0)
        return length * (y0 <= 0.0 ? 1.0 : 1.0 / (1.0 + y0 * y0));
    return length * (layered_integral(y1) - layered_integral(y0)) / rise;
}

/* The same for a ray without end that rises by `slope` a unit of length. */
static double endless_course(double y0, double slope)
{
    const double quarter = 1.57079632679489661923;

    return slope > 0.0 ? (quarter - layered_integral(y0)) / slope : HUGE_VAL;
}

/* Without an `alt` the density is 1 below the offset and 0 above. */
static double stepped_course(double y0, double slope, double length)
{
    const double until = -y0 / slope;   /* length to the step */

    if (y0 <= 0.0)
        return slope > 0.0 && until < length ? until : length;
    return slope < 0.0 && until < length ? length - until : 0.0;
}

/* Length that counts: by the density along it. */
static double fog_course(const fog *f, const segment *s)
{
    const double height = pov_dot(f->up, s->from) - f->offset, slope = pov_dot(f->up, s->dir);

    if (!f->layered)
        return s->length;
    if (f->alt == 0.0)
        return stepped_course(height, slope, s->length);
    if (s->length == HUGE_VAL)
        return endless_course(height / f->alt, slope / f->alt);
    return layered_course(height / f->alt, (height + slope * s->length) / f->alt, s->length);
}

/* Where it is turbulent the fog is thinner, as POV-Ray has it by the middle of the segment. */
static double fog_depth(const shading *scene, const fog *f, const segment *s)
{
    const model *m = scene->model;
    double depth = fog_course(f, s) / f->distance, thinner;
    pov_vec3 middle;

    if (turbulence_is_none(&f->turbulence) || s->length == HUGE_VAL)
        return depth;
    middle = pov_add(s->from, pov_scale(s->dir, 0.5 * s->length));
    middle = pov_vec3_of(middle.x * f->turbulence.amount.x, middle.y * f->turbulence.amount.y, middle.z * f->turbulence.amount.z);
    thinner = f->depth * noise_turbulence_at(m->noise, m->noise_generator, &f->turbulence, middle);
    return depth * (1.0 - elementary_exp(-s->length / f->distance) * (thinner < 1.0 ? thinner : 1.0));
}

static veil fog_veil(const shading *scene, const fog *f, const segment *s)
{
    const double passed = elementary_exp(-fog_depth(scene, f, s));
    const float t = (float)(passed > (double)f->pigment.transmit ? passed : (double)f->pigment.transmit), filter = f->pigment.filter;
    const colour c = f->pigment.color;
    veil v;

    v.by = colour_of(t * (1.0f - filter + filter * c.r), t * (1.0f - filter + filter * c.g), t * (1.0f - filter + filter * c.b));
    v.given = colour_scale(c, 1.0f - t);
    return v;
}

/* Of several fogs each adds its own light, whatever the others let through. */
static veil all_fogs(const shading *scene, const segment *s)
{
    veil all = clear;

    for (size_t i = 0; i < scene->model->fogs.count; i++) {
        const veil v = fog_veil(scene, &scene->model->fogs.items[i], s);

        all.by = colour_mul(all.by, v.by);
        all.given = colour_add(all.given, v.given);
    }
    return all;
}

colour air_fog_dims(const shading *scene, pov_vec3 from, pov_vec3 dir, double length)
{
    const segment s = { from, dir, length };

    return all_fogs(scene, &s).by;
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

    if (around <= inner)
        return 1.0;
    return around >= outer ? 0.0 : 1.0 - u * u * (3.0 - 2.0 * u);
}

/* False: the ray misses the bow. */
static bool rainbow_veil(const rainbow *r, const segment *s, veil *out)
{
    const double angle = elementary_acos(fmin(1.0, fmax(-1.0, pov_dot(s->dir, r->direction)))) / degree;
    const double at = (angle - r->angle + 0.5 * r->width) / r->width;
    const double passed = elementary_exp(-s->length / r->distance);
    pigment c;
    double weight;

    if (!(at > 0.0 && at < 1.0))
        return false;
    c = map_colour(r, at);
    weight = fmin(1.0 - passed, (1.0 - (double)c.transmit) * arc_share(r, s->dir));
    out->by = colour_of((float)(1.0 - weight), (float)(1.0 - weight), (float)(1.0 - weight));
    out->given = colour_scale(c.color, (float)weight);
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

static segment segment_of(const pov_ray *ray, double t)
{
    const double size = pov_largest(ray->dir);
    const pov_vec3 d = pov_scale(ray->dir, 1.0 / size);
    const segment s = { ray->org, pov_unit(ray->dir), t == HUGE_VAL ? t : t * size * sqrt(pov_dot(d, d)) };

    return s;
}

/* Length of a ray that hits nothing, where media fill the scene. */
static const double endless = 2e10;

static veil media_veil(shade_context *c, const path *p, const segment *s)
{
    const bool ends = s->length < HUGE_VAL;
    const media_segment on = { s->from, s->dir, ends ? s->length : endless };
    veil v = clear;

    if (c->scene->plan->media && (p->gathers == 0 || c->scene->model->radiosity.sees_media))
        haze_cross(c, p, &on, ends, &v.by, &v.given);
    return v;
}

/* Fog lies over rainbows, and both over media. There is no fog in solids, and none that radiosity sees. */
static veil veil_of(shade_context *c, const path *p, const segment *s)
{
    const veil near = media_veil(c, p, s), far = p->gathers > 0 ? near : veil_before(all_rainbows(c->scene, s), near);

    return p->solids > 0 || p->gathers > 0 ? far : veil_before(all_fogs(c->scene, s), far);
}

void air_cross(shade_context *c, const path *p, const pov_ray *ray, double t, path *dimmed, colour *out)
{
    const segment s = segment_of(ray, t);
    const veil v = veil_of(c, p, &s);

    *dimmed = *p;
    dimmed->factor.by = colour_mul(p->factor.by, v.by);
    dimmed->clear = p->clear * colour_grey(v.by);
    accumulate(p, v.given, out);
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

/* The same without its colour. */
static colour plain_filter_of(const pigment *p)
{
    const float by = p->filter + p->transmit;

    return colour_of(by, by, by);
}

/* A pigment before it, of a light of its own. */
static void put_before(backdrop *b, const pigment *p, colour own, colour by)
{
    const float opaque = 1.0f - p->filter - p->transmit;

    b->seen = colour_add(colour_scale(own, opaque), colour_mul(by, b->seen));
    b->through = colour_mul(by, b->through);
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

/* The sky's pigments, one over the other. */
static void add_sky(const shade_context *c, const batch *b, uint64_t rays, backdrop *seen)
{
    const model *m = c->scene->model;
    uint32_t lanes[BATCH_MAX], n = 0;
    pigment p[BATCH_MAX];
    texture_points points;

    points.has_surface = false;
    points.parts = NULL;
    for (; rays; rays &= rays - 1) {
        const uint32_t i = first_of64(rays);

        if (c->alpha && m->sky_is_old && !b->paths[i].mirrored && b->paths[i].gathers == 0)
            continue;
        lanes[n] = i;
        texture_point(NULL, pov_unit(b->rays[i]->dir), pov_vec3_of(0.0, 0.0, 0.0), n, &points);
        n++;
    }
    for (uint32_t k = 0; k < m->sky->count && n > 0; k++) {
        pigment_eval(m, m->sky->layers[k], &points, n, p);
        for (uint32_t i = 0; i < n; i++)
            put_before(&seen[lanes[i]], &p[i], colour_mul(p[i].color, m->sky->emission),
                       k > 0 && m->sky_is_old ? plain_filter_of(&p[i]) : filter_of(&p[i]));
    }
}

void air_background(shade_context *c, const batch *b, uint64_t rays, colour *out)
{
    const model *m = c->scene->model;
    backdrop seen[BATCH_MAX];

    for (uint64_t rest = rays; rest; rest &= rest - 1)
        seen[first_of64(rest)] = background_of(c, &b->paths[first_of64(rest)]);
    if (m->sky)
        add_sky(c, b, rays, seen);
    for (; rays; rays &= rays - 1) {
        const uint32_t i = first_of64(rays);
        const path *p = &b->paths[i];
        const segment s = segment_of(b->rays[i], HUGE_VAL);
        const veil v = c->scene->dims ? veil_of(c, p, &s) : clear;

        accumulate(p, colour_add(colour_mul(v.by, seen[i].seen), v.given), out);
        if (c->alpha)
            c->alpha[p->lane] -= p->clear * colour_grey(v.by) * colour_grey(seen[i].through);
    }
}
