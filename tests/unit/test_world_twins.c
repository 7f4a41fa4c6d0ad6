/* Opaque leaves in one place are asked once: the first of the text counts. */
#include "support/check.h"
#include "support/shapes.h"

#include "world/internal.h"

#include <string.h>

typedef struct subject { model model; world *world; query_context *context; } subject;

static void begin(subject *s)
{
    memset(s, 0, sizeof *s);
    test_model_init(&s->model, NULL);
    test_add_light(&s->model, 1.0f);
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

/* How many surfaces a ray along x finds in the place of the first that it meets, 0 for a single one; which that is. */
static uint32_t look(subject *s, uint32_t *object)
{
    const pov_ray ray = { .org = { -5.0, 0.0, 0.0 }, .dir = { 1.0, 0.1, 0.01 }, .origin_surface = POV_NO_OWNER };
    hit h;

    assert_true(test_nearest(s->world, s->context, &ray, HUGE_VAL, &h));
    *object = h.object;
    return h.coincident;
}

static const pov_vec3 middle = { 0.0, 0.0, 0.0 };

static void the_later_one_is_left_out(void **state)
{
    uint32_t first, other, seen;
    subject s;

    (void)state;
    begin(&s);
    other = test_add_material(&s.model, colour_of(0.5f, 0.5f, 0.5f), 0.0f, 0.0f, false);
    first = test_add_sphere(&s.model, middle, 1.0, 0);
    test_add_sphere(&s.model, middle, 1.0, other);
    test_add_sphere(&s.model, middle, 1.0, 0);
    build(&s);
    assert_int_equal(look(&s, &seen), 0);
    assert_int_equal(seen, first);
    end(&s);
}

static void what_is_clear_counts_each_time(void **state)
{
    uint32_t glass, seen;
    subject s;

    (void)state;
    begin(&s);
    glass = test_add_material(&s.model, colour_of(0.5f, 0.5f, 0.5f), 0.5f, 0.0f, true);
    test_add_sphere(&s.model, middle, 1.0, glass);
    test_add_sphere(&s.model, middle, 1.0, glass);
    build(&s);
    assert_int_equal(look(&s, &seen), 2);
    end(&s);
}

/* One that the camera does not see casts the shadow of both. */
static void other_flags_make_another(void **state)
{
    const test_sphere_shape sphere = { .centre = middle, .radius = 1.0 };
    uint32_t seen;
    subject s;

    (void)state;
    begin(&s);
    test_add_sphere(&s.model, middle, 1.0, 0);
    test_add(&s.model, &test_sphere_class, &sphere, NULL, 0, LEAF_NO_IMAGE);
    build(&s);
    assert_int_equal(look(&s, &seen), 2);
    end(&s);
}

/* Of a class whose texts have several forms, which it puts in order: here, without the sign of a zero. */
static void without_sign(void *parsed)
{
    test_sphere_shape *s = parsed;

    s->centre.x += 0.0;
}

static void texts_of_one_solid_are_alike(void **state)
{
    const test_sphere_shape one = { .centre = middle, .radius = 1.0 }, other = { .centre = { -0.0, 0.0, 0.0 }, .radius = 1.0 };
    shape_class shape = test_sphere_class;
    uint32_t seen;

    (void)state;
    for (int i = 0; i < 2; i++) {
        subject s;

        begin(&s);
        shape.reorder = i ? without_sign : NULL;
        test_add(&s.model, &shape, &one, NULL, 0, 0);
        test_add(&s.model, &shape, &other, NULL, 0, 0);
        build(&s);
        assert_int_equal(look(&s, &seen), i ? 0 : 2);
        end(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_later_one_is_left_out),
        cmocka_unit_test(what_is_clear_counts_each_time),
        cmocka_unit_test(other_flags_make_another),
        cmocka_unit_test(texts_of_one_solid_are_alike),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
