#include "world/instance.h"

#include "base/simd.h"

#include <string.h>

static inline double component(pov_vec3 v, int i)
{
    return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

static inline pov_two inverse(const instance_xform *p, int i, int j)
{
    return pov_two_of(component(p->column[j], i), component(p->column_lo[j], i));
}

/* ---- rays ---- */

/* The components side by side: a single row would wait for each of its sums. The fourth is unused. */
enum { ROWS = 4 };

typedef struct row_lanes { double hi[ROWS], lo[ROWS]; } row_lanes;

/* What a transform does, by row: the column of each component, and the anchor in object space. */
typedef struct transform_rows { row_lanes column[3], own; } transform_rows;

static inline void take_rows(double out[ROWS], const pov_vec3 *from)
{
    memcpy(out, from, sizeof *from);
    out[3] = 0.0;
}

static inline void take_transform(const instance_xform *p, transform_rows *out)
{
    for (int j = 0; j < 3; j++) {
        take_rows(out->column[j].hi, &p->column[j]);
        take_rows(out->column[j].lo, &p->column_lo[j]);
    }
    take_rows(out->own.hi, &p->own_anchor);
    take_rows(out->own.lo, &p->own_anchor_lo);
}

SIMD_INLINE pov_two row_of(const row_lanes *l, int i) { return pov_two_of(l->hi[i], l->lo[i]); }

/* A row of the inverse times a vector. */
SIMD_INLINE pov_two apply_row(const transform_rows *m, int i, pov_two x, pov_two y, pov_two z)
{
    const pov_two xy = pov_two_add(pov_two_mul(row_of(&m->column[0], i), x), pov_two_mul(row_of(&m->column[1], i), y));

    return pov_two_add(xy, pov_two_mul(row_of(&m->column[2], i), z));
}

/* From the anchor to a point, and a direction. Where that is one of doubles the products are as exact as its own. */
static void apply_point(const transform_rows *restrict m, const pov_two from[3], row_lanes *restrict out)
{
    const pov_two x = from[0], y = from[1], z = from[2];

    for (int i = 0; i < ROWS; i++) {
        const pov_two o = pov_two_add(apply_row(m, i, x, y, z), row_of(&m->own, i));

        out->hi[i] = o.hi;
        out->lo[i] = o.lo;
    }
}

static void apply_direction(const transform_rows *restrict m, const pov_two dir[3], row_lanes *restrict out)
{
    const pov_two x = dir[0], y = dir[1], z = dir[2];

    for (int i = 0; i < ROWS; i++) {
        const pov_two d = apply_row(m, i, x, y, z);

        out->hi[i] = d.hi;
        out->lo[i] = d.lo;
    }
}

/* The same for a diagonal inverse. */
static void scale_point(const instance_xform *p, const pov_two from[3], row_lanes *out)
{
    for (int i = 0; i < 3; i++) {
        const pov_two o = pov_two_add(pov_two_mul(inverse(p, i, i), from[i]),
                                      pov_two_of(component(p->own_anchor, i), component(p->own_anchor_lo, i)));

        out->hi[i] = o.hi;
        out->lo[i] = o.lo;
    }
}

static void scale_direction(const instance_xform *p, const pov_two dir[3], row_lanes *out)
{
    for (int i = 0; i < 3; i++) {
        const pov_two d = pov_two_mul(inverse(p, i, i), dir[i]);

        out->hi[i] = d.hi;
        out->lo[i] = d.lo;
    }
}

static inline void find_from_anchor(const instance_xform *p, pov_vec3 at, pov_vec3 at_lo, pov_two out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = pov_two_add_double(pov_two_sum(component(at, i), -component(p->anchor, i)), component(at_lo, i));
}

/* In double-double: the ray in object space then equals the world's except for errors of the order of 2^-100, from however
 * far it comes. */
void instance_ray(const instance_xform *p, const pov_ray *ray, pov_ray *own)
{
    const pov_two dir[3] = { pov_two_of(ray->dir.x, ray->dir_lo.x), pov_two_of(ray->dir.y, ray->dir_lo.y),
                             pov_two_of(ray->dir.z, ray->dir_lo.z) };
    pov_two from[3];
    row_lanes o, d;

    find_from_anchor(p, ray->org, ray->org_lo, from);
    if (p->axes) {
        scale_point(p, from, &o);
        scale_direction(p, dir, &d);
    } else {
        transform_rows m;

        take_transform(p, &m);
        apply_point(&m, from, &o);
        apply_direction(&m, dir, &d);
    }
    memcpy(&own->org, o.hi, sizeof own->org);
    memcpy(&own->org_lo, o.lo, sizeof own->org_lo);
    memcpy(&own->dir, d.hi, sizeof own->dir);
    memcpy(&own->dir_lo, d.lo, sizeof own->dir_lo);
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
    pov_two from[3];
    pov_two3 out;
    row_lanes o;

    find_from_anchor(p, point, point_lo, from);
    if (p->axes) {
        scale_point(p, from, &o);
    } else {
        transform_rows m;

        take_transform(p, &m);
        apply_point(&m, from, &o);
    }
    out.x = row_of(&o, 0);
    out.y = row_of(&o, 1);
    out.z = row_of(&o, 2);
    return out;
}

bool instance_inside(const instance_xform *p, const shape_class *shape, const void *self, pov_vec3 point,
                     pov_vec3 point_lo)
{
    const pov_two3 own = instance_point(p, point, point_lo);

    return shape->inside(self, pov_two3_hi(own), pov_two3_lo(own));
}
