/* report.h - reports a kernel's crossings to the host's sink, if double precision was accurate enough. */
#ifndef COMMON_REPORT_H
#define COMMON_REPORT_H

#include "common/local.h"

/* A crossing may be off by this many half units in its last place: 12 units at most, whatever the binade. */
#define COMMON_ULPS 12.0
/* And by this fraction of the shape's size, so that its point and normal are accurate to 1e-13 too. */
#define COMMON_FINE 0x1p-44

/* Largest error that a Newton step from the crossing may start with, as a fraction of the distance between two roots:
 * the step squares it. */
#define COMMON_SEPARATION 0x1p-24

typedef struct common_root {
    pov_two t;              /* in the units of a common_ray */
    double error;           /* upper bound of the error of t */
    uint32_t feature, flags;
} common_root;

/* Input of a refinement step: the equation's value at a point of the ray, in double-double, and half its slope there,
 * in double; with error bounds. */
typedef struct common_residual { double value, error, half_slope, slope_error; } common_residual;

typedef struct common_equation {
    const void *self;
    const common_ray *ray;
    common_residual (*at)(const void *self, const common_ray *ray, pov_two3 point, uint32_t feature);
    double separation;      /* half the distance between two roots */
} common_equation;

typedef enum common_verdict { COMMON_OUTSIDE, COMMON_GOOD, COMMON_OPEN } common_verdict;

static inline pov_mark common_mark(uint32_t feature, uint32_t flags)
{
    pov_mark mark = { feature, flags, 0.0, 0.0 };
    return mark;
}

/* Write a crossing for cross_sure(). */
static inline void common_cross_sure(pov_crossing *at, double t, double t_lo, uint32_t feature, uint32_t flags)
{
    at->t = t;
    at->t_lo = t_lo;
    at->mark = common_mark(feature, flags);
}

/* Does a ray start on the shape and definitely go into it? */
static inline bool common_is_inward(const pov_ray *ray, const pov_hits *hits)
{
    return ray->origin_surface == hits->owner && (ray->origin_mark.flags & POV_MARK_INWARD);
}

/* The same of the pairs of cross_sure(): all of them do, or none. */
static inline bool common_are_sure_inward(const pov_ray *const *rays, pov_crossing *const *at)
{
    return rays[0]->origin_surface == at[0]->owner;
}

/* Error bound of a root, including the product of t and unit. */
static inline double common_slack(const common_root *r) { return r->error + 2.0 * COMMON_U * fabs(r->t.hi); }

/* Is it accurate enough? `fine` is the largest error that the shape's size allows. */
static inline bool common_is_fine(const common_root *r, double fine)
{
    return r->error <= COMMON_ULPS * COMMON_U * fabs(r->t.hi) && r->error <= fine;
}

/* Is it certainly so near the end of the interval that the host decides? More precision would change nothing. */
static inline bool common_is_at_end(const common_root *r, double unit, const pov_hits *hits)
{
    return hits->slack > 0.0 && fabs(hits->tmax - r->t.hi * unit) + common_slack(r) * unit < 0.5 * hits->slack;
}

/* NaN anywhere gives COMMON_OPEN. */
static inline common_verdict common_judge(const common_root *r, double unit, double fine, const pov_hits *hits)
{
    double slack = common_slack(r);

    if ((r->t.hi + slack) * unit < hits->tmin || (r->t.hi - slack) * unit > hits->tmax)
        return COMMON_OUTSIDE;
    /* A query for any crossing, or for their number, needs existence only. */
    if ((hits->want == POV_WANT_ANY || hits->count_only) && (r->t.hi - slack) * unit > hits->tmin && (r->t.hi + slack) * unit < hits->tmax)
        return COMMON_GOOD;
    return common_is_fine(r, fine) || common_is_at_end(r, unit, hits) ? COMMON_GOOD : COMMON_OPEN;
}

/* A Newton step, and the root's error afterwards: the squared error over the distance of the roots, plus the residual's
 * own errors and the rounding of the step. */
static inline double common_root_step(const common_residual *r) { return -0.5 * r->value / r->half_slope; }

static inline double common_root_step_error(const common_residual *r, double step, double separation)
{
    const double slope = fabs(r->half_slope);

    return fabs(step) * (4.0 * COMMON_U + 2.0 * r->slope_error / slope) + step * step / separation + r->error / slope;
}

static inline bool common_refine(common_root *r, const common_equation *e)
{
    const common_ray *k = e->ray;
    common_residual residual;
    double step;

    if (!(r->error <= COMMON_SEPARATION * e->separation))
        return false;
    residual = e->at(e->self, k, common_along_dd(k, r->t), r->feature);
    step = common_root_step(&residual);
    if (!(fabs(step) <= 2.0 * r->error))
        return false;
    if (fabs(r->t.hi) <= r->error)
        r->flags |= POV_MARK_ESCALATED;
    r->error = common_root_step_error(&residual, step, e->separation);
    r->t = pov_two_add_double(r->t, step);
    return true;
}

/* Report up to two crossings, the nearer first. False: double-double arithmetic must decide, and nothing was
 * reported. */
static inline bool common_report(common_root *roots, uint32_t n, double fine, const common_equation *e, pov_hits *hits)
{
    const double unit = e->ray->unit;
    common_verdict verdict[2];
    uint32_t i;

    for (i = 0; i < n; i++) {
        verdict[i] = common_judge(&roots[i], unit, fine, hits);
        if (verdict[i] == COMMON_OPEN && common_refine(&roots[i], e))
            verdict[i] = common_judge(&roots[i], unit, fine, hits);
        if (verdict[i] == COMMON_OPEN)
            return false;
        if (verdict[i] == COMMON_GOOD && hits->want != POV_WANT_ALL && roots[i].t.hi * unit > hits->tmin)
            n = i + 1;
    }
    for (i = 0; i < n; i++) {
        const common_root *r = &roots[i];

        if (verdict[i] != COMMON_GOOD)
            continue;
        hits->escalated += (r->flags & POV_MARK_ESCALATED) != 0;
        if (!pov_cross(hits, r->t.hi * unit, r->t.lo * unit, common_mark(r->feature, r->flags)))
            break;
    }
    return true;
}

/* Report a result of double-double arithmetic. */
static inline bool common_report_escalated(pov_hits *hits, pov_two t, double unit, uint32_t feature, uint32_t flags)
{
    return pov_cross(hits, t.hi * unit, t.lo * unit, common_mark(feature, flags | POV_MARK_ESCALATED));
}

#endif
