/* Layers that are alike everywhere are weighed before the first ray: they give what layers of patterns give. */
#include "support/check.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 32, HEIGHT = 24 };

/* The word before and between a pigment's colours: none, or a pattern of equal colours. */
static const char *const constant[2] = { "", "//" }, *const varying[2] = { "checker", "" };

static float *draw(const char *const kind[2], const char *layers[3], const char *more)
{
    char text[2048];
    const int length = snprintf(text, sizeof text,
        "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,1,-4> look_at 0 angle 50 }\n"
        "light_source { <3,5,-4> rgb 1 } light_source { <-4,2,-3> rgb <.2,.3,.4> } background { rgb <.2,.3,.5> }\n"
        "plane { y, -1 pigment { rgb <.5,.4,.3> } finish { reflection .2 } }\n"
        "sphere { 0, 1 texture { pigment { %s rgb <.7,.4,.2>\n%s rgb <.7,.4,.2>\n } %s }\n"
        "texture { pigment { %s rgbf <1,.9,.8,.6>\n%s rgbf <1,.9,.8,.6>\n } %s }\n"
        "texture { pigment { %s rgbt <.2,.9,.8,.5>\n%s rgbt <.2,.9,.8,.5>\n } %s } %s }\n",
        kind[0], kind[1], layers[0], kind[0], kind[1], layers[1], kind[0], kind[1], layers[2], more);

    assert_in_range(length, 1, sizeof text - 1);
    return scenes_draw(text, WIDTH, HEIGHT, 1, 1);
}

static void layers_are_alike(const char *layers[3], const char *more)
{
    float *a = draw(constant, layers, more), *b = draw(varying, layers, more);

    assert_memory_equal(a, b, (size_t)WIDTH * HEIGHT * 4 * sizeof *a);
    free(a);
    free(b);
}

static void constant_layers_give_what_patterns_of_one_colour_give(void **state)
{
    const char *glazed[3] = { "finish { specular .4 diffuse .6 }", "finish { phong .7 reflection .1 brilliance 2 }", "" };
    (void)state;

    layers_are_alike(glazed, "");
    layers_are_alike(glazed, "double_illuminate");
    layers_are_alike(glazed, "interior { ior 1.4 }");
}

static void what_depends_on_the_angle_is_weighed_at_each_hit(void **state)
{
    const char *angular[3] = { "finish { phong .3 metallic }", "finish { reflection { .1 .8 falloff 2 } conserve_energy }",
                               "finish { irid { .3 thickness .2 } reflection .1 }" };
    (void)state;

    layers_are_alike(angular, "");
    layers_are_alike(angular, "interior { ior 1.4 fade_distance .5 fade_power 1 }");
}

/* Nothing is left for what lies below an opaque layer, nor for the ray through it. */
static void layers_below_an_opaque_one_are_hidden(void **state)
{
    float *covered, *alone;
    (void)state;

    covered = scenes_draw("#version 3.7; global_settings { assumed_gamma 1 } light_source { <3,5,-4> rgb 1 }\n"
                          "sphere { 4*z, 1 texture { pigment { rgb <1,0,0> } finish { emission 1 reflection 1 } }\n"
                          "texture { pigment { rgb <.2,.4,.6> } finish { phong .5 } } }", WIDTH, HEIGHT, 1, 1);
    alone = scenes_draw("#version 3.7; global_settings { assumed_gamma 1 } light_source { <3,5,-4> rgb 1 }\n"
                        "sphere { 4*z, 1 texture { pigment { rgb <.2,.4,.6> } finish { phong .5 } } }", WIDTH, HEIGHT, 1, 1);
    assert_memory_equal(covered, alone, (size_t)WIDTH * HEIGHT * 4 * sizeof *alone);
    free(covered);
    free(alone);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constant_layers_give_what_patterns_of_one_colour_give),
        cmocka_unit_test(what_depends_on_the_angle_is_weighed_at_each_hit),
        cmocka_unit_test(layers_below_an_opaque_one_are_hidden),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
