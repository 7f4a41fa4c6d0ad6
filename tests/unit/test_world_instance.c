/* Rays of shapes in spaces of their own: the filter before them never says a wrong no or yes, for one ray as for many,
 * and every processor's copy gives the same bits. */
#include "support/rays.h"
#include "support/check.h"
#include "support/maps.h"
#include "support/shapes.h"

#include "bvh/build.h"
#include "bvh/traverse.h"
#include "bvh/ray_soa.h"
#include "world/instance.h"

#include <math.h>
#include <string.h>

enum { MAPS = 100000, BATCH = 1000 };

/* ---- a box that is crossed in double-double arithmetic, with its sides ---- */

typedef struct span { pov_two in, out; bool empty; } span;

static void clip_slab(span *s, pov_two o, pov_two d, double lo, double hi)
{
    pov_two a, b;

    if (d.hi == 0.0) {
        s->empty = s->empty || pov_two_less(o, pov_two_of(lo, 0.0)) || pov_two_less(pov_two_of(hi, 0.0), o);
        return;
    }
    a = pov_two_div(pov_two_sub(pov_two_of(d.hi > 0.0 ? lo : hi, 0.0), o), d);
    b = pov_two_div(pov_two_sub(pov_two_of(d.hi > 0.0 ? hi : lo, 0.0), o), d);
    if (pov_two_less(s->in, a))
        s->in = a;
    if (pov_two_less(b, s->out))
        s->out = b;
}

static void intersect_brick(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const pov_box *b = self;
    const pov_mark mark = { 0, 0, 0.0, 0.0 };
    span s = { { -HUGE_VAL, 0.0 }, { HUGE_VAL, 0.0 }, false };

    clip_slab(&s, pov_two_of(ray->org.x, ray->org_lo.x), pov_two_of(ray->dir.x, ray->dir_lo.x), b->lo.x, b->hi.x);
    clip_slab(&s, pov_two_of(ray->org.y, ray->org_lo.y), pov_two_of(ray->dir.y, ray->dir_lo.y), b->lo.y, b->hi.y);
    clip_slab(&s, pov_two_of(ray->org.z, ray->org_lo.z), pov_two_of(ray->dir.z, ray->dir_lo.z), b->lo.z, b->hi.z);
    if (s.empty || pov_two_less(s.out, s.in))
        return;
    if (pov_cross(hits, s.in.hi, s.in.lo, mark))
        pov_cross(hits, s.out.hi, s.out.lo, mark);
}

static const shape_class brick = { .keyword = "brick", .instance_size = sizeof(pov_box),
                                       .flags = POV_SHAPE_BOX, .intersect = intersect_brick };

/* ---- and the sphere in a box, about its point nearest to the centre ---- */

static pov_two3 from_centre(const pov_box *b, const pov_ray *ray)
{
    pov_two3 w;

    w.x = pov_two_add_double(pov_two_of(ray->org.x, ray->org_lo.x), -0.5 * (b->lo.x + b->hi.x));
    w.y = pov_two_add_double(pov_two_of(ray->org.y, ray->org_lo.y), -0.5 * (b->lo.y + b->hi.y));
    w.z = pov_two_add_double(pov_two_of(ray->org.z, ray->org_lo.z), -0.5 * (b->lo.z + b->hi.z));
    return w;
}

static void intersect_orb(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const pov_box *b = self;
    const pov_mark mark = { 0, 0, 0.0, 0.0 };
    const double radius = 0.5 * (b->hi.x - b->lo.x);
    const pov_two3 d = pov_two3_of(ray->dir, ray->dir_lo), f = from_centre(b, ray);
    const pov_two a = pov_two3_dot(d, d), middle = pov_two_neg(pov_two_div(pov_two3_dot(f, d), a));
    pov_two3 w;
    pov_two square, half;

    w.x = pov_two_add(f.x, pov_two_mul(middle, d.x));
    w.y = pov_two_add(f.y, pov_two_mul(middle, d.y));
    w.z = pov_two_add(f.z, pov_two_mul(middle, d.z));
    square = pov_two_sub(pov_two_product(radius, radius), pov_two3_dot(w, w));
    if (!(square.hi >= 0.0))
        return;
    half = pov_two_sqrt(pov_two_div(square, a));
    if (pov_cross(hits, pov_two_sub(middle, half).hi, 0.0, mark))
        pov_cross(hits, pov_two_add(middle, half).hi, 0.0, mark);
}

