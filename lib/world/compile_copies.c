/* Copies as objects of the world, behind its leaves and trees. */
#include "world/compile.h"

#include "base/err.h"
#include "world/internal.h"

/* Does the part cast shadows, and does all of it block light? All its leaves cast shadows, or none does. */
static unsigned note_part(const world *part)
{
    const model *m = part->model;
    unsigned noted = COMPILE_OPAQUE;

    for (size_t i = 0; i < m->leaves.count; i++) {
        const leaf_node *o = &m->leaves.items[i];

        noted |= o->flags & LEAF_NO_SHADOW ? 0u : COMPILE_CASTS;
        if (material_is_transparent(&m->materials.items[o->material]))
            noted &= ~(unsigned)COMPILE_OPAQUE;
    }
    return noted;
}

static bool is_within_range(const pov_box *b)
{
    return pov_largest(b->lo) <= 1e150 && pov_largest(b->hi) <= 1e150;
}

/* The box of a copy; false: it has none, or its transformation has no inverse. */
static bool find_box(const leaf_node *leaf, const pov_affine *map, pov_box *out)
{
    pov_box own;

    if (!leaf->shape->bounds(leaf->instance, &own))
        return false;
    *out = own;
    if (map)
        instance_box(map, &own, out);
    return is_within_range(out);
}

/* False: its transformation has no inverse. */
static bool add_copy(compile_state *f, uint32_t which, uint16_t mark, const unsigned *noted)
{
    const model_copy *c = &f->model->copies.items[which];
    const uint32_t index = (uint32_t)(f->model->leaves.count + f->model->trees.count) + which;
    const object_info info = { .slot = noted[c->of->part] };
    leaf_node *leaf = &f->copy_leaves[which];
    pov_affine map;
    pov_box box;
    bool finite;

    f->copies[which] = (copy_root){ f->parts[c->of->part], c->name };
    *leaf = (leaf_node){ .shape = &copy_class, .instance = &f->copies[which], .map = c->map };
    f->objects_info[index] = info;
    f->moved[index] = NULL;
    if (c->map && !transform_compose(c->map, &map))
        return false;
    finite = find_box(leaf, c->map ? &map : NULL, &box);
    f->group[index] = mark + COMPILE_SINGLE;
    if (c->map) {
        f->group[index] = mark + COMPILE_INSTANCED;
        f->moved[index] = leaf->instance;
        f->maps[index] = (uint32_t)transform_packed_bytes(c->map);
        f->boxes[index] = box;
        f->composed++;
    }
    compile_take(f, index, finite ? &box : NULL);
    return true;
}

static pov_status refuse(const model_copy *c, pov_error *err)
{
    const leaf_node *first = &c->of->leaves.items[0];

    return err_set_at(err, POV_E_SYNTAX, (int)first->line, (int)first->column, "the transformation of this %s has no inverse",
                      first->shape->keyword);
}

pov_status compile_add_copies(compile_state *f, uint16_t mark, pov_error *err)
{
    const model *m = f->model;
    unsigned *noted;
    uint32_t count = 0;

    if (m->copies.count == 0)
        return POV_OK;
    f->copies = env_alloc(f->env, m->copies.count, sizeof *f->copies);
    f->copy_leaves = env_alloc(f->env, m->copies.count, sizeof *f->copy_leaves);
    noted = env_alloc(f->env, m->parts.count + m->copies.count, sizeof *noted);
    if (!f->copies || !f->copy_leaves || !noted) {
        env_free(f->env, noted);
        return err_memory(err);
    }
    for (size_t i = 0; i < f->part_count; i++)
        noted[i] = note_part(f->parts[i]);
    while (count < m->copies.count && add_copy(f, count, mark, noted))
        count++;
    for (size_t i = 0; i < f->part_count; i++)
        f->scratch = f->scratch > f->parts[i]->scratch_bytes ? f->scratch : f->parts[i]->scratch_bytes;
    env_free(f->env, noted);
    return count == m->copies.count ? POV_OK : refuse(&m->copies.items[count], err);
}
