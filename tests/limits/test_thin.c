/* test_thin.c - slabs, gaps and pebbles as thin and small as doubles can tell. */
#include "support/check.h"
#include "support/limits.h"
#include "support/near.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 64, HEIGHT = 48 };

static const double thicknesses[] = { 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15 };
enum { THICKNESSES = (int)(sizeof thicknesses / sizeof *thicknesses) };

static int begin(void **state)
{
    *state = scenes_context();
    return 0;
}

static int end(void **state)
{
    pov_context_destroy(*state);
    return 0;
}

/* ---- slabs ---- */

/* Each stands at z = 0 and is 1 thick before it is made thin; its side is of no matter. */
static const char *const slabs[] = {
    "box { <-8,-8,%.17g>, <8,8,%.17g>",
    "cylinder { <0,0,%.17g>, <0,0,%.17g>, 8",
    "cone { <0,0,%.17g>, 8, <0,0,%.17g>, 7",
};

static float *sample_through(void *context, const char *slab, double from, double to, const char *surface)
{
    char solid[256], text[1024];

    sprintf(solid, slab, from, to);
    sprintf(text,
            "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 8 } background { color rgb <1,0.5,0.25> }\n"
            "camera { location <0.5,0.25,-5> look_at <0,0,1> angle 50 right <1.3333333,0,0> }\n"
            "light_source { <3,5,40> color rgb 1 }\n"
            "%s %s }\n", solid, surface);
    return limits_picture(context, text, &limits_home, WIDTH, HEIGHT);
}

/* Both faces count on every pixel: half of the half comes through, of a refracting slab too. The slab stands at 0,
 * where all thicknesses can be told, and at 1, where those of some units in the last place can. */
static void both_faces_of_a_transparent_slab_count(void **state)
{
    static const char *const surfaces[] = {
        "pigment { color rgbf <1,1,1,0.5> } finish { ambient 0 diffuse 0 }",
        "pigment { color rgbf <1,1,1,0.5> } finish { ambient 0 diffuse 0 } interior { ior 1.5 }",
    };
    const float wanted[3] = { 0.25f, 0.125f, 0.0625f };

    for (int s = 0; s < 3; s++)
        for (int k = 0; k < THICKNESSES; k++)
            for (int i = 0; i < 4; i++) {
                const double at = i / 2 ? 1.0 : 0.0;
                float *seen = sample_through(*state, slabs[s], at, at + thicknesses[k], surfaces[i % 2]);
                const long right = limits_count_colour(seen, WIDTH, HEIGHT, wanted, 1e-6f);

                if (right != WIDTH * HEIGHT)
                    print_error("%s at %g, %g thick: %ld pixels wrong\n", slabs[s], at, thicknesses[k],
                                WIDTH * HEIGHT - right);
                assert_int_equal(right, WIDTH * HEIGHT);
                free(seen);
            }
}

/* The light stands behind: nothing of it reaches the front. */
static void no_light_comes_through_an_opaque_slab(void **state)
{
    const float black[3] = { 0.0f, 0.0f, 0.0f };

    for (int s = 0; s < 3; s++)
        for (int k = 0; k < THICKNESSES; k++)
            for (int i = 0; i < 2; i++) {
                float *seen = sample_through(*state, slabs[s], i, i + thicknesses[k],
                                             "pigment { color rgb 1 } finish { ambient 0 diffuse 1 phong 1 reflection 0 }");
                assert_int_equal(limits_count_colour(seen, WIDTH, HEIGHT, black, 0.0f), WIDTH * HEIGHT);
                free(seen);
            }
}

/* A stack of opaque and transparent sheets, 1e-15 apart at 1: each ray meets all in their order. */
static void sheets_a_few_units_apart_keep_their_order(void **state)
{
    static const char *const layers[] = { "box { <-8,-8,%.17g>, <8,8,%.17g>",
                                          "cylinder { <0,0,%.17g>, <0,0,%.17g>, 8" };
    const float wanted[3] = { 0.125f, 0.0f, 0.0f };

    for (int k = 0; k < THICKNESSES; k++) {
        const double h = thicknesses[k];
        char first[256], second[256], text[2048];
        float *seen;

        sprintf(first, layers[0], 1.0 + h, 1.0 + 2.0 * h);
        sprintf(second, layers[1], 1.0 + 3.0 * h, 1.0 + 4.0 * h);
        sprintf(text,
                "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 8 } background { color rgb 1 }\n"
                "camera { location <0.5,0.25,-5> look_at <0,0,1> angle 50 right <1.3333333,0,0> }\n"
                "box { <-9,-9,%.17g>, <9,9,7> pigment { color rgb <0,1,0> } finish { ambient 1 diffuse 0 } }\n"
                "%s pigment { color rgb <0.5,0,0> } finish { ambient 1 diffuse 0 } }\n"
                "%s pigment { color rgbf <1,1,1,0.5> } finish { ambient 0 diffuse 0 } }\n",
                1.0 + 5.0 * h, second, first);
        seen = limits_picture(*state, text, &limits_home, WIDTH, HEIGHT);
        assert_int_equal(limits_count_colour(seen, WIDTH, HEIGHT, wanted, 1e-6f), WIDTH * HEIGHT);
        free(seen);
    }
}

