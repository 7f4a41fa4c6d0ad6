#include "render/budget.h"

#include "render/budget_singles.h"
#include "render/estimate.h"
#include "render/sample.h"

#include <math.h>

/* A pass adds half of the present samples. No cell falls behind the mean by more than LAG, so that features missed by
 * all samples of a cell are still found. */
enum { LAG = 8 };

/* The error aimed at, as a fraction of the requested one: a result just below it needs no further pass. */
static const double aim = 0.985;

static uint32_t even_above(double n)
{
    double even = 2.0 * ceil(0.5 * n);

    return even < SAMPLES_MAX ? (uint32_t)even : SAMPLES_MAX;
}

/* ---- all pixels alike ---- */

/* 1 2 4 6 8 12 16 24 32 ...: both halves are whole nets at every other step. */
static uint32_t next_rung(uint32_t n)
{
    uint32_t power = 2;

    if (n < 2)
        return 2;
    while (power <= n / 2)
        power *= 2;
    if (power < 4)
        return 2 * power;
    return n < power + power / 2 ? power + power / 2 : 2 * power;
}

/* Samples of a cell before its error may be found too small to be seen: below a step of a picture of 8 bits, whose curve has a
 * slope of about 1/2 for light 1, and in inverse proportion to the light's root below. */
enum { ENOUGH_LEAST = 16 };
static const double least_step = 4.0 / (255.0 * 255.0);   /* squared, per light */

/* The error of the cell alone is asked for, so that parts of a picture need not know of each other. */
static bool is_enough(const cells *c, const settings *s, size_t number)
{
    const size_t first = number - number % GROUPS;
    double square = 0.0, bright = 0.0;

    if (!s->ends_early || c->groups[number].count < ENOUGH_LEAST)
        return false;
    for (size_t i = first; i < first + GROUPS; i++) {
        square += c->shown[i].square;
        bright += (c->shown[i].light[0] + c->shown[i].light[1] + c->shown[i].light[2]) / 3.0;
    }
    return square <= least_step * bright;
}

static bool set_all(cells *c, const settings *s, uint32_t target)
{
    bool more = false;

    if (c->singles)
        return budget_singles_all(c, target);
    for (size_t i = 0; i < GROUPS * c->count; i++) {
        group *at = &c->groups[i];

        at->target = target > at->count && !is_enough(c, s, i) ? target : at->count;
        more = more || at->target > at->count;
    }
    return more;
}

static bool next_uniform(cells *c, const settings *s, const pov_pass *now)
{
    uint32_t n = (uint32_t)now->spp_max, next = next_rung(n);

    if (s->target_error > 0.0 && now->est_rmse > 0.0 && n >= (uint32_t)budget_least(c)) {
        double ratio = now->est_rmse / (aim * estimate_asked(s, now));
        double needed = pov_max(n * ratio * ratio, n + 2.0);

        if (needed < next)
            next = even_above(needed);
    }
    return set_all(c, s, next < (uint32_t)s->samples ? next : (uint32_t)s->samples);
}

/* ---- where the error is ----
 *
 * Counts double, so that both halves stay whole nets: half a net more would be worth little. The mean squared error of
 * a cell then falls by 2^-3/2 where edges make it, by less where more than a place in the pixel decides. So what
 * doubling takes off the picture's error for each sample is in proportion to error / count, and the cells where that
 * is above some threshold double: a little above, once; far above, twice. */

static const double falls_by = 0.36, far_above = 5.0;

/* The mean squared error of a pixel of the other group of the cell, with this group's sample count. The few differences
 * of one group are mostly chance. So a quarter of the estimate is its own; a quarter is the neighbourhood's, because
 * edges continue in the next cell; and a half is the neighbourhood's, weighted by the group's share of its contrast,
 * because errors are where pixels differ. */
static double error_near(const cells *c, size_t number)
{
    int column = (int)(number / GROUPS % (size_t)c->columns), row = (int)(number / GROUPS / (size_t)c->columns);
    double own = 0.0, own_contrast = 0.0, sum = 0.0, contrasts = 0.0;
    int n = 0;

    for (int y = row > 0 ? row - 1 : 0; y <= row + 1 && y < c->rows; y++)
        for (int x = column > 0 ? column - 1 : 0; x <= column + 1 && x < c->columns; x++) {
            size_t other = GROUPS * ((size_t)y * (size_t)c->columns + (size_t)x) + (1 - number % GROUPS);
            size_t pixels = cells_pixels(c, other);
            double square, contrast;

            if (pixels == 0)
                continue;
            square = c->shown[other].square * c->groups[other].count / ((double)pixels * c->groups[number].count);
            contrast = cells_contrast(&c->shown[other], pixels);
            if (x == column && y == row) {
                own = square;
                own_contrast = contrast;
            }
            sum += square;
            contrasts += contrast;
            n++;
        }
    if (n == 0)
        return 0.0;
    return 0.25 * (own + sum / n) + 0.5 * sum * (contrasts > 0.0 ? own_contrast / contrasts : 1.0 / n);
}

