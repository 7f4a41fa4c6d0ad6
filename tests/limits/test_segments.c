/* test_segments.c - N2 and N3: segments that end on a surface, or as near to it as doubles are. */
#include "support/check.h"
#include "support/limits.h"
#include "support/scenes.h"

#include <povtrace/exact.h>

#include <stdio.h>
#include <stdlib.h>

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

static uint64_t next(uint64_t *seed)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    return *seed ^= *seed << 17;
}

static double number(uint64_t *seed) { return (double)(next(seed) >> 11) * 0x1p-52 - 1.0; }

static pov_vec3 direction(uint64_t *seed)
{
    pov_vec3 v;

    do
        v = pov_vec3_of(number(seed), number(seed), number(seed));
    while (pov_dot(v, v) > 1.0 || pov_dot(v, v) < 0.1);
    return pov_unit(v);
}

/* ---- whether segments are blocked ---- */

/* Shapes that are the unit sphere near the points that are asked. */
static const char *const spheres[] = {
    "sphere { <0,0,0>, 1 }",
    "quadric { <1,1,1>, <0,0,0>, <0,0,0>, -1 }",
    "sphere { <0,0,0>, 2 scale 0.5 rotate <30,40,50> rotate <-30,0,0> rotate <30,0,0> }",
    "intersection { sphere { <0,0,0>, 1 } box { <-2,-2,-2>, <2,2,2> } }",
};

/* |v|^2 - 1, exactly but for its last bits. */
static double outside_sphere(pov_vec3 v)
{
    const pov_two x = pov_two_product(v.x, v.x), y = pov_two_product(v.y, v.y), z = pov_two_product(v.z, v.z);

    return pov_two_add_double(pov_two_add(pov_two_add(x, y), z), -1.0).hi;
}

/* A segment from far away to a point at a sphere: whether it is blocked is a matter of the side of the tangent plane that
 * it comes from, and of the side of the sphere that its end is on. */
static long misjudged_sphere(pov_tracer *tracer, double height, double distance, uint64_t *seed)
{
    const pov_vec3 normal = direction(seed), from = direction(seed);
    const pov_vec3 target = pov_scale(normal, 1.0 + height), eye = pov_add(target, pov_scale(from, distance));
    const double rise = pov_dot(from, normal), height_found = outside_sphere(target);

    if (fabs(rise) < 0.01 || distance * fabs(rise) < 3.0 || fabs(height_found) < 0x1p-92 * distance)
        return 0;
    return pov_trace_blocked(tracer, eye, target) != (rise < 0.0 || height_found < 0.0);
}

/* Shapes with a planar face at x = 1 that reaches to 2 at least; a point on it is on it exactly. */
static const char *const faces[] = {
    "box { <-3,-3,-3>, <1,3,3> }",
    "cylinder { <-3,0,0>, <1,0,0>, 3 }",
    "cone { <-3,0,0>, 4, <1,0,0>, 3 }",
    "plane { <1,0,0>, 1 }",
    "polygon { 5, <1,-3,-3>, <1,3,-3>, <1,3,3>, <1,-3,3>, <1,-3,-3> }",
    "box { <-3,-3,-3>, <3,1,3> rotate <0,0,-90> }",
    "difference { box { <-3,-3,-3>, <4,3,3> } box { <1,-4,-4>, <5,4,4> } }",
};

/* Half of the directions graze the face, down to a cosine of 1e-4. */
static pov_vec3 face_direction(uint64_t *seed)
{
    const pov_vec3 v = direction(seed);
    const double graze = number(seed) < 0.0 ? pow(10.0, -4.0 * fabs(number(seed))) : 1.0;

    return pov_unit(pov_vec3_of(v.x * graze, v.y, v.z));
}

/* Nothing is between a face and what is in front of it; from behind, the face is before ends beyond it and not before
 * ends on it. */
static long misjudged_face(pov_tracer *tracer, double height, double distance, bool is_solid, uint64_t *seed)
{
    const pov_vec3 target = pov_vec3_of(1.0 + height, number(seed), number(seed)), from = face_direction(seed);
    const pov_vec3 eye = pov_add(target, pov_scale(from, distance));
    const bool in_front = from.x > 0.0;

    if (fabs(from.x) < 1e-4 || distance * fabs(from.x) < 8.0)
        return 0;
    if (in_front)
        return pov_trace_blocked(tracer, eye, target) != (target.x < 1.0);
    return pov_trace_blocked(tracer, eye, target) != (target.x > 1.0 || is_solid);
}

/* The number of a shape's segments that are misjudged, from near and far, by their end's distance from the surface. */
static long misjudged(pov_tracer *tracer, bool is_sphere, bool is_solid)
{
    uint64_t seed = 88172645463325252u;
    long wrong = 0;

    for (double distance = 10.0; distance < 1e13; distance *= 100.0)
        for (double height = 1e-5; height > 1e-17; height *= 0.1)
            for (int i = 0; i < 200; i++) {
                const double signed_height = i % 2 ? height : -height;

                wrong += is_sphere ? misjudged_sphere(tracer, signed_height, distance, &seed)
                                   : misjudged_face(tracer, signed_height, distance, is_solid, &seed);
            }
    return wrong;
}

