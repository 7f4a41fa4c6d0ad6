/* The hierarchy that plugins get: no part that a ray meets is left out, few others are seen, and it ends when told. */
#include "support/check.h"
#include "support/failing.h"
#include "support/shapes.h"

#include "base/simd.h"
#include "bvh/hierarchy.h"

#include <stdlib.h>
#include <string.h>

enum { PARTS = 700, RAYS = 3000 };

typedef struct fixture { pov_box boxes[PARTS]; hierarchy *made; uint32_t count, order[PARTS]; bool in_order; } fixture;

static env libc_env(void)
{
    env e;

    env_init(&e, NULL, NULL, NULL);
    return e;
}

static double uniform(test_random *r) { return test_uniform(r, 0.0, 1.0); }

static pov_vec3 within(test_random *r, double size)
{
    return pov_vec3_of(size * (2.0 * uniform(r) - 1.0), size * (2.0 * uniform(r) - 1.0), size * (2.0 * uniform(r) - 1.0));
}

static void box_at(void *user, uint32_t item, pov_box *out) { *out = ((const pov_box *)user)[item]; }

/* Parts of sizes from 1 to 1e-6, the smallest of them crowded. */
static void make(fixture *f, const env *e, test_random *r, uint32_t count)
{
    uint32_t i;

    f->count = count;
    for (i = 0; i < count; i++) {
        const double size = pow(10.0, -6.0 * (i % 7) / 6.0);
        const pov_vec3 at = within(r, 4.0 * size), half = pov_scale(pov_vec3_of(uniform(r), uniform(r), uniform(r)), 0.2 * size);

        f->boxes[i].lo = pov_sub(at, half);
        f->boxes[i].hi = pov_add(at, half);
    }
    f->made = hierarchy_create(e, &(const hierarchy_items){ count, box_at, f->boxes, f->in_order ? f->order : NULL, 1 });
    assert_non_null(f->made);
}

static pov_ray ray_from(pov_vec3 org, pov_vec3 dir)
{
    const pov_ray ray = { .org = org, .dir = dir, .origin_surface = POV_NO_OWNER };

    return ray;
}

/* In long doubles, which is finer than what is asked. */
static bool meets(const pov_box *b, const pov_ray *ray, double tmax)
{
    const double o[3] = { ray->org.x, ray->org.y, ray->org.z }, d[3] = { ray->dir.x, ray->dir.y, ray->dir.z };
    const double lo[3] = { b->lo.x, b->lo.y, b->lo.z }, hi[3] = { b->hi.x, b->hi.y, b->hi.z };
    long double from = 0.0L, to = tmax;

    for (int k = 0; k < 3; k++) {
        const long double a = ((long double)lo[k] - o[k]) / d[k], c = ((long double)hi[k] - o[k]) / d[k];

        from = fmaxl(from, fminl(a, c));
        to = fminl(to, fmaxl(a, c));
    }
    return from <= to;
}

typedef struct seen { uint8_t item[PARTS]; uint32_t count, most; pov_hits *hits; double closes_to; } seen;

static bool visit_item(void *user, uint32_t item)
{
    seen *s = user;

    assert_int_equal(s->item[item], 0);
    s->item[item] = 1;
    if (s->hits && s->closes_to < s->hits->tmax)
        s->hits->tmax = s->closes_to;
    return ++s->count < s->most;
}

static pov_ray some_ray(test_random *r)
{
    const pov_vec3 to = within(r, uniform(r) < 0.5 ? 4.0 : 1e-5), org = within(r, pow(10.0, 6.0 * uniform(r)));

    return ray_from(org, pov_scale(pov_sub(to, org), pow(10.0, 20.0 * uniform(r) - 10.0)));
}

