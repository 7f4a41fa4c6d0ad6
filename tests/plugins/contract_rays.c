/* contract_rays.c - what a plugin promises of one ray at one shape, as it is and mapped. */
#include "plugins/contract.h"
#include "plugins/subject.h"

#include "support/check.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* ---- what is promised ---- */

/* But for the rounding of the point that is held against the box. */
static bool lie_within(const void *self, const pov_ray *ray, const pov_crossing *at, uint32_t n)
{
    pov_box box;
    uint32_t i;

    if (!subject.shape->bounds(self, &box))
        return true;
    for (i = 0; i < n; i++) {
        const double slack = 1e-13 * pov_largest(pov_sub(box.hi, box.lo))
                             + DBL_EPSILON * 1e-2 * (pov_largest(box.lo) + pov_largest(box.hi));
        pov_vec3 p, low;

        subject_point(ray, at[i].t, at[i].t_lo, &p, &low);
        if (p.x < box.lo.x - slack || p.y < box.lo.y - slack || p.z < box.lo.z - slack || p.x > box.hi.x + slack
            || p.y > box.hi.y + slack || p.z > box.hi.z + slack)
            return false;
    }
    return true;
}

static bool lies_within(const thing *t, const pov_ray *ray)
{
    pov_crossing at[MOST];
    uint32_t n = subject_ask(t->self, ray, at);

    return lie_within(t->self, ray, at, n);
}

void crossings_lie_within_bounds(void **unused)
{
    (void)unused;
    subject_each_ray(RAYS, lies_within);
}

/* Of the sphere that an ellipsoid's rows make of it. */
static bool lies_on_the_sphere(const pov_ellipsoid *e, const pov_ray *ray, const pov_crossing *at)
{
    pov_vec3 p, low;

    subject_point(ray, at->t, at->t_lo, &p, &low);
    p = pov_add(pov_sub(p, e->centre), pov_sub(low, e->centre_lo));
    p = pov_vec3_of(pov_dot(e->row[0], p), pov_dot(e->row[1], p), pov_dot(e->row[2], p));
    return fabs(subject_length(p) - 1.0) <= 0x1p-20;
}

void an_ellipsoid_is_the_sphere_of_its_rows(void **unused)
{
    int seen = 0, broken = 0, i, j;

    (void)unused;
    if (!HAS(ellipsoid))
        subject_skip("has no ellipsoid");
    for (i = 0; i < subject.count + subject.hard; i++) {
        const thing *t = &subject.things[i];
        pov_ray ray;
        pov_ellipsoid e;

        if (!subject.shape->ellipsoid(t->self, &e))
            continue;
        assert_true(t->finite);
        /* From the middle, as spokes of a lattice go. */
        memset(&ray, 0, sizeof ray);
        ray.org = t->middle;
        ray.origin_surface = POV_NO_OWNER;
        for (j = 0; j < 729; j++) {
            pov_crossing at[MOST];
            uint32_t n;

            ray.dir = pov_vec3_of(j % 9 - 3.9, j / 9 % 9 - 3.8, j / 81 - 4.1);
            for (n = subject_ask(t->self, &ray, at); n > 0; n--, seen++)
                broken += !lies_on_the_sphere(&e, &ray, &at[n - 1]);
        }
    }
    assert_true(seen > 0);
    assert_int_equal(broken, 0);
}

static bool has_unit_normals(const thing *t, const pov_ray *ray)
{
    pov_crossing at[MOST];
    uint32_t n = subject_ask(t->self, ray, at), i;

    for (i = 0; i < n; i++) {
        pov_vec3 normal;

        subject.shape->normal(t->self, ray, &at[i], &normal);
        if (!(fabs(pov_dot(normal, normal) - 1.0) < 8.0 * DBL_EPSILON))
            return false;
    }
    return true;
}

void normals_are_unit(void **unused)
{
    (void)unused;
    subject_each_ray(RAYS, has_unit_normals);
}

