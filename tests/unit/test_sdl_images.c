/* Images in scenes: where they are found, what is refused, and how stored numbers become colours. */
#include "support/check.h"

#include "model/image.h"
#include "sdl/reader.h"
#include "texture/texture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

typedef struct bench {
    env env;
    registry *plugins;
    model model;
    pov_error error;
} bench;

/* As a scene of scenes/test, beside whose folder of images it stands. */
static pov_status read_scene_of(bench *b, const char *assumed_gamma, const char *text)
{
    char all[2048];
    pov_error error;

    memset(b, 0, sizeof *b);
    env_init(&b->env, NULL, NULL, NULL);
    b->plugins = registry_create(&b->env, TEST_BUILD "/lib/povtrace", &error);
    assert_non_null(b->plugins);
    model_init(&b->model, &b->env);
    snprintf(all, sizeof all, "#version 3.7; global_settings { assumed_gamma %s } plane { z, 0 %s }", assumed_gamma, text);
    return reader_read(&b->model, b->plugins, all, strlen(all), TEST_ROOT "/scenes/test/of_a_test.pov", NULL, &b->error);
}

static pov_status read_scene(bench *b, const char *text) { return read_scene_of(b, "1", text); }

static void end(bench *b)
{
    model_free(&b->model);
    registry_destroy(b->plugins);
}

static pigment colour_at(const bench *b, double x, double y)
{
    const texture *t = b->model.materials.items[b->model.leaves.items[0].material].texture;
    static texture_points points;
    pigment out;

    assert_non_null(t);
    memset(&points, 0, sizeof points);
    texture_point(&points, 0, pov_vec3_of(x, y, 0.0), pov_vec3_of(0.0, 0.0, 0.0));
    pigment_eval(&b->model, t->pigment, &points, 1, &out);
    return out;
}

static void refuses(const char *text, pov_status status, const char *message)
{
    bench b;

    assert_int_equal(read_scene(&b, text), status);
    if (!strstr(b.error.message, message))
        fail_msg("%s: \"%s\" instead of \"%s\"", text, b.error.message, message);
    assert_true(b.error.line == 1 && b.error.column > 0);
    end(&b);
}

static void a_name_without_a_format_is_that_of_a_png(void **state)
{
    bench b;

    (void)state;
    assert_int_equal(read_scene(&b, "pigment { image_map { \"images/rings\" } }"), POV_OK);
    end(&b);
}

static void what_cannot_be_read_is_refused_with_its_place(void **state)
{
    (void)state;
    refuses("pigment { image_map { png \"images/none.png\" } }", POV_E_IO, "no file \"images/none.png\"");
    refuses("pigment { image_map { png \"images/rings.tga\" } }", POV_E_IO, "does not begin like a PNG");
    refuses("pigment { image_map { sys \"images/rings\" } }", POV_E_UNSUPPORTED, "no image format of its own");
    refuses("pigment { image_map { \"images/none\" } }", POV_E_IO, "no file \"images/none\"");
    refuses("pigment { image_map { iff \"images/rings.png\" } }", POV_E_PLUGIN, "\"iff\"");
    refuses("pigment { image_map { png \"images/rings.png\" map_type 3 } }", POV_E_SYNTAX, "0, 1, 2 or 5");
    refuses("pigment { image_map { png \"images/rings.png\" filter 2, .5 } }", POV_E_SYNTAX, "with a palette");
    refuses("pigment { image_map { png \"images/tiles.png\" filter 6, .5 } }", POV_E_SYNTAX, "entries 0 to 5");
    refuses("pigment { image_map { png \"images/rings.png\" gamma 0 } }", POV_E_SYNTAX, "above 0");
    refuses("texture { material_map { png \"images/tiles.png\" } }", POV_E_SYNTAX, "wants textures");
    refuses("pigment { density_file \"images/blob.df3\" }", POV_E_SYNTAX, "\"df3\"");
    refuses("pigment { density_file df3 \"images/rings.tga\" }", POV_E_IO, "no df3 file");
    refuses("pigment { image_map { function 0, 4 { x } } }", POV_E_SYNTAX, "sides of an image");
    refuses("pigment { image_map { png \"/etc/passwd\" } }", POV_E_IO, "outside of the folders");
}

