/* test_object_queries.c - what the language asks of objects that are moved and clipped, as POV-Ray answers it. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>

/* The z at which a ray along it comes upon something. */
static double first_z(const char *scene_text)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, scene_text);
    pov_hit hit = POV_INIT(hit);
    pov_tracer *tracer;
    pov_error err;

    assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
    assert_true(pov_trace_hit(tracer, pov_vec3_of(0.0, 0.0, -99.0), pov_vec3_of(0.0, 0.0, 1.0), &hit));
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return hit.point.z;
}

/* The value of an expression behind some declarations, as the radius of a sphere. */
static void assert_value(const char *declared, const char *expression, double value)
{
    char text[700];
    double seen;

    snprintf(text, sizeof text, "#version 3.7; camera { location -9*z } %s sphere { 0, %s }", declared, expression);
    seen = -first_z(text);
    if (fabs(seen - value) > 1e-9)
        fail_msg("%s: %s is %.9g, not %.9g", declared, expression, seen, value);
}

static void assert_seen(const char *object, double z)
{
    char text[700];

    snprintf(text, sizeof text, "#version 3.7; camera { location -9*z } %s", object);
    if (fabs(first_z(text) - z) > 1e-9)
        fail_msg("%s is seen at %.9g, not %.9g", object, first_z(text), z);
}

/* How wide the box of an object is along x. */
static void assert_width(const char *object, double width)
{
    char declared[300];

    snprintf(declared, sizeof declared, "#declare S = %s", object);
    assert_value(declared, "max_extent(S).x - min_extent(S).x", width);
}

static void a_shape_takes_in_its_transformations(void **state)
{
    (void)state;
    assert_width("sphere { <1,2,3>, 1 rotate <30,40,50> }", 2.0);
    assert_width("sphere { <1,2,3>, 1 rotate <30,40,50> scale <3,2,1> }", 6.0);
    assert_width("torus { 1, .5 rotate 45*y rotate -45*y }", 3.0);
    assert_width("box { 0, <1, 2, 5>.y rotate 90*y }", 5.0);
    assert_width("box { 0, 1 scale 2*<1, 2, 5>.y rotate 90*y }", 4.0);
    assert_width("ovus { .5, .25 }", 1.0);
}

/* What counts steps along an object asks for whole numbers, as floor() does. */
static void extents_have_no_roundings(void **state)
{
    (void)state;
    assert_value("#declare S = sphere { 0, 1 }", "ceil(max_extent(S).y) - floor(min_extent(S).x)", 2.0);
    assert_value("#declare S = cylinder { 0, 3*y, .5 }", "ceil(max_extent(S).y) - floor(min_extent(S).y)", 3.0);
    assert_value("#declare S = sphere_sweep { linear_spline 2, 0, .5, x, .5 }", "ceil(2 * max_extent(S).x)", 3.0);
    assert_value("#declare S = sphere { 0, 1e-30 scale 1e35 }", "ceil(max_extent(S).x / 1e5)", 1.0);
    assert_value("#declare S = union { plane { y, 0 } }", "min_extent(S).x / -1e10", 1.0);
}

static void what_clips_or_bounds_an_object_narrows_its_box(void **state)
{
    (void)state;
    assert_width("quadric { <1,-1,1>, 0, 0, -1 clipped_by { sphere { 0, 2 } } rotate 45*y }", 4.0);
    assert_width("plane { y, 0 bounded_by { box { -1, 1 } } rotate 45*y }", sqrt(8.0));
    assert_width("plane { y, 0 rotate 45*y clipped_by { box { -1, 1 } } }", 2.0);
    assert_width("sphere { 0, 1 clipped_by { box { -.5, 2 } } }", 1.5);
    assert_width("sphere { 0, 1 clipped_by { sphere { 0, .5 inverse } } }", 2.0);
    assert_width("intersection { box { -1, 1 } sphere { 0, .5 inverse } }", 2.0);
}

/* Not that of the points that steer the curve. */
static void the_box_of_a_curve_is_its_own(void **state)
{
    (void)state;
    assert_width("sphere_sweep { linear_spline 2, <-.8,-.5,0>, .5, <.7,.5,.2>, .2 }", 2.2);
    assert_width("lathe { quadratic_spline 3, <0,-1>, <1,0>, <1,1> }", 2.25);
    assert_width("prism { bezier_spline 0, 1, 8, <0,0>, <2,0>, <2,1>, <0,1>, <0,1>, <0,.7>, <0,.3>, <0,0> }", 1.5);
    assert_width("sor { 4, <0,-1>, <1,0>, <1,1>, <0,2> }", 2.0 * sqrt(1.25));
}

