/* Many rays of a program at once, a packet after the other. */
#include "api/adapt.h"
#include "api/trace.h"
#include "base/err.h"
#include "query/query.h"
#include "shade/tracer.h"
#include "world/detail.h"

#include <math.h>

/* Up to WORLD_MANY rays of the caller, without those that are none. */
typedef struct chunk {
    uint32_t count;
    pov_ray rays[WORLD_MANY];
    size_t of[WORLD_MANY];       /* their indices */
} chunk;

static void take(chunk *c, size_t first, size_t end, const pov_vec3 *org, const pov_vec3 *dir)
{
    c->count = 0;
    for (size_t i = first; i < end; i++)
        if (trace_is_ray(org[i], dir[i])) {
            c->rays[c->count] = trace_ray(org[i], dir[i]);
            c->of[c->count++] = i;
        }
}

static void put_misses(const pov_found *out, size_t first, size_t end)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };

    for (size_t i = first; i < end; i++) {
        if (out->distance)
            out->distance[i] = HUGE_VAL;
        if (out->point)
            out->point[i] = zero;
        if (out->normal)
            out->normal[i] = zero;
        if (out->object)
            out->object[i] = UINT32_MAX;
        if (out->uv)
            out->uv[2 * i] = out->uv[2 * i + 1] = 0.0;
    }
}

static void put_surface(const pov_found *out, size_t i, const world *w, const hit *h)
{
    if (out->point)
        out->point[i] = h->point;
    if (out->normal)
        out->normal[i] = h->entering ? h->normal : pov_scale(h->normal, -1.0);
    if (out->uv)
        world_uv(w, h, out->uv + 2 * i);
}

/* Points and normals, side by side. */
static void put_surfaces(pov_tracer *t, const size_t *of, const pov_ray *const *rays, hit *const *hits, uint32_t n,
                         const pov_found *out)
{
    const world *w = t->context.scene->world;
    incidence unused;

    world_surface_many(w, query_context_own(t->context.context), rays, hits, n, &unused);
    for (uint32_t i = 0; i < n; i++)
        put_surface(out, of[i], w, hits[i]);
}

static void find_hits(pov_tracer *t, const chunk *c, const pov_found *out)
{
    const shading *scene = t->context.scene;
    const pov_ray *rays[WORLD_MANY];
    hit hits[WORLD_MANY], *met[WORLD_MANY];
    size_t of[WORLD_MANY];
    uint32_t n = 0;
    uint64_t found;

    for (uint32_t i = 0; i < c->count; i++)
        rays[i] = &c->rays[i];
    found = query_nearest(scene->world, t->context.context, rays, c->count, HUGE_VAL, hits);
    for (uint32_t i = 0; i < c->count; i++) {
        if (!(found >> i & 1))
            continue;
        if (out->distance)
            out->distance[c->of[i]] = hits[i].crossing.t;
        if (out->object)
            out->object[c->of[i]] = model_object_of(scene->model, hits[i].object);
        rays[n] = rays[i];
        met[n] = &hits[i];
        of[n++] = c->of[i];
    }
    if (n > 0 && (out->point || out->normal || out->uv))
        put_surfaces(t, of, rays, met, n, out);
}

static void find_colours(pov_tracer *t, const chunk *c, float *rgba)
{
    colour seen[WORLD_MANY];

    tracer_colors(t, c->rays, c->count, TRACER_SOUND, NULL, seen, NULL);
    for (uint32_t i = 0; i < c->count; i++) {
        float *at = rgba + 4 * c->of[i];

        at[0] = seen[i].r;
        at[1] = seen[i].g;
        at[2] = seen[i].b;
    }
}

static void put_black(float *rgba, size_t first, size_t end)
{
    for (size_t i = 4 * first; i < 4 * end; i++)
        rgba[i] = i % 4 == 3 ? 1.0f : 0.0f;
}

pov_status pov_trace_many(pov_tracer *tracer, size_t count, const pov_vec3 *org, const pov_vec3 *dir, const pov_found *out,
                          pov_error *err)
{
    pov_status status;
    pov_found to;
    chunk c;

    if (!tracer || !out || (count > 0 && (!org || !dir)))
        return err_set(err, POV_E_ARGUMENT, "rays take a tracer, starts, directions and a place");
    status = adapt_in(&to, sizeof to, out, "pov_found", err);
    if (status != POV_OK)
        return status;
    for (size_t first = 0; first < count; first += WORLD_MANY) {
        const size_t end = count - first < WORLD_MANY ? count : first + WORLD_MANY;

        take(&c, first, end, org, dir);
        put_misses(&to, first, end);
        if (c.count > 0 && (to.distance || to.point || to.normal || to.object || to.uv))
            find_hits(tracer, &c, &to);
        if (to.rgba)
            put_black(to.rgba, first, end);
        if (to.rgba && c.count > 0)
            find_colours(tracer, &c, to.rgba);
    }
    return tracer->context.failed || query_context_failed(tracer->context.context) ? tracer_error(tracer, err) : POV_OK;
}
