#include "common/triangle.h"

#include "common/lanes.h"
#include "common/report.h"

/* Starts nearer than this, in sizes of what the anchor stands for, need no double-double: the point is then off by five
 * roundings of the distance, and a coordinate in the view by four times that. */
static const double near = 64.0;

void common_triangle_enter(common_triangle_ray *r, const pov_ray *ray, pov_vec3 anchor, double scale,
                           bool always_exact)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };

    r->about = common_enter(ray, pov_two3_of(pov_scale(anchor, common_inverse(scale)), zero), scale);
    common_triangle_place(r, ray, anchor, scale);
    common_triangle_look(r, always_exact);
}

void common_triangle_place(common_triangle_ray *r, const pov_ray *ray, pov_vec3 anchor, double scale)
{
    r->anchor = anchor;
    r->org = pov_scale(ray->org, scale);
    r->org_lo = pov_scale(ray->org_lo, scale);
    r->view.exact = r->view.escalated = false;
}

void common_triangle_look(common_triangle_ray *r, bool always_exact)
{
    const double speed = pov_dot(r->about.d, r->about.d), along = -pov_dot(pov_two3_hi(r->about.f), r->about.d) / speed;
    const double size = pov_largest(pov_two3_hi(r->about.f));
    const pov_vec3 w = size < near ? pov_add(pov_two3_hi(r->about.f), pov_scale(r->about.d, along)) : common_along(&r->about, along);

    r->along = along;
    r->view = common_view_make(r->org, r->org_lo, &r->about, w, always_exact);
    if (size < near)
        r->view.error += 24.0 * COMMON_U * (size + pov_largest(w));
}

/* ---- the plane ---- */

/* The normal of two edges, and the error of each component. */
typedef struct plane { pov_vec3 normal, error; } plane;

/* x y - z w, with an error bound: the edges are rounded once, then each product, then the difference. */
static inline double minor_of(double x, double y, double z, double w, double *error)
{
    *error = 5.0 * COMMON_U * (fabs(x * y) + fabs(z * w));
    return x * y - z * w;
}

COMMON_INLINE plane plane_of(const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c)
{
    const pov_vec3 e = pov_sub(*c, *a), f = pov_sub(*b, *a);
    plane p;

    p.normal.x = minor_of(e.y, f.z, e.z, f.y, &p.error.x);
    p.normal.y = minor_of(e.z, f.x, e.x, f.z, &p.error.y);
    p.normal.z = minor_of(e.x, f.y, e.y, f.x, &p.error.z);
    return p;
}

static pov_two3 edge(const pov_vec3 *from, const pov_vec3 *to)
{
    pov_two3 e;

    e.x = pov_two_sum(to->x, -from->x);
    e.y = pov_two_sum(to->y, -from->y);
    e.z = pov_two_sum(to->z, -from->z);
    return e;
}

static pov_two3 exact_normal(const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c)
{
    return pov_two3_cross(edge(a, c), edge(a, b));
}

/* The ray about a corner. */
static common_ray about_corner(const common_triangle_ray *r, const pov_vec3 *a)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    common_ray k = r->about;

    k.f = common_offset(r->org, r->org_lo, pov_two3_of(*a, zero), 1.0);
    return k;
}

/* The distance to the plane: a first quotient, and its correction about the point there. */
COMMON_INLINE common_root find_distance(const plane *p, const common_ray *k, double *first)
{
    const double slope = pov_dot(p->normal, k->d);
    const double slope_error = common_sum_of_sizes(p->error, k->d) +
                               6.0 * COMMON_U * common_sum_of_sizes(p->normal, k->d);
    common_root root;
    double rest, off;
    pov_vec3 w;

    *first = -pov_dot(p->normal, pov_two3_hi(k->f)) / slope;
    w = common_along(k, *first);
    rest = -pov_dot(p->normal, w) / slope;
    off = common_sum_of_sizes(p->error, w) + 7.0 * COMMON_U * common_sum_of_sizes(p->normal, w) +
          fabs(rest) * slope_error;
    root.t = pov_two_sum(*first, rest);
    root.error = off / fabs(slope) + COMMON_U * fabs(rest);
    root.feature = root.flags = 0;
    if (!(fabs(slope) > 1024.0 * slope_error && pov_largest(pov_two3_hi(k->f)) < COMMON_FAR))
        root.error = HUGE_VAL;
    return root;
}

