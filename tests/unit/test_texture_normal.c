/* Perturbed normals: what is added to them, in which space, and how they are mixed. */
#include "support/near.h"
#include "support/reading.h"
#include "texture/normal.h"

#include <stdio.h>
#include <string.h>

static const pov_vec3 up = { 0.0, 1.0, 0.0 }, place = { 0.3, 0.7, -1.2 };
/* Vector noise and noise there, as measured. */
static const pov_vec3 noise_there = { 0.026545177252096, 0.223682093664635, 0.244694941066189 };
static const double value_there = 0.528537371654271;

static pov_vec3 perturbed(const char *text, pov_vec3 at, pov_vec3 normal)
{
    const pov_vec3 zero = pov_vec3_of(0.0, 0.0, 0.0);
    char scene[512];
    texture_points points;
    texture_term term;
    inverse_map space;
    const inverse_map *map;
    reading r;

    snprintf(scene, sizeof scene, "#version 3.7; sphere { 0, 1 %s %s }", strstr(text, "texture") ? "" : "pigment { rgb 1 }", text);
    reading_begin(&r, scene);
    if (r.status != POV_OK)
        fail_msg("%s: %s", text, r.error.message);
    memset(&points, 0, sizeof points);
    points.has_surface = points.has_uv = points.has_view = true;
    map = model_texture_map(&r.model, 0, &space);
    texture_point(&points, 0, at, zero);
    texture_points_map(map, 0, 1, &points);
    points.linear[0] = map ? map->linear : NULL;
    lanes_put(&points.uv, 0, place);
    lanes_put(&points.normal, 0, normal);
    lanes_put(&points.view, 0, pov_scale(normal, -1.0));
    assert_int_equal(texture_eval(&r.model, r.model.materials.items[0].texture, &points, 1, &term), 1);
    reading_end(&r);
    assert_true(term.bent);
    return term.normal;
}

static void assert_normal(pov_vec3 found, pov_vec3 wanted)
{
    const pov_vec3 unit = pov_unit(wanted);

    assert_near(found.x, unit.x, 1e-7);   /* amounts are floats */
    assert_near(found.y, unit.y, 1e-7);
    assert_near(found.z, unit.z, 1e-7);
}

static pov_vec3 plus(pov_vec3 a, pov_vec3 b, double amount) { return pov_add(a, pov_scale(b, amount)); }

static void bumps_and_dents_add_vector_noise(void **state)
{
    (void)state;
    assert_normal(perturbed("normal { bumps .4 }", place, up), plus(up, noise_there, 0.4));
    assert_normal(perturbed("normal { bumps }", place, up), plus(up, noise_there, 0.5));
    assert_normal(perturbed("normal { dents 2 }", place, up),
                  plus(up, noise_there, 2.0 * value_there * value_there * value_there));
    assert_normal(perturbed("normal { bumps .4 bump_size 3 }", place, up), plus(up, noise_there, 3.0));
}

static void other_patterns_add_their_slope(void **state)
{
    const pov_vec3 x = { 1.0, 0.0, 0.0 };
    (void)state;

    /* Four samples of a gradient: 5 * 0.02 * 4/3. */
    assert_normal(perturbed("normal { gradient x 1 }", place, up), plus(up, x, -0.4 / 3.0));
    assert_normal(perturbed("normal { gradient x 1 accuracy .001 }", place, up), plus(up, x, -0.4 / 3.0));
    assert_normal(perturbed("normal { gradient x 1 slope_map { [0 <0, .5>] [1 <.5, .5>] } }", place, up),
                  plus(up, x, -0.2 / 3.0));
    assert_normal(perturbed("normal { gradient x 1 slope_map { [.4 <1, 5>] [.5 <2, 5>] } }", place, up), up);
}