static const shape_class orb = { .keyword = "orb", .instance_size = sizeof(pov_box),
                                     .flags = POV_SHAPE_SPHERE, .intersect = intersect_orb };

static uint32_t find_hits(const instance_xform *p, const shape_class *shape, const pov_box *own, const pov_ray *ray,
                          double tmax, pov_crossing at[2])
{
    pov_hits hits = hits_to(tmax, POV_WANT_ALL, at, 2);

    hits.always_exact = true;
    instance_intersect(p, shape, own, ray, &hits);
    return hits.count;
}

/* ---- random boxes and rays ---- */

static pov_box random_box(test_random *r)
{
    const double size = test_power(r, -2.0, 2.0);
    const pov_vec3 far = pov_scale(test_direction(r), test_below(r, 2) ? 0.0 : 10.0 * size);
    pov_box b;

    b.lo = pov_sub(far, pov_vec3_of(size, size * test_power(r, -2.0, 2.0), test_below(r, 8) ? size : 0.0));
    b.hi = pov_add(far, pov_vec3_of(size, size * test_power(r, -2.0, 2.0), test_below(r, 8) ? size : 0.0));
    return b;
}

/* Towards an edge of the box, a place on a side of it, or near it. */
static pov_ray random_ray(test_random *r, const pov_affine *map, const pov_box *own)
{
    const double u[3] = { 0.0, 1.0, test_uniform(r, -0.25, 1.25) };
    const double x = u[test_below(r, 3)], y = u[test_below(r, 3)], z = u[test_below(r, 3)];
    const pov_vec3 at = pov_vec3_of(own->lo.x + x * (own->hi.x - own->lo.x), own->lo.y + y * (own->hi.y - own->lo.y),
                                    own->lo.z + z * (own->hi.z - own->lo.z));
    pov_vec3 there, low, dir = test_direction(r);
    pov_ray ray;

    transform_point(map, at, &there, &low);
    if (!test_below(r, 4))
        dir = test_below(r, 2) ? pov_vec3_of(1.0, 0.0, 0.0) : pov_vec3_of(0.0, 0.0, -1.0);
    memset(&ray, 0, sizeof ray);
    ray.dir = pov_scale(dir, test_power(r, -3.0, 3.0));
    ray.org = pov_sub(there, pov_scale(dir, pov_largest(pov_sub(own->hi, own->lo)) * fabs(map->m[0][0]) *
                                                test_power(r, -3.0, 6.0)));
    if (test_below(r, 2) && pov_largest(pov_sub(there, ray.org)) > 0.0)
        ray.dir = pov_scale(pov_sub(there, ray.org), test_power(r, -3.0, 3.0));
    ray.org_lo = pov_scale(ray.org, test_uniform(r, -0x1p-54, 0x1p-54));
    ray.origin_surface = test_below(r, 2) ? POV_NO_OWNER : 0;
    return ray;
}

/* ---- tests ---- */

static bool is_same(const pov_ray *a, const pov_ray *b)
{
    return memcmp(&a->org, &b->org, sizeof a->org) == 0 && memcmp(&a->org_lo, &b->org_lo, sizeof a->org_lo) == 0 &&
           memcmp(&a->dir, &b->dir, sizeof a->dir) == 0 && memcmp(&a->dir_lo, &b->dir_lo, sizeof a->dir_lo) == 0 &&
           a->origin_surface == b->origin_surface &&
               memcmp(&a->origin_mark, &b->origin_mark, sizeof a->origin_mark) == 0;
}

