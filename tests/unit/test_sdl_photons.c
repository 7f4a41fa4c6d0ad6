/* sdl/parse_photons: what photons { } says of the scene, of objects and of lights. */
#include "support/check.h"
#include "support/reading.h"

#include <string.h>

static void begin(reading *r, const char *text)
{
    reader_options options = { .dialect = POV_DIALECT_POVRAY, .max_trace_level = 0 };

    reading_begin_bytes(r, text, strlen(text), &options, NULL);
}

/* Of the first object, or of the first light. */
static uint32_t flags_of(const char *text, bool of_light)
{
    reading r;
    uint32_t flags;

    begin(&r, text);
    if (r.status != POV_OK)
        fail_msg("%s: %s", text, r.error.message);
    flags = of_light ? r.model.lights.items[0].flags : r.model.leaves.items[0].flags;
    reading_end(&r);
    return flags & (PHOTON_OBJECT_FLAGS | PHOTON_AREA);
}

static void a_scene_without_the_block_has_no_photons(void **state)
{
    reading r;

    (void)state;
    begin(&r, "sphere { 0, 1 photons { target } }");
    assert_false(r.model.photons.given);
    reading_end(&r);
}

static void the_scene_says_how_far_photons_go(void **state)
{
    reading r;

    (void)state;
    begin(&r, "global_settings { photons { count 20000 gather 20, 100 jitter .4 autostop 0 expand_thresholds .2, 40 "
              "radius .1, 2, .1, 2 max_trace_level 9 adc_bailout .01 media 100, 2 } }");
    assert_int_equal(r.status, POV_OK);
    assert_true(r.model.photons.media);
    assert_true(r.model.photons.given);
    assert_int_equal(r.model.photons.max_trace_level, 9);
    assert_true(r.model.photons.adc_bailout == .01);
    reading_end(&r);
    begin(&r, "global_settings { photons { spacing .01 } }");
    assert_int_equal(r.model.photons.max_trace_level, -1);
    assert_false(r.model.photons.media);
    assert_true(r.model.photons.adc_bailout < 0.0);
    reading_end(&r);
}

static void an_object_says_what_it_does_to_photons(void **state)
{
    (void)state;
    assert_int_equal(flags_of("sphere { 0, 1 }", false), 0);
    assert_int_equal(flags_of("sphere { 0, 1 photons { target 1.0 refraction on reflection off } }", false),
                     PHOTON_TARGET | PHOTON_REFRACTS | PHOTON_REFLECTS_NOT);
    assert_int_equal(flags_of("sphere { 0, 1 photons { collect off pass_through } }", false), PHOTON_IGNORES | PHOTON_THROUGH);
    assert_int_equal(flags_of("sphere { 0, 1 photons { refraction off refraction on collect off collect on } }", false),
                     PHOTON_REFRACTS);
}

static void a_group_says_it_for_its_members(void **state)
{
    (void)state;
    assert_int_equal(flags_of("difference { sphere { 0, 2 } sphere { 0, 1 } photons { target reflection on } }", false),
                     PHOTON_TARGET | PHOTON_REFLECTS);
}

static void a_light_says_it_for_its_photons(void **state)
{
    (void)state;
    assert_int_equal(flags_of("light_source { 0, 1 photons { area_light refraction off reflection on } }", true),
                     PHOTON_AREA | PHOTON_REFRACTS_NOT | PHOTON_REFLECTS);
}

static void what_is_off_at_either_is_off(void **state)
{
    (void)state;
    assert_true(photons_refract(PHOTON_REFRACTS, 0));
    assert_true(photons_refract(0, PHOTON_REFRACTS));
    assert_false(photons_refract(0, 0));
    assert_false(photons_refract(PHOTON_REFRACTS, PHOTON_REFRACTS_NOT));
    assert_false(photons_refract(PHOTON_REFRACTS_NOT, PHOTON_REFRACTS));
    assert_true(photons_reflect(PHOTON_REFLECTS, 0));
    assert_false(photons_reflect(PHOTON_REFRACTS, 0));
}

static void words_that_belong_elsewhere_are_refused(void **state)
{
    static const char *const wrong[] = {
        "global_settings { photons { target } }", "sphere { 0, 1 photons { spacing 1 } }",
        "light_source { 0, 1 photons { target } }", "global_settings { photons { max_trace_level -1 } }",
    };

    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        reading r;

        begin(&r, wrong[i]);
        assert_int_equal(r.status, POV_E_SYNTAX);
        reading_end(&r);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_scene_without_the_block_has_no_photons),
        cmocka_unit_test(the_scene_says_how_far_photons_go),
        cmocka_unit_test(an_object_says_what_it_does_to_photons),
        cmocka_unit_test(a_group_says_it_for_its_members),
        cmocka_unit_test(a_light_says_it_for_its_photons),
        cmocka_unit_test(what_is_off_at_either_is_off),
        cmocka_unit_test(words_that_belong_elsewhere_are_refused),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
