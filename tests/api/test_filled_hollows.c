/* test_filled_hollows.c - what fills a hollow of a solid lies on its walls: it looks as if it stood in the room that the solid is. */
#include "support/check.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 64, HEIGHT = 48 };

static float *draw(const char *shape, const char *room)
{
    char text[1000];

    snprintf(text, sizeof text, "#version 3.7; camera { location <-.3, -.1, -4> look_at 0 angle 30 } light_source { <-3, 5, -4> rgb .8 } "
                                "%s pigment { rgb 1 } } %s pigment { rgb x } }", shape, room);
    return scenes_draw(text, WIDTH, HEIGHT, 1, 1);
}

/* Rays from the shape to the light start on the walls, too. */
static void expect_filled(const char *shape)
{
    char hollowed[500];
    float *hollow, *room;

    snprintf(hollowed, sizeof hollowed, "difference { box { -90, 90 } %s }", shape);
    hollow = draw(shape, hollowed);
    room = draw(shape, "box { -90, 90");
    assert_memory_equal(hollow, room, sizeof *hollow * 4 * WIDTH * HEIGHT);
    free(hollow);
    free(room);
}

static void what_fills_a_hollow_is_lit(void **state)
{
    (void)state;
    expect_filled("sphere { 0, .8");
    expect_filled("torus { .6, .2 rotate 40*x");
    expect_filled("superellipsoid { <.3, .4> scale .8");
    expect_filled("sor { 5, <.3, -.7>, <.4, -.5>, <.7, 0>, <.4, .5>, <.3, .7>");
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(what_fills_a_hollow_is_lit) };

    return cmocka_run_group_tests_name("filled hollows", tests, NULL, NULL);
}
