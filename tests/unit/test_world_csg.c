/* world/csg and csg_traversal: solids made of others, met as one object: where they begin and end, whose surface that
 * is, and what happens where surfaces of members lie on each other. */
#include "support/check.h"
#include "support/rays.h"
#include "support/shapes.h"

#include "query/context.h"

#include <povtrace/exact.h>

#include <stdlib.h>
#include <string.h>

/* ---- making and asking ---- */

static node_ref group(model *m, node_op op, bool inverse, const node_ref *children, size_t count)
{
    const group_node shape = { .op = op, .inverse = inverse, .united = op == NODE_UNION, .line = 1, .column = 1 };
    node_ref out;

    assert_true(model_add_group(m, &shape, children, count, &out));
    return out;
}

static node_ref pair(model *m, node_op op, node_ref a, node_ref b)
{
    const node_ref both[] = { a, b };

    return group(m, op, false, both, 2);
}

static node_ref sphere(model *m, double x, double y, double z, double radius)
{
    return test_add_sphere(m, pov_vec3_of(x, y, z), radius, 0);
}

static node_ref brick(model *m, pov_vec3 lo, pov_vec3 hi)
{
    const test_brick b = { lo, hi };

    return test_add(m, &test_brick_class, &b, NULL, 0, 0);
}

typedef struct scene { model model; world *world; query_context *context; } scene;

static void begin(scene *s)
{
    test_model_init(&s->model, NULL);
}

static void compile(scene *s, pov_accel accel)
{
    world_options options = { .accel = accel, .threads = 1 };

    assert_int_equal(world_create(&s->world, &s->model, &options, NULL), POV_OK);
    assert_int_equal(query_context_create(&s->context, s->world, NULL), POV_OK);
}

static void conclude(scene *s)
{
    query_context_destroy(s->context);
    world_destroy(s->world);
}

static void end(scene *s)
{
    conclude(s);
    model_free(&s->model);
}

/* The next surface on the way, on which the ray then stands. */
static bool next(const scene *s, pov_ray *ray, hit *h)
{
    const pov_ray *one = ray;

    if (!query_nearest(s->world, s->context, &one, 1, HUGE_VAL, h))
        return false;
    world_surface(s->world, ray, h);
    ray->org = h->point;
    ray->org_lo = h->point_lo;
    world_origin_transmit(ray, h, fabs(pov_dot(h->normal, ray->dir)));
    return true;
}

static void check_normal(const hit *h, double x, double y, double z)
{
    assert_true(fabs(h->normal.x - x) <= 1e-12 && fabs(h->normal.y - y) <= 1e-12 && fabs(h->normal.z - z) <= 1e-12);
}

static const pov_vec3 ahead = { 0.0, 0.0, 1.0 };

/* ---- below a height, in double-double and without end ---- */

static void below_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const test_ground *g = self;
    const pov_two above = pov_two_add_double(pov_two_sum(g->height, -ray->org.y), -ray->org_lo.y);
    const pov_mark mark = { 0, 0, 0.0, 0.0 };
    pov_two t;

    if (ray->dir.y == 0.0 || ray->origin_surface == hits->owner)
        return;
    t = pov_two_div(above, pov_two_of(ray->dir.y, 0.0));
    pov_cross(hits, t.hi, t.lo, mark);
}

static shape_class below_class(void)
{
    shape_class c = test_ground_class;

    c.intersect = below_intersect;
    return c;
}

/* ---- half-spaces that count how often they are asked ---- */

static int face_asked;

static void face_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const pov_half_space *h = self;
    const pov_mark mark = { 0, 0, 0.0, 0.0 };
    const double slope = pov_dot(h->normal, ray->dir);

    face_asked++;
    if (slope != 0.0 && ray->origin_surface != hits->owner)
        pov_cross(hits, (h->distance - pov_dot(h->normal, ray->org)) / slope, 0.0, mark);
}

static void face_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)ray;
    (void)at;
    *out = ((const pov_half_space *)self)->normal;
}

static bool face_inside(const void *self, pov_vec3 p, pov_vec3 lo)
{
    const pov_half_space *h = self;

    (void)lo;
    return pov_dot(h->normal, p) < h->distance;
}

static bool face_half_space(const void *self, pov_half_space *out)
{
    *out = *(const pov_half_space *)self;
    return true;
}

static shape_class face_class(void)
{
    shape_class c = test_ground_class;

    c.keyword = "face";
    c.instance_size = sizeof(pov_half_space);
    c.intersect = face_intersect;
    c.normal = face_normal;
    c.inside = face_inside;
    c.half_space = face_half_space;
    return c;
}

/* ---- what is there ---- */

/* The sphere of radius 2 about 0 without the sphere of radius 1 about (0, 0, -1.5): along z from -0.5 to 2. */
static void a_sphere_without_a_sphere_begins_at_the_hollow(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), ahead);
    scene s;
    hit h;

    (void)state;
    begin(&s);
    sphere(&s.model, 0.0, 0.0, 0.0, 2.0);
    sphere(&s.model, 0.0, 0.0, -1.5, 1.0);
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_DIFFERENCE, 0, 1)));
    compile(&s, POV_ACCEL_TREE);

    assert_true(next(&s, &ray, &h));
    assert_int_equal(h.object, 1);
    assert_true(h.crossing.t == 4.5 && h.point.z == -0.5 && h.entering);
    check_normal(&h, 0.0, 0.0, -1.0);
    assert_true(next(&s, &ray, &h));
    assert_int_equal(h.object, 0);
    assert_true(h.point.z == 2.0 && !h.entering);
    check_normal(&h, 0.0, 0.0, 1.0);
    assert_false(next(&s, &ray, &h));
    end(&s);
}

