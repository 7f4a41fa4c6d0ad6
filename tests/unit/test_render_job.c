/* One job from beginning to end: the same picture by every way, what is read on the way, what is refused. */
#include "support/failing.h"
#include "support/near.h"
#include "support/tiny_job.h"

#include "render/raygen.h"
#include "render/sample.h"

#include <stdlib.h>
#include <string.h>

enum { WIDTH = 75, HEIGHT = 50 };
static const size_t whole = 4 * sizeof(float) * WIDTH * HEIGHT;

static void same_bits(float *a, float *b)
{
    assert_memory_equal(a, b, whole);
    free(b);
}

static void the_number_of_threads_changes_no_bit(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    float *one;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    d.threads = 1;
    one = tiny_picture(&s, &d);
    for (d.threads = 2; d.threads <= 8; d.threads++)
        same_bits(one, tiny_picture(&s, &d));
    free(one);
    tiny_end(&s);
}

static void a_preview_changes_no_bit_of_the_end(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    float *plain;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    d.samples = 3;
    plain = tiny_picture(&s, &d);
    for (d.preview = 2; d.preview <= 16; d.preview *= 2)
        same_bits(plain, tiny_picture(&s, &d));
    free(plain);
    tiny_end(&s);
}

static void steps_give_the_picture_that_threads_give(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    int steps = 0;
    pov_job *job;
    float *pixels;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    d.preview = 4;
    pixels = tiny_picture(&s, &d);
    job = tiny_job(&s, &d);
    while (job_step(job) == POV_JOB_RUNNING)
        steps++;
    assert_true(steps > 10);
    assert_int_equal(job_step(job), POV_JOB_DONE);
    same_bits(pixels, tiny_read(job, WIDTH, HEIGHT));
    job_destroy(job);
    free(pixels);
    tiny_end(&s);
}

static void a_pixel_is_what_the_tracer_sees_through_it(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    float *pixels;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    pixels = tiny_picture(&s, &d);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            pov_ray ray = raygen_ray(&s.model.camera, WIDTH, HEIGHT, x, y, 0.5, 0.5);
            colour c = tracer_color(s.tracer, &ray);
            float *p = pixels + 4 * (y * WIDTH + x);
            assert_true(p[0] == c.r && p[1] == c.g && p[2] == c.b && p[3] == 1.0f);
        }
    free(pixels);
    tiny_end(&s);
}

static void samples_are_averaged(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    double sum = 0.0;
    float *pixels;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    d.samples = 4;
    pixels = tiny_picture(&s, &d);
    for (int i = 0; i < 4; i++) {
        sample at = sample_at(0, 30, 26, i % 2, (uint32_t)(i / 2));
        pov_ray ray = raygen_ray(&s.model.camera, WIDTH, HEIGHT, 30, 26, at.x, at.y);
        sum += tracer_color(s.tracer, &ray).g;
    }
    assert_near(pixels[4 * (26 * WIDTH + 30) + 1], sum / 4.0, 1e-7);
    free(pixels);
    tiny_end(&s);
}

static void a_crop_is_the_part_of_the_whole(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    pov_rect crop = { 11, 7, 43, 29 };
    float *all, *part;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    d.samples = 2;
    all = tiny_picture(&s, &d);
    d.crop = crop;
    d.preview = 8;
    part = tiny_picture(&s, &d);
    for (int y = 0; y < crop.height; y++)
        assert_memory_equal(part + 4 * y * crop.width, all + 4 * ((crop.y + y) * WIDTH + crop.x),
                            4 * sizeof(float) * (size_t)crop.width);
    free(all);
    free(part);
    tiny_end(&s);
}

static void taken_tiles_cover_every_pixel_once(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    unsigned char seen[HEIGHT][WIDTH] = { { 0 } };
    pov_rect r;
    pov_job *job;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    job = tiny_job(&s, &d);
    assert_false(job_take(job, &r));
    while (job_step(job) == POV_JOB_RUNNING)
        ;
    while (job_take(job, &r))
        for (int y = r.y; y < r.y + r.height; y++)
            for (int x = r.x; x < r.x + r.width; x++)
                seen[y][x]++;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        assert_int_equal(seen[i / WIDTH][i % WIDTH], 1);
    job_destroy(job);
    tiny_end(&s);
}

