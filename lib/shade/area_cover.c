/* Of a convex solid segments from a point enter a convex set of places: all of a rectangle if its corners are in it. The solid is made
 * smaller by `skin` of its widths. That is more than all roundings, here and of the outline, and than what a place is off by where its point
 * is rounded: what is entered here is entered by the ray. */
#include "shade/area_cover.h"

#include <math.h>

static const double skin = 0x1p-10, roundings = 0x1p-36, clear = 0x1p10, end = 1.0 - 0x1p-8, beyond = 1.0 + 0x1p-8;

static double sum_of(pov_vec3 v) { return fabs(v.x) + fabs(v.y) + fabs(v.z); }

/* The square part of a quadric, times v. */
static pov_vec3 times(const double s[6], pov_vec3 v)
{
    return pov_vec3_of(s[0] * v.x + s[3] * v.y + s[4] * v.z, s[3] * v.x + s[1] * v.y + s[5] * v.z, s[4] * v.x + s[5] * v.y + s[2] * v.z);
}

static double largest_of(const double s[6])
{
    double most = 0.0;

    for (int i = 0; i < 6; i++)
        most = fmax(most, fabs(s[i]));
    return most;
}

/* A point, as the outline has it, the directions, and about how large all of these are. */
typedef struct view { pov_vec3 at, to, axes[2]; double size; } view;

/* False: the slab is too thin. outside: the point certainly is. */
static bool add_slab(area_cover *c, const pov_outline *solid, uint32_t i, const view *v, bool *outside)
{
    const pov_vec3 n = solid->normal[i];
    const double at = pov_dot(n, v->at), off = roundings * sum_of(n) * v->size, thinner = skin * (solid->hi[i] - solid->lo[i]);

    *outside = *outside || at < solid->lo[i] - off || at > solid->hi[i] + off;
    c->lo[i] = solid->lo[i] + thinner - at;
    c->hi[i] = solid->hi[i] - thinner - at;
    c->wide_lo[i] = solid->lo[i] - thinner - at;
    c->wide_hi[i] = solid->hi[i] + thinner - at;
    c->rate[i][0] = pov_dot(n, v->to);
    c->rate[i][1] = pov_dot(n, v->axes[0]);
    c->rate[i][2] = pov_dot(n, v->axes[1]);
    return thinner > off && thinner < HUGE_VAL;
}

static bool add_quadric(area_cover *c, const pov_outline *solid, const view *v, bool *outside)
{
    const double *s = solid->square;
    const pov_vec3 a = times(s, v->axes[0]), b = times(s, v->axes[1]), g = pov_add(times(s, v->at), solid->linear);
    const double at = pov_dot(pov_add(g, solid->linear), v->at) + solid->constant;
    const double off = roundings * v->size * (largest_of(s) * v->size + sum_of(solid->linear));

    *outside = *outside || at > off;
    c->constant = at - skin * solid->constant;
    c->wide_constant = at + skin * solid->constant;
    c->apart = c->wide_constant > clear * off;
    c->along[0] = pov_dot(g, v->to);
    c->along[1] = pov_dot(g, v->axes[0]);
    c->along[2] = pov_dot(g, v->axes[1]);
    c->square[0] = pov_dot(times(s, v->to), v->to);
    c->square[1] = 2.0 * pov_dot(a, v->to);
    c->square[2] = 2.0 * pov_dot(b, v->to);
    c->square[3] = pov_dot(a, v->axes[0]);
    c->square[4] = pov_dot(b, v->axes[1]);
    c->square[5] = 2.0 * pov_dot(a, v->axes[1]);
    return -skin * solid->constant > off;
}

bool area_cover_make(area_cover *c, const pov_outline *solid, pov_vec3 from, pov_vec3 to, const pov_vec3 axes[2])
{
    const view v = { pov_sub(from, solid->centre), to, { axes[0], axes[1] },
                     sum_of(from) + sum_of(solid->centre) + sum_of(to) + sum_of(axes[0]) + sum_of(axes[1]) };
    bool thick = true;

    c->slabs = solid->slabs;
    c->round = solid->round;
    c->outside = c->apart = false;
    for (uint32_t i = 0; i < solid->slabs; i++)
        thick = thick && add_slab(c, solid, i, &v, &c->outside);
    return thick && (!solid->round || add_quadric(c, solid, &v, &c->outside));
}

/* ---- many places ---- */

static uint32_t whole(uint32_t n) { return (n + 7) & ~7u; }

/* Where segments to places are within all slabs: the first and last of it. */
typedef struct SIMD_ALIGNED stretches { double first[AREA_PARTS], last[AREA_PARTS]; } stretches;

SIMD_CLONES static void cut_slab(const double *restrict rate, double lo, double hi, const double *restrict u, const double *restrict v, uint32_t n,
                                 stretches *restrict s)
{
    for (uint32_t i = 0; i < n; i++) {
        const double per = 1.0 / (rate[0] + rate[1] * u[i] + rate[2] * v[i]), a = lo * per, b = hi * per;
        const double near = a < b ? a : b, far = a < b ? b : a;

        s->first[i] = near > s->first[i] ? near : s->first[i];
        s->last[i] = far < s->last[i] ? far : s->last[i];
    }
}

