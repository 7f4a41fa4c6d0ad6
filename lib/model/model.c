#include "model/model.h"

#include <string.h>

void model_init(model *m, const env *e)
{
    memset(m, 0, sizeof *m);
    m->env = e;
    arena_init(&m->memory, e);
}

void model_free(model *m)
{
    env_free(m->env, m->objects.items);
    env_free(m->env, m->materials.items);
    env_free(m->env, m->lights.items);
    arena_free(&m->memory);
}
