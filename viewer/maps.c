#include "maps.h"

#include "bar.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { COARSEST = 16 };

struct maps {
    pov_tracer *tracer;          /* the thread's */
    void (*wake)(void *user);
    void *wake_user;
    pthread_t thread;
    pthread_mutex_t lock;        /* guards all below */
    pthread_cond_t changed;
    bool closing, working;
    unsigned generation;
    maps_request request;
    uint8_t *pixels;
    size_t capacity;
    maps_counts counts;
    int first, last;             /* rows not taken yet; last < first: none */
};

static uint8_t byte_of(double v)
{
    return (uint8_t)(v > 0.0 ? v < 1.0 ? 255.0 * v + 0.5 : 255.0 : 0.0);
}

/* Surfaces that are seen edge-on are darker, so that their shape is seen under the colour. */
static double shade(pov_vec3 ray, const pov_hit *hit)
{
    const double least = 0.3, length = sqrt(pov_dot(ray, ray) * pov_dot(hit->normal, hit->normal));

    return length > 0.0 ? least + (1.0 - least) * fabs(pov_dot(ray, hit->normal)) / length : 1.0;
}

static void color_certainty(pov_vec3 ray, const pov_hit *hit, uint8_t *rgba)
{
    static const uint8_t certain[3] = { 90, 130, 220 }, uncertain[3] = { 255, 150, 30 };
    const double light = shade(ray, hit);

    for (int c = 0; c < 3; c++)
        rgba[c] = byte_of(light * (hit->certain ? certain[c] : uncertain[c]) / 255.0);
}

void maps_color(const maps_request *request, pov_vec3 ray, const pov_hit *hit, uint8_t *rgba)
{
    rgba[0] = rgba[1] = rgba[2] = 0;
    rgba[3] = 255;
    if (!hit)
        return;
    if (request->kind == MAPS_CERTAINTY) {
        color_certainty(ray, hit, rgba);
        return;
    }
    if (request->kind == MAPS_DEPTH) {
        bar_color(BAR_DEPTH, bar_depth_share(request->middle, hit->distance), rgba);
        return;
    }
    rgba[0] = byte_of(0.5 + 0.5 * hit->normal.x);
    rgba[1] = byte_of(0.5 + 0.5 * hit->normal.y);
    rgba[2] = byte_of(0.5 + 0.5 * hit->normal.z);
}

static void trace(maps *m, const maps_request *r, int x, int y, uint8_t *rgba, maps_counts *counts)
{
    double u = (x + 0.5) / r->width - 0.5, v = 0.5 - (y + 0.5) / r->height;
    pov_hit hit = POV_INIT(hit);
    pov_vec3 org, dir = { 0.0, 0.0, 0.0 };
    bool found = pov_camera_ray(&r->camera, u, v, &org, &dir) && pov_trace_hit(m->tracer, org, dir, &hit);

    maps_color(r, dir, found ? &hit : NULL, rgba);
    counts->certain += found && hit.certain;
    counts->uncertain += found && !hit.certain;
}

/* One row of pixels `step` apart; pixels of the coarser pass are left unchanged. */
static void trace_row(maps *m, const maps_request *r, int y, int step, uint8_t *row, maps_counts *counts)
{
    bool has_coarser = step < COARSEST && y % (2 * step) == 0;

    for (int x = 0; x < r->width; x += step)
        if (!has_coarser || x % (2 * step) != 0)
            trace(m, r, x, y, row + 4 * x, counts);
}

/* Copy each pixel of a row to the square that it stands for. The lock is held. */
static void put_row(maps *m, int y, int step, const uint8_t *row)
{
    size_t width = (size_t)m->request.width;
    int bottom = y + step < m->request.height ? y + step : m->request.height;
    uint8_t *to = m->pixels + 4 * width * (size_t)y;
    bool has_coarser = step < COARSEST && y % (2 * step) == 0;

    for (size_t x = 0; x < width; x++) {
        size_t from = x - x % (size_t)step;

        if (has_coarser && from % (2 * (size_t)step) == 0)
            continue;
        memcpy(to + 4 * x, row + 4 * from, 4);
    }
    /* In a row of the coarser pass its pixels keep their lower half: rows below come with their own pass. */
    for (int below = y + 1; below < bottom; below++)
        memcpy(m->pixels + 4 * width * (size_t)below, to, 4 * width);
    m->first = y < m->first ? y : m->first;
    m->last = bottom - 1 > m->last ? bottom - 1 : m->last;
}

