/* Blends of textures: members that are not given, and transformations around members. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define EYE "#version 3.7; camera { orthographic location <0,0,-10> direction z right .001*x up .001*y } "
#define EYES "#version 3.7; camera { location <0,1,-5> look_at 0 angle 25 } light_source { <-6,0,-7> rgb 1 } "
#define TURN " scale <1,2,.7> rotate <20,30,80> "
#define LIT " finish { ambient 1 diffuse 0 } "

static void assert_red(const char *scene, double red, double green)
{
    char text[768];
    float *p;

    snprintf(text, sizeof text, EYE "%s", scene);
    p = scenes_draw(text, 1, 1, 1, 1);
    if (fabs((double)p[0] - red) > 1e-5 || fabs((double)p[1] - green) > 1e-5)
        fail_msg("%s: %f %f, not %f %f", scene, (double)p[0], (double)p[1], red, green);
    free(p);
}

/* Colours that are not given are the pattern's own. */
static void members_that_a_list_does_not_give_are_the_defaults(void **state)
{
    (void)state;
    assert_red("sphere { 0, 1 pigment { checker rgb 1 translate <.5,.5,.5> + x }" LIT "}", 0.0, 1.0);
    assert_red("sphere { 0, 1 pigment { checker pigment { rgb 1 } translate <.5,.5,.5> + x }" LIT "}", 0.0, 0.0);
    assert_red("#default { pigment { rgb x } } sphere { 0, 1 pigment { checker pigment { rgb 1 } translate <.5,.5,.5> + x }" LIT "}", 1.0, 0.0);
    assert_red("#default { pigment { rgb x } finish { ambient .5 diffuse 0 } } "
               "sphere { 0, 1 texture { checker texture { pigment { rgb 1 } } translate <.5,.5,.5> + x } }", 0.5, 0.0);
    assert_red("sphere { 0, 1 pigment { object { sphere { 0, 2 } pigment { rgb 1 } } }" LIT "}", 0.0, 0.0);
}

/* As POV-Ray's, which warns as well. */
static void a_map_without_a_pattern_is_black(void **state)
{
    (void)state;
    assert_red("sphere { 0, 1 pigment { color_map { [0 rgb x] [1 rgb y] } }" LIT "}", 0.0, 0.0);
    assert_red("sphere { 0, 1 pigment { pigment_map { [0 rgb x] [1 rgb y] } }" LIT "}", 0.0, 0.0);
    assert_red("#default { pigment { gradient x } } sphere { 0, 1 pigment { color_map { [0 rgb x] [1 rgb x] } }" LIT "}", 1.0, 0.0);
}

/* A block without a pattern, or of one colour, leaves the map to the pattern of a later one. */
static void maps_wait_for_their_pattern(void **state)
{
#define MAP "color_map { [0 rgb <1,.5,0>] [1 rgb <1,.5,0>] }"
    (void)state;
    assert_red("sphere { 0, 1 pigment { " MAP " } pigment { bozo }" LIT "}", 1.0, 0.5);
    assert_red("#declare P = pigment { " MAP " } sphere { 0, 1 pigment { P bozo }" LIT "}", 1.0, 0.5);
    assert_red("sphere { 0, 1 pigment { bozo " MAP " } pigment { rgb 1 } pigment { wood }" LIT "}", 1.0, 0.5);
    assert_red("sphere { 0, 1 pigment { bozo " MAP " } pigment { rgb y }" LIT "}", 0.0, 1.0);
#undef MAP
}

/* The same surface, whichever way its normal is written. */
static void assert_same_bumps(const char *a, const char *b)
{
    enum { W = 12, H = 9 };
    const char *const normals[2] = { a, b };
    char text[768];
    float *p[2];

    for (int k = 0; k < 2; k++) {
        snprintf(text, sizeof text, EYES "sphere { 0, 1 pigment { rgb 1 } %s }", normals[k]);
        p[k] = scenes_draw(text, W, H, 1, 1);
    }
    assert_memory_equal(p[0], p[1], 4 * W * H * sizeof(float));
    free(p[0]);
    free(p[1]);
}

/* An amount may follow the pattern whatever stood before; of a slope_map and a normal_map the last one counts. */
static void normals_take_the_map_of_those_before(void **state)
{
#define SLOPES "slope_map { [0 <0,1>] [.5 <1,0>] [1 <0,-1>] }"
#define MEMBERS "normal_map { [0 bumps scale .2] [1 dents] }"
    (void)state;
    assert_same_bumps("normal { leopard 1 " SLOPES " } normal { onion .4 }", "normal { onion .4 " SLOPES " }");
    assert_same_bumps("normal { leopard 1 " MEMBERS " } normal { onion .4 }", "normal { onion " MEMBERS " bump_size .4 }");
    assert_same_bumps("normal { onion " MEMBERS SLOPES " }", "normal { onion " SLOPES " }");
    assert_same_bumps("normal { onion " SLOPES MEMBERS " }", "normal { onion " MEMBERS " }");
#undef SLOPES
#undef MEMBERS
}

/* Transformations that stand behind the object in its pattern move it, and not the pattern's other points. */
static void objects_of_patterns_are_moved_in_their_block(void **state)
{
    (void)state;
    assert_red("sphere { 0, 1 pigment { object { sphere { 0, 2 } translate 9*x color rgb x, color rgb y } }" LIT "}", 1.0, 0.0);
    assert_red("#declare Far = sphere { 9*x, 2 } sphere { 0, 1 pigment { object { Far scale 2 translate -18*x rgb x, rgb y } }" LIT "}", 0.0, 1.0);
}

