#include "render/refine.h"

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

/* The pixels of a cell that lie in the claimed tile, which are all of it. */
typedef struct patch {
    int x, y;                    /* of its corner in the whole picture */
    int width, height;
    double *halves;              /* of its corner */
    int stride;                  /* from row to row, in numbers */
} patch;

/* A sample of each pixel of a cell: neighbours in company. */
static void trace_patch(worker *w, const settings *s, const patch *p, uint32_t number)
{
    pov_ray rays[CELL_EDGE * CELL_EDGE];
    colour seen[CELL_EDGE * CELL_EDGE];
    int half = (int)(number & 1u), count = p->width * p->height;

    for (int i = 0; i < count; i++) {
        int x = p->x + i % p->width, y = p->y + i / p->width;
        sample at = sample_at(s->seed, x, y, half, number / 2);

        rays[i] = raygen_ray(&w->claim.camera, s->width, s->height, x, y, at.x, at.y);
    }
    if (count > 0)
        tracer_colors(w->tracer, rays, (size_t)count, seen);
    for (int i = 0; i < count; i++) {
        double *sum = p->halves + i / p->width * p->stride + i % p->width * 6 + 3 * half;

        /* Sums in double of floats are exact as long as their exponents are near: a constant stays itself. */
        sum[0] += seen[i].r;
        sum[1] += seen[i].g;
        sum[2] += seen[i].b;
    }
}

/* The index-th cell of the claimed tile. */
static patch patch_of(const worker *w, const settings *s, cell_range range, int index)
{
    pov_rect tile = w->claim.rect;
    int left = index % range.columns * CELL_EDGE, top = index / range.columns * CELL_EDGE;
    patch p;

    p.x = s->crop.x + tile.x + left;
    p.y = s->crop.y + tile.y + top;
    p.width = tile.width - left < CELL_EDGE ? tile.width - left : CELL_EDGE;
    p.height = tile.height - top < CELL_EDGE ? tile.height - top : CELL_EDGE;
    p.stride = 6 * tile.width;
    p.halves = w->refinement->halves + 6 * (top * tile.width + left);
    return p;
}

bool refine_more(worker *w, const settings *s, const cells *c, const encoding *e)
{
    cell_range range = cells_of(w->claim.rect);
    refinement *r = w->refinement;

    for (int i = 0; i < range.columns * range.rows; i++) {
        patch p = patch_of(w, s, range, i);

        for (; r->cells[i].count < r->cells[i].target; r->cells[i].count++) {
            trace_patch(w, s, &p, r->cells[i].count);
            if (worker_is_given_up(w))
                return false;
        }
    }
    cells_measure(c, w->claim.rect, e, r->cells, r->halves, w->pixels);
    return true;
}
