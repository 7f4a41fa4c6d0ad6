#include "query/query.h"
#include "world/internal.h"

typedef struct asking { const world *world; const shaft *in; uint32_t left; query_blocker_fn *add; void *user; } asking;

/* The shape's own box, or else the leaf's. */
static bool add_boxed(const asking *a, const leaf_batch *r, uint32_t lane, const pov_box *leaf)
{
    const uint32_t flags = r->shape->flags;
    blocker b = { .opaque = r->opaque >> lane & 1 };

    if (!(r->flags & LEAF_INSTANCED) && r->object[lane] < a->world->model->leaves.count &&
        r->shape->bounds(leaf_batch_instance(r, lane), &b.box)) {
        b.is_box = (flags & POV_SHAPE_BOX) && r->plain >> lane & 1;
        b.is_sphere = (flags & POV_SHAPE_SPHERE) && r->plain >> lane & 1;
    } else if (leaf) {
        b.box = *leaf;
    } else {
        return false;
    }
    return !shaft_may_overlap(a->in, &b.box) || a->add(a->user, &b);
}

static bool add_shape(const asking *a, const leaf_batch *r, uint32_t lane, const pov_box *leaf)
{
    pov_half_space half;

    if (r->object[lane] == a->left && (r->shape->flags & POV_SHAPE_CONVEX))
        return true;
    if (!leaf && !(r->flags & LEAF_INSTANCED) && r->shape->half_space &&
        r->shape->half_space(leaf_batch_instance(r, lane), &half) && !shaft_may_cross(a->in, half.normal, half.distance))
        return true;
    return add_boxed(a, r, lane, leaf);
}

static bool add_leaf(void *user, const void *leaf, const pov_box *box)
{
    const asking *a = user;

    for (const leaf_batch *r = leaf; r; r = leaf_batch_next(r))
        for (uint32_t casts = r->casts & leaf_batch_lanes(r); casts; casts &= casts - 1)
            if (!add_shape(a, r, first_of(casts), box))
                return false;
    return true;
}

bool query_blockers(const world *w, const shaft *s, uint32_t left, query_blocker_fn *add, void *user)
{
    asking a = { w, s, left, add, user };

    return add_leaf(&a, w->infinite, NULL) && add_leaf(&a, w->list, NULL) &&
           (!w->has_tree || shaft_search(&w->tree, s, add_leaf, &a));
}
