/* Quadrics whose coefficients are so far apart that they share no power of two. */
#include "support/check.h"
#include "support/fake_reader.h"

#include <math.h>

static const shape_class *quadric;

/* Squeezed along y, what of y was next to nothing counts as much as the rest: who absorbs the map must have kept it. */
static void test_what_a_map_makes_large_is_kept(void **state)
{
    const double squeeze = 0x1p-523, reach = (double)(sqrtl(1e10L / 1e-305L) * 0x1p-523L);
    pov_reader *in = fake_reader_create();
    pov_affine map = { .m = { { 1.0 }, { 0.0, squeeze }, { 0.0, 0.0, 1.0 } },
                       .inv = { { 1.0 }, { 0.0, 1.0 / squeeze }, { 0.0, 0.0, 1.0 } } };
    pov_crossing at = { 0 };
    pov_hits hits = { 0 };
    pov_ray ray = { 0 };
    void *self;

    (void)state;
    fake_reader_text(in, "<1e10, 1e-305, 1e10>, <0, 0, 0>, <0, 0, 0>, -1e10");
    self = fake_reader_parse(in, quadric);
    assert_non_null(self);
    if (quadric->absorb(self, &map)) {
        ray.org = pov_vec3_of(0.0, -5.0, 0.0);
        ray.dir = pov_vec3_of(0.0, 1.0, 0.0);
        ray.origin_surface = POV_NO_OWNER;
        hits.tmax = HUGE_VAL;
        hits.want = POV_WANT_NEAREST;
        hits.at = &at;
        quadric->intersect(self, &ray, &hits);
        assert_int_equal(hits.count, 1);
        assert_true(fabs(at.t - (5.0 - reach)) <= 0x1p-48);
    }
    fake_reader_destroy(in);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(test_what_a_map_makes_large_is_kept) };

    quadric = fake_reader_shape("quadric");
    return quadric ? cmocka_run_group_tests(tests, NULL, NULL) : 1;
}