/* Off the axis: where the hollow's sphere x^2 + (z + 1.5)^2 = 1 is left at x = 0.6 stands z = -0.7. */
static void its_hollow_looks_into_it(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.6, 0.0, -5.0), ahead);
    scene s;
    hit h;

    (void)state;
    begin(&s);
    sphere(&s.model, 0.0, 0.0, 0.0, 2.0);
    sphere(&s.model, 0.0, 0.0, -1.5, 1.0);
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_DIFFERENCE, 0, 1)));
    compile(&s, POV_ACCEL_NONE);
    assert_true(next(&s, &ray, &h));
    assert_true(fabs(h.point.z + 0.7) <= 1e-15);
    check_normal(&h, -0.6, 0.0, -0.8);
    end(&s);
}

static void an_intersection_is_what_both_hold(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), ahead);
    scene s;
    hit h;

    (void)state;
    begin(&s);
    sphere(&s.model, 0.0, 0.0, 0.0, 1.0);
    sphere(&s.model, 0.0, 0.0, 1.5, 1.0);
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_INTERSECTION, 0, 1)));
    compile(&s, POV_ACCEL_TREE);
    assert_true(next(&s, &ray, &h) && h.object == 1 && h.point.z == 0.5 && h.entering);
    assert_true(next(&s, &ray, &h) && h.object == 0 && h.point.z == 1.0 && !h.entering);
    assert_false(next(&s, &ray, &h));
    end(&s);
}

static void a_merge_has_no_inner_faces(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), ahead);
    scene s;
    hit h;

    (void)state;
    begin(&s);
    sphere(&s.model, 0.0, 0.0, 0.0, 1.0);
    sphere(&s.model, 0.0, 0.0, 1.5, 1.0);
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_MERGE, 0, 1)));
    compile(&s, POV_ACCEL_TREE);
    assert_true(next(&s, &ray, &h) && h.object == 0 && h.point.z == -1.0);
    assert_true(next(&s, &ray, &h) && h.object == 1 && h.point.z == 2.5);
    assert_false(next(&s, &ray, &h));
    end(&s);
}

/* A union that nothing stands above is its members, whose inner faces are there. */
static void a_union_dissolves(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), ahead);
    scene s;
    hit h;
    uint32_t count = 0;

    (void)state;
    begin(&s);
    sphere(&s.model, 0.0, 0.0, 0.0, 1.0);
    sphere(&s.model, 0.0, 0.0, 1.5, 1.0);
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_UNION, 0, 1)));
    assert_int_equal(s.model.trees.count, 0);
    compile(&s, POV_ACCEL_TREE);
    while (next(&s, &ray, &h))
        count++;
    assert_int_equal(count, 4);
    assert_int_equal(world_solid(s.world, 1), 0);
    end(&s);
}

/* ---- clips and patches ---- */

/* The near half of a sphere is cut away: what is seen is the far half, from within. */
static void a_clip_takes_surfaces_away_and_adds_none(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), ahead);
    scene s;
    hit h;

    (void)state;
    begin(&s);
    sphere(&s.model, 0.0, 0.0, 0.0, 1.0);
    brick(&s.model, pov_vec3_of(-2.0, -2.0, 0.0), pov_vec3_of(2.0, 2.0, 2.0));
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_CLIP, 0, 1)));
    compile(&s, POV_ACCEL_TREE);
    assert_true(next(&s, &ray, &h) && h.object == 0 && h.point.z == 1.0 && !h.entering);
    assert_false(next(&s, &ray, &h));
    end(&s);
}

/* The complement of what is clipped is that of the solid, clipped: no face of the cutter's stands beyond the clip, and the
 * first member is not there either. */
static void a_clip_of_a_cutter_clips_what_is_left(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), ahead);
    node_ref cutter;
    scene s;
    hit h;

    (void)state;
    begin(&s);
    brick(&s.model, pov_vec3_of(-1.0, -1.0, -1.0), pov_vec3_of(1.0, 1.0, 1.0));
    brick(&s.model, pov_vec3_of(-2.0, -2.0, -2.0), pov_vec3_of(2.0, 2.0, -0.5));
    brick(&s.model, pov_vec3_of(-2.0, -2.0, -2.0), pov_vec3_of(2.0, 2.0, 0.25));
    cutter = pair(&s.model, NODE_CLIP, 1, 2);
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_DIFFERENCE, 0, cutter)));
    compile(&s, POV_ACCEL_TREE);
    assert_true(next(&s, &ray, &h) && h.object == 1 && h.point.z == -0.5 && h.entering);
    check_normal(&h, 0.0, 0.0, -1.0);
    assert_false(next(&s, &ray, &h));
    end(&s);
}

/* A face on the skin of what clips it is there, whether it is entered or left. */
static void what_lies_on_the_clips_skin_is_seen(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.1, 0.2, -5.0), ahead);
    scene s;
    hit h;

    (void)state;
    begin(&s);
    brick(&s.model, pov_vec3_of(-1.0, -1.0, -1.0), pov_vec3_of(1.0, 1.0, 1.0));
    brick(&s.model, pov_vec3_of(-1.0, -1.0, -1.0), pov_vec3_of(1.0, 1.0, 1.0));
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_CLIP, 0, 1)));
    compile(&s, POV_ACCEL_TREE);
    assert_true(next(&s, &ray, &h) && h.object == 0 && h.point.z == -1.0 && h.entering);
    assert_true(next(&s, &ray, &h) && h.object == 0 && h.point.z == 1.0 && !h.entering);
    assert_false(next(&s, &ray, &h));
    end(&s);
}

