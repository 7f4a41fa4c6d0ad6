#include "api/trace.h"

#include "api/adapt.h"
#include "api/handles.h"
#include "query/passage.h"
#include "shade/tracer.h"
#include "world/detail.h"

#include <povtrace/exact.h>

pov_status pov_tracer_create(pov_tracer **out, const pov_scene *scene, pov_error *err)
{
    if (out)
        *out = NULL;
    if (!out || !scene)
        return err_set(err, POV_E_ARGUMENT, "a tracer needs a place and a scene");
    return tracer_create(out, scene->shading, err);
}

void pov_tracer_destroy(pov_tracer *tracer)
{
    tracer_destroy(tracer);
}

pov_ray trace_ray(pov_vec3 org, pov_vec3 dir)
{
    const pov_mark no_mark = { 0, 0, 0.0, 0.0 };
    pov_ray ray;

    ray.org = org;
    ray.org_lo = pov_vec3_of(0.0, 0.0, 0.0);
    ray.dir = dir;
    ray.dir_lo = ray.org_lo;
    ray.origin_surface = POV_NO_OWNER;
    ray.origin_mark = no_mark;
    return ray;
}

bool trace_is_ray(pov_vec3 org, pov_vec3 dir)
{
    return pov_largest(pov_unit(dir)) > 0.0 && isfinite(org.x) && isfinite(org.y) && isfinite(org.z);
}

static pov_hit hit_of(const shading *scene, const pov_ray *ray, const hit *h, double distance)
{
    pov_hit found = POV_INIT(found);

    found.distance = distance;
    found.point = h->point;
    found.normal = h->entering ? h->normal : pov_scale(h->normal, -1.0);
    found.shading_normal = found.normal;
    if (shading_info(scene, h->object)->smooth)
        world_shading_normal(scene->world, ray, h, &found.shading_normal);
    found.object = model_object_of(scene->model, h->object);
    found.certain = (h->crossing.mark.flags & POV_MARK_ESCALATED) == 0;
    return found;
}

static bool nearest(const pov_tracer *tracer, const pov_ray *ray, hit *h)
{
    return query_nearest(tracer->context.scene->world, tracer->context.context, &ray, 1, INFINITY, h) != 0;
}

/* A miss is certain if no object on the way was escalated. For a hit only its own crossing counts, because the tree
 * decides which objects behind it are tested. */
bool pov_trace_hit(pov_tracer *tracer, pov_vec3 org, pov_vec3 dir, pov_hit *out)
{
    pov_ray ray = trace_ray(org, dir);
    pov_hit found = POV_INIT(found);
    uint64_t before;
    hit h;

    if (!tracer)
        return false;
    before = query_context_escalated(tracer->context.context);
    if (!trace_is_ray(org, dir) || !nearest(tracer, &ray, &h)) {
        found.certain = query_context_escalated(tracer->context.context) == before;
        if (out)
            adapt_out(out, &found, sizeof found);
        return false;
    }
    world_surface(tracer->context.scene->world, &ray, &h);
    found = hit_of(tracer->context.scene, &ray, &h, h.crossing.t);
    if (out)
        adapt_out(out, &found, sizeof found);
    return true;
}

/* Distance from the ray's start, in lengths of its direction. */
static double distance_to(const hit *h, pov_vec3 org, pov_vec3 dir)
{
    const pov_vec3 along = pov_add(pov_sub(h->point, org), h->point_lo), unit = pov_unit(dir);

    return pov_dot(along, unit) / pov_dot(dir, unit);
}

size_t pov_trace_hits(pov_tracer *tracer, pov_vec3 org, pov_vec3 dir, bool (*visit)(void *user, const pov_hit *hit),
                      void *user)
{
    passage p = { .ray = trace_ray(org, dir) };
    size_t count = 0;
    bool passes_cutoff = tracer && visit && trace_is_ray(org, dir);
    hit h;

    if (passes_cutoff) {
        p.world = tracer->context.scene->world;
        p.context = tracer->context.context;
    }
    while (passes_cutoff && passage_next(&p, &h)) {
        const pov_hit found =
            hit_of(tracer->context.scene, &p.ray, &h, count == 0 ? h.crossing.t : distance_to(&h, org, dir));

        count++;
        passes_cutoff = visit(user, &found);
    }
    return count;
}

bool pov_trace_blocked(pov_tracer *tracer, pov_vec3 from, pov_vec3 to)
{
    const pov_two x = pov_two_sum(to.x, -from.x), y = pov_two_sum(to.y, -from.y), z = pov_two_sum(to.z, -from.z);
    pov_ray ray = trace_ray(from, pov_vec3_of(x.hi, y.hi, z.hi));

    ray.dir_lo = pov_vec3_of(x.lo, y.lo, z.lo);
    return tracer && trace_is_ray(from, ray.dir) &&
        query_blocked(tracer->context.scene->world, tracer->context.context, &ray, 1.0);
}

pov_status pov_trace_color(pov_tracer *tracer, pov_vec3 org, pov_vec3 dir, float rgba[4], pov_error *err)
{
    pov_ray ray = trace_ray(org, dir);
    colour c;

    if (!tracer || !rgba)
        return err_set(err, POV_E_ARGUMENT, "a colour takes a tracer and a place");
    if (!trace_is_ray(org, dir))
        return err_set(err, POV_E_ARGUMENT, "a ray needs a finite start and a direction");
    c = tracer_color(tracer, &ray);
    rgba[0] = c.r;
    rgba[1] = c.g;
    rgba[2] = c.b;
    rgba[3] = 1.0f;
    return tracer->context.failed || query_context_failed(tracer->context.context) ? tracer_error(tracer, err) : POV_OK;
}
