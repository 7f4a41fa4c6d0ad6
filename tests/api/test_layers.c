/* Layers that are alike everywhere are weighed before the first ray: they give what layers of patterns give. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
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

/* With a light of area_illumination, though it is dark, each layer is lit as a surface of its own. */
static void layers_are_lit_alike(const char *layers[3], const char *more)
{
    char also[1024];
    float *together[2], *apart[2];

    snprintf(also, sizeof also, "%s } light_source { 5*y rgb 0 area_light x, z, 2, 2 area_illumination ", more);
    together[0] = draw(constant, layers, more);
    together[1] = draw(varying, layers, more);
    apart[0] = draw(constant, layers, also);
    apart[1] = draw(varying, layers, also);
    for (int i = 0; i < 2; i++) {
        assert_memory_equal(together[i], apart[i], (size_t)WIDTH * HEIGHT * 4 * sizeof *apart[i]);
        free(together[i]);
        free(apart[i]);
    }
}

static void layers_of_one_hit_are_lit_together(void **state)
{
    static const char *const more[] = {
        "", "double_illuminate", "interior { ior 1.4 dispersion 1.1 }", "interior { ior 1.4 } scale <1, .9, -1>",
        "} sphere { <1, 0, -1>, .3 texture { pigment { rgbt <1, .5, .2, .3> } } texture { pigment { rgbt .8 } finish { specular 1 } }",
        "} light_source { <2, 9, 1> rgb .3 area_light x, z, 4, 4 } light_source { <9, 1, 1> rgb .3 shadowless",
        "} box { <-1.5, -1, -1>, <-.9, .2, -.5> pigment { bozo } normal { bumps } } sphere { <1, -.5, -1>, .4 pigment { rgb .5 }",
        ("} smooth_triangle { <-1, 0, -1.5>, <-1, 0, -1>, <1, 0, -1.5>, <1, 0, -1>, <0, 1, -1.5>, <0, 1, -1>\n"
         "texture { pigment { rgb .5 } finish { phong .5 } } texture { pigment { rgbt <1, 0, 0, .5> } finish { reflection .3 } }"),
    };
    const char *glazed[3] = { "finish { specular .4 diffuse .6 }", "finish { phong .7 reflection .1 brilliance 2 }", "" };
    const char *mirrors[3] = { "finish { reflection .2 }", "finish { reflection .1 metallic }", "finish { reflection .1 diffuse .3 }" };
    const char *unlit[3] = { "finish { phong .5 }", "finish { diffuse 0 ambient .3 }", "finish { crand .1 }" };
    const char *powered[3] = { "finish { phong 1 metallic }", "finish { reflection .2 reflection_exponent 2 }", "finish { crand .1 }" };
    (void)state;

    for (size_t i = 0; i < sizeof more / sizeof more[0]; i++) {
        layers_are_lit_alike(glazed, more[i]);
        layers_are_lit_alike(mirrors, more[i]);
        layers_are_lit_alike(unlit, more[i]);
        layers_are_lit_alike(powered, more[i]);
    }
}

/* Layers of one material, some of them hidden here and there, or only nearly. more: of the sphere; light: what else shines. */
static float *draw_varied(const char *version, const char *finish, const char *more, const char *light)
{
    char text[2048];
    const int length = snprintf(text, sizeof text,
        "#version %s; global_settings { assumed_gamma 1 ambient_light <1,.8,.9> } camera { location <0,1,-4> look_at 0 angle 50 }\n"
        "light_source { <3,5,-4> rgb 1 } light_source { <-4,2,-3> rgb <.2,.3,.4> } %s\n"
        "sphere { 0, 1 texture { pigment { checker rgb <.9,.8,.1> rgb <.2,.9,.4> scale .3 } finish { emission .2 diffuse .7 } }\n"
        "texture { pigment { bozo color_map { [0 rgbt <.7,.4,.2,.3>] [1 rgbf <.2,.3,.9,.2>] } scale .2 } %s }\n"
        "texture { pigment { wood color_map { [.3 rgbf <.01,.01,.02,.5>] [.4 rgbt <1,.9,.2,.7>] [.8 rgb <0,1,0>] } scale .4 } %s }\n"
        "texture { pigment { gradient x color_map { [.2 rgbft <.6,.9,.8,.6,.2>] [.5 rgb <.2,.9,.8>] [.5 rgbt 1] } scale .5 } finish { diffuse .7 emission .1 specular .2 } } %s }\n",
        version, light, finish, finish, more);

    assert_in_range(length, 1, sizeof text - 1);
    return scenes_draw(text, WIDTH, HEIGHT, 1, 1);
}

