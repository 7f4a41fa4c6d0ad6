/* test_accuracy.c - what double was certain of is what two parts say: the pictures of both accuracies are the same. */
#include "support/check.h"
#include "support/limits.h"
#include "support/scenes.h"

#include <stdlib.h>

enum { WIDTH = 64, HEIGHT = 48 };

static float *picture(pov_context *context, const char *path, pov_accuracy accuracy, uint64_t *escalated)
{
    pov_load_desc load = POV_INIT(load);
    pov_render_desc d = POV_INIT(d);
    pov_scene *scene;
    pov_progress progress = POV_INIT(progress);
    pov_rect all = { 0, 0, WIDTH, HEIGHT };
    float *pixels = calloc(WIDTH * HEIGHT, 4 * sizeof *pixels);
    pov_job *job = NULL;
    pov_error err;

    assert_non_null(pixels);
    load.accuracy = accuracy;
    d.width = WIDTH;
    d.height = HEIGHT;
    d.threads = 2;
    if (pov_scene_load_file(&scene, context, path, &load, &err) < 0 || pov_job_create(&job, scene, &d, &err) < 0 ||
        pov_job_start(job, &err) < 0)
        fail_msg("%s: %s", path, err.message);
    while (pov_job_wait(job, 10.0) == POV_JOB_RUNNING)
        continue;
    pov_job_read(job, all, POV_PIXELS_LINEAR_FLOAT, pixels, WIDTH * 4 * sizeof *pixels);
    pov_job_get_progress(job, &progress);
    *escalated += progress.counts.escalated;
    pov_job_destroy(job);
    pov_scene_destroy(scene);
    return pixels;
}

/* Last bits decide the random numbers of photons and of jittered lights: single pixels differ, their mean does not. */
static const char *const by_chance[] = { "photons_glass", "photons_media", "caustic", "colonnade", "dust", "focus", "goblets", "logo",
                                        "sculpture", "spectrum", "still_life", NULL };

static double mean_of(const float *pixels)
{
    double sum = 0.0;

    for (int i = 0; i < 4 * WIDTH * HEIGHT; i++)
        sum += (double)pixels[i];
    return sum / (4 * WIDTH * HEIGHT);
}

/* Distances differ in their last bits, and so do colours. Where a mirrored or bent ray then passes an edge on the other
 * side, a pixel differs by more: of one scene at most one in a thousand. */
static void hold(const char *folder)
{
    pov_context *context = scenes_context();
    char **list = scenes_list(folder);
    uint64_t certified = 0, max = 0;
    long broken = 0;

    for (size_t i = 0; list[i]; i++) {
        float *a = picture(context, list[i], POV_ACCURACY_CERTIFIED, &certified);
        float *b = picture(context, list[i], POV_ACCURACY_MAX, &max);
        const bool chance = scenes_is_one_of(list[i], by_chance);
        const long off = chance ? 0 : limits_count(a, b, WIDTH, HEIGHT, 1e-4f);
        const double apart = fabs(mean_of(a) - mean_of(b));

        broken += apart > 1e-4;
        if (apart > 1e-4)
            print_message("%s: the means are %g apart\n", list[i], apart);
        if (off)
            print_message("%s: %ld pixels differ\n", list[i], off);
        broken += off > WIDTH * HEIGHT / 1000;
        free(a);
        free(b);
    }
    assert_int_equal(broken, 0);
    /* Both did what they say: all was decided in double-double, or next to nothing. */
    assert_true(max > 100000);
    assert_true(certified < max / 20);
    scenes_free(list);
    pov_context_destroy(context);
}

static void the_scenes_of_the_tests_are_the_same(void **state)
{
    (void)state;
    hold("test");
}

static void the_gallery_is_the_same(void **state)
{
    (void)state;
    hold("gallery");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_scenes_of_the_tests_are_the_same),
        cmocka_unit_test(the_gallery_is_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
