/* The tree gives the list's answers bit for bit, whatever the scene. */
#include "support/check.h"
#include "support/rays.h"
#include "support/shapes.h"

#include "world/internal.h"

/* ---- two worlds of one model ---- */

typedef struct pair { world *tree, *list; query_context *on_tree, *on_list; } pair;

static void make_pair(pair *p, const model *m)
{
    world_options with = { .accel = POV_ACCEL_TREE, .threads = 1 }, without = { .accel = POV_ACCEL_NONE, .threads = 1 };
    pov_error err;

    assert_int_equal(world_create(&p->tree, m, &with, &err), POV_OK);
    assert_int_equal(world_create(&p->list, m, &without, &err), POV_OK);
    assert_int_equal(query_context_create(&p->on_tree, p->tree, &err), POV_OK);
    assert_int_equal(query_context_create(&p->on_list, p->list, &err), POV_OK);
}

static void free_pair(pair *p)
{
    query_context_destroy(p->on_tree);
    query_context_destroy(p->on_list);
    world_destroy(p->tree);
    world_destroy(p->list);
}

static void same_number(double a, double b)
{
    assert_memory_equal(&a, &b, sizeof a);
}

static void same_point(pov_vec3 a, pov_vec3 b)
{
    same_number(a.x, b.x);
    same_number(a.y, b.y);
    same_number(a.z, b.z);
}

/* Ask both for everything; true with the hit when there is one. */
static bool same_answers(pair *p, const pov_ray *ray, double tmax, hit *out)
{
    hit a, b;
    uint32_t x[TEST_CROSSINGS], y[TEST_CROSSINGS], x_count, y_count;
    bool found = test_nearest(p->tree, p->on_tree, ray, tmax, &a);

    assert_int_equal(found, test_nearest(p->list, p->on_list, ray, tmax, &b));
    assert_int_equal(query_blocked(p->tree, p->on_tree, ray, tmax), query_blocked(p->list, p->on_list, ray, tmax));
    assert_int_equal(test_light(p->tree, p->on_tree, ray, tmax, x, &x_count),
                     test_light(p->list, p->on_list, ray, tmax, y, &y_count));
    assert_int_equal(x_count, y_count);
    assert_memory_equal(x, y, sizeof x);
    if (!found)
        return false;
    assert_int_equal(a.object, b.object);
    same_number(a.crossing.t, b.crossing.t);
    same_number(a.crossing.t_lo, b.crossing.t_lo);
    assert_int_equal(a.crossing.mark.feature, b.crossing.mark.feature);
    world_surface(p->tree, ray, &a);
    world_surface(p->list, ray, &b);
    same_point(a.point, b.point);
    same_point(a.point_lo, b.point_lo);
    same_point(a.normal, b.normal);
    assert_int_equal(a.entering, b.entering);
    *out = a;
    return true;
}

/* A ray and those that follow from it: mirrored, straight on, towards a light. Gives the number of hits. */
static int follow(pair *p, pov_ray ray, pov_vec3 lamp)
{
    pov_vec3 no = { 0.0, 0.0, 0.0 };
    int depth, hits = 0;
    hit h, ignored;

    for (depth = 0; depth < 4 && same_answers(p, &ray, HUGE_VAL, &h); depth++) {
        pov_ray shadow;
        hits++;
        shadow.dir_lo = no;
        shadow.org = h.point;
        shadow.org_lo = h.point_lo;
        shadow.dir = pov_sub(lamp, h.point);
        test_leave(&shadow, &h);
        same_answers(p, &shadow, 1.0, &ignored);
        if (depth % 2 == 0)
            shadow.dir = ray.dir;
        else
            shadow.dir = pov_sub(ray.dir, pov_scale(h.normal, 2.0 * pov_dot(h.normal, ray.dir)));
        if (pov_largest(shadow.dir) == 0.0)
            shadow.dir = pov_vec3_of(0.0, 1.0, 0.0);
        ray = shadow;
        test_leave(&ray, &h);
    }
    return hits;
}