/* A texture on a sphere that is turned looks as the whole sphere turned. */
static void bumps_turn_with_the_blend_that_they_are_in(void **state)
{
    static const char *const blends[] = {
        "bozo texture_map { [0 %s] [1 pigment { rgb .5 }] }", "checker texture { %s } texture { pigment { rgb 1 } }",
        "average texture_map { [1 %s] [1 pigment { rgb 1 }] }", "bozo texture_map { [0 marble texture_map { [0 %s] } rotate 20*z ] }",
    };
    enum { W = 12, H = 9 };
    const char *const bumps = "pigment { rgb 1 } normal { gradient x 2 sine_wave scale .2 }";
    char texture[256], text[1024];

    (void)state;
    for (size_t i = 0; i < sizeof blends / sizeof blends[0]; i++) {
        float *p[2];

        snprintf(texture, sizeof texture, blends[i], bumps);
        for (int whole = 0; whole < 2; whole++) {
            snprintf(text, sizeof text, whole ? EYES "sphere { 0, 1 scale 1 / <1,2,.7> texture { %s }" TURN "}"
                                              : EYES "sphere { 0, 1 texture { %s" TURN "} }", texture);
            p[whole] = scenes_draw(text, W, H, 1, 1);
        }
        for (int k = 0; k < 4 * W * H; k++)
            if (fabs((double)p[0][k] - (double)p[1][k]) > 1e-5)
                fail_msg("%s: number %d is %f and %f", blends[i], k, (double)p[0][k], (double)p[1][k]);
        free(p[0]);
        free(p[1]);
    }
}

/* Against POV-Ray 3.7. */
static void components_of_a_blob_share_by_their_parts_of_the_field(void **state)
{
    (void)state;
    assert_red("blob { threshold .3 sphere { <-.3,0,0>, 1, 1 pigment { rgb x }" LIT "} sphere { <.4,0,0>, 1, .7 } pigment { rgb y }" LIT "}", 0.6675, 0.3325);
    assert_red("blob { threshold .3 sphere { <-.3,0,0>, 1, 1 } sphere { <.4,0,0>, 1, -.7 pigment { rgb x }" LIT "} pigment { rgb y }" LIT "}", 0.37112, 0.62888);
    assert_red("blob { threshold .3 sphere { <-.3,0,0>, 1, 1 pigment { rgb <1,1,0> }" LIT "} sphere { <.2,0,0>, 1, .7 pigment { rgb y }" LIT "} "
               "sphere { <0,.3,0>, 1, .5 pigment { rgb x }" LIT "} sphere { <0,.3,0>, 1, .5 pigment { rgb <1,0,1> }" LIT "} "
               "sphere { <0,-.3,0>, 1, .5 pigment { rgb z }" LIT "} }", 0.5784, 0.5662);
}

#define STEEP "pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } }"

/* As that of an object: what stands behind its texture moves it, what stands before does not. */
static void transformations_of_a_component_move_its_texture(void **state)
{
    (void)state;
    assert_red("blob { threshold .3 sphere { 0, 1, 1 " STEEP LIT "translate -.25*x } }", 0.25, 0.25);
    assert_red("blob { threshold .3 sphere { 0, 1, 1 translate .25*x " STEEP LIT "translate -.5*x scale <.8,1,1> } }", 0.5, 0.5);
    assert_red("blob { threshold .3 sphere { 0, 1, 1 " STEEP "translate -.25*x" LIT "translate -.25*x } }", 0.5, 0.5);
    assert_red("blob { threshold .3 sphere { 5, 1, 1 " STEEP LIT "translate .1*x } sphere { 0, 1, 1 scale 1.1 " STEEP LIT "translate -.25*x } }", 0.25, 0.25);
    assert_red("blob { threshold .3 sphere { 0, 1, 1 " STEEP LIT "translate -.25*x } translate -.125*x }", 0.375, 0.375);
}

/* What a pigment inside of a pattern asks of the surface is there. */
static void inner_pigments_know_where_the_surface_is_seen_from(void **state)
{
    static const char *const pigments[2] = { "aoi", "pigment_pattern { aoi }" };
    enum { W = 12, H = 9 };
    float *p[2];
    char text[512];

    (void)state;
    for (int k = 0; k < 2; k++) {
        snprintf(text, sizeof text, EYES "sphere { 0, 1 pigment { %s color_map { [0 rgb 1] [1 rgb x] } } " LIT "}", pigments[k]);
        p[k] = scenes_draw(text, W, H, 1, 1);
    }
    for (int k = 0; k < 4 * W * H; k++)
        if (fabs((double)p[0][k] - (double)p[1][k]) > 1e-5)
            fail_msg("component %d: %f and %f", k, (double)p[0][k], (double)p[1][k]);
    free(p[0]);
    free(p[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(members_that_a_list_does_not_give_are_the_defaults),
        cmocka_unit_test(a_map_without_a_pattern_is_black),
        cmocka_unit_test(maps_wait_for_their_pattern),
        cmocka_unit_test(normals_take_the_map_of_those_before),
        cmocka_unit_test(objects_of_patterns_are_moved_in_their_block),
        cmocka_unit_test(components_of_a_blob_share_by_their_parts_of_the_field),
        cmocka_unit_test(transformations_of_a_component_move_its_texture),
        cmocka_unit_test(inner_pigments_know_where_the_surface_is_seen_from),
        cmocka_unit_test(bumps_turn_with_the_blend_that_they_are_in),
    };

    return cmocka_run_group_tests_name("blends of textures", tests, NULL, NULL);
}
