#include "query/query.h"
#include "world/csg.h"
#include "world/internal.h"

/* unseen: objects that cast no shadow count too. */
typedef struct asking {
    const world *world;
    const shaft *in;
    departure left[2];
    bool unseen;
    query_blocker_fn *add;
    void *user;
} asking;

static bool is_boxed(const shaft *s, const pov_box *b)
{
    return s->lo.x >= b->lo.x && s->lo.y >= b->lo.y && s->lo.z >= b->lo.z && s->hi.x <= b->hi.x && s->hi.y <= b->hi.y && s->hi.z <= b->hi.z;
}

/* Is one end of the shaft, the point (0) or the area (1), inside of the convex shape? */
static bool is_end_inside(const asking *a, int end, const shape_class *shape, const void *self)
{
    const pov_vec3 none = { 0.0, 0.0, 0.0 };

    if (end == 0)
        return shape->inside(self, a->in->from, none);
    for (int i = 0; i < 4; i++)
        if (!shape->inside(self, pov_add(a->in->from, a->in->corner[i]), none))
            return false;
    return true;
}

/* Is all of the shaft inside of a convex shape? Of an end whose rays leave the shape itself, that is known. self: in the world, or NULL. */
static bool is_inside(const asking *a, const shape_class *shape, const void *self, uint32_t object)
{
    pov_box box;

    if (!self || !shape->inside || !(shape->flags & POV_SHAPE_CONVEX))
        return false;
    if (a->left[0].object != object && a->left[1].object != object && shape->bounds(self, &box) && !is_boxed(a->in, &box))
        return false;
    for (int end = 0; end < 2; end++)
        if (a->left[end].object != object && !is_end_inside(a, end, shape, self))
            return false;
    return true;
}

/* Does no ray of the shaft meet the shape again, having started on it? Chords of a convex one meet it at their ends only. self: in the
 * world, or NULL. */
static bool is_left(const asking *a, const shape_class *shape, const void *self, uint32_t object, bool is_plane)
{
    const bool convex = shape->flags & POV_SHAPE_CONVEX, chords = a->left[0].object == a->left[1].object;

    for (int i = 0; i < 2; i++) {
        if (object != a->left[i].object)
            continue;
        if (is_plane || shape_is_triangle(shape) || (convex && (chords || a->left[i].outward)))
            return true;
    }
    return a->unseen && is_inside(a, shape, self, object);
}

static bool find_plane(const shape_class *shape, const void *self, pov_half_space *out)
{
    return shape->half_space && shape->half_space(self, out);
}

static bool add_plane(const asking *a, blocker *b)
{
    b->is_plane = true;
    return !shaft_may_cross(a->in, b->plane.normal, b->plane.distance) || a->add(a->user, b);
}

/* May the shaft overlap the shape's box in its own space? */
static bool may_overlap_own(const asking *a, const instance_xform *x, const shape_class *shape, const void *self)
{
    pov_box own;
    shaft moved;

    return !shape->bounds(self, &own) || !shaft_move(a->in, x->column, x->anchor, x->own_anchor, &moved) ||
           shaft_may_overlap(&moved, &own);
}

/* x: NULL: its own space is the world. */
static bool find_outline(const shape_class *shape, const void *self, const instance_xform *x, pov_outline *out)
{
    return shape->outline && shape->outline(self, out) && (!x || instance_outline(x, out));
}

/* Is the shape a ring? */
static bool find_ring(const shape_class *shape, const void *self, const instance_xform *x, blocker_ring *out)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const pov_own_map same = { zero, { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } }, zero };

    if (!shape->ring || !shape->ring(self, out->radii))
        return false;
    out->own = x ? (pov_own_map){ x->anchor, { x->column[0], x->column[1], x->column[2] }, x->own_anchor } : same;
    out->hollowed = false;
    return true;
}

/* ---- trees ---- */

/* More are not told apart. */
enum { MEMBERS_MAX = 16 };

static bool may_overlap_member(const asking *a, const csg_member *m)
{
    return !m->boxed || (shaft_may_overlap(a->in, &m->box) && (!m->xform || may_overlap_own(a, m->xform, m->shape, m->instance)));
}

static bool is_above(const csg_tree *t, uint32_t node, uint32_t below)
{
    while (below != node && below != 0)
        below = t->nodes[below].parent;
    return below == node;
}

