/* Memory that ends: for every scene of scenes/test the n-th allocation fails, for every n, from the context to the
 * last pixel. Each time the failure is reported as such and nothing is left behind. */
#include "support/check.h"
#include "support/failing.h"
#include "support/scenes.h"

#include <stdio.h>

enum { WIDTH = 12, HEIGHT = 9 };

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

static pov_status whole_way(const char *path, failing *f, pov_error *err)
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
        status = render(scene, err);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return status;
}

static void every_allocation_may_fail(void **state)
{
    char **list = scenes_list("test");
    long n, failures = 0;
    size_t i;

    (void)state;
    for (i = 0; list[i]; i++) {
        pov_status status = POV_E_MEMORY;
        for (n = 1; status != POV_OK; n++) {
            pov_error err;
            failing f;
            failing_init(&f, n);
            status = whole_way(list[i], &f, &err);
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

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(every_allocation_may_fail) };

    return cmocka_run_group_tests_name("memory", tests, NULL, NULL);
}
