#include "render/refine.h"

#include "render/job_state.h"
#include "render/meter.h"
#include "render/raygen.h"
#include "render/sample.h"

refinement *refinement_make(const env *e, int tile_edge, int sums)
{
    refinement *r = env_alloc(e, 1, sizeof *r);

    if (!r)
        return NULL;
    r->halves = env_resize(e, NULL, (size_t)tile_edge * (size_t)tile_edge, (size_t)sums * sizeof *r->halves);
    if (!r->halves) {
        env_free(e, r);
        return NULL;
    }
    return r;
}

void refinement_free(refinement *r, const env *e)
{
    if (!r)
        return;
    env_free(e, r->halves);
    env_free(e, r);
}

/* A packet of rays that is filled group by group: neighbouring groups with few samples share one. */
typedef struct packet {
    uint32_t count;
    raygen_places through;
    double *sums[BATCH_MAX];     /* the half of the pixel that the ray's colour is added to */
    double *alpha[BATCH_MAX];    /* the pixel's sum of alpha, if there is alpha */
    sample_id samples[BATCH_MAX];
    int cells[BATCH_MAX];        /* cell of the ray, within the tile */
    pov_ray rays[BATCH_MAX];
} packet;

static void trace_packet(worker *w, const settings *s, packet *c)
{
    colour seen[BATCH_MAX];
    float alpha[BATCH_MAX];
    raygen_screen through;
    unsigned known;

    if (c->count == 0)
        return;
    raygen_sample(s->seed, c->count, &c->through);
    raygen_place(&c->through, s->width, s->height, c->count, &through);
    if (raygen_counts(&w->claim.camera))
        raygen_spread(&w->claim.camera, s->seed, false, &c->through, c->count, &through);
    known = raygen_cast(w->job->scene->model, &w->claim.camera, &through, c->count, c->rays);
    tracer_colors(w->tracer, c->rays, c->count, known, c->samples, seen, s->alpha ? alpha : NULL);
    meter_cells(w->meter, c->cells, c->count);
    for (uint32_t i = 0; i < c->count; i++) {
        /* Sums of floats in double are exact as long as the exponents are near: a constant stays constant. */
        c->sums[i][0] += (double)seen[i].r;
        c->sums[i][1] += (double)seen[i].g;
        c->sums[i][2] += (double)seen[i].b;
    }
    for (uint32_t i = 0; s->alpha && i < c->count; i++)
        *c->alpha[i] += (double)alpha[i];
    c->count = 0;
}

/* The k-th sample of a pixel of a cell of the claimed tile. set: see random.h. */
static void add_sample(worker *w, const settings *s, packet *c, int cell, int x, int y, uint32_t k, uint64_t set, uint32_t place)
{
    const pov_rect tile = w->claim.rect;
    const int px = s->crop.x + tile.x + x, py = s->crop.y + tile.y + y;
    double *pixel = w->refinement->halves + w->job->cells.sums * (y * tile.width + x);
    raygen_places *p = &c->through;
    uint32_t n = c->count++;

    p->x[n] = px;
    p->y[n] = py;
    p->k[n] = k;
    if (w->job->scene->plan->random) {
        c->samples[n] = sample_id_of(s->seed, px, py, k);
        c->samples[n].set = set;
        c->samples[n].place = place;
    }
    c->alpha[n] = pixel + 6;
    c->sums[n] = pixel + 3 * (k & 1u);
    c->cells[n] = cell;
    if (c->count == BATCH_MAX)
        trace_packet(w, s, c);
}

/* Take the next samples of each pixel of a group. False: given up. */
static bool refine_singles(worker *w, const settings *s, cell_range range, int number, packet *c)
{
    singles *g = &w->refinement->singles[number];
    const int cell = number / GROUPS;
    const int left = cell % range.columns * CELL_EDGE, top = cell / range.columns * CELL_EDGE;

    for (int i = 0; i < CELL_EDGE * CELL_EDGE / GROUPS; i++) {
        const int y = top + i / (CELL_EDGE / GROUPS), x = left + i % (CELL_EDGE / GROUPS) * GROUPS + ((y + number) & 1);

        for (uint32_t k = single_count(g->has[i]); k < single_count(g->gets[i]); k++)
            add_sample(w, s, c, cell, x, y, k, 0, 0);
        g->has[i] = g->gets[i];
    }
    w->refinement->groups[number].count = w->refinement->groups[number].target;
    return !worker_is_given_up(w);
}

