/* contract_certified.c - what POV_SHAPE_CERTIFIED says of distances, asked of any class that carries it: a solid's are
 * where inside() changes; any shape's are the same from the ray's other end; those of a flat surface lie in its plane. */
#include "plugins/contract.h"
#include "plugins/subject.h"

#include "support/check.h"

#include <povtrace/exact.h>

#include <math.h>
#include <string.h>

static double ulp_of(double t)
{
    int power;

    frexp(t, &power);
    return ldexp(1.0, power - 53);
}

/* What t + t_lo may be off by. */
static double allowed(const thing *t, const pov_ray *ray, double when)
{
    const double ulps = 32.0 * ulp_of(when), point = 0x1p-42 * t->size / subject_length(ray->dir);

    return t->finite && point < ulps ? point : ulps;
}

/* Half of the rays come from up to 1e12 sizes away: there a distance in one part is coarser than the shape. */
static pov_ray near_or_far(const thing *t)
{
    pov_ray ray = subject_ray(t);

    if (subject_uniform() < 0.5)
        ray.org = pov_sub(ray.org, pov_scale(pov_unit(ray.dir), t->size * pow(10.0, 12.0 * subject_uniform())));
    return ray;
}

static void ask_of_certified(bool asked, const char *why, bool (*visit)(const thing *t, const pov_ray *ray))
{
    if (!(subject.shape->flags & POV_SHAPE_CERTIFIED))
        subject_skip("is not certified");
    if (!asked)
        subject_skip(why);
    subject_each(RAYS, near_or_far, visit);
}

/* ---- solids ---- */

static bool inside_at(const thing *t, const pov_ray *ray, const pov_crossing *at, double off)
{
    const pov_two when = pov_two_add_double(pov_two_of(at->t, at->t_lo), off);
    pov_vec3 p, low;

    subject_point(ray, when.hi, when.lo, &p, &low);
    return subject.shape->inside(t->self, p, low);
}

static bool changes_within(const thing *t, const pov_ray *ray, const pov_crossing *at, double off)
{
    return inside_at(t, ray, at, -off) != inside_at(t, ray, at, off);
}

/* By bisection, how far from a crossing inside() changes; not a number: nowhere about. */
static double change_near(const thing *t, const pov_ray *ray, const pov_crossing *at, double off)
{
    const double most = t->size / subject_length(ray->dir);
    double lo, hi;
    bool before;

    while (off < most && !changes_within(t, ray, at, off))
        off *= 2.0;
    if (!(off < most))
        return NAN;
    before = inside_at(t, ray, at, lo = -off);
    for (hi = off; fabs(hi - lo) > 1e-3 * off;) {
        const double middle = 0.5 * (lo + hi);

        if (inside_at(t, ray, at, middle) == before)
            lo = middle;
        else
            hi = middle;
    }
    return 0.5 * (lo + hi);
}

static bool is_single(const pov_crossing *at, uint32_t n, uint32_t i, double gap)
{
    return (i == 0 || at[i].t - at[i - 1].t > gap) && (i + 1 == n || at[i + 1].t - at[i].t > gap);
}

/* As finely as inside() can be asked along a ray: points in double-double are rounded to 2^-105 of their coordinates,
 * which a ray that grazes the surface takes long to pass. */
static double resolution(const thing *t, const pov_ray *ray, const pov_crossing *at)
{
    pov_vec3 normal;

    subject.shape->normal(t->self, ray, at, &normal);
    return 0x1p-103 * pov_largest(ray->org) / fabs(pov_dot(normal, ray->dir));
}

static bool changes_where_reported(const thing *t, const pov_ray *ray, const pov_crossing *at, uint32_t n)
{
    uint32_t i;

    for (i = 0; i < n; i++) {
        const double most = allowed(t, ray, at[i].t) + resolution(t, ray, &at[i]);

        if (!is_single(at, n, i, 4.0 * most) || changes_within(t, ray, &at[i], most))
            continue;
        subject_sides("%scrossing reported at %.17g + %.3g, inside() changes %.3g after it; %.3g allowed",
                      ray->origin_surface == OWNER ? "a ray that leaves one of its crossings: " : "", at[i].t,
                          at[i].t_lo,
                      change_near(t, ray, &at[i], most), most);
        return false;
    }
    return true;
}

