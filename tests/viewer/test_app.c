/* What the viewer makes of events, without a window. */
#include "app.h"
#include "support/check.h"
#include "support/near.h"

#include <math.h>
#include <string.h>

enum { WIDTH = 800, HEIGHT = 600 };

static double probe_seven(void *user, double x, double y)
{
    (void)x;
    (void)y;
    ++*(int *)user;
    return 7.0;
}

static pov_camera camera(void)
{
    pov_camera c = POV_INIT(c);

    c.location = pov_vec3_of(0, 0, -10);
    c.direction = pov_vec3_of(0, 0, 1);
    c.right = pov_vec3_of(4.0 / 3.0, 0, 0);
    c.up = pov_vec3_of(0, 1, 0);
    return c;
}

/* An app with a scene whose first orders have been taken. */
static app ready(int *probes)
{
    pov_camera c = camera();
    app a;

    app_init(&a, WIDTH, HEIGHT, probes ? probe_seven : NULL, probes);
    app_set_scene(&a, &c, 10.0, 20.0, NULL);
    app_update(&a, 0.0, true);
    return a;
}

static void send(app *a, app_event_kind kind, int code, bool down, double x, double y, double now)
{
    app_event e = { kind, code, down, x, y, 1.0 };

    app_take(a, &e, now);
}

static void type(app *a, int code)
{
    send(a, APP_CHARACTER, code, true, 0.0, 0.0, 1.0);
}

static void app_orders_nothing_when_nothing_happens(void **state)
{
    app a = ready(NULL);

    (void)state;
    assert_int_equal(app_update(&a, 1.0, true), 0);
    assert_true(app_patience(&a, 1.0) < 0.0);
    send(&a, APP_POINTER, 0, false, 10.0, 10.0, 1.0);
    assert_int_equal(app_update(&a, 1.0, true), 0);
}

static void app_drags_by_button_and_shift(void **state)
{
    int probes = 0;
    app a = ready(&probes);

    (void)state;
    send(&a, APP_BUTTON, APP_LEFT, true, 0, 0, 1.0);
    assert_int_equal(a.drag, APP_ORBIT);
    assert_int_equal(probes, 1);
    assert_true(a.orbit.reach == 7.0);
    send(&a, APP_BUTTON, APP_RIGHT, true, 0, 0, 1.0);
    assert_int_equal(a.drag, APP_ORBIT);
    send(&a, APP_BUTTON, APP_RIGHT, false, 0, 0, 1.0);
    assert_int_equal(a.drag, APP_ORBIT);
    send(&a, APP_BUTTON, APP_LEFT, false, 0, 0, 1.0);
    assert_int_equal(a.drag, APP_NO_DRAG);
    send(&a, APP_KEY, APP_KEY_SHIFT, true, 0, 0, 1.0);
    send(&a, APP_BUTTON, APP_LEFT, true, 0, 0, 1.0);
    assert_int_equal(a.drag, APP_PAN);
    send(&a, APP_LEAVE, 0, false, 0, 0, 1.0);
    assert_int_equal(a.drag, APP_NO_DRAG);
    send(&a, APP_BUTTON, APP_MIDDLE, true, 0, 0, 1.0);
    assert_int_equal(a.drag, APP_PAN);
}

static void app_restarts_once_for_many_moves(void **state)
{
    app a = ready(NULL);

    (void)state;
    send(&a, APP_POINTER, 0, false, 400, 300, 1.0);
    send(&a, APP_BUTTON, APP_LEFT, true, 0, 0, 1.0);
    for (int i = 1; i <= 20; i++)
        send(&a, APP_POINTER, 0, false, 400 + i, 300, 1.0);
    assert_int_equal(app_update(&a, 1.0, true) & APP_RESTART, APP_RESTART);
    assert_int_equal(app_update(&a, 1.0, true), 0);
    assert_true(app_camera(&a).location.x < 0.0);
}

static void app_waits_for_the_coarse_picture_but_not_for_long(void **state)
{
    app a = ready(NULL);

    (void)state;
    type(&a, '1');
    assert_true(app_update(&a, 1.0, true) & APP_RESTART);
    type(&a, '3');
    assert_int_equal(app_update(&a, 1.01, false), 0);
    assert_true(app_patience(&a, 1.01) > 0.0 && app_patience(&a, 1.01) < 0.05);
    assert_true(app_update(&a, 1.05, false) & APP_RESTART);
    type(&a, '7');
    assert_true(app_update(&a, 1.06, true) & APP_RESTART);
}

static void app_wheel_goes_to_what_is_under_the_pointer(void **state)
{
    int probes = 0;
    app a = ready(&probes);

    (void)state;
    send(&a, APP_POINTER, 0, false, 400, 300, 1.0);
    send(&a, APP_WHEEL, 0, false, 0.0, 1.0, 1.0);
    assert_int_equal(probes, 1);
    assert_near(app_camera(&a).location.z, -10.0 + 0.1 * 7.0, 1e-12);
    assert_true(app_update(&a, 1.0, true) & APP_RESTART);
}