enum { RAYS = 4, SEPARATION = 19 };   /* how many go at a shape, and how many lanes lie between them */
enum { NO_ORIGIN = 1 };          /* an owner that no ray starts on */

enum { MANY = 20 };              /* more than any number of lanes */

/* Side by side as one by one: as many as in packets, which start at points of their own, in groups of eight at one point, or all at
 * one. */
static void check_packet(const instance_xform *p, test_random *r, const pov_affine *map, const pov_box *own_box)
{
    enum { EIGHT = 8 };
    const uint32_t kind = test_below(r, 3), n = 1 + test_below(r, MANY);
    const instance_xform *xforms[MANY];
    const pov_ray *rays[MANY];
    pov_ray sent[MANY], own[MANY], one, *to[MANY];

    for (uint32_t i = 0; i < n; i++) {
        const pov_ray *const first = kind == 2 ? &sent[0] : kind == 1 ? &sent[i / EIGHT * EIGHT] : &sent[i];

        sent[i] = random_ray(r, map, own_box);
        sent[i].org = first->org;
        sent[i].org_lo = first->org_lo;
        xforms[i] = p;
        rays[i] = &sent[i];
        to[i] = &own[i];
    }
    instance_rays(xforms, rays, to, n);
    for (uint32_t i = 0; i < n; i++) {
        instance_ray(p, &sent[i], &one);
        assert_true(is_same(&own[i], &one));
    }
}

/* Starts of rays as points. */
static void check_placed(const instance_xform *p, test_random *r, const pov_affine *map, const pov_box *own_box)
{
    const uint32_t n = 1 + test_below(r, MANY);
    const instance_xform *xforms[MANY];
    pov_vec3 at[MANY], at_lo[MANY], *points[MANY], *points_lo[MANY];
    pov_two3 one[MANY];
    uint32_t i;

    for (i = 0; i < n; i++) {
        const pov_ray ray = random_ray(r, map, own_box);

        one[i] = instance_point(p, ray.org, ray.org_lo);
        xforms[i] = p;
        at[i] = ray.org;
        at_lo[i] = ray.org_lo;
        points[i] = &at[i];
        points_lo[i] = &at_lo[i];
    }
    instance_points(xforms, points, points_lo, n);
    for (i = 0; i < n; i++) {
        const pov_vec3 hi = pov_two3_hi(one[i]), lo = pov_two3_lo(one[i]);

        assert_memory_equal(&at[i], &hi, sizeof hi);
        assert_memory_equal(&at_lo[i], &lo, sizeof lo);
    }
}

/* Normals of shapes, of which some vanish and some are out of the range of squares, turned as one by one. */
static void check_turned(const instance_xform *p, test_random *r, uint32_t n)
{
    const instance_xform *xforms[MANY];
    pov_vec3 many[MANY], one[MANY], *normals[MANY];
    uint32_t i;

    for (i = 0; i < n; i++) {
        const double least = test_below(r, 4) ? -1.0 : test_below(r, 2) ? -300.0 : -500.0;

        xforms[i] = p;
        normals[i] = &many[i];
        many[i] = one[i] = pov_scale(test_direction(r), test_power(r, least, -least));
        instance_world_normal(p, &one[i]);
    }
    instance_world_normals(xforms, normals, n);
    assert_memory_equal(many, one, n * sizeof *many);
}

typedef struct tally { long fits, hits, misses, filtered, sure, definite_pair, diagonal; } tally;

/* False: it passes the frame by. */
static bool put_ray(pov_rays *to, uint32_t i, const bvh_frame *frame, const pov_ray *ray, double tmax)
{
    const pov_ray *const four[4] = { ray, ray, ray, ray };
    double length[POV_RAYS_MAX];
    bvh_local l;

    ray_soa_put_four(to, i, four);
    ray_soa_derive(to, i, tmax, length);
    if (!bvh_enter(frame, ray, length[i], to->per_length[i], &l))
        return false;
    bvh_to_frame(to, i, &l, bvh_limit(l.scale, l.shift, tmax));
    return true;
}

