#include "render/cells.h"

#include "base/simd.h"
#include "render/sample.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { OPAQUE_SUMS = 6 };

bool cells_make(cells *c, const env *e, const settings *s)
{
    const int width = s->crop.width, height = s->crop.height;
    const bool referring = s->reference != NULL;

    c->width = width;
    c->height = height;
    c->columns = (width - 1) / CELL_EDGE + 1;
    c->rows = (height - 1) / CELL_EDGE + 1;
    c->count = (size_t)c->columns * (size_t)c->rows;
    c->groups = env_resize(e, NULL, c->count, GROUPS * sizeof *c->groups);
    c->sums = s->alpha ? OPAQUE_SUMS + 1 : OPAQUE_SUMS;
    if (s->sampling || referring)
        c->shown = env_alloc(e, c->count, GROUPS * sizeof *c->shown);
    if (s->sampling)
        c->halves = env_resize(e, NULL, (size_t)width * (size_t)height, (size_t)c->sums * sizeof *c->halves);
    return c->groups && (c->shown || !(s->sampling || referring)) && (c->halves || !s->sampling);
}

bool cells_count_time(cells *c, const env *e)
{
    c->seconds = env_alloc(e, c->count, sizeof *c->seconds);
    return c->seconds != NULL;
}

void cells_free(cells *c, const env *e)
{
    env_free(e, c->singles);
    env_free(e, c->planes);
    env_free(e, c->ranks);
    env_free(e, c->groups);
    env_free(e, c->shown);
    env_free(e, c->seconds);
    env_free(e, c->halves);
}

void cells_clear(cells *c)
{
    memset(c->groups, 0, c->count * GROUPS * sizeof *c->groups);
    if (c->singles)
        memset(c->singles, 0, c->count * GROUPS * sizeof *c->singles);
    if (c->shown)
        memset(c->shown, 0, c->count * GROUPS * sizeof *c->shown);
    if (c->seconds)
        memset(c->seconds, 0, c->count * sizeof *c->seconds);
}

cell_range cells_of(pov_rect tile)
{
    cell_range r = { tile.x / CELL_EDGE, tile.y / CELL_EDGE, (tile.width - 1) / CELL_EDGE + 1,
                     (tile.height - 1) / CELL_EDGE + 1 };

    return r;
}

pov_rect cells_rect(const cells *c, int column, int row)
{
    pov_rect r = { column * CELL_EDGE, row * CELL_EDGE, CELL_EDGE, CELL_EDGE };

    if (c->width - r.x < CELL_EDGE)
        r.width = c->width - r.x;
    if (c->height - r.y < CELL_EDGE)
        r.height = c->height - r.y;
    return r;
}

size_t cells_pixels_of_edge(const cells *c, size_t number)
{
    const size_t cell = number / GROUPS;
    const pov_rect r = cells_rect(c, (int)(cell % (size_t)c->columns), (int)(cell / (size_t)c->columns));

    return ((size_t)r.width * (size_t)r.height + 1 - number % GROUPS) / GROUPS;
}

size_t singles_sum(const uint8_t *numbers)
{
    size_t sum = 0;

    for (int i = 0; i < CELL_EDGE * CELL_EDGE / GROUPS; i++)
        sum += single_count(numbers[i]);
    return sum;
}

size_t cells_samples_due(const cells *c, size_t number)
{
    return c->singles ? singles_sum(c->singles[number].gets) : cells_pixels(c, number) * c->groups[number].target;
}

bool cells_are_due(const cells *c, size_t number)
{
    const singles *s = c->singles;

    return s ? memcmp(s[number].has, s[number].gets, sizeof s->has) != 0 : c->groups[number].target > c->groups[number].count;
}

uint32_t singles_fewest(const uint8_t *numbers)
{
    uint8_t fewest = UINT8_MAX;

    for (int i = 0; i < CELL_EDGE * CELL_EDGE / GROUPS; i++)
        if (numbers[i] > 0 && numbers[i] < fewest)
            fewest = numbers[i];
    return fewest < UINT8_MAX ? single_count(fewest) : 0;
}

