/* sdl/parse_object and what it asks: shapes, modifiers, materials, lights. */
#include "support/check.h"
#include "support/near.h"
#include "support/reading.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void read_text(reading *r, const char *text)
{
    reading_begin(r, text);
    if (r->status != POV_OK)
        fail_msg("%s: %d:%d %s", text, r->error.line, r->error.column, r->error.message);
}

static const material *material_of(const reading *r, size_t index)
{
    return &r->model.materials.items[r->model.leaves.items[index].material];
}

static pov_vec3 mapped(const reading *r, size_t index, double x, double y, double z)
{
    pov_affine map;

    assert_true(transform_compose(r->model.leaves.items[index].map, &map));
    return pov_affine_point(&map, pov_vec3_of(x, y, z));
}

static void assert_point(pov_vec3 p, double x, double y, double z)
{
    if (!(pov_largest(pov_sub(p, pov_vec3_of(x, y, z))) <= 1e-15 * pov_largest(pov_vec3_of(x, y, z))))
        fail_msg("<%.17g, %.17g, %.17g> is not <%g, %g, %g>", p.x, p.y, p.z, x, y, z);
}

/* ---- shapes ---- */

static void every_primitive_gets_its_numbers(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "sphere { <1, 2, 3>, 4 }\n  box { 1, 2 } cone { 1, 2, 3, 4 open } cone { 1, 2, 3, 4 }\n"
                  "cylinder { 1, 2, 3 open } quadric { <1, 2, 3>, <4, 5, 6>, <7, 8, 9>, 10 }\n"
                  "polygon { 4, <0, 0>, <1, 0>, <1, 1>, <0, 0> } blob7 { power 3 (4) }");
    assert_int_equal(r.model.leaves.count, 8);
    assert_string_equal(r.model.leaves.items[5].shape->keyword, "quadric");
    assert_true(reading_shape(&r, 0)->numbers[0] == 4.0 && reading_shape(&r, 1)->vectors[1].y == 2.0);
    assert_true(reading_shape(&r, 2)->open && !reading_shape(&r, 3)->open && reading_shape(&r, 4)->open);
    assert_true(reading_shape(&r, 5)->vectors[2].z == 9.0 && reading_shape(&r, 5)->numbers[0] == 10.0);
    assert_true(reading_shape(&r, 6)->points[2].y == 1.0);
    assert_true(reading_shape(&r, 7)->numbers[1] == 4.0);
    reading_end(&r);
}

static void an_object_knows_where_it_stands(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "sphere { 0, 1 }\r\n\t/* \n */ box { 0, 1 }");
    assert_int_equal(r.model.leaves.items[0].line, 1);
    assert_int_equal(r.model.leaves.items[0].column, 1);
    assert_int_equal(r.model.leaves.items[1].line, 3);
    assert_int_equal(r.model.leaves.items[1].column, 5);
    reading_end(&r);
}

static void shapes_written_as_the_last_of_their_word_share_what_was_written(void **state)
{
    const leaf_node *o;
    reading r;

    (void)state;
    read_text(&r, "sphere { 0, 1 } box { 0, 1 } sphere { 0, 1 translate 1 } sphere { 0, 2 } box { 0, 1 } sphere { 0, 1 }");
    o = r.model.leaves.items;
    assert_ptr_equal(o[2].instance, o[0].instance);
    assert_ptr_equal(o[4].instance, o[1].instance);
    assert_true(o[3].instance != o[0].instance && o[5].instance != o[3].instance);
    assert_true(reading_shape(&r, 5)->numbers[0] == 1.0 && reading_shape(&r, 3)->numbers[0] == 2.0);
    reading_end(&r);
}

static void an_instance_is_aligned_for_vector_registers(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "sphere { 0, 1 } sphere { 0, 1 translate 1 } sphere { 0, 1 }");
    assert_int_equal((uintptr_t)reading_shape(&r, 0) % 32, 0);
    assert_int_equal((uintptr_t)reading_shape(&r, 2) % 32, 0);
    reading_end(&r);
}

static void a_plugins_warning_has_the_place_of_the_value(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "sphere { <0, 0, 0>,\n  -1 }\nsphere { 2 }");
    assert_int_equal(r.model.warnings, 2);
    assert_string_equal(r.notes[0].message, "a negative radius is taken as positive");
    assert_string_equal(r.notes[0].file, "scene.pov");
    assert_int_equal(r.notes[0].line, 2);
    assert_int_equal(r.notes[0].column, 3);
    assert_string_equal(r.notes[0].excerpt, "  -1 }");
    assert_int_equal(r.notes[0].caret, 2);
    assert_int_equal(r.notes[1].line, 3);
    reading_end(&r);
}