static bool is_inside(const thing *t, const pov_ray *ray, double when, double when_lo)
{
    pov_vec3 p, low;

    subject_point(ray, when, when_lo, &p, &low);
    return subject.shape->inside(t->self, p, low);
}

static bool flips(const thing *t, const pov_ray *ray, const pov_crossing *at, double step, double rise)
{
    const bool before = is_inside(t, ray, at->t - step, at->t_lo), after = is_inside(t, ray, at->t + step, at->t_lo);

    return before != after && after == (rise < 0.0);
}

/* Of crossings apart from each other: inside on one side, not on the other, and the normal points to the
 * latter. Open shapes end in air, so there inside() need not flip; but where it does it must do so
 * rightly. */
static bool flips_at_crossings(const thing *t, const pov_ray *ray)
{
    const double speed = subject_length(ray->dir), step = 1e-6 * t->size / speed;
    pov_crossing at[MOST];
    uint32_t n = subject_ask(t->self, ray, at), i;

    for (i = 0; i < n; i++) {
        pov_vec3 normal;
        double rise;

        if ((i > 0 && at[i].t - at[i - 1].t < 8.0 * step) || (i + 1 < n && at[i + 1].t - at[i].t < 8.0 * step))
            continue;
        subject.shape->normal(t->self, ray, &at[i], &normal);
        rise = pov_dot(normal, ray->dir) / speed;
        if (fabs(rise) < 1e-2)
            continue;
        /* Next to the rim of an open one it takes a smaller step. */
        if (!flips(t, ray, &at[i], step, rise) && !flips(t, ray, &at[i], 1e-3 * step, rise))
            return false;
    }
    return true;
}

void inside_flips_where_a_ray_crosses(void **unused)
{
    (void)unused;
    if (subject.shape->flags & POV_SHAPE_SOLID)
        subject_each_ray(RAYS, flips_at_crossings);
    else
        subject_skip("is not a POV_SHAPE_SOLID");
}

/* A bounded solid without gaps: a ray that starts inside crosses it an odd number of times. */
static bool counts_tell(const thing *t, const pov_ray *ray)
{
    pov_crossing at[MOST];

    if (!t->finite || (HAS(open) && subject.shape->open(t->self)))
        return true;
    return (subject_ask(t->self, ray, at) & 1) == subject.shape->inside(t->self, ray->org, ray->org_lo);
}

void crossings_ahead_tell_what_is_inside(void **unused)
{
    (void)unused;
    if (subject.shape->flags & POV_SHAPE_SOLID)
        subject_each_ray(RAYS, counts_tell);
    else
        subject_skip("is not a POV_SHAPE_SOLID");
}

static bool same_crossing(const pov_crossing *a, const pov_crossing *b)
{
    return a->t == b->t && a->t_lo == b->t_lo && a->mark.feature == b->mark.feature;
}

/* In any interval the nearest is the first of all, and ANY finds something exactly when there is
 * something. What double precision decides for one question may be decided in double-double for another, so
 * the distances may differ by that. */
static bool agrees(const thing *t, const pov_ray *ray)
{
    pov_crossing all[MOST], one[MOST];
    const double limit = subject_uniform() < 0.5 ? HUGE_VAL : 3.0 * t->size / subject_length(ray->dir);
    uint32_t n = subject_ask_in(t->self, ray, POV_WANT_ALL, 0.0, limit, false, all);
    uint32_t nearest = subject_ask_in(t->self, ray, POV_WANT_NEAREST, 0.0, limit, false, one);

    if (nearest != (n > 0))
        return false;
    if (n > 0 && fabs(one[0].t - all[0].t) > 32.0 * DBL_EPSILON * fabs(all[0].t))
        return false;
    if (n > 0 && one[0].owner != OWNER)
        return false;
    return subject_ask_in(t->self, ray, POV_WANT_ANY, 0.0, limit, false, one) == nearest;
}

void nearest_is_the_first_of_all_and_any_is_as_nearest(void **unused)
{
    (void)unused;
    subject_each_ray(RAYS, agrees);
}

