/* superellipsoid { <e, n> }: (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1.
 *
 * The left side to the power n/2 is a size: of a point twice as far it is double. With e and n up to 2 that is a norm, which
 * is convex along a ray: Newton's method from outside comes to the first crossing without passing it, and the slope tells
 * a ray that misses. Stars, with e or n above 2, are searched by bounds of |x|, |y| and |z| over stretches of the ray. */
#include "common/clip.h"
#include "common/powers.h"
#include "common/simd.h"

typedef struct superellipsoid {
    double e, n;
    bool convex;
    bool approx;                  /* are approximate sizes of use? Large powers multiply their errors */
} superellipsoid;

/* Exponents below this make edges that no double tells from those of a box. */
static const double SHARPEST = 0x1p-10, NEAR = 0x1p-30, FINE = 0x1p-50, APPROX = 0x1p-14, LAST = 0x1p-27;

static double exponent(const pov_host *host, pov_reader *in, double written)
{
    if (!(written >= SHARPEST))
        host->warn(in, "an exponent of a superellipsoid below %g counts as that", SHARPEST);
    return fmax(written, SHARPEST);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    superellipsoid *s = self;
    double v[2];

    host->vector_of(in, v, 2);
    s->e = exponent(host, in, v[0]);
    s->n = exponent(host, in, v[1]);
    s->convex = s->e <= 2.0 && s->n <= 2.0;
    s->approx = fmin(s->e, s->n) >= 0.0625 && fmax(s->e, s->n) <= 16.0;
}

static bool bounds(const void *self, pov_box *out)
{
    (void)self;
    out->lo = pov_vec3_of(-1.0, -1.0, -1.0);
    out->hi = pov_vec3_of(1.0, 1.0, 1.0);
    return true;
}

/* ---- the size of a point ---- */

/* A power within 2^-22 of it, and 2^-24 y, for x from 0 to 3 and y that makes no number below 2^-1000 of it. */
COMMON_INLINE double approx_power(double x, double y)
{
    const uint64_t sqrt_half = 0x3fe6a09e667f3bcd, two = 0x4000000000000000;
    const uint64_t above = (elementary_bits(x) + (two - sqrt_half)) >> 52;   /* the exponent + 1024 */
    const double k = elementary_of_bits(above | 0x4330000000000000) - (0x1p52 + 1024.0);
    const double m = elementary_of_bits(elementary_bits(x) - ((above - 1024) << 52)), s = (m - 1.0) / (m + 1.0), z = s * s;
    const double log2 = k + s * (2.885390081777927 + z * (0.9617966939259757 + z * (0.5770780163555854 + z * 0.41219858311113244)));
    const double all = y * log2, held = all > -1000.0 ? all : -1000.0, n = elementary_round(held), r = held - n;

    return (1.0 + r * (0.6931471805599453 + r * (0.24022650695910072 + r * (0.05550410866482158 + r * (0.009618129107628477 +
            r * (0.0013333558146428443 + r * 0.00015403530393381608)))))) * elementary_power_of_two(n);
}

COMMON_INLINE double power_of(double x, double y, bool approx) { return approx ? approx_power(x, y) : common_power(x, y); }

/* (a^(2/e) + b^(2/e))^(e/2), and the share of a in the sum. */
COMMON_INLINE double norm_of(double a, double b, double e, bool approx, double *share)
{
    const double most = a > b ? a : b, least = a > b ? b : a, ratio = most > 0.0 ? least / most : 0.0;
    const double rest = ratio > 0x1p-1000 ? power_of(ratio, 2.0 / e, approx) : 0.0;

    *share = (a >= b ? 1.0 : rest) / (1.0 + rest);
    return rest > 0.0 ? most * power_of(1.0 + rest, 0.5 * e, approx) : most;
}

static double size_at(const superellipsoid *s, pov_vec3 p)
{
    double share;

    return norm_of(norm_of(fabs(p.x), fabs(p.y), s->e, false, &share), fabs(p.z), s->n, false, &share);
}

/* How a norm grows with one of its numbers: the share of it, over its part of the whole. */
COMMON_INLINE double growth(double share, double whole, double x) { return x != 0.0 ? share * whole / x : 0.0; }

