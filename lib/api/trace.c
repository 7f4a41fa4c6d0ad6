#include "api/adapt.h"
#include "api/handles.h"
#include "shade/tracer.h"

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

static pov_hit hit_of(const hit *h, double distance)
{
    pov_hit found = POV_INIT(found);

    found.distance = distance;
    found.point = h->point;
    found.normal = h->entering ? h->normal : pov_scale(h->normal, -1.0);
    found.shading_normal = found.normal;
    found.object = h->object;
    found.certain = (h->crossing.mark.flags & POV_MARK_DECIDED) == 0;
    return found;
}

/* A miss is certain if no object on the way had to be decided; of a hit its own crossing counts, for what lies behind
 * it is looked at or not as the tree has it. */
bool pov_trace_hit(pov_tracer *tracer, pov_vec3 org, pov_vec3 dir, pov_hit *out)
{
    pov_ray ray = ray_of(org, dir);
    pov_hit found = POV_INIT(found);
    uint64_t before;
    hit h;

    if (!tracer)
        return false;
    before = walker_decided(tracer->context.walker);
    if (!is_ray(org, dir) || !world_nearest(tracer->context.scene->world, tracer->context.walker, &ray, INFINITY, &h)) {
        found.certain = walker_decided(tracer->context.walker) == before;
        if (out)
            adapt_out(out, &found, sizeof found);
        return false;
    }
    world_surface(tracer->context.scene->world, &ray, &h);
    found = hit_of(&h, h.crossing.t);
    if (out)
        adapt_out(out, &found, sizeof found);
    return true;
}

/* A ray that goes straight on through all that it meets, and the surfaces on each other that it stands on, if any. */
typedef struct passage {
    pov_tracer *tracer;
    pov_ray ray;
    spot on;
    int standing;                /* crossings in a row that did not move it */
} passage;

/* The spot's surface that a direction meets first is crossed; the others of it come next. */
static void cross_spot(passage *p, const hit *h)
{
    uint32_t which = 0;

    while (which + 1 < p->on.count && p->on.at[which].object != h->object)
        which++;
    spot_pass(&p->on, which);
}

/* What lies on the spot and is still to be crossed. */
static bool next_of_spot(passage *p, hit *h)
{
    const uint32_t which = spot_crossed(&p->on, p->ray.dir);

    if (which >= p->on.count)
        return false;
    *h = p->on.at[which];
    h->entering = pov_dot(h->normal, p->ray.dir) < 0.0;
    return true;
}

static bool next_ahead(passage *p, hit *h)
{
    const world *w = p->tracer->context.scene->world;
    walker *k = p->tracer->context.walker;
    const bool stands = p->on.count > 0;
    spot on;

    if (!(stands ? world_nearest_from(w, k, &p->on, &p->ray, INFINITY, h) : world_nearest(w, k, &p->ray, INFINITY, h)))
        return false;
    if (h->company)
        world_spot(w, k, &p->ray, stands ? &p->on : NULL, h, &on);
    else
        on.count = 0;
    p->on = on;
    world_surface(w, &p->ray, h);
    return true;
}

static bool next_surface(passage *p, hit *h)
{
    /* As for transmitted rays: more surfaces on one spot than are told apart could hand a ray back and forth. */
    enum { STANDING_MAX = 1000 };
    const pov_vec3 from = p->ray.org;
    bool met = (p->on.count > 0 && next_of_spot(p, h)) || next_ahead(p, h);

    if (!met || walker_failed(p->tracer->context.walker))
        return false;
    if (p->on.count > 0)
        cross_spot(p, h);
    p->ray.org = h->point;
    p->ray.org_lo = h->point_lo;
    p->ray.left = h->object;
    p->ray.left_mark = h->crossing.mark;
    p->standing = from.x == h->point.x && from.y == h->point.y && from.z == h->point.z ? p->standing + 1 : 0;
    return p->standing <= STANDING_MAX;
}

/* From the ray's start, in lengths of its direction. */
static double distance_to(const hit *h, pov_vec3 org, pov_vec3 dir)
{
    const pov_vec3 way = pov_add(pov_sub(h->point, org), h->point_lo), unit = pov_unit(dir);

    return pov_dot(way, unit) / pov_dot(dir, unit);
}

size_t pov_trace_hits(pov_tracer *tracer, pov_vec3 org, pov_vec3 dir, bool (*see)(void *user, const pov_hit *hit),
                      void *user)
{
    passage p = { .tracer = tracer, .ray = ray_of(org, dir) };
    size_t count = 0;
    bool goes_on = tracer && see && is_ray(org, dir);
    hit h;

    while (goes_on && next_surface(&p, &h)) {
        const pov_hit found = hit_of(&h, count == 0 ? h.crossing.t : distance_to(&h, org, dir));

        count++;
        goes_on = see(user, &found);
    }
    return count;
}

bool pov_trace_blocked(pov_tracer *tracer, pov_vec3 from, pov_vec3 to)
{
    pov_ray ray = ray_of(from, pov_sub(to, from));

    return tracer && is_ray(from, ray.dir) && world_blocked(tracer->context.scene->world, tracer->context.walker, &ray, 1.0);
}

pov_status pov_trace_color(pov_tracer *tracer, pov_vec3 org, pov_vec3 dir, float rgba[4], pov_error *err)
{
    pov_ray ray = ray_of(org, dir);
    colour c;

    if (!tracer || !rgba)
        return err_set(err, POV_E_ARGUMENT, "a colour takes a tracer and a place");
    if (!is_ray(org, dir))
        return err_set(err, POV_E_ARGUMENT, "a ray needs a finite start and a direction");
    c = tracer_color(tracer, &ray);
    rgba[0] = c.r;
    rgba[1] = c.g;
    rgba[2] = c.b;
    rgba[3] = 1.0f;
    return tracer->context.failed || walker_failed(tracer->context.walker) ? err_memory(err) : POV_OK;
}
