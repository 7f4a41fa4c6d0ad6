/* A picture that separate jobs trace in parts has the bits of one job's, whatever decides the number of samples. */
#include "support/check.h"
#include "support/tiny_job.h"

#include "base/file.h"
#include "base/hash.h"
#include "render/tiles.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WIDTH = 75, HEIGHT = 50, PARTS_MOST = 8, ROUNDS_MOST = 20 };

typedef struct fixture {
    tiny scene;
    env env;
    char folder[32], round[64], files[PARTS_MOST][64];
    const char *paths[PARTS_MOST];
    int parts;
} fixture;

static void begin(fixture *f, int parts)
{
    memset(f, 0, sizeof *f);
    tiny_room(&f->scene, NULL);
    env_init(&f->env, NULL, NULL, NULL);
    strcpy(f->folder, "/tmp/povtrace-parts-XXXXXX");
    assert_non_null(mkdtemp(f->folder));
    snprintf(f->round, sizeof f->round, "%s/round", f->folder);
    f->parts = parts;
    for (int i = 0; i < parts; i++) {
        snprintf(f->files[i], sizeof f->files[i], "%s/%d", f->folder, i);
        f->paths[i] = f->files[i];
    }
}

static void end(fixture *f)
{
    for (int i = 0; i < f->parts; i++)
        unlink(f->files[i]);
    unlink(f->round);
    rmdir(f->folder);
    tiny_end(&f->scene);
}

/* Trace a part of a round, from its own earlier file if `own`. */
static void trace(fixture *f, pov_render_desc d, int part, bool rounds, bool own)
{
    pov_job *job;

    d.part = part;
    d.parts = f->parts;
    d.threads = part % 3 + 1;
    d.note = "a note";
    job = tiny_job(&f->scene, &d);
    if (rounds)
        assert_int_equal(job_load(job, f->round, NULL), POV_OK);
    if (rounds && own)
        assert_int_equal(job_load(job, f->files[part - 1], NULL), POV_OK);
    while (job_step(job) == POV_JOB_RUNNING)
        continue;
    assert_int_equal(job_save(job, f->files[part - 1], NULL), POV_OK);
    job_destroy(job);
}

static pov_stop stop_of(pov_job *job)
{
    pov_progress p = POV_INIT(p);

    job_get_progress(job, &p);
    return p.stop;
}

/* The joined picture; own: whether parts go on from what they have. */
static pov_job *trace_all(fixture *f, const pov_render_desc *d, bool own, int *rounds)
{
    pov_job *job = NULL;

    for (*rounds = 1; *rounds < ROUNDS_MOST; ++*rounds) {
        for (int i = f->parts; i >= 1; i--)
            trace(f, *d, i, *rounds > 1, own);
        assert_int_equal(job_join(&job, &f->env, f->paths, (size_t)f->parts, NULL), POV_OK);
        if (stop_of(job) != POV_STOP_PART)
            return job;
        assert_int_equal(job_save(job, f->round, NULL), POV_OK);
        job_destroy(job);
    }
    fail_msg("no end after %d rounds", ROUNDS_MOST);
    return NULL;
}

static void expect_same(fixture *f, const pov_render_desc *d, bool own, int least_rounds)
{
    float *one = tiny_picture(&f->scene, d), *joined;
    int rounds;
    pov_job *job = trace_all(f, d, own, &rounds);

    joined = tiny_read(job, WIDTH, HEIGHT);
    assert_memory_equal(joined, one, sizeof *one * 4 * WIDTH * HEIGHT);
    assert_string_equal(job_note(job), "a note");
    assert_true(rounds >= least_rounds);
    job_destroy(job);
    free(one);
    free(joined);
}

static pov_render_desc describe(int samples, double error, pov_sampling sampling)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);

    d.samples = samples;
    d.target_error = error;
    d.sampling = sampling;
    return d;
}