/* The lower left pixel of rings.png is row 15, column 0: stored (247, 0, 239). */
static void a_name_without_its_ending_is_found_and_decoded(void **state)
{
    bench b;
    pigment p;

    (void)state;
    assert_int_equal(read_scene(&b, "pigment { image_map { tga \"images/rings\" } }"), POV_OK);
    p = colour_at(&b, 0.01, 0.01);
    assert_true(p.color.g == 0.0f && p.color.b > 0.85f && p.color.b < 0.87f && p.filter == 0.0f && p.transmit == 0.0f);
    end(&b);
    assert_int_equal(read_scene(&b, "pigment { image_map { tga \"images/rings\" gamma 1 } }"), POV_OK);
    p = colour_at(&b, 0.01, 0.01);
    assert_float_equal(p.color.b, 239.0 / 255.0, 1e-6);
    end(&b);
}

static void outside_an_image_that_is_there_once_all_is_clear(void **state)
{
    bench b;
    pigment p;

    (void)state;
    assert_int_equal(read_scene(&b, "pigment { image_map { ppm \"images/rings.ppm\" once transmit all .25 } }"), POV_OK);
    p = colour_at(&b, 1.5, 0.5);
    assert_true(p.color.r == 1.0f && p.transmit == 1.0f && p.filter == 0.0f);
    p = colour_at(&b, 0.5, 0.5);
    assert_true(p.transmit == 0.25f);
    end(&b);
}

static void colours_that_are_times_their_alpha_are_divided_by_it(void **state)
{
    bench b;
    pigment p;

    (void)state;
    assert_int_equal(read_scene(&b, "pigment { image_map { function 4, 4 { pigment { rgbt <.25, .2, .1, .5> } } premultiplied on } }"), POV_OK);
    p = colour_at(&b, 0.3, 0.3);
    assert_float_equal(p.color.r, 0.5, 1e-4);
    assert_float_equal(p.color.b, 0.2, 1e-4);
    assert_float_equal(p.transmit, 0.5, 1e-4);
    end(&b);
}

static void entries_of_a_palette_have_their_own_transparency(void **state)
{
    bench b;

    (void)state;
    assert_int_equal(read_scene(&b, "pigment { image_map { png \"images/tiles.png\" filter all .5 transmit 0, .125 } }"), POV_OK);
    /* The upper left pixel is entry 0; entry 2 has alpha 128. */
    assert_true(colour_at(&b, 0.01, 0.99).transmit == 0.125f && colour_at(&b, 0.01, 0.99).filter == 0.5f);
    assert_float_equal(colour_at(&b, 0.01, 0.99 - 4.0 / 16.0).transmit, 1.0 - 128.0 / 255.0, 1e-6);
    end(&b);
}

/* Interpolation gives a pixel's own value at its middle. */
static void between_pixels_every_method_meets_them(void **state)
{
    static const char *const texts[] = { "2", "3", "4" };
    char text[128];
    pigment pixel, p;
    bench b;

    (void)state;
    assert_int_equal(read_scene(&b, "pigment { image_map { ppm \"images/rings.ppm\" } }"), POV_OK);
    pixel = colour_at(&b, 5.5 / 24.0, 1.0 - 6.5 / 16.0);
    end(&b);
    for (int i = 0; i < 3; i++) {
        snprintf(text, sizeof text, "pigment { image_map { ppm \"images/rings.ppm\" interpolate %s } }", texts[i]);
        assert_int_equal(read_scene(&b, text), POV_OK);
        p = colour_at(&b, 5.5 / 24.0, 1.0 - 6.5 / 16.0);
        assert_float_equal(p.color.r, pixel.color.r, 1e-6);
        assert_float_equal(p.color.b, pixel.color.b, 1e-6);
        end(&b);
    }
}

