/* How a world is compiled: the tree for any number of threads, where things lie, and what the plan says of it. */
#include "support/check.h"
#include "support/shapes.h"

#include "api/explain.h"
#include "world/internal.h"

#include <stdlib.h>
#include <string.h>

static world *make(const model *m, pov_accel accel, int threads)
{
    world_options options = { .accel = accel, .threads = threads };
    pov_error err;
    world *w;

    assert_int_equal(world_create(&w, m, &options, &err), POV_OK);
    return w;
}

static pov_vec3 somewhere(test_random *r, double size)
{
    return pov_vec3_of(test_uniform(r, -size, size), test_uniform(r, -size, size), test_uniform(r, -size, size));
}

/* ---- trees ---- */

/* Every leaf's objects, in the order of memory. */
static void same_leaves(const bvh *a, const bvh *b)
{
    size_t at = 0;

    assert_int_equal(a->leaf_bytes, b->leaf_bytes);
    while (at < a->leaf_bytes) {
        const leaf_batch *x = (const leaf_batch *)(const void *)(a->leaves + at),
            *y = (const leaf_batch *)(const void *)(b->leaves + at);
        assert_int_equal(x->count, y->count);
        assert_memory_equal(x->object, y->object, x->count * sizeof x->object[0]);
        at += leaf_batch_bytes(x->shape, x->count, x->flags);
    }
}

static void same_frames(const bvh *a, const bvh *b)
{
    size_t i;

    assert_int_equal(a->frame_count, b->frame_count);
    for (i = 0; i < a->frame_count; i++) {
        assert_memory_equal(&a->frames[i].centre, &b->frames[i].centre, sizeof a->frames[i].centre);
        assert_memory_equal(&a->frames[i].scale, &b->frames[i].scale, sizeof a->frames[i].scale);
        assert_int_equal(a->frames[i].root, b->frames[i].root);
    }
}

static void any_number_of_threads_builds_the_same_tree(void **state)
{
    test_random r = { 1 };
    world *one, *other;
    model m;
    int i, threads;

    (void)state;
    test_model_init(&m, NULL);
    for (i = 0; i < 60000; i++) {
        double size = i % 10 == 0 ? 1e-4 : 1.0;   /* a dense heart in a wide cloud */
        test_add_sphere(&m, somewhere(&r, size), 0.01 * size, 0);
    }
    one = make(&m, POV_ACCEL_TREE, 1);
    assert_true(one->tree.frame_count > 1);
    for (threads = 2; threads < 8; threads += 3) {
        other = make(&m, POV_ACCEL_TREE, threads);
        assert_int_equal(one->tree.node_count, other->tree.node_count);
        assert_int_equal(one->tree.depth, other->tree.depth);
        assert_memory_equal(one->tree.nodes, other->tree.nodes, one->tree.node_count * sizeof *one->tree.nodes);
        same_frames(&one->tree, &other->tree);
        same_leaves(&one->tree, &other->tree);
        world_destroy(other);
    }
    world_destroy(one);
    model_free(&m);
}

/* In the frame of `frame`, is the true box within the floats around it? */
static bool is_around(const bvh_frame *f, const bvh_node *n, int i, const pov_box *b)
{
    return n->bounds[0][i] <= (b->lo.x - f->centre.x) * f->scale &&
           n->bounds[1][i] >= (b->hi.x - f->centre.x) * f->scale &&
           n->bounds[2][i] <= (b->lo.y - f->centre.y) * f->scale &&
           n->bounds[3][i] >= (b->hi.y - f->centre.y) * f->scale &&
           n->bounds[4][i] <= (b->lo.z - f->centre.z) * f->scale &&
           n->bounds[5][i] >= (b->hi.z - f->centre.z) * f->scale;
}

typedef struct census { const world *world; int seen[4096]; pov_box boxes[4096]; } census;

/* Walk all below `at`; every object must lie within each box on the way to it. `path` is the place in the node above.
 */