static void bumps_scale_with_their_pattern(void **state)
{
    const pov_vec3 at = pov_scale(place, 4.0), x = { 1.0, 0.0, 0.0 };
    (void)state;

    assert_normal(perturbed("normal { bumps 1 scale 4 }", at, up), plus(up, noise_there, 1.0));
    assert_normal(perturbed("normal { bumps 1 scale 4 no_bump_scale }", at, up), plus(up, noise_there, 0.25));
    assert_normal(perturbed("normal { bumps 1 scale 1e-100 }", pov_scale(place, 1e-100), up), plus(up, noise_there, 1.0));
    /* Uneven: the normal goes in as a normal does, and back. */
    assert_normal(perturbed("normal { gradient y 1 scale <1, 2, 1> }", pov_vec3_of(0.3, 1.4, -1.2), x),
                  plus(x, up, -0.4 / 3.0 / 2.0));
}

/* As in POV-Ray, with no_bump_scale too. */
static void facets_turn_by_what_their_word_says_at_any_scale(void **state)
{
    const pov_vec3 once = perturbed("normal { facets coords .4 }", place, up);
    (void)state;

    assert_true(once.y < 0.999);
    assert_normal(perturbed("normal { facets coords .4 scale 4 }", pov_scale(place, 4.0), up), once);
    assert_normal(perturbed("normal { facets coords .4 scale 4 no_bump_scale }", pov_scale(place, 4.0), up), once);
}

static void objects_take_their_bumps_along(void **state)
{
    const pov_vec3 z = { 0.0, 0.0, 1.0 };
    (void)state;

    /* Turned about x by 90 degrees, y goes to z and z to -y. */
    assert_normal(perturbed("normal { bumps 1 } rotate x*90 translate 5", pov_vec3_of(5.3, 6.2, 5.7), z),
                  plus(z, pov_vec3_of(noise_there.x, -noise_there.z, noise_there.y), 1.0));
    assert_normal(perturbed("normal { bumps 1 rotate x*90 }", pov_vec3_of(0.3, 1.2, 0.7), z),
                  plus(z, pov_vec3_of(noise_there.x, -noise_there.z, noise_there.y), 1.0));
    assert_normal(perturbed("normal { gradient x 1 warp { repeat 2*y } scale 3 }", place, up),
                  plus(up, pov_vec3_of(1.0, 0.0, 0.0), -0.4 / 3.0));
}

static void maps_mix_unit_normals(void **state)
{
    const pov_vec3 x = pov_unit(plus(up, pov_vec3_of(1.0, 0.0, 0.0), -4.0 / 3.0));
    const pov_vec3 z = pov_unit(plus(up, pov_vec3_of(0.0, 0.0, 1.0), -4.0 / 3.0));
    (void)state;

    assert_normal(perturbed("normal { gradient y normal_map { [0 gradient x 10] [1 gradient z 10] } }", place, up),
                  plus(pov_scale(x, 0.3), z, 0.7));
    assert_normal(perturbed("normal { average normal_map { [1 gradient x 10] [3 gradient z 10] } }", place, up),
                  plus(pov_scale(x, 0.25), z, 0.75));
    assert_normal(perturbed("normal { checker normal { gradient x 10 } normal { gradient z 10 } }",
                            pov_vec3_of(0.3, 0.7, -0.8), up), z);
}

/* As measured: a list that is not scaled has members that are not, and mixes normals that are not unit. */
static void a_list_without_scaled_bumps_has_no_members_with_them(void **state)
{
    const pov_vec3 at = pov_scale(place, 4.0), x = { 1.0, 0.0, 0.0 }, z = { 0.0, 0.0, 1.0 };
    (void)state;

    assert_normal(perturbed("normal { gradient y normal_map { [0 bumps 1 scale 4] [1 bumps 1 scale 4] } no_bump_scale }", at, up),
                  plus(up, noise_there, 0.25));
    assert_normal(perturbed("normal { gradient y normal_map { [0 bumps 1] [1 bumps 1] } scale 4 no_bump_scale }", at, up),
                  plus(up, noise_there, 0.25));
    assert_normal(perturbed("normal { average normal_map { [1 gradient x 10] [3 gradient z 10] } no_bump_scale }", place, up),
                  plus(plus(up, x, -1.0 / 3.0), z, -1.0));
}

