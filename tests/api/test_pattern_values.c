/* What shapes the values of some patterns. First the slope pattern on a plane that rises at 45 degrees, by height, against what POV-Ray 3.7 gives there. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 4, HEIGHT = 8, ROWS = 4 };

/* Rows from the top, at the heights 1.75, 1.25, 0.75, 0.25; the normal's angle alone is 0.75. */
typedef struct slope { const char *pattern; double values[ROWS]; } slope;

/* moved: along itself. */
static void assert_slope(const slope *s, const char *moved)
{
    char text[512];
    float *picture;

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 }\n"
             "camera { orthographic location <0,0,-10> look_at 0 right 2*x up 4*y }\n"
             "plane { <0,1,-1>, 0 pigment { slope { %s } color_map { [0 rgb 0] [1 rgb 1] } } finish { ambient 1 diffuse 0 } %s }\n",
             s->pattern, moved);
    picture = scenes_draw(text, WIDTH, HEIGHT, 1, 1);
    for (int row = 0; row < ROWS; row++)
        if (fabs((double)picture[4 * row * WIDTH] - s->values[row]) > 1e-4)
            fail_msg("slope { %s }: row %d is %f", s->pattern, row, (double)picture[4 * row * WIDTH]);
    free(picture);
}

static void the_lengths_of_both_vectors_are_their_weights(void **state)
{
    static const slope slopes[] = {
        { "y", { 0.75, 0.75, 0.75, 0.75 } },
        { "y altitude y", { 0.25, 1.0, 0.75, 0.5 } },
        { "y altitude y*3", { 0.5, 0.125, 0.75, 0.375 } },
        { "y*2 altitude y", { 0.0833, 0.9167, 0.75, 0.5833 } },
        { "y altitude y, 0, 2", { 0.8125, 0.6875, 0.5625, 0.4375 } },
        { "y*3, .2, .7 altitude y*2, -1, 1", { 0.21, 0.11, 0.01, 0.91 } },
        { "y, .3", { 0.5, 0.5, 0.5, 0.5 } },
        { "y altitude y, .5", { 0.125, 0.625, 0.125, 0.625 } },
        { "0 altitude y", { 0.75, 0.25, 0.75, 0.25 } },
    };
    (void)state;

    for (size_t i = 0; i < sizeof slopes / sizeof slopes[0]; i++)
        assert_slope(&slopes[i], "");
}

static void the_place_of_a_slope_is_in_the_world(void **state)
{
    static const slope slopes[] = {
        { "point_at <1,2,-3>", { 0.7457, 0.7744, 0.8048, 0.833 } },
        { "point_at <0,3,0>, .2", { 0.593, 0.593, 0.8745, 0.1709 } },
        { "point_at <0,3,0>, .2, .7", { 0.3628, 0.3628, 0.2502, 0.1316 } },
        { "point_at 0", { 0.5, 0.5, 0.5, 0.5 } },
    };
    (void)state;

    for (size_t i = 0; i < sizeof slopes / sizeof slopes[0]; i++) {
        assert_slope(&slopes[i], "");
        assert_slope(&slopes[i], "translate <3, 1, 1>");
    }
}

typedef struct seen_value { const char *pattern; double value; } seen_value;

/* At <0, 0, 1>. */
static void assert_seen(const seen_value *seen)
{
    char text[512];
    float *picture;

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 }\n"
             "plane { z, 1 pigment { %s color_map { [0 rgb 0] [1 rgb 1] } } finish { ambient 1 diffuse 0 } }\n", seen->pattern);
    picture = scenes_draw(text, 1, 1, 1, 1);
    if (fabs((double)picture[0] - seen->value) > 1e-4)
        fail_msg("%s is %f", seen->pattern, (double)picture[0]);
    free(picture);
}

/* As measured: the other patterns' period is a little more than 1 where there is a frequency. */
static void functions_repeat_with_a_period_of_one(void **state)
{
    static const seen_value seen[] = {
        { "function { 10000.25 }", 0.25 }, { "function { 10000.25 } frequency 2 phase .1", 0.6 }, { "function { 10000.25 } frequency 0", 0.25 },
        { "function { 1 }", 1.0 }, { "function { -10000.25 }", 0.85 },
    };
    (void)state;

    for (size_t i = 0; i < sizeof seen / sizeof seen[0]; i++)
        assert_seen(&seen[i]);
}

