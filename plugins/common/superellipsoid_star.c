/* Superellipsoids with an exponent above 2: stars, which a ray may enter more than once. Where a stretch of the ray may meet them
 * is bounded by what is nearest to the planes of the coordinates, and farthest from them. */
#include "common/superellipsoid_star.h"

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

COMMON_CLONES static void approx_sizes(const star_powers *s, places *restrict p)
{
    for (uint32_t i = 0; i < PLACES + 1; i++) {
        const star_power power = power_at(s, p->x[i], p->y[i], p->z[i]);

        p->approx[i] = power.value;
        p->by_x[i] = power.by_x;
        p->by_y[i] = power.by_y;
        p->by_z[i] = power.by_z;
        p->ring[i] = power.ring;
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
    const star_powers powers = powers_of(n->s);

    put_axis(out->x, a.x, b.x, m.x);
    put_axis(out->y, a.y, b.y, m.y);
    put_axis(out->z, a.z, b.z, m.z);
    if (n->s->approx)
        approx_sizes(&powers, out);
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

static inline star_power power_of_place(const places *p, int i)
{
    const star_power power = { p->approx[i], p->by_x[i], p->by_y[i], p->by_z[i], p->ring[i] };

    return power;
}

static known find_about(const line *n, const places *p, double middle, double half)
{
    const star_power nearest = power_of_place(p, NEAREST), farthest = power_of_place(p, FARTHEST);
    const bool is_off = p->x[NEAREST] > 0x1p-30 && p->y[NEAREST] > 0x1p-30 && p->z[NEAREST] > 0x1p-30;

    return known_of(&nearest, &farthest, p->approx[MIDDLE], is_off && n->s->approx, n->d, pov_add(n->o, pov_scale(n->d, middle)), half);
}

/* Where approximate sizes tell nothing. */
static known find_known(const line *n, places *p)
{
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
double common_star_bisect(const line *n, double lo, double hi, bool is_out)
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

    for (int turn = 0; turn < APPROX_TURNS && fabs(value) > APPROX; turn++) {
        *((value > 0.0) == is_out ? &lo : &hi) = t;
        next = t - value / slope;
        t = next > lo && next < hi ? next : 0.5 * (lo + hi);
        value = approx_along(n, t, &slope);
    }
    for (int turn = 0; turn < EXACT_TURNS; turn++) {
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
    return common_star_bisect(n, lo, hi, is_out);
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

static double root_of(const line *n, const common_ray *k, const stretch *s, bool only, const pov_hits *hits)
{
    if (is_any_between(n, k, s->lo, s->hi, hits))
        return 0.5 * (s->lo + s->hi);
    return only ? find_only(n, s->lo, s->hi, s->out) : common_star_bisect(n, s->lo, s->hi, s->out);
}

/* Where no coordinate changes its sign, powers of at most one bend down along a ray, and so do their sums and a norm of such a power: between
 * points outside, all are. */
static bool bends_down(const line *n, const places *p)
{
    return n->s->e >= 2.0 && n->s->n >= 2.0 && p->x[NEAREST] > 0.0 && p->y[NEAREST] > 0.0 && p->z[NEAREST] > 0.0;
}

quest common_star_quest(const line *n, places *p, known about, const stretch *s, stretch *near, stretch *far)
{
    known is = about;

    if (about == NOTHING)
        is = s->out && s->still && bends_down(n, p) ? OUTSIDE : find_known(n, p);
    if (is == OUTSIDE || is == INSIDE || (is == MONOTONIC && s->out == s->still))
        return NO_MORE;
    if (is == MONOTONIC)
        return ONLY;
    if (s->depth == 0 || (s->out != s->still && s->depth < 16))
        return s->out == s->still ? NO_MORE : CROSSING;
    *near = *far = *s;
    near->depth = far->depth = s->depth - 1;
    near->hi = far->lo = 0.5 * (s->lo + s->hi);
    near->still = far->out = is_place_above(n, p, MIDDLE, 1.0);
    return HALVES;
}

/* False: nothing more is wanted. */
static bool search(const line *n, const common_ray *k, const common_span *within, const stretch *s, pov_hits *hits)
{
    stretch near, far;
    places p;
    quest next;

    if (is_past(n, k, within, s, hits))
        return true;
    find_places(n, s->lo, s->hi, &p);
    next = common_star_quest(n, &p, find_about(n, &p, 0.5 * (s->lo + s->hi), 0.5 * (s->hi - s->lo)), s, &near, &far);
    if (next == HALVES)
        return search(n, k, within, &near, hits) && search(n, k, within, &far, hits);
    return next == NO_MORE || report(n, k, root_of(n, k, s, next == ONLY, hits), hits);
}

bool common_star_whole(const line *n, double from, bool out, common_span *within, stretch *all)
{
    const stretch whole = { from, n->span.hi, out, true, 26 };

    within->lo = from;
    within->hi = n->span.hi;
    clip_sums(n, within);
    if (within->lo > within->hi)
        return false;
    *all = whole;
    return true;
}

void common_superellipsoid_star(const line *n, const common_ray *k, double from, pov_hits *hits)
{
    common_span within;
    stretch all;

    if (common_star_whole(n, from, from > n->span.lo ? is_outside(n, from) : true, &within, &all))
        search(n, k, &within, &all, hits);
}
