/* Boxes of trees of shapes and of their members, and a hierarchy of boxes over the members. */
#include "world/csg.h"

/* ---- boxes ---- */

static void join(pov_box *a, const pov_box *b)
{
    a->lo = pov_vec3_of(pov_min(a->lo.x, b->lo.x), pov_min(a->lo.y, b->lo.y), pov_min(a->lo.z, b->lo.z));
    a->hi = pov_vec3_of(pov_max(a->hi.x, b->hi.x), pov_max(a->hi.y, b->hi.y), pov_max(a->hi.z, b->hi.z));
}

static void cut(pov_box *a, const pov_box *b)
{
    a->lo = pov_vec3_of(pov_max(a->lo.x, b->lo.x), pov_max(a->lo.y, b->lo.y), pov_max(a->lo.z, b->lo.z));
    a->hi = pov_vec3_of(pov_min(a->hi.x, b->hi.x), pov_min(a->hi.y, b->hi.y), pov_min(a->hi.z, b->hi.z));
}

static bool is_empty(const pov_box *b) { return b->lo.x > b->hi.x || b->lo.y > b->hi.y || b->lo.z > b->hi.z; }

/* A tree, and by member what is known of it. */
typedef struct extents { const csg_tree *tree; const csg_source *source; const csg_extent *of; } extents;

static bool box_of(const extents *x, node_ref node, pov_box *out);

static bool box_of_all(const extents *x, const csg_node *n, pov_box *out)
{
    for (uint32_t i = 0; i < n->child_count; i++) {
        pov_box b;

        if (!box_of(x, x->tree->children[n->child + i], &b))
            return false;
        if (i == 0)
            *out = b;
        else
            join(out, &b);
    }
    return true;
}

/* The intersection that an intersection's child is, or NULL. */
static const csg_node *intersection_below(const csg_tree *t, node_ref child)
{
    const csg_node *below = &t->nodes[child & ~NODE_GROUP];

    return (child & NODE_GROUP) && below->op == NODE_INTERSECTION && !below->inverse ? below : NULL;
}

typedef void half_space_sink(void *to, const pov_half_space *one, bool complement, uint32_t member);

/* Tell of the half-spaces that an intersection is part of. */
static void find_half_spaces(const extents *x, const csg_node *n, half_space_sink *take, void *to)
{
    for (uint32_t i = 0; i < n->child_count; i++) {
        const node_ref child = x->tree->children[n->child + i];
        const csg_node *below = intersection_below(x->tree, child);

        if (!(child & NODE_GROUP) && x->of[child].is_half_space)
            take(to, &x->of[child].half_space, x->tree->members[child].inverse, child);
        else if (below)
            find_half_spaces(x, below, take, to);
    }
}

static void take_some(void *to, const pov_half_space *one, bool complement, uint32_t member)
{
    half_spaces_add(to, one, complement, member);
}

/* Add what holds the infinite members of an intersection within the half-spaces. */
static void add_hulls(const extents *x, const csg_node *n, half_spaces *all)
{
    pov_half_space found[POV_HULL_MAX];

    for (uint32_t i = 0; i < n->child_count; i++) {
        const node_ref child = x->tree->children[n->child + i];
        const csg_node *below = intersection_below(x->tree, child);
        uint32_t count = 0;

        if (below)
            add_hulls(x, below, all);
        else if (!(child & NODE_GROUP) && !x->of[child].boxed && !x->tree->members[child].inverse)
            count = x->source->hull(x->source->user, x->tree->members[child].leaf, all, found);
        for (uint32_t k = 0; k < count; k++)
            half_spaces_add(all, &found[k], false, child);
    }
}

/* Infinite members may be finite together, or cut a box. */
static bool cut_by_infinite(const extents *x, const csg_node *n, bool boxed, pov_box *box)
{
    half_spaces all = { 0 };
    pov_box b;

    find_half_spaces(x, n, take_some, &all);
    if (boxed && all.count > 0)
        half_spaces_add_box(&all, box);
    if (!boxed)
        add_hulls(x, n, &all);
    if (!half_spaces_bound(&all, &b))
        return boxed;
    if (boxed)
        cut(box, &b);
    else
        *box = b;
    return true;
}

static bool box_of_common(const extents *x, const csg_node *n, pov_box *out)
{
    bool boxed = false;

    for (uint32_t i = 0; i < n->child_count; i++) {
        pov_box b;

        if (!box_of(x, x->tree->children[n->child + i], &b))
            continue;
        if (boxed)
            cut(out, &b);
        else
            *out = b;
        boxed = true;
    }
    return cut_by_infinite(x, n, boxed, out);
}

/* False: it may be infinite. */
static bool box_of(const extents *x, node_ref node, pov_box *out)
{
    const csg_tree *t = x->tree;
    const csg_node *n;

    if (!(node & NODE_GROUP)) {
        *out = t->members[node].box;
        return t->members[node].boxed && !t->members[node].inverse;
    }
    n = &t->nodes[node & ~NODE_GROUP];
    if (n->inverse)
        return false;
    return n->op == NODE_INTERSECTION ? box_of_common(x, n, out) : box_of_all(x, n, out);
}