/* Rays from within, from near, from far, along axes; positions and sizes times `scale`, moved by `offset`. */
static int trace(pair *p, test_random *r, int rays, double scale, pov_vec3 offset)
{
    int i, hits = 0;

    for (i = 0; i < rays; i++) {
        static const double dir[8] = { 1.0, 3.0, 50.0, 1e7, 1.0, 3.0, 500.0, 1e7 };
        pov_vec3 o = pov_scale(test_direction(r), scale * dir[i % 8]), d = test_direction(r);
        pov_vec3 target = pov_scale(test_direction(r), scale);
        if (i % 4 > 0)
            d = pov_sub(target, o);
        if (i % 16 == 1)
            d = pov_vec3_of(0.0, 0.0, o.z > 0.0 ? -1.0 : 1.0);
        if (i % 16 == 3)
            d = pov_vec3_of(o.x > 0.0 ? -1.0 : 1.0, 0.0, 1e-30);
        if (i % 7 == 0)
            d = pov_scale(d, 1e-7);
        hits +=
            follow(p, ray_from(pov_add(o, offset), d), pov_add(offset, pov_scale(pov_vec3_of(2.0, 5.0, -3.0), scale)));
    }
    return hits;
}

/* ---- scenes ---- */

static pov_vec3 somewhere(test_random *r, double size)
{
    return pov_vec3_of(test_uniform(r, -size, size), test_uniform(r, -size, size), test_uniform(r, -size, size));
}

/* Spheres, bricks, placed and absorbed, opaque and coloured, throwing shadows or not; some exactly alike. */
static void add_mixture(model *m, test_random *r, int n, double scale, pov_vec3 offset, double size)
{
    uint32_t glass = test_add_material(m, colour_of(0.9f, 0.5f, 0.2f), 0.8f, 0.1f, true);
    int i;

    for (i = 0; i < n; i++) {
        pov_vec3 c = pov_add(offset, somewhere(r, scale));
        test_sphere_shape sphere = { c, scale * size * test_uniform(r, 0.2, 1.0) };
        test_brick brick = {c, pov_add(c, pov_scale(pov_vec3_of(1.0, test_uniform(r, 0.1, 2.0), 0.5), scale * size))};
        uint32_t surface = test_below(r, 3) == 0 ? glass : 0, flags = test_below(r, 8) == 0 ? LEAF_NO_SHADOW : 0;
        const transform *map = NULL;
        switch (test_below(r, 6)) {
        case 0:
            test_add(m, &test_brick_class, &brick, NULL, surface, flags);
            break;
        case 1:
            sphere.centre = pov_vec3_of(0.25, 0.0, 0.0);
            sphere.radius = 1.0;
            map = test_transform(m, map, TRANSFORM_SCALE, scale * size, 0.5 * scale * size, 2.0 * scale * size);
            map = test_transform(m, map, TRANSFORM_ROTATE, 10.0, 50.0, 70.0);
            map = test_transform(m, map, TRANSFORM_TRANSLATE, c.x, c.y, c.z);
            test_add(m, &test_sphere_class, &sphere, map, surface, flags | LEAF_INVERSE);
            break;
        case 2:
            test_add(m, &test_plain_sphere_class, &sphere, NULL, surface, flags);
            break;
        case 3:
            test_add(m, &test_sphere_class, &sphere, NULL, 0, flags);
            test_add(m, &test_sphere_class, &sphere, NULL, glass, flags);
            break;
        default:
            test_add(m, &test_sphere_class, &sphere, NULL, surface, flags);
        }
    }
}

static void mixture_is_the_same(int n, int rays, double scale, pov_vec3 offset, double size, uint64_t seed)
{
    test_random r = { seed };
    model m;
    pair p;
    int hits;

    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    add_mixture(&m, &r, n, scale, offset, size);
    make_pair(&p, &m);
    assert_true(p.tree->has_tree);
    hits = trace(&p, &r, rays, scale, offset);
    assert_true(hits > rays / 8);
    p.tree->kernels = &bvh_kernels_portable;
    trace(&p, &r, rays / 4, scale, offset);
    free_pair(&p);
    model_free(&m);
}