/* Forward for half a second at a fifth of the scene's 20 a second, however often anybody looks. */
static void app_flies_by_the_clock(void **state)
{
    (void)state;
    for (int steps = 1; steps <= 50; steps += 7) {
        app a = ready(NULL);

        send(&a, APP_BUTTON, APP_RIGHT, true, 0, 0, 1.0);
        send(&a, APP_KEY, 'W', true, 0, 0, 1.0);
        assert_true(app_patience(&a, 1.0) < 0.02);
        for (int i = 1; i <= steps; i++)
            app_update(&a, 1.0 + 0.5 * i / steps, true);
        send(&a, APP_KEY, 'W', false, 0, 0, 1.5);
        app_update(&a, 2.0, true);
        assert_near(app_camera(&a).location.z, -10.0 + 0.5 * 4.0, 1e-12);
    }
}

static void app_letters_steer_in_flight_and_command_else(void **state)
{
    app a = ready(NULL);

    (void)state;
    type(&a, 's');
    assert_int_equal(app_update(&a, 1.0, true), APP_SNAPSHOT);
    send(&a, APP_BUTTON, APP_RIGHT, true, 0, 0, 1.0);
    send(&a, APP_KEY, 'S', true, 0, 0, 1.0);
    type(&a, 's');
    assert_false(app_update(&a, 1.1, true) & APP_SNAPSHOT);
    assert_true(app_camera(&a).location.z < -10.0);
    send(&a, APP_LEAVE, 0, false, 0, 0, 1.1);
    assert_int_equal(a.flying, 0);
}

static void app_orders_what_keys_say(void **state)
{
    app a = ready(NULL);

    (void)state;
    type(&a, 'c');
    assert_int_equal(app_update(&a, 1.0, true), APP_PRINT);
    send(&a, APP_KEY, APP_KEY_F5, true, 0, 0, 1.0);
    assert_int_equal(app_update(&a, 1.0, true), APP_RELOAD);
    type(&a, 'h');
    assert_true(a.help);
    assert_int_equal(app_update(&a, 1.0, true), APP_DRAW);
    send(&a, APP_KEY, APP_KEY_F1, true, 0, 0, 1.0);
    assert_false(a.help);
    app_update(&a, 1.0, true);
    type(&a, 'p');
    assert_true(a.paused);
    assert_true(app_update(&a, 1.0, true) & APP_PAUSE);
    send(&a, APP_KEY, APP_KEY_ESCAPE, true, 0, 0, 1.0);
    assert_true(app_update(&a, 1.0, true) & APP_QUIT);
    send(&a, APP_CLOSE, 0, false, 0, 0, 1.0);
    assert_true(app_update(&a, 1.0, true) & APP_QUIT);
}

static void app_exposure_goes_by_thirds_of_a_stop_and_ends(void **state)
{
    app a = ready(NULL);

    (void)state;
    assert_true(app_gain(&a) == 1.0);
    type(&a, ']');
    assert_string_equal(a.note, "exposure +1/3 stop");
    type(&a, ']');
    assert_near(app_gain(&a), cbrt(4.0), 1e-15);
    type(&a, ']');
    assert_string_equal(a.note, "exposure +1 stops");
    assert_near(app_gain(&a), 2.0, 1e-15);
    assert_true(app_update(&a, 1.0, true) & APP_TONE);
    for (int i = 0; i < 100; i++)
        type(&a, '[');
    assert_near(app_gain(&a), pow(2.0, -10.0), 1e-15);
}

static void app_views_come_round(void **state)
{
    app a = ready(NULL);

    (void)state;
    for (int i = 1; i <= APP_VIEWS; i++) {
        send(&a, APP_KEY, APP_KEY_TAB, true, 0, 0, 1.0);
        assert_int_equal(a.view, i % APP_VIEWS);
        assert_true(app_update(&a, 1.0, true) & APP_VIEW);
    }
}

static void app_inspector_follows_the_pointer(void **state)
{
    app a = ready(NULL);

    (void)state;
    type(&a, 'i');
    app_update(&a, 1.0, true);
    send(&a, APP_POINTER, 0, false, 10.0, 10.0, 1.0);
    assert_int_equal(app_update(&a, 1.0, true), APP_DRAW);
}

static void app_notes_pass(void **state)
{
    app a = ready(NULL);

    (void)state;
    app_say(&a, 1.0, "saved %s", "x.png");
    assert_int_equal(app_update(&a, 1.0, true), APP_DRAW);
    assert_string_equal(a.note, "saved x.png");
    assert_true(app_patience(&a, 1.0) > 1.0);
    assert_int_equal(app_update(&a, 4.0, true), APP_DRAW);
    assert_string_equal(a.note, "");
}

static void app_takes_sizes_but_none_of_a_window_put_away(void **state)
{
    app a = ready(NULL);

    (void)state;
    send(&a, APP_SIZE, 0, false, 0, 0, 1.0);
    assert_false(app_update(&a, 1.0, true) & APP_RESIZE);
    send(&a, APP_SIZE, 0, false, 1200, 600, 1.0);
    assert_true(app_update(&a, 1.0, true) & APP_RESIZE);
    assert_int_equal(a.width, 1200);
    assert_near(app_camera(&a).right.x, 2.0, 1e-12);
}