bool cells_are_singles_possible(const cells *c, size_t number, const uint8_t *has, const uint8_t *gets, bool measured)
{
    const size_t cell = number / GROUPS;
    const pov_rect r = cells_rect(c, (int)(cell % (size_t)c->columns), (int)(cell / (size_t)c->columns));

    for (int i = 0; i < CELL_EDGE * CELL_EDGE / GROUPS; i++) {
        const int y = i / (CELL_EDGE / GROUPS), x = i % (CELL_EDGE / GROUPS) * GROUPS + (int)(((size_t)y + number) & 1);
        const bool there = x < r.width && y < r.height;

        if (has[i] > gets[i] || single_count(gets[i]) > SAMPLES_MAX || (there ? measured && has[i] == 0 : gets[i] > 0))
            return false;
    }
    return true;
}

double cells_contrast(const showing *g, size_t pixels)
{
    double n = (double)pixels, mean_square = 0.0;

    for (int i = 0; i < 3; i++)
        mean_square += g->light[i] * g->light[i] / (3.0 * n * n);
    return pov_max(g->light_square / n - mean_square, 0.0);
}

/* ---- a tile's part ---- */

/* Index of the first group of a cell. */
static size_t row_of_groups(const cells *c, cell_range r, int row)
{
    return GROUPS * ((size_t)(r.row + row) * (size_t)c->columns + (size_t)r.column);
}

static double *row_of_halves(const cells *c, pov_rect tile, int y)
{
    return c->halves + (size_t)c->sums * ((size_t)(tile.y + y) * (size_t)c->width + (size_t)tile.x);
}

static size_t size_of_row(const cells *c, pov_rect tile) { return (size_t)c->sums * sizeof *c->halves * (size_t)tile.width; }

void cells_take(const cells *c, pov_rect tile, refinement *into)
{
    cell_range r = cells_of(tile);

    for (int row = 0; row < r.rows; row++) {
        const size_t from = row_of_groups(c, r, row), to = GROUPS * (size_t)row * (size_t)r.columns;

        memcpy(into->groups + to, c->groups + from, GROUPS * (size_t)r.columns * sizeof *c->groups);
        memcpy(into->shown + to, c->shown + from, GROUPS * (size_t)r.columns * sizeof *c->shown);
        if (c->singles)
            memcpy(into->singles + to, c->singles + from, GROUPS * (size_t)r.columns * sizeof *c->singles);
    }
    for (int y = 0; y < tile.height; y++)
        memcpy(into->halves + c->sums * y * tile.width, row_of_halves(c, tile, y), size_of_row(c, tile));
}

void cells_put(cells *c, pov_rect tile, const refinement *of)
{
    cell_range r = cells_of(tile);

    for (int row = 0; row < r.rows; row++) {
        const size_t to = row_of_groups(c, r, row), from = GROUPS * (size_t)row * (size_t)r.columns;

        memcpy(c->groups + to, of->groups + from, GROUPS * (size_t)r.columns * sizeof *c->groups);
        memcpy(c->shown + to, of->shown + from, GROUPS * (size_t)r.columns * sizeof *c->shown);
        if (c->singles)
            memcpy(c->singles + to, of->singles + from, GROUPS * (size_t)r.columns * sizeof *c->singles);
    }
    for (int y = 0; y < tile.height; y++)
        memcpy(row_of_halves(c, tile, y), of->halves + c->sums * y * tile.width, size_of_row(c, tile));
}

void cells_spend(cells *c, pov_rect tile, const double *seconds)
{
    cell_range r = cells_of(tile);

    for (int i = 0; i < r.columns * r.rows; i++)
        c->seconds[(size_t)(r.row + i / r.columns) * (size_t)c->columns + (size_t)(r.column + i % r.columns)] += seconds[i];
}

/* ---- what the halves say ---- */

