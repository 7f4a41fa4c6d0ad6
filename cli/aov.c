#include "aov.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

enum { THREADS_MAX = 64 };

typedef struct maps {
    const args *args;
    const pov_scene *scene;
    pov_camera camera;
    pov_rect rect;               /* the part of the picture that is mapped */
    int threads;
    float *pixels[ARGS_AOVS];    /* four channels each; NULL: not asked for */
} maps;

/* Work of one thread: each n-th row. */
typedef struct share { const maps *maps; int first; pov_tracer *tracer; } share;

/* The map of time is the job's; all others are of hits. */
static bool wants_rays(const args *a)
{
    for (int i = 0; i < ARGS_AOVS; i++)
        if (a->aov[i] && i != ARGS_AOV_TIME)
            return true;
    return false;
}

static pov_image_options options(void)
{
    pov_image_options o = POV_INIT(o);

    o.transfer = POV_TRANSFER_LINEAR;
    return o;
}

pov_status aov_check(pov_context *context, const args *a, pov_error *err)
{
    pov_image_options o = options();
    pov_status status = POV_OK;

    for (int i = 0; i < ARGS_AOVS && status == POV_OK; i++)
        if (a->aov[i])
            status = pov_image_check(context, a->aov[i], &o, err);
    return status;
}

static int threads_of(const args *a)
{
    const long cores = sysconf(_SC_NPROCESSORS_ONLN), wanted = a->threads > 0 ? a->threads : cores;

    return wanted < 1 ? 1 : wanted > THREADS_MAX ? THREADS_MAX : (int)wanted;
}

/* ---- tracing ---- */

/* The screen position of a pixel's centre in -1/2 .. 1/2: the same rays as the picture's single samples. */
static double centred(int pixel, int size)
{
    return ((double)pixel - 0.5 * size + 0.5) / size;
}

static bool ray_at(const maps *m, int x, int y, pov_vec3 *org, pov_vec3 *dir)
{
    const double u = centred(m->rect.x + x, m->args->width), v = -centred(m->rect.y + y, m->args->height);

    return pov_camera_ray(&m->camera, u, v, org, dir);
}

static void put(float *to, double r, double g, double b)
{
    to[0] = (float)r;
    to[1] = (float)g;
    to[2] = (float)b;
    to[3] = 1.0f;
}

static double length(pov_vec3 v)
{
    const double m = pov_largest(v);

    return m > 0.0 ? m * sqrt(pov_dot(pov_scale(v, 1.0 / m), pov_scale(v, 1.0 / m))) : 0.0;
}

static bool holds_floats(const char *path)
{
    const char *dot = strrchr(path, '.');

    return dot && (strcasecmp(dot, ".pfm") == 0 || strcasecmp(dot, ".exr") == 0);
}

/* One more than the object's number, so that nothing is 0; where a file holds integers, a colour for each that is far from
 * those of its neighbours. */
static void put_object(const char *path, float *to, uint32_t object)
{
    const double turn = fmod(0.6180339887498949 * (double)(object + 1), 1.0), bright = 1.0 - 0.25 * (double)(object % 3);

    if (holds_floats(path))
        put(to, object + 1.0, object + 1.0, object + 1.0);
    else
        put(to, bright * fmin(1.0, fabs(6.0 * turn - 3.0) * 0.5), bright * (1.0 - fabs(2.0 * turn - 1.0)),
            bright * (0.2 + 0.8 * turn));
}

static void map_pixel(const maps *m, pov_tracer *tracer, int x, int y)
{
    const size_t at = 4 * ((size_t)y * (size_t)m->rect.width + (size_t)x);
    pov_hit h = POV_INIT(h);
    pov_vec3 org, d;
    const bool met = ray_at(m, x, y, &org, &d) && pov_trace_hit(tracer, org, d, &h);

    if (m->pixels[ARGS_AOV_CERTAINTY])
        put(m->pixels[ARGS_AOV_CERTAINTY] + at, !h.certain, met && h.certain, 0.0);
    if (!met)
        return;
    if (m->pixels[ARGS_AOV_NORMAL])
        put(m->pixels[ARGS_AOV_NORMAL] + at, 0.5 + 0.5 * h.normal.x, 0.5 + 0.5 * h.normal.y, 0.5 + 0.5 * h.normal.z);
    if (m->pixels[ARGS_AOV_OBJECT])
        put_object(m->args->aov[ARGS_AOV_OBJECT], m->pixels[ARGS_AOV_OBJECT] + at, h.object);
    if (m->pixels[ARGS_AOV_DEPTH]) {
        const double depth = h.distance * length(d);
        put(m->pixels[ARGS_AOV_DEPTH] + at, depth, depth, depth);
    }
}