/* No other object of the scene has had its plugin loaded. */
static void a_shape_of_any_plugin_may_have_a_name(void **state)
{
    (void)state;
    assert_value("#declare S = polynomial { 2, xyz(2,0,0): 1, xyz(0,2,0): 1, xyz(0,0,2): 1, xyz(0,0,0): -4 }", "inside(S, x)", 1.0);
}

static void each_transformation_of_a_group_moves_the_box_before_it(void **state)
{
    (void)state;
    assert_width("union { sphere { 0, 1 } sphere { 0, 1 } rotate 45*y }", sqrt(8.0));
    assert_width("union { box { 0, 1 } box { 0, 1 } rotate 45*y rotate -45*y }", 2.0);
    assert_width("intersection { box { 0, 1 } box { -1, 1 } translate x rotate 45*y }", sqrt(2.0));
}

#define TRACED(object) "#declare N = <0,0,0>; #declare S = " object " #declare P = trace(S, -9*z, z, N);"

static void what_is_clipped_away_is_not_met(void **state)
{
    (void)state;
    assert_value(TRACED("sphere { 0, 1 clipped_by { plane { -z, 0 } } }"), "P.z", 1.0);
    assert_value(TRACED("sphere { 0, 1 clipped_by { plane { z, 0 } } }"), "-P.z", 1.0);
    assert_value(TRACED("sphere { 0, 1 translate 5*z clipped_by { plane { -z, -5 } } translate -4*z }"), "P.z", 2.0);
    assert_value(TRACED("sphere { 0, 1 clipped_by { plane { y, 0 } plane { -z, 0 } } rotate 180*y }"), "-P.z", 1.0);
    assert_value(TRACED("sphere { 0, 1 clipped_by { plane { y, 0 } plane { z, 0 } rotate 180*y translate y } }"), "P.z", 1.0);
    assert_value(TRACED("sphere { 0, 1 clipped_by { plane { -z, 5 } translate -5*z } translate 2*z }"), "P.z", 1.0);
    assert_value(TRACED("union { sphere { 0, 2 clipped_by { plane { -z, 0 } } } sphere { 0, 1 } clipped_by { box { <-9,-9,-.5>, 9 } } }"), "P.z", 1.0);
}

/* Also of what is inverse, and of what cuts: behind the clip nothing of the whole is left. */
static void a_point_is_inside_where_the_clips_are(void **state)
{
    (void)state;
    assert_value("#declare S = sphere { 0, 1 clipped_by { plane { -z, 0 } } }", "1 + inside(S, .5*z)", 2.0);
    assert_value("#declare S = sphere { 0, 1 clipped_by { plane { -z, 0 } } }", "1 + inside(S, -.5*z)", 1.0);
    assert_value("#declare S = sphere { 0, 1 inverse clipped_by { plane { -z, 0 } } }", "1 + inside(S, 2*z)", 2.0);
    assert_value("#declare S = sphere { 0, 1 inverse clipped_by { plane { -z, 0 } } }", "1 + inside(S, -2*z)", 1.0);
    assert_value(TRACED("difference { box { -2, 2 } sphere { 0, 3 clipped_by { plane { z, 1 } } } }"), "1 + vlength(N)", 1.0);
}

/* Not even where it cuts or is inverse: what it cuts from is gone, and of both only the surface in it is left. */
static void the_faces_of_a_box_belong_to_it(void **state)
{
    (void)state;
    assert_value("#declare S = box { <-.64, -1, 0>, 1 }", "1 + inside(S, x) + inside(S, <-.64, 0, .5>) + inside(S, <1, -1, 0>)", 4.0);
    assert_value("#declare S = sphere { 0, 1 }", "1 + inside(S, x)", 1.0);
}

static void a_triangle_holds_nothing(void **state)
{
    (void)state;
    assert_value(TRACED("difference { sphere { 0, 1 } triangle { <-2,-2,.5>, <2,-2,.5>, <0,2,.5> } }"), "P.z", 0.5);
    assert_value("#declare S = union { triangle { x, y, z } sphere { 0, 1 } }", "1 + inside(S, <9,9,9>)", 1.0);
    assert_value("#declare S = difference { box { -1, 1 } union { triangle { x, y, z } sphere { 0, .2 } } }", "1 + inside(S, .9)", 1.0);
    assert_value("#declare S = difference { box { -1, 1 } intersection { triangle { x, y, z } sphere { 0, .2 } } }", "1 + inside(S, .1)", 1.0);
    assert_value("#declare S = difference { box { -1, 1 } difference { triangle { x, y, z } sphere { 0, .2 } } }", "1 + inside(S, .1)", 2.0);
    assert_value("#declare S = object { union { box { -1, 1 } triangle { x, y, z } } inverse }", "1 + inside(S, 9)", 1.0);
}

