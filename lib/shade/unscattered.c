#include "shade/unscattered.h"

#include "shade/spawn.h"
#include "shade/subsurface.h"

/* A ray that enters is refracted, and so it is again where it leaves. Like POV-Ray's it loses nothing by Fresnel's equations, and
 * what lies in the solid ends it. */

typedef struct crossing { const surface *from; double ior; pov_ray ray; hit out; } crossing;

static bool enter(const surface *s, crossing *c)
{
    const pov_vec3 view = pov_unit(s->ray->dir), normal = s->at->normal;
    const double cosine = -pov_dot(view, normal);

    if (!s->at->entering || !(cosine > 0.0) || !refract(view, normal, cosine, 1.0, c->ior, &c->ray.dir))
        return false;
    world_origin_put(&c->ray, s->at);
    world_origin_transmit(&c->ray, s->at, -pov_dot(c->ray.dir, normal));
    return true;
}

/* Where the ray leaves the solid, and its direction behind it. */
static bool leave(shade_context *c, crossing *of, pov_vec3 *dir)
{
    const world *w = c->scene->world;
    const pov_ray *rays = &of->ray;
    pov_vec3 view, normal;

    if (!query_nearest(w, c->context, &rays, 1, HUGE_VAL, &of->out) || world_solid(w, of->out.object) != world_solid(w, of->from->at->object))
        return false;
    world_surface(w, &of->ray, &of->out);
    view = pov_unit(of->ray.dir);
    normal = pov_scale(of->out.normal, -1.0);
    return !of->out.entering && refract(view, normal, -pov_dot(view, normal), of->ior, 1.0, dir);
}

/* The path behind the solid has the same around it as the one before. */
static void go_on(scattering *to, const crossing *of, pov_vec3 dir, const coefficient *factor)
{
    const dielectric_crossing none = { .index = SIZE_MAX };
    shade_context *c = to->context;
    surface out = *of->from;
    batch *b = batch_branch(to->queue, c->env, &to->queue->transmitted, of->from->from->lane);
    hit at = of->out;
    path *next;

    if (!b) {
        c->failed = true;
        return;
    }
    out.at = &at;
    out.coincident = out.above = 0;
    next = spawn(b, &out, dir, *factor, true);
    world_origin_transmit(&b->own[b->count++], &at, pov_dot(dir, at.normal));
    next->travelled = 0.0;
    spawn_turn(next, TURN_UNSCATTERED);
    if (to->has.alpha)
        next->clear *= colour_grey(factor->by);
    if (c->scene->plan->refraction && next->inside.count > 0 && !dielectric_pass(&c->dielectrics, c->env, &next->inside, &none))
        c->failed = true;
    to->transmitted++;
}

static void cross_solid(scattering *to, const surface *s, const layer *is)
{
    crossing of = { .from = s, .ior = subsurface_ior(to->context->scene, s) };
    pov_vec3 dir, step;
    coefficient factor;
    colour left;

    if (s->from->level >= to->limits.level || !enter(s, &of) || !leave(to->context, &of, &dir))
        return;
    step = pov_sub(of.out.point, s->at->point);
    left = subsurface_unscattered(to->context->scene, s, sqrt(pov_dot(step, step)));
    factor = coefficient_mul(s->from->factor, coefficient_of(is ? colour_mul(left, is->by) : left));
    if (factor.weight >= to->limits.weight)
        go_on(to, &of, dir, &factor);
    else
        to->limits.cut_weight++;
}

void unscattered_rays(scattering *to, const surfaces *on, const layer *of)
{
    for (uint32_t i = 0; i < on->count && !to->context->failed; i++)
        if (on->at[i].appearance->below_weight != 0.0f)
            cross_solid(to, &on->at[i], of ? &of[i] : NULL);
    to->context->failed = to->context->failed || query_context_failed(to->context->context);
}
