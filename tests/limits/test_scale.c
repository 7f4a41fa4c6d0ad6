/* test_scale.c - a scene of everything is the same picture at any size, anywhere, from any distance. */
#include "support/check.h"
#include "support/limits.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 96, HEIGHT = 72, PIXELS = WIDTH * HEIGHT };

static int begin(void **state)
{
    *state = scenes_context();
    return 0;
}

static int end(void **state)
{
    pov_context_destroy(*state);
    return 0;
}

static float *picture(void *context, const char *template, double scale, double x, double y, double z)
{
    limits_frame f;

    f.scale = scale;
    f.move = pov_vec3_of(x, y, z);
    return limits_picture(context, template, &f, WIDTH, HEIGHT);
}

/* So that equality means something. */
static void the_picture_is_full_of_things(void **state)
{
    float *p = picture(*state, limits_everything, 1.0, 0.0, 0.0, 0.0);
    const float background[3] = { 0.25f, 0.375f, 0.5f };
    long changes = 0;

    for (long i = 1; i < PIXELS; i++)
        for (int c = 0; c < 3; c++)
            changes += fabsf(p[4 * i + c] - p[4 * i - 4 + c]) > 1.0f / 255.0f;
    assert_true(changes > PIXELS / 2);
    assert_true(limits_count_colour(p, WIDTH, HEIGHT, background, 0.0f) < PIXELS / 3);
    free(p);
}

static void powers_of_two_change_no_bit(void **state)
{
    static const int exponents[] = { -300, -240, -151, -100, -67, -40, -20, -9, -1, 1, 3, 10, 24, 53, 99, 160, 240, 300 };
    float *home = picture(*state, limits_everything, 1.0, 0.0, 0.0, 0.0);

    for (size_t i = 0; i < sizeof exponents / sizeof *exponents; i++) {
        float *other = picture(*state, limits_everything, ldexp(1.0, exponents[i]), 0.0, 0.0, 0.0);
        const long off = limits_count(home, other, WIDTH, HEIGHT, 0.0f);

        if (off)
            print_error("2^%d: %ld pixels differ\n", exponents[i], off);
        assert_int_equal(off, 0);
        free(other);
    }
    free(home);
}

/* Here coordinates are rounded, each by half a unit in its last place, and edges move by as little: of pixels whose
 * centre lies on an edge to 1e-15 there may be one or two. */
static void no_other_scale_changes_the_picture(void **state)
{
    static const double scales[] = { 1e-100, 1e-30, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 0.1, 3.0, 1e3, 1e5, 1e6,
                                     1e7, 1e8, 1e10, 1e12, 1e30, 1e100 };
    float *home = picture(*state, limits_everything, 1.0, 0.0, 0.0, 0.0);

    for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
        float *other = picture(*state, limits_everything, scales[i], 0.0, 0.0, 0.0);
        const long off = limits_count(home, other, WIDTH, HEIGHT, 1e-5f);

        if (off > 1)
            print_error("%g: %ld pixels differ\n", scales[i], off);
        assert_true(off <= 1);
        free(other);
    }
    free(home);
}

/* The moves are exact on the scene's grid, so this is the same scene, and only roundings of world points differ. */
static void no_move_changes_the_picture(void **state)
{
    static const double moves[] = { 1e3, 1e5, 1e6, 1e7, 3e7, 1e8, 1e9, 1e10, 1e12 };
    float *home = picture(*state, limits_everything, 1.0, 0.0, 0.0, 0.0);

    for (size_t i = 0; i < sizeof moves / sizeof *moves; i++) {
        float *other = picture(*state, limits_everything, 1.0, moves[i], -3.0 * moves[i], 7.0 * moves[i]);
        const long off = limits_count(home, other, WIDTH, HEIGHT, 1e-6f);

        if (off)
            print_error("%g: %ld pixels differ\n", moves[i], off);
        assert_int_equal(off, 0);
        free(other);
    }
    free(home);
}

/* A tiny scene far out, 1e9 of its sizes and more from the origin, still on a grid of doubles. */
static void a_tiny_scene_may_be_far_out(void **state)
{
    const double size = 0x1p-20;
    float *home = picture(*state, limits_everything, size, 0.0, 0.0, 0.0);
    float *other = picture(*state, limits_everything, size, 1024.0, 2048.0, -4096.0);

    assert_int_equal(limits_count(home, other, WIDTH, HEIGHT, 1e-6f), 0);
    free(home);
    free(other);
}

