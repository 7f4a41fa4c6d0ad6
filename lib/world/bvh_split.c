#include "world/bvh_build.h"

#include "base/share.h"

#include <float.h>
#include <stddef.h>
#include <string.h>

/* A range of many references is looked through in parts. Smallest and largest values and counts do not depend on how
 * they are put together. */
enum { BINS = 16, PARTS = 32, PARTS_FROM = 1 << 16 };
/* Centres that lie together within this have no order. */
static const float least_width = 1e-30f;

/* Four lanes, so that a box is two vectors; the fourth means nothing. */
typedef struct bin { float lo[4], hi[4]; uint32_t count; } bin;

static void bin_clear(bin *b)
{
    int k;

    for (k = 0; k < 4; k++) {
        b->lo[k] = FLT_MAX;
        b->hi[k] = -FLT_MAX;
    }
    b->count = 0;
}

/* Copies first, so that the compiler sees that nothing overlaps. `lo` and `hi` are four floats each. */
static inline void bin_add(bin *b, const void *lo, const void *hi, uint32_t count)
{
    float a[4], c[4], x[4], y[4];
    int k;

    memcpy(a, b->lo, sizeof a);
    memcpy(c, b->hi, sizeof c);
    memcpy(x, lo, sizeof x);
    memcpy(y, hi, sizeof y);
    for (k = 0; k < 4; k++)
        a[k] = x[k] < a[k] ? x[k] : a[k];
    for (k = 0; k < 4; k++)
        c[k] = y[k] > c[k] ? y[k] : c[k];
    memcpy(b->lo, a, sizeof a);
    memcpy(b->hi, c, sizeof c);
    b->count += count;
}

/* The corners of a reference's box as vectors; what is in their fourth lanes is no number. They are read from where
 * they stand: gcc 12, compiling for AVX2, spills a copy of both to a stack that it forgets to align. */
static inline const void *lo_of(const bvh_ref *f) { return f; }
static inline const void *hi_of(const bvh_ref *f) { return (const char *)f + offsetof(bvh_ref, hi); }

/* Half the surface. */
static float area_of(const float *lo, const float *hi)
{
    float x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
    return x * y + y * z + z * x;
}

typedef struct extent { bin box, centres; } extent;

static void extend(extent *e, const bvh_ref *refs, uint32_t begin, uint32_t end)
{
    uint32_t i;
    int k;

    bin_clear(&e->box);
    bin_clear(&e->centres);
    for (i = begin; i < end; i++) {
        float c[4], hi[4];
        bin_add(&e->box, lo_of(&refs[i]), hi_of(&refs[i]), 1);
        memcpy(c, lo_of(&refs[i]), sizeof c);
        memcpy(hi, hi_of(&refs[i]), sizeof hi);
        for (k = 0; k < 4; k++)
            c[k] += hi[k];
        bin_add(&e->centres, c, c, 1);
    }
}

typedef struct extent_work { const bvh_range *range; const bvh_ref *refs; extent parts[PARTS]; } extent_work;

static void extend_part(void *user, uint32_t i, int hand)
{
    extent_work *w = user;
    uint32_t n = bvh_range_count(w->range), begin = w->range->begin;

    (void)hand;
    extend(&w->parts[i], w->refs, begin + share_begin(n, PARTS, i), begin + share_begin(n, PARTS, i + 1));
}

static extent extent_of(const bvh_range *r, const bvh_ref *refs, int threads)
{
    extent_work w;
    extent all;
    int i;

    if (threads <= 1 || bvh_range_count(r) < PARTS_FROM) {
        extend(&all, refs, r->begin, r->end);
        return all;
    }
    w.range = r;
    w.refs = refs;
    share_work(threads, PARTS, extend_part, &w);
    for (all = w.parts[0], i = 1; i < PARTS; i++) {
        bin_add(&all.box, w.parts[i].box.lo, w.parts[i].box.hi, w.parts[i].box.count);
        bin_add(&all.centres, w.parts[i].centres.lo, w.parts[i].centres.hi, w.parts[i].centres.count);
    }
    return all;
}

void bvh_range_measure(bvh_range *r, const bvh_ref *refs, int threads)
{
    extent e = extent_of(r, refs, threads);
    int k;

    for (k = 0; k < 3; k++) {
        r->lo[k] = e.box.lo[k];
        r->hi[k] = e.box.hi[k];
        r->centre_lo[k] = e.centres.lo[k];
        r->centre_hi[k] = e.centres.hi[k];
    }
    r->area = area_of(r->lo, r->hi);
    r->is_leaf = false;
}

/* ---- where to cut ---- */

typedef struct cut { int axis, at; float base, factor, cost; } cut;

/* The bin of a box along the cut's axis. Each use must round alike, or a thing would change sides. */
static inline int bin_of(const bvh_ref *f, int axis, float base, float factor)
{
    return (int)((f->lo[axis] + f->hi[axis] - base) * factor);
}

/* What asking n things costs: packed ones are asked eight at once. */
static float cost_of(uint32_t n, bool count_blocks)
{
    return (float)(count_blocks ? (n + BVH_WIDTH - 1) / BVH_WIDTH : n);
}

/* The best place between two bins of one axis. Most ranges are of few things, so that most bins hold nothing: they
 * cost as much as the one before, and are passed by. */
