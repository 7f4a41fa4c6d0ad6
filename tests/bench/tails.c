/* tails - what the tiles of a picture allow: each is traced alone, and what it took is handed out to 1, 2, ... 16
 * threads as a job hands out tiles, to the first that is free. The longest of these threads ends the picture, so the
 * printed number is how many times as fast the job could be, were cores, caches and memory no limit. It needs no
 * machine with so many cores.
 * Usage: tails SCENE WIDTH HEIGHT */
#include <povtrace/povtrace.h>

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { THREADS_MAX = 16 };

static double cpu_seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The number of the thread that is free first. */
static int first_free(const double *ends, int threads)
{
    int first = 0;

    for (int i = 1; i < threads; i++)
        if (ends[i] < ends[first])
            first = i;
    return first;
}

static pov_status hand_out(const pov_scene *scene, int width, int height, int threads, pov_error *err)
{
    pov_render_desc desc = POV_INIT(desc);
    double ends[THREADS_MAX] = { 0 }, all = 0.0, dearest = 0.0, last = 0.0;
    pov_job_state state = POV_JOB_RUNNING;
    pov_job *job;
    int steps = 0;

    desc.width = width;
    desc.height = height;
    desc.threads = threads;
    if (pov_job_create(&job, scene, &desc, err) < 0)
        return err->status;
    for (; state == POV_JOB_RUNNING; steps++) {
        double began = cpu_seconds(), took;

        state = pov_job_step(job);
        took = cpu_seconds() - began;
        ends[first_free(ends, threads)] += took;
        all += took;
        dearest = took > dearest ? took : dearest;
    }
    for (int i = 0; i < threads; i++)
        last = ends[i] > last ? ends[i] : last;
    printf("threads: %d tiles: %d dearest_ms: %.3f faster: %.3f\n", threads, steps, 1e3 * dearest, all / last);
    pov_job_destroy(job);
    return POV_OK;
}

int main(int argc, char **argv)
{
    pov_context *context = NULL;
    pov_scene *scene = NULL;
    pov_error err = { 0 };
    pov_status status;

    if (argc != 4) {
        fprintf(stderr, "usage: tails SCENE WIDTH HEIGHT\n");
        return 2;
    }
    status = pov_context_create(&context, NULL, &err);
    if (status == POV_OK)
        status = pov_scene_load_file(&scene, context, argv[1], NULL, &err);
    for (int threads = 1; threads <= THREADS_MAX && status == POV_OK; threads *= 2)
        status = hand_out(scene, atoi(argv[2]), atoi(argv[3]), threads, &err);
    if (status < 0)
        fprintf(stderr, "tails: %s\n", err.message);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return status < 0;
}
