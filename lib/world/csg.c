/* Trees of shapes while the world is built, and their operations except intersections with rays. */
#include "world/csg.h"

#include <string.h>

int32_t csg_value(const csg_node *n, const csg_state *s)
{
    int32_t value = s->sum;

    if (n->op == NODE_MERGE)
        value = s->sum > 0;
    else if (n->op == NODE_INTERSECTION)
        value = s->zeros > 0 ? 0 : 1 + s->sum - (int32_t)n->child_count;
    if (n->nonzero)
        return value > 0;
    return n->inverse ? value == 0 : value;
}

/* ---- the nodes ---- */

typedef struct making { const model *model; csg_tree *tree; } making;

static const group_node *group_at(const model *m, node_ref node) { return &m->groups.items[node & ~NODE_GROUP]; }

/* What a node inherits: its complement is taken; an odd number of nodes above it is inverse; it clips. */
typedef struct inherited { bool complement, turned, hidden; } inherited;

static node_ref add_node(making *k, node_ref node, uint32_t parent, inherited from);

/* What has no inside has no complement. */
static node_ref add_member(making *k, uint32_t leaf, uint32_t node, inherited from)
{
    const leaf_node *o = &k->model->leaves.items[leaf];
    const uint32_t which = leaf - k->tree->members[0].leaf;
    const bool complement = from.complement != ((o->flags & LEAF_INVERSE) != 0);
    csg_member *m = &k->tree->members[which];

    m->shape = o->shape;
    m->leaf = leaf;
    m->node = node;
    m->hidden = from.hidden;
    m->patch = !shape_is_solid(o->shape, o->instance);
    m->inverse = !m->patch && complement;
    m->turned = !shape_is_patch(o->shape) && from.turned != complement;
    return which;
}

/* Is one of its members a surface, or clipped? */
static bool has_own_complements(const model *m, const group_node *g)
{
    for (uint32_t i = 0; i < g->child_count; i++) {
        const node_ref child = m->children.items[g->child + i];

        if (!(child & NODE_GROUP) ? !shape_is_solid(m->leaves.items[child].shape, m->leaves.items[child].instance)
                                  : group_at(m, child)->op == NODE_CLIP || has_own_complements(m, group_at(m, child)))
            return true;
    }
    return false;
}

/* The complement of a group with members that have complements of their own: that of what is clipped is clipped too, and a surface
 * stays one. Of a union it is what the complements of its children have in common, else what any of them holds. */
static node_ref add_complement(making *k, const group_node *g, uint32_t parent, inherited from)
{
    const bool united = g->op == NODE_UNION || g->op == NODE_MERGE;
    const uint32_t which = k->tree->node_count++;
    csg_node *n = &k->tree->nodes[which];
    inherited to = { true, from.turned, from.hidden };

    n->op = united ? NODE_INTERSECTION : NODE_MERGE;
    n->parent = parent;
    n->child = k->tree->child_count;
    n->child_count = g->child_count;
    k->tree->child_count += g->child_count;
    for (uint32_t i = 0; i < g->child_count; i++) {
        k->tree->children[n->child + i] = add_node(k, k->model->children.items[g->child + i], which, to);
        to.complement = g->op != NODE_DIFFERENCE;
    }
    return which | NODE_GROUP;
}

/* The complement of what is clipped is the complement of its first child, clipped. */
static node_ref add_group(making *k, const group_node *g, uint32_t parent, inherited from)
{
    const uint32_t which = k->tree->node_count++;
    const bool passed_on = g->op == NODE_CLIP && from.complement;
    csg_node *n = &k->tree->nodes[which];
    inherited to = { passed_on, false, from.hidden };

    n->op = g->op == NODE_DIFFERENCE || g->op == NODE_CLIP ? NODE_INTERSECTION : g->op;
    n->inverse = (from.complement && !passed_on) != g->inverse;
    n->nonzero = from.complement && !passed_on && g->inverse;
    n->parent = parent;
    n->child = k->tree->child_count;
    n->child_count = g->child_count;
    k->tree->child_count += g->child_count;
    to.turned = from.turned != n->inverse;
    for (uint32_t i = 0; i < g->child_count; i++) {
        k->tree->children[n->child + i] = add_node(k, k->model->children.items[g->child + i], which, to);
        to.complement = g->op == NODE_DIFFERENCE;
        to.hidden = from.hidden || g->op == NODE_CLIP;
    }
    return which | NODE_GROUP;
}

static node_ref add_node(making *k, node_ref node, uint32_t parent, inherited from)
{
    const group_node *g = node & NODE_GROUP ? group_at(k->model, node) : NULL;

    if (!g)
        return add_member(k, node, parent, from);
    return g->op != NODE_CLIP && from.complement != g->inverse && has_own_complements(k->model, g)
               ? add_complement(k, g, parent, from) : add_group(k, g, parent, from);
}

/* ---- values where no member is entered ---- */

static int32_t rest(const csg_tree *t, node_ref node)
{
    const csg_node *n;
    csg_state *s;

    if (!(node & NODE_GROUP))
        return t->members[node].inverse;
    n = &t->nodes[node & ~NODE_GROUP];
    s = &t->outside[node & ~NODE_GROUP];
    for (uint32_t i = 0; i < n->child_count; i++) {
        const int32_t value = rest(t, t->children[n->child + i]);

        s->sum += value;
        s->zeros += value == 0;
    }
    return s->value = csg_value(n, s);
}

