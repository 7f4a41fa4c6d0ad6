#include "render/worker.h"

#include "render/raygen.h"

#include <string.h>

bool worker_make(worker *w, pov_job *job, const env *e, int tile_edge)
{
    memset(w, 0, sizeof *w);
    w->job = job;
    w->pixels = env_resize(e, NULL, (size_t)tile_edge * (size_t)tile_edge, 4 * sizeof *w->pixels);
    return w->pixels != NULL;
}

void worker_free(worker *w, const env *e)
{
    tracer_destroy(w->tracer);
    env_free(e, w->pixels);
}

pov_status worker_prepare(worker *w, const model *m, const world *of, bool (*ask)(void *worker), pov_error *err)
{
    pov_counts none = { 0 };
    pov_status status;

    if (w->tracer && w->tracer->failed) {
        tracer_destroy(w->tracer);
        w->tracer = NULL;
    }
    if (!w->tracer) {
        status = tracer_create(&w->tracer, m, of, err);
        if (status < 0)
            return status;
        w->counted = none;
    }
    tracer_set_interrupt(w->tracer, ask, w);
    return POV_OK;
}

/* The mean of what is seen through each of the pixel's places. A single place is taken as it is. */
static void trace_pixel(worker *w, const settings *s, const sample *samples, int x, int y, float *out)
{
    double sum[3] = { 0.0, 0.0, 0.0 };

    for (int i = 0; i < s->samples && !w->tracer->interrupt.given_up; i++) {
        pov_ray ray = raygen_ray(&w->claim.camera, s->width, s->height, x, y, samples[i].x, samples[i].y);
        colour c = tracer_color(w->tracer, &ray);

        sum[0] += c.r;
        sum[1] += c.g;
        sum[2] += c.b;
    }
    for (int c = 0; c < 3; c++)
        out[c] = (float)(sum[c] / s->samples);
    out[3] = 1.0f;
}

bool worker_trace(worker *w, const settings *s, const sample *samples)
{
    const claim *c = &w->claim;
    int left = s->crop.x + c->rect.x, top = s->crop.y + c->rect.y, step = c->lattice.step;

    for (int y = 0; y < c->rect.height; y += step)
        for (int x = 0; x < c->rect.width; x += step) {
            if (!lattice_has(c->lattice, x, y))
                continue;
            trace_pixel(w, s, samples, left + x, top + y, w->pixels + 4 * (y * c->rect.width + x));
            if (w->tracer->failed || w->tracer->interrupt.given_up)
                return false;
        }
    return true;
}

/* Counts are added member by member, so that one added to the struct is a line here too. */
static void add(pov_counts *sum, const pov_counts *more, uint64_t sign)
{
    sum->camera += sign * more->camera;
    sum->shadow += sign * more->shadow;
    sum->reflected += sign * more->reflected;
    sum->transmitted += sign * more->transmitted;
    sum->shadow_behind += sign * more->shadow_behind;
    sum->shadow_idle += sign * more->shadow_idle;
    sum->cut_depth += sign * more->cut_depth;
    sum->cut_weight += sign * more->cut_weight;
    sum->inner_reflections += sign * more->inner_reflections;
    sum->decided += sign * more->decided;
}

void counts_add(pov_counts *sum, const pov_counts *more)
{
    add(sum, more, 1);
}

pov_counts worker_count(worker *w)
{
    pov_counts all = tracer_counts(w->tracer), fresh = all;

    add(&fresh, &w->counted, (uint64_t)-1);
    w->counted = all;
    return fresh;
}
