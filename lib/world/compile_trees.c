/* Trees of shapes as objects of the world, behind its leaves. */
#include "world/compile.h"

static void extent_of(const void *user, uint32_t leaf, csg_extent *out)
{
    const flat *f = user;

    out->boxed = !(f->group[leaf] & FLAT_INFINITE);
    if (out->boxed)
        flat_box(f, leaf, &out->box);
}

/* A tree casts a shadow where a member does, and light ends at it where all are opaque. Normals of members that are taken
 * away point into these. */
static unsigned see_members(flat *f, const csg_tree *t)
{
    unsigned opaque = FLAT_OPAQUE, casts = 0;

    for (uint32_t i = 0; i < t->member_count; i++) {
        world_thing *thing = &f->things[t->members[i].leaf];

        opaque &= thing->slot;
        casts |= thing->slot & FLAT_CASTS;
        thing->inverse = t->members[i].turned;
    }
    return opaque | casts;
}

static void add_tree(flat *f, uint32_t which, uint16_t mark)
{
    const csg_tree *t = &f->trees.items[which];
    const leaf_node *first = &f->model->leaves.items[t->members[0].leaf];
    const uint32_t index = (uint32_t)f->model->leaves.count + which;
    const world_thing thing = { .slot = see_members(f, t), .material = first->material };
    const leaf_node leaf = { .shape = &csg_class, .instance = &f->roots[which], .material = first->material,
                             .line = first->line, .column = first->column };

    f->roots[which].tree = t;
    f->tree_leaves[which] = leaf;
    f->things[index] = thing;
    f->group[index] = mark;
    if (f->moved)
        f->moved[index] = NULL;
    if (t->empty)
        f->group[index] |= FLAT_MEMBER;   /* no ray need be handed it */
    else
        flat_take(f, index, t->boxed ? &t->box : NULL);
}

bool flat_add_trees(flat *f, uint16_t mark)
{
    const model *m = f->model;

    if (m->trees.count == 0)
        return true;
    f->roots = env_alloc(f->env, m->trees.count, sizeof *f->roots);
    f->tree_leaves = env_alloc(f->env, m->trees.count, sizeof *f->tree_leaves);
    if (!f->roots || !f->tree_leaves || !csg_make(&f->trees, m, extent_of, f))
        return false;
    for (uint32_t i = 0; i < f->trees.count; i++)
        add_tree(f, i, mark);
    return true;
}
