#include "world/instance.h"

#include <string.h>

static inline double component(pov_vec3 v, int i)
{
    return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

static inline pov_two inverse(const instance_xform *p, int i, int j)
{
    return pov_two_of(component(p->column[j], i), component(p->column_lo[j], i));
}

static inline pov_two apply_row(const instance_xform *p, int i, const pov_two v[3])
{
    if (p->axes)
        return pov_two_mul(inverse(p, i, i), v[i]);
    return pov_two_add(pov_two_add(pov_two_mul(inverse(p, i, 0), v[0]), pov_two_mul(inverse(p, i, 1), v[1])),
                       pov_two_mul(inverse(p, i, 2), v[2]));
}

/* ---- rays ---- */

/* Vector from the anchor to a double-double point. */
static inline pov_two from_anchor(double at, double at_lo, double anchor)
{
    return pov_two_add_double(pov_two_sum(at, -anchor), at_lo);
}

/* A component of the direction, in double-double: the ray in object space then equals the world's except for errors of
 * the order of 2^-100, from however far it comes. */
static inline pov_two rotated(const instance_xform *p, int i, pov_vec3 d)
{
    pov_two sum;

    if (p->axes)
        return pov_two_mul_double(inverse(p, i, i), component(d, i));
    sum = pov_two_add(pov_two_mul_double(inverse(p, i, 0), d.x), pov_two_mul_double(inverse(p, i, 1), d.y));
    return pov_two_add(sum, pov_two_mul_double(inverse(p, i, 2), d.z));
}

/* The same of a direction in double-double. */
static inline pov_two rotated_exact(const instance_xform *p, int i, const pov_ray *ray)
{
    const pov_two d[3] = { pov_two_of(ray->dir.x, ray->dir_lo.x), pov_two_of(ray->dir.y, ray->dir_lo.y),
                           pov_two_of(ray->dir.z, ray->dir_lo.z) };

    return apply_row(p, i, d);
}

/* Transform a world point to object space, in double-double. */
static inline void own_point(const instance_xform *p, pov_vec3 at, pov_vec3 at_lo, pov_two out[3])
{
    pov_two w[3];
    int i;

    w[0] = from_anchor(at.x, at_lo.x, p->anchor.x);
    w[1] = from_anchor(at.y, at_lo.y, p->anchor.y);
    w[2] = from_anchor(at.z, at_lo.z, p->anchor.z);
    for (i = 0; i < 3; i++)
        out[i] = pov_two_add(apply_row(p, i, w),
                             pov_two_of(component(p->own_anchor, i), component(p->own_anchor_lo, i)));
}

void instance_ray(const instance_xform *p, const pov_ray *ray, pov_ray *own)
{
    const bool exact = ray->dir_lo.x != 0.0 || ray->dir_lo.y != 0.0 || ray->dir_lo.z != 0.0;
    pov_two o[3], d[3];
    int i;

    own_point(p, ray->org, ray->org_lo, o);
    for (i = 0; i < 3; i++)
        d[i] = exact ? rotated_exact(p, i, ray) : rotated(p, i, ray->dir);
    own->org = pov_vec3_of(o[0].hi, o[1].hi, o[2].hi);
    own->org_lo = pov_vec3_of(o[0].lo, o[1].lo, o[2].lo);
    own->dir = pov_vec3_of(d[0].hi, d[1].hi, d[2].hi);
    own->dir_lo = pov_vec3_of(d[0].lo, d[1].lo, d[2].lo);
    own->origin_surface = ray->origin_surface;
    own->origin_mark = ray->origin_mark;
}

/* ---- what rays are answered ---- */

void instance_intersect(const instance_xform *p, const shape_class *shape, const void *self, const pov_ray *ray,
                        pov_hits *hits)
{
    pov_ray own;

    instance_ray(p, ray, &own);
    shape->intersect(self, &own, hits);
}

void instance_normal(const instance_xform *p, const shape_class *shape, const void *self, const pov_ray *ray,
                     const pov_crossing *at, pov_vec3 *out)
{
    pov_ray own;

    instance_ray(p, ray, &own);
    shape->normal(self, &own, at, out);
    instance_world_normal(p, out);
}

/* Normals are transformed by the transpose of the inverse. */
void instance_world_normal(const instance_xform *p, pov_vec3 *normal)
{
    double n[3];
    int i;

    for (i = 0; i < 3; i++) {
        pov_two sum = pov_two_add(pov_two_mul_double(inverse(p, 0, i), normal->x),
                                  pov_two_mul_double(inverse(p, 1, i), normal->y));
        n[i] = pov_two_add(sum, pov_two_mul_double(inverse(p, 2, i), normal->z)).hi;
    }
    *normal = pov_unit(pov_vec3_of(n[0], n[1], n[2]));
}

pov_two3 instance_point(const instance_xform *p, pov_vec3 point, pov_vec3 point_lo)
{
    pov_two o[3];
    pov_two3 out;

    own_point(p, point, point_lo, o);
    out.x = o[0];
    out.y = o[1];
    out.z = o[2];
    return out;
}

bool instance_inside(const instance_xform *p, const shape_class *shape, const void *self, pov_vec3 point,
                     pov_vec3 point_lo)
{
    const pov_two3 own = instance_point(p, point, point_lo);

    return shape->inside(self, pov_two3_hi(own), pov_two3_lo(own));
}
