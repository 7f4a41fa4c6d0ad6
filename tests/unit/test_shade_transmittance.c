/* What is left of light behind transparent surfaces. */
#include "support/check.h"
#include "support/shapes.h"

#include "query/context.h"
#include "shade/transmittance.h"

#include <string.h>

typedef struct subject { model model; world *world; shading *shading; shade_context context; } subject;

static void begin(subject *s)
{
    memset(s, 0, sizeof *s);
    test_model_init(&s->model, NULL);
    test_add_light(&s->model, 1.0f);
}

static void build(subject *s)
{
    const world_options options = { .accel = POV_ACCEL_TREE, .threads = 1 };

    assert_int_equal(world_create(&s->world, &s->model, &options, NULL), POV_OK);
    assert_int_equal(shading_create(&s->shading, &s->model, s->world, NULL), POV_OK);
    s->context.env = s->model.env;
    s->context.scene = s->shading;
    assert_int_equal(walker_create(&s->context.walker, s->world, NULL), POV_OK);
}

static void end(subject *s)
{
    walker_destroy(s->context.walker);
    shading_destroy(s->shading);
    world_destroy(s->world);
    model_free(&s->model);
}

/* From z = -1 to this z. */
static bool light_to(subject *s, double z, colour *through)
{
    pov_ray ray;
    const pov_ray *rays = &ray;

    memset(&ray, 0, sizeof ray);
    ray.org.z = -1.0;
    ray.dir.z = z + 1.0;
    ray.left = POV_NOBODY;
    return transmittance_find(&s->context, &rays, 1, 1.0, through) != 0;
}

/* What six surfaces leave of each component is the product of six numbers as they are, rounded to a float once. */
static void light_loses_to_rounding_once_a_path(void **state)
{
    static const colour tint[3] = { { 0.9f, 0.3f, 0.7f }, { 0.11f, 0.77f, 0.31f }, { 0.59f, 0.83f, 0.97f } };
    const colour white = { 1.0f, 1.0f, 1.0f };
    long double r = 1.0L, g = 1.0L, b = 1.0L;
    colour through;
    subject s;
    (void)state;

    begin(&s);
    for (int i = 0; i < 3; i++)
        test_add_ball(&s.model, pov_vec3_of(0.0, 0.0, i == 2 ? 2.0 : 5.0 + 3.0 * i), 1.0,
                      test_add_material(&s.model, tint[i], 0.7f, 0.2f, false));
    build(&s);
    for (int i = 0; i < 6; i++) {
        r *= (long double)(tint[i % 3].r * 0.7f + 0.2f);
        g *= (long double)(tint[i % 3].g * 0.7f + 0.2f);
        b *= (long double)(tint[i % 3].b * 0.7f + 0.2f);
    }
    assert_true(light_to(&s, 100.0, &through));
    assert_true(through.r == (float)r && through.g == (float)g && through.b == (float)b);
    assert_true(light_to(&s, 0.5, &through));
    assert_memory_equal(&through, &white, sizeof white);
    end(&s);
}

/* Many more crossings than a walker begins with. */
static void light_may_cross_any_number_of_surfaces(void **state)
{
    const colour tint = { 0.999f, 0.9985f, 0.998f };
    long double red = 1.0L, green = 1.0L, blue = 1.0L;
    test_random r = { 7 };
    colour through;
    uint32_t glass;
    subject s;
    (void)state;

    begin(&s);
    glass = test_add_material(&s.model, tint, 1.0f, 0.0f, false);
    for (int i = 0; i < 1000; i++) {
        test_add_ball(&s.model, pov_vec3_of(0.0, 0.0, 10.0 + test_uniform(&r, 0.0, 1000.0)), 0.5, glass);
        red *= (long double)tint.r * (long double)tint.r;
        green *= (long double)tint.g * (long double)tint.g;
        blue *= (long double)tint.b * (long double)tint.b;
    }
    build(&s);
    assert_true(light_to(&s, 2000.0, &through));
    assert_true(through.r == (float)red && through.g == (float)green && through.b == (float)blue);
    assert_true(s.context.walker->rooms[0].capacity >= 2000);
    assert_false(walker_failed(s.context.walker));
    end(&s);
}

static void light_through_black_glass_is_gone(void **state)
{
    colour through;
    subject s;
    (void)state;

    begin(&s);
    test_add_ball(&s.model, pov_vec3_of(0.0, 0.0, 2.0), 1.0,
                  test_add_material(&s.model, colour_of(0, 0, 0), 1.0f, 0.0f, false));
    build(&s);
    assert_false(light_to(&s, 100.0, &through));
    assert_true(light_to(&s, 0.5, &through));
    end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_loses_to_rounding_once_a_path),
        cmocka_unit_test(light_may_cross_any_number_of_surfaces),
        cmocka_unit_test(light_through_black_glass_is_gone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
