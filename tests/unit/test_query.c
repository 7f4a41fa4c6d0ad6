/* What rays are told: what light crosses, shapes in spaces of their own, dielectrics, memory that ends. */
#include "support/check.h"
#include "support/failing.h"
#include "support/near.h"
#include "support/rays.h"
#include "support/shapes.h"

#include "query/context.h"

#include <string.h>

static const pov_vec3 origin = { 0.0, 0.0, 0.0 };

static world *make(const model *m, pov_accel accel)
{
    world_options options = { .accel = accel, .threads = 1 };
    pov_error err;
    world *w;

    assert_int_equal(world_create(&w, m, &options, &err), POV_OK);
    return w;
}

static query_context *traversal_in(const world *w)
{
    pov_error err;
    query_context *k;

    assert_int_equal(query_context_create(&k, w, &err), POV_OK);
    return k;
}

static const pov_vec3 ahead = { 0.0, 0.0, 1.0 };

/* ---- light ---- */

/* Where a definite pair is noted, and where crossings are asked for one by one. */
static void light_crosses_transparent_surfaces_in_the_order_of_objects(void **state)
{
    const uint32_t owners[6] = { 0, 0, 1, 1, 2, 2 };
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -1.0), ahead);
    uint32_t found[TEST_CROSSINGS], count, i;
    model m;
    world *w;
    query_context *k;

    (void)state;
    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    for (i = 0; i < 3; i++) {
        const test_sphere_shape sphere = { pov_vec3_of(0.0, 0.0, i == 2 ? 2.0 : 8.0 - 3.0 * i), 1.0 };
        const uint32_t glass = test_add_material(&m, colour_of(1, 1, 1), 0.7f, 0.2f, false);

        test_add(&m, i == 1 ? &test_plain_sphere_class : &test_sphere_class, &sphere, NULL, glass, 0);
    }
    w = make(&m, POV_ACCEL_TREE);
    k = traversal_in(w);
    assert_true(test_light(w, k, &ray, HUGE_VAL, found, &count));
    assert_int_equal(count, 6);
    assert_memory_equal(found, owners, sizeof owners);
    assert_true(test_light(w, k, &ray, 3.0, found, &count));
    assert_int_equal(count, 1);
    assert_true(test_light(w, k, &ray, 1.5, found, &count));
    assert_int_equal(count, 0);
    query_context_destroy(k);
    world_destroy(w);
    model_free(&m);
}

/* Of objects that are not plain shading is told where they are crossed; nothing is taken from a filter's word. */
static void crossings_of_objects_that_are_not_plain_are_located(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -1.0), ahead);
    const pov_ray *rays = &ray;
    occlusion found;
    model m;
    world *w;
    query_context *k;
    uint32_t i;

    (void)state;
    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    for (i = 0; i < 3; i++)
        test_add_sphere(&m, pov_vec3_of(0.0, 0.0, 4.0 + 3.0 * i), 1.0,
                        test_add_material(&m, colour_of(1, 1, 1), 0.7f, 0.2f, false));
    w = make(&m, POV_ACCEL_TREE);
    k = traversal_in(w);
    assert_false(w->located);
    w->located = true;
    for (i = 0; i < w->tree.leaf_bytes;) {
        leaf_batch *r = (leaf_batch *)(void *)(w->tree.leaves + i);

        assert_int_equal(r->plain, leaf_batch_lanes(r));
        r->plain = 0;
        i += (uint32_t)leaf_batch_bytes(r->shape, r->count, r->flags);
    }
    for (i = 0; i < 3; i++)
        w->objects_info[i].plain = false;
    assert_int_equal(query_occlusion(w, k, &rays, 1, HUGE_VAL, &found), 1);
    assert_int_equal(found.crossed, 1);
    assert_int_equal(found.count[0], 6);
    for (i = 0; i < 6; i++) {
        assert_int_equal(found.at[0][i].owner, i / 2);
        assert_near(found.at[0][i].t, 4.0 + 3.0 * (i / 2) + 2.0 * (i % 2), 1e-14);
    }
    query_context_destroy(k);
    world_destroy(w);
    model_free(&m);
}

