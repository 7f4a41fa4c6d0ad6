#include "shade/fade.h"

#include "base/elementary.h"
#include "shade/paint.h"

/* From this power on light fades exponentially. */
static const double exponential_power = 1000.0;

static float fade_channel(const interior *in, float c, double distance, double share)
{
    const double lost = 1.0 - (double)c;

    if (in->fade_power >= exponential_power)
        return (float)elementary_exp(-lost * distance / in->fade_distance);
    return (float)((double)c + lost * share);
}

colour fade_over(const interior *in, double distance)
{
    const double share = 1.0 / (1.0 + elementary_pow(distance / in->fade_distance, in->fade_power));
    const colour c = in->fade_color;

    return colour_of(fade_channel(in, c.r, distance, share), fade_channel(in, c.g, distance, share),
                     fade_channel(in, c.b, distance, share));
}

static inline double length_of(pov_vec3 v) { return sqrt(pov_dot(v, v)); }

void fade_inside(const shade_context *c, const path *p, const pov_ray *ray, const hit *h, colour *by)
{
    const shading *scene = c->scene;
    const uint32_t solid = shading_solid(scene, h->object);
    const interior *in = dielectric_interior(scene->model, solid);
    const double before = c->photons_fly ? 0.0 : p->travelled;   /* photons see all surfaces */

    if (!(in->fade_distance > 0.0) || !dielectric_is_in(&c->dielectrics, p->inside, solid))
        return;
    *by = fade_over(in, before + length_of(pov_sub(h->point, ray->org)));
}

/* ---- light ---- */

static inline bool is_before(const pov_crossing *a, const pov_crossing *b)
{
    return a->t != b->t ? a->t < b->t : a->t_lo != b->t_lo ? a->t_lo < b->t_lo : a->owner < b->owner;
}

/* There are few. */
void fade_sort(pov_crossing *at, uint32_t count)
{
    for (uint32_t i = 1; i < count; i++) {
        const pov_crossing one = at[i];
        uint32_t k = i;

        for (; k > 0 && is_before(&one, &at[k - 1]); k--)
            at[k] = at[k - 1];
        at[k] = one;
    }
}

static void take(double by[3], colour c)
{
    by[0] *= (double)c.r;
    by[1] *= (double)c.g;
    by[2] *= (double)c.b;
}

/* Light that crosses a surface steeply is focused by it. */
static colour caustics_at(const shading *scene, const interior *in, const pov_ray *ray, const pov_crossing *at)
{
    hit h = { .object = at->owner, .crossing = *at };
    float by;

    world_surface(scene->world, ray, &h);
    by = (float)paint_focus(scene, ray, &h, 45.0 * (double)in->caustics);
    return colour_of(by, by, by);
}

/* Without a power what is seen through a solid is halved, but not the light that comes through it: so has POV-Ray it. */
void fade_crossings(const shading *scene, const interior_walk *around, const pov_ray *ray, pov_crossing *at, uint32_t count,
                    double by[3])
{
    const double length = length_of(ray->dir);
    interior_walk w = *around;
    double before = 0.0;

    fade_sort(at, count);
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t solid = shading_solid(scene, at[i].owner);
        const interior *in = dielectric_interior(scene->model, solid);

        if (in->caustics != 0.0f)
            take(by, caustics_at(scene, in, ray, &at[i]));
        if (in->fade_distance > 0.0 && in->fade_power > 0.0 && walk_holds(&w, solid))
            take(by, fade_over(in, (at[i].t - before) * length));
        walk_cross(scene, &w, at[i].owner, false);
        before = at[i].t;
    }
}
