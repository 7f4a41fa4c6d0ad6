#include "shade/window.h"

#include "base/lane_mask.h"
#include "base/simd.h"
#include "shade/gather.h"
#include "shade/reuse.h"

#include <string.h>

enum { PIXELS = WINDOW_BLOCK * WINDOW_BLOCK, CELLS_ACROSS = WINDOW_BLOCK / WINDOW_CELL, CELLS = CELLS_ACROSS * CELLS_ACROSS, NONE = 255 };

/* The first surfaces of a block's pixels from which light is gathered. */
typedef struct block {
    reuse starts;
    flats flats, around;         /* its own, and those of all blocks beside it, joined */
    uint32_t count;              /* of starts; 0: it is not in the picture, or none of it gathers */
    uint8_t pixel[PIXELS], start_of[PIXELS];   /* by start, its place in the block; and by place, NONE: it has none */
    bool hollow[PIXELS];         /* by start: it always sends a ray */
    double chance[PIXELS];       /* of a start to send one */
    uint64_t alike[WINDOW_CELL][PIXELS];   /* by start, those that one of them asks for what they see; itself is one */
    path paths[PIXELS];
    uint64_t samples[PIXELS];    /* the random numbers of their pixels */
    uint64_t key;                /* and those of the block */
    double along[2][PIXELS];     /* by start, its place between the corners of the block, from 0 to 1 */
    colour_lanes seen;           /* what it gathers */
} block;

/* Rays of a batch: the block and the start that each is from. */
typedef struct senders { block *of[BATCH_MAX]; int column[BATCH_MAX], row[BATCH_MAX]; uint8_t start[BATCH_MAX]; } senders;

struct windows {
    int across;                  /* blocks that there is room for, with the margin */
    int columns, rows;           /* of the tile */
    block *blocks;
    batch rays;
    reuse found;
    senders from;
    sample_id samples[BATCH_MAX];
    colour seen[BATCH_MAX];
};

windows *windows_make(const env *e, int tile_edge)
{
    windows *w = env_alloc_aligned(e, sizeof *w, SIMD_LINE);

    if (!w)
        return NULL;
    w->across = (tile_edge + WINDOW_BLOCK - 1) / WINDOW_BLOCK + 2;
    w->blocks = env_alloc_aligned(e, (size_t)w->across * (size_t)w->across * sizeof *w->blocks, SIMD_LINE);
    if (!w->blocks) {
        windows_free(w, e);
        return NULL;
    }
    for (uint32_t i = 0; i < BATCH_MAX; i++)
        w->rays.rays[i] = &w->rays.own[i];
    return w;
}

void windows_free(windows *w, const env *e)
{
    if (!w)
        return;
    env_free_aligned(e, w->blocks);
    env_free_aligned(e, w);
}

bool windows_are_possible(const shade_context *c) { return reuse_is_possible(c) && !c->scene->photons && gather_is_even(c->scene); }

static block *block_at(const windows *w, int column, int row) { return &w->blocks[(row + 1) * w->across + column + 1]; }

static bool has_block(const windows *w, int column, int row) { return column >= -1 && row >= -1 && column <= w->columns && row <= w->rows; }

void windows_begin(windows *w, int columns, int rows)
{
    w->columns = columns;
    w->rows = rows;
    for (int i = -1; i <= rows; i++)
        for (int k = -1; k <= columns; k++)
            block_at(w, k, i)->count = 0;
}

/* ---- starts ---- */

/* Find the places that the first surfaces of camera rays gather light from. */
static void find_origins(pov_tracer *t, const pov_ray *rays, uint32_t n)
{
    const colour white = { 1.0f, 1.0f, 1.0f };
    shade_context *c = &t->context;
    const pov_counts counts = c->counts;
    colour carried[BATCH_MAX], out[BATCH_MAX];
    int kind;

    for (uint32_t i = 0; i < n; i++) {
        carried[i] = white;
        out[i] = colour_of(0.0f, 0.0f, 0.0f);
    }
    c->lent = NULL;
    tracer_begin(t, rays, n, carried);
    surfaces_find(c, &t->surfaces, &t->camera, out);
    batch_begin(&t->queue, out);
    if (t->surfaces.count > 0) {
        kind = surfaces_complete(c, &t->surfaces, &t->painted);
        if (kind == PAINT_SINGLE)
            gather_begin(c, &t->surfaces, &t->queue);
        else
            for (layers_begin(t->layers); !c->failed && layers_take(c, t->layers, &t->surfaces, &t->painted);)
                gather_begin_layers(c, t->layers, &t->queue);
    }
    c->failed = c->failed || query_context_failed(c->context);
    c->counts = counts;          /* they are counted when the picture is traced */
}

