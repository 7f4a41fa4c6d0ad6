#include "world/placement.h"

#include <string.h>

/* ---- making ---- */

static pov_two entry(const double hi[3][4], const double lo[3][4], int i, int j)
{
    return pov_two_of(hi[i][j], lo[i][j]);
}

/* One bound of a sum of intervals: the terms' two-part sum, moved outward by more than its error (relative to the
 * terms, 2^-96 is many times what the additions lose) and rounded outward. */
static double bound(const pov_affine *map, const pov_vec3 *corner, int i, double outward)
{
    const double v[3] = { corner->x, corner->y, corner->z };
    pov_two sum = entry(map->m, map->m_lo, i, 3);
    double size = fabs(sum.hi);
    int j;

    for (j = 0; j < 3; j++) {
        pov_two term = pov_two_mul_double(entry(map->m, map->m_lo, i, j), v[j]);
        sum = pov_two_add(sum, term);
        size += fabs(term.hi);
    }
    return nextafter(sum.hi + copysign(size * 0x1p-96, outward), outward);
}

static double pick(double factor, double at_plus, double at_minus)
{
    return factor >= 0.0 ? at_plus : at_minus;
}

void placement_box(const pov_affine *map, const pov_box *own, pov_box *out)
{
    double lo[3], hi[3];
    int i;

    for (i = 0; i < 3; i++) {
        const double *m = map->m[i];
        pov_vec3 a = pov_vec3_of(pick(m[0], own->lo.x, own->hi.x), pick(m[1], own->lo.y, own->hi.y),
                                 pick(m[2], own->lo.z, own->hi.z));
        pov_vec3 b = pov_vec3_of(pick(m[0], own->hi.x, own->lo.x), pick(m[1], own->hi.y, own->lo.y),
                                 pick(m[2], own->hi.z, own->lo.z));
        lo[i] = bound(map, &a, i, -HUGE_VAL);
        hi[i] = bound(map, &b, i, HUGE_VAL);
    }
    out->lo = pov_vec3_of(lo[0], lo[1], lo[2]);
    out->hi = pov_vec3_of(hi[0], hi[1], hi[2]);
}

static pov_two apply_row(const placement *p, int i, const pov_two v[3])
{
    if (p->axes)
        return pov_two_mul(p->inverse[i][i], v[i]);
    return pov_two_add(pov_two_add(pov_two_mul(p->inverse[i][0], v[0]), pov_two_mul(p->inverse[i][1], v[1])),
                       pov_two_mul(p->inverse[i][2], v[2]));
}

void placement_init(placement *p, const pov_affine *map, const pov_box *around)
{
    pov_two moved[3];
    int i, j;

    memset(p, 0, sizeof *p);
    p->axes = true;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++) {
            p->inverse[i][j] = entry(map->inv, map->inv_lo, i, j);
            if (i != j && p->inverse[i][j].hi != 0.0)
                p->axes = false;
        }
    p->anchor = pov_vec3_of(map->m[0][3], map->m[1][3], map->m[2][3]);
    if (around)
        p->anchor = pov_add(pov_scale(around->lo, 0.5), pov_scale(around->hi, 0.5));
    moved[0] = pov_two_sub(pov_two_of(p->anchor.x, 0.0), entry(map->m, map->m_lo, 0, 3));
    moved[1] = pov_two_sub(pov_two_of(p->anchor.y, 0.0), entry(map->m, map->m_lo, 1, 3));
    moved[2] = pov_two_sub(pov_two_of(p->anchor.z, 0.0), entry(map->m, map->m_lo, 2, 3));
    for (i = 0; i < 3; i++)
        p->own_anchor[i] = apply_row(p, i, moved);
}

/* ---- rays ---- */

/* From the anchor to a point, all parts of it. */
static inline pov_two from_anchor(double at, double at_lo, double anchor)
{
    return pov_two_add_double(pov_two_sum(at, -anchor), at_lo);
}

/* A component of the direction, in two parts: the ray in the shape's space then is the world's but for errors of the
 * order of 2^-100, from however far it comes. */
static inline pov_two turned(const placement *p, int i, pov_vec3 d)
{
    pov_two sum;

    if (p->axes)
        return pov_two_mul_double(p->inverse[i][i], i == 0 ? d.x : i == 1 ? d.y : d.z);
    sum = pov_two_add(pov_two_mul_double(p->inverse[i][0], d.x), pov_two_mul_double(p->inverse[i][1], d.y));
    return pov_two_add(sum, pov_two_mul_double(p->inverse[i][2], d.z));
}

static void own_ray(const placement *p, const pov_ray *ray, pov_ray *own)
{
    pov_two w[3], o[3], d[3];
    int i;

    w[0] = from_anchor(ray->org.x, ray->org_lo.x, p->anchor.x);
    w[1] = from_anchor(ray->org.y, ray->org_lo.y, p->anchor.y);
    w[2] = from_anchor(ray->org.z, ray->org_lo.z, p->anchor.z);
    for (i = 0; i < 3; i++) {
        o[i] = pov_two_add(apply_row(p, i, w), p->own_anchor[i]);
        d[i] = turned(p, i, ray->dir);
    }
    own->org = pov_vec3_of(o[0].hi, o[1].hi, o[2].hi);
    own->org_lo = pov_vec3_of(o[0].lo, o[1].lo, o[2].lo);
    own->dir = pov_vec3_of(d[0].hi, d[1].hi, d[2].hi);
    own->dir_lo = pov_vec3_of(d[0].lo, d[1].lo, d[2].lo);
    own->left = ray->left;
    own->left_mark = ray->left_mark;
}

void placement_intersect(const placement *p, const pov_shape_class *shape, const void *self, const pov_ray *ray,
                         pov_hits *hits)
{
    pov_ray own;

    own_ray(p, ray, &own);
    shape->intersect(self, &own, hits);
}

void placement_normal(const placement *p, const pov_shape_class *shape, const void *self, const pov_ray *ray,
                      const pov_crossing *at, pov_vec3 *out)
{
    pov_vec3 normal;
    pov_ray own;
    double n[3];
    int i;

    own_ray(p, ray, &own);
    shape->normal(self, &own, at, &normal);
    /* Normals go by the transpose of the inverse. */
    for (i = 0; i < 3; i++) {
        pov_two sum =
            pov_two_add(pov_two_mul_double(p->inverse[0][i], normal.x), pov_two_mul_double(p->inverse[1][i], normal.y));
        n[i] = pov_two_add(sum, pov_two_mul_double(p->inverse[2][i], normal.z)).hi;
    }
    *out = pov_unit(pov_vec3_of(n[0], n[1], n[2]));
}

bool placement_inside(const placement *p, const pov_shape_class *shape, const void *self, pov_vec3 point,
                      pov_vec3 point_lo)
{
    pov_two w[3], o[3];
    int i;

    w[0] = from_anchor(point.x, point_lo.x, p->anchor.x);
    w[1] = from_anchor(point.y, point_lo.y, p->anchor.y);
    w[2] = from_anchor(point.z, point_lo.z, p->anchor.z);
    for (i = 0; i < 3; i++)
        o[i] = pov_two_add(apply_row(p, i, w), p->own_anchor[i]);
    return shape->inside(self, pov_vec3_of(o[0].hi, o[1].hi, o[2].hi), pov_vec3_of(o[0].lo, o[1].lo, o[2].lo));
}
