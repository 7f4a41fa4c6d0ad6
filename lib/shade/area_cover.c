/* Of a convex solid segments from a point enter a convex set of places: all of a rectangle if its corners are in it. The solid is made
 * smaller by `skin` of its widths. That is more than all roundings, here and of the outline, and than what a place is off by where its point
 * is rounded: what is entered here is entered by the ray. */
#include "shade/area_cover.h"

#include "base/lane_mask.h"
#include "base/vec3.h"

#include <math.h>
#include <string.h>

static const double skin = 0x1p-10, roundings = 0x1p-36, clear = 0x1p10, end = 1.0 - 0x1p-8, beyond = 1.0 + 0x1p-8;

/* The square part of a quadric, times v. */
static pov_vec3 times(const double s[6], pov_vec3 v)
{
    return pov_vec3_of(s[0] * v.x + s[3] * v.y + s[4] * v.z, s[3] * v.x + s[1] * v.y + s[5] * v.z, s[4] * v.x + s[5] * v.y + s[2] * v.z);
}

static double largest_of(const double s[6])
{
    double most = 0.0;

    for (int i = 0; i < 6; i++)
        most = pov_max(most, fabs(s[i]));
    return most;
}

/* A point, as the outline has it, the directions, and about how large all of these are. */
typedef struct view { pov_vec3 at, to, axes[2]; double size; } view;

/* False: the slab is too thin. outside: the point certainly is. */
static bool add_slab(area_cover *c, const pov_outline *solid, uint32_t i, const view *v, bool *outside)
{
    const pov_vec3 n = solid->normal[i];
    const double at = pov_dot(n, v->at), off = roundings * vec3_sum(n) * v->size, thinner = skin * (solid->hi[i] - solid->lo[i]);

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
    const double off = roundings * v->size * (largest_of(s) * v->size + vec3_sum(solid->linear));

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
                     vec3_sum(from) + vec3_sum(solid->centre) + vec3_sum(to) + vec3_sum(axes[0]) + vec3_sum(axes[1]) };
    bool thick = true;

    c->slabs = solid->slabs;
    c->round = solid->round;
    c->outside = c->apart = false;
    for (uint32_t i = 0; i < solid->slabs; i++)
        thick = thick && add_slab(c, solid, i, &v, &c->outside);
    return thick && (!solid->round || add_quadric(c, solid, &v, &c->outside));
}

/* ---- parts side by side ---- */

enum { TOGETHER = 8 };
typedef double lane[TOGETHER];

/* Some parts, and where segments to them are within all slabs: the first and last of it. */
typedef struct SIMD_ALIGNED some_parts { lane lo[2], hi[2], first, last, flag; } some_parts;

static uint32_t whole(uint32_t n) { return (n + AREA_TOGETHER - 1) / AREA_TOGETHER * AREA_TOGETHER; }

SIMD_INLINE void take(const area_parts *restrict p, uint32_t from, some_parts *restrict out)
{
    for (int axis = 0; axis < 2; axis++) {
        memcpy(out->lo[axis], p->lo[axis] + from, sizeof(lane));
        memcpy(out->hi[axis], p->hi[axis] + from, sizeof(lane));
    }
}

SIMD_INLINE void set_flags(double to, double *restrict flag)
{
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        flag[i] = to;
}

SIMD_INLINE void put_flags(const double *restrict flag, uint32_t *restrict out)
{
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        out[i] = flag[i] > 0.0 ? 1 : 0;
}

/* ---- what a solid hides ---- */

SIMD_INLINE void cut_slab(const double *restrict rate, double lo, double hi, const double *restrict u, const double *restrict v, double *restrict first,
                          double *restrict last)
{
    const double one = rate[0], by_u = rate[1], by_v = rate[2];

    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double per = 1.0 / (one + by_u * u[i] + by_v * v[i]), a = lo * per, b = hi * per;
        const double near = a < b ? a : b, far = a < b ? b : a;

        first[i] = near > first[i] ? near : first[i];
        last[i] = far < last[i] ? far : last[i];
    }
}