/* Up to 1e4 times as large as what it holds, which is anywhere in it. */
static bvh_frame random_frame(test_random *r, const pov_box *around)
{
    const double most = pov_largest(pov_sub(around->hi, around->lo));
    const double size = most * (test_below(r, 2) ? test_power(r, -1.0, 4.0) : 0.0);
    const pov_vec3 before = pov_vec3_of(test_uniform(r, 0.0, 1.0), test_uniform(r, 0.0, 1.0), 0.5);
    const pov_vec3 behind = pov_vec3_of(test_uniform(r, 0.0, 1.0), test_uniform(r, 0.0, 1.0), 0.5);
    pov_box all;

    all.lo = pov_sub(around->lo, pov_scale(before, size));
    all.hi = pov_add(around->hi, pov_scale(behind, size));
    return bvh_frame_around(&all);
}

static bool is_not_before(double a, double b) { return a >= b - fabs(b) * 0x1p-46; }

/* What is said of one ray, held against the truth; NULL: nothing. */
static void check_candidates(const pov_candidate *said, uint32_t hits, const pov_crossing at[2], tally *t)
{
    assert_true(said || hits == 0);
    t->hits += hits > 0;
    t->misses += hits == 0;
    t->filtered += !said;
    if (!said)
        return;
    assert_true(hits > 0 || !said->definite);
    assert_true(hits == 2 || !said->definite_pair);
    if (hits > 0)
        assert_true(is_not_before(at[0].t, said->lo));
    if (said->definite)
        assert_true(is_not_before(said->hi, at[0].t));
    t->sure += said->definite;
    t->definite_pair += said->definite_pair;
}

/* A sphere under the map is the ellipsoid of these rows, and stands as that does. */
static void check_ellipsoid(const instance_xform *p, const bvh_frame *frame, const instance_filter *filters)
{
    const pov_vec3 *c = p->column;
    const pov_ellipsoid e = { p->anchor, { 0.0, 0.0, 0.0 },
                              { pov_scale(pov_vec3_of(c[0].x, c[1].x, c[2].x), (double)p->per_half[0]),
                                pov_scale(pov_vec3_of(c[0].y, c[1].y, c[2].y), (double)p->per_half[1]),
                                pov_scale(pov_vec3_of(c[0].z, c[1].z, c[2].z), (double)p->per_half[2]) } };
    instance_filter s;

    if (p->known != INSTANCE_IS_SPHERE)
        return;
    assert_true(instance_filter_make_ellipsoid(&e, frame, &s));
    assert_memory_equal(&s, filters, sizeof s);
}

static void check_map(model *m, test_random *r, const shape_class *shape, pov_box own, tally *t)
{
    const pov_candidate *of[RAYS] = { NULL };
    pov_crossing at[RAYS][2];
    pov_candidate candidates[RAYS];
    static pov_rays rays;
    uint32_t hits[RAYS], count, i;
    uint64_t lanes = 0;
    bvh_frame frame;
    pov_box around, tree;
    pov_affine map;
    instance_xform p;
    instance_filter filters;
    bool fits;

    assert_true(transform_compose(test_random_map(m, r), &map));
    instance_box(&map, &own, &around);
    instance_init(&p, &map, &own, &around, shape->flags);
    assert_int_not_equal(p.known, INSTANCE_UNKNOWN);
    tree = around;
    if (shape->flags & POV_SHAPE_SPHERE)
        instance_shrink_box(&map, &own, &tree);
    frame = random_frame(r, &tree);
    fits = instance_filter_make(&p, &frame, &filters);
    t->fits += fits;
    if (fits)
        check_ellipsoid(&p, &frame, &filters);
    for (i = 0; i < RAYS; i++) {
        const pov_ray ray = random_ray(r, &map, &own);
        const double tmax = test_below(r, 2) ? HUGE_VAL : test_power(r, -3.0, 6.0);

        hits[i] = find_hits(&p, shape, &own, &ray, tmax, at[i]);
        if (put_ray(&rays, i * SEPARATION, &frame, &ray, tmax))
            lanes |= (uint64_t)1 << i * SEPARATION;
    }
    check_packet(&p, r, &map, &own);
    check_placed(&p, r, &map, &own);
    t->diagonal += p.axes;
    check_turned(&p, r, 1 + test_below(r, MANY));
    count = fits ? instance_filter_rays(&filters, NO_ORIGIN, &rays, lanes, candidates) : 0;
    for (i = 0; i < count; i++) {
        assert_true((lanes >> candidates[i].ray & 1) && candidates[i].lane == 0 && !of[candidates[i].ray / SEPARATION]);
        of[candidates[i].ray / SEPARATION] = &candidates[i];
    }
    for (i = 0; i < RAYS && fits; i++)
        check_candidates(of[i], hits[i], at[i], t);
}

