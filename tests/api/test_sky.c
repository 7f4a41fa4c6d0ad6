/* Skies and backgrounds where nothing is hit, against what POV-Ray 3.7 gives there. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void assert_seen(const char *version, const char *body, double red, double green, double blue)
{
    const double wanted[3] = { red, green, blue };
    char text[1024];
    float *picture;

    snprintf(text, sizeof text, "#version %s; global_settings { assumed_gamma 1 } camera { location 0 look_at y + z }\n%s", version, body);
    picture = scenes_draw(text, 3, 3, 0, 0);
    for (int i = 0; i < 3; i++)
        if (fabs((double)picture[4 * 4 + i] - wanted[i]) > 2e-6)
            fail_msg("%s %s: channel %d is %f", version, body, i, (double)picture[4 * 4 + i]);
    free(picture);
}

#define BEHIND "background { rgb <.2, .4, .8> } "

static void one_layer_filters_the_background(void **state)
{
    static const char *const versions[] = { "3.7", "3.6" };

    (void)state;
    for (int i = 0; i < 2; i++) {
        assert_seen(versions[i], BEHIND "sky_sphere { pigment { rgbf <.75, .5, .6, .4> } }", 0.51, 0.38, 0.552);
        assert_seen(versions[i], BEHIND "sky_sphere { pigment { rgbft <.75, .5, .6, .4, .2> } }", 0.4, 0.36, 0.592);
    }
}

/* Before version 3.7 the colour of an upper layer does not count, as with textures. */
static void upper_layers_filter_by_version(void **state)
{
    static const char sky[] = BEHIND "sky_sphere { pigment { rgb <.2, .3, .4> } pigment { rgbf <.75, .5, .6, .4> } }";

    (void)state;
    assert_seen("3.7", sky, 0.45 + 0.3 * 0.2, 0.3 + 0.2 * 0.3, 0.36 + 0.24 * 0.4);
    assert_seen("3.6", sky, 0.45 + 0.4 * 0.2, 0.3 + 0.4 * 0.3, 0.36 + 0.4 * 0.4);
}

/* Before version 3.7 light passes through several layers if all of them filter, or all of them transmit. */
static void what_old_layers_filter_and_transmit_is_counted_apart(void **state)
{
    (void)state;
    assert_seen("3.6", BEHIND "sky_sphere { pigment { rgb 1 } pigment { rgbt <.2, .7, .1, .4> } pigment { rgbf <.6, .1, .7, .3> } }",
                0.42 + 0.036, 0.07 + 0.126, 0.49 + 0.018);
    assert_seen("3.6", BEHIND "sky_sphere { pigment { rgbft <.1, .45, .3, .2, .1> } pigment { rgbft <.6, .1, .7, .3, .3> } }",
                0.24 + 0.042 + 0.2 * 0.0336, 0.04 + 0.189 + 0.4 * 0.0327, 0.28 + 0.126 + 0.8 * 0.0426);
}

static void a_background_lets_nothing_through_before_version_3_7(void **state)
{
    (void)state;
    assert_seen("3.7", "background { rgbft <.5, .6, .7, .2, .3> }", 0.35, 0.42, 0.49);
    assert_seen("3.6", "background { rgbft <.5, .6, .7, .2, .3> }", 0.5, 0.6, 0.7);
}

static void the_last_sky_counts_and_emission_scales_its_own_light(void **state)
{
    (void)state;
    assert_seen("3.7", BEHIND "sky_sphere { pigment { rgb 1 } } sky_sphere { pigment { rgbt <.5, .5, .5, .5> } emission <1, 2, 0> }",
                0.25 + 0.1, 0.5 + 0.2, 0.4);
}

/* Of a sphere that mirrors, before a sky. */
static float *draw_before(const char *sky)
{
    char text[512];

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 } camera { location -4*z look_at 0 } %s "
             "sphere { 0, 1 pigment { rgb .3 } finish { reflection <.7, .4, .9> } }", sky);
    return scenes_draw(text, 24, 18, 0, 0);
}

/* A sky of one colour is known without its directions. */
static void a_sky_without_a_pattern_is_what_one_of_equal_colours_is(void **state)
{
    float *plain = draw_before("sky_sphere { pigment { rgb <.75, .5, .125> } }");
    float *varying = draw_before("sky_sphere { pigment { checker rgb <.75, .5, .125>, rgb <.75, .5, .125> } }");

    (void)state;
    assert_memory_equal(plain, varying, 24 * 18 * 4 * sizeof *plain);
    assert_true(plain[0] == 0.75f && plain[1] == 0.5f && plain[2] == 0.125f);
    free(plain);
    free(varying);
}