/* Is what a member shows of its surface within that other one: does an intersection of both stand above it? */
static bool is_within(const csg_tree *t, const csg_member *m, const csg_member *other)
{
    const csg_node *n = &t->nodes[other->node];

    return m != other && n->op == NODE_INTERSECTION && !other->inverse && !other->patch && !other->open && is_above(t, other->node, m->node);
}

static bool may_show(const asking *a, const csg_tree *t, const csg_member *m)
{
    if (!may_overlap_member(a, m))
        return false;
    for (uint32_t i = 0; i < t->member_count; i++)
        if (is_within(t, m, &t->members[i]) && !may_overlap_member(a, &t->members[i]))
            return false;
    return true;
}

/* The convex member of which a tree is all that is in none of the others. NULL: there is none. */
static const csg_member *body_of(const csg_tree *t)
{
    const uint32_t within = t->chords.within;

    if (!t->chords.all || t->open_count > 0 || (within & (within - 1)) != 0)
        return NULL;
    return &t->members[t->chords.member[first_of(within)]];
}

/* A solid that what a member shows lies within. NULL: none is known. */
static const csg_member *find_clip(const csg_tree *t, const csg_member *m, pov_outline *out)
{
    for (uint32_t i = 0; i < t->member_count; i++) {
        const csg_member *other = &t->members[i];

        if (is_within(t, m, other) && other->boxed && find_outline(other->shape, other->instance, other->xform, out))
            return other;
    }
    return NULL;
}

/* Is a tree all of a member that is in no other one, or of its surface, but for what lies outside of the clip? hollows: how many others. */
static bool is_shown(const csg_tree *t, const csg_member *m, const csg_member *clip, uint32_t *hollows, const csg_member **hollow)
{
    *hollows = 0;
    if (t->node_count != 1 || t->nodes[0].op != NODE_INTERSECTION || t->nodes[0].inverse || m->inverse)
        return false;
    for (uint32_t i = 0; i < t->member_count; i++) {
        const csg_member *other = &t->members[i];

        if (other == m || other == clip)
            continue;
        if (!other->inverse || other->patch || other->open || csg_is_unseen(other))
            return false;
        ++*hollows;
        *hollow = other;
    }
    return true;
}

/* A ring that hides, but within its only hollow, needs no other member's shadow. */
static void find_shown(const csg_tree *t, const csg_member *m, const csg_member *clip, blocker *b, blocker_ring *ring)
{
    const csg_member *hollow = NULL;
    uint32_t hollows;

    b->hides = is_shown(t, m, clip, &hollows, &hollow);
    ring->hollowed = b->hides && hollows == 1 && hollow->boxed && find_outline(hollow->shape, hollow->instance, hollow->xform, &ring->hollow) &&
                     !ring->hollow.round;
    b->unaided = b->hides && (ring->hollowed || hollows == 0);
}

/* What a member of a tree shows of its surface lies in the tree's box too. body: the member of which what is in no other one stops light. */
static bool add_member(const asking *a, const csg_tree *t, const csg_member *m, const csg_member *body, bool opaque)
{
    const csg_member *clip = NULL;
    blocker_ring ring;
    blocker b = { .box = m->boxed ? m->box : t->box, .tree = t->members[0].leaf + 1 };
    const bool is_plane = !m->xform && !m->boxed && find_plane(m->shape, m->instance, &b.plane);

    if (csg_is_unseen(m) || m->absent || is_left(a, m->shape, m->xform ? NULL : m->instance, m->leaf, is_plane))
        return true;
    if (is_plane)
        return (t->boxed && !shaft_may_overlap(a->in, &t->box)) || add_plane(a, &b);
    if (!m->boxed && !t->boxed)
        return false;
    if (!shaft_may_overlap(a->in, &b.box) || !may_show(a, t, m))
        return true;
    b.outlined = m->boxed && find_outline(m->shape, m->instance, m->xform, &b.solid);
    b.ring = find_ring(m->shape, m->instance, m->xform, &ring) ? &ring : NULL;
    b.object = m->leaf;
    if (b.ring || (b.outlined && m->leaf == a->left[0].object))
        clip = find_clip(t, m, &b.clip);
    b.clipped = clip != NULL;
    b.hides = b.outlined && m == body;
    if (b.ring && opaque)
        find_shown(t, m, clip, &b, &ring);
    return a->add(a->user, &b);
}

static const csg_tree *tree_of(const leaf_batch *r, uint32_t lane)
{
    const csg_tree *t = r->shape == &csg_class ? ((const csg_root *)leaf_batch_instance(r, lane))->tree : NULL;

    return t && t->member_count <= MEMBERS_MAX ? t : NULL;
}

