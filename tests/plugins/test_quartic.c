/* Boxes of quartics of which one coordinate grows as the square of another. */
#include "support/check.h"
#include "support/fake_reader.h"

#include <math.h>

static const shape_class *quartic;

static pov_box box_of(const char *text)
{
    pov_reader *in = fake_reader_create();
    pov_box box;
    void *self;

    fake_reader_text(in, text);
    self = fake_reader_parse(in, quartic);
    assert_non_null(self);
    assert_true(quartic->bounds(self, &box));
    fake_reader_destroy(in);
    return box;
}

/* 4 x^4 - 4 x^3 + y^2 + z^2 is inside from 0 to 1, and nowhere farther than the square root of 27/64 from the axis. */
static void the_box_of_a_piriform_is_tight(void **state)
{
    const double radius = sqrt(27.0 / 64.0);
    const pov_box box = box_of("<4, 0,0,-4, 0,0,0,0,0,0, 0,0,0,0,0,0,0,0,0,0, 0,0,0,0,0,1,0,0,0,0, 0,0,1,0,0>");

    (void)state;
    assert_true(box.lo.x <= 0.0 && box.hi.x >= 1.0);
    assert_true(box.hi.x - box.lo.x < 1.25);
    assert_true(box.lo.y <= -radius && box.lo.z <= -radius && box.hi.y >= radius && box.hi.z >= radius);
    assert_true(box.hi.y - box.lo.y < 2.5 * radius && box.hi.z - box.lo.z < 2.5 * radius);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_box_of_a_piriform_is_tight),
    };

    quartic = fake_reader_shape("quartic");
    return quartic ? cmocka_run_group_tests(tests, NULL, NULL) : 1;
}
