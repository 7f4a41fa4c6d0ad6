#include "world/placement_parts.h"

#include <string.h>

/* ---- making ---- */

static pov_two entry(const double hi[3][4], const double lo[3][4], int i, int j)
{
    return pov_two_of(hi[i][j], lo[i][j]);
}

/* One bound of a row's sum of intervals, the lower one for a side of -1, the upper one for 1: the terms' two-part sum,
 * moved outward by more than its error (relative to the terms, 2^-96 is many times what the additions lose) and rounded
 * outward. near, far: the corners of the box, far the one on that side. */
static inline double bound(const pov_affine *map, int i, const double *near, const double *far, double side)
{
    pov_two sum = entry(map->m, map->m_lo, i, 3);
    double size = fabs(sum.hi);
    int j;

    for (j = 0; j < 3; j++) {
        double v = map->m[i][j] >= 0.0 ? far[j] : near[j];
        pov_two term = pov_two_mul_double(entry(map->m, map->m_lo, i, j), v);
        sum = pov_two_add(sum, term);
        size += fabs(term.hi);
    }
    return side * pov_next(side * sum.hi + size * 0x1p-96);
}

void placement_box(const pov_affine *map, const pov_box *own, pov_box *out)
{
    const double lo[3] = { own->lo.x, own->lo.y, own->lo.z }, hi[3] = { own->hi.x, own->hi.y, own->hi.z };

    out->lo = pov_vec3_of(bound(map, 0, hi, lo, -1.0), bound(map, 1, hi, lo, -1.0), bound(map, 2, hi, lo, -1.0));
    out->hi = pov_vec3_of(bound(map, 0, lo, hi, 1.0), bound(map, 1, lo, hi, 1.0), bound(map, 2, lo, hi, 1.0));
}

