/* A box without extent along an axis is one surface: rays and light are filtered once, wherever it stands. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 64, HEIGHT = 48 };

static const char *const places[] = {
    "rotate 0", "rotate <10, 20, 30>", "rotate <40, 200, -30> translate <.1, .2, .3>",
    "translate 1e6*z rotate 30*y rotate -30*y translate -1e6*z",
    "scale 1e-9 rotate <10, 20, 30> scale 1e9", "matrix <.8, .1, .2, -.1, .9, .3, .05, -.2, .95, 0, 0, 0>",
};

/* Every pixel shows the background or half of it; returns the number of those. */
static int count_halves(const char *text)
{
    float *picture = scenes_draw(text, WIDTH, HEIGHT, 1, 1);
    int halves = 0;

    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        const float seen = picture[4 * i];

        if (seen != 1.0f && seen != 0.5f)
            fail_msg("%s: pixel %d is %f", text, i, (double)seen);
        halves += seen == 0.5f;
    }
    free(picture);
    return halves;
}

static void a_planar_box_filters_rays_once(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        char text[512];

        snprintf(text, sizeof text, "#version 3.7; camera { location <1, 2, -5> look_at 0 } background { rgb 1 }"
                 "box { <-1, -1, 0>, <1, 1, 0> pigment { rgb 0 transmit .5 } finish { ambient 0 diffuse 0 } %s }", places[i]);
        assert_in_range(count_halves(text), 50, WIDTH * HEIGHT / 2);
    }
}

static void a_planar_box_filters_light_once(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        char text[512];

        snprintf(text, sizeof text, "#version 3.7; camera { location <1, 2, -5> look_at <0, 0, 3> } light_source { <0, 0, -1000> rgb 1 parallel point_at 0 }"
                 "plane { -z, -3 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }"
                 "box { <-1, -1, 0>, <1, 1, 0> pigment { rgb 0 transmit .5 } no_image %s }", places[i]);
        assert_in_range(count_halves(text), 50, WIDTH * HEIGHT / 2);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_planar_box_filters_rays_once),
        cmocka_unit_test(a_planar_box_filters_light_once),
    };

    return cmocka_run_group_tests_name("planar boxes", tests, NULL, NULL);
}
