/* Rays of shapes in spaces of their own: the filter before them never says a wrong no, and every processor's copy gives
 * the same bits. */
#include "support/check.h"
#include "support/shapes.h"

#include "world/placement.h"

#include <math.h>
#include <string.h>

enum { MAPS = 100000, BATCH = 1000 };

/* ---- a box that is crossed in two-part arithmetic, with its sides ---- */

typedef struct span { pov_two in, out; bool empty; } span;

static void meet_slab(span *s, pov_two o, pov_two d, double lo, double hi)
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

    meet_slab(&s, pov_two_of(ray->org.x, ray->org_lo.x), pov_two_of(ray->dir.x, ray->dir_lo.x), b->lo.x, b->hi.x);
    meet_slab(&s, pov_two_of(ray->org.y, ray->org_lo.y), pov_two_of(ray->dir.y, ray->dir_lo.y), b->lo.y, b->hi.y);
    meet_slab(&s, pov_two_of(ray->org.z, ray->org_lo.z), pov_two_of(ray->dir.z, ray->dir_lo.z), b->lo.z, b->hi.z);
    if (s.empty || pov_two_less(s.out, s.in))
        return;
    if (pov_cross(hits, s.in.hi, s.in.lo, mark))
        pov_cross(hits, s.out.hi, s.out.lo, mark);
}

static const pov_shape_class brick = { .size = sizeof brick, .keyword = "brick", .instance_size = sizeof(pov_box),
                                       .intersect = intersect_brick };

static uint32_t count_hits(const placement *p, const pov_box *own, const pov_ray *ray, double tmax, bool always_exact)
{
    pov_crossing at[2];
    pov_hits hits;

    memset(&hits, 0, sizeof hits);
    hits.tmax = tmax;
    hits.want = POV_WANT_ALL;
    hits.always_exact = always_exact;
    hits.capacity = 2;
    hits.at = at;
    placement_intersect(p, &brick, own, ray, &hits);
    return hits.count;
}

/* ---- random maps, boxes and rays ---- */

static double power(test_random *r, double lo, double hi)
{
    return pow(10.0, test_uniform(r, lo, hi));
}

static double either(test_random *r, double v)
{
    return test_below(r, 2) ? v : -v;
}

/* Scaled by factors that differ by up to 1e9, mirrored, turned, sometimes squeezed again; tiny or large, near or far. */
static const transform *random_map(model *m, test_random *r)
{
    const double size = power(r, -12.0, 12.0), uneven = test_below(r, 3) ? 0.5 : 4.5;
    const transform *map = test_transform(m, NULL, TRANSFORM_SCALE, either(r, size * power(r, -uneven, uneven)),
                                          either(r, size * power(r, -uneven, uneven)),
                                          either(r, size * power(r, -uneven, uneven)));

    if (test_below(r, 4))
        map = test_transform(m, map, TRANSFORM_ROTATE, test_uniform(r, 0.0, 360.0), test_uniform(r, 0.0, 360.0),
                             test_uniform(r, 0.0, 360.0));
    if (!test_below(r, 4))
        map = test_transform(m, map, TRANSFORM_SCALE, power(r, -2.0, 2.0), power(r, -2.0, 2.0), power(r, -2.0, 2.0));
    if (test_below(r, 4)) {
        const double far = size * power(r, -3.0, 9.0);
        const pov_vec3 way = test_direction(r);
        map = test_transform(m, map, TRANSFORM_TRANSLATE, far * way.x, far * way.y, far * way.z);
    }
    return map;
}

static pov_box random_box(test_random *r)
{
    const double size = power(r, -2.0, 2.0);
    const pov_vec3 far = pov_scale(test_direction(r), test_below(r, 2) ? 0.0 : 10.0 * size);
    pov_box b;

    b.lo = pov_sub(far, pov_vec3_of(size, size * power(r, -2.0, 2.0), test_below(r, 8) ? size : 0.0));
    b.hi = pov_add(far, pov_vec3_of(size, size * power(r, -2.0, 2.0), test_below(r, 8) ? size : 0.0));
    return b;
}

/* Towards an edge of the box, a place on a side of it, or near it. */
static pov_ray random_ray(test_random *r, const pov_affine *map, const pov_box *own)
{
    const double u[3] = { 0.0, 1.0, test_uniform(r, -0.25, 1.25) };
    const double x = u[test_below(r, 3)], y = u[test_below(r, 3)], z = u[test_below(r, 3)];
    const pov_vec3 at = pov_vec3_of(own->lo.x + x * (own->hi.x - own->lo.x), own->lo.y + y * (own->hi.y - own->lo.y),
                                    own->lo.z + z * (own->hi.z - own->lo.z));
    pov_vec3 there, low, way = test_direction(r);
    pov_ray ray;

    transform_point(map, at, &there, &low);
    if (!test_below(r, 4))
        way = test_below(r, 2) ? pov_vec3_of(1.0, 0.0, 0.0) : pov_vec3_of(0.0, 0.0, -1.0);
    memset(&ray, 0, sizeof ray);
    ray.dir = pov_scale(way, power(r, -3.0, 3.0));
    ray.org = pov_sub(there, pov_scale(way, pov_largest(pov_sub(own->hi, own->lo)) * fabs(map->m[0][0]) *
                                                power(r, -3.0, 6.0)));
    if (test_below(r, 2))
        ray.dir = pov_scale(pov_sub(there, ray.org), power(r, -3.0, 3.0));
    ray.org_lo = pov_scale(ray.org, test_uniform(r, -0x1p-54, 0x1p-54));
    ray.left = test_below(r, 2) ? POV_NOBODY : 0;
    return ray;
}

