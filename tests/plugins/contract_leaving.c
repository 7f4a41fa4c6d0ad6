/* contract_leaving.c - what a plugin promises of rays that leave its shape, or go into it and out. */
#include "plugins/contract.h"
#include "plugins/subject.h"

#include "support/check.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { SPAWNED = 120000 };

/* A ray that starts on the surface does not meet its own start: no crossing lies nearer than a chord of
 * that tilt can be. */
static bool leaves_for_good(const thing *t, const pov_ray *ray)
{
    pov_crossing at[MOST], again[MOST];
    uint32_t n = subject_ask(t->self, ray, at), m, i, which = (uint32_t)(n * subject_uniform());
    pov_vec3 normal;
    pov_ray next;
    double tilt;

    if (n == 0)
        return true;
    memset(&next, 0, sizeof next);
    subject.shape->normal(t->self, ray, &at[which], &normal);
    subject_point(ray, at[which].t, at[which].t_lo, &next.org, &next.org_lo);
    next.dir = subject_direction();
    tilt = pov_dot(next.dir, normal);
    if (subject_uniform() < 0.5) {
        const double less = pow(10.0, -4.0 * subject_uniform());

        next.dir = pov_unit(pov_sub(next.dir, pov_scale(normal, tilt * (1.0 - less))));
        tilt = pov_dot(next.dir, normal);
    }
    if (fabs(tilt) < 1e-6)
        return true;
    next.origin_surface = OWNER;
    next.origin_mark = at[which].mark;
    m = subject_ask(t->self, &next, again);
    for (i = 0; i < m; i++) {
        /* At an edge or a rim another part is as near as one likes; the same part is not. */
        if (again[i].t < 1e-9 * t->thickness && again[i].mark.feature == at[which].mark.feature)
            return false;
    }
    return true;
}

void a_ray_that_leaves_never_hits_its_start(void **unused)
{
    (void)unused;
    subject_each_ray(SPAWNED, leaves_for_good);
}

/* The nearest crossing beyond a distance is the next one of all. */
static bool finds_the_next(const thing *t, const pov_ray *ray)
{
    pov_crossing at[MOST], all[MOST], one[MOST];
    const uint32_t n = subject_ask(t->self, ray, at), which = (uint32_t)(n * subject_uniform());
    pov_ray next;
    uint32_t m;

    if (n == 0)
        return true;
    memset(&next, 0, sizeof next);
    subject_point(ray, at[which].t, at[which].t_lo, &next.org, &next.org_lo);
    next.dir = subject_uniform() < 0.3 ? ray->dir : subject_direction();
    next.origin_surface = OWNER;
    next.origin_mark = at[which].mark;
    m = subject_ask(t->self, &next, all);
    for (uint32_t i = 0; i + 1 < m; i++) {
        const double first = all[i].t, second = all[i + 1].t;

        if (second - first > 1e-6 * second &&
            (subject_ask_in(t->self, &next, POV_WANT_NEAREST, 0.5 * (first + second), HUGE_VAL, false, one) != 1 ||
             fabs(one[0].t - second) > 1e-9 * second))
            return false;
    }
    return true;
}

void from_the_surface_the_nearest_beyond_a_distance_is_the_next(void **unused)
{
    (void)unused;
    subject_each_ray(SPAWNED, finds_the_next);
}

/* From each crossing outward, at all angles down to a hundred times what normals may be off by; to either side, where the
 * crossing's mark says so. */
