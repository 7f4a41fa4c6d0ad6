#include "shade/fade.h"

#include "base/elementary.h"

/* From this power on light fades exponentially. */
static const double exponential_power = 1000.0;

static float fade_channel(const interior *in, float c, double distance, double share)
{
    const double lost = 1.0 - (double)c;

    if (in->fade_power >= exponential_power)
        return (float)elementary_exp(-lost * distance / in->fade_distance);
    return (float)((double)c + lost * share);
}

colour fade_by(const interior *in, double distance, double power)
{
    const double share = 1.0 / (1.0 + power);
    const colour c = in->fade_color;

    return colour_of(fade_channel(in, c.r, distance, share), fade_channel(in, c.g, distance, share),
                     fade_channel(in, c.b, distance, share));
}

colour fade_over(const interior *in, double distance)
{
    const bool exponential = in->fade_power >= exponential_power;   /* it asks for no power */

    return fade_by(in, distance, exponential ? 0.0 : elementary_pow(distance / in->fade_distance, in->fade_power));
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
