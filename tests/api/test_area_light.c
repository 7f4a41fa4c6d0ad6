/* An area light of n points is n lights of a share each, whatever is in their way. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 48, HEIGHT = 36 };

/* What is seen, and the middle and the axes of the light. */
typedef struct view { const char *camera, *middle, *axes[2]; int width, height; } view;
static const view usual = { "location <1,3,-6> look_at <0,.6,0> angle 55", "<3,5,-2>", { "2*x", "<0,1,1.5>" }, WIDTH, HEIGHT };

#define HEAD "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 5 } camera { %s } #declare P = %s; #declare U = %s; #declare V = %s;\n"
#define AREA "light_source { P rgb 1 area_light U, V, 8, 8 }\n"
#define LIGHTS "#for (I, 0, 7) #for (J, 0, 7) light_source { P + (I/7-.5)*U + (J/7-.5)*V rgb 1/64 } #end #end\n"

static float *render(const view *v, const char *light, const char *body)
{
    char text[4096];

    snprintf(text, sizeof text, HEAD "%s%s", v->camera, v->middle, v->axes[0], v->axes[1], light, body);
    return scenes_draw(text, v->width, v->height, 0, 0);
}

/* Sums of 64 floats differ by their roundings. */
static void assert_alike_in(const view *v, const char *body)
{
    float *area = render(v, AREA, body), *lights = render(v, LIGHTS, body);
    double lit = 0.0;

    for (int i = 0; i < 4 * v->width * v->height; i++) {
        lit += i % 4 < 3 ? (double)area[i] : 0.0;
        if (!(fabs((double)area[i] - (double)lights[i]) < 2e-5))
            fail_msg("%s: value %d is %f, not %f", body, i, (double)area[i], (double)lights[i]);
    }
    assert_true(lit > 0.05 * v->width * v->height);
    free(area);
    free(lights);
}

static void assert_alike(const char *body) { assert_alike_in(&usual, body); }

/* The diffuse light of an area is that of its middle: here it is alike from everywhere. Only the shadows of what is not seen
 * are. */
#define LIT " finish { diffuse .8 brilliance 0 ambient 0 } }\n"
#define MATT " no_image }\n"
#define FLOOR "plane { y, 0 pigment { rgb <.9,.8,.7> }" LIT
#define SLAB "box { <-9,-.3,-9>, <9,0,9> pigment { checker rgb 1 rgb .6 }" LIT

static void spheres_and_boxes_on_a_floor(void **state)
{
    (void)state;
    assert_alike(FLOOR "#for (I, -2, 2) #for (J, -2, 2) sphere { <I,.35,J>, .35" MATT "#end #end");
    assert_alike(SLAB "#for (I, -2, 2) #for (J, -2, 2) box { <I,.1,J>, <I+.4,.9,J+.3>" MATT "#end #end");
    assert_alike(SLAB "sphere { <1,2,-.5>, 1.1" MATT "box { <-2,.5,-2>, <-.2,1,1>" MATT);
}

static void shapes_that_are_turned_or_open(void **state)
{
    (void)state;
    assert_alike(FLOOR "box { -.5, .5 scale <1,.05,1> rotate <20,30,40> translate <0,1.2,0>" MATT
                 "sphere { 0, 1 scale <.9,.1,.4> rotate <50,0,20> translate <1,2,-.6>" MATT);
    assert_alike(SLAB "cylinder { <0,.1,0>, <0,1.5,0>, .4 open" MATT "cone { <1,0,1>, .6, <1,1.4,1>, 0" MATT
                 "torus { .5, .2 translate <-1,.6,0>" MATT "disc { <1.4,2.4,-.8>, <1,2,0>, .5" MATT);
}

