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

/* A member's instance in the coordinates of the world, if it has one; in `made` if there is none yet. NULL: it has none. */
typedef struct made_instance { SIMD_ALIGNED unsigned char bytes[POV_PREPARED_MAX]; } made_instance;

static const void *instance_of(const compile_state *f, uint32_t leaf, made_instance *made)
{
    const leaf_node *o = compile_leaf(f, leaf);

    if ((f->group[leaf] & (COMPILE_MEMBER - 1)) % COMPILE_KINDS == COMPILE_INSTANCED || o->shape->instance_size > sizeof *made)
        return NULL;
    if (f->moved && f->moved[leaf])
        return f->moved[leaf];
    compile_make(o, made->bytes);
    return made->bytes;
}

static void extent_of(const void *user, uint32_t leaf, csg_extent *out)
{
    const compile_state *f = user;
    const shape_class *shape = compile_leaf(f, leaf)->shape;
    made_instance made;

    out->has_box = !(f->group[leaf] & COMPILE_INFINITE);
    out->boxed = out->has_box && !(shape->flags & POV_SHAPE_ENDLESS);
    if (out->has_box)
        compile_box(f, leaf, &out->box);
    out->is_half_space = false;
    if (!out->boxed && shape->half_space) {
        const void *self = instance_of(f, leaf, &made);
        out->is_half_space = self && shape->half_space(self, &out->half_space);
    }
}

static uint32_t hull_of(const void *user, uint32_t leaf, const half_spaces *within, pov_half_space *out)
{
    const compile_state *f = user;
    const shape_class *shape = compile_leaf(f, leaf)->shape;
    made_instance made;
    const void *self = shape->hull ? instance_of(f, leaf, &made) : NULL;

    return self ? shape->hull(self, within->of, within->count, out) : 0;
}

/* A tree casts a shadow if a member does, and blocks light if all members are opaque. Normals of subtracted members
 * point into these. */
static unsigned note_members(compile_state *f, const csg_tree *t)
{
    unsigned opaque = COMPILE_OPAQUE, casts = 0;

    for (uint32_t i = 0; i < t->member_count; i++) {
        object_info *info = &f->objects_info[t->members[i].leaf];

        info->inverse = t->members[i].turned;
        if (csg_is_unseen(&t->members[i]))
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
    const bool filtered = f->use_blocks && (t->chords.all || (t->clipped.count > 0 && t->boxed) || csg_is_small(t));
    const leaf_node leaf = { .shape = &csg_class, .instance = &f->roots[which], .material = first->material,
                             .line = first->line, .column = first->column };

    f->roots[which].tree = t;
    f->tree_leaves[which] = leaf;
    f->objects_info[index] = info;
    f->group[index] = (uint16_t)(mark + (filtered ? COMPILE_SHARES_LEAF - COMPILE_SINGLE : 0));
    f->packed += filtered;
    if (f->moved)
        f->moved[index] = NULL;
    if (t->empty)
        f->group[index] |= COMPILE_MEMBER;   /* no ray needs to test it */
    else
        compile_take(f, index, t->shows_boxed ? &t->shown : NULL);
}

bool compile_add_trees(compile_state *f, uint16_t mark)
{
    const model *m = f->model;
    const csg_source source = { extent_of, hull_of, f, f->clear_members };

    if (m->trees.count == 0)
        return true;
    f->roots = env_alloc(f->env, m->trees.count, sizeof *f->roots);
    f->tree_leaves = env_alloc(f->env, m->trees.count, sizeof *f->tree_leaves);
    if (!f->roots || !f->tree_leaves || !csg_make(&f->trees, m, &source))
        return false;
    for (uint32_t i = 0; i < f->trees.count; i++)
        add_tree(f, i, mark);
    return true;
}