/* There the quadric is least where its slope is zero, or at an end. */
SIMD_INLINE void cut_quadric(const area_cover *c, const double *restrict u, const double *restrict v, const double *restrict first,
                             const double *restrict last, double *restrict hidden)
{
    const double constant = c->constant, one = c->along[0], by_u = c->along[1], by_v = c->along[2];
    const double s = c->square[0], s_u = c->square[1], s_v = c->square[2], s_uu = c->square[3], s_vv = c->square[4], s_uv = c->square[5];

    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double along = one + by_u * u[i] + by_v * v[i];
        const double square = s + s_u * u[i] + s_v * v[i] + s_uu * u[i] * u[i] + s_vv * v[i] * v[i] + s_uv * u[i] * v[i];
        const double least = -along / square, after = least > first[i] ? least : first[i], t = after < last[i] ? after : last[i];
        const double value = constant + t * (2.0 * along + t * square);

        hidden[i] = value < 0.0 ? hidden[i] : 0.0;
    }
}

/* Leave those for which segments to these places enter the solid. */
SIMD_INLINE void keep_hidden(const area_cover *c, const double *restrict u, const double *restrict v, some_parts *restrict io)
{
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        io->first[i] = 0.0;
        io->last[i] = end;
    }
    for (uint32_t i = 0; i < c->slabs; i++)
        cut_slab(c->rate[i], c->lo[i], c->hi[i], u, v, io->first, io->last);
    if (c->round)
        cut_quadric(c, u, v, io->first, io->last, io->flag);
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        io->flag[i] = io->first[i] < io->last[i] ? io->flag[i] : 0.0;
}

SIMD_CLONES SIMD_NOINLINE static uint64_t find_hidden(const area_cover *c, const area_parts *p, uint64_t which)
{
    SIMD_ALIGNED uint32_t hidden[AREA_PARTS] = { 0 };

    for (uint32_t from = 0; from < p->count; from += TOGETHER) {
        some_parts s;

        if (!(which >> from & ((1u << TOGETHER) - 1)))
            continue;
        take(p, from, &s);
        set_flags(1.0, s.flag);
        keep_hidden(c, s.lo[0], s.lo[1], &s);
        if (!p->points) {
            keep_hidden(c, s.hi[0], s.lo[1], &s);
            keep_hidden(c, s.lo[0], s.hi[1], &s);
            keep_hidden(c, s.hi[0], s.hi[1], &s);
        }
        put_flags(s.flag, hidden + from);
    }
    return lane_mask_of(hidden, p->count) & which;
}

uint64_t area_cover_hides_of(const area_cover *c, const area_parts *p, uint64_t which) { return c->outside ? find_hidden(c, p, which) : 0; }

/* ---- what misses a solid ---- */

/* Parts by their middles and half widths. */
SIMD_INLINE void find_middles(some_parts *restrict io)
{
    for (int axis = 0; axis < 2; axis++)
        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
            const double lo = io->lo[axis][i], hi = io->hi[axis][i];

            io->lo[axis][i] = 0.5 * (lo + hi);
            io->hi[axis][i] = 0.5 * (hi - lo);
        }
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        io->first[i] = 0.0;
        io->last[i] = HUGE_VAL;
    }
}

/* A slab lo <= t (rate . (1, u, v)) <= hi, where hi is not below zero: no segment to a part is within before `first` or after `last`. */
SIMD_INLINE void pass_slab(const double *restrict rate, double lo, double hi, some_parts *restrict io)
{
    const double off = roundings * (fabs(rate[0]) + fabs(rate[1]) + fabs(rate[2]));
    const double one = rate[0], by_u = rate[1], by_v = rate[2], broad = fabs(by_u), high = fabs(by_v);
    SIMD_ALIGNED lane most;

    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double at = one + by_u * io->lo[0][i] + by_v * io->lo[1][i], wide = broad * io->hi[0][i] + high * io->hi[1][i] + off, least = at - wide;
        const double height = least > 0.0 ? hi : lo, slope = least > 0.0 ? least : at + wide, t = height / slope;
        const double last = least > 0.0 ? t : slope < 0.0 ? t : HUGE_VAL;

        most[i] = at + wide;
        io->last[i] = last < io->last[i] ? last : io->last[i];
    }
    if (!(lo > 0.0))
        return;
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double t = lo / most[i], first = most[i] > 0.0 ? t : HUGE_VAL;

        io->first[i] = first > io->first[i] ? first : io->first[i];
    }
}

