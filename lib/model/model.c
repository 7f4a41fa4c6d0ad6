#include "model/model.h"

#include "base/vec.h"

#include <string.h>

void model_init(model *m, const env *e)
{
    memset(m, 0, sizeof *m);
    m->env = e;
    m->irid_wavelength = colour_of(0.70f, 0.52f, 0.48f);
    m->noise_generator = 2;
    m->number_of_waves = 10;
    m->sky_colour.transmit = 1.0f;
    arena_init(&m->memory, e);
    arena_init(&m->maps, e);
}

bool model_keep(model *m, void *item, void (*destroy)(void *item))
{
    const kept_item one = { item, destroy };

    if (VEC_PUSH(m->env, &m->kept, one))
        return true;
    destroy(item);
    return false;
}

bool model_is_lit_by(const model *m, uint32_t leaf, const light *l)
{
    uint32_t number = 0, from = 0;
    bool is_around = false, global_lights = true;

    for (size_t i = 0; i < m->light_groups.count; i++) {
        const light_group *g = &m->light_groups.items[i];

        if (leaf - g->leaf >= g->leaf_count)
            continue;
        from = number ? from : g->from;
        number = number ? number : g->number;
        is_around |= g->number == l->group;
        global_lights = g->global_lights;
    }
    return l->group ? is_around && (l->group == number || l->group <= from) : global_lights;
}

static void free_nodes(model *m)
{
    env_free(m->env, m->leaves.items);
    env_free(m->env, m->groups.items);
    env_free(m->env, m->children.items);
    env_free(m->env, m->trees.items);
    env_free(m->env, m->solids.items);
    env_free(m->env, m->copies.items);
    env_free(m->env, m->texture_maps.items);
    env_free(m->env, m->cutaways.items);
    env_free(m->env, m->givers.items);
}

void model_free(model *m)
{
    while (m->kept.count > 0) {
        const kept_item *last = &m->kept.items[--m->kept.count];

        last->destroy(last->item);
    }
    env_free(m->env, m->kept.items);
    free_nodes(m);
    for (size_t i = 0; i < m->parts.count; i++) {
        free_nodes(m->parts.items[i]);
        env_free(m->env, m->parts.items[i]);
    }
    env_free(m->env, m->parts.items);
    env_free(m->env, m->materials.items);
    env_free(m->env, m->lights.items);
    env_free(m->env, m->light_groups.items);
    env_free(m->env, m->fogs.items);
    env_free(m->env, m->rainbows.items);
    map_table_free(&m->kept_maps, m->env);
    env_free_aligned(m->env, m->noise);
    arena_free(&m->memory);
    arena_free(&m->maps);
}

static void drop_maps(model *m)
{
    size_t i;

    for (i = 0; i < m->leaves.count; i++)
        m->leaves.items[i].map = NULL;
    for (i = 0; i < m->copies.count; i++)
        m->copies.items[i].map = NULL;
}

void model_drop_maps(model *m)
{
    size_t i;

    for (i = 0; i < m->parts.count; i++)
        drop_maps(m->parts.items[i]);
    drop_maps(m);
    arena_free(&m->maps);
}

bool model_set_texture_map(model *m, const pov_affine *map)
{
    const uint32_t number = map_table_add_own(&m->kept_maps, m->env, map), none = 0;

    if (number == 0)
        return false;
    while (m->texture_maps.count + 1 < m->leaves.count)
        if (!VEC_PUSH(m->env, &m->texture_maps, none))
            return false;
    return VEC_PUSH(m->env, &m->texture_maps, number);
}

void model_clear_texture_map(model *m, uint32_t leaf)
{
    if (leaf < m->texture_maps.count)
        m->texture_maps.items[leaf] = 0;   /* the identity */
}

const cutaway *model_cutaway(const model *m, uint32_t leaf)
{
    size_t low = 0, high = m->cutaways.count;

    while (low < high) {
        const size_t middle = low + (high - low) / 2;

        if (m->cutaways.items[middle].leaf < leaf)
            low = middle + 1;
        else
            high = middle;
    }
    return low < m->cutaways.count && m->cutaways.items[low].leaf == leaf ? &m->cutaways.items[low] : NULL;
}
