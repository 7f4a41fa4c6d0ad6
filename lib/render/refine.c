#include "render/refine.h"

#include "render/meter.h"
#include "render/raygen.h"
#include "render/sample.h"

refinement *refinement_make(const env *e, int tile_edge)
{
    refinement *r = env_alloc(e, 1, sizeof *r);

    if (!r)
        return NULL;
    r->halves = env_resize(e, NULL, (size_t)tile_edge * (size_t)tile_edge, 6 * sizeof *r->halves);
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

/* Pixels of one group of a cell of the claimed tile. */
typedef struct patch {
    int count;
    struct { int x, y; double *halves; } at[CELL_EDGE * CELL_EDGE];   /* places in the whole picture */
} patch;

static void find_patch(const worker *w, const settings *s, cell_range range, int number, patch *p)
{
    pov_rect tile = w->claim.rect;
    int left = number / GROUPS % range.columns * CELL_EDGE, top = number / GROUPS / range.columns * CELL_EDGE;

    p->count = 0;
    for (int y = top; y < top + CELL_EDGE && y < tile.height; y++)
        for (int x = left; x < left + CELL_EDGE && x < tile.width; x++) {
            if (group_of(range.columns, x, y) != (size_t)number)
                continue;
            p->at[p->count].x = s->crop.x + tile.x + x;
            p->at[p->count].y = s->crop.y + tile.y + y;
            p->at[p->count++].halves = w->refinement->halves + 6 * (y * tile.width + x);
        }
}

/* The next samples of each pixel of a group, one or two: neighbours in company. */
static void trace_patch(worker *w, const settings *s, const patch *p, uint32_t number, int more)
{
    pov_ray rays[CELL_EDGE * CELL_EDGE];
    colour seen[CELL_EDGE * CELL_EDGE];
    int count = more * p->count;

    for (int i = 0; i < count; i++) {
        int x = p->at[i % p->count].x, y = p->at[i % p->count].y;
        uint32_t k = number + (uint32_t)(i / p->count);
        sample at = sample_at(s->seed, x, y, (int)(k & 1u), k / 2);

        rays[i] = raygen_ray(&w->claim.camera, s->width, s->height, x, y, at.x, at.y);
    }
    if (count > 0)
        tracer_colors(w->tracer, rays, (size_t)count, seen);
    for (int i = 0; i < count; i++) {
        uint32_t k = number + (uint32_t)(i / p->count);
        double *sum = p->at[i % p->count].halves + 3 * (k & 1u);

        /* Sums in double of floats are exact as long as their exponents are near: a constant stays itself. */
        sum[0] += seen[i].r;
        sum[1] += seen[i].g;
        sum[2] += seen[i].b;
    }
}

/* False: it was given up. */
static bool refine_group(worker *w, const settings *s, cell_range range, int number)
{
    group *g = &w->refinement->groups[number];
    patch p;

    if (g->count >= g->target)
        return true;
    find_patch(w, s, range, number, &p);
    while (g->count < g->target) {
        int more = g->target - g->count > 1 ? GROUPS : 1;

        trace_patch(w, s, &p, g->count, more);
        if (worker_is_given_up(w))
            return false;
        g->count += (uint32_t)more;
    }
    return true;
}

bool refine_more(worker *w, const settings *s, const cells *c, const encoding *e)
{
    cell_range range = cells_of(w->claim.rect);
    refinement *r = w->refinement;

    meter_begin(w->meter);
    for (int i = 0; i < GROUPS * range.columns * range.rows; i++) {
        int cell = i / GROUPS;

        if (!refine_group(w, s, range, i))
            return false;
        meter_cell(w->meter, w->claim.rect, cell % range.columns * CELL_EDGE, cell / range.columns * CELL_EDGE);
    }
    cells_measure(c, w->claim.rect, e, r->groups, r->halves, w->pixels);
    return true;
}
