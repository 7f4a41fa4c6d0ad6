/* Which side of a surface is its back, where interior_texture shows: in the middle of the picture, as in POV-Ray 3.7. */
#include "support/check.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TWO " texture { pigment { rgb <1,0,0> } finish { ambient 1 diffuse 0 } } " \
            "interior_texture { pigment { rgb <0,1,0> } finish { ambient 1 diffuse 0 } } "
#define SQUARE "polygon { 5, <-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1>" TWO
#define TRIANGLE "triangle { <-1,-1,0>, <1,-1,0>, <0,1,0> "
#define SMOOTH(a, b, c) "smooth_triangle { <-1,-1,0>, " a ", <1,-1,0>, " b ", <0,1,0>, " c TWO
#define MESH "mesh { " TRIANGLE "} "
#define SHEET "parametric { function { u } function { v } function { 0 } <-1,-1>, <1,1> "
#define SURFACE SHEET "contained_by { box { -1, 1 } } "
#define PATCH PATCH_SHAPE TWO
#define PATCH_SHAPE "bicubic_patch { type 1 u_steps 1 v_steps 1 <-1,-1,0> <-.3,-1,0> <.3,-1,0> <1,-1,0> <-1,-.3,0> <-.3,-.3,0> <.3,-.3,0> <1,-.3,0> " \
              "<-1,.3,0> <-.3,.3,0> <.3,.3,0> <1,.3,0> <-1,1,0> <-.3,1,0> <.3,1,0> <1,1,0> "

typedef enum side { NOTHING, FRONT, BACK } side;
static const char *const names[] = { "nothing", "the front", "the back" };

static void assert_side(const char *object, side wanted)
{
    char text[1024];
    float *p;
    side seen;

    snprintf(text, sizeof text, "#version 3.7; camera { orthographic location <0,0,-10> direction z right .001*x up .001*y } "
             "background { rgb <0,0,1> } %s", object);
    p = scenes_draw(text, 1, 1, 1, 1);
    seen = p[0] == 1.0f ? FRONT : p[1] == 1.0f ? BACK : NOTHING;
    free(p);
    if (seen != wanted)
        fail_msg("%s: %s is seen, not %s", object, names[seen], names[wanted]);
}

static void the_first_corners_of_a_polygon_give_its_side(void **state)
{
    (void)state;
    assert_side(SQUARE "}", BACK);
    assert_side(SQUARE "rotate 180*y }", FRONT);
    assert_side(SQUARE "scale <-1,1,1> }", BACK);
    assert_side(SQUARE "scale <1,1,-1> }", FRONT);
    assert_side("polygon { 7, <1,1>, <.5,.5>, <.2,1.5>, <-1,1>, <-1,-1>, <1,-1>, <1,1>" TWO "}", FRONT);
    assert_side("polygon { 6, <-1,-1>, <0,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1>" TWO "}", BACK);
    assert_side("polygon { 6, <-1,-1>, <.5,-.9>, <1,-1>, <1,1>, <-1,1>, <-1,-1>" TWO "}", FRONT);
}

static void normals_of_a_smooth_triangle_give_its_side(void **state)
{
    (void)state;
    assert_side(SMOOTH("-z", "-z", "-z") "}", FRONT);
    assert_side(SMOOTH("z", "z", "z") "}", BACK);
    assert_side(SMOOTH("-z", "-z", "-z") "scale <1,1,-1> }", BACK);
    assert_side(SMOOTH("z", "-z", "-z") "}", NOTHING);
    assert_side(SMOOTH("x", "-z", "-z") "}", NOTHING);
    assert_side("mesh { smooth_triangle { <-1,-1,0>, z, <1,-1,0>, -z, <0,1,0>, z }" TWO "}", BACK);
    assert_side("mesh { smooth_triangle { <-1,-1,0>, z, <1,-1,0>, z + .1 * x, <0,1,0>, z }" TWO "}", BACK);
    assert_side("mesh { smooth_triangle { <-1,-1,0>, -z, <1,-1,0>, .1 * x - z, <0,1,0>, -z }" TWO "}", FRONT);
    assert_side("difference { sphere { 0, 1.5 } mesh { smooth_triangle { <-1,-1,0>, z, <1,-1,0>, z + .1 * x, <0,1,0>, z } } " TWO "}", FRONT);
}

