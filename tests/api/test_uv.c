/* uv_mapping of an object is that of the patterns of its texture, whichever way the texture is given. */
#include "support/check.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 32, HEIGHT = 24, VALUES = 4 * WIDTH * HEIGHT };

#define CHECKS "checker rgb 1 rgb <.8, .1, .1> scale .1"
#define STRIPES "gradient x color_map { [.5 rgbt 1] [.5 rgbt <.2, .3, .9, .4>] } scale .25"

static float *draw(const char *look)
{
    char text[1024];

    snprintf(text, sizeof text, "#version 3.7; camera { location <0, 0, -3> look_at 0 } light_source { <5, 8, -6> rgb 1 }\n"
             "sphere { 0, 1 %s rotate 20*x }\n", look);
    return scenes_draw(text, WIDTH, HEIGHT, 0, 0);
}

static bool are_alike(const char *one, const char *other)
{
    float *a = draw(one), *b = draw(other);
    const bool alike = memcmp(a, b, VALUES * sizeof *a) == 0;

    free(a);
    free(b);
    return alike;
}

static const char upon_pigment[] = "pigment { uv_mapping " CHECKS " }";

static void it_counts_for_a_pigment_a_texture_and_a_material(void **state)
{
    (void)state;
    assert_false(are_alike("pigment { " CHECKS " }", upon_pigment));
    assert_true(are_alike("uv_mapping pigment { " CHECKS " }", upon_pigment));
    assert_true(are_alike("uv_mapping texture { pigment { " CHECKS " } }", upon_pigment));
    assert_true(are_alike("uv_mapping material { texture { pigment { " CHECKS " } } }", upon_pigment));
}

static void it_counts_for_every_layer(void **state)
{
    (void)state;
    assert_true(are_alike("uv_mapping texture { pigment { " CHECKS " } } texture { pigment { " STRIPES " } }",
                          "texture { pigment { uv_mapping " CHECKS " } } texture { pigment { uv_mapping " STRIPES " } }"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_counts_for_a_pigment_a_texture_and_a_material),
        cmocka_unit_test(it_counts_for_every_layer),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