/* The upper row is y = 0; numbers are cut down to 16 bits, and not decoded. */
static void a_function_makes_an_image_of_grey(void **state)
{
    bench b;

    (void)state;
    assert_int_equal(read_scene(&b, "pigment { image_map { function 3, 2 { x / 4 + y / 2 } } }"), POV_OK);
    assert_float_equal(colour_at(&b, 0.5, 0.9).color.r, 8191.0 / 65535.0, 1e-9);
    assert_float_equal(colour_at(&b, 0.9, 0.1).color.g, 49151.0 / 65535.0, 1e-9);
    end(&b);
}

/* As measured: 65535 times the value without its upper bits, and 0 beyond 31 bits. */
static void values_of_functions_beyond_0_and_1_come_round(void **state)
{
    static const struct {
        const char *text;
        double wanted;
    } values[] = {
        { "1", 65535 },    { "1.00001", 65535 }, { "1.0001", 5 },  { "1.25", 16382 }, { "2", 65534 },   { "100.3", 19560 },
        { "-.00001", 0 },  { "-.1", 58983 },     { "-1", 1 },      { "-2.3", 45878 }, { "70000", 0 },   { "-1e10", 0 },
        { "sqrt(-x)", 0 },
    };
    (void)state;

    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        char text[256];
        bench b;

        snprintf(text, sizeof text, "pigment { image_map { function 3, 2 { %s } } }", values[i].text);
        assert_int_equal(read_scene(&b, text), POV_OK);
        assert_float_equal(colour_at(&b, 0.5, 0.5).color.r, values[i].wanted / 65535.0, 1e-9);
        end(&b);
        snprintf(text, sizeof text,
                 "} #declare H = height_field { function 3, 2 { %s } };\n"
                 "#if (abs(trace(H, <.3, 9, .3>, -y).y * 65536 - %g) > .01) #error \"its height\" #end sphere { 0, 1",
                 values[i].text, values[i].wanted);
        if (read_scene(&b, text) != POV_OK)
            fail_msg("%s: %s", values[i].text, b.error.message);
        end(&b);
    }
}

/* .297 + .406 y of <1 - y, y, y>, as measured in POV-Ray. */
static void heights_of_a_pigment_are_its_brightness(void **state)
{
    bench b;

    (void)state;
    assert_int_equal(read_scene(&b, "} #declare H = height_field { function 5, 4 { pigment { gradient y color_map { [0 rgb x] [1 rgb <0, 1, 1>] } } } };\n"
                                    "#if (abs(trace(H, <.3, 9, .4>, -y).y - .54058) > 1e-4) #error \"its height\" #end sphere { 0, 1"), POV_OK);
    end(&b);
    assert_int_equal(read_scene(&b, "} #declare H = height_field { function 3, 3 { pigment { rgb .0874 } } }; #declare I = height_field { function 3, 3 { "
                                    "pigment { rgb .1311 } } };\n#if (abs(trace(H, <.3, 9, .4>, -y).y * 65536 - 5727) + abs(trace(I, <.3, 9, .4>, -y).y * 65536 - 8590) > .01) "
                                    "#error \"its digit\" #end sphere { 0, 1"), POV_OK);
    end(&b);
}

/* As POV-Ray has it; the filter is lost. */
static void a_pigment_makes_an_image_of_its_colours(void **state)
{
    pigment p;
    bench b;

    (void)state;
    assert_int_equal(read_scene(&b, "pigment { image_map { function 2, 2 { pigment { gradient x color_map {"
                                    " [.5 rgb <.25, .5, .75>] [.5 rgbft <1, .5, .25, .2, .6>] } } } } }"), POV_OK);
    p = colour_at(&b, 0.2, 0.5);
    assert_float_equal(p.color.r, 16383.0 / 65535.0, 1e-7);
    assert_float_equal(p.color.b, 49151.0 / 65535.0, 1e-7);
    assert_float_equal(p.transmit, 0.0, 1e-7);
    end(&b);
    assert_int_equal(read_scene(&b, "pigment { image_map { function 2, 2 { pigment { rgbft <1, .5, .25, .2, .6> } } } }"), POV_OK);
    p = colour_at(&b, 0.8, 0.5);
    assert_float_equal(p.color.g, 0.5, 2e-5);
    assert_float_equal(p.transmit, 0.6, 2e-5);
    assert_float_equal(p.filter, 0.0, 1e-7);
    end(&b);
}

