/* The figures that polygons draw: the plane of loops that cross themselves, holes, and corners off the plane. */
#include "support/check.h"
#include "support/fake_reader.h"

#include <math.h>

static const shape_class *polygon;

/* Whether a ray along z through (x, y) meets the polygon of the text, at z = 0. */
static bool covers(const void *self, double x, double y)
{
    pov_crossing at = { 0 };
    pov_hits hits = { 0 };
    pov_ray ray = { 0 };

    ray.org = pov_vec3_of(x, y, -5.0);
    ray.dir = pov_vec3_of(0.0, 0.0, 1.0);
    ray.origin_surface = POV_NO_OWNER;
    hits.tmax = HUGE_VAL;
    hits.want = POV_WANT_NEAREST;
    hits.at = &at;
    polygon->intersect(self, &ray, &hits);
    if (hits.count)
        assert_true(at.t == 5.0);
    return hits.count != 0;
}

static void *parse(pov_reader *in, const char *text)
{
    fake_reader_clear(in);
    fake_reader_text(in, text);
    return fake_reader_parse(in, polygon);
}

static void test_a_bow_tie_has_a_plane_though_its_area_is_zero(void **state)
{
    pov_reader *in = fake_reader_create();
    void *self = parse(in, "5, <-1, -1, 0>, <1, 1, 0>, <1, -1, 0>, <-1, 1, 0>, <-1, -1, 0>");

    (void)state;
    assert_non_null(self);
    assert_int_equal(fake_reader_warnings(in), 0);
    assert_true(covers(self, -0.8, 0.1));
    assert_true(covers(self, 0.8, -0.1));
    assert_false(covers(self, 0.1, 0.8));
    assert_false(covers(self, -0.1, -0.8));
    fake_reader_destroy(in);
}

static void test_loops_that_cancel_are_seen(void **state)
{
    pov_reader *in = fake_reader_create();
    void *self = parse(in, "8, <0, 0, 0>, <1, 0, 0>, <0, 1, 0>, <0, 0, 0>, <3, 0, 0>, <3, 1, 0>, <4, 0, 0>, <3, 0, 0>");

    (void)state;
    assert_non_null(self);
    assert_true(covers(self, 0.2, 0.2));
    assert_true(covers(self, 3.2, 0.2));
    assert_false(covers(self, 2.0, 0.2));
    fake_reader_destroy(in);
}

static void test_the_middle_of_a_star_and_a_hole_are_open(void **state)
{
    pov_reader *in = fake_reader_create();
    void *self = parse(in, "6, <0, 1, 0>, <0.6, -0.8, 0>, <-0.95, 0.3, 0>, <0.95, 0.3, 0>, <-0.6, -0.8, 0>, <0, 1, 0>");

    (void)state;
    assert_non_null(self);
    assert_true(covers(self, 0.0, 0.7));
    assert_false(covers(self, 0.0, 0.0));
    self = parse(in, "10, <0, 0, 0>, <9, 0, 0>, <9, 9, 0>, <0, 9, 0>, <0, 0, 0>, "
                     "<3, 3, 0>, <6, 3, 0>, <6, 6, 0>, <3, 6, 0>, <3, 3, 0>");
    assert_non_null(self);
    assert_true(covers(self, 1.0, 5.0));
    assert_false(covers(self, 4.0, 5.0));
    fake_reader_destroy(in);
}

/* A ray from afar through a corner of the hole, or past one at its level. */
static pov_ray past_corner(int i)
{
    const pov_vec3 dir = pov_vec3_of(0.31 + 0.013 * i, -0.17 - 0.007 * i, 1.0), to = pov_vec3_of(0.1 * (i % 8), i % 2 ? 0.3 : 0.6, 0.0);
    pov_ray ray = { .origin_surface = POV_NO_OWNER };

    ray.org = pov_sub(to, pov_scale(dir, 5.0));
    ray.dir = dir;
    return ray;
}

/* Doubles leave open which edges such rays pass. */
static void test_rays_past_corners_are_alike_alone_and_together(void **state)
{
    enum { MANY = 64 };
    pov_reader *in = fake_reader_create();
    const void *self = parse(in, "10, <0, 0, 0>, <.9, 0, 0>, <.9, .9, 0>, <0, .9, 0>, <0, 0, 0>, "
                                 "<.3, .3, 0>, <.6, .3, 0>, <.6, .6, 0>, <.3, .6, 0>, <.3, .3, 0>"), *selves[MANY];
    pov_crossing crossings[2][MANY] = { { { 0 } } };
    pov_hits hits[2][MANY] = { { { 0 } } }, *to[MANY];
    const pov_ray *rays[MANY];
    pov_ray ray[MANY];

    (void)state;
    assert_non_null(self);
    for (int i = 0; i < MANY; i++) {
        ray[i] = past_corner(i);
        for (int k = 0; k < 2; k++) {
            hits[k][i].tmax = HUGE_VAL;
            hits[k][i].want = POV_WANT_NEAREST;
            hits[k][i].at = &crossings[k][i];
        }
        selves[i] = self, rays[i] = &ray[i], to[i] = &hits[1][i];
        polygon->intersect(self, &ray[i], &hits[0][i]);
    }
    polygon->intersect_many(selves, rays, to, MANY);
    for (int i = 0; i < MANY; i++) {
        assert_int_equal(hits[1][i].count, hits[0][i].count);
        assert_true(crossings[1][i].t == crossings[0][i].t && crossings[1][i].t_lo == crossings[0][i].t_lo);
    }
    fake_reader_destroy(in);
}

