/* test_extents.c - min_extent and max_extent of objects that are moved: the boxes that POV-Ray has. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>

/* How wide the box of S is along x: as the diameter of a ball. */
static void assert_width(const char *object, double width)
{
    char text[500];
    pov_context *context = scenes_context();
    pov_hit hit = POV_INIT(hit);
    pov_scene *scene;
    pov_tracer *tracer;
    pov_error err;

    snprintf(text, sizeof text, "#version 3.7; camera { location -9*z } #declare S = %s sphere { 0, (max_extent(S).x - min_extent(S).x)/2 }",
             object);
    scene = scenes_text(context, text);
    assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
    assert_true(pov_trace_hit(tracer, pov_vec3_of(0.0, 0.0, -99.0), pov_vec3_of(0.0, 0.0, 1.0), &hit));
    if (fabs(-2.0 * hit.point.z - width) > 1e-9)
        fail_msg("%s is %.9g wide, not %.9g", object, -2.0 * hit.point.z, width);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

static void a_shape_takes_in_its_transformations(void **state)
{
    (void)state;
    assert_width("sphere { <1,2,3>, 1 rotate <30,40,50> }", 2.0);
    assert_width("sphere { <1,2,3>, 1 rotate <30,40,50> scale <3,2,1> }", 6.0);
    assert_width("torus { 1, .5 rotate 45*y rotate -45*y }", 3.0);
    assert_width("ovus { .5, .25 }", 1.0);
}

static void each_transformation_of_a_group_moves_the_box_before_it(void **state)
{
    (void)state;
    assert_width("union { sphere { 0, 1 } sphere { 0, 1 } rotate 45*y }", sqrt(8.0));
    assert_width("union { box { 0, 1 } box { 0, 1 } rotate 45*y rotate -45*y }", 2.0);
    assert_width("intersection { box { 0, 1 } box { -1, 1 } translate x rotate 45*y }", sqrt(2.0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_shape_takes_in_its_transformations),
        cmocka_unit_test(each_transformation_of_a_group_moves_the_box_before_it),
    };

    return cmocka_run_group_tests_name("extents", tests, NULL, NULL);
}