static const pov_vec3 origin = { 0.0, 0.0, 0.0 };

static void small_and_large_mixtures_are_the_same(void **state)
{
    (void)state;
    mixture_is_the_same(20, 1500, 1.0, origin, 0.3, 1);
    mixture_is_the_same(300, 700, 1.0, origin, 0.1, 2);
    mixture_is_the_same(2000, 200, 1.0, origin, 0.05, 3);
}

static void scenes_of_every_scale_are_the_same(void **state)
{
    static const double scales[] = { 1e-100, 1e-30, 1e-12, 1e-5, 1e5, 1e12, 1e30, 1e100 };
    size_t i;

    (void)state;
    for (i = 0; i < sizeof scales / sizeof scales[0]; i++)
        mixture_is_the_same(100, 400, scales[i], origin, 0.15, 10 + i);
}

static void scenes_far_from_the_origin_are_the_same(void **state)
{
    static const double distances[] = { 1e3, 1e6, 1e9, 1e12 };
    size_t i;

    (void)state;
    for (i = 0; i < sizeof distances / sizeof distances[0]; i++)
        mixture_is_the_same(100, 400, 1.0, pov_vec3_of(distances[i], -0.5 * distances[i], 2.0 * distances[i]), 0.15,
                            20 + i);
}

/* Clusters within clusters: each has its own frame in the tree. */
static void scenes_of_very_uneven_sizes_are_the_same(void **state)
{
    static const double scales[] = { 1e6, 1.0, 1e-5, 1e-9 };
    test_random r = { 31 };
    model m;
    pair p;
    size_t i;

    (void)state;
    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    for (i = 0; i < 4; i++)
        add_mixture(&m, &r, 60, scales[i], origin, 0.1);
    make_pair(&p, &m);
    assert_true(p.tree->tree.frame_count > 2);
    for (i = 0; i < 4; i++)
        assert_true(trace(&p, &r, 400, scales[i], origin) > 100);
    free_pair(&p);
    model_free(&m);
}

/* Centres that go apart ever faster: no cut is good, and depth is bounded. */
static void a_long_thin_scene_is_the_same(void **state)
{
    test_random r = { 32 };
    model m;
    pair p;
    double x = 1e-60;
    int i;

    (void)state;
    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    for (i = 0; i < 400; i++, x *= 1.9)
        test_add_sphere(&m, pov_vec3_of(x, 0.0, 0.0), 0.4 * x, 0);
    make_pair(&p, &m);
    assert_true(p.tree->tree.depth < BVH_DEPTH);
    for (x = 1e-50; x < 1e50; x *= 1e10)
        assert_true(trace(&p, &r, 100, x, origin) > 10);
    free_pair(&p);
    model_free(&m);
}

static void objects_all_alike_are_the_same_and_the_first_wins(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), pov_vec3_of(0.0, 0.1, 1.0));
    test_random r = { 33 };
    model m;
    pair p;
    hit h;
    int i;

    (void)state;
    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    for (i = 0; i < 1000; i++)
        test_add_sphere(&m, pov_vec3_of(0.5, 0.5, 0.5), 1.0, 0);
    make_pair(&p, &m);
    assert_true(p.tree->tree.depth < 8);
    assert_true(same_answers(&p, &ray, HUGE_VAL, &h));
    assert_int_equal(h.object, 0);
    trace(&p, &r, 500, 2.0, origin);
    free_pair(&p);
    model_free(&m);
}

/* Flat boxes, and boxes of no extent at all. */
static void degenerate_boxes_are_the_same(void **state)
{
    test_random r = { 34 };
    model m;
    pair p;
    int i;

    (void)state;
    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    for (i = 0; i < 200; i++) {
        pov_vec3 c = somewhere(&r, 1.0);
        test_brick slab = { c, pov_add(c, pov_vec3_of(0.3, i % 2 ? 0.0 : 0.2, 0.0)) };
        test_sphere_shape point = { c, 0.0 };
        test_add(&m, &test_brick_class, &slab, NULL, 0, 0);
        test_add(&m, &test_sphere_class, &point, NULL, 0, 0);
    }
    test_add_sphere(&m, origin, 0.1, 0);
    make_pair(&p, &m);
    trace(&p, &r, 2000, 1.0, origin);
    free_pair(&p);
    model_free(&m);
}