/* Of a patch and a solid only the patch is seen, where the solid holds it; a merge hides it there. */
static void a_patch_is_seen_where_being_in_it_would_matter(void **state)
{
    static const node_op ops[] = { NODE_INTERSECTION, NODE_DIFFERENCE, NODE_MERGE };
    shape_class patch = below_class();

    (void)state;
    patch.flags = 0;
    patch.inside = NULL;
    for (int i = 0; i < 3; i++) {
        pov_ray ray = ray_from(pov_vec3_of(0.0, 5.0, 0.0), pov_vec3_of(0.0, -1.0, 0.0));
        const test_ground ground = { 0.5 };
        scene s;
        hit h;

        begin(&s);
        sphere(&s.model, 0.0, 0.0, 0.0, 1.0);
        test_add(&s.model, &patch, &ground, NULL, 0, 0);
        assert_true(model_add_tree(&s.model, pair(&s.model, ops[i], 0, 1)));
        compile(&s, POV_ACCEL_TREE);
        assert_true(next(&s, &ray, &h) && h.object == (ops[i] != NODE_MERGE) && h.entering);
        assert_true(h.point.y == (ops[i] == NODE_MERGE ? 1.0 : 0.5));
        if (ops[i] == NODE_MERGE)
            assert_true(next(&s, &ray, &h) && h.object == 0 && h.point.y == -1.0);
        assert_false(next(&s, &ray, &h));
        end(&s);
    }
}

/* ---- surfaces of members that lie on each other ---- */

static uint32_t count_ahead(const scene *s, pov_vec3 org, pov_vec3 dir)
{
    pov_ray ray = ray_from(org, dir);
    uint32_t count = 0;
    hit h;

    while (count < 100 && next(s, &ray, &h))
        count++;
    return count;
}

static void a_cutter_that_ends_on_the_faces_leaves_no_film(void **state)
{
    scene s;

    (void)state;
    begin(&s);
    brick(&s.model, pov_vec3_of(-1.0, -1.0, -1.0), pov_vec3_of(1.0, 1.0, 1.0));
    brick(&s.model, pov_vec3_of(-0.5, -0.5, -1.0), pov_vec3_of(0.5, 0.5, 1.0));
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_DIFFERENCE, 0, 1)));
    compile(&s, POV_ACCEL_TREE);
    assert_int_equal(count_ahead(&s, pov_vec3_of(0.1, 0.2, -5.0), ahead), 0);
    assert_int_equal(count_ahead(&s, pov_vec3_of(0.1, 0.2, -5.0), pov_vec3_of(0.01, 0.02, 1.0)), 0);
    assert_int_equal(count_ahead(&s, pov_vec3_of(0.7, 0.2, -5.0), ahead), 2);
    end(&s);
}

static void what_is_taken_from_itself_is_gone(void **state)
{
    scene s;

    (void)state;
    begin(&s);
    sphere(&s.model, 0.0, 0.0, 0.0, 1.0);
    sphere(&s.model, 0.0, 0.0, 0.0, 1.0);
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_DIFFERENCE, 0, 1)));
    compile(&s, POV_ACCEL_TREE);
    assert_int_equal(count_ahead(&s, pov_vec3_of(0.3, 0.2, -5.0), ahead), 0);
    end(&s);
}

/* A brick that only touches the other takes nothing away, not even its face's name. */
static void what_only_touches_changes_nothing(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.1, 0.2, -5.0), ahead);
    scene s;
    hit h;

    (void)state;
    begin(&s);
    brick(&s.model, pov_vec3_of(-1.0, -1.0, 0.0), pov_vec3_of(1.0, 1.0, 1.0));
    brick(&s.model, pov_vec3_of(-1.0, -1.0, -1.0), pov_vec3_of(1.0, 1.0, 0.0));
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_DIFFERENCE, 0, 1)));
    compile(&s, POV_ACCEL_TREE);
    assert_true(next(&s, &ray, &h) && h.object == 0 && h.point.z == 0.0);
    assert_true(next(&s, &ray, &h) && h.object == 0 && h.point.z == 1.0);
    assert_false(next(&s, &ray, &h));
    end(&s);
}

static void a_shared_face_is_the_first_members(void **state)
{
    static const node_op ops[] = { NODE_MERGE, NODE_INTERSECTION };

    (void)state;
    for (int i = 0; i < 2; i++) {
        pov_ray ray = ray_from(pov_vec3_of(0.1, 0.2, -5.0), ahead);
        scene s;
        hit h;

        begin(&s);
        brick(&s.model, pov_vec3_of(-1.0, -1.0, 0.0), pov_vec3_of(1.0, 1.0, 1.0));
        brick(&s.model, pov_vec3_of(-0.5, -1.0, 0.0), pov_vec3_of(2.0, 1.0, 2.0));
        assert_true(model_add_tree(&s.model, pair(&s.model, ops[i], 0, 1)));
        compile(&s, POV_ACCEL_TREE);
        assert_true(next(&s, &ray, &h) && h.object == 0 && h.point.z == 0.0);
        assert_true(next(&s, &ray, &h) && h.point.z == (i == 0 ? 2.0 : 1.0));
        assert_false(next(&s, &ray, &h));
        end(&s);
    }
}