static void no_part_that_a_ray_meets_is_left_out(void **state)
{
    static const uint32_t counts[] = { 1, 2, 9, PARTS };
    env e = libc_env();
    test_random r = { 7 };
    double all = 0.0, visited = 0.0;

    (void)state;
    for (size_t c = 0; c < sizeof counts / sizeof counts[0]; c++) {
        fixture f = { .in_order = false };

        make(&f, &e, &r, counts[c]);
        for (int i = 0; i < RAYS; i++) {
            const pov_hierarchy *h = hierarchy_service(f.made);
            pov_ray ray = some_ray(&r);
            pov_hits hits = { .tmax = uniform(&r) < 0.5 ? HUGE_VAL : 2.0 / pov_largest(ray.dir) };
            seen s = { .most = PARTS + 1 };

            assert_true(h->visit(h, &ray, &hits, visit_item, &s));
            for (uint32_t k = 0; k < f.count; k++)
                assert_true(s.item[k] || !meets(&f.boxes[k], &ray, hits.tmax));
            all += f.count;
            visited += s.count;
        }
        hierarchy_destroy(f.made);
    }
    assert_true(visited < 0.2 * all);
}

static bool visit_range(void *user, uint32_t first, uint32_t count)
{
    bool more = true;

    for (uint32_t i = first; i < first + count; i++)
        more = visit_item(user, i) && more;
    return more;
}

/* New numbers are old ones in another order, and ranges are the leaves that single items are visited in. */
static void items_in_order_are_those_of_a_leaf_side_by_side(void **state)
{
    static uint32_t order[PARTS];
    uint8_t is_there[PARTS] = { 0 };
    env e = libc_env();
    test_random r = { 13 };
    hierarchy *in_order;
    fixture f = { .in_order = false };

    (void)state;
    make(&f, &e, &r, PARTS);
    in_order = hierarchy_create(&e, &(const hierarchy_items){ PARTS, box_at, f.boxes, order, 2 });
    assert_non_null(in_order);
    for (uint32_t i = 0; i < PARTS; i++) {
        assert_true(order[i] < PARTS && !is_there[order[i]]);
        is_there[order[i]] = 1;
    }
    for (int i = 0; i < RAYS; i++) {
        const pov_hierarchy *h = hierarchy_service(f.made), *ranges = hierarchy_service(in_order);
        pov_ray ray = some_ray(&r);
        pov_hits hits = { .tmax = HUGE_VAL };
        seen a = { .most = PARTS + 1 }, b = { .most = PARTS + 1 };

        h->visit(h, &ray, &hits, visit_item, &a);
        ranges->visit_ranges(ranges, &ray, &hits, visit_range, &b);
        assert_int_equal(a.count, b.count);
        for (uint32_t k = 0; k < PARTS; k++)
            assert_int_equal(b.item[k], a.item[order[k]]);
    }
    hierarchy_destroy(f.made);
    hierarchy_destroy(in_order);
}

static void it_ends_where_it_is_told_to(void **state)
{
    env e = libc_env();
    test_random r = { 11 };
    uint32_t ended = 0, shortened = 0, whole = 0;
    fixture f = { .in_order = false };

    (void)state;
    make(&f, &e, &r, PARTS);
    for (int i = 0; i < RAYS; i++) {
        const pov_hierarchy *h = hierarchy_service(f.made);
        const pov_ray ray = ray_from(pov_vec3_of(0.0, 0.0, -9.0), pov_sub(within(&r, 1e-3), pov_vec3_of(0.0, 0.0, -9.0)));
        pov_hits hits = { .tmax = HUGE_VAL }, closing = { .tmax = HUGE_VAL };
        seen one = { .most = 1 }, all = { .most = PARTS + 1 };
        seen near = { .most = PARTS + 1, .hits = &closing, .closes_to = 0.5 };

        h->visit(h, &ray, &hits, visit_item, &all);
        if (all.count == 0)
            continue;
        assert_false(h->visit(h, &ray, &hits, visit_item, &one));
        assert_int_equal(one.count, 1);
        h->visit(h, &ray, &closing, visit_item, &near);
        ended++;
        shortened += near.count;
        whole += all.count;
    }
    assert_true(ended > RAYS / 2 && shortened < whole);
    hierarchy_destroy(f.made);
}