static bool add_tree(const asking *a, const csg_tree *t, bool opaque)
{
    const csg_member *body = opaque ? body_of(t) : NULL;

    for (uint32_t i = 0; i < t->member_count; i++)
        if (!add_member(a, t, &t->members[i], body, opaque))
            return false;
    return true;
}

/* ---- other objects ---- */

/* Is the whole surface of the solid there, and does the same to light everywhere? */
static bool is_whole(const leaf_batch *r, uint32_t lane)
{
    const shape_class *shape = r->shape;

    return (r->plain & 1u << lane) && !(shape->open && shape->open(leaf_batch_instance(r, lane)));
}

/* May the shaft overlap a triangle in its box? */
static bool may_overlap_face(const asking *a, const shape_class *shape, const void *self)
{
    pov_face f;

    return !shape_is_triangle(shape) || !shape->face(self, 0, &f) || shaft_may_overlap_triangle(a->in, f.corners, f.normal, !a->unseen);
}

/* The shape's own box, or else the leaf's. */
static bool add_boxed(const asking *a, const leaf_batch *r, uint32_t lane, const pov_box *leaf)
{
    const instance_xform *x = r->flags & LEAF_INSTANCED ? leaf_batch_xform(r) : NULL;
    const uint32_t flags = r->shape->flags;
    blocker b = { .is_box = false };
    blocker_ring ring;
    bool whole;

    if (!x && r->object[lane] < a->world->model->leaves.count &&
        r->shape->bounds(leaf_batch_instance(r, lane), &b.box)) {
        b.is_box = flags & POV_SHAPE_BOX;
        b.is_sphere = flags & POV_SHAPE_SPHERE;
        if (!may_overlap_face(a, r->shape, leaf_batch_instance(r, lane)))
            return true;
    } else if (leaf) {
        b.box = *leaf;
    } else {
        return false;
    }
    if (!shaft_may_overlap(a->in, &b.box))
        return true;
    if (x && !may_overlap_own(a, x, r->shape, r->instances))
        return true;
    b.outlined = find_outline(r->shape, leaf_batch_instance(r, lane), x, &b.solid);
    b.ring = find_ring(r->shape, leaf_batch_instance(r, lane), x, &ring) ? &ring : NULL;
    whole = is_whole(r, lane) && (b.ring || (b.outlined && (r->shape->flags & POV_SHAPE_CONVEX)));
    b.hides = whole && (r->opaque >> lane & 1);
    b.dims = whole && !b.ring && !b.hides;
    b.object = r->object[lane];
    return a->add(a->user, &b);
}

static bool add_shape(const asking *a, const leaf_batch *r, uint32_t lane, const pov_box *leaf)
{
    const csg_tree *t = tree_of(r, lane);
    blocker b = { .is_box = false };
    const bool is_plane = !leaf && !(r->flags & LEAF_INSTANCED) && find_plane(r->shape, leaf_batch_instance(r, lane), &b.plane);

    if (is_left(a, r->shape, (r->flags & LEAF_INSTANCED) ? NULL : leaf_batch_instance(r, lane), r->object[lane], is_plane))
        return true;
    if (is_plane)
        return add_plane(a, &b);
    return t ? add_tree(a, t, r->opaque >> lane & 1) : add_boxed(a, r, lane, leaf);
}

static bool add_leaf(void *user, const void *leaf, const pov_box *box)
{
    const asking *a = user;

    for (const leaf_batch *r = leaf; r; r = leaf_batch_next(r))
        for (uint32_t casts = (a->unseen ? ~0u : r->casts) & leaf_batch_lanes(r); casts; casts &= casts - 1)
            if (!add_shape(a, r, first_of(casts), box))
                return false;
    return true;
}

static bool search(const asking *a)
{
    void *user = (void *)(uintptr_t)a;

    return add_leaf(user, a->world->infinite, NULL) && add_leaf(user, a->world->list, NULL) &&
           (!a->world->has_tree || shaft_search(&a->world->tree, a->in, add_leaf, user));
}

bool query_blockers(const world *w, const shaft *s, departure left, query_blocker_fn *add, void *user)
{
    const asking a = { w, s, { left, { POV_NO_OWNER, false } }, false, add, user };

    return search(&a);
}

static bool is_none(void *user, const blocker *b)
{
    (void)user;
    (void)b;
    return false;
}

bool query_is_clear(const world *w, const shaft *s, departure from, departure to)
{
    const asking a = { w, s, { from, to }, true, is_none, NULL };

    return search(&a);
}
