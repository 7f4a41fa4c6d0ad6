/* Media: the middle of a picture against closed forms, and against numbers that POV-Ray 3.7 gives at its best settings. */
#include "support/check.h"
#include "support/near.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 9, HEIGHT = 7, SAMPLES = 16 };

#define CLEAR " hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } "
#define BOX(media) "box { <-1, -1, 0>, <1, 1, 1.5>" CLEAR "interior { " media " } } "
#define WALL(z, colour) "plane { z, " z " hollow pigment { " colour " } finish { ambient 1 diffuse 0 } } "
/* Alike in all of the picture's middle: parallel, along the rays of the camera. */
#define ALONG "light_source { <0, 0, -20> rgb 1 parallel point_at <0, 0, 1> } "

static float *render(const char *body, int threads, int samples)
{
    char text[1024];

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 10 adc_bailout 0 }\n"
             "camera { orthographic location <0,0,-10> right 1.8*x up 1.4*y }\n%s", body);
    return scenes_draw(text, WIDTH, HEIGHT, samples, threads);
}

/* The mean over all pixels: they see the same. */
static void assert_mean(const char *body, double red, double green, double blue, double tolerance)
{
    const double wanted[3] = { red, green, blue };
    float *picture = render(body, 1, SAMPLES);

    for (int c = 0; c < 3; c++) {
        double sum = 0.0;

        for (int i = 0; i < WIDTH * HEIGHT; i++)
            sum += (double)picture[4 * i + c];
        if (!(fabs(sum / (WIDTH * HEIGHT) - wanted[c]) <= tolerance))
            fail_msg("%s: channel %d is %f, not %f", body, c, sum / (WIDTH * HEIGHT), wanted[c]);
    }
    free(picture);
}

static void assert_grey(const char *body, double wanted, double tolerance) { assert_mean(body, wanted, wanted, wanted, tolerance); }

static const double exact = 2e-6;

/* ---- closed forms ---- */

static void a_box_absorbs_and_emits_by_its_thickness(void **state)
{
    const double e = exp(-1.2), through = exp(-0.45);
    (void)state;

    assert_mean(BOX("media { absorption <0.3, 1, 0> }") WALL("4", "rgb 1"), through, exp(-1.5), 1.0, exact);
    assert_grey(BOX("media { emission 0.2 }") WALL("4", "rgb 0.1"), 0.4, exact);
    assert_grey(BOX("media { emission 0.5 absorption 0.8 }") WALL("4", "rgb 0"), 0.5 / 0.8 * (1.0 - e), exact);
    assert_grey(BOX("media { absorption -0.3 }") WALL("4", "rgb 0.5"), 0.5 / through, exact);
    assert_mean(BOX("media { emission 0.2 density { rgb <0.5, 1, 2> } density { rgb <0.3, 0.4, 0.2> } }") WALL("4", "rgb 0"), 0.045,
                0.12, 0.12, exact);
}

static void a_sphere_absorbs_by_the_chord(void **state)
{
    float *picture = render("sphere { 0, 0.8" CLEAR "interior { media { absorption 0.7 } } }" WALL("4", "rgb 1"), 1, 1);
    (void)state;

    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const double u = ((double)x - 4.0) * 0.2, v = ((double)y - 3.0) * 0.2, half = 0.64 - u * u - v * v;

            assert_near((double)picture[4 * (y * WIDTH + x)], half > 0.0 ? exp(-1.4 * sqrt(half)) : 1.0, 2e-5);
        }
    free(picture);
}

static void a_scale_moves_densities_and_not_strengths(void **state)
{
    (void)state;

    assert_grey("box { <-1, -1, 0>, <1, 1, 1>" CLEAR "interior { media { emission 0.2 scale 3 } } scale 2 }" WALL("4", "rgb 0"), 0.4,
                exact);
    /* Each place is dimmed by what lies before it, not as if all of its way were as dense. */
    assert_grey("box { <-1, -1, 0>, <1, 1, 1>" CLEAR "interior { media { method 2 samples 200, 200 emission 0.3 absorption 1 density { gradient z } } } }"
                WALL("4", "rgb 0"), 0.3 * (1.0 - exp(-0.5)), 1e-3);
    /* 1 from z = 0.5 on, once the density has moved there with the box. */
    assert_grey("box { <-1, -1, 0>, <1, 1, 1>" CLEAR "interior { media { emission 1 density { planar scale 1e6 } } } translate z }"
                WALL("4", "rgb 0"), 1.0, 1e-5);
}

/* ---- which media act ---- */

