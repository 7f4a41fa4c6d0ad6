/* lathe { [spline] n, <radius, height>, ... [sturm] }: a curve turned about the y axis.
 *
 * Where the ray o + s d has the height y(u), its distance to the axis is to be |r(u)|. Multiplied by the square of d.y that
 * is a polynomial in u of the order 2, 4 or 6, without a division; its Bernstein coefficients are sums of three products.
 * A ray that hardly rises can meet only those stretches of the curve that are at its height. There s is a polynomial in u without
 * cancellation. Of a ray that rises less still, the height alone gives u, and the radius gives both distances. */
#include "common/bernstein.h"
#include "common/curve.h"
#include "common/revolved.h"
#include "common/sides.h"
#include "common/turns.h"

#include <string.h>

enum { ORDER = COMMON_TURNED_ORDER };
typedef common_turned part;

typedef struct lathe {
    common_outline outline;
    part *parts;
    common_turned_block *blocks;
    common_boxed boxed;
    common_revolved filter;        /* of straight pieces; else empty */
    double wide, high;             /* half a box about the anchor, scaled */
    common_sides sides;
    bool open;
} lathe;

/* ---- loading ---- */

/* Ends on the axis, and those that another piece shares, leave no gap. */
static bool is_joined(const lathe *l, uint32_t piece, uint32_t end)
{
    const common_piece *c = &l->outline.at[piece];
    const double x = c->x[end], y = c->y[end];

    if (x == 0.0)
        return true;
    for (uint32_t i = 0; i < l->outline.count; i++) {
        const common_piece *o = &l->outline.at[i];
        const uint32_t n = o->degree;

        if ((o->x[0] == x && o->y[0] == y && !(i == piece && end == 0)) || (o->x[n] == x && o->y[n] == y && !(i == piece && end == n)))
            return true;
    }
    return false;
}

static void find_gaps(lathe *l)
{
    for (uint32_t i = 0; i < l->outline.count; i++)
        l->open |= l->outline.count < 4096 && (!is_joined(l, i, 0) || !is_joined(l, i, l->outline.at[i].degree));
}

/* Nearer to the axis than all of the curve is outside; of bezier splines their points count, as in POV-Ray. */
static void take_in_points(common_outline *o)
{
    for (uint32_t i = 0; i < o->count; i++)
        for (uint32_t k = 0; k <= o->at[i].degree; k++)
            o->lo[0] = pov_min(o->lo[0], o->at[i].x[k]);
}

static void pack(lathe *l, const pov_host *host, pov_reader *in)
{
    const uint32_t count = l->outline.count, lanes = COMMON_TURNED_LANES;

    l->blocks = host->alloc(in, (count + lanes - 1) / lanes * sizeof *l->blocks);
    for (uint32_t i = 0; l->parts && l->blocks && i < count; i += lanes)
        common_turned_pack(&l->parts[i], count - i, &l->blocks[i / lanes]);
}

static void place(lathe *l, common_spline kind, const pov_host *host, pov_reader *in)
{
    double middle[2] = { 0.0, 0.0 };

    common_outline_bound(&l->outline);
    middle[1] = 0.5 * (l->outline.lo[1] + l->outline.hi[1]);
    l->wide = pov_max(fabs(l->outline.lo[0]), fabs(l->outline.hi[0]));
    l->high = 0.5 * (l->outline.hi[1] - l->outline.lo[1]);
    l->boxed.scale = pov_inverse_power(pov_max(l->wide, l->high));
    l->wide *= l->boxed.scale;
    l->high *= l->boxed.scale;
    l->boxed.anchor.y.hi = middle[1];
    l->boxed.lo = pov_vec3_of(-l->wide, -l->high, -l->wide);
    l->boxed.hi = pov_vec3_of(l->wide, l->high, l->wide);
    common_outline_place(&l->outline, middle, l->boxed.scale);
    if (kind == COMMON_BEZIER)
        take_in_points(&l->outline);
    find_gaps(l);
    common_sides_find(&l->sides, &l->outline, host, in);
    l->parts = host->alloc(in, l->outline.count * sizeof *l->parts);
    for (uint32_t i = 0; l->parts && i < l->outline.count; i++)
        common_turned_make(&l->parts[i], &l->outline.at[i]);
    pack(l, host, in);
    common_revolved_outline(&l->filter, &l->outline, host, in);
}