static bool never_comes_back(const thing *t, const pov_ray *ray)
{
    pov_crossing at[MOST], again[MOST];
    uint32_t n = subject_ask(t->self, ray, at), which = (uint32_t)(n * subject_uniform());
    pov_vec3 normal, along;
    pov_ray next;

    if (n == 0)
        return true;
    memset(&next, 0, sizeof next);
    subject.shape->normal(t->self, ray, &at[which], &normal);
    if ((at[which].mark.flags & POV_MARK_OUTWARD) && subject_uniform() < 0.5)
        normal = pov_scale(normal, -1.0);
    subject_point(ray, at[which].t, at[which].t_lo, &next.org, &next.org_lo);
    along = subject_direction();
    along = pov_sub(along, pov_scale(normal, pov_dot(along, normal)));
    next.dir = pov_unit(pov_add(pov_unit(along), pov_scale(normal, pow(10.0, 2.0 - 13.0 * subject_uniform()))));
    if (!(pov_dot(next.dir, normal) > 0x1p-36))
        return true;
    next.origin_surface = OWNER;
    next.origin_mark = at[which].mark;
    return subject_ask(t->self, &next, again) == 0;
}

void a_convex_shape_is_left_for_good(void **unused)
{
    (void)unused;
    if (subject.shape->flags & POV_SHAPE_CONVEX)
        subject_each_ray(SPAWNED, never_comes_back);
    else
        subject_skip("is not a POV_SHAPE_CONVEX");
}

/* A ray that goes into a closed shape from one of these crossings. False: none was found. */
static bool go_in(const thing *t, const pov_ray *ray, const pov_crossing *at, uint32_t n, pov_ray *next)
{
    const uint32_t which = (uint32_t)(n * subject_uniform());
    pov_vec3 normal;

    if (n == 0 || !(at[which].mark.flags & POV_MARK_CLOSED))
        return false;
    memset(next, 0, sizeof *next);
    subject.shape->normal(t->self, ray, &at[which], &normal);
    subject_point(ray, at[which].t, at[which].t_lo, &next->org, &next->org_lo);
    next->dir = subject_direction();
    if (pov_dot(next->dir, normal) > 0.0)
        next->dir = pov_scale(next->dir, -1.0);
    next->origin_surface = OWNER;
    next->origin_mark = at[which].mark;
    next->origin_mark.flags |= POV_MARK_INWARD;
    return pov_dot(next->dir, normal) < -1e-6;
}

/* From each crossing inward: out once, and then no more. */
static bool comes_out_once(const thing *t, const pov_ray *ray)
{
    pov_crossing at[MOST], again[MOST];
    const uint32_t n = subject_ask(t->self, ray, at);
    pov_ray next;

    for (uint32_t i = 1; i < n; i++)
        if ((at[i].mark.flags ^ at[0].mark.flags) & POV_MARK_CLOSED)
            return false;
    if (!go_in(t, ray, at, n, &next))
        return true;
    return subject_ask(t->self, &next, again) == 1 && again[0].mark.flags & POV_MARK_CLOSED;
}

void who_goes_into_a_closed_shape_comes_out_once(void **unused)
{
    (void)unused;
    subject_each_ray(SPAWNED, comes_out_once);
}

/* Rays that went in, and those of them that were not left open. */
static uint32_t gone_in, crossed;

/* Several that go in. */
static bool exits_are_sure(const thing *t, const pov_ray *ray)
{
    const void *selves[MOST];
    const pov_ray *rays[MOST];
    pov_crossing at[MOST], found[MOST], *to[MOST];
    pov_contact contacts[MOST], *where[MOST];
    const uint32_t n = subject_ask(t->self, ray, at);
    pov_ray next[MOST];
    uint32_t count = 0;
    uint64_t open;

    for (uint32_t i = 0; i < 7; i++)
        if (go_in(t, ray, at, n, &next[count])) {
            found[count].owner = OWNER;
            rays[count] = &next[count];
            count++;
        }
    gone_in += count;
    if (count == 0)
        return true;
    for (uint32_t i = 0; i < count; i++) {
        selves[i] = t->self;
        to[i] = &found[i];
        where[i] = &contacts[i];
    }
    open = subject.shape->cross_sure(selves, rays, to, where, count);
    for (uint32_t i = 0; i < count; i++) {
        pov_crossing single;
        pov_hits hits = subject_nearest(HUGE_VAL, &single);

        if (open >> i & 1)
            continue;
        crossed++;
        subject.shape->intersect(t->self, rays[i], &hits);
        if (hits.count != 1 || single.t != found[i].t || single.t_lo != found[i].t_lo ||
            memcmp(&single.mark, &found[i].mark, sizeof single.mark) != 0 || !subject_is_contact(t->self, rays[i], &found[i], &contacts[i]))
            return false;
    }
    return true;
}