/* Whose rays could be those of others too. Surfaces of several normals gather light by themselves. */
static uint64_t find_alone(const batch_queue *q)
{
    uint64_t once = 0, more = 0;

    for (size_t k = 0; k < q->gathered.count; k++) {
        const batch *b = q->gathered.items[k];

        for (uint32_t i = 0; i < b->count; i++) {
            const uint64_t bit = (uint64_t)1 << b->paths[i].lane;

            if (b->gather->behind[i])
                continue;
            more |= once & bit;
            once |= bit;
            if (b->paths[i].coincident || b->paths[i].inside.count > 0)
                more |= bit;
        }
    }
    return once & ~more;
}

static void add_start(block *at, const shade_context *c, const batch *from, uint32_t i, uint8_t pixel)
{
    const world_lamps *lamps = world_get_lamps(c->scene->world);
    const uint32_t n = at->count++;
    guide_views above;

    guide_find(lamps, from->own[i].org, lanes_at(&from->gather->normal, i), &above);
    reuse_put(&at->starts, n, from, i, &above, lamps->count);
    at->paths[n] = from->paths[i];
    at->samples[n] = c->samples[from->paths[i].lane].pixel;
    at->pixel[n] = pixel;
    at->start_of[pixel] = (uint8_t)n;
    at->along[0][n] = (pixel % WINDOW_BLOCK + 0.5) / WINDOW_BLOCK;
    at->along[1][n] = (pixel / WINDOW_BLOCK + 0.5) / WINDOW_BLOCK;
    colour_lane_put(&at->seen, n, colour_of(0.0f, 0.0f, 0.0f));
}

static uint32_t cell_of(const block *b, uint32_t start)
{
    const int x = b->pixel[start] % WINDOW_BLOCK, y = b->pixel[start] / WINDOW_BLOCK;

    return (uint32_t)(y / WINDOW_CELL * CELLS_ACROSS + x / WINDOW_CELL);
}

/* Do two starts look at each other well? */
static bool are_facing(const reuse *r, uint32_t i, uint32_t k)
{
    const double least = 0.05;
    const pov_vec3 d = pov_sub(lanes_at(&r->start, k), lanes_at(&r->start, i));
    const double there = pov_dot(d, lanes_at(&r->face, i)), back = -pov_dot(d, lanes_at(&r->face, k));

    return there > 0.0 && back > 0.0 && there * back > least * pov_dot(d, d);
}

/* Does a start lie on a surface that another one goes on with? least: the cosine between both; most: the sine of the way. */
static bool are_alike(const reuse *r, uint32_t i, uint32_t k, double least, double most)
{
    const pov_vec3 d = pov_sub(lanes_at(&r->start, k), lanes_at(&r->start, i)), face = lanes_at(&r->face, i);

    return pov_dot(face, lanes_at(&r->face, k)) > least && fabs(pov_dot(d, face)) <= most * sqrt(pov_dot(d, d));
}

/* Is there a corner beside a start? What it has of the surface there comes from so near that few rays of others find it. Or is it
 * by itself in its cell, so that the rays of others may find little of what it faces? */
static bool is_hollow(const block *b, uint32_t start)
{
    const int beside = 2, x = b->pixel[start] % WINDOW_BLOCK, y = b->pixel[start] / WINDOW_BLOCK;
    bool alone = true;

    for (int v = y - beside; v <= y + beside; v++)
        for (int u = x - beside; u <= x + beside; u++) {
            const bool is_in = u >= 0 && v >= 0 && u < WINDOW_BLOCK && v < WINDOW_BLOCK;
            const uint8_t other = is_in ? b->start_of[v * WINDOW_BLOCK + u] : NONE;

            if (other == NONE || other == start)
                continue;
            if (are_facing(&b->starts, start, other))
                return true;
            if (cell_of(b, start) == cell_of(b, other) && are_alike(&b->starts, start, other, 0.7, 0.5))
                alone = false;
        }
    return alone;
}

