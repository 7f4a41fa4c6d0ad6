/* test_far_digits.c - N5 to N7: the rays of the review whose distances, normals or components lay at the promise's edge. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/povtrace.h>

#include <math.h>

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

static bool trace(void *context, const char *shape, pov_vec3 org, pov_vec3 dir, pov_hit *out)
{
    const pov_hit none = POV_INIT(none);
    pov_scene *scene = scenes_text(context, shape);
    pov_tracer *tracer;
    bool found;

    *out = none;
    assert_int_equal(pov_tracer_create(&tracer, scene, NULL), POV_OK);
    found = pov_trace_hit(tracer, org, dir, out);
    pov_tracer_destroy(tracer);
    pov_scene_destroy(scene);
    return found;
}

/* A ray of the review: the truth, by exact fractions and 700 digits, and how far off it the distance may be. */
typedef struct ray_case { const char *shape; pov_vec3 org, dir; double truth, off; } ray_case;

static void assert_near(void *context, const ray_case *c)
{
    pov_hit h;

    if (!trace(context, c->shape, c->org, c->dir, &h))
        fail_msg("%s: missed", c->shape);
    if (!(fabs(h.distance - c->truth) <= c->off))
        fail_msg("%s: %.17g instead of %.17g", c->shape, h.distance, c->truth);
}

/* 2^-44 of a size of 1. */
#define PART_OF_SIZE 0x1p-44

static void n5_a_sliver_s_distance_is_within_a_part_of_its_size(void **state)
{
    const ray_case c = {
        "polygon { 4, <0.072779850727419618,0.50726477446115514,0.85871155920889297>, <0.72316331671819423,-0.24166215662456147,0.98563594244693453>,"
        "<0.25041131331276539,0.30271935923922166,0.89337690838188832>, <0.072779850727419618,0.50726477446115514,0.85871155920889297> }",
        { 0x1.7c527f2baba57p-3, 0x1.8248bc1bad74ep-2, 0x1.c2f18c367a3e5p-1 },
        { -0x1.a11c743816a15p-1, -0x1.8f478b38a1372p-2, -0x1.b792e01c530b7p-2 }, 6.881965437542003e-09, 0.7 * PART_OF_SIZE
    };

    assert_near(*state, &c);
}

static void n5_a_nearly_planar_quadric_s_distance_is_within_a_part_of_its_size(void **state)
{
    const ray_case c = {
        "quadric { <-0,2.9523936411761973e-06,-0>, <3.9355847138079788e-06,2.1307896699604927e-06,1.5984740082467523e-06>,"
        "<-0.0082941147775272735,-0.0061747782907682234,2.5605622634380743e-05>, -0.09967007822200577 }",
        { -0x1.f9c93c2df1b27p+2, -0x1.5efb78e936874p+2, 0x1.2e225ce92da9ap-1 },
        { 0x1.f23a1133e678p-4, -0x1.4c12676c26dcp-3, 0x1.6d40068f52f3p-5 }, 0.5066961024294363, PART_OF_SIZE
    };

    assert_near(*state, &c);
}

static void n5_a_quadric_written_far_away_is_within_60_units_in_the_last_place(void **state)
{
    const ray_case c = {
        "quadric { <0,12,8>, <-16,-8,22>, <1245728176.8217635,-4723013321.7467899,-3140086771.3869972>, 2.9498198478179827e+17 }",
        { -0x1.b5c7cfdb6e10dp+26, 0x1.9b2a85ca7b42cp+24, 0x1.846d28c7f504p+26 },
        { -0x1.834b35f24f245p-2, -0x1.9ad5948a942b3p-3, -0x1.ceb4749aefe65p-1 }, 0.0035736965815558568, 60 * 0x1p-61
    };

    assert_near(*state, &c);
}