static void an_opaque_object_behind_glass_blocks_light(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -1.0), ahead);
    uint32_t found[TEST_CROSSINGS], count;
    model m;
    world *w;
    query_context *k;

    (void)state;
    test_model_init(&m, NULL);
    test_add_light(&m, 1.0f);
    test_add_sphere(&m, pov_vec3_of(0.0, 0.0, 2.0), 1.0, test_add_material(&m, colour_of(1, 1, 1), 1.0f, 0.0f, false));
    test_add_sphere(&m, pov_vec3_of(0.0, 0.0, 9.0), 1.0, 0);
    w = make(&m, POV_ACCEL_TREE);
    k = traversal_in(w);
    assert_true(test_light(w, k, &ray, 8.0, found, &count));
    assert_false(test_light(w, k, &ray, 20.0, found, &count));
    assert_true(query_blocked(w, k, &ray, 8.0));
    query_context_destroy(k);
    world_destroy(w);
    model_free(&m);
}

static void what_throws_no_shadow_is_passed_by_light_but_not_by_sight(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), ahead);
    test_sphere_shape sphere = { { 0.0, 0.0, 0.0 }, 1.0 };
    uint32_t found[TEST_CROSSINGS], count;
    model m;
    world *w;
    query_context *k;
    hit h;

    (void)state;
    test_model_init(&m, NULL);
    test_add(&m, &test_sphere_class, &sphere, NULL, 0, LEAF_NO_SHADOW);
    w = make(&m, POV_ACCEL_TREE);
    k = traversal_in(w);
    assert_true(test_nearest(w, k, &ray, HUGE_VAL, &h));
    assert_true(test_light(w, k, &ray, HUGE_VAL, found, &count));
    assert_false(query_blocked(w, k, &ray, HUGE_VAL));
    query_context_destroy(k);
    world_destroy(w);
    model_free(&m);
}

/* ---- sight ---- */

typedef struct room { shape_class convex; model model; world *world; query_context *context; } room;

/* Object 0 is a sphere of 100 around all, object 1 a small one ahead; neither throws a shadow. */
static void make_room(room *r)
{
    const test_sphere_shape around = { { 0.0, 0.0, 0.0 }, 100.0 }, small = { { 0.0, 0.0, 5.0 }, 1.0 };

    r->convex = test_sphere_class;
    r->convex.flags |= POV_SHAPE_CONVEX;
    test_model_init(&r->model, NULL);
    test_add(&r->model, &r->convex, &around, NULL, 0, LEAF_NO_SHADOW);
    test_add(&r->model, &r->convex, &small, NULL, 0, LEAF_NO_SHADOW);
    r->world = make(&r->model, POV_ACCEL_TREE);
    r->context = traversal_in(r->world);
}

static void free_room(room *r)
{
    query_context_destroy(r->context);
    world_destroy(r->world);
    model_free(&r->model);
}

static bool sees(const room *r, pov_vec3 from, pov_vec3 to, departure end)
{
    const pov_ray ray = ray_from(from, pov_sub(to, from)), *const rays = &ray;

    return query_visible(r->world, r->context, &rays, 1, 1.0 - 0x1p-20, end) == 1;
}

static void what_throws_no_shadow_hides_what_lies_behind_it(void **state)
{
    const departure around = { 0, false }, none = { POV_NO_OWNER, false };
    room r;

    (void)state;
    make_room(&r);
    assert_true(sees(&r, origin, pov_vec3_of(100.0, 0.0, 0.0), around));
    assert_true(sees(&r, origin, pov_vec3_of(0.0, 0.0, 4.0), (departure){ 1, true }));
    assert_false(sees(&r, origin, pov_vec3_of(0.0, 0.0, 100.0), around));
    assert_false(sees(&r, origin, pov_vec3_of(0.0, 0.0, 6.0), (departure){ 1, false }));
    assert_false(sees(&r, origin, pov_vec3_of(200.0, 0.0, 0.0), none));
    free_room(&r);
}