/* Two bricks that share a face, merged with a third that begins before both, or behind the face. */
static uint32_t escalated_at_shared_faces(double from)
{
    const node_ref leaves[3] = { 0, 1, 2 };
    const pov_ray ray = ray_from(pov_vec3_of(0.1, 0.2, -5.0), ahead);
    pov_crossing at[8];
    pov_hits hits = hits_to(HUGE_VAL, POV_WANT_ALL, at, 8);
    csg_root root;
    scene s;

    begin(&s);
    brick(&s.model, pov_vec3_of(-1.0, -1.0, 0.0), pov_vec3_of(1.0, 1.0, 1.0));
    brick(&s.model, pov_vec3_of(-2.0, -1.0, 1.0), pov_vec3_of(2.0, 1.0, 2.0));
    brick(&s.model, pov_vec3_of(-3.0, -3.0, from), pov_vec3_of(3.0, 3.0, 3.0));
    assert_true(model_add_tree(&s.model, group(&s.model, NODE_MERGE, false, leaves, 3)));
    compile(&s, POV_ACCEL_TREE);
    root.tree = &world_trees(s.world)->items[0];
    hits.user = &s.context->hit_buffers[0];
    csg_class.intersect(&root, &ray, &hits);
    assert_int_equal(hits.count, 2);
    assert_true(at[0].t == 5.0 + fmin(from, 0.0) && at[1].t == 8.0);
    end(&s);
    return hits.escalated;
}

static void order_is_not_asked_for_where_it_does_not_matter(void **state)
{
    (void)state;
    assert_int_equal(escalated_at_shared_faces(-1.0), 0);
    assert_true(escalated_at_shared_faces(1.5) > 0);
}

/* ---- any tree, against what its members say of points ---- */

enum { LEAVES_MAX = 12, CROSSINGS_MAX = 1024, HOLLOWS = 300 };

/* The classes of random members. */
typedef struct kinds { shape_class below, sphere, brick; } kinds;

static kinds kinds_of(uint32_t flags)
{
    kinds k = { below_class(), test_sphere_class, test_brick_class };

    k.sphere.flags |= flags;
    k.brick.flags |= flags;
    return k;
}

static node_ref random_leaf(model *m, const kinds *of, test_random *r)
{
    /* On a grid of quarters, so that members share faces and centres. */
    const double x = 0.25 * (double)test_below(r, 9) - 1.0, y = 0.25 * (double)test_below(r, 9) - 1.0;
    const double z = 0.25 * (double)test_below(r, 9) - 1.0, size = 0.25 * (double)(1 + test_below(r, 5));
    const test_ground ground = { y };
    const uint32_t kind = test_below(r, 8);

    if (kind == 0)
        return test_add(m, &of->below, &ground, NULL, 0, 0);
    if (kind < 4)
        return test_add(m, &of->sphere, &(test_sphere_shape){ { x, y, z }, size }, NULL, 0,
                        kind == 3 && test_below(r, 4) == 0 ? LEAF_INVERSE : 0);
    return test_add(m, &of->brick, &(test_brick){ { x, y, z }, { x + size, y + 0.5, z + 0.75 } }, NULL, 0, 0);
}

static node_ref random_tree(model *m, const kinds *of, test_random *r, int depth)
{
    node_ref children[3];
    const uint32_t n = 2 + test_below(r, 2);

    if (depth == 0 || m->leaves.count >= LEAVES_MAX)
        return random_leaf(m, of, r);
    for (uint32_t i = 0; i < n; i++)
        children[i] = random_tree(m, of, r, depth - 1);
    return group(m, (node_op)test_below(r, 4), test_below(r, 8) == 0, children, n);
}

