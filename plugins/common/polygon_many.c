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

static void intersect_lanes(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n,
                            void (*one)(const void *self, const pov_ray *ray, pov_hits *hits))
{
    const void *shapes[TOGETHER];
    polygon_lanes lanes;
    plane_lanes plane;
    uint32_t i;

    common_put_four_of(&lanes.rays, 0, rays, n);
    for (i = 0; i < TOGETHER; i++) {
        shapes[i] = selves[common_lane_of(i, n)];
        lanes.forward[i] = common_forward(rays[common_lane_of(i, n)]->dir);
    }
    common_put_four_shapes(lanes.number[0], TOGETHER, NUMBERS, shapes);
    find_planes(&lanes, &plane);
    for (i = 0; i < n; i++)
        if (!report_plane(&plane, i, rays[i], hits[i]))
            one(selves[i], rays[i], hits[i]);
}

void common_polygon_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                   uint32_t n, void (*one)(const void *self, const pov_ray *ray, pov_hits *hits))
{
    const void *self[TOGETHER];
    const pov_ray *ray[TOGETHER];
    pov_hits *hit[TOGETHER];
    uint32_t i, count = 0;

    for (i = 0; i < n; i++) {
        if (((const common_polygon *)selves[i])->small) {
            self[count] = selves[i];
            ray[count] = rays[i];
            hit[count++] = hits[i];
        } else {
            one(selves[i], rays[i], hits[i]);
        }
        if (count == TOGETHER || (count > 1 && i + 1 == n)) {
            intersect_lanes(self, ray, hit, count, one);
            count = 0;
        }
    }
    if (count)
        one(self[0], ray[0], hit[0]);
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
