/* A textured scene looks the same a thousand million sizes away and a googolth of its size. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/trace.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ACROSS = 32, COUNT = ACROSS * ACROSS, TEXT = 3000 };

/* %s: what moves the whole scene. */
static const char format[] =
    "#version 3.7; #declare M = transform { %s }\n"
    "camera { location <0, 2, -6> look_at 0 angle 40 transform M } light_source { <5, 8, -6> rgb 1 transform M }\n"
    "union { plane { y, -1 pigment { checker rgb 1 rgb .2 } }\n"
    "sphere { <-1.2, 0, 0>, 1 pigment { granite color_map { [0 rgb 1] [1 rgb .3] } scale .5 } normal { bumps .4 scale .1 } finish { phong .4 } }\n"
    "sphere { <1.2, 0, 0>, 1 pigment { bozo turbulence .6 color_map { [0 rgb x] [.5 rgb y] [1 rgb z] } scale .3 rotate 20 } }\n"
    "box { <-.4, .8, -.3>, <.5, 1.6, .4> pigment { crackle scale .2 } rotate y*30 }\n"
    "sphere { <0, -.6, -1.6>, .4 pigment { marble turbulence .7 scale .2 } normal { ripples .3 scale .1 } translate .01*x }\n"
    "transform M }\n";

static void draw(const char *moves, float *rgba)
{
    static pov_vec3 org[COUNT], dir[COUNT];
    const pov_found out = { sizeof out, NULL, NULL, NULL, NULL, rgba, NULL };
    pov_context *context = scenes_context();
    pov_camera camera = POV_INIT(camera);
    char text[TEXT];
    pov_tracer *tracer;
    pov_scene *scene;

    assert_true(snprintf(text, sizeof text, format, moves) < TEXT);
    scene = scenes_text(context, text);
    pov_scene_get_camera(scene, &camera);
    for (int i = 0; i < COUNT; i++)
        assert_true(pov_camera_ray(&camera, (i % ACROSS + 0.5) / ACROSS - 0.5, (i / ACROSS + 0.5) / ACROSS - 0.5, &org[i], &dir[i]));
    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    assert_int_equal(pov_trace_many(tracer, COUNT, org, dir, &out, NULL), POV_OK);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void textures_do_not_swim(void **state)
{
    static const char *const moves[] = { "translate <1e9, -7e8, 3e8>", "scale 1e-100", "translate <1e9, -7e8, 3e8> scale 1e-100" };
    static float here[4 * COUNT], there[4 * COUNT];
    float brightest = 0.0f;

    (void)state;
    draw("translate 0", here);
    for (int i = 0; i < 4 * COUNT; i++)
        brightest = fmaxf(brightest, here[i]);
    assert_true(brightest > 0.5f);
    for (size_t k = 0; k < sizeof moves / sizeof moves[0]; k++) {
        float most = 0.0f;

        draw(moves[k], there);
        for (int i = 0; i < 4 * COUNT; i++)
            most = fmaxf(most, fabsf(there[i] - here[i]));
        if (most > 1e-5f)
            fail_msg("%s: %g", moves[k], (double)most);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(textures_do_not_swim) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