static void visit(census *c, uint32_t at, uint32_t frame, const bvh_node *above, int place,
                  const bvh_frame *above_frame, int depth)
{
    const bvh *t = &c->world->tree;
    const leaf_batch *r;
    uint32_t i;
    int k;

    assert_true(depth <= BVH_DEPTH);
    switch (at & BVH_KIND) {
    case BVH_FRAME:
        visit(c, t->frames[at & ~BVH_KIND].root, at & ~BVH_KIND, above, place, above_frame, depth);
        return;
    case BVH_NODE:
        for (k = 0; k < BVH_WIDTH; k++)
            if (t->nodes[at].bounds[0][k] <= t->nodes[at].bounds[1][k])
                visit(c, t->nodes[at].child[k], frame, &t->nodes[at], k, &t->frames[frame], depth + 1);
        return;
    default:
        for (r = (const leaf_batch *)(const void *)(t->leaves + (size_t)(at & ~BVH_KIND) * BVH_UNIT); r;
             r = leaf_batch_next(r))
            for (i = 0; i < r->count; i++) {
                c->seen[r->object[i]]++;
                assert_true(is_around(above_frame, above, place, &c->boxes[r->object[i]]));
                assert_ptr_equal(world_shape(c->world, r->object[i]).instance, leaf_batch_instance(r, i));
            }
    }
}

static void every_object_is_in_one_leaf_within_its_boxes(void **state)
{
    static census c;
    test_random r = { 2 };
    model m;
    world *w;
    int i;

    (void)state;
    test_model_init(&m, NULL);
    for (i = 0; i < 4000; i++) {
        double size = i % 3 == 0 ? 1e-7 : i % 3 == 1 ? 1.0 : 1e6;
        test_sphere_shape sphere = { somewhere(&r, size), 0.01 * size };
        test_add(&m, i % 5 ? &test_sphere_class : &test_plain_sphere_class, &sphere, NULL, 0, 0);
        assert_true(test_sphere_class.bounds(&sphere, &c.boxes[i]));
    }
    w = make(&m, POV_ACCEL_TREE, 1);
    c.world = w;
    visit(&c, w->tree.frames[0].root, 0, NULL, 0, NULL, 0);
    for (i = 0; i < 4000; i++)
        assert_int_equal(c.seen[i], 1);
    world_destroy(w);
    model_free(&m);
}

/* Each would best stand beside all that it holds, in a tree as deep as they are many. */
static void spheres_in_spheres_are_no_chain(void **state)
{
    static census c;
    double radius = 1.0;
    model m;
    world *w;
    int i;

    (void)state;
    test_model_init(&m, NULL);
    memset(&c, 0, sizeof c);
    for (i = 0; i < 1000; i++, radius *= 1.004) {
        test_sphere_shape sphere = { { 0.004 * radius, 0.0, 0.0 }, radius };
        test_add(&m, &test_plain_sphere_class, &sphere, NULL, 0, 0);
        assert_true(test_sphere_class.bounds(&sphere, &c.boxes[i]));
    }
    w = make(&m, POV_ACCEL_TREE, 1);
    c.world = w;
    visit(&c, w->tree.frames[0].root, 0, NULL, 0, NULL, 0);
    for (i = 0; i < 1000; i++)
        assert_int_equal(c.seen[i], 1);
    world_destroy(w);
    model_free(&m);
}

static void instances_are_aligned_and_neighbours_in_a_leaf_are_neighbours_in_memory(void **state)
{
    test_random r = { 3 };
    model m;
    world *w;
    int i;

    (void)state;
    test_model_init(&m, NULL);
    for (i = 0; i < 500; i++)
        test_add_sphere(&m, somewhere(&r, 1.0), 0.05, 0);
    w = make(&m, POV_ACCEL_TREE, 1);
    for (i = 0; i < 500; i++)
        assert_int_equal((uintptr_t)world_shape(w, (uint32_t)i).instance % 32, 0);
    assert_int_equal(w->group_count, 1);
    assert_int_equal(w->groups[0].count, 500);
    world_destroy(w);
    model_free(&m);
}

static void prepare_twice_as_large(void *self, const void *text)
{
    test_sphere_shape *sphere = self;

    memcpy(sphere, text, sizeof *sphere);
    sphere->radius *= 2.0;
}

