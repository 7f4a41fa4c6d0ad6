#include "render/budget_singles.h"

#include "base/simd.h"
#include "render/sample.h"

#include <math.h>

/* The squared error of a pixel is expected from pixels of the other colour of the chess board: a quarter from its four neighbours',
 * three quarters from all that are at most AROUND columns and rows away, in proportion to its share of the contrast there. A
 * pixel's contrast is the variance of its four neighbours, for errors are where pixels differ. So what one colour shows decides
 * about the other, as in groups.
 *
 * Planes hold a number for each pixel, and beyond the picture's edges those of the pixels that a mirror at the last row or column
 * would show: these have the right colour. */
enum { AROUND = BUDGET_SINGLES_LEAST_EDGE - 1, ERRORS = 0, LIGHT = 1, CONTRASTS = 4, PLANES = 5, ROWS = 4 };

/* Of worths; see below. */
enum { RANK_BITS = 6, RANKS = 256 << RANK_BITS, STEP = 5 * (1 << RANK_BITS) / 2, MOST_DOUBLINGS = 3 };

static const float near_share = 0.25f;

typedef struct planes {
    int width, height;           /* of the picture */
    size_t stride, size;         /* of a row, and of a plane */
    float *first, *rows;         /* rows: ROWS of them */
} planes;

static planes planes_of(const cells *c, float *memory)
{
    const size_t stride = (size_t)c->width + 2 * AROUND, size = stride * ((size_t)c->height + 2 * AROUND);

    return (planes){ c->width, c->height, stride, size, memory, memory ? memory + PLANES * size : NULL };
}

bool budget_singles_make(cells *c, const env *e)
{
    const planes p = planes_of(c, NULL);

    c->singles = env_alloc(e, c->count, GROUPS * sizeof *c->singles);
    c->planes = env_resize(e, NULL, PLANES * p.size + ROWS * p.stride, sizeof *c->planes);
    c->ranks = env_resize(e, NULL, RANKS, sizeof *c->ranks);
    return c->singles && c->planes && c->ranks;
}

/* A plane's pixel (0, y). */
static float *row_of(const planes *p, int plane, int y)
{
    return p->first + (size_t)plane * p->size + (size_t)(y + AROUND) * p->stride + AROUND;
}

static void mirror(const planes *p, int plane)
{
    for (int y = 0; y < p->height; y++) {
        float *row = row_of(p, plane, y);

        for (int i = 1; i <= AROUND; i++) {
            row[-i] = row[i];
            row[p->width - 1 + i] = row[p->width - 1 - i];
        }
    }
    for (int i = 1; i <= AROUND; i++) {
        memcpy(row_of(p, plane, -i) - AROUND, row_of(p, plane, i) - AROUND, p->stride * sizeof(float));
        memcpy(row_of(p, plane, p->height - 1 + i) - AROUND, row_of(p, plane, p->height - 1 - i) - AROUND, p->stride * sizeof(float));
    }
}

/* Errors as if of one sample, and light, as far as it is a number. */
static void fill_pixel(const cells *c, const planes *p, int x, int y)
{
    const singles *s = &c->singles[group_of(c->columns, x, y)];
    const double *halves = c->halves + (size_t)c->sums * ((size_t)y * (size_t)c->width + (size_t)x);
    const double count = single_count(s->has[place_of(x, y)]), per = 1.0 / count;

    row_of(p, ERRORS, y)[x] = s->square[place_of(x, y)] * (float)count;
    for (int i = 0; i < 3; i++)
        row_of(p, LIGHT + i, y)[x] = (float)((halves[i] + halves[3 + i]) * per);
}

static void fill(const cells *c, const planes *p)
{
    for (int y = 0; y < p->height; y++)
        for (int x = 0; x < p->width; x++)
            fill_pixel(c, p, x, y);
    for (int i = ERRORS; i < CONTRASTS; i++)
        mirror(p, i);
}

/* Four times the variance of the numbers left, right, above and below. */
SIMD_INLINE float spread_of(const float *row, size_t stride, int x)
{
    const float left = row[x - 1], right = row[x + 1], up = row[x - (int)stride], down = row[x + (int)stride];
    const float a = left - right, b = up - down, c = (left + right) - (up + down);

    return 0.5f * (a * a + b * b) + 0.25f * (c * c);
}

