/* Pairs of a small polygon and a ray, side by side. */
#include "common/edges.h"
#include "common/lanes.h"
#include "common/polygon.h"

/* Fewer lanes than COMMON_LANES: a polygon has many corners to copy, so unused lanes cost much. */
enum { TOGETHER = 4 };

/* Number of doubles at the start of a polygon, in whole fours. */
#define NUMBER_OF(member) (offsetof(common_polygon, member) / sizeof(double))
enum { NUMBERS = (NUMBER_OF(count) + 3) / 4 * 4, PLANE_NUMBERS = (NUMBER_OF(near) + 3) / 4 * 4 };

/* Pairs of a small polygon and a ray, with the ray's largest axis. */
typedef struct polygon_lanes {
    common_rays rays;
    double number[NUMBERS][TOGETHER];
    common_lane forward;
} polygon_lanes;

static inline pov_vec3 get_vector(const polygon_lanes *l, uint32_t i, size_t number, size_t separation)
{
    return pov_vec3_of(l->number[number][i], l->number[number + separation][i], l->number[number + 2 * separation][i]);
}

/* Permute a vector to the ray's view: across, up, away. */
static inline pov_vec3 rotate(pov_vec3 v, double forward)
{
    const double across = forward < 0.5 ? v.y : forward < 1.5 ? v.z : v.x,
        up = forward < 0.5 ? v.z : forward < 1.5 ? v.x : v.y;

    return pov_vec3_of(across, up, forward < 0.5 ? v.x : forward < 1.5 ? v.y : v.z);
}

/* The ray's point near the polygon, its permuted direction, and the error of a coordinate. */
typedef struct ray_at { pov_vec3 w, d; double error, forward; } ray_at;

/* A corner in the ray's view. above, certain: one or zero. A corner on the ray's level is not certainly above or
 * below. */
typedef struct projected { double across, up, above, certain; } projected;

static inline projected project(const polygon_lanes *l, size_t corner, uint32_t i, const ray_at *at)
{
    const pov_vec3 local = get_vector(l, i, NUMBER_OF(near) + 3 * corner, 1);
    const pov_vec3 v = rotate(pov_sub(local, at->w), at->forward), d = at->d;
    projected p;

    p.across = v.x * d.z - v.z * d.x;
    p.up = v.y * d.z - v.z * d.y;
    p.above = p.up > 0.0 ? 1.0 : 0.0;
    p.certain = fabs(p.up) > at->error ? 1.0 : 0.0;
    return p;
}

/* As is_right() of the primitive, one or zero: does an edge pass the ray on the right, to the other side of the level?
 * Adds one to `certain` if the result is certain. */
static inline double pass(projected a, projected b, double error, double *certain)
{
    const double cross = a.across * b.up - b.across * a.up, step = b.above - a.above;
    const double doubt = error * (fabs(a.across) + fabs(a.up) + fabs(b.across) + fabs(b.up) + 2.0 * error) +
                         4.0 * COMMON_U * (fabs(a.across * b.up) + fabs(b.across * a.up));
    const double sure = fabs(cross) > doubt ? 1.0 : 0.0;

    *certain += common_greater(sure, 1.0 - fabs(step));
    return step * cross > 0.0 ? 1.0 : 0.0;
}

/* Point-in-loop test: +1 definitely inside, -1 definitely outside, 0 undecided. */
static inline double enclose(const polygon_lanes *l, uint32_t i, pov_vec3 w, pov_vec3 d)
{
    const double error = common_view_blur(w), forward = l->forward[i];
    const ray_at at = { w, rotate(d, forward), error, forward };
    const projected a = project(l, 0, i, &at), b = project(l, 1, i, &at), c = project(l, 2, i, &at);
    const projected e = project(l, 3, i, &at), f = project(l, 4, i, &at), g = project(l, 5, i, &at);
    double certain = a.certain + b.certain + c.certain + e.certain + f.certain + g.certain;
    const double one = pass(a, b, error, &certain), two = pass(b, c, error, &certain);
    const double three = pass(c, e, error, &certain), four = pass(e, f, error, &certain);
    const double five = pass(f, g, error, &certain), turns = one + two + three + four + five;

    /* At most four edges pass; inside if one or three do. */
    return certain > 10.5 ? (fabs(fabs(turns - 2.0) - 1.0) < 0.5 ? 1.0 : -1.0) : 0.0;
}

/* Distances to planes, in the units of a common_ray, and their errors; within: the result of enclose(). */
typedef struct plane_lanes { common_lane t, t_lo, error, unit, within; } plane_lanes;