COMMON_INLINE double size_and_slope(const superellipsoid *s, pov_vec3 p, bool approx, pov_vec3 *slope)
{
    double of_x, of_ring;
    const double ring = norm_of(fabs(p.x), fabs(p.y), s->e, approx, &of_x);
    const double size = norm_of(ring, fabs(p.z), s->n, approx, &of_ring), by_ring = growth(of_ring, size, ring);

    slope->x = by_ring * growth(of_x, ring, p.x);
    slope->y = by_ring * growth(1.0 - of_x, ring, p.y);
    slope->z = growth(1.0 - of_ring, size, p.z);
    return size;
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    return size_at(self, pov_add(point, point_lo)) <= 1.0;
}

/* ---- along a ray ---- */

typedef struct line {
    const superellipsoid *s;
    pov_vec3 o, d;
    double base;
    common_span span;            /* from the base */
} line;

COMMON_INLINE double value_along(const line *n, double t, bool approx, double *slope)
{
    pov_vec3 by;
    const double size = size_and_slope(n->s, pov_add(n->o, pov_scale(n->d, t)), approx, &by);

    *slope = pov_dot(by, n->d);
    return size - 1.0;
}

static double size_along(const line *n, double t, double *slope) { return value_along(n, t, false, slope); }
static double approx_along(const line *n, double t, double *slope) { return value_along(n, t, true, slope); }

/* Approximate values come near the root: a start for exact ones. False: there is none, beyond what those may be off. */
static bool come_near(const line *n, double sign, double *start)
{
    double t = *start, slope, value = approx_along(n, t, &slope);

    for (int turn = 0; turn < 100 && value > APPROX; turn++) {
        double next;

        if (!(slope * sign < 0.0))
            return value < 4.0 * APPROX;
        next = t - value / slope;
        if (!(next >= n->span.lo && next <= n->span.hi))
            return value < 4.0 * APPROX;
        t = next;
        value = approx_along(n, t, &slope);
    }
    *start = t;
    return true;
}

/* Does a step of Newton's method end at the crossing? It leaves a value of the step's square: of a ray that grazes, steps are long. */
static inline bool is_last_step(double value, double slope) { return fabs(value) < LAST && fabs(value) < LAST * (slope * slope); }

/* Newton's method from one end of a convex function; sign: 1 from the near end, -1 from the far one. False: no crossing. */
static bool approach(const line *n, double start, double sign, double *root, double *slope)
{
    double t = start, value;

    if (!come_near(n, sign, &t))
        return false;
    value = size_along(n, t, slope);
    for (int turn = 0; turn < 100 && fabs(value) > FINE; turn++) {
        double next;

        if (!(*slope * sign < 0.0))
            return false;
        next = t - value / *slope;
        if (!(next >= n->span.lo && next <= n->span.hi))
            return false;
        if (next == t || is_last_step(value, *slope)) {
            t = next;
            break;
        }
        t = next;
        value = size_along(n, t, slope);
    }
    *root = t;
    return true;
}

static bool report(const line *n, const common_ray *k, double t, pov_hits *hits)
{
    const pov_two at = pov_two_sum(n->base, t);
    const pov_mark mark = { 0, 0, 0.0, 0.0 };

    return pov_cross(hits, at.hi * k->unit, at.lo * k->unit, mark);
}

static bool goes_in(const line *n, const pov_ray *ray)
{
    double slope;

    if (ray->origin_mark.flags & (POV_MARK_INWARD | POV_MARK_OUTWARD))
        return ray->origin_mark.flags & POV_MARK_INWARD;
    size_along(n, 0.0, &slope);
    return slope < 0.0;
}

/* A ray that clearly goes in, where it counts, need not come out. */
static bool is_enough(const line *n, const common_ray *k, double in, double slope, const pov_hits *hits)
{
    return hits->want != POV_WANT_ALL && slope < -0x1p-10 && (n->base + in) * k->unit > hits->tmin;
}

/* Any crossing counts: is there one for certain? Then *at is near it. */
static bool is_certain(const line *n, const common_ray *k, const pov_hits *hits, double *at)
{
    double t = n->span.lo, slope, value, behind;

    if (hits->want != POV_WANT_ANY || !come_near(n, 1.0, &t))
        return false;
    value = approx_along(n, t, &slope);
    behind = t - (fabs(value) + 4.0 * APPROX) / slope;
    *at = t;
    return slope < 0.0 && (n->base + t) * k->unit > hits->tmin && (n->base + behind) * k->unit < hits->tmax &&
           approx_along(n, behind, &slope) < -APPROX;
}

