/* quadric_approx.h - quadric surfaces along a ray, in double with error bounds, and the refinement step of a
 * crossing: shared by single rays and lanes of rays. */
#ifndef COMMON_QUADRIC_APPROX_H
#define COMMON_QUADRIC_APPROX_H

#include "common/report.h"
#include "common/quadric.h"

/* Feature of a crossing: the ray enters negative values, or leaves them. */
enum { ENTERING = 0, EXITING = 1 };

static inline uint32_t quadric_mark(const common_quadric *s) { return s->closed ? POV_MARK_CLOSED : 0; }

/* ---- what is left after cancelling ---- */

static inline pov_two half(pov_two a) { return pov_two_scale(a, 0.5); }

/* Error below 3 u^2 of both sizes. */
COMMON_INLINE pov_two fast_sum(pov_two a, pov_two b)
{
    const pov_two s = pov_two_sum(a.hi, b.hi);
    return pov_two_sum(s.hi, s.lo + (a.lo + b.lo));
}

/* As common_half_gradient() and common_value(), within 2^-99 and 2^-98 of the sum of the sizes of all terms. */
COMMON_INLINE pov_two3 fast_half_gradient(const pov_two *q, pov_two3 p)
{
    const pov_two d = half(q[D]), e = half(q[E]), f = half(q[F]);
    const pov_two3 x = { q[A], d, e }, y = { d, q[B], f }, z = { e, f, q[C] };
    pov_two3 g;

    g.x = fast_sum(common_fast_dot(x, p), half(q[G]));
    g.y = fast_sum(common_fast_dot(y, p), half(q[H]));
    g.z = fast_sum(common_fast_dot(z, p), half(q[I]));
    return g;
}

COMMON_INLINE pov_two fast_value(const pov_two *q, pov_two3 p, pov_two3 g)
{
    g.x = fast_sum(g.x, half(q[G]));
    g.y = fast_sum(g.y, half(q[H]));
    g.z = fast_sum(g.z, half(q[I]));
    return fast_sum(common_fast_dot(p, g), q[J]);
}

/* ---- along a ray ---- */

/* Coefficients along the ray through w with direction d, from `q`: second order, first order and value. With the sizes
 * of coefficients and components in their place: the sums of the sizes of all terms. */
COMMON_INLINE double along_second(const double *q, pov_vec3 d)
{
    return d.x * (q[A] * d.x + q[D] * d.y + q[E] * d.z) + d.y * (q[B] * d.y + q[F] * d.z) + q[C] * d.z * d.z;
}

COMMON_INLINE double along_first(const double *q, pov_vec3 w, pov_vec3 d)
{
    return d.x * (q[A] * w.x + 0.5 * (q[D] * w.y + q[E] * w.z + q[G]))
           + d.y * (q[B] * w.y + 0.5 * (q[D] * w.x + q[F] * w.z + q[H]))
           + d.z * (q[C] * w.z + 0.5 * (q[E] * w.x + q[F] * w.y + q[I]));
}

COMMON_INLINE double along_value(const double *q, pov_vec3 w)
{
    return w.x * (q[A] * w.x + q[D] * w.y + q[E] * w.z + q[G]) + w.y * (q[B] * w.y + q[F] * w.z + q[H])
           + w.z * (q[C] * w.z + q[I]) + q[J];
}

/* Absolute values, each with a slack. */
static inline pov_vec3 sizes(pov_vec3 a, double slack)
{
    return pov_vec3_of(fabs(a.x) + slack, fabs(a.y) + slack, fabs(a.z) + slack);
}

typedef struct along { double a, b, c, a_error, b_error, c_error; } along;

/* Error of along_value() at a point whose largest component is that. */
COMMON_INLINE double value_error(const common_quadric *s, double far)
{
    return 12.0 * COMMON_U * ((s->sum2 * far + s->sum1) * far + s->size[J]);
}

/* The coefficients at the ray's origin. The sizes of the terms are bounded by the largest component of the origin and
 * by the direction's, which is below 2. */
COMMON_INLINE along measure_at_origin(const common_quadric *s, const common_ray *k)
{
    const pov_vec3 f = pov_two3_hi(k->f);
    const double far = pov_largest(f);
    along r;

    r.a = along_second(s->approx, k->d);
    r.b = along_first(s->approx, f, k->d);
    r.c = along_value(s->approx, f);
    r.a_error = 40.0 * COMMON_U * s->sum2;
    r.b_error = 22.0 * COMMON_U * (s->sum2 * far + 0.5 * s->sum1);
    r.c_error = value_error(s, far);
    return r;
}

COMMON_INLINE double discriminant_of(const along *r) { return r->b * r->b - r->a * r->c; }

COMMON_INLINE double discriminant_error(const along *r)
{
    return (2.0 * fabs(r->b) + r->b_error) * r->b_error + (fabs(r->a) + r->a_error) * r->c_error +
           fabs(r->c) * r->a_error + 3.0 * COMMON_U * (r->b * r->b + fabs(r->a * r->c));
}