/* Does the ray meet the shape first where another one was found at `other`? */
static bool is_found_before(const thing *t, const pov_ray *ray, double other, double first)
{
    pov_crossing at = { .t = other, .owner = OWNER + 1 };
    pov_hits hits = { .tmax = other, .want = POV_WANT_NEAREST, .owner = OWNER, .count = 1, .capacity = 1, .at = &at };

    hits.scratch = subject_scratch(t->self);
    subject.shape->intersect(t->self, ray, &hits);
    if (first > other)
        return at.owner == OWNER + 1 && at.t == other;
    return at.owner == OWNER && fabs(at.t - first) <= 32.0 * DBL_EPSILON * fabs(first);
}

/* What was found before, on another shape, only ends the interval. */
static bool another_only_ends_it(const thing *t, const pov_ray *ray)
{
    const double other = 3.0 * t->size * subject_uniform() / subject_length(ray->dir);
    pov_crossing all[MOST];
    const uint32_t n = subject_ask(t->self, ray, all);
    const double first = n > 0 ? all[0].t : HUGE_VAL;

    return fabs(first - other) <= 1e-9 * other || is_found_before(t, ray, other, first);
}

void what_was_found_before_only_ends_the_interval(void **unused)
{
    (void)unused;
    subject_each_ray(RAYS, another_only_ends_it);
}

static pov_vec3 with_zeros(pov_vec3 d, unsigned axes, double zero)
{
    return pov_vec3_of(axes & 1 ? zero : d.x, axes & 2 ? zero : d.y, axes & 4 ? zero : d.z);
}

/* Parallel to an axis, or to a plane of two. */
static bool zeros_have_no_sign(const thing *t, const pov_ray *ray)
{
    for (unsigned axes = 1; axes < 7; axes++) {
        pov_crossing plus[MOST], minus[MOST];
        pov_ray along = *ray;
        uint32_t n;

        along.dir = with_zeros(ray->dir, axes, 0.0);
        along.dir_lo = with_zeros(ray->dir_lo, axes, 0.0);
        if (!(pov_largest(along.dir) > 0.0))
            continue;
        n = subject_ask(t->self, &along, plus);
        along.dir = with_zeros(ray->dir, axes, -0.0);
        along.dir_lo = with_zeros(ray->dir_lo, axes, -0.0);
        if (subject_ask(t->self, &along, minus) != n)
            return false;
        for (uint32_t i = 0; i < n; i++)
            if (plus[i].t != minus[i].t)
                return false;
    }
    return true;
}

void zeros_of_a_direction_have_no_sign(void **unused)
{
    (void)unused;
    subject_each_ray(RAYS / 4, zeros_have_no_sign);
}

static bool agrees_exactly(const thing *t, const pov_ray *ray)
{
    pov_crossing quick[MOST], exact[MOST];
    uint32_t n = subject_ask(t->self, ray, quick), i;

    if (subject_ask_in(t->self, ray, POV_WANT_ALL, 0.0, HUGE_VAL, true, exact) != n)
        return false;
    for (i = 0; i < n; i++) {
        if (fabs(quick[i].t - exact[i].t) > 32.0 * DBL_EPSILON * fabs(exact[i].t))
            return false;
    }
    return true;
}

void always_exact_finds_the_same(void **unused)
{
    (void)unused;
    subject_each_ray(RAYS, agrees_exactly);
}

static uint32_t count_only(const thing *t, const pov_ray *ray, double tmax)
{
    pov_crossing at[MOST];
    pov_hits hits;

    memset(&hits, 0, sizeof hits);
    hits.tmax = tmax;
    hits.want = POV_WANT_ALL;
    hits.count_only = true;
    hits.owner = OWNER;
    hits.capacity = MOST;
    hits.at = at;
    hits.scratch = subject_scratch(t->self);
    subject.shape->intersect(t->self, ray, &hits);
    return hits.count;
}

/* Asked for no more than how many crossings there are, in an interval that ends anywhere; the ray starts anywhere, or on
 * the surface. */
