/* Jobs that are restarted, cancelled, watched and destroyed while threads work on them. */
#include "support/failing.h"
#include "support/near.h"
#include "support/tiny_job.h"

#include "base/clock.h"
#include "base/thread.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 75, HEIGHT = 50 };

static void nap(double seconds)
{
    mutex m;
    condition c;
    double until = clock_seconds() + seconds;

    assert_true(mutex_init(&m) && condition_init(&c));
    mutex_lock(&m);
    while (condition_wait_until(&c, &m, until))
        ;
    mutex_unlock(&m);
    condition_destroy(&c);
    mutex_destroy(&m);
}

static unsigned next_random(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return *seed >> 16;
}

/* What a viewer does, until it is told to stop. */
typedef struct viewer { pov_job *job; mutex lock; bool stop; long taken; float pixels[4 * WIDTH * HEIGHT]; } viewer;

static bool is_stopped(viewer *v)
{
    bool stop;

    mutex_lock(&v->lock);
    stop = v->stop;
    mutex_unlock(&v->lock);
    return stop;
}

static void *watch(void *user)
{
    viewer *v = user;
    pov_progress progress = POV_INIT(progress);
    pov_rect r;

    while (!is_stopped(v)) {
        job_wait(v->job, 0.001);
        while (job_take(v->job, &r)) {
            job_read(v->job, r, POV_PIXELS_LINEAR_FLOAT, v->pixels + 4 * (r.y * WIDTH + r.x),
                     4 * sizeof(float) * WIDTH);
            v->taken++;
        }
        job_get_progress(v->job, &progress);
    }
    return NULL;
}

static void conclude(viewer *v, thread t)
{
    mutex_lock(&v->lock);
    v->stop = true;
    mutex_unlock(&v->lock);
    thread_join(t);
    mutex_destroy(&v->lock);
}

static void a_storm_of_restarts_ends_in_the_last_camera_s_picture(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    viewer *v = calloc(1, sizeof *v);
    unsigned seed = 3;
    pov_camera camera;
    float *wanted, *found;
    thread t;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    camera = s.model.camera;
    d.preview = 16;
    d.threads = 3;
    v->job = tiny_job(&s, &d);
    assert_true(mutex_init(&v->lock));
    assert_int_equal(job_start(v->job, NULL), POV_OK);
    assert_true(thread_start(&t, watch, v));
    for (int i = 0; i < 300; i++) {
        camera.location.x = i * 0.01;
        job_restart(v->job, &camera);
        if (next_random(&seed) % 4 == 0)
            nap(next_random(&seed) % 100 * 1e-5);
    }
    while (job_wait(v->job, 1.0) == POV_JOB_RUNNING)
        ;
    conclude(v, t);
    found = tiny_read(v->job, WIDTH, HEIGHT);
    d.camera = &camera;
    wanted = tiny_picture(&s, &d);
    assert_memory_equal(found, wanted, sizeof v->pixels);
    assert_true(v->taken > 0);
    job_destroy(v->job);
    free(found);
    free(wanted);
    free(v);
    tiny_end(&s);
}

static void a_job_may_be_cancelled_and_destroyed_at_any_moment(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    unsigned seed = 11;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    for (int i = 0; i < 60; i++) {
        pov_job *job;
        pov_job_state after;

        d.threads = 1 + i % 4;
        d.preview = i % 2 ? 8 : 0;
        job = tiny_job(&s, &d);
        assert_int_equal(job_start(job, NULL), POV_OK);
        nap(next_random(&seed) % 40 * 1e-4);
        if (i % 3 > 0)
            job_cancel(job);
        after = job_wait(job, 0.0);
        assert_true(i % 3 == 0 || after == POV_JOB_CANCELLED || after == POV_JOB_DONE);
        job_destroy(job);
    }
    tiny_end(&s);
}

/* Each pixel of this scene is a tree of 2^200 rays: only the question whether to give up ends it. */
static void a_pixel_that_takes_for_ever_is_given_up_at_once(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    double start, cancelled;
    pov_job *job;
    tiny s;
    (void)state;

    tiny_endless(&s);
    d.threads = 2;
    job = tiny_job(&s, &d);
    assert_int_equal(job_start(job, NULL), POV_OK);
    assert_int_equal(job_wait(job, 0.1), POV_JOB_RUNNING);
    start = clock_seconds();
    job_cancel(job);
    job_destroy(job);
    cancelled = clock_seconds() - start;
    print_message("cancelled and joined after %.1f ms\n", 1e3 * cancelled);
    assert_true(cancelled < 2.0);
    tiny_end(&s);
}

