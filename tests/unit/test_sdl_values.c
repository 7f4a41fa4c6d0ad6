/* sdl/value: numbers, vectors, colours as they come out of a scene. */
#include "support/check.h"
#include "support/reading.h"

#include <string.h>

static void assert_vector(pov_vec3 v, double x, double y, double z)
{
    if (v.x != x || v.y != y || v.z != z)
        fail_msg("<%.17g, %.17g, %.17g> is not <%g, %g, %g>", v.x, v.y, v.z, x, y, z);
}

/* The box of the text, whose two corners are the vectors under test. */
static const test_shape *read_box(reading *r, const char *text)
{
    reading_begin(r, text);
    if (r->status != POV_OK)
        fail_msg("%s: %s", text, r->error.message);
    return reading_shape(r, 0);
}

static void vectors_are_read_with_and_without_commas(void **state)
{
    reading r;
    const test_shape *s = read_box(&r, "box { <-1, +.5, 2e1> <1 2., 3,> }");

    (void)state;
    assert_vector(s->vectors[0], -1.0, 0.5, 20.0);
    assert_vector(s->vectors[1], 1.0, 2.0, 3.0);
    reading_end(&r);
}

static void a_number_stands_for_a_vector(void **state)
{
    reading r;
    const test_shape *s = read_box(&r, "box { -1, - -2 }");

    (void)state;
    assert_vector(s->vectors[0], -1.0, -1.0, -1.0);
    assert_vector(s->vectors[1], 2.0, 2.0, 2.0);
    reading_end(&r);
}

static void a_vector_of_two_numbers_ends_in_zero(void **state)
{
    reading r;
    const test_shape *s = read_box(&r, "box { <1, 2>, 3 }");

    (void)state;
    assert_vector(s->vectors[0], 1.0, 2.0, 0.0);
    assert_int_equal(r.model.warnings, 0);
    reading_end(&r);
}

static void a_number_too_small_for_a_double_is_zero_with_a_warning(void **state)
{
    reading r;
    const test_shape *s = read_box(&r, "box { 1e-400, 3 }");

    (void)state;
    assert_vector(s->vectors[0], 0.0, 0.0, 0.0);
    assert_string_equal(r.notes[0].message, "\"1e-400\" is too small for a double and counts as 0");
    reading_end(&r);
}

typedef struct colour_case {
    const char *text;
    float red, green, blue, filter, transmit;
} colour_case;

/* As POV-Ray 3.7 reads them, measured. */
static const colour_case colour_cases[] = {
    {"color rgb <.25, .5, 1>", .25f, .5f, 1, 0, 0},
    {"rgb <.25 .5 1>", .25f, .5f, 1, 0, 0},
    {"colour rgb .5", .5f, .5f, .5f, 0, 0},
    {"rgb 1", 1, 1, 1, 0, 0},
    {"rgbf <1, .5, .25, .125>", 1, .5f, .25f, .125f, 0},
    {"rgbf .5", .5f, .5f, .5f, .5f, 0},
    {"rgbf <1, .5, .25>", 1, .5f, .25f, 0, 0},
    {"rgbt <1, .5, .25, .125>", 1, .5f, .25f, 0, .125f},
    {"rgbt .5", .5f, .5f, .5f, 0, .5f},
    {"rgbft <1, .5, .25, .125, .75>", 1, .5f, .25f, .125f, .75f},
    {"rgbft .5", .5f, .5f, .5f, .5f, .5f},
    {"color .5", .5f, .5f, .5f, .5f, .5f},
    {"color <1, .5, .25>", 1, .5f, .25f, 0, 0},
    {"color <1, .5, .25, .125>", 1, .5f, .25f, .125f, 0},
    {"color <1, .5, .25, .125, .75>", 1, .5f, .25f, .125f, .75f},
    {"rgb <1, .5>", 1, .5f, 0, 0, 0},
    {"rgb <1, .5, .25, .125>", 1, .5f, .25f, .125f, 0},
    {"red 1 green .5 blue 0 filter .25", 1, .5f, 0, .25f, 0},
    {"color red 1", 1, 0, 0, 0, 0},
    {"transmit .5 blue 1", 0, 0, 1, 0, .5f},
    {"red 1 red .5", .5f, 0, 0, 0, 0},
    {"rgb <1, .5, .25> filter .5", 1, .5f, .25f, .5f, 0},
    {"color rgb 1 transmit .5 red .25", .25f, 1, 1, 0, .5f},
    {"rgb <-1, 2, 1e3>", -1, 2, 1000, 0, 0},
};

