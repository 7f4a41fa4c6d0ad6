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

/* How the size, to the power 2 / n, grows along a stretch where no coordinate changes its sign: bounds of each coordinate's part and of what
 * multiplies those of x and y, from what is nearest to the planes of the coordinates and what is farthest from them. */
COMMON_CLONES static void find_growths(double e, double n, const places *restrict p, double *restrict x, double *restrict y,
                                       double *restrict z, double *restrict ring)
{
    for (uint32_t i = 0; i < PLACES + 1; i++) {
        const double a = fabs(p->x[i]), b = fabs(p->y[i]), by_x = approx_power(a, 2.0 / e - 1.0), by_y = approx_power(b, 2.0 / e - 1.0);

        x[i] = by_x * (2.0 / e);
        y[i] = by_y * (2.0 / e);
        z[i] = approx_power(fabs(p->z[i]), 2.0 / n - 1.0) * (2.0 / n);
        ring[i] = approx_power(a * by_x + b * by_y, e / n - 1.0) * (e / n);
    }
}

/* The least and the greatest of a factor between two values, times one of any sign, and more than what powers are off. */
typedef struct range { double lo, hi; } range;

static range times(double a, double b, double by)
{
    const double most = larger(a, b) * (1.0 + 0x1p-10) * by, least = smaller(a, b) * (1.0 - 0x1p-10) * by;
    const range r = { smaller(least, most), larger(least, most) };

    return r;
}

/* Does the size certainly grow all along a stretch, or certainly fall? */
static bool is_monotonic(const line *n, const places *p, double lo)
{
    const pov_vec3 a = pov_add(n->o, pov_scale(n->d, lo));
    place_lanes by_x, by_y, by_z, by_ring;
    range x, y, z, sum;

    if (!n->s->approx || !(p->x[NEAREST] > 0x1p-30 && p->y[NEAREST] > 0x1p-30 && p->z[NEAREST] > 0x1p-30))
        return false;
    find_growths(n->s->e, n->s->n, p, by_x, by_y, by_z, by_ring);
    x = times(by_x[NEAREST], by_x[FARTHEST], copysign(n->d.x, n->d.x * a.x));
    y = times(by_y[NEAREST], by_y[FARTHEST], copysign(n->d.y, n->d.y * a.y));
    z = times(by_z[NEAREST], by_z[FARTHEST], copysign(n->d.z, n->d.z * a.z));
    sum.lo = times(by_ring[NEAREST], by_ring[FARTHEST], x.lo + y.lo).lo + z.lo;
    sum.hi = times(by_ring[NEAREST], by_ring[FARTHEST], x.hi + y.hi).hi + z.hi;
    return sum.lo > 0.0 || sum.hi < 0.0;
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

    /* Behind a crossing that is known, or the end. */
    if ((n->base + s.lo) * k->unit > (hits->tmax + hits->slack) * (1.0 + 0x1p-40))
        return true;
    find_places(n, s.lo, s.hi, &p);
    if (side_of(n, &p) != 0)
        return true;
    if (s.out == s.still && is_monotonic(n, &p, s.lo))
        return true;
    if (depth == 0 || (s.out != s.still && depth < 16))
        return s.out == s.still || report(n, k, is_any_between(n, k, s.lo, s.hi, hits) ? middle : bisect(n, s.lo, s.hi, s.out), hits);
    near.hi = far.lo = middle;
    near.still = far.out = is_place_above(n, &p, MIDDLE, 1.0);
    return search(n, k, near, depth - 1, hits) && search(n, k, far, depth - 1, hits);
}

void common_superellipsoid_star(const line *n, const common_ray *k, double from, pov_hits *hits)
{
    const stretch all = { from, n->span.hi, is_outside(n, from), is_outside(n, n->span.hi) };

    search(n, k, all, 26, hits);
}
