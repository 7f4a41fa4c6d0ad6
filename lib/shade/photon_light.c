#include "shade/photon_light.h"

static bool lights(const photon *p, uint32_t solid) { return p->within == photon_free || p->within == solid; }

/* The photons that light a surface: where the camera sees it straight, those of a cell of the pixel. */
static void find(const photon_map *map, const photon_view *view, const surfaces *on, uint32_t i, photon_visit *visit, void *user)
{
    const path *from = on->at[i].from;
    const pov_vec3 at = lanes_at(&on->geometry.to.point, i), normal = lanes_at(&on->geometry.to.normal, i);
    photon_cell cell;

    if (!from->mirrored && from->gathers == 0 && photon_view_cell(view, at, normal, &cell))
        photon_map_count(map, at, normal, &cell, visit, user);
    else
        photon_map_find(map, at, normal, view->least * photon_view_spacing(view, at), visit, user);
}

/* ---- surfaces without highlights ---- */

/* Their light from all directions is the same. */
typedef struct plain_sum { uint32_t solid; pov_vec3 normal; colour sum; } plain_sum;

static inline double facing(const photon *p, pov_vec3 normal)
{
    return -((double)p->dir[0] * normal.x + (double)p->dir[1] * normal.y + (double)p->dir[2] * normal.z);
}

static void add_plain(void *user, const photon *p, float density)
{
    plain_sum *s = user;

    if (lights(p, s->solid) && facing(p, s->normal) > 0.0)
        s->sum = colour_add(s->sum, colour_scale(p->flux, density));
}

static bool is_plain(const appearance *a) { return a->kinds == 0 && a->phong == 0.0f; }

static colour light_plain(const photon_map *map, const photon_view *view, const surfaces *on, uint32_t i, uint32_t solid)
{
    const geometry *g = &on->geometry;
    const appearance *a = on->at[i].appearance;
    plain_sum s = { solid, lanes_at(g->shading, i), { 0.0f, 0.0f, 0.0f } };

    find(map, view, on, i, add_plain, &s);
    return colour_scale(colour_mul(s.sum, a->pigment), a->diffuse_weight);
}

/* ---- others ---- */

/* The surface in every lane. */
static void repeat(photon_lanes *l, const model *m, const surfaces *on, uint32_t lane)
{
    const geometry *from = &on->geometry;
    geometry *to = &l->on.geometry;

    l->on.count = BATCH_MAX;
    l->on.alike = true;
    to->shading = &to->bent;
    to->raw = &to->smooth;
    for (uint32_t i = 0; i < BATCH_MAX; i++) {
        l->on.at[i].appearance = on->at[lane].appearance;
        lanes_put(&to->to.point, i, lanes_at(&from->to.point, lane));
        lanes_put(&to->to.normal, i, lanes_at(&from->to.normal, lane));
        lanes_put(&to->bent, i, lanes_at(from->shading, lane));
        lanes_put(&to->view, i, lanes_at(&from->view, lane));
        lanes_put(&to->reflected, i, lanes_at(&from->reflected, lane));
        lanes_put(&l->in.dir, i, lanes_at(from->shading, lane));
        to->cosine[i] = from->cosine[lane];
    }
    brdf_begin(&l->finishes, m, &l->on, 0);
    l->in.uniform = false;
    l->in.tmax = 1.0;
    l->count = 0;
    l->sum = colour_of(0.0f, 0.0f, 0.0f);
}

/* A photon that grazes the surface tells little: its light is divided by the cosine. */
static const double least_cosine = 0x1p-10;

/* Light the surface by the lanes that are filled. What photons bring is light upon the surface, with the cosine in it. */
static void light_lanes_once(photon_lanes *l, const model *m)
{
    brdf_cosines(&l->sample, &l->on.geometry, &l->in.dir, true, BATCH_MAX);
    for (uint32_t i = 0; i < BATCH_MAX; i++) {
        const double cosine = fabs(l->sample.cosine[i]);
        const float by = i < l->count && cosine > least_cosine ? (float)(1.0 / cosine) : 0.0f;

        l->in.red[i] *= by;
        l->in.green[i] *= by;
        l->in.blue[i] *= by;
    }
    brdf_reflect(&l->finishes, m, &l->sample, &l->in, true, BATCH_MAX);
    for (uint32_t i = 0; i < l->count; i++)
        if (l->sample.contributes[i])
            l->sum = colour_add(l->sum, brdf_at(&l->sample, i));
    l->count = 0;
}

typedef struct lanes_of { photon_lanes *lanes; const model *model; uint32_t solid; } lanes_of;

static void add_lane(void *user, const photon *p, float density)
{
    lanes_of *of = user;
    photon_lanes *l = of->lanes;
    const uint32_t i = l->count;

    if (!lights(p, of->solid))
        return;
    l->count++;
    lanes_put(&l->in.dir, i, pov_vec3_of(-(double)p->dir[0], -(double)p->dir[1], -(double)p->dir[2]));
    l->in.red[i] = p->flux.r * density;
    l->in.green[i] = p->flux.g * density;
    l->in.blue[i] = p->flux.b * density;
    if (l->count == BATCH_MAX)
        light_lanes_once(l, of->model);
}

static colour light_rich(photon_lanes *l, const model *m, const photon_map *map, const photon_view *view, const surfaces *on, uint32_t i,
                         uint32_t solid)
{
    lanes_of of = { l, m, solid };

    repeat(l, m, on, i);
    find(map, view, on, i, add_lane, &of);
    if (l->count > 0)
        light_lanes_once(l, m);
    return l->sum;
}

void photon_light_add(photon_work *w, const shade_context *c, const finishes *lit, surfaces *on)
{
    const model *m = c->scene->model;

    for (uint32_t k = 0; k < lit->count; k++) {
        const uint32_t i = lit->lit[k];
        const surface *s = &on->at[i];
        const photon_map *map = &w->maps[s->from->lane]->of[PHOTON_ON];
        const photon_view *view = &w->views[s->from->lane];
        const uint32_t solid = shading_solid(c->scene, s->at->object);
        colour given;

        if (map->node_count == 0 || (model_leaf(m, s->at->object)->flags & PHOTON_IGNORES))
            continue;
        given = is_plain(s->appearance) ? light_plain(map, view, on, i, solid) : light_rich(&w->lanes, m, map, view, on, i, solid);
        colour_lane_add(&on->lit, i, given);
    }
}
