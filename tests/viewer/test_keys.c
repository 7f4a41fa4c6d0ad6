/* The table of keys, and what those for the camera do. */
#include "keys.h"
#include "support/check.h"
#include "support/near.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static pov_camera camera(void)
{
    pov_camera c = POV_INIT(c);

    c.location = pov_vec3_of(0, 0, -10);
    c.direction = pov_vec3_of(0, 0, 1);
    c.right = pov_vec3_of(4.0 / 3.0, 0, 0);
    c.up = pov_vec3_of(0, 1, 0);
    return c;
}

static bool unit_around_seven(void *user, double x, double y, pov_box *out)
{
    (void)user;
    (void)x;
    (void)y;
    *out = (pov_box){ pov_vec3_of(6, -1, -1), pov_vec3_of(8, 1, 1) };
    return true;
}

static app ready(const pov_camera *c)
{
    static const pov_box box = { { -3, -2, -1 }, { 5, 2, 1 } };
    app a;

    app_init(&a, 800, 600, NULL, NULL);
    a.extent = unit_around_seven;
    app_set_scene(&a, c, 10.0, 20.0, &box);
    app_update(&a, 0.0, true);
    return a;
}

static void type(app *a, int code)
{
    app_event e = { APP_CHARACTER, code, true, 0.0, 0.0, 1.0 };

    app_take(a, &e, 1.0);
}

/* How far from the middle the furthest corner of the box is seen; 1: on the picture's edge. */
static double furthest(const app *a, const pov_box *box)
{
    pov_camera c = app_camera(a);
    double most = 0.0;

    for (int i = 0; i < 8; i++) {
        pov_vec3 p = pov_sub(pov_vec3_of(i & 1 ? box->hi.x : box->lo.x, i & 2 ? box->hi.y : box->lo.y,
                                         i & 4 ? box->hi.z : box->lo.z), c.location);
        double ahead = c.type == POV_CAMERA_ORTHOGRAPHIC ? 1.0 : pov_dot(p, c.direction) / pov_dot(c.direction, c.direction);

        assert_true(ahead > 0.0);
        most = fmax(most, fabs(pov_dot(p, c.right)) / pov_dot(c.right, c.right) / ahead * 2.0);
        most = fmax(most, fabs(pov_dot(p, c.up)) / pov_dot(c.up, c.up) / ahead * 2.0);
    }
    return most;
}

static void keys_have_one_row_each(void **state)
{
    const keys_row *row;

    (void)state;
    for (int i = 0; (row = keys_get(i)); i++)
        for (int k = 0; k < 4 && row->codes[k]; k++)
            assert_ptr_equal(keys_find(row->codes[k]), row);
    assert_ptr_equal(keys_find('F'), keys_find('f'));
    assert_null(keys_find(0));
    assert_null(keys_find('~'));
}

static char *whole_file(const char *path)
{
    char *text = calloc(1, 100000);
    FILE *f = fopen(path, "r");

    assert_non_null(text);
    assert_non_null(f);
    assert_true(fread(text, 1, 99999, f) > 0);
    fclose(f);
    return text;
}

static void keys_are_in_the_pages(void **state)
{
    char *page = whole_file("docs/viewer.md"), *man = whole_file("docs/man/povview.1"), line[200];
    const keys_row *row;

    (void)state;
    for (int i = 0; (row = keys_get(i)); i++) {
        snprintf(line, sizeof line, "\n| %s | %s |\n", row->names, row->help);
        if (!strstr(page, line))
            fail_msg("docs/viewer.md lacks%s", line);
        snprintf(line, sizeof line, "\n.TP\n%s\n", row->names);
        if (!strstr(man, line))
            fail_msg("docs/man/povview.1 lacks%s", line);
    }
    free(page);
    free(man);
}

static void keys_frame_all_and_one(void **state)
{
    const pov_box one = { { 6, -1, -1 }, { 8, 1, 1 } };
    pov_camera c = camera();
    app a = ready(&c);

    (void)state;
    for (int turn = 0; turn < 2; turn++) {
        type(&a, 'a');
        assert_true(furthest(&a, &a.box) <= 1.0);
        assert_true(furthest(&a, &a.box) > 0.8);
        assert_near(orbit_pivot(&a.orbit).x, 1.0, 1e-12);
        type(&a, 'F');
        assert_true(furthest(&a, &one) <= 1.0);
        assert_true(furthest(&a, &one) > 0.8);
        assert_near(orbit_pivot(&a.orbit).x, 7.0, 1e-12);
        assert_true(app_update(&a, 2.0, true) & APP_RESTART);
        c.type = POV_CAMERA_ORTHOGRAPHIC;
        a = ready(&c);
    }
}