/* The sequence of .5 leaves after three steps, that of .3 after ten. */
static void steps_of_fractals_may_begin_again(void **state)
{
    static const seen_value seen[] = {
        { "mandel 20 exterior 7, 2 translate -.5*x", 0.5 },    { "mandel 20 exterior 7, 2.9 translate -.5*x", 1.0 / 2.9 },
        { "mandel 20 exterior 8, 2 translate -.5*x", 0.0 },    { "mandel 20 exterior 8, 3 translate -.5*x", 1.0 },
        { "mandel 20 exterior 7, -6 translate -.5*x", 0.5 },   { "mandel 20 exterior 8, 0 translate -.5*x", 0.0 },
        { "mandel 20 exterior 7, 4 translate -.3*x", 0.5 },
    };
    (void)state;

    for (size_t i = 0; i < sizeof seen / sizeof seen[0]; i++)
        assert_seen(&seen[i]);
}

/* v of a sor's caps goes on from 0 and 1 at their rims to -1 and 2 on the axis. */
static void caps_of_a_sor_go_on_from_their_rims(void **state)
{
    static const double places[][3] = { { 0.35, 10.0, 1.5 }, { 0.6, 10.0, 2.0 - 0.6 / 0.7 }, { 0.1, -10.0, -0.75 }, { 0.3, -10.0, -0.25 } };

    (void)state;
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        char text[512];
        float *picture;

        snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 }\n"
                 "camera { orthographic location <%g, %g, 0> direction <0, %g, 0> right .001*x up .001*z }\n"
                 "sor { 4 <.3, -1> <.4, -.7> <.7, 0> <.5, .6> uv_mapping pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } scale 8 "
                 "translate -4*y } finish { ambient 1 diffuse 0 } }\n", places[i][0], places[i][1], -places[i][1]);
        picture = scenes_draw(text, 1, 1, 1, 1);
        if (fabs(8.0 * (double)picture[0] - 4.0 - places[i][2]) > 1e-3)
            fail_msg("%f instead of %f", 8.0 * (double)picture[0] - 4.0, places[i][2]);
        free(picture);
    }
}

static float *seen_of(const char *pattern, const char *shape)
{
    char text[1024];

    snprintf(text, sizeof text, "#version 3.7; camera { orthographic location <.3,.4,-10> direction z right 2*x up 4*y }\n"
             "plane { z, 0 pigment { %s %s } finish { ambient 1 diffuse 0 } }\n", pattern, shape);
    return scenes_draw(text, WIDTH, HEIGHT, 1, 1);
}

/* What up to `limit` steps of squares and c find: interior types from 1 to 5, exterior ones from 1 to 6. */
static double square_value(double x, double y, const double *c, int limit, int interior, int exterior)
{
    double least = x * x + y * y;
    bool escaped = false;
    int k = 0;

    while (k < limit && !escaped) {
        const double re = x * x - y * y + c[0], im = 2.0 * x * y + c[1];

        x = re;
        y = im;
        escaped = x * x + y * y > 4.0;
        least = escaped ? least : fmin(least, x * x + y * y);
        k += !escaped;
    }
    {
        const double of[] = { 0.0, escaped ? (double)k / limit : sqrt(least), x, y, x * x, y * y, sqrt(x * x + y * y) };

        return of[escaped ? exterior : interior] * (escaped && exterior > 1 ? 0.2 : 1.0);
    }
}

/* Inside, sequences of this c come to rounds of three places. */
static void long_sequences_end_where_their_steps_lead(void **state)
{
    static const int limits[] = { 1, 7, 8, 9, 50, 1200, 1201, 1202, 1203, 1207 };
    static const double c[] = { -0.12, 0.74 };

    (void)state;
    for (size_t i = 0; i < 5 * sizeof limits / sizeof limits[0]; i++) {
        const int limit = limits[i / 5], type = 1 + (int)(i % 5);
        char text[256];
        float *seen;

        snprintf(text, sizeof text, "julia <-.12, .74>, %d interior %d, 1 exterior %d, .2 frequency .05 phase .5 color_map { [0 rgb 0] [1 rgb 1] }",
                 limit, type, type + 1);
        seen = seen_of(text, "");
        for (int k = 0; k < WIDTH * HEIGHT; k++) {
            const double x = 0.3 + 2.0 * ((k % WIDTH + 0.5) / WIDTH - 0.5), y = 0.4 + 4.0 * (0.5 - (k / WIDTH + 0.5) / HEIGHT);
            const double value = square_value(x, y, c, limit, type, type + 1);

            if (fabs(20.0 * ((double)seen[4 * k] - 0.5) - value) > 1e-4)
                fail_msg("%s: pixel %d is %f instead of %f", text, k, 20.0 * ((double)seen[4 * k] - 0.5), value);
        }
        free(seen);
    }
}