/* There the quadric is least where its slope is zero, or at an end. */
SIMD_CLONES static void cut_quadric(const area_cover *restrict c, const stretches *restrict in, const double *restrict u, const double *restrict v,
                                    uint32_t n, double *restrict hidden)
{
    const double *s = c->square;

    for (uint32_t i = 0; i < n; i++) {
        const double along = c->along[0] + c->along[1] * u[i] + c->along[2] * v[i];
        const double square = s[0] + s[1] * u[i] + s[2] * v[i] + s[3] * u[i] * u[i] + s[4] * v[i] * v[i] + s[5] * u[i] * v[i];
        const double least = -along / square, after = least > in->first[i] ? least : in->first[i], t = after < in->last[i] ? after : in->last[i];
        const double value = c->constant + t * (2.0 * along + t * square);

        hidden[i] = value < 0.0 ? hidden[i] : 0.0;
    }
}

SIMD_CLONES static void set_all(uint32_t n, stretches *restrict s)
{
    for (uint32_t i = 0; i < n; i++) {
        s->first[i] = 0.0;
        s->last[i] = end;
    }
}

SIMD_CLONES static bool keep_some(const stretches *restrict s, uint32_t n, double *restrict hidden)
{
    double any = 0.0;

    for (uint32_t i = 0; i < n; i++) {
        hidden[i] = s->first[i] < s->last[i] ? hidden[i] : 0.0;
        any += hidden[i];
    }
    return any > 0.0;
}

/* Leave those for which segments to these places enter the solid. False: there are none. */
static bool keep_hidden(const area_cover *c, const double *u, const double *v, uint32_t n, double *hidden)
{
    stretches s;

    set_all(n, &s);
    for (uint32_t i = 0; i < c->slabs; i++)
        cut_slab(c->rate[i], c->lo[i], c->hi[i], u, v, n, &s);
    if (c->round)
        cut_quadric(c, &s, u, v, n, hidden);
    return keep_some(&s, n, hidden);
}

static uint64_t bits_of(const double *flag, uint32_t n)
{
    uint64_t bits = 0;

    for (uint32_t i = 0; i < n; i++)
        bits |= (uint64_t)(flag[i] > 0.0) << i;
    return bits;
}

uint64_t area_cover_hides_of(const area_cover *c, const area_parts *p)
{
    const uint32_t n = whole(p->count);
    SIMD_ALIGNED double hidden[AREA_PARTS];
    bool any;

    if (!c->outside)
        return 0;
    for (uint32_t i = 0; i < n; i++)
        hidden[i] = 1.0;
    any = keep_hidden(c, p->lo[0], p->lo[1], n, hidden);
    if (!p->points)
        any = any && keep_hidden(c, p->hi[0], p->lo[1], n, hidden) && keep_hidden(c, p->lo[0], p->hi[1], n, hidden) &&
              keep_hidden(c, p->hi[0], p->hi[1], n, hidden);
    return any ? bits_of(hidden, p->count) : 0;
}

/* ---- what passes a solid ---- */

/* Middles and half widths of parts. */
typedef struct SIMD_ALIGNED middles { double u[AREA_PARTS], v[AREA_PARTS], broad[AREA_PARTS], high[AREA_PARTS]; } middles;

SIMD_CLONES static void find_middles(const area_parts *restrict p, uint32_t n, middles *restrict m)
{
    for (uint32_t i = 0; i < n; i++) {
        m->u[i] = 0.5 * (p->lo[0][i] + p->hi[0][i]);
        m->v[i] = 0.5 * (p->lo[1][i] + p->hi[1][i]);
        m->broad[i] = 0.5 * (p->hi[0][i] - p->lo[0][i]);
        m->high[i] = 0.5 * (p->hi[1][i] - p->lo[1][i]);
    }
}

/* A slab lo <= t (rate . (1, u, v)) <= hi, where hi is not below zero: no segment to a part is within before `first` or after `last`. */
SIMD_CLONES static void cut_parts(const double *restrict rate, double lo, double hi, const middles *restrict m, uint32_t n, stretches *restrict s)
{
    const double off = roundings * (fabs(rate[0]) + fabs(rate[1]) + fabs(rate[2])), ahead = lo > 0.0 ? lo : 0.0, never = lo > 0.0 ? HUGE_VAL : 0.0;

    for (uint32_t i = 0; i < n; i++) {
        const double at = rate[0] + rate[1] * m->u[i] + rate[2] * m->v[i], wide = fabs(rate[1]) * m->broad[i] + fabs(rate[2]) * m->high[i] + off;
        const double least = at - wide, most = at + wide, back = most < 0.0 ? lo / most : HUGE_VAL;
        const double first = most > 0.0 ? ahead / most : never, last = least > 0.0 ? hi / least : back;

        s->first[i] = first > s->first[i] ? first : s->first[i];
        s->last[i] = last < s->last[i] ? last : s->last[i];
    }
}

