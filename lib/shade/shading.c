#include "shade/shading.h"

#include "base/err.h"

pov_status shading_create(shading **out, const model *m, const world *w, pov_error *err)
{
    shading *s = env_alloc(m->env, 1, sizeof *s);

    if (!s)
        return err_memory(err);
    s->model = m;
    s->world = w;
    s->plan = world_plan(w);
    s->things = world_things(w);
    s->appearances = env_alloc(m->env, m->materials.count, sizeof *s->appearances);
    if (!s->appearances && m->materials.count > 0) {
        shading_destroy(s);
        return err_memory(err);
    }
    for (size_t i = 0; i < m->materials.count; i++)
        appearance_make(&s->appearances[i], s->plan, m, &m->materials.items[i]);
    *out = s;
    return POV_OK;
}

void shading_destroy(shading *s)
{
    if (!s)
        return;
    env_free(s->model->env, s->appearances);
    env_free(s->model->env, s);
}
