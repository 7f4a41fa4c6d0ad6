/* Pixels that lend each other what their rays find have errors that are alike: these are not seen as squares. */
#include "support/check.h"
#include "support/scenes.h"

#include <stdlib.h>

enum { EDGE = 96, SQUARE = 8, SAMPLES = 16 };

/* All of the floor has the same light, from a bright part of the sky that a third of the rays meets. */
static const char text[] =
    "#version 3.7; global_settings { assumed_gamma 1 radiosity { } }\n"
    "camera { orthographic location y right x * 4 up z * 4 direction -y }\n"
    "sky_sphere { pigment { gradient y color_map { [0 rgb 0] [.8 rgb 0] [.8 rgb 3] [1 rgb 3] } } }\n"
    "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n";

static double mean_of(const float *rgba, int left, int top, int edge)
{
    double sum = 0.0;

    for (int i = 0; i < edge * edge; i++)
        sum += (double)rgba[4 * ((top + i / edge) * EDGE + left + i % edge)];
    return sum / (edge * edge);
}

/* The mean square of the errors of squares that begin at `from`, and of which none leaves the picture. */
static double error_of_squares(const float *rgba, int from)
{
    const double mean = mean_of(rgba, 0, 0, EDGE);
    double sum = 0.0;
    int count = 0;

    for (int y = from; y + SQUARE <= EDGE; y += SQUARE)
        for (int x = from; x + SQUARE <= EDGE; x += SQUARE, count++) {
            const double off = mean_of(rgba, x, y, SQUARE) - mean;

            sum += off * off;
        }
    return sum / count;
}

/* Were the squares those that lend, those between them would have a quarter of their error. */
static void what_pixels_lend_is_not_seen_as_squares(void **state)
{
    float *rgba = scenes_draw(text, EDGE, EDGE, SAMPLES, 2);
    const double on = error_of_squares(rgba, 0), between = error_of_squares(rgba, SQUARE / 2);

    (void)state;
    assert_true(on > 0.0);
    if (on > 2.5 * between)
        fail_msg("%g in the squares, %g between them", on, between);
    free(rgba);
}

/* In a picture of one sample a pixel those of two sets alternate, and half of the error goes where means are taken. Were all of a square of
 * one set, none would. */
static void the_first_sample_hides_its_squares(void **state)
{
    float *rgba = scenes_draw(text, EDGE, EDGE, 1, 2);
    const double mean = mean_of(rgba, 0, 0, EDGE), squares = error_of_squares(rgba, 0);
    double pixels = 0.0;

    (void)state;
    for (int i = 0; i < EDGE * EDGE; i++)
        pixels += ((double)rgba[4 * i] - mean) * ((double)rgba[4 * i] - mean) / (EDGE * EDGE);
    assert_true(squares > 0.0);
    if (squares > 0.7 * pixels)
        fail_msg("%g in squares, %g in pixels", squares, pixels);
    free(rgba);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_pixels_lend_is_not_seen_as_squares),
        cmocka_unit_test(the_first_sample_hides_its_squares),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
