/* A normal of the camera bends its rays. */
#include "support/check.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 9, HEIGHT = 7 };

/* What the middle of the picture sees of a small sphere in direction (x, y, 1). */
static float middle(const char *normal, double x, double y, int samples)
{
    char text[512];
    float *picture, seen;

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 } camera { location <3, 4, 5> %s }\n"
             "sphere { <3 + 10 * %f, 4 + 10 * %f, 15>, 0.1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }", normal, x, y);
    picture = scenes_draw(text, WIDTH, HEIGHT, samples, 0);
    seen = picture[4 * (HEIGHT / 2 * WIDTH + WIDTH / 2)];
    free(picture);
    return seen;
}

/* A slope of 1 along x turns a normal by 4/30 of the amount. */
static void the_slope_of_a_pattern_bends_rays(void **state)
{
    static const char slope[] = "normal { gradient x, 0.75 translate -0.5 * x }";

    (void)state;
    assert_true(middle("", 0.0, 0.0, 0) == 1.0f);
    assert_true(middle(slope, 0.0, 0.0, 0) == 0.0f);
    assert_true(middle(slope, -0.1, 0.0, 0) == 1.0f);
    assert_true(middle(slope, -0.1, 0.0, 16) > 0.0f);
    assert_true(middle("normal { gradient y, -0.75 translate -0.5 * y }", 0.0, 0.1, 0) == 1.0f);
    assert_true(middle("normal { bumps 0 }", 0.0, 0.0, 0) == 1.0f);
}

static void it_is_bent_by_the_place_in_the_picture(void **state)
{
    (void)state;
    assert_true(middle("normal { gradient x, 0.75 }", -0.1, 0.0, 0) == 0.0f);   /* where the gradient begins anew */
    assert_true(middle("normal { gradient x, 0.75 scale 4 translate 2 * x }", -0.1, 0.0, 0) == 1.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_slope_of_a_pattern_bends_rays),
        cmocka_unit_test(it_is_bent_by_the_place_in_the_picture),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