static void instances_are_prepared_alone_absorbed_and_transformed(void **state)
{
    shape_class small = test_sphere_class;
    test_sphere_shape sphere = { { 0.0, 0.0, 0.0 }, 1.0 };
    const test_sphere_shape *made[3];
    model m;
    world *w;
    int i;

    (void)state;
    small.parsed_size = sizeof sphere;
    small.prepare = prepare_twice_as_large;
    test_model_init(&m, NULL);
    test_add(&m, &small, &sphere, NULL, 0, 0);
    test_add(&m, &small, &sphere, test_transform(&m, NULL, TRANSFORM_SCALE, 3.0, 3.0, 3.0), 0, 0);
    test_add(&m, &small, &sphere, test_transform(&m, NULL, TRANSFORM_SCALE, 1.0, 2.0, 3.0), 0, 0);
    w = make(&m, POV_ACCEL_TREE, 1);
    for (i = 0; i < 3; i++)
        made[i] = world_shape(w, (uint32_t)i).instance;
    assert_true(made[0]->radius == 2.0 && made[1]->radius == 6.0 && made[2]->radius == 2.0);
    assert_non_null(world_shape(w, 2).xform);
    world_destroy(w);
    model_free(&m);
}

/* Spheres of the one class share leaves, those of the other stand alone. */
static void large_shapes_that_absorb_are_found_among_very_many(void **state)
{
    typedef struct large_sphere { test_sphere_shape sphere; unsigned char more[COMPILE_LARGE]; } large_sphere;
    large_sphere shape = { { { 0.0, 0.0, 0.0 }, 1e-3 }, { 0 } };
    shape_class classes[2] = { test_sphere_class, test_sphere_class };
    pov_vec3 *at = malloc((COMPILE_MANY + 1) * sizeof *at);
    uint32_t i, stay[2] = { 0, 0 };
    test_random r = { 5 };
    model m;
    world *w;

    (void)state;
    assert_non_null(at);
    test_model_init(&m, NULL);
    classes[0].instance_size = classes[1].instance_size = sizeof shape;
    classes[1].block_size = 0;
    for (i = 0; i <= COMPILE_MANY; i++) {
        at[i] = pov_add(somewhere(&r, 1.0), pov_vec3_of(i % 2 ? 0.0 : 4.0, 0.0, 0.0));
        test_add(&m, &classes[i % 2], &shape,
                 test_transform(&m, NULL, TRANSFORM_TRANSLATE, at[i].x, at[i].y, at[i].z), 0, 0);
    }
    w = make(&m, POV_ACCEL_TREE, 2);
    for (i = 0; i <= COMPILE_MANY; i++) {
        const shape_ref place = world_shape(w, i);

        assert_memory_equal(&((const large_sphere *)place.instance)->sphere.centre, &at[i], sizeof at[i]);
        assert_null(place.xform);
        stay[i % 2] += w->objects_info[i].slot >= LEAF_SINGLE;
    }
    assert_true(stay[0] < COMPILE_MANY / 4 && stay[1] == COMPILE_MANY / 2);
    world_destroy(w);
    model_free(&m);
    free(at);
}

/* Every third sphere is stretched, some grounds are turned, and one in ten transformations is a matrix. */
static void scatter(model *m, int count)
{
    const double matrix[12] = { 1.0, 0.25, 0.0, 0.0, 1.0, 0.5, 0.125, 0.0, 1.0, 3.0, 4.0, 5.0 };
    test_ground ground = { -100.0 };
    test_random r = { 4 };
    int i;

    for (i = 0; i < count; i++) {
        test_sphere_shape sphere = { somewhere(&r, 10.0), 0.01 };
        const transform *map = NULL;
        pov_vec3 v = somewhere(&r, 1.0);
        if (i % 3 == 0)
            map = test_transform(m, test_transform(m, map, TRANSFORM_SCALE, 1.0, 2.0, 3.0), TRANSFORM_ROTATE, v.x, v.y, v.z);
        if (i % 10 == 0)
            map = transform_append(&m->maps, map, TRANSFORM_MATRIX, matrix);
        if (i % 2000 == 0)
            test_add(m, &test_ground_class, &ground, map, 0, 0);
        else
            test_add(m, i % 2 ? &test_sphere_class : &test_plain_sphere_class, &sphere, map, 0, 0);
    }
}