static void add_pieces(lathe *l, const pov_host *host, pov_reader *in, common_spline kind, double (*at)[2], uint32_t n)
{
    const uint32_t first = kind == COMMON_QUADRATIC || kind == COMMON_CUBIC ? 1 : 0, step = kind == COMMON_BEZIER ? 4 : 1;
    const uint32_t behind = kind == COMMON_BEZIER ? 3 : kind == COMMON_CUBIC ? 2 : 1;

    if (n < first + behind + 1 || (kind == COMMON_BEZIER && n % 4 != 0)) {
        host->fail(in, kind == COMMON_BEZIER ? "a lathe of bezier splines needs four points a piece"
                                             : "a lathe of this spline needs at least %u points",
                   (unsigned)(first + behind + 1));
        return;
    }
    for (uint32_t i = first; i + behind < n; i += step) {
        const common_piece c = common_spline_piece(kind, (const double (*)[2])at + i);

        common_outline_add(&l->outline, host, in, &c);
    }
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    lathe *l = self;
    common_spline kind = COMMON_LINEAR;
    double (*at)[2];
    uint32_t n;

    common_spline_read(host, in, &kind);
    at = common_points_read(host, in, &n);
    if (at)
        add_pieces(l, host, in, kind, at, n);
    common_sturm_read(host, in);
    if (l->outline.count > 0)
        place(l, kind, host, in);
}

static bool bounds(const void *self, pov_box *out)
{
    const lathe *l = self;
    const double back = common_inverse(l->boxed.scale), wide = common_above(l->wide * back), high = l->high * back;

    out->lo = pov_vec3_of(-wide, common_below(l->boxed.anchor.y.hi - high), -wide);
    out->hi = pov_vec3_of(wide, common_above(l->boxed.anchor.y.hi + high), wide);
    return true;
}

/* ---- along a ray ---- */

/* The ray from its point nearest to the axis, along a direction of length one. */
typedef struct line {
    pov_vec3 o, d;
    double a, b, c;              /* the square of the distance to the axis: a s^2 + 2 b s + c */
    double base, unit;           /* s to distance: base + s unit */
    common_span span;            /* in s */
    double per_height, foot;     /* 1 / d.y; where it is nearest to the axis */
} line;

/* Rays that rise less than this are level; less than that, stretches of the curve are cut out first, with BESIDE_BOX of the ray before
 * and behind the box. */
static const double LEVEL = 0x1p-40, SLOW = 0x1p-6, BESIDE_BOX = 0.25, NEAR = 0x1p-30, BESIDE_START = 0x1p-10;

static void make_line(line *n, const common_ray *k, common_span span)
{
    const pov_vec3 f = pov_two3_hi(k->f);
    const double across = k->d.x * k->d.x + k->d.z * k->d.z;

    n->base = across > 0.0 ? -(f.x * k->d.x + f.z * k->d.z) / across : span.lo;
    n->base = pov_min(pov_max(n->base, span.lo), span.hi);
    n->unit = 1.0 / sqrt(pov_dot(k->d, k->d));
    n->o = common_along(k, n->base);
    n->d = pov_scale(k->d, n->unit);
    n->a = n->d.x * n->d.x + n->d.z * n->d.z;
    n->b = n->o.x * n->d.x + n->o.z * n->d.z;
    n->c = n->o.x * n->o.x + n->o.z * n->o.z;
    n->span.lo = (span.lo - n->base) / n->unit;
    n->span.hi = (span.hi - n->base) / n->unit;
    n->per_height = 1.0 / n->d.y;
    n->foot = n->a > 0.0 ? -n->b / n->a : 0.0;
}

static inline double lesser(double a, double b) { return a < b ? a : b; }
static inline double greater(double a, double b) { return a > b ? a : b; }

