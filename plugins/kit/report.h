/* report.h - reports a kernel's crossings to the host's sink, if double precision was accurate enough. */
#ifndef KIT_REPORT_H
#define KIT_REPORT_H

#include "kit/local.h"

/* A crossing may be off by this many half units in its last place: 12 units at most, whatever the binade. */
#define KIT_ULPS 12.0
/* And by this fraction of the shape's size, so that its point and normal are accurate to 1e-13 too. */
#define KIT_FINE 0x1p-44

/* Largest error that a Newton step from the crossing may start with, as a fraction of the distance between two roots:
 * the step squares it. */
#define KIT_APART 0x1p-24

typedef struct kit_root {
    pov_two t;              /* in the units of a kit_ray */
    double error;           /* upper bound of the error of t */
    uint32_t part, flags;
} kit_root;

/* Input of a refinement step: the equation's value at a point of the ray, in double-double, and half its slope there,
 * in double; with error bounds. */
typedef struct kit_residual { double value, error, half_slope, slope_error; } kit_residual;

typedef struct kit_equation {
    const void *self;
    const kit_ray *ray;
    kit_residual (*at)(const void *self, const kit_ray *ray, pov_two3 point, uint32_t part);
    double apart;           /* half the distance between two roots */
} kit_equation;

typedef enum kit_verdict { KIT_OUTSIDE, KIT_GOOD, KIT_OPEN } kit_verdict;

static inline pov_mark kit_mark(uint32_t part, uint32_t flags)
{
    pov_mark mark = { part, flags, 0.0, 0.0 };
    return mark;
}

/* Does a ray start on the shape and definitely go into it? */
static inline bool kit_is_inward(const pov_ray *ray, const pov_hits *hits)
{
    return ray->left == hits->owner && (ray->left_mark.flags & POV_MARK_INTO);
}

/* Error bound of a root, including the product of t and unit. */
static inline double kit_slack(const kit_root *r) { return r->error + 2.0 * KIT_U * fabs(r->t.hi); }

/* Is it accurate enough? `fine` is the largest error that the shape's size allows. */
static inline bool kit_is_fine(const kit_root *r, double fine)
{
    return r->error <= KIT_ULPS * KIT_U * fabs(r->t.hi) && r->error <= fine;
}

/* NaN anywhere gives KIT_OPEN. */
static inline kit_verdict kit_judge(const kit_root *r, double unit, double fine, const pov_hits *hits)
{
    double slack = kit_slack(r);

    if ((r->t.hi + slack) * unit < hits->tmin || (r->t.hi - slack) * unit > hits->tmax)
        return KIT_OUTSIDE;
    /* A query for any crossing, or for their number, needs existence only. */
    if ((hits->want == POV_WANT_ANY || hits->count_only) && (r->t.hi - slack) * unit > hits->tmin && (r->t.hi + slack) * unit < hits->tmax)
        return KIT_GOOD;
    return kit_is_fine(r, fine) ? KIT_GOOD : KIT_OPEN;
}

/* A Newton step, and the root's error afterwards: the squared error over the distance of the roots, plus the residual's
 * own errors and the rounding of the step. */
static inline double kit_root_step(const kit_residual *r) { return -0.5 * r->value / r->half_slope; }

static inline double kit_root_step_error(const kit_residual *r, double step, double apart)
{
    const double slope = fabs(r->half_slope);

    return fabs(step) * (4.0 * KIT_U + 2.0 * r->slope_error / slope) + step * step / apart + r->error / slope;
}

static inline bool kit_refine(kit_root *r, const kit_equation *e)
{
    const kit_ray *k = e->ray;
    kit_residual residual;
    double step;

    if (!(r->error <= KIT_APART * e->apart))
        return false;
    residual = e->at(e->self, k, kit_along_two_parts(k, r->t), r->part);
    step = kit_root_step(&residual);
    if (!(fabs(step) <= 2.0 * r->error))
        return false;
    if (fabs(r->t.hi) <= r->error)
        r->flags |= POV_MARK_DECIDED;
    r->error = kit_root_step_error(&residual, step, e->apart);
    r->t = pov_two_add_double(r->t, step);
    return true;
}

/* Report up to two crossings, the nearer first. False: double-double arithmetic must decide, and nothing was
 * reported. */
static inline bool kit_report(kit_root *roots, uint32_t n, double fine, const kit_equation *e, pov_hits *hits)
{
    const double unit = e->ray->unit;
    kit_verdict verdict[2];
    uint32_t i;

    for (i = 0; i < n; i++) {
        verdict[i] = kit_judge(&roots[i], unit, fine, hits);
        if (verdict[i] == KIT_OPEN && kit_refine(&roots[i], e))
            verdict[i] = kit_judge(&roots[i], unit, fine, hits);
        if (verdict[i] == KIT_OPEN)
            return false;
        if (verdict[i] == KIT_GOOD && hits->want != POV_WANT_ALL && roots[i].t.hi * unit > hits->tmin)
            n = i + 1;
    }
    for (i = 0; i < n; i++) {
        const kit_root *r = &roots[i];

        if (verdict[i] != KIT_GOOD)
            continue;
        hits->decided += (r->flags & POV_MARK_DECIDED) != 0;
        if (!pov_cross(hits, r->t.hi * unit, r->t.lo * unit, kit_mark(r->part, r->flags)))
            break;
    }
    return true;
}

/* Report a result of double-double arithmetic. */
static inline bool kit_report_decided(pov_hits *hits, pov_two t, double unit, uint32_t part, uint32_t flags)
{
    return pov_cross(hits, t.hi * unit, t.lo * unit, kit_mark(part, flags | POV_MARK_DECIDED));
}

#endif