static void cross_convex(const line *n, const common_ray *k, const pov_ray *ray, bool from_here, pov_hits *hits)
{
    double in, out, slope, slope_out;

    if (from_here) {
        if (goes_in(n, ray) && approach(n, n->span.hi, -1.0, &out, &slope) && out > 0.0)
            report(n, k, out, hits);
        return;
    }
    if (is_certain(n, k, hits, &in)) {
        report(n, k, in, hits);
        return;
    }
    if (!approach(n, n->span.lo, 1.0, &in, &slope))
        return;
    if (is_enough(n, k, in, slope, hits))
        report(n, k, in, hits);
    else if (approach(n, n->span.hi, -1.0, &out, &slope_out) && in < out && report(n, k, in, hits))
        report(n, k, out, hits);
}

/* ---- stars ---- */

static inline double smaller(double a, double b) { return a < b ? a : b; }
static inline double larger(double a, double b) { return a > b ? a : b; }
static inline double least_of(double a, double b) { return (a < 0.0) != (b < 0.0) ? 0.0 : smaller(fabs(a), fabs(b)); }

/* The turn at which a crossing between two points is about known. */
enum { NARROW = 8 };

/* About the size to the power 2 / n, of a point of the unit cube: that is above one where the size is. */
COMMON_INLINE double approx_size(double e, double n, double x, double y, double z)
{
    return approx_power(approx_power(fabs(x), 2.0 / e) + approx_power(fabs(y), 2.0 / e), e / n) + approx_power(fabs(z), 2.0 / n);
}

static bool is_outside(const line *n, double t)
{
    const pov_vec3 p = pov_add(n->o, pov_scale(n->d, t));
    const double approx = n->s->approx ? approx_size(n->s->e, n->s->n, p.x, p.y, p.z) : 1.0;

    return fabs(approx - 1.0) > APPROX ? approx > 1.0 : size_at(n->s, p) > 1.0;
}

/* Of a stretch: what is nearest to the planes of its coordinates, what is farthest from them, and its middle; with approximate sizes, and
 * exact ones where these do not tell them from one. */
enum { NEAREST, FARTHEST, MIDDLE, PLACES };
typedef double place_lanes[PLACES + 1];
typedef struct places { place_lanes x, y, z, approx, size, shares; bool exact; } places;

COMMON_CLONES static void approx_sizes(double e, double n, places *restrict p)
{
    for (uint32_t i = 0; i < PLACES + 1; i++)
        p->approx[i] = approx_size(e, n, p->x[i], p->y[i], p->z[i]);
}

/* size_at() of all. Shares are kept for the compiler, which else moves powers into branches and makes no vectors of them. */
COMMON_CLONES static void exact_sizes(double e, double n, places *restrict p)
{
    for (uint32_t i = 0; i < PLACES + 1; i++) {
        double of_x, of_ring;

        p->size[i] = norm_of(norm_of(fabs(p->x[i]), fabs(p->y[i]), e, false, &of_x), fabs(p->z[i]), n, false, &of_ring);
        p->shares[i] = of_x + of_ring;
    }
}

static inline void put_axis(double *out, double a, double b, double middle)
{
    out[NEAREST] = least_of(a, b);
    out[FARTHEST] = larger(fabs(a), fabs(b));
    out[MIDDLE] = out[PLACES] = middle;
}

static void find_places(const line *n, double lo, double hi, places *out)
{
    const pov_vec3 a = pov_add(n->o, pov_scale(n->d, lo)), b = pov_add(n->o, pov_scale(n->d, hi));
    const pov_vec3 m = pov_add(n->o, pov_scale(n->d, 0.5 * (lo + hi)));

    put_axis(out->x, a.x, b.x, m.x);
    put_axis(out->y, a.y, b.y, m.y);
    put_axis(out->z, a.z, b.z, m.z);
    if (n->s->approx)
        approx_sizes(n->s->e, n->s->n, out);
    for (uint32_t i = 0; !n->s->approx && i < PLACES; i++)
        out->approx[i] = 1.0;
    out->exact = false;
}

static bool is_place_above(const line *n, places *p, uint32_t i, double level)
{
    if (fabs(p->approx[i] - 1.0) > APPROX)
        return p->approx[i] > 1.0;
    if (!p->exact)
        exact_sizes(n->s->e, n->s->n, p);
    p->exact = true;
    return p->size[i] > level;
}

/* 1: certainly outside all along; -1: inside; 0: neither. */
static int side_of(const line *n, places *p)
{
    return is_place_above(n, p, NEAREST, 1.0 + FINE) ? 1 : is_place_above(n, p, FARTHEST, 1.0 - FINE) ? 0 : -1;
}

