/* cone_approx.h - double precision with running error bounds: shared by single rays and lanes of rays. */
#ifndef COMMON_CONE_APPROX_H
#define COMMON_CONE_APPROX_H

#include "common/cone_internal.h"
#include "common/simd.h"

typedef struct bounded { double v, e; } bounded;   /* the exact value is within e of v */

COMMON_INLINE bounded bounded_of(double v, double e) { bounded b; b.v = v; b.e = e; return b; }

/* A row times a vector with errors of one rounding of each component, and of `slack` more: six roundings in all, or one
 * if the row is a coordinate axis. */
COMMON_INLINE bounded row_times(const common_cone *s, int i, pov_vec3 w, double slack)
{
    const pov_two3 *row = &s->row[i];
    const double x = row->x.hi * w.x, y = row->y.hi * w.y, z = row->z.hi * w.z;
    const double lost = fabs(row->x.hi) + fabs(row->y.hi) + fabs(row->z.hi);

    return bounded_of(x + y + z, s->loss[i] * (fabs(x) + fabs(y) + fabs(z) + slack * lost));
}

COMMON_INLINE bounded times(bounded a, bounded b)
{
    const double v = a.v * b.v;
    return bounded_of(v, fabs(a.v) * b.e + a.e * (fabs(b.v) + b.e) + COMMON_U * fabs(v));
}

COMMON_INLINE bounded plus(bounded a, bounded b)
{
    const double v = a.v + b.v;
    return bounded_of(v, a.e + b.e + COMMON_U * fabs(v));
}

COMMON_INLINE bounded minus(bounded a, bounded b)
{
    b.v = -b.v;
    return plus(a, b);
}

COMMON_INLINE bounded over(bounded a, bounded b)
{
    const double v = a.v / b.v;
    return bounded_of(v, (a.e + fabs(v) * b.e) / (fabs(b.v) - b.e) + COMMON_U * fabs(v));
}

/* Is the sign certain, even with twice the bound? The factor covers the bound's own roundings. */
COMMON_INLINE bool is_certain(bounded a) { return fabs(a.v) > 2.0 * a.e; }

typedef struct approx { bounded x, y, z, dx, dy, dz, r, grow; } approx;

/* Two components perpendicular to the axis: the larger error, the larger size, and the sum of sizes. */
typedef struct approx_pair { double off, most, size; } approx_pair;

COMMON_INLINE approx_pair pair_of(bounded a, bounded b)
{
    approx_pair p;

    p.off = common_greater(a.e, b.e);
    p.most = common_greater(fabs(a.v), fabs(b.v));
    p.size = fabs(a.v) + fabs(b.v);
    return p;
}

/* Errors of a product, a square, and the sum of two squares, from those of the factors. */
COMMON_INLINE double off_by(double a, double a_off, double b, double b_off) { return a * b_off + a_off * (b + b_off); }
COMMON_INLINE double off_by_square(double a, double off) { return off * (2.0 * a + off); }
COMMON_INLINE double off_by_squares(approx_pair a) { return 2.0 * a.off * (a.size + a.off); }

/* The equation of the side along the ray, a t^2 + 2 b t + c, and its discriminant p^2 + q^2 - m^2. Error rules as
 * above, with common terms factored out. */
typedef struct approx_equation { bounded a, b, c, discriminant; } approx_equation;

COMMON_INLINE approx_equation equation_of(const approx *g)
{
    const double u = COMMON_U, x = g->x.v, y = g->y.v, r = g->r.v, dx = g->dx.v, dy = g->dy.v, grow = g->grow.v;
    const double far = fabs(r), steep = fabs(grow), p = r * dx - grow * x, q = r * dy - grow * y, m = x * dy - y * dx;
    const double dir2 = dx * dx + dy * dy, grow2 = grow * grow, out2 = x * x + y * y, r2 = r * r, pq2 = p * p + q * q;
    const approx_pair out = pair_of(g->x, g->y), dir = pair_of(g->dx, g->dy);
    const double pq_off = off_by(far, g->r.e, dir.most, dir.off) + off_by(steep, g->grow.e, out.most, out.off)
                          + 2.0 * u * (far * dir.most + steep * out.most);
    /* Errors of m, and of x dx + y dy. */
    const double m_off = out.size * dir.off + out.off * (dir.size + 2.0 * dir.off) + 3.0 * u * out.size * dir.most;
    const approx_pair pq = { pq_off, 0.0, fabs(p) + fabs(q) };
    approx_equation e;

    e.a = bounded_of(dir2 - grow2, off_by_squares(dir) + off_by_square(steep, g->grow.e) + 3.0 * u * (dir2 + grow2));
    e.b = bounded_of(x * dx + y * dy - r * grow, m_off + off_by(far, g->r.e, steep, g->grow.e) + 3.0 * u * far * steep);
    e.c = bounded_of(out2 - r2, off_by_squares(out) + off_by_square(far, g->r.e) + 3.0 * u * (out2 + r2));
    e.discriminant = bounded_of(pq2 - m * m, off_by_squares(pq) + off_by_square(fabs(m), m_off) + 3.0 * u * (pq2 + m * m));
    return e;
}

COMMON_INLINE common_root root_of(double middle, bounded t, uint32_t feature, uint32_t flags)
{
    common_root r;

    r.t = pov_two_sum(middle, t.v);
    r.error = t.e;
    r.feature = feature;
    r.flags = flags;
    return r;
}

/* The slope, rounded. */
COMMON_INLINE bounded slope_of(const common_cone *s) { return bounded_of(s->slope.hi, COMMON_U * fabs(s->slope.hi)); }

/* A ray at its closest approach to the centre of the axis, in local lengths. Any point near the shape would do. */
COMMON_INLINE double find_middle(const common_cone *s, const common_ray *k, approx *g)
{
    const pov_vec3 f = pov_two3_hi(k->f);
    const double x = row_times(s, 0, f, 0.0).v, y = row_times(s, 1, f, 0.0).v, z = row_times(s, 2, f, 0.0).v;

    g->dx = row_times(s, 0, k->d, 0.0);
    g->dy = row_times(s, 1, k->d, 0.0);
    g->dz = row_times(s, 2, k->d, 0.0);
    g->grow = times(slope_of(s), g->dz);
    return -(x * g->dx.v + y * g->dy.v + (z - 0.5 * s->height.hi) * g->dz.v)
           / (g->dx.v * g->dx.v + g->dy.v * g->dy.v + g->dz.v * g->dz.v);
}

COMMON_INLINE void find_point(const common_cone *s, const common_ray *k, double middle, approx *g)
{
    const pov_vec3 w = common_along(k, middle);
    const double slack = common_far_slack(k);

    g->x = row_times(s, 0, w, slack);
    g->y = row_times(s, 1, w, slack);
    g->z = row_times(s, 2, w, slack);
    g->r = plus(bounded_of(s->radius.hi, COMMON_U * s->radius.hi), times(slope_of(s), g->z));
}

#endif
