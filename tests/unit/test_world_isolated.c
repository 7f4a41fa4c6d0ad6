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

/* The box in which nothing else is; NULL: there is none. */
static const pov_box *isolated_in(const subject *s, uint32_t which)
{
    const world_isolation *a = &s->world->isolation;

    assert_non_null(a->number);
    return a->number[which] ? &a->boxes[a->number[which] - 1] : NULL;
}

static bool is_everywhere(const pov_box *b)
{
    return b && isinf(b->lo.x) && isinf(b->lo.y) && isinf(b->lo.z) && isinf(b->hi.x) && isinf(b->hi.y) && isinf(b->hi.z);
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
    assert_true(is_everywhere(isolated_in(&s, single)));
    assert_null(isolated_in(&s, opaque));
    assert_true(isolated_in(&s, left)->hi.x < 11.0 - 0x1p-22 && isolated_in(&s, left)->hi.x > 11.0 - 0x1p-10 && isinf(isolated_in(&s, left)->lo.x));
    assert_true(isolated_in(&s, right)->lo.x > 11.0 + 0x1p-22 && isolated_in(&s, right)->lo.x < 11.0 + 0x1p-10);
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
    assert_null(isolated_in(&s, outer));
    assert_null(isolated_in(&s, inner));
    end(&s);
}

/* Nobody knows where it is. */
static void no_object_is_isolated_beside_an_infinite_one(void **state)
{
    const test_ground ground = { -100.0 };
    subject s;

    (void)state;
    begin(&s);
    add_sphere(&s, 0.0, 1.0, true);
    test_add(&s.model, &test_ground_class, &ground, NULL, 0, 0);
    build(&s);
    assert_null(isolated_in(&s, 0));
    end(&s);
}

/* y < height, and it says so. */
static bool ground_half_space(const void *self, pov_half_space *out)
{
    out->normal = pov_vec3_of(0.0, 1.0, 0.0);
    out->distance = ((const test_ground *)self)->height;
    return true;
}

static shape_class floor_class(void)
{
    shape_class c = test_ground_class;

    c.keyword = "floor";
    c.half_space = ground_half_space;
    return c;
}

static void a_plane_takes_what_it_cuts_off(void **state)
{
    static const struct { double height, above, below; bool everywhere; } rows[] = {
        { -100.0, 0, 0, true }, { -1.0, -1.0, HUGE_VAL, false }, { 0.9, -HUGE_VAL, 0.9, false },
        { 0.1, -HUGE_VAL, 0.1, false }, { 2.0, 0, 0, true },
    };
    const shape_class shape = floor_class();

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const test_ground ground = { rows[i].height };
        const pov_box *b;
        subject s;

        begin(&s);
        add_sphere(&s, 0.0, 1.0, true);
        test_add(&s.model, &shape, &ground, NULL, 0, 0);
        build(&s);
        b = isolated_in(&s, 0);
        assert_non_null(b);
        assert_int_equal(is_everywhere(b), rows[i].everywhere);
        if (!rows[i].everywhere) {
            assert_true(isinf(rows[i].above) ? isinf(b->lo.y) : b->lo.y > rows[i].above && b->lo.y < rows[i].above + 0x1p-10);
            assert_true(isinf(rows[i].below) ? isinf(b->hi.y) : b->hi.y < rows[i].below && b->hi.y > rows[i].below - 0x1p-10);
        }
        end(&s);
    }
}

