/* test_doubled_walls.c - walls of a prism that stand there twice bound nothing, by the even-odd rule: it looks as without. */
#include "support/check.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 64, HEIGHT = 48 };

static float *draw(const char *shape)
{
    char text[1000];

    snprintf(text, sizeof text, "#version 3.7; camera { location <-1, 2, -4> look_at y*.5 angle 40 } light_source { <-3, 5, -4> rgb 1 } "
                                "plane { y, 0 pigment { rgb .7 } } %s pigment { rgb 1 } }", shape);
    return scenes_draw(text, WIDTH, HEIGHT, 1, 1);
}

static void expect_alike(const char *doubled, const char *plain)
{
    float *const a = draw(doubled), *const b = draw(plain);

    assert_memory_equal(a, b, sizeof *a * 4 * WIDTH * HEIGHT);
    free(a);
    free(b);
}

static void a_ring_that_goes_on_along_its_own_wall(void **state)
{
    (void)state;
    expect_alike("prism { 0, 1, 6, <-.5, 0>, <.5, 0>, <0, -.75>, <-.5, 0>, <.5, 0>, <0, -.75>",
                 "prism { 0, 1, 4, <-.5, 0>, <.5, 0>, <0, -.75>, <-.5, 0>");
}

static void a_spike(void **state)
{
    (void)state;
    expect_alike("prism { 0, 1, 7, <-.5, 0>, <.5, 0>, <0, .5>, <-.5, 0>, <0, .5>, <1, .5>, <0, .5>",
                 "prism { 0, 1, 4, <-.5, 0>, <.5, 0>, <0, .5>, <-.5, 0>");
}

static void two_rings_that_share_a_wall(void **state)
{
    (void)state;
    expect_alike("prism { 0, 1, 10, <-.5, 0>, <0, 0>, <0, .5>, <-.5, .5>, <-.5, 0>, <0, 0>, <.5, 0>, <.5, .5>, <0, .5>, <0, 0>",
                 "prism { 0, 1, 7, <-.5, 0>, <0, 0>, <.5, 0>, <.5, .5>, <0, .5>, <-.5, .5>, <-.5, 0>");
}

static void curves_that_go_back(void **state)
{
    (void)state;
    expect_alike("prism { bezier_spline 0, 1, 16, <-.5, 0>, <-.5, -.5>, <.5, -.5>, <.5, 0>, <.5, 0>, <.5, 1>, <-.5, 1>, <-.5, 0>, "
                 "<-.5, 0>, <-1, 0>, <-1, 1>, <-.2, 1>, <-.2, 1>, <-1, 1>, <-1, 0>, <-.5, 0>",
                 "prism { bezier_spline 0, 1, 8, <-.5, 0>, <-.5, -.5>, <.5, -.5>, <.5, 0>, <.5, 0>, <.5, 1>, <-.5, 1>, <-.5, 0>");
}

/* Nothing is left of it. */
static void a_wall_there_and_back(void **state)
{
    (void)state;
    expect_alike("prism { 0, 1, 5, <-.5, 0>, <.5, 0>, <0, .5>, <.5, 0>, <-.5, 0>", "sphere { -y, .1");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ring_that_goes_on_along_its_own_wall),
        cmocka_unit_test(a_spike),
        cmocka_unit_test(two_rings_that_share_a_wall),
        cmocka_unit_test(curves_that_go_back),
        cmocka_unit_test(a_wall_there_and_back),
    };

    return cmocka_run_group_tests_name("doubled walls", tests, NULL, NULL);
}
