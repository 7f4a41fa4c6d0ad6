#include "world/object_box.h"

#include "world/internal.h"

#include <float.h>

static bool is_finite(const pov_box *b)
{
    return fabs(b->lo.x) <= DBL_MAX && fabs(b->lo.y) <= DBL_MAX && fabs(b->lo.z) <= DBL_MAX && fabs(b->hi.x) <= DBL_MAX &&
           fabs(b->hi.y) <= DBL_MAX && fabs(b->hi.z) <= DBL_MAX;
}

/* The tree that a leaf belongs to, or NULL. */
static const csg_tree *tree_of(const world *w, uint32_t leaf)
{
    for (uint32_t i = 0; i < w->trees.count; i++) {
        const csg_tree *t = &w->trees.items[i];

        for (uint32_t k = 0; k < t->member_count; k++)
            if (t->members[k].leaf == leaf)
                return t;
    }
    return NULL;
}

/* The columns of the map to the world, by Cramer's rule. */
static void invert(const instance_xform *x, pov_vec3 column[3])
{
    const pov_vec3 *c = x->column;
    const pov_vec3 row[3] = { pov_cross_product(c[1], c[2]), pov_cross_product(c[2], c[0]), pov_cross_product(c[0], c[1]) };
    const double by = 1.0 / pov_dot(c[0], row[0]);

    column[0] = pov_scale(pov_vec3_of(row[0].x, row[1].x, row[2].x), by);
    column[1] = pov_scale(pov_vec3_of(row[0].y, row[1].y, row[2].y), by);
    column[2] = pov_scale(pov_vec3_of(row[0].z, row[1].z, row[2].z), by);
}

static pov_vec3 size_of(pov_vec3 v) { return pov_vec3_of(fabs(v.x), fabs(v.y), fabs(v.z)); }

void world_box_of_own(const instance_xform *x, const pov_box *own, pov_box *out)
{
    const pov_vec3 half = pov_scale(pov_sub(own->hi, own->lo), 0.5);
    const pov_vec3 from = pov_sub(pov_scale(pov_add(own->hi, own->lo), 0.5), x->own_anchor);
    pov_vec3 column[3], middle, reach;

    invert(x, column);
    middle = pov_add(pov_scale(column[0], from.x), pov_add(pov_scale(column[1], from.y), pov_scale(column[2], from.z)));
    middle = pov_add(middle, x->anchor);
    reach = pov_add(pov_scale(size_of(column[0]), half.x),
                    pov_add(pov_scale(size_of(column[1]), half.y), pov_scale(size_of(column[2]), half.z)));
    out->lo = pov_sub(middle, reach);
    out->hi = pov_add(middle, reach);
}

bool world_object_box(const world *w, uint32_t leaf, pov_box *out)
{
    const object_info *info = &w->objects_info[leaf];
    const csg_tree *tree = info->member ? tree_of(w, leaf) : NULL;
    shape_ref at;
    pov_box own;

    if (tree) {
        *out = tree->box;
        return tree->boxed && is_finite(out);
    }
    if (info->member)
        return false;
    at = world_shape(w, leaf);
    if (!w->groups[info->group].shape->bounds(at.instance, &own))
        return false;
    if (at.xform)
        world_box_of_own(at.xform, &own, out);
    else
        *out = own;
    return is_finite(out);
}