/* Whoever reads each tile as it is taken has the picture in the end. */
static void reading_what_is_taken_gives_the_picture(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    float *pixels = calloc(1, whole), *plain;
    pov_rect r;
    pov_job *job;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    d.preview = 16;
    job = tiny_job(&s, &d);
    while (job_step(job) != POV_JOB_IDLE && job_take(job, &r))
        job_read(job, r, POV_PIXELS_LINEAR_FLOAT, pixels + 4 * (r.y * WIDTH + r.x), 4 * sizeof(float) * WIDTH);
    plain = tiny_picture(&s, &d);
    same_bits(plain, pixels);
    free(plain);
    job_destroy(job);
    tiny_end(&s);
}

static void the_first_pass_fills_the_picture(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    pov_progress progress = POV_INIT(progress);
    float *pixels;
    pov_job *job;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    d.preview = 16;
    job = tiny_job(&s, &d);
    do {
        job_step(job);
        job_get_progress(job, &progress);
    } while (progress.pass < 2);
    assert_int_equal(progress.passes, 5);
    assert_int_equal(progress.counts.camera, 5 * 4);
    pixels = tiny_read(job, WIDTH, HEIGHT);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        assert_true(pixels[4 * i + 3] == 1.0f);
    assert_true(pixels[4 * (33 * WIDTH + 19)] == pixels[4 * (32 * WIDTH + 16)]);
    free(pixels);
    job_destroy(job);
    tiny_end(&s);
}

/* The picture as it is, whole and in pieces that begin anywhere: the same bytes, whatever the lattices that are in. */
static void assert_pieces_are_of_the_whole(pov_job *job, pov_pixels format, size_t bytes)
{
    static const pov_rect pieces[] = { { 0, 0, 1, 1 }, { 3, 5, 7, 9 }, { 13, 14, 40, 20 }, { 31, 31, 2, 2 }, { 74, 49, 1, 1 } };
    static unsigned char all[HEIGHT][WIDTH * 16], part[HEIGHT][WIDTH * 16];
    pov_rect whole_picture = { 0, 0, WIDTH, HEIGHT };

    job_read(job, whole_picture, format, all, sizeof all[0]);
    for (int i = 0; i < 5; i++) {
        pov_rect r = pieces[i];

        job_read(job, r, format, part, sizeof part[0]);
        for (int y = 0; y < r.height; y++)
            assert_memory_equal(part[y], &all[r.y + y][(size_t)r.x * bytes], (size_t)r.width * bytes);
    }
}

static void pieces_of_a_coarse_picture_are_of_the_whole(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    pov_job *job;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    d.preview = 16;
    job = tiny_job(&s, &d);
    do {
        assert_pieces_are_of_the_whole(job, POV_PIXELS_LINEAR_FLOAT, 16);
        assert_pieces_are_of_the_whole(job, POV_PIXELS_DISPLAY8, 4);
    } while (job_step(job) == POV_JOB_RUNNING);
    job_destroy(job);
    tiny_end(&s);
}

static void reading_outside_the_picture_writes_nothing(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    pov_rect corner = { -2, -2, 4, 4 }, outside[] = { { WIDTH, 0, 4, 4 }, { 0, -4, 4, 4 }, { 5, 5, -1, 4 },
                                                      { 2147483647, 2147483647, 2147483647, 2147483647 } };
    unsigned char bytes[4][16], blank[4][16];
    pov_job *job;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    memset(blank, 7, sizeof blank);
    memset(bytes, 7, sizeof bytes);
    job = tiny_job(&s, &d);
    for (int i = 0; i < 4; i++)
        job_read(job, outside[i], POV_PIXELS_DISPLAY8, bytes, 16);
    assert_memory_equal(bytes, blank, sizeof bytes);
    while (job_step(job) == POV_JOB_RUNNING)
        ;
    job_read(job, corner, POV_PIXELS_DISPLAY8, bytes, 16);
    assert_memory_equal(bytes, blank, 2 * 16 + 8);
    assert_int_equal(bytes[2][11], 255);
    assert_int_equal(bytes[3][15], 255);
    assert_int_equal(bytes[3][7], 7);
    job_destroy(job);
    tiny_end(&s);
}

