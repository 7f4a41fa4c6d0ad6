/* sdl/parse_radiosity: what radiosity { } says of the scene. */
#include "support/check.h"
#include "support/reading.h"

#include <stdio.h>
#include <string.h>

static void begin(reading *r, const char *text)
{
    reader_options options = { .dialect = POV_DIALECT_POVRAY, .max_trace_level = 0 };

    reading_begin_bytes(r, text, strlen(text), &options, NULL);
}

static void the_block_has_povrays_defaults(void **state)
{
    reading r;

    (void)state;
    begin(&r, "sphere { 0, 1 }");
    assert_false(r.model.radiosity.given);
    reading_end(&r);
    begin(&r, "global_settings { radiosity { } }");
    assert_true(r.model.radiosity.given && r.model.radiosity.recursion_limit == 2);
    assert_true(r.model.radiosity.brightness == 1.0f && r.model.radiosity.adc_bailout == 0.01);
    assert_int_equal(r.model.warnings, 0);
    reading_end(&r);
}

static void every_word_is_read(void **state)
{
    reading r;

    (void)state;
    begin(&r, "global_settings { radiosity { adc_bailout .02 always_sample off brightness .5 count 200, 1600 error_bound .5 "
              "gray_threshold .25 low_error_factor .5 max_sample 3 maximum_reuse .2 media on minimum_reuse .01 "
              "nearest_count 10, 5 normal on pretrace_start .08 pretrace_end .01 recursion_limit 3 subsurface off } }");
    assert_int_equal(r.status, POV_OK);
    assert_true(r.model.radiosity.recursion_limit == 3 && r.model.radiosity.draws == 16);
    assert_true(r.model.radiosity.brightness == .5f && r.model.radiosity.gray_threshold == .25f);
    assert_true(r.model.radiosity.max_sample == 3.0f && r.model.radiosity.adc_bailout == .02);
    assert_true(r.model.radiosity.uses_normals && r.model.radiosity.sees_media);
    assert_int_equal(r.model.warnings, 1);
    reading_end(&r);
}

static void ambient_light_ends_with_version_37(void **state)
{
    reading r;

    (void)state;
    begin(&r, "#version 3.7; global_settings { radiosity { } ambient_light rgb 2 }");
    assert_true(colour_is_black(r.model.ambient_light));
    reading_end(&r);
    begin(&r, "#version 3.6; global_settings { radiosity { } ambient_light rgb 2 }");
    assert_true(r.model.ambient_light.g == 2.0f);
    reading_end(&r);
}

static void bounces_are_limited(void **state)
{
    static const char *const wrong[] = { "recursion_limit 0", "recursion_limit 21", "adc_bailout -1", "count -1", "radius 2" };
    char text[128];
    reading r;

    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        snprintf(text, sizeof text, "global_settings { radiosity { %s } }", wrong[i]);
        begin(&r, text);
        assert_int_equal(r.status, POV_E_SYNTAX);
        reading_end(&r);
    }
}

static void an_object_can_be_hidden(void **state)
{
    reading r;

    (void)state;
    begin(&r, "global_settings { radiosity { } } sphere { 0, 1 no_radiosity radiosity { importance .5 } }");
    assert_int_equal(r.status, POV_OK);
    assert_true(r.model.leaves.items[0].flags & LEAF_NO_RADIOSITY);
    reading_end(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_block_has_povrays_defaults), cmocka_unit_test(every_word_is_read),
        cmocka_unit_test(ambient_light_ends_with_version_37), cmocka_unit_test(bounces_are_limited),
        cmocka_unit_test(an_object_can_be_hidden),
    };

    return cmocka_run_group_tests_name("reading of radiosity", tests, NULL, NULL);
}