/* What passes a turned solid, and what it hides, is told from its own space. */
static void turned_solids_that_hide_much(void **state)
{
    (void)state;
    assert_alike(FLOOR "box { -1, 1 scale <1.6,.2,.8> rotate <20,40,10> translate <0,1.4,0>" MATT "cylinder { -x, x, .4 scale <1,1,.5> rotate <0,30,20> translate <1,.7,-1>" MATT);
    assert_alike(SLAB "cone { -y, .8, y, .1 scale <1,1,.4> rotate <60,10,0> translate <-.8,1.2,.4>" MATT "sphere { 0, 1 scale <1,.3,.6> rotate <20,0,50> translate <1,2,-1>" MATT);
}

/* A torus is followed in its own space; what clips it lets light through where it ends, or where it is cut. */
static void tori_whole_and_in_parts(void **state)
{
    (void)state;
    assert_alike(FLOOR "torus { 1, .3 rotate <70,20,0> translate <0,1.4,0>" MATT "torus { .6, .2 scale <1,2,.5> rotate 30 translate <1.4,.8,-1>" MATT);
    assert_alike(FLOOR "torus { 1, .4 rotate 90*x clipped_by { box { <-1.4,0,-.4>, <1.4,1.4,.4> } } translate <0,.6,0>" MATT
                 "torus { .8, .3 clipped_by { box { <-2,-.1,-2>, <.3,.2,2> } rotate 20*y } translate <1,2,-1>" MATT);
    assert_alike(SLAB "difference { torus { 1, .4 rotate 90*x } box { <0,-2,-.4>, <2,0,.4> } translate 1.4*y" MATT
                 "intersection { torus { .7, .25 } box { -1, <1,1,.2> } rotate <20,0,50> translate <1,2,-1>" MATT);
    assert_alike(SLAB "difference { cylinder { -.3*y, .3*y, .9 } torus { .6, .25 } rotate 50*z translate <0,1.2,0>" MATT
                 "difference { torus { .9, .3 } torus { .6, .4 } sphere { x, .5 } rotate 60*x translate <1,1.6,-1>" MATT
                 "torus { .5, .3 clipped_by { sphere { .4*x, .6 inverse } } translate <-1,2,-1>" MATT "torus { .2, .3 translate <-1.4,.6,0>" MATT);
}

/* Light goes through holes, however many of them there are. */
static void plates_with_holes(void **state)
{
    (void)state;
    assert_alike(FLOOR "difference { box { <-2,1,-2>, <2,1.2,2> } box { <-.7,0,-.7>, <.7,3,.7> rotate 30*y } cylinder { <1.4,0,-1>, <1.4,2,-1>, .5 }" MATT);
    assert_alike(FLOOR "difference { box { -2, 2 scale <1,.05,1> rotate <10,45,0> translate y } sphere { <.3,1,0>, 1 } rotate 20*z" MATT);
    assert_alike(FLOOR "difference { box { <.9,2.5,-2.1>, <3.1,2.6,0> } #for (I, 0, 6) cylinder { 0, 3*y, .17 translate <1.6+.4*mod(I,3),0,-1.5+.4*int(I/3)> } #end" MATT);
    assert_alike(FLOOR "difference { cylinder { .8*y, 2*y, 1.5 } cylinder { 0, 3*y, 1.3 }" MATT);
}

static void solids_made_of_others_and_meshes(void **state)
{
    (void)state;
    assert_alike(SLAB "difference { box { <-.6,0,-.6>, <.6,1.2,.6> } sphere { <.6,1.2,-.6>, .7 }" MATT
                 "intersection { sphere { <1.5,.6,0>, .6 } sphere { <1.8,.8,0>, .6 }" MATT "object { sphere { <-1.5,.7,0>, .7 } clipped_by { plane { y, .8 } }" MATT);
    assert_alike(FLOOR "mesh { triangle { <-1,.2,0>, <1,.3,.4>, <0,1.5,0> } triangle { <1,.3,.4>, <0,1.5,0>, <1,2,-.5> }" MATT
                 "triangle { <-2,.1,-1>, <-1,.1,-1.2>, <-1.4,1.2,-.8>" MATT);
}