SIMD_CLONES static void find_contrasts(int width, size_t stride, const float *restrict r, const float *restrict g, const float *restrict b,
                                       float *restrict out)
{
    for (int x = 0; x < width; x++)
        out[x] = spread_of(r, stride, x) + spread_of(g, stride, x) + spread_of(b, stride, x);
}

/* Sums over the column of each pixel: of every other row from its own on, and of the rows between. */
SIMD_CLONES static void add_columns(size_t stride, const float *restrict row, float *restrict own, float *restrict between)
{
    for (size_t i = 0; i < stride; i++) {
        const float *at = row + i;

        own[i] = at[0] + (at[-2 * (ptrdiff_t)stride] + at[2 * stride]);
        between[i] = (at[-(ptrdiff_t)stride] + at[stride]) + (at[-3 * (ptrdiff_t)stride] + at[3 * stride]);
    }
}

/* Sums over AROUND columns on each side: of a's numbers in the pixel's own column and every other one, and of b's between. */
SIMD_INLINE float sum_around(const float *a, const float *b, int x)
{
    return (a[x] + (a[x - 2] + a[x + 2])) + ((b[x - 1] + b[x + 1]) + (b[x - 3] + b[x + 3]));
}

/* The errors expected of a row as if of one sample, in place of its red light. rows: of errors and of contrasts, own and between. */
SIMD_CLONES static void expect(int width, size_t stride, const float *restrict errors, const float *restrict contrasts,
                               const float *restrict rows, float *restrict out)
{
    const float all_other = 24.0f, all_own = 25.0f;   /* pixels around, of the other colour and of its own */
    const float *error_own = rows, *error_between = rows + stride, *contrast_own = rows + 2 * stride, *contrast_between = rows + 3 * stride;

    for (int x = 0; x < width; x++) {
        const float close = 0.25f * ((errors[x - 1] + errors[x + 1]) + (errors[x - (int)stride] + errors[x + (int)stride]));
        const float wide = sum_around(error_between, error_own, x) / all_other;
        const float contrast = sum_around(contrast_own, contrast_between, x) / all_own;
        const float share = contrast > 0.0f ? contrasts[x] / contrast : 1.0f;

        out[x] = near_share * close + (1.0f - near_share) * wide * share;
    }
}

static void expect_all(const planes *p)
{
    for (int y = 0; y < p->height; y++)
        find_contrasts(p->width, p->stride, row_of(p, LIGHT, y), row_of(p, LIGHT + 1, y), row_of(p, LIGHT + 2, y), row_of(p, CONTRASTS, y));
    mirror(p, CONTRASTS);
    for (int y = 0; y < p->height; y++) {
        const float *errors = row_of(p, ERRORS, y), *contrasts = row_of(p, CONTRASTS, y);

        add_columns(p->stride, errors - AROUND, p->rows, p->rows + p->stride);
        add_columns(p->stride, contrasts - AROUND, p->rows + 2 * p->stride, p->rows + 3 * p->stride);
        expect(p->width, p->stride, errors, contrasts, p->rows + AROUND, row_of(p, LIGHT, y));
    }
}

/* ---- which pixels double ----
 *
 * What doubling takes off the picture's error for each sample is in proportion to error / count, the worth. Pixels double once for
 * each STEP of ranks that their worth is above some threshold, at most MOST_DOUBLINGS times: with an error that falls by `falls_by`
 * the worth falls by half of that, by two and a half octaves. The rank of a worth is the beginning of its bits as a float. */
static const float falls_by = 0.36f;

static int rank_of(float worth)
{
    uint32_t bits;

    if (!(worth > 0.0f))
        return 0;
    memcpy(&bits, &worth, sizeof bits);
    return (int)(bits >> (23 - RANK_BITS));
}

/* The count that a pixel gets in any case, by its number as in singles. */
static int raised(int number, uint32_t least)
{
    while (1u << (number - 1) < least && 1u << (number - 1) < SAMPLES_MAX)
        number++;
    return number;
}

