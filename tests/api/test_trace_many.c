/* Many rays at once find what single ones do. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/trace.h>

#include <math.h>

enum { COUNT = 1000 };

static const char text[] = "#version 3.7; camera { location <0, 1, -4> look_at 0 } light_source { <5, 9, -7> rgb 1 }\n"
                           "sphere { 0, 1 pigment { rgb <1, .5, .2> } finish { reflection .3 } }\n"
                           "box { <-3, -1.5, -3>, <3, -1, 3> pigment { checker rgb 1 rgb .2 } }\n"
                           "sphere { <1.5, 0, -.5>, .5 pigment { rgbt .9 } interior { ior 1.4 } }\n"
                           "torus { .5, .2 scale <1, .5, 1.3> rotate <40, 20, 0> translate <-1.6, .6, -1> }\n"
                           "superellipsoid { <.4, .3> scale .4 rotate 30*y translate <1.6, 1, 0> }\n"
                           "superellipsoid { <3, .4> scale .6 rotate <20, 30, 0> translate <-.9, 1.3, -1> }\n"
                           "superellipsoid { <2.5, 3> scale .7 rotate <50, 10, 0> translate <.6, -.6, -1.2> }\n"
                           "difference { box { <-.5, .8, -.5>, <.5, 1.6, .5> } sphere { <0, 1.4, -.5>, .4 } rotate 20*z }\n";

typedef struct rays { pov_vec3 org[COUNT], dir[COUNT]; } rays;

/* Over the picture; a few are none. */
static void aim(const pov_scene *scene, rays *r)
{
    pov_camera camera = POV_INIT(camera);

    pov_scene_get_camera(scene, &camera);
    for (int i = 0; i < COUNT; i++) {
        assert_true(pov_camera_ray(&camera, (i % 40) / 39.0 - 0.5, (i / 40) / 24.0 - 0.5, &r->org[i], &r->dir[i]));
        if (i % 97 == 5)
            r->dir[i] = pov_vec3_of(0.0, 0.0, 0.0);
        if (i % 97 == 6)
            r->org[i].x = NAN;
    }
}

static void many_are_as_single_ones(void **state)
{
    static rays r;
    static double distance[COUNT];
    static pov_vec3 point[COUNT], normal[COUNT];
    static uint32_t object[COUNT];
    static float rgba[4 * COUNT];
    const pov_found out = { sizeof out, distance, point, normal, object, rgba, NULL };
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, text);
    pov_tracer *tracer;
    int hits = 0;

    (void)state;
    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    aim(scene, &r);
    assert_int_equal(pov_trace_many(tracer, COUNT, r.org, r.dir, &out, NULL), POV_OK);
    for (int i = 0; i < COUNT; i++) {
        pov_hit one = POV_INIT(one);
        float seen[4] = { 0.0f, 0.0f, 0.0f, 1.0f };

        pov_trace_color(tracer, r.org[i], r.dir[i], seen, NULL);
        assert_memory_equal(seen, &rgba[4 * i], sizeof seen);
        if (!pov_trace_hit(tracer, r.org[i], r.dir[i], &one)) {
            assert_true(isinf(distance[i]) && object[i] == UINT32_MAX);
            continue;
        }
        hits++;
        assert_true(one.distance == distance[i] && one.object == object[i]);
        assert_memory_equal(&one.point, &point[i], sizeof one.point);
        assert_memory_equal(&one.normal, &normal[i], sizeof one.normal);
    }
    assert_true(hits > COUNT / 4 && hits < COUNT);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