void exits_of_closed_shapes_are_sure(void **unused)
{
    (void)unused;
    if (!HAS(cross_sure))
        subject_skip("has no cross_sure");
    gone_in = crossed = 0;
    subject_each_ray(SPAWNED / 8, exits_are_sure);
    assert_true(crossed > 0 || gone_in == 0);
}

static bool normals_need_no_ray(const thing *t, const pov_ray *ray)
{
    pov_crossing at[MOST];
    const uint32_t n = subject_ask(t->self, ray, at);
    pov_vec3 one, other;
    pov_ray none;
    uint32_t i;

    memset(&none, 0, sizeof none);
    for (i = 0; i < n; i++) {
        subject.shape->normal(t->self, ray, &at[i], &one);
        subject.shape->normal(t->self, &none, &at[i], &other);
        if (memcmp(&one, &other, sizeof one) != 0)
            return false;
    }
    return true;
}

void faces_have_the_same_normal_from_everywhere(void **unused)
{
    (void)unused;
    if (subject.shape->flags & POV_SHAPE_FACETED)
        subject_each_ray(RAYS, normals_need_no_ray);
    else
        subject_skip("is not a POV_SHAPE_FACES");
}

static double between(double lo, double hi, double at)
{
    const double rounded = DBL_EPSILON * 8.0 * (fabs(lo) + fabs(hi)), half = 0.5 * (hi - lo) - rounded;

    return 0.5 * (lo + hi) + at * fmax(half, 0.0);
}

/* Points just within the bounds, or the sphere that touches them. */
static bool fills_its_bounds(const thing *t, const pov_ray *ray)
{
    const double edge = 1.0 - 0x1p-40;
    pov_vec3 at = pov_scale(subject_direction(), edge), zero = { 0.0, 0.0, 0.0 };
    pov_box box;

    (void)ray;
    if (subject.shape->flags & POV_SHAPE_BOX)
        at = pov_vec3_of(copysign(edge, at.x), copysign(edge, at.y), copysign(edge, at.z));
    if (!subject.shape->bounds(t->self, &box))
        return false;
    at = pov_vec3_of(between(box.lo.x, box.hi.x, at.x), between(box.lo.y, box.hi.y, at.y),
                     between(box.lo.z, box.hi.z, at.z));
    return subject.shape->inside(t->self, at, zero);
}

/* And none of a sphere is beyond: hosts may look for nothing in the corners of its bounds. */
static bool lies_in_its_sphere(const thing *t, const pov_ray *ray)
{
    pov_crossing at[MOST];
    const double wide = pov_largest(t->box.lo) + pov_largest(t->box.hi);
    const double radius = 0.5 * pov_largest(pov_sub(t->box.hi, t->box.lo)) + wide * 0x1p-48;
    uint32_t n;

    for (n = subject_ask(t->self, ray, at); n > 0; n--) {
        pov_vec3 hi, lo;

        subject_point(ray, at[n - 1].t, at[n - 1].t_lo, &hi, &lo);
        if (!(subject_length(pov_sub(hi, t->middle)) <= radius + 4.0 * DBL_EPSILON * wide))
            return false;
    }
    return true;
}

void a_box_or_sphere_fills_its_bounds(void **unused)
{
    (void)unused;
    if (subject.shape->flags & (POV_SHAPE_BOX | POV_SHAPE_SPHERE))
        subject_each_ray(RAYS, fills_its_bounds);
    else
        subject_skip("is neither a POV_SHAPE_BOX nor a POV_SHAPE_SPHERE");
    if (subject.shape->flags & POV_SHAPE_SPHERE)
        subject_each_ray(RAYS, lies_in_its_sphere);
}
