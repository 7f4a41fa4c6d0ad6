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
    pov_vec3 half;
    int i, j;

    memset(p, 0, sizeof *p);
    p->axes = true;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++) {
            p->inverse[i][j] = entry(map->inv, map->inv_lo, i, j);
            if (i != j && p->inverse[i][j].hi != 0.0)
                p->axes = false;
        }
    p->far = HUGE_VAL;
    p->anchor = pov_vec3_of(map->m[0][3], map->m[1][3], map->m[2][3]);
    if (around) {
        p->anchor = pov_add(pov_scale(around->lo, 0.5), pov_scale(around->hi, 0.5));
        half = pov_scale(pov_sub(around->hi, around->lo), 0.5);
        p->far = 16.0 * pov_dot(half, half);
    }
    moved[0] = pov_two_sub(pov_two_of(p->anchor.x, 0.0), entry(map->m, map->m_lo, 0, 3));
    moved[1] = pov_two_sub(pov_two_of(p->anchor.y, 0.0), entry(map->m, map->m_lo, 1, 3));
    moved[2] = pov_two_sub(pov_two_of(p->anchor.z, 0.0), entry(map->m, map->m_lo, 2, 3));
    for (i = 0; i < 3; i++)
        p->own_anchor[i] = apply_row(p, i, moved);
}

/* ---- rays ---- */

/* How far to move the start along the ray before it goes into the shape's space, so that the rounding of the direction
 * there is spread over the shape's size and not over the way to it. From near by, and for the shape that the ray
 * leaves, nothing: the whole distance then keeps its relative exactness. */
static double approach(const placement *p, const pov_ray *ray, uint32_t owner)
{
    pov_vec3 f = pov_sub(ray->org, p->anchor), d = ray->dir;
    double m, t;

    if (!(pov_dot(f, f) > p->far) || ray->left == owner)
        return 0.0;
    m = pov_largest(d);
    d = pov_vec3_of(d.x / m, d.y / m, d.z / m);
    t = -pov_dot(f, d) / pov_dot(d, d) / m;
    return t > 0.0 && t < 1e300 ? t : 0.0;
}

static inline pov_two centred(double o, double o_lo, double anchor, double t, double d)
{
    if (t == 0.0)
        return pov_two_add_double(pov_two_sum(o, -anchor), o_lo);
    return pov_recentre(o, o_lo, anchor, t, d);
}

/* A component of the direction: what rounds the exact sum, but for errors far below a unit in the last place. */
static inline double turned(const placement *p, int i, pov_vec3 d)
{
    pov_two sum;

    if (p->axes) {
        double v = i == 0 ? d.x : i == 1 ? d.y : d.z;
        return pov_two_mul_double(p->inverse[i][i], v).hi;
    }
    sum = pov_two_add(pov_two_mul_double(p->inverse[i][0], d.x), pov_two_mul_double(p->inverse[i][1], d.y));
    return pov_two_add(sum, pov_two_mul_double(p->inverse[i][2], d.z)).hi;
}

/* The ray in the shape's space, its start moved by t along it. */
static void own_ray(const placement *p, const pov_ray *ray, double t, pov_ray *own)
{
    pov_two w[3], o[3];
    int i;

    w[0] = centred(ray->org.x, ray->org_lo.x, p->anchor.x, t, ray->dir.x);
    w[1] = centred(ray->org.y, ray->org_lo.y, p->anchor.y, t, ray->dir.y);
    w[2] = centred(ray->org.z, ray->org_lo.z, p->anchor.z, t, ray->dir.z);
    for (i = 0; i < 3; i++)
        o[i] = pov_two_add(apply_row(p, i, w), p->own_anchor[i]);
    own->org = pov_vec3_of(o[0].hi, o[1].hi, o[2].hi);
    own->org_lo = pov_vec3_of(o[0].lo, o[1].lo, o[2].lo);
    own->dir = pov_vec3_of(turned(p, 0, ray->dir), turned(p, 1, ray->dir), turned(p, 2, ray->dir));
    own->left = ray->left;
    own->left_mark = ray->left_mark;
}

