#include "shade/paint.h"

#include "base/simd.h"
#include "texture/texture.h"
#include "world/detail.h"

/* The surfaces of one material, by lane of the texture. */
typedef struct group {
    uint32_t count;
    uint8_t lane[BATCH_MAX];
    texture_points points;
    texture_part parts[BATCH_MAX];
} group;

/* The part of its object that a hit is on. */
static void find_part(const shading *scene, const hit *h, texture_part *out)
{
    double share[3];

    out->count = world_part_textures(scene->world, h, out->which, share);
    for (uint32_t i = 0; i < out->count; i++)
        out->share[i] = (float)share[i];
}

static void add(group *g, const shading *scene, const surfaces *s, uint32_t lane)
{
    const incidence *to = &s->geometry.to;

    if (s->at[lane].appearance->material->texture->blend == BLEND_PARTS)
        find_part(scene, s->at[lane].at, &g->parts[g->count]);
    g->lane[g->count] = (uint8_t)lane;
    texture_point(model_texture_map(scene->model, s->at[lane].at->object), lanes_at(&to->point, lane),
                  lanes_at(&to->point_lo, lane), g->count++, &g->points);
}

/* The layer on top, of blends that of the first member. */
static const pigment_node *pigment_of(const texture *of)
{
    while (of->blend != BLEND_NONE)
        of = of->textures[of->blend == BLEND_LAYERS ? of->count - 1 : 0];
    return of->pigment;
}

static void paint(const shading *scene, surfaces *s, const group *g, const appearance *of)
{
    pigment pigments[BATCH_MAX];

    pigment_eval(scene->model, pigment_of(of->material->texture), &g->points, g->count, pigments);
    for (uint32_t i = 0; i < g->count; i++) {
        appearance *out = &s->varying[g->lane[i]];

        appearance_paint(out, scene->plan, scene->model, of, &pigments[i]);
        s->at[g->lane[i]].appearance = out;
    }
}

/* Bit i: the texture of surface i varies. */
static uint64_t varying(const surfaces *s)
{
    uint64_t lanes = 0;

    for (uint32_t i = 0; i < s->count; i++)
        lanes |= (uint64_t)s->at[i].appearance->varies << i;
    return lanes;
}

void paint_surfaces(const shading *scene, surfaces *s)
{
    for (uint64_t rest = varying(s); rest;) {
        const appearance *of = s->at[first_of64(rest)].appearance;
        group g;

        g.count = 0;
        g.points.has_surface = false;
        g.points.parts = g.parts;
        for (uint64_t lanes = rest; lanes; lanes &= lanes - 1) {
            const uint32_t i = first_of64(lanes);

            if (s->at[i].appearance != of)
                continue;
            add(&g, scene, s, i);
            rest &= ~((uint64_t)1 << i);
        }
        paint(scene, s, &g, of);
    }
}

colour paint_filter(const shading *scene, const hit *h)
{
    const material *of = shading_constant(scene, h->object)->material;
    texture_points points;
    texture_part part;
    colour filter;

    points.has_surface = false;
    points.parts = &part;
    if (of->texture->blend == BLEND_PARTS)
        find_part(scene, h, &part);
    texture_point(model_texture_map(scene->model, h->object), h->point, h->point_lo, 0, &points);
    texture_filters(scene->model, of->texture, &points, 1, &filter);
    return filter;
}