/* As intersect() without escalation, except for the test whether the point is inside. */
COMMON_INLINE common_ray find_plane(const polygon_lanes *l, uint32_t i, plane_lanes *out, pov_vec3 *w)
{
    const pov_ray ray = common_get_ray(&l->rays, i);
    const pov_vec3 n = get_vector(l, i, NUMBER_OF(normal), 2);
    const pov_two3 anchor = pov_two3_of(get_vector(l, i, NUMBER_OF(anchor), 2),
                                        get_vector(l, i, NUMBER_OF(anchor) + 1, 2));
    const common_ray k = common_enter(&ray, anchor, l->number[NUMBER_OF(scale)][i]);
    const double slope = pov_dot(n, k.d), first = -pov_dot(n, pov_two3_hi(k.f)) / slope;
    common_root r;

    *w = common_along(&k, first);
    r = common_polygon_distance(n, &k, slope, 6.0 * COMMON_U * common_sum_of_sizes(n, k.d), first, *w);
    out->t[i] = r.t.hi;
    out->t_lo[i] = r.t.lo;
    out->error[i] = r.error;
    out->unit[i] = k.unit;
    return k;
}

COMMON_CLONES static void find_planes(const polygon_lanes *restrict l, plane_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        pov_vec3 w;
        const common_ray k = find_plane(l, i, out, &w);

        out->within[i] = enclose(l, i, w, k.d);
    }
}

/* For definite hits. */
COMMON_CLONES static void find_crossed(const polygon_lanes *restrict l, plane_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        pov_vec3 w;

        find_plane(l, i, out, &w);
        out->within[i] = 1.0;
    }
}

/* Report a ray that does not start on the polygon, and definitely hits or misses it, or is out of its interval. False:
 * undecided. */
COMMON_INLINE bool report_plane(const plane_lanes *p, uint32_t i, const pov_ray *ray, pov_hits *h)
{
    const common_root r = { { p->t[i], p->t_lo[i] }, p->error[i], 0, 0 };
    const common_verdict verdict = common_judge(&r, p->unit[i], COMMON_FINE, h);

    if (verdict == COMMON_OUTSIDE)
        return true;
    if (p->within[i] == 0.0 || verdict == COMMON_OPEN || h->always_exact || h->owner == ray->origin_surface)
        return false;
    if (p->within[i] > 0.0 && isfinite(r.t.hi))
        pov_cross(h, r.t.hi * p->unit[i], r.t.lo * p->unit[i], common_mark(0, COMMON_POLYGON_MARK));
    return true;
}

/* ---- any number of corners ---- */

/* What corners are seen from: the rays' points near the polygon, permuted as directions are, and the errors of coordinates. */
typedef struct view_lanes { double w[3][TOGETHER], d[3][TOGETHER], error[TOGETHER]; } view_lanes;

COMMON_CLONES static void find_views(const polygon_lanes *restrict l, plane_lanes *restrict out, view_lanes *restrict v)
{
    for (uint32_t i = 0; i < TOGETHER; i++) {
        pov_vec3 w, d;
        const common_ray k = find_plane(l, i, out, &w);

        v->error[i] = common_view_blur(w);
        w = rotate(w, l->forward[i]);
        d = rotate(k.d, l->forward[i]);
        v->w[0][i] = w.x, v->w[1][i] = w.y, v->w[2][i] = w.z;
        v->d[0][i] = d.x, v->d[1][i] = d.y, v->d[2][i] = d.z;
    }
}

/* By lane: the corner that was seen last, the edges that passed on the right, and whether all that is certain. */
typedef struct loop_lanes { double across[TOGETHER], up[TOGETHER], above[TOGETHER], turns[TOGETHER], certain[TOGETHER]; } loop_lanes;

/* As project() and pass(), of a corner in the view of all rays; edge: 1, or 0 where none leads to it. */
COMMON_SEPARATE static void pass_corner(loop_lanes *restrict l, const view_lanes *restrict v, pov_vec3 corner, double edge)
{
    for (uint32_t i = 0; i < TOGETHER; i++) {
        const double x = corner.x - v->w[0][i], y = corner.y - v->w[1][i], z = corner.z - v->w[2][i];
        const double across = x * v->d[2][i] - z * v->d[0][i], up = y * v->d[2][i] - z * v->d[1][i];
        const double above = up > 0.0 ? 1.0 : 0.0, step = (above - l->above[i]) * edge;
        const double cross = l->across[i] * up - across * l->up[i], error = v->error[i];
        const double doubt = error * (fabs(l->across[i]) + fabs(l->up[i]) + fabs(across) + fabs(up) + 2.0 * error) +
                             4.0 * COMMON_U * (fabs(l->across[i] * up) + fabs(across * l->up[i]));
        const double sure = fabs(cross) > doubt ? 1.0 : 0.0, seen = fabs(up) > error ? 1.0 : 0.0;

        l->certain[i] *= seen * common_greater(sure, 1.0 - fabs(step));
        l->turns[i] += step * cross > 0.0 ? 1.0 : 0.0;
        l->across[i] = across;
        l->up[i] = up;
        l->above[i] = above;
    }
}

