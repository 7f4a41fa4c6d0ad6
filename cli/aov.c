#include "aov.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

enum { THREADS_MAX = 64, BAND = 16 };

/* Where the values of a map come from, how many a pixel has, and the names that they have as layers of a file. */
typedef struct kind { pov_pixels pixels; int values; const char *layers[3]; } kind;

static const kind kinds[ARGS_AOVS] = {
    [ARGS_AOV_CERTAINTY] = { POV_PIXELS_CERTAINTY, 1, { "certainty.V" } },
    [ARGS_AOV_NORMAL] = { POV_PIXELS_NORMAL, 4, { "normal.X", "normal.Y", "normal.Z" } },
    [ARGS_AOV_DEPTH] = { POV_PIXELS_DEPTH, 1, { "depth.Z" } },
    [ARGS_AOV_TIME] = { POV_PIXELS_TIME, 1, { "time.us" } },
    [ARGS_AOV_OBJECT] = { POV_PIXELS_OBJECT, 1, { "object.id" } },
    [ARGS_AOV_POSITION] = { POV_PIXELS_POSITION, 4, { "position.X", "position.Y", "position.Z" } },
    [ARGS_AOV_ALBEDO] = { POV_PIXELS_ALBEDO, 4, { "albedo.R", "albedo.G", "albedo.B" } },
    [ARGS_AOV_ALPHA] = { POV_PIXELS_ALPHA, 1, { "alpha.A" } },
};

typedef struct maps {
    const args *args;
    pov_job *job;
    pov_rect rect;               /* the part of the picture that is mapped, from its corner */
    int threads;
    float *values[ARGS_AOVS];    /* as pov_job_read() gives them; NULL: not asked for */
    float *pixels;               /* red, green, blue, alpha of the map that is being written */
} maps;

/* Work of one thread: each n-th band of rows. */
typedef struct share { const maps *maps; int first; } share;

