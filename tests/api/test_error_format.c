/* Errors as text: place, message, hint, excerpt; whole or cut off. */
#include "support/check.h"
#include "support/scenes.h"

#include <string.h>

static void an_error_of_a_scene_shows_its_place(void **state)
{
    static const char text[] = "camera { }\n\tsphere { 0, 1 pigmnet { rgb 1 } }";
    static const char want[] = "\u00e4.pov:2:16: unknown word \"pigmnet\" in \"sphere\"; did you mean \"pigment\"?\n"
                               "    \tsphere { 0, 1 pigmnet { rgb 1 } }\n"
                               "    \t              ^";
    pov_context *context = scenes_context();
    char out[1000], start[20];
    pov_scene *scene;
    pov_error err;
    size_t length;

    (void)state;
    assert_int_equal(pov_scene_load_text(&scene, context, text, strlen(text), "\u00e4.pov", NULL, &err), POV_E_SYNTAX);
    length = pov_error_format(&err, out, sizeof out);
    assert_string_equal(out, want);
    assert_int_equal(length, strlen(want));
    assert_int_equal(pov_error_format(&err, start, sizeof start), length);
    assert_memory_equal(start, want, sizeof start - 1);
    assert_int_equal(start[sizeof start - 1], 0);
    assert_int_equal(pov_error_format(&err, NULL, 0), length);
    pov_context_destroy(context);
}

static void defect_26_an_error_without_a_place_is_its_message(void **state)
{
    pov_error err = { .status = POV_E_MEMORY, .message = "out of memory" };
    char out[100];

    (void)state;
    assert_int_equal(pov_error_format(&err, out, sizeof out), strlen("out of memory"));
    assert_string_equal(out, "out of memory");
    assert_int_equal(pov_error_format(NULL, out, sizeof out), 0);
    assert_string_equal(out, "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_error_of_a_scene_shows_its_place), cmocka_unit_test(defect_26_an_error_without_a_place_is_its_message),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