/* Written down once more, from the rules. */
static int value_at(const model *m, node_ref node, pov_vec3 p)
{
    const pov_vec3 none = { 0.0, 0.0, 0.0 };
    const group_node *g;
    int sum = 0, zeros = 0, value;

    if (!(node & NODE_GROUP)) {
        const leaf_node *o = &m->leaves.items[node];
        return o->shape->inside(o->instance, p, none) != ((o->flags & LEAF_INVERSE) != 0);
    }
    g = &m->groups.items[node & ~NODE_GROUP];
    for (uint32_t i = 0; i < g->child_count; i++) {
        value = value_at(m, m->children.items[g->child + i], p);
        if (g->op == NODE_DIFFERENCE && i > 0)
            value = value == 0;
        sum += value;
        zeros += value == 0;
    }
    value = g->op == NODE_UNION ? sum : g->op == NODE_MERGE ? sum > 0 : zeros ? 0 : 1 + sum - (int)g->child_count;
    return g->inverse ? value == 0 : value;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Where all members are crossed, in order; what is within 1e-9 of another counts once. */
static uint32_t cross_members(const model *m, const pov_ray *ray, double *t)
{
    pov_crossing at[4];
    uint32_t n = 0, resident = 0;

    for (uint32_t i = 0; i < m->leaves.count; i++) {
        pov_hits hits = hits_to(HUGE_VAL, POV_WANT_ALL, at, 4);

        hits.owner = i;
        hits.always_exact = true;
        m->leaves.items[i].shape->intersect(m->leaves.items[i].instance, ray, &hits);
        for (uint32_t k = 0; k < hits.count; k++)
            t[n++] = at[k].t;
    }
    qsort(t, n, sizeof *t, compare);
    for (uint32_t i = 0; i < n; i++)
        if (resident == 0 || t[i] - t[resident - 1] > 1e-9)
            t[resident++] = t[i];
    return resident;
}

static pov_vec3 point_at(const pov_ray *ray, double t) { return pov_add(ray->org, pov_scale(ray->dir, t)); }

/* Of a ray that is nowhere near an edge: surfaces where the value changes between the middles of the way. */
static uint32_t expect(const model *m, node_ref root, const pov_ray *ray, double *out, int *values)
{
    double t[CROSSINGS_MAX];
    uint32_t n = cross_members(m, ray, t), count = 0;
    int before = value_at(m, root, ray->org), after;

    values[0] = before;
    for (uint32_t i = 0; i < n; i++) {
        after = value_at(m, root, point_at(ray, i + 1 < n ? 0.5 * (t[i] + t[i + 1]) : t[i] + 100.0));
        if (after != before) {
            out[count++] = t[i];
            values[count] = after;
        }
        before = after;
    }
    return count;
}

/* How many surfaces there are. */
static uint32_t check_ray(const scene *s, node_ref root, pov_ray ray)
{
    double t[CROSSINGS_MAX], gone;
    int values[CROSSINGS_MAX + 1];
    const uint32_t n = expect(&s->model, root, &ray, t, values);
    const pov_vec3 org = ray.org;
    hit h;

    for (uint32_t i = 0; i < n; i++) {
        assert_true(next(s, &ray, &h));
        gone = pov_dot(pov_sub(h.point, org), ray.dir) / pov_dot(ray.dir, ray.dir);
        assert_true(fabs(gone - t[i]) <= 1e-9);
        assert_int_equal(h.entering, values[i + 1] > values[i]);
        assert_int_equal(h.entering, pov_dot(h.normal, ray.dir) < 0.0);
    }
    assert_false(next(s, &ray, &h));
    return n;
}

/* Surfaces of random trees; `by_chords`: how many are intersected by chords. */
static uint32_t check_trees(const kinds *of, uint64_t seed, uint32_t *by_chords)
{
    test_random r = { seed };
    uint32_t surfaces = 0;

    *by_chords = 0;
    for (int round = 0; round < 4000; round++) {
        node_ref root;
        scene s;

        begin(&s);
        root = random_tree(&s.model, of, &r, 1 + (int)test_below(&r, 3));
        assert_true(model_add_tree(&s.model, root));
        if (s.model.trees.count != 1 || s.model.trees.items[0] != root) {
            model_free(&s.model);   /* a union of others, whose faces are all there */
            continue;
        }
        compile(&s, round % 2 ? POV_ACCEL_TREE : POV_ACCEL_NONE);
        *by_chords += world_trees(s.world)->items[0].chords.all != 0;
        for (int i = 0; i < 40; i++) {
            const pov_vec3 org = { test_uniform(&r, -2.0, 2.0), test_uniform(&r, -2.0, 2.0), test_uniform(&r, -2.0, 2.0) };

            surfaces += check_ray(&s, root, ray_from(org, test_direction(&r)));
        }
        end(&s);
    }
    return surfaces;
}

static void random_trees_are_what_their_members_say_of_points(void **state)
{
    const kinds of = kinds_of(0);
    uint32_t by_chords;

    (void)state;
    assert_true(check_trees(&of, 7, &by_chords) > 10000);
    assert_int_equal(by_chords, 0);
}

/* Of convex members: most intersections need no queue. */
static void convex_members_are_what_their_members_say_of_points(void **state)
{
    const kinds of = kinds_of(POV_SHAPE_CONVEX);
    uint32_t by_chords;

    (void)state;
    assert_true(check_trees(&of, 13, &by_chords) > 10000);
    assert_true(by_chords > 100);
}

/* Surfaces of a cube without spheres of up to such a radius. */
static uint32_t check_hollows(int count, double most)
{
    test_random r = { 5 };
    node_ref members[HOLLOWS + 1];
    uint32_t surfaces = 0;
    node_ref root;
    scene s;

    begin(&s);
    members[0] = brick(&s.model, pov_vec3_of(-1.0, -1.0, -1.0), pov_vec3_of(1.0, 1.0, 1.0));
    for (int i = 1; i <= count; i++)
        members[i] = sphere(&s.model, test_uniform(&r, -1.5, 1.5), test_uniform(&r, -1.5, 1.5),
                            test_uniform(&r, -1.5, 1.5), test_uniform(&r, 0.02, most));
    root = group(&s.model, NODE_DIFFERENCE, false, members, (uint32_t)count + 1);
    assert_true(model_add_tree(&s.model, root));
    compile(&s, POV_ACCEL_TREE);
    for (int i = 0; i < 1000; i++) {
        const pov_vec3 org = { test_uniform(&r, -2.0, 2.0), test_uniform(&r, -2.0, 2.0), test_uniform(&r, -2.0, 2.0) };

        surfaces += check_ray(&s, root, ray_from(org, test_direction(&r)));
    }
    end(&s);
    return surfaces;
}

/* Members are looked for by their boxes, the nearest first: those of some side by side, those of many by a hierarchy. */
static void many_hollows_are_all_found(void **state)
{
    (void)state;
    assert_true(check_hollows(HOLLOWS, 0.2) > 500);
    assert_true(check_hollows(63, 0.3) > 300);
    assert_true(check_hollows(17, 0.5) > 300);
}

/* What the contract asks of a primitive holds of a tree too: by the number of crossings ahead it is known whether a point is
 * inside. (Of those that are no union at the root, where a surface may lie inside.) */
static void crossings_ahead_tell_what_is_inside(void **state)
{
    test_random r = { 11 };
    uint32_t inside = 0;

    (void)state;
    for (int round = 0; round < 200; round++) {
        const node_ref leaves[3] = { 0, 1, 2 };
        csg_root root;
        scene s;

        begin(&s);
        for (int i = 0; i < 3; i++)
            sphere(&s.model, test_uniform(&r, -1.0, 1.0), test_uniform(&r, -1.0, 1.0), test_uniform(&r, -1.0, 1.0),
                   test_uniform(&r, 0.3, 1.5));
        assert_true(model_add_tree(&s.model, group(&s.model, (node_op)(1 + round % 3), false, leaves, 3)));
        compile(&s, POV_ACCEL_TREE);
        root.tree = &world_trees(s.world)->items[0];
        for (int i = 0; i < 40; i++) {
            const pov_vec3 none = { 0.0, 0.0, 0.0 };
            const pov_ray ray = ray_from(pov_vec3_of(test_uniform(&r, -1.5, 1.5), test_uniform(&r, -1.5, 1.5),
                                                   test_uniform(&r, -1.5, 1.5)), test_direction(&r));
            pov_crossing at[16];
            pov_hits hits = hits_to(HUGE_VAL, POV_WANT_ALL, at, 16);

            hits.user = &s.context->hit_buffers[0];
            csg_class.intersect(&root, &ray, &hits);
            assert_int_equal(hits.count & 1, csg_class.inside(&root, ray.org, none));
            inside += hits.count & 1;
        }
        end(&s);
    }
    assert_true(inside > 300);
}

/* ---- what light and media know of it ---- */

/* Light passes the surfaces that are there, each by its leaf: the near one of what was cut out, the far one of the rest. */
static void light_crosses_the_surfaces_that_are_there(void **state)
{
    const pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), ahead), *one = &ray;
    occlusion out;
    uint32_t glass;
    scene s;

    (void)state;
    begin(&s);
    glass = test_add_material(&s.model, colour_of(0.0f, 0.5f, 0.0f), 1.0f, 0.0f, false);
    test_add_light(&s.model, 1.0f);
    test_add_sphere(&s.model, pov_vec3_of(0.0, 0.0, 0.0), 2.0, glass);
    test_add_sphere(&s.model, pov_vec3_of(0.0, 0.0, -1.5), 1.0, glass);
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_DIFFERENCE, 0, 1)));
    compile(&s, POV_ACCEL_TREE);
    assert_int_equal(query_occlusion(s.world, s.context, &one, 1, 10.0, &out), 1);
    assert_int_equal(out.crossed, 1);
    assert_int_equal(out.count[0], 2);
    assert_int_equal(out.at[0][0].owner + out.at[0][1].owner, 1);
    assert_int_equal(query_occlusion(s.world, s.context, &one, 1, 4.25, &out), 1);
    assert_int_equal(out.crossed, 0);   /* it ends in the hollow */
    end(&s);
}