static void progress_counts_what_was_done(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    pov_progress progress = POV_INIT(progress);
    double last = 0.0;
    pov_job *job;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    d.preview = 8;
    job = tiny_job(&s, &d);
    job_get_progress(job, &progress);
    assert_near(progress.fraction, 0.0, 0.0);
    assert_near(progress.seconds, 0.0, 0.0);
    while (job_step(job) == POV_JOB_RUNNING) {
        job_get_progress(job, &progress);
        assert_true(progress.fraction > last && progress.fraction < 1.0);
        assert_int_equal(progress.counts.camera, floor(progress.fraction * WIDTH * HEIGHT + 0.5));
        last = progress.fraction;
    }
    job_get_progress(job, &progress);
    assert_near(progress.fraction, 1.0, 0.0);
    assert_int_equal(progress.pass, progress.passes);
    assert_true(progress.seconds > 0.0 && progress.counts.shadow > 0 && progress.counts.reflected > 0);
    job_destroy(job);
    tiny_end(&s);
}

static void count(void *user)
{
    ++*(int *)user;
}

static void a_wake_comes_when_there_is_something_to_take_again(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    int woken = 0;
    pov_rect r;
    pov_job *job;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    d.wake = count;
    d.wake_user = &woken;
    job = tiny_job(&s, &d);
    job_step(job);
    job_step(job);
    assert_int_equal(woken, 1);
    assert_true(job_take(job, &r));
    assert_true(job_take(job, &r));
    job_step(job);
    assert_int_equal(woken, 2);
    job_destroy(job);
    tiny_end(&s);
}

static void a_restart_takes_another_camera(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    pov_camera camera;
    pov_rect r;
    float *wanted;
    pov_job *job;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    camera = s.model.camera;
    camera.location.x = 0.5;
    d.camera = &camera;
    wanted = tiny_picture(&s, &d);
    d.camera = NULL;
    job = tiny_job(&s, &d);
    for (int i = 0; i < 5; i++)
        job_step(job);
    job_restart(job, &camera);
    assert_false(job_take(job, &r));
    while (job_step(job) == POV_JOB_RUNNING)
        ;
    same_bits(wanted, tiny_read(job, WIDTH, HEIGHT));
    job_restart(job, NULL);
    while (job_step(job) == POV_JOB_RUNNING)
        ;
    same_bits(wanted, tiny_read(job, WIDTH, HEIGHT));
    free(wanted);
    job_destroy(job);
    tiny_end(&s);
}

static void a_cancelled_job_stays_so_until_it_is_restarted(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    pov_job *job;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    job = tiny_job(&s, &d);
    job_step(job);
    job_cancel(job);
    assert_int_equal(job_step(job), POV_JOB_CANCELLED);
    assert_int_equal(job_wait(job, 10.0), POV_JOB_CANCELLED);
    assert_int_equal(job_get_error(job, NULL), POV_OK);
    job_restart(job, NULL);
    while (job_step(job) == POV_JOB_RUNNING)
        ;
    assert_int_equal(job_wait(job, 10.0), POV_JOB_DONE);
    job_cancel(job);
    assert_int_equal(job_wait(job, 10.0), POV_JOB_DONE);
    job_destroy(job);
    tiny_end(&s);
}

/* ---- what is refused ---- */

static void refuse(const tiny *s, pov_render_desc d, pov_status wanted)
{
    pov_error err = { 0 };
    pov_job *job = NULL;

    assert_int_equal(job_create(&job, s->shading, &d, &err), wanted);
    assert_null(job);
    assert_int_equal(err.status, wanted);
    assert_true(err.message[0] != '\0');
}

static void impossible_descriptions_are_refused(void **state)
{
    static const int sizes[][2] = { { 0, 1 }, { 1, 0 }, { -1, 5 }, { 5, -2147483647 }, { 1 << 29, 1 } };
    static const pov_rect crops[] = { { -1, 0, 5, 5 }, { 0, 0, 76, 1 }, { 70, 0, 6, 1 }, { 0, 49, 5, 2 },
                                      { 0, 0, -5, 5 }, { 0, 0, 5, 0 }, { 2147483647, 0, 2147483647, 1 } };
    static const int previews[] = { -1, 1, 3, 32 };
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    for (int i = 0; i < 5; i++)
        refuse(&s, tiny_desc(sizes[i][0], sizes[i][1]), POV_E_ARGUMENT);
    for (int i = 0; i < 7; i++) {
        d.crop = crops[i];
        refuse(&s, d, POV_E_ARGUMENT);
    }
    d = tiny_desc(WIDTH, HEIGHT);
    for (int i = 0; i < 4; i++) {
        d.preview = previews[i];
        refuse(&s, d, POV_E_ARGUMENT);
    }
    d.preview = 0;
    d.samples = -1;
    refuse(&s, d, POV_E_ARGUMENT);
    d.samples = 1 << 30;
    refuse(&s, d, POV_E_ARGUMENT);
    d.samples = 0;
    d.threads = -1;
    refuse(&s, d, POV_E_ARGUMENT);
    tiny_end(&s);
}