static void equal_warnings_by_the_thousand_are_only_counted(void **state)
{
    static char text[12 * 1000 + 1];
    reading r;
    int i;

    (void)state;
    for (i = 0; i < 1000; i++)
        memcpy(text + 12 * i, "sphere { 2 }", 12);
    read_text(&r, text);
    assert_int_equal(r.model.warnings, 1000);
    assert_int_equal(r.note_count, 101);
    assert_string_equal(r.notes[100].message, "more than 100 warnings; the rest is only counted");
    reading_end(&r);
}

/* ---- transformations ---- */

static void transformations_apply_in_the_order_written(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "sphere { 0, 1 translate <1, 0, 0> rotate <0, 90, 0> scale <1, 1, 2> }\n"
                  "sphere { 0, 1 scale <1, 1, 2> rotate 90 translate <1, 0, 0> }");
    assert_point(mapped(&r, 0, 0, 0, 0), 0, 0, -2);
    assert_point(mapped(&r, 0, 0, 0, 1), 1, 0, -2);
    /* About x, then y, then z, each by 90 degrees: z -> -y -> -y -> x. */
    assert_point(mapped(&r, 1, 0, 0, 1), 3, 0, 0);
    reading_end(&r);
}

static void a_rotation_is_left_handed(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "sphere { 0, 1 rotate <90, 0, 0> } sphere { 0, 1 rotate <0, 90, 0> } sphere { 0, 1 rotate "
                  "<0, 0, 90> }");
    assert_point(mapped(&r, 0, 0, 1, 0), 0, 0, 1);
    assert_point(mapped(&r, 1, 0, 0, 1), 1, 0, 0);
    assert_point(mapped(&r, 2, 1, 0, 0), 0, 1, 0);
    reading_end(&r);
}

static void a_matrix_is_read_row_by_row_as_in_povray(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "sphere { 0, 1 matrix <1, 2, 3, 0, 1, 4, 0, 0, 1, 7, 8, 9> }");
    assert_point(mapped(&r, 0, 1, 0, 0), 8, 10, 12);
    assert_point(mapped(&r, 0, 0, 1, 0), 7, 9, 13);
    reading_end(&r);
}

static void a_scale_of_zero_counts_as_one_with_a_warning(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "sphere { 0, 1 scale <2, 0, -1> } sphere { 0, 1 scale 0 }");
    assert_point(mapped(&r, 0, 1, 1, 1), 2, 1, -1);
    assert_null(r.model.leaves.items[1].map);
    assert_int_equal(r.model.warnings, 2);
    assert_int_equal(r.notes[0].column, 21);
    reading_end(&r);
}

static void what_moves_nothing_is_no_transformation(void **state)
{
    reading r;

    (void)state;
    read_text(&r,
              "sphere { 0, 1 translate 0 scale 1 rotate <0, 360, -720> matrix <1,0,0,0,1,0,0,0,1,0,0,0> }\n"
              "sphere { 0, 1 translate 1 rotate 0 }");
    assert_null(r.model.leaves.items[0].map);
    assert_null(r.model.leaves.items[1].map->before);
    reading_end(&r);
}

/* ---- looks ---- */

static void textures_have_their_defaults(void **state)
{
    reading r;
    const material *m;

    (void)state;
    read_text(&r, "sphere { 0, 1 } sphere { 0, 1 pigment { } finish { } texture { } }");
    m = material_of(&r, 0);
    assert_true(colour_is_black(m->pigment) && m->filter == 0.0f && m->transmit == 0.0f);
    assert_true(m->finish.ambient.r == 0.1f && m->finish.ambient.b == 0.1f && m->finish.diffuse == 0.6f && m->finish.phong == 0.0f);
    assert_true(m->finish.phong_size == 40.0f && m->finish.metallic == 0.0f && colour_is_black(m->finish.reflection.max));
    assert_true(m->interior.ior == 1.0 && !m->interior.given);
    assert_int_equal(r.model.materials.count, 1);
    reading_end(&r);
}