/* An opaque member ends light, but only where its surface is there. */
static void light_ends_at_what_is_opaque(void **state)
{
    const pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), ahead), *one = &ray;
    occlusion out;
    scene s;

    (void)state;
    begin(&s);
    test_add_light(&s.model, 1.0f);
    sphere(&s.model, 0.0, 0.0, 0.0, 2.0);
    sphere(&s.model, 0.0, 0.0, -1.5, 1.0);
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_DIFFERENCE, 0, 1)));
    compile(&s, POV_ACCEL_TREE);
    assert_int_equal(query_occlusion(s.world, s.context, &one, 1, 4.25, &out), 1);
    assert_int_equal(query_occlusion(s.world, s.context, &one, 1, 4.75, &out), 0);
    end(&s);
}

/* Whatever trusts the marks of a shape asks its batch first. */
static void leaves_are_plain_and_trees_are_not(void **state)
{
    const leaf_batch *b;
    uint32_t plain = 0, trees = 0;
    scene s;

    (void)state;
    begin(&s);
    sphere(&s.model, 0.0, 0.0, 0.0, 2.0);
    sphere(&s.model, 0.0, 0.0, -1.5, 1.0);
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_DIFFERENCE, 0, 1)));
    for (int i = 0; i < 20; i++)
        sphere(&s.model, 3.0 * i, 9.0, 0.0, 1.0);
    test_add(&s.model, &test_plain_sphere_class, &(test_sphere_shape){ { 0.0, 0.0, 9.0 }, 1.0 },
             test_transform(&s.model, NULL, TRANSFORM_SCALE, 1.0, 2.0, 3.0), 0, 0);
    compile(&s, POV_ACCEL_NONE);
    for (b = s.world->list; b; b = leaf_batch_next(b)) {
        if (b->shape == &csg_class) {
            assert_int_equal(b->plain, 0);
            trees++;
        } else {
            assert_int_equal(b->plain, leaf_batch_lanes(b));
            plain += b->count;
        }
    }
    assert_int_equal(plain, 21);
    assert_int_equal(trees, 1);
    end(&s);
}