/* The rank of a pixel with that count. error: as if of one sample, with the count that it has. */
static int rank_pixel(int has, int gets, float error)
{
    for (int k = has; k < gets; k++)
        error *= 2.0f * falls_by;
    return rank_of(error * ldexpf(1.0f, -2 * (gets - 1)));
}

static int doublings(int rank, int threshold)
{
    const int above = rank - threshold;

    return above < 0 ? 0 : above / STEP < MOST_DOUBLINGS - 1 ? 1 + above / STEP : MOST_DOUBLINGS;
}

/* Tallies are sums over all pixels of a rank; then of it and of those above. */
static tally at_rank(const tally *ranks, int rank) { return rank < RANKS ? ranks[rank] : (tally){ 0.0, 0.0 }; }

static bool suffices(const tally *ranks, int threshold, double pixels, const goal *g)
{
    double mean = ranks[0].count, square = ranks[0].square, more = 1.0, less = 1.0 - (double)falls_by;

    for (int i = 0; i < MOST_DOUBLINGS; i++, more *= 2.0, less *= (double)falls_by) {
        const tally above = at_rank(ranks, threshold + i * STEP);

        mean += more * above.count;
        square -= less * above.square;
    }
    return mean >= g->mean * pixels || (mean >= g->fewest * pixels && square <= g->square * pixels);
}

/* The highest threshold that suffices; or 1, for all pixels that have an error. */
static int find_threshold(tally *ranks, double pixels, const goal *g)
{
    int threshold = RANKS - 1;

    for (int i = RANKS - 1; i-- > 0;) {
        ranks[i].count += ranks[i + 1].count;
        ranks[i].square += ranks[i + 1].square;
    }
    while (threshold > 1 && !suffices(ranks, threshold, pixels, g))
        threshold--;
    return threshold;
}

/* The ranks take the places of the errors. */
static void count_ranks(const cells *c, const planes *p, uint32_t least, tally *ranks)
{
    memset(ranks, 0, RANKS * sizeof *ranks);
    for (int y = 0; y < p->height; y++)
        for (int x = 0; x < p->width; x++) {
            const singles *s = &c->singles[group_of(c->columns, x, y)];
            const int place = place_of(x, y), gets = raised(s->has[place], least);
            float *at = row_of(p, LIGHT, y) + x;
            const int rank = rank_pixel(s->has[place], gets, *at);

            *at = (float)rank;
            ranks[rank].count += 1u << (gets - 1);
            ranks[rank].square += (double)s->square[place];
        }
}

/* So many doublings above `least`. A group's target is the most of its pixels'. True: the pixel gets more. */
static bool give(cells *c, int x, int y, uint32_t least, int more)
{
    const size_t number = group_of(c->columns, x, y);
    singles *s = &c->singles[number];
    const int place = place_of(x, y), has = s->has[place], to = raised(has, least) + more;

    s->gets[place] = (uint8_t)(single_count((uint8_t)to) < SAMPLES_MAX ? to : raised(has, SAMPLES_MAX));
    if (single_count(s->gets[place]) > c->groups[number].target)
        c->groups[number].target = single_count(s->gets[place]);
    return s->gets[place] > has;
}

bool budget_singles_next(cells *c, const goal *g, uint32_t least)
{
    const planes p = planes_of(c, c->planes);
    tally *ranks = c->ranks;
    bool more = false;
    int threshold;

    fill(c, &p);
    expect_all(&p);
    count_ranks(c, &p, least, ranks);
    threshold = find_threshold(ranks, (double)c->width * (double)c->height, g);
    for (int y = 0; y < c->height; y++)
        for (int x = 0; x < c->width; x++)
            more |= give(c, x, y, least, doublings((int)row_of(&p, LIGHT, y)[x], threshold));
    return more;
}

bool budget_singles_all(cells *c, uint32_t target)
{
    bool more = false;

    for (int y = 0; y < c->height; y++)
        for (int x = 0; x < c->width; x++)
            more |= give(c, x, y, target, 0);
    return more;
}