static inline double part(pov_vec3 v, int i)
{
    return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

static inline pov_two inverse(const placement *p, int i, int j)
{
    return pov_two_of(part(p->column[j], i), part(p->column_lo[j], i));
}

static inline pov_two apply_row(const placement *p, int i, const pov_two v[3])
{
    if (p->axes)
        return pov_two_mul(inverse(p, i, i), v[i]);
    return pov_two_add(pov_two_add(pov_two_mul(inverse(p, i, 0), v[0]), pov_two_mul(inverse(p, i, 1), v[1])),
                       pov_two_mul(inverse(p, i, 2), v[2]));
}

static void set_inverse(placement *p, const pov_affine *map)
{
    int i, j;

    p->axes = true;
    for (j = 0; j < 3; j++) {
        p->column[j] = pov_vec3_of(map->inv[0][j], map->inv[1][j], map->inv[2][j]);
        p->column_lo[j] = pov_vec3_of(map->inv_lo[0][j], map->inv_lo[1][j], map->inv_lo[2][j]);
        for (i = 0; i < 3; i++)
            if (i != j && map->inv[i][j] != 0.0)
                p->axes = false;
    }
}

/* From the anchor to the further side of the own box, and some: what is flat stays within the range of floats. reach:
 * the edges of the box in the world. snug: set to false if the nearer side is not as far, as the filter sees it. */
static bool set_half(placement *p, int i, double lo, double hi, pov_vec3 reach, bool *snug)
{
    const pov_two at = pov_two_of(part(p->own_anchor, i), part(p->own_anchor_lo, i));
    const double above = pov_two_sub(pov_two_of(hi, 0.0), at).hi, below = pov_two_sub(at, pov_two_of(lo, 0.0)).hi;
    const double least = fmin(above, below) - PLACEMENT_ROUNDED * (fabs(lo) + fabs(hi));
    double half = fmax(above, below) + PLACEMENT_LEAST, across = 0.0;
    int j;

    for (j = 0; j < 3; j++)
        across += fabs(inverse(p, i, j).hi) * part(reach, j);
    half = fmax(half, PLACEMENT_FLAT * across);
    p->per_half[i] = (float)((1.0 - 0x1p-20) / half);
    *snug = *snug && half > PLACEMENT_SMALL && least * (double)p->per_half[i] >= PLACEMENT_SNUG;
    return half < PLACEMENT_LARGE && pov_largest(p->column[i]) < PLACEMENT_RANGE;
}

static bool set_box(placement *p, const pov_box *own, const pov_box *around, bool *snug)
{
    const pov_vec3 reach = pov_sub(around->hi, around->lo);

    *snug = true;
    return pov_largest(reach) < PLACEMENT_RANGE && set_half(p, 0, own->lo.x, own->hi.x, reach, snug) &&
           set_half(p, 1, own->lo.y, own->hi.y, reach, snug) && set_half(p, 2, own->lo.z, own->hi.z, reach, snug);
}

static uint8_t what_is_known(placement *p, const pov_box *own, const pov_box *around, uint32_t flags)
{
    bool snug;

    if (!around || !set_box(p, own, around, &snug))
        return PLACEMENT_UNKNOWN;
    if (!(flags & (POV_SHAPE_BOX | POV_SHAPE_BALL)) || !snug)
        return PLACEMENT_IN_BOX;
    return flags & POV_SHAPE_BOX ? PLACEMENT_IS_BOX : PLACEMENT_IS_BALL;
}

void placement_init(placement *p, const pov_affine *map, const pov_box *own, const pov_box *around, uint32_t flags)
{
    pov_two moved[3], at[3];
    int i;

    memset(p, 0, sizeof *p);
    set_inverse(p, map);
    p->anchor = pov_vec3_of(map->m[0][3], map->m[1][3], map->m[2][3]);
    if (around)
        p->anchor = pov_add(pov_scale(around->lo, 0.5), pov_scale(around->hi, 0.5));
    moved[0] = pov_two_sub(pov_two_of(p->anchor.x, 0.0), entry(map->m, map->m_lo, 0, 3));
    moved[1] = pov_two_sub(pov_two_of(p->anchor.y, 0.0), entry(map->m, map->m_lo, 1, 3));
    moved[2] = pov_two_sub(pov_two_of(p->anchor.z, 0.0), entry(map->m, map->m_lo, 2, 3));
    for (i = 0; i < 3; i++)
        at[i] = apply_row(p, i, moved);
    p->own_anchor = pov_vec3_of(at[0].hi, at[1].hi, at[2].hi);
    p->own_anchor_lo = pov_vec3_of(at[0].lo, at[1].lo, at[2].lo);
    p->known = what_is_known(p, own, around, flags);
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
        return pov_two_mul_double(inverse(p, i, i), part(d, i));
    sum = pov_two_add(pov_two_mul_double(inverse(p, i, 0), d.x), pov_two_mul_double(inverse(p, i, 1), d.y));
    return pov_two_add(sum, pov_two_mul_double(inverse(p, i, 2), d.z));
}

/* A point of the world, in two parts, in the shape's own space. */
static inline void own_point(const placement *p, pov_vec3 at, pov_vec3 at_lo, pov_two out[3])
{
    pov_two w[3];
    int i;

    w[0] = from_anchor(at.x, at_lo.x, p->anchor.x);
    w[1] = from_anchor(at.y, at_lo.y, p->anchor.y);
    w[2] = from_anchor(at.z, at_lo.z, p->anchor.z);
    for (i = 0; i < 3; i++)
        out[i] = pov_two_add(apply_row(p, i, w), pov_two_of(part(p->own_anchor, i), part(p->own_anchor_lo, i)));
}

void placement_ray_portable(const placement *p, const pov_ray *ray, pov_ray *own)
{
    pov_two o[3], d[3];
    int i;

    own_point(p, ray->org, ray->org_lo, o);
    for (i = 0; i < 3; i++)
        d[i] = turned(p, i, ray->dir);
    own->org = pov_vec3_of(o[0].hi, o[1].hi, o[2].hi);
    own->org_lo = pov_vec3_of(o[0].lo, o[1].lo, o[2].lo);
    own->dir = pov_vec3_of(d[0].hi, d[1].hi, d[2].hi);
    own->dir_lo = pov_vec3_of(d[0].lo, d[1].lo, d[2].lo);
    own->left = ray->left;
    own->left_mark = ray->left_mark;
}

void placement_ray(const placement *p, const pov_ray *ray, pov_ray *own)
{
#if defined(__x86_64__) && defined(__GNUC__) && !defined(POV_PORTABLE)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        placement_ray_avx2(p, ray, own);
        return;
    }
#endif
    placement_ray_portable(p, ray, own);
}

/* ---- what rays are answered ---- */

void placement_intersect(const placement *p, const pov_shape_class *shape, const void *self, const pov_ray *ray,
                         pov_hits *hits)
{
    pov_ray own;

    placement_ray(p, ray, &own);
    shape->intersect(self, &own, hits);
}

void placement_normal(const placement *p, const pov_shape_class *shape, const void *self, const pov_ray *ray,
                      const pov_crossing *at, pov_vec3 *out)
{
    pov_ray own;

    placement_ray(p, ray, &own);
    shape->normal(self, &own, at, out);
    placement_turn_normal(p, out);
}

/* Normals go by the transpose of the inverse. */
void placement_turn_normal(const placement *p, pov_vec3 *normal)
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

bool placement_inside(const placement *p, const pov_shape_class *shape, const void *self, pov_vec3 point,
                      pov_vec3 point_lo)
{
    pov_two o[3];

    own_point(p, point, point_lo, o);
    return shape->inside(self, pov_vec3_of(o[0].hi, o[1].hi, o[2].hi), pov_vec3_of(o[0].lo, o[1].lo, o[2].lo));
}