/* There are definitely two roots, and both are accurate enough. */
static inline int is_cut(const along *r, double d, double d_error)
{
    return (int)(d > 16.0 * d_error) & (int)(fabs(r->a) > 1024.0 * r->a_error) & (int)(fabs(r->a) > COMMON_TINY);
}

/* Common error of both roots; and the part that depends on the size of one. */
COMMON_INLINE double roots_error(const along *r, double root, double d_error)
{
    return (r->b_error + 0.52 * d_error / root + COMMON_U * (root + fabs(r->b))) / (0.9 * fabs(r->a));
}

COMMON_INLINE double root_error(const along *r, double t, double error)
{
    return error + fabs(t) * (1.1 * r->a_error / fabs(r->a) + 2.0 * COMMON_U);
}

COMMON_INLINE common_residual quadric_residual(const common_quadric *s, const common_ray *k, pov_two3 w)
{
    const pov_two3 g = fast_half_gradient(s->q, w);
    common_residual r;

    r.value = fast_value(s->q, w, g).hi;
    r.error = 0x1p-98 * along_value(s->size, sizes(pov_two3_hi(w), 0.0));
    r.half_slope = pov_dot(pov_two3_hi(g), k->d);
    r.slope_error = 6.0 * COMMON_U * common_sum_of_sizes(pov_two3_hi(g), k->d);
    return r;
}

/* ---- normals ---- */

/* At the point of a crossing, moved onto the surface by a Newton step along the ray: on strongly curved surfaces the
 * distance alone is too inaccurate for a normal. Steps longer than this limit are not taken: a ray that only touches
 * the surface has none, and a point that is off by much is not moved. */
#define QUADRIC_STEP 0x1p-30

COMMON_INLINE double step_to(const common_quadric *s, const common_ray *k, pov_two3 p, pov_two3 g)
{
    return -0.5 * fast_value(s->q, p, g).hi / pov_dot(pov_two3_hi(g), k->d);
}

/* The gradient changes by the matrix times the step; that is so small that plain double is enough. */
COMMON_INLINE pov_vec3 gradient_beyond(const common_quadric *s, const common_ray *k, pov_two3 g, double step)
{
    const double *q = s->approx;
    const pov_vec3 move = pov_vec3_of(q[A] * k->d.x + 0.5 * (q[D] * k->d.y + q[E] * k->d.z),
                                      q[B] * k->d.y + 0.5 * (q[D] * k->d.x + q[F] * k->d.z),
                                      q[C] * k->d.z + 0.5 * (q[E] * k->d.x + q[F] * k->d.y));

    return pov_vec3_of(g.x.hi + (g.x.lo + step * move.x), g.y.hi + (g.y.lo + step * move.y),
                       g.z.hi + (g.z.lo + step * move.z));
}

/* ---- planes ---- */

/* The equation of a plane along a ray, which has no second order: its value at the ray's start and its change along the ray, off by
 * less than 2^-98 of the sizes. In double-double they give the crossing as exactly. */
typedef struct plane_along { pov_two value, slope; double value_size, slope_size; } plane_along;

COMMON_INLINE plane_along along_plane(pov_two3 n, pov_two at_anchor, const common_ray *k)
{
    const pov_vec3 n_size = pov_vec3_of(fabs(n.x.hi), fabs(n.y.hi), fabs(n.z.hi));
    const plane_along a = { pov_two_add(common_fast_dot(n, k->f), at_anchor), common_fast_dot(n, common_direction(k)),
                            common_sum_of_sizes(n_size, pov_two3_hi(k->f)) + fabs(at_anchor.hi), common_sum_of_sizes(n_size, k->d) };

    return a;
}

/* The same, bit for bit, of a plane across an axis, n a power of two: f and d are the ray's along that axis. */
COMMON_INLINE plane_along along_level(double n, pov_two at_anchor, pov_two f, pov_two d)
{
    const plane_along a = { pov_two_add(pov_two_sum(n * f.hi, n * f.lo), at_anchor), pov_two_sum(n * d.hi, n * d.lo),
                            fabs(n * f.hi) + fabs(at_anchor.hi), fabs(n * d.hi) };

    return a;
}

COMMON_INLINE pov_two plane_root(pov_two value, pov_two slope) { return pov_two_neg(pov_two_div(value, slope)); }

/* The bound of the root's error times the slope's size; and does it hold? */
COMMON_INLINE double plane_error(const plane_along *a, double t)
{
    return 1.1 * (0x1p-98 * a->value_size + fabs(t) * (0x1p-98 * a->slope_size)) + 0x1p-100 * fabs(t * a->slope.hi);
}

COMMON_INLINE int plane_is_sound(const plane_along *a)
{
    const double size = fabs(a->slope.hi);

    return (int)(size > 0x1p-94 * a->slope_size) & (int)(size > COMMON_TINY) & (int)(fabs(a->value.hi) > COMMON_TINY);
}

COMMON_INLINE common_root plane_cross(const plane_along *a)
{
    const pov_two t = plane_root(a->value, a->slope);
    const common_root root = { t, plane_error(a, t.hi) / fabs(a->slope.hi), 0, 0 };

    return root;
}

#endif