SIMD_INLINE void pass_slabs(const area_cover *c, some_parts *restrict io)
{
    for (uint32_t i = 0; i < c->slabs; i++) {
        const double side = c->wide_hi[i] < 0.0 ? -1.0 : 1.0, *r = c->rate[i], rate[3] = { side * r[0], side * r[1], side * r[2] };

        pass_slab(rate, side < 0.0 ? -c->wide_hi[i] : c->wide_lo[i], side < 0.0 ? -c->wide_lo[i] : c->wide_hi[i], io);
    }
    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++)
        io->flag[i] = io->first[i] > io->last[i] ? 1.0 : io->first[i] > beyond ? 1.0 : 0.0;
}

/* A quadric in u and v, with a margin. */
typedef struct discriminant { double one, u, v, uu, vv, uv, off; } discriminant;

/* Below zero the lines miss the cover's quadric: (along . (1, u, v))^2 - constant (square . (1, u, v, u u, v v, u v)). */
static discriminant discriminant_of(const area_cover *c)
{
    const double *b = c->along, *s = c->square, by = c->wide_constant, sum = fabs(b[0]) + fabs(b[1]) + fabs(b[2]);
    const double squares = fabs(s[0]) + fabs(s[1]) + fabs(s[2]) + fabs(s[3]) + fabs(s[4]) + fabs(s[5]);

    return (discriminant){ b[0] * b[0] - by * s[0], 2.0 * b[0] * b[1] - by * s[1], 2.0 * b[0] * b[2] - by * s[2], b[1] * b[1] - by * s[3],
                   b[2] * b[2] - by * s[4], 2.0 * b[1] * b[2] - by * s[5], roundings * (sum * sum + by * squares) };
}

/* The most of it in a part is that at the middle, and by its slopes and curves there. */
SIMD_INLINE void pass_quadric(const discriminant *restrict q, some_parts *restrict io)
{
    const double one = q->one, u = q->u, v = q->v, uu = q->uu, vv = q->vv, uv = q->uv, off = q->off;
    const double bent_u = uu > 0.0 ? uu : 0.0, bent_v = vv > 0.0 ? vv : 0.0, turned = fabs(uv);

    SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
        const double x = io->lo[0][i], y = io->lo[1][i], broad = io->hi[0][i], high = io->hi[1][i];
        const double middle = one + x * (u + uu * x + uv * y) + y * (v + vv * y);
        const double slope = fabs(u + 2.0 * uu * x + uv * y) * broad + fabs(v + 2.0 * vv * y + uv * x) * high;
        const double most = middle + slope + bent_u * broad * broad + bent_v * high * high + turned * broad * high;

        io->flag[i] = most < -off ? 1.0 : io->flag[i];
    }
}

SIMD_CLONES uint64_t area_cover_misses_of(const area_cover *c, const area_parts *p, uint64_t which)
{
    const bool round = c->round && c->apart;
    const discriminant q = discriminant_of(c);
    SIMD_ALIGNED uint32_t missed[AREA_PARTS] = { 0 };

    for (uint32_t from = 0; from < p->count; from += TOGETHER) {
        some_parts s;

        if (!(which >> from & ((1u << TOGETHER) - 1)))
            continue;
        take(p, from, &s);
        set_flags(0.0, s.flag);
        find_middles(&s);
        if (c->slabs > 0)
            pass_slabs(c, &s);
        if (round)
            pass_quadric(&q, &s);
        put_flags(s.flag, missed + from);
    }
    return lane_mask_of(missed, p->count) & which;
}