static void n5_a_start_near_a_cone_that_grazes_it_is_within_a_part_of_its_size(void **state)
{
    const ray_case c = {
        "cone { <-8.7603228551601837e-74,2.7914001036406644e-73,4.1598280823633093e-73>, 5.4105150368934377e-73,"
        "<4.0846401876926025e-73,2.2044880338873759e-73,4.453665410825943e-73>, 6.5016703549699726e-73 }",
        { 0x1.aafd644ee0bcbp-242, 0x1.5137bff246886p-241, 0x1.d5667b4f29196p-240 },
        { 0x1.d78abbde5fed8p-1, -0x1.fc94cc19c36dcp-3, 0x1.336ab665077b4p-2 }, 6.250013927793599e-83, 5e-73 * PART_OF_SIZE
    };

    assert_near(*state, &c);
}

/* No independent truth: the rotations are rounded, and the digits are those that this build gives. It guards against a
 * change, and says nothing of accuracy. */
static void n5_a_sheared_box_is_met_13_decades_ahead(void **state)
{
    const ray_case c = {
        "box { <-0.38223328647299415,-0.35494734970844255,-0.77825092491741321>, <0.38223328647299415,0.35494734970844255,0.77825092491741321>"
        " matrix <1,0,0,0,1,1.9167099209116985,0,0,1,0.074415966362924024,-0.69269737859226262,0.28675499413531758>"
        " scale <-6.1651513934160587,0.075585070699863879,-25.110582110669469> rotate <-180,278.70364810862691,-66.246854789708095> }",
        { 0x1.3a500f9aa4572p+2, -0x1.5ff5f84144b87p+3, 0x1.36cf3c89a60b1p-4 },
        { -0x1.d5e0398ee1387p-1, 0x1.86dbe67d5ec58p-2, 0x1.c247278aafa75p-4 }, 1.06352987e-13, 1e-21
    };

    assert_near(*state, &c);
}

static void n6_a_denormal_component_leaves_the_face_that_the_ray_starts_in(void **state)
{
    static const char box[] = "box { <0.28328615295341986,0.84066485566308269,0.30972544862852813>, <1.778286003871157,1.9796553099131671,1.6385338785272829> }";
    const pov_vec3 org = { 0x1.60508ae1154fep-1, 0x1.ae6b9fbbf0626p-1, -0x1.597b64e14c0b8p-4 };
    pov_hit h;

    assert_false(trace(*state, box, org, pov_vec3_of(-1.0, -0x0.0000000000001p-1022, 1.0), &h));
    assert_false(trace(*state, box, org, pov_vec3_of(-1.0, -0x1p-1022, 1.0), &h));
    assert_true(trace(*state, box, pov_vec3_of(org.x, 1.0, org.z), pov_vec3_of(0.0, -0x0.0000000000001p-1022, 1.0), &h));
}

static void n7_the_normal_of_a_grazed_pair_of_planes_is_within_1e_10(void **state)
{
    const ray_case c = {
        "quadric { <0,-4,0>, <6,-6,4>, <-6,6,-2>, -2 }",
        { -0x1.56a6c1a67c694p+7, -0x1.f66cbc44c9527p+6, -0x1.fa6cbc44e636ap+6 },
        { 0x1.62bfbba2f9058p-1, 0x1.050d875d912c5p-1, 0x1.050d875da012fp-1 }, 247.21150060155884, 16 * 0x1p-45
    };
    const pov_vec3 truth = { -0.8320502943378437, 0.5547001962252291, 0.0 };
    pov_hit h;

    assert_near(*state, &c);
    assert_true(trace(*state, c.shape, c.org, c.dir, &h));
    assert_true(pov_largest(pov_sub(h.normal, truth)) <= 1e-10);
}

#define HERE(test) cmocka_unit_test_setup_teardown(test, begin, end)

int main(void)
{
    const struct CMUnitTest tests[] = {
        HERE(n5_a_sliver_s_distance_is_within_a_part_of_its_size),
        HERE(n5_a_nearly_planar_quadric_s_distance_is_within_a_part_of_its_size),
        HERE(n5_a_quadric_written_far_away_is_within_60_units_in_the_last_place),
        HERE(n5_a_start_near_a_cone_that_grazes_it_is_within_a_part_of_its_size),
        HERE(n5_a_sheared_box_is_met_13_decades_ahead),
        HERE(n6_a_denormal_component_leaves_the_face_that_the_ray_starts_in),
        HERE(n7_the_normal_of_a_grazed_pair_of_planes_is_within_1e_10),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
