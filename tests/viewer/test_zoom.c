/* Where a magnified picture's pixels are. */
#include "support/check.h"
#include "support/near.h"
#include "zoom.h"

enum { WIDTH = 800, HEIGHT = 600 };

static void zoom_keeps_what_is_under_the_pointer(void **state)
{
    zoom z = { 0 };
    double x, y, then_x, then_y;

    (void)state;
    for (int step = 0; step < 9; step++) {
        zoom_to_picture(&z, 500.0, 200.0, &x, &y);
        assert_true(zoom_step(&z, 1.0, 500.0, 200.0, WIDTH, HEIGHT));
        zoom_to_picture(&z, 500.0, 200.0, &then_x, &then_y);
        /* Half of a pixel of the window at most, by which the corner is moved onto the window's grid. */
        assert_near(then_x, x, 0.5000001 / z.factor);
        assert_near(then_y, y, 0.5000001 / z.factor);
    }
    assert_int_equal(z.factor, 32);
}

static void zoom_lies_on_the_windows_pixels(void **state)
{
    zoom z = { 0 };

    (void)state;
    while (zoom_step(&z, 1.0, 333.3, 77.7, WIDTH, HEIGHT)) {
        assert_near(z.left * z.factor, (int)(z.left * z.factor + 0.5), 1e-9);
        assert_near(z.top * z.factor, (int)(z.top * z.factor + 0.5), 1e-9);
    }
    assert_int_equal(z.factor, 128);
}

static void zoom_ends_at_the_whole_picture(void **state)
{
    zoom z = { 0 };

    (void)state;
    assert_false(zoom_step(&z, -1.0, 5.0, 5.0, WIDTH, HEIGHT));
    assert_false(zoom_is_on(&z));
    zoom_step(&z, 6.0, 790.0, 590.0, WIDTH, HEIGHT);
    assert_int_equal(z.factor, 12);
    assert_true(zoom_step(&z, -1000.0, 5.0, 5.0, WIDTH, HEIGHT));
    assert_false(zoom_is_on(&z));
    assert_true(z.left == 0.0 && z.top == 0.0);
    /* What was too much is forgotten. */
    assert_true(zoom_step(&z, 1.0, 5.0, 5.0, WIDTH, HEIGHT));
}

static void zoom_shows_nothing_beyond_the_edges(void **state)
{
    zoom z = { 0 };
    double x, y;

    (void)state;
    zoom_step(&z, 3.0, 400.0, 300.0, WIDTH, HEIGHT);
    assert_int_equal(z.factor, 4);
    zoom_pan(&z, 1e6, 1e6, WIDTH, HEIGHT);
    assert_true(z.left == 0.0 && z.top == 0.0);
    zoom_pan(&z, -1e6, -1e6, WIDTH, HEIGHT);
    zoom_to_picture(&z, WIDTH, HEIGHT, &x, &y);
    assert_near(x, WIDTH, 1e-9);
    assert_near(y, HEIGHT, 1e-9);
    zoom_fit(&z, 400, 300);
    zoom_to_picture(&z, 400, 300, &x, &y);
    assert_true(x <= 400.0 && y <= 300.0);
}

static void zoom_pan_follows_the_pointer(void **state)
{
    zoom z = { 0 };
    double x, y, then_x, then_y;

    (void)state;
    zoom_step(&z, 7.0, 400.0, 300.0, WIDTH, HEIGHT);
    zoom_to_picture(&z, 100.0, 100.0, &x, &y);
    zoom_pan(&z, 37.0, -11.0, WIDTH, HEIGHT);
    zoom_to_picture(&z, 137.0, 89.0, &then_x, &then_y);
    assert_near(then_x, x, 1e-9);
    assert_near(then_y, y, 1e-9);
    zoom_to_window(&z, x, y, &x, &y);
    assert_near(x, 137.0, 1e-9);
    assert_near(y, 89.0, 1e-9);
}

static void zoom_adds_up_parts_of_a_step(void **state)
{
    zoom z = { 0 };

    (void)state;
    for (int i = 0; i < 3; i++)
        assert_false(zoom_step(&z, 0.25, 0.0, 0.0, WIDTH, HEIGHT));
    assert_true(zoom_step(&z, 0.25, 0.0, 0.0, WIDTH, HEIGHT));
    assert_int_equal(z.factor, 2);
    assert_false(zoom_step(&z, -0.5, 0.0, 0.0, WIDTH, HEIGHT));
    assert_true(zoom_step(&z, -0.5, 0.0, 0.0, WIDTH, HEIGHT));
    assert_int_equal(z.factor, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(zoom_keeps_what_is_under_the_pointer),
        cmocka_unit_test(zoom_lies_on_the_windows_pixels),
        cmocka_unit_test(zoom_ends_at_the_whole_picture),
        cmocka_unit_test(zoom_shows_nothing_beyond_the_edges),
        cmocka_unit_test(zoom_pan_follows_the_pointer),
        cmocka_unit_test(zoom_adds_up_parts_of_a_step),
    };

    return cmocka_run_group_tests_name("magnified pixels", tests, NULL, NULL);
}