/* What members of a tree show is looked for one by one. */
static void rooms_made_of_planes(void **state)
{
    (void)state;
    assert_alike("union { plane { z, 0 inverse translate <0,0,4> } plane { y, 0 } plane { <1,0,.3>, -3 }"
                 " clipped_by { box { <-60,-.5,-60>, <60,70,60> } } pigment { rgb .9 }" LIT "sphere { <0,.5,0>, .5" MATT);
    assert_alike("intersection { plane { y, 8 } plane { -y, 0 } plane { x, 7 } plane { -x, 6 } plane { z, 5 } plane { -z, 9 } inverse"
                 " pigment { rgb .9 }" LIT "cylinder { <1,0,0>, <1,1,.3>, .4" MATT);
    assert_alike(FLOOR "intersection { plane { y, 4.9 rotate 30*z } plane { -y, -4.5 rotate 20*x } plane { <1,0,1>, 9 }"
                 " sphere { <2,4,-2>, 9 } cylinder { <3,0,-2>, <3,9,-2>, .4 inverse }" MATT);
    assert_alike("difference { plane { y, 0 } box { <-1,-.6,-.8>, <.6,1,.9> } box { <-2,-.4,-.5>, <0,1,.5> } pigment { rgb .9 }" LIT
                 "merge { sphere { <0,1,0>, .4 } box { <.5,.5,-1>, <.9,.9,1> }" MATT);
}

static void glass_and_what_casts_no_shadow(void **state)
{
    (void)state;
    assert_alike(FLOOR "sphere { <0,.7,0>, .6 no_image pigment { rgbf <1,.5,.4,.8> } } box { <1,.2,0>, <1.5,1.4,.6> no_image pigment { rgbt <.5,1,.4,.6> } }");
    assert_alike(FLOOR "sphere { <0,.7,0>, .6 no_shadow" MATT "sphere { <1.2,.7,0>, .5 no_image pigment { checker rgb 1 rgbt <1,1,1,.7> scale .2 } }");
}

/* Light leaves the box that clips a curved wall before it can come upon the wall again, or it does not. */
static void curved_walls_that_are_clipped(void **state)
{
    static const char *const walls[] = { "cylinder { -9*x, 9*x, 3 } clipped_by { box { <-9,-3,0>, <9,0,3> } }", "cylinder { -9*x, 9*x, 3 } clipped_by { box { <-9,-3,-3>, <9,-1,3> } }",
                                         "cylinder { -9*x, 9*x, 2 } clipped_by { box { <-9,-3,-1.7>, <9,1.9,3> } }" };

    (void)state;
    for (size_t i = 0; i < sizeof walls / sizeof walls[0]; i++) {
        char body[512];

        snprintf(body, sizeof body, "object { %s translate <0,3.1,0> pigment { rgb .8 }" LIT FLOOR, walls[i]);
        assert_alike(body);
    }
}

/* All of the light that crosses one solid of glass and nothing else is dimmed alike: on its way out of it too, and out of the floor. */
#define GLASS " pigment { rgbf <.9,.7,.5,.8> } finish { ambient 0 diffuse 0 } }\n"

static void solids_of_glass_that_light_crosses(void **state)
{
    (void)state;
    assert_alike(FLOOR "box { <-1.5,0,-.6>, <.2,1,.7>" GLASS "cylinder { <1,0,0>, <1,1.2,0>, .5" GLASS "sphere { <0,2,1>, .4" MATT);
    assert_alike(SLAB "box { -.6, .6 rotate <0,30,0> translate <0,.6,0>" GLASS "box { <-.2,.3,-1>, <1.8,.6,.4>" GLASS "sphere { <-1.4,.5,0>, .5" GLASS);
    assert_alike(FLOOR "box { <-1.5,0,-.6>, <.2,1,.7>" GLASS "box { <-1.5,0,-.6>, <.2,.4,.2>" GLASS "cylinder { <1,0,0>, <1,1.2,0>, .5 open" GLASS);
    assert_alike(FLOOR "sphere { <3,5,-2>, .5" GLASS "sphere { <3,4.5,-2>, 1.6" GLASS);
    assert_alike(FLOOR "box { <-5,0,-5>, <5,4.9,5>" GLASS "sphere { <0,1,0>, .8" GLASS);
}