/* Each ray to the light crosses dozens of surfaces whose filters, foci and losses are found side by side. */
static void light_through_glass_and_fog_is_that_of_single_rays(void **state)
{
    static const char glass[] =
        "#version 3.7; camera { location <0, 1, -4> look_at 0 } light_source { <1, 9, -2> rgb 4 media_attenuation on }\n"
        "light_source { <-3, 7, 1> rgb 2 } fog { distance 20 rgb .3 turbulence .2 } plane { y, -1.5 pigment { rgb 1 } hollow }\n"
        "#declare T = texture { pigment { checker rgbt <1, .9, .8, .9> rgbf <.7, .9, 1, .9> scale .3 } normal { bumps .4 scale .2 } }\n"
        "#declare K = 0; #while (K < 9)\n"
        "box { <-9, 2 + K/2, -9>, <9, 2.2 + K/2, 9> hollow texture { T } interior { caustics .02*K fade_distance 3 fade_power mod(K, 3) } }\n"
        "sphere { <K - 4, 1, 0>, .4 hollow texture { gradient x texture_map { [.3 T] [.7 pigment { rgbt .8 }] } scale .1 } interior { caustics 1 } }\n"
        "sphere { <K - 4, 1, 1>, .3 pigment { rgbf <.9, .8, 1, .9> } interior { caustics .3 } }\n"
        "#declare K = K + 1; #end\n";
    static rays r;
    static float rgba[4 * COUNT];
    const pov_found out = { sizeof out, NULL, NULL, NULL, NULL, rgba, NULL };
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, glass);
    pov_tracer *tracer;

    (void)state;
    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    aim(scene, &r);
    assert_int_equal(pov_trace_many(tracer, COUNT, r.org, r.dir, &out, NULL), POV_OK);
    for (int i = 0; i < COUNT; i++) {
        float seen[4] = { 0.0f, 0.0f, 0.0f, 1.0f };

        pov_trace_color(tracer, r.org[i], r.dir[i], seen, NULL);
        assert_memory_equal(seen, &rgba[4 * i], sizeof seen);
    }
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

/* Surfaces that glow by their uv coordinates tell what these are. */
static void uv_are_those_of_textures(void **state)
{
    static const char glowing[] =
        "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0, 1, -4> look_at 0 }\n"
        "#declare U = texture { uv_mapping pigment { gradient x color_map { [0 rgb 0] [1 rgb x] } } finish { ambient 1 diffuse 0 } }\n"
        "sphere { 0, 1 texture { U } rotate 30*z translate .2*x } torus { 1.5, .2 texture { U } }\n"
        "box { <-3, -1.5, -3>, <3, -1, 3> texture { U } scale 1.1 }\n";
    static rays r;
    static double uv[2 * COUNT];
    static float rgba[4 * COUNT];
    static uint32_t object[COUNT];
    const pov_found out = { sizeof out, NULL, NULL, NULL, object, rgba, uv };
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, glowing);
    pov_tracer *tracer;
    double most = 0.0;

    (void)state;
    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    aim(scene, &r);
    assert_int_equal(pov_trace_many(tracer, COUNT, r.org, r.dir, &out, NULL), POV_OK);
    for (int i = 0; i < COUNT; i++) {
        if (object[i] == UINT32_MAX) {
            assert_true(uv[2 * i] == 0.0 && uv[2 * i + 1] == 0.0);
            continue;
        }
        assert_true(fabs(uv[2 * i] - floor(uv[2 * i]) - rgba[4 * i]) < 1e-6);
        most = uv[2 * i] > most ? uv[2 * i] : most;
    }
    assert_true(most > 0.5);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void what_is_not_asked_for_is_left_out(void **state)
{
    static rays r;
    static uint32_t object[COUNT];
    pov_found out = { sizeof out, NULL, NULL, NULL, object, NULL, NULL };
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, text);
    pov_tracer *tracer;
    pov_error err;

    (void)state;
    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    aim(scene, &r);
    assert_int_equal(pov_trace_many(tracer, 3, r.org, r.dir, &out, NULL), POV_OK);
    assert_int_equal(pov_trace_many(tracer, 0, NULL, NULL, &out, NULL), POV_OK);
    assert_int_equal(pov_trace_many(tracer, 1, NULL, r.dir, &out, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_trace_many(NULL, 1, r.org, r.dir, &out, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_trace_many(tracer, 1, r.org, r.dir, NULL, &err), POV_E_ARGUMENT);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(many_are_as_single_ones),
        cmocka_unit_test(light_through_glass_and_fog_is_that_of_single_rays),
        cmocka_unit_test(uv_are_those_of_textures),
        cmocka_unit_test(what_is_not_asked_for_is_left_out),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