static pov_two escalate_distance(const pov_two3 *normal, const common_ray *k, double first)
{
    const pov_two slope = pov_two3_dot(*normal, common_direction(k));
    const pov_two height = pov_two3_dot(*normal, isfinite(first) ? common_along_two(k, first) : k->f);
    const pov_two t = pov_two_neg(pov_two_div(height, slope));

    return isfinite(first) ? pov_two_add_double(t, first) : t;
}

/* Of faces that are equally near the first counts, in whatever order they come. */
static bool report(pov_hits *hits, double t, double t_lo, pov_mark mark)
{
    pov_crossing *at = hits->at;

    if (hits->want != POV_WANT_NEAREST || hits->count == 0 || at->t != t || at->t_lo != t_lo || at->owner != hits->owner)
        return pov_cross(hits, t, t_lo, mark);
    if (mark.feature < at->mark.feature)
        at->mark = mark;
    return true;
}

bool common_triangle_cross(common_triangle_ray *r, const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c,
                           pov_mark mark, pov_hits *hits)
{
    const plane p = plane_of(a, b, c);
    const common_ray k = about_corner(r, a);
    double first;
    common_root root = find_distance(&p, &k, &first);
    const common_verdict verdict = common_judge(&root, k.unit, COMMON_FINE, hits);

    if (verdict == COMMON_OUTSIDE)
        return true;
    if (verdict == COMMON_OPEN || r->view.exact || hits->always_exact) {
        const pov_two3 normal = exact_normal(a, b, c);

        r->view.escalated = true;
        root.t = escalate_distance(&normal, &k, first);
    }
    mark.flags |= r->view.escalated ? POV_MARK_ESCALATED : 0;
    return !isfinite(root.t.hi) || report(hits, root.t.hi * k.unit, root.t.lo * k.unit, mark);
}

/* ---- side by side ---- */

/* Corners by lane, with what is behind them; and distances to planes, in the units of a common_ray. */
typedef struct face_lanes { common_rays rays; common_lane corner[3][4]; common_lane t, t_lo, error, unit; } face_lanes;

static inline pov_vec3 lane_corner(const face_lanes *l, int k, uint32_t i)
{
    return pov_vec3_of(l->corner[k][0][i], l->corner[k][1][i], l->corner[k][2][i]);
}

static void put_corners(face_lanes *l, uint32_t i, int k, const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c, const pov_vec3 *d)
{
    const void *const corners[4] = { a, b, c, d };

    common_put_four_shapes(l->corner[k][0] + i, COMMON_LANES, 4, corners);
}

static void put_faces(face_lanes *l, const common_triangle_pair *pairs, uint32_t n)
{
    for (uint32_t i = 0; i < COMMON_LANES; i += 4) {
        const common_triangle_pair *a = &pairs[common_lane_of(i, n)], *b = &pairs[common_lane_of(i + 1, n)];
        const common_triangle_pair *c = &pairs[common_lane_of(i + 2, n)], *d = &pairs[common_lane_of(i + 3, n)];
        const pov_ray *const rays[4] = { a->ray, b->ray, c->ray, d->ray };

        common_put_four_rays(&l->rays, i, rays);
        for (int k = 0; k < 3; k++)
            put_corners(l, i, k, a->corner[k], b->corner[k], c->corner[k], d->corner[k]);
    }
}

COMMON_CLONES static void find_distances(face_lanes *restrict l, double scale)
{
    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        const pov_vec3 zero = { 0.0, 0.0, 0.0 }, a = lane_corner(l, 0, i), b = lane_corner(l, 1, i), c = lane_corner(l, 2, i);
        const pov_ray ray = common_get_ray(&l->rays, i);
        const double power = pov_inverse_power(pov_largest(ray.dir));
        const plane p = plane_of(&a, &b, &c);
        common_ray k;
        common_root root;
        double first;

        k.f = common_offset(pov_scale(ray.org, scale), pov_scale(ray.org_lo, scale), pov_two3_of(a, zero), 1.0);
        k.d = pov_scale(ray.dir, power);
        k.d_lo = pov_scale(ray.dir_lo, power);
        root = find_distance(&p, &k, &first);
        l->t[i] = root.t.hi;
        l->t_lo[i] = root.t.lo;
        l->error[i] = root.error;
        l->unit[i] = power * common_inverse(scale);
    }
}