/* Those in corners send a ray each; of the others one of each cell does. */
static void find_chances(block *b)
{
    uint32_t count[CELLS] = { 0 };

    for (uint32_t i = 0; i < b->count; i++) {
        b->hollow[i] = is_hollow(b, i);
        count[cell_of(b, i)] += !b->hollow[i];
    }
    for (uint32_t i = 0; i < b->count; i++)
        b->chance[i] = b->hollow[i] ? 1.0 : 1.0 / count[cell_of(b, i)];
}

static uint8_t start_at(const block *b, int x, int y)
{
    return x < 0 || y < 0 || x >= WINDOW_BLOCK || y >= WINDOW_BLOCK ? NONE : b->start_of[y * WINDOW_BLOCK + x];
}

/* Does something beside a start stand out of its surface? It may be near and hide much from one pixel and little from the next. */
static bool is_beside_more(const block *b, uint32_t start)
{
    const double most = 0.25;
    const int x = b->pixel[start] % WINDOW_BLOCK, y = b->pixel[start] / WINDOW_BLOCK;
    const pov_vec3 from = lanes_at(&b->starts.start, start), face = lanes_at(&b->starts.face, start);

    for (int v = y > 0 ? y - 1 : 0; v <= y + 1 && v < WINDOW_BLOCK; v++)
        for (int u = x > 0 ? x - 1 : 0; u <= x + 1 && u < WINDOW_BLOCK; u++) {
            const uint8_t other = start_at(b, u, v);
            const pov_vec3 d = other == NONE ? face : pov_sub(lanes_at(&b->starts.start, other), from);

            if (pov_dot(d, face) > most * sqrt(pov_dot(d, d)))
                return true;
        }
    return false;
}

/* Within surfaces the starts of a square of the size of a cell ask together who sees a place. The squares are cells or lie across the
 * corners of cells, by chance: so each start has as much of the squares' others on one side as on the other. */
static uint64_t find_alike(const block *b, uint32_t start, int shift, uint64_t left)
{
    const double least = 0.95, most = 0.25;
    const int x = (b->pixel[start] % WINDOW_BLOCK + shift) / WINDOW_CELL * WINDOW_CELL - shift;
    const int y = (b->pixel[start] / WINDOW_BLOCK + shift) / WINDOW_CELL * WINDOW_CELL - shift;
    uint64_t out = (uint64_t)1 << start;

    for (int i = 0; left >> start & 1 && i < WINDOW_CELL * WINDOW_CELL; i++) {
        const uint8_t other = start_at(b, x + i % WINDOW_CELL, y + i / WINDOW_CELL);

        if (other != NONE && other != start && left >> other & 1 && are_alike(&b->starts, start, other, least, most) &&
            are_alike(&b->starts, other, start, least, most))
            out |= (uint64_t)1 << other;
    }
    return out;
}

static void find_groups(block *b)
{
    uint64_t within = 0, left, lanes;

    for (uint32_t i = 0; i < b->count; i++)
        within |= (uint64_t)(!b->hollow[i] && !is_beside_more(b, i)) << i;
    for (int shift = 0; shift < WINDOW_CELL; shift++) {
        left = within;
        for (uint64_t open = lane_mask_all(b->count); open; open &= ~lanes) {
            lanes = find_alike(b, first_of64(open), shift, left);
            for (uint64_t rest = lanes; rest; rest &= rest - 1)
                b->alike[shift][first_of64(rest)] = lanes;
            left &= ~lanes;
        }
    }
}

