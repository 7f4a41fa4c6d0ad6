/* media { }: what is read of it, and messages on what is wrong. */
#include "support/check.h"
#include "support/near.h"
#include "support/reading.h"

#include <stdio.h>

#define FILLED(media) "sphere { 0, 1 hollow pigment { rgbt 1 } interior { " media " } }"

static const media *media_of_first(const reading *r)
{
    assert_int_equal(r->status, POV_OK);
    return r->model.materials.items[r->model.leaves.items[0].material].interior.media;
}

static void words_of_media_are_read(void **state)
{
    const medium *m;
    reading r;
    (void)state;

    reading_begin(&r, FILLED("media { absorption 0.1 emission <0.1, 0.2, 0.3> scattering { 5, rgb 0.4 eccentricity -0.2 extinction 0.7 } "
                             "method 3 intervals 2 samples 10, 20 ratio 0.9 confidence 0.9 variance 1/128 jitter 0.5 aa_level 3 "
                             "aa_threshold 0.1 }"));
    assert_int_equal(media_of_first(&r)->count, 1);
    m = media_of_first(&r)->items;
    assert_near((double)m->absorption.g, (double)0.1f, 0.0);
    assert_near((double)m->emission.b, (double)0.3f, 0.0);
    assert_int_equal(m->type, SCATTER_HENYEY);
    assert_near((double)m->scattering.r, (double)0.4f, 0.0);
    assert_near((double)m->extinction, (double)0.7f, 0.0);
    assert_near((double)m->eccentricity, (double)-0.2f, 0.0);
    assert_int_equal(m->strata, 20);
    assert_int_equal(m->density_count, 0);
    reading_end(&r);
}

static void the_last_scattering_counts_with_its_own_words(void **state)
{
    const medium *m;
    reading r;
    (void)state;

    reading_begin(&r, FILLED("media { scattering { 5, rgb 0.4 eccentricity 0.2 extinction 0.7 } scattering { 2, rgb 0.1 } }"));
    m = media_of_first(&r)->items;
    assert_int_equal(m->type, SCATTER_HAZE);
    assert_near((double)m->extinction, 1.0, 0.0);
    assert_near((double)m->eccentricity, 0.0, 0.0);
    reading_end(&r);
}

static void unknown_scattering_is_isotropic(void **state)
{
    static const char *const types[] = { "0", "6", "-1" };
    (void)state;

    for (int i = 0; i < 3; i++) {
        char text[200];
        reading r;

        snprintf(text, sizeof text, FILLED("media { scattering { %s, rgb 0.1 } }"), types[i]);
        reading_begin(&r, text);
        assert_int_equal(media_of_first(&r)->items[0].type, SCATTER_ISOTROPIC);
        reading_end(&r);
    }
}

static void media_add_up_in_interiors_and_around_the_scene(void **state)
{
    reading r;
    (void)state;

    reading_begin(&r, "#declare M = media { emission 1 }; #declare I = interior { media { M } media { M absorption 2 } };\n"
                      "sphere { 0, 1 interior { I media { scattering { 1, 3 } } } }\n"
                      "media { M } media { absorption 1 }");
    assert_int_equal(media_of_first(&r)->count, 3);
    assert_near((double)media_of_first(&r)->items[1].emission.r, 1.0, 0.0);
    assert_near((double)media_of_first(&r)->items[1].absorption.r, 2.0, 0.0);
    assert_int_equal(r.model.atmosphere->count, 2);
    reading_end(&r);
}

static void densities_move_with_their_object(void **state)
{
    reading r;
    (void)state;

    reading_begin(&r, "#declare S = sphere { 0, 1 interior { media { emission 1 density { spherical } density { rgb 2 } } } };\n"
                      "object { S } object { S translate x } union { object { S } translate x }\n"
                      "sphere { 0, 1 translate x interior { media { emission 1 density { spherical } density { rgb 2 } } } }");
    assert_int_equal(r.status, POV_OK);
    assert_int_equal(r.model.leaves.count, 4);
    assert_true(r.model.leaves.items[0].material != r.model.leaves.items[1].material);
    assert_int_equal(r.model.leaves.items[1].material, r.model.leaves.items[2].material);
    assert_int_equal(r.model.leaves.items[0].material, r.model.leaves.items[3].material);
    reading_end(&r);
}

static void lights_say_what_media_do_to_them(void **state)
{
    reading r;
    (void)state;

    reading_begin(&r, "light_source { 0, 1 } light_source { 0, 1 media_interaction off media_attenuation on }\n"
                      "light_source { 0, 1 media_interaction on media_attenuation off }");
    assert_int_equal(r.status, POV_OK);
    assert_int_equal(r.model.lights.items[0].flags & (LIGHT_NO_MEDIA | LIGHT_ATTENUATED), 0);
    assert_int_equal(r.model.lights.items[1].flags & (LIGHT_NO_MEDIA | LIGHT_ATTENUATED), LIGHT_NO_MEDIA | LIGHT_ATTENUATED);
    assert_int_equal(r.model.lights.items[2].flags & (LIGHT_NO_MEDIA | LIGHT_ATTENUATED), 0);
    reading_end(&r);
}

static void assert_refused(const char *text, const char *message, int column)
{
    reading r;

    reading_begin(&r, text);
    assert_int_equal(r.status, POV_E_SYNTAX);
    assert_string_equal(r.error.message, message);
    assert_int_equal(r.error.column, column);
    reading_end(&r);
}

static void mistakes_have_a_place(void **state)
{
    (void)state;

    assert_refused("media { method 4 }", "the method of a media is 1, 2 or 3", 16);
    assert_refused("media { scattering { 2, 1 eccentricity .5 } }", "\"eccentricity\" is of a scattering of type 5", 27);
    assert_refused("media { scattering { 1, 1 emission 2 } }", "\"emission\" does not belong in \"scattering\"", 27);
    assert_refused("media { scattring { 1, 1 } }", "unknown word \"scattring\" in \"media\"", 9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(words_of_media_are_read),
        cmocka_unit_test(unknown_scattering_is_isotropic),
        cmocka_unit_test(the_last_scattering_counts_with_its_own_words),
        cmocka_unit_test(media_add_up_in_interiors_and_around_the_scene),
        cmocka_unit_test(densities_move_with_their_object),
        cmocka_unit_test(lights_say_what_media_do_to_them),
        cmocka_unit_test(mistakes_have_a_place),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