static void without_a_frequency_a_phase_moves_neither_quilts_nor_images(void **state)
{
    static const char *const patterns[] = { "quilted control0 .3 control1 .7", "image_pattern { function 8, 8 { x*y } }" };
    const size_t bytes = sizeof(float[4]) * WIDTH * HEIGHT;

    (void)state;
    for (size_t i = 0; i < sizeof patterns / sizeof patterns[0]; i++) {
        float *as_is = seen_of(patterns[i], ""), *moved = seen_of(patterns[i], "phase .3"), *folded = seen_of(patterns[i], "frequency 1 phase .3");

        assert_memory_equal(as_is, moved, bytes);
        assert_memory_not_equal(as_is, folded, bytes);
        free(as_is);
        free(moved);
        free(folded);
    }
}

static void colours_that_are_left_out_are_those_of_the_pattern(void **state)
{
    static const struct { const char *pattern; double red, green, blue; } seen[] = {
        { "object { sphere { 0, .5 } }", 0.0, 1.0, 0.0 },    { "object { sphere { 9, .5 } }", 0.0, 0.0, 1.0 },
        { "object { sphere { 0, .5 } rgb 1 }", 0.0, 1.0, 0.0 }, { "julia <0, 0>, 20", 1.0, 1.0, 1.0 },
        { "julia <3, 0>, 20", 0.0, 0.0, 0.0 },               { "magnet 1 julia <.2, .3>, 20", 1.0, 1.0, 1.0 },
        { "mandel 20", 0.0, 1.0, 1.0 },
        /* A pattern's own map is not that of another that comes instead; a map that was written is. */
        { "#declare P = pigment { mandel 20 }; P julia <0, 0>, 20", 1.0, 1.0, 1.0 },
        { "#declare P = pigment { julia <0, 0>, 20 }; P mandel 20", 0.0, 1.0, 1.0 },
        { "#declare P = pigment { mandel 20 color_map { [0 rgb 0] [1 rgb <1, 0, 0>] } }; P julia <0, 0>, 20", 1.0, 0.0, 0.0 },
        /* Behind an image the frequency is 0, and a phase does nothing. */
        { "#declare P = pigment { image_map { function 4, 4 { x } } }; P gradient x phase .3", 0.1, 0.1, 0.1 },
    };

    (void)state;
    for (size_t i = 0; i < sizeof seen / sizeof seen[0]; i++) {
        char text[512];
        float *p;

        snprintf(text, sizeof text, "#version 3.7; camera { orthographic location <.1,.1,-10> direction z right .001*x up .001*y }\n"
                 "plane { z, 0 pigment { %s } finish { ambient 1 diffuse 0 } }\n", seen[i].pattern);
        p = scenes_draw(text, 1, 1, 1, 1);
        if (fabs((double)p[0] - seen[i].red) + fabs((double)p[1] - seen[i].green) + fabs((double)p[2] - seen[i].blue) > 1e-5)
            fail_msg("%s: %f %f %f", seen[i].pattern, (double)p[0], (double)p[1], (double)p[2]);
        free(p);
    }
}

/* As in POV-Ray: a wall that stands in the middle of the coordinates shows the tiles behind it. */
static void a_side_belongs_to_the_tile_behind_it(void **state)
{
    static const char *const patterns[] = { "triangular", "hexagon", "square", "tiling 5", "tiling 6", "tiling 9", "tiling 11", "tiling 18", "tiling 22" };

    (void)state;
    for (size_t i = 0; i < sizeof patterns / sizeof patterns[0]; i++) {
        float *on = seen_of(patterns[i], ""), *behind = seen_of(patterns[i], "translate -1e-6*z");

        for (int k = 0; k < 4 * WIDTH * HEIGHT; k++)
            if (fabs((double)on[k] - (double)behind[k]) > 1e-4)
                fail_msg("%s: value %d is %f, not %f", patterns[i], k, (double)on[k], (double)behind[k]);
        free(on);
        free(behind);
    }
}