static void media_act_between_the_surfaces_of_hollow_objects(void **state)
{
    (void)state;

    assert_grey("box { <-1, -1, 0>, <1, 1, 1.5> pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { emission 0.2 } } }"
                WALL("4", "rgb 0.25"), 0.25, exact);
    assert_grey(BOX("media { emission 0.2 }") "box { <-1, -1, 0.5>, <1, 1, 1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }"
                WALL("4", "rgb 0"), 0.2, exact);
    assert_grey("box { <-2, -2, 0>, <2, 2, 1> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { emission 0.3 } } }"
                BOX("media { emission 0.2 }") WALL("4", "rgb 0"), 0.6, exact);
    /* Overlapping parts of a union with one interior: out of it where two are. */
    assert_grey("union { box { <-1, -1, 0>, <1, 1, 2> } box { <-1, -1, 1>, <1, 1, 3> }" CLEAR "interior { media { emission 0.2 } } }"
                WALL("4", "rgb 0"), 0.4, 1e-5);
    assert_grey("merge { box { <-1, -1, 0>, <1, 1, 2> } box { <-1, -1, 1>, <1, 1, 3> }" CLEAR "interior { media { emission 0.2 } } }"
                WALL("4", "rgb 0"), 0.6, 1e-5);
    assert_grey("disc { <0, 0, 1>, z, 9" CLEAR "interior { media { emission 0.2 } } }" WALL("3", "rgb 0"), 0.4, exact);
}

static void nothing_acts_on_the_last_segment_but_the_atmosphere(void **state)
{
    (void)state;

    assert_grey("background { rgb 0.5 } plane { -z, 0" CLEAR "interior { media { absorption 1 emission 1 } } }", 0.5, exact);
    assert_grey("background { rgb 0.5 } media { emission 1e-11 }", 0.7, 1e-5);
    assert_grey("background { rgb 0.5 } media { absorption 0.2 emission 0.1 }", 0.5, 1e-5);
}

static void a_camera_inside_begins_in_the_media(void **state)
{
    (void)state;

    assert_grey("sphere { <0, 0, -10>, 6" CLEAR "interior { media { emission 0.05 } } }" WALL("4", "rgb 0"), 0.05 * 5.9, 0.01);
    assert_grey("sphere { <0, 0, -10>, 6 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { emission 0.05 } } }"
                WALL("4", "rgb 0.5"), 0.5, exact);
}

static void an_atmosphere_lies_over_media_and_fog_over_both(void **state)
{
    const double loss = exp(-0.7), fog = exp(-1.4);
    (void)state;

    assert_grey("media { absorption 0.05 emission 0.02 }" WALL("4", "rgb 0.6"), 0.6 * loss + 0.4 * (1.0 - loss), exact);
    assert_grey("media { absorption 0.05 emission 0.02 } fog { rgb 0.5 distance 10 }" WALL("4", "rgb 0.6"),
                (0.6 * loss + 0.4 * (1.0 - loss)) * fog + 0.5 * (1.0 - fog), exact);
}

/* ---- light ---- */

static void light_is_scattered_as_in_povray(void **state)
{
    (void)state;

    /* Light goes through what it is scattered in: (1 - exp(-2 s d)) / 2. But nothing ends the last piece of its way before
     * it is in the box, so it is dimmed up to the surface. */
    assert_grey(BOX("media { scattering { 1, 0.4 } }") ALONG WALL("4", "rgb 0"), 0.34940, 1e-4);
    assert_grey(BOX("media { scattering { 1, 0.4 extinction 0.5 } }") ALONG WALL("4", "rgb 0"), 0.45119, 1e-4);
    assert_grey(BOX("media { scattering { 5, 0.3 eccentricity 0.4 extinction 0.5 } }") ALONG WALL("4", "rgb 0"), 0.11093, 1e-4);
    assert_mean("background { rgb 0.7 }" BOX("media { absorption 0.3 emission <0.1, 0.3, 0.2> scattering { 1, <0.2, 0.1, 0.4> extinction 0.7 } }")
                WALL("4", "rgb 0.7") ALONG, 0.63816, 0.83780, 0.77793, 2e-4);
    assert_grey(BOX("media { scattering { 1, 0.2 } } media { scattering { 4, 0.3 extinction 0.5 } }") ALONG WALL("4", "rgb 0"), 0.60335, 2e-4);
}

/* The phase is the plain mean over the media, whatever each of them scatters. */
static void phases_of_several_media_are_averaged(void **state)
{
    const double haze = 0.57666, rayleigh = 2.0 * 0.79940;
    (void)state;

    assert_grey(BOX("media { scattering { 2, 0.2 extinction 0 } } media { scattering { 4, 0.3 extinction 0 } }") ALONG WALL("4", "rgb 0"),
                0.5 * (haze + rayleigh) / 2.0 * 1.5, 2e-4);
}

static void some_lights_give_nothing_to_media(void **state)
{
    (void)state;

    assert_grey(BOX("media { scattering { 1, 0.4 } }") "light_source { <0, 0, -20> rgb 1 media_interaction off }" WALL("4", "rgb 0"), 0.0,
                exact);
    assert_grey(BOX("media { scattering { 1, 0.4 } }") "light_source { <0, 0, -20> rgb 1 shadowless }" WALL("4", "rgb 0"), 0.0, exact);
}