/* As enclose(): each edge that passes on the right turns out into in. No edge leads to the first corner of a loop. */
static void enclose_any(const common_corner *corners, uint32_t count, double forward, const view_lanes *views, double *within)
{
    loop_lanes l;

    for (uint32_t i = 0; i < TOGETHER; i++) {
        l.across[i] = l.up[i] = l.above[i] = l.turns[i] = 0.0;
        l.certain[i] = 1.0;
    }
    for (uint32_t c = 0; c < count; c++)
        pass_corner(&l, views, rotate(corners[c].local, forward), corners[c].starts ? 0.0 : 1.0);
    for (uint32_t i = 0; i < TOGETHER; i++) {
        const double half = 0.5 * l.turns[i];

        within[i] = l.certain[i] > 0.0 ? (half > floor(half) ? 1.0 : -1.0) : 0.0;
    }
}

/* ---- pairs ---- */

/* Pairs that are asked together: small polygons, or one of any size and rays of one largest axis. */
typedef struct polygon_pairs {
    const void *selves[TOGETHER];
    const pov_ray *rays[TOGETHER];
    pov_hits *hits[TOGETHER];
    uint32_t count;
} polygon_pairs;

static void find_together(const polygon_pairs *p, plane_lanes *plane)
{
    const common_polygon *first = p->selves[0];
    const void *shapes[TOGETHER];
    polygon_lanes lanes;
    view_lanes views;

    common_put_four_of(&lanes.rays, 0, p->rays, p->count);
    for (uint32_t i = 0; i < TOGETHER; i++) {
        shapes[i] = p->selves[common_lane_of(i, p->count)];
        lanes.forward[i] = common_forward(p->rays[common_lane_of(i, p->count)]->dir);
    }
    common_put_four_shapes(lanes.number[0], TOGETHER, first->small ? NUMBERS : PLANE_NUMBERS, shapes);
    if (first->small) {
        find_planes(&lanes, plane);
        return;
    }
    find_views(&lanes, plane, &views);
    enclose_any(first->corners, first->count, lanes.forward[0], &views, plane->within);
}

static void intersect_together(polygon_pairs *p, void (*one)(const void *self, const pov_ray *ray, pov_hits *hits))
{
    plane_lanes plane;

    if (p->count > 1)
        find_together(p, &plane);
    for (uint32_t i = 0; i < p->count; i++)
        if (p->count == 1 || !report_plane(&plane, i, p->rays[i], p->hits[i]))
            one(p->selves[i], p->rays[i], p->hits[i]);
    p->count = 0;
}

void common_polygon_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                   uint32_t n, void (*one)(const void *self, const pov_ray *ray, pov_hits *hits))
{
    polygon_pairs small = { .count = 0 }, large = { .count = 0 };

    for (uint32_t i = 0; i < n; i++) {
        const common_polygon *s = selves[i];
        polygon_pairs *to = s->small ? &small : &large;

        if (s->count == 0)
            continue;
        if (to == &large && large.count > 0 && (large.selves[0] != s || common_forward(large.rays[0]->dir) != common_forward(rays[i]->dir)))
            intersect_together(&large, one);
        to->selves[to->count] = s;
        to->rays[to->count] = rays[i];
        to->hits[to->count++] = hits[i];
        if (to->count == TOGETHER)
            intersect_together(to, one);
    }
    intersect_together(&small, one);
    intersect_together(&large, one);
}

/* Corners are not used, so polygons may have any number of them. */
void common_polygon_cross_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n,
                               void (*one)(const void *self, const pov_ray *ray, pov_hits *hits))
{
    uint32_t first, i;

    for (first = 0; first < n; first += TOGETHER) {
        const void *shapes[TOGETHER];
        polygon_lanes lanes;
        plane_lanes plane;

        common_put_four_of(&lanes.rays, 0, rays + first, n - first);
        for (i = 0; i < TOGETHER; i++)
            shapes[i] = selves[first + common_lane_of(i, n - first)];
        common_put_four_shapes(lanes.number[0], TOGETHER, PLANE_NUMBERS, shapes);
        find_crossed(&lanes, &plane);
        for (i = first; i < n && i < first + TOGETHER; i++)
            if (!report_plane(&plane, i - first, rays[i], hits[i]))
                one(selves[i], rays[i], hits[i]);
    }
}
