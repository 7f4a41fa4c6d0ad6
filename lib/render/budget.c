#include "render/budget.h"

#include "render/sample.h"

#include <math.h>

/* A pass adds half of what is there. An estimate from few samples may be far off, so no cell grows by more than
 * GROWTH in one pass, and none stays behind the mean by more than LAG: what all samples of a cell have missed is
 * looked for all the same. */
enum { GROWTH = 4, LAG = 8 };

/* The error aimed at, in parts of the one that was asked for: to be just below it is not to need another pass. */
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

static bool set_all(cells *c, uint32_t target)
{
    bool more = false;

    for (size_t i = 0; i < c->count; i++) {
        cell *at = &c->items[i];

        at->target = target > at->count ? target : at->count;
        more = more || at->target > at->count;
    }
    return more;
}

static bool next_uniform(cells *c, const settings *s, const pov_pass *now)
{
    uint32_t n = (uint32_t)now->spp_max, next = next_rung(n);

    if (s->target_error > 0.0 && now->est_rmse > 0.0 && n >= BUDGET_PILOT) {
        double ratio = now->est_rmse / (aim * s->target_error);
        double needed = fmax(n * ratio * ratio, n + 2.0);

        if (needed < next)
            next = even_above(needed);
    }
    return set_all(c, next < (uint32_t)s->samples ? next : (uint32_t)s->samples);
}

/* ---- where the error is ---- */

/* The error of a cell, as a variance of one sample, but no less than the mean of its neighbourhood: an edge goes on
 * next door, and an estimate that is low by chance is mended by its neighbours'. */
static double variance_near(const cells *c, int column, int row)
{
    double own = 0.0, sum = 0.0;
    int n = 0;

    for (int y = row > 0 ? row - 1 : 0; y <= row + 1 && y < c->rows; y++)
        for (int x = column > 0 ? column - 1 : 0; x <= column + 1 && x < c->columns; x++) {
            size_t index = (size_t)y * (size_t)c->columns + (size_t)x;
            pov_rect r = cells_rect(c, index);
            double v = c->items[index].square * c->items[index].count / ((double)r.width * r.height);

            if (x == column && y == row)
                own = v;
            sum += v;
            n++;
        }
    return fmax(own, sum / n);
}

static uint32_t wanted(const cell *at, double weight, double scale, uint32_t least)
{
    uint32_t most = at->count < SAMPLES_MAX / GROWTH ? GROWTH * at->count : SAMPLES_MAX;
    uint32_t n = scale * weight < most ? even_above(scale * weight) : most;

    n = n > least ? n : least;
    return n > at->count ? n : at->count;
}

typedef struct outcome { double mean, square; } outcome;

/* What the picture would be with this scale: the sum of squared errors is least, at a given number of samples, where
 * samples are in proportion to the standard deviation. */
static outcome foresee(const cells *c, const double *weights, double scale, uint32_t least)
{
    double all = (double)c->width * (double)c->height;
    outcome o = { 0.0, 0.0 };

    for (size_t i = 0; i < c->count; i++) {
        const cell *at = &c->items[i];
        pov_rect r = cells_rect(c, i);
        uint32_t n = wanted(at, weights[i], scale, least);

        o.mean += (double)r.width * r.height * n;
        o.square += at->square * at->count / n;
    }
    o.mean /= all;
    o.square /= all;
    return o;
}

/* The scale that gives this mean, or as near as it comes from above. `square` above 0: or the smaller one that is
 * enough for that error. */
static double find_scale(const cells *c, const double *weights, double mean, double square, uint32_t least)
{
    enum { DOUBLINGS = 40, HALVINGS = 20 };
    double low = 0.0, high = 1.0;
    outcome o = foresee(c, weights, high, least);

    for (int i = 0; i < DOUBLINGS && o.mean < mean && !(o.square <= square); i++) {
        low = high;
        high *= 2.0;
        o = foresee(c, weights, high, least);
    }
    for (int i = 0; i < HALVINGS; i++) {
        double middle = 0.5 * (low + high);

        o = foresee(c, weights, middle, least);
        if (o.mean < mean && !(o.square <= square))
            low = middle;
        else
            high = middle;
    }
    return high;
}

static bool next_adaptive(cells *c, const settings *s, const pov_pass *now, double *weights)
{
    double mean = fmin(1.5 * now->spp_mean, s->samples), goal = aim * s->target_error, largest = 0.0, scale;
    uint32_t least = even_above(floor(mean / LAG));
    bool more = false;

    for (size_t i = 0; i < c->count; i++) {
        weights[i] = sqrt(variance_near(c, (int)(i % (size_t)c->columns), (int)(i / (size_t)c->columns)));
        largest = fmax(largest, weights[i]);
    }
    for (size_t i = 0; i < c->count && largest > 0.0; i++)
        weights[i] /= largest;
    scale = find_scale(c, weights, mean, goal * goal, least);
    for (size_t i = 0; i < c->count; i++) {
        c->items[i].target = wanted(&c->items[i], weights[i], scale, least);
        more = more || c->items[i].target > c->items[i].count;
    }
    return more || set_all(c, even_above(mean));
}

bool budget_next(cells *c, const settings *s, const pov_pass *now, double *scratch)
{
    if (s->adaptive && now->spp_mean >= BUDGET_PILOT)
        return next_adaptive(c, s, now, scratch);
    if (s->adaptive && s->samples > BUDGET_PILOT) {
        settings pilot = *s;

        pilot.samples = BUDGET_PILOT;
        return next_uniform(c, &pilot, now);
    }
    return next_uniform(c, s, now);
}
