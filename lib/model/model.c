#include "model/model.h"

#include <string.h>

void model_init(model *m, const env *e)
{
    memset(m, 0, sizeof *m);
    m->env = e;
    arena_init(&m->memory, e);
    arena_init(&m->maps, e);
}

void model_free(model *m)
{
    env_free(m->env, m->leaves.items);
    env_free(m->env, m->groups.items);
    env_free(m->env, m->children.items);
    env_free(m->env, m->trees.items);
    env_free(m->env, m->solids.items);
    env_free(m->env, m->materials.items);
    env_free(m->env, m->lights.items);
    arena_free(&m->memory);
    arena_free(&m->maps);
}

void model_drop_maps(model *m)
{
    size_t i;

    for (i = 0; i < m->leaves.count; i++)
        m->leaves.items[i].map = NULL;
    arena_free(&m->maps);
}