static void modifiers_stand_in_any_order_and_number(void **state)
{
    reading r;
    const material *m;

    (void)state;
    read_text(
        &r, "sphere { 0, 1 finish { phong .5 metallic } translate 1 interior { ior 1.5 } pigment { rgb 1 }\n"
            "  finish { diffuse .25 phong_size 9 metallic .5 reflection <.5, .25, 0> } pigment { red .5 } }");
    m = material_of(&r, 0);
    assert_true(m->finish.phong == 0.5f && m->finish.diffuse == 0.25f && m->finish.phong_size == 9.0f && m->finish.metallic == 0.5f);
    assert_true(m->pigment.r == 0.5f && m->pigment.g == 0.0f && m->finish.reflection.max.g == 0.25f);
    assert_true(m->interior.given && m->interior.ior == 1.5);
    reading_end(&r);
}

static void a_texture_begins_anew_and_what_follows_changes_it(void **state)
{
    reading r;
    const material *m;

    (void)state;
    read_text(
        &r,
        "sphere { 0, 1 interior { ior 2 } pigment { rgb 1 } finish { phong 1 }\n"
        "  texture { finish { diffuse .5 } scale 3 pigment { rgb .5 translate 1 } } finish { ambient 0 } }");
    m = material_of(&r, 0);
    assert_true(m->finish.phong == 0.0f && m->finish.diffuse == 0.5f && m->pigment.g == 0.5f);
    assert_true(colour_is_black(m->finish.ambient) && m->interior.ior == 2.0);
    reading_end(&r);
}

/* As POV-Ray takes them; materials that are the same are kept once. */
static void names_of_parts_stand_right_in_a_texture(void **state)
{
    static const char *const pairs[][2] = {
        { "P", "pigment { P }" },
        { "F P", "finish { F } pigment { P }" },
        { "T F", "T finish { F }" },
        { "T Ps[1] N scale 2", "T pigment { Ps[1] } normal { N } scale 2" },
        { "bozo texture_map { [0 P][1 T] }", "bozo texture_map { [0 pigment { P }][1 T] }" },
        { "P finish { phong 1 }", "pigment { P } finish { phong 1 }" },
    };
    (void)state;

    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        char text[768];
        reading r;

        snprintf(text, sizeof text,
                 "#version 3.7; #declare P = pigment { rgb x } #declare N = normal { bumps }\n"
                 "#declare F = finish { ambient 1 } #declare T = texture { pigment { bozo } }\n"
                 "#declare Ps = array[2] { P, pigment { granite } } sphere { 0, 1 texture { %s } } sphere { 0, 1 texture { %s } }",
                 pairs[i][0], pairs[i][1]);
        read_text(&r, text);
        assert_int_equal(r.model.leaves.count, 2);
        assert_int_equal(r.model.materials.count, 1);
        reading_end(&r);
    }
}

static void an_opaque_layer_hides_the_one_below(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "sphere { 0, 1 texture { pigment { rgb 1 } } texture { pigment { rgb .5 } } }");
    assert_true(material_of(&r, 0)->pigment.r == 0.5f);
    reading_end(&r);
}

static void flags_are_kept_and_inverse_undoes_itself(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "sphere { 0, 1 no_shadow inverse hollow } sphere { 0, 1 inverse inverse } sphere { 0, 1 }");
    assert_int_equal(r.model.leaves.items[0].flags, LEAF_NO_SHADOW | LEAF_INVERSE | LEAF_HOLLOW);
    assert_int_equal(r.model.leaves.items[1].flags, 0);
    assert_int_equal(r.model.leaves.items[2].flags, 0);
    reading_end(&r);
}

static void a_number_switches_a_flag_off_again(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "sphere { 0, 1 hollow 0 double_illuminate off no_image 1-1 no_reflection false no_radiosity no_radiosity 0 }"
                  "sphere { 0, 1 hollow .5 double_illuminate on no_image 2 no_reflection yes no_radiosity -1 }");
    assert_int_equal(r.model.leaves.items[0].flags, 0);
    assert_int_equal(r.model.leaves.items[1].flags, LEAF_HOLLOW | LEAF_DOUBLE_ILLUMINATE | LEAF_NO_IMAGE | LEAF_NO_REFLECTION | LEAF_NO_RADIOSITY);
    reading_end(&r);
}

