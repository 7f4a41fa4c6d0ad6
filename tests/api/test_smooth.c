/* test_smooth.c - normals of smooth shapes are blended in the space of the scene, each of unit length there, as in POV-Ray. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>

/* The hit straight ahead of <x, y, -9>. */
static pov_hit look(const char *object, double x, double y)
{
    char text[1000];
    pov_context *context = scenes_context();
    pov_hit hit = POV_INIT(hit);
    pov_scene *scene;
    pov_tracer *tracer;
    pov_error err;

    snprintf(text, sizeof text, "#version 3.7; camera { location -9*z } %s", object);
    scene = scenes_text(context, text);
    assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
    assert_true(pov_trace_hit(tracer, pov_vec3_of(x, y, -9.0), pov_vec3_of(0.0, 0.0, 1.0), &hit));
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return hit;
}

static bool is_near(pov_vec3 a, pov_vec3 b) { return pov_largest(pov_sub(a, b)) < 1e-12; }

/* Covectors of the map x to 4 x. */
static pov_vec3 stretched(double x, double y, double z) { return pov_unit(pov_vec3_of(x / 4.0, y, z)); }

static void a_smooth_triangle_that_is_stretched(void **state)
{
    const pov_hit hit = look("smooth_triangle { <0,0,0>, <0,0,-1>, <1,0,0>, <1,0,-1>, <0,1,0>, <0,3,-4> scale <4,1,1> }", 1.0, 0.25);
    const pov_vec3 sum = pov_add(pov_add(pov_vec3_of(0.0, 0.0, -0.5), pov_scale(stretched(1, 0, -1), 0.25)),
                                 pov_scale(stretched(0, 3, -4), 0.25));

    (void)state;
    assert_true(is_near(hit.shading_normal, pov_unit(sum)));
}

/* Corners have 16 bits a component, so they are looked at where nothing is stretched; then it is asked that halfway between
 * two of them is the mean of both, as stretched. */
static void a_smooth_height_field_that_is_stretched(void **state)
{
    static const char even[] = "height_field { function 3, 3 { x*x } smooth scale %s translate <%s> rotate -90*x }";
    const double at[2] = { 0.0, 0.5 };
    pov_vec3 corner[2];
    char object[200];
    pov_hit hit;
    int i;

    (void)state;
    for (i = 0; i < 2; i++) {
        snprintf(object, sizeof object, even, "<1,1,1>", "0,0,0");
        corner[i] = look(object, at[i] + 0x1p-40, 0.5).shading_normal;
        corner[i] = stretched(corner[i].x, corner[i].y, corner[i].z);
    }
    snprintf(object, sizeof object, even, "<4,1,1>", "0,0,0");
    hit = look(object, 4.0 * 0.25, 0.5);
    assert_true(pov_largest(pov_sub(hit.shading_normal, pov_unit(pov_add(corner[0], corner[1])))) < 1e-9);
}

static const char saddle[] =
    "bicubic_patch { type 1 u_steps 0 v_steps %d <0,0,0><1,0,1><2,0,2><3,0,3> <0,1,1><1,1,1><2,1,1><3,1,2> "
    "<0,2,2><1,2,1><2,2,1><3,2,1> <0,3,3><1,3,2><2,3,1><3,3,0> }";

/* A cell is split from its least u and v to its greatest, where both corners have z = 0; the others have z = 3. */
static void a_patch_of_one_cell_is_split_from_first_to_last(void **state)
{
    char object[400];

    (void)state;
    snprintf(object, sizeof object, saddle, 0);
    assert_true(fabs(look(object, 1.5, 1.5).point.z) < 1e-12);
    assert_true(fabs(look(object, 2.0, 1.0).point.z - 1.0) < 1e-12);
}

/* Halfway along a row a corner is added at z = 1.5, on the first row and on the last; none between the rows. */
static void v_steps_are_along_a_row(void **state)
{
    char object[400];

    (void)state;
    snprintf(object, sizeof object, saddle, 1);
    assert_true(fabs(look(object, 1.5, 1.5).point.z - 1.5) < 1e-12);
    assert_true(fabs(look(object, 0.75, 1.5).point.z - 0.75) < 1e-12);
}

/* trace() of the language gives the same normal. */
static void trace_blends_alike(void **state)
{
    static const char traced[] =
        "#declare N = <0,0,0>; #declare O = smooth_triangle { <0,0,0>, <0,0,-1>, <1,0,0>, <1,0,-1>, <0,1,0>, <0,3,-4> scale <4,1,1> } "
        "#declare P = trace(O, <1,.25,-9>, z, N); plane { N, 0 translate 100*z }";
    const pov_vec3 sum = pov_add(pov_add(pov_vec3_of(0.0, 0.0, -0.5), pov_scale(stretched(1, 0, -1), 0.25)),
                                 pov_scale(stretched(0, 3, -4), 0.25));

    (void)state;
    assert_true(is_near(look(traced, 0.0, 0.0).normal, pov_unit(sum)));
}

/* Straight down, where two components of the direction are zeros of either sign. */
static void a_height_field_is_hit_from_straight_above(void **state)
{
    static const char field[] = "height_field { function 8, 8 { x*y } rotate %s }";
    char object[200];

    (void)state;
    snprintf(object, sizeof object, field, "-90*x");
    assert_true(look(object, 0.13, 0.37).point.z < 0.0);
    assert_true(look(object, 0.87, 0.92).point.z < 0.0);
    assert_true(look("#declare N = <0,0,0>; #declare O = height_field { function 8, 8 { x*y } } #declare P = trace(O, <.13,3,.37>, -y, N); "
                     "sphere { <0, N.y, 0>, .5 }", 0.0, 1.0).point.z < 0.0);
}

/* Two triangles, and a third beside them; of each the normals of two corners lean along x. */
#define STRIP(rest) "mesh2 { vertex_vectors { 5, <0,0,0>, <0,2,0>, <2,0,0>, <2,2,0>, <4,0,0> } normal_vectors { 5, <0,0,-1>, <-3,0,-4>, " \
                    "<-3,0,-4>, <0,0,-1>, <-3,0,-4> } face_indices { 3, <0,1,2>, <1,2,3>, <2,3,4> } " rest " }"

static bool is_leaning(const char *object, double x, double y) { return look(object, x, y).shading_normal.x < -0.1; }

/* As in POV-Ray: faces that have no indices of normals are flat, where others of the mesh have some. */
static void faces_behind_the_indices_of_normals_are_flat(void **state)
{
    (void)state;
    assert_true(is_leaning(STRIP(""), 2.5, 0.5));
    assert_true(is_leaning(STRIP("normal_indices { 2, <0,1,2>, <1,2,3> }"), 0.5, 0.5));
    assert_true(is_leaning(STRIP("normal_indices { 2, <0,1,2>, <1,2,3> }"), 1.5, 1.5));
    assert_false(is_leaning(STRIP("normal_indices { 2, <0,1,2>, <1,2,3> }"), 2.5, 0.5));
    assert_false(is_leaning(STRIP("normal_indices { 0 }"), 0.5, 0.5));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_smooth_triangle_that_is_stretched),
        cmocka_unit_test(a_smooth_height_field_that_is_stretched),
        cmocka_unit_test(a_patch_of_one_cell_is_split_from_first_to_last),
        cmocka_unit_test(v_steps_are_along_a_row),
        cmocka_unit_test(a_height_field_is_hit_from_straight_above),
        cmocka_unit_test(trace_blends_alike),
        cmocka_unit_test(faces_behind_the_indices_of_normals_are_flat),
    };

    return cmocka_run_group_tests_name("smooth", tests, NULL, NULL);
}