static float within(float v)
{
    return v < 0.0f ? 0.0f : v > 1.0f ? 1.0f : v;
}

/* Difference between a pixel in linear light and the reference. */
static void hold_against(const cells *c, showing *into, int x, int y, const float *rgba)
{
    const float *truth = c->reference + 4 * ((size_t)y * (size_t)c->width + (size_t)x);
    double square = 0.0;

    for (int i = 0; i < 3; i++) {
        double off = (double)(c->reference_clipped ? within(rgba[i]) : rgba[i]) - (double)truth[i];

        square += off * off;
        into->off_max = pov_max(into->off_max, fabs(off));
    }
    into->off_square += square / 3.0;
}

static void show(const cells *c, showing *into, int x, int y, const float *linear)
{
    for (int i = 0; i < 3; i++) {
        into->light[i] += (double)linear[i];
        into->light_square += (double)linear[i] * (double)linear[i] / 3.0;
    }
    if (c->reference)
        hold_against(c, into, x, y, linear);
}

static bool is_clipped(const float *linear)
{
    for (int i = 0; i < 3; i++)
        if (linear[i] < 0.0f || linear[i] > 1.0f)
            return true;
    return false;
}

/* Samples of a pixel's halves. per_half, per_both: the inverses of powers of two, by which products are what quotients are, bit for
 * bit; or 0. */
typedef struct share { double a, b, per_half, per_both; } share;

static share share_of(uint32_t count)
{
    const bool doubled = count > 1 && (count & (count - 1)) == 0;
    const double per_both = doubled ? 1.0 / count : 0.0;

    return (share){ sample_half(count, 0), sample_half(count, 1), 2.0 * per_both, per_both };
}

static double mean_of(double sum, double count, double per) { return per > 0.0 ? sum * per : sum / count; }

/* The variance of the mean of n samples of which one half has a and the other b is estimated without bias by
 * (difference of the halves' means)^2 * a b / n^2. */
static double square_of_error(const encoding *e, const double *halves, const share *n)
{
    const double a = n->a, b = n->b;
    float first[4] = { 0 }, second[4] = { 0 };
    double square = 0.0;

    if (b == 0.0)
        return 0.0;
    if (e->decode == 1.0) {
        for (int i = 0; i < 3; i++) {
            double d = mean_of(halves[i], a, n->per_half) - mean_of(halves[3 + i], b, n->per_half);

            square += d * d;
        }
    } else {
        for (int i = 0; i < 3; i++) {
            first[i] = (float)mean_of(halves[i], a, n->per_half);
            second[i] = (float)mean_of(halves[3 + i], b, n->per_half);
        }
        encoding_linear(e, first, 1);
        encoding_linear(e, second, 1);
        for (int i = 0; i < 3; i++) {
            double d = (double)first[i] - (double)second[i];

            square += d * d;
        }
    }
    return square / 3.0 * (a == b ? 0.25 : a * b / ((a + b) * (a + b)));
}

/* Are all values of a row within 0 .. 1? */
SIMD_CLONES static bool is_within(const float *rgba, int pixels)
{
    int outside = 0;

    for (int i = 0; i < 4 * pixels; i++)
        outside |= (rgba[i] < 0.0f) | (rgba[i] > 1.0f);
    return !outside;
}

/* A row in linear light: the row itself, or a copy in `buffer`. */
static const float *linear_row(const encoding *e, const float *row, int width, float *buffer)
{
    if (e->decode == 1.0)
        return row;
    memcpy(buffer, row, 4 * sizeof *row * (size_t)width);
    encoding_linear(e, buffer, width);
    return buffer;
}

static void put_first(double *sums, int count, const float *rgba)
{
    for (int i = 0; i < count; i++)
        sums[i] = i < 3 ? (double)rgba[i] : i < 6 ? 0.0 : (double)rgba[3];
}

