/* The lighting formula, term by term. */
#include "shade/highlight.h"
#include "support/near.h"
#include "support/tiny.h"

static const pov_vec3 origin = { 0.0, 0.0, 0.0 };

/* ---- what a surface gives of itself ---- */

static void ambient_is_the_product_of_four_factors(void **state)
{
    material m = tiny_emitted(0.5f, 1.0f, 0.25f);
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    m.finish.ambient = colour_of(0.1f, 0.2f, 0.4f);
    m.filter = 0.25f;
    m.transmit = 0.25f;
    s.model.ambient_light = colour_of(1.0f, 2.0f, 4.0f);
    tiny_plane(&s, 0, 0, 1, 5, m);
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0, 0, 1), 0.5 * 0.1 * 0.5, 0.5 * 0.2 * 2.0, 0.5 * 0.4 * 4.0 * 0.25, 1e-6);
    tiny_end(&s);
}

static void opacity_may_weigh_the_filter_by_its_colour(void **state)
{
    material m = tiny_emitted(0.5f, 0.25f, 0.0f);
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    m.filter = 0.6f;
    m.transmit = 0.1f;
    s.model.opacity_uses_filter_colour = true;
    tiny_plane(&s, 0, 0, 1, 5, m);
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0, 0, 1), 0.6 * 0.5, 0.6 * 0.25, 0.0, 1e-6);
    tiny_end(&s);
}

static void more_filter_and_transmit_than_one_takes_light_away(void **state)
{
    material m = tiny_emitted(0.5f, 0.5f, 0.5f);
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    m.filter = 0.9f;
    m.transmit = 0.9f;
    tiny_plane(&s, 0, 0, 1, 5, m);
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0, 0, 1), -0.8 * 0.5, -0.8 * 0.5, -0.8 * 0.5, 1e-6);
    tiny_end(&s);
}

static void diffuse_light_goes_by_the_cosine(void **state)
{
    material m = tiny_matt();
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    m.pigment = colour_of(1.0f, 0.5f, 0.0f);
    m.finish.diffuse = 0.6f;
    tiny_plane(&s, 0, 0, 1, 5, m);
    tiny_light(&s, 3, 0, 1, 1.0f, 1.0f, 0.5f);
    tiny_light(&s, 0, 0, 4, 0.0f, 0.5f, 0.0f);
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0, 0, 7), 0.6 * 0.8, 0.3 * 0.8 + 0.3 * 0.5, 0.0, 1e-6);
    tiny_end(&s);
}

static void what_lets_light_through_gives_less_diffuse_light(void **state)
{
    material m = tiny_matt();
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    m.filter = 0.5f;
    m.transmit = 0.25f;
    tiny_plane(&s, 0, 0, 1, 5, m);
    tiny_light(&s, 0, 0, 1, 1.0f, 1.0f, 1.0f);
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0, 0, 1), 0.15, 0.15, 0.15, 1e-6);
    tiny_end(&s);
}

static void the_normal_is_turned_towards_the_eye(void **state)
{
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    tiny_plane(&s, 0, 0, 1, 5, tiny_matt());
    tiny_light(&s, 0, 0, 9, 1.0f, 1.0f, 1.0f);
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0, 0, 1), 0.0, 0.0, 0.0, 0.0);
    assert_colour(tiny_trace(&s, pov_vec3_of(0, 0, 12), 0, 0, -1), 0.6, 0.6, 0.6, 1e-6);
    assert_int_equal(s.tracer->context.counts.shadow_behind, 1);
    tiny_end(&s);
}

/* The light stands at 45 degrees, the eye above: R.L is the cosine of 45 degrees. */
static void see_highlight(tiny *s, material m, colour wanted)
{
    m.finish.diffuse = 0.0f;
    m.finish.phong = 0.5f;
    m.finish.phong_size = 4.0f;
    m.pigment = colour_of(1.0f, 0.5f, 0.0f);
    tiny_plane(s, 0, 0, 1, 5, m);
    tiny_light(s, 2, 0, 3, 1.0f, 1.0f, 0.5f);
    tiny_build(s);
    assert_colour(tiny_trace(s, origin, 0, 0, 1), wanted.r, wanted.g, wanted.b, 1e-6);
    tiny_end(s);
}