void windows_add(windows *w, pov_tracer *t, int column, int row, uint32_t n, const pov_ray *rays, unsigned known, const sample_id *samples,
                 const uint8_t *pixels, uint64_t key)
{
    shade_context *c = &t->context;
    block *at = block_at(w, column, row);
    uint64_t alone;

    at->key = key;
    at->starts.lamps_seen = 0;
    memset(at->start_of, NONE, sizeof at->start_of);
    if (!(known & TRACER_SOUND))
        return;
    c->samples = samples;
    c->alpha = NULL;
    find_origins(t, rays, n);
    if (c->failed || interrupt_is_due(&c->interrupt, n))
        return;
    alone = find_alone(&t->queue);
    for (size_t k = 0; k < t->queue.gathered.count; k++) {
        const batch *b = t->queue.gathered.items[k];

        for (uint32_t i = 0; i < b->count; i++)
            if (!b->gather->behind[i] && (alone >> b->paths[i].lane & 1))
                add_start(at, c, b, i, pixels[b->paths[i].lane]);
    }
    find_chances(at);
    find_groups(at);
    reuse_find_flats(&at->starts, 0, at->count, &at->flats);
}

/* ---- rays ---- */

/* The direction of a start's ray. False: it is not needed. */
static bool aim(const shade_context *c, const sample_id *id, block *b, uint32_t start, pov_ray *ray, bool *below)
{
    const pov_vec3 normal = lanes_at(&b->starts.normal, start);
    guide_views all;
    float by;
    double along;

    *ray = b->starts.rays[start];
    guide_find(world_get_lamps(c->scene->world), ray->org, normal, &all);
    if (!guide_draw(&all, ray->org, normal, random_point_of_set(id, 0, 1, b->paths[start].branch), GUIDE_EITHER, &ray->dir, &by))
        return false;
    along = pov_dot(ray->dir, lanes_at(&b->starts.face, start));
    world_origin_leave(ray, b->starts.outside[start], along, 1.0);
    *below = !(along > 0.0);
    return true;
}

/* Add the ray of a start to the batch, one of the block's. */
static void add_ray(windows *w, const shade_context *c, int column, int row, uint32_t start, uint32_t place, float weight)
{
    block *b = block_at(w, column, row);
    const uint32_t n = w->rays.count;
    path *p = &w->rays.paths[n];
    bool below;

    w->samples[n] = (sample_id){ b->samples[start], 0, place, b->key };
    if (!aim(c, &w->samples[n], b, start, &w->rays.own[n], &below) || below)
        return;
    *p = b->paths[start];
    p->factor = (coefficient){ { 1.0f, 1.0f, 1.0f }, weight };
    p->lane = n;
    p->draw = 0;
    p->draws = 1;
    w->from.of[n] = b;
    w->from.column[n] = column;
    w->from.row[n] = row;
    w->from.start[n] = (uint8_t)start;
    w->found.below[n] = false;
    w->found.found[n] = REUSE_SKY;   /* until a surface is found */
    lanes_put(&w->found.end, n, w->rays.own[n].dir);
    w->seen[n] = colour_of(0.0f, 0.0f, 0.0f);
    w->rays.count++;
}

/* ---- what they find ---- */

/* What a ray has found, as the up to nine blocks around its own have it. */
typedef struct finding { weights of[3][3]; bool is_asked[3][3]; } finding;

/* Is the window at the corner of these blocks one of the tile's? */
static bool has_window(const windows *w, int column, int row) { return column >= 0 && row >= 0 && column <= w->columns && row <= w->rows; }

/* Has a block beside a ray's starts, and a window of the tile that both are in? */
static bool shares_window(const windows *w, int column, int row, int right, int down)
{
    const int left = right > 0 ? column + right : column, end = right < 0 ? column : column + 1;
    const int top = down > 0 ? row + down : row, bottom = down < 0 ? row : row + 1;

    if (!has_block(w, column + right, row + down) || block_at(w, column + right, row + down)->count == 0)
        return false;
    for (int r = top; r <= bottom; r++)
        for (int k = left; k <= end; k++)
            if (has_window(w, k, r))
                return true;
    return false;
}