/* ---- crossings of a ray that was moved ---- */

enum { MOVED_SLOTS = 8 };

/* Takes crossings that count from the moved start, and passes them on as the caller counts. */
typedef struct passage {
    pov_hits *to;
    double t;
    bool done;
} passage;

static void pass_on(pov_hits *from)
{
    passage *p = from->user;
    uint32_t i;

    for (i = 0; i < from->count && !p->done; i++) {
        pov_two sum = pov_two_sum(p->t, from->at[i].t);
        sum = pov_fast_two_sum(sum.hi, sum.lo + from->at[i].t_lo);
        p->done = !pov_cross(p->to, sum.hi, sum.lo, from->at[i].mark);
    }
    from->count = 0;
}

static bool make_room(pov_hits *from)
{
    const passage *p = from->user;

    pass_on(from);
    return !p->done;
}

/* All crossings are asked for, in an interval a little wider than the caller's; which of them count is decided where
 * they are passed on, by the same comparison as for every other shape. */
static void intersect_moved(const pov_shape_class *shape, const void *self, const pov_ray *own, double t, pov_hits *hits)
{
    pov_crossing at[MOVED_SLOTS];
    passage through = { hits, t, false };
    pov_hits moved;

    moved.tmin = (hits->tmin - t) - (fabs(hits->tmin) + t) * 0x1p-50;
    moved.tmax = (hits->tmax - t) + (fabs(hits->tmax) + t) * 0x1p-50;
    moved.want = POV_WANT_ALL;
    moved.always_exact = hits->always_exact;
    moved.owner = hits->owner;
    moved.count = 0;
    moved.capacity = MOVED_SLOTS;
    moved.decided = 0;
    moved.at = at;
    moved.grow = make_room;
    moved.user = &through;
    shape->intersect(self, own, &moved);
    pass_on(&moved);
    hits->decided += moved.decided;
}

void placement_intersect(const placement *p, const pov_shape_class *shape, const void *self, const pov_ray *ray, pov_hits *hits)
{
    double t = approach(p, ray, hits->owner);
    pov_ray own;

    own_ray(p, ray, t, &own);
    if (t == 0.0)
        shape->intersect(self, &own, hits);
    else
        intersect_moved(shape, self, &own, t, hits);
}

/* ---- the rest ---- */

void placement_normal(const placement *p, const pov_shape_class *shape, const void *self, const pov_ray *ray,
                      const pov_crossing *at, pov_vec3 *out)
{
    double t = approach(p, ray, at->owner), n[3];
    pov_crossing moved = *at;
    pov_two from_there = pov_two_add_double(pov_two_sum(at->t, -t), at->t_lo);
    pov_ray own;
    pov_vec3 normal;
    int i;

    own_ray(p, ray, t, &own);
    moved.t = from_there.hi;
    moved.t_lo = from_there.lo;
    shape->normal(self, &own, &moved, &normal);
    /* Normals go by the transpose of the inverse. */
    for (i = 0; i < 3; i++) {
        pov_two sum = pov_two_add(pov_two_mul_double(p->inverse[0][i], normal.x), pov_two_mul_double(p->inverse[1][i], normal.y));
        n[i] = pov_two_add(sum, pov_two_mul_double(p->inverse[2][i], normal.z)).hi;
    }
    *out = pov_unit(pov_vec3_of(n[0], n[1], n[2]));
}

bool placement_inside(const placement *p, const pov_shape_class *shape, const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    pov_two w[3], o[3];
    int i;

    w[0] = centred(point.x, point_lo.x, p->anchor.x, 0.0, 0.0);
    w[1] = centred(point.y, point_lo.y, p->anchor.y, 0.0, 0.0);
    w[2] = centred(point.z, point_lo.z, p->anchor.z, 0.0, 0.0);
    for (i = 0; i < 3; i++)
        o[i] = pov_two_add(apply_row(p, i, w), p->own_anchor[i]);
    return shape->inside(self, pov_vec3_of(o[0].hi, o[1].hi, o[2].hi), pov_vec3_of(o[0].lo, o[1].lo, o[2].lo));
}
