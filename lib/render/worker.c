#include "render/worker.h"

#include "render/job_state.h"
#include "render/lend.h"
#include "render/meter.h"
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
    windows_free(w->windows, e);
    env_free(e, w->pixels);
}

pov_status worker_prepare(worker *w, const shading *scene, bool (*ask)(void *worker), pov_error *err)
{
    pov_counts none = { 0 };
    pov_status status;

    if (w->tracer && w->tracer->context.failed) {
        tracer_destroy(w->tracer);
        w->tracer = NULL;
    }
    if (!w->tracer) {
        status = tracer_create(&w->tracer, scene, err);
        if (status < 0)
            return status;
        w->counted = none;
    }
    tracer_set_interrupt(w->tracer, ask, w);
    return POV_OK;
}

/* A packet of rays, for the pixels of a block of the lattice. */
typedef struct packet {
    uint32_t count;
    uint64_t set;                /* see random.h */
    raygen_screen through;
    float *out[BATCH_MAX];
    sample_id samples[BATCH_MAX];   /* if plan->random */
    lent_light lent[BATCH_MAX];  /* if the worker lends */
    SIMD_ALIGNED pov_ray rays[BATCH_MAX];
} packet;

/* Screen coordinates of the centres of the tile's columns and rows of pixels. */
typedef struct middles { double u[TILE_EDGE_MAX], v[TILE_EDGE_MAX]; } middles;

/* Coordinates are those of the whole picture: a crop has the samples of the whole. */
static void find_middles(middles *m, const settings *s, pov_rect tile)
{
    for (int x = 0; x < tile.width; x++)
        m->u[x] = raygen_u(s->crop.x + tile.x + x, 0.5, s->width);
    for (int y = 0; y < tile.height; y++)
        m->v[y] = raygen_v(s->crop.y + tile.y + y, 0.5, s->height);
}

/* Samples are the first ones of their pixels. */
static void find_pixels(const worker *w, const settings *s, const packet *c, raygen_places *p)
{
    const pov_rect tile = w->claim.rect;

    for (uint32_t i = 0; i < c->count; i++) {
        const int at = (int)(c->out[i] - w->pixels) / 4;

        p->x[i] = s->crop.x + tile.x + at % tile.width;
        p->y[i] = s->crop.y + tile.y + at / tile.width;
        p->k[i] = 0;
    }
}

/* The numbers of samples, and their places on the lens. */
static void number_samples(const worker *w, const settings *s, packet *c)
{
    const bool random = w->job->scene->plan->random, lens = raygen_counts(&w->claim.camera);
    raygen_places p;

    if (random || lens)
        find_pixels(w, s, c, &p);
    for (uint32_t i = 0; random && i < c->count; i++) {
        c->samples[i] = sample_id_of(s->seed, p.x[i], p.y[i], 0);
        c->samples[i].set = c->set;
        c->samples[i].place = i;
    }
    if (lens)
        raygen_spread(&w->claim.camera, s->seed, !s->sampling, &p, c->count, &c->through);
}

static void trace_packet(worker *w, const settings *s, packet *c)
{
    const uint32_t n = c->count;
    colour seen[BATCH_MAX + 1];      /* four numbers are copied where the last one's three are */
    float alpha[BATCH_MAX];
    unsigned known;

    number_samples(w, s, c);
    for (uint32_t i = 0; w->lends && i < c->count; i++) {
        const int at = (int)(c->out[i] - w->pixels) / 4;

        c->lent[i] = windows_at(w->windows, at % w->claim.rect.width, at / w->claim.rect.width);
    }
    w->tracer->context.lent = w->lends ? c->lent : NULL;
    known = raygen_cast(w->job->scene->model, &w->claim.camera, &c->through, c->count, c->rays);
    tracer_colors(w->tracer, c->rays, c->count, known, c->samples, seen, s->alpha ? alpha : NULL);
    w->tracer->context.lent = NULL;
    for (uint32_t i = 0; i < n; i++) {
        memcpy(c->out[i], (const char *)seen + i * sizeof *seen, 4 * sizeof *c->out[i]);
        c->out[i][3] = 1.0f;
    }
    for (uint32_t i = 0; s->alpha && i < c->count; i++)
        c->out[i][3] = alpha[i];
}

/* Positions of the rays within their pixels, if those are not the centres. */
static void take_samples(worker *w, packet *c, const settings *s)
{
    raygen_places p;

    find_pixels(w, s, c, &p);
    raygen_sample(s->seed, c->count, &p);
    raygen_place(&p, s->width, s->height, c->count, &c->through);
}

enum { BLOCK_EDGE = 8 };     /* squared, no more than BATCH_MAX */