static void equal_materials_are_stored_once(void **state)
{
    static char text[64 * 1000 + 1];
    reading r;
    int i;

    (void)state;
    for (i = 0; i < 1000; i++)
        sprintf(text + strlen(text), "sphere { 0, 1 pigment { red %d } }\n", i % 250);
    read_text(&r, text);
    assert_int_equal(r.model.materials.count, 250);
    for (i = 0; i < 1000; i++)
        assert_true(material_of(&r, (size_t)i)->pigment.r == (float)(i % 250));
    reading_end(&r);
}

/* ---- lights ---- */

static void lights_have_place_and_colour(void **state)
{
    reading r;
    const light *l;

    (void)state;
    read_text(&r, "light_source { <1, 0, 0>, rgb <1, 2, -1> rotate <0, 0, 90> translate <0, 0, 3> }\n"
                  "light_source { 5 }");
    l = r.model.lights.items;
    assert_int_equal(r.model.lights.count, 2);
    assert_point(l[0].position, 0, 1, 3);
    assert_true(l[0].color.g == 2.0f && l[0].color.b == -1.0f);
    assert_true(colour_is_black(l[1].color) && l[1].position.z == 5.0);
    assert_int_equal(r.model.warnings, 1);
    reading_end(&r);
}

static void lights_of_other_kinds_have_an_axis(void **state)
{
    reading r;
    const light *l;

    (void)state;
    read_text(&r, "#version 3.7; light_source { <0,1,0> rgb 1 spotlight radius 60 falloff 90 point_at 0 rotate <0,0,90> }\n"
                  "light_source { 0 rgb 1 cylinder radius 2 falloff 3 tightness 4 point_at 5*x }\n"
                  "light_source { 0 rgb 1 parallel fade_distance 3 fade_power 2 shadowless }\n"
                  "light_source { 0 rgb 1 area_light 2*x, 3*y, 4, 5 adaptive 2 jitter circular rotate <0,0,90> }\n");
    l = r.model.lights.items;
    assert_int_equal(r.model.lights.count, 4);
    assert_int_equal(l[0].type, LIGHT_SPOT);
    assert_near(l[0].axis.x, 1.0, 1e-15);
    assert_near(l[0].radius, 0.5, 1e-15);
    assert_near(l[0].falloff, 0.0, 1e-15);
    assert_int_equal(l[1].type, LIGHT_CYLINDER);
    assert_true(l[1].axis.x == 1.0 && l[1].radius == 2.0 && l[1].falloff == 3.0 && l[1].tightness == 4.0);
    assert_int_equal(l[2].type, LIGHT_PARALLEL);
    assert_true(l[2].axis.z == 1.0 && light_fades(&l[2]));
    assert_int_equal(l[2].flags, LIGHT_SHADOWLESS);
    assert_int_equal(l[3].flags, LIGHT_AREA | LIGHT_CIRCULAR | LIGHT_JITTER);
    assert_near(l[3].area.axes[0].y, 2.0, 1e-15);
    assert_near(l[3].area.axes[1].x, -3.0, 1e-15);
    assert_true(l[3].area.counts[0] == 4 && l[3].area.counts[1] == 5);
    reading_end(&r);
}

static bool is_lit(const reading *r, uint32_t leaf, size_t which)
{
    return model_is_lit_by(&r->model, leaf, &r->model.lights.items[which]);
}

/* The lights are the scene's, the outer group's and the inner one's; the leaves are of the inner, the outer and no group. */
static void expect_groups(const char *outer, const char *inner, bool outer_is_global)
{
    char text[512];
    reading r;

    sprintf(text, "#version 3.7; light_source { 0 rgb 1 } light_group { light_source { 0 rgb 1 }\n"
                  "light_group { light_source { 0 rgb 1 } sphere { 0, 1 } %s } sphere { 0, 1 } %s } sphere { 0, 1 }", inner, outer);
    read_text(&r, text);
    assert_true(is_lit(&r, 0, 0) == outer_is_global && !is_lit(&r, 0, 1) && is_lit(&r, 0, 2));
    assert_true(is_lit(&r, 1, 0) == outer_is_global && is_lit(&r, 1, 1) && !is_lit(&r, 1, 2));
    assert_true(is_lit(&r, 2, 0) && !is_lit(&r, 2, 1) && !is_lit(&r, 2, 2));
    reading_end(&r);
}

static void a_group_within_a_group_has_its_own_lights(void **state)
{
    (void)state;
    expect_groups("", "", false);
    expect_groups("", "global_lights", false);
    expect_groups("global_lights", "", true);
    expect_groups("global_lights on", "global_lights off", true);
}