static void parts_of_one_sample_a_pixel_make_the_picture(void **state)
{
    const pov_render_desc d = describe(1, 0.0, POV_SAMPLING_UNIFORM);
    fixture f;

    (void)state;
    begin(&f, 7);
    expect_same(&f, &d, false, 1);
    end(&f);
}

static void parts_of_even_samples_need_one_round(void **state)
{
    const pov_render_desc d = describe(7, 0.0, POV_SAMPLING_UNIFORM);
    fixture f;

    (void)state;
    begin(&f, 4);
    expect_same(&f, &d, false, 1);
    end(&f);
}

static void parts_go_on_where_the_error_of_the_picture_is(void **state)
{
    const pov_render_desc d = describe(0, 0.01, POV_SAMPLING_ADAPTIVE);
    fixture f;

    (void)state;
    begin(&f, 3);
    expect_same(&f, &d, true, 3);
    expect_same(&f, &d, false, 3);
    end(&f);
}

static void look_through_a_lens(fixture *f)
{
    f->scene.model.camera.lens_radius = 0.05;
    f->scene.model.camera.focal_distance = 4.0;
}

/* Each pixel has a count of its own then. */
static void parts_behind_a_lens_go_on_where_the_error_of_the_picture_is(void **state)
{
    const pov_render_desc d = describe(0, 0.005, POV_SAMPLING_ADAPTIVE);
    fixture f;

    (void)state;
    begin(&f, 3);
    look_through_a_lens(&f);
    expect_same(&f, &d, true, 3);
    expect_same(&f, &d, false, 3);
    end(&f);
}

static void parts_of_even_samples_stop_at_the_error_of_the_picture(void **state)
{
    const pov_render_desc d = describe(0, 0.002, POV_SAMPLING_UNIFORM);
    fixture f;

    (void)state;
    begin(&f, 2);
    expect_same(&f, &d, true, 2);
    end(&f);
}

static double mean_samples(const fixture *f, const pov_render_desc *d)
{
    pov_progress p = POV_INIT(p);
    pov_job *job = tiny_job(&f->scene, d);

    while (job_step(job) == POV_JOB_RUNNING)
        continue;
    job_get_progress(job, &p);
    job_destroy(job);
    return p.spp_mean;
}

/* A lens says how many samples there are at most. What is asked for otherwise is taken. */
static void a_lens_ends_where_no_error_is_seen(void **state)
{
    enum { MOST = 64 };
    const pov_render_desc few = describe(0, 0.0, POV_SAMPLING_UNIFORM), all = describe(MOST, 0.0, POV_SAMPLING_UNIFORM);
    double off = 0.0, mean;
    float *a, *b;
    fixture f;

    (void)state;
    begin(&f, 3);
    look_through_a_lens(&f);
    f.scene.model.camera.lens_samples = MOST;
    mean = mean_samples(&f, &few);
    assert_true(mean >= 16.0 && mean < 0.9 * MOST);
    assert_true(mean_samples(&f, &all) == MOST);
    expect_same(&f, &few, false, 1);
    a = tiny_picture(&f.scene, &few);
    b = tiny_picture(&f.scene, &all);
    for (int i = 0; i < 4 * WIDTH * HEIGHT; i++)
        off += pow((double)a[i] - (double)b[i], 2.0);
    assert_true(sqrt(off / (4.0 * WIDTH * HEIGHT)) < 0.004);
    free(a);
    free(b);
    end(&f);
}

static void a_single_part_is_the_picture(void **state)
{
    const pov_render_desc d = describe(12, 0.0, POV_SAMPLING_ADAPTIVE);
    fixture f;

    (void)state;
    begin(&f, 1);
    expect_same(&f, &d, true, 2);
    end(&f);
}