static void its_leaves_are_one_object(void **state)
{
    const solid_node *solid;
    uint32_t leaf;
    scene s;

    (void)state;
    begin(&s);
    sphere(&s.model, 5.0, 0.0, 0.0, 1.0);
    sphere(&s.model, 0.0, 0.0, 0.0, 2.0);
    sphere(&s.model, 0.0, 0.0, -1.5, 1.0);
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_DIFFERENCE, 1, 2)));
    sphere(&s.model, -5.0, 0.0, 0.0, 1.0);
    compile(&s, POV_ACCEL_TREE);
    assert_int_equal(model_object_count(&s.model), 3);
    assert_int_equal(model_object_of(&s.model, 0), 0);
    assert_int_equal(model_object_of(&s.model, 2), 1);
    assert_int_equal(model_object_of(&s.model, 3), 2);
    solid = model_object(&s.model, 1, &leaf);
    assert_non_null(solid);
    assert_int_equal(solid->op, NODE_DIFFERENCE);
    assert_null(model_object(&s.model, 2, &leaf));
    assert_int_equal(leaf, 3);
    assert_int_equal(world_solid(s.world, 2), 1);
    assert_int_equal(world_solid(s.world, 3), 3);
    end(&s);
}

/* Of a polyhedron of many faces a ray asks those only that it may enter or leave by. */
static void of_many_faces_few_are_asked(void **state)
{
    enum { FACES = 60 };
    const shape_class face = face_class();
    test_random r = { 7 };
    node_ref leaves[FACES];
    pov_half_space faces[FACES];
    scene s;
    hit h;

    (void)state;
    begin(&s);
    for (int i = 0; i < FACES; i++) {
        faces[i] = (pov_half_space){ test_direction(&r), 1.0 };
        leaves[i] = test_add(&s.model, &face, &faces[i], NULL, 0, 0);
    }
    assert_true(model_add_tree(&s.model, group(&s.model, NODE_INTERSECTION, false, leaves, FACES)));
    compile(&s, POV_ACCEL_TREE);
    for (int n = 0; n < 1000; n++) {
        const pov_vec3 from = pov_scale(test_direction(&r), 5.0);
        const pov_vec3 to = pov_scale(test_direction(&r), test_uniform(&r, 0.0, 1.1));
        const pov_ray ray = ray_from(from, pov_sub(to, from));
        double enter = 0.0, leave = HUGE_VAL;

        for (int i = 0; i < FACES; i++) {
            const double slope = pov_dot(faces[i].normal, ray.dir);
            const double t = (1.0 - pov_dot(faces[i].normal, from)) / slope;

            enter = slope < 0.0 ? fmax(enter, t) : enter;
            leave = slope > 0.0 ? fmin(leave, t) : leave;
        }
        face_asked = 0;
        assert_int_equal(test_nearest(s.world, s.context, &ray, HUGE_VAL, &h), enter < leave);
        assert_true(enter >= leave || h.crossing.t == (enter > 0.0 ? enter : leave));
        assert_true(face_asked <= 8);
    }
    end(&s);
}

/* A cube made of half-spaces, the last ones of which are written as complements of what lies beyond. */
static node_ref cube_of_faces(model *m, const shape_class *face, double x, double size, int complements)
{
    node_ref leaves[6];

    for (int i = 0; i < 6; i++) {
        const bool complement = i >= 6 - complements;
        const double sign = i % 2 ? -1.0 : 1.0, turn = complement ? -sign : sign;
        const pov_half_space f = { { i / 2 == 0 ? turn : 0.0, i / 2 == 1 ? turn : 0.0, i / 2 == 2 ? turn : 0.0 },
                                   (complement ? -1.0 : 1.0) * (size + (i / 2 == 0 ? sign * x : 0.0)) };

        leaves[i] = test_add(m, face, &f, NULL, 0, complement ? LEAF_INVERSE : 0);
    }
    return group(m, NODE_INTERSECTION, false, leaves, 6);
}

/* Of finite parts of infinite members a ray asks those that it comes to; unless all of a part are complements. */
static void members_of_parts_elsewhere_are_not_asked(void **state)
{
    static const int asked[] = { 6 + 6, 6 + 6, 6 };
    const shape_class face = face_class();
    node_ref parts[3];
    scene s;
    hit h;

    (void)state;
    begin(&s);
    parts[0] = cube_of_faces(&s.model, &face, -10.0, 1.0, 0);
    parts[1] = cube_of_faces(&s.model, &face, 0.0, 2.0, 5);
    parts[2] = cube_of_faces(&s.model, &face, 10.0, 3.0, 6);
    assert_true(model_add_tree(&s.model, group(&s.model, NODE_MERGE, false, parts, 3)));
    compile(&s, POV_ACCEL_TREE);
    for (int i = 0; i < 3; i++) {
        const pov_ray down = ray_from(pov_vec3_of(-9.5 + 10.0 * i, 5.0, 0.25), pov_vec3_of(0.0, -1.0, 0.0));

        face_asked = 0;
        assert_true(test_nearest(s.world, s.context, &down, HUGE_VAL, &h));
        assert_true(h.crossing.t == 4.0 - i);
        assert_int_equal(h.object / 6, i);
        assert_true(face_asked <= asked[i]);
    }
    end(&s);
}

static int face_between_asked;

static void face_between(const void *self, const pov_ray *ray, pov_hits *hits)
{
    assert_true(hits->tmin >= 0.0 && hits->tmax < 100.0);
    face_between_asked++;
    face_intersect(self, ray, hits);
}

