/* Checkpoints that somebody made up: a renewed hash makes them whole, and still no job may wait for what never comes.
 * Finding F5 of the review. */
#include "support/check.h"
#include "support/tiny_job.h"

#include "base/file.h"
#include "base/hash.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WIDTH = 8, HEIGHT = 8, STEPS_MOST = 60, SECONDS_MOST = 120 };
enum { HEAD = 2048 };            /* bytes that hold more than the pixels' sums */

typedef struct fixture {
    tiny scene;
    pov_render_desc desc;
    char folder[32], file[64];
    char *good, *forged;
    size_t count;
} fixture;

static pov_render_desc describe(pov_sampling sampling)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);

    d.samples = 16;
    d.preview = 4;
    d.threads = 1;
    d.sampling = sampling;
    return d;
}

/* Save a job after so many of its steps. */
static void begin(fixture *f, pov_sampling sampling, double lens, int steps)
{
    env e;
    pov_job *job;

    tiny_room(&f->scene, NULL);
    f->scene.model.camera.lens_radius = lens;
    f->scene.model.camera.focal_distance = 4.0;
    f->desc = describe(sampling);
    strcpy(f->folder, "/tmp/povtrace-checkpoint-XXXXXX");
    assert_non_null(mkdtemp(f->folder));
    snprintf(f->file, sizeof f->file, "%s/c", f->folder);
    job = tiny_job(&f->scene, &f->desc);
    while (steps-- > 0)
        job_step(job);
    assert_int_equal(job_save(job, f->file, NULL), POV_OK);
    job_destroy(job);
    env_init(&e, NULL, NULL, NULL);
    assert_int_equal(file_read(&e, f->file, &f->good, &f->count, NULL), POV_OK);
    f->forged = malloc(f->count);
    assert_non_null(f->forged);
    memcpy(f->forged, f->good, f->count);
}

static void end(fixture *f)
{
    unlink(f->file);
    rmdir(f->folder);
    free(f->good);
    free(f->forged);
    tiny_end(&f->scene);
}

static void write_forged(fixture *f)
{
    const uint64_t hash = hash_bytes(0, f->forged, f->count - sizeof hash);
    FILE *to = fopen(f->file, "wb");

    assert_non_null(to);
    memcpy(f->forged + f->count - sizeof hash, &hash, sizeof hash);
    assert_int_equal(fwrite(f->forged, 1, f->count, to), f->count);
    fclose(to);
}

/* True: it was taken. What hangs is ended by the alarm, and the test with it. */
static bool goes_on_with(fixture *f)
{
    pov_job *job = tiny_job(&f->scene, &f->desc);
    const bool taken = job_load(job, f->file, NULL) == POV_OK;
    int steps = 0;

    while (taken && steps++ < STEPS_MOST && job_step(job) == POV_JOB_RUNNING)
        continue;
    job_destroy(job);
    return taken;
}

static void forge_each_byte(pov_sampling sampling, double lens, int steps)
{
    static const unsigned char flips[] = { 0x01, 0xff };
    size_t refused = 0, taken = 0, i, k;
    fixture f;

    begin(&f, sampling, lens, steps);
    for (i = 0; i + sizeof(uint64_t) < f.count; i += i < HEAD ? 3 : 61)
        for (k = 0; k < sizeof flips; k++) {
            f.forged[i] = (char)(f.forged[i] ^ flips[k]);
            write_forged(&f);
            *(goes_on_with(&f) ? &taken : &refused) += 1;
            f.forged[i] = f.good[i];
        }
    assert_true(refused > 0 && taken > 0);
    end(&f);
}

static void f5_a_forged_byte_of_the_first_passes_makes_no_job_wait(void **state)
{
    (void)state;
    forge_each_byte(POV_SAMPLING_UNIFORM, 0.0, 2);
}

static void f5_a_forged_byte_of_later_passes_makes_no_job_wait(void **state)
{
    (void)state;
    forge_each_byte(POV_SAMPLING_ADAPTIVE, 0.0, 6);
}

static void a_forged_count_of_a_pixel_makes_no_job_wait(void **state)
{
    (void)state;
    forge_each_byte(POV_SAMPLING_ADAPTIVE, 0.05, 6);
}

static void a_job_that_has_ended_is_at_its_end_again(void **state)
{
    fixture f;

    (void)state;
    begin(&f, POV_SAMPLING_UNIFORM, 0.0, STEPS_MOST);
    assert_true(goes_on_with(&f));
    end(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_job_that_has_ended_is_at_its_end_again),
        cmocka_unit_test(f5_a_forged_byte_of_the_first_passes_makes_no_job_wait),
        cmocka_unit_test(f5_a_forged_byte_of_later_passes_makes_no_job_wait),
        cmocka_unit_test(a_forged_count_of_a_pixel_makes_no_job_wait),
    };

    alarm(SECONDS_MOST);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