static void *work(void *user)
{
    const share *s = user;

    for (int y = s->first; y < s->maps->rect.height; y += s->maps->threads)
        for (int x = 0; x < s->maps->rect.width; x++)
            map_pixel(s->maps, s->tracer, x, y);
    return NULL;
}

/* If a thread cannot be started, this one does its work. */
static pov_status trace(const maps *m, pov_error *err)
{
    share shares[THREADS_MAX];
    pthread_t threads[THREADS_MAX];
    bool started[THREADS_MAX] = { false };
    pov_status status = POV_OK;
    int i;

    memset(shares, 0, sizeof shares);
    for (i = 0; i < m->threads && status == POV_OK; i++) {
        shares[i].maps = m;
        shares[i].first = i;
        status = pov_tracer_create(&shares[i].tracer, m->scene, err);
    }
    for (i = 1; i < m->threads && status == POV_OK; i++)
        started[i] = pthread_create(&threads[i], NULL, work, &shares[i]) == 0;
    for (i = 0; i < m->threads; i++) {
        if (started[i])
            pthread_join(threads[i], NULL);
        else if (status == POV_OK)
            work(&shares[i]);
    }
    for (i = 0; i < m->threads; i++)
        pov_tracer_destroy(shares[i].tracer);
    return status;
}

/* ---- time ---- */

/* Microseconds; or fractions of the maximum, where a file of integers would clip them. */
static void map_time(const maps *m, pov_job *job)
{
    const size_t count = (size_t)m->rect.width * (size_t)m->rect.height;
    const pov_rect all = { 0, 0, m->rect.width, m->rect.height };
    float *to = m->pixels[ARGS_AOV_TIME];
    double most = 0.0, scale = 1e6;

    pov_job_read(job, all, POV_PIXELS_TIME, to, sizeof *to * (size_t)m->rect.width);
    for (size_t i = 0; i < count; i++)
        most = fmax(most, (double)to[i]);
    if (!holds_floats(m->args->aov[ARGS_AOV_TIME]))
        scale = most > 0.0 ? 1.0 / most : 0.0;
    /* From the last element on, because the results overwrite the first ones. */
    for (size_t i = count; i-- > 0;) {
        const double value = scale * (double)to[i];
        put(to + 4 * i, value, value, value);
    }
}

/* ---- writing ---- */

static pov_status prepare(maps *m, pov_error *err)
{
    const size_t count = 4 * (size_t)m->rect.width * (size_t)m->rect.height;

    for (int i = 0; i < ARGS_AOVS; i++) {
        if (!m->args->aov[i])
            continue;
        m->pixels[i] = calloc(count, sizeof *m->pixels[i]);
        if (!m->pixels[i]) {
            memset(err, 0, sizeof *err);
            err->status = POV_E_MEMORY;
            snprintf(err->message, sizeof err->message, "out of memory for a map of this size");
            return POV_E_MEMORY;
        }
    }
    return POV_OK;
}

pov_status aov_write(pov_context *context, const pov_scene *scene, pov_job *job, const args *a, pov_error *err)
{
    const pov_rect all = { 0, 0, a->width, a->height };
    pov_image_options o = options();
    maps m = { .args = a, .scene = scene, .camera = POV_INIT(m.camera) };
    pov_status status;

    m.rect = a->crop.width ? a->crop : all;
    m.threads = threads_of(a);
    pov_scene_get_camera(scene, &m.camera);
    status = prepare(&m, err);
    if (status == POV_OK && wants_rays(a))
        status = trace(&m, err);
    if (status == POV_OK && m.pixels[ARGS_AOV_TIME])
        map_time(&m, job);
    for (int i = 0; i < ARGS_AOVS; i++) {
        if (m.pixels[i] && status == POV_OK)
            status = pov_image_write(context, a->aov[i], m.rect.width, m.rect.height, m.pixels[i],
                                     4 * sizeof(float) * (size_t)m.rect.width, &o, err);
        free(m.pixels[i]);
    }
    return status;
}
