/* Pigments that vary: their lists, and the space that a leaf's texture stands in. */
#include "support/check.h"
#include "support/reading.h"

#include "texture/texture.h"

#include <string.h>

static void read_text(reading *r, const char *text)
{
    reading_begin(r, text);
    if (r->status != POV_OK)
        fail_msg("%s: %d:%d %s", text, r->error.line, r->error.column, r->error.message);
}

static const material *material_of(const reading *r, size_t leaf)
{
    return &r->model.materials.items[r->model.leaves.items[leaf].material];
}

/* Red, green, blue or yellow: the squares of a leaf at a point of the world, for those of the default list. */
static char colour_at(const reading *r, uint32_t leaf, double x, double y, double z)
{
    texture_points points;
    inverse_map space;
    pigment p;

    memset(&points, 0, sizeof points);
    assert_non_null(material_of(r, leaf)->texture);
    texture_point(&points, 0, pov_vec3_of(x, y, z), pov_vec3_of(0, 0, 0));
    texture_points_map(model_texture_map(&r->model, leaf, &space), 0, 1, &points);
    pigment_eval(&r->model, material_of(r, leaf)->texture->pigment, &points, 1, &p);
    return p.color.b == 1.0f ? 'b' : p.color.g == 0.0f ? 'r' : p.color.r == 0.0f ? 'g' : 'y';
}

static void a_list_replaces_the_colours_that_it_gives(void **state)
{
    const pigment *list;
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; sphere { 0, 1 pigment { square rgbf <.5, .25, 0, .75>, color rgbt <1, 0, 1, .5> 0.125 } }");
    list = material_of(&r, 0)->texture->pigment->colours;
    assert_int_equal(material_of(&r, 0)->texture->pigment->count, 4);
    assert_true(list[0].color.r == 0.5f && list[0].color.g == 0.25f && list[0].filter == 0.75f);
    assert_true(list[1].color.b == 1.0f && list[1].transmit == 0.5f && list[1].filter == 0.0f);
    assert_true(list[2].color.r == 0.125f && list[2].color.b == 0.125f);
    assert_true(list[3].color.r == 1.0f && list[3].color.g == 1.0f && list[3].color.b == 0.0f);
    /* What a scene needs is told by the most of each. */
    assert_true(material_is_transparent(material_of(&r, 0)) && material_of(&r, 0)->pigment.g == 1.0f);
    reading_end(&r);
}

/* As in POV-Ray, where it changes none of them. */
static void an_amount_may_stand_behind_a_list_of_normals(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; sphere { 0, 1 pigment { rgb 1 } normal { checker normal { bumps } normal { dents }, .4 scale 2 } }");
    assert_int_equal(material_of(&r, 0)->texture->normal->count, 2);
    assert_true(material_of(&r, 0)->texture->normal->normals[0]->amount == 0.5f);
    reading_end(&r);
}

/* The colours of the map of `mandel` are for squares. */
static void a_mandel_of_another_exponent_is_grey(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; sphere { 0, 1 pigment { mandel 20 exponent 3 exponent 2 } } sphere { 0, 1 pigment { mandel 20 exponent 3 } }");
    assert_int_equal(material_of(&r, 0)->texture->pigment->count, 7);
    assert_int_equal(material_of(&r, 1)->texture->pigment->count, 2);
    assert_true(material_of(&r, 1)->texture->pigment->colours[1].color.r == 1.0f);
    reading_end(&r);
}

static void transformations_of_a_pigment_and_of_its_texture_move_it(void **state)
{
    inverse_map space;
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; sphere { 0, 1 pigment { square scale 2 translate <1, 0, 0> } }\n"
                  "sphere { 0, 1 texture { pigment { square scale 2 } translate <1, 0, 0> } }\n"
                  "#declare P = pigment { square scale 2 }; sphere { 0, 1 texture { pigment { P translate x } finish { } } }\n"
                  "sphere { 0, 1 pigment { square } }");
    for (uint32_t i = 0; i < 3; i++) {
        assert_int_equal(colour_at(&r, i, 1.5, 0, 1.5), 'r');
        assert_int_equal(colour_at(&r, i, 3.5, 0, 1.5), 'y');
        assert_int_equal(colour_at(&r, i, 0.5, 0, 1.5), 'y');
        assert_null(model_texture_map(&r.model, i, &space));
    }
    /* All three are the same, and the last one is its own. */
    assert_int_equal(r.model.kept_maps.count, 1);
    assert_int_equal(r.model.materials.count, 2);
    assert_int_equal(colour_at(&r, 3, 1.5, 0, 1.5), 'b');
    reading_end(&r);
}