static uint32_t wanted(const group *at, double worth, double threshold, uint32_t least)
{
    uint32_t n = at->count;

    if (worth > threshold)
        n *= worth > far_above * threshold ? 4 : 2;
    while (n < least)
        n *= 2;
    return n < SAMPLES_MAX ? n : SAMPLES_MAX;
}

typedef struct outcome { double mean, square; } outcome;

/* Add what a group makes of the picture's cost and error, both still sums over pixels, for this threshold. */
static void foresee(const cells *c, size_t number, double worth, double threshold, uint32_t least, outcome *o)
{
    const group *at = &c->groups[number];
    const uint32_t n = wanted(at, worth, threshold, least);
    double square = c->shown[number].square;

    for (uint32_t k = at->count; k < n; k *= 2)
        square *= falls_by;
    o->mean += (double)cells_pixels(c, number) * n;
    o->square += square;
}

/* A pass adds at least a sixteenth, because each pass has a cost of its own; and no pass ends for the requested error
 * before the least mean that may. */
static goal goal_of(const cells *c, const settings *s, const pov_pass *now)
{
    const double growth = c->singles ? 2.0 : 1.5;
    double mean = pov_min(growth * now->spp_mean, s->samples), error = aim * estimate_asked(s, now);
    double fewest = pov_max(1.0625 * now->spp_mean, budget_least(c));

    return (goal){ mean, pov_min(mean, fewest), error * error };
}

/* Groups whose counts depend on the threshold, as far as it is known, and what all others make. */
typedef struct search { double low, high, *open; size_t count; outcome fixed; } search;

static void decide(search *f, const cells *c, const double *worths, uint32_t least)
{
    size_t left = 0;

    for (size_t k = 0; k < f->count; k++) {
        const size_t i = (size_t)f->open[k];

        if (wanted(&c->groups[i], worths[i], f->low, least) == wanted(&c->groups[i], worths[i], f->high, least))
            foresee(c, i, worths[i], f->low, least, &f->fixed);
        else
            f->open[left++] = (double)i;
    }
    f->count = left;
}

static bool suffices(const search *f, const cells *c, const double *worths, double threshold, uint32_t least, const goal *g)
{
    const double all = (double)c->width * (double)c->height;
    outcome o = f->fixed;

    for (size_t k = 0; k < f->count; k++)
        foresee(c, (size_t)f->open[k], worths[(size_t)f->open[k]], threshold, least, &o);
    return o.mean / all >= g->mean || (o.mean / all >= g->fewest && o.square / all <= g->square);
}

/* The highest sufficient threshold, or one that all groups take as that; or zero, for all groups. `open` holds a number for
 * each group. */
static double find_threshold(const cells *c, const double *worths, const goal *g, uint32_t least, double *open)
{
    enum { HALVINGS = 40 };
    search f = { .open = open, .count = GROUPS * c->count };

    for (size_t i = 0; i < f.count; i++) {
        open[i] = (double)i;
        f.high = pov_max(f.high, worths[i]);
    }
    for (int i = 0; i < HALVINGS && f.count > 0; i++) {
        /* Benefits span many decades: bisect by the geometric mean, once there is one. */
        const double middle = f.low > 0.0 ? sqrt(f.low * f.high) : f.high / 1024.0;

        if (suffices(&f, c, worths, middle, least, g))
            f.low = middle;
        else
            f.high = middle;
        decide(&f, c, worths, least);
    }
    return f.low;
}

static bool next_adaptive(cells *c, const settings *s, const pov_pass *now, double *worths)
{
    const goal g = goal_of(c, s, now);
    const uint32_t least = (uint32_t)(g.mean / LAG);
    double threshold;
    bool more = false;

    if (c->singles)
        return budget_singles_next(c, &g, least) || set_all(c, s, 2 * (uint32_t)now->spp_max);

    for (size_t i = 0; i < GROUPS * c->count; i++)
        worths[i] = error_near(c, i) / c->groups[i].count;
    threshold = find_threshold(c, worths, &g, least, worths + GROUPS * c->count);
    for (size_t i = 0; i < GROUPS * c->count; i++) {
        group *at = &c->groups[i];

        at->target = wanted(at, worths[i], threshold, least);
        more = more || at->target > at->count;
    }
    return more || set_all(c, s, 2 * (uint32_t)now->spp_max);
}

bool budget_next(cells *c, const settings *s, const pov_pass *now, double *scratch)
{
    const int first = budget_pilot(c);

    if (s->adaptive && now->spp_mean >= first)
        return next_adaptive(c, s, now, scratch);
    if (s->adaptive && s->samples > first) {
        settings pilot = *s;

        pilot.samples = first;
        return next_uniform(c, &pilot, now);
    }
    return next_uniform(c, s, now);
}

int budget_blind_end(const cells *c, const settings *s)
{
    const int end = s->adaptive ? budget_pilot(c) : s->target_error > 0.0 ? BUDGET_LEAST : s->samples;

    return end < s->samples ? end : s->samples;
}

bool budget_blind(cells *c, const settings *s, const pov_pass *now)
{
    return now->spp_max < budget_blind_end(c, s) && budget_next(c, s, now, NULL);
}