/* Who of a block sees what the ray found? clear: parts from where it is not hidden. False: given up. */
static bool inquire(const windows *w, shade_context *c, uint32_t ray, block *b, const flats *clear, weights *at, asking *asked)
{
    const uint64_t key = random_turn(b->key, (uint32_t)w->samples[ray].pixel);
    const sharing s = { b->alike[w->samples[ray].pixel >> 32 & 1], key };
    const uint32_t own = b == w->from.of[ray] ? w->from.start[ray] : UINT32_MAX;

    reuse_find_densities(c, &b->starts, at);
    return reuse_ask(c, &b->starts, own, reuse_lanes_within(&b->flats, clear), &s, at, asked);
}

/* False: it counts for none, or given up. */
static bool weigh(windows *w, shade_context *c, uint32_t ray, finding *f)
{
    const uint32_t start = w->from.start[ray];
    block *own = w->from.of[ray], *blocks[9];
    asking asked;
    flats clear;

    for (int i = 0; i < 9; i++) {
        weights *at = &f->of[i / 3][i % 3];

        blocks[i] = NULL;
        f->is_asked[i / 3][i % 3] = shares_window(w, w->from.column[ray], w->from.row[ray], i % 3 - 1, i / 3 - 1);
        if (!f->is_asked[i / 3][i % 3])
            continue;
        blocks[i] = block_at(w, w->from.column[ray] + i % 3 - 1, w->from.row[ray] + i / 3 - 1);
        reuse_begin(&w->found, ray, at);
        at->from = 0;
        at->to = blocks[i]->count;
        reuse_find_kernels(&blocks[i]->starts, at);
    }
    if (!(f->of[1][1].kernel[start] > 0.0))
        return false;
    reuse_find_clear(c, &own->starts, start, &own->around, &f->of[1][1], &clear);
    asked.count = 0;
    for (int i = 0; i < 9; i++)
        if (blocks[i] && !inquire(w, c, ray, blocks[i], &clear, &f->of[i / 3][i % 3], &asked))
            return false;
    return reuse_send(c, &asked);
}

/* How densely rays of a block come to the place. */
SIMD_CLONES static double sum_densities(const block *b, const weights *w)
{
    enum { APART = 8 };
    double part[APART] = { 0 }, sum = 0.0;

    for (uint32_t i = 0; i < PIXELS; i += APART)
        for (uint32_t k = 0; k < APART; k++)
            part[k] += i + k < b->count ? b->chance[i + k] * w->density[i + k] : 0.0;
    for (uint32_t k = 0; k < APART; k++)
        sum += part[k];
    return sum;
}

/* Inverse densities in the windows at the corners of a block: [down][right]. */
typedef struct corners { double by[2][2]; } corners;

/* Each window counts for a pixel by the pixel's place between corners. */
SIMD_CLONES static void give(block *b, const weights *w, corners at, colour seen)
{
    for (uint32_t i = 0; i < b->count; i++) {
        const double x = b->along[0][i], y = b->along[1][i];
        const double above = at.by[0][0] + x * (at.by[0][1] - at.by[0][0]), below = at.by[1][0] + x * (at.by[1][1] - at.by[1][0]);
        const float by = (float)(w->kernel[i] * (above + y * (below - above)));

        b->seen.red[i] += by * seen.r;
        b->seen.green[i] += by * seen.g;
        b->seen.blue[i] += by * seen.b;
    }
}

/* The windows at the corners of the ray's own block. */
static corners find_windows(const windows *w, uint32_t ray, const finding *f)
{
    const int column = w->from.column[ray], row = w->from.row[ray];
    double sums[3][3], all;
    corners out;

    for (int r = 0; r < 3; r++)
        for (int k = 0; k < 3; k++)
            sums[r][k] = f->is_asked[r][k] ? sum_densities(block_at(w, column + k - 1, row + r - 1), &f->of[r][k]) : 0.0;
    for (int r = 0; r < 2; r++)
        for (int k = 0; k < 2; k++) {
            all = sums[r][k] + sums[r][k + 1] + sums[r + 1][k] + sums[r + 1][k + 1];
            out.by[r][k] = has_window(w, column + k, row + r) ? 1.0 / all : 0.0;
        }
    return out;
}

