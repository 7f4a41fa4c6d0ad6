/* Rays through the points in which a torus meets itself: the poles of a spindle, and the middle of one with equal radii. */
#include "support/check.h"
#include "support/fake_reader.h"

#include <math.h>

static const shape_class *torus;

/* The crossings of a ray, which may start on the torus. */
static uint32_t cross(const char *text, pov_ray ray, bool exact, pov_crossing at[4])
{
    pov_reader *in = fake_reader_create();
    pov_hits hits = { .tmax = HUGE_VAL, .want = POV_WANT_ALL, .at = at, .capacity = 4, .always_exact = exact, .owner = 0 };
    void *self;

    fake_reader_text(in, text);
    self = fake_reader_parse(in, torus);
    assert_non_null(self);
    torus->intersect(self, &ray, &hits);
    fake_reader_destroy(in);
    return hits.count;
}

/* It starts on the torus and goes along a diagonal: inside of the torus before the middle and behind it. */
static void equal_radii_touch_in_a_point_that_a_ray_passes(void **state)
{
    const double s = 0x1.e2b7dddfefa66p-1, s_lo = 0x1.60eeap-57;
    const pov_ray ray = { .org = { s, -s, s }, .org_lo = { s_lo, -s_lo, s_lo }, .dir = { -1.0, 1.0, -1.0 }, .origin_surface = 0 };
    pov_crossing at[4];

    (void)state;
    for (int exact = 0; exact < 2; exact++) {
        assert_int_equal(cross("1, 1", ray, exact, at), 1);
        assert_true(fabs(at[0].t - 2.0 * s) <= 0x1p-50);
    }
}

/* Only the outer sheet is a surface: its poles are all that the axis meets. */
static void the_axis_meets_a_spindle_in_its_poles(void **state)
{
    static const char *const spindles[] = { "3, 5", ".3, .5", "1, 1.25", "5, 13" };
    static const double poles[] = { 4.0, 0.4, 0.75, 12.0 };
    pov_crossing at[4];

    (void)state;
    for (int i = 0; i < 4; i++)
        for (int exact = 0; exact < 2; exact++) {
            const double h = poles[i];
            const pov_ray ray = { .org = { 0.0, -8.0 * h, 0.0 }, .dir = { 0.0, 1.0, 0.0 }, .origin_surface = POV_NO_OWNER };

            assert_int_equal(cross(spindles[i], ray, exact, at), 2);
            assert_true(fabs(at[0].t - 7.0 * h) <= 0x1p-46 * h && fabs(at[1].t - 9.0 * h) <= 0x1p-46 * h);
        }
}

static pov_ray ray_at(double x, double y)
{
    const pov_ray ray = { .org = { x, y, -3.0 }, .dir = { 0.0, 0.0, 1.0 }, .origin_surface = POV_NO_OWNER };

    return ray;
}

/* Rounded cylinders of the standard include files end in such tori. */
static void without_the_first_radius_it_is_a_sphere(void **state)
{
    pov_crossing at[4];

    (void)state;
    for (int exact = 0; exact < 2; exact++) {
        assert_int_equal(cross("0, 1", ray_at(0.6, 0.0), exact, at), 2);
        assert_true(fabs(at[0].t - 2.2) <= 0x1p-50 && fabs(at[1].t - 3.8) <= 0x1p-50);
        assert_int_equal(cross("0, 1", ray_at(0.8, 0.7), exact, at), 0);
    }
}

static void without_the_second_radius_it_is_not_seen(void **state)
{
    pov_crossing at[4];

    (void)state;
    for (int exact = 0; exact < 2; exact++) {
        assert_int_equal(cross("1, 0", ray_at(0.6, 0.0), exact, at), 0);
        assert_int_equal(cross("0, 0", ray_at(0.0, 0.0), exact, at), 0);
    }
}

/* What is within a distance of its circle; not of a spindle, where that is another solid. */
static void a_ring_has_its_radii(void **state)
{
    static const char *const texts[] = { "3, .5", "1, 2" };

    (void)state;
    for (int i = 0; i < 2; i++) {
        pov_reader *in = fake_reader_create();
        double radii[2];

        fake_reader_text(in, texts[i]);
        assert_int_equal(torus->ring(fake_reader_parse(in, torus), radii), i == 0);
        assert_true(radii[0] == (i ? 1.0 : 3.0) && radii[1] == (i ? 2.0 : 0.5));
        fake_reader_destroy(in);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_radii_touch_in_a_point_that_a_ray_passes),
        cmocka_unit_test(the_axis_meets_a_spindle_in_its_poles),
        cmocka_unit_test(without_the_first_radius_it_is_a_sphere),
        cmocka_unit_test(without_the_second_radius_it_is_not_seen),
        cmocka_unit_test(a_ring_has_its_radii),
    };

    torus = fake_reader_shape("torus");
    return torus ? cmocka_run_group_tests(tests, NULL, NULL) : 1;
}