/* ---- one part ---- */

area_parts area_parts_of(const grid_part *part)
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
    const area_parts one = area_parts_of(part);

    return area_cover_hides_of(c, &one, 1) != 0;
}

bool area_cover_misses(const area_cover *c, const grid_part *part)
{
    const area_parts one = area_parts_of(part);

    return area_cover_misses_of(c, &one, 1) != 0;
}

/* ---- a solid that is left late ---- */

/* Bounds of number . (1, u, v) over a part. */
static void bound(const double number[3], const grid_part *p, double out[2])
{
    const double off = roundings * (fabs(number[0]) + fabs(number[1]) + fabs(number[2]));

    out[0] = number[0] - off;
    out[1] = number[0] + off;
    for (int axis = 0; axis < 2; axis++) {
        const double a = number[1 + axis] * p->lo[axis], b = number[1 + axis] * p->hi[axis];

        out[0] += pov_min(a, b);
        out[1] += pov_max(a, b);
    }
}

/* When all have left its slabs at the latest, from within. */
static double latest(const area_cover *c, const grid_part *p)
{
    double last = HUGE_VAL, rate[2];

    for (uint32_t i = 0; i < c->slabs; i++) {
        bound(c->rate[i], p, rate);
        last = rate[0] > 0.0 ? pov_min(last, c->wide_hi[i] / rate[0]) : rate[1] < 0.0 ? pov_min(last, c->wide_lo[i] / rate[1]) : last;
    }
    return last;
}

/* When the first can leave a slab that it is within, and when the quadric: its root is -2 along / square from a start on it, but for what little
 * that is off, and more from within. */
static double earliest(const area_cover *c, const grid_part *p)
{
    const double *s = c->square;
    const double most_u = pov_max(fabs(p->lo[0]), fabs(p->hi[0])), most_v = pov_max(fabs(p->lo[1]), fabs(p->hi[1]));
    const double more = fabs(s[1]) * most_u + fabs(s[2]) * most_v + fabs(s[3]) * most_u * most_u + fabs(s[4]) * most_v * most_v + fabs(s[5]) * most_u * most_v;
    const double square = s[0] + more + roundings * (fabs(s[0]) + more);
    double first = HUGE_VAL, rate[2], along[2];

    for (uint32_t i = 0; i < c->slabs; i++) {
        bound(c->rate[i], p, rate);
        if (rate[1] > 0.0)
            first = pov_min(first, c->hi[i] / rate[1]);
        if (rate[0] < 0.0)
            first = pov_min(first, c->lo[i] / rate[0]);
    }
    bound(c->along, p, along);
    if (!(along[1] < 0.0 && square > 0.0 && c->constant * square < (1.0 - end) * along[1] * along[1]))
        return 0.0;
    return pov_min(first, -2.0 * end * along[1] / square);
}

bool area_cover_holds(const area_cover *c, const area_cover *other, const grid_part *part)
{
    return c->round && latest(other, part) < end * earliest(c, part);
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

SIMD_CLONES SIMD_NOINLINE static void find_overlap(const area_parts *restrict p, const grid_part *restrict other, uint32_t n, uint32_t *restrict out)
{
    const double lo_u = other->lo[0], hi_u = other->hi[0], lo_v = other->lo[1], hi_v = other->hi[1];

    for (uint32_t i = 0; i < n; i++)
        out[i] = (p->lo[0][i] <= hi_u) & (lo_u <= p->hi[0][i]) & (p->lo[1][i] <= hi_v) & (lo_v <= p->hi[1][i]);
}

uint64_t area_parts_overlap(const area_parts *p, const grid_part *other)
{
    SIMD_ALIGNED uint32_t out[AREA_PARTS];

    find_overlap(p, other, whole(p->count), out);
    return lane_mask_of(out, p->count);
}
