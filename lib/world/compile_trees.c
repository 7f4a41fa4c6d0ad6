/* Trees of shapes as objects of the world, behind its leaves. */
#include "world/compile.h"

#include <string.h>

void compile_mark_members(compile_state *f)
{
    const model *m = f->model;

    for (size_t i = 0; i < m->trees.count; i++) {
        const group_node *g = &m->groups.items[m->trees.items[i] & ~NODE_GROUP];

        memset(f->is_member + g->leaf, 1, g->leaf_count);
    }
}

/* Is it a half-space, where it is in the world's coordinates? */
static bool find_half_space(const compile_state *f, uint32_t leaf, half_space *out)
{
    const leaf_node *o = compile_leaf(f, leaf);
    SIMD_ALIGNED unsigned char made[POV_PREPARED_MAX];
    const void *self = f->moved ? f->moved[leaf] : NULL;

    if (!o->shape->half_space || (f->group[leaf] & 0x3fff) % COMPILE_KINDS == COMPILE_INSTANCED ||
        (!self && o->shape->instance_size > sizeof made))
        return false;
    if (!self)
        compile_make(o, made);
    return o->shape->half_space(self ? self : made, &out->normal, &out->distance);
}

static void extent_of(const void *user, uint32_t leaf, csg_extent *out)
{
    const compile_state *f = user;

    out->boxed = !(f->group[leaf] & COMPILE_INFINITE) &&
                 !(compile_leaf(f, leaf)->shape->flags & POV_SHAPE_ENDLESS);
    if (out->boxed)
        compile_box(f, leaf, &out->box);
    out->is_half_space = !out->boxed && find_half_space(f, leaf, &out->half_space);
}

/* A tree casts a shadow if a member does, and blocks light if all members are opaque. Normals of subtracted members
 * point into these. */
static unsigned note_members(compile_state *f, const csg_tree *t)
{
    unsigned opaque = COMPILE_OPAQUE, casts = 0;

    for (uint32_t i = 0; i < t->member_count; i++) {
        object_info *info = &f->objects_info[t->members[i].leaf];

        info->inverse = t->members[i].turned;
        if (t->members[i].hidden)
            continue;
        opaque &= info->slot;
        casts |= info->slot & COMPILE_CASTS;
    }
    return opaque | casts;
}

static void add_tree(compile_state *f, uint32_t which, uint16_t mark)
{
    const csg_tree *t = &f->trees.items[which];
    const leaf_node *first = &f->model->leaves.items[t->members[0].leaf];
    const uint32_t index = (uint32_t)f->model->leaves.count + which;
    const object_info info = { .slot = note_members(f, t), .material = first->material };
    const leaf_node leaf = { .shape = &csg_class, .instance = &f->roots[which], .material = first->material,
                             .line = first->line, .column = first->column };

    f->roots[which].tree = t;
    f->tree_leaves[which] = leaf;
    f->objects_info[index] = info;
    f->group[index] = mark;
    if (f->moved)
        f->moved[index] = NULL;
    if (t->empty)
        f->group[index] |= COMPILE_MEMBER;   /* no ray needs to test it */
    else
        compile_take(f, index, t->boxed ? &t->box : NULL);
}

bool compile_add_trees(compile_state *f, uint16_t mark)
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
