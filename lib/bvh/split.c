#include "bvh/corner.h"

#include "base/share.h"

#include <stddef.h>
#include <string.h>

/* A range of many references is processed in slices. Minima, maxima and counts do not depend on how they are
 * combined. */
enum { BINS = 16, SLICES = 32, SLICES_FROM = 1 << 16 };
/* Centres closer together than this have no order. */
static const float least_width = 1e-30f;

static inline corner lo_of(const bvh_ref *f) { return corner_at(f); }
static inline corner hi_of(const bvh_ref *f) { return corner_at((const char *)f + offsetof(bvh_ref, hi)); }

/* Bounds of boxes, and of their centres times two. */
typedef struct extent { box all, centres; } extent;

static void extend(extent *e, const bvh_ref *refs, uint32_t begin, uint32_t end)
{
    box all = no_box, centres = no_box;
    uint32_t i;

    for (i = begin; i < end; i++) {
        const corner lo = lo_of(&refs[i]), hi = hi_of(&refs[i]), c = sum_of(lo, hi);
        all = add(all, lo, hi);
        centres = add(centres, c, c);
    }
    e->all = all;
    e->centres = centres;
}

typedef struct extent_work { const bvh_range *range; const bvh_ref *refs; extent slices[SLICES]; } extent_work;

static void extend_slice(void *user, uint32_t i, int worker)
{
    extent_work *w = user;
    uint32_t n = bvh_range_count(w->range), begin = w->range->begin;

    (void)worker;
    extend(&w->slices[i], w->refs, begin + share_begin(n, SLICES, i), begin + share_begin(n, SLICES, i + 1));
}

static extent extent_of(const bvh_range *r, const bvh_ref *refs, int threads)
{
    extent_work w;
    extent all;
    int i;

    if (threads <= 1 || bvh_range_count(r) < SLICES_FROM) {
        extend(&all, refs, r->begin, r->end);
        return all;
    }
    w.range = r;
    w.refs = refs;
    share_work(threads, SLICES, extend_slice, &w);
    for (all = w.slices[0], i = 1; i < SLICES; i++) {
        all.all = add(all.all, w.slices[i].all.lo, w.slices[i].all.hi);
        all.centres = add(all.centres, w.slices[i].centres.lo, w.slices[i].centres.hi);
    }
    return all;
}

void bvh_range_measure(bvh_range *r, const bvh_ref *refs, int threads)
{
    extent e = extent_of(r, refs, threads);
    int k;

    for (k = 0; k < 3; k++) {
        r->lo[k] = LANE(e.all.lo, k);
        r->hi[k] = LANE(e.all.hi, k);
        r->centre_lo[k] = LANE(e.centres.lo, k);
        r->centre_hi[k] = LANE(e.centres.hi, k);
    }
    r->area = area_of(&e.all);
    r->is_leaf = false;
}

/* ---- where to cut ---- */

typedef struct cut { int axis, at; float base, factor, cost; } cut;

/* The bin of a box along the split axis. Each use must round alike, or a reference would change sides. */
static inline int bin_of(const bvh_ref *f, int axis, float base, float factor)
{
    return (int)((f->lo[axis] + f->hi[axis] - base) * factor);
}

/* Cost of intersecting objects of so many slots: the number of blocks that they fill. */
static float cost_of(uint32_t slots) { return (float)((slots + BVH_WIDTH - 1) / BVH_WIDTH); }

/* Bins along an axis; count: slots. */
typedef struct bins { box at[BINS]; uint32_t count[BINS]; } bins;

/* The best split between two bins of one axis. Most ranges hold few objects, so most bins are empty: they cost as much
 * as the one before, and are skipped. */
static void weigh(const bins *h, int axis, float base, float factor, cut *best)
{
    float right[BINS];
    uint32_t held[BINS], count = 0;
    int n = 0, i;
    box sum = no_box;

    for (i = 0; i < BINS; i++) {
        held[n] = (uint32_t)i;
        n += h->count[i] > 0;
    }
    for (i = n - 1; i > 0; i--) {
        sum = add(sum, h->at[held[i]].lo, h->at[held[i]].hi);
        count += h->count[held[i]];
        right[i] = area_of(&sum) * cost_of(count);
    }
    sum = no_box;
    for (i = 1, count = 0; i < n; i++) {
        float cost;
        sum = add(sum, h->at[held[i - 1]].lo, h->at[held[i - 1]].hi);
        count += h->count[held[i - 1]];
        cost = area_of(&sum) * cost_of(count) + right[i];
        if (cost < best->cost) {
            const cut found = { axis, (int)held[i], base, factor, cost };
            *best = found;
        }
    }
}

typedef struct histogram { bins at[3]; } histogram;

static void sort_into(histogram *h, const bvh_range *r, const float *factor, const bvh_ref *refs, uint32_t begin,
                      uint32_t end)
{
    uint32_t i;
    int k, j;

    for (k = 0; k < 3; k++) {
        for (j = 0; j < BINS; j++)
            h->at[k].at[j] = no_box;
        memset(h->at[k].count, 0, sizeof h->at[k].count);
    }
    for (i = begin; i < end; i++)
        for (k = 0; k < 3; k++) {
            const int at = bin_of(&refs[i], k, r->centre_lo[k], factor[k]);
            h->at[k].at[at] = add(h->at[k].at[at], lo_of(&refs[i]), hi_of(&refs[i]));
            h->at[k].count[at] += refs[i].slots;
        }
}