/* Rows longer than what is evaluated at once, and no multiple of it. */
static void each_pixel_of_a_wide_row_is_the_pigment_there(void **state)
{
    enum { WIDE = 131 };
    bench b;

    (void)state;
    assert_int_equal(read_scene(&b, "pigment { image_map { function 131, 2 { pigment { gradient x color_map { [0 rgb 0] [1 rgb <1, .5, .25>] } scale 2 } } } }"),
                     POV_OK);
    for (int i = 0; i < WIDE; i++) {
        const pigment p = colour_at(&b, (i + 0.5) / WIDE, 0.25);

        assert_float_equal(p.color.r, 0.5 * i / (WIDE - 1), 2e-5);
        assert_float_equal(p.color.b, 0.125 * i / (WIDE - 1), 2e-5);
    }
    end(&b);
}

/* Values and heights are no light: what is given of their curve counts, and not what the scene calculates in. */
static void values_of_images_do_not_depend_on_the_assumed_gamma(void **state)
{
    static const char *const gammas[] = { "", "gamma 1", "gamma 1.8", "gamma srgb" };
    char text[256];
    bench b;

    (void)state;
    for (size_t i = 0; i < sizeof gammas / sizeof gammas[0]; i++) {
        float found[2];

        snprintf(text, sizeof text, "pigment { image_pattern { png \"images/rings.png\" %s } color_map { [0 rgb 0] [1 rgb 1] } }", gammas[i]);
        for (int k = 0; k < 2; k++) {
            assert_int_equal(read_scene_of(&b, k ? "2.2" : "1", text), POV_OK);
            found[k] = colour_at(&b, 0.01, 0.01).color.r;
            end(&b);
        }
        assert_float_equal(found[0], found[1], 0.0);
        assert_true(found[0] > 0.05f);
    }
}

/* As a colour it is clear there, and white. */
static void the_brightness_beyond_an_image_is_none(void **state)
{
    bench b;

    (void)state;
    assert_int_equal(read_scene_of(&b, "1", "pigment { pigment_pattern { image_map { png \"images/rings.png\" once } } color_map { [0 rgb .25] [1 rgb 1] } }"),
                     POV_OK);
    assert_true(colour_at(&b, 0.01, 0.01).color.r > 0.25f);
    assert_float_equal(colour_at(&b, 1.01, 0.01).color.r, 0.25, 0.0);
    end(&b);
}

/* The lower left pixel is (19, 0, 239) in the PNG: red is the high byte, and green the low one, as the gamma says. */
static void heights_are_decoded_by_the_gamma_that_is_given(void **state)
{
    static const char text[] =
        "} #declare A = height_field { png \"images/rings.png\" }; #declare B = height_field { png \"images/rings.png\" gamma 2 };\n"
        "#macro Check(H, Y) #if (abs(trace(H, <1e-7, 2, 1e-7>, -y).y - Y) > 2e-5) #error \"not as high\" #end #end\n"
        "Check(A, 19 * 256 / 65536) Check(B, 362 / 65536) sphere { 0, 1";
    bench b;

    (void)state;
    if (read_scene_of(&b, "2.2", text) != POV_OK)
        fail_msg("%s", b.error.message);
    end(&b);
}

