/* sdl/parse_camera: from what is written to the frame, in both dialects. */
#include "support/check.h"
#include "support/reading.h"

#include <math.h>
#include <string.h>

static pov_camera read_camera(const char *text, pov_dialect dialect)
{
    reader_options options = { .dialect = dialect, .max_trace_level = 0 };
    reading r;
    pov_camera camera;

    reading_begin_bytes(&r, text, strlen(text), &options, NULL);
    if (r.status != POV_OK)
        fail_msg("%s: %s", text, r.error.message);
    camera = r.model.camera;
    reading_end(&r);
    return camera;
}

static void assert_near(const char *what, pov_vec3 v, double x, double y, double z)
{
    double size = fmax(fmax(fabs(x), fabs(y)), fabs(z));

    if (!(pov_largest(pov_sub(v, pov_vec3_of(x, y, z))) <= 4e-16 * size))
        fail_msg("%s is <%.17g, %.17g, %.17g>, not <%.17g, %.17g, %.17g>", what, v.x, v.y, v.z, x, y, z);
}

static void assert_frame(pov_camera c, const double d[3], const double r[3], const double u[3])
{
    assert_int_equal(c.size, sizeof c);
    assert_near("direction", c.direction, d[0], d[1], d[2]);
    assert_near("right", c.right, r[0], r[1], r[2]);
    assert_near("up", c.up, u[0], u[1], u[2]);
}

#define V(x, y, z) ((const double[3]){x, y, z})

static void without_a_camera_the_view_is_along_z(void **state)
{
    (void)state;
    assert_frame(read_camera("sphere { 0, 1 }", POV_DIALECT_AUTO), V(0, 0, 1), V(1.33333, 0, 0), V(0, 1, 0));
    assert_frame(read_camera("sphere { 0, 1 hollow }", POV_DIALECT_AUTO), V(0, 0, 1), V(1.33, 0, 0),
                 V(0, 1, 0));
    assert_frame(read_camera("camera { }", POV_DIALECT_COURSE), V(0, 0, 1), V(1.33333, 0, 0), V(0, 1, 0));
    assert_frame(read_camera("camera { }", POV_DIALECT_POVRAY), V(0, 0, 1), V(1.33, 0, 0), V(0, 1, 0));
}

static void both_dialects_look_at_a_point_alike(void **state)
{
    const char *text = "camera { look_at <1, 2, 3> up <0, 1, 0> right <2, 0, 0> location <-2, 2, -1> }";
    const double s = 1.0 / sqrt(25.0);
    pov_camera c;
    int dialect;

    (void)state;
    for (dialect = POV_DIALECT_COURSE; dialect <= POV_DIALECT_POVRAY; dialect++) {
        c = read_camera(text, (pov_dialect)dialect);
        assert_near("location", c.location, -2, 2, -1);
        assert_frame(c, V(3 * s, 0, 4 * s), V(2 * 4 * s, 0, -2 * 3 * s), V(0, 1, 0));
    }
}

static void the_angle_is_the_horizontal_one(void **state)
{
    (void)state;
    assert_frame(read_camera("camera { angle 90 right <2, 0, 0> look_at <0, 0, 5> }", POV_DIALECT_COURSE),
                 V(0, 0, 1), V(2, 0, 0), V(0, 1, 0));
    assert_frame(read_camera("camera { direction <0, 0, 7> right <3, 0, 0> angle 90 }", POV_DIALECT_POVRAY),
                 V(0, 0, 1.5), V(3, 0, 0), V(0, 1, 0));
}

static void in_the_course_dialect_up_is_the_vertical(void **state)
{
    /* The part of up along the view is subtracted; its length is the picture's height. */
    assert_frame(read_camera("camera { up <0, 3, 4> look_at <0, 0, 9> }", POV_DIALECT_COURSE), V(0, 0, 1),
                 V(1.33333, 0, 0), V(0, 5, 0));
    assert_frame(read_camera("camera { up <1, 0, 0> right <0, 0, 2> look_at <0, 0, 9> }", POV_DIALECT_COURSE),
                 V(0, 0, 1), V(0, -2, 0), V(1, 0, 0));
    (void)state;
}