static void varied_pigments_are_lit_alike(const char *version, const char *finish, const char *more)
{
    float *together = draw_varied(version, finish, more, "");
    float *apart = draw_varied(version, finish, more, "light_source { 5*y rgb 0 area_light x, z, 2, 2 area_illumination }");

    if (memcmp(together, apart, (size_t)WIDTH * HEIGHT * 4 * sizeof *apart) != 0)
        fail_msg("%s: %s %s", version, finish, more);
    free(together);
    free(apart);
}

static void layers_of_varied_pigments_are_lit_together(void **state)
{
    static const char *const finishes[] = {
        "finish { specular .4 roughness .013 ambient .2 }", "finish { phong .7 phong_size 40 brilliance 2 }", "finish { phong .7 phong_size 33.3 }",
        "finish { diffuse 0 ambient .3 }", "finish { diffuse 0 phong 1 }", "finish { crand .1 }", "finish { metallic phong 1 }",
        "finish { irid { .3 thickness .2 } }", "finish { reflection .1 }", "normal { bumps .6 scale .2 } finish { phong .4 }", "finish { diffuse .6, .4 }",
    };
    static const char *const more[] = {
        "", "double_illuminate", "interior { ior 1.4 fade_distance .5 fade_power 1 }", "clipped_by { plane { -x, .5 } }",
        "double_illuminate clipped_by { plane { -x, .5 } }",
    };
    (void)state;

    for (size_t i = 0; i < sizeof finishes / sizeof finishes[0]; i++)
        for (size_t k = 0; k < sizeof more / sizeof more[0]; k++) {
            varied_pigments_are_lit_alike("3.7", finishes[i], more[k]);
            varied_pigments_are_lit_alike("3.1", finishes[i], more[k]);
        }
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

/* The camera is in glass below a surface that reflects totally; below it are a filter and a light floor. */
static double seen_from_below(const char *bailout, const char *texture)
{
    char text[1024];
    float *picture, seen;

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 9 adc_bailout %s }\n"
             "#default { finish { ambient 0 diffuse 0 } } camera { location -y look_at 2*x angle 1 }\n"
             "plane { y, -5 pigment { rgb 1 } finish { ambient 1 } }\n"
             "disc { -3*y, y, 99 pigment { rgbt <1, 1, 1, .9> } interior { ior 1.5 } }\n"
             "plane { y, 0 %s interior { ior 1.5 } }\n", bailout, texture);
    picture = scenes_draw(text, 1, 1, 1, 1);
    seen = picture[0];
    free(picture);
    return (double)seen;
}

/* As measured: a ray that is totally reflected keeps its colour, but the filters that it does not cross count in its weight. */
static void total_reflection_weighs_as_much_as_what_would_go_through(void **state)
{
    static const char two[] = "texture { pigment { rgbt <1, 1, 1, .7> } finish { reflection .4 conserve_energy } } texture { pigment { rgbt <1, 1, 1, .8> } }";
    static const char *const one[] = { "pigment { rgbt <1, 1, 1, .8> }", "pigment { checker rgbt <1, 1, 1, .8> rgbt <1, 1, 1, .8> }" };
    (void)state;

    for (int i = 0; i < 2; i++) {
        assert_true(fabs(seen_from_below(".71", one[i]) - 0.9) < 1e-6);
        assert_true(seen_from_below(".73", one[i]) == 0.0);
    }
    assert_true(fabs(seen_from_below(".3", two) - 0.9) < 1e-6);
    assert_true(seen_from_below(".31", two) == 0.0);
}

/* As measured: of layers the upper one's film is seen in total reflection. */
static void the_upper_film_is_seen_in_total_reflection(void **state)
{
    static const char plain[] = "texture { pigment { rgbt <1, 1, 1, .7> } }", film[] = "texture { pigment { rgbt <1, 1, 1, .7> } finish { irid { .4 thickness .3 } } }";
    char above[256], below[256];
    (void)state;

    snprintf(above, sizeof above, "%s %s", plain, film);
    snprintf(below, sizeof below, "%s %s", film, plain);
    assert_true(fabs(seen_from_below("0", film) - 0.9 * 0.6965) < 0.02);
    assert_true(seen_from_below("0", above) == seen_from_below("0", film));
    assert_true(fabs(seen_from_below("0", below) - 0.9) < 1e-6);
}