/* Does the line come near enough to the axis at the heights of the part? */
static bool may_cross(const line *n, const part *p)
{
    const double s = (p->low - n->o.y) * n->per_height, t = (p->high - n->o.y) * n->per_height;
    double lo = greater(lesser(s, t), n->span.lo), hi = lesser(greater(s, t), n->span.hi), nearest;

    if (!(fabs(n->per_height) < HUGE_VAL)) {
        lo = n->span.lo;
        hi = n->span.hi;
        if (n->o.y < p->low || n->o.y > p->high)
            return false;
    }
    if (!(lo <= hi + 0x1p-30))
        return false;
    nearest = n->a > 0.0 ? lesser(greater(n->foot, lo), hi) : lo;
    return (n->a * nearest + 2.0 * n->b) * nearest + n->c <= p->widest * (1.0 + 0x1p-30) + 0x1p-60;
}

/* Newton's method for height and radius together, from s and u, which change by less than REFINED. */
static const double REFINED = 0x1p-9;

static void refine(const line *n, const part *p, double most, common_cross *at)
{
    for (int turn = 0; turn < 2; turn++) {
        double v[2], slope[2], height, radius, radial, det, ds, du;

        common_piece_at(&p->curve, at->u, v, slope);
        height = n->o.y + at->s * n->d.y - v[1];
        radius = (n->a * at->s + 2.0 * n->b) * at->s + n->c - v[0] * v[0];
        radial = 2.0 * (n->a * at->s + n->b);
        det = 2.0 * v[0] * slope[0] * -n->d.y + slope[1] * radial;
        ds = (2.0 * v[0] * slope[0] * height - slope[1] * radius) / det;
        du = (radial * height - n->d.y * radius) / det;
        if (!(fabs(ds) < most && fabs(du) < 0x1p-10))
            return;
        at->s += ds;
        at->u += du;
    }
}

/* A piece by its equation, in lane `lane`. `start`: NULL, or where on the piece the ray starts, which is left out. */
static void cross_risen(const line *n, const part *p, uint32_t piece, const common_turned_equations *all, uint32_t lane, double noise,
                        const double *start, common_cross *out, uint32_t *count)
{
    double b[ORDER + 1], q[ORDER], root[ORDER];
    uint32_t found;

    for (int k = 0; k <= p->order; k++)
        b[k] = all->b[k][lane];
    if (start)
        common_bernstein_divide(b, p->order, *start, q);
    found = start ? common_bernstein_roots(q, p->order - 1, p->order * noise, root) : common_bernstein_roots(b, p->order, noise, root);
    for (uint32_t i = 0; i < found; i++) {
        common_cross at = { 0.0, root[i], piece };
        double v[2], slope[2];

        common_piece_at(&p->curve, at.u, v, slope);
        at.s = (v[1] - n->o.y) / n->d.y;
        out[(*count)++] = at;
    }
}

/* All pieces, some at a time. */
static void cross_all_risen(const lathe *l, const line *n, uint32_t origin, const double *start, common_cross *out, uint32_t *count)
{
    const double square = n->d.y * n->d.y, linear = 2.0 * (n->b * n->d.y - n->a * n->o.y);
    const double rest = (n->a * n->o.y - 2.0 * n->b * n->d.y) * n->o.y + square * n->c;
    const double noise = 0x1p-51 * (n->a + fabs(linear) + fabs(rest) + square);
    const common_turned_line of = { n->a, n->b, n->c, n->o.y, n->per_height, n->foot, n->span.lo, n->span.hi, linear, rest, square };

    for (uint32_t first = 0; first < l->outline.count; first += COMMON_TURNED_LANES) {
        common_turned_equations all;

        for (uint32_t left = common_turned_find(&l->blocks[first / COMMON_TURNED_LANES], l->parts->order, &of, &all); left; left &= left - 1) {
            const uint32_t lane = common_first_lane(left), i = first + lane;

            cross_risen(n, &l->parts[i], i, &all, lane, noise, i == origin ? start : NULL, out, count);
        }
    }
}

/* ---- of a ray that hardly rises ---- */

/* The coefficients of a piece's stretch. */
static void cut_out(const double *b, int degree, double from, double to, double *out)
{
    for (int k = 0; k <= degree; k++) {
        double w[4];

        memcpy(w, b, sizeof w);
        for (int j = 0; j < degree; j++)
            for (int i = 0; i < degree - j; i++)
                w[i] += (w[i + 1] - w[i]) * (j < degree - k ? from : to);
        out[k] = w[0];
    }
    out[degree] = to == 1.0 ? b[degree] : out[degree];
}

