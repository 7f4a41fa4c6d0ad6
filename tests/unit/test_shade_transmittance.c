/* What is left of light behind transparent surfaces. */
#include "support/check.h"
#include "support/rays.h"
#include "support/shapes.h"
#include "support/squares.h"

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
    assert_int_equal(query_context_create(&s->context.context, s->world, NULL), POV_OK);
}

static void end(subject *s)
{
    query_context_destroy(s->context.context);
    shading_destroy(s->shading);
    world_destroy(s->world);
    model_free(&s->model);
}

static const segment_end at_one = { 1.0, NULL, false };

/* From z = -1 to this z. */
static bool light_to(subject *s, double z, colour *through)
{
    const pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -1.0), pov_vec3_of(0.0, 0.0, z + 1.0)), *rays = &ray;

    return transmittance_find(&s->context, &rays, NULL, 1, at_one, through) != 0;
}

/* What six surfaces leave of each component is the product of six numbers as they are, rounded to a float once. */
static void light_loses_to_rounding_once_a_path(void **state)
{
    static const colour filter[3] = { { 0.9f, 0.3f, 0.7f }, { 0.11f, 0.77f, 0.31f }, { 0.59f, 0.83f, 0.97f } };
    const colour white = { 1.0f, 1.0f, 1.0f };
    long double r = 1.0L, g = 1.0L, b = 1.0L;
    colour through;
    subject s;
    (void)state;

    begin(&s);
    for (int i = 0; i < 3; i++)
        test_add_sphere(&s.model, pov_vec3_of(0.0, 0.0, i == 2 ? 2.0 : 5.0 + 3.0 * i), 1.0,
                        test_add_material(&s.model, filter[i], 0.7f, 0.2f, false));
    build(&s);
    for (int i = 0; i < 6; i++) {
        r *= (long double)(filter[i % 3].r * 0.7f + 0.2f);
        g *= (long double)(filter[i % 3].g * 0.7f + 0.2f);
        b *= (long double)(filter[i % 3].b * 0.7f + 0.2f);
    }
    assert_true(light_to(&s, 100.0, &through));
    assert_true(through.r == (float)r && through.g == (float)g && through.b == (float)b);
    assert_true(light_to(&s, 0.5, &through));
    assert_memory_equal(&through, &white, sizeof white);
    end(&s);
}

/* Many more crossings than a query context begins with. */
static void light_may_cross_any_number_of_surfaces(void **state)
{
    const colour filter = { 0.999f, 0.9985f, 0.998f };
    long double red = 1.0L, green = 1.0L, blue = 1.0L;
    test_random r = { 7 };
    colour through;
    uint32_t glass;
    subject s;
    (void)state;

    begin(&s);
    glass = test_add_material(&s.model, filter, 1.0f, 0.0f, false);
    for (int i = 0; i < 1000; i++) {
        test_add_sphere(&s.model, pov_vec3_of(0.0, 0.0, 10.0 + test_uniform(&r, 0.0, 1000.0)), 0.5, glass);
        red *= (long double)filter.r * (long double)filter.r;
        green *= (long double)filter.g * (long double)filter.g;
        blue *= (long double)filter.b * (long double)filter.b;
    }
    build(&s);
    assert_true(light_to(&s, 2000.0, &through));
    assert_true(through.r == (float)red && through.g == (float)green && through.b == (float)blue);
    assert_true(s.context.context->hit_buffers[0].capacity >= 2000);
    assert_false(query_context_failed(s.context.context));
    end(&s);
}

static void light_through_black_glass_is_gone(void **state)
{
    colour through;
    subject s;
    (void)state;

    begin(&s);
    test_add_sphere(&s.model, pov_vec3_of(0.0, 0.0, 2.0), 1.0,
                    test_add_material(&s.model, colour_of(0, 0, 0), 1.0f, 0.0f, false));
    build(&s);
    assert_false(light_to(&s, 100.0, &through));
    assert_true(light_to(&s, 0.5, &through));
    end(&s);
}

/* ---- patterned glass ---- */

static const pigment panes[4] = { { { 1.0f, 0.5f, 0.25f }, 1.0f, 0.0f }, { { 0.0f, 0.0f, 0.0f }, 0.0f, 0.75f },
                                  { { 0.5f, 0.5f, 0.0f }, 0.5f, 0.25f }, { { 0.25f, 0.5f, 1.0f }, 0.25f, 0.5f } };

