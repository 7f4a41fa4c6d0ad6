/* torus.h - the arithmetic of a torus and a ray, and the search for their crossings: for one ray, and for several side by
 * side. */
#ifndef COMMON_TORUS_H
#define COMMON_TORUS_H

#include "common/lanes.h"
#include "common/roots.h"
#include "common/sphere.h"

/* By its radii: a ring; without the first radius a sphere, without the second one a circle, which rays only touch. */
typedef enum torus_kind { TORUS_RING, TORUS_SPHERE, TORUS_CIRCLE } torus_kind;

typedef struct torus {
    double R, r;                   /* times scale */
    double scale;                  /* a power of two that makes R + r of the order of one */
    pov_two ring, hollow, lens;    /* R^2; R^2 - r^2; what p.p is below on the inner sheet of a spindle, else 0 or less */
    double major, minor;           /* as written */
    torus_kind kind;
    common_sphere sphere;          /* the sphere */
} torus;

enum { ENTERING, EXITING };

/* The equation's value at a point. */
COMMON_INLINE pov_two value_at(const torus *t, pov_two3 p)
{
    const pov_two level = pov_two_add(pov_two_mul(p.x, p.x), pov_two_mul(p.z, p.z));
    const pov_two g = pov_two_add(pov_two_add(level, pov_two_mul(p.y, p.y)), t->hollow);

    return pov_two_sub(pov_two_mul(g, g), pov_two_scale(pov_two_mul(t->ring, level), 4.0));
}

/* Is a point inside the inner sheet of a spindle? */
static inline bool is_in_lens(const torus *t, pov_two3 p) { return t->lens.hi > 0.0 && pov_two_less(pov_two3_dot(p, p), t->lens); }

/* The interval of a ray that may hit the torus: points at `middle + x half`, x from -1 to 1. */
typedef struct stretch {
    const torus *torus;
    common_ray ray;
    double middle, half;
    pov_two3 w;                    /* the point at its middle */
    double lost;                   /* error of w from distant origins, in any arithmetic */
    double bend;                   /* the second derivative along x is not larger, from -1 to 1 */
} stretch;

/* 0: the ray misses the sphere, or the slab, around the torus. */
COMMON_INLINE int enter(stretch *s, const torus *t, const pov_ray *ray)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const double reach = t->R + t->r, square = reach * reach;
    double across, speed, within, least;
    pov_vec3 w;

    s->torus = t;
    s->ray = common_enter(ray, pov_two3_of(zero, zero), t->scale);
    speed = pov_dot(s->ray.d, s->ray.d);
    s->middle = -pov_dot(pov_two3_hi(s->ray.f), s->ray.d) / speed;
    s->w = common_along_two(&s->ray, s->middle);
    s->lost = 0x1p-98 * pov_largest(pov_two3_hi(s->ray.f));
    w = pov_two3_hi(s->w);
    across = pov_dot(w, w);
    within = square * (1.0 + 0x1p-20) - across;
    least = 0x1p-30 * square;
    /* The nearest point was rounded, by less than 2^-48 of its distance. */
    s->half = sqrt((within > least ? within : least) / speed) + 0x1p-48 * fabs(s->middle);
    return (int)(across <= square * (1.0 + 0x1p-40) + 8.0 * s->lost * reach) &
           (int)(fabs(w.y) <= fabs(s->ray.d.y) * s->half + t->r * (1.0 + 0x1p-40) + s->lost);
}

/* The quartic in x, and the sum of its coefficients' error bounds. Each is a sum of at most twelve rounded products. */
COMMON_INLINE double coefficients(stretch *s, double a[5])
{
    const double u = 16.0 * COMMON_U, four = 4.0 * s->torus->R * s->torus->R;
    const pov_vec3 w = pov_two3_hi(s->w), d = pov_scale(s->ray.d, s->half);
    const double dd = pov_dot(d, d), ww = pov_dot(w, w), b = 2.0 * pov_dot(w, d), g = ww + s->torus->hollow.hi;
    const double size = ww + s->torus->R * s->torus->R + s->torus->r * s->torus->r, b_error = u * sqrt(dd * ww);
    const double fd = d.x * d.x + d.z * d.z, fb = 2.0 * (w.x * d.x + w.z * d.z), fw = w.x * w.x + w.z * w.z;

    a[4] = dd * dd;
    a[3] = 2.0 * dd * b;
    a[2] = 2.0 * dd * g + b * b - four * fd;
    a[1] = 2.0 * b * g - four * fb;
    a[0] = g * g - four * fw;
    s->bend = 12.0 * (a[4] + fabs(a[3]) + fabs(a[2])) + 1.0;
    return u * (dd * dd + 2.0 * dd * size + four * (fd + 2.0 * sqrt(fd * fw) + fw) + size * size + 2.0 * fabs(b) * size) +
           b_error * (2.0 * dd + 2.0 * fabs(b) + 2.0 * size) + 64.0 * s->lost;
}

