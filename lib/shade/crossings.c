#include "shade/crossings.h"

#include "base/powers.h"
#include "base/simd.h"
#include "shade/fade.h"
#include "shade/paint.h"

/* Crossings to be looked at together, those of a ray in their order. */
typedef struct crossed {
    const shading *scene;
    light_product *out;          /* by ray */
    uint32_t count;
    uint8_t ray[BATCH_MAX];
    const pov_ray *rays[BATCH_MAX];
    const pov_crossing *at[BATCH_MAX];
} crossed;

static void begin(crossed *x, const shading *scene, light_product *out)
{
    x->scene = scene;
    x->out = out;
    x->count = 0;
}

static uint32_t add(crossed *x, uint32_t which, const pov_ray *ray, const pov_crossing *at)
{
    x->ray[x->count] = (uint8_t)which;
    x->rays[x->count] = ray;
    x->at[x->count] = at;
    return x->count++;
}

/* Points and normals of some of them, as of hits. */
typedef struct completed {
    hit own[BATCH_MAX];
    const hit *hits[BATCH_MAX];
    const pov_ray *rays[BATCH_MAX];
    light_crossings at;
} completed;

static void complete(const crossed *x, uint64_t some, completed *c)
{
    hit *hits[BATCH_MAX];
    incidence unused;
    uint32_t n = 0;

    for (; some; some &= some - 1, n++) {
        const uint32_t i = first_of64(some);

        c->own[n].object = x->at[i]->owner;
        c->own[n].crossing = *x->at[i];
        c->hits[n] = hits[n] = &c->own[n];
        c->rays[n] = x->rays[i];
    }
    if (n > 0)
        world_surface_many(x->scene->world, NULL, c->rays, hits, n, &unused);
    c->at.rays = c->rays;
    c->at.hits = c->hits;
    c->at.count = n;
}

/* ---- filters ---- */

static void paint_some(const crossed *x, uint64_t some, colour *filter)
{
    colour by[BATCH_MAX];
    completed c;

    complete(x, some, &c);
    paint_filters(x->scene, &c.at, by);
    for (uint32_t n = 0; some; some &= some - 1)
        filter[first_of64(some)] = by[n++];
}

static void filter_all(crossed *x)
{
    colour filter[BATCH_MAX];
    uint64_t varying = 0;

    for (uint32_t i = 0; i < x->count; i++) {
        const appearance *a = shading_constant(x->scene, x->at[i]->owner);

        varying |= (uint64_t)a->varies << i;
        filter[i] = a->onward.filter.by;
    }
    if (varying)
        paint_some(x, varying, filter);
    for (uint32_t i = 0; i < x->count; i++)
        light_take(&x->out[x->ray[i]], filter[i]);
    x->count = 0;
}

void crossings_filter(const shading *scene, const pov_ray *const *rays, const occlusion *found, uint64_t which, light_product *out)
{
    crossed x;

    begin(&x, scene, out);
    for (; which; which &= which - 1) {
        const uint32_t i = first_of64(which);

        for (uint32_t k = 0; k < found->count[i]; k++) {
            add(&x, i, rays[i], &found->at[i][k]);
            if (x.count == BATCH_MAX)
                filter_all(&x);
        }
    }
    filter_all(&x);
}

/* ---- what light is focused by, and fades in ---- */

typedef struct fading {
    crossed on;
    uint64_t focuses, fades;     /* bits of these crossings */
    double power[BATCH_MAX];     /* of the cosine, where light is focused */
    const interior *in[BATCH_MAX];
    double distance[BATCH_MAX];  /* in the solid, where it fades */
} fading;

/* Light that crosses a surface steeply is focused by it. */
static void find_focus(const fading *f, float *out)
{
    double power[BATCH_MAX], by[BATCH_MAX];
    uint64_t rest = f->focuses;
    completed c;

    complete(&f->on, rest, &c);
    for (uint32_t n = 0; rest; rest &= rest - 1)
        power[n++] = f->power[first_of64(rest)];
    paint_focus(f->on.scene, &c.at, power, by);
    rest = f->focuses;
    for (uint32_t n = 0; rest; rest &= rest - 1)
        out[first_of64(rest)] = (float)by[n++];
}

/* Powers of distances, in units of those at which half of the light is left. */
static void find_powers(const fading *f, double *out)
{
    double power[BATCH_MAX], value[BATCH_MAX];
    uint32_t n = 0;

    for (uint64_t rest = f->fades; rest; rest &= rest - 1, n++) {
        const uint32_t i = first_of64(rest);

        power[n] = f->in[i]->fade_power;
        value[n] = f->distance[i] / f->in[i]->fade_distance;
    }
    powers_raise_each(power, n, value);
    n = 0;
    for (uint64_t rest = f->fades; rest; rest &= rest - 1)
        out[first_of64(rest)] = value[n++];
}

static void fade_all(fading *f)
{
    double power[BATCH_MAX];
    float focus[BATCH_MAX];

    if (f->focuses)
        find_focus(f, focus);
    if (f->fades)
        find_powers(f, power);
    for (uint32_t i = 0; i < f->on.count; i++) {
        light_product *out = &f->on.out[f->on.ray[i]];

        if (f->focuses >> i & 1)
            light_take(out, colour_of(focus[i], focus[i], focus[i]));
        if (f->fades >> i & 1)
            light_take(out, fade_by(f->in[i], f->distance[i], power[i]));
    }
    f->on.count = 0;
    f->focuses = f->fades = 0;
}

/* Without a power what is seen through a solid is halved, but not the light that comes through it: so has POV-Ray it. */
static void add_fading(fading *f, uint32_t which, const pov_ray *ray, const pov_crossing *at, const interior *in, bool within,
                       double distance)
{
    const bool fades = within && in->fade_distance > 0.0 && in->fade_power > 0.0;
    uint32_t n;

    if (!fades && in->caustics == 0.0f)
        return;
    n = add(&f->on, which, ray, at);
    f->focuses |= (uint64_t)(in->caustics != 0.0f) << n;
    f->fades |= (uint64_t)fades << n;
    f->power[n] = 45.0 * (double)in->caustics;
    f->in[n] = in;
    f->distance[n] = distance;
    if (f->on.count == BATCH_MAX)
        fade_all(f);
}

static void add_ray(fading *f, uint32_t which, const interior_walk *around, const pov_ray *ray, const pov_crossing *at, uint32_t count)
{
    const shading *scene = f->on.scene;
    const double length = sqrt(pov_dot(ray->dir, ray->dir));
    interior_walk w = *around;
    double before = 0.0;

    for (uint32_t k = 0; k < count; k++) {
        const uint32_t solid = shading_solid(scene, at[k].owner);

        add_fading(f, which, ray, &at[k], dielectric_interior(scene->model, solid), walk_holds(&w, solid), (at[k].t - before) * length);
        walk_cross(scene, &w, at[k].owner, false);
        before = at[k].t;
    }
}

void crossings_fade(const shading *scene, const interior_walk *around, const pov_ray *const *rays, const occlusion *found, uint64_t which,
                    light_product *out)
{
    fading f;

    begin(&f.on, scene, out);
    f.focuses = f.fades = 0;
    for (; which; which &= which - 1) {
        const uint32_t i = first_of64(which);

        fade_sort(found->at[i], found->count[i]);
        add_ray(&f, i, &around[i], rays[i], found->at[i], found->count[i]);
    }
    fade_all(&f);
}
