/* A paused job stands still, and goes on to the same picture. */
#include "support/check.h"
#include "support/scenes.h"

#include <stdlib.h>
#include <string.h>

enum { WIDTH = 64, HEIGHT = 48 };

static const char text[] = "#version 3.7; camera { location <0, 1, -4> look_at 0 } light_source { <5, 9, -7> rgb 1 }\n"
                           "sphere { 0, 1 pigment { color rgb <1, .5, .2> } finish { reflection .3 phong .5 } }\n";

static float *read_all(pov_job *job)
{
    pov_rect all = { 0, 0, WIDTH, HEIGHT };
    float *pixels = malloc(sizeof *pixels * WIDTH * HEIGHT * 4);

    assert_non_null(pixels);
    pov_job_read(job, all, POV_PIXELS_LINEAR_FLOAT, pixels, sizeof *pixels * WIDTH * 4);
    return pixels;
}

static pov_job *make(const pov_scene *scene)
{
    pov_render_desc d = POV_INIT(d);
    pov_job *job;

    d.width = WIDTH;
    d.height = HEIGHT;
    d.threads = 2;
    d.preview = 8;
    assert_int_equal(pov_job_create(&job, scene, &d, NULL), POV_OK);
    return job;
}

static double fraction(pov_job *job)
{
    pov_progress p = POV_INIT(p);

    pov_job_get_progress(job, &p);
    return p.fraction;
}

static void a_paused_job_traces_nothing_until_it_may(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, text);
    pov_job *job = make(scene), *plain = make(scene);
    float *paused, *other;

    (void)state;
    pov_job_pause(job, true);
    assert_int_equal(pov_job_start(job, NULL), POV_OK);
    assert_int_equal(pov_job_wait(job, 0.05), POV_JOB_RUNNING);
    assert_true(fraction(job) == 0.0);
    pov_job_restart(job, NULL);
    assert_int_equal(pov_job_wait(job, 0.05), POV_JOB_RUNNING);
    assert_true(fraction(job) == 0.0);

    pov_job_pause(job, false);
    while (pov_job_wait(job, 10.0) == POV_JOB_RUNNING)
        assert_true(fraction(job) > 0.0);
    paused = read_all(job);
    while (pov_job_step(plain) == POV_JOB_RUNNING)
        continue;
    other = read_all(plain);
    assert_memory_equal(paused, other, sizeof *paused * WIDTH * HEIGHT * 4);
    free(paused);
    free(other);
    pov_job_destroy(job);
    pov_job_destroy(plain);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void a_step_of_a_paused_job_comes_back_at_once(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, text);
    pov_job *job = make(scene);

    (void)state;
    pov_job_pause(job, true);
    assert_int_equal(pov_job_step(job), POV_JOB_RUNNING);
    assert_true(fraction(job) == 0.0);
    pov_job_pause(job, false);
    assert_int_equal(pov_job_step(job), POV_JOB_RUNNING);
    assert_true(fraction(job) > 0.0);
    pov_job_destroy(job);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void a_paused_job_can_be_destroyed(void **state)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, text);
    pov_job *job = make(scene);

    (void)state;
    assert_int_equal(pov_job_start(job, NULL), POV_OK);
    pov_job_pause(job, true);
    pov_job_destroy(job);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_paused_job_traces_nothing_until_it_may),
        cmocka_unit_test(a_step_of_a_paused_job_comes_back_at_once),
        cmocka_unit_test(a_paused_job_can_be_destroyed),
    };

    return cmocka_run_group_tests_name("pausing a job", tests, NULL, NULL);
}