/* As measured: total reflection takes the place of the mirrors that have its normal, and of no others. */
static void mirrors_with_other_normals_stay_beside_total_reflection(void **state)
{
    static const char plain[] = "texture { pigment { rgbt <1, 1, 1, .7> } }", mirror[] = "texture { pigment { rgbt <1, 1, 1, .7> } finish { reflection .25 } }";
    static const char bent[] = "texture { pigment { rgbt <1, 1, 1, .7> } normal { bumps .001 } }";
    char like[256], unlike[256];
    (void)state;

    snprintf(like, sizeof like, "%s %s", mirror, plain);
    snprintf(unlike, sizeof unlike, "%s %s", mirror, bent);
    assert_true(fabs(seen_from_below("0", like) - 0.9) < 1e-6);
    assert_true(fabs(seen_from_below("0", unlike) - 0.9 * 1.25) < 1e-6);
}

/* A mirror below a layer, and what is behind the camera: nothing but light. */
static double mirrored(const char *bailout, const char *upper)
{
    char text[1024];
    float *picture, seen;

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 adc_bailout %s } #default { finish { ambient 0 diffuse 0 } }\n"
             "camera { location -5*z look_at 0 angle 1 } plane { z, -9 pigment { rgb 1 } finish { ambient 1 } }\n"
             "plane { z, 0 texture { pigment { rgb .5 } finish { reflection .2 } } texture { pigment { %s } } }\n", bailout, upper);
    picture = scenes_draw(text, 1, 1, 1, 1);
    seen = picture[0];
    free(picture);
    return (double)seen;
}

/* As measured: layers take from the weight of what those below them reflect, but never add to it. */
static void layers_that_brighten_add_no_weight(void **state)
{
    (void)state;
    assert_true(mirrored(".11", "rgbt <1, 1, 1, .5>") == 0.0 && fabs(mirrored(".09", "rgbt <1, 1, 1, .5>") - 0.2) < 1e-6);
    assert_true(mirrored(".21", "rgbft <1, 1, 1, .9, .8>") == 0.0 && fabs(mirrored(".19", "rgbft <1, 1, 1, .9, .8>") - 0.2) < 1e-6);
    assert_true(mirrored(".21", "rgbft <1, 1, 1, .9, .8> } } texture { pigment { rgbt 1.5") == 0.0);
}

/* As measured: what a layer can reflect at any angle counts in the weight, before metal and films dye it, as for one layer. */
static void layers_weigh_what_they_can_reflect(void **state)
{
    static const char veil[] = "rgbt .5 } finish { reflection { .2, .8 }";
    static const char film[] = "rgbt .5 } finish { reflection .4 irid { .9 thickness .35 }";
    (void)state;

    assert_true(fabs(mirrored(".79", veil) - 0.2) < 1e-6 && mirrored(".81", veil) == 0.0);
    assert_true(mirrored(".39", film) > 0.0 && mirrored(".41", film) == 0.0);
}

static void assert_film(double bumps, const double reds[10])
{
    char text[1024];
    float *picture;

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 }\n"
             "camera { location <0,3,-6> look_at 0 angle 30 } background { rgb 1 }\n"
             "plane { y,-1 pigment { rgb 0 } normal { bumps %g scale .2 }\n"
             "finish { ambient 0 diffuse 0 reflection .5 irid { .9 thickness .55 turbulence 0 } } }\n", bumps);
    picture = scenes_draw(text, 10, 8, 1, 1);
    for (int x = 0; x < 10; x++)
        if (fabs((double)picture[4 * (4 * 10 + x)] - reds[x]) > 0.006)
            fail_msg("bumps %g: pixel %d is %f", bumps, x, (double)picture[4 * (4 * 10 + x)]);
    free(picture);
}

/* As measured: where a bent normal would mirror a ray into the surface, or does not face it, a film is as thick as the ray
 * finds it that goes another way. */
static void films_are_as_thick_as_the_mirrored_ray_finds_them(void **state)
{
    static const double reds[] = { 0.617, 0.084, 0.584, 0.098, 0.913, 0.102, 0.753, 0.051, 0.270, 0.479 };
    static const double steep[] = { 0.286, 0.918, 0.494, 0.949, 0.871, 0.949, 0.937, 0.447, 0.082, 0.925 };
    (void)state;

    assert_film(0.6, reds);
    assert_film(6.0, steep);
}