static void in_the_course_dialect_x_takes_the_place_of_an_up_along_the_view(void **state)
{
    (void)state;
    assert_frame(read_camera("camera { location <0, 5, 0> look_at 0 right <1, 0, 0> }", POV_DIALECT_COURSE),
                 V(0, -1, 0), V(0, 0, -1), V(1, 0, 0));
    assert_frame(read_camera("camera { up <.1, .3, .7> look_at <.2, .6, 1.4> }", POV_DIALECT_COURSE),
                 V(.1 / sqrt(.59), .3 / sqrt(.59), .7 / sqrt(.59)),
                 V(0, -1.33333 * .7 / sqrt(.58), 1.33333 * .3 / sqrt(.58)),
                 V(sqrt(.59) * .58 / sqrt(.58 * .59), -sqrt(.59) * .03 / sqrt(.58 * .59),
                   -sqrt(.59) * .07 / sqrt(.58 * .59)));
    assert_frame(read_camera("camera { up <1, 0, 0> look_at <3, 0, 0> right <1, 0, 0> }", POV_DIALECT_COURSE),
                 V(1, 0, 0), V(0, 0, -1), V(0, 1, 0));
}

static void in_the_povray_dialect_sky_is_the_vertical(void **state)
{
    (void)state;
    assert_frame(read_camera("camera { sky <1, 0, 0> right <2, 0, 0> up <0, 3, 0> look_at <0, 0, 9> }",
                             POV_DIALECT_AUTO),
                 V(0, 0, 1), V(0, -2, 0), V(3, 0, 0));
    assert_frame(read_camera("camera { up <0, 3, 4> look_at <0, 0, 9> }", POV_DIALECT_POVRAY), V(0, 0, 1),
                 V(1.33, 0, 0), V(0, 5, 0));
}

static void in_the_povray_dialect_the_frame_is_free_without_look_at(void **state)
{
    (void)state;
    assert_frame(read_camera("camera { direction <0, 1, 2> right <1, 1, 0> up <0, 2, 0> }", POV_DIALECT_AUTO),
                 V(0, 1, 2), V(1, 1, 0), V(0, 2, 0));
}

static void in_the_povray_dialect_handedness_is_kept(void **state)
{
    (void)state;
    assert_frame(read_camera("camera { right <-1.33, 0, 0> look_at <0, 0, 9> }", POV_DIALECT_POVRAY),
                 V(0, 0, 1), V(-1.33, 0, 0), V(0, 1, 0));
    assert_frame(read_camera("camera { up <0, -1, 0> look_at <0, 0, 9> }", POV_DIALECT_POVRAY), V(0, 0, 1),
                 V(-1.33, 0, 0), V(0, 1, 0));
    assert_frame(read_camera("camera { direction <0, 0, 2> look_at <0, 0, 9> }", POV_DIALECT_POVRAY),
                 V(0, 0, 2), V(1.33, 0, 0), V(0, 1, 0));
}

static void in_the_povray_dialect_right_stays_where_sky_lies_along_the_view(void **state)
{
    (void)state;
    assert_frame(read_camera("camera { look_at <0, 9, 0> }", POV_DIALECT_POVRAY), V(0, 1, 0), V(1.33, 0, 0),
                 V(0, 0, -1));
    assert_frame(read_camera("camera { look_at <0, -9, 0> }", POV_DIALECT_POVRAY), V(0, -1, 0), V(1.33, 0, 0),
                 V(0, 0, 1));
    /* Measured of POV-Ray: it turns the frame by the written right, and then mirrors it as ever. */
    assert_frame(read_camera("camera { right <-2, 0, 0> look_at <0, -9, 0> }", POV_DIALECT_POVRAY), V(0, -1, 0),
                 V(2, 0, 0), V(0, 0, -1));
}