/* To any side from one of the crossings, which is left by its name. */
static pov_ray leaving(const pov_ray *ray, const pov_crossing *at)
{
    pov_ray next = *ray;

    subject_point(ray, at->t, at->t_lo, &next.org, &next.org_lo);
    next.dir = subject_direction();
    next.origin_surface = OWNER;
    next.origin_mark = at->mark;
    return next;
}

static bool changes_at_crossings(const thing *t, const pov_ray *ray)
{
    pov_crossing at[MOST], again[MOST];
    const uint32_t n = subject_ask(t->self, ray, at);
    pov_ray next;

    if (!changes_where_reported(t, ray, at, n))
        return false;
    if (n == 0)
        return true;
    next = leaving(ray, &at[(uint32_t)(n * subject_uniform())]);
    return changes_where_reported(t, &next, again, subject_ask(t->self, &next, again));
}

void a_certified_distance_is_where_inside_changes(void **unused)
{
    (void)unused;
    ask_of_certified(subject.shape->flags & POV_SHAPE_SOLID, "is not solid", changes_at_crossings);
}

/* ---- closed shapes ---- */

/* A point below the surface, by 1e-3 to 1e-20 of the shape's size. */
static void below(const thing *t, const pov_ray *ray, const pov_crossing *at, pov_vec3 *p, pov_vec3 *low)
{
    const double depth = t->size * pow(10.0, -3.0 - 17.0 * subject_uniform());
    pov_ray down = *ray;
    pov_vec3 normal;

    subject.shape->normal(t->self, ray, at, &normal);
    subject_point(ray, at->t, at->t_lo, &down.org, &down.org_lo);
    down.dir = pov_scale(normal, -1.0);
    subject_point(&down, depth, 0.0, p, low);
}

/* A ray along the surface that passes the point at `when`, starting outside or not. */
static pov_ray grazing(pov_vec3 p, pov_vec3 low, pov_vec3 normal, double when)
{
    const pov_vec3 any = subject_direction();
    pov_ray back, ray;

    memset(&back, 0, sizeof back);
    back.org = p;
    back.org_lo = low;
    back.dir = pov_unit(pov_sub(any, pov_scale(normal, pov_dot(any, normal))));
    ray = back;
    ray.dir = pov_scale(back.dir, -1.0);
    subject_point(&back, when, 0.0, &ray.org, &ray.org_lo);
    ray.origin_surface = POV_NO_OWNER;
    return ray;
}

/* A ray through a point inside a closed shape, however near to its surface, goes in before and comes out after. */
static bool hits_what_is_inside(const thing *t, const pov_ray *ray)
{
    const double when = t->size * (2.0 + pow(10.0, 4.0 * subject_uniform()));
    pov_crossing at[MOST], again[MOST];
    pov_vec3 p, low, normal;
    pov_ray next;
    uint32_t n;

    if (subject_ask(t->self, ray, at) == 0 || !(at->mark.flags & POV_MARK_CLOSED))
        return true;
    below(t, ray, at, &p, &low);
    if (!subject.shape->inside(t->self, p, low))
        return true;
    subject.shape->normal(t->self, ray, at, &normal);
    next = grazing(p, low, normal, when);
    n = subject_ask(t->self, &next, again);
    if (n == 2 && again[0].t <= when + 64.0 * ulp_of(when) && again[1].t >= when - 64.0 * ulp_of(when))
        return true;
    subject_sides("<%.17g, %.17g, %.17g> is inside; a ray along <%.17g, %.17g, %.17g> that passes it at %.17g has %u "
                  "crossings, the first at %.17g",
                  p.x, p.y, p.z, next.dir.x, next.dir.y, next.dir.z, when, n, n > 0 ? again[0].t : NAN);
    return false;
}

void a_certified_closed_shape_is_never_missed(void **unused)
{
    (void)unused;
    ask_of_certified(subject.shape->flags & POV_SHAPE_SOLID, "is not solid", hits_what_is_inside);
}

/* ---- any shape ---- */

