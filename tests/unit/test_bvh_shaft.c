/* Shafts from points to areas: what they are said to miss, no segment in them enters. */
#include "bvh/shaft.h"
#include "support/check.h"

static uint64_t seed = 1;

static double uniform(double lo, double hi)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return lo + (hi - lo) * (double)(seed >> 11) * 0x1p-53;
}

static pov_vec3 anywhere(double size) { return pov_vec3_of(uniform(-size, size), uniform(-size, size), uniform(-size, size)); }

/* An area in a frame of this scale around a place. */
typedef struct area { pov_vec3 from, to, axes[2]; shaft s; } area;

static bool make_area(area *a, pov_vec3 place, double scale)
{
    pov_vec3 corner[4];

    a->from = pov_add(place, pov_scale(anywhere(1.0), scale));
    a->to = pov_scale(anywhere(4.0), scale);
    a->axes[0] = pov_scale(anywhere(1.0), scale);
    a->axes[1] = pov_scale(anywhere(1.0), scale);
    for (int i = 0; i < 4; i++) {
        const double u = (i + 1) & 2 ? 0.5 : -0.5, v = i & 2 ? 0.5 : -0.5;

        corner[i] = pov_add(a->to, pov_add(pov_scale(a->axes[0], u), pov_scale(a->axes[1], v)));
    }
    return shaft_make(&a->s, a->from, corner);
}

static pov_vec3 point_in(const area *a)
{
    const pov_vec3 at = pov_add(a->to, pov_add(pov_scale(a->axes[0], uniform(-0.5, 0.5)), pov_scale(a->axes[1], uniform(-0.5, 0.5))));

    return pov_add(a->from, pov_scale(at, uniform(0.0, 1.0)));
}

static bool holds(const pov_box *b, pov_vec3 p)
{
    return p.x >= b->lo.x && p.x <= b->hi.x && p.y >= b->lo.y && p.y <= b->hi.y && p.z >= b->lo.z && p.z <= b->hi.z;
}

static const double scales[] = { 1.0, 1e-12, 1e12 };

static pov_vec3 draw_place(int round, double scale) { return round % 2 ? pov_scale(anywhere(1.0), 1e3 * scale) : pov_vec3_of(0.0, 0.0, 0.0); }

static void no_point_of_a_shaft_is_in_a_box_that_it_misses(void **state)
{
    int missed = 0, rounds = 0;
    (void)state;

    for (int round = 0; round < 60000; round++) {
        const double scale = scales[round % 3];
        const pov_vec3 place = draw_place(round, scale);
        const pov_vec3 lo = pov_add(place, pov_scale(anywhere(4.0), scale)), size = pov_scale(anywhere(1.0), scale);
        const pov_box box = { lo, pov_add(lo, pov_vec3_of(fabs(size.x), fabs(size.y), fabs(size.z))) };
        area a;

        assert_true(make_area(&a, place, scale));
        rounds++;
        if (shaft_may_overlap(&a.s, &box))
            continue;
        missed++;
        for (int i = 0; i < 20; i++)
            assert_false(holds(&box, point_in(&a)));
    }
    assert_true(missed > rounds / 2);
}

/* However small the box. */
static void a_box_around_a_point_of_a_shaft_overlaps_it(void **state)
{
    (void)state;
    for (int round = 0; round < 60000; round++) {
        const double scale = scales[round % 3];
        area a;
        pov_vec3 p;
        pov_box box;

        assert_true(make_area(&a, pov_vec3_of(0.0, 0.0, 0.0), scale));
        p = point_in(&a);
        box = (pov_box){ p, p };
        assert_true(shaft_may_overlap(&a.s, &box));
        assert_true(shaft_may_cross(&a.s, pov_vec3_of(0.0, 1.0, 0.0), p.y));
    }
}

/* Columns of a map that turns, stretches and moves. */
typedef struct moved_to { pov_vec3 column[3], anchor, to; } moved_to;

static pov_vec3 move(const moved_to *m, pov_vec3 p)
{
    const pov_vec3 v = pov_sub(p, m->anchor);

    return pov_add(pov_add(pov_scale(m->column[0], v.x), pov_scale(m->column[1], v.y)), pov_add(pov_scale(m->column[2], v.z), m->to));
}

static void a_moved_shaft_overlaps_boxes_around_moved_points(void **state)
{
    int missed = 0;
    (void)state;

    for (int round = 0; round < 60000; round++) {
        const double scale = scales[round % 3], other = scales[round / 3 % 3];
        const moved_to m = { { pov_scale(anywhere(1.0), other), pov_scale(anywhere(1.0), other), pov_scale(anywhere(1.0), other) },
                             pov_scale(anywhere(round % 2 ? 1e3 : 1.0), scale), pov_scale(anywhere(1.0), scale * other) };
        area a;
        shaft moved;
        pov_vec3 p, away;

        assert_true(make_area(&a, round % 2 ? m.anchor : pov_vec3_of(0.0, 0.0, 0.0), scale));
        if (!shaft_move(&a.s, m.column, m.anchor, m.to, &moved))
            continue;
        p = move(&m, point_in(&a));
        away = pov_add(p, pov_scale(anywhere(4.0), scale * other));
        assert_true(shaft_may_overlap(&moved, &(pov_box){ p, p }));
        missed += !shaft_may_overlap(&moved, &(pov_box){ away, away });
    }
    assert_true(missed > 30000);
}

