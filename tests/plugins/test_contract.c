/* test_contract.c - what every primitive plugin promises, asked of each .so in a folder.
 *
 * test_contract [FOLDER or FILE ...]: by default the build's own plugins, and the one built out of tree. A
 * plugin of a keyword that the table does not know is given random numbers until it takes some, so a new
 * primitive passes, or fails, unchanged. */
#include "plugins/subject.h"

#include "support/check.h"
#include "support/fake_reader.h"

#include <povtrace/exact.h>

#include <dirent.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RAYS = 20000, SPAWNED = 120000 };

static double length_of(pov_vec3 a) { return sqrt(pov_dot(a, a)); }

/* Each of `rays` rays on every instance; `see` gives false where something is wrong. */
static void each_ray(int rays, bool (*see)(const thing *t, const pov_ray *ray))
{
    int i, j, broken = 0;

    for (i = 0; i < subject.count; i++) {
        for (j = 0; j < rays; j++) {
            const pov_ray ray = subject_ray(&subject.things[i]);

            if (see(&subject.things[i], &ray))
                continue;
            if (broken++ < 4)
                print_error("%s, shape %d: from <%a, %a, %a> along <%a, %a, %a>\n", subject.shape->keyword, i,
                            ray.org.x, ray.org.y, ray.org.z, ray.dir.x, ray.dir.y, ray.dir.z);
        }
    }
    assert_int_equal(broken, 0);
}

/* ---- what is promised ---- */

static void the_form_is_kept(void **unused)
{
    const pov_shape_class *s = subject.shape;
    const char *name = strrchr(subject.file, '/');

    (void)unused;
    assert_true(s->size >= offsetof(pov_shape_class, inside));
    assert_non_null(s->keyword);
    assert_true(s->instance_size > 0 && s->parse && s->bounds && s->intersect && s->normal);
    assert_true(!(s->flags & POV_SHAPE_SOLID) || HAS(inside));
    name = name ? name + 1 : subject.file;
    assert_int_equal(strncmp(name, s->keyword, strlen(s->keyword)), 0);
    assert_string_equal(name + strlen(s->keyword), ".so");
    if (HAS(block_pack))
        assert_true(s->block_size > 0 && s->block_filter);
}

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

static void crossings_lie_within_bounds(void **unused)
{
    (void)unused;
    each_ray(RAYS, lies_within);
}

/* Of the ball that an ellipsoid's rows make of it. */
static bool lies_on_the_ball(const pov_ellipsoid *e, const pov_ray *ray, const pov_crossing *at)
{
    pov_vec3 p, low;

    subject_point(ray, at->t, at->t_lo, &p, &low);
    p = pov_add(pov_sub(p, e->centre), pov_sub(low, e->centre_lo));
    p = pov_vec3_of(pov_dot(e->row[0], p), pov_dot(e->row[1], p), pov_dot(e->row[2], p));
    return fabs(length_of(p) - 1.0) <= 0x1p-20;
}