/* 19 is 1 with a gamma of 2. */
static void numbers_of_textures_are_decoded_too(void **state)
{
    static const char text[] =
        "texture { material_map { png \"images/rings.png\" gamma %s texture { pigment { rgb .25 } } texture { pigment { rgb .5 } }\n"
        "texture { pigment { rgb .75 } } texture { pigment { rgb 1 } } } }";
    static const struct { const char *gamma; uint32_t number; } cases[] = { { "1", 19 % 4 }, { "2", 1 } };
    char scene[512];
    bench b;

    (void)state;
    for (size_t i = 0; i < 2; i++) {
        static texture_points points;
        texture_term term[4];

        snprintf(scene, sizeof scene, text, cases[i].gamma);
        assert_int_equal(read_scene(&b, scene), POV_OK);
        memset(&points, 0, sizeof points);
        texture_point(&points, 0, pov_vec3_of(0.01, 0.01, 0.0), pov_vec3_of(0.0, 0.0, 0.0));
        assert_int_equal(texture_eval(&b.model, b.model.materials.items[b.model.leaves.items[0].material].texture, &points, 1, term), 1);
        assert_true(term[0].pigment.color.r == 0.25f * (float)(cases[i].number + 1));
        end(&b);
    }
}

/* 2.35 is between 1.9 and 2.8. */
static void numbers_of_textures_are_interpolated_before_they_are_cut_down(void **state)
{
    static const char text[] =
        "texture { material_map { function 2, 1 { select(x - .5, 1.9, 2.8) / 255 } interpolate 2\n"
        "texture { pigment { rgb 0 } } texture { pigment { rgb .25 } } texture { pigment { rgb .5 } } texture { pigment { rgb 1 } } } }";
    static const struct { double x; float shown; } cases[] = { { 0.25, 0.25f }, { 0.5, 0.5f }, { 0.75, 0.5f } };
    bench b;

    (void)state;
    assert_int_equal(read_scene(&b, text), POV_OK);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        static texture_points points;
        texture_term term[4];

        memset(&points, 0, sizeof points);
        texture_point(&points, 0, pov_vec3_of(cases[i].x, 0.5, 0.0), pov_vec3_of(0.0, 0.0, 0.0));
        assert_int_equal(texture_eval(&b.model, b.model.materials.items[b.model.leaves.items[0].material].texture, &points, 1, term), 1);
        assert_true(term[0].pigment.color.r == cases[i].shown);
    }
    end(&b);
}

/* Patterns are asked for many pixels at once, formulas that call them for one. */
static void a_pattern_makes_the_image_of_a_formula_that_calls_it(void **state)
{
    static const char *const made[] = { "pattern { bozo scale .2 turbulence .3 }", "F(x, y, z) + 0 * x" };
    static float found[2][70];
    char text[256];
    bench b;

    (void)state;
    for (int k = 0; k < 2; k++) {
        snprintf(text, sizeof text, "} #declare F = function { %s }; plane { z, 0 pigment { image_map { function 70, 3 { %s } } }", made[0], made[k]);
        assert_int_equal(read_scene(&b, text), POV_OK);
        b.model.leaves.items[0] = b.model.leaves.items[1];
        for (int i = 0; i < 70; i++)
            found[k][i] = colour_at(&b, (i + 0.5) / 70.0, 0.4).color.r;
        end(&b);
    }
    for (int i = 0; i < 70; i++)
        assert_float_equal(found[0][i], found[1][i], 0.0);
    assert_true(found[0][0] != found[0][69]);
}

static const image *image_of(const bench *b, uint32_t leaf)
{
    const texture *t = b->model.materials.items[b->model.leaves.items[leaf].material].texture;

    assert_non_null(t);
    return ((const image_map *)t->pigment->pattern->self)->image;
}