/* Where the light sees a slope that turns away, though the face does not. */
static void the_blend_at_a_point_gives_its_side(void **state)
{
    (void)state;
    assert_side(SMOOTH("<1,0,-.2>", "<1,0,-.2>", "<1,0,-.2>") "rotate -40*y }", BACK);
    assert_side("smooth_triangle { <-1,-1,0>, <1,0,-.2>, <1,-1,0>, -z, <0,1,0>, <1,0,-.2> rotate -40*y" TWO "}", BACK);
    assert_side("smooth_triangle { <-1,-1,0>, <1,0,-.2>, <1,-1,0>, -z, <0,1,0>, -z rotate -40*y" TWO "}", FRONT);
}

/* All normals of a face the same: it is not smooth, and its side is that of its corners. */
static void equal_normals_make_a_flat_face(void **state)
{
    (void)state;
    assert_side("mesh { smooth_triangle { <-1,-1,0>, z, <1,-1,0>, z, <0,1,0>, z }" TWO "}", FRONT);
    assert_side("mesh { smooth_triangle { <-1,-1,0>, z, <0,1,0>, z, <1,-1,0>, z }" TWO "}", BACK);
    assert_side("mesh { smooth_triangle { <-1,-1,0>, z, <1,-1,0>, z + 1e-6 * x, <0,1,0>, z }" TWO "}", FRONT);
    assert_side("mesh { smooth_triangle { <-1,-1,0>, z, <1,-1,0>, z + 1e-4 * x, <0,1,0>, z }" TWO "}", BACK);
}

#define HALF(look) "sphere { 0, 1 " look "clipped_by { plane { -z, 0 } } } "
#define OWN "pigment { rgb <0,0,1> } finish { ambient 1 diffuse 0 } "

/* A member that has only a texture of its own has the interior_texture of the group around it. */
static void a_group_gives_its_interior_texture(void **state)
{
    (void)state;
    assert_side("union { " HALF(OWN) TWO "}", BACK);
    assert_side("merge { union { union { " HALF(OWN) "} " TWO "} sphere { 9, 1 } " OWN "}", BACK);
    assert_side("union { " HALF(OWN "interior_texture { " OWN "} ") TWO "}", NOTHING);
}

/* It keeps its place in the group, whatever moves the member. */
static void an_interior_texture_stays_with_its_group(void **state)
{
    static const char moved[] = "union { sphere { 0, 1 " OWN "rotate 90*z translate .2*y clipped_by { plane { -z, 0 } } } texture { " OWN "} "
                                "interior_texture { pigment { gradient y color_map { [.5 rgb x] [.5 rgb y] } translate %s*y } "
                                "finish { ambient 1 diffuse 0 } } %s }";
    char text[512];

    (void)state;
    snprintf(text, sizeof text, moved, ".25", "");
    assert_side(text, BACK);
    snprintf(text, sizeof text, moved, "-.25", "");
    assert_side(text, FRONT);
    snprintf(text, sizeof text, moved, ".25", "translate .3*y");
    assert_side(text, FRONT);
}

static void a_parametric_surface_faces_the_turn_from_v_to_u(void **state)
{
    (void)state;
    assert_side(SURFACE TWO "}", BACK);
    assert_side(SURFACE TWO "rotate 180*y }", FRONT);
}

static void a_parametric_surface_ends_at_its_container(void **state)
{
    (void)state;
    assert_side(SHEET "contained_by { box { -.1, 1.3 } }" TWO "}", BACK);
    assert_side(SHEET "contained_by { sphere { <.6,.6,0>, .7 } }" TWO "}", NOTHING);
    assert_side(SHEET "contained_by { sphere { <.6,.6,0>, .9 } }" TWO "}", BACK);
}