static bool counts_the_same(const thing *t, const pov_ray *ray)
{
    const double scale = t->size / subject_length(ray->dir);
    const double tmax = subject_uniform() < 0.5 ? HUGE_VAL : 20.0 * scale * subject_uniform();
    pov_crossing at[MOST];
    pov_ray next = *ray;
    uint32_t n;

    if (count_only(t, ray, tmax) != subject_ask_in(t->self, ray, POV_WANT_ALL, 0.0, tmax, true, at))
        return false;
    n = subject_ask(t->self, ray, at);
    if (n == 0)
        return true;
    n = (uint32_t)(n * subject_uniform());
    subject_point(ray, at[n].t, at[n].t_lo, &next.org, &next.org_lo);
    next.dir = pov_scale(subject_direction(), subject_length(ray->dir));
    next.origin_surface = OWNER;
    next.origin_mark = at[n].mark;
    n = subject_ask_in(t->self, &next, POV_WANT_ALL, 0.0, tmax, true, at);
    /* Nearer to a rim than starts are exact either is right. */
    return count_only(t, &next, tmax) == n || (n > 0 && at[0].t < 1e-9 * t->thickness / subject_length(ray->dir));
}

void counting_finds_as_many(void **unused)
{
    (void)unused;
    subject_each_ray(RAYS, counts_the_same);
}

static bool copies_agree(const thing *t, const pov_ray *ray)
{
    void *copy = subject_memory();
    pov_crossing a[MOST], b[MOST];
    uint32_t n, i;

    memcpy(copy, t->self, subject.shape->instance_size);
    n = subject_ask(t->self, ray, a);
    if (subject_ask(copy, ray, b) != n)
        return false;
    for (i = 0; i < n; i++) {
        if (!same_crossing(&a[i], &b[i]))
            return false;
    }
    return true;
}

void copies_behave_alike(void **unused)
{
    (void)unused;
    subject_each_ray(RAYS / 4, copies_agree);
}

/* ---- maps ---- */

/* Axial and general ones, with their inverses; exact to a rounding each. */
static pov_affine map_of(int which)
{
    const double turn = 0.7 * which, c = which % 3 ? cos(turn) : 0.0, s = which % 3 ? sin(turn) : 1.0;
    const double scale = which % 2 ? 3.0 : 0.5, x = which > 4 ? 2.0 * scale : scale;
    pov_affine f;

    memset(&f, 0, sizeof f);
    f.m[0][0] = x * c, f.m[0][2] = x * s;
    f.m[1][1] = which == 5 ? -scale : scale;
    f.m[2][0] = -scale * s, f.m[2][2] = scale * c;
    f.m[0][3] = 1.5, f.m[1][3] = -2.25, f.m[2][3] = 10.0 * which;
    f.inv[0][0] = c / x, f.inv[0][2] = -s / scale;
    f.inv[1][1] = 1.0 / f.m[1][1];
    f.inv[2][0] = s / x, f.inv[2][2] = c / scale;
    f.inv[0][3] = -(f.inv[0][0] * f.m[0][3] + f.inv[0][2] * f.m[2][3]);
    f.inv[1][3] = -f.inv[1][1] * f.m[1][3];
    f.inv[2][3] = -(f.inv[2][0] * f.m[0][3] + f.inv[2][2] * f.m[2][3]);
    return f;
}

static pov_vec3 linear(const double m[3][4], pov_vec3 v)
{
    return pov_vec3_of(m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
                       m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z);
}

/* How far along a ray of unit direction the map's own rounding may move a crossing. One far out, of a ray nearly
 * along an asymptote, is where a square term of the ray's equation, that the map leaves a rounding or so wrong,
 * meets one of the first degree: it moves with the square of its distance. */
static double may_move(const thing *t, double size, double reach)
{
    return 1e-6 * size + 64.0 * DBL_EPSILON * reach * (reach / t->size);
}

/* The mapped shape against the ray taken back: the same crossings but for what the map's own rounding
 * moves. */