/* From outside a solid the way to its inner side leads through it, also where others start inside. */
static void the_inner_side_of_a_solid_is_hidden_from_outside(void **state)
{
    const departure around = { 0, false };
    const pov_vec3 end = { 100.0, 0.0, 0.0 };
    pov_ray two[2], *const rays[2] = { &two[0], &two[1] };
    room r;

    (void)state;
    make_room(&r);
    two[0] = ray_from(origin, end);
    two[1] = ray_from(pov_vec3_of(-150.0, 0.0, 0.0), pov_vec3_of(250.0, 0.0, 0.0));
    assert_int_equal(query_visible(r.world, r.context, (const pov_ray *const *)rays, 2, 1.0 - 0x1p-20, around), 1);
    free_room(&r);
}

static bool is_clear(const room *r, pov_vec3 from, pov_vec3 corner)
{
    const departure none = { POV_NO_OWNER, false };
    const pov_vec3 side = { 1.0, 0.0, 0.0 }, up = { 0.0, 1.0, 0.0 };
    pov_vec3 to[4] = { pov_sub(corner, from) };
    shaft s;

    to[1] = pov_add(to[0], side);
    to[2] = pov_add(to[1], up);
    to[3] = pov_add(to[0], up);
    assert_true(shaft_make(&s, from, to));
    return query_is_clear(r->world, &s, none, none);
}

static void a_pyramid_inside_a_convex_solid_is_clear_of_it(void **state)
{
    room r;

    (void)state;
    make_room(&r);
    assert_true(is_clear(&r, pov_vec3_of(0.0, 0.0, -20.0), pov_vec3_of(30.0, 0.0, 0.0)));
    assert_false(is_clear(&r, pov_vec3_of(0.0, 0.0, -20.0), pov_vec3_of(-0.5, -0.5, 20.0)));   /* the small one */
    assert_false(is_clear(&r, pov_vec3_of(0.0, 0.0, -20.0), pov_vec3_of(99.5, 0.0, 0.0)));
    assert_false(is_clear(&r, pov_vec3_of(0.0, 0.0, -101.0), pov_vec3_of(30.0, 0.0, 0.0)));
    free_room(&r);
}

/* ---- leaving ---- */

static void a_ray_that_leaves_a_sphere_hits_its_other_side_only(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), ahead);
    model m;
    world *w;
    query_context *k;
    hit h;

    (void)state;
    test_model_init(&m, NULL);
    test_add_sphere(&m, origin, 1.0, test_add_material(&m, colour_of(1, 1, 1), 0.5f, 0.0f, false));
    w = make(&m, POV_ACCEL_TREE);
    k = traversal_in(w);
    assert_true(test_nearest(w, k, &ray, HUGE_VAL, &h));
    world_surface(w, &ray, &h);
    assert_true(h.entering);
    ray.org = h.point;
    ray.org_lo = h.point_lo;
    ray.origin_surface = h.object;
    ray.origin_mark = h.crossing.mark;
    assert_true(test_nearest(w, k, &ray, HUGE_VAL, &h));
    assert_near(h.crossing.t, 2.0, 0.0);
    world_surface(w, &ray, &h);
    assert_false(h.entering);
    ray.dir.z = -1.0;
    assert_false(test_nearest(w, k, &ray, HUGE_VAL, &h));
    assert_false(query_blocked(w, k, &ray, HUGE_VAL));
    query_context_destroy(k);
    world_destroy(w);
    model_free(&m);
}

/* ---- shapes in spaces of their own ---- */

static hit nearest_of(const model *m, const pov_ray *ray, bool *found)
{
    world *w = make(m, POV_ACCEL_TREE);
    query_context *k = traversal_in(w);
    hit h;

    memset(&h, 0, sizeof h);
    *found = test_nearest(w, k, ray, HUGE_VAL, &h);
    if (*found)
        world_surface(w, ray, &h);
    query_context_destroy(k);
    world_destroy(w);
    return h;
}