/* Of these those at the corners of a block beside it. */
static corners find_shared(const corners *own, int right, int down)
{
    corners out;

    for (int r = 0; r < 2; r++)
        for (int k = 0; k < 2; k++) {
            const bool is_own = r + down >= 0 && r + down <= 1 && k + right >= 0 && k + right <= 1;

            out.by[r][k] = is_own ? own->by[r + down][k + right] : 0.0;
        }
    return out;
}

static void spread(windows *w, shade_context *c, uint32_t ray)
{
    const colour seen = gather_sample(&c->scene->model->radiosity, w->seen[ray]);
    finding f;
    corners own;

    if (w->found.found[ray] == REUSE_NOTHING || (seen.r == 0.0f && seen.g == 0.0f && seen.b == 0.0f) || !weigh(w, c, ray, &f))
        return;
    own = find_windows(w, ray, &f);
    for (int r = 0; r < 3; r++)
        for (int k = 0; k < 3; k++)
            if (f.is_asked[r][k])
                give(block_at(w, w->from.column[ray] + k - 1, w->from.row[ray] + r - 1), &f.of[r][k], find_shared(&own, k - 1, r - 1), seen);
}

/* ---- all of the tile ---- */

static bool trace(windows *w, pov_tracer *t)
{
    shade_context *c = &t->context;

    c->counts.reflected += w->rays.count;
    c->samples = w->samples;
    batch_forget(&t->queue, c);
    w->rays.reuse = &w->found;
    tracer_follow(t, &w->rays, w->seen);
    for (uint32_t i = 0; i < w->rays.count && !c->failed && !c->interrupt.given_up; i++)
        spread(w, c, i);
    w->rays.count = 0;
    return !c->failed && !c->interrupt.given_up;
}

/* Paths end by the weight of the start that counts most. */
static float heaviest(const block *b)
{
    float most = 0.0f;

    for (uint32_t i = 0; i < b->count; i++)
        most = pov_maxf(most, b->paths[i].factor.weight);
    return most;
}

static void join_flats(windows *w, int column, int row)
{
    block *b = block_at(w, column, row);

    b->around.count = 0;
    for (int i = 0; i < 9; i++) {
        const int k = column + i % 3 - 1, r = row + i / 3 - 1;

        if (has_block(w, k, r) && block_at(w, k, r)->count > 0)
            reuse_join_flats(&block_at(w, k, r)->flats, &b->around);
    }
}

/* The rays of a block. */
static bool send(windows *w, pov_tracer *t, int column, int row)
{
    const block *b = block_at(w, column, row);
    const float weight = heaviest(b);
    uint32_t passed[CELLS] = { 0 }, more = CELLS;

    if (b->count > 0)
        join_flats(w, column, row);
    for (uint32_t i = 0; i < b->count; i++) {
        const uint32_t cell = cell_of(b, i);
        const double chosen = floor(random_fraction(random_turn(b->key, cell + 1)) / b->chance[i]);

        if (!b->hollow[i] && (double)passed[cell]++ != chosen)
            continue;
        if (w->rays.count == BATCH_MAX && !trace(w, t))
            return false;
        add_ray(w, &t->context, column, row, i, b->hollow[i] ? more++ : cell, weight);
    }
    return true;
}

bool windows_gather(windows *w, pov_tracer *t)
{
    shade_context *c = &t->context;

    c->alpha = NULL;
    c->lent = NULL;
    w->rays.count = 0;
    for (int row = -1; row <= w->rows; row++)
        for (int column = -1; column <= w->columns; column++)
            if (!send(w, t, column, row))
                return false;
    return w->rays.count == 0 || trace(w, t);
}

lent_light windows_at(const windows *w, int x, int y)
{
    const block *b = block_at(w, x / WINDOW_BLOCK, y / WINDOW_BLOCK);
    const uint32_t pixel = (uint32_t)(y % WINDOW_BLOCK * WINDOW_BLOCK + x % WINDOW_BLOCK);
    const lent_light none = { { 0.0f, 0.0f, 0.0f }, false };

    return b->count == 0 || b->start_of[pixel] == NONE ? none : (lent_light){ colour_lane(&b->seen, b->start_of[pixel]), true };
}
