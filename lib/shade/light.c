#include "shade/light.h"

#include "shade/pigment.h"

#include <povtrace/exact.h>

/* From the hit to the light, rounded once: both ends have two parts, so that a light may be near or far. */
static pov_vec3 towards(const light *l, const hit *h)
{
    pov_two3 a = pov_two3_of(l->position, l->position_lo), b = pov_two3_of(h->point, h->point_lo);

    return pov_vec3_of(pov_two_sub(a.x, b.x).hi, pov_two_sub(a.y, b.y).hi, pov_two_sub(a.z, b.z).hi);
}

/* What white light from a unit direction becomes on its way to the ray's start. */
static colour answer(const pov_tracer *t, const surface *s, pov_vec3 direction, double cosine)
{
    const material *m = s->material;
    colour sum = colour_scale(m->pigment, s->opacity * m->diffuse * (float)cosine);
    double along;

    if (!t->plan->highlights || m->phong == 0.0f)
        return sum;
    along = pov_dot(s->mirrored, direction);
    if (along > 0.0) {
        float strength = m->phong * (float)pow(along, m->phong_size);
        sum = colour_add(sum, colour_scale(pigment_highlight(t->model, m, cosine), strength));
    }
    return sum;
}

/* What is left of the light at the surface. */
static bool is_lit(pov_tracer *t, const surface *s, pov_vec3 way, colour *through)
{
    pov_ray ray = { .org = s->at->point, .org_lo = s->at->point_lo, .dir = way,
                    .left = s->at->object, .left_mark = s->at->crossing.mark };

    if (!t->plan->shadows)
        return true;
    t->counts.shadow++;
    return world_light_path(t->world, t->walker, &ray, 1.0, through);
}

colour light_gather(pov_tracer *t, const surface *s)
{
    colour sum = { 0.0f, 0.0f, 0.0f };

    for (size_t i = 0; i < t->model->lights.count; i++) {
        const light *l = &t->model->lights.items[i];
        pov_vec3 way = towards(l, s->at), direction = pov_unit(way);
        double cosine = pov_dot(s->normal, direction);
        colour given, through = { 1.0f, 1.0f, 1.0f };

        if (!(cosine > 0.0)) {
            t->counts.shadow_behind++;
            continue;
        }
        given = colour_mul(l->color, answer(t, s, direction, cosine));
        if (colour_is_black(given))
            t->counts.shadow_idle++;
        else if (is_lit(t, s, way, &through))
            sum = colour_add(sum, colour_mul(given, through));
    }
    return sum;
}