/* All pixels of a row of a block. */
static inline void take_whole_row(packet *c, const double *u, double v, float *row)
{
    const uint32_t n = c->count;

    for (int i = 0; i < BLOCK_EDGE; i++)
        c->through.u[n + i] = u[i];
    for (int i = 0; i < BLOCK_EDGE; i++)
        c->through.v[n + i] = v;
    for (int i = 0; i < BLOCK_EDGE; i++)
        c->out[n + i] = row + 4 * i;
    c->count = n + BLOCK_EDGE;
}

/* The lattice's pixels of one row of the tile, from `left` on. */
static void take_row(packet *c, const middles *m, lattice l, int apart, int left, int right, int y, float *row)
{
    /* Pixels that a coarser pass has traced are left out: every other pixel of its rows, and no pixel of the rows
     * between. */
    const bool between = l.finer && !l.again && (y & l.step) == 0;
    const int step = between ? 2 * l.step : apart * l.step;
    const double v = m->v[y];
    uint32_t n = c->count;

    if (step == 1 && right - left == BLOCK_EDGE) {
        take_whole_row(c, m->u + left, v, row + 4 * left);
        return;
    }
    for (int x = between ? left + l.step : left; x < right; x += step, n++) {
        c->through.u[n] = m->u[x];
        c->through.v[n] = v;
        c->out[n] = row + 4 * x;
    }
    c->count = n;
}

/* A block is a square of the lattice's pixels, (left, top) its corner in the tile; or one of two colours of a chess board of twice
 * the width. */
static void trace_block(worker *w, packet *together, const settings *s, const middles *m, int left, int top, int edge, int colours, int which)
{
    const pov_rect tile = w->claim.rect;
    const int right = left + colours * edge < tile.width ? left + colours * edge : tile.width;
    const lattice l = w->claim.lattice;

    const int height = tile.height - top < edge ? tile.height - top : edge;
    const pov_rect part = { tile.x + left, tile.y + top, right - left, height };

    framebuffer_prefetch(&w->job->framebuffer, part);
    together->count = 0;
    together->through.width = s->width;
    together->through.height = s->height;
    together->set = w->job->scene->plan->radiosity ? random_set(s->seed, (uint32_t)l.step, s->crop.x + part.x + which, s->crop.y + part.y) : 0;
    for (int y = top; y < top + height; y += l.step)
        take_row(together, m, l, colours, left + ((y + which) & (colours - 1)), right, y, w->pixels + 4 * y * tile.width);
    if (s->sampling)
        take_samples(w, together, s);
    if (together->count > 0)
        trace_packet(w, s, together);
}

/* A picture of one sample a pixel shows the light in the middles of pixels, and not that of whole pixels. */
void worker_set_pixel(worker *w, const settings *s)
{
    const pov_camera *camera = &w->claim.camera;
    const model *m = w->job->scene->model;
    double start, slope;
    photon_screen screen;
    bool known;

    if (!w->job->scene->plan->photons)
        return;
    raygen_apart(camera, s->width, s->height, &start, &slope);
    known = s->sampling && !m->camera_normal && raygen_flat(camera, s->width, s->height, &screen);
    tracer_set_pixel(w->tracer, start, slope, known ? &screen : NULL, s->seed);
}

bool worker_trace(worker *w, const settings *s)
{
    const claim *c = &w->claim;
    /* What is alike in the pixels of a set is seen less where those of two alternate. */
    const int colours = w->job->scene->plan->radiosity && c->lattice.step == 1 ? 2 : 1;
    int edge = BLOCK_EDGE * c->lattice.step;
    packet together;
    middles m;

    worker_set_pixel(w, s);
    raygen_begin(&c->camera, together.rays, BATCH_MAX);
    find_middles(&m, s, c->rect);
    if (w->job->scene->plan->radiosity && edge > TILE_EDGE_MIN)
        edge = TILE_EDGE_MIN;
    meter_begin(w->meter);
    w->lends = false;
    if (c->lattice.step == 1 && !lend_find(w, s))
        return false;
    for (int y = 0; y < c->rect.height; y += edge)
        for (int x = 0; x < c->rect.width; x += colours * edge) {
            for (int i = 0; i < colours; i++)
                trace_block(w, &together, s, &m, x, y, edge, colours, i);
            meter_block(w->meter, c->rect, c->lattice, x, y, colours * edge, edge);
            if (worker_is_given_up(w))
                return false;
        }
    return true;
}

bool worker_is_given_up(const worker *w)
{
    return w->tracer->context.failed || w->tracer->context.interrupt.given_up;
}

/* Counts are added member by member: a member added to the struct must be added here. */
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
    sum->escalated += sign * more->escalated;
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
