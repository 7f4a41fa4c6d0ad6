/* uv_mapping of an object is that of the patterns of its texture, whichever way the texture is given. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 32, HEIGHT = 24, VALUES = 4 * WIDTH * HEIGHT };

#define CHECKS "checker rgb 1 rgb <.8, .1, .1> scale .1"
#define STRIPES "gradient x color_map { [.5 rgbt 1] [.5 rgbt <.2, .3, .9, .4>] } scale .25"

static float *draw(const char *look)
{
    char text[1024];

    snprintf(text, sizeof text, "#version 3.7; camera { location <0, 0, -3> look_at 0 } light_source { <5, 8, -6> rgb 1 }\n"
             "sphere { 0, 1 %s rotate 20*x }\n", look);
    return scenes_draw(text, WIDTH, HEIGHT, 0, 0);
}

static bool are_alike(const char *one, const char *other)
{
    float *a = draw(one), *b = draw(other);
    const bool alike = memcmp(a, b, VALUES * sizeof *a) == 0;

    free(a);
    free(b);
    return alike;
}

static const char upon_pigment[] = "pigment { uv_mapping " CHECKS " }";

static void it_counts_for_a_pigment_a_texture_and_a_material(void **state)
{
    (void)state;
    assert_false(are_alike("pigment { " CHECKS " }", upon_pigment));
    assert_true(are_alike("uv_mapping pigment { " CHECKS " }", upon_pigment));
    assert_true(are_alike("uv_mapping texture { pigment { " CHECKS " } }", upon_pigment));
    assert_true(are_alike("uv_mapping material { texture { pigment { " CHECKS " } } }", upon_pigment));
}

static void it_counts_for_a_pigment_that_a_pattern_asks(void **state)
{
    static const char outside[] = "pigment { uv_mapping pigment_pattern { " CHECKS " } color_map { [0 rgb x] [1 rgb y] } }";

    (void)state;
    assert_true(are_alike("pigment { pigment_pattern { uv_mapping " CHECKS " } color_map { [0 rgb x] [1 rgb y] } }", outside));
    assert_true(are_alike("pigment { pigment_pattern { average pigment_map { [1 uv_mapping " CHECKS "] } } color_map { [0 rgb x] [1 rgb y] } }", outside));
}

static void it_counts_for_every_layer(void **state)
{
    (void)state;
    assert_true(are_alike("uv_mapping texture { pigment { " CHECKS " } } texture { pigment { " STRIPES " } }",
                          "texture { pigment { uv_mapping " CHECKS " } } texture { pigment { uv_mapping " STRIPES " } }"));
}

/* Against POV-Ray 3.7: what the gradient is at (.3, .2). */
static void it_counts_for_all_that_is_in_an_object(void **state)
{
    static const struct { const char *text; double value; } seen[] = {
        { "union { object { P texture { T } } uv_mapping }", 0.59994 },
        { "union { object { P texture { T } scale 1.1 } uv_mapping }", 0.59031 },
        { "union { object { P texture { T } } uv_mapping scale 1.1 }", 0.59031 },
        { "union { object { P uv_mapping scale 1.1 } texture { T } }", 0.59934 },
        { "union { object { P uv_mapping texture { T } } scale 1.1 }", 0.59934 },
        { "intersection { object { P uv_mapping } sphere { 0, 3 } texture { T } scale 1.1 }", 0.59031 },
        { "merge { union { object { P texture { T } scale 1.1 } } uv_mapping texture { S } }", 0.59031 },
        { "union { object { P texture { T } interior_texture { S } scale 1.1 } uv_mapping }", 0.53410 },
        { "difference { object { P texture { T } scale 1.1 } sphere { 0, .2 } uv_mapping cutaway_textures }", 0.59031 },
        { "object { M uv_mapping }", 0.67124 },
        { "object { M uv_mapping scale 1.1 }", 0.66818 },
        { "object { M scale 1.1 uv_mapping }", 0.65289 },
        { "union { object { M } uv_mapping scale 1.1 }", 0.65289 },
        { "blob { threshold .5 sphere { <.5, 0, .5>, 1, 1.5 } sphere { -2*x, 1, 1.5 texture { S } } uv_mapping texture { T } "
          "scale 1.1 }", 0.53750 },
        { "blob { threshold .5 sphere { <.5, 0, .5>, 1, 1.5 texture { T } scale 1.2 } sphere { -2*x, 1, 1.5 } uv_mapping "
          "texture { S } scale 1.1 }", 0.52840 },
    };

    (void)state;
    for (size_t i = 0; i < sizeof seen / sizeof seen[0]; i++) {
        char text[1024];
        float *p;

        snprintf(text, sizeof text, "#version 3.7; camera { orthographic location <.3, .2, -10> direction z right .001*x up .001*y } "
                 "#declare T = texture { pigment { gradient x scale 8 translate -4 } finish { ambient 1 diffuse 0 } } "
                 "#declare S = texture { pigment { rgb 1 } } #declare P = sphere { 0, 1 } "
                 "#declare M = mesh { triangle { <-1, -1, 0>, <1, -1, 0>, <1, 1, 0> uv_vectors <.2, .3>, <2, .3>, <2, 3> texture { T } } } %s",
                 seen[i].text);
        p = scenes_draw(text, 1, 1, 1, 1);
        if (fabs((double)p[0] - seen[i].value) > 2e-5)
            fail_msg("%s: %f, not %f", seen[i].text, (double)p[0], seen[i].value);
        free(p);
    }
}