/* For any number of threads, with a tree and with a list. */
static void the_last_world_of_a_model_is_like_any_other_and_takes_its_transformations(void **state)
{
    int i, k, count;

    (void)state;
    for (i = 0; i < 6; i++) {
        world_options options = { .accel = i % 2 ? POV_ACCEL_TREE : POV_ACCEL_NONE, .threads = 1 + i / 2 };
        world *any, *last;
        pov_error err;
        model m;

        test_model_init(&m, NULL);
        count = i % 2 ? 20000 : 3000;
        scatter(&m, count);
        assert_int_equal(world_create(&any, &m, &options, &err), POV_OK);
        assert_non_null(m.leaves.items[0].map);
        options.last = &m;
        assert_int_equal(world_create(&last, &m, &options, &err), POV_OK);
        if (i % 2)
            same_leaves(&any->tree, &last->tree);
        for (k = 0; k < count; k++) {
            shape_ref a = world_shape(any, (uint32_t)k), b = world_shape(last, (uint32_t)k);
            assert_null(m.leaves.items[k].map);
            assert_int_equal(a.xform != NULL, b.xform != NULL);
            if (a.xform)
                assert_memory_equal(a.xform, b.xform, sizeof *a.xform);
        }
        world_destroy(any);
        world_destroy(last);
        model_free(&m);
    }
}

static void bounds_are_those_of_the_finite_objects(void **state)
{
    test_ground ground = { 100.0 };
    pov_box box;
    model m;
    world *w;

    (void)state;
    test_model_init(&m, NULL);
    test_add(&m, &test_ground_class, &ground, NULL, 0, 0);
    w = make(&m, POV_ACCEL_TREE, 1);
    assert_false(world_bounds(w, &box));
    world_destroy(w);
    test_add_sphere(&m, pov_vec3_of(1.0, 2.0, 3.0), 1.0, 0);
    test_add_sphere(&m, pov_vec3_of(-1.0, 2.0, 3.0), 0.5, 0);
    w = make(&m, POV_ACCEL_TREE, 1);
    assert_true(world_bounds(w, &box));
    assert_true(box.lo.x <= -1.5 && box.lo.x > -1.5000001 && box.hi.x >= 2.0 && box.hi.x < 2.0000001);
    world_destroy(w);
    model_free(&m);
}

/* ---- plans ---- */

/* reason: NULL: any. */
static void row_is(const world *w, const char *subject, bool used, const char *state, const char *reason)
{
    const explain_row *r = NULL;
    explanation e;
    pov_error err;

    explain_init(&e, w->env);
    assert_int_equal(explain_world(&e, w->model, w, &err), POV_OK);
    for (size_t i = 0; i < e.rows.count; i++)
        if (strcmp(e.rows.items[i].subject, subject) == 0)
            r = &e.rows.items[i];
    assert_non_null(r);
    assert_int_equal(r->used, used);
    assert_string_equal(r->state, state);
    if (reason)
        assert_string_equal(r->reason, reason);
    explain_free(&e);
}

static void a_plain_scene_leaves_out_what_it_does_not_need(void **state)
{
    model m;
    world *w;
    const plan *p;

    (void)state;
    test_model_init(&m, NULL);
    test_add_sphere(&m, pov_vec3_of(0.0, 0.0, 0.0), 1.0, 0);
    w = make(&m, POV_ACCEL_NONE, 1);
    p = world_plan(w);
    assert_false(p->lighting || p->shadows || p->coloured_shadows || p->highlights || p->metallic || p->reflection ||
                 p->transmission || p->refraction || p->dielectrics_at_start);
    row_is(w, "shadow rays", false, "left out", "no light emits");
    row_is(w, "reflection", false, "left out", "no surface has reflection");
    row_is(w, "transformations", false, "left out", "no object has one");
    row_is(w, "tree", false, "left out", "asked for none: every ray tests every object");
    row_is(w, "dialect", true, "povray", "a test");
    world_destroy(w);
    model_free(&m);
}

