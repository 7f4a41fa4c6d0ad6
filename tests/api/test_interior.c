/* Interiors: the middle of the picture of clear solids in front of white, against what POV-Ray 3.7 gives there. */
#include "support/check.h"
#include "support/near.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 9, HEIGHT = 7 };

#define CLEAR " pigment { rgbt 1 } finish { ambient 0 diffuse 0 } "
#define FADES "interior { fade_distance 1 fade_power 1 } "
#define WALL(place) "light_source { <0, 0, " place "> rgb 1 } plane { -z, -5 pigment { rgb 1 } finish { ambient 0 diffuse 1 } } "

static void assert_seen(const char *body, double red, double green, double blue)
{
    const double wanted[3] = { red, green, blue };
    char text[1024];
    float *picture;

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 10 adc_bailout 0 } background { rgb 1 }\n"
             "camera { orthographic location <0,0,-10> right 4*x up 3*y }\n%s", body);
    picture = scenes_draw(text, WIDTH, HEIGHT, 0, 0);
    for (int i = 0; i < 3; i++) {
        const double seen = (double)picture[4 * (HEIGHT / 2 * WIDTH + WIDTH / 2) + i];

        if (fabs(seen - wanted[i]) > 2e-5)
            fail_msg("%s: channel %d is %f", body, i, seen);
    }
    free(picture);
}

static void light_fades_where_a_ray_leaves_a_solid(void **state)
{
    (void)state;

    assert_seen("sphere { 0, 2" CLEAR FADES "}", 0.2, 0.2, 0.2);
    assert_seen("sphere { 0, 2" CLEAR FADES "} sphere { 0, 1" CLEAR FADES "}", 1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0);
    assert_seen("sphere { 0, 2" CLEAR FADES "} sphere { 0, 1" CLEAR "}", 0.5, 0.5, 0.5);
    assert_seen("sphere { 0, 2" CLEAR FADES "} sphere { 0, 1 pigment { rgb 1 } finish { ambient 1 diffuse 0 } }", 1.0, 1.0, 1.0);
    assert_seen("plane { -z, 2" CLEAR FADES "}", 1.0, 1.0, 1.0);
}

static void colour_and_power_shape_the_fading(void **state)
{
    (void)state;

    assert_seen("sphere { 0, 2" CLEAR "interior { fade_distance 4 } }", 0.5, 0.5, 0.5);
    assert_seen("sphere { 0, 2" CLEAR "interior { fade_distance 4 fade_power 2 fade_color rgb <1, 0.5, 0> } }", 1.0, 0.75, 0.5);
    assert_seen("sphere { 0, 2" CLEAR "interior { fade_distance 4 fade_power 1000 fade_color rgb <0.5, 0, 1> } }", exp(-0.5), exp(-1.0), 1.0);
}

static void light_on_its_way_fades_and_is_focused(void **state)
{
    (void)state;

    assert_seen(WALL("-30") "sphere { 0, 2 no_image" CLEAR FADES "}", 0.2, 0.2, 0.2);
    assert_seen(WALL("-30") "sphere { 0, 2 no_image" CLEAR FADES "} sphere { 0, 1 no_image" CLEAR FADES "}", 1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0);
    assert_seen("light_source { <0, 0, -30> rgb 1 } sphere { 0, 2 pigment { rgbt <1, 1, 1, 0.5> } finish { ambient 0 diffuse 1 } " FADES "}", 0.575, 0.575, 0.575);
    assert_seen(WALL("0.5") "sphere { 0, 2 no_image" CLEAR FADES "}", 1.0, 1.0, 1.0);
    assert_seen(WALL("-30") "sphere { 0, 2 no_image pigment { rgbt <1, 1, 1, 0.25> } interior { caustics 0.5 } }", 0.25, 0.25, 0.25);
}