/* Lights 0, 1 and 2 are the scene's, the outer group's and the inner one's, as leaf 0 of the inner one has them. */
static void expect_lit(const char *text, bool by_scene, bool by_outer, bool by_inner)
{
    reading r;

    read_text(&r, text);
    assert_true(is_lit(&r, 0, 0) == by_scene && is_lit(&r, 0, 1) == by_outer && is_lit(&r, 0, 2) == by_inner);
    reading_end(&r);
}

#define LAMP "light_source { 0 rgb 1 } "

/* As POV-Ray does. */
static void lights_reach_into_groups_that_came_by_a_name(void **state)
{
    (void)state;
    expect_lit("#version 3.7; #declare Inner = light_group { " LAMP "sphere { 0, 1 } }; " LAMP "light_group { " LAMP "object { Inner } }", false, true, true);
    expect_lit("#version 3.7; #declare Inner = light_group { " LAMP "sphere { 0, 1 } }; " LAMP
               "light_group { " LAMP "union { light_group { Inner } } global_lights }", true, true, true);
    expect_lit("#version 3.7; #declare Both = light_group { " LAMP "light_group { " LAMP "sphere { 0, 1 } } }; " LAMP "object { Both }", false, true, true);
    expect_lit("#version 3.7; " LAMP "light_group { " LAMP "union { light_group { " LAMP "sphere { 0, 1 } } } }", false, false, true);
}

static void a_light_in_a_union_is_of_no_group(void **state)
{
    (void)state;
    expect_lit("#version 3.7; " LAMP "light_group { " LAMP "union { " LAMP "sphere { 0, 1 } } }", false, true, false);
    expect_lit("#version 3.7; " LAMP "light_group { " LAMP "union { " LAMP "sphere { 0, 1 } } global_lights }", true, true, true);
}

static void what_a_light_looks_like_is_an_object_without_a_shadow(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; light_source { <0,1,0> rgb 1 looks_like { sphere { 0, 1 } } projected_through { box { -1, 1 } } }\n"
                  "light_source { 0 rgb 1 }\n");
    assert_int_equal(r.model.leaves.count, 2);
    assert_int_equal(r.model.leaves.items[0].flags, LEAF_NO_SHADOW | LEAF_NO_IMAGE | LEAF_NO_REFLECTION);
    assert_int_equal(r.model.leaves.items[1].flags, LEAF_NO_SHADOW);
    assert_int_equal(r.model.lights.items[0].through, 0);
    assert_int_equal(r.model.lights.items[0].through_count, 1);
    assert_int_equal(r.model.lights.items[1].through_count, 0);
    reading_end(&r);
}

static void expect_near(pov_vec3 a, pov_vec3 b)
{
    const pov_vec3 between = pov_sub(a, b);

    assert_true(pov_dot(between, between) < 1e-30);
}

static void expect_light(const light *l, pov_vec3 axis, double first_axis)
{
    expect_near(l->axis, axis);
    expect_near(l->area.axes[0], pov_vec3_of(first_axis, 0.0, 0.0));
}

/* As POV-Ray does: what stands behind a transformation is not moved by it. */
static void a_light_is_moved_as_far_as_it_is_said(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "#declare Cone = light_source { 0 rgb 1 spotlight translate 4*y point_at <3,0,0> area_light x, z, 2, 2 }\n"
                  "light_source { Cone }\n"
                  "light_source { Cone translate 9*z }\n"
                  "union { light_source { Cone } scale 2 }\n"
                  "light_source { 0 rgb 1 spotlight point_at <3,0,0> area_light x, z, 2, 2 translate 4*y scale 3 }\n"
                  "light_source { 0 rgb 1 parallel translate y }\n");
    expect_light(&r.model.lights.items[0], pov_vec3_of(0.6, -0.8, 0.0), 1.0);
    expect_light(&r.model.lights.items[1], pov_vec3_of(0.6, -0.8, 0.0), 1.0);
    expect_light(&r.model.lights.items[2], pov_vec3_of(0.6, -0.8, 0.0), 2.0);
    expect_light(&r.model.lights.items[3], pov_vec3_of(1.0, 0.0, 0.0), 3.0);
    expect_light(&r.model.lights.items[4], pov_vec3_of(0.0, 0.0, 1.0), 0.0);
    reading_end(&r);
}

