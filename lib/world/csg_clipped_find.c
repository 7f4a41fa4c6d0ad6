/* Which trees are one surface that others clip (csg_clipped.c), found as a tree is compiled. */
#include "world/csg_traversal.h"

/* loose: as an outline has it, such as a half-space, or its complement. */
static bool may_clip(const csg_member *m, bool loose)
{
    return !m->patch && !m->absent && (loose ? m->shape->outline != NULL : !m->inverse && m->boxed && (m->shape->flags & POV_SHAPE_CONVEX));
}

/* The surface is the only member that shows, or the only one that cannot clip. Else the number of members. */
static uint32_t find_surface(const csg_tree *t, bool loose)
{
    uint32_t showing = 0, others = 0, shown = 0, other = 0;

    for (uint32_t i = 0; i < t->member_count; i++) {
        if (!csg_is_unseen(&t->members[i])) {
            showing++;
            shown = i;
        }
        if (!may_clip(&t->members[i], loose)) {
            others++;
            other = i;
        }
    }
    return showing == 1 ? shown : others == 1 ? other : t->member_count;
}

static bool is_surface(const csg_member *m) { return !csg_is_unseen(m) && !m->absent; }

/* Nothing but intersections? */
static bool is_intersection(const csg_tree *t, node_ref node)
{
    const csg_node *n = &t->nodes[node & ~NODE_GROUP];

    if (!(node & NODE_GROUP))
        return true;
    if (n->op != NODE_INTERSECTION || n->inverse)
        return false;
    for (uint32_t i = 0; i < n->child_count; i++)
        if (!is_intersection(t, t->children[n->child + i]))
            return false;
    return true;
}

static bool forget(csg_tree *t)
{
    t->clipped = (csg_clipped){ .count = 0 };
    return false;
}

static bool find_clips(csg_tree *t, bool loose)
{
    csg_clipped found = { .surface = find_surface(t, loose), .loose = loose };

    if (found.surface == t->member_count || !is_surface(&t->members[found.surface]))
        return false;
    for (uint32_t i = 0; i < t->member_count; i++) {
        if (i == found.surface)
            continue;
        if (!may_clip(&t->members[i], loose))
            return false;
        found.shown = found.shown || !csg_is_unseen(&t->members[i]);
        found.hollows |= (uint32_t)t->members[i].inverse << found.count;
        found.clip[found.count++] = i;
    }
    t->clipped = found;
    /* Where a hollow holds the first crossing, the walk asks the surface again: but for csg_hollows_first() only those that are quick on a
     * stretch gain by it. */
    if (found.hollows && !csg_is_hollowed(t) && !t->members[found.surface].shape->intersect_between)
        return forget(t);
    /* Of a patch only clips that do not show leave the first crossing: it has no inside. */
    if (t->members[found.surface].patch && found.shown)
        return forget(t);
    return true;
}

void csg_find_clipped(csg_tree *t)
{
    if (!t->empty && t->member_count <= CSG_FEW && is_intersection(t, NODE_GROUP) && !(t->boxed && find_clips(t, false)))
        find_clips(t, true);
}