static void a_rich_scene_needs_all_of_it(void **state)
{
    test_random r = { 4 };
    test_sphere_shape sphere = { { 0.0, 0.0, 0.0 }, 1.0 };
    uint32_t glass;
    model m;
    world *w;
    const plan *p;
    int i;

    (void)state;
    test_model_init(&m, NULL);
    glass = test_add_material(&m, colour_of(1, 1, 1), 0.9f, 0.0f, true);
    m.materials.items[glass].finish.phong = 0.5f;
    m.materials.items[glass].finish.metallic = 1.0f;
    m.materials.items[glass].finish.reflection.min = m.materials.items[glass].finish.reflection.max = colour_of(0.1f, 0.1f, 0.1f);
    test_add_light(&m, 1.0f);
    for (i = 0; i < 30; i++)
        test_add_sphere(&m, somewhere(&r, 3.0), 0.3, 0);
    test_add(&m, &test_sphere_class, &sphere, test_transform(&m, NULL, TRANSFORM_TRANSLATE, 1.0, 2.0, 3.0), glass, 0);
    test_add(&m, &test_sphere_class, &sphere, test_transform(&m, NULL, TRANSFORM_SCALE, 1.0, 2.0, 3.0), 0, 0);
    w = make(&m, POV_ACCEL_TREE, 1);
    p = world_plan(w);
    assert_true(p->lighting && p->shadows && p->coloured_shadows && p->highlights && p->metallic && p->reflection &&
                p->transmission && p->refraction && p->dielectrics_at_start);
    row_is(w, "shadow rays", true, "sent", "objects that throw a shadow: 32");
    row_is(w, "refraction", true, "computed", "objects that refract light: 1");
    row_is(w, "transformations", true, "some absorbed",
           "applied to the shapes themselves: 1; rays transformed to object space: 1");
    row_is(w, "blocks", true, "packed", "shapes filtered up to eight at once: 31 of 32");
    row_is(w, "tree", true, "built", NULL);
    world_destroy(w);
    w = make(&m, POV_ACCEL_NONE, 1);
    row_is(w, "tree", false, "left out", "asked for none: every ray tests every object");
    world_destroy(w);
    model_free(&m);
}

static void a_black_light_and_a_scene_without_shadows_send_no_shadow_rays(void **state)
{
    test_sphere_shape sphere = { { 0.0, 0.0, 0.0 }, 1.0 };
    model m;
    world *w;

    (void)state;
    test_model_init(&m, NULL);
    test_add(&m, &test_sphere_class, &sphere, NULL, 0, LEAF_NO_SHADOW);
    test_add_light(&m, 0.0f);
    w = make(&m, POV_ACCEL_TREE, 1);
    assert_false(world_plan(w)->lighting);
    world_destroy(w);
    test_add_light(&m, 0.5f);
    w = make(&m, POV_ACCEL_TREE, 1);
    assert_true(world_plan(w)->lighting);
    row_is(w, "shadow rays", false, "left out", "every object is no_shadow");
    world_destroy(w);
    model_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_number_of_threads_builds_the_same_tree),
        cmocka_unit_test(every_object_is_in_one_leaf_within_its_boxes),
        cmocka_unit_test(spheres_in_spheres_are_no_chain),
        cmocka_unit_test(instances_are_aligned_and_neighbours_in_a_leaf_are_neighbours_in_memory),
        cmocka_unit_test(instances_are_prepared_alone_absorbed_and_transformed),
        cmocka_unit_test(large_shapes_that_absorb_are_found_among_very_many),
        cmocka_unit_test(the_last_world_of_a_model_is_like_any_other_and_takes_its_transformations),
        cmocka_unit_test(bounds_are_those_of_the_finite_objects),
        cmocka_unit_test(a_plain_scene_leaves_out_what_it_does_not_need),
        cmocka_unit_test(a_rich_scene_needs_all_of_it),
        cmocka_unit_test(a_black_light_and_a_scene_without_shadows_send_no_shadow_rays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