static float *glass(const char *upper, const char *lower)
{
    char text[1024];

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 } #default { finish { ambient 0 diffuse 0 } }\n"
             "camera { location <0, 1, -4> look_at 0 angle 40 } plane { y, -1 pigment { checker rgb 1 rgb .2 } finish { ambient 1 } }\n"
             "box { -1, 1 texture { pigment { rgbt <1, 1, 1, .8> } %s } texture { pigment { rgbf <1, 1, .5, .9> } %s }\n"
             "interior { ior 1.8 } rotate <20, 30, 10> }\n", lower, upper);
    return scenes_draw(text, WIDTH, HEIGHT, 1, 1);
}

/* As measured: of layers the upper one's normal bends what goes through. */
static void the_upper_normal_bends_what_goes_through(void **state)
{
    static const char bumps[] = "normal { bumps .4 scale .3 }";
    float *both = glass(bumps, bumps), *upper = glass(bumps, ""), *lower = glass("", bumps), *none = glass("", "");
    const size_t bytes = sizeof(float[4]) * WIDTH * HEIGHT;
    (void)state;

    assert_memory_equal(both, upper, bytes);
    assert_memory_equal(none, lower, bytes);
    assert_memory_not_equal(both, none, bytes);
    free(both);
    free(upper);
    free(lower);
    free(none);
}

/* What is seen of a light wall through a sheet, in a scene before version 3.1. */
static double seen_through(const char *texture)
{
    char text[1024];
    float *picture, seen;

    snprintf(text, sizeof text, "#version 3.0; global_settings { assumed_gamma 1 } camera { direction z }\n"
             "#default { finish { ambient 0 diffuse 0 } } plane { z, 5 pigment { color rgb 1 } finish { ambient 1 } }\n"
             "disc { z, z, 9 texture { %s } }\n", texture);
    picture = scenes_draw(text, 1, 1, 1, 1);
    seen = picture[0];
    free(picture);
    return (double)seen;
}

/* As measured: the `refraction` of old scenes is that of an object's upper texture, and a factor of what the whole lets through. */
static void the_upper_refraction_is_that_of_all_layers(void **state)
{
    static const char clear[] = "pigment { color rgbt <1, 1, 1, .8> }";
    static const struct { const char *lower, *upper; double seen; } cases[] = {
        { "finish { refraction .5 }", "", .64 }, { "", "finish { refraction .5 }", .32 },
        { "finish { refraction .25 }", "finish { refraction .5 }", .32 },
    };
    char text[512];
    (void)state;

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        snprintf(text, sizeof text, "%s %s } texture { %s %s", clear, cases[i].lower, clear, cases[i].upper);
        assert_true(fabs(seen_through(text) - cases[i].seen) < 1e-6);
    }
    snprintf(text, sizeof text, "%s finish { refraction .5 }", clear);
    assert_true(fabs(seen_through(text) - .4) < 1e-6);
    snprintf(text, sizeof text, "gradient z texture_map { [0 %s finish { refraction .5 }] [1 %s] }", clear, clear);
    assert_true(fabs(seen_through(text) - .8) < 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constant_layers_give_what_patterns_of_one_colour_give),
        cmocka_unit_test(what_depends_on_the_angle_is_weighed_at_each_hit),
        cmocka_unit_test(layers_of_one_hit_are_lit_together),
        cmocka_unit_test(layers_of_varied_pigments_are_lit_together),
        cmocka_unit_test(layers_below_an_opaque_one_are_hidden),
        cmocka_unit_test(total_reflection_weighs_as_much_as_what_would_go_through),
        cmocka_unit_test(the_upper_normal_bends_what_goes_through),
        cmocka_unit_test(layers_that_brighten_add_no_weight),
        cmocka_unit_test(layers_weigh_what_they_can_reflect),
        cmocka_unit_test(mirrors_with_other_normals_stay_beside_total_reflection),
        cmocka_unit_test(films_are_as_thick_as_the_mirrored_ray_finds_them),
        cmocka_unit_test(the_upper_film_is_seen_in_total_reflection),
        cmocka_unit_test(the_upper_refraction_is_that_of_all_layers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