/* ---- contact shadows ---- */

/* The eye is in the gap between a lit floor and what stands h above it: below that all is dark, beside it all is lit. */
static void see_gap(void *context, const char *floor, const char *occluder, double h)
{
    char text[1024], above[256];
    pov_scene *scene;

    sprintf(above, occluder, h, h, h, h);
    sprintf(text,
            "#version 3.7; global_settings { assumed_gamma 1 } light_source { <0.1,100,-0.05> color rgb 1 }\n"
            "%s pigment { color rgb 1 } finish { ambient 0 diffuse 1 } }\n"
            "%s pigment { color rgb 1 } finish { ambient 0 diffuse 1 } }\n", floor, above);
    scene = limits_scene(context, text, &limits_home, NULL);
    for (int i = 0; i < 400; i++) {
        const double x = -1.9 + 0.2 * (i % 20) + 0.013, z = -1.9 + 0.2 * (i / 20) - 0.017;
        const bool covered = fabs(x) < 1.0 && fabs(z) < 1.0;
        float c[4];

        limits_trace(scene, pov_vec3_of(x, 0.5 * h, z), pov_vec3_of(0.3, -1.0, 0.2), c);
        if (covered)
            assert_true(c[0] == 0.0f);
        else
            assert_near(c[0], 1.0, 0.001);
    }
    pov_scene_destroy(scene);
}

static void a_contact_shadow_has_no_gap(void **state)
{
    static const char *const floors[] = {
        "box { <-5,-1,-5>, <5,0,5>",
        "polygon { 4, <-5,0,-5>, <5,0,-5>, <5,0,5>, <-5,0,5>",
        "quadric { <0,0,0>, <0,0,0>, <0,1,0>, 0",
        "cylinder { <0,-1,0>, <0,0,0>, 8",
        "box { <-5,-1,-5>, <5,0,5> rotate <0,30,0>",
    };
    static const char *const occluders[] = {
        "box { <-1,%.17g,-1>, <1,1,1>",
        "polygon { 4, <-1,%.17g,-1>, <1,%.17g,-1>, <1,%.17g,1>, <-1,%.17g,1>",
        "box { <-1,0,-1>, <1,1,1> translate <0,%.17g,0>",
    };

    for (size_t f = 0; f < sizeof floors / sizeof *floors; f++)
        for (size_t o = 0; o < sizeof occluders / sizeof *occluders; o++)
            for (int k = 0; k < THICKNESSES; k++)
                see_gap(*state, floors[f], occluders[o], thicknesses[k]);
}

/* From afar, through a pane that lies h above the floor: seen and lit through all of its faces. */
static long filter(void *context, const char *floor, const char *pane, double h, float factor)
{
    char text[1024], with[1536], above[256];
    const double low = 1.0 + h, high = low + h;
    float *bare, *tinted;
    long off = 0;

    sprintf(above, pane, low, high, low, high);
    sprintf(text,
            "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 8 }\n"
            "camera { location <0.5,7,-5> look_at <0.25,0,0.125> angle 50 right <1.3333333,0,0> }\n"
            "light_source { <30,100,-20> color rgb 1 }\n"
            "%s pigment { color rgb 1 } finish { ambient 0 diffuse 1 } }\n", floor);
    sprintf(with, "%s %s pigment { color rgbf <1,1,1,0.5> } finish { ambient 0 diffuse 0 } }\n", text, above);
    bare = limits_picture(context, text, &limits_home, WIDTH, HEIGHT);
    tinted = limits_picture(context, with, &limits_home, WIDTH, HEIGHT);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        off += !(fabsf(tinted[4 * i] * factor - bare[4 * i]) <= 1e-5f) || bare[4 * i] == 0.0f;
    if (off)
        print_error("%s... and %s...: %g: %ld pixels wrong\n", floor, pane, h, off);
    free(bare);
    free(tinted);
    return off;
}