/* The same sphere once as it is and once made of a unit sphere by scale and translate. */
static void instance_matches_plain(double radius, pov_vec3 centre, double distance, test_random *r)
{
    test_sphere_shape plain = { centre, radius }, unit = { { 0.0, 0.0, 0.0 }, 1.0 };
    model a, b;
    int i;

    test_model_init(&a, NULL);
    test_model_init(&b, NULL);
    test_add(&a, &test_plain_sphere_class, &plain, NULL, 0, 0);
    test_add(&b, &test_plain_sphere_class, &unit,
             test_transform(&b, test_transform(&b, NULL, TRANSFORM_SCALE, radius, radius, radius), TRANSFORM_TRANSLATE,
                            centre.x, centre.y, centre.z),
             0, 0);
    for (i = 0; i < 50; i++) {
        pov_vec3 dir = pov_unit(test_direction(r));
        pov_ray ray = ray_from(pov_add(centre, pov_scale(dir, -distance)), pov_scale(dir, test_uniform(r, 0.1, 3.0)));
        bool x, y;
        hit g, h;
        ray.org = pov_add(ray.org, pov_scale(test_direction(r), 0.9 * radius));
        g = nearest_of(&a, &ray, &x);
        h = nearest_of(&b, &ray, &y);
        assert_int_equal(x, y);
        if (!x)
            continue;
        assert_near((g.crossing.t - h.crossing.t) + (g.crossing.t_lo - h.crossing.t_lo), 0.0, 1e-15 * radius);
        assert_near(pov_largest(pov_sub(g.normal, h.normal)), 0.0, 1e-15);
    }
    model_free(&a);
    model_free(&b);
}

static void an_instance_of_a_sphere_matches_a_plain_one_however_far(void **state)
{
    static const double far[] = { 2.0, 1e3, 1e6, 1e9, 1e12 };
    test_random r = { 5 };
    size_t i;

    (void)state;
    for (i = 0; i < 5; i++) {
        instance_matches_plain(1.0, origin, far[i], &r);
        instance_matches_plain(1.0, pov_vec3_of(1e9, -2e9, 3e9), far[i], &r);
        instance_matches_plain(1e-12, origin, 1e-12 * far[i], &r);
        instance_matches_plain(1e100, pov_vec3_of(1e103, 0.0, 0.0), 1e100 * far[i], &r);
    }
}

/* An ellipsoid from its equation: |S^-1 p| = 1. */
static void a_stretched_and_turned_sphere_is_an_ellipsoid(void **state)
{
    test_sphere_shape unit = { { 0.0, 0.0, 0.0 }, 1.0 };
    pov_ray ray = ray_from(pov_vec3_of(7.0, 3.0, -50.0), ahead);
    const transform *map;
    model m;
    hit h;
    bool found;

    (void)state;
    test_model_init(&m, NULL);
    map = test_transform(&m, NULL, TRANSFORM_SCALE, 1.0, 2.0, 4.0);
    map = test_transform(&m, map, TRANSFORM_ROTATE, 0.0, 90.0, 0.0);   /* +z goes to +x */
    map = test_transform(&m, map, TRANSFORM_TRANSLATE, 5.0, 2.0, 3.0);
    test_add(&m, &test_plain_sphere_class, &unit, map, 0, 0);
    h = nearest_of(&m, &ray, &found);
    assert_true(found);
    /* (2/4)^2 + (1/2)^2 + z^2 = 1, seen from -50, about z = 3. */
    assert_near(h.crossing.t, 53.0 - sqrt(0.5), 1e-14);
    assert_near(h.normal.x / h.normal.z, (2.0 / 16.0) / -sqrt(0.5), 1e-14);
    assert_near(h.normal.y / h.normal.z, (1.0 / 4.0) / -sqrt(0.5), 1e-14);
    assert_near(pov_dot(h.normal, h.normal), 1.0, 1e-15);
    assert_near(h.point.z + h.point_lo.z, 3.0 - sqrt(0.5), 1e-14);
    assert_true(h.entering);
    model_free(&m);
}