/* Solids without fog in them are those that the ray meets, and those that it starts in, as in POV-Ray. */
static void a_solid_that_is_not_seen_holds_no_fog_up(void **state)
{
    static const char wall[] = "fog { distance 5 rgb <.3, .7, .8> } plane { -z, -5 pigment { rgb .5 } finish { ambient 1 diffuse 0 } } ";
    const double left = exp(-sqrt(50.0) / 5.0), inside = exp(-(sqrt(50.0) - 2.0) / 5.0);
    char body[512];

    (void)state;
    snprintf(body, sizeof body, "%ssphere { <0, 2, 2>, 1 pigment { rgbt 1 } }", wall);
    assert_seen("3.7", body, 0.3 + 0.2 * inside, 0.7 - 0.2 * inside, 0.8 - 0.3 * inside);
    snprintf(body, sizeof body, "%ssphere { <0, 2, 2>, 1 no_image }", wall);
    assert_seen("3.7", body, 0.3 + 0.2 * left, 0.7 - 0.2 * left, 0.8 - 0.3 * left);
    snprintf(body, sizeof body, "%ssphere { 0, 1 no_image }", wall);
    assert_seen("3.7", body, 0.5, 0.5, 0.5);
}

/* The noise at the origin makes it thinner all over; values as measured. */
static void a_word_of_turbulence_makes_fog_thinner(void **state)
{
    static const char scene[] = "fog { distance 5 rgb <.3, .7, .8> %s } plane { -z, -5 pigment { rgb .5 } finish { ambient 1 diffuse 0 } }";
    static const struct { const char *words; double red, green, blue; } cases[] = {
        { "turb_depth .8", 0.348623, 0.651377, 0.727065 },
        { "octaves 6", 0.350240, 0.649760, 0.724640 },
        { "turb_depth .8 octaves 2 turbulence 0", 0.350601, 0.649399, 0.724098 },
    };
    char body[512];

    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        snprintf(body, sizeof body, scene, cases[i].words);
        assert_seen("3.7", body, cases[i].red, cases[i].green, cases[i].blue);
    }
}

/* Fog that lets half through at most does so once on the whole way. */
static void a_way_across_what_is_not_seen_is_one(void **state)
{
    static const char fog[] = "fog { distance 1 rgbt <.4, .6, .8, .5> } plane { -z, -5 pigment { rgb 0 } finish { ambient 0 diffuse 0 } } ";
    char body[512];

    (void)state;
    snprintf(body, sizeof body, "%sbox { <-1, 1, 1>, <1, 4, 4> no_image }", fog);
    assert_seen("3.7", body, 0.2, 0.3, 0.4);
}

/* As measured. Half of the bow is there beside its direction's `up`; before something near it is as strong as anywhere. */
static void the_arc_of_a_rainbow_limits_what_its_distance_leaves(void **state)
{
    static const char bow[] = "plane { -z, -5 pigment { rgb 0 } finish { ambient 0 diffuse 0 } } rainbow { direction z angle 45 width 20 distance 20 "
                              "color_map { [0 rgbt <1, 1, 1, %.1f>] [1 rgbt <1, 1, 1, %.1f>] } up x arc_angle 360 falloff_angle 0 }";
    const double near = 1.0 - exp(-sqrt(50.0) / 20.0);
    char body[512];

    (void)state;
    snprintf(body, sizeof body, bow, 0.0, 0.0);
    assert_seen("3.7", body, near, near, near);
    snprintf(body, sizeof body, bow, 0.8, 0.8);
    assert_seen("3.7", body, 0.1, 0.1, 0.1);
}

/* As measured. The mean is of the bows that are there: one whose arc is elsewhere does not count. Without a distance it is 1e7. */
static void bows_whose_arcs_are_elsewhere_do_not_count(void **state)
{
    static const char map[] = "color_map { [0 rgb <.2, .4, .8>] [1 rgb <.2, .4, .8>] }";
    char body[1024];

    (void)state;
    snprintf(body, sizeof body, "rainbow { direction z angle 45 width 20 distance 20 %s } rainbow { direction z angle 45 width 20 %s up -x "
             "arc_angle 60 falloff_angle 40 }", map, map);
    assert_seen("3.7", body, 0.2, 0.4, 0.8);
    snprintf(body, sizeof body, "plane { -z, -1e7 pigment { rgb 0 } finish { ambient 0 diffuse 0 } } rainbow { direction z angle 45 width 20 "
             "color_map { [0 rgb 1] [1 rgb 1] } }");
    assert_seen("3.7", body, 1.0 - exp(-sqrt(2.0)), 1.0 - exp(-sqrt(2.0)), 1.0 - exp(-sqrt(2.0)));
}