static bool absorbed_agrees(const thing *t, const void *mapped, const pov_affine *f, const pov_ray *ray)
{
    pov_crossing own[MOST], taken[MOST];
    const double size = t->size + subject_length(pov_sub(ray->org, t->middle));
    pov_ray there = *ray;
    uint32_t n = subject_ask(t->self, ray, own), m, i;

    there.org = pov_affine_point(f, ray->org);
    there.dir = linear(f->m, ray->dir);
    m = subject_ask(mapped, &there, taken);
    if (!lie_within(mapped, &there, taken, m))
        return false;
    if (n != m) {
        /* A graze may fall either way: then two crossings are close, or one ends at an edge. */
        const pov_ray beside = {pov_add(ray->org, pov_scale(subject_direction(), 1e-9 * size)),
                                ray->org_lo,
                                ray->dir,
                                POV_NO_OWNER,
                                ray->origin_mark,
                                ray->dir_lo};
        return subject_ask(t->self, &beside, own) != n || n + m <= 2;
    }
    for (i = 0; i < n; i++) {
        const double speed = subject_length(ray->dir);
        pov_vec3 a, b;

        if (fabs(own[i].t - taken[i].t) * speed > may_move(t, size, fabs(own[i].t) * speed))
            return false;
        subject.shape->normal(t->self, ray, &own[i], &a);
        subject.shape->normal(mapped, &there, &taken[i], &b);
        /* Normals go by the transposed inverse; back again by the transposed map. */
        b = pov_unit(pov_vec3_of(f->m[0][0] * b.x + f->m[1][0] * b.y + f->m[2][0] * b.z,
                                 f->m[0][1] * b.x + f->m[1][1] * b.y + f->m[2][1] * b.z,
                                 f->m[0][2] * b.x + f->m[1][2] * b.y + f->m[2][2] * b.z));
        if (subject_length(pov_sub(a, b)) > 1e-4 && own[i].mark.feature == taken[i].mark.feature)
            return false;
    }
    return true;
}

/* Directions underflow where a ray is mapped into a shape's space. From anywhere within its bounds, that is soon answered. */
void a_ray_without_a_direction_ends(void **unused)
{
    int i, j, broken = 0;

    (void)unused;
    for (i = 0; i < subject.count; i++) {
        for (j = 0; j < 100; j++) {
            pov_ray ray = subject_ray(&subject.things[i]);
            pov_crossing at[MOST];

            ray.org = pov_add(ray.org, pov_scale(ray.dir, pov_dot(pov_sub(subject.things[i].middle, ray.org), ray.dir) /
                                                              pov_dot(ray.dir, ray.dir)));
            ray.dir = pov_vec3_of(0.0, -0.0, 0.0);
            broken += subject_ask(subject.things[i].self, &ray, at) > 0;
        }
    }
    assert_int_equal(broken, 0);
}

void an_absorbed_map_is_as_a_mapped_ray(void **unused)
{
    int i, which, j, taken = 0, broken = 0;

    (void)unused;
    if (!HAS(absorb))
        subject_skip("has no absorb");
    for (i = 0; i < subject.count; i++) {
        const thing *t = &subject.things[i];

        for (which = 0; which < 7; which++) {
            const pov_affine f = map_of(which);
            void *mapped = subject_memory(), *before = subject_memory();

            memcpy(mapped, t->self, subject.shape->instance_size);
            memcpy(before, t->self, subject.shape->instance_size);
            if (!subject.shape->absorb(mapped, &f)) {
                assert_memory_equal(mapped, before, subject.shape->instance_size);
                continue;
            }
            taken++;
            for (j = 0; j < RAYS / 8 && t->size < 1e3 && pov_largest(t->middle) < 1e3 && t->size > 1e-1; j++) {
                const pov_ray ray = subject_ray(t);
                broken += !absorbed_agrees(t, mapped, &f, &ray);
            }
        }
    }
    assert_true(taken > 0);
    assert_int_equal(broken, 0);
}
