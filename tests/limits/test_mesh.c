/* test_mesh.c - a mesh of 1e5 faces has no leaks: rays at its edges and corners, from one to 1e9 of its sizes depth, hit it;
 * and what goes into a closed one comes out again. test_mesh RAYS for a long run. */
#include "support/check.h"
#include "support/limits.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS = 224, CORNERS = CELLS + 1 };

static long rays = 20000;
static uint64_t state = 88172645463325252u;

static double uniform(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) * 0x1p-53;
}

/* Bumps that are less steep than any ray, so that no edge is an outline, past which a ray may go. */
static double height(double x, double z) { return 0.05 * sin(7.0 * x) * cos(6.0 * z) + 0.002 * sin(41.0 * x + 13.0 * z); }

/* As it is written, so that targets are where the mesh has its corners. */
static pov_vec3 corner(int i, int j)
{
    const double x = 2.0 * i / CELLS - 1.0, z = 2.0 * j / CELLS - 1.0;

    return pov_vec3_of(x, height(x, z), z);
}

static char *write_grid(void)
{
    const size_t most = (size_t)CORNERS * CORNERS * 100 + (size_t)CELLS * CELLS * 100 + 1000;
    char *text = malloc(most), *at = text;
    int i, j;

    assert_non_null(text);
    at += sprintf(at, "#version 3.7; camera { location -z }\nmesh2 { vertex_vectors { %d", CORNERS * CORNERS);
    for (j = 0; j < CORNERS; j++)
        for (i = 0; i < CORNERS; i++) {
            const pov_vec3 v = corner(i, j);

            at += sprintf(at, ", <%.17g,%.17g,%.17g>", v.x, v.y, v.z);
        }
    at += sprintf(at, " } face_indices { %d", 2 * CELLS * CELLS);
    for (j = 0; j < CELLS; j++)
        for (i = 0; i < CELLS; i++) {
            const int a = j * CORNERS + i;

            at += sprintf(at, ", <%d,%d,%d>, <%d,%d,%d>", a, a + 1, a + CORNERS, a + CORNERS + 1, a + 1, a + CORNERS);
        }
    sprintf(at, " } pigment { rgb 1 } }\n");
    return text;
}

/* On an edge or at a corner inside the grid. */
static pov_vec3 target(void)
{
    static const int steps[3][2] = { { 1, 0 }, { 0, 1 }, { -1, 1 } };
    const int i = 2 + (int)((CELLS - 4) * uniform()), j = 2 + (int)((CELLS - 4) * uniform());
    const int *step = steps[(int)(3.0 * uniform())];
    const pov_vec3 a = corner(i, j), b = corner(i + step[0], j + step[1]);
    const double along = uniform() < 0.3 ? 0.0 : uniform();

    return pov_add(a, pov_scale(pov_sub(b, a), along));
}

static pov_vec3 direction_from_above(void)
{
    const double angle = 6.283185307179586 * uniform(), up = 0.5 + uniform();

    return pov_unit(pov_vec3_of(cos(angle), up, sin(angle)));
}

static void no_ray_leaks_through_edges_and_corners(void **state_)
{
    pov_context *context = scenes_context();
    char *text = write_grid();
    pov_scene *scene = scenes_text(context, text);
    pov_tracer *tracer;
    pov_error err;
    long missed = 0;

    (void)state_;
    assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
    for (long i = 0; i < rays; i++) {
        const pov_vec3 to = target(), dir = direction_from_above();
        const double depth = pow(10.0, 9.0 * uniform());
        const pov_vec3 from = pov_add(to, pov_scale(dir, depth));
        pov_hit hit = POV_INIT(hit);
        const bool found = pov_trace_hit(tracer, from, pov_sub(to, from), &hit);

        missed += !found;
        assert_true(!found || (hit.distance > 0.0 && hit.distance * depth < depth + 2.0));
    }
    assert_int_equal(missed, 0);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    free(text);
}

static bool count_hit(void *user, const pov_hit *hit)
{
    (void)hit;
    ++*(int *)user;
    return true;
}

/* An octahedron: every line through it has two crossings, also through its edges and corners. */
static void a_closed_mesh_is_crossed_twice(void **state_)
{
    static const pov_vec3 corners[6] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 } };
    static const char text[] =
        "#version 3.7; camera { location -5*z } mesh { triangle { x,y,z } triangle { y,-x,z } triangle { -x,-y,z } "
        "triangle { -y,x,z } triangle { y,x,-z } triangle { -x,y,-z } triangle { -y,-x,-z } triangle { x,-y,-z } "
        "inside_vector <.3,.9,.1> pigment { rgbt 1 } }";
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, text);
    pov_tracer *tracer;
    pov_error err;

    (void)state_;
    assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
    for (long i = 0; i < rays / 4; i++) {
        const pov_vec3 a = corners[(int)(6.0 * uniform())], b = corners[(int)(6.0 * uniform())];
        const double along = uniform(), shift = uniform() < 0.5 ? 0.0 : 1e-12;
        const pov_vec3 on = pov_scale(pov_add(pov_scale(a, along), pov_scale(b, 1.0 - along)), 0.5 + shift);
        const pov_vec3 from = pov_scale(pov_vec3_of(uniform() - 0.5, uniform() - 0.5, -uniform() - 0.5), 20.0);
        int count = 0;

        pov_trace_hits(tracer, from, pov_sub(on, from), count_hit, &count);
        assert_int_equal(count % 2, 0);
    }
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

/* Light sees the blend of the corners' normals, rays the face. */
static void shading_normals_are_blends(void **state_)
{
    static const char text[] =
        "#version 3.7; camera { location -5*z } mesh2 { vertex_vectors { 3, <0,0,0>, <1,0,0>, <0,1,0> } "
        "normal_vectors { 3, <0,0,-1>, <1,0,-1>, <0,3,-4> } face_indices { 1, <0,1,2> } scale <2,1,1> pigment { rgb 1 } }";
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, text);
    pov_hit hit = POV_INIT(hit);
    pov_tracer *tracer;
    pov_error err;
    pov_vec3 blend;

    (void)state_;
    assert_int_equal(pov_tracer_create(&tracer, scene, &err), POV_OK);
    assert_true(pov_trace_hit(tracer, pov_vec3_of(0.5, 0.25, -3.0), pov_vec3_of(0.0, 0.0, 1.0), &hit));
    blend = pov_unit(pov_add(pov_add(pov_vec3_of(0, 0, -0.5), pov_scale(pov_unit(pov_vec3_of(1, 0, -1)), 0.25)),
                             pov_scale(pov_vec3_of(0, 0.6, -0.8), 0.25)));
    blend = pov_unit(pov_vec3_of(blend.x / 2.0, blend.y, blend.z));
    assert_true(pov_largest(pov_sub(hit.shading_normal, blend)) < 1e-14);
    assert_true(hit.normal.x == 0.0 && hit.normal.y == 0.0 && hit.normal.z == -1.0);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_ray_leaks_through_edges_and_corners),
        cmocka_unit_test(a_closed_mesh_is_crossed_twice),
        cmocka_unit_test(shading_normals_are_blends),
    };

    if (argc > 1)
        rays = strtol(argv[1], NULL, 10);
    return cmocka_run_group_tests_name("mesh", tests, NULL, NULL);
}
