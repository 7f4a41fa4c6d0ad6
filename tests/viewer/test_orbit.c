/* Where the camera goes, without a window. */
#include "camera_text.h"
#include "orbit.h"
#include "support/check.h"
#include "support/near.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double TIGHT = 1e-12;

static pov_camera camera_at(double x, double y, double z)
{
    pov_camera c = POV_INIT(c);

    c.location = pov_vec3_of(x, y, z);
    c.direction = pov_vec3_of(0, 0, 1);
    c.right = pov_vec3_of(4.0 / 3.0, 0, 0);
    c.up = pov_vec3_of(0, 1, 0);
    return c;
}

/* Ten behind the origin, looking along z at it. */
static orbit plain(void)
{
    pov_camera c = camera_at(0, 0, -10);
    orbit o;

    orbit_init(&o, &c, 10.0, 4.0 / 3.0);
    return o;
}

static void assert_vector(pov_vec3 v, double x, double y, double z, double tolerance)
{
    assert_near(v.x, x, tolerance);
    assert_near(v.y, y, tolerance);
    assert_near(v.z, z, tolerance);
}

static double length(pov_vec3 v)
{
    return sqrt(pov_dot(v, v));
}

static void assert_square(const orbit *o)
{
    pov_camera c = orbit_camera(o);

    assert_near(pov_dot(c.direction, c.right), 0.0, TIGHT);
    assert_near(pov_dot(c.direction, c.up), 0.0, TIGHT);
    assert_near(pov_dot(c.right, c.up), 0.0, TIGHT);
    assert_near(length(c.direction), 1.0, TIGHT);
    assert_near(length(c.right), 4.0 / 3.0, TIGHT);
    assert_near(length(c.up), 1.0, TIGHT);
}

/* Where a point is seen, in parts of the picture from its middle to the right and up. */
static void seen_at(const orbit *o, pov_vec3 point, double *right, double *up)
{
    pov_camera c = orbit_camera(o);
    pov_vec3 way = pov_sub(point, c.location);
    double ahead = pov_dot(way, c.direction) / pov_dot(c.direction, c.direction);

    *right = pov_dot(way, c.right) / pov_dot(c.right, c.right) / ahead;
    *up = pov_dot(way, c.up) / pov_dot(c.up, c.up) / ahead;
}

static void orbit_turns_about_its_pivot_at_the_same_distance(void **state)
{
    orbit o = plain();

    (void)state;
    orbit_turn(&o, 0.2, 0.1);
    assert_vector(orbit_pivot(&o), 0, 0, 0, 1e-11);
    assert_near(length(o.camera.location), 10.0, 1e-11);
    assert_square(&o);
    assert_near(o.camera.right.y, 0.0, TIGHT);
}

static void orbit_turns_what_is_near_with_the_pointer(void **state)
{
    orbit o = plain();
    double right, up;

    (void)state;
    orbit_turn(&o, 0.1, 0.0);
    assert_true(o.camera.location.x < 0.0);
    seen_at(&o, pov_vec3_of(0, 0, -1), &right, &up);
    assert_true(right > 0.01);
    o = plain();
    orbit_turn(&o, 0.0, 0.1);
    assert_true(o.camera.location.y > 0.0);
    seen_at(&o, pov_vec3_of(0, 0, -1), &right, &up);
    assert_true(up < -0.01);
}

static void orbit_half_a_turn_is_the_height_of_the_picture(void **state)
{
    orbit o = plain();

    (void)state;
    orbit_turn(&o, 0.75, 0.0);
    assert_vector(o.camera.location, 0, 0, 10, 1e-11);
}

static void orbit_does_not_tip_over(void **state)
{
    orbit o = plain();

    (void)state;
    orbit_turn(&o, 0.0, 3.0);
    assert_true(o.camera.location.y > 9.9 && o.camera.up.y > 0.0);
    orbit_turn(&o, 0.3, -9.0);
    assert_true(o.camera.location.y < -9.9 && o.camera.up.y > 0.0);
    assert_square(&o);
}

static void orbit_wears_no_lengths_in_a_million_turns(void **state)
{
    orbit o = plain();

    (void)state;
    for (int i = 0; i < 1000000; i++)
        orbit_turn(&o, 0.013, i % 2 ? 0.02 : -0.02);
    assert_near(length(o.camera.direction), 1.0, 1e-9);
    assert_near(length(o.camera.up), 1.0, 1e-9);
    assert_near(pov_dot(o.camera.right, o.camera.up), 0.0, 1e-9);
}

static void orbit_pan_keeps_the_pivot_under_the_pointer(void **state)
{
    orbit o = plain();
    double right, up;

    (void)state;
    orbit_turn(&o, 0.1, 0.1);
    orbit_pan(&o, 0.25, 0.125);
    seen_at(&o, pov_vec3_of(0, 0, 0), &right, &up);
    assert_near(right, 0.25, 1e-10);
    assert_near(up, -0.125, 1e-10);
}