/* As in POV-Ray a texture that has members is scaled as a whole, whatever their bumps say. */
static void textures_scale_the_bumps_of_their_members(void **state)
{
    const pov_vec3 at = pov_scale(place, 4.0);
    (void)state;

    assert_normal(perturbed("texture { average texture_map { [1 normal { bumps 1 no_bump_scale }] } scale 4 }", at, up),
                  plus(up, noise_there, 1.0));
    assert_normal(perturbed("texture { average texture_map { [1 normal { bumps 1 scale 2 no_bump_scale }] } scale 2 }", at, up),
                  plus(up, noise_there, 0.5));
}

/* A whole texture's turn with the object, as in POV-Ray; bumps on uv coordinates of their own and an object's do not. */
static void bumps_on_uv_coordinates_turn_with_what_they_were_said_of(void **state)
{
    const pov_vec3 z = { 0.0, 0.0, 1.0 }, x = { 1.0, 0.0, 0.0 }, y = { 0.0, -1.0, 0.0 };
    (void)state;

    assert_normal(perturbed("normal { uv_mapping gradient x 1 } rotate z*-90", place, z), plus(z, x, -0.4 / 3.0));
    assert_normal(perturbed("texture { uv_mapping normal { gradient x 1 } } rotate z*-90", place, z), plus(z, y, -0.4 / 3.0));
    assert_normal(perturbed("uv_mapping texture { normal { gradient x 1 } } rotate z*-90", place, z), plus(z, x, -0.4 / 3.0));
    assert_normal(perturbed("uv_mapping texture { average texture_map { [1 normal { gradient x 1 }] } } rotate z*-90", place, z),
                  plus(z, x, -0.4 / 3.0));
    assert_normal(perturbed("texture { uv_mapping average texture_map { [1 normal { gradient x 1 }] } } rotate z*-90", place, z),
                  plus(z, y, -0.4 / 3.0));
}

/* Where uv_mapping is a whole texture's, what moves it later moves no point, as in POV-Ray, but turns the normals. */
static void bumps_of_whole_textures_on_uv_coordinates_turn_with_what_moves_them(void **state)
{
    const pov_vec3 z = { 0.0, 0.0, 1.0 }, y = { 0.0, -1.0, 0.0 };
    (void)state;

    assert_normal(perturbed("#declare T = texture { uv_mapping normal { gradient x 1 } }; texture { T rotate z*-90 }", place, z),
                  plus(z, y, -0.4 / 3.0));
    assert_normal(perturbed("#declare T = texture { uv_mapping average texture_map { [1 normal { gradient x 1 }] } }; "
                            "texture { T rotate z*-90 }", place, z), plus(z, y, -0.4 / 3.0));
    assert_normal(perturbed("#declare T = texture { uv_mapping normal { gradient x 1 } }; #declare U = texture { T rotate z*-45 }; "
                            "texture { U rotate z*-45 }", place, z), plus(z, y, -0.4 / 3.0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bumps_and_dents_add_vector_noise),
        cmocka_unit_test(other_patterns_add_their_slope),
        cmocka_unit_test(bumps_scale_with_their_pattern),
        cmocka_unit_test(facets_turn_by_what_their_word_says_at_any_scale),
        cmocka_unit_test(objects_take_their_bumps_along),
        cmocka_unit_test(maps_mix_unit_normals),
        cmocka_unit_test(a_list_without_scaled_bumps_has_no_members_with_them),
        cmocka_unit_test(textures_scale_the_bumps_of_their_members),
        cmocka_unit_test(bumps_on_uv_coordinates_turn_with_what_they_were_said_of),
        cmocka_unit_test(bumps_of_whole_textures_on_uv_coordinates_turn_with_what_moves_them),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