/* Counts that were not added are zero since cells_clear(). */
void cells_first(cells *c, pov_rect tile, const framebuffer *f, const encoding *e)
{
    cell_range r = cells_of(tile);
    float buffer[4 * TILE_EDGE_MAX];

    for (int row = 0; row < r.rows; row++)
        for (int i = 0; i < GROUPS * r.columns; i++) {
            group *first = &c->groups[row_of_groups(c, r, row) + (size_t)i];
            first->count = first->target = 1;
        }
    for (int y = 0; c->singles && y < tile.height; y++)
        for (int x = 0; x < tile.width; x++) {
            singles *first = &c->singles[group_of(c->columns, tile.x + x, tile.y + y)];

            first->has[place_of(x, y)] = first->gets[place_of(x, y)] = 1;
        }
    for (int y = 0; y < tile.height; y++) {
        const float *row = framebuffer_pixels(f, tile.x, tile.y + y), *linear;

        for (int x = 0; c->halves && x < tile.width; x++)
            put_first(row_of_halves(c, tile, y) + c->sums * x, c->sums, row + 4 * x);
        /* Without a reference there is no more to compute. What is opaque and within 0 .. 1 is so in linear light. */
        if (!c->reference && (e->decode == 1.0 || c->sums == OPAQUE_SUMS) && is_within(row, tile.width))
            continue;
        linear = linear_row(e, row, tile.width, buffer);
        for (int x = 0; x < tile.width; x++) {
            const size_t into = group_of(c->columns, tile.x + x, tile.y + y);

            c->groups[into].clipped += is_clipped(linear + 4 * x);
            if (c->shown)
                show(c, &c->shown[into], tile.x + x, tile.y + y, linear + 4 * x);
        }
    }
}

/* The mean of a pixel, four channels, and a copy: one made of what was just written would wait for it. */
static void find_mean(const cells *c, const double *halves, const share *n, float *out, float *copy)
{
    const double both = n->a + n->b;

    for (int i = 0; i < 3; i++)
        out[i] = copy[i] = (float)mean_of(halves[i] + halves[3 + i], both, n->per_both);
    out[3] = copy[3] = c->sums > OPAQUE_SUMS ? (float)(halves[6] / both) : 1.0f;
}

/* The least square that is not zero, so that a pixel whose halves differ is known to do so. */
static float narrowed(double square) { return square > 0.0 ? pov_maxf((float)square, FLT_MIN) : 0.0f; }

/* A group whose count has grown is measured again from its halves. */
void cells_measure(const cells *c, pov_rect tile, const encoding *e, refinement *of, float *pixels)
{
    const cell_range r = cells_of(tile);
    const double *halves = of->halves;
    group *groups = of->groups;
    showing *shown = of->shown;
    singles *own = c->singles ? of->singles : NULL;

    for (int i = 0; i < GROUPS * r.columns * r.rows; i++)
        groups[i].clipped = 0;
    memset(shown, 0, GROUPS * (size_t)r.columns * (size_t)r.rows * sizeof *shown);
    for (int y = 0; y < tile.height; y++)
        for (int x = 0; x < tile.width; x++) {
            const size_t into = group_of(r.columns, x, y);
            const double *h = halves + c->sums * (y * tile.width + x);
            const share n = share_of(own ? single_count(own[into].has[place_of(x, y)]) : groups[into].count);
            const double square = square_of_error(e, h, &n);
            float *out = pixels + 4 * (y * tile.width + x), linear[4];

            find_mean(c, h, &n, out, linear);
            encoding_linear(e, linear, 1);
            shown[into].square += square;
            shown[into].fourth += c->alike ? 0.0 : square * square;
            if (own)
                own[into].square[place_of(x, y)] = narrowed(square);
            groups[into].clipped += is_clipped(linear);
            show(c, &shown[into], tile.x + x, tile.y + y, linear);
        }
    for (int i = 0; c->alike && i < GROUPS * r.columns * r.rows; i++)
        shown[i].fourth = c->alike * shown[i].square * shown[i].square;
}
