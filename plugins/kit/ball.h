/* ball.h - a sphere's kernel.
 *
 * The ray is re-centred at its closest approach to the centre, where the roots are as large as the sphere
 * and not as the distance. docs/numerics.md derives the bounds. */
#ifndef KIT_BALL_H
#define KIT_BALL_H

#include "kit/report.h"

/* One cache line: all other numbers of intersect() are computed from these two as fast as they could be loaded. */
typedef struct kit_ball {
    pov_two3 centre;
    pov_two radius;
} kit_ball;

/* Power of two that scales the radius into [1, 2). */
static inline double kit_ball_scale(const kit_ball *s) { return pov_inverse_power(s->radius.hi); }

/* The square of the scaled radius. */
static inline pov_two kit_ball_square(const kit_ball *s)
{
    pov_two r = pov_two_scale(s->radius, kit_ball_scale(s));
    return pov_two_mul(r, r);
}

KIT_INLINE kit_residual kit_ball_residual(pov_two square, const kit_ray *k, pov_two3 w)
{
    kit_residual r;

    r.value = pov_two_sub(pov_two3_dot(w, w), square).hi;
    r.error = 0x1p-100 * square.hi;
    r.half_slope = pov_dot(pov_two3_hi(w), k->d);
    r.slope_error = 6.0 * KIT_U * kit_sum_of_sizes(pov_two3_hi(w), k->d);
    return r;
}

/* The chord of a ray in a sphere, in double: its midpoint, and the remaining distance b to the midpoint; the
 * discriminant with an error bound; and, where the discriminant is certainly positive, its root and an error bound of
 * both ends. */
typedef struct kit_chord { double middle, inverse, b, d, d_error, root, error; } kit_chord;

static inline kit_chord kit_find_chord(pov_two square, const kit_ray *k)
{
    const double u = KIT_U;
    const double a = pov_dot(k->d, k->d);
    pov_vec3 w;
    double ww, b_error, c, c_error;
    kit_chord h;

    h.inverse = 1.0 / a;
    h.middle = -pov_dot(pov_two3_hi(k->f), k->d) * h.inverse;
    w = kit_along(k, h.middle);
    ww = pov_dot(w, w);
    h.b = pov_dot(w, k->d);
    c = square.hi - ww;
    b_error = 10.0 * u * kit_sum_of_sizes(w, k->d) + u * u * a;
    c_error = u * (square.hi + 6.0 * ww);
    h.d = c * a + h.b * h.b;
    h.d_error = c_error * a + 2.0 * fabs(h.b) * b_error + b_error * b_error;
    h.root = sqrt(h.d);
    h.error = (b_error + 0.52 * h.d_error / h.root + u * (13.0 * h.root + 9.0 * fabs(h.b))) * h.inverse;
    return h;
}

/* Does the ray certainly cross the sphere? */
static inline bool kit_is_cut(const kit_chord *h) { return h->d > 16.0 * h->d_error; }

static inline kit_root kit_near_end(const kit_chord *h)
{
    kit_root r = { pov_two_sum(h->middle, (-h->b - h->root) * h->inverse), h->error, 0, POV_MARK_CLOSED };
    return r;
}

static inline kit_root kit_far_end(const kit_chord *h)
{
    kit_root r = { pov_two_sum(h->middle, (-h->b + h->root) * h->inverse), h->error, 1, POV_MARK_CLOSED };
    return r;
}

/* Is re-centring to one double exact enough? */
static inline bool kit_ball_is_near(const kit_ray *k) { return pov_largest(pov_two3_hi(k->f)) < KIT_FAR; }

/* From the centre to the crossing, scaled. */
static inline pov_vec3 kit_ball_offset(const kit_ball *s, const pov_ray *ray, const pov_crossing *at)
{
    kit_ray k = kit_enter(ray, s->centre, kit_ball_scale(s));

    return pov_two3_hi(kit_point(&k, at));
}

/* The contract's functions; selves are kit_balls. */
void kit_ball_intersect(const void *self, const pov_ray *ray, pov_hits *hits);
void kit_ball_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out);
void kit_ball_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n);
void kit_ball_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                          pov_vec3 *const *out, uint32_t n);

#endif