/* ---- tests ---- */

static bool is_same(const pov_ray *a, const pov_ray *b)
{
    return memcmp(&a->org, &b->org, sizeof a->org) == 0 && memcmp(&a->org_lo, &b->org_lo, sizeof a->org_lo) == 0 &&
           memcmp(&a->dir, &b->dir, sizeof a->dir) == 0 && memcmp(&a->dir_lo, &b->dir_lo, sizeof a->dir_lo) == 0 &&
           a->left == b->left && memcmp(&a->left_mark, &b->left_mark, sizeof a->left_mark) == 0;
}

static void check_copies(const placement *p, const pov_ray *ray)
{
#if defined(__x86_64__) && defined(__GNUC__)
    pov_ray a, b;

    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
        return;
    placement_portable.own_ray(p, ray, &a);
    placement_avx2.own_ray(p, ray, &b);
    assert_true(is_same(&a, &b));
    assert_true(placement_portable.misses(p, ray, 0.0, HUGE_VAL) == placement_avx2.misses(p, ray, 0.0, HUGE_VAL));
#else
    (void)p;
    (void)ray;
    (void)is_same;
#endif
}

typedef struct tally { long hits, misses, filtered; } tally;

static void check_map(model *m, test_random *r, tally *t)
{
    const pov_box own = random_box(r);
    pov_box around;
    pov_affine map;
    placement p;
    int i;

    assert_true(transform_compose(random_map(m, r), &map));
    placement_box(&map, &own, &around);
    placement_init(&p, &map, &own, &around);
    for (i = 0; i < 4; i++) {
        const pov_ray ray = random_ray(r, &map, &own);
        const double tmax = test_below(r, 2) ? HUGE_VAL : power(r, -3.0, 6.0);
        const uint32_t hits = count_hits(&p, &own, &ray, tmax, true);

        check_copies(&p, &ray);
        assert_int_equal(count_hits(&p, &own, &ray, tmax, false), hits);
        if (hits)
            assert_false(placement_portable.misses(&p, &ray, 0.0, tmax));
        t->hits += hits > 0;
        t->misses += hits == 0;
        t->filtered += placement_portable.misses(&p, &ray, 0.0, tmax);
    }
}

static void the_filter_never_says_a_wrong_no(void **state)
{
    test_random r = { 17 };
    tally t = { 0, 0, 0 };
    int i, j;

    (void)state;
    for (i = 0; i < MAPS; i += BATCH) {
        model m;
        test_model_init(&m, NULL);
        for (j = 0; j < BATCH; j++)
            check_map(&m, &r, &t);
        model_free(&m);
    }
    print_message("hits %ld, misses %ld, filtered %ld\n", t.hits, t.misses, t.filtered);
    /* It is of use: many rays of either kind, and most that miss are told, though they aim at edges. */
    assert_true(t.hits > MAPS && t.misses > MAPS / 2);
    assert_true((double)t.filtered > 0.5 * (double)t.misses);
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
        placement p;
        model m;
        pov_ray ray;

        test_model_init(&m, NULL);
        assert_true(transform_compose(test_transform(&m, NULL, TRANSFORM_SCALE, sizes[i], 2.0 * sizes[i], sizes[i]),
                                      &map));
        placement_box(&map, &own, &around);
        placement_init(&p, &map, &own, &around);
        memset(&ray, 0, sizeof ray);
        ray.org = pov_vec3_of(0.0, 0.0, -5.0 * sizes[i]);
        ray.dir = pov_vec3_of(0.0, 1e-3, 1.0);
        check_copies(&p, &ray);
        assert_int_equal(count_hits(&p, &own, &ray, HUGE_VAL, false), 2);
        ray.dir = pov_vec3_of(0.0, 1e-113, 1e-110);
        check_copies(&p, &ray);
        assert_int_equal(count_hits(&p, &own, &ray, HUGE_VAL, false), 2);
        placement_init(&p, &map, &own, NULL);
        assert_false(placement_portable.misses(&p, &ray, 0.0, 1e-9));
        model_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_filter_never_says_a_wrong_no),
        cmocka_unit_test(what_is_out_of_range_is_not_filtered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
