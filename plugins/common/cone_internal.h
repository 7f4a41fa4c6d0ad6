/* cone_internal.h - declarations for the files of cylinders and cones only. */
#ifndef COMMON_CONE_INTERNAL_H
#define COMMON_CONE_INTERNAL_H

#include "common/cone.h"

enum { SIDE_IN = 0, SIDE_OUT = 1, CAP_BASE = 2, CAP_TOP = 3 };

static inline uint32_t cone_mark(const common_cone *s) { return s->open ? 0 : POV_MARK_CLOSED; }

/* Crossings that a ray which left the shape may still report. */
typedef enum leaving { NOT_LEAVING, INWARD, OUTWARD } leaving;

static inline pov_two3 scaled(pov_two3 a, double power)
{
    a.x = pov_two_scale(a.x, power);
    a.y = pov_two_scale(a.y, power);
    a.z = pov_two_scale(a.z, power);
    return a;
}

static inline pov_two3 times_vector(const pov_two3 rows[3], pov_two3 w)
{
    pov_two3 p;

    p.x = pov_two3_dot(rows[0], w);
    p.y = pov_two3_dot(rows[1], w);
    p.z = pov_two3_dot(rows[2], w);
    return p;
}

static inline pov_two3 cone_local(const common_cone *s, pov_two3 w) { return times_vector(s->row, w); }

static inline pov_two radius_at(const common_cone *s, pov_two z)
{
    return pov_two_add(s->radius, pov_two_mul(s->slope, z));
}

/* a b + c d */
static inline pov_two sum2(pov_two a, pov_two b, pov_two c, pov_two d)
{
    return pov_two_add(pov_two_mul(a, b), pov_two_mul(c, d));
}

/* A point, the radius there, and the direction, in local coordinates. */
typedef struct view { pov_two3 p; pov_two r; pov_vec3 d; } view;

static inline view view_of(const common_cone *s, const common_ray *k, pov_two3 w)
{
    view v;

    v.p.x = common_fast_dot(s->row[0], w);
    v.p.y = common_fast_dot(s->row[1], w);
    v.p.z = common_fast_dot(s->row[2], w);
    v.r = radius_at(s, v.p.z);
    v.d = pov_vec3_of(pov_dot(pov_two3_hi(s->row[0]), k->d), pov_dot(pov_two3_hi(s->row[1]), k->d),
                      pov_dot(pov_two3_hi(s->row[2]), k->d));
    return v;
}

/* x^2 + y^2 - r^2, and half its slope along the ray. */
static inline double side_value(const view *v)
{
    pov_two3 a = v->p, b = v->p;

    a.z = v->r;
    b.z = pov_two_neg(v->r);
    return common_fast_dot(a, b).hi;
}

static inline double side_slope(const common_cone *s, const view *v)
{
    return v->p.x.hi * v->d.x + v->p.y.hi * v->d.y - v->r.hi * (s->slope.hi * v->d.z);
}

/* Newton's step to the side. */
static inline double side_step(const common_cone *s, const view *v) { return -0.5 * side_value(v) / side_slope(s, v); }

static inline int is_step(double step) { return fabs(step) < 0x1p-30; }

static inline void take_step(const common_cone *s, view *v, double step)
{
    v->p.x = pov_two_add(v->p.x, pov_two_product(step, v->d.x));
    v->p.y = pov_two_add(v->p.y, pov_two_product(step, v->d.y));
    v->p.z = pov_two_add(v->p.z, pov_two_product(step, v->d.z));
    v->r = radius_at(s, v->p.z);
}

static inline pov_two3 two3_of(pov_two a, pov_two b, pov_two c)
{
    pov_two3 v;

    v.x = a;
    v.y = b;
    v.z = c;
    return v;
}

/* Normal of the side, not normalised. */
static inline pov_vec3 side_normal(const common_cone *s, const view *v)
{
    const pov_two3 *row = s->row, n = two3_of(v->p.x, v->p.y, pov_two_neg(pov_two_mul(s->slope, v->r)));

    return pov_vec3_of(common_fast_dot(n, two3_of(row[0].x, row[1].x, row[2].x)).hi,
                       common_fast_dot(n, two3_of(row[0].y, row[1].y, row[2].y)).hi,
                       common_fast_dot(n, two3_of(row[0].z, row[1].z, row[2].z)).hi);
}

/* The local coordinates are sums of three products with entries below 2, so within 2^-97 of |w|. They and the radius
 * are below 8 wherever that matters. */
static inline double cone_value_error(pov_two3 w) { return 0x1p-91 * (1.0 + pov_largest(pov_two3_hi(w))); }

/* Rows and direction are below 2: no component of d is off by more than this. */
#define CONE_D_ERROR (64.0 * COMMON_U)

static inline common_residual side_residual(const common_cone *s, const view *v)
{
    const double grow = s->slope.hi * v->d.z;
    const pov_vec3 size = pov_vec3_of(fabs(v->p.x.hi), fabs(v->p.y.hi), fabs(v->r.hi));
    common_residual r;

    r.error = 0.0;
    r.value = side_value(v);
    r.half_slope = side_slope(s, v);
    r.slope_error = CONE_D_ERROR * (size.x + size.y + size.z * fabs(s->slope.hi))
                    + 4.0 * COMMON_U * (size.x * fabs(v->d.x) + size.y * fabs(v->d.y) + size.z * fabs(grow));
    return r;
}

static inline common_residual cap_residual(const common_cone *s, const view *v, int base)
{
    const pov_two beyond = pov_two_sub(v->p.z, s->height);
    common_residual r;

    r.error = 0.0;
    r.value = base ? v->p.z.hi : beyond.hi;
    r.half_slope = 0.5 * v->d.z;
    r.slope_error = CONE_D_ERROR;
    return r;
}

/* The equation of the side, or of a cap's plane, at a point. */
common_residual common_cone_residual(const void *self, const common_ray *k, pov_two3 w, uint32_t feature);

/* Double-double arithmetic from the start, about the ray's point at `middle`. */
void common_cone_escalate(const common_cone *s, const common_ray *k, const pov_ray *ray, double middle, pov_hits *hits);

#endif