static void app_is_calm_before_there_is_a_scene(void **state)
{
    app a;

    (void)state;
    app_init(&a, WIDTH, HEIGHT, NULL, NULL);
    for (const char *c = "137rRcC[]pPsSiIgG"; *c; c++)
        type(&a, *c);
    send(&a, APP_BUTTON, APP_LEFT, true, 0, 0, 1.0);
    send(&a, APP_POINTER, 0, false, 30, 30, 1.0);
    send(&a, APP_WHEEL, 0, false, 0, 1.0, 1.0);
    assert_int_equal(app_update(&a, 1.0, false), APP_DRAW);
    type(&a, 'h');
    assert_true(a.help);
}

/* Where the user gave a size the picture is povc's of that size; else nothing is stretched. */
static void app_shapes_the_picture_by_the_size_that_was_asked_for(void **state)
{
    pov_camera c = camera();
    app a;

    (void)state;
    app_init(&a, 1000, 500, NULL, NULL);
    app_set_scene(&a, &c, 10.0, 20.0, NULL);
    assert_near(app_camera(&a).right.x, 2.0, 1e-12);
    app_init(&a, 1000, 500, NULL, NULL);
    a.sized = true;
    app_set_scene(&a, &c, 10.0, 20.0, NULL);
    assert_true(app_camera(&a).right.x == c.right.x);
    app_init(&a, 1024, 768, NULL, NULL);
    c.right.x = 1.33;
    app_set_scene(&a, &c, 10.0, 20.0, NULL);
    assert_true(app_camera(&a).right.x == 1.33);
}

static void app_greets_once_and_takes_the_keys_of_other_programs(void **state)
{
    app a = ready(NULL);

    (void)state;
    a.greets = true;
    app_update(&a, 1.0, true);
    assert_string_equal(a.note, "H: help");
    app_update(&a, 5.5, true);
    assert_string_equal(a.note, "H: help");
    app_update(&a, 7.0, true);
    assert_string_equal(a.note, "");
    type(&a, '?');
    assert_true(a.help);
    type(&a, '+');
    type(&a, '=');
    type(&a, '-');
    assert_int_equal(a.exposure, 1);
}

static void app_magnifies_with_control_and_the_wheel(void **state)
{
    app a = ready(NULL);
    double x, y;

    (void)state;
    send(&a, APP_POINTER, 0, false, 200.0, 150.0, 1.0);
    send(&a, APP_KEY, APP_KEY_CONTROL, true, 0.0, 0.0, 1.0);
    send(&a, APP_WHEEL, 0, false, 0.0, 3.0, 1.0);
    send(&a, APP_KEY, APP_KEY_CONTROL, false, 0.0, 0.0, 1.0);
    assert_int_equal(a.zoom.factor, 4);
    app_pointed(&a, &x, &y);
    assert_near(x, 200.0, 0.2);
    assert_near(y, 150.0, 0.2);
    assert_false(app_update(&a, 1.0, true) & APP_RESTART);
    /* Back to the whole picture; what the wheel turns too far moves nothing, and later it does again. */
    send(&a, APP_WHEEL, 0, false, 0.0, -3.0, 2.0);
    send(&a, APP_WHEEL, 0, false, 0.0, -3.0, 2.1);
    assert_false(zoom_is_on(&a.zoom));
    assert_false(app_update(&a, 2.1, true) & APP_RESTART);
    send(&a, APP_WHEEL, 0, false, 0.0, -3.0, 3.0);
    assert_true(app_update(&a, 3.0, true) & APP_RESTART);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(app_orders_nothing_when_nothing_happens),
        cmocka_unit_test(app_drags_by_button_and_shift),
        cmocka_unit_test(app_restarts_once_for_many_moves),
        cmocka_unit_test(app_waits_for_the_coarse_picture_but_not_for_long),
        cmocka_unit_test(app_wheel_goes_to_what_is_under_the_pointer),
        cmocka_unit_test(app_flies_by_the_clock),
        cmocka_unit_test(app_letters_steer_in_flight_and_command_else),
        cmocka_unit_test(app_orders_what_keys_say),
        cmocka_unit_test(app_exposure_goes_by_thirds_of_a_stop_and_ends),
        cmocka_unit_test(app_views_come_round),
        cmocka_unit_test(app_inspector_follows_the_pointer),
        cmocka_unit_test(app_notes_pass),
        cmocka_unit_test(app_takes_sizes_but_none_of_a_window_put_away),
        cmocka_unit_test(app_is_calm_before_there_is_a_scene),
        cmocka_unit_test(app_shapes_the_picture_by_the_size_that_was_asked_for),
        cmocka_unit_test(app_greets_once_and_takes_the_keys_of_other_programs),
        cmocka_unit_test(app_magnifies_with_control_and_the_wheel),
    };

    return cmocka_run_group_tests_name("the viewer's state", tests, NULL, NULL);
}
