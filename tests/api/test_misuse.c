/* Findings F9, F12 and F13 of the review: NULL where none is allowed, cameras and sizes that cannot be. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/povtrace.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char sphere[] = "light_source { <0, 0, -10> rgb 1 } sphere { <0, 0, 0>, 1 pigment { color red 1 } }";

static void f12_scene_calls_take_null(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, sphere);
    pov_scene_info info = POV_INIT(info);
    pov_camera camera = POV_INIT(camera);
    pov_plan_row row = POV_INIT(row);
    pov_box box;

    (void)state;
    pov_scene_get_info(scene, NULL);
    pov_scene_get_info(NULL, &info);
    pov_scene_get_camera(scene, NULL);
    pov_scene_get_camera(NULL, &camera);
    assert_false(pov_scene_get_bounds(scene, NULL));
    assert_false(pov_scene_get_bounds(NULL, &box));
    assert_false(pov_scene_get_plan(scene, 0, NULL));
    assert_false(pov_scene_get_plan(NULL, 0, &row));
    assert_false(pov_scene_get_object(NULL, 0, NULL, NULL, NULL));
    assert_int_equal(pov_scene_object_count(NULL), 0);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void f12_job_calls_take_null(void **state)
{
    pov_rect all = { 0, 0, 1, 1 };
    pov_progress progress = POV_INIT(progress);
    pov_class_counts counts = POV_INIT(counts);
    pov_pass pass = POV_INIT(pass);
    pov_error err;
    float pixel[4];

    (void)state;
    assert_int_equal(pov_job_start(NULL, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_job_step(NULL), POV_JOB_FAILED);
    assert_int_equal(pov_job_wait(NULL, 0.0), POV_JOB_FAILED);
    assert_false(pov_job_take(NULL, &all));
    pov_job_read(NULL, all, POV_PIXELS_LINEAR_FLOAT, pixel, sizeof pixel);
    pov_job_restart(NULL, NULL);
    pov_job_pause(NULL, true);
    pov_job_cancel(NULL);
    pov_job_get_progress(NULL, &progress);
    assert_false(pov_job_get_pass(NULL, 0, &pass));
    assert_false(pov_job_get_class(NULL, 0, &counts));
    assert_int_equal(pov_job_get_error(NULL, &err), POV_E_ARGUMENT);
}

static void f12_job_results_may_go_nowhere(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, sphere);
    pov_render_desc desc = POV_INIT(desc);
    pov_rect all = { 0, 0, 4, 3 };
    pov_job *job;

    (void)state;
    desc.width = 4;
    desc.height = 3;
    assert_int_equal(pov_job_create(&job, scene, &desc, NULL), POV_OK);
    while (pov_job_step(job) == POV_JOB_RUNNING)
        continue;
    assert_false(pov_job_take(job, NULL));
    pov_job_get_progress(job, NULL);
    assert_false(pov_job_get_pass(job, 0, NULL));
    assert_false(pov_job_get_class(job, 0, NULL));
    pov_job_read(job, all, POV_PIXELS_LINEAR_FLOAT, NULL, 64);
    pov_job_destroy(job);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void f12_single_rays_take_null(void **state)
{
    const pov_vec3 org = { 0.0, 0.0, -5.0 }, dir = { 0.0, 0.0, 1.0 };
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, sphere);
    pov_hit hit = POV_INIT(hit);
    pov_tracer *tracer;
    float rgba[4];
    pov_error err;

    (void)state;
    assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
    assert_false(pov_trace_hit(NULL, org, dir, &hit));
    assert_int_equal(pov_trace_hits(NULL, org, dir, NULL, NULL), 0);
    assert_int_equal(pov_trace_hits(tracer, org, dir, NULL, NULL), 0);
    assert_false(pov_trace_blocked(NULL, org, dir));
    assert_int_equal(pov_trace_color(NULL, org, dir, rgba, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_trace_color(tracer, org, dir, NULL, &err), POV_E_ARGUMENT);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void f13_images_want_an_output_a_stride_of_floats_and_a_sized_bitmap(void **state)
{
    pov_context *context = scenes_context();
    pov_output none = { NULL, NULL };
    pov_image_options ppm = POV_INIT(ppm);
    pov_bitmap unsized = { 0 };
    float rgba[64] = { 0.0f };
    pov_error err;

    (void)state;
    ppm.format = "ppm";
    assert_int_equal(pov_image_put(context, &none, 1, 1, rgba, 16, &ppm, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_image_write(context, "-", 4, 1, rgba, 65, &ppm, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_image_read(context, "none.ppm", &unsized, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_file_write(context, NULL, "x", 1, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_file_write(context, "x", NULL, 1, &err), POV_E_ARGUMENT);
    assert_int_equal(pov_file_check(NULL, "x", &err), POV_E_ARGUMENT);
    pov_context_destroy(context);
}

static pov_status make_with(const pov_scene *scene, pov_vec3 location, pov_vec3 direction, pov_vec3 right)
{
    pov_camera camera = POV_INIT(camera);
    pov_render_desc desc = POV_INIT(desc);
    pov_job *job = NULL;
    pov_status status;

    camera.location = location;
    camera.direction = direction;
    camera.right = right;
    camera.up = pov_vec3_of(0.0, 1.0, 0.0);
    desc.width = 4;
    desc.height = 3;
    desc.camera = &camera;
    status = pov_job_create(&job, scene, &desc, NULL);
    pov_job_destroy(job);
    return status;
}

static void f13_cameras_that_cannot_be_are_refused(void **state)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 }, ahead = { 0.0, 0.0, 1.0 }, aside = { 1.0, 0.0, 0.0 };
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, sphere);

    (void)state;
    assert_int_equal(make_with(scene, zero, ahead, aside), POV_OK);
    assert_int_equal(make_with(scene, pov_vec3_of(NAN, 0.0, 0.0), ahead, aside), POV_E_ARGUMENT);
    assert_int_equal(make_with(scene, pov_vec3_of(0.0, INFINITY, 0.0), ahead, aside), POV_E_ARGUMENT);
    assert_int_equal(make_with(scene, zero, zero, aside), POV_E_ARGUMENT);
    assert_int_equal(make_with(scene, zero, pov_vec3_of(0.0, 0.0, NAN), aside), POV_E_ARGUMENT);
    assert_int_equal(make_with(scene, zero, ahead, zero), POV_E_ARGUMENT);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

/* No infinite object, no light, and rays that go through: sums with null pointers that clang's sanitizer sees, where arrays
 * have no members. */
static void f9_arrays_without_members_are_not_reached_into(void **state)
{
    static const char *const texts[] = { "sphere { <0,0,0>, 1 }", "sphere { <0,0,0>, 1 pigment { rgbt 1 } interior { ior 1.5 } }",
                                         "sphere { <0,0,0>, 1 pigment { rgbf <1,1,1,.5> } }", "background { rgb 1 }" };

    (void)state;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        free(scenes_draw(texts[i], 8, 6, 1, 1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(f9_arrays_without_members_are_not_reached_into),
        cmocka_unit_test(f12_scene_calls_take_null),
        cmocka_unit_test(f12_job_calls_take_null),
        cmocka_unit_test(f12_job_results_may_go_nowhere),
        cmocka_unit_test(f12_single_rays_take_null),
        cmocka_unit_test(f13_images_want_an_output_a_stride_of_floats_and_a_sized_bitmap),
        cmocka_unit_test(f13_cameras_that_cannot_be_are_refused),
    };

    return cmocka_run_group_tests_name("misuse", tests, NULL, NULL);
}
