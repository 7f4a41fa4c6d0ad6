/* frustum_parts.h - what the files of the frustum share with each other and with nobody else. */
#ifndef KIT_FRUSTUM_PARTS_H
#define KIT_FRUSTUM_PARTS_H

#include "kit/frustum.h"

enum { SIDE_IN = 0, SIDE_OUT = 1, CAP_BASE = 2, CAP_TOP = 3 };

/* Which crossings a ray that left the shape may still report. */
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

static inline pov_two3 frustum_local(const kit_frustum *s, pov_two3 w) { return times_vector(s->row, w); }

static inline pov_two radius_at(const kit_frustum *s, pov_two z)
{
    return pov_two_add(s->radius, pov_two_mul(s->slope, z));
}

/* a b + c d */
static inline pov_two sum2(pov_two a, pov_two b, pov_two c, pov_two d)
{
    return pov_two_add(pov_two_mul(a, b), pov_two_mul(c, d));
}

/* The equation of the side, or of a cap's plane, at a point. */
kit_residual kit_frustum_residual(const void *self, const kit_ray *k, pov_two3 w, uint32_t part);

/* Two-part arithmetic from the start, about the ray's point at `middle`. */
void kit_frustum_decide(const kit_frustum *s, const kit_ray *k, const pov_ray *ray, double middle, pov_hits *hits);

#endif