static void every_layer_focuses_light_by_its_own_normal(void **state)
{
#define PANE(texture) WALL("-30") "box { <-3, -3, -1>, <3, 3, 1> no_image " texture " interior { caustics 0.02 } }"
#define LEVEL "texture { pigment { rgbt <1, 1, 1, 0.4> } } "
#define STEEP "pigment { rgbt <1, 1, 1, 0.4> } normal { gradient x 20 scale 40 translate 7 * x } "
    (void)state;
    assert_seen(PANE(LEVEL), 0.64, 0.64, 0.64);
    assert_seen(PANE(LEVEL LEVEL), 0.4096, 0.4096, 0.4096);
    assert_seen(PANE("texture { " STEEP " }"), 0.30907, 0.30907, 0.30907);
    assert_seen(PANE(LEVEL "texture { " STEEP " }"), 0.19780, 0.19780, 0.19780);
    assert_seen(PANE("texture { checker texture { " STEEP " } texture { " STEEP " } }"), 0.30907, 0.30907, 0.30907);
    assert_seen(PANE("texture { average texture_map { [1 " STEEP "] [1 pigment { rgbt <1, 1, 1, 0.4> }] } }"), 0.45965, 0.45965, 0.45965);
}

static void a_smooth_surface_focuses_light_by_its_shading_normal(void **state)
{
#define TILTED WALL("-30") "#declare N = <sqrt(3), 0, -1>; smooth_triangle { <-9,-9,0>, N, <9,-9,0>, N, <0,9,0>, N no_image "
#define WIDELY " interior { caustics 1/45 } }"
    (void)state;
    assert_seen(WALL("-30") "triangle { <-9,-9,0>, <9,-9,0>, <0,9,0> no_image pigment { rgbt <1, 1, 1, 0.25> }" WIDELY, 0.5, 0.5, 0.5);
    assert_seen(TILTED "pigment { rgbt <1, 1, 1, 0.25> }" WIDELY, 0.375, 0.375, 0.375);
    assert_seen(TILTED "pigment { checker rgbt <1, 1, 1, 0.25> rgbt <1, 1, 1, 0.25> }" WIDELY, 0.375, 0.375, 0.375);
}

/* What a ray crosses for the first time it enters, whichever way the surface faces. */
static void light_fades_between_two_surfaces_of_one_interior(void **state)
{
    (void)state;

    assert_seen(WALL("-30") "disc { 0, z, 2 no_image" CLEAR FADES "}", 1.0, 1.0, 1.0);
    assert_seen(WALL("-30") "disc { 0, -z, 2 no_image" CLEAR FADES "}", 1.0, 1.0, 1.0);
    assert_seen(WALL("-30") "union { disc { 0, z, 2 } disc { <0, 0, 3>, z, 2 } no_image" CLEAR FADES "}", 0.25, 0.25, 0.25);
    assert_seen(WALL("-30") "box { <-1, -1, 0>, <1, 1, 4> clipped_by { plane { z, 1 } } no_image" CLEAR FADES "}", 1.0, 1.0, 1.0);
    assert_seen(WALL("-30") "plane { -z, 0" CLEAR FADES "}", 1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0);
    assert_seen(WALL("-30") "plane { -z, 0 no_image" CLEAR FADES "}", 1.0, 1.0, 1.0);
}

static void members_with_interiors_of_their_own_are_solids_of_their_own(void **state)
{
    (void)state;

    assert_seen("merge { sphere { <5, 0, 0>, 1 " FADES "} box { <-1, -1, 0>, <1, 1, 3> interior { fade_distance 3 fade_power 1 } }" CLEAR "}",
                0.5, 0.5, 0.5);
    assert_seen("intersection { sphere { 0, 9 } box { <-1, -1, 0>, <1, 1, 3> " FADES "}" CLEAR "}", 0.25, 0.25, 0.25);
    assert_seen("merge { box { <-1, -1, 0>, <1, 1, 2> " FADES "} box { <-1, -1, 1>, <1, 1, 3> " FADES "}" CLEAR "}", 0.25, 0.25, 0.25);
}

static void hidden_objects_are_passed(void **state)
{
    (void)state;

    assert_seen("sphere { 0, 1 no_image pigment { rgb 0 } }", 1.0, 1.0, 1.0);
    assert_seen("plane { -z, -5 pigment { rgb 0 } finish { reflection 1 } } sphere { <0, 0, -20>, 2 no_reflection pigment { rgb 0 } }", 1.0, 1.0, 1.0);
    assert_seen("plane { -z, -5 pigment { rgb 0 } finish { reflection 1 } } sphere { <0, 0, 0>, 1 no_image pigment { rgb 0.25 } finish { ambient 1 } }",
                0.25, 0.25, 0.25);
}