/* 0, where the curve has one of two heights, and 1; returns how many stretches that are. */
static uint32_t find_cuts(const part *p, double low, double high, double cut[8])
{
    const int degree = (int)p->curve.degree;
    const double levels[2] = { low, high };
    uint32_t count = 1;

    cut[0] = 0.0;
    for (int level = 0; level < 2; level++) {
        double b[4], root[3];
        uint32_t found, at;

        for (int k = 0; k <= degree; k++)
            b[k] = p->curve.y[k] - levels[level];
        found = common_bernstein_roots(b, degree, common_bernstein_noise(b, degree), root);
        for (uint32_t i = 0; i < found; i++) {
            for (at = count++; cut[at - 1] > root[i]; at--)
                cut[at] = cut[at - 1];
            cut[at] = root[i];
        }
    }
    cut[count] = 1.0;
    return count;
}

/* The equation over a stretch, with s for the height. Ends of pieces that touch have the same bits. Returns its noise. */
static double stretch_equation(const line *n, const part *p, double from, double to, double *b)
{
    static const double ones[4] = { 1.0, 1.0, 1.0, 1.0 };
    const int degree = (int)p->curve.degree;
    double x[4], y[4], s[ORDER + 1], s_square[ORDER + 1], r_square[ORDER + 1], sum = 0.0;

    cut_out(p->curve.x, degree, from, to, x);
    cut_out(p->curve.y, degree, from, to, y);
    for (int k = 0; k <= degree; k++)
        y[k] = (y[k] - n->o.y) * n->per_height;
    common_turned_multiply(degree, y, ones, s);
    common_turned_multiply(degree, y, y, s_square);
    common_turned_multiply(degree, x, x, r_square);
    for (int k = 0; k <= 2 * degree; k++) {
        b[k] = n->a * s_square[k] + 2.0 * n->b * s[k] + (n->c - r_square[k]);
        sum = greater(sum, n->a * fabs(s_square[k]) + 2.0 * fabs(n->b * s[k]) + fabs(n->c) + fabs(r_square[k]));
    }
    for (int end = 0; end <= degree; end += degree)
        b[2 * end] = (n->a * y[end] + 2.0 * n->b) * y[end] + (n->c - x[end] * x[end]);
    return 0x1p-50 * sum + 0x1p-53 * fabs(n->per_height);
}

/* Of a stretch that is this short and rises all the way, powers of its length above the second do not count. */
static const double SHORT = 0x1p-14;

static bool is_short(const part *p, double from, double to, double rise)
{
    double v[2], w[2], slope[2];

    if (!(from > 0.0 && to < 1.0 && to - from < SHORT))
        return false;
    common_piece_at(&p->curve, from, v, slope);
    common_piece_at(&p->curve, to, w, slope);
    return fabs(w[1] - v[1]) > 0.9 * rise;
}

static double bend_at(const double *b, uint32_t degree, double u)
{
    const double first = degree > 1 ? b[0] - 2.0 * b[1] + b[2] : 0.0;

    return degree < 3 ? 2.0 * first : 6.0 * (first * (1.0 - u) + (b[1] - 2.0 * b[2] + b[3]) * u);
}

/* With the radius r + s slope + s^2 bend from where the stretch has the height of the line at s = 0. */
static void cross_short(const line *n, const part *p, uint32_t piece, const double *start, double u, common_cross *out, uint32_t *count)
{
    const common_piece *c = &p->curve;
    double v[2], w[2], turns, slope, bend, a, half, rest;

    for (int turn = 0; turn < 4; turn++) {
        common_piece_at(c, u, v, w);
        u += (n->o.y - v[1]) / w[1];
    }
    common_piece_at(c, u, v, w);
    turns = n->d.y / w[1];
    slope = w[0] * turns;
    bend = 0.5 * (bend_at(c->x, c->degree, u) - w[0] / w[1] * bend_at(c->y, c->degree, u)) * turns * turns;
    a = n->a - slope * slope - 2.0 * v[0] * bend;
    half = n->b - v[0] * slope;
    rest = half * half - a * (n->c - v[0] * v[0]);
    for (int sign = -1; sign <= 1 && (start || rest >= 0.0); sign += start ? 4 : 2) {
        const double s = start ? n->base / n->unit - 2.0 * half / a : (sign * sqrt(rest) - half) / a;
        const common_cross at = { s, u + s * turns, piece };

        out[(*count)++] = at;
    }
}