/* Seen from both sides, and lit on both. */
#define PANE " pigment { rgbt <.9,.7,.5,.6> } double_illuminate" LIT

/* Rays of the camera hit edges, corners and rims exactly: light leaves the solid once, or at once. */
static void light_leaves_solids_at_their_edges(void **state)
{
    static const view edges = { "location <0,0,-5> direction z up y right x", "<.5,.25,8>", { "4*x", "4*y" }, 39, 38 };
    static const char *const solids[] = { "box { -1, 1", "box { <-1,-1,-1>, <0,1,3>", "cylinder { -z, z, 1", "cylinder { -y, y, 1", "cone { -z, 1, z, .5",
                                          "box { -1, 1 matrix <.5,.5,0,-.5,.5,0,0,0,1,0,0,0>", "box { -1, 1 matrix <1,0,0,0,1,0,.25,.5,1,0,0,0>" };

    (void)state;
    for (size_t i = 0; i < sizeof solids / sizeof solids[0]; i++) {
        char body[512];

        snprintf(body, sizeof body, "%s" PANE, solids[i]);
        assert_alike_in(&edges, body);
    }
}

/* On a line that is on two surfaces, only a part of the light goes into one of them. */
static void light_leaves_lines_on_two_surfaces(void **state)
{
    static const view line = { "location <0,1.5,-5> direction z up y right x", "<0,.25,8>", { "1.5*x", "4*y" }, 38, 38 };

    (void)state;
    assert_alike_in(&line, "box { -1, 1" PANE "plane { y, .5" PANE);
    assert_alike_in(&line, "plane { -y, -.5" PANE "box { -1, 1" PANE);
}

/* A solid so close below a surface that points cannot be told from its own: light passes its edge. */
static void light_passes_solids_close_below(void **state)
{
    static const view above = { "location <1.9,1,0> direction -y up z*.3 right x*.2", "<6,-.027,0>", { "z", "-.05*y" }, 36, 36 };

    (void)state;
    assert_alike_in(&above, "plane { y, .001" PANE "box { <-2,-2,-2>, <2,0,2>" PANE);
}

/* How much of the light is left depends on its way through the solid, or on nothing but what it crosses. */
static void solids_that_dim_light_by_its_way(void **state)
{
    (void)state;
    assert_alike(FLOOR "box { <-1.5,.1,-1>, <1,1.4,.8> interior { fade_distance .5 fade_power 2 fade_color rgb .2 }" PANE);
    assert_alike("media { absorption .05 }" FLOOR "box { <-1.5,.1,-1>, <1,1.4,.8> hollow" PANE);
}

static void a_room_with_the_light_in_it(void **state)
{
    (void)state;
    assert_alike("box { <-8,0,-8>, <8,9,8> inverse pigment { rgb .9 }" LIT "sphere { <3,5,-2>, .3 no_shadow" MATT "sphere { <1,1,0>, 1" MATT);
    assert_alike("sphere { 0, 40 hollow pigment { gradient y } finish { ambient 1 diffuse 0 } }" FLOOR "box { <-1,0,-1>, <0,1,1>" MATT);
    assert_alike(FLOOR "plane { -z, -4 pigment { rgb .8 }" LIT "plane { <-1,.2,0>, 5" MATT "sphere { <3,4.8,-2>, .2" MATT);
}

