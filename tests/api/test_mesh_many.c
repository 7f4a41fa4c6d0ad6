/* Many rays at a mesh find what each finds by exact arithmetic: at corners and edges, at faces that lie on others or nearly so,
 * from far and from near starts, in bundles and scattered. And they see the colours, shadows too, that each sees by itself.
 * test_mesh_many RAYS for a long run. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/trace.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 60, LAYERS = 3, CORNERS = LAYERS * SIDE * SIDE, BYTES_A_CORNER = 200, BLOCK = 1024 };

static long rays = 40000;
static pov_vec3 corner[CORNERS];
static uint64_t state = 20261126;

static double uniform(void)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(state >> 11) * 0x1p-53;
}

/* Bumps; a second layer that meets the first along lines of corners, and is the same on a quarter; a third, far below. */
static void put_corners(void)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        const double x = 2.0 * (i % SIDE) / (SIDE - 1) - 1.0, z = 2.0 * (i / SIDE) / (SIDE - 1) - 1.0;
        const double y = 0.06 * sin(7.0 * x + 3.0 * z) * cos(5.0 * z) + 0.01 * uniform();

        corner[i] = pov_vec3_of(x, y, z);
        corner[SIDE * SIDE + i] = pov_vec3_of(x, x < 0.0 && z < 0.0 ? y : y + 1e-8 * sin(40.0 * x), z);
        corner[2 * SIDE * SIDE + i] = pov_vec3_of(2.0 * x, y - 0.5, 2.0 * z);
    }
}

static char *write_scene(void)
{
    char *text = malloc((size_t)CORNERS * BYTES_A_CORNER), *at = text;

    assert_non_null(text);
    at += sprintf(at, "#version 3.7; light_source { <3, 6, -4>, 1 } mesh2 { vertex_vectors { %d", CORNERS);
    for (int i = 0; i < CORNERS; i++)
        at += sprintf(at, ",<%.17g,%.17g,%.17g>\n", corner[i].x, corner[i].y, corner[i].z);
    at += sprintf(at, "} face_indices { %d", LAYERS * 2 * (SIDE - 1) * (SIDE - 1));
    for (int i = 0; i < CORNERS - SIDE; i++)
        if (i % SIDE < SIDE - 1 && i / SIDE % SIDE < SIDE - 1)
            at += sprintf(at, ",<%d,%d,%d>,<%d,%d,%d>\n", i, i + 1, i + SIDE, i + 1, i + SIDE + 1, i + SIDE);
    sprintf(at, "} pigment { rgb 1 } }");
    return text;
}

static pov_scene *load(pov_context *context, const char *text, pov_accuracy accuracy)
{
    pov_load_desc desc = POV_INIT(desc);
    pov_scene *scene = NULL;
    pov_error error;

    desc.accuracy = accuracy;
    assert_int_equal(pov_scene_load_text(&scene, context, text, strlen(text), "mesh", &desc, &error), POV_OK);
    return scene;
}

static pov_vec3 anywhere(double size)
{
    return pov_vec3_of(size * (2.0 * uniform() - 1.0), size * (2.0 * uniform() - 1.0), size * (2.0 * uniform() - 1.0));
}

/* A corner, or a point of an edge or of a face. */
static pov_vec3 pick_target(void)
{
    static const int step[3] = { 1, SIDE, SIDE - 1 };
    const int i = (1 + (int)(uniform() * (SIDE - 2))) * SIDE + 1 + (int)(uniform() * (SIDE - 2));
    const pov_vec3 a = corner[i], b = corner[i + step[(int)(3.0 * uniform())]];
    const double kind = uniform(), share = kind < 0.3 ? 0.0 : kind < 0.6 ? 0.5 : uniform();

    return pov_add(pov_add(a, pov_scale(pov_sub(b, a), share)), anywhere(kind < 0.8 ? 0.0 : 0.01));
}

/* Bundles of 64 have one start, and others lie anywhere; some start at a corner. */
static void pick_rays(pov_vec3 org[BLOCK], pov_vec3 dir[BLOCK])
{
    for (int i = 0; i < BLOCK; i++) {
        const bool first = i % 64 == 0, bundle = i / 64 % 2 == 0;

        org[i] = bundle && !first ? org[i - 1] : uniform() < 0.1 ? pick_target() : anywhere(pow(10.0, 6.0 * uniform() - 1.0));
        dir[i] = pov_sub(pick_target(), org[i]);
        if (!(pov_largest(dir[i]) > 0.0))
            dir[i] = pov_vec3_of(0.0, 1.0, 0.0);
    }
}

static bool is_alike(double a, double b) { return a == b || fabs(a - b) <= 0x1p-45 * fabs(a); }

static long count_differences(pov_tracer *tracer, pov_tracer *exact, const pov_vec3 *org, const pov_vec3 *dir)
{
    static double distance[BLOCK];
    static float rgba[4 * BLOCK];
    pov_found found = POV_INIT(found);
    pov_error error;
    long wrong = 0;

    found.distance = distance;
    found.rgba = rgba;
    assert_int_equal(pov_trace_many(tracer, BLOCK, org, dir, &found, &error), POV_OK);
    for (int i = 0; i < BLOCK; i++) {
        pov_hit hit = POV_INIT(hit);
        float own[4];
        const double at = pov_trace_hit(exact, org[i], dir[i], &hit) ? hit.distance : HUGE_VAL;

        assert_int_equal(pov_trace_color(tracer, org[i], dir[i], own, &error), POV_OK);
        if ((!is_alike(distance[i], at) || memcmp(own, rgba + 4 * i, sizeof own) != 0) && wrong++ < 4)
            fprintf(stderr, "<%a %a %a> to <%a %a %a>: %a, exactly %a; %g and %g\n", org[i].x, org[i].y, org[i].z, dir[i].x,
                    dir[i].y, dir[i].z, distance[i], at, (double)rgba[4 * i], (double)own[0]);
    }
    return wrong;
}

static void many_rays_find_what_exact_arithmetic_finds(void **unused)
{
    pov_context *context = scenes_context();
    pov_scene *fast, *slow;
    pov_tracer *tracer, *exact;
    pov_vec3 org[BLOCK], dir[BLOCK];
    char *text;
    long wrong = 0;

    (void)unused;
    put_corners();
    text = write_scene();
    fast = load(context, text, POV_ACCURACY_CERTIFIED);
    slow = load(context, text, POV_ACCURACY_MAX);
    free(text);
    assert_int_equal(pov_tracer_create(&tracer, fast, NULL), POV_OK);
    assert_int_equal(pov_tracer_create(&exact, slow, NULL), POV_OK);
    for (long i = 0; i < rays; i += BLOCK) {
        pick_rays(org, dir);
        wrong += count_differences(tracer, exact, org, dir);
    }
    print_message("%ld rays: %ld wrong\n", rays, wrong);
    assert_int_equal(wrong, 0);
    pov_tracer_destroy(tracer);
    pov_tracer_destroy(exact);
    pov_scene_destroy(fast);
    pov_scene_destroy(slow);
    pov_context_destroy(context);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(many_rays_find_what_exact_arithmetic_finds) };

    if (argc > 1)
        rays = strtol(argv[1], NULL, 10);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
