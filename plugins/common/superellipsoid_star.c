/* Superellipsoids with an exponent above 2: stars, which a ray may enter more than once. Where a stretch of the ray may meet them
 * is bounded by what is nearest to the planes of the coordinates, and farthest from them. */
#include "common/superellipsoid.h"

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

/* Of a stretch: what is nearest to the planes of its coordinates, what is farthest from them, and its middle; with approximate sizes, to
 * the power 2 / n, and exact ones where these do not tell them from one. How the power grows with each coordinate: `ring` times that of x and
 * y, and that of z. */
enum { NEAREST, FARTHEST, MIDDLE, PLACES };
typedef double place_lanes[PLACES + 1];
typedef struct places { place_lanes x, y, z, approx, by_x, by_y, by_z, ring, size, shares; bool exact; } places;

/* What a power grows by with its base, which is x or nearer to zero. */
COMMON_INLINE double growth_of(double power, double x, double y)
{
    const double at_zero = y < 1.0 ? HUGE_VAL : 0.0;

    return x > 0x1p-30 ? y * power / x : y == 1.0 ? 1.0 : at_zero;
}

COMMON_CLONES static void approx_sizes(double e, double n, places *restrict p)
{
    for (uint32_t i = 0; i < PLACES + 1; i++) {
        const double x = fabs(p->x[i]), y = fabs(p->y[i]), z = fabs(p->z[i]);
        const double of_x = approx_power(x, 2.0 / e), of_y = approx_power(y, 2.0 / e), of_z = approx_power(z, 2.0 / n);
        const double ring = approx_power(of_x + of_y, e / n);

        p->approx[i] = ring + of_z;
        p->by_x[i] = growth_of(of_x, x, 2.0 / e);
        p->by_y[i] = growth_of(of_y, y, 2.0 / e);
        p->by_z[i] = growth_of(of_z, z, 2.0 / n);
        p->ring[i] = ring / (of_x + of_y) * (e / n);
    }
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

/* The least and the greatest of a factor between two values, times one of any sign, and more than what powers are off. */
typedef struct range { double lo, hi; } range;

static range times(double a, double b, double by)
{
    const double most = larger(a, b) * (1.0 + 0x1p-10) * by, least = smaller(a, b) * (1.0 - 0x1p-10) * by;
    const range r = { smaller(least, most), larger(least, most) };

    return r;
}

/* Bounds of how the size, to the power 2 / n, grows along a stretch where no coordinate changes its sign. False: there are none. */
static bool find_growth(const line *n, const places *p, double middle, range *out)
{
    const pov_vec3 at = pov_add(n->o, pov_scale(n->d, middle));
    range x, y, z;

    if (!n->s->approx || !(p->x[NEAREST] > 0x1p-30 && p->y[NEAREST] > 0x1p-30 && p->z[NEAREST] > 0x1p-30))
        return false;
    x = times(p->by_x[NEAREST], p->by_x[FARTHEST], copysign(n->d.x, n->d.x * at.x));
    y = times(p->by_y[NEAREST], p->by_y[FARTHEST], copysign(n->d.y, n->d.y * at.y));
    z = times(p->by_z[NEAREST], p->by_z[FARTHEST], copysign(n->d.z, n->d.z * at.z));
    out->lo = times(p->ring[NEAREST], p->ring[FARTHEST], x.lo + y.lo).lo + z.lo;
    out->hi = times(p->ring[NEAREST], p->ring[FARTHEST], x.hi + y.hi).hi + z.hi;
    return true;
}

/* What is known of a stretch: its points are all outside, or all inside; its size grows or falls all along, so that it has one crossing
 * at most; or nothing. */
typedef enum known { OUTSIDE, INSIDE, MONOTONIC, NOTHING } known;

/* By approximate sizes. */
static known find_about(const line *n, const places *p, double middle, double half)
{
    range by;
    double most;

    if (p->approx[NEAREST] - 1.0 > APPROX)
        return OUTSIDE;
    if (1.0 - p->approx[FARTHEST] > APPROX)
        return INSIDE;
    if (!find_growth(n, p, middle, &by))
        return NOTHING;
    most = half * larger(fabs(by.lo), fabs(by.hi)) + APPROX;
    if (p->approx[MIDDLE] - 1.0 > most)
        return OUTSIDE;
    if (1.0 - p->approx[MIDDLE] > most)
        return INSIDE;
    return by.lo > 0.0 || by.hi < 0.0 ? MONOTONIC : NOTHING;
}

static known find_known(const line *n, places *p, double middle, double half)
{
    const known about = find_about(n, p, middle, half);

    if (about != NOTHING)
        return about;
    if (is_place_above(n, p, NEAREST, 1.0 + FINE))
        return OUTSIDE;
    return is_place_above(n, p, FARTHEST, 1.0 - FINE) ? NOTHING : INSIDE;
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

/* The crossing between points on different sides where the size grows or falls all along: Newton's method kept between them, of
 * approximate sizes first. */
static double find_only(const line *n, double lo, double hi, bool is_out)
{
    double t = 0.5 * (lo + hi), slope, value = approx_along(n, t, &slope), next;

    for (int turn = 0; turn < 40 && fabs(value) > APPROX; turn++) {
        *((value > 0.0) == is_out ? &lo : &hi) = t;
        next = t - value / slope;
        t = next > lo && next < hi ? next : 0.5 * (lo + hi);
        value = approx_along(n, t, &slope);
    }
    for (int turn = 0; turn < 80; turn++) {
        value = size_along(n, t, &slope);
        if (fabs(value) <= FINE)
            return t;
        *((value > 0.0) == is_out ? &lo : &hi) = t;
        next = t - value / slope;
        next = next > lo && next < hi ? next : 0.5 * (lo + hi);
        if (!(next > lo && next < hi))
            return t;
        t = next;
    }
    return bisect(n, lo, hi, is_out);
}

/* Does any crossing do, so that it need not be known where it lies between two distances? */
static bool is_any_between(const line *n, const common_ray *k, double lo, double hi, const pov_hits *hits)
{
    return hits->want == POV_WANT_ANY && (n->base + lo) * k->unit > hits->tmin && (n->base + hi) * k->unit < hits->tmax - hits->slack;
}

static void clip_sum(const line *n, double x, double y, double z, common_span *s)
{
    const pov_vec3 by = { x, y, z };

    common_clip_axis(s, pov_dot(by, n->o), pov_dot(by, n->d), -1.0, 1.0, 0x1p-40);
}

/* Powers of at most one of numbers up to one are no less than these: where the sizes of two coordinates, or of all, add to no more than one. */
static void clip_sums(const line *n, common_span *s)
{
    const bool ring = n->s->e >= 2.0, all = n->s->n >= 2.0;

    for (int i = 0; ring && !all && i < 2; i++)
        clip_sum(n, 1.0, i == 0 ? 1.0 : -1.0, 0.0, s);
    for (int i = 0; all && i < 4; i++)
        if (ring)
            clip_sum(n, 1.0, i < 2 ? 1.0 : -1.0, i % 2 == 0 ? 1.0 : -1.0, s);
        else
            clip_sum(n, i < 2 ? 1.0 : 0.0, i < 2 ? 0.0 : 1.0, i % 2 == 0 ? 1.0 : -1.0, s);
}

/* A stretch, and on which side its ends are. */
typedef struct stretch { double lo, hi; bool out, still; } stretch;

static double root_of(const line *n, const common_ray *k, const stretch *s, bool only, const pov_hits *hits)
{
    if (is_any_between(n, k, s->lo, s->hi, hits))
        return 0.5 * (s->lo + s->hi);
    return only ? find_only(n, s->lo, s->hi, s->out) : bisect(n, s->lo, s->hi, s->out);
}

/* False: nothing more is wanted. */
static bool search(const line *n, const common_ray *k, const common_span *within, stretch s, int depth, pov_hits *hits)
{
    const double middle = 0.5 * (s.lo + s.hi);
    stretch near = s, far = s;
    places p;
    known is;

    if (s.hi < within->lo || s.lo > within->hi)
        return true;
    /* Behind a crossing that is known, or the end. */
    if ((n->base + s.lo) * k->unit > (hits->tmax + hits->slack) * (1.0 + 0x1p-40))
        return true;
    find_places(n, s.lo, s.hi, &p);
    is = find_known(n, &p, middle, 0.5 * (s.hi - s.lo));
    if (is == OUTSIDE || is == INSIDE || (is == MONOTONIC && s.out == s.still))
        return true;
    if (depth == 0 || is == MONOTONIC || (s.out != s.still && depth < 16))
        return s.out == s.still || report(n, k, root_of(n, k, &s, is == MONOTONIC, hits), hits);
    near.hi = far.lo = middle;
    near.still = far.out = is_place_above(n, &p, MIDDLE, 1.0);
    return search(n, k, within, near, depth - 1, hits) && search(n, k, within, far, depth - 1, hits);
}

void common_superellipsoid_star(const line *n, const common_ray *k, double from, pov_hits *hits)
{
    common_span within = { from, n->span.hi };
    stretch all = { from, n->span.hi, true, true };

    clip_sums(n, &within);
    if (within.lo > within.hi)
        return;
    all.out = from > n->span.lo ? is_outside(n, from) : true;
    search(n, k, &within, all, 26, hits);
}
