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

/* Rays in company: those of the pixels of a block of the lattice, or some of one pixel's. */
typedef struct company {
    uint32_t count, pixels;
    pov_ray rays[BATCH_MAX];
    uint32_t pixel[BATCH_MAX];   /* of a ray: which of the block's */
    double sum[BATCH_MAX][3];    /* of the pixels' samples so far */
    float *out[BATCH_MAX];
} company;

static void trace_company(worker *w, company *c)
{
    colour seen[BATCH_MAX];

    tracer_colors(w->tracer, c->rays, c->count, seen);
    for (uint32_t i = 0; i < c->count; i++) {
        double *sum = c->sum[c->pixel[i]];

        sum[0] += seen[i].r;
        sum[1] += seen[i].g;
        sum[2] += seen[i].b;
    }
    c->count = 0;
}

static bool is_given_up(const worker *w)
{
    return w->tracer->failed || w->tracer->interrupt.given_up;
}

static void trace_pixel(worker *w, company *c, const settings *s, const sample *samples, int x, int y, float *out)
{
    uint32_t pixel = c->pixels++;

    memset(c->sum[pixel], 0, sizeof c->sum[pixel]);
    c->out[pixel] = out;
    for (int i = 0; i < s->samples && !is_given_up(w); i++) {
        c->pixel[c->count] = pixel;
        c->rays[c->count++] = raygen_ray(&w->claim.camera, s->width, s->height, x, y, samples[i].x, samples[i].y);
        if (c->count == BATCH_MAX)
            trace_company(w, c);
    }
}

/* The mean of what is seen through each of the pixel's places. A single place is taken as it is. */
static void end_block(worker *w, company *c, const settings *s)
{
    if (c->count > 0)
        trace_company(w, c);
    for (uint32_t i = 0; i < c->pixels; i++) {
        for (int k = 0; k < 3; k++)
            c->out[i][k] = (float)(c->sum[i][k] / s->samples);
        c->out[i][3] = 1.0f;
    }
    c->pixels = 0;
}

/* The edge of a square of pixels whose rays are not too many for one company. */
static int block_edge(int samples)
{
    int edge = 8;

    while (edge > 1 && edge * edge * samples > BATCH_MAX)
        edge /= 2;
    return edge;
}

/* A block is a square of the lattice's pixels, (x, y) its corner in the tile. */
static void trace_block(worker *w, company *together, const settings *s, const sample *samples, int left, int top, int edge)
{
    const claim *c = &w->claim;

    for (int y = top; y < c->rect.height && y < top + edge; y += c->lattice.step)
        for (int x = left; x < c->rect.width && x < left + edge; x += c->lattice.step)
            if (lattice_has(c->lattice, x, y))
                trace_pixel(w, together, s, samples, s->crop.x + c->rect.x + x, s->crop.y + c->rect.y + y,
                            w->pixels + 4 * (y * c->rect.width + x));
    end_block(w, together, s);
}

bool worker_trace(worker *w, const settings *s, const sample *samples)
{
    const claim *c = &w->claim;
    int edge = block_edge(s->samples) * c->lattice.step;
    company together;

    together.count = together.pixels = 0;
    for (int y = 0; y < c->rect.height; y += edge)
        for (int x = 0; x < c->rect.width; x += edge) {
            trace_block(w, &together, s, samples, x, y, edge);
            if (is_given_up(w))
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