static void textures_of_components_are_seen_from_both_sides(void **state)
{
    (void)state;
    assert_side("blob { threshold .3 sphere { 0, 1, 1 }" TWO "inverse }", BACK);
    assert_side("blob { threshold .3 sphere { 0, 1, 1 pigment { rgb x } finish { ambient 1 diffuse 0 } }" TWO "inverse }", FRONT);
    assert_side("blob { threshold .3 sphere { 0, 1, 1 } sphere { 9, 1, 1 pigment { rgb z } } sphere { 7, 1, 1 }" TWO "inverse }", FRONT);
}

static void patches_are_not_inverted(void **state)
{
    (void)state;
    assert_side(TRIANGLE TWO "inverse }", FRONT);
    assert_side(SMOOTH("-z", "-z", "-z") "inverse }", FRONT);
    assert_side(SQUARE "inverse }", BACK);
    assert_side(PATCH "}", FRONT);
    assert_side(PATCH "inverse }", FRONT);
    assert_side("difference { sphere { 0, 1.5 } " TRIANGLE "} " TWO "}", FRONT);
}

static void meshes_are_inverted(void **state)
{
    (void)state;
    assert_side(MESH TWO "}", FRONT);
    assert_side(MESH TWO "inverse }", BACK);
    assert_side("difference { sphere { 0, 1.5 } " MESH "} " TWO "}", BACK);
    assert_side("difference { sphere { 0, 1.5 } " MESH "rotate 180*y } " TWO "}", FRONT);
    assert_side("union { " MESH "} sphere { 5, .1 } inverse " TWO "}", BACK);
}

/* Rings of prisms: counterclockwise with x to the right and z up, and the other way. */
#define RING "<-1,-1>, <1,-1>, <0,1>, <-1,-1>"
#define BACKWARD "<-1,-1>, <0,1>, <1,-1>, <-1,-1>"
#define STRAIGHT(ring) "prism { linear_spline -1, 1, 4, " ring TWO
#define CONE(ring) "prism { conic_sweep .3, 1, 4, " ring " translate -.5*y" TWO
#define BEZIER(a, b, c) "prism { bezier_spline -1, 1, 12, " a a b b b b c c c c a a TWO
#define HOLE(ring) "prism { -1, 1, 10, <-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1>, " ring " clipped_by { plane { -z, 0 } }" TWO

static void rings_of_prisms_turn_about_their_fronts(void **state)
{
    (void)state;
    assert_side(STRAIGHT(RING) "}", FRONT);
    assert_side(STRAIGHT(BACKWARD) "}", BACK);
    assert_side(STRAIGHT(BACKWARD) "scale <-1,1,1> }", BACK);
    assert_side(STRAIGHT(BACKWARD) "inverse }", FRONT);
    assert_side("intersection { sphere { 0, 1.5 } prism { -1, 1, 4, " BACKWARD "} " TWO "}", BACK);
    assert_side("prism { quadratic_spline -1, 1, 5, <0,1>, " RING TWO "}", FRONT);
    assert_side("prism { cubic_spline -1, 1, 6, <1,-1>, " BACKWARD ", <0,1>" TWO "}", BACK);
    assert_side(CONE(RING) "}", FRONT);
    assert_side(CONE(BACKWARD) "}", BACK);
    assert_side(BEZIER("<-1,-1>", "<1,-1>", "<0,1>") "}", BACK);
    assert_side(BEZIER("<-1,-1>", "<0,1>", "<1,-1>") "}", FRONT);
    assert_side(HOLE("<-.4,-.4>, <.4,-.4>, <.4,.4>, <-.4,.4>, <-.4,-.4>") "}", BACK);
    assert_side(HOLE("<-.4,-.4>, <-.4,.4>, <.4,.4>, <.4,-.4>, <-.4,-.4>") "}", FRONT);
}

