#include "api/adapt.h"
#include "api/handles.h"
#include "shade/shade.h"

pov_status pov_tracer_create(pov_tracer **out, const pov_scene *scene, pov_error *err)
{
    if (out)
        *out = NULL;
    if (!out || !scene)
        return err_set(err, POV_E_ARGUMENT, "a tracer needs a place and a scene");
    return tracer_create(out, &scene->model, scene->world, err);
}

void pov_tracer_destroy(pov_tracer *tracer)
{
    tracer_destroy(tracer);
}

static pov_ray ray_of(pov_vec3 org, pov_vec3 dir)
{
    const pov_mark no_mark = { 0, 0, 0.0, 0.0 };
    pov_ray ray;

    ray.org = org;
    ray.org_lo = pov_vec3_of(0.0, 0.0, 0.0);
    ray.dir = dir;
    ray.dir_lo = ray.org_lo;
    ray.left = POV_NOBODY;
    ray.left_mark = no_mark;
    return ray;
}

/* Could a ray of these be traced at all? A direction of zero or of no number meets nothing. */
static bool is_ray(pov_vec3 org, pov_vec3 dir)
{
    return pov_largest(pov_unit(dir)) > 0.0 && isfinite(org.x) && isfinite(org.y) && isfinite(org.z);
}

/* A miss is certain if no object on the way had to be decided; of a hit its own crossing counts, for what lies behind
 * it is looked at or not as the tree has it. */
bool pov_trace_hit(pov_tracer *tracer, pov_vec3 org, pov_vec3 dir, pov_hit *out)
{
    const uint64_t before = walker_decided(tracer->walker);
    pov_ray ray = ray_of(org, dir);
    pov_hit found = POV_INIT(found);
    hit h;

    if (!is_ray(org, dir) || !world_nearest(tracer->world, tracer->walker, &ray, INFINITY, &h)) {
        found.certain = walker_decided(tracer->walker) == before;
        if (out)
            adapt_out(out, &found, sizeof found);
        return false;
    }
    world_surface(tracer->world, &ray, &h);
    found.distance = h.crossing.t;
    found.point = h.point;
    found.normal = h.entering ? h.normal : pov_scale(h.normal, -1.0);
    found.object = h.object;
    found.certain = (h.crossing.mark.flags & POV_MARK_DECIDED) == 0;
    if (out)
        adapt_out(out, &found, sizeof found);
    return true;
}

bool pov_trace_blocked(pov_tracer *tracer, pov_vec3 from, pov_vec3 to)
{
    pov_ray ray = ray_of(from, pov_sub(to, from));

    return is_ray(from, ray.dir) && world_blocked(tracer->world, tracer->walker, &ray, 1.0);
}

pov_status pov_trace_color(pov_tracer *tracer, pov_vec3 org, pov_vec3 dir, float rgba[4], pov_error *err)
{
    pov_ray ray = ray_of(org, dir);
    colour c;

    if (!is_ray(org, dir))
        return err_set(err, POV_E_ARGUMENT, "a ray needs a finite start and a direction");
    c = tracer_color(tracer, &ray);
    rgba[0] = c.r;
    rgba[1] = c.g;
    rgba[2] = c.b;
    rgba[3] = 1.0f;
    return tracer->failed || walker_failed(tracer->walker) ? err_memory(err) : POV_OK;
}