/* The light lies on the ceiling: not one ray to it is cut off, wherever the grid's points move to. */
static void a_ceiling_does_not_hide_the_light_on_it(void **state)
{
    static const char *const grids[] = { "", "jitter", "jitter adaptive 0" };
    static const char *const ceilings[] = {
        "plane { y, 5.488 pigment { rgb 1 } }",
        "triangle { <-99,5.488,-99>, <99,5.488,-99>, <0,5.488,99> pigment { rgb 1 } }",
    };

    (void)state;
    for (size_t g = 0; g < sizeof grids / sizeof grids[0]; g++)
        for (size_t k = 0; k < sizeof ceilings / sizeof ceilings[0]; k++) {
            char light[256], room[512];
            float *with, *without;

            snprintf(light, sizeof light, "light_source { <2.78,5.488,-1.3> rgb 1 area_light 1.3*x, 1.05*z, 4, 4 %s }\n", grids[g]);
            snprintf(room, sizeof room, "%s%s", FLOOR "sphere { <0,.5,0>, .5 pigment { rgb 1 } }", ceilings[k]);
            with = render(&usual, light, room);
            without = render(&usual, light, FLOOR "sphere { <0,.5,0>, .5 pigment { rgb 1 } }");
            for (int i = 4 * WIDTH * HEIGHT / 2; i < 4 * WIDTH * HEIGHT; i++)   /* below the ceiling */
                if (with[i] != without[i])
                    fail_msg("%s below %s: value %d is %f, not %f", grids[g], ceilings[k], i, (double)with[i], (double)without[i]);
            free(with);
            free(without);
        }
}

/* POV-Ray's shadows show it: parallel light from a point of the area goes where the middle's points at. */
static void each_point_of_a_parallel_light_has_a_direction_of_its_own(void **state)
{
    static const char body[] = FLOOR "sphere { <0,1,0>, .4" MATT "box { <-2,.5,-1>, <-1,.8,1>" MATT "sphere { <3,3,3>, .3" MATT;
    float *area = render(&usual, "light_source { <4,5,-2> rgb 1 parallel point_at <1,0,.5> area_light <3,-1,0>, y, 2, 1 }\n", body);
    float *lights = render(&usual, "light_source { <5.5,4.5,-2> rgb .5 parallel point_at <1,0,.5> }"
                           "light_source { <2.5,5.5,-2> rgb .5 parallel point_at <1,0,.5> }\n", body);

    (void)state;
    for (int i = 0; i < 4 * WIDTH * HEIGHT; i++)
        if (!(fabs((double)area[i] - (double)lights[i]) < 2e-5))
            fail_msg("value %d is %f, not %f", i, (double)area[i], (double)lights[i]);
    free(area);
    free(lights);
}

static double floor_at(const char *place, const char *words)
{
    char text[512];
    float *picture;
    double light;

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 } plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n"
             "camera { location <%s> + 4*y look_at <%s> angle 1 } light_source { <0, 1, 0>, rgb 1 %s point_at <3, -2, 0> }\n", place, place, words);
    picture = scenes_draw(text, 1, 1, 1, 1);
    light = (double)picture[0];
    free(picture);
    return light;
}

/* As measured: a cone of parallel light has no angle, but shines only ahead. */
static void parallel_spotlights_shine_ahead(void **state)
{
    (void)state;
    assert_true(floor_at("-5, 0, 0", "parallel") > 0.7 && floor_at("-5, 0, 0", "parallel") == floor_at("5, 0, 0", "parallel"));
    assert_true(floor_at("5, 0, 0", "spotlight parallel radius 2 falloff 3") == floor_at("5, 0, 0", "parallel"));
    assert_true(floor_at("-.9, 0, 0", "parallel spotlight") == floor_at("5, 0, 0", "parallel"));
    assert_true(floor_at("-1.1, 0, 0", "parallel spotlight") == 0.0 && floor_at("-5, 0, 0", "spotlight parallel") == 0.0);
    assert_true(floor_at("-5, 0, 0", "spotlight parallel shadowless") > 0.7);
}

