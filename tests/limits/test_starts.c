/* test_starts.c - N1: rays that start exactly on a surface. What lies at the start is not ahead of it. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/povtrace.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A start on a shape, with a normal there. Inward a closed shape is left, and a flat one is not met again. Shapes that are
 * decided in double are not grazed. */
typedef struct place { const char *shape; pov_vec3 at, normal; bool closed, in_double; } place;

#define QUADRIC "quadric { <1,1,1>, <0,0,0>, <0,0,0>, -9 }"
#define TILTED "polygon { 4, <3,0,0>, <0,3,0>, <0,0,3>, <3,0,0> }"
#define MESH "mesh { triangle { <3,0,0>, <0,3,0>, <0,0,3> } }"

static const place places[] = {
    { "sphere { <0,0,0>, 1 }", { 0, 0, -1 }, { 0, 0, -1 }, true, false },
    { "sphere { <0,0,0>, 3 }", { 1, 2, -2 }, { 1, 2, -2 }, true, false },
    { "sphere { <1,1,1>, 7 }", { 3, 4, 7 }, { 2, 3, 6 }, true, false },
    { "sphere { <1e9,0,0>, 7 }", { 1e9 + 2, 3, 6 }, { 2, 3, 6 }, true, false },
    { "sphere { <0,0,0>, 0.75 scale 4 }", { 0, 3, 0 }, { 0, 1, 0 }, true, false },
    { "sphere { <0,0,0>, 1 rotate <30,40,50> rotate <-30,0,0> rotate <30,0,0> }", { 0, 1, 0 }, { 0, 1, 0 }, true, false },
    { "sphere { <0,0,0>, 1 scale <2,3,4> }", { 0, 3, 0 }, { 0, 1, 0 }, true, false },
    { "sphere { <0,0,0>, 1 scale <2,3,4> rotate 30*y }", { 0, 3, 0 }, { 0, 1, 0 }, true, false },
    { "sphere { <0,0,0>, 1 scale <2,3,4> translate <1e6,0,7> }", { 1e6, 3, 7 }, { 0, 1, 0 }, true, false },
    { "cylinder { <0,0,0>, <1,1,1>, 1 }", { 0.5, -0.25, -0.25 }, { -1, -1, -1 }, true, false },
    { "cylinder { <0,0,0>, <0,5,0>, 5 }", { 3, 2, 4 }, { 3, 0, 4 }, true, false },
    { "cylinder { <0,0,0>, <0,5,0>, 5 }", { 1, 5, 1 }, { 0, 1, 0 }, true, false },
    { "cylinder { <0,0,0>, <0,5,0>, 5 rotate 30*y }", { 1, 5, 1 }, { 0, 1, 0 }, true, false },
    { "cylinder { <0,0,0>, <0,5,0>, 5 matrix <1,0,0,1,1,0,0,0,1,0,0,0> }", { 4, 1, 4 }, { 3, -3, 4 }, true, false },
    { "cone { <0,0,0>, 10, <0,10,0>, 0 }", { 3, 5, 4 }, { 3, 5, 4 }, true, false },
    { "cone { <0,0,0>, 10, <0,5,0>, 5 }", { 3, 5, 1 }, { 0, 1, 0 }, true, false },
    { "cone { <1,1,1>, 5, <3,3,3>, 0 }", { 2, 0, 1 }, { -1, -1, -1 }, true, false },
    { QUADRIC, { 1, 2, -2 }, { 1, 2, -2 }, true, false },
    { "quadric { <1,1,1>, <0,0,0>, <-2e6,0,0>, 999999999991 }", { 1e6 + 1, 2, -2 }, { 1, 2, -2 }, true, false },
    { "quadric { <1,0,1>, <0,0,0>, <0,0,0>, -25 }", { 3, 7, 4 }, { 3, 0, 4 }, true, false },
    { "torus { 10, 5 }", { 5, 4, 12 }, { 15, 52, 36 }, true, false },
    { "torus { 348160, 294912 }", { 344064, -294912, 53248 }, { 0, -1, 0 }, true, false },
    { "torus { 10, 5 scale <1,2,3> translate <1e6,0,7> }", { 1e6 + 5, 8, 43 }, { 15, 26, 12 }, true, false },
    { "plane { <1,2,2>, 3 }", { 1, 2, 2 }, { 1, 2, 2 }, false, false },
    { "plane { <1,1,1>, 0 }", { 1, -3, 2 }, { 1, 1, 1 }, false, false },
    { "plane { y, 0 rotate 33*y translate <5,1,9> }", { 3, 1, 2 }, { 0, 1, 0 }, false, false },
    { "plane { <-20,20,-10>, 0 matrix <2,3,3,-2,1,-2,1,1,-1,1.5454133972525597e-08,7.9453457146883011e-09,-2.0634615793824196e-08> }",
      { 0x1.098p-26, 0x1.3c8p-26, -0x1.adp-27 }, { 1, 0, 0 }, false, false },
    { "disc { <0,0,0>, <1,1,1>, 9 }", { 1, -3, 2 }, { 1, 1, 1 }, false, false },
    { "disc { <0,0,0>, y, 9 scale <1,2,3> translate <5,1,9> }", { 3, 1, 2 }, { 0, 1, 0 }, false, false },
    { TILTED, { 1, 1, 1 }, { 1, 1, 1 }, false, false },
    { TILTED, { 0.375, 2.5, 0.125 }, { 1, 1, 1 }, false, false },
    { "polygon { 4, <3,1,0>, <0,1,3>, <-3,1,-3>, <3,1,0> scale <1,2,3> rotate 33*y }", { 0, 2, 0 }, { 0, 1, 0 }, false, false },
    { "triangle { <3,0,0>, <0,3,0>, <0,0,3> }", { 0.375, 2.5, 0.125 }, { 1, 1, 1 }, false, false },
    { "triangle { <3,1,0>, <0,1,3>, <-3,1,-3> scale <1,2,3> rotate 33*y }", { 0, 2, 0 }, { 0, 1, 0 }, false, false },
    { "smooth_triangle { <3,0,0>, x, <0,3,0>, y, <0,0,3>, z }", { 0.375, 2.5, 0.125 }, { 1, 1, 1 }, false, false },
    { MESH, { 0.375, 2.5, 0.125 }, { 1, 1, 1 }, false, false },
    { MESH, { 1, 1, 1 }, { 1, 1, 1 }, false, false },
    { "box { <-1,-1,-1>, <1,1,1> }", { 0.5, 0.25, -1 }, { 0, 0, -1 }, true, false },
    { "box { <-1,-1,-1>, <1,1,1> rotate 33*y }", { 0.5, 1, 0.25 }, { 0, 1, 0 }, true, false },
    { "box { <-1,-1,-1>, <1,1,1> rotate 45*z rotate 45*z translate <1e6,0,3> }", { 1e6 + 0.5, 1, 3 }, { 0, 1, 0 }, true, false },
    { "box { <0,0,0>, <1,1,1> matrix <1,1,0,0,1,0,0,0,1,5,6,7> }", { 5.25, 6.5, 7 }, { 0, 0, -1 }, true, false },
    { "superellipsoid { <1,1> scale 2 }", { 0, 2, 0 }, { 0, 1, 0 }, true, true },
    { "superellipsoid { <0.25,0.25> rotate 33*y }", { 0, 1, 0 }, { 0, 1, 0 }, true, true },
    { "prism { 1, 4, 4, <3,0>, <0,3>, <-3,-3>, <3,0> }", { 0, 4, 0 }, { 0, 1, 0 }, true, true },
    { "prism { 1, 4, 4, <3,0>, <0,3>, <-3,-3>, <3,0> }", { 2, 2, 1 }, { 1, 0, 1 }, true, true },
    { "poly { 2, <1,0,0,0,1,0,0,1,0,-9> }", { 1, 2, -2 }, { 1, 2, -2 }, true, false },
    { "poly { 6, <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,-66> }", { 1, 1, 2 }, { 1, 1, 32 }, true, false },
    { "blob { threshold 0.5625 sphere { <0,0,0>, 2, 1 } }", { 0, 1, 0 }, { 0, 1, 0 }, true, true },
    { "sor { 4, <1,0>, <1,1>, <1,2>, <1,3> }", { 0, 2, 0.5 }, { 0, 1, 0 }, true, true },
    { "lathe { linear_spline 4, <0,0>, <5,0>, <5,5>, <0,5> }", { 3, 2, 4 }, { 3, 0, 4 }, true, true },
    { "lathe { linear_spline 4, <0,0>, <5,0>, <5,5>, <0,5> }", { 1, 5, 1 }, { 0, 1, 0 }, true, true },
    { "ovus { 2, 1 }", { 0, 3, 0 }, { 0, 1, 0 }, true, true },
    { "sphere_sweep { linear_spline 2, <0,0,0>, 3, <9,0,0>, 3 }", { 4, 3, 0 }, { 0, 1, 0 }, true, true },
    { "isosurface { function { x*x + y*y + z*z - 9 } max_gradient 20 contained_by { sphere { 0, 8 } } }", { 1, 2, -2 }, { 1, 2, -2 }, true, true },
    { "union { sphere { <0,0,0>, 3 } sphere { <0,0,0>, 1 } }", { 1, 2, -2 }, { 1, 2, -2 }, true, false },
    { "merge { sphere { <0,0,0>, 3 } sphere { <0,0,0>, 1 } }", { 1, 2, -2 }, { 1, 2, -2 }, true, false },
    { "intersection { sphere { <0,0,0>, 3 } box { <-9,-9,-9>, <9,9,9> } }", { 1, 2, -2 }, { 1, 2, -2 }, true, false },
};

