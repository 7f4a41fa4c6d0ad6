#include "bvh/build.h"
#include "bvh/traverse.h"

#include <povtrace/exact.h>

/* ---- frames for a build ---- */

/* Round down: the margin exceeds the rounding of the subtraction before and the conversion after it. */
static inline float round_down(double x)
{
    return (float)(x - (fabs(x) * 0x1p-22 + 0x1p-120));
}

static inline float round_up(double x)
{
    return (float)(x + (fabs(x) * 0x1p-22 + 0x1p-120));
}

pov_box bvh_box_around(const bvh_input *in, const bvh_ref *refs, uint32_t begin, uint32_t end)
{
    pov_box all, b;
    uint32_t i;

    in->box(in->box_user, refs[begin].id, &all);
    for (i = begin + 1; i < end; i++) {
        in->box(in->box_user, refs[i].id, &b);
        all.lo = pov_vec3_of(pov_min(all.lo.x, b.lo.x), pov_min(all.lo.y, b.lo.y), pov_min(all.lo.z, b.lo.z));
        all.hi = pov_vec3_of(pov_max(all.hi.x, b.hi.x), pov_max(all.hi.y, b.hi.y), pov_max(all.hi.z, b.hi.z));
    }
    return all;
}

/* Power of two that scales half the box below 1; a box without extent counts as a few rounding errors. */
static double scale_for(const pov_box *all)
{
    double half = 0.5 * pov_largest(pov_sub(all->hi, all->lo));
    double least = pov_max(pov_max(pov_largest(all->lo), pov_largest(all->hi)) * 0x1p-50, 1e-300);
    int e;

    frexp(pov_max(half, least), &e);
    return ldexp(1.0, -e);
}

bvh_frame bvh_frame_around(const pov_box *all)
{
    bvh_frame f;

    f.centre = pov_add(pov_scale(all->lo, 0.5), pov_scale(all->hi, 0.5));
    f.scale = scale_for(all);
    f.root = 0;
    return f;
}

void bvh_frame_convert(const bvh_frame *frame, const bvh_input *in, bvh_ref *refs, uint32_t begin, uint32_t end)
{
    pov_vec3 c = frame->centre;
    double s = frame->scale;
    uint32_t i;

    for (i = begin; i < end; i++) {
        bvh_ref *f = &refs[i];
        pov_box b;
        in->box(in->box_user, f->id, &b);
        f->lo[0] = round_down((b.lo.x - c.x) * s);
        f->lo[1] = round_down((b.lo.y - c.y) * s);
        f->lo[2] = round_down((b.lo.z - c.z) * s);
        f->hi[0] = round_up((b.hi.x - c.x) * s);
        f->hi[1] = round_up((b.hi.y - c.y) * s);
        f->hi[2] = round_up((b.hi.z - c.z) * s);
    }
}

/* ---- rays that come into a frame from far away, or with odd numbers ---- */

/* For numbers too large or too small: with this much slack every box is hit. */
static bool enter_blindly(bvh_local *l)
{
    l->org = pov_vec3_of(0.0, 0.0, 0.0);
    l->dir = pov_vec3_of(1.0, 1.0, 1.0);
    l->scale = HUGE_VAL;         /* any limit becomes infinite */
    l->shift = 0.0;
    l->slack = 1e30;
    return true;
}

/* The ray's point at t in the frame, rounded once or twice, however far the ray starts. */
static pov_vec3 point_at(const bvh_frame *f, const pov_ray *ray, double t)
{
    pov_two x = pov_recentre(ray->org.x, ray->org_lo.x, f->centre.x, t, ray->dir.x);
    pov_two y = pov_recentre(ray->org.y, ray->org_lo.y, f->centre.y, t, ray->dir.y);
    pov_two z = pov_recentre(ray->org.z, ray->org_lo.z, f->centre.z, t, ray->dir.z);

    return pov_scale(pov_vec3_of(x.hi + t * ray->dir_lo.x, y.hi + t * ray->dir_lo.y, z.hi + t * ray->dir_lo.z), f->scale);
}

bool bvh_bring_near(const bvh_frame *f, const pov_ray *ray, bvh_local *l)
{
    const pov_vec3 o = l->org, d = l->dir;
    double along = -pov_dot(o, d);
    pov_vec3 at;

    if (!(fabs(along) < 1e200))
        return enter_blindly(l);
    /* The cube reaches to sqrt(3). For a ray that starts more than BVH_NEAR away it is ahead, or it is missed. */
    if (along <= 0.0)
        return false;
    /* Start 4 before the point closest to the centre, and earlier by the rounding errors of t and of the length 1. */
    l->shift = (along - (4.0 + pov_largest(o) * 0x1p-48)) / l->scale;
    at = point_at(f, ray, l->shift);
    /* Filters square such numbers, and multiples of the shift, in floats. */
    if (!(pov_largest(at) < 1e6) || !(fabs(l->shift) < 1e290))
        return enter_blindly(l);
    l->org = at;
    /* The cube's sphere has the square of its radius at 3; the subtraction loses some 2^-51 of its terms. */
    along = pov_dot(at, d);
    return pov_dot(at, at) - along * along <= 4.0 + pov_dot(at, at) * 0x1p-33;
}

/* A direction too long or too short to be squared, and its unit vector. */
static bool measure(const bvh_frame *f, const pov_ray *ray, bvh_local *l)
{
    const double m = pov_largest(ray->dir);
    const pov_vec3 d = pov_vec3_of(ray->dir.x / m, ray->dir.y / m, ray->dir.z / m);
    const double length = sqrt(pov_dot(d, d));

    l->dir = pov_vec3_of(d.x / length, d.y / length, d.z / length);
    l->scale = f->scale * m * length;
    return l->scale > 1e-300 && l->scale < 1e300;
}

bool bvh_enter_far(const bvh_frame *f, const pov_ray *ray, bvh_local *l)
{
    if (!measure(f, ray, l))
        return enter_blindly(l);
    if (pov_largest(l->org) <= BVH_NEAR)
        return true;
    return bvh_bring_near(f, ray, l);
}
