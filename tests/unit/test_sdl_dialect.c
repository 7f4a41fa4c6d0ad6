/* sdl: how a text tells its dialect, and what follows from it. */
#include "support/check.h"
#include "support/reading.h"

#include <string.h>

static void read_as(reading *r, const char *text, pov_dialect dialect)
{
    reader_options options = { .dialect = dialect, .max_trace_level = 0 };

    reading_begin_bytes(r, text, strlen(text), &options, NULL);
    if (r->status != POV_OK)
        fail_msg("%s: %s", text, r->error.message);
}

static const char course_text[] =
    "// every word of the base language\n"
    "camera { location <0, 1, -5> look_at 0 angle 40 up <0, 1, 0> right <1, 0, 0> rotate 0 }\n"
    "light_source { <1, 2, 3> color rgb 1 }\n"
    "global_settings { ambient_light rgb .5 max_trace_level 3 adc_bailout .1 }\n"
    "sphere { 0, 1 pigment { colour rgbf <1, 1, 1, .5> } finish { ambient .1 diffuse .2 phong .3 phong_size "
    "4 }\n"
    "    interior { ior 1.5 } translate 1 rotate 2 scale 3 }\n"
    "box { 0, 1 finish { metallic reflection .1 } pigment { red 1 green 1 blue 1 filter .5 } }\n"
    "cone { 0, 1, 2, 3 } cylinder { <0, 0, 0>, 2, 3 } quadric { 1, 0, 0, 1 }\n"
    "polygon { 3, <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }\n";

static void a_text_of_the_base_language_is_course(void **state)
{
    reading r;

    (void)state;
    read_as(&r, course_text, POV_DIALECT_AUTO);
    assert_int_equal(r.model.dialect, POV_DIALECT_COURSE);
    assert_string_equal(r.model.dialect_reason,
                        "no \"#version\", and every word is one of the base language");
    assert_int_equal(r.model.leaves.count, 6);
    reading_end(&r);
}

typedef struct deciding {
    const char *text, *reason;
} deciding;

static const deciding deciding_cases[] = {
    {"#version 3.7;", "the word \"#version\" at 1:1"},
    {"sphere { 0, 1 }\n # version 3.6 sphere { 0, 1 }", "the word \"# version\" at 2:2"},
    {"sphere { 0, 1\n  texture { pigment { rgb 1 } } }", "the word \"texture\" at 2:3"},
    {"cone { 0, 1, 2, 3 open no_shadow }", "the word \"open\" at 1:19"},
    {"sphere { 0, 1 no_shadow }", "the word \"no_shadow\" at 1:15"},
    {"sphere { 0, 1 inverse }", "the word \"inverse\" at 1:15"},
    {"sphere { 0, 1 hollow }", "the word \"hollow\" at 1:15"},
    {"sphere { 0, 1 matrix <1,0,0,0,1,0,0,0,1,0,0,0> }", "the word \"matrix\" at 1:15"},
    {"camera { sky <0, 1, 0> }", "the word \"sky\" at 1:10"},
    {"camera { direction <0, 0, 1> }", "the word \"direction\" at 1:10"},
    {"global_settings { assumed_gamma 1 }", "the word \"assumed_gamma\" at 1:19"},
    {"background { rgb 1 }", "the word \"background\" at 1:1"},
    {"light_source { 1 rgbt 1 }", "the word \"rgbt\" at 1:18"},
    {"light_source { 1 rgbft 1 }", "the word \"rgbft\" at 1:18"},
    {"sphere { 0, 1 pigment { rgb 1 transmit .5 } }", "the word \"transmit\" at 1:31"},
    {"blob7 { power 1 (2) }", "the word \"blob7\" at 1:1"},
};

static void the_first_other_word_makes_a_text_povray(void **state)
{
    size_t i;

    (void)state;
    for (i = 0; i < sizeof deciding_cases / sizeof deciding_cases[0]; i++) {
        reading r;

        read_as(&r, deciding_cases[i].text, POV_DIALECT_AUTO);
        assert_int_equal(r.model.dialect, POV_DIALECT_POVRAY);
        assert_string_equal(r.model.dialect_reason, deciding_cases[i].reason);
        reading_end(&r);
    }
}

static void words_in_comments_decide_nothing(void **state)
{
    reading r;

    (void)state;
    read_as(&r, "/* #version 3.7; */ sphere { 0, 1 } // texture", POV_DIALECT_AUTO);
    assert_int_equal(r.model.dialect, POV_DIALECT_COURSE);
    reading_end(&r);
}

static void what_is_asked_for_wins(void **state)
{
    reading r;

    (void)state;
    read_as(&r, "background { rgb 1 }", POV_DIALECT_COURSE);
    assert_int_equal(r.model.dialect, POV_DIALECT_COURSE);
    assert_string_equal(r.model.dialect_reason, "it was asked for");
    reading_end(&r);
    read_as(&r, "sphere { 0, 1 }", POV_DIALECT_POVRAY);
    assert_int_equal(r.model.dialect, POV_DIALECT_POVRAY);
    reading_end(&r);
}