static int begin(void **state)
{
    *state = scenes_context();
    return 0;
}

static int end(void **state)
{
    pov_context_destroy(*state);
    return 0;
}

static double number(uint64_t *seed)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return (double)(*seed >> 11) * 0x1p-52 - 1.0;
}

/* Any direction, or one that is nearly along the surface. */
static pov_vec3 direction(pov_vec3 normal, int turn, uint64_t *seed)
{
    const pov_vec3 v = pov_vec3_of(number(seed), number(seed), number(seed)), n = pov_unit(normal);
    const double grazing = turn % 3 ? 1.0 : pow(10.0, -8.0 * fabs(number(seed)));

    return pov_add(v, pov_scale(n, (grazing - 1.0) * pov_dot(n, v)));
}

/* Does the ray go out of the start, and meet nothing, or go in and meet something further away? */
static bool is_right(pov_tracer *tracer, const place *p, pov_vec3 dir)
{
    const double rise = pov_dot(p->normal, dir);
    const pov_vec3 to = pov_add(p->at, pov_scale(dir, 1e-3));
    pov_hit hit = POV_INIT(hit);
    const bool found = pov_trace_hit(tracer, p->at, dir, &hit);

    if (rise > 0.0 || !p->closed)
        return !found && (rise < 1e-3 || !pov_trace_blocked(tracer, p->at, to));
    return found && hit.distance > 1e-15 * -rise;
}