/* Of a mesh with textures of faces too; against POV-Ray 3.7. */
static void an_interior_texture_stays_where_what_is_before_it_moved_the_mesh(void **state)
{
    static const char text[] = "#version 3.7; camera { orthographic location <.3, .2, -10> direction z right .001*x up .001*y } "
        "mesh { triangle { <-1, -1, 0>, <1, -1, 0>, <1, 1, 0> } triangle { x, 2*x, 2*x + y texture { pigment { rgb 1 } } } scale 1.1 "
        "texture { pigment { rgb 1 } } interior_texture { pigment { gradient x scale 8 translate -4 } finish { ambient 1 diffuse 0 } } "
        "scale 1.2 rotate 180*x }";
    float *p = scenes_draw(text, 1, 1, 1, 1);

    (void)state;
    assert_true(fabs((double)p[0] - 0.53125) < 2e-5);
    free(p);
}

/* At heights of the axis, against POV-Ray 3.7; 2 stands for no hit. */
static void v_of_an_ovus_is_an_angle_and_a_large_top_is_a_sphere(void **state)
{
    static const struct { const char *shape; double height, v; } seen[] = {
        { ".774, .404", -0.5, 0.22269 }, { ".774, .404", 0.2, 0.49915 }, { ".774, .404", 0.9, 0.82275 },
        { ".3, .5", -0.1, 0.23915 }, { ".3, .5", 0.5, 0.65898 }, { ".3, .9", -0.5, 0.15148 },
        { ".3, .9", 0.3, 0.5 }, { ".3, .9", 1.1, 0.84852 }, { ".3, .9", -0.65, 2.0 }, { ".3, .9", 1.25, 2.0 },
    };

    (void)state;
    for (size_t i = 0; i < sizeof seen / sizeof seen[0]; i++) {
        char text[512];
        float *p;

        snprintf(text, sizeof text, "#version 3.7; camera { orthographic location <0,%f,-10> direction z right .001*x up .001*y } background { rgb 2 } "
                 "ovus { %s pigment { uv_mapping gradient y } finish { ambient 1 diffuse 0 } }", seen[i].height, seen[i].shape);
        p = scenes_draw(text, 1, 1, 1, 1);
        if (fabs((double)p[0] - seen[i].v) > 2e-5)
            fail_msg("ovus { %s } at %f: %f, not %f", seen[i].shape, seen[i].height, (double)p[0], seen[i].v);
        free(p);
    }
}

/* The front of a cube that is turned by a quarter: lit from all sides alike, its picture would be turned by as much. */
static void bumps_do_not_turn_with_the_object(void **state)
{
    enum { SIDE = 16 };
    static const char format[] = "#version 3.7; camera { orthographic location -10*z direction z right 2*x up 2*y }\n"
                                 "light_source { <5e9,8e9,-6e9> rgb 1 } box { -1, 1 pigment { rgb 1 } normal { uv_mapping bumps .7 scale .05 } "
                                 "finish { ambient 0 diffuse .8 } %s }\n";
    char text[512];
    float *straight, *turned;
    double most = 0.0;

    (void)state;
    snprintf(text, sizeof text, format, "");
    straight = scenes_draw(text, SIDE, SIDE, 1, 1);
    snprintf(text, sizeof text, format, "rotate 90*z");
    turned = scenes_draw(text, SIDE, SIDE, 1, 1);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            most = fmax(most, fabs((double)straight[4 * (y * SIDE + x)] - (double)turned[4 * ((SIDE - 1 - x) * SIDE + y)]));
    if (most > 1e-5)
        fail_msg("%g", most);
    free(straight);
    free(turned);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(v_of_an_ovus_is_an_angle_and_a_large_top_is_a_sphere),
        cmocka_unit_test(it_counts_for_a_pigment_a_texture_and_a_material),
        cmocka_unit_test(it_counts_for_a_pigment_that_a_pattern_asks),
        cmocka_unit_test(it_counts_for_every_layer),
        cmocka_unit_test(it_counts_for_all_that_is_in_an_object),
        cmocka_unit_test(an_interior_texture_stays_where_what_is_before_it_moved_the_mesh),
        cmocka_unit_test(bumps_do_not_turn_with_the_object),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