/* The everything scene in a narrow view along z from far off: lines of sight are parallel but for 1 in 1e7 and less, so
 * the pictures differ by edges that move by 1e-7 of the width; lights stand where they stood. */
static void a_narrow_view_from_afar_is_as_good_as_any(void **state)
{
    static const double distances[] = { 1e8, 1e9, 1e10, 1e11, 1e12, 1e13 };
    const char *scene = strstr(limits_everything, "light_source");
    float *near = NULL;

    for (size_t i = 0; i < sizeof distances / sizeof *distances; i++) {
        const double d = distances[i] * 8.0, angle = 2.0 * atan(8.0 / d) * 180.0 / 3.14159265358979323846;
        char *text = malloc(strlen(limits_everything) + 512);
        float *seen;

        assert_non_null(text);
        sprintf(text,
                "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 8 } background { color rgb 0.5 }\n"
                "camera { location <0,3,%.17g> look_at <0,3,0> angle %.17g right <1.3333333,0,0> }\n%s", -d, angle, scene);
        seen = picture(*state, text, 1.0, 0.0, 0.0, 0.0);
        if (near) {
            const long off = limits_count(near, seen, WIDTH, HEIGHT, 1e-4f);
            if (off > 2)
                print_error("from %g: %ld pixels differ\n", d, off);
            assert_true(off <= 2);
            free(seen);
        } else {
            near = seen;
        }
        free(text);
    }
    free(near);
}

#define TEXT TEST_BUILD "/tests/" TEST_COPY "limits/test_scale.pov"
#define IMAGE TEST_BUILD "/tests/" TEST_COPY "limits/test_scale.pfm"

/* What povc makes of a text: three floats a pixel, the lowest row first. */
static void draw_by_povc(const char *text, float *pixels)
{
    const size_t count = 3 * (size_t)PIXELS;
    FILE *f = fopen(TEXT, "w");
    char command[4096];
    int width, height;

    assert_non_null(f);
    assert_true(fputs(text, f) >= 0 && fclose(f) == 0);
    snprintf(command, sizeof command, "'%s' '%s' %d %d '%s' --quiet", TEST_BUILD "/bin/povc", TEXT, WIDTH, HEIGHT, IMAGE);
    assert_int_equal(system(command), 0);
    f = fopen(IMAGE, "rb");
    assert_non_null(f);
    assert_int_equal(fscanf(f, "PF %d %d -1.0%*1[\n]", &width, &height), 2);
    assert_true(width == WIDTH && height == HEIGHT);
    assert_int_equal(fread(pixels, sizeof *pixels, count, f), count);
    fclose(f);
}

/* The command is as good as the library: the same bits, from the extremes of what is asked above. */
static void povc_draws_the_same(void **state)
{
    static const limits_frame frames[] = {
        { 1.0, { 0.0, 0.0, 0.0 } },   { 0x1p-300, { 0.0, 0.0, 0.0 } },    { 0x1p300, { 0.0, 0.0, 0.0 } },
        { 1e-12, { 0.0, 0.0, 0.0 } }, { 1e12, { 0.0, 0.0, 0.0 } },        { 1.0, { 1e9, -3e9, 7e9 } },
        { 1.0, { 1e12, 3e12, 1e12 } }, { 0x1p-20, { 1024.0, 2048.0, -4096.0 } },
    };
    static float drawn[3 * PIXELS];

    for (size_t i = 0; i < sizeof frames / sizeof *frames; i++) {
        float *wanted = limits_picture(*state, limits_everything, &frames[i], WIDTH, HEIGHT);
        char *text = limits_text(limits_everything, &frames[i]);
        long off = 0;

        draw_by_povc(text, drawn);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                off += memcmp(drawn + 3 * ((HEIGHT - 1 - y) * WIDTH + x), wanted + 4 * (y * WIDTH + x), 3 * sizeof *wanted) != 0;
        if (off)
            print_error("scale %g, moved by %g: %ld pixels differ\n", frames[i].scale, frames[i].move.x, off);
        assert_int_equal(off, 0);
        free(text);
        free(wanted);
    }
    remove(TEXT);
    remove(IMAGE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_picture_is_full_of_things),
        cmocka_unit_test(powers_of_two_change_no_bit),
        cmocka_unit_test(no_other_scale_changes_the_picture),
        cmocka_unit_test(no_move_changes_the_picture),
        cmocka_unit_test(a_tiny_scene_may_be_far_out),
        cmocka_unit_test(a_narrow_view_from_afar_is_as_good_as_any),
        cmocka_unit_test(povc_draws_the_same),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