/* Each corner of a turned box lies in the box that the tree is given. */
static void a_box_around_an_instance_holds_all_of_it(void **state)
{
    test_random r = { 6 };
    int i, k;

    (void)state;
    for (i = 0; i < 200; i++) {
        pov_box own = { test_direction(&r), test_direction(&r) }, around;
        double far = i % 2 ? 1e9 : 1e-3;
        pov_affine map;
        model m;
        own.hi = pov_add(own.lo, pov_vec3_of(fabs(own.hi.x), fabs(own.hi.y), fabs(own.hi.z)));
        test_model_init(&m, NULL);
        assert_true(
            transform_compose(test_transform(&m, test_transform(&m, NULL, TRANSFORM_ROTATE, i, 2.0 * i, 3.0 * i + 1.0),
                                             TRANSFORM_TRANSLATE, far, -far, 0.1),
                              &map));
        instance_box(&map, &own, &around);
        for (k = 0; k < 8; k++) {
            pov_vec3 hi, lo,
                p = pov_vec3_of(k & 1 ? own.lo.x : own.hi.x, k & 2 ? own.lo.y : own.hi.y, k & 4 ? own.lo.z : own.hi.z);
            transform_point(&map, p, &hi, &lo);
            assert_true(hi.x > around.lo.x || (hi.x == around.lo.x && lo.x >= 0.0));
            assert_true(hi.x < around.hi.x || (hi.x == around.hi.x && lo.x <= 0.0));
            assert_true(hi.y >= around.lo.y && hi.y <= around.hi.y && hi.z >= around.lo.z && hi.z <= around.hi.z);
        }
        assert_true(around.hi.x - around.lo.x < 2.0 * 1.8 + 1e-6 * far);
        model_free(&m);
    }
}

/* ---- inverse objects and dielectrics ---- */

static void an_inverse_object_turns_its_normal(void **state)
{
    test_sphere_shape sphere = { { 0.0, 0.0, 0.0 }, 1.0 };
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), ahead);
    model m;
    hit h;
    bool found;

    (void)state;
    test_model_init(&m, NULL);
    test_add(&m, &test_sphere_class, &sphere, NULL, 0, LEAF_INVERSE);
    h = nearest_of(&m, &ray, &found);
    assert_true(found);
    assert_near(h.normal.z, 1.0, 0.0);
    assert_false(h.entering);
    model_free(&m);
}

typedef struct seen { uint32_t object[8]; int count; } seen;

static void see(void *user, uint32_t medium_object)
{
    seen *s = user;
    s->object[s->count++] = medium_object;
}

static void the_dielectrics_of_a_point_come_with_the_inner_ones_last(void **state)
{
    test_sphere_shape sphere = { { 0.0, 0.0, 0.0 }, 1.0 }, excluded = { { 9.0, 0.0, 0.0 }, 1.0 };
    test_ground ground = { 0.5 };
    seen s = { { 0 }, 0 };
    uint32_t glass;
    model m;
    world *w;

    (void)state;
    test_model_init(&m, NULL);
    glass = test_add_material(&m, colour_of(1, 1, 1), 1.0f, 0.0f, true);
    test_add(&m, &test_sphere_class, &sphere, NULL, 0, 0);
    test_add(&m, &test_sphere_class, &sphere, test_transform(&m, NULL, TRANSFORM_SCALE, 2.0, 3.0, 4.0), glass, 0);
    test_add(&m, &test_sphere_class, &excluded, NULL, glass, 0);
    test_add(&m, &test_ground_class, &ground, NULL, glass, 0);
    test_add(&m, &test_sphere_class, &excluded, NULL, glass, LEAF_INVERSE);
    test_add(&m, &test_sphere_class, &sphere, NULL, glass, LEAF_INVERSE);
    w = make(&m, POV_ACCEL_TREE);
    world_dielectrics_at(w, origin, origin, see, &s);
    assert_int_equal(s.count, 3);
    assert_int_equal(s.object[0], 3);
    assert_int_equal(s.object[1], 4);
    assert_int_equal(s.object[2], 1);
    world_destroy(w);
    model_free(&m);
}

/* ---- memory ---- */