static void expect_judged(void *context, const char *shape, bool is_sphere, bool is_solid)
{
    pov_scene *scene = scenes_text(context, shape);
    pov_tracer *tracer;
    pov_error err;
    long wrong;

    assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
    wrong = misjudged(tracer, is_sphere, is_solid);
    if (wrong)
        print_error("%s: %ld\n", shape, wrong);
    assert_int_equal(wrong, 0);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
}

static void n2_segments_that_end_at_a_sphere_are_judged_by_their_ends(void **state)
{
    for (size_t s = 0; s < sizeof spheres / sizeof *spheres; s++)
        expect_judged(*state, spheres[s], true, true);
}

static void n2_segments_that_end_at_a_face_are_judged_by_their_ends(void **state)
{
    for (size_t s = 0; s < sizeof faces / sizeof *faces; s++)
        expect_judged(*state, faces[s], false, s != 3 && s != 4);
}

/* Flat shapes in the plane 2 x + 3 y + 6 z = 0, about the points u <3,-2,0> + v <0,-2,1> of whole u and v up to 9. */
static const char *const tilted[] = {
    "plane { <2,3,6>, 0 }",
    "disc { <0,0,0>, <2,3,6>, 90 }",
    "triangle { <-90,60,0>, <90,60,-60>, <0,-120,60> }",
    "polygon { 5, <-90,60,0>, <90,60,-60>, <90,-60,0>, <-90,-60,60>, <-90,60,0> }",
    "smooth_triangle { <-90,60,0>, <2,3,6>, <90,60,-60>, <2,3,6>, <0,-120,60>, <2,3,6> }",
    "mesh { triangle { <-90,60,0>, <90,60,-60>, <0,-120,60> } }",
    "box { <-90,-90,-90>, <90,0,90> matrix <3,-2,0, 2,3,6, 0,-2,1, 0,0,0> }",
};

/* Seen from the front at any angle down to a cosine of 1e-4, what a segment ends on is not in its way. */
static long misjudged_tilted(pov_tracer *tracer)
{
    const pov_vec3 normal = { 2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0 };
    uint64_t seed = 362436069u;
    long wrong = 0;

    for (double distance = 10.0; distance < 1e13; distance *= 10.0)
        for (int i = 0; i < 300; i++) {
            const double u = floor(9.0 * number(&seed)), v = floor(9.0 * number(&seed)), cosine = pow(10.0, -4.0 * fabs(number(&seed)));
            const pov_vec3 at = pov_vec3_of(3.0 * u, -2.0 * (u + v), v), d = direction(&seed);
            const pov_vec3 along = pov_unit(pov_add(pov_sub(d, pov_scale(normal, pov_dot(d, normal))), pov_scale(normal, cosine)));

            wrong += pov_trace_blocked(tracer, pov_add(at, pov_scale(along, distance)), at);
        }
    return wrong;
}

static void n2_segments_that_graze_the_face_that_they_end_on_are_free(void **state)
{
    for (size_t s = 0; s < sizeof tilted / sizeof *tilted; s++) {
        pov_scene *scene = scenes_text(*state, tilted[s]);
        pov_tracer *tracer;
        pov_error err;
        long wrong;

        assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
        wrong = misjudged_tilted(tracer);
        if (wrong)
            print_error("%s: %ld\n", tilted[s], wrong);
        assert_int_equal(wrong, 0);
        pov_tracer_destroy(tracer);
        pov_scene_destroy(scene);
    }
}

/* ---- lights that lie on surfaces ---- */

/* A light that lies on a shape at <0, 1, 0> or at a unit in the last place from there, and what of it reaches a wall below
 * that height and above it. */
typedef struct lamp { const char *place, *shape; double below, above; } lamp;

static const lamp lamps[] = {
    { "<0,1,0>", "box { <-1,-1,-1>, <1,1,1> }", 0, 1 },
    { "<0,1.0000000000000002,0>", "box { <-1,-1,-1>, <1,1,1> }", 0, 1 },
    { "<0,0.99999999999999989,0>", "box { <-1,-1,-1>, <1,1,1> }", 0, 0 },
    { "<0,1,0>", "box { <-1,-1,-1>, <1,1,1> rotate <0,0,45> rotate <0,0,45> }", 0, 1 },
    { "<0,1,0>", "sphere { <0,0,0>, 1 }", 0, 1 },
    { "<0,0.99999999999999989,0>", "sphere { <0,0,0>, 1 }", 0, 0 },
    { "<0,1,0>", "sphere { <0,0,0>, 1 pigment { rgbf <1,1,1,0.5> } }", 0.5, 1 },
    { "<0,0.99999999999999989,0>", "sphere { <0,0,0>, 1 pigment { rgbf <1,1,1,0.5> } }", 0.5, 0.5 },
    { "<0,1,0>", "cylinder { <0,-1,0>, <0,1,0>, 1 }", 0, 1 },
    { "<0,1,0>", "cone { <0,-1,0>, 1, <0,1,0>, 0 }", 1, 1 },
    { "<0,1,0>", "triangle { <-1,1,-1>, <1,1,-1>, <0,1,1> }", 1, 1 },
    { "<0,1.0000000000000002,0>", "triangle { <-1,1,-1>, <1,1,-1>, <0,1,1> }", 0, 1 },
    { "<0,1,0>", "difference { box { <-1,-1,-1>, <1,2,1> } box { <-3,1,-3>, <3,3,3> } }", 0, 1 },
    { "<0,1,0>", "box { <-1,-1,-1>, <1,1,1> } box { <-1,-1,-1>, <1,1,1> }", 0, 1 },
};