/* Trace the present request; given up when another comes. */
static void work(maps *m, const maps_request *r, unsigned generation, uint8_t *row)
{
    for (int step = COARSEST; step >= 1; step /= 2) {
        for (int y = 0; y < r->height; y += step) {
            maps_counts counts = { 0, 0 };
            bool tell = false, current;

            trace_row(m, r, y, step, row, &counts);
            pthread_mutex_lock(&m->lock);
            current = m->generation == generation && !m->closing;
            if (current) {
                tell = m->last < m->first;
                put_row(m, y, step, row);
                m->counts.certain += counts.certain;
                m->counts.uncertain += counts.uncertain;
            }
            pthread_mutex_unlock(&m->lock);
            if (!current)
                return;
            if (tell && m->wake)
                m->wake(m->wake_user);
        }
    }
    pthread_mutex_lock(&m->lock);
    if (m->generation == generation)
        m->working = false;
    pthread_mutex_unlock(&m->lock);
    if (m->wake)
        m->wake(m->wake_user);
}

static void *run(void *user)
{
    maps *m = user;

    pthread_mutex_lock(&m->lock);
    while (!m->closing) {
        maps_request request = m->request;
        unsigned generation = m->generation;
        uint8_t *row;

        if (!m->working) {
            pthread_cond_wait(&m->changed, &m->lock);
            continue;
        }
        pthread_mutex_unlock(&m->lock);
        row = malloc((size_t)request.width * 4);
        if (row)
            work(m, &request, generation, row);
        free(row);
        pthread_mutex_lock(&m->lock);
        if (!row)
            m->working = false;
    }
    pthread_mutex_unlock(&m->lock);
    return NULL;
}

pov_status maps_create(maps **out, const pov_scene *scene, void (*wake)(void *), void *wake_user, pov_error *err)
{
    maps *m = calloc(1, sizeof *m);
    pov_status status = m ? pov_tracer_create(&m->tracer, scene, err) : POV_E_MEMORY;

    *out = NULL;
    if (status < 0) {
        free(m);
        return status;
    }
    m->wake = wake;
    m->wake_user = wake_user;
    m->last = -1;
    pthread_mutex_init(&m->lock, NULL);
    pthread_cond_init(&m->changed, NULL);
    if (pthread_create(&m->thread, NULL, run, m) != 0) {
        pov_tracer_destroy(m->tracer);
        free(m);
        return POV_E_MEMORY;
    }
    *out = m;
    return POV_OK;
}

void maps_destroy(maps *m)
{
    if (!m)
        return;
    pthread_mutex_lock(&m->lock);
    m->closing = true;
    pthread_cond_signal(&m->changed);
    pthread_mutex_unlock(&m->lock);
    pthread_join(m->thread, NULL);
    pthread_cond_destroy(&m->changed);
    pthread_mutex_destroy(&m->lock);
    pov_tracer_destroy(m->tracer);
    free(m->pixels);
    free(m);
}

void maps_begin(maps *m, const maps_request *request)
{
    size_t bytes = (size_t)request->width * (size_t)request->height * 4;

    pthread_mutex_lock(&m->lock);
    m->generation++;
    m->request = *request;
    m->counts = (maps_counts){ 0, 0 };
    m->first = request->height;
    m->last = -1;
    if (bytes > m->capacity) {
        free(m->pixels);
        m->pixels = malloc(bytes);
        m->capacity = m->pixels ? bytes : 0;
    }
    m->working = m->pixels != NULL;
    pthread_cond_signal(&m->changed);
    pthread_mutex_unlock(&m->lock);
}

void maps_stop(maps *m)
{
    pthread_mutex_lock(&m->lock);
    m->generation++;
    m->working = false;
    m->first = m->request.height;
    m->last = -1;
    pthread_mutex_unlock(&m->lock);
}

bool maps_take(maps *m, uint8_t *pixels, int *first, int *last)
{
    size_t stride;
    bool found;

    pthread_mutex_lock(&m->lock);
    stride = (size_t)m->request.width * 4;
    found = m->last >= m->first;
    if (found) {
        *first = m->first;
        *last = m->last;
        memcpy(pixels + stride * (size_t)*first, m->pixels + stride * (size_t)*first,
               stride * (size_t)(*last - *first + 1));
        m->first = m->request.height;
        m->last = -1;
    }
    pthread_mutex_unlock(&m->lock);
    return found;
}

maps_counts maps_count(maps *m)
{
    maps_counts counts;

    pthread_mutex_lock(&m->lock);
    counts = m->counts;
    pthread_mutex_unlock(&m->lock);
    return counts;
}

bool maps_is_done(maps *m)
{
    bool done;

    pthread_mutex_lock(&m->lock);
    done = !m->working && m->last < m->first;
    pthread_mutex_unlock(&m->lock);
    return done;
}