/* A tree without a box may show no more than members whose surfaces have one, such as a height field within an endless cylinder. */
static void find_shown(csg_tree *t, const csg_extent *of)
{
    bool any = false;

    t->shows_boxed = t->boxed;
    t->shown = t->box;
    for (uint32_t i = 0; !t->boxed && i < t->member_count; i++) {
        if (t->members[i].hidden)
            continue;
        if (!of[i].has_box)
            return;
        if (any)
            join(&t->shown, &of[i].box);
        else
            t->shown = of[i].box;
        any = true;
    }
    t->shows_boxed = t->boxed || any;
    if (any)
        t->size = pov_max(t->size, pov_max(pov_largest(t->shown.lo), pov_largest(t->shown.hi)));
}

/* Parts outside the tree's box are clipped. */
static void find_boxes(csg_tree *t, const extents *x)
{
    const csg_extent *of = x->of;
    uint32_t i;

    for (i = 0; i < t->member_count; i++) {
        t->members[i].boxed = of[i].boxed;
        t->members[i].box = of[i].box;
        if (of[i].boxed)
            t->size = pov_max(t->size, pov_max(pov_largest(of[i].box.lo), pov_largest(of[i].box.hi)));
    }
    t->boxed = box_of(x, NODE_GROUP, &t->box);
    t->empty = t->boxed && is_empty(&t->box);
    find_shown(t, of);
    if (t->boxed && !t->empty)
        t->size = pov_max(t->size, pov_max(pov_largest(t->box.lo), pov_largest(t->box.hi)));
    for (i = 0; t->boxed && i < t->member_count; i++)
        if (t->members[i].boxed) {
            cut(&t->members[i].box, &t->box);
            t->members[i].absent = is_empty(&t->members[i].box);
        }
}

/* ---- the hierarchy ---- */

static double centre_of(const pov_box *b, int axis)
{
    return axis == 0 ? b->lo.x + b->hi.x : axis == 1 ? b->lo.y + b->hi.y : b->lo.z + b->hi.z;
}

/* Sort by the centres along an axis. */
static void sort(const csg_tree *t, uint32_t *ids, uint32_t count, int axis)
{
    uint32_t gap, i, j;

    for (gap = 1; gap < count / 3; gap = 3 * gap + 1)
        continue;
    for (; gap > 0; gap /= 3)
        for (i = gap; i < count; i++) {
            const uint32_t id = ids[i];
            const double centre = centre_of(&t->members[id].box, axis);

            for (j = i; j >= gap && centre < centre_of(&t->members[ids[j - gap]].box, axis); j -= gap)
                ids[j] = ids[j - gap];
            ids[j] = id;
        }
}

static int longest_axis(const pov_box *b)
{
    const pov_vec3 e = pov_sub(b->hi, b->lo);

    return e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
}

/* Halves of equal count, along the longest edge. */
static uint32_t split(csg_tree *t, uint32_t *ids, uint32_t count)
{
    const uint32_t at = t->bounds_count++;
    csg_bound *b = &t->bounds[at];

    b->box = t->members[ids[0]].box;
    b->member = ids[0];
    b->other = 0;
    if (count == 1)
        return at;
    for (uint32_t i = 1; i < count; i++)
        join(&b->box, &t->members[ids[i]].box);
    sort(t, ids, count, longest_axis(&b->box));
    split(t, ids, count / 2);
    b->other = split(t, ids + count / 2, count - count / 2);
    return at;
}

static void put_few(csg_few *few, const csg_bound *b, uint32_t index)
{
    const uint32_t i = few->count++;

    few->bound[i] = index;
    few->lo[0][i] = b->box.lo.x;
    few->lo[1][i] = b->box.lo.y;
    few->lo[2][i] = b->box.lo.z;
    few->hi[0][i] = b->box.hi.x;
    few->hi[1][i] = b->box.hi.y;
    few->hi[2][i] = b->box.hi.z;
}

/* Columns that are not used repeat one that is. */
static void fill_few(csg_few *few, const csg_bound *bounds)
{
    const uint32_t count = few->count;

    while (few->count < CSG_FEW)
        put_few(few, &bounds[few->bound[0]], few->bound[0]);
    few->count = count;
}

static void find_few(csg_tree *t, uint32_t count, csg_few *few)
{
    uint32_t n = 0;

    for (uint32_t i = 0; i < t->bounds_count; i++)
        if (t->bounds[i].other == 0)
            put_few(&few[n++ / CSG_FEW], &t->bounds[i], i);
    fill_few(&few[(count - 1) / CSG_FEW], t->bounds);
}

/* Boxes of up to 64 members stand side by side: that is faster than to go through the hierarchy. False: no memory. */
static bool find_groups(csg_tree *t, const env *e, uint32_t count)
{
    if (count == 0 || count > CSG_FEW * CSG_MANY)
        return true;
    if (count > CSG_FEW) {
        t->many_count = (count + CSG_FEW - 1) / CSG_FEW;
        t->many = env_alloc(e, t->many_count, sizeof *t->many);
        if (!t->many)
            return false;
    }
    find_few(t, count, t->many ? t->many : &t->few);
    return true;
}