static void a_highlight_has_the_colour_of_the_light(void **state)
{
    material m = tiny_matt();
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    m.transmit = 1.0f;
    see_highlight(&s, m, colour_of(0.125f, 0.125f, 0.0625f));
}

static void a_metal_takes_its_own_colour_into_the_highlight(void **state)
{
    material m = tiny_matt();
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    m.finish.metallic = 0.5f;
    see_highlight(&s, m, colour_of(0.125f, 0.125f * 0.75f, 0.0625f * 0.5f));
}

static void a_metal_by_fresnel_loses_some_of_its_colour(void **state)
{
    double f = 0.014567225 / ((0.5 - 1.12) * (0.5 - 1.12)) - 0.011612903;
    material m = tiny_matt();
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    m.finish.metallic = 1.0f;
    s.model.fresnel_metallic = true;
    see_highlight(&s, m, colour_of(0.125f, (float)(0.125 * (0.5 + 0.5 * f)), (float)(0.0625 * f)));
}

/* What is not computed would have been lost in the sum. */
static void a_highlight_is_left_out_only_where_no_float_can_hold_it(void **state)
{
    static const float sizes[] = { 0.5f, 1.0f, 7.0f, 40.0f, 1000.0f, 1e6f }, strengths[] = { 0.01f, 0.5f, 1.0f, 30.0f };
    (void)state;

    for (size_t i = 0; i < 6; i++)
        for (size_t j = 0; j < 4; j++) {
            material m = tiny_matt();
            double highlight_cutoff;
            tiny s;

            m.finish.phong = strengths[j];
            m.finish.phong_size = sizes[i];
            tiny_begin(&s, NULL);
            tiny_plane(&s, 0, 0, 1, 5, m);
            tiny_light(&s, 0, 0, 0, 1.0f, 1.0f, 1.0f);
            tiny_build(&s);
            highlight_cutoff = s.shading->appearances[0].highlight_cutoff;
            assert_true(highlight_cutoff > 0.0 && highlight_cutoff * highlight_cutoff != highlight_cutoff);
            for (double specular_cos = highlight_cutoff; specular_cos > 0.9 * highlight_cutoff;
                 specular_cos -= 0.01 * highlight_cutoff) {
                const float strength = m.finish.phong * (float)pow(specular_cos, m.finish.phong_size);

                assert_true(APPEARANCE_VISIBLE + strength == APPEARANCE_VISIBLE && -APPEARANCE_VISIBLE + strength == -APPEARANCE_VISIBLE);
            }
            assert_true(APPEARANCE_VISIBLE + m.finish.phong * (float)pow(highlight_cutoff * pow(16.0, 1.0 / m.finish.phong_size),
                                                                  m.finish.phong_size) > APPEARANCE_VISIBLE);
            tiny_end(&s);
        }
}

static void highlights_that_grow_away_from_the_light_are_never_left_out(void **state)
{
    material bright = tiny_matt(), odd = tiny_matt(), flat = tiny_matt();
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    bright.finish.phong = odd.finish.phong = flat.finish.phong = 1.0f;
    bright.finish.metallic = 2.0f;
    odd.finish.phong_size = -1.0f;
    flat.finish.phong_size = 0.0f;
    tiny_plane(&s, 0, 0, 1, 5, bright);
    tiny_plane(&s, 0, 0, 1, 6, odd);
    tiny_plane(&s, 0, 0, 1, 7, flat);
    tiny_light(&s, 0, 0, 0, 1.0f, 1.0f, 1.0f);
    tiny_build(&s);
    for (int i = 0; i < 3; i++)
        assert_near(s.shading->appearances[i].highlight_cutoff, 0.0, 0.0);
    tiny_end(&s);
}

