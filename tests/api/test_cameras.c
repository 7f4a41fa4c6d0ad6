/* Directions of rays that POV-Ray 3.7 gives: cameras whose right is not at their up's right, and cameras that bend rays. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Pixel (1, 3) of 5 x 5 shows the direction of its ray as a colour. */
static const char scene[] =
    "#version 3.7; global_settings { assumed_gamma 1 } camera { %s }\n"
    "sky_sphere { pigment { average pigment_map { [1 function { (x + 1) / 2 } color_map { [0 rgb 0] [1 rgb 3*x] }]\n"
    "[1 function { (y + 1) / 2 } color_map { [0 rgb 0] [1 rgb 3*y] }] [1 function { (z + 1) / 2 } color_map { [0 rgb 0] [1 rgb 3*z] }] } } }";

typedef struct seen { const char *camera; double along[3]; } seen;

static void assert_seen(const seen *row)
{
    char text[768];
    float *picture;

    snprintf(text, sizeof text, scene, row->camera);
    picture = scenes_draw(text, 5, 5, 1, 1);
    for (int i = 0; i < 3; i++) {
        const double along = 2.0 * (double)picture[4 * (3 * 5 + 1) + i] - 1.0;

        if (!(fabs(along - row->along[i]) < 5e-5))
            fail_msg("%s: %d is %f", row->camera, i, along);
    }
    free(picture);
}

static void frames_that_are_mirrored_or_skew(void **state)
{
    static const seen rows[] = {
        { "spherical right -x", { -0.76941, 0.58779, 0.24999 } },
        { "spherical right x look_at <1,2,3> scale <1,.7,2>", { -0.02382, -0.45751, 0.88888 } },
        { "omnimax right <1.2,.3,0> up <.1,1,0>", { -0.51455, -0.29946, 0.80346 } },
    };

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        assert_seen(&rows[i]);
}

/* A dome is cut off by the frame's own axes: it stays as symmetric as it is. */
static void a_skew_dome_is_black_alike_on_both_sides(void **state)
{
    char text[768];
    float *picture;

    (void)state;
    snprintf(text, sizeof text, scene, "omnimax right <1.2,.3,0> up <.1,1,0>");
    picture = scenes_draw(text, 40, 60, 1, 1);
    for (int y = 0; y < 60; y++)
        for (int x = 0; x < 20; x++)
            assert_int_equal((picture[4 * (y * 40 + x) + 2] > 0.0f), (picture[4 * (y * 40 + 39 - x) + 2] > 0.0f));
    free(picture);
}

typedef struct round_picture { const char *camera; int lit; } round_picture;

/* As many pixels see something as in POV-Ray's pictures: the rest is beyond the disc, or below the dome's edge. */
static void round_pictures_are_black_where_povray_s_are(void **state)
{
    static const round_picture rows[] = { { "fisheye right x up y", 1264 }, { "omnimax right x up y", 964 } };

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[256];
        float *picture;
        int lit = 0;

        snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 } background { rgb 1 } camera { %s }", rows[i].camera);
        picture = scenes_draw(text, 40, 40, 1, 1);
        for (int k = 0; k < 40 * 40; k++)
            lit += picture[4 * k] > 0.0f;
        assert_int_equal(lit, rows[i].lit);
        free(picture);
    }
}

#define BENT "angle 100 right x*1.2 up y*.9 normal { waves .3 }"

static void normals_are_looked_up_by_the_camera_s_own_angles(void **state)
{
    static const seen rows[] = {
        { "perspective " BENT, { -0.44598, -0.31511, 0.83774 } },
        { "fisheye " BENT, { -0.58798, -0.32042, 0.74270 } },
        { "omnimax " BENT, { -0.67498, -0.15886, 0.72055 } },
        { "ultra_wide_angle " BENT, { -0.41158, -0.27208, 0.86981 } },
        { "panoramic " BENT, { -0.41335, -0.62216, 0.66488 } },
        { "spherical " BENT, { -0.42165, -0.19118, 0.88638 } },
        { "cylinder 1 " BENT, { -0.42068, -0.19478, 0.88605 } },
        { "cylinder 2 " BENT, { -0.29186, -0.35229, 0.88922 } },
        { "cylinder 3 " BENT, { -0.42730, -0.04591, 0.90295 } },
        { "cylinder 4 " BENT, { -0.10277, -0.36574, 0.92502 } },
    };

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        assert_seen(&rows[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_that_are_mirrored_or_skew),
        cmocka_unit_test(a_skew_dome_is_black_alike_on_both_sides),
        cmocka_unit_test(round_pictures_are_black_where_povray_s_are),
        cmocka_unit_test(normals_are_looked_up_by_the_camera_s_own_angles),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
