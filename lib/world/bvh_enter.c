#include "world/bvh_walk.h"

#include <povtrace/exact.h>

#include <float.h>

/* A ray that starts within this many half-sizes of a frame needs no moving: the offsets' slack stays below 2^-17. */
static const double near_enough = 8.0;
static const double least_component = 1e-18;

static inline void set_axis(bvh_slabs *s, int axis, double o, double d)
{
    double a = fabs(d), inverse = 1.0 / copysign(a > least_component ? a : least_component, d);
    double slack = fabs(inverse) * (1.0 + fabs(o)) * 0x1p-22;

    s->inverse[axis] = (float)inverse;
    s->near_offset[axis] = (float)(o * inverse + slack);
    s->far_offset[axis] = (float)(o * inverse - slack);
    s->near_row[axis] = 2u * (uint32_t)axis + (inverse < 0.0);
}

static inline void set_axes(bvh_slabs *s, pov_vec3 o, pov_vec3 d)
{
    set_axis(s, 0, o.x, d.x);
    set_axis(s, 1, o.y, d.y);
    set_axis(s, 2, o.z, d.z);
}

/* Numbers too large or too small for this: every box is met. */
static bool enter_blindly(bvh_slabs *s)
{
    int k;

    for (k = 0; k < 3; k++) {
        s->inverse[k] = 1.0f;
        s->near_offset[k] = FLT_MAX;
        s->far_offset[k] = -FLT_MAX;
        s->near_row[k] = 2u * (uint32_t)k;
    }
    s->scale = 1.0;
    s->shift = 0.0;
    s->limit = HUGE_VALF;
    return true;
}

/* Where the ray is at t, in the frame: exact but for one rounding, however far it starts. */
static pov_vec3 point_at(const bvh_frame *f, const pov_ray *ray, double t)
{
    pov_two x = pov_recentre(ray->org.x, ray->org_lo.x, f->centre.x, t, ray->dir.x);
    pov_two y = pov_recentre(ray->org.y, ray->org_lo.y, f->centre.y, t, ray->dir.y);
    pov_two z = pov_recentre(ray->org.z, ray->org_lo.z, f->centre.z, t, ray->dir.z);

    return pov_scale(pov_vec3_of(x.hi, y.hi, z.hi), f->scale);
}

/* The ray starts far away: move its start to just before the cube. o and d are in the frame, d about 1 long. */
static bool enter_far(const bvh_frame *f, const pov_ray *ray, double limit, pov_vec3 o, pov_vec3 d, bvh_slabs *s)
{
    double dd = pov_dot(d, d), length = sqrt(dd), along = -pov_dot(o, d) / dd, back;
    pov_vec3 at;

    if (!(fabs(along) < 1e200))
        return enter_blindly(s);
    /* The cube reaches to sqrt(3). From more than 8 away it is ahead, or it is missed. */
    if (along <= 0.0)
        return false;
    /* Before the nearest point to the centre by 4, and by what the rounding of t may bring. */
    back = (4.0 + pov_largest(o) * 0x1p-48) / length;
    s->shift = (along - back) / s->scale;
    at = point_at(f, ray, s->shift);
    if (!(pov_largest(at) < 1e30) || !(fabs(s->shift) < 1e290))
        return enter_blindly(s);
    along = pov_dot(at, d) / length;
    if (pov_dot(at, at) - along * along > 4.0 + pov_dot(at, at) * 1e-10)
        return false;
    set_axes(s, at, d);
    bvh_set_limit(s, limit);
    return true;
}

bool bvh_enter(const bvh_frame *f, const pov_ray *ray, double limit, bvh_slabs *s)
{
    pov_vec3 d = ray->dir, o = pov_sub(ray->org, f->centre);
    double m = pov_largest(d);

    o = pov_scale(pov_add(o, ray->org_lo), f->scale);
    s->scale = f->scale;
    s->shift = 0.0;
    if (!(m > 0x1p-20 && m < 0x1p20)) {
        d = pov_vec3_of(d.x / m, d.y / m, d.z / m);
        s->scale *= m;
    }
    if (!(s->scale > 1e-300 && s->scale < 1e300))
        return enter_blindly(s);
    if (!(pov_largest(o) <= near_enough))
        return enter_far(f, ray, limit, o, d, s);
    set_axes(s, o, d);
    bvh_set_limit(s, limit);
    return true;
}
