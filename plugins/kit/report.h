/* report.h - crossings from a kernel to the host's sink: those that double precision has found well
 * enough. */
#ifndef KIT_REPORT_H
#define KIT_REPORT_H

#include "kit/local.h"

/* A crossing may be off by this many half units in its last place: 16 units at most, whatever the binade. */
#define KIT_ULPS 16.0
/* And by this part of the shape's size, so that its point and normal are good to 1e-13 too. */
#define KIT_FINE 0x1p-44

/* Where normals are found by a step of Newton's from the crossing, this part of the distance between two roots: the step
 * squares it. */
#define KIT_APART 0x1p-24

typedef struct kit_root {
    pov_two t;              /* in the units of a kit_ray */
    double error;           /* no less than the error of t */
    uint32_t part;
} kit_root;

typedef enum kit_verdict { KIT_OUTSIDE, KIT_GOOD, KIT_OPEN } kit_verdict;

static inline pov_mark kit_mark(uint32_t part, uint32_t flags)
{
    pov_mark mark = { part, flags, 0.0, 0.0 };
    return mark;
}

/* `fine` is the largest error that the shape's size allows. Not a number anywhere gives KIT_OPEN. */
static inline kit_verdict kit_judge(const kit_root *r, double unit, double fine, const pov_hits *hits)
{
    double slack = r->error + 2.0 * KIT_U * fabs(r->t.hi);

    if ((r->t.hi + slack) * unit < hits->tmin || (r->t.hi - slack) * unit > hits->tmax)
        return KIT_OUTSIDE;
    /* Who asks for any crossing wants to know only that it is there. */
    if (hits->want == POV_WANT_ANY && (r->t.hi - slack) * unit > hits->tmin && (r->t.hi + slack) * unit < hits->tmax)
        return KIT_GOOD;
    return r->error <= KIT_ULPS * KIT_U * fabs(r->t.hi) && r->error <= fine ? KIT_GOOD : KIT_OPEN;
}

/* Report up to two crossings, the nearer first. False: two-part arithmetic must decide, and nothing was
 * reported. */
static inline bool kit_report(const kit_root *roots, uint32_t n, double unit, double fine, pov_hits *hits)
{
    kit_verdict verdict[2];
    uint32_t i;

    for (i = 0; i < n; i++) {
        verdict[i] = kit_judge(&roots[i], unit, fine, hits);
        if (verdict[i] == KIT_OPEN)
            return false;
        if (verdict[i] == KIT_GOOD && hits->want != POV_WANT_ALL && roots[i].t.hi * unit > hits->tmin)
            n = i + 1;
    }
    for (i = 0; i < n; i++) {
        const kit_root *r = &roots[i];

        if (verdict[i] == KIT_GOOD && !pov_cross(hits, r->t.hi * unit, r->t.lo * unit, kit_mark(r->part, 0)))
            break;
    }
    return true;
}

/* What two-part arithmetic found. */
static inline bool kit_report_decided(pov_hits *hits, pov_two t, double unit, uint32_t part)
{
    return pov_cross(hits, t.hi * unit, t.lo * unit, kit_mark(part, POV_MARK_DECIDED));
}

#endif