/* What POV-Ray 3.7 shows of a floor: with area_illumination each point has its own cone and fades over its own way, those of a grid that
 * turns to the lit point, too. */
static void points_that_turn_have_cones_of_their_own(void **state)
{
    static const char *const places[3] = { ".5, 0, -.2", "1.5, 0, .8", "-1, 0, .3" };
    static const struct { const char *light; double given[3]; } lights[] = {
        { "spotlight point_at 0 radius 10 falloff 20 area_light 2*x, 2*z, 2, 2 orient", { 0.74821, 0.32029, 0.50814 } },
        { "fade_distance 2 fade_power 2 area_light 3*x, 3*z, 3, 2 orient", { 0.20760, 0.17099, 0.16315 } },
        { "spotlight point_at 0 radius 5 falloff 20 tightness 2 area_light 2*x, 2*z, 3, 3 circular orient", { 0.65852, 0.25655, 0.49413 } },
    };

    (void)state;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            char text[1024];
            float *picture;

            snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 } plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n"
                     "camera { location <%s> + 4*y look_at <%s> angle 1 } light_source { <1, 5, -2>, rgb 1 %s area_illumination }\n",
                     places[k], places[k], lights[i].light);
            picture = scenes_draw(text, 1, 1, 1, 1);
            if (fabs((double)picture[0] - lights[i].given[k]) > 2e-5)
                fail_msg("%f, not %f at %s: %s", (double)picture[0], lights[i].given[k], places[k], lights[i].light);
            free(picture);
        }
}

/* With area_illumination light comes from each point, but a film is that of the light's middle, as measured. */
static void films_are_those_of_the_middle(void **state)
{
    static const double waves[3] = { 0.7, 0.52, 0.48 };
    const double mean = 2.0 / sqrt(6.0);
    float *picture = scenes_draw("#version 3.7; global_settings { assumed_gamma 1 } camera { orthographic location -9*z right .001*x up .001*y }\n"
                                 "light_source { -2*z rgb 1 area_light 2*x, 2*y, 2, 2 area_illumination }\n"
                                 "plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse .5 irid { .8 thickness .4 } } }\n", 1, 1, 1, 1);
    (void)state;

    for (int c = 0; c < 3; c++) {
        const double wanted = 0.5 * mean * (1.0 + 0.8 * cos(2.0 * 3.14159265358979323846 * 0.4 * 2.0 / waves[c]));

        if (fabs((double)picture[c] - wanted) > 1e-4)
            fail_msg("%f, not %f", (double)picture[c], wanted);
    }
    free(picture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spheres_and_boxes_on_a_floor),
        cmocka_unit_test(shapes_that_are_turned_or_open),
        cmocka_unit_test(turned_solids_that_hide_much),
        cmocka_unit_test(tori_whole_and_in_parts),
        cmocka_unit_test(plates_with_holes),
        cmocka_unit_test(solids_made_of_others_and_meshes),
        cmocka_unit_test(rooms_made_of_planes),
        cmocka_unit_test(glass_and_what_casts_no_shadow),
        cmocka_unit_test(curved_walls_that_are_clipped),
        cmocka_unit_test(solids_of_glass_that_light_crosses),
        cmocka_unit_test(light_leaves_solids_at_their_edges),
        cmocka_unit_test(light_leaves_lines_on_two_surfaces),
        cmocka_unit_test(light_passes_solids_close_below),
        cmocka_unit_test(solids_that_dim_light_by_its_way),
        cmocka_unit_test(a_room_with_the_light_in_it),
        cmocka_unit_test(parallel_spotlights_shine_ahead),
        cmocka_unit_test(points_that_turn_have_cones_of_their_own),
        cmocka_unit_test(films_are_those_of_the_middle),
        cmocka_unit_test(each_point_of_a_parallel_light_has_a_direction_of_its_own),
        cmocka_unit_test(a_ceiling_does_not_hide_the_light_on_it),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