static void media_throw_shadows(void **state)
{
#define LIT "plane { z, 4 hollow pigment { rgb 1 } finish { ambient 0 diffuse 1 } } " ALONG
    (void)state;

    assert_grey(BOX("media { absorption 0.4 }") LIT, exp(-1.2), exact);
    assert_grey("box { <-1, -1, 0>, <1, 1, 1.5> no_shadow" CLEAR "interior { media { absorption 0.4 } } }" LIT, exp(-0.6), exact);
    assert_grey("media { absorption 0.1 }" LIT, exp(-1.4), exact);
    assert_grey("media { absorption 0.1 } plane { z, 4 hollow pigment { rgb 1 } finish { ambient 0 diffuse 1 } }"
                "light_source { <0, 0, -6> rgb 1 parallel point_at <0, 0, 1> media_attenuation on }", exp(-1.4) * exp(-1.0), exact);
    assert_grey("fog { rgb 0 distance 10 } plane { z, 4 hollow pigment { rgb 1 } finish { ambient 0 diffuse 1 } }"
                "light_source { <0, 0, -6> rgb 1 parallel point_at <0, 0, 1> media_attenuation on }", exp(-1.4) * exp(-1.0), exact);
#undef LIT
}

/* From the wall at 4 to the lamp at -6, over two surfaces at -1 and -2; the camera is at -10. */
static void fog_and_the_atmosphere_dim_light_by_piece(void **state)
{
#define LAMP "light_source { <0, 0, -6> rgb 1 parallel point_at <0, 0, 1> media_attenuation on }"
#define SEEN "plane { z, 4 hollow pigment { rgb 1 } finish { ambient 0 diffuse 1 } }" LAMP
    static const char *const air = "media { absorption 0.1 }", *const fog = "fog { rgb 0 distance 10 }";
    char text[2048];

    (void)state;
    for (int k = 0; k < 2; k++) {
        const char *by = k == 0 ? air : fog;

        snprintf(text, sizeof text, "%s plane { z, 4 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }" LAMP, by);
        assert_grey(text, 1.0, exact);
        snprintf(text, sizeof text, "%s plane { z, 4 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }"
                 "box { <-1, -1, -2>, <1, 1, -1> no_image pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }" LAMP, by);
        assert_grey(text, k == 0 ? exp(-0.6) : 1.0, exact);
        snprintf(text, sizeof text, "%s" SEEN "box { <-1, -1, -2>, <1, 1, -1> no_image pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }", by);
        assert_grey(text, k == 0 ? exp(-2.4) : exp(-2.3), exact);
        snprintf(text, sizeof text, "%s" SEEN "box { <-1, -1, -9>, <1, 1, -1> no_image pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }", by);
        assert_grey(text, exp(-1.9), exact);
    }
#undef SEEN
#undef LAMP
}

/* Sampled media, with densities that vary, in shadow and light. */
static void pictures_are_the_same_with_any_number_of_threads(void **state)
{
    static const char *body = "sphere { 0, 0.6" CLEAR "interior { media { scattering { 3, 1 } absorption 0.4 density { spherical turbulence 0.4 } } } }"
                              "sphere { <0.2, 0.5, -0.8>, 0.2 pigment { rgb 1 } } light_source { <2, 5, -6> rgb 1 area_light x, y, 3, 3 }"
                              "media { scattering { 2, 0.03 } }" WALL("4", "rgb 0.2");
    float *one = render(body, 1, 5), *three = render(body, 3, 5);
    (void)state;

    assert_memory_equal(one, three, 4 * WIDTH * HEIGHT * sizeof *one);
    free(one);
    free(three);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_box_absorbs_and_emits_by_its_thickness),
        cmocka_unit_test(a_sphere_absorbs_by_the_chord),
        cmocka_unit_test(a_scale_moves_densities_and_not_strengths),
        cmocka_unit_test(media_act_between_the_surfaces_of_hollow_objects),
        cmocka_unit_test(nothing_acts_on_the_last_segment_but_the_atmosphere),
        cmocka_unit_test(a_camera_inside_begins_in_the_media),
        cmocka_unit_test(an_atmosphere_lies_over_media_and_fog_over_both),
        cmocka_unit_test(light_is_scattered_as_in_povray),
        cmocka_unit_test(phases_of_several_media_are_averaged),
        cmocka_unit_test(some_lights_give_nothing_to_media),
        cmocka_unit_test(media_throw_shadows),
        cmocka_unit_test(fog_and_the_atmosphere_dim_light_by_piece),
        cmocka_unit_test(pictures_are_the_same_with_any_number_of_threads),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