static void both_caps_of_a_prism_face_up(void **state)
{
    (void)state;
    assert_side(STRAIGHT(RING) "rotate -90*x }", FRONT);
    assert_side(STRAIGHT(RING) "rotate 90*x }", BACK);
    assert_side(CONE(BACKWARD) "rotate -90*x }", FRONT);
    assert_side(CONE(BACKWARD) "rotate 90*x }", BACK);
}

static void a_lathe_is_faced_to_the_right_of_its_way(void **state)
{
    (void)state;
    assert_side("lathe { linear_spline 3, <0,-1>, <.5,0>, <0,1>" TWO "}", FRONT);
    assert_side("lathe { linear_spline 3, <0,1>, <.5,0>, <0,-1>" TWO "}", BACK);
    assert_side("lathe { cubic_spline 5, <0,1.3>, <0,1>, <.5,0>, <0,-1>, <0,-1.3>" TWO "rotate 30*x }", BACK);
}

/* trace() gives the normal of the front. */
static void the_front_is_where_a_traced_normal_points(void **state)
{
    static const char traced[] = "#declare N = <0,0,0>; #declare O = %s } #declare P = trace(O, -5*z, z, N); box { -1, 1 pigment { rgb <-N.z, N.z, 0> } "
                                 "finish { ambient 1 diffuse 0 } }";
    char text[1024];

    (void)state;
    snprintf(text, sizeof text, traced, "prism { -1, 1, 4, " RING);
    assert_side(text, FRONT);
    snprintf(text, sizeof text, traced, "prism { -1, 1, 4, " BACKWARD);
    assert_side(text, BACK);
    snprintf(text, sizeof text, traced, SURFACE);
    assert_side(text, BACK);
    snprintf(text, sizeof text, traced, PATCH_SHAPE);
    assert_side(text, FRONT);
    snprintf(text, sizeof text, traced, "mesh { smooth_triangle { <-1,-1,0>, z + x, <1,-1,0>, z + x, <0,1,0>, z + x }");
    assert_side(text, FRONT);
}

/* Where the field lies below the water a cut shows the solid up to the water, which has no surface of its own. */
static void a_cut_height_field_is_solid_up_to_its_water(void **state)
{
    static const char cut[] = "intersection { height_field { function 20, 20 { x } water_level .3 translate <-.1,%s,-.5> } box { <-.4,-2,-.3>, <.9,2,2>" TWO "} }";
    char text[512];

    (void)state;
    snprintf(text, sizeof text, cut, "-.05");
    assert_side(text, FRONT);
    snprintf(text, sizeof text, cut, "-.25");
    assert_side(text, FRONT);
    snprintf(text, sizeof text, cut, "-.35");
    assert_side(text, NOTHING);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_corners_of_a_polygon_give_its_side),
        cmocka_unit_test(normals_of_a_smooth_triangle_give_its_side),
        cmocka_unit_test(the_blend_at_a_point_gives_its_side),
        cmocka_unit_test(equal_normals_make_a_flat_face),
        cmocka_unit_test(a_group_gives_its_interior_texture),
        cmocka_unit_test(an_interior_texture_stays_with_its_group),
        cmocka_unit_test(a_parametric_surface_faces_the_turn_from_v_to_u),
        cmocka_unit_test(a_parametric_surface_ends_at_its_container),
        cmocka_unit_test(textures_of_components_are_seen_from_both_sides),
        cmocka_unit_test(patches_are_not_inverted),
        cmocka_unit_test(meshes_are_inverted),
        cmocka_unit_test(rings_of_prisms_turn_about_their_fronts),
        cmocka_unit_test(both_caps_of_a_prism_face_up),
        cmocka_unit_test(a_lathe_is_faced_to_the_right_of_its_way),
        cmocka_unit_test(the_front_is_where_a_traced_normal_points),
        cmocka_unit_test(a_cut_height_field_is_solid_up_to_its_water),
    };

    return cmocka_run_group_tests_name("sides of surfaces", tests, NULL, NULL);
}