static void cross_slow(const line *n, const part *p, uint32_t piece, const double *start, common_cross *out, uint32_t *count)
{
    const double one = n->o.y + n->d.y * (n->span.lo - BESIDE_BOX), other = n->o.y + n->d.y * (n->span.hi + BESIDE_BOX);
    const double low = lesser(one, other), high = greater(one, other);
    double cut[8], b[ORDER + 1], q[ORDER], root[ORDER], v[2], slope[2];
    const uint32_t stretches = find_cuts(p, low, high, cut), room = *count + ORDER;

    for (uint32_t k = 0; k < stretches; k++) {
        const double from = cut[k], length = cut[k + 1] - from;
        const bool has_start = start && *start >= from && *start <= cut[k + 1];
        uint32_t found;
        double noise;

        common_piece_at(&p->curve, from + 0.5 * length, v, slope);
        if (!(length > 0.0 && v[1] >= low && v[1] <= high))
            continue;
        if (is_short(p, from, cut[k + 1], high - low) && *count + 2 <= room) {
            cross_short(n, p, piece, has_start ? start : NULL, from + 0.5 * length, out, count);
            continue;
        }
        noise = stretch_equation(n, p, from, cut[k + 1], b);
        if (has_start)
            common_bernstein_divide(b, p->order, (*start - from) / length, q);
        found = has_start ? common_bernstein_roots(q, p->order - 1, p->order * noise, root) : common_bernstein_roots(b, p->order, noise, root);
        for (uint32_t i = 0; i < found && *count < room; i++) {
            common_cross at = { 0.0, from + length * root[i], piece };

            common_piece_at(&p->curve, at.u, v, slope);
            at.s = (v[1] - n->o.y) * n->per_height;
            out[(*count)++] = at;
        }
    }
}

/* The other crossing at the height of the start is as far from the foot. */
static void cross_level(const line *n, const part *p, uint32_t piece, const double *start, common_cross *out, uint32_t *count)
{
    const int degree = (int)p->curve.degree;
    double b[4], root[3];
    uint32_t found;

    for (int k = 0; k <= degree; k++)
        b[k] = p->curve.y[k] - n->o.y;
    found = common_bernstein_roots(b, degree, common_bernstein_noise(b, degree), root);
    for (uint32_t i = 0; i < found; i++) {
        double v[2], slope[2], rest;

        common_piece_at(&p->curve, root[i], v, slope);
        rest = n->b * n->b - n->a * (n->c - v[0] * v[0]);
        if (start && fabs(root[i] - *start) < BESIDE_START) {
            const common_cross at = { 2.0 * n->foot + n->base / n->unit, root[i], piece };

            out[(*count)++] = at;
            continue;
        }
        if (!(rest >= 0.0))
            continue;
        for (int sign = -1; sign <= 1; sign += 2) {
            const common_cross at = { (sign * sqrt(rest) - n->b) / n->a, root[i], piece };

            out[(*count)++] = at;
        }
    }
}

static size_t scratch(const void *self) { return ORDER * ((const lathe *)self)->outline.count * sizeof(common_cross); }

/* Of rays that start elsewhere and want the first crossing only: keeps those that may be that. */
static uint32_t keep_first(const line *n, const common_ray *k, const pov_hits *hits, common_cross *at, uint32_t count)
{
    const double from = (hits->tmin * k->per_unit - n->base) / n->unit + 2.0 * REFINED;
    double least = HUGE_VAL;
    uint32_t kept = 0;

    for (uint32_t i = 0; i < count; i++)
        least = at[i].s > from ? lesser(least, at[i].s) : least;
    for (uint32_t i = 0; i < count; i++)
        if (at[i].s <= least + 2.0 * REFINED)
            at[kept++] = at[i];
    return kept;
}

/* Does the ray start there, beside the end of another piece, or on its own? */
static bool is_start(const line *n, uint32_t origin, const common_cross *at)
{
    return origin != UINT32_MAX && fabs(at->s + n->base / n->unit) < (at->piece == origin ? NEAR : 0x1p-14 * NEAR);
}