/* Between points on different sides, a step of Newton's method from the middle and both sides of where it leads. */
static void narrow(const line *n, double *lo, double *hi, bool is_out)
{
    const double middle = 0.5 * (*lo + *hi), near = 0x1p-20 * (*hi - *lo);
    double slope, value = size_along(n, middle, &slope), root = middle - value / slope;

    *((value > 0.0) == is_out ? lo : hi) = middle;
    for (int i = 0; i < 2; i++) {
        const double t = root + (i == 0 ? -near : near);

        if (t > *lo && t < *hi)
            *((size_along(n, t, &slope) > 0.0) == is_out ? lo : hi) = t;
    }
}

/* A crossing between points on different sides. */
static double bisect(const line *n, double lo, double hi, bool is_out)
{
    for (int turn = 0;; turn++) {
        const double middle = 0.5 * (lo + hi);

        if (!(middle > lo && middle < hi))
            return middle;
        if (turn >= NARROW)
            narrow(n, &lo, &hi, is_out);
        else
            *(is_outside(n, middle) == is_out ? &lo : &hi) = middle;
    }
}

/* Does any crossing do, so that it need not be known where it lies between two distances? */
static bool is_any_between(const line *n, const common_ray *k, double lo, double hi, const pov_hits *hits)
{
    return hits->want == POV_WANT_ANY && (n->base + lo) * k->unit > hits->tmin && (n->base + hi) * k->unit < hits->tmax - hits->slack;
}

/* A stretch, and on which side its ends are. */
typedef struct stretch { double lo, hi; bool out, still; } stretch;

/* False: nothing more is wanted. */
static bool search(const line *n, const common_ray *k, stretch s, int depth, pov_hits *hits)
{
    const double middle = 0.5 * (s.lo + s.hi);
    stretch near = s, far = s;
    places p;

    find_places(n, s.lo, s.hi, &p);
    if (side_of(n, &p) != 0)
        return true;
    if (depth == 0 || (s.out != s.still && depth < 16))
        return s.out == s.still || report(n, k, is_any_between(n, k, s.lo, s.hi, hits) ? middle : bisect(n, s.lo, s.hi, s.out), hits);
    near.hi = far.lo = middle;
    near.still = far.out = is_place_above(n, &p, MIDDLE, 1.0);
    return search(n, k, near, depth - 1, hits) && search(n, k, far, depth - 1, hits);
}

static void cross_star(const line *n, const common_ray *k, double from, pov_hits *hits)
{
    const stretch all = { from, n->span.hi, is_outside(n, from), is_outside(n, n->span.hi) };

    search(n, k, all, 26, hits);
}

static const pov_vec3 zero = { 0.0, 0.0, 0.0 }, one = { 1.0, 1.0, 1.0 };

/* False: the ray misses the box, or has no direction, so that it stays where it is for ever. */
static bool enter(line *n, const superellipsoid *s, const common_ray *k, bool from_here, const pov_hits *hits)
{
    if (!common_clip(k, pov_scale(one, -1.0), one, &n->span) || n->span.hi < 0.0 ||
        !(n->span.hi < HUGE_VAL) || n->span.lo * k->unit > hits->tmax)
        return false;
    n->s = s;
    n->base = from_here ? 0.0 : n->span.lo;
    n->o = common_along(k, n->base);
    n->d = k->d;
    n->span.lo -= n->base;
    n->span.hi -= n->base;
    return true;
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    const bool from_here = ray->origin_surface == hits->owner;
    line n;

    if (!enter(&n, self, &k, from_here, hits))
        return;
    if (n.s->convex)
        cross_convex(&n, &k, ray, from_here, hits);
    else
        cross_star(&n, &k, from_here ? NEAR : n.span.lo, hits);
}

/* ---- several rays side by side ---- */

enum { TOGETHER = 4 };
typedef double four[TOGETHER];

/* By lane: a line, and its shape's exponents. */
typedef struct line_lanes { four o[3], d[3], e, n; } line_lanes;

COMMON_INLINE line get_line(const line_lanes *l, superellipsoid *s, uint32_t i)
{
    line n;

    s->e = l->e[i];
    s->n = l->n[i];
    n.s = s;
    n.o = pov_vec3_of(l->o[0][i], l->o[1][i], l->o[2][i]);
    n.d = pov_vec3_of(l->d[0][i], l->d[1][i], l->d[2][i]);
    return n;
}

