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
        /* All up to j are no larger, all from j + 1 on no smaller. */
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
    double spread = square > 0.0 ? 1.96 * sqrt(2.0 * fourth) / square : 0.0;

    row->est_ci95_lo = row->est_rmse * exp(-0.5 * spread);
    row->est_ci95_hi = row->est_rmse * exp(0.5 * spread);
}

static size_t pixels_of(const cells *c, size_t index)
{
    pov_rect r = cells_rect(c, index);

    return (size_t)r.width * (size_t)r.height;
}

void estimate_row(const cells *c, const settings *s, double *scratch, pov_pass *row)
{
    const double eye_sees = 1.0 / 255.0;
    double limit = s->target_error > 0.0 ? s->target_error : eye_sees, all = (double)c->width * (double)c->height;
    double square = 0.0, fourth = 0.0, off = 0.0, samples = 0.0;
    bool known = true, whole = true;

    row->unresolved = row->clipped = 0;
    row->spp_max = 0;
    row->ref_max = 0.0;
    for (size_t i = 0; i < c->count; i++) {
        const cell *at = &c->items[i];
        double pixels = (double)pixels_of(c, i);

        square += at->square;
        fourth += at->fourth;
        off += at->off_square;
        samples += pixels * at->count;
        scratch[i] = at->square / pixels;
        row->unresolved += at->square > limit * limit * pixels ? (uint64_t)pixels : 0;
        row->clipped += at->clipped;
        row->ref_max = fmax(row->ref_max, at->off_max);
        row->spp_max = (int)at->count > row->spp_max ? (int)at->count : row->spp_max;
        known = known && at->count > 1;
        whole = whole && at->count > 0;
    }
    row->spp_mean = samples / all;
    row->est_rmse = row->est_ci95_lo = row->est_ci95_hi = row->est_p99_tile = -1.0;
    if (known) {
        row->est_rmse = sqrt(square / all);
        band(row, square, fourth);
        row->est_p99_tile = sqrt(select_kth(scratch, c->count, (c->count - 1) * 99 / 100));
    }
    row->ref_rmse = c->reference && whole ? sqrt(off / all) : -1.0;
    if (row->ref_rmse < 0.0)
        row->ref_max = -1.0;
}