static void a_plane_between_point_and_area_crosses_the_shaft_and_one_behind_does_not(void **state)
{
    const pov_vec3 up = { 0.0, 1.0, 0.0 };
    const pov_vec3 corner[4] = { { -1, 4, -1 }, { 1, 4, -1 }, { 1, 4, 1 }, { -1, 4, 1 } };
    shaft s;
    (void)state;

    assert_true(shaft_make(&s, pov_vec3_of(0.0, 1.0, 0.0), corner));
    assert_true(shaft_may_cross(&s, up, 1.0));
    assert_true(shaft_may_cross(&s, up, 3.0));
    assert_true(shaft_may_cross(&s, up, 5.0));
    assert_false(shaft_may_cross(&s, up, 0.999999));
    assert_false(shaft_may_cross(&s, up, 5.000001));
}

/* By the place of the area that the point is before, and how far from there. */
static bool is_well_in(const area *a, pov_vec3 p)
{
    const pov_vec3 n = pov_cross_product(a->axes[0], a->axes[1]), d = pov_sub(p, a->from);
    const double share = pov_dot(d, n) / pov_dot(a->to, n), per = 1.0 / pov_dot(n, n);
    const pov_vec3 at = pov_sub(pov_scale(d, 1.0 / share), a->to);
    const double right = pov_dot(pov_cross_product(at, a->axes[1]), n) * per, down = pov_dot(pov_cross_product(a->axes[0], at), n) * per;

    return share > 0.0 && share < 1.0 && fabs(right) < 0.4999 && fabs(down) < 0.4999;
}

/* A triangle around a point of a shaft overlaps it; and no point of one that it misses is in one. */
static void no_point_of_a_shaft_is_in_a_triangle_that_it_misses(void **state)
{
    int missed = 0, rounds = 0;
    (void)state;

    for (int round = 0; round < 60000; round++) {
        const double scale = scales[round % 3];
        const pov_vec3 place = draw_place(round, scale);
        pov_vec3 corner[3], middle, normal;
        area a;

        assert_true(make_area(&a, place, scale));
        for (int i = 0; i < 3; i++)
            corner[i] = pov_add(place, pov_scale(anywhere(4.0), scale));
        if (round % 4 == 0) {
            middle = pov_scale(pov_add(corner[0], pov_add(corner[1], corner[2])), 1.0 / 3.0);
            for (int i = 0; i < 3; i++)
                corner[i] = pov_add(corner[i], pov_sub(point_in(&a), middle));
        }
        normal = pov_unit(pov_cross_product(pov_sub(corner[1], corner[0]), pov_sub(corner[2], corner[0])));
        rounds++;
        if (shaft_may_overlap_triangle(&a.s, corner, normal, true))
            continue;
        missed++;
        assert_false(shaft_may_overlap_triangle(&a.s, corner, normal, false));
        for (int i = 0; i < 20; i++) {
            const double u = uniform(0.0, 1.0), v = uniform(0.0, 1.0), x = u + v > 1.0 ? 1.0 - u : u, y = u + v > 1.0 ? 1.0 - v : v;
            const pov_vec3 p = pov_add(corner[0], pov_add(pov_scale(pov_sub(corner[1], corner[0]), x), pov_scale(pov_sub(corner[2], corner[0]), y)));

            assert_false(is_well_in(&a, p));
        }
    }
    assert_true(missed > rounds / 4 && missed < rounds);
}

/* Planes of triangles, through the point and through the area. */
static void a_triangle_in_whose_plane_a_shaft_ends_is_told_from_one_in_it(void **state)
{
    const pov_vec3 corner[4] = { { -1.0, 2.0, -1.0 }, { 1.0, 2.0, -1.0 }, { 1.0, 2.0, 1.0 }, { -1.0, 2.0, 1.0 } }, up = pov_vec3_of(0.0, 1.0, 0.0);
    shaft s;

    (void)state;
    assert_true(shaft_make(&s, pov_vec3_of(0.0, 0.0, 0.0), corner));
    for (int i = 0; i < 3; i++) {
        const pov_vec3 at[3] = { { -9.0, i, -9.0 }, { 9.0, i, -9.0 }, { 0.0, i, 9.0 } };

        assert_true(shaft_may_overlap_triangle(&s, at, up, true));
        assert_int_equal(shaft_may_overlap_triangle(&s, at, up, false), i == 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_point_of_a_shaft_is_in_a_box_that_it_misses),
        cmocka_unit_test(a_box_around_a_point_of_a_shaft_overlaps_it),
        cmocka_unit_test(a_moved_shaft_overlaps_boxes_around_moved_points),
        cmocka_unit_test(a_plane_between_point_and_area_crosses_the_shaft_and_one_behind_does_not),
        cmocka_unit_test(no_point_of_a_shaft_is_in_a_triangle_that_it_misses),
        cmocka_unit_test(a_triangle_in_whose_plane_a_shaft_ends_is_told_from_one_in_it),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