/* As measured: it is nowhere beyond its arc, whatever the falloff, which is 180 where it is not given. */
static void a_bow_ends_with_its_arc(void **state)
{
    (void)state;
    assert_seen("3.7", "background { rgb <.9, .7, .5> } rainbow { direction z angle 45 width 20 color_map { [0 rgb <.2, .4, .8>] "
                "[1 rgb <.2, .4, .8>] } up x arc_angle 90 }", 0.9, 0.7, 0.5);
}

/* As measured: filter and transmit lie between those of the map's entries, as colours do. */
static void maps_of_bows_blend_all_components(void **state)
{
    (void)state;
    assert_seen("3.7", "background { rgb <.9, .7, .5> } rainbow { direction z angle 45 width 20 color_map { [0 rgb <.2, .4, .8>] "
                "[1 rgbft <.2, .4, .8, .8, .5>] } }", 0.321, 0.4435, 0.7175);
}

/* What is behind a bow is filtered as far as the bow is there. It is in the half of the sky that it is directed to, and in no solid. */
static void rainbows_filter_and_end_at_a_right_angle(void **state)
{
    static const char bow[] = "plane { -z, -5 pigment { rgb 1 } finish { ambient 1 diffuse 0 } %s } "
                              "rainbow { direction %s angle 90 width 180 distance 10 color_map { [0 rgbf <.3, .6, .9, .5>] [1 rgbf <.3, .6, .9, .5>] } }";
    const double w = 1.0 - exp(-sqrt(0.5)), left = 1.0 - w;
    char body[512];

    (void)state;
    snprintf(body, sizeof body, bow, "", "<1, 1, 1>");
    assert_seen("3.7", body, 0.3 * w + left * (1.0 - 0.35 * w), 0.6 * w + left * (1.0 - 0.2 * w), 0.9 * w + left * (1.0 - 0.05 * w));
    snprintf(body, sizeof body, bow, "", "<1, -1, 0>");
    assert_seen("3.7", body, 1.0, 1.0, 1.0);
    snprintf(body, sizeof body, bow, "inverse", "<1, 1, 1>");
    assert_seen("3.7", body, 1.0, 1.0, 1.0);
}

#define LAYER "fog { distance 1 fog_type 2 fog_alt 1 "
#define CEILING " colour rgb 0 } plane { -y, -1 pigment { rgb 1 } finish { ambient 1 diffuse 0 } }"

static void what_moves_a_fog_turns_its_top(void **state)
{
    const double up = exp(-atan(1.0) * sqrt(2.0)), down = exp(-sqrt(2.0));

    (void)state;
    assert_seen("3.7", LAYER "translate 5*y scale 2" CEILING, up, up, up);
    assert_seen("3.7", LAYER "rotate 180*x" CEILING, down, down, down);
    assert_seen("3.7", LAYER "scale <1, -1, 1>" CEILING, down, down, down);
    assert_seen("3.7", LAYER "up -y rotate 180*x" CEILING, up, up, up);
    assert_seen("3.7", LAYER "rotate 180*x up y" CEILING, up, up, up);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_layer_filters_the_background),
        cmocka_unit_test(upper_layers_filter_by_version),
        cmocka_unit_test(what_old_layers_filter_and_transmit_is_counted_apart),
        cmocka_unit_test(a_background_lets_nothing_through_before_version_3_7),
        cmocka_unit_test(a_sky_without_a_pattern_is_what_one_of_equal_colours_is),
        cmocka_unit_test(a_solid_that_is_not_seen_holds_no_fog_up),
        cmocka_unit_test(maps_of_bows_blend_all_components),
        cmocka_unit_test(a_bow_ends_with_its_arc),
        cmocka_unit_test(bows_whose_arcs_are_elsewhere_do_not_count),
        cmocka_unit_test(rainbows_filter_and_end_at_a_right_angle),
        cmocka_unit_test(a_way_across_what_is_not_seen_is_one),
        cmocka_unit_test(the_arc_of_a_rainbow_limits_what_its_distance_leaves),
        cmocka_unit_test(what_moves_a_fog_turns_its_top),
        cmocka_unit_test(a_word_of_turbulence_makes_fog_thinner),
        cmocka_unit_test(the_last_sky_counts_and_emission_scales_its_own_light),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
