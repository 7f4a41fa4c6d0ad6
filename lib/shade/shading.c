#include "shade/shading.h"

#include "base/err.h"
#include "shade/air.h"

static bool make_appearances(shading *s, const model *m)
{
    s->appearances = env_alloc(m->env, m->materials.count, sizeof *s->appearances);
    for (size_t i = 0; s->appearances && i < m->materials.count; i++)
        appearance_make(&s->appearances[i], s->plan, m, &m->materials.items[i]);
    return s->appearances || m->materials.count == 0;
}

static bool make_light(scene_light *out, const env *e, const light *l)
{
    const bool is_area = (l->flags & LIGHT_AREA) && l->area.counts[0] * l->area.counts[1] > 1;

    out->light = l;
    out->class = light_class_of(l);
    out->grid = is_area ? grid_create(e, l) : NULL;
    return out->grid || !is_area;
}

static bool make_lights(shading *s, const model *m)
{
    s->light_count = m->lights.count;
    s->lights = env_alloc(m->env, s->light_count, sizeof *s->lights);
    for (size_t i = 0; s->lights && i < s->light_count; i++)
        if (!make_light(&s->lights[i], m->env, &m->lights.items[i]))
            return false;
    return s->lights || s->light_count == 0;
}

pov_status shading_create(shading **out, const model *m, const world *w, pov_error *err)
{
    shading *s = env_alloc(m->env, 1, sizeof *s);

    if (!s)
        return err_memory(err);
    s->model = m;
    s->world = w;
    s->plan = world_plan(w);
    s->air = air_is_there(m);
    s->dims = air_dims(m);
    s->objects_info = world_object_info(w);
    s->unseen.transmissive = s->unseen.needs_point = s->unseen.clear = true;
    s->unseen.filter = coefficient_of(colour_of(1.0f, 1.0f, 1.0f));
    if (!make_appearances(s, m) || !make_lights(s, m)) {
        shading_destroy(s);
        return err_memory(err);
    }
    *out = s;
    return POV_OK;
}

void shading_destroy(shading *s)
{
    if (!s)
        return;
    env_free(s->model->env, s->appearances);
    for (size_t i = 0; s->lights && i < s->light_count; i++)
        env_free(s->model->env, s->lights[i].grid);
    env_free(s->model->env, s->lights);
    env_free(s->model->env, s);
}