static void weigh(const bin *bins, bool count_blocks, int axis, float base, float factor, cut *best)
{
    const bin *held[BINS];
    float right[BINS];
    int n = 0, i;
    bin sum;

    for (i = 0; i < BINS; i++) {
        held[n] = &bins[i];
        n += bins[i].count > 0;
    }
    bin_clear(&sum);
    for (i = n - 1; i > 0; i--) {
        bin_add(&sum, held[i]->lo, held[i]->hi, held[i]->count);
        right[i] = area_of(sum.lo, sum.hi) * cost_of(sum.count, count_blocks);
    }
    bin_clear(&sum);
    for (i = 1; i < n; i++) {
        float cost;
        bin_add(&sum, held[i - 1]->lo, held[i - 1]->hi, held[i - 1]->count);
        cost = area_of(sum.lo, sum.hi) * cost_of(sum.count, count_blocks) + right[i];
        if (cost < best->cost) {
            cut found = { axis, (int)(held[i] - bins), base, factor, cost };
            *best = found;
        }
    }
}

/* Bins along the three axes. */
typedef struct histogram { bin at[3][BINS]; } histogram;

static void sort_into(histogram *h, const bvh_range *r, const float *factor, const bvh_ref *refs, uint32_t begin,
                      uint32_t end)
{
    uint32_t i;
    int k, j;

    for (k = 0; k < 3; k++)
        for (j = 0; j < BINS; j++)
            bin_clear(&h->at[k][j]);
    for (i = begin; i < end; i++)
        for (k = 0; k < 3; k++)
            bin_add(&h->at[k][bin_of(&refs[i], k, r->centre_lo[k], factor[k])], lo_of(&refs[i]), hi_of(&refs[i]), 1);
}

typedef struct histogram_work {
    const bvh_range *range;
    const bvh_ref *refs;
    const float *factor;
    histogram parts[PARTS];
} histogram_work;

static void sort_part(void *user, uint32_t i, int hand)
{
    histogram_work *w = user;
    uint32_t n = bvh_range_count(w->range), begin = w->range->begin;

    (void)hand;
    sort_into(&w->parts[i], w->range, w->factor, w->refs, begin + share_begin(n, PARTS, i),
              begin + share_begin(n, PARTS, i + 1));
}

static void sort_together(histogram *all, const bvh_range *r, const float *factor, const bvh_ref *refs, int threads)
{
    histogram_work w;
    int i, k, j;

    w.range = r;
    w.refs = refs;
    w.factor = factor;
    share_work(threads, PARTS, sort_part, &w);
    *all = w.parts[0];
    for (i = 1; i < PARTS; i++)
        for (k = 0; k < 3; k++)
            for (j = 0; j < BINS; j++)
                bin_add(&all->at[k][j], w.parts[i].at[k][j].lo, w.parts[i].at[k][j].hi, w.parts[i].at[k][j].count);
}

static cut find_cut(const bvh_range *r, const bvh_ref *refs, bool count_blocks, int threads)
{
    histogram bins;
    float factor[3];
    cut best = { -1, 0, 0.0f, 0.0f, FLT_MAX };
    int k;

    for (k = 0; k < 3; k++) {
        float wide = r->centre_hi[k] - r->centre_lo[k];
        /* Just below the number of bins, so that the last centre falls into the last of them. Where all centres are
         * the same, or nearly so against the frame, all fall into the first, and nothing separates there. */
        factor[k] = wide > least_width ? (float)BINS * 0.9999f / wide : 0.0f;
    }
    if (threads > 1 && bvh_range_count(r) >= PARTS_FROM)
        sort_together(&bins, r, factor, refs, threads);
    else
        sort_into(&bins, r, factor, refs, r->begin, r->end);
    for (k = 0; k < 3; k++)
        if (factor[k] > 0.0f)
            weigh(bins.at[k], count_blocks, k, r->centre_lo[k], factor[k], &best);
    return best;
}

static uint32_t partition(bvh_ref *refs, uint32_t begin, uint32_t end, const cut *c)
{
    for (;;) {
        bvh_ref swap;
        while (begin < end && bin_of(&refs[begin], c->axis, c->base, c->factor) < c->at)
            begin++;
        while (begin < end && bin_of(&refs[end - 1], c->axis, c->base, c->factor) >= c->at)
            end--;
        if (begin >= end)
            return begin;
        swap = refs[begin];
        refs[begin] = refs[end - 1];
        refs[end - 1] = swap;
    }
}

static void divide(const bvh_range *r, const bvh_ref *refs, uint32_t middle, int threads, bvh_range *a, bvh_range *b)
{
    uint32_t begin = r->begin, end = r->end;   /* a or b may be r itself */

    a->begin = begin;
    a->end = middle;
    b->begin = middle;
    b->end = end;
    bvh_range_measure(a, refs, threads);
    bvh_range_measure(b, refs, threads);
}

void bvh_halve(const bvh_range *r, const bvh_ref *refs, bvh_range *a, bvh_range *b)
{
    divide(r, refs, r->begin + bvh_range_count(r) / 2, 1, a, b);
}

/* Two things, as every third cut is of: one or the other way round costs the same, so the first axis decides on which
 * their centres are not the same. */
static void part_two(const bvh_range *r, bvh_ref *refs, bvh_range *a, bvh_range *b)
{
    bvh_ref *first = &refs[r->begin], swap = *first;
    int k = 0;

    while (k < 3 && !(r->centre_hi[k] - r->centre_lo[k] > least_width))
        k++;
    if (k < 3 && first->lo[k] + first->hi[k] > r->centre_lo[k]) {
        first[0] = first[1];
        first[1] = swap;
    }
    bvh_halve(r, refs, a, b);
}

void bvh_split(const bvh_range *r, bvh_ref *refs, bool count_blocks, int threads, bvh_range *a, bvh_range *b)
{
    cut best;

    if (bvh_range_count(r) == 2) {
        part_two(r, refs, a, b);
        return;
    }
    best = find_cut(r, refs, count_blocks, threads);
    if (best.axis < 0)
        bvh_halve(r, refs, a, b);
    else
        divide(r, refs, partition(refs, r->begin, r->end, &best), threads, a, b);
}