static void without_memory_there_is_none_and_nothing_is_left(void **state)
{
    const pov_box box = { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 } };
    hierarchy *h = NULL;
    long n;

    (void)state;
    for (n = 1; !h; n++) {
        pov_allocator a;
        failing f;
        env e;

        failing_init(&f, n);
        a = failing_allocator(&f);
        env_init(&e, &a, NULL, NULL);
        h = hierarchy_create(&e, &(const hierarchy_items){ 1, box_at, (void *)(uintptr_t)&box, NULL, 1 });
        hierarchy_destroy(h);
        assert_int_equal(f.blocks, 0);
    }
    assert_true(n > 3);
}

/* ---- rays side by side ---- */

enum { TOGETHER = 64 };

typedef struct many_seen { const fixture *of; uint64_t item[PARTS], ended; double *limit; bool ends, closes; } many_seen;

/* The even rays end at their first leaf; odd ones get shorter there. */
static uint64_t visit_many(void *user, uint32_t first, uint32_t count, uint64_t rays, uint64_t *lowered)
{
    const uint64_t even = 0x5555555555555555u;
    many_seen *s = user;

    assert_int_equal(rays & s->ended, 0);
    for (uint32_t i = first; i < first + count; i++) {
        assert_int_equal(s->item[s->of->order[i]] & rays, 0);
        s->item[s->of->order[i]] |= rays;
    }
    for (uint64_t rest = s->closes ? rays & ~even : 0; rest; rest &= rest - 1)
        s->limit[first_of64(rest)] *= 0.5;
    *lowered |= s->closes ? rays & ~even : 0;
    s->ended |= s->ends ? rays & even : 0;
    return s->ended;
}

static void check_many(const fixture *f, test_random *r, bool nearest, bool ends, bool closes)
{
    const pov_hierarchy *h = hierarchy_service(f->made);
    const uint32_t n = 1 + (uint32_t)(uniform(r) * TOGETHER);
    pov_ray rays[TOGETHER];
    const pov_ray *at[TOGETHER];
    double limit[TOGETHER];
    many_seen s = { .of = f, .limit = limit, .ends = ends, .closes = closes };

    for (uint32_t i = 0; i < n; i++) {
        rays[i] = i > 0 && uniform(r) < 0.7 ? rays[i - 1] : some_ray(r);
        at[i] = &rays[i];
        limit[i] = uniform(r) < 0.5 ? HUGE_VAL : 2.0 / pov_largest(rays[i].dir);
    }
    h->visit_rays(h, at, n, limit, nearest, visit_many, &s);
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t k = 0; k < f->count; k++)
            assert_true((s.item[k] >> i & 1) || (s.ended >> i & 1) || !meets(&f->boxes[k], &rays[i], limit[i]));
}

static void rays_side_by_side_meet_what_each_meets(void **state)
{
    static const uint32_t counts[] = { 1, 2, 9, PARTS };
    env e = libc_env();
    test_random r = { 11 };

    (void)state;
    for (size_t c = 0; c < sizeof counts / sizeof counts[0]; c++) {
        fixture f = { .in_order = true };

        make(&f, &e, &r, counts[c]);
        for (int i = 0; i < 200; i++)
            check_many(&f, &r, i & 1, i & 2, i & 4);
        hierarchy_destroy(f.made);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_part_that_a_ray_meets_is_left_out),
        cmocka_unit_test(items_in_order_are_those_of_a_leaf_side_by_side),
        cmocka_unit_test(it_ends_where_it_is_told_to),
        cmocka_unit_test(rays_side_by_side_meet_what_each_meets),
        cmocka_unit_test(without_memory_there_is_none_and_nothing_is_left),
    };

    return cmocka_run_group_tests_name("bvh_hierarchy", tests, NULL, NULL);
}