typedef struct histogram_work {
    const bvh_range *range;
    const bvh_ref *refs;
    const float *factor;
    histogram slices[SLICES];
} histogram_work;

static void sort_slice(void *user, uint32_t i, int worker)
{
    histogram_work *w = user;
    uint32_t n = bvh_range_count(w->range), begin = w->range->begin;

    (void)worker;
    sort_into(&w->slices[i], w->range, w->factor, w->refs, begin + share_begin(n, SLICES, i),
              begin + share_begin(n, SLICES, i + 1));
}

static void sort_together(histogram *all, const bvh_range *r, const float *factor, const bvh_ref *refs, int threads)
{
    histogram_work w;
    int i, k, j;

    w.range = r;
    w.refs = refs;
    w.factor = factor;
    share_work(threads, SLICES, sort_slice, &w);
    *all = w.slices[0];
    for (i = 1; i < SLICES; i++)
        for (k = 0; k < 3; k++)
            for (j = 0; j < BINS; j++) {
                const bins *more = &w.slices[i].at[k];
                all->at[k].at[j] = add(all->at[k].at[j], more->at[j].lo, more->at[j].hi);
                all->at[k].count[j] += more->count[j];
            }
}

static cut find_cut(const bvh_range *r, const bvh_ref *refs, int threads)
{
    histogram h;
    float factor[3];
    cut best = { -1, 0, 0.0f, 0.0f, FLT_MAX };
    int k;

    for (k = 0; k < 3; k++) {
        float wide = r->centre_hi[k] - r->centre_lo[k];
        /* Just below the number of bins, so that the last centre falls into the last bin. If all centres are equal, or
         * nearly so relative to the frame, all fall into the first, and this axis has no split. */
        factor[k] = wide > least_width ? (float)BINS * 0.9999f / wide : 0.0f;
    }
    if (threads > 1 && bvh_range_count(r) >= SLICES_FROM)
        sort_together(&h, r, factor, refs, threads);
    else
        sort_into(&h, r, factor, refs, r->begin, r->end);
    for (k = 0; k < 3; k++)
        if (factor[k] > 0.0f)
            weigh(&h.at[k], k, r->centre_lo[k], factor[k], &best);
    return best;
}

static inline void swap(bvh_ref *a, bvh_ref *b)
{
    const bvh_ref old = *a;

    *a = *b;
    *b = old;
}

/* Elements on the wrong side of large ranges are found block by block, without unpredictable branches. The swaps are
 * the same as one by one. */
static void partition_blocks(bvh_ref *refs, uint32_t *begin, uint32_t *end, const cut *c)
{
    enum { BLOCK = 64 };
    uint8_t low[BLOCK], high[BLOCK];
    uint32_t lows = 0, highs = 0, from_low = 0, from_high = 0, i, n;

    while (*end - *begin > 2 * BLOCK) {
        bvh_ref *left = refs + *begin, *right = refs + *end - 1;

        if (lows == 0)
            for (i = from_low = 0; i < BLOCK; i++) {
                low[lows] = (uint8_t)i;
                lows += bin_of(left + i, c->axis, c->base, c->factor) >= c->at;
            }
        if (highs == 0)
            for (i = from_high = 0; i < BLOCK; i++) {
                high[highs] = (uint8_t)i;
                highs += bin_of(right - i, c->axis, c->base, c->factor) < c->at;
            }
        n = lows < highs ? lows : highs;
        for (i = 0; i < n; i++)
            swap(left + low[from_low + i], right - high[from_high + i]);
        from_low += n;
        from_high += n;
        lows -= n;
        highs -= n;
        *begin += lows == 0 ? BLOCK : 0;
        *end -= highs == 0 ? BLOCK : 0;
    }
}

static uint32_t partition(bvh_ref *refs, uint32_t begin, uint32_t end, const cut *c)
{
    partition_blocks(refs, &begin, &end, c);
    for (;;) {
        while (begin < end && bin_of(&refs[begin], c->axis, c->base, c->factor) < c->at)
            begin++;
        while (begin < end && bin_of(&refs[end - 1], c->axis, c->base, c->factor) >= c->at)
            end--;
        if (begin >= end)
            return begin;
        swap(&refs[begin], &refs[end - 1]);
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

/* Two objects, as in every third split: both orders cost the same, so the first axis decides on which their centres
 * differ. */
static void split_two(const bvh_range *r, bvh_ref *refs, bvh_range *a, bvh_range *b)
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

void bvh_split(const bvh_range *r, bvh_ref *refs, int threads, bvh_range *a, bvh_range *b)
{
    cut best;

    if (bvh_range_count(r) == 2) {
        split_two(r, refs, a, b);
        return;
    }
    best = find_cut(r, refs, threads);
    if (best.axis < 0)
        bvh_halve(r, refs, a, b);
    else
        divide(r, refs, partition(refs, r->begin, r->end, &best), threads, a, b);
}