static void fill(model *m)
{
    test_random r = { 3 };
    uint32_t glass = test_add_material(m, colour_of(1, 1, 1), 0.9f, 0.0f, true);
    int i;

    test_add_light(m, 1.0f);
    for (i = 0; i < 60; i++) {
        test_sphere_shape sphere = { test_direction(&r), 0.3 };
        const transform *map = i % 3 ? NULL : test_transform(m, NULL, TRANSFORM_SCALE, 1.0, 2.0, 1.0);
        test_add(m, i % 2 ? &test_sphere_class : &test_plain_sphere_class, &sphere, map, glass, 0);
    }
}

/* Build and trace with memory that ends at the n-th request, for each n until there was enough. */
static void memory_may_end_anywhere(void **state)
{
    pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -5.0), ahead);
    long n, crossings = 0;
    bool enough = false;

    (void)state;
    for (n = 1; !enough; n++) {
        world_options options = { .accel = POV_ACCEL_TREE, .threads = 1 };
        failing counter;
        pov_allocator hooks;
        world *w = NULL;
        query_context *k = NULL;
        uint32_t found[TEST_CROSSINGS], count;
        pov_error err;
        model m;
        env e;

        failing_init(&counter, 0);
        hooks = failing_allocator(&counter);
        env_init(&e, &hooks, NULL, NULL);
        test_model_init(&m, &e);
        fill(&m);
        counter.fail_at = counter.calls + n;
        err.status = POV_OK;
        if (world_create(&w, &m, &options, &err) < 0) {
            assert_int_equal(err.status, POV_E_MEMORY);
            assert_null(w);
        } else if (query_context_create(&k, w, &err) < 0) {
            assert_int_equal(err.status, POV_E_MEMORY);
        } else {
            test_light(w, k, &ray, HUGE_VAL, found, &count);
            enough = !query_context_failed(k);
            crossings = (long)k->hit_buffers[0].capacity;
        }
        query_context_destroy(k);
        world_destroy(w);
        model_free(&m);
        assert_int_equal(counter.blocks, 0);
        assert_true(n < 500);
    }
    assert_true(n > 20);
    assert_true(crossings > 0);
}

static void a_transformation_without_an_inverse_is_an_error(void **state)
{
    static const double compile_matrix[12] = { 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0 };
    world_options options = { .accel = POV_ACCEL_TREE, .threads = 1 };
    test_sphere_shape sphere = { { 0.0, 0.0, 0.0 }, 1.0 };
    pov_error err;
    world *w;
    model m;

    (void)state;
    test_model_init(&m, NULL);
    test_add(&m, &test_sphere_class, &sphere, transform_append(&m.maps, NULL, TRANSFORM_MATRIX, compile_matrix), 0, 0);
    assert_int_equal(world_create(&w, &m, &options, &err), POV_E_SYNTAX);
    assert_null(w);
    model_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_crosses_transparent_surfaces_in_the_order_of_objects),
        cmocka_unit_test(crossings_of_objects_that_are_not_plain_are_located),
        cmocka_unit_test(an_opaque_object_behind_glass_blocks_light),
        cmocka_unit_test(what_throws_no_shadow_is_passed_by_light_but_not_by_sight),
        cmocka_unit_test(what_throws_no_shadow_hides_what_lies_behind_it),
        cmocka_unit_test(the_inner_side_of_a_solid_is_hidden_from_outside),
        cmocka_unit_test(a_pyramid_inside_a_convex_solid_is_clear_of_it),
        cmocka_unit_test(a_ray_that_leaves_a_sphere_hits_its_other_side_only),
        cmocka_unit_test(an_instance_of_a_sphere_matches_a_plain_one_however_far),
        cmocka_unit_test(a_stretched_and_turned_sphere_is_an_ellipsoid),
        cmocka_unit_test(a_box_around_an_instance_holds_all_of_it),
        cmocka_unit_test(an_inverse_object_turns_its_normal),
        cmocka_unit_test(the_dielectrics_of_a_point_come_with_the_inner_ones_last),
        cmocka_unit_test(memory_may_end_anywhere),
        cmocka_unit_test(a_transformation_without_an_inverse_is_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
