/* test_cylinder.c - rays along the axis of a cylinder, as those of a camera that looks at letters from the front. */
#include "support/check.h"
#include "support/fake_reader.h"

#include <math.h>

static const shape_class *cylinder;

static pov_hits cross(double x, pov_want want, pov_crossing at[2])
{
    const pov_ray ray = { .org = { x, 0.25, -3.0 }, .dir = { 0.0, 0.0, 1.0 }, .origin_surface = POV_NO_OWNER };
    pov_hits hits = { .tmax = HUGE_VAL, .want = want, .at = at, .capacity = 2, .owner = 0 };
    pov_reader *in = fake_reader_create();
    void *self;

    fake_reader_text(in, "<0, 0, 0>, <0, 0, 2>, 1.25");
    self = fake_reader_parse(in, cylinder);
    assert_non_null(self);
    cylinder->intersect(self, &ray, &hits);
    fake_reader_destroy(in);
    return hits;
}

static void doubles_tell_whether_a_ray_along_the_axis_is_inside(void **state)
{
    pov_crossing at[2];
    pov_hits hits = cross(0.5, POV_WANT_ALL, at);

    (void)state;
    assert_int_equal(hits.count, 2);
    assert_true(at[0].t == 3.0 && at[1].t == 5.0);
    assert_int_equal(hits.escalated, 0);
    hits = cross(0.5, POV_WANT_NEAREST, at);
    assert_true(hits.count == 1 && at[0].t == 3.0 && hits.escalated == 0);
    hits = cross(1.3, POV_WANT_ALL, at);
    assert_true(hits.count == 0 && hits.escalated == 0);
}

/* 1.5625 = 1.25 * 1.25 = 1.5 + 0.0625, and the double next to the root of that. */
static void on_the_side_double_double_does(void **state)
{
    const double side = 0x1.3988e1409212ep0;
    pov_crossing at[2];

    (void)state;
    for (int i = -2; i <= 2; i++) {
        const double x = side + i * 0x1p-52;
        const pov_hits hits = cross(x, POV_WANT_ALL, at);

        assert_int_equal(hits.escalated, 1);
        assert_int_equal(hits.count, i <= 0 ? 2 : 0);
    }
}

/* Of a segment that ends in a cap's plane, on it, or before. */
static void an_end_at_a_cap_is_near_and_not_crossed(void **state)
{
    static const double ends[] = { 3.0, 3.0 - 0x1p-51, 3.0 + 0x1p-51 };
    static const bool near[] = { true, false, false };
    static const pov_want wants[] = { POV_WANT_ALL, POV_WANT_NEAREST, POV_WANT_ANY };
    const pov_ray ray = { .org = { 0.5, 0.25, -3.0 }, .dir = { 0.1, 0.0, 1.0 }, .origin_surface = POV_NO_OWNER };
    pov_reader *in = fake_reader_create();
    void *self;

    (void)state;
    fake_reader_text(in, "<0, 0, 0>, <0, 0, 2>, 1.25");
    self = fake_reader_parse(in, cylinder);
    for (int i = 0; i < 9; i++) {
        pov_crossing at[2];
        pov_hits hits = { .tmax = ends[i / 3], .want = wants[i % 3], .at = at, .capacity = 2, .owner = 0, .always_exact = true, .slack = 0x1p-90 };

        cylinder->intersect(self, &ray, &hits);
        assert_int_equal(hits.near_end, near[i / 3]);
        assert_int_equal(hits.count, ends[i / 3] > 3.0 + 0x1p-60);
    }
    fake_reader_destroy(in);
}

/* Of a ray that starts in a cap's plane, or a little to one side of it, and goes out, or in. */
static void a_start_at_a_cap_is_on_one_side_of_it(void **state)
{
    static const double aside[] = { 0.0, 0x1p-90, -0x1p-90 };
    static const uint32_t out[] = { 0, 0, 1 }, in[] = { 1, 1, 2 };
    pov_reader *reader = fake_reader_create();
    void *self;

    (void)state;
    fake_reader_text(reader, "<0, 0, 0>, <0, 0, 2>, 1.25");
    self = fake_reader_parse(reader, cylinder);
    for (int i = 0; i < 12; i++) {
        const double z = i & 1 ? 2.0 : 0.0, outward = i & 1 ? 1.0 : -1.0, side = i & 2 ? -1.0 : 1.0, off = aside[i / 4];
        const pov_ray ray = { .org = { 0.5, 0.25, z }, .org_lo = { 0.0, 0.0, outward * off }, .dir = { 0.1, 0.0, side * outward }, .origin_surface = POV_NO_OWNER };
        pov_crossing at[2];
        pov_hits hits = { .tmax = HUGE_VAL, .want = POV_WANT_ALL, .at = at, .capacity = 2, .owner = 0 };

        cylinder->intersect(self, &ray, &hits);
        assert_int_equal(hits.count, side > 0.0 ? out[i / 4] : in[off == 0.0 ? 0 : 3 - i / 4]);
        if (i / 4 == (side > 0.0 ? 2 : 1))
            assert_true(fabs(at[0].t - 0x1p-90) < 0x1p-130);
    }
    fake_reader_destroy(reader);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(doubles_tell_whether_a_ray_along_the_axis_is_inside),
        cmocka_unit_test(on_the_side_double_double_does),
        cmocka_unit_test(an_end_at_a_cap_is_near_and_not_crossed),
        cmocka_unit_test(a_start_at_a_cap_is_on_one_side_of_it),
    };

    cylinder = fake_reader_shape("cylinder");
    return cylinder ? cmocka_run_group_tests(tests, NULL, NULL) : 1;
}