static tally check_maps(const shape_class *shape, pov_box (*own)(test_random *r))
{
    test_random r = { 17 };
    tally t = { 0, 0, 0, 0, 0, 0, 0 };
    int i, j;

    for (i = 0; i < MAPS; i += BATCH) {
        model m;
        test_model_init(&m, NULL);
        for (j = 0; j < BATCH; j++)
            check_map(&m, &r, shape, own(&r), &t);
        model_free(&m);
    }
    print_message("%s: fits %ld, hits %ld, misses %ld, filtered %ld, sure %ld, twice %ld, diagonal %ld\n", shape->keyword, t.fits,
                  t.hits, t.misses, t.filtered, t.sure, t.definite_pair, t.diagonal);
    assert_true(t.diagonal > MAPS / 50);
    return t;
}

static void the_filter_is_right_of_boxes(void **state)
{
    const tally t = check_maps(&brick, random_box);

    (void)state;
    /* It is of use: many rays of either kind, and most that miss are told, though they aim at edges. */
    assert_true(t.hits > MAPS && t.misses > MAPS / 2);
    assert_true((double)t.filtered > 0.5 * (double)t.misses);
    assert_true(t.sure > MAPS / 10 && t.definite_pair > MAPS / 20);
}

static void the_filter_is_right_of_spheres(void **state)
{
    const tally t = check_maps(&orb, test_random_cube);

    (void)state;
    assert_true(t.hits > MAPS / 10 && t.misses > MAPS / 2);
    assert_true((double)t.filtered > 0.5 * (double)t.misses);
    assert_true(t.sure > MAPS / 20 && t.definite_pair > MAPS / 40);
}

static uint32_t count_candidates(uint32_t flags, uint32_t left, uint32_t mark)
{
    const pov_box own = { { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 } };
    static pov_rays rays;
    bvh_frame frame;
    pov_candidate candidates;
    pov_box around;
    pov_affine map;
    instance_xform p;
    instance_filter s;
    pov_ray ray;
    model m;

    test_model_init(&m, NULL);
    assert_true(transform_compose(test_transform(&m, NULL, TRANSFORM_ROTATE, 10.0, 20.0, 30.0), &map));
    instance_box(&map, &own, &around);
    instance_init(&p, &map, &own, &around, flags);
    frame = bvh_frame_around(&around);
    memset(&ray, 0, sizeof ray);
    ray.dir.z = 1.0;
    ray.origin_surface = left;
    ray.origin_mark.flags = mark;
    assert_true(put_ray(&rays, 5, &frame, &ray, HUGE_VAL));
    model_free(&m);
    assert_true(instance_filter_make(&p, &frame, &s));
    return instance_filter_rays(&s, 7, &rays, 32, &candidates);
}

