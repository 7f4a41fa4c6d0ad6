/* The camera that C copies: short to read, and near enough when read back. */
#include "camera_text.h"
#include "orbit.h"
#include "support/check.h"
#include "support/near.h"
#include "support/scenes.h"

#include <stdio.h>
#include <string.h>

static orbit orbit_of(pov_camera_type type, pov_vec3 right, pov_vec3 up)
{
    pov_camera c = POV_INIT(c);
    orbit o;

    c.location = pov_vec3_of(0, 0, -10);
    c.direction = pov_vec3_of(0, 0, 1);
    c.right = right;
    c.up = up;
    c.type = type;
    c.angles[0] = 2.0;
    c.angles[1] = 1.0;
    orbit_init(&o, &c, 10.0, 4.0 / 3.0);
    return o;
}

static pov_camera read_back(const char *camera)
{
    pov_context *context = scenes_context();
    pov_camera c = POV_INIT(c);
    char text[2048];
    pov_scene *scene;

    snprintf(text, sizeof text, "#version 3.7; sphere { <0, 0, 0>, 1 }\n%s", camera);
    scene = scenes_text(context, text);
    pov_scene_get_camera(scene, &c);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return c;
}

/* A thousandth of a pixel of a thousand, and ten times that for the place of what is in the middle. */
static void assert_same_view(const pov_camera *a, const pov_camera *b)
{
    const double near = 5e-5, whole = 10.0;

    assert_int_equal(a->type, b->type);
    assert_near(pov_largest(pov_sub(a->location, b->location)), 0.0, 1e-4 * whole);
    assert_near(pov_largest(pov_sub(a->direction, b->direction)), 0.0, near);
    assert_near(pov_largest(pov_sub(a->right, b->right)), 0.0, near);
    assert_near(pov_largest(pov_sub(a->up, b->up)), 0.0, near);
}

static void assert_round(orbit o)
{
    pov_camera c, again;
    char text[1024];

    orbit_turn(&o, 0.21, 0.13);
    orbit_pan(&o, 0.1, 0.2);
    c = orbit_camera(&o);
    camera_text(&c, POV_DIALECT_POVRAY, o.reach, text, sizeof text);
    assert_non_null(strstr(text, "look_at"));
    again = read_back(text);
    assert_same_view(&again, &c);
    for (const char *line = text; *line; line += strcspn(line, "\n") + 1)
        assert_true(strcspn(line, "\n") < 50);
}

static void defect_14_camera_text_is_for_people(void **state)
{
    orbit o = orbit_of(POV_CAMERA_PERSPECTIVE, pov_vec3_of(4.0 / 3.0, 0, 0), pov_vec3_of(0, 1, 0));
    pov_camera c = orbit_camera(&o);
    char text[1024];

    (void)state;
    c.location.x = 1.0 / 3.0;
    c.location.y = -1e-9;
    camera_text(&c, POV_DIALECT_POVRAY, o.reach, text, sizeof text);
    assert_string_equal(text, "camera {\n    location <0.3333, 0, -10>\n    right x * 1.33333\n"
                              "    angle 67.3801\n    look_at <0.3333, 0, 0>\n}\n");
    c.location.y = 123456.75;
    camera_text(&c, POV_DIALECT_POVRAY, 1e7, text, sizeof text);
    assert_non_null(strstr(text, "location <0, 123457, -10>"));
}

static void camera_text_reads_back_as_the_same_view(void **state)
{
    const pov_vec3 right = pov_vec3_of(4.0 / 3.0, 0, 0), up = pov_vec3_of(0, 1, 0);

    (void)state;
    assert_round(orbit_of(POV_CAMERA_PERSPECTIVE, right, up));
    assert_round(orbit_of(POV_CAMERA_PERSPECTIVE, pov_scale(right, -1.0), up));
    assert_round(orbit_of(POV_CAMERA_PERSPECTIVE, right, pov_scale(up, 0.75)));
    assert_round(orbit_of(POV_CAMERA_PERSPECTIVE, pov_vec3_of(0.8, 0.6, 0), pov_vec3_of(-0.6, 0.8, 0)));
    assert_round(orbit_of(POV_CAMERA_ORTHOGRAPHIC, pov_scale(right, 5.0), pov_scale(up, 5.0)));
    assert_round(orbit_of(POV_CAMERA_FISHEYE, right, up));
    assert_round(orbit_of(POV_CAMERA_SPHERICAL, right, up));
    assert_round(orbit_of(POV_CAMERA_CYLINDER_3, right, up));
}

static void camera_text_keeps_angles_and_lens(void **state)
{
    orbit o = orbit_of(POV_CAMERA_SPHERICAL, pov_vec3_of(4.0 / 3.0, 0, 0), pov_vec3_of(0, 1, 0));
    pov_camera c = orbit_camera(&o), again;
    char text[1024];

    (void)state;
    camera_text(&c, POV_DIALECT_POVRAY, o.reach, text, sizeof text);
    again = read_back(text);
    assert_near(again.angles[0], 2.0, 1e-5);
    assert_near(again.angles[1], 1.0, 1e-5);
    c.type = POV_CAMERA_PERSPECTIVE;
    c.lens_radius = 0.125;
    c.focal_distance = 8.0;
    c.lens_samples = 40;
    camera_text(&c, POV_DIALECT_POVRAY, o.reach, text, sizeof text);
    again = read_back(text);
    assert_near(again.lens_radius, 0.125, 1e-6);
    assert_near(again.focal_distance, 8.0, 1e-4);
    assert_int_equal(again.lens_samples, 40);
}

static void camera_text_of_a_skewed_camera_is_exact(void **state)
{
    orbit o = orbit_of(POV_CAMERA_PERSPECTIVE, pov_vec3_of(4.0 / 3.0, 0, 0.1), pov_vec3_of(0, 1, 0));
    pov_camera c = orbit_camera(&o), again;
    char text[1024];

    (void)state;
    camera_text(&c, POV_DIALECT_POVRAY, o.reach, text, sizeof text);
    assert_null(strstr(text, "look_at"));
    again = read_back(text);
    assert_memory_equal(&again.right, &c.right, sizeof c.right);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defect_14_camera_text_is_for_people),
        cmocka_unit_test(camera_text_reads_back_as_the_same_view),
        cmocka_unit_test(camera_text_keeps_angles_and_lens),
        cmocka_unit_test(camera_text_of_a_skewed_camera_is_exact),
    };

    return cmocka_run_group_tests_name("the viewer's camera as text", tests, NULL, NULL);
}