static void points_alone_make_a_tree(void **state)
{
    test_random r = { 35 };
    model m;
    pair p;
    int i;

    (void)state;
    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    for (i = 0; i < 100; i++)
        test_add_sphere(&m, pov_vec3_of(3.0, 3.0, 3.0), 0.0, 0);
    make_pair(&p, &m);
    trace(&p, &r, 200, 4.0, origin);
    free_pair(&p);
    model_free(&m);
}

static void a_tree_may_be_of_one_object_but_not_of_none(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), pov_vec3_of(0.0, 0.0, 1.0));
    test_random r = { 36 };
    model m;
    pov_box box;
    pair p;
    hit h;

    (void)state;
    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    make_pair(&p, &m);
    assert_false(same_answers(&p, &ray, HUGE_VAL, &h));
    assert_false(world_bounds(p.tree, &box));
    assert_false(p.tree->has_tree);
    free_pair(&p);
    test_add_sphere(&m, origin, 1.0, 0);
    make_pair(&p, &m);
    assert_true(p.tree->has_tree);
    assert_true(same_answers(&p, &ray, HUGE_VAL, &h));
    same_number(h.crossing.t, 4.0);
    trace(&p, &r, 500, 1.0, origin);
    free_pair(&p);
    model_free(&m);
}

static void infinite_objects_are_tested_separately(void **state)
{
    test_random r = { 37 };
    test_ground ground[3] = { { -1.0 }, { -1.5 }, { -1.0 } };
    model m;
    pair p;
    int i;

    (void)state;
    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    for (i = 0; i < 3; i++)
        test_add(&m, &test_ground_class, &ground[i], NULL, 0, i == 2 ? LEAF_NO_SHADOW : 0);
    make_pair(&p, &m);
    assert_int_equal(world_get_facts(p.tree).infinite, 3);
    assert_true(trace(&p, &r, 500, 1.0, origin) > 100);
    free_pair(&p);
    add_mixture(&m, &r, 100, 1.0, origin, 0.1);
    make_pair(&p, &m);
    assert_true(p.tree->has_tree);
    assert_true(trace(&p, &r, 1500, 1.0, origin) > 500);
    free_pair(&p);
    model_free(&m);
}

static void infinite_objects_share_blocks(void **state)
{
    test_random r = { 43 };
    model m;
    pair p;
    size_t i;
    int k;

    (void)state;
    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    for (k = 0; k < 21; k++) {
        test_sphere_shape sphere = { somewhere(&r, 1.0), test_uniform(&r, 0.05, 0.3) };
        test_add(&m, &test_loose_sphere_class, &sphere, NULL, 0, k % 5 == 4 ? LEAF_NO_SHADOW : 0);
    }
    add_mixture(&m, &r, 100, 1.0, origin, 0.1);
    make_pair(&p, &m);
    assert_int_equal(world_get_facts(p.tree).infinite, 21);
    assert_true(p.tree->has_tree);
    for (i = 0; i < p.tree->group_count; i++)
        if (p.tree->groups[i].shape == &test_loose_sphere_class)
            assert_true(p.tree->groups[i].shares_leaf);
    assert_true(trace(&p, &r, 1500, 1.0, origin) > 500);
    free_pair(&p);
    model_free(&m);
}