static void faces_with_a_corner_that_is_no_number_are_left_out(void **state)
{
#define BESIDE_NAN(S) "#declare No = mod(1, 0);" TRACED(S)
    (void)state;
    assert_value(BESIDE_NAN("mesh2 { vertex_vectors { 4, <No, 1, 1>, <-9, -9, .5>, <9, -9, .5>, <0, 9, .5> } face_indices { 2, <0, 1, 2>, <1, 2, 3> } }"),
                 "P.z", 0.5);
    assert_value(BESIDE_NAN("mesh2 { vertex_vectors { 3, <-9, -9, .5>, <9, -9, .5>, <0, 9, .5> }"
                            " normal_vectors { 3, -z, <0, 1 / 0, 0>, -z } face_indices { 1, <0, 1, 2> } }"), "P.z", 0.5);
    assert_value(BESIDE_NAN("mesh { triangle { <-9, -9, .2>, <9, -9, .2>, <0, No, .2> } triangle { <-9, -9, .5>, <9, -9, .5>, <0, 9, .5> } }"),
                 "P.z", 0.5);
    assert_value(BESIDE_NAN("union { triangle { <-9, -9, .2>, <9, -9, .2>, <0, 1 / 0, .2> } plane { -z, -.5 } }"), "P.z", 0.5);
#undef BESIDE_NAN
}

static void a_polygon_may_be_asked_and_holds_nothing(void **state)
{
    (void)state;
    assert_value("#declare S = polygon { 4, 0, x, y, 0 }", "1 + inside(S, <.2, .2, 0>)", 1.0);
    assert_value("#declare S = object { polygon { 4, 0, x, y, 0 } inverse }", "1 + inside(S, <.2, .2, 1>)", 1.0);
}

static void a_union_of_nothing_is_nowhere_and_an_intersection_of_nothing_everywhere(void **state)
{
    (void)state;
    assert_value("#declare S = intersection { }", "1 + inside(S, 0)", 2.0);
    assert_value("#declare S = union { }", "1 + inside(S, 0)", 1.0);
    assert_value("#declare S = object { union { } inverse }", "1 + inside(S, 0)", 2.0);
    assert_value("#declare S = object { intersection { } inverse }", "1 + inside(S, 0)", 1.0);
    assert_value(TRACED("intersection { sphere { 0, 1 } union { } }"), "1 + vlength(N)", 1.0);
    assert_value(TRACED("difference { sphere { 0, 1 } difference { } }"), "1 + vlength(N)", 1.0);
    assert_value(TRACED("merge { sphere { 0, 1 } intersection { } }"), "1 + vlength(N)", 1.0);
    assert_value(TRACED("union { sphere { 0, 1 } intersection { } }"), "1 + vlength(N)", 2.0);
}

/* Nor does a ray see more of what is left than the surface. */
static void a_triangle_that_cuts_is_all_that_is_seen(void **state)
{
    (void)state;
    assert_seen("difference { box { -1, 1 } union { triangle { <-2,-2,.5>, <2,-2,.5>, <0,2,.5> } sphere { 0, .2 } } }", 0.5);
    assert_seen("object { union { box { -1, 1 } triangle { <-2,-2,3>, <2,-2,3>, <0,2,3> } } inverse }", 3.0);
}

/* As rays of the camera see them. */
static void a_triangle_beside_solids_in_a_union_is_traced_in_a_solid(void **state)
{
#define BESIDE "union { triangle { <-2,-2,.5>, <2,-2,.5>, <0,2,.5> } sphere { 3*x, .2 } }"
    (void)state;
    assert_value(TRACED("intersection { sphere { 0, 1 } " BESIDE " }"), "P.z", 0.5);
    assert_value(TRACED("difference { sphere { 0, 1 } " BESIDE " }"), "P.z", 0.5);
    assert_value(TRACED("difference { " BESIDE " sphere { y, .2 } }"), "P.z", 0.5);
    assert_value(TRACED("difference { " BESIDE " sphere { 0, .6 } }"), "1 + vlength(N)", 1.0);
    assert_value(TRACED("merge { sphere { z, .7 } " BESIDE " }"), "P.z", 0.3);
}

/* Of a group that cuts what its members' complements make is traced. */
static void what_a_triangle_leaves_of_solids_is_traced(void **state)
{
#define TRIANGLE "triangle { <-2,-2,.5>, <2,-2,.5>, <0,2,.5> }"
    (void)state;
    assert_value(TRACED("difference { sphere { 0, 1 } difference { " TRIANGLE " sphere { 0, .4 } } }"), "-P.z", 0.4);
    assert_value(TRACED("difference { sphere { 0, 1 } union { " TRIANGLE " sphere { .5*z, .1 } } }"), "1 + vlength(N)", 1.0);
    assert_value(TRACED("difference { sphere { 0, 1 } union { " TRIANGLE " sphere { 0, .1 } } inverse }"), "-P.z", 1.0);
    assert_value(TRACED("union { " TRIANGLE " sphere { .5*z, .1 } inverse }"), "1 + vlength(N)", 1.0);
}