/* Also where there is fog. */
static void light_fades_over_all_of_a_way_across_what_is_not_seen(void **state)
{
#define ROOM "box { <-1, -1, 0>, <1, 1, 3> " CLEAR FADES "} sphere { <0, 0, 1.5>, 0.5 no_image pigment { rgb 0 } } "
    (void)state;
    assert_seen(ROOM, 0.25, 0.25, 0.25);
    assert_seen(ROOM "fog { distance 1e9 rgb 0 } plane { -z, -5 pigment { rgb 1 } finish { ambient 1 diffuse 0 } }", 0.25, 0.25, 0.25);
    assert_seen("plane { -z, -5 pigment { rgb 0 } finish { reflection 1 } } box { <-1, -1, 0>, <1, 1, 3> no_image "
                CLEAR FADES "}", 0.25, 0.25, 0.25);
}

static void white_light_is_dispersed_into_its_colours(void **state)
{
    (void)state;

    /* The two halves of the spectrum go on together where nothing bends them. */
    assert_seen("sphere { 0, 2" CLEAR "interior { ior 1.5 dispersion 1.1 dispersion_samples 2 } }", 0.99380, 1.0, 0.99620);
}

/* As in POV-Ray; the ior may come later. */
static void without_an_ior_nothing_is_dispersed(void **state)
{
    (void)state;

    assert_seen("sphere { 0, 2" CLEAR "interior { dispersion 1.1 dispersion_samples 2 } }", 1.0, 1.0, 1.0);
    assert_seen("#declare I = interior { dispersion 1.1 dispersion_samples 2 } sphere { 0, 2" CLEAR "interior { I ior 1.5 } }", 0.99380, 1.0, 0.99620);
}

/* As measured: colours that are turned back where white light would enter are filtered, and the surface mirrors as well. */
static void dispersed_colours_are_turned_back_one_by_one(void **state)
{
    (void)state;

    assert_seen("plane { <1, 0, -.3>, 0 pigment { rgbt <1, 1, 1, .5> } finish { ambient 0 diffuse 0 } interior { ior .6 dispersion 1.05 dispersion_samples 2 } }",
                0.4969, 0.5, 0.4981);
    assert_seen("plane { <1, 0, -.3>, 0 pigment { rgbt <1, 1, 1, .5> } finish { ambient 0 diffuse 0 reflection .25 } interior { ior .6 dispersion 1.05 dispersion_samples 2 } }",
                0.7469, 0.75, 0.7481);
}

/* Of nothing in front, and white behind, through a sphere of the ior 1.5: what two surfaces let through. */
#define GLASS "finish { ambient 0 diffuse 0 reflection { 1 fresnel } conserve_energy ior 1.5 } "
#define WHITE "background { rgb 0 } plane { -z, -5 pigment { rgb 1 } finish { ambient 1 diffuse 0 } } "

/* As measured: what a mirror of Fresnel's takes is that of white light for each colour. */
static void fresnel_takes_of_each_colour_as_much_as_of_white_light(void **state)
{
    const double left = 0.96 / 1.04;

    (void)state;
    assert_seen(WHITE "sphere { 0, 2 pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } conserve_energy } "
                "interior { ior 1.5 dispersion 1.6 dispersion_samples 2 } }", 0.99380 * left, left, 0.99620 * left);
}

