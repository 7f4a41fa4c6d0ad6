#include "render/worker.h"

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

/* Rays in company: those of the pixels of a block of the lattice. */
typedef struct company {
    uint32_t count;
    raygen_places through;
    float *out[BATCH_MAX];
    SIMD_ALIGNED pov_ray rays[BATCH_MAX];
} company;

static void trace_company(worker *w, const settings *s, company *c)
{
    colour seen[BATCH_MAX];
    bool sound;

    sound = raygen_aim(&w->claim.camera, s->width, s->height, &c->through, c->count, c->rays);
    tracer_colors(w->tracer, c->rays, c->count, sound, seen);
    for (uint32_t i = 0; i < c->count; i++) {
        const colour at = seen[i];
        float *out = c->out[i];

        out[0] = at.r;
        out[1] = at.g;
        out[2] = at.b;
        out[3] = 1.0f;
    }
}

/* Where in their pixels the rays go through. A pixel's place in the whole picture counts: a crop's samples are the
 * whole's. The centres, where a pixel has one sample, are there already. */
static void take_samples(company *c, const settings *s)
{
    raygen_places *p = &c->through;

    for (uint32_t i = 0; s->sampling && i < c->count; i++) {
        const sample at = sample_at(s->seed, p->x[i], p->y[i], 0, 0);

        p->dx[i] = at.x;
        p->dy[i] = at.y;
    }
}

/* The lattice's pixels of one row of the tile, from `left` on. */
static void take_row(company *c, lattice l, pov_rect at, int left, int right, int y, float *row)
{
    /* What a coarser pass has traced is left out: in its rows every other pixel, in those between none. */
    const bool between = l.finer && (y & l.step) == 0;
    uint32_t n = c->count;

    for (int x = between ? left + l.step : left; x < right; x += between ? 2 * l.step : l.step) {
        c->through.x[n] = at.x + x;
        c->through.y[n] = at.y + y;
        c->out[n++] = row + 4 * x;
    }
    c->count = n;
}

/* A block is a square of the lattice's pixels, (left, top) its corner in the tile. */
static void trace_block(worker *w, company *together, const settings *s, int left, int top, int edge)
{
    const pov_rect tile = w->claim.rect, at = { s->crop.x + tile.x, s->crop.y + tile.y, tile.width, tile.height };
    const int right = left + edge < tile.width ? left + edge : tile.width;
    const lattice l = w->claim.lattice;

    together->count = 0;
    for (int y = top; y < tile.height && y < top + edge; y += l.step)
        take_row(together, l, at, left, right, y, w->pixels + 4 * y * tile.width);
    take_samples(together, s);
    if (together->count > 0)
        trace_company(w, s, together);
}

bool worker_trace(worker *w, const settings *s)
{
    enum { BLOCK_EDGE = 8 };     /* squared, no more than BATCH_MAX */
    const claim *c = &w->claim;
    int edge = BLOCK_EDGE * c->lattice.step;
    company together;

    raygen_begin(&c->camera, together.rays, BATCH_MAX);
    for (int i = 0; i < BATCH_MAX; i++)
        together.through.dx[i] = together.through.dy[i] = 0.5;
    meter_begin(w->meter);
    for (int y = 0; y < c->rect.height; y += edge)
        for (int x = 0; x < c->rect.width; x += edge) {
            trace_block(w, &together, s, x, y, edge);
            meter_square(w->meter, c->rect, c->lattice, x, y, edge);
            if (worker_is_given_up(w))
                return false;
        }
    return true;
}

bool worker_is_given_up(const worker *w)
{
    return w->tracer->failed || w->tracer->interrupt.given_up;
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