static void orbit_dolly_keeps_what_is_under_the_pointer_there(void **state)
{
    orbit o = plain();
    pov_vec3 target = pov_add(o.camera.location, pov_scale(orbit_ray(&o, 0.8, 0.3), 7.0));
    double right, up;

    (void)state;
    orbit_dolly(&o, 0.8, 0.3, 7.0, 5.0);
    seen_at(&o, target, &right, &up);
    assert_near(right, 0.3, 1e-10);
    assert_near(up, 0.2, 1e-10);
    assert_near(length(pov_sub(target, o.camera.location)), 7.0 * pow(0.9, 5) * length(orbit_ray(&o, 0.8, 0.3)), 1e-10);
}

static void orbit_dolly_back_undoes_dolly(void **state)
{
    orbit o = plain();

    (void)state;
    orbit_dolly(&o, 0.8, 0.3, 7.0, 3.0);
    orbit_dolly(&o, 0.8, 0.3, 7.0 * pow(0.9, 3), -3.0);
    assert_vector(o.camera.location, 0, 0, -10, 1e-12);
    assert_near(o.reach, 10.0, 1e-12);
}

static void orbit_looks_and_flies_from_its_own_place(void **state)
{
    orbit o = plain();

    (void)state;
    orbit_look(&o, 0.5, 0.0);
    assert_vector(o.camera.location, 0, 0, -10, TIGHT);
    assert_true(o.camera.direction.x > 0.1);
    orbit_fly(&o, 0.0, 0.0, 2.0);
    assert_near(length(pov_sub(o.camera.location, pov_vec3_of(0, 0, -10))), 2.0, TIGHT);
    assert_true(o.camera.location.x > 0.1 && o.camera.location.z > -10.0);
    o = plain();
    orbit_fly(&o, 1.0, 2.0, -3.0);
    assert_vector(o.camera.location, 1, 2, -13, TIGHT);
}

static void orbit_faces_along_the_axes(void **state)
{
    orbit o = plain();

    (void)state;
    orbit_turn(&o, 0.3, 0.2);
    orbit_face(&o, ORBIT_FRONT);
    assert_vector(o.camera.location, 0, 0, -10, 1e-11);
    assert_vector(o.camera.right, 4.0 / 3.0, 0, 0, TIGHT);
    orbit_face(&o, ORBIT_RIGHT);
    assert_vector(o.camera.location, 10, 0, 0, 1e-11);
    assert_vector(o.camera.right, 0, 0, 4.0 / 3.0, TIGHT);
    orbit_face(&o, ORBIT_TOP);
    assert_vector(o.camera.location, 0, 10, 0, 1e-11);
    assert_vector(o.camera.up, 0, 0, 1, TIGHT);
    orbit_turn(&o, 0.1, -0.1);
    assert_square(&o);
}

static void orbit_finds_z_up(void **state)
{
    pov_camera c = camera_at(0, -10, 0);
    orbit o;

    (void)state;
    c.direction = pov_vec3_of(0, 1, 0);
    c.up = pov_vec3_of(0, 0, 1);
    orbit_init(&o, &c, 10.0, 4.0 / 3.0);
    assert_vector(o.sky, 0, 0, 1, 0.0);
    orbit_turn(&o, 0.2, 0.1);
    assert_near(o.camera.right.z, 0.0, TIGHT);
    orbit_face(&o, ORBIT_TOP);
    assert_vector(o.camera.location, 0, 0, 10, 1e-11);
}

static void orbit_of_a_mirrored_camera_follows_the_pointer_too(void **state)
{
    pov_camera c = camera_at(0, 0, -10);
    orbit o;
    double right, up;

    (void)state;
    c.right.x = -c.right.x;
    orbit_init(&o, &c, 10.0, 4.0 / 3.0);
    orbit_turn(&o, 0.1, 0.1);
    seen_at(&o, pov_vec3_of(0, 0, -1), &right, &up);
    assert_true(right > 0.01);
    assert_true(up < -0.01);
}

static void orbit_returns_home_bit_for_bit(void **state)
{
    orbit o = plain();
    pov_camera home = o.home;

    (void)state;
    orbit_turn(&o, 0.3, 0.2);
    orbit_pan(&o, 0.1, 0.1);
    assert_true(o.moved);
    orbit_reset(&o);
    assert_false(o.moved);
    assert_memory_equal(&o.camera, &home, sizeof home);
}

