#include "shade/interior_walk.h"

static const media *media_of(const shading *scene, uint32_t solid)
{
    return dielectric_interior(scene->model, solid)->media;
}

static void add(const shading *scene, interior_walk *w, uint32_t solid)
{
    const interior *in = dielectric_interior(scene->model, solid);

    if ((in->media || in->fade_distance > 0.0) && w->count < WALK_MAX)
        w->in[w->count++] = solid;
}

bool walk_holds(const interior_walk *w, uint32_t solid)
{
    for (uint32_t i = 0; i < w->count; i++)
        if (w->in[i] == solid)
            return true;
    return false;
}

void walk_begin(const shade_context *c, const path *p, interior_walk *w)
{
    w->solids = p->solids;
    w->count = 0;
    for (size_t i = 0; i < p->inside.count; i++)
        add(c->scene, w, c->dielectrics.items[p->inside.first + i]);
}

void walk_cross(const shading *scene, interior_walk *w, uint32_t object, bool entering)
{
    const uint32_t solid = shading_solid(scene, object);

    if (shading_info(scene, object)->filled)
        w->solids = entering ? w->solids + 1 : w->solids - (w->solids > 0);
    for (uint32_t i = 0; i < w->count; i++) {
        if (w->in[i] != solid)
            continue;
        w->in[i] = w->in[--w->count];
        return;
    }
    add(scene, w, solid);
}

void walk_media(const shading *scene, const interior_walk *w, media_set *out)
{
    out->count = out->strata = 0;
    out->varies = out->dims = out->shines = out->scatters = false;
    for (uint32_t i = 0; w->solids == 0 && i < w->count; i++)
        if (media_of(scene, w->in[i]))
            media_set_add(out, media_of(scene, w->in[i]), w->in[i]);
}

void walk_atmosphere(const shading *scene, uint32_t solids, media_set *out)
{
    out->count = out->strata = 0;
    out->varies = out->dims = out->shines = out->scatters = false;
    if (scene->model->atmosphere && solids == 0)
        media_set_add(out, scene->model->atmosphere, MEDIA_AIR);
}
