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

/* Note the ray from a surface to the light, or add what it gives where nothing can stand in the way. */
static void ask(pov_tracer *t, surface *s, pov_vec3 way, colour given)
{
    light_rays *l = &t->light_rays;
    pov_ray *ray = &l->rays[l->count];

    if (!t->plan->shadows) {
        s->lit = colour_add(s->lit, given);
        return;
    }
    ray->org = s->at.point;
    ray->org_lo = s->at.point_lo;
    ray->dir = way;
    ray->left = s->at.object;
    ray->left_mark = s->at.crossing.mark;
    l->of[l->count] = s;
    l->given[l->count++] = given;
}

static bool any_on_spot(const light_rays *l)
{
    for (uint32_t i = 0; i < l->count; i++)
        if (l->of[i]->spot)
            return true;
    return false;
}

/* Rays from surfaces that lie on others go alone. */
static uint64_t light_each(pov_tracer *t, const light_rays *l, colour *through)
{
    uint64_t lit = 0;

    for (uint32_t i = 0; i < l->count; i++) {
        const uint32_t at = l->of[i]->spot;
        const bool is_lit = at ? world_light_path_from(t->world, t->walker, &t->spots.items[at - 1], &l->rays[i], 1.0,
                                                       &through[i])
                               : world_light_path(t->world, t->walker, &l->rays[i], 1.0, &through[i]);
        lit |= (uint64_t)is_lit << i;
    }
    return lit;
}

static void send(pov_tracer *t)
{
    light_rays *l = &t->light_rays;
    const pov_ray *rays[BATCH_MAX];
    colour through[BATCH_MAX];
    uint64_t lit;
    uint32_t i;

    for (i = 0; i < l->count; i++)
        rays[i] = &l->rays[i];
    t->counts.shadow += l->count;
    lit = any_on_spot(l) ? light_each(t, l, through)
                         : world_light_path_many(t->world, t->walker, rays, l->count, 1.0, through);
    for (i = 0; i < l->count; i++)
        if (lit >> i & 1)
            l->of[i]->lit = colour_add(l->of[i]->lit, colour_mul(l->given[i], through[i]));
    l->count = 0;
}

static void shine(pov_tracer *t, const light *l, surface *s)
{
    pov_vec3 way = towards(l, &s->at), direction = pov_unit(way);
    double cosine = pov_dot(s->normal, direction);
    colour given;

    if (!(cosine > 0.0)) {
        t->counts.shadow_behind++;
        return;
    }
    given = colour_mul(l->color, answer(t, s, direction, cosine));
    if (colour_is_black(given))
        t->counts.shadow_idle++;
    else
        ask(t, s, way, given);
}

void light_gather(pov_tracer *t, surface *const *surfaces, uint32_t n)
{
    uint32_t i;

    for (i = 0; i < n; i++)
        surfaces[i]->lit = colour_of(0.0f, 0.0f, 0.0f);
    for (size_t k = 0; k < t->model->lights.count && !t->failed && !tracer_gives_up(t, n); k++) {
        for (i = 0; i < n; i++)
            shine(t, &t->model->lights.items[k], surfaces[i]);
        if (t->light_rays.count > 0)
            send(t);
        t->failed = t->failed || walker_failed(t->walker);
    }
}
