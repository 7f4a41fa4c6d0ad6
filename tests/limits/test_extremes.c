/* test_extremes.c - F2 and F3: at sizes and ratios where doubles end, tree and list agree, and nothing is hit that is not
 * there. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/povtrace.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 32, HEIGHT = 24 };

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

/* Pixels that are brighter than the background, which is 1/4. */
static int bright(void *context, const char *text, pov_accel accel)
{
    pov_load_desc load = POV_INIT(load);
    pov_render_desc desc = POV_INIT(desc);
    pov_scene *scene;
    pov_error err;
    float *pixels;
    int count = 0;

    load.accel = accel;
    if (pov_scene_load_text(&scene, context, text, strlen(text), "extremes.pov", &load, &err) != POV_OK)
        fail_msg("%s", err.message);
    desc.width = WIDTH;
    desc.height = HEIGHT;
    pixels = scenes_render(scene, &desc);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        count += pixels[4 * i] > 0.5f;
    free(pixels);
    pov_scene_destroy(scene);
    return count;
}

static void f2_a_camera_of_any_distance_sees_what_the_tree_holds(void **state)
{
    for (int e = 10; e <= 100; e += e < 48 ? 1 : 13) {
        char text[512];
        int tree, list;

        sprintf(text, "#version 3.7; background { rgb 1/4 } camera { location <0,0,-1e%d> direction <0,0,1e%d> right <4,0,0> up <0,3,0> }"
                      " sphere { <0,0,0>, 1 pigment { rgb 1 } finish { ambient 1 } }"
                      " box { <-2,-2,5>, <2,2,6> pigment { rgb .8 } finish { ambient 1 } }", e, e);
        tree = bright(*state, text, POV_ACCEL_TREE);
        list = bright(*state, text, POV_ACCEL_NONE);
        if (tree != WIDTH * HEIGHT || list != tree)
            fail_msg("1e%d: %d in the tree, %d in the list", e, tree, list);
    }
}

/* An ellipsoid that is as good as a disc: from within its plane it is not seen, from above it is. */
static void f3_a_quadric_of_far_apart_coefficients_is_not_hit_beside_it(void **state)
{
    static const char *const cameras[] = { "location 0 direction z", "location <0,5,3> look_at <0,0,3>" };

    for (int e = 20; e <= 300; e += e < 90 ? 2 : 30)
        for (int i = 0; i < 4; i++) {
            char text[512];
            int seen;

            sprintf(text, "#version 3.7; background { rgb 1/4 } camera { %s } quadric { <1,1e%d,1>, <0,0,0>, <0,0,-6>, 8 pigment { rgb 1 } finish { ambient 1 } }"
                          " sphere { <50,50,50>, .1 }", cameras[i / 2], e);
            seen = bright(*state, text, i % 2 ? POV_ACCEL_TREE : POV_ACCEL_NONE);
            if (i < 2 ? seen > 0 : seen < 50)
                fail_msg("1e%d from %s: %d pixels", e, cameras[i / 2], seen);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(f2_a_camera_of_any_distance_sees_what_the_tree_holds, begin, end),
        cmocka_unit_test_setup_teardown(f3_a_quadric_of_far_apart_coefficients_is_not_hit_beside_it, begin, end),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