/* Infinite members that can are asked for what lies within the tree's box alone, which leaves the tree as it is. */
static void infinite_members_are_asked_within_the_box(void **state)
{
    shape_class face[] = { face_class(), face_class() };
    test_random r = { 11 };
    scene s[2];

    (void)state;
    face[1].intersect_between = face_between;
    for (int i = 0; i < 2; i++) {
        node_ref parts[2];

        begin(&s[i]);
        parts[0] = cube_of_faces(&s[i].model, &face[i], -1.5, 1.0, 3);
        parts[1] = pair(&s[i].model, NODE_DIFFERENCE, sphere(&s[i].model, 1.5, 0.0, 0.0, 2.0), sphere(&s[i].model, 2.0, 0.5, 0.0, 1.5));
        assert_true(model_add_tree(&s[i].model, pair(&s[i].model, NODE_MERGE, parts[0], parts[1])));
        compile(&s[i], POV_ACCEL_TREE);
    }
    face_between_asked = 0;
    for (int n = 0; n < 4000; n++) {
        const pov_vec3 from = pov_scale(test_direction(&r), test_uniform(&r, 0.0, 6.0));
        const pov_ray ray = ray_from(from, test_direction(&r));
        hit a, b;
        const bool hits = test_nearest(s[0].world, s[0].context, &ray, HUGE_VAL, &a);

        assert_int_equal(test_nearest(s[1].world, s[1].context, &ray, HUGE_VAL, &b), hits);
        assert_true(!hits || (a.crossing.t == b.crossing.t && a.object == b.object));
    }
    assert_true(face_between_asked > 1000);
    end(&s[0]);
    end(&s[1]);
}

static uint32_t rod_hull(const void *self, const pov_half_space *within, uint32_t n, pov_half_space *out)
{
    (void)self;
    (void)within;
    (void)n;
    for (int i = 0; i < 4; i++)
        out[i] = (pov_half_space){ { i / 2 == 0 ? 1.0 - i % 2 * 2.0 : 0.0, 0.0, i / 2 == 1 ? 1.0 - i % 2 * 2.0 : 0.0 }, 1.0 };
    return 4;
}

/* Half of what bounds a rod stands in an intersection within the other one. */
static void a_rod_is_finite_by_two_intersections(void **state)
{
    static const pov_half_space top = { { 0.0, 1.0, 0.0 }, 1.0 }, bottom = { { 0.0, -1.0, 0.0 }, 1.0 };
    const shape_class face = face_class();
    shape_class rod = face_class();
    node_ref leaves[3];
    pov_box box;
    scene s;

    (void)state;
    rod.keyword = "rod";
    rod.half_space = NULL;
    rod.hull = rod_hull;
    begin(&s);
    leaves[0] = test_add(&s.model, &rod, &top, NULL, 0, 0);
    leaves[1] = test_add(&s.model, &face, &top, NULL, 0, 0);
    leaves[2] = test_add(&s.model, &face, &bottom, NULL, 0, 0);
    leaves[1] = pair(&s.model, NODE_INTERSECTION, leaves[0], leaves[1]);
    assert_true(model_add_tree(&s.model, pair(&s.model, NODE_CLIP, leaves[1], leaves[2])));
    compile(&s, POV_ACCEL_TREE);
    assert_true(world_bounds(s.world, &box));
    assert_true(pov_largest(box.lo) < 1.001 && pov_largest(box.hi) < 1.001);
    end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sphere_without_a_sphere_begins_at_the_hollow),
        cmocka_unit_test(its_hollow_looks_into_it),
        cmocka_unit_test(an_intersection_is_what_both_hold),
        cmocka_unit_test(a_merge_has_no_inner_faces),
        cmocka_unit_test(a_union_dissolves),
        cmocka_unit_test(a_clip_takes_surfaces_away_and_adds_none),
        cmocka_unit_test(a_clip_of_a_cutter_clips_what_is_left),
        cmocka_unit_test(what_lies_on_the_clips_skin_is_seen),
        cmocka_unit_test(a_patch_is_seen_where_being_in_it_would_matter),
        cmocka_unit_test(a_cutter_that_ends_on_the_faces_leaves_no_film),
        cmocka_unit_test(what_is_taken_from_itself_is_gone),
        cmocka_unit_test(what_only_touches_changes_nothing),
        cmocka_unit_test(a_shared_face_is_the_first_members),
        cmocka_unit_test(order_is_not_asked_for_where_it_does_not_matter),
        cmocka_unit_test(random_trees_are_what_their_members_say_of_points),
        cmocka_unit_test(convex_members_are_what_their_members_say_of_points),
        cmocka_unit_test(many_hollows_are_all_found),
        cmocka_unit_test(crossings_ahead_tell_what_is_inside),
        cmocka_unit_test(light_crosses_the_surfaces_that_are_there),
        cmocka_unit_test(light_ends_at_what_is_opaque),
        cmocka_unit_test(leaves_are_plain_and_trees_are_not),
        cmocka_unit_test(its_leaves_are_one_object),
        cmocka_unit_test(of_many_faces_few_are_asked),
        cmocka_unit_test(members_of_parts_elsewhere_are_not_asked),
        cmocka_unit_test(infinite_members_are_asked_within_the_box),
        cmocka_unit_test(a_rod_is_finite_by_two_intersections),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