static void orbit_keeps_a_moved_camera_and_no_other_when_the_scene_changes(void **state)
{
    orbit o = plain();
    pov_camera other = camera_at(5, 5, 5), here;

    (void)state;
    orbit_set_home(&o, &other, 3.0, 4.0 / 3.0);
    assert_vector(o.camera.location, 5, 5, 5, 0.0);
    orbit_turn(&o, 0.1, 0.0);
    here = o.camera;
    other = camera_at(1, 2, 3);
    orbit_set_home(&o, &other, 3.0, 4.0 / 3.0);
    assert_memory_equal(&o.camera, &here, sizeof here);
    orbit_reset(&o);
    assert_vector(o.camera.location, 1, 2, 3, 0.0);
}

static void orbit_shows_more_at_the_sides_of_a_wider_window(void **state)
{
    orbit o = plain();

    (void)state;
    orbit_fit(&o, 800, 600);
    assert_true(orbit_camera(&o).right.x == o.home.right.x);
    orbit_fit(&o, 1600, 600);
    assert_near(orbit_camera(&o).right.x, 8.0 / 3.0, TIGHT);
    assert_true(orbit_camera(&o).up.y == 1.0);
    orbit_fit(&o, 0, 600);
    assert_near(orbit_camera(&o).right.x, 8.0 / 3.0, TIGHT);
}

/* ---- a camera as text ---- */

static pov_camera read_back(const char *camera, const char *before)
{
    pov_context *context = scenes_context();
    pov_camera c = POV_INIT(c);
    char text[2048];
    pov_scene *scene;

    snprintf(text, sizeof text, "%s sphere { <0, 0, 0>, 1 }\n%s", before, camera);
    scene = scenes_text(context, text);
    pov_scene_get_camera(scene, &c);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return c;
}

static void camera_text_reads_back_bit_for_bit_in_the_povray_dialect(void **state)
{
    orbit o = plain();
    pov_camera c, again;
    char text[1024];

    (void)state;
    orbit_turn(&o, 0.21, 0.13);
    orbit_dolly(&o, 0.3, 0.4, 3.0, 2.0);
    c = orbit_camera(&o);
    camera_text_exact(&c, text, sizeof text);
    again = read_back(text, "#version 3.7;");
    assert_memory_equal(&again.location, &c.location, sizeof c.location);
    assert_memory_equal(&again.direction, &c.direction, sizeof c.direction);
    assert_memory_equal(&again.right, &c.right, sizeof c.right);
    assert_memory_equal(&again.up, &c.up, sizeof c.up);
}

static void camera_text_keeps_the_course_dialect(void **state)
{
    orbit o = plain();
    pov_camera c, again;
    char text[1024];

    (void)state;
    o.home.direction = o.camera.direction = pov_vec3_of(0, 0, 1.7);
    orbit_turn(&o, 0.21, 0.13);
    c = orbit_camera(&o);
    camera_text(&c, POV_DIALECT_COURSE, o.reach, text, sizeof text);
    assert_null(strstr(text, "direction"));
    again = read_back(text, "");
    assert_vector(again.location, c.location.x, c.location.y, c.location.z, 1e-4);
    assert_vector(again.direction, c.direction.x, c.direction.y, c.direction.z, 5e-5);
    assert_vector(again.right, c.right.x, c.right.y, c.right.z, 5e-5);
    assert_vector(again.up, c.up.x, c.up.y, c.up.z, 5e-5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orbit_turns_about_its_pivot_at_the_same_distance),
        cmocka_unit_test(orbit_turns_what_is_near_with_the_pointer),
        cmocka_unit_test(orbit_half_a_turn_is_the_height_of_the_picture),
        cmocka_unit_test(orbit_does_not_tip_over),
        cmocka_unit_test(orbit_wears_no_lengths_in_a_million_turns),
        cmocka_unit_test(orbit_pan_keeps_the_pivot_under_the_pointer),
        cmocka_unit_test(orbit_dolly_keeps_what_is_under_the_pointer_there),
        cmocka_unit_test(orbit_dolly_back_undoes_dolly),
        cmocka_unit_test(orbit_looks_and_flies_from_its_own_place),
        cmocka_unit_test(orbit_faces_along_the_axes),
        cmocka_unit_test(orbit_finds_z_up),
        cmocka_unit_test(orbit_of_a_mirrored_camera_follows_the_pointer_too),
        cmocka_unit_test(orbit_returns_home_bit_for_bit),
        cmocka_unit_test(orbit_keeps_a_moved_camera_and_no_other_when_the_scene_changes),
        cmocka_unit_test(orbit_shows_more_at_the_sides_of_a_wider_window),
        cmocka_unit_test(camera_text_reads_back_bit_for_bit_in_the_povray_dialect),
        cmocka_unit_test(camera_text_keeps_the_course_dialect),
    };

    return cmocka_run_group_tests_name("the viewer's camera", tests, NULL, NULL);
}
