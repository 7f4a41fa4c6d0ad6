/* sphere.h - a sphere's kernel.
 *
 * The ray is re-centred at its closest approach to the centre, where the roots are as large as the sphere
 * and not as the distance. docs/numerics.md derives the bounds. */
#ifndef COMMON_SPHERE_H
#define COMMON_SPHERE_H

#include "common/report.h"

/* One cache line: all other numbers of intersect() are computed from these two as fast as they could be loaded. */
typedef struct common_sphere {
    pov_two3 centre;
    pov_two radius;
} common_sphere;

/* Power of two that scales the radius into [1, 2). */
static inline double common_sphere_scale(const common_sphere *s) { return pov_inverse_power(s->radius.hi); }

/* The square of the scaled radius. */
static inline pov_two common_sphere_square(const common_sphere *s)
{
    pov_two r = pov_two_scale(s->radius, common_sphere_scale(s));
    return pov_two_mul(r, r);
}

COMMON_INLINE common_residual common_sphere_residual(pov_two square, const common_ray *k, pov_two3 w)
{
    common_residual r;

    r.value = pov_two_sub(pov_two3_dot(w, w), square).hi;
    r.error = 0x1p-100 * square.hi;
    r.half_slope = pov_dot(pov_two3_hi(w), k->d);
    r.slope_error = 6.0 * COMMON_U * common_sum_of_sizes(pov_two3_hi(w), k->d);
    return r;
}

/* The chord of a ray in a sphere, in double: its midpoint, and the remaining distance b to the midpoint; the
 * discriminant with an error bound; and, where the discriminant is certainly positive, its root and an error bound of
 * both ends. */
typedef struct common_chord { double middle, inverse, b, d, d_error, root, error; } common_chord;

static inline common_chord common_find_chord(pov_two square, const common_ray *k)
{
    const double u = COMMON_U;
    const double a = pov_dot(k->d, k->d);
    pov_vec3 w;
    double ww, b_error, c, c_error;
    common_chord h;

    h.inverse = 1.0 / a;
    h.middle = -pov_dot(pov_two3_hi(k->f), k->d) * h.inverse;
    w = common_along(k, h.middle);
    ww = pov_dot(w, w);
    h.b = pov_dot(w, k->d);
    c = square.hi - ww;
    b_error = 10.0 * u * common_sum_of_sizes(w, k->d) + u * u * a;
    c_error = u * (square.hi + 6.0 * ww);
    h.d = c * a + h.b * h.b;
    h.d_error = c_error * a + 2.0 * fabs(h.b) * b_error + b_error * b_error;
    h.root = sqrt(h.d);
    h.error = (b_error + 0.52 * h.d_error / h.root + u * (13.0 * h.root + 9.0 * fabs(h.b))) * h.inverse;
    return h;
}

/* Does the ray certainly cross the sphere? */
static inline bool common_is_cut(const common_chord *h) { return h->d > 16.0 * h->d_error; }

static inline common_root common_near_end(const common_chord *h)
{
    common_root r = { pov_two_sum(h->middle, (-h->b - h->root) * h->inverse), h->error, 0, POV_MARK_CLOSED };
    return r;
}

static inline common_root common_far_end(const common_chord *h)
{
    common_root r = { pov_two_sum(h->middle, (-h->b + h->root) * h->inverse), h->error, 1, POV_MARK_CLOSED };
    return r;
}

/* Is re-centring to one double exact enough? */
static inline bool common_sphere_is_near(const common_ray *k) { return pov_largest(pov_two3_hi(k->f)) < COMMON_FAR; }

/* From the centre to the crossing, scaled. */
static inline pov_vec3 common_sphere_offset(const common_sphere *s, const pov_ray *ray, const pov_crossing *at)
{
    common_ray k = common_enter(ray, s->centre, common_sphere_scale(s));

    return pov_two3_hi(common_point(&k, at));
}

/* From the centre to the point, scaled. */
static inline pov_vec3 common_sphere_offset_of(const common_sphere *s, pov_vec3 point, pov_vec3 point_lo)
{
    return pov_two3_hi(common_offset(point, point_lo, s->centre, common_sphere_scale(s)));
}

/* The contract's functions; selves are common_spheres. */
void common_sphere_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
void common_sphere_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
void common_sphere_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                  uint32_t n);
uint64_t common_sphere_cross_sure(const void *const *selves, const pov_ray *const *rays, pov_crossing *const *at, pov_contact *const *contacts,
                                  uint32_t n);
void common_sphere_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                               pov_vec3 *const *out, uint32_t n);
void common_sphere_normal_at_many(const void *const *selves, const pov_vec3 *const *points, pov_vec3 *const *out, uint32_t n);

#endif