/* Its centre, and how long its third axis is. */
static void expect_first_leaf(const char *text, pov_vec3 at, double stretch)
{
    pov_vec3 centre, low;
    reading r;
    pov_affine map;

    read_text(&r, text);
    assert_true(transform_compose(r.model.leaves.items[0].map, &map));
    transform_point(&map, pov_vec3_of(0.0, 0.0, 0.0), &centre, &low);
    expect_near(centre, at);
    expect_near(transform_direction(&map, pov_vec3_of(0.0, 0.0, 1.0)), pov_vec3_of(0.0, 0.0, stretch));
    reading_end(&r);
}

/* An object of a light stands where the light is when it is named, and moves with it from there on. */
static void objects_of_a_light_are_moved_as_far_as_they_are_said(void **state)
{
    (void)state;
    expect_first_leaf("light_source { y rgb 1 scale 2 looks_like { sphere { 0, 1 } } }", pov_vec3_of(0.0, 2.0, 0.0), 1.0);
    expect_first_leaf("light_source { y rgb 1 looks_like { sphere { 0, 1 } } scale 2 }", pov_vec3_of(0.0, 2.0, 0.0), 2.0);
    expect_first_leaf("light_source { y rgb 1 looks_like { sphere { 0, 1 } scale 2 } translate y }", pov_vec3_of(0.0, 3.0, 0.0), 2.0);
    expect_first_leaf("light_source { y rgb 1 looks_like { sphere { 0, 1 } pigment { rgb x } translate x } }", pov_vec3_of(1.0, 1.0, 0.0), 1.0);
    expect_first_leaf("light_source { y rgb 1 projected_through { sphere { 0, 1 } scale 2 translate x } }", pov_vec3_of(1.0, 0.0, 0.0), 2.0);
    expect_first_leaf("light_source { y rgb 1 translate x projected_through { sphere { 0, 1 } } scale 2 }",
                      pov_vec3_of(0.0, 0.0, 0.0), 2.0);
}

static void a_moved_light_keeps_both_parts_of_its_place(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "light_source { <1e-10, 0, 0>, rgb 1 translate <1e9, 0, 0> }");
    assert_true(r.model.lights.items[0].position.x == 1e9);
    assert_true(fabs(r.model.lights.items[0].position_lo.x - 1e-10) < 1e-25);
    reading_end(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_primitive_gets_its_numbers),
        cmocka_unit_test(an_object_knows_where_it_stands),
        cmocka_unit_test(shapes_written_as_the_last_of_their_word_share_what_was_written),
        cmocka_unit_test(an_instance_is_aligned_for_vector_registers),
        cmocka_unit_test(a_plugins_warning_has_the_place_of_the_value),
        cmocka_unit_test(equal_warnings_by_the_thousand_are_only_counted),
        cmocka_unit_test(transformations_apply_in_the_order_written),
        cmocka_unit_test(a_rotation_is_left_handed),
        cmocka_unit_test(a_matrix_is_read_row_by_row_as_in_povray),
        cmocka_unit_test(a_scale_of_zero_counts_as_one_with_a_warning),
        cmocka_unit_test(what_moves_nothing_is_no_transformation),
        cmocka_unit_test(textures_have_their_defaults),
        cmocka_unit_test(modifiers_stand_in_any_order_and_number),
        cmocka_unit_test(a_texture_begins_anew_and_what_follows_changes_it),
        cmocka_unit_test(names_of_parts_stand_right_in_a_texture),
        cmocka_unit_test(an_opaque_layer_hides_the_one_below),
        cmocka_unit_test(flags_are_kept_and_inverse_undoes_itself),
        cmocka_unit_test(a_number_switches_a_flag_off_again),
        cmocka_unit_test(equal_materials_are_stored_once),
        cmocka_unit_test(lights_have_place_and_colour),
        cmocka_unit_test(lights_of_other_kinds_have_an_axis),
        cmocka_unit_test(a_group_within_a_group_has_its_own_lights),
        cmocka_unit_test(lights_reach_into_groups_that_came_by_a_name),
        cmocka_unit_test(a_light_in_a_union_is_of_no_group),
        cmocka_unit_test(what_a_light_looks_like_is_an_object_without_a_shadow),
        cmocka_unit_test(a_light_is_moved_as_far_as_it_is_said),
        cmocka_unit_test(objects_of_a_light_are_moved_as_far_as_they_are_said),
        cmocka_unit_test(a_moved_light_keeps_both_parts_of_its_place),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