/* As in POV-Ray: uv coordinates of a pigment of its own stay where they are; of a whole texture they are moved. */
static void what_stands_on_uv_coordinates_is_moved_within_its_own_block_only(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; sphere { 0, 1 texture { pigment { uv_mapping square scale 2 } } }\n"
                  "sphere { 0, 1 texture { pigment { uv_mapping square scale 2 } scale 3 rotate y*90 } }\n"
                  "sphere { 0, 1 texture { uv_mapping pigment { square } scale 2 } }\n"
                  "#declare P = pigment { square scale 2 }; sphere { 0, 1 pigment { uv_mapping P } }\n"
                  "#declare U = pigment { uv_mapping P }; sphere { 0, 1 pigment { U scale 3 } }\n"
                  "#declare T = texture { pigment { P } }; sphere { 0, 1 texture { uv_mapping T } }");
    assert_int_equal(r.model.kept_maps.count, 1);
    for (size_t i = 1; i < 6; i++)
        assert_ptr_equal(material_of(&r, i)->texture->pigment->pattern, material_of(&r, 0)->texture->pigment->pattern);
    reading_end(&r);
}

/* Only pigments of surfaces begin with the default one. */
static void pigments_of_the_sky_and_of_functions_do_not_begin_with_the_default(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; #default { pigment { square scale 5 } }\n"
                  "sky_sphere { pigment { square } }\n"
                  "#declare F = function { pigment { gradient x } }\n"
                  "#declare G = function { pattern { pigment_pattern { gradient x } } }\n"
                  "#if (abs(F(.25, 0, 0).red - .25) > 1e-6 | abs(G(.25, 0, 0) - .25) > 1e-6) #error \"moved\" #end\n");
    assert_null(map_table_at(&r.model.kept_maps, r.model.sky->layers[0]->pattern->map));
    reading_end(&r);
}

static void transformations_of_an_object_move_the_texture_that_stands_before_them(void **state)
{
    inverse_map space;
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; sphere { 0, 1 translate <5, 0, 0> pigment { square } translate <1, 0, 0> scale 2 }\n"
                  "sphere { 0, 1 pigment { square } translate <5, 0, 0> texture { pigment { square } } finish { } rotate y*90 }\n"
                  "#declare O = object { sphere { 0, 1 pigment { square } translate <1, 0, 0> } };\n"
                  "object { O scale 2 } object { O scale 2 pigment { square } }");
    assert_int_equal(colour_at(&r, 0, 2.5, 0, 0.5), 'r');
    assert_int_equal(colour_at(&r, 0, 1.5, 0, 0.5), 'y');
    assert_int_equal(colour_at(&r, 0, 4.5, 0, 2.5), 'b');
    /* x of the world is z of the object. */
    assert_int_equal(colour_at(&r, 1, 1.5, 0, -0.5), 'g');
    assert_int_equal(colour_at(&r, 1, 0.5, 0, -1.5), 'y');
    assert_int_equal(colour_at(&r, 2, 2.5, 0, 0.5), 'r');
    assert_int_equal(colour_at(&r, 2, 1.5, 0, 0.5), 'y');
    assert_null(model_texture_map(&r.model, 3, &space));
    reading_end(&r);
}