/* One job's life: of any size and kind, and whatever a viewer may do to it at any moment. */
static void weather(const tiny *s, viewer *v, unsigned *seed)
{
    pov_render_desc d = tiny_desc(1 + (int)(next_random(seed) % WIDTH), 1 + (int)(next_random(seed) % HEIGHT));
    pov_camera camera = s->model.camera;
    thread t;

    d.threads = 1 + (int)(next_random(seed) % 4);
    d.preview = next_random(seed) % 2 ? 16 : 0;
    d.samples = next_random(seed) % 3 ? 12 : 1;
    d.sampling = next_random(seed) % 2 ? POV_SAMPLING_ADAPTIVE : POV_SAMPLING_UNIFORM;
    v->stop = false;
    v->job = tiny_job(s, &d);
    assert_true(mutex_init(&v->lock) && thread_start(&t, watch, v));
    for (int i = 0; i < 30; i++) {
        unsigned what = next_random(seed) % 8;

        camera.location.x = i * 0.01;
        if (what < 3)
            job_restart(v->job, &camera);
        else if (what < 5)
            job_pause(v->job, what == 3);
        else if (what == 5)
            job_cancel(v->job);
        else if (what == 6)
            assert_int_equal(job_start(v->job, NULL), POV_OK);
        nap(next_random(seed) % 20 * 1e-4);
    }
    if (next_random(seed) % 4 == 0) {
        float *found, *wanted;

        job_pause(v->job, false);
        job_restart(v->job, &camera);
        while (job_step(v->job) == POV_JOB_RUNNING)
            continue;
        found = tiny_read(v->job, d.width, d.height);
        d.camera = &camera;
        wanted = tiny_picture(s, &d);
        assert_memory_equal(found, wanted, 4 * sizeof(float) * (size_t)d.width * (size_t)d.height);
        free(found);
        free(wanted);
    }
    conclude(v, t);
    job_destroy(v->job);
}

/* Or -1 where the system does not say. */
static int threads_alive(void)
{
    DIR *tasks = opendir("/proc/self/task");
    int count = 0;

    if (!tasks)
        return -1;
    while (readdir(tasks))
        count++;
    closedir(tasks);
    return count;
}

/* For POVTRACE_STORM seconds, half a second where nobody says. */
static void all_of_it_at_random_moments_leaves_nothing_behind(void **state)
{
    const char *asked = getenv("POVTRACE_STORM");
    double until = clock_seconds() + (asked ? strtod(asked, NULL) : 0.5);
    viewer *v = calloc(1, sizeof *v);
    unsigned seed = 17;
    pov_allocator memory;
    failing all;
    int lives = 0, alive;
    long blocks;
    tiny s;
    (void)state;

    failing_init(&all, 0);
    memory = failing_allocator(&all);
    tiny_room(&s, &memory);
    blocks = all.blocks;
    alive = threads_alive();
    for (; lives == 0 || clock_seconds() < until; lives++)
        weather(&s, v, &seed);
    assert_int_equal(all.blocks, blocks);
    /* The system may list a thread for a moment after it was joined. */
    for (int i = 0; i < 100 && threads_alive() != alive; i++)
        nap(0.01);
    assert_int_equal(threads_alive(), alive);
    print_message("%d jobs came and went\n", lives);
    free(v);
    tiny_end(&s);
}

static void *step_to_the_end(void *user)
{
    while (job_step(user) == POV_JOB_RUNNING)
        ;
    return NULL;
}

static void threads_of_the_program_may_step_beside_those_of_the_job(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    thread t[3];
    float *wanted, *found;
    pov_job *job;
    tiny s;
    (void)state;

    tiny_room(&s, NULL);
    d.preview = 4;
    wanted = tiny_picture(&s, &d);
    d.threads = 2;
    job = tiny_job(&s, &d);
    for (int i = 0; i < 3; i++)
        assert_true(thread_start(&t[i], step_to_the_end, job));
    assert_int_equal(job_start(job, NULL), POV_OK);
    assert_int_equal(job_start(job, NULL), POV_OK);
    for (int i = 0; i < 3; i++)
        thread_join(t[i]);
    assert_int_equal(job_wait(job, 0.0), POV_JOB_DONE);
    found = tiny_read(job, WIDTH, HEIGHT);
    assert_memory_equal(found, wanted, 4 * sizeof(float) * WIDTH * HEIGHT);
    free(found);
    free(wanted);
    job_destroy(job);
    tiny_end(&s);
}

static void waiting_ends_when_its_time_is_up(void **state)
{
    pov_render_desc d = tiny_desc(WIDTH, HEIGHT);
    double start;
    pov_job *job;
    tiny s;
    (void)state;

    tiny_endless(&s);
    job = tiny_job(&s, &d);
    assert_int_equal(job_wait(job, 100.0), POV_JOB_IDLE);
    assert_int_equal(job_start(job, NULL), POV_OK);
    start = clock_seconds();
    assert_int_equal(job_wait(job, 0.05), POV_JOB_RUNNING);
    assert_true(clock_seconds() - start >= 0.05);
    assert_int_equal(job_wait(job, NAN), POV_JOB_RUNNING);
    assert_int_equal(job_wait(job, -1.0), POV_JOB_RUNNING);
    job_destroy(job);
    tiny_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_storm_of_restarts_ends_in_the_last_camera_s_picture),
        cmocka_unit_test(a_job_may_be_cancelled_and_destroyed_at_any_moment),
        cmocka_unit_test(all_of_it_at_random_moments_leaves_nothing_behind),
        cmocka_unit_test(a_pixel_that_takes_for_ever_is_given_up_at_once),
        cmocka_unit_test(threads_of_the_program_may_step_beside_those_of_the_job),
        cmocka_unit_test(waiting_ends_when_its_time_is_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