static void old_finishes_say_what_is_inside(void **state)
{
    const double seen = 0.9216 / (1.0 - 0.0016);

    (void)state;
    assert_seen(WHITE "sphere { 0, 1 pigment { rgbt 1 } " GLASS "}", seen, seen, seen);
    assert_seen(WHITE "sphere { 0, 1 pigment { rgbt 1 } " GLASS "interior { ior 1.1 } }", seen, seen, seen);
    assert_seen(WHITE "#declare F = " GLASS "sphere { 0, 1 pigment { rgbt 1 } finish { F } }", seen, seen, seen);
    assert_seen(WHITE "#declare T = texture { pigment { rgbt 1 } " GLASS "} sphere { 0, 1 texture { T } }", seen, seen, seen);
    assert_seen(WHITE "union { sphere { 0, 1 } sphere { 5*x, 1 } pigment { rgbt 1 } " GLASS "interior { ior 1.1 } }", seen, seen, seen);
    assert_seen(WHITE "#declare S = sphere { 0, 1 pigment { rgbt 1 } " GLASS "} object { S texture { pigment { rgbt 1 } } }", 1.0, 1.0, 1.0);
    assert_seen(WALL("-20") "disc { 0, <sqrt(3), 0, 1>, 2 pigment { rgbt 1 } finish { ambient 0 diffuse 0 caustics 1 } }", 1.5, 1.5, 1.5);
}

/* As it was written: in floats .9 is less than that. */
static void a_weight_of_the_bailout_itself_is_below_it_where_its_float_is(void **state)
{
    (void)state;
    assert_seen("global_settings { adc_bailout .9 } sphere { 0, 1 finish { ambient 0 diffuse 0 reflection .9 } }", 0.0, 0.0, 0.0);
    assert_seen("global_settings { adc_bailout .1 } sphere { 0, 1 finish { ambient 0 diffuse 0 reflection .1 } }", 0.1, 0.1, 0.1);
}

#define PLATE(from, to) "box { <-9, -9, " from ">, <9, 9, " to "> rotate 30*y texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } } "
#define MIRROR "interior_texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } } } "

/* As if it went from the one into the other. */
static void leaving_a_solid_in_one_that_was_entered_later_reflects_by_both(void **state)
{
    const double seen = 1.1112;

    (void)state;
    assert_seen(PLATE("0", "2") MIRROR "} " PLATE("1", "3") "interior { ior 2 } }", seen, seen, seen);
}

static float *spheres_with(const char *more)
{
    char text[1024];

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0.17, 1.39, -4.2> look_at <0.16, 0.45, -0.24> }\n"
             "background { rgb <.2, .4, .6> } sphere { 0.5, 1 pigment { rgbt 0.9 } interior { ior 1.81 } } sphere { 0, 1 pigment { rgbt 0.9 } } %s", more);
    return scenes_draw(text, 40, 30, 0, 0);
}

/* Their rays go on beside others that have entered something. */
static void what_is_not_seen_leaves_lists_of_solids_as_they_are(void **state)
{
    float *with = spheres_with("box { -.5, .4 no_image }"), *without = spheres_with("");

    (void)state;
    for (int i = 0; i < 4 * 40 * 30; i++)
        assert_near(with[i], without[i], 1e-5);
    free(with);
    free(without);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_fades_where_a_ray_leaves_a_solid),
        cmocka_unit_test(colour_and_power_shape_the_fading),
        cmocka_unit_test(light_on_its_way_fades_and_is_focused),
        cmocka_unit_test(every_layer_focuses_light_by_its_own_normal),
        cmocka_unit_test(a_smooth_surface_focuses_light_by_its_shading_normal),
        cmocka_unit_test(light_fades_between_two_surfaces_of_one_interior),
        cmocka_unit_test(members_with_interiors_of_their_own_are_solids_of_their_own),
        cmocka_unit_test(hidden_objects_are_passed),
        cmocka_unit_test(light_fades_over_all_of_a_way_across_what_is_not_seen),
        cmocka_unit_test(white_light_is_dispersed_into_its_colours),
        cmocka_unit_test(fresnel_takes_of_each_colour_as_much_as_of_white_light),
        cmocka_unit_test(old_finishes_say_what_is_inside),
        cmocka_unit_test(a_weight_of_the_bailout_itself_is_below_it_where_its_float_is),
        cmocka_unit_test(leaving_a_solid_in_one_that_was_entered_later_reflects_by_both),
        cmocka_unit_test(what_is_not_seen_leaves_lists_of_solids_as_they_are),
        cmocka_unit_test(without_an_ior_nothing_is_dispersed),
        cmocka_unit_test(dispersed_colours_are_turned_back_one_by_one),
    };

    return cmocka_run_group_tests_name("interiors", tests, NULL, NULL);
}
