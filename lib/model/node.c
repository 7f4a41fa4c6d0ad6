#include "base/vec.h"
#include "model/model.h"

/* ---- adding ---- */

bool model_add_leaf(model *m, const leaf_node *leaf)
{
    return VEC_PUSH(m->env, &m->leaves, *leaf);
}

static void invert(model *m, node_ref node)
{
    if (node & NODE_GROUP)
        m->groups.items[node & ~NODE_GROUP].inverse ^= true;
    else
        m->leaves.items[node].flags ^= LEAF_INVERSE;
}

static uint32_t first_leaf(const model *m, node_ref node)
{
    return node & NODE_GROUP ? m->groups.items[node & ~NODE_GROUP].leaf : node;
}

bool model_add_group(model *m, const group_node *shape, const node_ref *children, size_t count, node_ref *out)
{
    group_node g = *shape;

    if (count == 1) {
        *out = children[0];
        if (g.inverse)
            invert(m, *out);
        return true;
    }
    g.child = (uint32_t)m->children.count;
    g.child_count = (uint32_t)count;
    g.leaf = first_leaf(m, children[0]);
    g.leaf_count = (uint32_t)m->leaves.count - g.leaf;
    for (size_t i = 0; i < count; i++)
        if (!VEC_PUSH(m->env, &m->children, children[i]))
            return false;
    *out = (node_ref)m->groups.count | NODE_GROUP;
    return VEC_PUSH(m->env, &m->groups, g);
}

/* The clipped solid. */
static const group_node *clipped(const model *m, const group_node *g)
{
    while (g->op == NODE_CLIP && m->children.items[g->child] & NODE_GROUP)
        g = &m->groups.items[m->children.items[g->child] & ~NODE_GROUP];
    return g;
}

/* Solids are in the order of their leaves, so that each knows the number of objects before it. */
static bool add_solid(model *m, const group_node *g)
{
    const group_node *named = clipped(m, g);
    const solid_node *last = m->solids.count > 0 ? &m->solids.items[m->solids.count - 1] : NULL;
    const solid_node fresh = { named->op, g->leaf, g->leaf_count,
                               last ? last->object + 1 + g->leaf - (last->leaf + last->leaf_count) : g->leaf,
                               named->line, named->column };

    return VEC_PUSH(m->env, &m->solids, fresh);
}

/* alone: no union above is an object. */
static bool add_pieces(model *m, node_ref node, bool alone)
{
    group_node g;

    if (!(node & NODE_GROUP))
        return true;
    g = m->groups.items[node & ~NODE_GROUP];
    if (g.op != NODE_UNION || g.inverse)
        return VEC_PUSH(m->env, &m->trees, node) && (!alone || add_solid(m, &g));
    if (alone && g.united && !add_solid(m, &g))
        return false;
    for (uint32_t i = 0; i < g.child_count; i++)
        if (!add_pieces(m, m->children.items[g.child + i], alone && !g.united))
            return false;
    return true;
}

bool model_add_tree(model *m, node_ref root)
{
    return add_pieces(m, root, true);
}

const char *model_op_keyword(node_op op)
{
    static const char *const words[] = { "union", "merge", "intersection", "difference", "clipped_by" };

    return words[op];
}