static void colours_are_read_in_every_form(void **state)
{
    size_t i;

    (void)state;
    for (i = 0; i < sizeof colour_cases / sizeof colour_cases[0]; i++) {
        const colour_case *c = &colour_cases[i];
        const material *m;
        char text[128] = "sphere { 0, 1 pigment { ";
        reading r;

        strcat(text, c->text);
        strcat(text, " } }");
        reading_begin(&r, text);
        if (r.status != POV_OK)
            fail_msg("%s: %s", text, r.error.message);
        m = &r.model.materials.items[0];
        if (m->pigment.r != c->red || m->pigment.g != c->green || m->pigment.b != c->blue ||
            m->filter != c->filter || m->transmit != c->transmit)
            fail_msg("%s gave %g %g %g %g %g", c->text, (double)m->pigment.r, (double)m->pigment.g,
                     (double)m->pigment.b, (double)m->filter, (double)m->transmit);
        reading_end(&r);
    }
}

static void a_bare_vector_is_a_colour_where_nothing_else_can_stand(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "global_settings { ambient_light <.5, .25, 0> } background { <1, .5, 0> }\n"
                      "light_source { <1, 2, 3> <.25, .5, .75> }\n"
                      "sphere { 0, 1 finish { ambient <.5, .25, .125> reflection .5 } }");
    assert_int_equal(r.status, POV_OK);
    assert_true(r.model.ambient_light.g == 0.25f && r.model.background.g == 0.5f);
    assert_true(r.model.lights.items[0].color.b == 0.75f);
    assert_true(r.model.materials.items[0].finish.ambient.b == 0.125f &&
                r.model.materials.items[0].finish.reflection.max.b == 0.5f);
    reading_end(&r);
}

static void a_name_may_hold_a_colour_that_no_surface_can_have(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "#declare C = rgb <1/0, 2, 1e39>; #declare D = red 1/0; sphere { 0, C.green + (D.red > 1) pigment { rgb 1 } }");
    assert_int_equal(r.status, POV_OK);
    assert_true(reading_shape(&r, 0)->numbers[0] == 3.0);
    reading_end(&r);
    reading_begin(&r, "#declare C = rgb <1/0, 2, 3>; sphere { 0, 1 pigment { C } }");
    assert_string_equal(r.error.message, "a number beyond 3.40282e+38 has no use in a colour");
    reading_end(&r);
}

static void a_value_may_begin_with_a_colours_name(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "#declare C = rgb <.5, .25, 1>; #declare V = C.red * <2, 4, 6>; #declare D = C * .5; #declare E = color C green 1;\n"
                      "background { color color D } global_settings { ambient_light E }\n"
                      "light_source { V, C }");
    assert_int_equal(r.status, POV_OK);
    assert_true(r.model.lights.items[0].position.z == 3.0);
    assert_true(r.model.background.r == 0.25f && r.model.background.b == 0.5f);
    assert_true(r.model.ambient_light.r == 0.5f && r.model.ambient_light.g == 1.0f);
    reading_end(&r);
}

static void the_word_color_alone_is_black_with_a_warning(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "background { rgb 1 } background { color } light_source { 0 colour }\n"
                      "sphere { 0, 1 pigment { gradient y color_map { [0 color][1 color red 1] } } }");
    assert_int_equal(r.status, POV_OK);
    assert_int_equal(r.model.warnings, 3);
    assert_true(r.model.background.r == 0.0f);
    reading_end(&r);
}