/* By the angle at which light falls upon them, on either side. */
static void light_through_slopes_is_filtered_by_its_own_ray(void **state)
{
    static const struct { const char *normal, *pattern; double seen; } discs[] = {
        { "<.2,.3,1>", "slope { <.2,.5,1> }", 0.05403 }, { "-<.2,.3,1>", "slope { <.2,.5,1> }", 0.05403 },
        { "<.2,.3,-1>", "slope { <.2,.5,1> }", 0.26588 }, { "<.2,.3,1>", "aoi", 0.11014 }, { "-<.2,.3,1>", "aoi", 0.11014 },
    };

    (void)state;
    for (size_t i = 0; i < sizeof discs / sizeof discs[0]; i++) {
        char text[768];
        float *seen;

        snprintf(text, sizeof text, "#version 3.7; camera { orthographic location <0,0,-10> direction z right .002*x up .001*y }\n"
                 "light_source { <0,0,-1e6> rgb 1 parallel point_at 0 } plane { -z, -5 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n"
                 "disc { 0, %s, 3 no_image pigment { %s color_map { [0 rgbt <0,0,0,1>] [1 rgbt <1,.5,.2,0>] } } }\n", discs[i].normal, discs[i].pattern);
        seen = scenes_draw(text, 2, 1, 1, 1);
        if (fabs((double)seen[0] - discs[i].seen) > 2e-4)
            fail_msg("%s on %s: %f, not %f", discs[i].pattern, discs[i].normal, (double)seen[0], discs[i].seen);
        free(seen);
    }
}

/* A bent normal's component across a plane that is seen from the front, in halves of that along the view. */
static double halves(const float *by_x, const float *by_y, int i, bool along_y)
{
    const double pi = 3.14159265358979323846;
    const double x = cos(pi * (1.0 - (double)by_x[4 * i])), y = cos(pi * (1.0 - (double)by_y[4 * i]));

    return 2.0 * (along_y ? y : x) / sqrt(1.0 - x * x - y * y);
}

/* As measured: a bump_map by index has whole heights between pixels, too. */
static void heights_by_index_are_whole_between_pixels(void **state)
{
    static const char bumps[] = "} normal { bump_map { gif \"" TEST_ROOT "/scenes/test/images/tiles.gif\" use_index interpolate 2 bump_size 1 } scale 3";
    char text[512];
    float *by_x, *by_y;
    double most = 0.0;

    (void)state;
    snprintf(text, sizeof text, "color_map { [0 rgb 0] [1 rgb 1] } %s", bumps);
    by_x = seen_of("slope x", text);
    by_y = seen_of("slope y", text);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        for (int k = 0; k < 2; k++) {
            const double n = halves(by_x, by_y, i, k);

            if (fabs(n - floor(n + 0.5)) > 1e-3 * (1.0 + fabs(n)))
                fail_msg("pixel %d is bent by %f", i, n);
            most = fmax(most, fabs(n));
        }
    assert_true(most > 0.9);
    free(by_x);
    free(by_y);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(functions_repeat_with_a_period_of_one),
        cmocka_unit_test(caps_of_a_sor_go_on_from_their_rims),
        cmocka_unit_test(steps_of_fractals_may_begin_again),
        cmocka_unit_test(long_sequences_end_where_their_steps_lead),
        cmocka_unit_test(the_lengths_of_both_vectors_are_their_weights),
        cmocka_unit_test(the_place_of_a_slope_is_in_the_world),
        cmocka_unit_test(light_through_slopes_is_filtered_by_its_own_ray),
        cmocka_unit_test(colours_that_are_left_out_are_those_of_the_pattern),
        cmocka_unit_test(a_side_belongs_to_the_tile_behind_it),
        cmocka_unit_test(without_a_frequency_a_phase_moves_neither_quilts_nor_images),
        cmocka_unit_test(heights_by_index_are_whole_between_pixels),
    };

    return cmocka_run_group_tests_name("values of patterns", tests, NULL, NULL);
}