/* POV-Ray's pictures: the colour is plain, but what comes in its place stands where it was moved to. */
static void a_pattern_in_place_of_a_colour_stands_where_that_was_moved_to(void **state)
{
    inverse_map space;
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; sphere { 0, 1 pigment { rgb 1 } translate <1, 0, 0> pigment { square } }\n"
                  "#declare O = sphere { 0, 1 texture { pigment { rgb 1 } scale 2 } translate <1, 0, 0> }\n"
                  "object { O translate <1, 0, 0> pigment { square } translate <1, 0, 0> }\n"
                  "sphere { 0, 1 pigment { rgb 1 } translate <1, 0, 0> texture { pigment { square } } }\n"
                  "object { O texture { pigment { rgbt 1 } } } object { O texture { pigment { rgbt 1 } } translate y }");
    assert_int_equal(colour_at(&r, 0, 1.5, 0, 0.5), 'r');
    assert_int_equal(colour_at(&r, 0, 0.5, 0, 0.5), 'y');
    assert_int_equal(colour_at(&r, 1, 4, 0, 1), 'r');
    assert_int_equal(colour_at(&r, 1, 2, 0, 1), 'y');
    assert_null(model_texture_map(&r.model, 2, &space));
    assert_int_equal(r.model.leaves.items[3].material, r.model.leaves.items[4].material);
    reading_end(&r);
}

/* A union's texture is for members without one; its transformations move all. */
static void members_of_unions_stand_in_the_space_that_their_texture_was_written_in(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; union { sphere { 0, 1 translate <0, 0, 7> } sphere { 0, 1 pigment { square } translate <0, 0, 1> }\n"
                  "  union { sphere { 0, 1 } translate <9, 0, 9> } translate <3, 0, 0> pigment { square } translate <1, 0, 0> }");
    assert_int_equal(r.model.leaves.count, 3);
    assert_int_equal(colour_at(&r, 0, 1.5, 0, 0.5), 'r');
    assert_int_equal(colour_at(&r, 0, 0.5, 0, 0.5), 'y');
    assert_int_equal(colour_at(&r, 1, 0.5, 0, 1.5), 'r');
    assert_int_equal(colour_at(&r, 1, 0.5, 0, 0.5), 'g');
    assert_int_equal(colour_at(&r, 2, 1.5, 0, 0.5), 'r');
    assert_int_equal(colour_at(&r, 2, 1.5, 0, 1.5), 'g');
    reading_end(&r);
}

/* Ten thousand copies of one textured object: those that are moved have the three numbers of their place each, the others
 * nothing. The pigment's own map and its linear part are there once, and so is the linear part of all the copies. */
static void copies_share_their_texture_and_linear_map(void **state)
{
    inverse_map space;
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; #declare O = object { sphere { 0, 1 pigment { square scale 3 } } };\n"
                  "#declare I = 0; #while (I < 10000) object { O translate <mod(I, 10), 0, 0> } #declare I = I + 1; #end");
    assert_int_equal(r.model.leaves.count, 10000);
    assert_int_equal(r.model.materials.count, 1);
    assert_int_equal(r.model.kept_maps.linear_count, 2);
    assert_int_equal(r.model.kept_maps.count, 1);
    assert_int_equal(r.model.kept_maps.brief.count, 9000);
    assert_null(model_texture_map(&r.model, 9990, &space));
    assert_int_equal(colour_at(&r, 9995, 5.5, 0, 0.5), 'r');
    assert_int_equal(colour_at(&r, 9995, 4.5, 0, 0.5), 'y');
    reading_end(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_list_replaces_the_colours_that_it_gives),
        cmocka_unit_test(an_amount_may_stand_behind_a_list_of_normals),
        cmocka_unit_test(a_mandel_of_another_exponent_is_grey),
        cmocka_unit_test(transformations_of_a_pigment_and_of_its_texture_move_it),
        cmocka_unit_test(what_stands_on_uv_coordinates_is_moved_within_its_own_block_only),
        cmocka_unit_test(pigments_of_the_sky_and_of_functions_do_not_begin_with_the_default),
        cmocka_unit_test(transformations_of_an_object_move_the_texture_that_stands_before_them),
        cmocka_unit_test(a_pattern_in_place_of_a_colour_stands_where_that_was_moved_to),
        cmocka_unit_test(members_of_unions_stand_in_the_space_that_their_texture_was_written_in),
        cmocka_unit_test(copies_share_their_texture_and_linear_map),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