/* Also next to where a float ends and the next begins, and where the power is too small for any. */
static void the_power_of_a_highlight_is_the_elementary_one(void **state)
{
    static const int sizes[] = { 1, 2, 7, 40, 100, 500, APPEARANCE_POWER_MAX };
    (void)state;

    for (size_t i = 0; i < 7; i++) {
        const finish f = { .phong_size = (float)sizes[i] };
        const appearance compiled = { .power = (uint32_t)sizes[i], .finish = &f };

        for (int j = 1; j < 20000; j++) {
            const float end = (float)j / 20000 + 0x1p-26f;
            const double edge = pow(0.5 * ((double)end + (double)nextafterf(end, 1.0f)), 1.0 / sizes[i]);

            assert_true(highlight_power(j / 19000.0, &compiled) == (float)elementary_pow(j / 19000.0, sizes[i]));
            assert_true(highlight_power(edge, &compiled) == (float)elementary_pow(edge, sizes[i]));
        }
        assert_true(highlight_power(1e-200, &compiled) == (float)elementary_pow(1e-200, sizes[i]));
    }
}

static void a_phong_size_of_zero_is_a_highlight_all_over(void **state)
{
    material m = tiny_matt();
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    m.finish.diffuse = 0.0f;
    m.finish.phong = 0.5f;
    m.finish.phong_size = 0.0f;
    tiny_plane(&s, 0, 0, 1, 5, m);
    tiny_light(&s, 20, 0, 3, 1.0f, 1.0f, 1.0f);
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0, 0, 1), 0.5, 0.5, 0.5, 1e-6);
    tiny_end(&s);
}

/* ---- shadows ---- */

static void an_opaque_sphere_throws_a_shadow_and_a_coloured_one_filters_it(void **state)
{
    material glass = tiny_glass(1.0);
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    glass.transmit = 0.1f;
    glass.filter = 0.5f;
    glass.pigment = colour_of(1.0f, 0.5f, 0.0f);
    tiny_plane(&s, 0, 0, 1, 5, tiny_matt());
    tiny_sphere(&s, 4, 0, 5, 1, glass);
    tiny_sphere(&s, -4, 0, 5, 1, tiny_matt());
    tiny_light(&s, 8, 0, 0, 1.0f, 1.0f, 1.0f);
    tiny_light(&s, -8, 0, 0, 1.0f, 1.0f, 1.0f);
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0, 0, 1), 1.2 * 5.0 / sqrt(89.0), 1.2 * 5.0 / sqrt(89.0),
                  1.2 * 5.0 / sqrt(89.0), 1e-6);
    tiny_end(&s);

    tiny_begin(&s, NULL);
    tiny_plane(&s, 0, 0, 1, 5, tiny_matt());
    tiny_sphere(&s, 4, 0, 2.5, 1, glass);
    tiny_sphere(&s, -4, 0, 2.5, 1, tiny_matt());
    tiny_light(&s, 8, 0, 0, 1.0f, 1.0f, 1.0f);
    tiny_light(&s, -8, 0, 0, 1.0f, 1.0f, 1.0f);
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0, 0, 1), 0.36 * 3.0 / sqrt(89.0), 0.1225 * 3.0 / sqrt(89.0),
                  0.01 * 3.0 / sqrt(89.0), 1e-6);
    assert_int_equal(s.tracer->context.counts.shadow, 2);
    tiny_end(&s);
}

