#include "render/estimate.h"

#include <math.h>

/* The k-th smallest of n numbers, which change their order: Hoare's FIND. */
static double select_kth(double *v, size_t n, size_t k)
{
    size_t from = 0, to = n - 1;

    while (from < to) {
        double pivot = v[from + (to - from) / 2];
        size_t i = from, j = to;

        for (;;) {
            while (v[i] < pivot)
                i++;
            while (v[j] > pivot)
                j--;
            if (i >= j)
                break;
            double swapped = v[i];
            v[i++] = v[j];
            v[j--] = swapped;
        }
        /* Elements up to j are no larger, elements from j + 1 on no smaller. */
        if (k <= j)
            to = j;
        else
            from = j + 1;
    }
    return v[k];
}

/* The errors of the mean and of the halves' difference have the same distribution and are uncorrelated. A pixel's
 * squared error has at most the variance that its fourth power has for mean, so the true error of this very picture
 * lies within two standard deviations of `square`, taken for both, in 95 of 100 cases. A factor of the logarithm keeps
 * the band above zero. */
static void band(pov_pass *row, double square, double fourth)
{
    double spread = 1.96 * sqrt(2.0 * fourth) / square;

    row->est_ci95_lo = row->est_rmse * exp(-0.5 * spread);
    row->est_ci95_hi = row->est_rmse * exp(0.5 * spread);
}

/* Sums over the groups. fewest: samples in the cell that has the fewest. */
typedef struct sums { double square, fourth, off, samples, fewest; bool known, whole; } sums;

/* While all halves are bit-identical, their difference tells nothing. A feature that covers the fraction p of a cell is
 * missed by n samples with probability (1 - p)^n. So with n equal samples a feature of p < 3/n is not excluded in 95 of
 * 100 cases (the rule of three); a difference of one in light then makes an error of 3/n. */
static void band_of_nothing(pov_pass *row, double fewest)
{
    row->est_ci95_lo = 0.0;
    row->est_ci95_hi = pov_min(3.0 / fewest, 1.0);
}

/* Returns the samples of the group's pixels, of which there are so many. */
static size_t add_group(sums *s, const cells *c, size_t number, size_t pixels, pov_pass *row)
{
    const group *g = &c->groups[number];
    const uint32_t fewest = cells_fewest(c, number);
    const size_t samples = c->singles ? cells_samples(c, number) : pixels * g->count;

    if (pixels == 0)
        return 0;
    s->known = s->known && fewest > 1;
    s->whole = s->whole && fewest > 0;
    row->clipped += g->clipped;
    row->spp_max = (int)g->count > row->spp_max ? (int)g->count : row->spp_max;
    return samples;
}

static void add_shown(sums *s, const showing *g, pov_pass *row)
{
    s->square += g->square;
    s->fourth += g->fourth;
    s->off += g->off_square;
    row->ref_max = pov_max(row->ref_max, g->off_max);
}

static void add_cell(sums *s, const cells *c, int column, int line, double limit, double *scratch, pov_pass *row)
{
    const size_t i = (size_t)line * (size_t)c->columns + (size_t)column, first = GROUPS * i;
    const pov_rect r = cells_rect(c, column, line);
    const size_t pixels = (size_t)r.width * (size_t)r.height, second = pixels / 2;
    const double samples = (double)(add_group(s, c, first, pixels - second, row) + add_group(s, c, first + 1, second, row));

    s->samples += samples;
    s->fewest = samples < s->fewest ? samples : s->fewest;
    if (!c->shown)
        return;
    add_shown(s, &c->shown[first], row);
    add_shown(s, &c->shown[first + 1], row);
    scratch[i] = (c->shown[first].square + c->shown[first + 1].square) / (double)pixels;
    row->unresolved += scratch[i] > limit * limit ? pixels : 0;
}

void estimate_row(const cells *c, const settings *s, double *scratch, pov_pass *row)
{
    const double eye_sees = 1.0 / 255.0;
    double limit = s->target_error > 0.0 ? s->target_error : eye_sees, all = (double)c->width * (double)c->height;
    sums sum = { .fewest = HUGE_VAL, .known = true, .whole = true };

    row->unresolved = row->clipped = 0;
    row->spp_max = 0;
    row->ref_max = 0.0;
    for (int y = 0; y < c->rows; y++)
        for (int x = 0; x < c->columns; x++)
            add_cell(&sum, c, x, y, limit, scratch, row);
    row->spp_mean = sum.samples / all;
    row->est_rmse = row->est_ci95_lo = row->est_ci95_hi = row->est_p99_tile = -1.0;
    if (sum.known) {
        row->est_rmse = sqrt(sum.square / all);
        if (sum.square > 0.0)
            band(row, sum.square, sum.fourth);
        else
            band_of_nothing(row, sum.fewest);
        row->est_p99_tile = sqrt(select_kth(scratch, c->count, (c->count - 1) * 99 / 100));
    }
    row->ref_rmse = c->reference && sum.whole ? sqrt(sum.off / all) : -1.0;
    if (row->ref_rmse < 0.0)
        row->ref_max = -1.0;
}

double estimate_asked(const settings *s, const pov_pass *now)
{
    const double fifth_more = 1.2;

    return now->est_rmse > 0.0 ? s->target_error * pov_min(1.0, fifth_more * now->est_rmse / now->est_ci95_hi) : s->target_error;
}
