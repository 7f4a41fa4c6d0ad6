#include "shade/paint.h"
#include "shade/paint_group.h"
#include "world/detail.h"

/* The normal, turned against the ray. */
static pov_vec3 facing(const pov_ray *ray, const hit *h)
{
    return pov_dot(h->normal, ray->dir) > 0.0 ? pov_scale(h->normal, -1.0) : h->normal;
}

static const texture *texture_across(const shading *scene, const pov_ray *ray, const hit *h)
{
    return paint_texture_of(scene, shading_constant(scene, h->object)->material, ray, h);
}

/* Of these crossings those of the first one's texture are added. Returns the others. smooth: with normals that shading has. */
static uint64_t add_crossed(paint_group *g, const shading *scene, const light_crossings *at, uint64_t lanes, bool smooth)
{
    const uint32_t first = first_of64(lanes);
    uint32_t object[BATCH_MAX];
    uint64_t rest = lanes;

    paint_group_begin(g, texture_across(scene, at->rays[first], at->hits[first]));
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = first_of64(lanes), n = g->count;
        const hit *h = at->hits[i];
        pov_vec3 normal = facing(at->rays[i], h);

        if (i != first && texture_across(scene, at->rays[i], h) != g->texture)
            continue;
        if (g->texture) {
            paint_group_add_point(g, scene, h);
            if (scene->uvs)
                paint_group_add_uv(g, scene, h);
        }
        if (smooth && shading_info(scene, h->object)->smooth)
            world_shading_normal(scene->world, at->rays[i], h, &normal);
        lanes_put(&g->points.normal, n, normal);
        lanes_put(&g->points.view, n, pov_unit(at->rays[i]->dir));
        object[n] = h->object;
        g->lane[g->count++] = (uint8_t)i;
        rest &= ~((uint64_t)1 << i);
    }
    if (g->texture)
        paint_group_enter(g, scene, object);
    g->points.has_view = true;
    return rest;
}

static uint64_t all_crossed(const light_crossings *at) { return at->count > 0 ? ~(uint64_t)0 >> (BATCH_MAX - at->count) : 0; }

void paint_filters(const shading *scene, const light_crossings *at, colour *out)
{
    colour filters[BATCH_MAX];
    paint_group g;

    for (uint64_t rest = all_crossed(at); rest;) {
        rest = add_crossed(&g, scene, at, rest, false);
        texture_filters(scene->model, g.texture, &g.points, g.count, filters);
        for (uint32_t i = 0; i < g.count; i++)
            out[g.lane[i]] = filters[i];
    }
}

void paint_focus(const shading *scene, const light_crossings *at, const double *power, double *out)
{
    SIMD_ALIGNED double own[BATCH_MAX], by[BATCH_MAX];
    paint_group g;

    for (uint64_t rest = all_crossed(at); rest;) {
        rest = add_crossed(&g, scene, at, rest, true);
        for (uint32_t i = 0; i < g.count; i++)
            own[i] = power[g.lane[i]];
        if (g.texture)
            texture_focus(scene->model, g.texture, &g.points, own, g.count, by);
        else
            texture_focus_of(&g.points.normal, &g.points.view, own, g.count, by);
        for (uint32_t i = 0; i < g.count; i++)
            out[g.lane[i]] = by[i];
    }
}