static void rays_that_would_add_nothing_are_not_sent_but_counted(void **state)
{
    material bare = tiny_matt(), lit = tiny_matt();
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    bare.finish.diffuse = 0.0f;
    tiny_plane(&s, 0, 0, 1, 5, bare);
    tiny_plane(&s, 0, 0, 1, -5, lit);
    tiny_light(&s, 0, 0, 0, 1.0f, 1.0f, 1.0f);
    tiny_light(&s, 0, 1, 0, 0.0f, 0.0f, 0.0f);
    tiny_light(&s, 0, 1, -9, 1.0f, 1.0f, 1.0f);
    tiny_build(&s);
    tiny_trace(&s, origin, 0, 0, 1);
    assert_int_equal(s.tracer->context.counts.shadow_idle, 3);
    tiny_trace(&s, origin, 0, 0, -1);
    assert_int_equal(s.tracer->context.counts.shadow_idle, 4);
    assert_int_equal(s.tracer->context.counts.shadow_behind, 1);
    assert_int_equal(s.tracer->context.counts.shadow, 1);
    tiny_end(&s);
}

/* A light that is nearer to the surface than the coordinates' last place, and one that is 1e100 away. */
static void a_light_may_be_very_near_or_very_far(void **state)
{
    const double place = 1e9;
    light near = { .position = { place, 0.0, 5.0 - 1e-12 }, .color = { 1.0f, 0.0f, 0.0f } };
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    near.position_lo.z = (5.0 - near.position.z) - 1e-20;
    tiny_plane(&s, 0, 0, 1, 5, tiny_matt());
    tiny_light(&s, 1e100, 0, -1e100, 0.0f, 1.0f, 0.0f);
    tiny_light(&s, 0, 0, 0, 0.0f, 0.0f, 0.0f);
    s.model.lights.items[1] = near;
    tiny_build(&s);
    assert_colour(tiny_trace(&s, pov_vec3_of(place, 0, 0), 0, 0, 1), 0.6, 0.6 * sqrt(0.5), 0.0, 1e-6);
    tiny_end(&s);
}

/* ---- the ends of the world ---- */

/* Lanes are computed at once only as long as squares of lengths are numbers. */
static void directions_may_be_as_short_or_long_as_numbers_go(void **state)
{
    static const double lengths[] = { 0x1p-900, 0x1p-500, 0x1p500, 0x1p900 };
    material m = tiny_matt();
    colour usual;
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    m.finish.phong = 0.5f;
    m.finish.reflection.min = m.finish.reflection.max = colour_of(0.5f, 0.5f, 0.5f);
    tiny_plane(&s, 0, 0, 1, 5, m);
    tiny_plane(&s, 0, 0.6, -0.8, 5, m);
    s.model.leaves.items[1].flags |= LEAF_NO_SHADOW;
    tiny_light(&s, 1, 2, 0, 1.0f, 1.0f, 1.0f);
    tiny_light(&s, 0x1p900, 0, -0x1p900, 0.0f, 0.25f, 0.0f);
    tiny_build(&s);
    usual = tiny_trace(&s, origin, 0.25, 0.125, 1.0);
    assert_true(usual.r > 0.1f && usual.g > usual.r);
    for (int i = 0; i < 4; i++) {
        colour c = tiny_trace(&s, origin, 0.25 * lengths[i], 0.125 * lengths[i], lengths[i]);

        assert_colour(c, usual.r, usual.g, usual.b, 0.0);
    }
    tiny_end(&s);
}

static void colours_beyond_all_measure_stay_numbers(void **state)
{
    material m = tiny_matt();
    colour c;
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    m.pigment = colour_of(1e38f, -1e38f, 0.0f);
    m.finish.reflection.min = m.finish.reflection.max = m.pigment;
    m.finish.ambient = colour_of(1e38f, 1e38f, 1e38f);
    tiny_plane(&s, 0, 0, 1, 5, m);
    tiny_plane(&s, 0, 0, 1, -5, m);
    tiny_light(&s, 0, 0, 0, 1e38f, -1e38f, 1e38f);
    tiny_build(&s);
    c = tiny_trace(&s, origin, 0, 0, 1);
    assert_true(isfinite(c.r) && isfinite(c.g) && isfinite(c.b));
    tiny_end(&s);
}