/* The last in the order of asking is the first of the scene, and the other way round. */
static void of_equal_distances_the_earlier_object_wins(void **state)
{
    test_random r = { 38 };
    test_brick brick = { { -0.5, -0.5, 0.0 }, { 0.5, 0.5, 1.0 } };
    pov_ray ray = ray_from(pov_vec3_of(0.1, 0.2, -5.0), pov_vec3_of(0.0, 0.0, 1.0));
    model m;
    pair p;
    hit h;
    uint32_t first;

    (void)state;
    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    add_mixture(&m, &r, 100, 0.1, pov_vec3_of(0.0, 3.0, 0.0), 0.2);
    first = test_add(&m, &test_brick_class, &brick, NULL, 0, 0);
    brick.hi.z = 3.0;
    test_add(&m, &test_brick_class, &brick, NULL, 0, 0);
    brick.lo.x = -7.0;
    test_add(&m, &test_brick_class, &brick, NULL, 0, 0);
    make_pair(&p, &m);
    assert_true(same_answers(&p, &ray, HUGE_VAL, &h));
    assert_int_equal(h.object, first);
    same_number(h.crossing.t, 5.0);
    free_pair(&p);
    model_free(&m);
}

static void rays_of_every_length_and_distance_are_the_same(void **state)
{
    static const double lengths[] = { 1e-200, 1e-40, 1e-7, 1.0, 1e7, 1e40, 1e200 };
    static const double distances[] = { 1.0, 1e4, 1e8, 1e12, 1e16, 1e30, 1e100 };
    test_random r = { 39 };
    model m;
    pair p;
    size_t i, k;
    int n;

    (void)state;
    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    add_mixture(&m, &r, 300, 1.0, origin, 0.1);
    make_pair(&p, &m);
    for (i = 0; i < 7; i++)
        for (k = 0; k < 7; k++)
            for (n = 0; n < 15; n++) {
                pov_vec3 dir = pov_unit(test_direction(&r)),
                         o = pov_add(pov_scale(dir, -distances[k]), somewhere(&r, 1.0));
                hit h;
                pov_ray ray = ray_from(o, pov_scale(dir, lengths[i]));
                same_answers(&p, &ray, HUGE_VAL, &h);
                same_answers(&p, &ray, distances[k] / lengths[i], &h);
            }
    free_pair(&p);
    model_free(&m);
}

/* Nothing but its box tells which rays miss a brick; of a sphere a filter does. */
static void one_object_without_a_filter_has_a_node(void **state)
{
    const test_brick brick = { { -0.5, -0.5, 0.0 }, { 0.5, 0.5, 1.0 } };
    const test_sphere_shape sphere = { { 0.0, 0.0, 0.0 }, 0.5 };
    test_random r = { 41 };

    (void)state;
    for (int filtered = 0; filtered < 2; filtered++) {
        model m;
        pair p;

        test_model_init(&m, NULL);
        test_add_light(&m, 1.0f);
        test_add(&m, filtered ? &test_sphere_class : &test_brick_class, filtered ? (const void *)&sphere : &brick, NULL, 0, 0);
        make_pair(&p, &m);
        assert_true(p.tree->has_tree);
        assert_int_equal(p.tree->tree.node_count, filtered ? 0 : 1);
        assert_true(trace(&p, &r, 300, 1.0, origin) > 20);
        free_pair(&p);
        model_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(small_and_large_mixtures_are_the_same),
        cmocka_unit_test(one_object_without_a_filter_has_a_node),
        cmocka_unit_test(scenes_of_every_scale_are_the_same),
        cmocka_unit_test(scenes_far_from_the_origin_are_the_same),
        cmocka_unit_test(scenes_of_very_uneven_sizes_are_the_same),
        cmocka_unit_test(a_long_thin_scene_is_the_same),
        cmocka_unit_test(objects_all_alike_are_the_same_and_the_first_wins),
        cmocka_unit_test(degenerate_boxes_are_the_same),
        cmocka_unit_test(points_alone_make_a_tree),
        cmocka_unit_test(a_tree_may_be_of_one_object_but_not_of_none),
        cmocka_unit_test(infinite_objects_are_tested_separately),
        cmocka_unit_test(infinite_objects_share_blocks),
        cmocka_unit_test(of_equal_distances_the_earlier_object_wins),
        cmocka_unit_test(rays_of_every_length_and_distance_are_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