static void put_line(line_lanes *l, const line *n, uint32_t i)
{
    l->o[0][i] = n->o.x;
    l->o[1][i] = n->o.y;
    l->o[2][i] = n->o.z;
    l->d[0][i] = n->d.x;
    l->d[1][i] = n->d.y;
    l->d[2][i] = n->d.z;
    l->e[i] = n->s->e;
    l->n[i] = n->s->n;
}

/* size_along() and approx_along() of all lanes. */
COMMON_CLONES static void sizes_along(const line_lanes *restrict l, const double *restrict t, double *restrict value,
                                      double *restrict slope)
{
    for (uint32_t i = 0; i < TOGETHER; i++) {
        superellipsoid s;
        const line n = get_line(l, &s, i);
        double by;

        value[i] = value_along(&n, t[i], false, &by);
        slope[i] = by;
    }
}

COMMON_CLONES static void approxes_along(const line_lanes *restrict l, const double *restrict t, double *restrict value,
                                         double *restrict slope)
{
    for (uint32_t i = 0; i < TOGETHER; i++) {
        superellipsoid s;
        const line n = get_line(l, &s, i);
        double by;

        value[i] = value_along(&n, t[i], true, &by);
        slope[i] = by;
    }
}

/* One of them: where it is, and whether that is still being looked for. `near`: about the first crossing. */
typedef struct member { line n; common_ray k; bool open, near; } member;

/* A turn of come_near() from the near end. False: it ends, near the crossing or with a certain miss, or `unsure`. */
static bool turn_near(member *m, double value, double slope, double *t, bool *unsure)
{
    const double next = *t - value / slope;

    m->near = !(value > APPROX);
    if (!m->near && slope < 0.0 && next >= m->n.span.lo && next <= m->n.span.hi) {
        *t = next;
        return true;
    }
    *unsure = !m->near && value < 4.0 * APPROX;
    return false;
}

/* A turn of approach(). False: it ends, at the crossing or `unsure`. */
static bool turn_exact(member *m, double value, double slope, double *t, bool *unsure)
{
    const double next = *t - value / slope, at = *t;

    if (!(fabs(value) > FINE))
        return false;
    *unsure = !(slope < 0.0 && next >= m->n.span.lo && next <= m->n.span.hi);
    if (*unsure)
        return false;
    *t = next;
    return next != at && !is_last_step(value, slope);
}

typedef struct members { member at[TOGETHER]; line_lanes lanes; four t, value, slope; bool unsure[TOGETHER]; } members;

typedef void evaluate(const line_lanes *restrict l, const double *restrict t, double *restrict value, double *restrict slope);
typedef bool take_turn(member *m, double value, double slope, double *t, bool *unsure);

/* Turns until all have ended. */
static void take_turns(members *all, evaluate *sizes, take_turn *take)
{
    bool any = true;

    for (int turn = 0; turn < 100 && any; turn++) {
        sizes(&all->lanes, all->t, all->value, all->slope);
        any = false;
        for (uint32_t i = 0; i < TOGETHER; i++) {
            member *m = &all->at[i];

            if (m->open)
                m->open = take(m, all->value[i], all->slope[i], &all->t[i], &all->unsure[i]);
            any = any || m->open;
        }
    }
    for (uint32_t i = 0; any && i < TOGETHER; i++)
        all->unsure[i] = all->unsure[i] || all->at[i].open;
}

/* As is_certain(), of those near a crossing. */
static void find_certain(members *all, pov_hits *const *hits, uint32_t n, bool *certain)
{
    four behind, value, slope;

    for (uint32_t i = 0; i < TOGETHER; i++)
        behind[i] = all->t[i] - (fabs(all->value[i]) + 4.0 * APPROX) / all->slope[i];
    approxes_along(&all->lanes, behind, value, slope);
    for (uint32_t i = 0; i < n; i++) {
        const member *m = &all->at[i];

        certain[i] = m->near && all->slope[i] < 0.0 && (m->n.base + all->t[i]) * m->k.unit > hits[i]->tmin &&
                     (m->n.base + behind[i]) * m->k.unit < hits[i]->tmax && value[i] < -APPROX;
    }
}

/* Rays that do not start on a convex shape. The first crossing of each is looked for; those that are not certain of one, or of a
 * miss, are left to cross_convex(). */