static void transformations_come_last_wherever_they_stand(void **state)
{
    pov_camera c = read_camera(
        "camera { rotate <0, 90, 0> translate <1, 0, 0> location <0, 0, -5> look_at 0 }", POV_DIALECT_COURSE);

    (void)state;
    assert_near("location", c.location, -4, 0, 0);
    assert_frame(c, V(1, 0, 0), V(0, 0, -1.33333), V(0, 1, 0));
    c = read_camera("camera { location <1, 1, 0> scale <2, 1, 1> }", POV_DIALECT_POVRAY);
    assert_near("location", c.location, 2, 1, 0);
    assert_frame(c, V(0, 0, 1), V(2.66, 0, 0), V(0, 1, 0));
}

static void far_and_small_views_keep_their_direction(void **state)
{
    pov_camera c = read_camera("camera { location <1e308, 0, 0> look_at <-1e308, 0, 0> right <1, 0, 0> }",
                               POV_DIALECT_COURSE);

    (void)state;
    assert_frame(c, V(-1, 0, 0), V(0, 0, 1), V(0, 1, 0));
    c = read_camera(
        "camera { location <1e-300, 0, 0> look_at <0, 0, 0> up <0, 1e-200, 0> right <1e200, 0, 0> }",
        POV_DIALECT_COURSE);
    assert_frame(c, V(-1, 0, 0), V(0, 0, 1e200), V(0, 1e-200, 0));
}

static void the_last_camera_wins_with_a_warning(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "camera { location 1 angle 20 }\ncamera { location 2 }");
    assert_true(r.model.camera.location.x == 2.0 && r.model.camera.direction.z == 1.0);
    assert_int_equal(r.model.warnings, 1);
    assert_int_equal(r.notes[0].line, 2);
    reading_end(&r);
}

static void assert_size(const char *text, double width, double height)
{
    const pov_camera c = read_camera(text, POV_DIALECT_POVRAY);

    assert_int_equal(c.type, POV_CAMERA_ORTHOGRAPHIC);
    if (!(fabs(sqrt(pov_dot(c.right, c.right)) - width) < 1e-14 * width &&
          fabs(sqrt(pov_dot(c.up, c.up)) - height) < 1e-14 * height))
        fail_msg("%s: right is <%g, %g, %g> and up <%g, %g, %g>, not %g and %g long", text, c.right.x, c.right.y, c.right.z,
                 c.up.x, c.up.y, c.up.z, width, height);
}

static void an_orthographic_camera_sees_as_much_as_the_language_says(void **state)
{
    const double a = 2.0 * 5.0 * tan(3.14159265358979323846 / 9.0);

    (void)state;
    assert_size("camera { orthographic location <3, 4, 0> look_at 0 }", 1.33 * 5, 5);
    assert_size("camera { location <3, 4, 0> direction 2*z look_at 0 orthographic }", 1.33 * 2.5, 2.5);
    assert_size("camera { orthographic location <0, 0, -3> }", 1.33 * 4, 4);
    assert_size("camera { orthographic location <3, 4, 0> look_at 0 right x*8 }", 8, 1);
    assert_size("camera { orthographic location <3, 4, 0> look_at 0 up y*3 }", 1.33, 3);
    assert_size("camera { orthographic location <3, 4, 0> look_at 0 angle 40 }", a, a / 1.33);
    assert_size("camera { orthographic location <3, 4, 0> look_at 0 angle 40 right 2*x up 3*y }", a, a * 1.5);
    assert_size("camera { orthographic location <3, 4, 0> look_at 0 right x*8 up y*6 scale 2 }", 16, 12);
    assert_size("#version 3.1; camera { orthographic location <3, 4, 0> look_at 0 angle 40 }", 1.33, 1);
    assert_size("camera { orthographic angle right 8*x up 6*y location <3, 4, 0> look_at 0 }", 40, 30);
    assert_size("camera { orthographic location <3, 4, 0> right 8*x angle direction 2*z look_at 0 }", 20, 2.5);
    assert_size("camera { orthographic angle location <3, 4, 0> look_at 0 angle 40 }", a, a / 1.33);
    assert_int_equal(read_camera("camera { orthographic perspective }", POV_DIALECT_POVRAY).type, POV_CAMERA_PERSPECTIVE);
}