static void take_cut(void *to, const pov_half_space *one, bool complement, uint32_t member)
{
    csg_tree *t = to;
    half_spaces same = { 0 };

    half_spaces_add(&same, one, complement, member);
    t->cuts[t->cut_count++] = (csg_cut){ .within = same.of[0], .member = member };
}

/* False: no memory. */
static bool keep_cuts(csg_tree *t, const env *e, const extents *x)
{
    if (!t->boxed || t->nodes[0].op != NODE_INTERSECTION || t->nodes[0].inverse)
        return true;
    t->cuts = env_resize(e, NULL, t->member_count, sizeof *t->cuts);
    if (t->cuts)
        find_half_spaces(x, &t->nodes[0], take_cut, t);
    return t->cuts;
}

static bool is_cut(const csg_tree *t, uint32_t member)
{
    for (uint32_t i = 0; i < t->cut_count; i++)
        if (t->cuts[i].member == member)
            return true;
    return false;
}

/* ---- infinite members of finite parts ---- */

/* By node, as far as asked: is it finite, and its box. empties: an infinite member is of it that is no complement: unless a ray asks
 * that one, the part is empty, whatever its others are. */
typedef struct part { uint8_t asked, boxed, empties; pov_box box; } part;

static part *ask_part(const extents *x, part *all, uint32_t node)
{
    part *p = &all[node];

    p->boxed = p->asked ? p->boxed : box_of(x, node | NODE_GROUP, &p->box);
    p->asked = 1;
    return p;
}

/* The outermost intersection around a member, if it is finite and the tree is not part of it. Else NULL. */
static part *part_of(const extents *x, part *all, uint32_t member)
{
    const csg_node *nodes = x->tree->nodes;
    part *found = NULL;

    for (uint32_t i = x->tree->members[member].node; nodes[i].op == NODE_INTERSECTION && !nodes[i].inverse; i = nodes[i].parent) {
        if (i == 0)
            return NULL;
        if (ask_part(x, all, i)->boxed)
            found = &all[i];
    }
    return found;
}

static void find_parts(const extents *x, csg_tree *t, part *all)
{
    for (uint32_t i = 0; i < t->endless_count; i++) {
        part *p = part_of(x, all, t->endless[i].member);

        if (p && !t->members[t->endless[i].member].inverse)
            p->empties = 1;
    }
    for (uint32_t i = 0; i < t->endless_count; i++) {
        const part *p = part_of(x, all, t->endless[i].member);

        t->endless[i].boxed = p && p->empties;
        if (t->endless[i].boxed)
            t->endless[i].box = p->box;
    }
}

/* False: no memory. */
static bool find_endless(csg_tree *t, const env *e, const extents *x)
{
    part *parts = env_alloc(e, t->node_count, sizeof *parts);

    t->endless = env_resize(e, NULL, t->member_count, sizeof *t->endless);
    for (uint32_t i = 0; t->endless && i < t->member_count; i++)
        if (!t->members[i].boxed && !is_cut(t, i))
            t->endless[t->endless_count++].member = i;
    if (parts && t->endless)
        find_parts(x, t, parts);
    env_free(e, parts);
    return parts && t->endless;
}

/* ---- the tree ---- */

static bool ask_extents(csg_tree *t, const env *e, const csg_source *source)
{
    csg_extent *of = env_resize(e, NULL, t->member_count, sizeof *of);
    const extents x = { t, source, of };
    bool kept;

    for (uint32_t i = 0; of && i < t->member_count; i++)
        source->extent(source->user, t->members[i].leaf, &of[i]);
    if (of)
        find_boxes(t, &x);
    kept = of && keep_cuts(t, e, &x) && find_endless(t, e, &x);
    env_free(e, of);
    return kept;
}

/* Is the tree empty wherever a member, or the complement that its node takes of it, is? */
static bool is_needed(const csg_tree *t, const csg_member *m)
{
    uint32_t node = m->node;

    while (t->nodes[node].op == NODE_INTERSECTION && !t->nodes[node].inverse && node != 0)
        node = t->nodes[node].parent;
    return !m->inverse && !m->patch && t->nodes[node].op == NODE_INTERSECTION && !t->nodes[node].inverse;
}

bool csg_find_bounds(csg_tree *t, const env *e, const csg_source *source)
{
    uint32_t *ids = env_resize(e, NULL, t->member_count, sizeof *ids), count = 0;
    bool done = ask_extents(t, e, source);

    t->bounds = env_resize(e, NULL, 2 * (size_t)t->member_count, sizeof *t->bounds);
    done = done && ids && t->bounds;
    for (uint32_t i = 0; done && i < t->member_count; i++)
        if (!is_cut(t, i) && t->members[i].boxed && !t->members[i].absent)
            ids[count++] = i;
    for (uint32_t i = 0; i < t->member_count; i++)
        t->members[i].needed = is_needed(t, &t->members[i]);
    if (count > 0)
        split(t, ids, count);
    done = done && find_groups(t, e, count);
    env_free(e, ids);
    return done;
}