/* Take the next samples of all pixels of a group, whose places are every other one of each row. False: given up. */
static bool refine_group(worker *w, const settings *s, cell_range range, int number, packet *c)
{
    group *g = &w->refinement->groups[number];
    pov_rect tile = w->claim.rect;
    int cell = number / GROUPS;
    int left = cell % range.columns * CELL_EDGE, top = cell / range.columns * CELL_EDGE;

    for (; g->count < g->target; g->count++) {
        for (int y = top; y < top + CELL_EDGE && y < tile.height; y++)
            for (int x = left + ((y + number) & 1); x < left + CELL_EDGE && x < tile.width; x += GROUPS)
                add_sample(w, s, c, cell, x, y, g->count, 0, 0);
        if (worker_is_given_up(w))
            return false;
    }
    return true;
}

/* ---- sets ---- */

/* Sets lie in squares of two by two of them, which no tile divides. From the second sample on they are shifted there by chance, around
 * its edges, so that what is alike within a set is not seen as a square in the mean. */
typedef struct shift { int x, y; } shift;

static shift shift_of(const settings *s, int x, int y, uint32_t k)
{
    const uint64_t bits = random_turn(random_set(s->seed, 40, x, y), k);
    const shift none = { 0, 0 }, some = { (int)(bits >> 8 & 15), (int)(bits >> 16 & 15) };

    return k > 0 ? some : none;
}

/* The next sample of the pixels of a set whose groups need it: of one colour, in the quarter `number` of a shifted square. */
static void refine_set(worker *w, const settings *s, cell_range range, int left, int top, int number, int parity, uint32_t k, packet *c)
{
    const pov_rect tile = w->claim.rect;
    const int x0 = s->crop.x + tile.x + left, y0 = s->crop.y + tile.y + top;
    const int right = number % SET_SQUARE * SET_EDGE, down = number / SET_SQUARE * SET_EDGE;
    const uint64_t set = random_set(s->seed, (uint32_t)(32 + parity), x0 + right, y0 + down);
    const shift by = shift_of(s, x0, y0, k);
    uint32_t place = 0;

    if (c->count > BATCH_MAX - SET_PIXELS)
        trace_packet(w, s, c);
    for (int i = 0; i < SET_EDGE * SET_EDGE; i++) {
        const int x = left + ((right + i % SET_EDGE + by.x) & (SET_SQUARE * SET_EDGE - 1));
        const int y = top + ((down + i / SET_EDGE + by.y) & (SET_SQUARE * SET_EDGE - 1));
        const size_t at = group_of(range.columns, x, y);

        if (((x ^ y) & 1) == parity && x < tile.width && y < tile.height && w->refinement->groups[at].count <= k &&
            k < w->refinement->groups[at].target)
            add_sample(w, s, c, (int)(at / GROUPS), x, y, k, set, place++);
    }
}

/* Take the next samples of all pixels of the tile, those of a set together. False: given up. */
static bool refine_sets(worker *w, const settings *s, cell_range range, packet *c)
{
    enum { EDGE = SET_SQUARE * SET_EDGE };
    refinement *r = w->refinement;
    const int all = GROUPS * range.columns * range.rows;
    uint32_t first = UINT32_MAX, last = 0;

    for (int i = 0; i < all; i++) {
        first = r->groups[i].count < first ? r->groups[i].count : first;
        last = r->groups[i].target > last ? r->groups[i].target : last;
    }
    for (uint32_t k = first; k < last; k++)
        for (int top = 0; top < w->claim.rect.height; top += EDGE)
            for (int left = 0; left < w->claim.rect.width; left += EDGE)
                for (int set = 0; set < GROUPS * SET_SQUARE * SET_SQUARE; set++) {
                    refine_set(w, s, range, left, top, set / GROUPS, set % GROUPS, k, c);
                    if (worker_is_given_up(w))
                        return false;
                }
    for (int i = 0; i < all; i++)
        r->groups[i].count = r->groups[i].target;
    return true;
}

static bool refine_groups(worker *w, const settings *s, cell_range range, packet *c)
{
    for (int i = 0; i < GROUPS * range.columns * range.rows; i++)
        if (!(w->job->cells.singles ? refine_singles : refine_group)(w, s, range, i, c))
            return false;
    return true;
}

bool refine_more(worker *w, const settings *s, const cells *c, const encoding *e)
{
    cell_range range = cells_of(w->claim.rect);
    refinement *r = w->refinement;
    packet together;

    worker_set_pixel(w, s);
    meter_begin(w->meter);
    together.count = 0;
    raygen_begin(&w->claim.camera, together.rays, BATCH_MAX);
    if (!(w->job->scene->plan->radiosity ? refine_sets(w, s, range, &together) : refine_groups(w, s, range, &together)))
        return false;
    trace_packet(w, s, &together);
    if (worker_is_given_up(w))
        return false;
    cells_measure(c, w->claim.rect, e, r, w->pixels);
    return true;
}