/* What is written twice is one image, unless other noise would make another of it. */
static void equal_patterns_of_equal_sides_make_one_image(void **state)
{
    static const char *const made[7] = {
        "8, 9 { pattern { bozo scale .2 } }", "8, 9 { pattern { bozo scale .2 } }", "7, 9 { pattern { bozo scale .2 } }",
        "8, 9 { pattern { bozo scale .3 } }", "8, 9 { pigment { bozo scale .2 } }", "8, 9 { pigment { bozo scale .2 } }",
        "8, 9 { pattern { bozo scale .2 } }",
    };
    static const uint32_t first[7] = { 0, 0, 2, 3, 4, 4, 6 };
    char all[2048];
    bench b;

    (void)state;
    strcpy(all, "}");
    for (int i = 0; i < 7; i++)
        sprintf(all + strlen(all), "%s plane { z, 0 pigment { image_map { function %s } } }",
                i < 6 ? "" : "global_settings { noise_generator 1 }", made[i]);
    strcat(all, "sphere { 0, 1");
    if (read_scene(&b, all) != POV_OK)
        fail_msg("%s", b.error.message);
    for (uint32_t i = 0; i < 7; i++)
        for (uint32_t k = 0; k <= i; k++)
            assert_int_equal(image_of(&b, i + 1) == image_of(&b, k + 1), first[i] == first[k]);
    end(&b);
}

/* An image of one pixel, a volume of one value; what is written anew is read anew. */
static void what_a_scene_writes_is_an_image_of_it(void **state)
{
    static const char text[] =
        "} #macro Of(V) #fopen F \"of.pgm\" write #write (F, \"P2 1 1 255 \", V, \"\\n\") #fclose F"
        " plane { z, 0 pigment { image_map { pgm \"of.pgm\" gamma 1 } } } #end Of(51) Of(51) Of(255)"
        " #fopen F \"v.df3\" write #write (F, uint16be <1, 1, 1>, uint8 102) #fclose F"
        " plane { z, 0 pigment { density_file df3 \"v.df3\" } } sphere { 0, 1";
    static const float red[4] = { 51 / 255.0f, 51 / 255.0f, 1.0f, 102 / 255.0f };
    static texture_points points;
    bench b;
    pigment p;

    (void)state;
    if (read_scene(&b, text) != POV_OK)
        fail_msg("%s", b.error.message);
    texture_point(&points, 0, pov_vec3_of(0.5, 0.5, 0.5), pov_vec3_of(0.0, 0.0, 0.0));
    for (uint32_t i = 0; i < 4; i++) {
        pigment_eval(&b.model, b.model.materials.items[b.model.leaves.items[i + 1].material].texture->pigment, &points, 1, &p);
        assert_float_equal(p.color.r, red[i], 1e-6);
    }
    end(&b);
    assert_int_equal(access("of.pgm", F_OK), -1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_patterns_of_equal_sides_make_one_image),
        cmocka_unit_test(a_name_without_a_format_is_that_of_a_png),
        cmocka_unit_test(what_cannot_be_read_is_refused_with_its_place),
        cmocka_unit_test(a_name_without_its_ending_is_found_and_decoded),
        cmocka_unit_test(outside_an_image_that_is_there_once_all_is_clear),
        cmocka_unit_test(colours_that_are_times_their_alpha_are_divided_by_it),
        cmocka_unit_test(entries_of_a_palette_have_their_own_transparency),
        cmocka_unit_test(between_pixels_every_method_meets_them),
        cmocka_unit_test(a_function_makes_an_image_of_grey),
        cmocka_unit_test(values_of_functions_beyond_0_and_1_come_round),
        cmocka_unit_test(heights_of_a_pigment_are_its_brightness),
        cmocka_unit_test(a_pigment_makes_an_image_of_its_colours),
        cmocka_unit_test(each_pixel_of_a_wide_row_is_the_pigment_there),
        cmocka_unit_test(values_of_images_do_not_depend_on_the_assumed_gamma),
        cmocka_unit_test(the_brightness_beyond_an_image_is_none),
        cmocka_unit_test(heights_are_decoded_by_the_gamma_that_is_given),
        cmocka_unit_test(numbers_of_textures_are_decoded_too),
        cmocka_unit_test(numbers_of_textures_are_interpolated_before_they_are_cut_down),
        cmocka_unit_test(a_pattern_makes_the_image_of_a_formula_that_calls_it),
        cmocka_unit_test(what_a_scene_writes_is_an_image_of_it),
    };

    return cmocka_run_group_tests_name("images in scenes", tests, NULL, NULL);
}
