/* edges.h - on which side of an edge a ray passes: decided by the ray and the edge's two corners alone, exactly where
 * doubles leave it open. So figures that share an edge leave no gap and no overlap along it. */
#ifndef COMMON_EDGES_H
#define COMMON_EDGES_H

#include "common/local.h"

/* View along a ray: its largest axis points away, across and up are the two others. The view depends on the ray
 * only. */
typedef struct common_view {
    int across, up, forward;
    double o[3], o_lo[3], d[3], d_lo[3];   /* the direction is scaled; the origin is in the units of the corners */
    double w[3];           /* a point of the ray near the figure, seen from the anchor */
    double error;          /* error of a coordinate in the view */
    bool exact, escalated;
} common_view;

/* A corner in the view, with the ray at the origin. */
typedef struct common_seen { double across, up; int above; } common_seen;

/* The largest axis of a direction. */
static inline int common_forward(pov_vec3 d)
{
    return fabs(d.x) > fabs(d.y) ? (fabs(d.x) > fabs(d.z) ? 0 : 2) : fabs(d.y) > fabs(d.z) ? 1 : 2;
}

/* Corners are below 2 and so is the direction. A coordinate is the difference of two products of a rounded difference:
 * 6 roundings of terms below 2 (2 + |w|), twice. */
COMMON_INLINE double common_view_blur(pov_vec3 w) { return 24.0 * COMMON_U * (2.0 + pov_largest(w)); }

static inline void common_set3(double *to, pov_vec3 v) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }

/* w: the point of the ray that corners are seen from, relative to the anchor and scaled. */
common_view common_view_make(pov_vec3 org, pov_vec3 org_lo, const common_ray *k, pov_vec3 w, bool always_exact);

/* Is a corner above the ray's level? Exactly. */
bool common_view_is_above(const common_view *s, const pov_vec3 *corner);
/* The sign of d . ((a - o) x (b - o)), as is_right() needs it. Exactly. */
bool common_view_passes(const common_view *s, const pov_vec3 *a, const pov_vec3 *b, bool upward);

/* A corner, given relative to the anchor and scaled, and as the exact functions need it. A corner level with the ray
 * counts as below: the same for every figure that has it. */
static inline common_seen common_view_project(common_view *s, pov_vec3 local, const pov_vec3 *corner)
{
    const double v[3] = { local.x - s->w[0], local.y - s->w[1], local.z - s->w[2] };
    common_seen p;

    p.across = v[s->across] * s->d[s->forward] - v[s->forward] * s->d[s->across];
    p.up = v[s->up] * s->d[s->forward] - v[s->forward] * s->d[s->up];
    p.above = p.up > 0.0;
    if (s->exact || !(fabs(p.up) > s->error)) {
        s->escalated = true;
        p.above = common_view_is_above(s, corner);
    }
    return p;
}

/* Does an edge that crosses the ray's level pass the ray on the right, or through it? Edges are tested upward, so that
 * both figures of a shared edge compute the same. */
static inline bool common_view_is_right(common_view *s, const pov_vec3 *a, common_seen pa, const pov_vec3 *b,
                                        common_seen pb)
{
    const double cross = pa.across * pb.up - pb.across * pa.up;
    const double error = s->error * (fabs(pa.across) + fabs(pa.up) + fabs(pb.across) + fabs(pb.up) + 2.0 * s->error) +
                         4.0 * COMMON_U * (fabs(pa.across * pb.up) + fabs(pb.across * pa.up));

    if (!s->exact && fabs(cross) > error)
        return (cross > 0.0) == (pb.above > pa.above);
    s->escalated = true;
    return common_view_passes(s, a, b, pb.above);
}

#endif