/* Gives nothing larger than 64 MiB, as a machine without overcommitted memory would not. */
static void *modest(void *user, void *block, size_t bytes)
{
    (void)user;
    if (bytes == 0) {
        free(block);
        return NULL;
    }
    return bytes <= (size_t)64 << 20 ? realloc(block, bytes) : NULL;
}

static void a_picture_larger_than_memory_is_refused_at_once(void **state)
{
    pov_allocator allocator = { modest, NULL };
    pov_render_desc part = tiny_desc(1 << 28, 1 << 28);
    pov_rect crop = { 1 << 27, 1 << 27, 3, 2 };
    float *pixels;
    tiny s;
    (void)state;

    tiny_room(&s, &allocator);
    refuse(&s, tiny_desc(1 << 28, 1 << 28), POV_E_MEMORY);
    refuse(&s, tiny_desc(1 << 16, 1 << 16), POV_E_MEMORY);
    part.crop = crop;
    pixels = tiny_picture(&s, &part);
    assert_true(pixels[4 * 5 + 3] == 1.0f);
    free(pixels);
    tiny_end(&s);
}

/* Render with memory that ends at the n-th allocation after loading. True: it did not matter. */
static bool survives(long n, bool by_steps)
{
    pov_render_desc d = tiny_desc(40, 30);
    pov_job *job = NULL;
    pov_error err = { 0 };
    pov_status status;
    failing memory;
    pov_allocator allocator;
    tiny s;

    failing_init(&memory, 0);
    allocator = failing_allocator(&memory);
    tiny_room(&s, &allocator);
    memory.fail_at = memory.calls + n;
    d.threads = 2;
    d.time_map = 1;
    status = job_create(&job, s.shading, &d, &err);
    if (status == POV_OK && !by_steps)
        status = job_start(job, &err);
    if (status == POV_OK) {
        while ((by_steps ? job_step(job) : job_wait(job, 1.0)) == POV_JOB_RUNNING)
            ;
        status = job_get_error(job, &err);
    }
    job_destroy(job);
    tiny_end(&s);
    assert_int_equal(memory.blocks, 0);
    assert_true(status == POV_OK || (status == POV_E_MEMORY && err.status == status && err.message[0] != '\0'));
    return status == POV_OK;
}

static void memory_that_ends_is_reported_wherever_it_ends(void **state)
{
    (void)state;

    for (int by_steps = 0; by_steps < 2; by_steps++) {
        long n = 1;
        while (!survives(n, by_steps))
            n++;
        assert_true(n > 8);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_number_of_threads_changes_no_bit),
        cmocka_unit_test(a_preview_changes_no_bit_of_the_end),
        cmocka_unit_test(steps_give_the_picture_that_threads_give),
        cmocka_unit_test(a_pixel_is_what_the_tracer_sees_through_it),
        cmocka_unit_test(samples_are_averaged),
        cmocka_unit_test(a_crop_is_the_part_of_the_whole),
        cmocka_unit_test(taken_tiles_cover_every_pixel_once),
        cmocka_unit_test(reading_what_is_taken_gives_the_picture),
        cmocka_unit_test(the_first_pass_fills_the_picture),
        cmocka_unit_test(pieces_of_a_coarse_picture_are_of_the_whole),
        cmocka_unit_test(reading_outside_the_picture_writes_nothing),
        cmocka_unit_test(progress_counts_what_was_done),
        cmocka_unit_test(a_wake_comes_when_there_is_something_to_take_again),
        cmocka_unit_test(a_restart_takes_another_camera),
        cmocka_unit_test(a_cancelled_job_stays_so_until_it_is_restarted),
        cmocka_unit_test(impossible_descriptions_are_refused),
        cmocka_unit_test(a_picture_larger_than_memory_is_refused_at_once),
        cmocka_unit_test(memory_that_ends_is_reported_wherever_it_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
