#include "render/lend.h"

#include "render/job_state.h"
#include "render/raygen.h"

/* The camera rays of a block: the first samples of its pixels. */
typedef struct packet {
    uint32_t count;
    raygen_places places;
    raygen_screen through;
    uint8_t pixels[BATCH_MAX];
    sample_id samples[BATCH_MAX];
    SIMD_ALIGNED pov_ray rays[BATCH_MAX];
} packet;

/* Its pixels that lie in the crop; (left, top) is its corner there. */
static void take_pixels(packet *p, const settings *s, int left, int top)
{
    p->count = 0;
    for (int i = 0; i < WINDOW_BLOCK * WINDOW_BLOCK; i++) {
        const int x = left + i % WINDOW_BLOCK, y = top + i / WINDOW_BLOCK;
        const uint32_t n = p->count;

        if (x < 0 || y < 0 || x >= s->crop.width || y >= s->crop.height)
            continue;
        p->places.x[n] = s->crop.x + x;
        p->places.y[n] = s->crop.y + y;
        p->places.k[n] = 0;
        p->places.dx[n] = p->places.dy[n] = 0.5;
        p->pixels[n] = (uint8_t)i;
        p->samples[n] = sample_id_of(s->seed, p->places.x[n], p->places.y[n], 0);
        p->count++;
    }
}

static void add_block(worker *w, const settings *s, packet *p, int column, int row)
{
    const int left = w->claim.rect.x + column * WINDOW_BLOCK, top = w->claim.rect.y + row * WINDOW_BLOCK;
    const pov_camera *camera = &w->claim.camera;
    unsigned known;

    take_pixels(p, s, left, top);
    if (p->count == 0)
        return;
    if (s->sampling)
        raygen_sample(s->seed, p->count, &p->places);
    raygen_place(&p->places, s->width, s->height, p->count, &p->through);
    if (raygen_counts(camera))
        raygen_spread(camera, s->seed, !s->sampling, &p->places, p->count, &p->through);
    known = raygen_cast(w->job->scene->model, camera, &p->through, p->count, p->rays);
    windows_add(w->windows, w->tracer, column, row, p->count, p->rays, known, p->samples, p->pixels,
                random_set(s->seed, 41, s->crop.x + left, s->crop.y + top));
}

bool lend_find(worker *w, const settings *s)
{
    const int columns = (w->claim.rect.width - 1) / WINDOW_BLOCK + 1, rows = (w->claim.rect.height - 1) / WINDOW_BLOCK + 1;
    packet p;

    w->lends = w->job->scene->plan->radiosity && windows_are_possible(&w->tracer->context);
    if (!w->lends)
        return true;
    if (!w->windows)
        w->windows = windows_make(w->job->env, w->job->tiles.edge);
    if (!w->windows) {
        w->tracer->context.failed = true;
        return false;
    }
    p.through.width = s->width;
    p.through.height = s->height;
    raygen_begin(&w->claim.camera, p.rays, BATCH_MAX);
    windows_begin(w->windows, columns, rows);
    for (int row = -1; row <= rows; row++)
        for (int column = -1; column <= columns; column++) {
            add_block(w, s, &p, column, row);
            if (worker_is_given_up(w))
                return false;
        }
    return windows_gather(w->windows, w->tracer);
}