/* Every tile belongs to one part, and no part has two more than another. */
static void tiles_are_dealt_evenly(void **state)
{
    env e;

    (void)state;
    env_init(&e, NULL, NULL, NULL);
    for (int parts = 1; parts <= 40; parts++) {
        int owners[32 * 32] = { 0 };
        size_t least = SIZE_MAX, most = 0;
        tiles t;

        for (int part = 1; part <= parts; part++) {
            tiles_make(&t, 500, 500, 1, false);
            assert_true(tiles_sort(&t, &e));
            tiles_deal(&t, part, parts);
            for (size_t i = 0; i < t.own; i++)
                owners[t.order[i]]++;
            least = t.own < least ? t.own : least;
            most = t.own > most ? t.own : most;
            tiles_free(&t, &e);
        }
        for (size_t i = 0; i < t.count; i++)
            assert_int_equal(owners[i], 1);
        assert_true(most - least <= 1);
    }
}

/* ---- files that are none ---- */

static void write_file(const char *to_path, const char *bytes, size_t count)
{
    FILE *to = fopen(to_path, "wb");

    assert_non_null(to);
    assert_int_equal(fwrite(bytes, 1, count, to), count);
    fclose(to);
}

/* Every third byte of the head and some of the rest, with a hash that fits: refused, or joined, but never more. */
static void a_forged_part_is_refused_or_joined(void **state)
{
    const pov_render_desc d = describe(2, 0.0, POV_SAMPLING_UNIFORM);
    size_t count, refused = 0, joined = 0;
    uint64_t hash;
    char *bytes;
    fixture f;

    (void)state;
    begin(&f, 2);
    trace(&f, d, 1, false, false);
    trace(&f, d, 2, false, false);
    assert_int_equal(file_read(&f.env, f.files[0], &bytes, &count, NULL), POV_OK);
    for (size_t i = 0; i < count - sizeof hash; i += i < 1024 ? 3 : 4093) {
        pov_job *job;

        bytes[i] = (char)(bytes[i] ^ 0x40);
        hash = hash_bytes(0, bytes, count - sizeof hash);
        memcpy(bytes + count - sizeof hash, &hash, sizeof hash);
        write_file(f.files[0], bytes, count);
        bytes[i] = (char)(bytes[i] ^ 0x40);
        if (job_join(&job, &f.env, f.paths, 2, NULL) != POV_OK) {
            refused++;
            continue;
        }
        joined++;
        job_destroy(job);
    }
    assert_true(refused > 0 && joined > 0);
    env_free(&f.env, bytes);
    end(&f);
}

static void a_joined_job_traces_nothing(void **state)
{
    const pov_render_desc d = describe(1, 0.0, POV_SAMPLING_UNIFORM);
    pov_progress p = POV_INIT(p);
    pov_job *job;
    int rounds;
    fixture f;

    (void)state;
    begin(&f, 2);
    job = trace_all(&f, &d, false, &rounds);
    assert_int_equal(job_start(job, NULL), POV_OK);
    assert_int_equal(job_step(job), POV_JOB_DONE);
    job_restart(job, NULL);
    assert_int_equal(job_step(job), POV_JOB_DONE);
    job_get_progress(job, &p);
    assert_true(p.width == WIDTH && p.height == HEIGHT && p.round == 1);
    assert_int_equal(job_save(job, f.round, NULL), POV_E_ARGUMENT);
    job_destroy(job);
    end(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_of_one_sample_a_pixel_make_the_picture),
        cmocka_unit_test(parts_of_even_samples_need_one_round),
        cmocka_unit_test(parts_go_on_where_the_error_of_the_picture_is),
        cmocka_unit_test(parts_behind_a_lens_go_on_where_the_error_of_the_picture_is),
        cmocka_unit_test(parts_of_even_samples_stop_at_the_error_of_the_picture),
        cmocka_unit_test(a_lens_ends_where_no_error_is_seen),
        cmocka_unit_test(a_single_part_is_the_picture),
        cmocka_unit_test(tiles_are_dealt_evenly),
        cmocka_unit_test(a_forged_part_is_refused_or_joined),
        cmocka_unit_test(a_joined_job_traces_nothing),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
