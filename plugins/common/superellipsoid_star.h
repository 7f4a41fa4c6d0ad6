/* superellipsoid_star.h - shared parts of the search of superellipsoids with an exponent above 2: ray by ray, and several side by side. */
#ifndef COMMON_SUPERELLIPSOID_STAR_H
#define COMMON_SUPERELLIPSOID_STAR_H

#include "common/superellipsoid.h"

COMMON_INLINE double smaller(double a, double b) { return a < b ? a : b; }
COMMON_INLINE double larger(double a, double b) { return a > b ? a : b; }
COMMON_INLINE double least_of(double a, double b) { return (a < 0.0) != (b < 0.0) ? 0.0 : smaller(fabs(a), fabs(b)); }

/* The size to the power 2 / n of a point, with approximate powers, and how it grows with each coordinate: `ring` times that of x and y, and
 * that of z. */
typedef struct star_power { double value, by_x, by_y, by_z, ring; } star_power;

/* The powers, and what those of numbers of about zero grow by. */
typedef struct star_powers { double e, n, ring, at_zero_e, at_zero_n; } star_powers;

COMMON_INLINE double growth_at_zero(double y) { return y == 1.0 ? 1.0 : y < 1.0 ? HUGE_VAL : 0.0; }

COMMON_INLINE star_powers powers_of(const superellipsoid *s)
{
    const star_powers p = { 2.0 / s->e, 2.0 / s->n, s->e / s->n, growth_at_zero(2.0 / s->e), growth_at_zero(2.0 / s->n) };

    return p;
}

/* What a power grows by with its base, which is x or nearer to zero. */
COMMON_INLINE double growth_of(double power, double x, double y, double at_zero)
{
    const double by = y * power / x;

    return x > 0x1p-30 ? by : at_zero;
}

COMMON_INLINE star_power power_at(const star_powers *s, double at_x, double at_y, double at_z)
{
    const double x = fabs(at_x), y = fabs(at_y), z = fabs(at_z);
    const double of_x = approx_power(x, s->e), of_y = approx_power(y, s->e), of_z = approx_power(z, s->n);
    const double ring = approx_power(of_x + of_y, s->ring);
    const star_power p = { ring + of_z, growth_of(of_x, x, s->e, s->at_zero_e), growth_of(of_y, y, s->e, s->at_zero_e),
                           growth_of(of_z, z, s->n, s->at_zero_n), ring / (of_x + of_y) * s->ring };

    return p;
}

/* The least and the greatest of a factor between two values, times one of any sign, and more than what powers are off. */
typedef struct range { double lo, hi; } range;

COMMON_INLINE range times(double a, double b, double by)
{
    const double most = larger(a, b) * (1.0 + 0x1p-10) * by, least = smaller(a, b) * (1.0 - 0x1p-10) * by;
    const range r = { smaller(least, most), larger(least, most) };

    return r;
}

/* Bounds of how the power grows along a direction d, where no coordinate is zero, from what is nearest to zero to what is farthest; `at`: of
 * the coordinates' signs. */
COMMON_INLINE range growth_between(const star_power *a, const star_power *b, pov_vec3 d, pov_vec3 at)
{
    const range x = times(a->by_x, b->by_x, copysign(d.x, d.x * at.x));
    const range y = times(a->by_y, b->by_y, copysign(d.y, d.y * at.y));
    const range z = times(a->by_z, b->by_z, copysign(d.z, d.z * at.z));
    const range by = { times(a->ring, b->ring, x.lo + y.lo).lo + z.lo, times(a->ring, b->ring, x.hi + y.hi).hi + z.hi };

    return by;
}

/* What is known of a stretch: its points are all outside, or all inside; its size grows or falls all along, so that it has one crossing
 * at most; or nothing. */
typedef enum known { OUTSIDE, INSIDE, MONOTONIC, NOTHING } known;

/* By approximate sizes; `off`: is no coordinate zero? */
COMMON_INLINE known known_of(const star_power *nearest, const star_power *farthest, double middle, bool off, pov_vec3 d, pov_vec3 at, double half)
{
    const range by = growth_between(nearest, farthest, d, at);
    const double most = half * larger(fabs(by.lo), fabs(by.hi)) + APPROX;
    const known all = (middle - 1.0 > most) ? OUTSIDE : (1.0 - middle > most) ? INSIDE : ((by.lo > 0.0) | (by.hi < 0.0)) ? MONOTONIC : NOTHING;

    return nearest->value - 1.0 > APPROX ? OUTSIDE : 1.0 - farthest->value > APPROX ? INSIDE : off ? all : NOTHING;
}

/* Of a stretch: what is nearest to the planes of its coordinates, what is farthest from them, and its middle; with approximate sizes, to
 * the power 2 / n, and exact ones where these do not tell them from one. */
enum { NEAREST, FARTHEST, MIDDLE, PLACES };
typedef double place_lanes[PLACES + 1];
typedef struct places { place_lanes x, y, z, approx, by_x, by_y, by_z, ring, size, shares; bool exact; } places;

/* A stretch: its ends, and on which side they are; how often it may be halved. */
typedef struct stretch { double lo, hi; bool out, still; int depth; } stretch;

/* What a stretch may be searched for: nothing more, its only crossing, a crossing, or its halves. */
typedef enum quest { NO_MORE, ONLY, CROSSING, HALVES } quest;

/* Its places have approximate sizes, by which `about` is known. */
quest common_star_quest(const line *n, places *p, known about, const stretch *s, stretch *near, stretch *far);

/* A crossing between the ends of a stretch, which are on different sides. */
double common_star_bisect(const line *n, double lo, double hi, bool is_out);

/* Does any crossing do, so that it need not be known where it lies between two distances? */
COMMON_INLINE bool is_any_between(const line *n, const common_ray *k, double lo, double hi, const pov_hits *hits)
{
    return hits->want == POV_WANT_ANY && (n->base + lo) * k->unit > hits->tmin && (n->base + hi) * k->unit < hits->tmax - hits->slack;
}

/* Can nothing be there: is it beyond where a star may be, behind a crossing that is known, or behind the end? */
COMMON_INLINE bool is_past(const line *n, const common_ray *k, const common_span *within, const stretch *s, const pov_hits *hits)
{
    return s->hi < within->lo || s->lo > within->hi || (n->base + s->lo) * k->unit > (hits->tmax + hits->slack) * (1.0 + 0x1p-40);
}

/* The whole, from a distance on; is it outside there? False: nothing can be there. */
bool common_star_whole(const line *n, double from, bool out, common_span *within, stretch *all);

/* Turns of Newton's method between two points. */
enum { APPROX_TURNS = 40, EXACT_TURNS = 80 };

/* Several, whose approximate sizes are of use. */
typedef struct star_ray { line n; common_ray k; double from; pov_hits *hits; } star_ray;
enum { STARS = 16 };
void common_superellipsoid_stars(const star_ray *rays, uint32_t n);

#endif
