#include "media/matter.h"

#include "base/elementary.h"

#include <string.h>

/* Points of n strata from the first one on. */
static void find_points(const media_march *l, uint32_t first, uint32_t n, double *at)
{
    const double *edge = l->table.strata.edge;

    for (uint32_t i = first; i < first + n; i++)
        at[i - first] = edge[i] + media_jitter(&l->random, i) * (edge[i + 1] - edge[i]);
}

void matter_find(const media_march *l, media_matter *out)
{
    const media_strata *s = &l->table.strata;

    for (uint32_t first = 0, n; first < s->count; first += n) {
        n = matter_block(s, first);
        find_points(l, first, n, out->at + first);
        media_set_at(l->model, l->set, &l->on, out->at + first, n, NULL, &out->of[first / LANES_MAX]);
    }
}

/* ---- which to split ---- */

/* What one pair of strata beside another may differ from the other one, in light that is lost or given: then that between them is split. */
static const double uneven_light = 0x1p-5;

/* The least and the most of each pair, in one channel. */
typedef struct ranges { double least[LANES_MAX / 2], most[LANES_MAX / 2]; } ranges;

static void add_what(double *restrict sum, const double *restrict of, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        sum[i] += of[i];
}

static void find_ranges(const media_set *s, const media_optics *o, int c, uint32_t pairs, ranges *out)
{
    double all[LANES_MAX];

    memset(all, 0, 2 * pairs * sizeof *all);
    if (s->dims)
        add_what(all, o->loss[c], 2 * pairs);
    if (s->shines)
        add_what(all, o->emitted[c], 2 * pairs);
    if (s->scatters)
        add_what(all, o->scatter[c], 2 * pairs);
    for (uint32_t p = 0; p < pairs; p++) {
        out->least[p] = pov_min(all[2 * p], all[2 * p + 1]);
        out->most[p] = pov_max(all[2 * p], all[2 * p + 1]);
    }
}

/* How much the pairs beside each differ, in the channel where they do most; the first and the last one ask two on one side. */
static void compare_pairs(const media_set *s, const media_optics *o, uint32_t pairs, double *uneven)
{
    ranges r;

    for (uint32_t p = 0; p < pairs; p++)
        uneven[p] = 0.0;
    for (int c = 0; c < 3; c++) {
        find_ranges(s, o, c, pairs, &r);
        for (uint32_t p = 0; p < pairs; p++) {
            const uint32_t a = p > 0 ? p - 1 : 2, b = p + 1 < pairs ? p + 1 : p - 2;

            uneven[p] = pov_max(uneven[p], pov_max(r.most[a], r.most[b]) - pov_min(r.least[a], r.least[b]));
        }
    }
}

/* What is left of light that comes from an edge, in the channel where it is most. */
static double left_from(const media_table *t, uint32_t edge)
{
    return elementary_exp(-pov_min(t->depth[0][edge], pov_min(t->depth[1][edge], t->depth[2][edge])));
}

uint64_t matter_uneven(const media_march *l, const media_matter *m)
{
    const double *edge = l->table.strata.edge;
    const uint32_t pairs = l->table.strata.count / 2;
    double uneven[LANES_MAX / 2];
    uint64_t which = 0;

    if (pairs < 3)
        return 0;
    compare_pairs(l->set, &m->of[0], pairs, uneven);
    for (uint32_t p = 0; p < pairs; p++) {
        const double change = uneven[p] * (edge[2 * p + 2] - edge[2 * p]) * l->weight;

        if (change > uneven_light && (!l->set->dims || change * left_from(&l->table, 2 * p) > uneven_light))
            which |= (uint64_t)3 << 2 * p;
    }
    return which;
}

/* ---- splitting ---- */

/* Parts of a stratum, and the first number for points in them. */
enum { PARTS = 4 };
static const uint32_t part_numbers = 1u << 31;

static void put_optics(const media_set *s, const media_optics *from, uint32_t i, media_matter *to, uint32_t k)
{
    media_optics *o = &to->of[k / LANES_MAX];
    const uint32_t lane = k % LANES_MAX;

    for (int c = 0; c < 3; c++) {
        if (s->dims)
            o->loss[c][lane] = from->loss[c][i];
        if (s->shines)
            o->emitted[c][lane] = from->emitted[c][i];
        if (s->scatters)
            o->scatter[c][lane] = from->scatter[c][i];
    }
}

/* Points that are new, and the strata in which they lie. */
typedef struct fresh { uint32_t count; double at[MEDIA_STRATA_MAX]; uint8_t in[MEDIA_STRATA_MAX]; } fresh;

/* A point in each part: that of the stratum in its own. Neighbours lie on opposite sides, as media_jitter() has them. Returns which is
 * the stratum's. */
static uint32_t place_parts(const media_march *l, uint32_t i, double at, double out[PARTS])
{
    const double lo = l->table.strata.edge[i], width = (l->table.strata.edge[i + 1] - lo) / PARTS, u = width > 0.0 ? (at - lo) / width : 0.0;
    const uint32_t own = u < PARTS - 1 ? (uint32_t)u : PARTS - 1, others = (own & 2) ^ 2;
    const double turn = media_number(&l->random, part_numbers + i);

    out[own] = at;
    out[own ^ 1] = lo + width * ((double)(own ^ 1) + 1.0 - (u - (double)own));
    out[others] = lo + width * ((double)others + turn);
    out[others + 1] = lo + width * ((double)(others + 1) + 1.0 - turn);
    return own;
}

/* One stratum's parts, behind those that are there. */
static void put_parts(const media_march *l, const media_matter *m, uint32_t i, media_strata *to, media_matter *out, fresh *f)
{
    const double lo = l->table.strata.edge[i], width = l->table.strata.edge[i + 1] - lo;
    double at[PARTS];
    const uint32_t own = place_parts(l, i, m->at[i], at);

    for (uint32_t q = 0; q < PARTS; q++) {
        const uint32_t k = to->count++;

        to->edge[k] = lo + width * ((double)q / PARTS);
        out->at[k] = at[q];
        if (q == own) {
            put_optics(l->set, &m->of[0], i, out, k);
            continue;
        }
        f->at[f->count] = at[q];
        f->in[f->count++] = (uint8_t)k;
    }
}

static void find_fresh(const media_march *l, const fresh *f, media_matter *out)
{
    media_optics o;

    for (uint32_t first = 0, n; first < f->count; first += n) {
        n = f->count - first < LANES_MAX ? f->count - first : LANES_MAX;
        media_set_at(l->model, l->set, &l->on, f->at + first, n, NULL, &o);
        for (uint32_t i = 0; i < n; i++)
            put_optics(l->set, &o, i, out, f->in[first + i]);
    }
}

void matter_split(media_march *l, const media_matter *m, uint64_t which, media_matter *out)
{
    const media_strata *from = &l->table.strata;
    media_strata to;
    fresh f;

    to.count = f.count = 0;
    for (uint32_t i = 0; i < from->count; i++) {
        if (which >> i & 1) {
            put_parts(l, m, i, &to, out, &f);
            continue;
        }
        to.edge[to.count] = from->edge[i];
        out->at[to.count] = m->at[i];
        put_optics(l->set, &m->of[0], i, out, to.count++);
    }
    to.edge[to.count] = from->edge[from->count];
    l->table.strata = to;
    find_fresh(l, &f, out);
}
