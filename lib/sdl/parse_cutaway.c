#include "sdl/parse_cutaway.h"

#include "base/vec.h"
#include "sdl/materials.h"
#include "sdl/parse_texture.h"
#include "sdl/textures.h"

#include <string.h>

bool parse_cutaway_begin(pov_reader *in, const object_parsed *o, cutaway_list *list)
{
    if (in->cutaway || !(o->flags & LEAF_CUTAWAY))
        return false;
    memset(list, 0, sizeof *list);
    list->whole = o;
    in->cutaway = list;
    return true;
}

void parse_cutaway_add(pov_reader *in, const cutaway_member *member)
{
    if (!in->failed && !VEC_PUSH(in->model->env, in->cutaway, *member))
        report_memory(in);
}

/* A member's texture in the space of the world, where those of all members meet. */
static const texture *texture_in_world(pov_reader *in, const cutaway_member *c)
{
    const texture *own = parse_surface_node(in, &c->surface);
    const transform *moves = c->moves < parse_count_transforms(c->map) ? parse_last_transforms(in, c->map, c->moves)
                                                                        : c->map;

    return moves ? textures_move(in, own, moves) : own;
}

static bool gives_texture(const cutaway_member *c) { return c->surface.has_look && !c->cuts; }

/* The members that give their textures to cut faces; returns their textures, with room for one more. */
static const texture **find_givers(pov_reader *in, const cutaway_list *list, cutaway *out)
{
    const texture **all = env_resize(in->model->env, NULL, list->count + 1, sizeof *all);

    out->giver = (uint32_t)in->model->givers.count;
    out->giver_count = 0;
    for (size_t i = 0; all && i < list->count && !in->failed; i++) {
        const cutaway_member *c = &list->items[i];

        if (!gives_texture(c))
            continue;
        all[out->giver_count++] = texture_in_world(in, c);
        if (!VEC_PUSH(in->model->env, &in->model->givers, c->leaf))
            report_memory(in);
    }
    if (!all)
        report_memory(in);
    return all;
}

static void set_leaf(pov_reader *in, const cutaway_member *c, const texture **all, cutaway *of)
{
    leaf_node *leaf = &in->model->leaves.items[c->leaf];
    surface_parsed s = c->surface;
    texture node;
    material m;

    memset(&node, 0, sizeof node);
    all[of->giver_count] = texture_in_world(in, c);
    node.blend = BLEND_PARTS;
    node.count = of->giver_count + 1;
    node.textures = all;
    s.whole = in->failed ? NULL : textures_texture(in, &node);
    s.under = NULL;
    if (!in->failed)
        parse_surface_material(in, &s, &m);
    if (in->failed)
        return;
    m.double_illuminate = (leaf->flags & LEAF_DOUBLE_ILLUMINATE) != 0;
    leaf->material = materials_index(in, &m);
    leaf->flags |= LEAF_CUTAWAY;
    model_clear_texture_map(in->model, c->leaf);
    of->leaf = c->leaf;
    if (!VEC_PUSH(in->model->env, &in->model->cutaways, *of))
        report_memory(in);
}

void parse_cutaway_end(pov_reader *in, cutaway_list *list)
{
    const texture **all;
    cutaway of;

    in->cutaway = NULL;
    all = in->failed ? NULL : find_givers(in, list, &of);
    for (size_t i = 0; all && i < list->count && of.giver_count > 0 && !in->failed; i++)
        if (!list->items[i].surface.has_look)
            set_leaf(in, &list->items[i], all, &of);
    env_free(in->model->env, all);
    env_free(in->model->env, list->items);
}