static void opaque_scenes_are_not_looked_at(void **state)
{
    subject s;

    (void)state;
    begin(&s);
    add_sphere(&s, 0.0, 1.0, false);
    build(&s);
    assert_null(s.world->isolation.number);
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

/* What the world says without knowing what is alone. */
static bool ask_all_others(subject *s, const pov_ray *ray, hit *out)
{
    uint32_t *const number = s->world->isolation.number;
    bool found;

    s->world->isolation.number = NULL;
    found = test_nearest(s->world, s->context, ray, HUGE_VAL, out);
    s->world->isolation.number = number;
    return found;
}

/* Rays within the first: whether it is alone must not matter to what is said. Returns how many shapes were asked. */
static uint64_t compare_rays_within(subject *s, uint32_t seed)
{
    pov_ray rays[WORLD_MANY];
    const pov_ray *all[WORLD_MANY];
    hit many[WORLD_MANY];
    uint32_t hit_itself = 0, i;
    uint64_t candidates, asked;

    go_in(s, seed, rays);
    for (i = 0; i < WORLD_MANY; i++)
        all[i] = &rays[i];
    count_asked(s);
    candidates = query_nearest(s->world, s->context, all, WORLD_MANY, HUGE_VAL, many);
    asked = count_asked(s);
    for (i = 0; i < WORLD_MANY; i++) {
        hit single;

        assert_int_equal(candidates >> i & 1, ask_all_others(s, all[i], &single));
        if (!(candidates >> i & 1))
            continue;
        assert_int_equal(many[i].object, single.object);
        assert_int_equal(many[i].coincident, single.coincident);
        assert_true(many[i].crossing.t == single.crossing.t && many[i].crossing.t_lo == single.crossing.t_lo);
        hit_itself += rays[i].origin_surface == 0 && many[i].object == 0;
    }
    assert_true(hit_itself > 0);
    return asked;
}

static void add_others(subject *s, int within)
{
    add_sphere(s, 0.0, 1.0, true);
    for (int k = 0; k < within; k++)
        add_sphere(s, 0.25 * (k + 1), 0.2, k % 2 == 0);
    for (int k = 0; k < 20; k++)
        add_sphere(s, 3.0 + k, 0.4, k % 2 == 0);
}

static void rays_within_an_isolated_shape(void **state)
{
    subject s;

    (void)state;
    begin(&s);
    add_others(&s, 0);
    build(&s);
    assert_int_equal(compare_rays_within(&s, 7), WORLD_MANY); /* each of itself */
    end(&s);
}

static void rays_within_a_shape_that_holds_others(void **state)
{
    subject s;

    (void)state;
    begin(&s);
    add_others(&s, 3);
    build(&s);
    assert_true(compare_rays_within(&s, 10) > WORLD_MANY);
    end(&s);
}

/* On the floor, into it, and through a smaller one: those that stay away from these meet nothing else. */
static void rays_within_a_shape_that_others_reach_into(void **state)
{
    static const double heights[] = { -1.0, -0.95, -0.5, 0.3 };
    const shape_class shape = floor_class();

    (void)state;
    for (uint32_t seed = 0; seed < 40; seed++)
        for (int i = 0; i < 5; i++) {
            const test_ground ground = { heights[i % 4] };
            subject s;
            uint64_t asked;

            begin(&s);
            add_others(&s, 0);
            if (i < 4)
                test_add(&s.model, &shape, &ground, NULL, 0, 0);
            else
                add_sphere(&s, 1.0, 0.5, true);
            build(&s);
            assert_non_null(isolated_in(&s, 0));
            assert_false(is_everywhere(isolated_in(&s, 0)));
            asked = compare_rays_within(&s, seed);
            assert_true(asked >= WORLD_MANY && asked < (i == 0 ? WORLD_MANY + 8 : 3 * WORLD_MANY));
            end(&s);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(isolated_objects_are_found),
        cmocka_unit_test(what_has_another_within_is_not_isolated),
        cmocka_unit_test(no_object_is_isolated_beside_an_infinite_one),
        cmocka_unit_test(a_plane_takes_what_it_cuts_off),
        cmocka_unit_test(opaque_scenes_are_not_looked_at),
        cmocka_unit_test(rays_within_an_isolated_shape),
        cmocka_unit_test(rays_within_a_shape_that_holds_others),
        cmocka_unit_test(rays_within_a_shape_that_others_reach_into),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