static uint32_t add_panes(model *m, squares *memory)
{
    const uint32_t number = test_add_material(m, colour_of(0, 0, 0), 0.0f, 0.0f, false);

    squares_set(memory, panes, &m->materials.items[number]);
    return number;
}

/* The pane of the point in the pattern's space; -1: it is too near to another for this test to tell, or there is no point. */
static int pane_at(double x, double z)
{
    if (!(fabs(x - nearbyint(x)) > 1e-9 && fabs(z - nearbyint(z)) > 1e-9))
        return -1;
    return (int)floor(x) & 1 ? 3 - ((int)floor(z) & 1) : (int)floor(z) & 1;
}

/* Where the ray enters or leaves the sphere about z = 5 of radius 3, from its centre. */
static pov_vec3 crossing_at(const pov_ray *ray, double sign)
{
    const pov_vec3 o = pov_sub(ray->org, pov_vec3_of(0, 0, 5)), d = ray->dir;
    const double a = pov_dot(d, d), b = pov_dot(o, d), root = sqrt(b * b - a * (pov_dot(o, o) - 9.0));

    return pov_add(o, pov_scale(d, (-b + sign * root) / a));
}

/* A sphere of coloured panes is moved to z = 5 and turned by 90 degrees after its texture was written. What light loses
 * is the product of the panes at the two points where it crosses the sphere; alone and in packets. */
static void light_through_patterned_glass_takes_the_colours_of_where_it_crosses(void **state)
{
    const pov_affine turned = { .inv = { { 0, 1, 0, 0 }, { -1, 0, 0, 0 }, { 0, 0, 1, -5 } } };
    enum { ROUNDS = 200 };
    test_random r = { 11 };
    squares memory;
    uint32_t seen = 0;
    subject s;
    (void)state;

    begin(&s);
    test_add_sphere(&s.model, pov_vec3_of(0, 0, 5), 3.0, add_panes(&s.model, &memory));
    assert_true(model_set_texture_map(&s.model, &turned));
    build(&s);
    for (int round = 0; round < ROUNDS; round++) {
        colour through[WORLD_MANY], single;
        pov_ray rays[WORLD_MANY];
        const pov_ray *of[WORLD_MANY];
        uint64_t lit;

        memset(rays, 0, sizeof rays);
        for (uint32_t i = 0; i < WORLD_MANY; i++) {
            rays[i].org = pov_vec3_of(test_uniform(&r, -2, 2), test_uniform(&r, -2, 2), -1.0);
            rays[i].dir = pov_vec3_of(test_uniform(&r, -2, 2), test_uniform(&r, -2, 2), 12.0);
            rays[i].origin_surface = POV_NO_OWNER;
            of[i] = &rays[i];
        }
        lit = transmittance_find(&s.context, of, NULL, WORLD_MANY, at_one, through);
        for (uint32_t i = 0; i < WORLD_MANY; i++) {
            const pov_vec3 in = crossing_at(of[i], -1.0), out = crossing_at(of[i], 1.0);
            const int a = pane_at(in.y, in.z), b = pane_at(out.y, out.z);
            const pigment *p = &panes[a < 0 ? 0 : a], *q = &panes[b < 0 ? 0 : b];
            const bool is_lit = transmittance_find(&s.context, &of[i], NULL, 1, at_one, &single) != 0;

            assert_int_equal(is_lit, lit >> i & 1);
            assert_memory_equal(&single, &through[i], sizeof single);
            if (a < 0 || b < 0)
                continue;
            seen |= 1u << (4 * a + b);
            assert_true(is_lit);
            assert_true(fabs(single.r - (p->color.r * p->filter + p->transmit) * (q->color.r * q->filter + q->transmit)) < 1e-6);
            assert_true(fabs(single.g - (p->color.g * p->filter + p->transmit) * (q->color.g * q->filter + q->transmit)) < 1e-6);
            assert_true(fabs(single.b - (p->color.b * p->filter + p->transmit) * (q->color.b * q->filter + q->transmit)) < 1e-6);
        }
    }
    assert_int_equal(seen, 0xffff);
    end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_loses_to_rounding_once_a_path),
        cmocka_unit_test(light_may_cross_any_number_of_surfaces),
        cmocka_unit_test(light_through_black_glass_is_gone),
        cmocka_unit_test(light_through_patterned_glass_takes_the_colours_of_where_it_crosses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
