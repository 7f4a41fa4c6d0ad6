#include "shade/paint_group.h"

#include "world/detail.h"

const texture *paint_texture_of(const shading *scene, const material *m, const pov_ray *ray, const hit *h)
{
    return m->inside && !world_is_at_front(scene->world, ray, h) ? m->inside : m->texture;
}

enum { PARTS_FIT = 1 / (TEXTURE_PARTS_MAX == POV_TEXTURES_MAX) };   /* else this does not compile */

/* The part of its object that a hit is on. */
static void find_part(const shading *scene, const hit *h, texture_part *out)
{
    double share[POV_TEXTURES_MAX];

    out->count = world_part_textures(scene->world, h, out->which, share);
    for (uint32_t i = 0; i < out->count; i++)
        out->share[i] = (float)share[i];
}

void paint_group_begin(paint_group *g, const texture *of)
{
    g->texture = of;
    g->count = 0;
    g->points.parts = g->parts;
}

void paint_group_add_point(paint_group *g, const shading *scene, const hit *h)
{
    if (g->texture->blend == BLEND_PARTS)
        find_part(scene, h, &g->parts[g->count]);
    texture_point(&g->points, g->count, h->point, h->point_lo);
    if (scene->worlds)
        lanes_put(&g->points.world, g->count, h->point);
}

void paint_group_add_uv(paint_group *g, const shading *scene, const hit *h)
{
    double uv[2] = { 0.0, 0.0 };

    if (model_leaf(scene->model, h->object)->flags & LEAF_UV)
        world_uv(scene->world, h, uv);
    lanes_put(&g->points.uv, g->count, pov_vec3_of(uv[0], uv[1], 0.0));
}

/* Do two leaves have one map? */
static inline bool have_one_map(const model *m, uint32_t a, uint32_t b)
{
    const uint32_t own = (uint32_t)m->leaves.count;

    return a == b || (a < own && b < own && model_texture_map_number(m, a) == model_texture_map_number(m, b));
}

void paint_group_enter(paint_group *g, const shading *scene, const uint32_t *object)
{
    inverse_map space;
    uint32_t first, end;

    g->points.has_surface = g->points.in_world = true;
    g->points.has_world = scene->worlds;
    g->points.has_uv = scene->uvs;
    g->points.has_view = scene->views;
    if (!paint_has_spaces(scene->model))
        return;
    for (first = 0; first < g->count; first = end) {
        const inverse_map *map = world_texture_map(scene->world, scene->model, object[first], &space, &g->linear[first]);

        for (end = first; end < g->count && have_one_map(scene->model, object[first], object[end]); end++)
            g->points.linear[end] = map ? map->linear : NULL;
        texture_points_map(map, first, end, &g->points);
        g->points.in_world &= !map;
    }
}