/* ---- trees ---- */

static void count_nodes(const model *m, node_ref node, uint32_t *nodes, uint32_t *children)
{
    const group_node *g;

    if (!(node & NODE_GROUP))
        return;
    g = group_at(m, node);
    *nodes += 1;
    *children += g->child_count;
    for (uint32_t i = 0; i < g->child_count; i++)
        count_nodes(m, m->children.items[g->child + i], nodes, children);
}

/* A tree of which nothing is seen stays one that rays cross. */
static void find_clear(csg_tree *t, const model *m)
{
    bool seen = false;

    for (uint32_t i = 0; i < t->member_count; i++) {
        const leaf_node *o = &m->leaves.items[t->members[i].leaf];

        t->members[i].clear = !(o->flags & LEAF_CUTAWAY) && material_is_clear(&m->materials.items[o->material]);
        seen = seen || !csg_is_unseen(&t->members[i]);
    }
    for (uint32_t i = 0; i < t->member_count; i++)
        t->members[i].clear = t->members[i].clear && seen;
}

static bool make_tree(csg_tree *t, const model *m, node_ref root)
{
    const group_node *g = group_at(m, root);
    uint32_t nodes = 0, children = 0;
    const inherited nothing = { false, false, false };
    making k = { m, t };

    count_nodes(m, root, &nodes, &children);
    t->member_count = g->leaf_count;
    t->members = env_alloc(m->env, g->leaf_count, sizeof *t->members);
    t->nodes = env_alloc(m->env, nodes, sizeof *t->nodes);
    t->outside = env_alloc(m->env, nodes, sizeof *t->outside);
    t->children = env_alloc(m->env, children, sizeof *t->children);
    if (!t->members || !t->nodes || !t->outside || !t->children)
        return false;
    t->members[0].leaf = g->leaf;
    add_node(&k, root, 0, nothing);
    rest(t, NODE_GROUP);
    return true;
}

bool csg_make(csg_list *out, const model *m, const csg_source *source)
{
    out->count = 0;
    out->items = m->trees.count > 0 ? env_alloc(m->env, m->trees.count, sizeof *out->items) : NULL;
    if (!out->items)
        return m->trees.count == 0;
    for (; out->count < m->trees.count; out->count++) {
        csg_tree *t = &out->items[out->count];

        if (!make_tree(t, m, m->trees.items[out->count])) {
            out->count++;
            return false;
        }
        if (source->clear_members)
            find_clear(t, m);
        if (!csg_find_bounds(t, m->env, source)) {
            out->count++;
            return false;
        }
        csg_find_chords(t);
        csg_find_clipped(t);
    }
    return true;
}

void csg_free(csg_list *all, const env *e)
{
    for (uint32_t i = 0; i < all->count; i++) {
        env_free(e, all->items[i].members);
        env_free(e, all->items[i].outline);
        env_free(e, all->items[i].nodes);
        env_free(e, all->items[i].outside);
        env_free(e, all->items[i].children);
        env_free(e, all->items[i].bounds);
        env_free(e, all->items[i].many);
        env_free(e, all->items[i].endless);
        env_free(e, all->items[i].cuts);
    }
    env_free(e, all->items);
    all->items = NULL;
    all->count = 0;
}

/* ---- where a point lies ---- */

static bool is_inside(const csg_member *m, pov_vec3 point, pov_vec3 point_lo)
{
    if (m->absent || m->patch)
        return false;
    return m->xform ? instance_inside(m->xform, m->shape, m->instance, point, point_lo)
                    : m->shape->inside(m->instance, point, point_lo);
}

static int32_t value_at(const csg_tree *t, node_ref node, pov_vec3 point, pov_vec3 point_lo)
{
    csg_state s = { 0, 0, 0 };
    const csg_node *n;

    if (!(node & NODE_GROUP))
        return is_inside(&t->members[node], point, point_lo) != t->members[node].inverse;
    n = &t->nodes[node & ~NODE_GROUP];
    for (uint32_t i = 0; i < n->child_count; i++) {
        const int32_t value = value_at(t, t->children[n->child + i], point, point_lo);

        s.sum += value;
        s.zeros += value == 0;
    }
    return csg_value(n, &s);
}

bool csg_inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    return value_at(((const csg_root *)self)->tree, NODE_GROUP, point, point_lo) != 0;
}

/* ---- the class ---- */

static bool bounds(const void *self, pov_box *out)
{
    const csg_tree *t = ((const csg_root *)self)->tree;

    *out = t->shown;
    return t->shows_boxed;
}

static bool pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    csg_block *b = block;

    (void)frame;
    b->count = n;
    for (uint32_t i = 0; i < n; i++)
        b->tree[i] = ((const csg_root *)selves[i])->tree;
    return true;
}

const shape_class csg_class = {
    .flags = POV_SHAPE_SOLID,
    .keyword = "csg",
    .instance_size = sizeof(csg_root),
    .bounds = bounds,
    .intersect = csg_intersect,
    .inside = csg_inside,
    .block_size = sizeof(csg_block),
    .block_pack = pack,
    .block_filter = csg_filter,
    .intersect_many = csg_intersect_many,
    .cross_many = csg_cross_many,
};