static void a_ray_that_is_none_sees_the_background(void **state)
{
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    s.model.background = colour_of(0.25f, 0.5f, 1.0f);
    tiny_plane(&s, 0, 0, 1, 5, tiny_emitted(1.0f, 1.0f, 1.0f));
    tiny_build(&s);
    assert_colour(tiny_trace(&s, origin, 0, 0, 0), 0.25, 0.5, 1.0, 0.0);
    assert_colour(tiny_trace(&s, origin, 0, NAN, 1), 0.25, 0.5, 1.0, 0.0);
    assert_colour(tiny_trace(&s, pov_vec3_of(0, HUGE_VAL, 0), 0, 0, 1), 0.25, 0.5, 1.0, 0.0);
    assert_int_equal(s.tracer->context.counts.camera, 0);
    tiny_end(&s);
}

/* Rays that are none among many, and many without such behind them. */
static void rays_that_are_none_leave_the_others_in_their_lanes(void **state)
{
    const double none[4][5] = { { 0, 0, 0, 0, 0 }, { 1, 0, 1, 0, 0 }, { 0, 0, 0, 0, 1 }, { 0, 0, 0, 0, 0 } };
    pov_ray rays[5];
    colour many[5];
    tiny s;
    (void)state;
    tiny_begin(&s, NULL);

    s.model.background = colour_of(0.25f, 0.5f, 1.0f);
    tiny_plane(&s, 0, 1, 0, 1, tiny_emitted(1.0f, 0.5f, 0.0f));
    tiny_build(&s);
    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < 5; i++) {
            const pov_ray ray = { .origin_surface = POV_NO_OWNER };

            rays[i] = ray;
            rays[i].dir = pov_vec3_of(0.0, i - 2.0, none[k][i] > 0.0 ? NAN : 1.0);
        }
        tracer_colors(s.tracer, rays, 5, 0, NULL, many, NULL);
        for (int i = 0; i < 5; i++) {
            const colour one = tracer_color(s.tracer, &rays[i]);

            assert_memory_equal(&many[i], &one, sizeof one);
            assert_true(one.b == (i < 3 || none[k][i] > 0.0 ? 1.0f : 0.0f));
        }
    }
    tiny_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ambient_is_the_product_of_four_factors),
        cmocka_unit_test(opacity_may_weigh_the_filter_by_its_colour),
        cmocka_unit_test(more_filter_and_transmit_than_one_takes_light_away),
        cmocka_unit_test(diffuse_light_goes_by_the_cosine),
        cmocka_unit_test(what_lets_light_through_gives_less_diffuse_light),
        cmocka_unit_test(the_normal_is_turned_towards_the_eye),
        cmocka_unit_test(a_highlight_has_the_colour_of_the_light),
        cmocka_unit_test(a_metal_takes_its_own_colour_into_the_highlight),
        cmocka_unit_test(a_metal_by_fresnel_loses_some_of_its_colour),
        cmocka_unit_test(a_highlight_is_left_out_only_where_no_float_can_hold_it),
        cmocka_unit_test(highlights_that_grow_away_from_the_light_are_never_left_out),
        cmocka_unit_test(the_power_of_a_highlight_is_the_elementary_one),
        cmocka_unit_test(a_phong_size_of_zero_is_a_highlight_all_over),
        cmocka_unit_test(an_opaque_sphere_throws_a_shadow_and_a_coloured_one_filters_it),
        cmocka_unit_test(rays_that_would_add_nothing_are_not_sent_but_counted),
        cmocka_unit_test(a_light_may_be_very_near_or_very_far),
        cmocka_unit_test(directions_may_be_as_short_or_long_as_numbers_go),
        cmocka_unit_test(colours_beyond_all_measure_stay_numbers),
        cmocka_unit_test(a_ray_that_is_none_sees_the_background),
        cmocka_unit_test(rays_that_are_none_leave_the_others_in_their_lanes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