/* Whether the object was scaled, or a group that it is in. */
/* Along z from -2, between both spheres. */
static void assert_traced(const char *object, double z)
{
    char declared[400];

    snprintf(declared, sizeof declared, "#declare U = union { sphere { 0, 3 } sphere { 0, 1 } } #declare O = %s", object);
    assert_value(declared, "9 + trace(O, -2*z, z).z", 9.0 + z);
}

static void faces_within_a_union_are_traced_in_groups_as_they_are_seen(void **state)
{
    (void)state;
    assert_traced("object { U }", -1.0);
    assert_traced("intersection { object { U } box { -9, 9 } }", -1.0);
    assert_traced("difference { object { U } box { 8, 9 } }", -1.0);
    assert_traced("difference { object { U scale .75 } sphere { 0, .5 } }", -.75);
    assert_traced("difference { box { -9, 9 } object { U inverse } }", -1.0);
    assert_traced("intersection { union { box { -5, 5 inverse } object { U } } sphere { 0, 9 } }", -1.0);
    assert_traced("intersection { merge { object { U } box { -.5, .5 } } box { -9, 9 } }", 3.0);
    assert_traced("difference { box { -9, 9 } object { U } }", 3.0);
}

static void the_normals_of_a_smooth_triangle_are_blended_in_the_scene(void **state)
{
#define SMOOTH "smooth_triangle { <-2,-2,0>, <1,0,-1>, <2,-2,0>, <0,3,-1>, <0,2,0>, -z "
    (void)state;
    assert_value("#declare M = <0,0,0>; #declare R = " SMOOTH "scale <1,3,1> } #declare P = trace(R, -9*z, z, M);"
                 TRACED("union { " SMOOTH "} scale <1,3,1> }"), "1 + vlength(N - M)", 1.0);
}

/* A member that ends where another is met again and again by rays of an oblique map. */
static void no_crossing_is_met_twice(void **state)
{
    (void)state;
    assert_value(TRACED("intersection { torus { 1, .3 rotate <20,30,40> inverse } sphere { 0, 1.5 scale <1,1.1,1.2> rotate 33*x } "
                        "sphere { 0, .1 rotate 12*y } }"), "vlength(P)", 0.1);
}

/* By the points of its splines, as in POV-Ray. */
static void a_lathe_of_bezier_splines_has_no_inside_nearer_than_its_points(void **state)
{
    static const char lathe[] = "#declare S = lathe { bezier_spline 4, <.945,-1>, <.2,-.723>, <.342,.18>, <.858,.966> }";

    (void)state;
    assert_value(lathe, "1 + inside(S, <.19,0,0>)", 1.0);
    assert_value(lathe, "1 + inside(S, <.21,0,0>)", 2.0);
    assert_value(lathe, "1 + inside(S, <.43,0,0>)", 2.0);
    assert_value(lathe, "1 + inside(S, <.5,0,0>)", 1.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_shape_takes_in_its_transformations),
        cmocka_unit_test(extents_have_no_roundings), cmocka_unit_test(what_clips_or_bounds_an_object_narrows_its_box),
        cmocka_unit_test(the_box_of_a_curve_is_its_own),
        cmocka_unit_test(a_shape_of_any_plugin_may_have_a_name),
        cmocka_unit_test(each_transformation_of_a_group_moves_the_box_before_it),
        cmocka_unit_test(what_is_clipped_away_is_not_met),
        cmocka_unit_test(a_point_is_inside_where_the_clips_are),
        cmocka_unit_test(the_faces_of_a_box_belong_to_it),
        cmocka_unit_test(a_triangle_holds_nothing),
        cmocka_unit_test(a_triangle_that_cuts_is_all_that_is_seen),
        cmocka_unit_test(a_triangle_beside_solids_in_a_union_is_traced_in_a_solid),
        cmocka_unit_test(what_a_triangle_leaves_of_solids_is_traced),
        cmocka_unit_test(faces_within_a_union_are_traced_in_groups_as_they_are_seen),
        cmocka_unit_test(the_normals_of_a_smooth_triangle_are_blended_in_the_scene),
        cmocka_unit_test(faces_with_a_corner_that_is_no_number_are_left_out),
        cmocka_unit_test(a_polygon_may_be_asked_and_holds_nothing),
        cmocka_unit_test(a_union_of_nothing_is_nowhere_and_an_intersection_of_nothing_everywhere),
        cmocka_unit_test(a_lathe_of_bezier_splines_has_no_inside_nearer_than_its_points),
        cmocka_unit_test(no_crossing_is_met_twice),
    };

    return cmocka_run_group_tests_name("object_queries", tests, NULL, NULL);
}