/* Misses have no certainty of their own colour, so that map needs the one of objects. */
static bool is_wanted(const args *a, int i)
{
    return a->aov[i] || (i == ARGS_AOV_OBJECT && a->aov[ARGS_AOV_CERTAINTY]);
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

/* ---- reading ---- */

static void read_band(const maps *m, int y)
{
    const int rows = m->rect.height - y < BAND ? m->rect.height - y : BAND;
    const pov_rect band = { 0, y, m->rect.width, rows };

    for (int i = 0; i < ARGS_AOVS; i++) {
        const size_t row = (size_t)kinds[i].values * (size_t)m->rect.width;

        if (m->values[i])
            pov_job_read(m->job, band, kinds[i].pixels, m->values[i] + row * (size_t)y, row * sizeof(float));
    }
}

static void *work(void *user)
{
    const share *s = user;

    for (int y = BAND * s->first; y < s->maps->rect.height; y += BAND * s->maps->threads)
        read_band(s->maps, y);
    return NULL;
}

/* If a thread cannot be started, this one does its work. */
static void read_all(const maps *m)
{
    share shares[THREADS_MAX];
    pthread_t threads[THREADS_MAX];
    bool started[THREADS_MAX] = { false };

    for (int i = 0; i < m->threads; i++) {
        shares[i] = (share){ m, i };
        started[i] = i > 0 && pthread_create(&threads[i], NULL, work, &shares[i]) == 0;
    }
    for (int i = 0; i < m->threads; i++)
        if (!started[i])
            work(&shares[i]);
    for (int i = 0; i < m->threads; i++)
        if (started[i])
            pthread_join(threads[i], NULL);
}

/* ---- a map by itself: its values as colours ---- */

static void put(float *to, double r, double g, double b)
{
    to[0] = (float)r;
    to[1] = (float)g;
    to[2] = (float)b;
    to[3] = 1.0f;
}

static bool holds_floats(const char *path)
{
    const char *dot = strrchr(path, '.');

    return dot && (strcasecmp(dot, ".pfm") == 0 || strcasecmp(dot, ".exr") == 0);
}

static uint32_t object_at(const maps *m, size_t pixel)
{
    uint32_t number;

    memcpy(&number, m->values[ARGS_AOV_OBJECT] + pixel, sizeof number);
    return number;
}

/* One more than the object's number, so that nothing is 0; where a file holds integers, a colour for each that is far from
 * those of its neighbours. */
static void put_object(const char *path, float *to, uint32_t object)
{
    const double turn = fmod(0.6180339887498949 * (double)(object + 1), 1.0), bright = 1.0 - 0.25 * (double)(object % 3);

    if (object == UINT32_MAX)
        put(to, 0.0, 0.0, 0.0);
    else if (holds_floats(path))
        put(to, object + 1.0, object + 1.0, object + 1.0);
    else
        put(to, bright * fmin(1.0, fabs(6.0 * turn - 3.0) * 0.5), bright * (1.0 - fabs(2.0 * turn - 1.0)),
            bright * (0.2 + 0.8 * turn));
}

static void put_certainty(const maps *m, size_t pixel, float *to)
{
    const bool is_certain = m->values[ARGS_AOV_CERTAINTY][pixel] > 0.0f;

    put(to, !is_certain, is_certain && object_at(m, pixel) != UINT32_MAX, 0.0);
}

/* Half of it, plus a half. */
static void put_normal(const float *v, float *to)
{
    if (v[3] > 0.0f)
        put(to, 0.5 + 0.5 * (double)v[0], 0.5 + 0.5 * (double)v[1], 0.5 + 0.5 * (double)v[2]);
    else
        put(to, 0.0, 0.0, 0.0);
}

/* Of seconds microseconds; or fractions of the maximum, where a file of integers would clip them. */
static double scale_of(const maps *m, int which)
{
    const size_t count = (size_t)m->rect.width * (size_t)m->rect.height;
    double most = 0.0;

    if (which != ARGS_AOV_TIME)
        return 1.0;
    for (size_t i = 0; i < count; i++)
        most = fmax(most, (double)m->values[which][i]);
    return holds_floats(m->args->aov[which]) ? 1e6 : most > 0.0 ? 1.0 / most : 0.0;
}

static void colour_pixel(const maps *m, int which, size_t pixel, double scale)
{
    const float *v = m->values[which] + (size_t)kinds[which].values * pixel;
    float *to = m->pixels + 4 * pixel;

    if (which == ARGS_AOV_OBJECT)
        put_object(m->args->aov[which], to, object_at(m, pixel));
    else if (which == ARGS_AOV_CERTAINTY)
        put_certainty(m, pixel, to);
    else if (which == ARGS_AOV_NORMAL)
        put_normal(v, to);
    else if (kinds[which].values == 4)
        put(to, (double)v[0], (double)v[1], (double)v[2]);
    else
        put(to, scale * (double)v[0], scale * (double)v[0], scale * (double)v[0]);
}

/* ---- layers of the picture's file: the values themselves ---- */

bool aov_is_layer(const args *a, int which)
{
    const char *dot = a->output ? strrchr(a->output, '.') : NULL;

    return a->aov[which] && dot && !a->in_whole && strcmp(a->aov[which], a->output) == 0 && strcasecmp(dot, ".exr") == 0;
}

static bool any_layer(const args *a)
{
    for (int i = 0; i < ARGS_AOVS; i++)
        if (aov_is_layer(a, i))
            return true;
    return false;
}

/* Seconds to microseconds, and numbers of objects to one more than them: 0 is none. */
static void scale_layer(const maps *m, int which)
{
    const size_t count = (size_t)m->rect.width * (size_t)m->rect.height;
    float *v = m->values[which];

    for (size_t i = 0; i < count && which == ARGS_AOV_TIME; i++)
        v[i] *= 1e6f;
    for (size_t i = 0; i < count && which == ARGS_AOV_OBJECT; i++) {
        const uint32_t number = object_at(m, i);

        v[i] = number == UINT32_MAX ? 0.0f : (float)number + 1.0f;
    }
}

static int list_layers(const maps *m, pov_layer *out)
{
    int n = 0;

    for (int i = 0; i < ARGS_AOVS; i++) {
        if (!aov_is_layer(m->args, i))
            continue;
        scale_layer(m, i);
        for (int c = 0; c < 3 && kinds[i].layers[c]; c++)
            out[n++] = (pov_layer){ kinds[i].layers[c], m->values[i] + c, kinds[i].values };
    }
    return n;
}

static pov_status write_layers(pov_context *context, const maps *m, pov_error *err)
{
    const size_t stride = 4 * sizeof(float) * (size_t)m->rect.width;
    pov_layer layers[3 * ARGS_AOVS];
    pov_image_options o = options();

    o.layer_count = list_layers(m, layers);
    o.layers = layers;
    pov_job_read(m->job, m->rect, POV_PIXELS_LINEAR_FLOAT, m->pixels, stride);
    return pov_image_write(context, m->args->output, m->rect.width, m->rect.height, m->pixels, stride, &o, err);
}

/* ---- writing ---- */

static pov_status write_map(pov_context *context, const maps *m, int which, pov_error *err)
{
    const size_t count = (size_t)m->rect.width * (size_t)m->rect.height;
    const double scale = scale_of(m, which);
    const pov_image_options o = options();

    for (size_t i = 0; i < count; i++)
        colour_pixel(m, which, i, scale);
    return pov_image_write(context, m->args->aov[which], m->rect.width, m->rect.height, m->pixels,
                           4 * sizeof(float) * (size_t)m->rect.width, &o, err);
}

static pov_status fail_memory(pov_error *err)
{
    memset(err, 0, sizeof *err);
    err->status = POV_E_MEMORY;
    snprintf(err->message, sizeof err->message, "out of memory for a map of this size");
    return POV_E_MEMORY;
}

static pov_status prepare(maps *m, pov_error *err)
{
    const size_t count = (size_t)m->rect.width * (size_t)m->rect.height;
    bool done = true, any = false;

    for (int i = 0; i < ARGS_AOVS; i++) {
        if (!is_wanted(m->args, i))
            continue;
        any = true;
        m->values[i] = calloc(count, (size_t)kinds[i].values * sizeof(float));
        done = done && m->values[i];
    }
    if (any)
        m->pixels = malloc(4 * count * sizeof(float));
    return done && (m->pixels || !any) ? POV_OK : fail_memory(err);
}

/* Of a tracer that had no memory, values are no numbers, and objects are none. */
static bool is_known(const maps *m)
{
    for (int i = 0; i < ARGS_AOVS; i++)
        if (m->values[i] && i != ARGS_AOV_OBJECT && isnan(m->values[i][0]))
            return false;
    return true;
}

pov_status aov_write(pov_context *context, pov_job *job, const args *a, pov_error *err)
{
    maps m = { .args = a, .job = job, .threads = threads_of(a) };
    pov_status status;

    m.rect.width = a->crop.width ? a->crop.width : a->width;
    m.rect.height = a->crop.width ? a->crop.height : a->height;
    status = prepare(&m, err);
    if (status == POV_OK && m.pixels) {
        read_all(&m);
        status = is_known(&m) ? POV_OK : fail_memory(err);
    }
    for (int i = 0; i < ARGS_AOVS && status == POV_OK; i++)
        if (a->aov[i] && !aov_is_layer(a, i))
            status = write_map(context, &m, i, err);
    if (status == POV_OK && any_layer(a))
        status = write_layers(context, &m, err);
    for (int i = 0; i < ARGS_AOVS; i++)
        free(m.values[i]);
    free(m.pixels);
    return status;
}