static void cross(const void *self, const pov_ray *ray, const common_entry *e, pov_hits *hits)
{
    const lathe *l = self;
    const double unit = e->k.unit;
    const uint32_t origin = ray->origin_surface == hits->owner ? ray->origin_mark.feature : UINT32_MAX;
    common_cross *at = hits->scratch;
    uint32_t count = 0;
    line n;

    make_line(&n, &e->k, e->span);
    if (!(fabs(n.d.y) < SLOW))
        cross_all_risen(l, &n, origin, &ray->origin_mark.u, at, &count);
    for (uint32_t i = 0; fabs(n.d.y) < SLOW && i < l->outline.count; i++)
        if (may_cross(&n, &l->parts[i]))
            (fabs(n.d.y) < LEVEL ? cross_level : cross_slow)(&n, &l->parts[i], i, i == origin ? &ray->origin_mark.u : NULL, at, &count);
    if (count > 1 && hits->want != POV_WANT_ALL && ray->origin_surface != hits->owner)
        count = keep_first(&n, &e->k, hits, at, count);
    for (uint32_t i = 0; i < count; i++)
        refine(&n, &l->parts[at[i].piece], at[i].piece == origin ? lesser(0x1p-10, 0.25 * fabs(at[i].s + n.base / n.unit)) : 0x1p-10, &at[i]);
    for (uint32_t i = 0; i < count; i++) {
        const pov_two t = pov_two_sum(n.base, at[i].s * n.unit);
        const pov_mark mark = { at[i].piece, 0, at[i].u, 0.0 };

        if (!is_start(&n, origin, &at[i]) && !pov_cross(hits, t.hi * unit, t.lo * unit, mark))
            return;
    }
}

static void first(const void *self, const common_entries *restrict e, common_first_crossings *restrict out)
{
    const lathe *l = self;

    common_turned_first(l->parts, l->filter.count, e, out);
}

static uint32_t narrow(const void *self, const pov_own_map *map, uint32_t owner, const pov_rays *rays, pov_candidate *io, uint32_t n)
{
    const lathe *l = self;

    return l->filter.count > 0 ? common_narrow(&l->boxed, common_revolved_look, &l->filter, map, owner, rays, io, n) : n;
}

/* ---- points ---- */

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const lathe *l = self;
    const pov_vec3 p = pov_two3_hi(common_offset(point, point_lo, l->boxed.anchor, l->boxed.scale));
    const double at[2] = { sqrt(p.x * p.x + p.z * p.z), p.y };

    return common_outline_inside(&l->outline, at);
}

static void normal_at(const void *self, pov_vec3 p, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const lathe *l = self;
    const double radius = sqrt(p.x * p.x + p.z * p.z);
    const double outward = common_sides_at(&l->sides, at->mark.feature, at->mark.u);
    double v[2], slope[2], radial;

    common_piece_at(&l->outline.at[at->mark.feature], at->mark.u, v, slope);
    radial = radius > 0.0 ? (v[0] < 0.0 ? -1.0 : 1.0) * slope[1] / radius : 0.0;
    *out = pov_scale(pov_unit(pov_vec3_of(p.x * radial, -slope[0], p.z * radial)), outward);
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

COMMON_ROUND_CLASS(lathe, cross, first, false, narrow, normal_at)

/* The front is to the right of the curve's way. */
static bool reversed(const void *self, const pov_ray *ray, const pov_crossing *at)
{
    (void)ray;
    return common_sides_at(&((const lathe *)self)->sides, at->mark.feature, at->mark.u) < 0.0;
}

static bool open(const void *self) { return ((const lathe *)self)->open; }

static void uv(const void *self, pov_vec3 point, const pov_mark *mark, double out[2])
{
    out[0] = common_whole_turn(point.z, point.x);
    out[1] = (mark->feature + mark->u) / ((const lathe *)self)->outline.count;
}

static const pov_shape_class lathe_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "lathe",
    .instance_size = sizeof(lathe),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .scratch = scratch,
    .extension = extension,
    .open = open,
    .reversed = reversed,
    .uv = uv,
};

static const pov_shape_class *const shapes[] = { &lathe_class, NULL };

POV_PLUGIN(lathe) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "lathe",
    .version = "1",
    .shapes = shapes,
};
