/* Memory that ends: for every scene of scenes/test the n-th allocation fails, for every n, from the context to the
 * last pixel. Each time the failure is reported as such and nothing is left behind. */
#include "support/check.h"
#include "support/failing.h"
#include "support/scenes.h"

#include <stdio.h>

enum { WIDTH = 12, HEIGHT = 9 };

#define CHECKPOINT TEST_BUILD "/tests/api/test_memory.checkpoint"

static pov_status render(const pov_scene *scene, pov_error *err)
{
    static float pixels[WIDTH * HEIGHT * 4];
    pov_render_desc d = POV_INIT(d);
    pov_rect all = { 0, 0, WIDTH, HEIGHT };
    pov_job *job = NULL;
    pov_status status;

    d.width = WIDTH;
    d.height = HEIGHT;
    d.threads = 2;
    d.preview = 4;
    status = pov_job_create(&job, scene, &d, err);
    if (status == POV_OK)
        status = pov_job_start(job, err);
    if (status == POV_OK) {
        while (pov_job_wait(job, 10.0) == POV_JOB_RUNNING)
            continue;
        status = pov_job_get_error(job, err);
    }
    if (status == POV_OK)
        pov_job_read(job, all, POV_PIXELS_LINEAR_FLOAT, pixels, WIDTH * 4 * sizeof *pixels);
    pov_job_destroy(job);
    return status;
}

/* Eight samples a pixel on average, where the error is; it is left after a pass for a checkpoint, and another job goes on
 * from that and tells its rows. */
static pov_status refine(const pov_scene *scene, pov_error *err)
{
    pov_render_desc d = POV_INIT(d);
    pov_pass row = POV_INIT(row);
    pov_job *job = NULL;
    pov_status status;
    size_t passes;

    d.width = WIDTH;
    d.height = HEIGHT;
    d.threads = 1;
    d.samples = 8;
    d.sampling = POV_SAMPLING_ADAPTIVE;
    status = pov_job_create(&job, scene, &d, err);
    while (status == POV_OK && !pov_job_get_pass(job, 1, &row) && pov_job_step(job) == POV_JOB_RUNNING)
        continue;
    if (status == POV_OK)
        status = pov_job_get_error(job, err);
    if (status == POV_OK)
        status = pov_job_save(job, CHECKPOINT, err);
    pov_job_destroy(job);
    job = NULL;
    if (status == POV_OK)
        status = pov_job_create(&job, scene, &d, err);
    if (status == POV_OK)
        status = pov_job_load(job, CHECKPOINT, err);
    while (status == POV_OK && pov_job_step(job) == POV_JOB_RUNNING)
        continue;
    if (status == POV_OK)
        status = pov_job_get_error(job, err);
    for (passes = 0; status == POV_OK && pov_job_get_pass(job, passes, &row); passes++)
        continue;
    if (status == POV_OK)
        assert_true(passes >= 4 && row.est_rmse >= 0.0 && row.spp_mean >= 8.0);
    pov_job_destroy(job);
    return status;
}

static pov_status whole_way(const char *path, failing *f, pov_status (*draw)(const pov_scene *, pov_error *), pov_error *err)
{
    pov_context_desc d = POV_INIT(d);
    pov_context *context = NULL;
    pov_scene *scene = NULL;
    pov_status status;

    d.allocator = failing_allocator(f);
    d.plugin_path = TEST_PLUGINS;
    status = pov_context_create(&context, &d, err);
    if (status == POV_OK)
        status = pov_scene_load_file(&scene, context, path, NULL, err);
    if (status == POV_OK)
        status = draw(scene, err);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return status;
}

/* dear: beginnings of the names of scenes that take too long to be drawn once for each allocation. */
static void fail_every_allocation(pov_status (*draw)(const pov_scene *, pov_error *), const char *const *dear)
{
    char **list = scenes_list("test");
    long n, failures = 0;
    size_t i;

    for (i = 0; list[i]; i++) {
        pov_status status = POV_E_MEMORY;

        if (scenes_is_one_of(list[i], dear))
            continue;
        for (n = 1; status != POV_OK; n++) {
            pov_error err;
            failing f;
            failing_init(&f, n);
            status = whole_way(list[i], &f, draw, &err);
            if (status != POV_OK && status != POV_E_MEMORY)
                fail_msg("%s, allocation %ld: %s: %s", list[i], n, pov_status_name(status), err.message);
            if (f.blocks != 0)
                fail_msg("%s, allocation %ld: %ld blocks were left", list[i], n, f.blocks);
            failures += status != POV_OK;
            assert_true(n < 100000);
        }
        assert_true(n > 10);
    }
    print_message("%ld failures in %zu scenes\n", failures, i);
    scenes_free(list);
}

static void every_allocation_of_a_picture_may_fail(void **state)
{
    /* Photons are sent again for each allocation: photons_mirror, the quickest, stands for these. */
    static const char *const dear[] = { "photons_glass", "photons_dispersion", "photons_media", NULL };

    (void)state;
    fail_every_allocation(render, dear);
}

static void every_allocation_of_more_samples_may_fail(void **state)
{
    /* More samples send more of them. */
    static const char *const dear[] = { "photons", NULL };

    (void)state;
    fail_every_allocation(refine, dear);
    assert_int_equal(remove(CHECKPOINT), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_allocation_of_a_picture_may_fail),
        cmocka_unit_test(every_allocation_of_more_samples_may_fail),
    };

    return cmocka_run_group_tests_name("memory", tests, NULL, NULL);
}