static void ambient_light_depends_on_the_dialect_unless_given(void **state)
{
    reading r;

    (void)state;
    read_as(&r, "sphere { 0, 1 }", POV_DIALECT_COURSE);
    assert_true(r.model.ambient_light.r == 0.0f);
    reading_end(&r);
    read_as(&r, "sphere { 0, 1 }", POV_DIALECT_POVRAY);
    assert_true(r.model.ambient_light.r == 1.0f && r.model.ambient_light.b == 1.0f);
    reading_end(&r);
    read_as(&r, "global_settings { ambient_light rgb <.25, 0, 0> } global_settings { max_trace_level 9 }",
            POV_DIALECT_POVRAY);
    assert_true(r.model.ambient_light.r == 0.25f && r.model.ambient_light.g == 0.0f);
    assert_int_equal(r.model.max_trace_level, 9);
    reading_end(&r);
}

typedef struct effect {
    const char *text;
    double decode;
    pov_transfer transfer;
    bool opacity_uses_filter_colour, fresnel_metallic;
} effect;

static const effect effects[] = {
    {"sphere { 0, 1 }", 1.0, POV_TRANSFER_LINEAR, false, false},
    {"sphere { 0, 1 hollow }", 1.0, POV_TRANSFER_LINEAR, true, true},
    {"#version 3.6; sphere { 0, 1 }", 1.0, POV_TRANSFER_LINEAR, true, true},
    {"#version 3.7; sphere { 0, 1 }", 1.0, POV_TRANSFER_SRGB, false, true},
    {"#version 3.7; sphere { 0, 1 } #version 3.5;", 1.0, POV_TRANSFER_LINEAR, true, true},
    {"#version 3.8 #version 3.70 sphere { 0, 1 }", 1.0, POV_TRANSFER_SRGB, false, true},
    {"global_settings { assumed_gamma 2.2 } sphere { 0, 1 }", 2.2, POV_TRANSFER_SRGB, true, true},
    {"#version 3.7; global_settings { assumed_gamma 1 }", 1.0, POV_TRANSFER_SRGB, false, true},
};

static void version_and_gamma_have_their_effects(void **state)
{
    size_t i;

    (void)state;
    for (i = 0; i < sizeof effects / sizeof effects[0]; i++) {
        const effect *e = &effects[i];
        reading r;

        read_as(&r, e->text, POV_DIALECT_AUTO);
        if (r.model.gamma.decode != e->decode || r.model.gamma.transfer != e->transfer ||
            r.model.opacity_uses_filter_colour != e->opacity_uses_filter_colour ||
            r.model.fresnel_metallic != e->fresnel_metallic)
            fail_msg("%s", e->text);
        reading_end(&r);
    }
}

static void settings_have_their_defaults(void **state)
{
    reading r;

    (void)state;
    read_as(&r, "sphere { 0, 1 }", POV_DIALECT_AUTO);
    assert_int_equal(r.model.max_trace_level, 5);
    assert_true(r.model.adc_bailout == 1.0 / 255.0);
    assert_true(colour_is_black(r.model.background));
    assert_int_equal(r.model.lights.count, 0);
    reading_end(&r);
}

static void the_caller_wins_over_max_trace_level(void **state)
{
    reader_options options = { .dialect = POV_DIALECT_AUTO, .max_trace_level = 12 };
    const char *text = "global_settings { max_trace_level 3 }";
    reading r;

    (void)state;
    reading_begin_bytes(&r, text, strlen(text), &options, NULL);
    assert_int_equal(r.model.max_trace_level, 12);
    reading_end(&r);
}

static void a_broken_trace_level_is_cut_with_a_warning(void **state)
{
    reading r;

    (void)state;
    read_as(&r, "global_settings { max_trace_level 3.7 }", POV_DIALECT_AUTO);
    assert_int_equal(r.model.max_trace_level, 3);
    assert_int_equal(r.model.warnings, 1);
    reading_end(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_text_of_the_base_language_is_course),
        cmocka_unit_test(the_first_other_word_makes_a_text_povray),
        cmocka_unit_test(words_in_comments_decide_nothing),
        cmocka_unit_test(what_is_asked_for_wins),
        cmocka_unit_test(ambient_light_depends_on_the_dialect_unless_given),
        cmocka_unit_test(version_and_gamma_have_their_effects),
        cmocka_unit_test(settings_have_their_defaults),
        cmocka_unit_test(the_caller_wins_over_max_trace_level),
        cmocka_unit_test(a_broken_trace_level_is_cut_with_a_warning),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
