/* Layers and shares of matt textures are lit as one surface, and colours of one finish by lane: they look as they do one by one. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/trace.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ACROSS = 24, COUNT = ACROSS * ACROSS, TEXT = 2000, LAYERED = 3 };

/* A highlight that is too weak to be seen keeps the terms apart. */
static const char format[] =
    "#version %s; #declare F = finish { ambient .2 diffuse .5 emission .1 %s }\n"
    "camera { location <0, 0, -4> look_at 0 } light_source { <5, 9, -7> rgb <1, .8, .5> } light_source { <-5, 1, -9> rgb .3 }\n"
    "sphere { <0, 0, 3>, 1.5 pigment { checker rgb 1 rgb .2 } }\n"
    "sphere { 0, 1 %s }\n";

/* Layers come first. */
static const char *const textures[] = {
    "texture { pigment { granite color_map { [0 rgb 1] [1 rgb .3] } } finish { F } }"
    " texture { pigment { checker rgbt <1, .2, .1, .4> rgbf <1, .5, .2, .7> scale .3 } finish { F diffuse .9 } }",
    "texture { pigment { rgbft <1, .5, .2, .3, .5> } finish { F } }"
    " texture { pigment { bozo color_map { [0 rgbt <.1, 1, .3, .9>] [1 rgbf <1, .9, .2, .8>] } scale .2 } finish { F } }",
    "texture { pigment { rgb .5 } finish { F } } texture { pigment { checker rgb x rgbt 1 scale .4 } finish { F } }",
    "texture { bozo texture_map { [0 pigment { rgb x } finish { F }] [1 pigment { granite } finish { F ambient .9 }] } }",
    "texture { average texture_map { [1 pigment { rgb x } finish { F }] [3 pigment { rgbt <0, 1, 0, .5> } finish { F }] } }",
};

static float *colours_of(const char *version, const char *finish, const char *texture)
{
    static float rgba[4 * COUNT];
    static pov_vec3 org[COUNT], dir[COUNT];
    const pov_found out = { sizeof out, NULL, NULL, NULL, NULL, rgba, NULL };
    pov_context *context = scenes_context();
    char text[TEXT];
    pov_tracer *tracer;
    pov_scene *scene;

    assert_true(snprintf(text, sizeof text, format, version, finish, texture) < TEXT);
    scene = scenes_text(context, text);
    for (int i = 0; i < COUNT; i++) {
        org[i] = pov_vec3_of(0.0, 0.0, -4.0);
        dir[i] = pov_vec3_of((i % ACROSS) * 0.025 - 0.29, (i / ACROSS) * 0.025 - 0.29, 1.0);
    }
    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    assert_int_equal(pov_trace_many(tracer, COUNT, org, dir, &out, NULL), POV_OK);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return rgba;
}

static void terms_that_are_as_one_look_as_each_does(void **state)
{
    static float apart[4 * COUNT];

    (void)state;
    for (size_t k = 0; k < sizeof textures / sizeof textures[0]; k++) {
        const float *seen;
        float most = 0.0f;

        memcpy(apart, colours_of("3.7", "phong 1e-12", textures[k]), sizeof apart);
        seen = colours_of("3.7", "", textures[k]);
        for (int i = 0; i < 4 * COUNT; i++)
            most = fmaxf(most, fabsf(seen[i] - apart[i]));
        if (most > 2e-6f)
            fail_msg("texture %zu: %g", k, (double)most);
    }
}

/* Members of a list are terms, and each lane has all of one. What filters cover depends on the version. */
static void layers_of_one_texture_have_the_bits_of_terms(void **state)
{
    static const char *const versions[] = { "3.0", "3.7" };
    static float of_terms[4 * COUNT];

    (void)state;
    for (size_t k = 0; k < 2 * LAYERED; k++) {
        const char *const layers = textures[k / 2];
        char list[TEXT];

        assert_true(snprintf(list, sizeof list, "translate -9*z } #declare T = %s sphere { 0, 1 texture { checker texture { T } texture { T } }",
                             layers) < TEXT);
        memcpy(of_terms, colours_of(versions[k % 2], "", list), sizeof of_terms);
        assert_memory_equal(of_terms, colours_of(versions[k % 2], "", layers), sizeof of_terms);
    }
}

/* The same of a texture with a pattern of colours, all of which are lit by lane where light does not go through them. */
static void colours_of_one_finish_have_the_bits_of_terms(void **state)
{
    static const char *const finishes[] = {
        "", "phong .8 phong_size 9", "phong .4 phong_size 9.5", "specular .5", "brilliance 1.5", "phong .5 metallic", "diffuse .4, .3",
        "reflection .3", "reflection { .1, .5 } specular .3", "reflection { .4 metallic }", "irid { .4 thickness .3 turbulence .5 }",
    };
    static const char *const pigments[] = { "bozo scale .2 color_map { [0 rgb <1, .2, .1>] [1 rgb <0, .5, 2>] }",
                                            "bozo scale .2 color_map { [0 rgb <1, .2, .1>] [1 rgbt <0, .5, 2, .5>] }",
                                            "aoi color_map { [.5 rgb <1, .2, .1>] [1 rgb <0, .5, 2>] }" };
    enum { PIGMENTS = sizeof pigments / sizeof pigments[0], EACH = 4 * PIGMENTS };
    static float of_terms[4 * COUNT];

    (void)state;
    for (size_t k = 0; k < EACH * (sizeof finishes / sizeof finishes[0]); k++) {
        const char *const finish = finishes[k / EACH], *const pigment = pigments[k % PIGMENTS];
        const char *const both = k / PIGMENTS & 1 ? "double_illuminate no_shadow" : "", *const normal = k / PIGMENTS & 2 ? "normal { bumps .6 scale .2 }" : "";
        const char *const objects = "translate -9*z } #declare T = texture { pigment { %s } %s finish { F } } #declare U = texture { %s }\n"
                                    "box { <-9, -.7, 0>, 9 texture { U } rotate 60*x no_shadow } box { <-9, -9, 0>, <9, -.7, 9> texture { U } rotate 60*x %s";
        char alone[TEXT], list[TEXT];

        assert_true(snprintf(alone, sizeof alone, objects, pigment, normal, "T", both) < TEXT);
        assert_true(snprintf(list, sizeof list, objects, pigment, normal, "checker texture { T } texture { T }", both) < TEXT);
        memcpy(of_terms, colours_of("3.7", finish, list), sizeof of_terms);
        assert_memory_equal(of_terms, colours_of("3.7", finish, alone), sizeof of_terms);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(terms_that_are_as_one_look_as_each_does),
        cmocka_unit_test(layers_of_one_texture_have_the_bits_of_terms),
        cmocka_unit_test(colours_of_one_finish_have_the_bits_of_terms),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