static long misjudged(pov_tracer *tracer, const place *p)
{
    uint64_t seed = 88172645463325252u;
    long wrong = 0;

    for (int i = 0; i < 3000; i++) {
        const pov_vec3 dir = direction(p->normal, i, &seed);

        if (fabs(pov_dot(pov_unit(p->normal), dir)) > (p->in_double ? 0.01 : 1e-9))
            wrong += !is_right(tracer, p, dir);
    }
    return wrong;
}

static long expect_places(void *context, int accuracy)
{
    const char *only = getenv("STARTS_ONLY");
    long all = 0;

    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        pov_load_desc desc = POV_INIT(desc);
        char text[512];
        pov_scene *scene;
        pov_tracer *tracer;
        pov_error err;
        long wrong;

        if (only && atoi(only) != (int)i)
            continue;
        sprintf(text, "#version 3.7; %s", places[i].shape);
        desc.accuracy = accuracy ? POV_ACCURACY_MAX : POV_ACCURACY_CERTIFIED;
        if (pov_scene_load_text(&scene, context, text, strlen(text), "starts.pov", &desc, &err) != POV_OK)
            fail_msg("%s: %s", places[i].shape, err.message);
        assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
        wrong = misjudged(tracer, &places[i]);
        if (wrong)
            print_error("%d %s: %ld of 3000\n", (int)i, places[i].shape, wrong);
        all += wrong;
        pov_tracer_destroy(tracer);
        pov_scene_destroy(scene);
    }
    return all;
}

static void n1_what_lies_at_the_start_is_not_ahead(void **state) { assert_int_equal(expect_places(*state, 0), 0); }
static void n1_nor_is_it_in_double_double(void **state) { assert_int_equal(expect_places(*state, 1), 0); }

static float *draw_by(pov_context *context, const char *text, pov_accel accel)
{
    pov_load_desc load = POV_INIT(load);
    pov_render_desc d = POV_INIT(d);
    pov_scene *scene;
    pov_error err;
    float *picture;

    load.accel = accel;
    d.width = 40;
    d.height = 30;
    if (pov_scene_load_text(&scene, context, text, strlen(text), NULL, &load, &err) < 0)
        fail_msg("%s", err.message);
    picture = scenes_render(scene, &d);
    pov_scene_destroy(scene);
    return picture;
}

/* Rows of the picture lie on the edge of a side and the cap above it. */
static void light_that_starts_on_an_edge_crosses_no_cap(void **state)
{
    static const char text[] = "#version 3.7; camera { orthographic location <0,0,-100> right 80*4/3*x up 80*y look_at 0 }"
        "light_source { <100,100,-200> rgb 1 } prism { -.5, .5, 4, <-1,-.3>, <1,0>, <-1,.3>, <-1,-.3> scale 12 "
        "translate <35,-10,0> pigment { rgbt <1,1,1,.9> } finish { ambient 0 diffuse 1 } }";
    float *tree = draw_by(*state, text, POV_ACCEL_TREE), *list = draw_by(*state, text, POV_ACCEL_NONE);

    assert_memory_equal(tree, list, 40 * 30 * 4 * sizeof *tree);
    free(tree);
    free(list);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(n1_what_lies_at_the_start_is_not_ahead, begin, end),
        cmocka_unit_test_setup_teardown(n1_nor_is_it_in_double_double, begin, end),
        cmocka_unit_test_setup_teardown(light_that_starts_on_an_edge_crosses_no_cap, begin, end),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