/* POV-Ray's pictures of a plane whose colours are its coordinates. */
static void before_version_3_5_a_camera_is_read_in_its_order(void **state)
{
    const double t = tan(3.14159265358979323846 / 7.2);
    pov_camera c;

    (void)state;
    c = read_camera("#version 3.1; camera { angle 50 direction 2*z location -6*z look_at 0 }", POV_DIALECT_AUTO);
    assert_frame(c, V(0, 0, 2), V(1.33, 0, 0), V(0, 1, 0));
    c = read_camera("#version 3.1; camera { angle 50 right 3*x location -6*z look_at 0 }", POV_DIALECT_AUTO);
    assert_frame(c, V(0, 0, .665 / t), V(3, 0, 0), V(0, 1, 0));
    c = read_camera("#version 3.1; camera { location <6, 0, 0> look_at 0 direction 2*z up 3*y }", POV_DIALECT_AUTO);
    assert_frame(c, V(0, 0, 2), V(0, 0, 1.33), V(0, 3, 0));
    c = read_camera("#version 3.5; camera { location <6, 0, 0> look_at 0 direction 2*z up 3*y }", POV_DIALECT_AUTO);
    assert_frame(c, V(-2, 0, 0), V(0, 0, 1.33), V(0, 3, 0));
    c = read_camera("camera { location <6, 0, 0> look_at 0 } #version 3.1;", POV_DIALECT_AUTO);
    assert_frame(c, V(-1, 0, 0), V(0, 0, 1.33), V(0, 1, 0));
    c = read_camera("#version 3.1; #declare C = camera { location <6, 0, 0> look_at 0 direction 2*z }"
                    "#version 3.7; camera { C }", POV_DIALECT_AUTO);
    assert_frame(c, V(0, 0, 2), V(0, 0, 1.33), V(0, 1, 0));
    assert_size("#version 3.1; camera { orthographic location -6*z look_at 0 }", 1.33, 1);
    assert_size("#version 3.1; camera { location -6*z orthographic look_at 0 }", 1.33 * 7, 7);
    assert_size("#version 3.1; camera { location -6*z angle 50 look_at 0 orthographic }", 12 * t, 12 * t / 1.33);
    assert_size("#version 3.1; camera { location -6*z look_at 0 orthographic right 3*x up 2*y }", 3, 2);
    assert_size("#version 3.1; camera { right 4*x up 3*y location -6*z orthographic }", 28, 21);
}

static void of_two_numbers_of_blur_samples_the_last_counts(void **state)
{
    (void)state;
    assert_int_equal(read_camera("camera { aperture .4 blur_samples 7 }", POV_DIALECT_POVRAY).lens_samples, 7);
    assert_int_equal(read_camera("camera { aperture .4 blur_samples 3, 9 }", POV_DIALECT_POVRAY).lens_samples, 9);
    assert_int_equal(read_camera("camera { aperture .4 blur_samples 3 9 variance 0 }", POV_DIALECT_POVRAY).lens_samples, 9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_a_camera_the_view_is_along_z),
        cmocka_unit_test(both_dialects_look_at_a_point_alike),
        cmocka_unit_test(the_angle_is_the_horizontal_one),
        cmocka_unit_test(in_the_course_dialect_up_is_the_vertical),
        cmocka_unit_test(in_the_course_dialect_x_takes_the_place_of_an_up_along_the_view),
        cmocka_unit_test(in_the_povray_dialect_sky_is_the_vertical),
        cmocka_unit_test(in_the_povray_dialect_the_frame_is_free_without_look_at),
        cmocka_unit_test(in_the_povray_dialect_handedness_is_kept),
        cmocka_unit_test(in_the_povray_dialect_right_stays_where_sky_lies_along_the_view),
        cmocka_unit_test(transformations_come_last_wherever_they_stand),
        cmocka_unit_test(far_and_small_views_keep_their_direction),
        cmocka_unit_test(an_orthographic_camera_sees_as_much_as_the_language_says),
        cmocka_unit_test(before_version_3_5_a_camera_is_read_in_its_order),
        cmocka_unit_test(of_two_numbers_of_blur_samples_the_last_counts),
        cmocka_unit_test(the_last_camera_wins_with_a_warning),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