/* The corners of a regular polygon in a tilted plane, far from the origin, each rounded once; one may be moved off. */
static void *tilted(pov_reader *in, int corners, double size, double moved)
{
    const double a[3] = { 0.6, 0.48, 0.64 }, b[3] = { 0.8, -0.36, -0.48 }, c[3] = { 0.0, 0.8, -0.6 };
    const double centre[3] = { 1234.5, -77.1, 0.3 };
    int i, j;

    fake_reader_clear(in);
    fake_reader_number(in, corners);
    for (i = 0; i < corners; i++) {
        const double angle = 6.283185307179586 * i / corners;

        fake_reader_text(in, ", <");
        for (j = 0; j < 3; j++) {
            fake_reader_number(in, centre[j] + size * (cos(angle) * a[j] + sin(angle) * b[j])
                                   + (i == 2 ? moved : 0.0) * c[j]);
            fake_reader_text(in, j < 2 ? "," : ">");
        }
    }
    return fake_reader_parse(in, polygon);
}

static void test_rounding_explains_a_little(void **state)
{
    pov_reader *in = fake_reader_create();
    int corners;

    (void)state;
    for (corners = 3; corners < 200; corners += 7) {
        assert_non_null(tilted(in, corners, 1.0, 0.0));
        assert_non_null(tilted(in, corners, 1e5, 0.0));
        assert_non_null(tilted(in, corners, 1e-3, 0.0));
    }
    fake_reader_destroy(in);
}

/* The first warning is of the loop that is not closed. */
static void test_few_digits_are_flattened_and_more_is_an_error(void **state)
{
    static const double moved[] = { 1e-11, 1e-6, 5e-4 };
    pov_reader *in = fake_reader_create();

    (void)state;
    assert_non_null(tilted(in, 5, 1.0, 0.0));
    assert_int_equal(fake_reader_warnings(in), 1);
    for (int i = 0; i < 3; i++) {
        assert_non_null(tilted(in, 5, 1.0, moved[i]));
        assert_int_equal(fake_reader_warnings(in), 2);
        assert_non_null(tilted(in, 50, 1e5, 1e5 * moved[i]));
        assert_int_equal(fake_reader_warnings(in), 2);
    }
    assert_null(tilted(in, 5, 1.0, 1e-2));
    fake_reader_destroy(in);
}

/* Seen along its normal a flattened polygon has its corners where they were, and lies within what they were off. */
static void test_a_flattened_polygon_is_where_its_corners_were(void **state)
{
    pov_reader *in = fake_reader_create();
    const void *self = parse(in, "6, <-1, -1, 0>, <1, -1, 0>, <1.5, 0, 1e-6>, <1, 1, 0>, <-1, 1, 0>, <-1, -1, 0>");
    pov_crossing at = { 0 };
    pov_hits hits = { .tmax = HUGE_VAL, .want = POV_WANT_NEAREST, .at = &at };
    const pov_ray ray = { .org = { 1.49, 0.0, -5.0 }, .dir = { 0.0, 0.0, 1.0 }, .origin_surface = POV_NO_OWNER };

    (void)state;
    assert_non_null(self);
    polygon->intersect(self, &ray, &hits);
    assert_int_equal(hits.count, 1);
    assert_true(fabs(at.t - 5.0) <= 2e-6);
    fake_reader_destroy(in);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_bow_tie_has_a_plane_though_its_area_is_zero),
        cmocka_unit_test(test_loops_that_cancel_are_seen),
        cmocka_unit_test(test_the_middle_of_a_star_and_a_hole_are_open),
        cmocka_unit_test(test_rays_past_corners_are_alike_alone_and_together),
        cmocka_unit_test(test_rounding_explains_a_little),
        cmocka_unit_test(test_few_digits_are_flattened_and_more_is_an_error),
        cmocka_unit_test(test_a_flattened_polygon_is_where_its_corners_were),
    };

    polygon = fake_reader_shape("polygon");
    return polygon ? cmocka_run_group_tests(tests, NULL, NULL) : 1;
}
