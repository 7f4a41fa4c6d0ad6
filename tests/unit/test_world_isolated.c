/* Shapes that stand alone are known, and rays within them are answered as if all others had been asked. */
#include "support/check.h"
#include "support/shapes.h"

#include "world/internal.h"

#include <string.h>

typedef struct subject { model model; world *world; query_context *context; uint32_t glass; } subject;

static void begin(subject *s)
{
    memset(s, 0, sizeof *s);
    test_model_init(&s->model, NULL);
    test_add_light(&s->model, 1.0f);
    s->glass = test_add_material(&s->model, colour_of(0.9f, 0.5f, 0.2f), 0.8f, 0.1f, true);
}

static void build(subject *s)
{
    const world_options options = { .accel = POV_ACCEL_TREE, .threads = 1 };
    pov_error err;

    assert_int_equal(world_create(&s->world, &s->model, &options, &err), POV_OK);
    assert_int_equal(query_context_create(&s->context, s->world, &err), POV_OK);
}

static void end(subject *s)
{
    query_context_destroy(s->context);
    world_destroy(s->world);
    model_free(&s->model);
}

static uint32_t add_sphere(subject *s, double x, double radius, bool transparent)
{
    return test_add_sphere(&s->model, pov_vec3_of(x, 0.0, 0.0), radius, transparent ? s->glass : 0);
}

static void isolated_objects_are_found(void **state)
{
    uint32_t single, opaque, left, right;
    subject s;

    (void)state;
    begin(&s);
    single = add_sphere(&s, 0.0, 1.0, true);
    opaque = add_sphere(&s, 5.0, 1.0, false);
    left = add_sphere(&s, 10.0, 1.0, true);
    right = add_sphere(&s, 12.0 + 0x1p-30, 1.0, true); /* a gap, but too small a one */
    build(&s);
    assert_non_null(s.world->isolated);
    assert_true(s.world->isolated[single]);
    assert_false(s.world->isolated[opaque] || s.world->isolated[left] || s.world->isolated[right]);
    end(&s);
}

static void what_has_another_within_is_not_isolated(void **state)
{
    uint32_t outer, inner;
    subject s;

    (void)state;
    begin(&s);
    outer = add_sphere(&s, 0.0, 2.0, true);
    inner = add_sphere(&s, 0.0, 1.0, true);
    build(&s);
    assert_false(s.world->isolated[outer] || s.world->isolated[inner]);
    end(&s);
}

static void no_object_is_isolated_beside_an_infinite_one(void **state)
{
    const test_ground ground = { -100.0 };
    subject s;

    (void)state;
    begin(&s);
    add_sphere(&s, 0.0, 1.0, true);
    test_add(&s.model, &test_ground_class, &ground, NULL, 0, 0);
    build(&s);
    assert_null(s.world->isolated);
    end(&s);
}

static void opaque_scenes_are_not_looked_at(void **state)
{
    subject s;

    (void)state;
    begin(&s);
    add_sphere(&s, 0.0, 1.0, false);
    build(&s);
    assert_null(s.world->isolated);
    end(&s);
}

/* Rays from points of the spheres into them, all ways. */
static void go_in(subject *s, uint32_t seed, pov_ray *rays)
{
    test_random random = { seed };
    uint32_t n = 0;

    while (n < WORLD_MANY) {
        const pov_vec3 dir = test_direction(&random);
        pov_ray ray = { .dir = dir, .origin_surface = POV_NO_OWNER };
        hit h;

        ray.org = pov_vec3_of(-20.0 * dir.x, -20.0 * dir.y, -20.0 * dir.z);
        if (!test_nearest(s->world, s->context, &ray, HUGE_VAL, &h))
            continue;
        world_surface(s->world, &ray, &h);
        rays[n] = ray;
        rays[n].org = h.point;
        rays[n].org_lo = h.point_lo;
        rays[n].dir = pov_sub(dir, pov_scale(h.normal, test_uniform(&random, 0.0, 2.0)));
        test_leave(&rays[n], &h);
        n += rays[n].origin_mark.flags & POV_MARK_INWARD ? 1 : 0;
    }
}

static uint64_t count_asked(subject *s)
{
    class_counts counts = { { { 0, 0 } } };
    uint64_t asked = 0;
    int i;

    query_context_take_classes(s->context, &counts);
    for (i = 0; i < WORLD_CLASSES; i++)
        asked += counts.of[i].asked;
    return asked;
}

/* others: how many more there are, around the first; whether it is alone must not matter to what is said. */
static void rays_within(int others, bool isolated)
{
    pov_ray rays[WORLD_MANY];
    const pov_ray *all[WORLD_MANY];
    hit many[WORLD_MANY];
    uint32_t hit_itself = 0, i;
    uint64_t candidates, asked;
    subject s;
    int k;

    begin(&s);
    add_sphere(&s, 0.0, 1.0, true);
    for (k = 0; k < others; k++)
        add_sphere(&s, 0.25 * (k + 1), 0.2, k % 2 == 0);
    for (k = 0; k < 20; k++)
        add_sphere(&s, 3.0 + k, 0.4, k % 2 == 0);
    build(&s);
    assert_int_equal(s.world->isolated[0], isolated);
    go_in(&s, 7u + (uint32_t)others, rays);
    for (i = 0; i < WORLD_MANY; i++)
        all[i] = &rays[i];
    count_asked(&s);
    candidates = query_nearest(s.world, s.context, all, WORLD_MANY, HUGE_VAL, many);
    asked = count_asked(&s);
    assert_true(isolated ? asked == WORLD_MANY : asked > WORLD_MANY); /* each of itself; and more */
    for (i = 0; i < WORLD_MANY; i++) {
        hit single;

        assert_int_equal(candidates >> i & 1, test_nearest(s.world, s.context, all[i], HUGE_VAL, &single));
        if (!(candidates >> i & 1))
            continue;
        assert_int_equal(many[i].object, single.object);
        assert_int_equal(many[i].coincident, single.coincident);
        assert_true(many[i].crossing.t == single.crossing.t && many[i].crossing.t_lo == single.crossing.t_lo);
        hit_itself += rays[i].origin_surface == 0 && many[i].object == 0;
    }
    assert_true(hit_itself > WORLD_MANY / 4);
    end(&s);
}

static void rays_within_an_isolated_shape(void **state)
{
    (void)state;
    rays_within(0, true);
}

static void rays_within_a_shape_that_holds_others(void **state)
{
    (void)state;
    rays_within(3, false);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(isolated_objects_are_found),
        cmocka_unit_test(what_has_another_within_is_not_isolated),
        cmocka_unit_test(no_object_is_isolated_beside_an_infinite_one),
        cmocka_unit_test(opaque_scenes_are_not_looked_at),
        cmocka_unit_test(rays_within_an_isolated_shape),
        cmocka_unit_test(rays_within_a_shape_that_holds_others),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