/* The same line from its point at `when`, backwards. */
static pov_ray reversed(const pov_ray *ray, double when)
{
    pov_ray back = *ray;

    subject_point(ray, when, 0.0, &back.org, &back.org_lo);
    back.dir = pov_scale(ray->dir, -1.0);
    return back;
}

static double sum_of(const pov_crossing *a, const pov_crossing *b, double less)
{
    const pov_two sum = pov_two_add(pov_two_of(a->t, a->t_lo), pov_two_of(b->t, b->t_lo));

    return pov_two_add_double(sum, -less).hi;
}

static bool is_the_same_backwards(const thing *t, const pov_ray *ray)
{
    pov_crossing at[MOST], again[MOST];
    const uint32_t n = subject_ask(t->self, ray, at);
    const double length = n > 0 ? at[n - 1].t + 1.7 * t->size / subject_length(ray->dir) : 0.0;
    const pov_ray back = reversed(ray, length);
    const uint32_t m = n > 0 ? subject_ask_in(t->self, &back, POV_WANT_ALL, 0.0, length, false, again) : 0;

    if (m != n) {
        subject_sides("crossings: %u, backwards: %u", n, m);
        return false;
    }
    for (uint32_t i = 0; i < n; i++) {
        const pov_crossing *other = &again[n - 1 - i];
        const double off = sum_of(&at[i], other, length);
        const double most = allowed(t, ray, at[i].t) + allowed(t, &back, other->t);

        if (fabs(off) <= most)
            continue;
        subject_sides("%.17g + %.3g there and %.17g + %.3g back are %.3g off a way of %.17g; %.3g allowed", at[i].t,
                      at[i].t_lo, other->t, other->t_lo, off, length, most);
        return false;
    }
    return true;
}

void a_certified_distance_is_the_same_from_the_other_side(void **unused)
{
    (void)unused;
    ask_of_certified(true, "", is_the_same_backwards);
}

/* ---- flat surfaces ---- */

static pov_two difference(double a, double a_lo, double b, double b_lo)
{
    return pov_two_add(pov_two_sum(a, -b), pov_two_sum(a_lo, -b_lo));
}

static pov_vec3 way_between(const pov_ray *a, const pov_crossing *at, const pov_ray *b, const pov_crossing *bt)
{
    pov_vec3 p, p_lo, q, q_lo;

    subject_point(a, at->t, at->t_lo, &p, &p_lo);
    subject_point(b, bt->t, bt->t_lo, &q, &q_lo);
    return pov_vec3_of(difference(p.x, p_lo.x, q.x, q_lo.x).hi, difference(p.y, p_lo.y, q.y, q_lo.y).hi,
                       difference(p.z, p_lo.z, q.z, q_lo.z).hi);
}

/* The way from one of its points to another is across the normal, but for what distances may be off by, and for the
 * normal's own rounding. */
static bool lies_in_one_plane(const thing *t, const pov_ray *ray)
{
    const pov_ray other = subject_ray(t);
    pov_crossing at[MOST], there[MOST];
    pov_vec3 normal, way;
    double height, most;

    if (subject_ask(t->self, ray, at) != 1 || subject_ask(t->self, &other, there) != 1
        || at->mark.feature != there->mark.feature)
        return true;
    subject.shape->normal(t->self, ray, at, &normal);
    way = way_between(ray, at, &other, there);
    height = pov_dot(way, normal);
    most = allowed(t, ray, at->t) * fabs(pov_dot(ray->dir, normal))
           + allowed(t, &other, there->t) * fabs(pov_dot(other.dir, normal)) + 0x1p-50 * subject_length(way);
    if (fabs(height) <= most)
        return true;
    subject_sides("crossings at %.17g + %.3g, and at %.17g of another ray, are %.3g off one plane; %.3g allowed", at->t,
                  at->t_lo, there->t, height, most);
    return false;
}

void a_certified_planar_surface_is_planar(void **unused)
{
    const uint32_t flags = subject.shape->flags;

    (void)unused;
    ask_of_certified((flags & POV_SHAPE_FACETED) && !(flags & POV_SHAPE_SOLID), "is not a flat surface",
                     lies_in_one_plane);
}