static void cut_parts_by(const area_cover *c, uint32_t slab, const middles *m, uint32_t n, stretches *s)
{
    const double *r = c->rate[slab], back[3] = { -r[0], -r[1], -r[2] };

    if (c->wide_hi[slab] < 0.0)
        cut_parts(back, -c->wide_hi[slab], -c->wide_lo[slab], m, n, s);
    else
        cut_parts(r, c->wide_lo[slab], c->wide_hi[slab], m, n, s);
}

/* Lines to all of a part pass the quadric where (b . (1, u, v))^2 - constant (square . (1, u, v, u u, v v, u v)) is below zero all over it: there
 * is most of it at the middle, and by its slopes and curves there. */
SIMD_CLONES static void pass_quadric(const area_cover *restrict c, const middles *restrict m, uint32_t n, double *restrict missed)
{
    const double *b = c->along, *s = c->square, by = c->wide_constant;
    const double one = b[0] * b[0] - by * s[0], u = 2.0 * b[0] * b[1] - by * s[1], v = 2.0 * b[0] * b[2] - by * s[2];
    const double uu = b[1] * b[1] - by * s[3], vv = b[2] * b[2] - by * s[4], uv = 2.0 * b[1] * b[2] - by * s[5];
    const double sum = fabs(b[0]) + fabs(b[1]) + fabs(b[2]), squares = fabs(s[0]) + fabs(s[1]) + fabs(s[2]) + fabs(s[3]) + fabs(s[4]) + fabs(s[5]);
    const double off = roundings * (sum * sum + by * squares), bent_u = uu > 0.0 ? uu : 0.0, bent_v = vv > 0.0 ? vv : 0.0, turned = fabs(uv);

    for (uint32_t i = 0; i < n; i++) {
        const double x = m->u[i], y = m->v[i], broad = m->broad[i], high = m->high[i];
        const double middle = one + x * (u + uu * x + uv * y) + y * (v + vv * y);
        const double slope = fabs(u + 2.0 * uu * x + uv * y) * broad + fabs(v + 2.0 * vv * y + uv * x) * high;
        const double most = middle + slope + bent_u * broad * broad + bent_v * high * high + turned * broad * high;

        missed[i] = most < -off ? 1.0 : missed[i];
    }
}

SIMD_CLONES static void pass_slabs(const stretches *restrict s, uint32_t n, double *restrict missed)
{
    for (uint32_t i = 0; i < n; i++)
        missed[i] = s->first[i] > s->last[i] ? 1.0 : s->first[i] > beyond ? 1.0 : missed[i];
}

uint64_t area_cover_misses_of(const area_cover *c, const area_parts *p)
{
    const uint32_t n = whole(p->count);
    SIMD_ALIGNED double missed[AREA_PARTS];
    stretches s;
    middles m;

    find_middles(p, n, &m);
    for (uint32_t i = 0; i < n; i++) {
        missed[i] = s.first[i] = 0.0;
        s.last[i] = HUGE_VAL;
    }
    for (uint32_t i = 0; i < c->slabs; i++)
        cut_parts_by(c, i, &m, n, &s);
    if (c->slabs > 0)
        pass_slabs(&s, n, missed);
    if (c->round && c->apart)
        pass_quadric(c, &m, n, missed);
    return bits_of(missed, p->count);
}

/* ---- one part ---- */

static area_parts one_part(const grid_part *part)
{
    area_parts one = { .count = 1 };

    for (int axis = 0; axis < 2; axis++)
        for (uint32_t i = 0; i < whole(1); i++) {
            one.lo[axis][i] = part->lo[axis];
            one.hi[axis][i] = part->hi[axis];
        }
    return one;
}

bool area_cover_hides(const area_cover *c, const grid_part *part)
{
    const area_parts one = one_part(part);

    return area_cover_hides_of(c, &one) != 0;
}

bool area_cover_misses(const area_cover *c, const grid_part *part)
{
    const area_parts one = one_part(part);

    return area_cover_misses_of(c, &one) != 0;
}

/* ---- parts of a grid ---- */

void area_parts_find(const light_grid *g, uint32_t k, area_parts *out)
{
    out->count = g->count - k < AREA_PARTS ? g->count - k : AREA_PARTS;
    out->points = !g->moves;
    for (uint32_t i = 0; i < whole(out->count); i++) {
        const grid_part p = grid_place(g, k + (i < out->count ? i : 0));

        for (int axis = 0; axis < 2; axis++) {
            out->lo[axis][i] = p.lo[axis];
            out->hi[axis][i] = p.hi[axis];
        }
    }
}

SIMD_CLONES static void overlap(const area_parts *restrict p, const grid_part *restrict other, uint32_t n, double *restrict out)
{
    for (uint32_t i = 0; i < n; i++)
        out[i] = (p->lo[0][i] <= other->hi[0]) & (other->lo[0] <= p->hi[0][i]) & (p->lo[1][i] <= other->hi[1]) & (other->lo[1] <= p->hi[1][i])
                     ? 1.0 : 0.0;
}

uint64_t area_parts_overlap(const area_parts *p, const grid_part *other)
{
    SIMD_ALIGNED double out[AREA_PARTS];

    overlap(p, other, whole(p->count), out);
    return bits_of(out, p->count);
}