static void cross_four(members *all, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    bool certain[TOGETHER] = { false }, any = false, some = false;

    for (uint32_t i = 0; i < TOGETHER; i++) {
        put_line(&all->lanes, &all->at[i < n ? i : n - 1].n, i);
        all->at[i].open = i < n;
        all->at[i].near = all->unsure[i] = false;
        all->t[i] = all->at[i < n ? i : n - 1].n.span.lo;
    }
    take_turns(all, approxes_along, turn_near);
    for (uint32_t i = 0; i < n; i++) {
        any = any || (all->at[i].near && hits[i]->want == POV_WANT_ANY);
        all->at[i].open = all->at[i].near && hits[i]->want == POV_WANT_NEAREST;
        some = some || all->at[i].open;
    }
    if (any)
        find_certain(all, hits, n, certain);
    if (some)
        take_turns(all, sizes_along, turn_exact);
    for (uint32_t i = 0; i < n; i++) {
        const member *m = &all->at[i];
        const bool is_any = hits[i]->want == POV_WANT_ANY;

        if (!all->unsure[i] && !m->near)
            continue;
        if (!all->unsure[i] && (is_any ? certain[i] : hits[i]->want == POV_WANT_NEAREST &&
                                                      is_enough(&m->n, &m->k, all->t[i], all->slope[i], hits[i])))
            report(&m->n, &m->k, all->t[i], hits[i]);
        else
            cross_convex(&m->n, &m->k, rays[i], false, hits[i]);
    }
}

static void intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    const pov_ray *some[TOGETHER];
    pov_hits *of[TOGETHER];
    members all;
    uint32_t count = 0;

    for (uint32_t i = 0; i < n; i++) {
        const superellipsoid *s = selves[i];

        if (!s->convex || rays[i]->origin_surface == hits[i]->owner || hits[i]->always_exact) {
            intersect(s, rays[i], hits[i]);
            continue;
        }
        all.at[count].k = common_enter(rays[i], pov_two3_of(zero, zero), 1.0);
        if (!enter(&all.at[count].n, s, &all.at[count].k, false, hits[i]))
            continue;
        some[count] = rays[i];
        of[count++] = hits[i];
        if (count == TOGETHER) {
            cross_four(&all, some, of, count);
            count = 0;
        }
    }
    if (count > 1)
        cross_four(&all, some, of, count);
    else if (count > 0)
        cross_convex(&all.at[0].n, &all.at[0].k, some[0], false, of[0]);
}

/* ---- normals ---- */

/* The point of a crossing. */
static pov_vec3 point_of(const pov_ray *ray, const pov_crossing *at)
{
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);

    return pov_two3_hi(common_point(&k, at));
}

static pov_vec3 unit_of(pov_vec3 slope, const pov_ray *ray)
{
    const pov_vec3 unit = pov_unit(slope);

    return pov_largest(unit) > 0.0 ? unit : pov_scale(pov_unit(ray->dir), -1.0);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    pov_vec3 slope;

    size_and_slope(self, point_of(ray, at), false, &slope);
    *out = unit_of(slope, ray);
}

/* Of the points o. */
COMMON_CLONES static void find_slopes(const line_lanes *restrict l, double (*restrict out)[TOGETHER])
{
    for (uint32_t i = 0; i < TOGETHER; i++) {
        superellipsoid s;
        const line n = get_line(l, &s, i);
        pov_vec3 slope;

        size_and_slope(&s, n.o, false, &slope);
        out[0][i] = slope.x;
        out[1][i] = slope.y;
        out[2][i] = slope.z;
    }
}

static void normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                        pov_vec3 *const *out, uint32_t n)
{
    four slopes[3];
    line_lanes lanes;

    for (uint32_t some; n > 0; n -= some, selves += some, rays += some, at += some, out += some) {
        some = n < TOGETHER ? n : TOGETHER;
        for (uint32_t i = 0; i < TOGETHER; i++) {
            const uint32_t j = i < some ? i : some - 1;
            const line place = { .s = selves[j], .o = point_of(rays[j], at[j]) };

            put_line(&lanes, &place, i);
        }
        find_slopes(&lanes, slopes);
        for (uint32_t i = 0; i < some; i++)
            *out[i] = unit_of(pov_vec3_of(slopes[0][i], slopes[1][i], slopes[2][i]), rays[i]);
    }
}

static const pov_shape_fast superellipsoid_fast = {
    .size = sizeof(pov_shape_fast),
    .intersect_many = intersect_many,
    .normal_many = normal_many,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &superellipsoid_fast : NULL; }

static const pov_shape_class superellipsoid_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "superellipsoid",
    .instance_size = sizeof(superellipsoid),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .extension = extension,
};

static const pov_shape_class *const shapes[] = { &superellipsoid_class, NULL };

POV_PLUGIN(superellipsoid) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "superellipsoid",
    .version = "1",
    .shapes = shapes,
};
