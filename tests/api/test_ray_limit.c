/* The limit of rays that follow from one: glass between mirrors, without a bail-out, sends 2^depth of them. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/povtrace.h>

#include <string.h>

static const char endless[] =
    "#version 3.7; global_settings { max_trace_level 200 adc_bailout 0 }\n"
    "camera { location <0, 0, -3> look_at 0 } light_source { <5, 9, -7> rgb 1 }\n"
    "#declare F = finish { reflection 1 }\n"
    "box { <-9, -9, -9>, <9, 9, 9> pigment { rgb 1 } finish { F } }\n"
    "sphere { 0, 1 pigment { rgbt <1, 1, 1, .9> } finish { F } interior { ior 1.3 } }\n"
    "sphere { <2, 0, 0>, 1 pigment { rgbt <1, 1, 1, .9> } finish { F } interior { ior 1.3 } }\n";

static pov_scene *load(pov_context *context, const char *text, uint64_t most)
{
    pov_load_desc desc = POV_INIT(desc);
    pov_scene *scene;
    pov_error err;

    desc.most_rays = most;
    if (pov_scene_load_text(&scene, context, text, strlen(text), "scene", &desc, &err) != POV_OK)
        fail_msg("%s", err.message);
    return scene;
}

static void a_ray_that_never_ends_is_an_error(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = load(context, endless, 10000);
    pov_tracer *tracer;
    pov_error err;
    float rgba[4];

    (void)state;
    assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
    assert_int_equal(pov_trace_color(tracer, pov_vec3_of(0, 0, -3), pov_vec3_of(0.1, 0.05, 1), rgba, &err), POV_E_UNSUPPORTED);
    assert_non_null(strstr(err.message, "more than 10000 rays"));
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void a_picture_of_such_rays_fails(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = load(context, endless, 10000);
    pov_render_desc desc = POV_INIT(desc);
    pov_job *job;
    pov_error err;

    (void)state;
    desc.width = desc.height = 8;
    assert_int_equal(pov_job_create(&job, scene, &desc, &err), POV_OK);
    while (pov_job_step(job) == POV_JOB_RUNNING)
        continue;
    assert_int_equal(pov_job_get_error(job, &err), POV_E_UNSUPPORTED);
    assert_non_null(strstr(err.message, "rays follow from one ray of the camera"));
    pov_job_destroy(job);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

/* One mirror: a camera ray, and one that follows from it. */
static void a_limit_that_is_just_met_changes_nothing(void **state)
{
    static const char mirror[] = "#version 3.7; background { rgb 1 } camera { location <0, 0, -3> look_at 0 }\n"
                                 "plane { z, 0 pigment { rgb 0 } finish { reflection .5 } }";
    pov_context *context = scenes_context();

    (void)state;
    for (uint64_t most = 0; most < 3; most++) {
        pov_scene *scene = load(context, mirror, most);
        pov_tracer *tracer;
        pov_error err;
        float rgba[4];

        assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
        assert_int_equal(pov_trace_color(tracer, pov_vec3_of(0, 0, -3), pov_vec3_of(0, 0, 1), rgba, &err), POV_OK);
        assert_true(rgba[0] > 0.4f && rgba[0] < 0.6f);
        pov_tracer_destroy(tracer);
        pov_scene_destroy(scene);
    }
    pov_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ray_that_never_ends_is_an_error),
        cmocka_unit_test(a_picture_of_such_rays_fails),
        cmocka_unit_test(a_limit_that_is_just_met_changes_nothing),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