static void an_ellipsoid_is_the_ball_of_its_rows(void **unused)
{
    int seen = 0, broken = 0, i, j;

    (void)unused;
    if (!HAS(ellipsoid))
        skip();
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
        ray.left = POV_NOBODY;
        for (j = 0; j < 729; j++) {
            pov_crossing at[MOST];
            uint32_t n;

            ray.dir = pov_vec3_of(j % 9 - 3.9, j / 9 % 9 - 3.8, j / 81 - 4.1);
            for (n = subject_ask(t->self, &ray, at); n > 0; n--, seen++)
                broken += !lies_on_the_ball(&e, &ray, &at[n - 1]);
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

static void normals_are_unit(void **unused)
{
    (void)unused;
    each_ray(RAYS, has_unit_normals);
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
    const double speed = length_of(ray->dir), step = 1e-6 * t->size / speed;
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

static void inside_flips_where_a_ray_crosses(void **unused)
{
    (void)unused;
    if (subject.shape->flags & POV_SHAPE_SOLID)
        each_ray(RAYS, flips_at_crossings);
    else
        skip();
}

static bool same_crossing(const pov_crossing *a, const pov_crossing *b)
{
    return a->t == b->t && a->t_lo == b->t_lo && a->mark.part == b->mark.part;
}

/* In any interval the nearest is the first of all, and ANY finds something exactly when there is
 * something. What double precision decides for one question may be decided in two parts for another, so
 * the distances may differ by that. */
static bool agrees(const thing *t, const pov_ray *ray)
{
    pov_crossing all[MOST], one[MOST];
    const double limit = subject_uniform() < 0.5 ? HUGE_VAL : 3.0 * t->size / length_of(ray->dir);
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

static void nearest_is_the_first_of_all_and_any_is_as_nearest(void **unused)
{
    (void)unused;
    each_ray(RAYS, agrees);
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

static void always_exact_finds_the_same(void **unused)
{
    (void)unused;
    each_ray(RAYS, agrees_exactly);
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
    subject.shape->intersect(t->self, ray, &hits);
    return hits.count;
}

/* Asked for no more than how many crossings there are, in an interval that ends anywhere; the ray starts anywhere, or on
 * the surface. */
static bool counts_the_same(const thing *t, const pov_ray *ray)
{
    const double scale = t->size / length_of(ray->dir);
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
    next.dir = pov_scale(subject_direction(), length_of(ray->dir));
    next.left = OWNER;
    next.left_mark = at[n].mark;
    n = subject_ask_in(t->self, &next, POV_WANT_ALL, 0.0, tmax, true, at);
    /* Nearer to a rim than starts are exact either is right. */
    return count_only(t, &next, tmax) == n || (n > 0 && at[0].t < 1e-9 * t->thickness / length_of(ray->dir));
}

static void counting_finds_as_many(void **unused)
{
    (void)unused;
    each_ray(RAYS, counts_the_same);
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

static void copies_behave_alike(void **unused)
{
    (void)unused;
    each_ray(RAYS / 4, copies_agree);
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
    const double size = t->size + length_of(pov_sub(ray->org, t->middle));
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
                                POV_NOBODY,
                                ray->left_mark,
                                ray->dir_lo};
        return subject_ask(t->self, &beside, own) != n || n + m <= 2;
    }
    for (i = 0; i < n; i++) {
        const double speed = length_of(ray->dir);
        pov_vec3 a, b;

        if (fabs(own[i].t - taken[i].t) * speed > may_move(t, size, fabs(own[i].t) * speed))
            return false;
        subject.shape->normal(t->self, ray, &own[i], &a);
        subject.shape->normal(mapped, &there, &taken[i], &b);
        /* Normals go by the transposed inverse; back again by the transposed map. */
        b = pov_unit(pov_vec3_of(f->m[0][0] * b.x + f->m[1][0] * b.y + f->m[2][0] * b.z,
                                 f->m[0][1] * b.x + f->m[1][1] * b.y + f->m[2][1] * b.z,
                                 f->m[0][2] * b.x + f->m[1][2] * b.y + f->m[2][2] * b.z));
        if (length_of(pov_sub(a, b)) > 1e-4 && own[i].mark.part == taken[i].mark.part)
            return false;
    }
    return true;
}

static void an_absorbed_map_is_as_a_mapped_ray(void **unused)
{
    int i, which, j, taken = 0, broken = 0;

    (void)unused;
    if (!HAS(absorb))
        skip();
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

/* ---- blocks ---- */

/* What a filter says of one ray and one thing is right; m is NULL where it says nothing. */
static bool is_right(const pov_meeting *m, const thing *t, const pov_ray *ray, double tmax)
{
    pov_crossing at[MOST];
    const uint32_t found = subject_ask_in(t->self, ray, POV_WANT_NEAREST, 0.0, tmax, true, at);

    if (!m)
        return !found;
    if (m->twice && !m->surely)
        return false;
    if (found && at[0].t < m->lo)
        return false;
    if (m->surely && (!found || at[0].t > m->hi))
        return false;
    return !m->twice || subject_ask_in(t->self, ray, POV_WANT_ALL, 0.0, tmax, true, at) == 2;
}

/* Around all of them, as a world's are: half of what is in it is below one. False: they have no box. */
static bool frame_around(const thing *const *things, uint32_t n, pov_frame *out)
{
    pov_vec3 lo, hi;
    pov_box box;
    uint32_t i;
    int e;

    for (i = 0; i < n; i++) {
        if (!subject.shape->bounds(things[i]->self, &box) || !(pov_largest(box.lo) < 1e150 && pov_largest(box.hi) < 1e150))
            return false;
        lo = i > 0 ? pov_vec3_of(fmin(lo.x, box.lo.x), fmin(lo.y, box.lo.y), fmin(lo.z, box.lo.z)) : box.lo;
        hi = i > 0 ? pov_vec3_of(fmax(hi.x, box.hi.x), fmax(hi.y, box.hi.y), fmax(hi.z, box.hi.z)) : box.hi;
    }
    out->centre = pov_add(pov_scale(lo, 0.5), pov_scale(hi, 0.5));
    frexp(fmax(0.5 * pov_largest(pov_sub(hi, lo)), fmax(fmax(pov_largest(lo), pov_largest(hi)) * 0x1p-50, 1e-300)), &e);
    out->scale = ldexp(1.0, -e);
    return true;
}

/* Up to POV_BLOCK_MAX of the subject's things in a block, or one of them as often, and the frame that they are in; its
 * scale is zero where there is none. 0: it declines them. */
static uint32_t pack_some(void *block, const thing **things, pov_frame *frame)
{
    const uint32_t n = 1 + (uint32_t)(POV_BLOCK_MAX * subject_uniform());
    const bool alike = subject_uniform() < 0.4;
    const void *selves[POV_BLOCK_MAX];
    bool framed;
    uint32_t i;

    for (i = 0; i < n; i++) {
        things[i] = alike && i > 0 ? things[0]
                                   : &subject.things[(int)((subject.count + subject.hard) * subject_uniform())];
        selves[i] = things[i]->self;
    }
    framed = frame_around(things, n, frame);
    if (!framed)
        frame->scale = 0.0;
    return subject.shape->block_pack(block, framed ? frame : NULL, selves, n) ? n : 0;
}

/* A ray along the surface of one, or off that by little: from the side of a crossing, across its normal. */
static pov_ray grazing_ray(const thing *t, pov_ray ray)
{
    pov_crossing at[MOST];
    const uint32_t n = subject_ask(t->self, &ray, at);
    pov_vec3 normal, at_point, low;
    double tilt;

    if (n == 0)
        return ray;
    subject.shape->normal(t->self, &ray, &at[0], &normal);
    subject_point(&ray, at[0].t, at[0].t_lo, &at_point, &low);
    tilt = pov_dot(ray.dir, normal) * (1.0 - (subject_uniform() < 0.3 ? 0.0 : pow(10.0, -16.0 * subject_uniform())));
    ray.dir = pov_sub(ray.dir, pov_scale(normal, tilt));
    ray.org = pov_sub(at_point, pov_scale(ray.dir, t->size / length_of(ray.dir) * 100.0 * subject_uniform()));
    ray.org = pov_add(ray.org, pov_scale(normal, t->size * (subject_uniform() < 0.5 ? -1.0 : 1.0)
                                                     * pow(10.0, -17.0 * subject_uniform())));
    return ray;
}

/* One that starts on the surface, in two parts. */
static pov_ray starting_ray(const thing *t, pov_ray ray)
{
    pov_crossing at[MOST];
    const uint32_t n = subject_ask(t->self, &ray, at);
    pov_vec3 point, low;

    if (n > 0) {
        subject_point(&ray, at[0].t, at[0].t_lo, &point, &low);
        ray.org = point;
        ray.org_lo = low;
        ray.dir = subject_direction();
    }
    return ray;
}

/* Low parts of a direction are those that a map leaves. */
static double lower(double d) { return d * 0x1p-54 * (2.0 * subject_uniform() - 1.0); }

/* All that rays can be: far off, along the surface or from it, parallel to axes, with low parts. */
static pov_ray block_ray(const thing *t)
{
    const int family = (int)(8.0 * subject_uniform());
    pov_ray ray = subject_ray(t);

    if (family == 0)
        ray.org = pov_sub(ray.org, pov_scale(ray.dir, t->size / length_of(ray.dir) * pow(10.0, 12.0 * subject_uniform())));
    else if (family == 1)
        ray = grazing_ray(t, ray);
    else if (family == 2)
        ray = starting_ray(t, ray);
    else if (family == 3)
        ray.dir_lo = pov_vec3_of(lower(ray.dir.x), lower(ray.dir.y), lower(ray.dir.z));
    else if (family == 4 && subject_uniform() < 0.5)
        ray.dir = pov_vec3_of(0.0, subject_uniform() < 0.5 ? -0.0 : 0.0, ray.dir.z);
    else if (family == 4)
        ray.dir = pov_vec3_of(ray.dir.x, subject_uniform() < 0.5 ? -0.0 : 1e-250, -0.0);
    else if (family == 5)
        ray.dir = pov_scale(ray.dir, pow(10.0, 200.0 * subject_uniform() - 100.0));
    if (family > 4 && subject_uniform() < 0.1)
        ray.dir.x = 0.0;
    if (family > 4 && subject_uniform() < 0.05)
        ray.dir.y = -0.0;
    return ray;
}

/* Put the ray where filters want it, unless it is out of the range that they are promised. */
static bool put_in_range(pov_rays *rays, uint32_t i, const pov_ray *ray, double tmax)
{
    const double o[3] = { ray->org.x, ray->org.y, ray->org.z }, d[3] = { ray->dir.x, ray->dir.y, ray->dir.z };
    const double low[3] = { ray->org_lo.x, ray->org_lo.y, ray->org_lo.z };
    int k;

    for (k = 0; k < 3; k++) {
        if (!(fabs(o[k]) < 1e99) || (d[k] != 0.0 && !(fabs(d[k]) > 1e-80 && fabs(d[k]) < 1e80)))
            return false;
        rays->org[k][i] = o[k];
        rays->org_lo[k][i] = low[k];
        rays->dir[k][i] = d[k];
    }
    rays->inverse[i] = 1.0 / pov_dot(ray->dir, ray->dir);
    rays->per_length[i] = sqrt(rays->inverse[i]);
    rays->size[i] = fabs(o[0]) + fabs(o[1]) + fabs(o[2]);
    rays->tmax[i] = tmax;
    return pov_largest(ray->dir) > 0.0 && pov_largest(ray->dir_lo) == 0.0;
}

/* And in the frame, from near it. False: its line passes far by, or it goes the other way. */
static bool put_in_frame(pov_rays *rays, uint32_t i, const pov_ray *ray, const pov_frame *f)
{
    const double length = length_of(ray->dir), scale = f->scale * length;
    const pov_vec3 d = pov_scale(ray->dir, 1.0 / length);
    pov_vec3 o = pov_scale(pov_add(pov_sub(ray->org, f->centre), ray->org_lo), f->scale);
    double along = -pov_dot(o, d), shift = 0.0, smax;

    if (!(scale > 1e-280 && scale < 1e280))
        return false;
    if (pov_largest(o) > 8.0) {
        shift = (along - 4.0 - pov_largest(o) * 0x1p-48) / scale;
        if (!(shift > 0.0))
            return false;
        o = pov_scale(pov_vec3_of(pov_recentre(ray->org.x, ray->org_lo.x, f->centre.x, shift, ray->dir.x).hi,
                                  pov_recentre(ray->org.y, ray->org_lo.y, f->centre.y, shift, ray->dir.y).hi,
                                  pov_recentre(ray->org.z, ray->org_lo.z, f->centre.z, shift, ray->dir.z).hi), f->scale);
        if (!(pov_largest(o) <= 8.0))
            return false;
    }
    smax = (rays->tmax[i] - shift) * scale;
    rays->framed.org[0][i] = (float)o.x, rays->framed.org[1][i] = (float)o.y, rays->framed.org[2][i] = (float)o.z;
    rays->framed.dir[0][i] = (float)d.x, rays->framed.dir[1][i] = (float)d.y, rays->framed.dir[2][i] = (float)d.z;
    rays->framed.size[i] = (float)(fabs(o.x) + fabs(o.y) + fabs(o.z) + fabs(shift) * scale * 0x1p-22);
    rays->framed.smax[i] = (float)fmin(smax + fabs(smax) * 0x1p-22 + fabs(shift) * scale * 0x1p-46, 1e38);
    rays->framed.shift[i] = shift;
    rays->framed.unit[i] = 1.0 / scale;
    return true;
}

/* One that passes near the thing as another does, apart from it by parts of the thing's size. */
static pov_ray beside(const thing *t, pov_ray ray, double org, double dir)
{
    const double length = length_of(ray.dir), way = length_of(pov_sub(t->middle, ray.org)) + t->size;
    const pov_vec3 off = pov_scale(subject_direction(), t->size * dir * subject_uniform() / way);

    ray.org = pov_add(ray.org, pov_scale(subject_direction(), t->size * org * subject_uniform()));
    ray.dir = pov_scale(pov_unit(pov_add(pov_scale(ray.dir, 1.0 / length), off)), length);
    return ray;
}

/* From near the start of another to a point of the ball around the thing. */
static pov_ray aimed(const thing *t, pov_ray ray, double org)
{
    const pov_vec3 at = pov_add(t->middle, pov_scale(subject_direction(), 0.5 * t->size));

    ray.org = pov_add(ray.org, pov_scale(subject_direction(), t->size * org * subject_uniform()));
    ray.dir = pov_scale(pov_unit(pov_sub(at, ray.org)), length_of(ray.dir));
    return ray;
}

/* A company, as it comes from a camera or a mirror: one ray and others beside it, or one that goes elsewhere. */
static void company_rays(const thing *t, pov_ray *out)
{
    const bool alike = subject_uniform() < 0.3;
    const double org = subject_uniform() < 0.5 ? 0.0 : pow(10.0, -8.0 * subject_uniform());
    const double dir = alike ? 0.0 : pow(10.0, 1.0 - 8.0 * subject_uniform());
    const pov_ray one = block_ray(t), past = beside(t, one, 0.0, 4.0);
    const bool some = subject_uniform() < 0.5;
    uint32_t i;

    for (i = 0; i < POV_RAYS_MAX; i++)
        out[i] = some ? beside(t, one, org, dir) : past;
    if (!some)
        out[(uint32_t)(POV_RAYS_MAX * subject_uniform())] = aimed(t, past, org);
}

static void block_rays(const thing *const *things, uint32_t n, pov_ray *out)
{
    uint32_t i;

    if (subject_uniform() < 0.6) {
        company_rays(things[(uint32_t)(n * subject_uniform())], out);
        return;
    }
    for (i = 0; i < POV_RAYS_MAX; i++)
        out[i] = block_ray(things[(uint32_t)(n * subject_uniform())]);
}

/* A ray that nothing is known of, as a world says it. */
static void put_blind(pov_rays *rays, uint32_t i)
{
    int k;

    for (k = 0; k < 3; k++) {
        rays->framed.org[k][i] = 0.0f;
        rays->framed.dir[k][i] = 1.0f;
    }
    rays->framed.size[i] = rays->framed.smax[i] = HUGE_VALF;
    rays->framed.shift[i] = 0.0;
    rays->framed.unit[i] = 1.0;
}

/* What stands in a lane that nobody asks for: anything. */
static void put_nothing(pov_rays *rays, uint32_t i)
{
    int k;

    for (k = 0; k < 3; k++) {
        rays->framed.org[k][i] = NAN;
        rays->framed.dir[k][i] = subject_uniform() < 0.5 ? NAN : HUGE_VALF;
    }
    rays->framed.size[i] = subject_uniform() < 0.5 ? NAN : HUGE_VALF;
}

/* Which of the rays are where filters want them. */
static uint64_t put_rays(pov_rays *rays, const pov_ray *ray, const pov_frame *frame, const thing *const *things, uint32_t n)
{
    const double asked = subject_uniform() < 0.5 ? 0.95 : 0.6, blind = subject_uniform() < 0.2 ? 0.05 : 0.0;
    uint64_t lanes = 0;
    uint32_t i;

    for (i = 0; i < POV_RAYS_MAX; i++) {
        const double scale = things[(uint32_t)(n * subject_uniform())]->size / length_of(ray[i].dir);
        const double tmax = subject_uniform() < 0.5 ? HUGE_VAL : 20.0 * scale * subject_uniform();

        if (subject_uniform() < asked && put_in_range(rays, i, &ray[i], tmax)
            && (frame->scale == 0.0 || put_in_frame(rays, i, &ray[i], frame)))
            lanes |= (uint64_t)1 << i;
        else
            put_nothing(rays, i);
        if (subject_uniform() < blind)
            put_blind(rays, i);
    }
    return lanes;
}

/* Rays at some things; how many of the answers are wrong. */
static int wrong_answers(const void *block, const pov_frame *frame, const thing *const *things, uint32_t n, int *seen)
{
    static pov_rays rays;
    static pov_ray ray[POV_RAYS_MAX];
    static pov_meeting met[POV_MEETINGS_MAX];
    static const uint32_t owners[POV_BLOCK_MAX] = { 11, 12, 13, 14, 15, 16, 17, 18 };
    const bool convex = subject.shape->flags & POV_SHAPE_CONVEX;
    const pov_meeting *of[POV_RAYS_MAX][POV_BLOCK_MAX];
    uint64_t lanes;
    uint32_t count, i, k;
    int broken = 0;

    block_rays(things, n, ray);
    lanes = put_rays(&rays, ray, frame, things, n);
    for (i = 0; i < POV_RAYS_MAX; i++)
        rays.away[i] = subject_uniform() < 0.3 ? owners[(uint32_t)(n * subject_uniform())] : POV_NOBODY;
    /* Now and then one alone. */
    if (subject_uniform() < 0.3)
        lanes &= ~(lanes - 1);
    if (!lanes)
        return 0;
    memset(of, 0, sizeof of);
    count = subject.shape->block_filter(block, owners, &rays, lanes, met);
    for (i = 0; i < count; i++) {
        if (met[i].ray >= POV_RAYS_MAX || !(lanes >> met[i].ray & 1) || met[i].lane >= n || of[met[i].ray][met[i].lane])
            return 1;
        of[met[i].ray][met[i].lane] = &met[i];
        *seen += met[i].surely;
    }
    for (i = 0; i < POV_RAYS_MAX; i++)
        for (k = 0; (lanes >> i & 1) && k < n; k++)
            if ((of[i][k] || !convex || rays.away[i] != owners[k])
                && !is_right(of[i][k], things[k], &ray[i], rays.tmax[i]) && broken++ < 2)
                print_error("%s: from <%a, %a, %a> along <%a, %a, %a> to %a\n", subject.shape->keyword, ray[i].org.x,
                            ray[i].org.y, ray[i].org.z, ray[i].dir.x, ray[i].dir.y, ray[i].dir.z, rays.tmax[i]);
    return broken;
}

static void block_filters_never_exclude_a_crossing(void **unused)
{
    void *block;
    int round, broken = 0, packed = 0, seen = 0;

    (void)unused;
    if (!HAS(block_pack))
        skip();
    block = fake_reader_memory(subject.in, subject.shape->block_size);
    for (round = 0; round < 6000; round++) {
        const thing *things[POV_BLOCK_MAX];
        pov_frame frame;
        const uint32_t n = pack_some(block, things, &frame);

        if (n == 0)
            continue;
        packed++;
        broken += wrong_answers(block, &frame, things, n, &seen);
    }
    assert_true(packed > 0);
    assert_int_equal(broken, 0);
    /* A filter that is never sure is of no use. */
    assert_true(seen > 0);
}

/* ---- many at once ---- */

enum { COMPANY = 37 };

/* To which side a ray goes from the crossing that it starts on, where that is no matter of rounding. */
static void name_side(const thing *t, pov_ray *ray, const pov_crossing *from)
{
    pov_vec3 normal;
    double rise;

    subject.shape->normal(t->self, ray, from, &normal);
    rise = pov_dot(normal, pov_unit(ray->dir));
    if (fabs(rise) > 1e-6)
        ray->left_mark.flags |= rise > 0.0 ? POV_MARK_AWAY : POV_MARK_INTO;
}

/* Rays of all kinds: from far and near, from the surface itself, with zeros of both signs, absurdly large and small. */
static pov_ray any_ray(const thing *t)
{
    const double luck = subject_uniform();
    pov_ray ray = subject_ray(t);
    pov_crossing at[MOST];
    const uint32_t n = subject_ask(t->self, &ray, at);

    if (n > 0 && luck < 0.4) {
        const uint32_t which = (uint32_t)(n * subject_uniform());

        subject_point(&ray, at[which].t, at[which].t_lo, &ray.org, &ray.org_lo);
        ray.dir = subject_direction();
        ray.left = OWNER;
        ray.left_mark = at[which].mark;
        if (luck < 0.3)
            name_side(t, &ray, &at[which]);
    } else if (luck < 0.5) {
        ray.dir.x = luck < 0.45 ? 0.0 : -0.0;
    } else if (luck < 0.6) {
        ray.dir = pov_scale(ray.dir, luck < 0.53 ? 1e-280 : luck < 0.56 ? 1e250 : 5e-324);
    } else if (luck < 0.65) {
        ray.org = pov_scale(ray.org, luck < 0.63 ? 1e180 : 1e-300);
    }
    return ray;
}

static pov_hits any_question(const thing *t, const pov_ray *ray, pov_crossing *at)
{
    const double scale = t->size / fmax(pov_largest(ray->dir), 1e-300);
    pov_hits hits;

    memset(&hits, 0, sizeof hits);
    hits.want = subject_uniform() < 0.2 ? POV_WANT_ANY : POV_WANT_NEAREST;
    hits.tmin = subject_uniform() < 0.8 ? 0.0 : scale * subject_uniform();
    hits.tmax = subject_uniform() < 0.5 ? HUGE_VAL : hits.tmin + 20.0 * scale * subject_uniform();
    hits.always_exact = subject_uniform() < 0.02;
    hits.owner = OWNER;
    hits.capacity = 1;
    hits.at = at;
    memset(at, 0, sizeof *at);
    return hits;
}

static bool same_answer(const pov_hits *a, const pov_hits *b)
{
    return a->count == b->count && a->decided == b->decided && a->crowded == b->crowded
           && memcmp(&a->tmax, &b->tmax, sizeof a->tmax) == 0
           && (a->count == 0 || memcmp(a->at, b->at, sizeof *a->at) == 0);
}

/* Pairs of a thing and a ray, their questions, and what is there. */
typedef struct company {
    const void *selves[COMPANY];
    const pov_ray *rays[COMPANY];
    pov_ray ray[COMPANY];
    pov_hits hits[2][COMPANY];
    pov_crossing at[2][COMPANY];
} company;

static void gather(company *c, uint32_t n)
{
    uint32_t i;

    for (i = 0; i < n; i++) {
        const thing *t = &subject.things[(int)(subject.count * subject_uniform())];

        c->selves[i] = t->self;
        c->ray[i] = any_ray(t);
        c->rays[i] = &c->ray[i];
        c->hits[0][i] = c->hits[1][i] = any_question(t, &c->ray[i], &c->at[0][i]);
        c->hits[1][i].at = &c->at[1][i];
        c->at[1][i] = c->at[0][i];
        subject.shape->intersect(t->self, &c->ray[i], &c->hits[0][i]);
    }
}

static void many_rays_get_the_answers_of_single_ones(void **unused)
{
    static company c;
    int round, broken = 0;

    (void)unused;
    if (!HAS(intersect_many))
        skip();
    for (round = 0; round < 3000; round++) {
        const uint32_t n = 1 + (uint32_t)(COMPANY * subject_uniform());
        pov_hits *hits[COMPANY];
        uint32_t i;

        gather(&c, n);
        for (i = 0; i < n; i++)
            hits[i] = &c.hits[1][i];
        subject.shape->intersect_many(c.selves, c.rays, hits, n);
        for (i = 0; i < n; i++)
            broken += !same_answer(&c.hits[0][i], &c.hits[1][i]);
    }
    assert_int_equal(broken, 0);
}

static void many_normals_are_those_of_single_ones(void **unused)
{
    static company c;
    int round, broken = 0, seen = 0;

    (void)unused;
    if (!HAS(normal_many))
        skip();
    for (round = 0; round < 3000; round++) {
        const pov_crossing *at[COMPANY];
        pov_vec3 normal[COMPANY], *out[COMPANY];
        uint32_t i, n = 0;

        gather(&c, COMPANY);
        for (i = 0; i < COMPANY; i++) {
            if (c.hits[0][i].count == 0)
                continue;
            c.selves[n] = c.selves[i];
            c.rays[n] = c.rays[i];
            at[n] = &c.at[0][i];
            out[n] = &normal[n];
            n++;
        }
        if (n == 0)
            continue;
        seen += (int)n;
        subject.shape->normal_many(c.selves, c.rays, at, out, n);
        for (i = 0; i < n; i++) {
            pov_vec3 one;

            subject.shape->normal(c.selves[i], c.rays[i], at[i], &one);
            broken += memcmp(&one, &normal[i], sizeof one) != 0;
        }
    }
    assert_true(seen > 1000);
    assert_int_equal(broken, 0);
}

/* ---- leaving ---- */

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
    next.left = OWNER;
    next.left_mark = at[which].mark;
    m = subject_ask(t->self, &next, again);
    for (i = 0; i < m; i++) {
        /* At an edge or a rim another part is as near as one likes; the same part is not. */
        if (again[i].t < 1e-9 * t->thickness && again[i].mark.part == at[which].mark.part)
            return false;
    }
    return true;
}

static void a_ray_that_leaves_never_meets_its_start(void **unused)
{
    (void)unused;
    each_ray(SPAWNED, leaves_for_good);
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
    if ((at[which].mark.flags & POV_MARK_AWAY) && subject_uniform() < 0.5)
        normal = pov_scale(normal, -1.0);
    subject_point(ray, at[which].t, at[which].t_lo, &next.org, &next.org_lo);
    along = subject_direction();
    along = pov_sub(along, pov_scale(normal, pov_dot(along, normal)));
    next.dir = pov_unit(pov_add(pov_unit(along), pov_scale(normal, pow(10.0, 2.0 - 13.0 * subject_uniform()))));
    if (!(pov_dot(next.dir, normal) > 0x1p-36))
        return true;
    next.left = OWNER;
    next.left_mark = at[which].mark;
    return subject_ask(t->self, &next, again) == 0;
}

static void a_convex_shape_is_left_for_good(void **unused)
{
    (void)unused;
    if (subject.shape->flags & POV_SHAPE_CONVEX)
        each_ray(SPAWNED, never_comes_back);
    else
        skip();
}

/* From each crossing inward: out once, and then no more. */
static bool comes_out_once(const thing *t, const pov_ray *ray)
{
    pov_crossing at[MOST], again[MOST];
    uint32_t n = subject_ask(t->self, ray, at), i, which = (uint32_t)(n * subject_uniform());
    pov_vec3 normal;
    pov_ray next;

    for (i = 1; i < n; i++)
        if ((at[i].mark.flags ^ at[0].mark.flags) & POV_MARK_CLOSED)
            return false;
    if (n == 0 || !(at[0].mark.flags & POV_MARK_CLOSED))
        return true;
    memset(&next, 0, sizeof next);
    subject.shape->normal(t->self, ray, &at[which], &normal);
    subject_point(ray, at[which].t, at[which].t_lo, &next.org, &next.org_lo);
    next.dir = subject_direction();
    if (pov_dot(next.dir, normal) > 0.0)
        next.dir = pov_scale(next.dir, -1.0);
    if (!(pov_dot(next.dir, normal) < -1e-6))
        return true;
    next.left = OWNER;
    next.left_mark = at[which].mark;
    next.left_mark.flags |= POV_MARK_INTO;
    return subject_ask(t->self, &next, again) == 1 && again[0].mark.flags & POV_MARK_CLOSED;
}

static void who_goes_into_a_closed_shape_comes_out_once(void **unused)
{
    (void)unused;
    each_ray(SPAWNED, comes_out_once);
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

static void faces_have_the_same_normal_from_everywhere(void **unused)
{
    (void)unused;
    if (subject.shape->flags & POV_SHAPE_FACES)
        each_ray(RAYS, normals_need_no_ray);
    else
        skip();
}

static double between(double lo, double hi, double at)
{
    const double rounded = DBL_EPSILON * 8.0 * (fabs(lo) + fabs(hi)), half = 0.5 * (hi - lo) - rounded;

    return 0.5 * (lo + hi) + at * fmax(half, 0.0);
}

/* Points just within the bounds, or the ball that touches them. */
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

static void a_box_or_ball_fills_its_bounds(void **unused)
{
    (void)unused;
    if (subject.shape->flags & (POV_SHAPE_BOX | POV_SHAPE_BALL))
        each_ray(RAYS, fills_its_bounds);
    else
        skip();
}

/* ---- garbage ---- */

static void garbage_never_crashes_parse(void **unused)
{
    static const char *const words[] = { "<", ">", ",", "open", "{", "}", "pigment", "-", "nan", "\"" };
    static const double odd[] = {0.0, -0.0, 1e308, -1e308,   5e-324,    1e-320, -1.0,
                                 3.0, 4.0,  1e9,   HUGE_VAL, -HUGE_VAL, NAN};
    void *self = subject_memory();
    int round, i;

    (void)unused;
    for (round = 0; round < 20000; round++) {
        const int n = (int)(24.0 * subject_uniform());
        pov_crossing at[MOST];
        pov_box box;

        fake_reader_clear(subject.in);
        for (i = 0; i < n; i++) {
            if (subject_uniform() < 0.4)
                fake_reader_word(subject.in, words[(int)(10.0 * subject_uniform())]);
            else
                fake_reader_number(subject.in, subject_uniform() < 0.5 ? odd[(int)(13.0 * subject_uniform())]
                                                                       : 8.0 * subject_uniform() - 4.0);
        }
        /* What it takes, it must also survive being asked. */
        if (fake_reader_parse_into(subject.in, subject.shape, self)) {
            const pov_ray ray = subject_ray(&subject.things[0]);

            subject.shape->bounds(self, &box);
            subject_ask(self, &ray, at);
            if (HAS(inside))
                subject.shape->inside(self, ray.org, ray.org_lo);
        }
    }
}

/* ---- folders ---- */

static int check_file(const char *file)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_form_is_kept),
        cmocka_unit_test(crossings_lie_within_bounds),
        cmocka_unit_test(an_ellipsoid_is_the_ball_of_its_rows),
        cmocka_unit_test(normals_are_unit),
        cmocka_unit_test(inside_flips_where_a_ray_crosses),
        cmocka_unit_test(nearest_is_the_first_of_all_and_any_is_as_nearest),
        cmocka_unit_test(always_exact_finds_the_same),
        cmocka_unit_test(counting_finds_as_many),
        cmocka_unit_test(copies_behave_alike),
        cmocka_unit_test(an_absorbed_map_is_as_a_mapped_ray),
        cmocka_unit_test(block_filters_never_exclude_a_crossing),
        cmocka_unit_test(many_rays_get_the_answers_of_single_ones),
        cmocka_unit_test(many_normals_are_those_of_single_ones),
        cmocka_unit_test(a_ray_that_leaves_never_meets_its_start),
        cmocka_unit_test(a_box_or_ball_fills_its_bounds),
        cmocka_unit_test(a_convex_shape_is_left_for_good),
        cmocka_unit_test(who_goes_into_a_closed_shape_comes_out_once),
        cmocka_unit_test(faces_have_the_same_normal_from_everywhere),
        cmocka_unit_test(garbage_never_crashes_parse),
    };
    int failed;

    if (!subject_set_up(file)) {
        print_error("%s: no shape could be made\n", file);
        return 1;
    }
    failed = cmocka_run_group_tests_name(subject.shape->keyword, tests, NULL, NULL);
    fake_reader_destroy(subject.in);
    return failed;
}

static bool is_plugin(const char *name)
{
    const size_t n = strlen(name);
    return n > 3 && strcmp(name + n - 3, ".so") == 0;
}

static int order(const void *a, const void *b) { return strcmp(a, b); }

static int check_folder(const char *folder)
{
    static char files[256][1024];
    DIR *d = opendir(folder);
    const struct dirent *entry;
    int count = 0, failed = 0, i;

    if (!d)
        return check_file(folder);
    while (count < 256 && (entry = readdir(d)) != NULL) {
        if (is_plugin(entry->d_name))
            snprintf(files[count++], sizeof files[0], "%s/%s", folder, entry->d_name);
    }
    closedir(d);
    qsort(files, (size_t)count, sizeof files[0], order);
    for (i = 0; i < count; i++)
        failed += check_file(files[i]);
    return count == 0 || failed;
}

int main(int argc, char **argv)
{
    int i, failed = 0;

    if (argc < 2)
        return check_folder(TEST_BUILD "/lib/povtrace/primitives")
               + check_folder(TEST_BUILD "/tests/plugins/out_of_tree");
    for (i = 1; i < argc; i++)
        failed += check_folder(argv[i]);
    return failed != 0;
}