static void rays_that_go_outward_from_a_box_or_sphere_are_excluded(void **state)
{
    (void)state;
    assert_int_equal(count_candidates(POV_SHAPE_BOX, 7, POV_MARK_OUTWARD), 0);
    assert_int_equal(count_candidates(POV_SHAPE_SPHERE, 7, POV_MARK_OUTWARD), 0);
    assert_int_equal(count_candidates(POV_SHAPE_BOX, 7, 0), 1);
    assert_int_equal(count_candidates(POV_SHAPE_BOX, 8, POV_MARK_OUTWARD), 1);
    /* It may be met again if it is not convex. */
    assert_int_equal(count_candidates(0, 7, POV_MARK_OUTWARD), 1);
}

/* A ray through the middle, which meets the box twice. */
static void check_range(const instance_xform *p, const pov_box *own, const pov_box *around, const pov_ray *ray)
{
    const bvh_frame frame = bvh_frame_around(around);
    static pov_rays rays;
    pov_crossing at[2];
    pov_candidate candidates;
    instance_filter where;

    assert_int_equal(find_hits(p, &brick, own, ray, HUGE_VAL, at), 2);
    if (!instance_filter_make(p, &frame, &where))
        return;
    assert_true(put_ray(&rays, 0, &frame, ray, HUGE_VAL));
    assert_int_equal(instance_filter_rays(&where, NO_ORIGIN, &rays, 1, &candidates), 1);
}

/* Where squares and products would leave the range of double, there is no filter and no wrong answer. */
static void what_is_out_of_range_is_not_filtered(void **state)
{
    static const double sizes[] = { 1e-140, 1e-101, 1e-35, 1e35, 1e101, 1e140 };
    const pov_box own = { { -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 } };
    size_t i;

    (void)state;
    for (i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        pov_box around;
        pov_affine map;
        instance_xform p;
        model m;
        pov_ray ray;

        test_model_init(&m, NULL);
        assert_true(transform_compose(test_transform(&m, NULL, TRANSFORM_SCALE, sizes[i], 2.0 * sizes[i], sizes[i]),
                                      &map));
        instance_box(&map, &own, &around);
        instance_init(&p, &map, &own, &around, POV_SHAPE_SPHERE);
        memset(&ray, 0, sizeof ray);
        ray.org = pov_vec3_of(0.0, 0.0, -5.0 * sizes[i]);
        ray.dir = pov_vec3_of(0.0, 1e-3, 1.0);
        check_range(&p, &own, &around, &ray);
        ray.dir = pov_vec3_of(0.0, 1e-73, 1e-70);
        check_range(&p, &own, &around, &ray);
        instance_init(&p, &map, &own, NULL, POV_SHAPE_SPHERE);
        assert_int_equal(p.known, INSTANCE_UNKNOWN);
        model_free(&m);
    }
}

/* ---- bounds ---- */

static void next_is_nextafter(double x)
{
    const double mine = pov_next(x), theirs = nextafter(x, HUGE_VAL);

    assert_int_equal(memcmp(&mine, &theirs, sizeof mine), 0);
}

static void the_next_double_is_that_of_nextafter(void **state)
{
    const double at[] = { 0.0, 5e-324, 2.2250738585072014e-308, 0x1p-1022, 1.0, 0x1.fffffffffffffp0, 1e300,
                          1.7976931348623157e308, HUGE_VAL };
    size_t i;

    (void)state;
    for (i = 0; i < sizeof at / sizeof at[0]; i++) {
        next_is_nextafter(at[i]);
        next_is_nextafter(-at[i]);
    }
    assert_true(isnan(pov_next(NAN)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_filter_is_right_of_boxes),
        cmocka_unit_test(the_filter_is_right_of_spheres),
        cmocka_unit_test(rays_that_go_outward_from_a_box_or_sphere_are_excluded),
        cmocka_unit_test(what_is_out_of_range_is_not_filtered),
        cmocka_unit_test(the_next_double_is_that_of_nextafter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