static void keys_frame_nothing_where_nothing_is(void **state)
{
    pov_camera c = camera();
    app a = ready(&c);

    (void)state;
    a.has_box = false;
    type(&a, 'a');
    assert_string_equal(a.note, "nothing here has an end");
    assert_true(app_camera(&a).location.z == -10.0);
    a.extent = NULL;
    type(&a, 'f');
    assert_string_equal(a.note, "nothing is under the pointer");
}

static void keys_change_the_field_of_view_and_not_the_place(void **state)
{
    pov_camera c = camera();
    app a = ready(&c);

    (void)state;
    type(&a, ',');
    assert_string_equal(a.note, "72.5\xc2\xb0 across");
    assert_near(app_camera(&a).direction.z, 1.0 / 1.1, 1e-15);
    assert_true(app_camera(&a).location.z == -10.0);
    assert_near(orbit_pivot(&a.orbit).z, 0.0, 1e-14);
    type(&a, '.');
    assert_near(app_camera(&a).direction.z, 1.0, 1e-15);
    for (int i = 0; i < 1000; i++)
        type(&a, ',');
    assert_string_equal(a.note, "176.2\xc2\xb0 across");
    for (int i = 0; i < 1000; i++)
        type(&a, '.');
    assert_string_equal(a.note, "0.1\xc2\xb0 across");
}

static void keys_widen_parallel_rays_but_no_fisheye(void **state)
{
    pov_camera c = camera();
    app a;

    (void)state;
    c.type = POV_CAMERA_ORTHOGRAPHIC;
    a = ready(&c);
    type(&a, ',');
    assert_near(app_camera(&a).up.y, 1.1, 1e-15);
    assert_near(app_camera(&a).right.x, 1.1 * 4.0 / 3.0, 1e-15);
    c.type = POV_CAMERA_FISHEYE;
    a = ready(&c);
    type(&a, ',');
    assert_string_equal(a.note, "a camera of this kind keeps its field of view");
    assert_false(app_update(&a, 1.0, true) & APP_RESTART);
}

static void keys_scroll_the_help_within_its_ends(void **state)
{
    app_event wheel = { APP_WHEEL, 0, false, 0.0, -1.0, 1.0 };
    pov_camera c = camera();
    app a = ready(&c);

    (void)state;
    type(&a, APP_KEY_DOWN);
    assert_true(a.help_from == 0.0);
    type(&a, 'h');
    app_fit_help(&a, 100.0);
    app_update(&a, 2.0, true);
    app_take(&a, &wheel, 2.0);
    assert_true(a.help_from == 54.0);
    assert_int_equal(app_update(&a, 2.0, true), APP_DRAW);
    assert_true(app_camera(&a).location.z == -10.0);
    type(&a, APP_KEY_PAGE_DOWN);
    assert_true(a.help_from == 100.0);
    type(&a, APP_KEY_UP);
    assert_true(a.help_from == 82.0);
    app_fit_help(&a, 20.0);
    assert_true(a.help_from == 20.0);
    /* Where all of it is seen, the wheel is the camera's. */
    app_fit_help(&a, 0.0);
    assert_true(a.help_from == 0.0);
    app_take(&a, &wheel, 9.0);
    assert_true(app_camera(&a).location.z < -10.0);
}

static void keys_want_the_whole_screen_and_give_it_back(void **state)
{
    pov_camera c = camera();
    app a = ready(&c);

    (void)state;
    type(&a, APP_KEY_F11);
    assert_true(a.full && (app_update(&a, 2.0, true) & APP_FULL));
    type(&a, APP_KEY_F11);
    assert_true(!a.full && (app_update(&a, 2.0, true) & APP_FULL));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(keys_have_one_row_each),
        cmocka_unit_test(keys_are_in_the_pages),
        cmocka_unit_test(keys_frame_all_and_one),
        cmocka_unit_test(keys_frame_nothing_where_nothing_is),
        cmocka_unit_test(keys_change_the_field_of_view_and_not_the_place),
        cmocka_unit_test(keys_widen_parallel_rays_but_no_fisheye),
        cmocka_unit_test(keys_scroll_the_help_within_its_ends),
        cmocka_unit_test(keys_want_the_whole_screen_and_give_it_back),
    };

    return cmocka_run_group_tests_name("the viewer's keys", tests, NULL, NULL);
}