uint32_t common_triangle_cross_many(const common_triangle_pair *pairs, uint32_t n, double scale)
{
    uint32_t open = 0, i;
    face_lanes l;

    put_faces(&l, pairs, n);
    find_distances(&l, scale);
    for (i = 0; i < n; i++) {
        const common_root root = { { l.t[i], l.t_lo[i] }, l.error[i], 0, 0 };
        const common_verdict verdict = common_judge(&root, l.unit[i], COMMON_FINE, pairs[i].hits);

        if (verdict == COMMON_OPEN)
            open |= 1u << i;
        else if (verdict == COMMON_GOOD && isfinite(root.t.hi))
            report(pairs[i].hits, root.t.hi * l.unit[i], root.t.lo * l.unit[i], common_mark(pairs[i].feature, 0));
    }
    return open;
}

/* ---- points ---- */

/* The normal of a sliver is a small difference, and needs double-double. */
static bool is_precise(const plane *p) { return pov_largest(p->error) < 0x1p-47 * pov_largest(p->normal); }

bool common_triangle_is_degenerate(const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c)
{
    const plane p = plane_of(a, b, c);

    return !is_precise(&p) && !(pov_largest(pov_two3_hi(exact_normal(a, b, c))) > 0.0);
}

pov_vec3 common_triangle_normal(const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c)
{
    const plane p = plane_of(a, b, c);

    return is_precise(&p) ? p.normal : pov_two3_hi(exact_normal(a, b, c));
}

/* certain: where pov_unit() needs no scaling, and the normal is no small difference. */
COMMON_CLONES static void find_normals(const face_lanes *restrict l, common_lane3 *restrict out, common_lane *restrict certain)
{
    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        const pov_vec3 a = lane_corner(l, 0, i), b = lane_corner(l, 1, i), c = lane_corner(l, 2, i);
        const plane p = plane_of(&a, &b, &c);
        const double size = pov_largest(p.normal), length = sqrt(pov_dot(p.normal, p.normal));

        out->x[i] = p.normal.x / length;
        out->y[i] = p.normal.y / length;
        out->z[i] = p.normal.z / length;
        (*certain)[i] = size >= 1e-120 && size <= 1e120 && is_precise(&p) ? 1.0 : 0.0;
    }
}

void common_triangle_normals(const pov_vec3 *const corner[COMMON_TRIANGLES][3], uint32_t n, pov_vec3 *const *out)
{
    common_lane certain;
    common_lane3 unit;
    face_lanes l;

    for (uint32_t i = 0; i < COMMON_LANES; i += 4)
        for (int k = 0; k < 3; k++)
            put_corners(&l, i, k, corner[common_lane_of(i, n)][k], corner[common_lane_of(i + 1, n)][k],
                        corner[common_lane_of(i + 2, n)][k], corner[common_lane_of(i + 3, n)][k]);
    find_normals(&l, &unit, &certain);
    for (uint32_t i = 0; i < n; i++)
        *out[i] = certain[i] > 0.0 ? common_get(&unit, i) : pov_unit(common_triangle_normal(corner[i][0], corner[i][1], corner[i][2]));
}

void common_triangle_shares(const pov_vec3 *a, const pov_vec3 *b, const pov_vec3 *c, pov_vec3 point, pov_vec3 point_lo,
                            double share[3])
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const pov_vec3 p = pov_two3_hi(common_offset(point, point_lo, pov_two3_of(*a, zero), 1.0));
    const pov_vec3 e = pov_sub(*b, *a), f = pov_sub(*c, *a), n = pov_cross_product(e, f);
    const double square = pov_dot(n, n);

    share[1] = pov_dot(pov_cross_product(p, f), n) / square;
    share[2] = pov_dot(pov_cross_product(e, p), n) / square;
    share[0] = 1.0 - share[1] - share[2];
}