/* Half the equation's slope along x, in double. */
COMMON_INLINE double slope_at(const stretch *s, pov_two3 point)
{
    const torus *t = s->torus;
    const pov_vec3 p = pov_two3_hi(point), d = pov_scale(s->ray.d, s->half);
    const double g = pov_dot(p, p) + t->hollow.hi;

    return 2.0 * g * pov_dot(p, d) - 4.0 * t->ring.hi * (p.x * d.x + p.z * d.z);
}

COMMON_INLINE pov_two distance_at(const stretch *s, pov_two x)
{
    return pov_two_add_double(pov_two_mul_double(x, s->half), s->middle);
}

/* A step of Newton's method from x, and whether no more are needed: its error is its square times the second derivative
 * over the slope. */
COMMON_INLINE double step_at(const stretch *s, double slope, double value, int *last)
{
    const double step = -0.5 * value / slope;

    *last = (int)(fabs(step) <= 0x1p-70) | (int)(step * step * s->bend <= 0x1p-80 * fabs(slope));
    return step;
}

/* The search for crossings. A ray that starts on the torus has that root divided out: a cubic remains, from the start to
 * the end of the stretch: x = middle + y half. */
typedef struct search {
    stretch s;
    double a[5], error;            /* the quartic */
    common_range wanted;
    bool from_here, escalated;
    pov_two start, middle, half;   /* from here only */
    double cubic[4];
    common_brackets roots;         /* in x; from here in y */
} search;

/* The part of the stretch that counts between two distances, with a margin. */
COMMON_INLINE common_range range_of(const stretch *s, double tmin, double tmax)
{
    const double margin = 0x1p-40 * (1.0 + fabs(s->middle) / s->half), per = s->ray.per_unit;
    const double start = (tmin * per - s->middle) / s->half, end = (tmax * per - s->middle) / s->half;
    const common_range part = { start - margin, start + margin, end + margin, true };

    return part;
}

/* The normal points out of the circle in the middle of the tube. Not of unit length. */
COMMON_INLINE pov_vec3 normal_at(const torus *t, const pov_ray *ray, double at, double at_lo)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), t->scale);
    const pov_two3 p = common_along_dd(&k, pov_two_of(at * k.per_unit, at_lo * k.per_unit));
    const pov_two axis = pov_two_sqrt(pov_two_add(pov_two_mul(p.x, p.x), pov_two_mul(p.z, p.z)));
    const double outward = axis.hi > 0.0 ? pov_two_add_double(axis, -t->R).hi / axis.hi : 0.0;

    return pov_vec3_of(p.x.hi * outward, p.y.hi, p.z.hi * outward);
}

/* Is the first crossing enough? The inner sheet of a spindle is no hit. */
bool common_torus_wants_first(const torus *t, const pov_hits *hits);
/* Isolates the roots: those that count, if double does. */
void common_torus_begin(search *r, bool from_here, pov_hits *hits);
/* The bracket of a root in x, and where in it the root is about. */
common_bracket common_torus_bracket(const search *r, uint32_t i);
double common_torus_start(const search *r, uint32_t i);
/* Where any crossing will do, does one certainly lie in the interval? Its distance need not be known. */
bool common_torus_is_blocked(const stretch *s, const common_bracket *root, common_range wanted, pov_hits *hits);
/* Newton's method in double-double, kept in the bracket: a single step as a rule. */
pov_two common_torus_complete(const stretch *s, double start, const common_bracket *root);
/* At the distance t in local units. False: no more crossings are wanted. */
bool common_torus_report(const stretch *s, pov_two t, bool rising, bool escalated, pov_hits *hits);
/* Reports the crossings from the i-th on. */
void common_torus_finish(const search *r, uint32_t i, pov_hits *hits);

/* Functions of the class. */
void common_torus_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
void common_torus_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
void common_torus_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
void common_torus_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                              pov_vec3 *const *out, uint32_t n);
uint32_t common_torus_narrow(const void *self, const pov_own_map *map, uint32_t owner, const pov_rays *rays, pov_candidate *io, uint32_t n);

#endif
