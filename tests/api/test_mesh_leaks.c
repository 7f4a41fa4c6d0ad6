/* A sheet of 100 352 triangles, and rays at its corners and edges from 1 to 1e9 sizes away: each meets it. Without arguments a
 * short run; test_mesh_leaks RAYS for a long one. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/trace.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { SIDE = 225, CORNERS = SIDE * SIDE, BYTES_A_CORNER = 160 };

static long rays = 60000;
static pov_vec3 corner[CORNERS];
static uint64_t state = 20261125;

static double uniform(void)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(state >> 11) * 0x1p-53;
}

static double height(double x, double z)
{
    return 0.06 * sin(7.0 * x + 3.0 * z) * cos(5.0 * z) + 0.004 * sin(61.0 * x) * cos(53.0 * z + x) + 0.0005 * uniform();
}

static pov_scene *load(pov_context *context)
{
    char *text = malloc((size_t)CORNERS * BYTES_A_CORNER), *at = text;
    pov_scene *scene;

    assert_non_null(text);
    at += sprintf(at, "#version 3.7; camera { location <0, 1, -4> look_at 0 } mesh2 { vertex_vectors { %d", CORNERS);
    for (int i = 0; i < CORNERS; i++)
        at += sprintf(at, ",<%.17g,%.17g,%.17g>\n", corner[i].x, corner[i].y, corner[i].z);
    at += sprintf(at, "} face_indices { %d", 2 * (SIDE - 1) * (SIDE - 1));
    for (int i = 0; i < CORNERS - SIDE; i++)
        if (i % SIDE < SIDE - 1)
            at += sprintf(at, ",<%d,%d,%d>,<%d,%d,%d>\n", i, i + 1, i + SIDE, i + 1, i + SIDE + 1, i + SIDE);
    sprintf(at, "} pigment { rgb 1 } }");
    scene = scenes_text(context, text);
    free(text);
    return scene;
}

/* A corner far from the sheet's ends, or a point of an edge from there, as nearly as a double tells. */
static pov_vec3 pick_target(void)
{
    static const int step[3] = { 1, SIDE, SIDE - 1 };
    const int x = SIDE / 4 + (int)(uniform() * (SIDE / 2)), z = SIDE / 4 + (int)(uniform() * (SIDE / 2));
    const pov_vec3 a = corner[z * SIDE + x], b = corner[z * SIDE + x + step[(int)(3.0 * uniform())]];
    const double share = uniform() < 0.4 ? 0.0 : uniform() < 0.3 ? 0.5 : uniform();

    return pov_add(a, pov_scale(pov_sub(b, a), share));
}

static void no_ray_passes_between_faces(void **unused)
{
    pov_context *context = scenes_context();
    pov_scene *scene;
    pov_tracer *tracer;
    long leaks = 0;

    (void)unused;
    for (int i = 0; i < CORNERS; i++) {
        const double x = 2.0 * (i % SIDE) / (SIDE - 1) - 1.0, z = 2.0 * (i / SIDE) / (SIDE - 1) - 1.0;

        corner[i] = pov_vec3_of(x, height(x, z), z);
    }
    scene = load(context);
    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    for (long i = 0; i < rays; i++) {
        const pov_vec3 target = pick_target();
        const pov_vec3 dir = pov_vec3_of(3.0 * uniform() - 1.5, uniform() < 0.5 ? -1.0 : 1.0, 3.0 * uniform() - 1.5);
        const pov_vec3 org = pov_sub(target, pov_scale(dir, pow(10.0, 9.0 * uniform())));
        pov_hit hit = POV_INIT(hit);

        if (!pov_trace_hit(tracer, org, dir, &hit) && leaks++ < 8)
            fprintf(stderr, "leaks: <%a %a %a> to <%a %a %a>\n", org.x, org.y, org.z, dir.x, dir.y, dir.z);
    }
    print_message("%ld rays: %ld leaks\n", rays, leaks);
    assert_int_equal(leaks, 0);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(no_ray_passes_between_faces) };

    if (argc > 1)
        rays = strtol(argv[1], NULL, 10);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