static pov_scene *wall_with(void *context, const lamp *l, const char *shape)
{
    char text[512];

    sprintf(text, "#version 3.7; light_source { %s rgb 1 } plane { z, 5 pigment { rgb 1 } finish { ambient 0 diffuse 1 } } %s",
            l->place, shape);
    return scenes_text(context, text);
}

static double brightness_at(const pov_scene *scene, double x, double y)
{
    float rgba[4];

    limits_trace(scene, pov_vec3_of(x, y, 4.0), pov_vec3_of(0.0, 0.0, 1.0), rgba);
    return rgba[0];
}

static void n3_a_light_on_a_surface_gives_a_clean_shadow(void **state)
{
    uint64_t seed = 521288629u;

    for (size_t k = 0; k < sizeof lamps / sizeof *lamps; k++) {
        pov_scene *free_wall = wall_with(*state, &lamps[k], ""), *wall = wall_with(*state, &lamps[k], lamps[k].shape);

        for (int i = 0; i < 400; i++) {
            const double x = 4.0 * number(&seed), y = 1.0 + 4.0 * number(&seed);
            const double by = y < 1.0 ? lamps[k].below : lamps[k].above, all = brightness_at(free_wall, x, y);

            if (fabs(brightness_at(wall, x, y) - by * all) > 1e-6)
                fail_msg("%s %s at %g %g: %g of %g", lamps[k].place, lamps[k].shape, x, y, brightness_at(wall, x, y), all);
        }
        pov_scene_destroy(wall);
        pov_scene_destroy(free_wall);
    }
}

/* ---- lights that are projected through an object ---- */

/* All are the sphere <0, 0, -1.5>, 0.4 for a light at <0, 0, -3>; before it and behind it, on the axis, are others. */
static const char *const holes[] = {
    "sphere { <0,0,-1.5>, 0.4 }",
    "sphere { 0, 0.2 scale 2 translate <0,0,-1.5> }",
    "intersection { sphere { <0,0,-1.5>, 0.4 } box { <-1,-1,-2>, <1,1,-1> } }",
    "union { sphere { <0,0,-1.5>, 0.4 } sphere { <0,0,-1.5>, 0.2 } }",
    "sphere { <0,0,-1.5>, 0.4 clipped_by { plane { z, -1 } } }",
};

static void only_light_that_crosses_what_it_is_projected_through_counts(void **state)
{
    const double cone = 3.0 * tan(asin(0.4 / 1.5)), shadow = 3.0 * tan(asin(0.1 / 2.5));
    uint64_t seed = 2463534242u;

    for (size_t k = 0; k < sizeof holes / sizeof *holes; k++) {
        char text[1024];
        pov_scene *scene;

        sprintf(text, "#version 3.7; light_source { <0,0,-3> rgb 1 projected_through { %s } } plane { z, 0 inverse pigment { rgb 1 }"
                      " finish { ambient 0 diffuse 1 } } sphere { <0,0,-2.5>, 0.3 } sphere { <0,0,-0.5>, 0.1 }", holes[k]);
        scene = scenes_text(*state, text);
        for (int i = 0; i < 400; i++) {
            const double x = 1.2 * number(&seed), y = 1.2 * number(&seed), r = hypot(x, y);
            float rgba[4];

            limits_trace(scene, pov_vec3_of(x, y, -0.001), pov_vec3_of(0.0, 0.0, 1.0), rgba);
            if ((rgba[0] > 0.0f) != (r < cone && r > shadow))
                fail_msg("%s at %g: %g", holes[k], r, (double)rgba[0]);
        }
        pov_scene_destroy(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(n2_segments_that_end_at_a_sphere_are_judged_by_their_ends, begin, end),
        cmocka_unit_test_setup_teardown(n2_segments_that_end_at_a_face_are_judged_by_their_ends, begin, end),
        cmocka_unit_test_setup_teardown(n2_segments_that_graze_the_face_that_they_end_on_are_free, begin, end),
        cmocka_unit_test_setup_teardown(n3_a_light_on_a_surface_gives_a_clean_shadow, begin, end),
        cmocka_unit_test_setup_teardown(only_light_that_crosses_what_it_is_projected_through_counts, begin, end),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
