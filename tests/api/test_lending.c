/* Pixels that lend each other what their rays find have errors that are alike: these are not seen as squares, and change no mean. */
#include "support/check.h"
#include "support/near.h"
#include "support/scenes.h"

#include <math.h>
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

/* The mean square of the steps from one column to the next, behind every SQUARE-th one. */
static double steps_behind(const float *rgba, int column)
{
    double sum = 0.0;
    int count = 0;

    for (int y = 0; y < EDGE; y++)
        for (int x = column; x + 1 < EDGE; x += SQUARE, count++) {
            const double step = (double)rgba[4 * (y * EDGE + x + 1)] - (double)rgba[4 * (y * EDGE + x)];

            sum += step * step;
        }
    return sum / count;
}

/* Independent pixels have twice the square of their error in a step. So have those of two sets that alternate, and of squares it is in the
 * steps between them. */
static void the_light_of_first_samples_has_no_steps(void **state)
{
    float *rgba = scenes_draw(text, EDGE, EDGE, 1, 2);
    const double mean = mean_of(rgba, 0, 0, EDGE);
    double square = 0.0, between = steps_behind(rgba, SQUARE - 1), within = steps_behind(rgba, SQUARE / 2 - 1);

    (void)state;
    for (int i = 0; i < EDGE * EDGE; i++)
        square += ((double)rgba[4 * i] - mean) * ((double)rgba[4 * i] - mean) / (EDGE * EDGE);
    assert_true(square > 0.0);
    if (between > 0.1 * square || within > 0.1 * square)
        fail_msg("%g in pixels, steps of %g within squares and of %g between them", square, within, between);
    free(rgba);
}

/* A picture of one sample a pixel, or of more. */
static float *draw(const char *of, int edge, int samples, unsigned seed, int threads)
{
    pov_render_desc desc = POV_INIT(desc);

    desc.width = desc.height = edge;
    desc.samples = samples;
    desc.seed = seed;
    desc.threads = threads;
    return scenes_draw_as(of, &desc);
}

/* A wall that gives light, and a floor, of which each place sees the wall in half of its directions, however near it is. */
#define WALL(MIDDLE)                                                                                                              \
    "#version 3.7; global_settings { assumed_gamma 1 radiosity { recursion_limit 1 } }\n"                                        \
    "camera { orthographic location <" MIDDLE ", 2, 0> right x * 2 up z * 2 direction -y }\n"                                    \
    "plane { -x, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }\n"                                              \
    "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n"
/* Posts before it and a mirror, whose edges are those of pixels. What is seen in the mirror is lent to nobody. */
#define POSTS                                                                                                                     \
    "#declare i = 0; #while (i < 4)\n"                                                                                           \
    "  box { <.75 + .5 * i, 0, -.75 + .25 * i>, <.875 + .5 * i, .25 + .1 * i, 0> pigment { rgb .5 } finish { ambient 0 diffuse 1 } }\n" \
    "  #declare i = i + 1; #end\n"
#define MIRROR "box { <1.75, .3, .25>, <2.25, .5, .75> pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection .8 } }"

static void near_a_wall_there_is_half_of_its_light(void **state)
{
    enum { ROUNDS = 32, WIDE = 32 };
    double columns[WIDE] = { 0 };

    (void)state;
    for (unsigned round = 0; round < ROUNDS; round++) {
        float *rgba = draw(WALL("1"), WIDE, 1, round, 2);

        for (int i = 0; i < WIDE * WIDE; i++)
            columns[i % WIDE] += (double)rgba[4 * i] / (WIDE * ROUNDS);
        free(rgba);
    }
    for (int x = 0; x < WIDE; x++)
        assert_near(columns[x], 0.5, 0.01);
}

/* Beside a long black wall, under a sky of 1, which is hidden up to the wall's top. One pixel asks for a few beside it who sees what: so a
 * pixel has some of their light, as much from each side but for those next to the wall. */
static void beside_a_wall_pixels_have_their_own_light(void **state)
{
    enum { ROUNDS = 256, WIDE = 24 };
    static const char wall[] =
        "#version 3.7; global_settings { assumed_gamma 1 radiosity { recursion_limit 1 } }\n"
        "camera { orthographic location <.625, 2, 0> right x * 1.5 up z * 1.5 direction -y }\n"
        "background { rgb 1 }\n"
        "box { <-1, 0, -100>, <0, .125, 100> pigment { rgb 0 } }\n"
        "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n";
    double columns[WIDE] = { 0 };

    (void)state;
    for (unsigned round = 0; round < ROUNDS; round++) {
        float *rgba = draw(wall, WIDE, 1, round, 2);

        for (int i = 0; i < WIDE * WIDE; i++)
            columns[i % WIDE] += (double)rgba[4 * i] / (WIDE * ROUNDS);
        free(rgba);
    }
    for (int i = 2; i < WIDE; i++) {
        const double x = (i - 1.5) / 16.0;

        assert_near(columns[i], (1.0 + x / sqrt(x * x + 1.0 / 64.0)) / 2.0, i < 5 ? 0.025 : 0.007);
    }
}

/* The mean over squares of pixels, from first samples that lend to all around and from many, of which few do. */
static void first_samples_have_the_mean_of_many(void **state)
{
    enum { ROUNDS = 256, WIDE = 16, PART = 4, PARTS = WIDE / PART };
    static const char *const scenes[] = { WALL("1.5") POSTS, WALL("1.5") POSTS MIRROR };

    (void)state;
    for (int n = 0; n < 2; n++) {
        double first[PARTS * PARTS] = { 0 }, many[PARTS * PARTS] = { 0 };
        float *rgba = draw(scenes[n], WIDE, 1024, 1000, 2);

        for (int i = 0; i < WIDE * WIDE; i++)
            many[i / WIDE / PART * PARTS + i % WIDE / PART] += (double)rgba[4 * i] / (PART * PART);
        free(rgba);
        for (unsigned round = 0; round < ROUNDS; round++) {
            rgba = draw(scenes[n], WIDE, 1, round, 2);
            for (int i = 0; i < WIDE * WIDE; i++)
                first[i / WIDE / PART * PARTS + i % WIDE / PART] += (double)rgba[4 * i] / (PART * PART * ROUNDS);
            free(rgba);
        }
        for (int i = 0; i < PARTS * PARTS; i++)
            assert_near(first[i], many[i], 0.01);
    }
}

/* Tiles of few threads are large: what lies across their edges is the same. */
static void tiles_change_no_bit(void **state)
{
    enum { WIDE = 150 };
    float *few = draw(WALL("1") POSTS, WIDE, 1, 0, 1), *many = draw(WALL("1") POSTS, WIDE, 1, 0, 16);

    (void)state;
    assert_memory_equal(few, many, 4 * WIDE * WIDE * sizeof *few);
    free(few);
    free(many);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_pixels_lend_is_not_seen_as_squares),
        cmocka_unit_test(the_light_of_first_samples_has_no_steps),
        cmocka_unit_test(near_a_wall_there_is_half_of_its_light),
        cmocka_unit_test(beside_a_wall_pixels_have_their_own_light),
        cmocka_unit_test(first_samples_have_the_mean_of_many),
        cmocka_unit_test(tiles_change_no_bit),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
