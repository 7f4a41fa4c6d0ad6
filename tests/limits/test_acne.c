/* test_acne.c - a convex solid, lit from beside the camera, casts no shadow on what the camera sees of it. So its
 * picture is bit for bit the one in which it casts none at all, wherever it stands and however large it is. */
#include "support/check.h"
#include "support/limits.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 48, HEIGHT = 48 };

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

static const char *const solids[] = {
    "sphere { @p{0.25,0.5,0}, @l{1}",
    "box { @p{-1,-0.5,-0.75}, @p{0.75,1,0.5}",
    "cone { @p{0,-1,0}, @l{1}, @p{0.25,1,0.125}, @l{0.25}",
    "cone { @p{0,-1,0}, @l{0.75}, @p{0.25,1,0.125}, @l{0}",
    "cylinder { @p{-0.5,-0.75,0}, @p{0.5,0.75,-0.25}, @l{0.5}",
    "quadric { <1,0.5,2>, <0.25,0.125,0.5>, <0,0,0>, @s{-0.75} translate @p{0,0,0}",
    "polygon { 4, @p{-1,-1,0}, @p{1,-1,-0.5}, @p{1,1,-1}, @p{-1,1,-0.5}",
    "sphere { <0,0,0>, @l{1} scale <1,0.25,0.5> rotate <30,40,50> translate @p{0,0,0}",
    "box { @v{-1,-0.5,-0.5}, @v{1,0.5,0.5} rotate <30,40,50> translate @p{0,0,0}",
    "cylinder { @v{0,-1,0}, @v{0,1,0}, @l{1} scale <1,0.5,0.75> rotate <60,40,20> translate @p{0,0,0}",
    "sphere { <0,0,0>, 1 scale @l{1} rotate <10,0,0> translate @p{0,0,0}",
};

enum { SOLIDS = (int)(sizeof solids / sizeof *solids) };

static float *picture(void *context, const char *solid, const char *shadow, const limits_frame *f)
{
    char text[1024];

    sprintf(text,
            "#version 3.7; global_settings { assumed_gamma 1 } background { color rgb <0,0,1> }\n"
            "camera { location @p{0.5,1,-5} look_at @p{0,0,0} angle 40 right <1,0,0> }\n"
            "light_source { @p{0.5,1,-5} color rgb 1 }\n"
            "%s pigment { color rgb 1 } finish { ambient 0.25 diffuse 0.5 } %s }\n", solid, shadow);
    return limits_picture(context, text, f, WIDTH, HEIGHT);
}

static void hold(void *context, int solid, const limits_frame *f)
{
    const float background[3] = { 0.0f, 0.0f, 1.0f };
    float *with = picture(context, solids[solid], "", f), *without = picture(context, solids[solid], "no_shadow", f);
    const long off = limits_count(with, without, WIDTH, HEIGHT, 0.0f);
    const long empty = limits_count_colour(with, WIDTH, HEIGHT, background, 0.0f);

    if (off || empty > WIDTH * HEIGHT - 100)
        print_error("%s...: size %g at %g: %ld spots of shadow, %ld pixels empty\n", solids[solid], f->scale, f->move.x,
                    off, empty);
    assert_int_equal(off, 0);
    assert_true(empty < WIDTH * HEIGHT - 100);
    free(with);
    free(without);
}

static void no_size_gives_acne(void **state)
{
    static const double scales[] = { 1e-100, 1e-12, 1e-7, 1e-4, 1e-2, 1.0, 1e3, 1e6, 1e9, 1e12, 1e100 };

    for (int i = 0; i < SOLIDS; i++)
        for (size_t k = 0; k < sizeof scales / sizeof *scales; k++) {
            limits_frame f = { 1.0, { 0.0, 0.0, 0.0 } };
            f.scale = scales[k];
            hold(*state, i, &f);
        }
}

static void no_place_gives_acne(void **state)
{
    static const double moves[] = { 1e4, 1e6, 1e7, 1e8, 1e9 };

    for (int i = 0; i < SOLIDS; i++)
        for (size_t k = 0; k < sizeof moves / sizeof *moves; k++) {
            limits_frame f = { 1.0, { 0.0, 0.0, 0.0 } };
            f.move = pov_vec3_of(moves[k], -0.5 * moves[k], 3.0 * moves[k]);
            hold(*state, i, &f);
        }
}

/* Inside a closed opaque shell nothing is seen of the light outside. */
static void no_shell_leaks(void **state)
{
    static const char *const shells[] = {
        "sphere { @p{0,0,0}, @l{2}",
        "box { @p{-2,-1,-1.5}, @p{1.5,1,2}",
        "cylinder { @p{-2,-1,0}, @p{2,1,0.5}, @l{1}",
        "cone { @p{0,-2,0}, @l{2}, @p{0.5,2,0}, @l{0.25}",
        "quadric { <1,0.5,2>, <0.25,0.125,0.5>, <0,0,0>, @s{-1} translate @p{0,0,0}",
        "box { @v{-2,-1,-1}, @v{2,1,1} rotate <30,40,50> translate @p{0,0,0}",
    };
    static const limits_frame frames[] = {
        { 1.0, { 0.0, 0.0, 0.0 } }, { 1e-12, { 0.0, 0.0, 0.0 } }, { 1e12, { 0.0, 0.0, 0.0 } }, { 1.0, { 1e9, 1e9, -1e9 } },
        { 0x1p-20, { 1024.0, -512.0, 768.0 } }, { 1e-100, { 0.0, 0.0, 0.0 } }, { 1e100, { 0.0, 0.0, 0.0 } },
    };
    const float black[3] = { 0.0f, 0.0f, 0.0f };

    for (size_t i = 0; i < sizeof shells / sizeof *shells; i++)
        for (size_t k = 0; k < sizeof frames / sizeof *frames; k++) {
            char text[1024];
            float *seen;
            long dark;

            sprintf(text,
                    "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 4 } background { color rgb 1 }\n"
                    "camera { location @p{0.125,0.0625,-0.25} look_at @p{0.5,-0.25,1} angle 150 right <1,0,0> }\n"
                    "light_source { @p{5,8,-9} color rgb 1 } light_source { @p{-15,-18,11} color rgb 1 }\n"
                    "%s pigment { color rgb 1 } finish { ambient 0 diffuse 1 phong 1 reflection 0.5 } }\n", shells[i]);
            seen = limits_picture(*state, text, &frames[k], WIDTH, HEIGHT);
            dark = limits_count_colour(seen, WIDTH, HEIGHT, black, 0.0f);
            if (dark != WIDTH * HEIGHT)
                print_error("%s...: size %g at %g: %ld pixels leak\n", shells[i], frames[k].scale, frames[k].move.x,
                            WIDTH * HEIGHT - dark);
            assert_int_equal(dark, WIDTH * HEIGHT);
            free(seen);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_size_gives_acne),
        cmocka_unit_test(no_place_gives_acne),
        cmocka_unit_test(no_shell_leaks),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