/* ---- normals that are blended ---- */

bool common_triangle_blend(const pov_vec3 normal[3], const double share[3], pov_vec3 *out)
{
    const pov_vec3 sum = pov_add(pov_add(pov_scale(normal[0], share[0]), pov_scale(normal[1], share[1])),
                                 pov_scale(normal[2], share[2]));

    *out = pov_unit(sum);
    return pov_largest(*out) > 0.0;
}

/* Points by lane; certain: where pov_unit() needs no scaling. */
typedef struct blend_lanes { face_lanes faces, normals; common_lane3 point, point_lo, out; common_lane certain; } blend_lanes;

COMMON_CLONES static void find_blends(blend_lanes *restrict l)
{
    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        const pov_vec3 a = lane_corner(&l->faces, 0, i), b = lane_corner(&l->faces, 1, i), c = lane_corner(&l->faces, 2, i);
        const pov_vec3 zero = { 0.0, 0.0, 0.0 };
        const pov_vec3 p = pov_two3_hi(common_offset(common_get(&l->point, i), common_get(&l->point_lo, i), pov_two3_of(a, zero), 1.0));
        const pov_vec3 e = pov_sub(b, a), f = pov_sub(c, a), n = pov_cross_product(e, f);
        const double square = pov_dot(n, n);
        const double one = pov_dot(pov_cross_product(p, f), n) / square, two = pov_dot(pov_cross_product(e, p), n) / square;
        const pov_vec3 sum = pov_add(pov_add(pov_scale(lane_corner(&l->normals, 0, i), 1.0 - one - two),
                                             pov_scale(lane_corner(&l->normals, 1, i), one)),
                                     pov_scale(lane_corner(&l->normals, 2, i), two));
        const double size = pov_largest(sum), length = sqrt(pov_dot(sum, sum));

        l->out.x[i] = sum.x / length;
        l->out.y[i] = sum.y / length;
        l->out.z[i] = sum.z / length;
        l->certain[i] = size >= 1e-120 && size <= 1e120 ? 1.0 : 0.0;
    }
}

static void put_points(blend_lanes *l, const common_triangle_point *at, uint32_t n)
{
    for (uint32_t i = 0; i < COMMON_LANES; i += 4) {
        const common_triangle_point *a = &at[common_lane_of(i, n)], *b = &at[common_lane_of(i + 1, n)];
        const common_triangle_point *c = &at[common_lane_of(i + 2, n)], *d = &at[common_lane_of(i + 3, n)];

        for (int k = 0; k < 3; k++) {
            put_corners(&l->faces, i, k, a->corner[k], b->corner[k], c->corner[k], d->corner[k]);
            put_corners(&l->normals, i, k, a->normal[k], b->normal[k], c->normal[k], d->normal[k]);
        }
    }
    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        common_put(&l->point, i, at[common_lane_of(i, n)].point);
        common_put(&l->point_lo, i, at[common_lane_of(i, n)].point_lo);
    }
}

static bool blend_one(const common_triangle_point *at, pov_vec3 *out)
{
    double share[3];

    common_triangle_shares(at->corner[0], at->corner[1], at->corner[2], at->point, at->point_lo, share);
    return common_triangle_blend((const pov_vec3[3]){ *at->normal[0], *at->normal[1], *at->normal[2] }, share, out);
}

uint32_t common_triangle_blend_many(const common_triangle_point *at, uint32_t n, pov_vec3 *out)
{
    uint32_t found = 0;
    blend_lanes l;

    if (n >= COMMON_LEAST) {
        put_points(&l, at, n);
        find_blends(&l);
    }
    for (uint32_t i = 0; i < n; i++) {
        const bool certain = n >= COMMON_LEAST && l.certain[i] > 0.0;

        if (certain)
            out[i] = common_get(&l.out, i);
        found |= (uint32_t)(certain || blend_one(&at[i], &out[i])) << i;
    }
    return found;
}