static void a_hash_before_words_of_the_scene_is_left_out(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "#background { #rgb .5 } ##declare S = #sphere { 0, 1 pigment { #rgb 1 } } #S #global_settings { max_trace_level 7 }");
    assert_int_equal(r.status, POV_OK);
    assert_int_equal(r.model.warnings, 7);
    assert_int_equal(r.model.leaves.count, 1);
    assert_int_equal(r.model.max_trace_level, 7);
    reading_end(&r);
}

static void the_default_texture_is_that_of_the_statement(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "#declare S = sphere { 0, 1 interior { ior 1.5 } } #declare T = sphere { 0, 1 pigment { rgb .5 } }\n"
                      "#default { pigment { rgb <1, .25, 0> } } S object { S finish { phong 1 } } object { T }");
    assert_int_equal(r.status, POV_OK);
    assert_int_equal(r.model.leaves.count, 3);
    for (int i = 0; i < 3; i++) {
        const material *m = &r.model.materials.items[r.model.leaves.items[i].material];

        assert_true(m->pigment.g == (i < 2 ? 0.25f : 0.5f));
        assert_true(m->interior.ior == (i < 2 ? 1.5 : 1.0));
    }
    reading_end(&r);
}

#define DEFAULT(colour) "#default { pigment { rgb " colour " } }"

static void the_default_texture_is_that_at_the_last_brace(void **state)
{
    const char *texts[] = {   /* each with red in the end */
        "sphere { 0, 1 " DEFAULT("x") " }" DEFAULT("y"),
        "union { sphere { 0, 1 " DEFAULT("y") " } sphere { 0, 2 } " DEFAULT("x") " }" DEFAULT("y"),
        "object { sphere { 0, 1 } scale 2 " DEFAULT("x") " translate x }" DEFAULT("y"),
        "#declare S = sphere { 0, 1 " DEFAULT("y") " } object { S " DEFAULT("x") " } #declare T = sphere { 0, 1 " DEFAULT("y") " }",
        "union { object { sphere { 0, 1 } } " DEFAULT("x") " } #declare T = union { sphere { 0, 1 } " DEFAULT("y") " }",
    };
    reading r;

    (void)state;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        reading_begin(&r, texts[i]);
        assert_int_equal(r.status, POV_OK);
        const material *m = &r.model.materials.items[r.model.leaves.items[0].material];

        assert_true(m->pigment.r == 1.0f && m->pigment.g == 0.0f);
        reading_end(&r);
    }
}

static void a_background_is_darkened_by_what_it_transmits(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "#version 3.7; background { color rgbt <1, .5, 0, .5> }");
    assert_true(r.model.background.r == 0.5f && r.model.background.g == 0.25f);
    reading_end(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vectors_are_read_with_and_without_commas),
        cmocka_unit_test(a_number_stands_for_a_vector),
        cmocka_unit_test(a_vector_of_two_numbers_ends_in_zero),
        cmocka_unit_test(a_number_too_small_for_a_double_is_zero_with_a_warning),
        cmocka_unit_test(colours_are_read_in_every_form),
        cmocka_unit_test(a_bare_vector_is_a_colour_where_nothing_else_can_stand),
        cmocka_unit_test(a_name_may_hold_a_colour_that_no_surface_can_have),
        cmocka_unit_test(a_value_may_begin_with_a_colours_name),
        cmocka_unit_test(the_word_color_alone_is_black_with_a_warning),
        cmocka_unit_test(a_hash_before_words_of_the_scene_is_left_out),
        cmocka_unit_test(the_default_texture_is_that_of_the_statement),
        cmocka_unit_test(the_default_texture_is_that_at_the_last_brace),
        cmocka_unit_test(a_background_is_darkened_by_what_it_transmits),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
