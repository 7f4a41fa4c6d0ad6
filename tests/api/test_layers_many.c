/* Layers of surfaces side by side give each what it gives alone. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/trace.h>

#include <stdio.h>
#include <string.h>

enum { EDGE = 24, COUNT = EDGE * EDGE };

static void aim(pov_vec3 *org, pov_vec3 *dir)
{
    for (int i = 0; i < COUNT; i++) {
        org[i] = pov_vec3_of(0.0, 1.0, -4.0);
        dir[i] = pov_vec3_of((i % EDGE - 0.5 * EDGE) / EDGE, (0.2 * EDGE - i / EDGE) / EDGE, 1.0);
    }
}

static void compare(const char *text)
{
    static pov_vec3 org[COUNT], dir[COUNT];
    static float together[COUNT][4];
    const pov_found found = { .size = sizeof found, .rgba = together[0] };
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, text);
    pov_tracer *tracer;
    pov_error err;
    int off = 0, seen = 0;

    aim(org, dir);
    assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
    assert_int_equal(pov_trace_many(tracer, COUNT, org, dir, &found, &err), POV_OK);
    for (int i = 0; i < COUNT; i++) {
        float alone[4];

        assert_int_equal(pov_trace_color(tracer, org[i], dir[i], alone, &err), POV_OK);
        off += memcmp(alone, together[i], sizeof alone) != 0;
        seen += alone[0] > 0.0f;
    }
    assert_int_equal(off, 0);
    assert_true(seen > COUNT / 2);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

/* Layers over one another, some opaque, some so dark that nothing below is seen, with other textures beside them. */
#define SCENE                                                                                                                  \
    "light_source { <3,5,-4> rgb 1 } light_source { <-4,2,-3> rgb <.2,.3,.4> }\n"                                              \
    "#declare Deep = texture { pigment { granite color_map { [0 rgb .2] [1 rgb <1,.8,.5>] } } finish { ambient .1 } }\n"       \
    "texture { pigment { checker rgbf <1,.9,.8,.6> rgb <.3,.9,.2> scale .3 } finish { ambient .2 diffuse .4 } }\n"              \
    "texture { pigment { bozo color_map { [.4 rgbt <.2,.9,.8,.5>] [.6 rgbft <.9,.1,.2,.3,.6>] } scale .2 } finish { emission .1 } }\n" \
    "texture { pigment { agate color_map { [.7 rgbt 1] [.8 rgbf <0,.001,0,1>] } scale .2 } finish { diffuse 0 ambient 0 } }\n"  \
    "plane { y, -1 texture { Deep } }\n"                                                                                       \
    "sphere { <-1,0,0>, 1 texture { Deep scale .5 } }\n"                                                                       \
    "sphere { <1,0,0>, 1 texture { checker texture { Deep } texture { pigment { wood scale .2 } } scale .7 } }\n"

static void layers_side_by_side_are_those_of_each_alone(void **state)
{
    static const char *const versions[] = { "3.7", "3.5", "3.1" };
    (void)state;

    for (size_t i = 0; i < sizeof versions / sizeof *versions; i++) {
        char text[4096];

        snprintf(text, sizeof text, "#version %s; global_settings { assumed_gamma 1 max_trace_level 3 }\n%s", versions[i], SCENE);
        compare(text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layers_side_by_side_are_those_of_each_alone),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