static void a_pane_above_a_floor_filters_its_light_twice(void **state)
{
    static const char *const floors[] = {
        "box { <-50,0,-50>, <50,1,50>",
        "polygon { 4, <-50,1,-50>, <50,1,-50>, <50,1,50>, <-50,1,50>",
        "quadric { <0,0,0>, <0,0,0>, <0,1,0>, -1",
        "cylinder { <0,0,0>, <0,1,0>, 80",
    };
    static const struct { const char *text; float factor; } panes[] = {
        { "box { <-40,%.17g,-40>, <40,%.17g,40>", 16.0f },
        { "cylinder { <0,%.17g,0>, <0,%.17g,0>, 60", 16.0f },
        { "cone { <0,%.17g,0>, 60, <0,%.17g,0>, 40", 16.0f },
        { "polygon { 4, <-40,%1$.17g,-40>, <40,%1$.17g,-40>, <40,%1$.17g,40>, <-40,%1$.17g,40>", 4.0f },
    };
    long broken = 0;

    for (size_t f = 0; f < sizeof floors / sizeof *floors; f++)
        for (size_t p = 0; p < sizeof panes / sizeof *panes; p++)
            for (int k = 0; k < THICKNESSES; k++)
                broken += filter(*state, floors[f], panes[p].text, thicknesses[k], panes[p].factor);
    assert_int_equal(broken, 0);
}

/* ---- a planet ---- */

/* Radius 1e10, a pebble of 1e-3 on it, an eye a tenth above the ground. The ground is lit all over but in the pebble's
 * shadow, and as many pixels are pebble as on a floor. */
static void a_pebble_lies_on_a_planet(void **state)
{
    const char *scene =
        "#version 3.7; global_settings { assumed_gamma 1 } background { color rgb <0,0,1> }\n"
        "camera { location <0,0.0625,-0.0625> look_at <0,0,0> angle 8 right <1.3333333,0,0> }\n"
        "light_source { <1e6,1e6,0> color rgb 1 }\n"
        "sphere { <0,0.001,0>, 0.001 pigment { color rgb <1,0,0> } finish { ambient 1 diffuse 0 } }\n"
        "%s pigment { color rgb <0,1,0> } finish { ambient 0 diffuse 1 } }\n";
    char planet[1024], flat[1024];
    float *a, *b;
    const float red[3] = { 1.0f, 0.0f, 0.0f }, black[3] = { 0.0f, 0.0f, 0.0f };
    float green[3] = { 0.0f, 0.70710678f, 0.0f };
    long pebble, shadow, ground;

    sprintf(planet, scene, "sphere { <0,-1e10,0>, 1e10");
    sprintf(flat, scene, "box { <-1e3,-1,-1e3>, <1e3,0,1e3>");
    a = limits_picture(*state, planet, &limits_home, 2 * WIDTH, 2 * HEIGHT);
    b = limits_picture(*state, flat, &limits_home, 2 * WIDTH, 2 * HEIGHT);
    pebble = limits_count_colour(a, 2 * WIDTH, 2 * HEIGHT, red, 0.0f);
    shadow = limits_count_colour(a, 2 * WIDTH, 2 * HEIGHT, black, 0.0f);
    ground = limits_count_colour(a, 2 * WIDTH, 2 * HEIGHT, green, 1e-4f);
    assert_true(pebble > 300 && shadow > 100);
    assert_int_equal(pebble + shadow + ground, 4 * WIDTH * HEIGHT);
    assert_int_equal(pebble, limits_count_colour(b, 2 * WIDTH, 2 * HEIGHT, red, 0.0f));
    assert_true(labs(shadow - limits_count_colour(b, 2 * WIDTH, 2 * HEIGHT, black, 0.0f)) <= 2);
    free(a);
    free(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_faces_of_a_transparent_slab_count),
        cmocka_unit_test(no_light_comes_through_an_opaque_slab),
        cmocka_unit_test(sheets_a_few_units_apart_keep_their_order),
        cmocka_unit_test(a_contact_shadow_has_no_gap),
        cmocka_unit_test(a_pane_above_a_floor_filters_its_light_twice),
        cmocka_unit_test(a_pebble_lies_on_a_planet),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
