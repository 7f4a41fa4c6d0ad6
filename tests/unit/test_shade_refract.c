/* Snell's law without cancellation, and the list of dielectrics that a ray is in. */
#include "support/near.h"

#include "shade/dielectric.h"
#include "shade/refract.h"

#include <string.h>

/* A ray that comes at this angle to the normal y, downwards. */
static pov_vec3 coming_at(double angle)
{
    return pov_vec3_of(sin(angle), -cos(angle), 0.0);
}

static bool refract_at(double angle, double before, double after, pov_vec3 *out)
{
    return refract(coming_at(angle), pov_vec3_of(0.0, 1.0, 0.0), cos(angle), before, after, out);
}

static void refract_obeys_snell_at_all_angles(void **state)
{
    static const double iors[] = { 1.0, 1.1, 1.33, 1.5, 2.4, 10.0 };
    pov_vec3 out;
    (void)state;

    for (int a = 0; a < 6; a++)
        for (int b = 0; b < 6; b++)
            for (double angle = 0.0; angle < 1.57; angle += 0.01) {
                double sine = iors[a] / iors[b] * sin(angle);
                if (fabs(sine - 1.0) < 1e-3)
                    continue;
                assert_int_equal(refract_at(angle, iors[a], iors[b], &out), sine < 1.0);
                if (sine > 1.0)
                    continue;
                assert_near(out.x, sine, 4e-15);
                assert_near(out.y, -sqrt(1.0 - sine * sine), 1e-12);
                assert_near(pov_dot(out, out), 1.0, 1e-15);
            }
}

/* sin b = sin a / (1 + d) turns the ray by d tan a, to the first order in d. */
static void refract_follows_an_ior_of_one_and_1e_11(void **state)
{
    const double ior = 1.0 + 1e-11, d = ior - 1.0, angle = 0.7;
    pov_vec3 out, view = coming_at(angle);
    (void)state;

    assert_true(refract_at(angle, 1.0, ior, &out));
    assert_near((view.x - out.x) / (d * sin(angle)), 1.0, 3e-5);
    assert_near((view.y - out.y) / (d * sin(angle) * tan(angle)), 1.0, 3e-5);
}

static void refract_leaves_on_the_other_side_also_when_grazing(void **state)
{
    pov_vec3 out, normal = { 0.0, 1.0, 0.0 };
    (void)state;

    for (double cosine = 1e-3; cosine > 1e-300; cosine *= 0.01) {
        pov_vec3 view = { 1.0, -cosine, 0.0 };
        assert_true(refract(view, normal, cosine, 1.0, 1.5, &out));
        assert_near(out.y, -sqrt(1.0 - 1.0 / 2.25), 1e-6);
        assert_true(refract(view, normal, cosine, 1.0, 1.0 + 1e-15, &out));
        assert_true(out.y < 0.0);
        assert_false(refract(view, normal, cosine, 1.5, 1.0, &out));
    }
}

/* Lane i of n: what surfaces of these dielectrics on both sides make of a ray at an angle of its own. */
static void assert_bent_alike(const double *iors, uint32_t count, uint32_t n)
{
    vec_lanes view, normal;
    double cosines[WORLD_MANY];
    refraction_lanes b;

    for (uint32_t i = 0; i < WORLD_MANY; i++) {
        const double angle = 1.57 / WORLD_MANY * i;
        lanes_put(&view, i, coming_at(angle));
        lanes_put(&normal, i, pov_vec3_of(0.0, 1.0, 0.0));
        cosines[i] = cos(angle);
        b.before[i] = iors[i % count];
        b.after[i] = iors[i / count % count];
    }
    refract_lanes(&b, &view, &normal, cosines, n);
    for (uint32_t i = 0; i < n; i++) {
        pov_vec3 one, dir = lanes_at(&b.dir, i);
        assert_int_equal(refract(lanes_at(&view, i), lanes_at(&normal, i), cosines[i], b.before[i], b.after[i], &one),
                         b.squared_cosine[i] > 0.0);
        assert_memory_equal(&dir, &one, sizeof one);
    }
}

static void refract_many_gives_the_bits_of_refract(void **state)
{
    static const double iors[] = { 1.0, 1.5, 1.0 + 1e-15, 2.4 }, odd[] = { 1.0, 1e100, 1e-100 };
    (void)state;

    for (uint32_t n = 1; n <= WORLD_MANY; n++) {
        assert_bent_alike(iors, 4, n);
        assert_bent_alike(odd, 3, n);
    }
}

static void refract_ends_at_the_critical_angle(void **state)
{
    double critical = asin(1.0 / 1.5);
    pov_vec3 out;
    (void)state;

    assert_true(refract_at(critical - 1e-12, 1.5, 1.0, &out));
    assert_true(out.y < 0.0 && out.y > -1e-5);
    assert_false(refract_at(critical + 1e-12, 1.5, 1.0, &out));
}

/* ---- dielectrics ---- */

typedef struct glasses { env env; model model; material materials[4]; leaf_node objects[4]; dielectric_stack stack; } glasses;

static void setup(glasses *g)
{
    static const double iors[4] = { 1.1, 1.2, 1.3, 0.0 };

    memset(g, 0, sizeof *g);
    env_init(&g->env, NULL, NULL, NULL);
    model_init(&g->model, &g->env);
    for (uint32_t i = 0; i < 4; i++) {
        g->materials[i].interior.ior = iors[i];
        g->objects[i].material = i;
    }
    g->model.materials.items = g->materials;
    g->model.leaves.items = g->objects;
}

static dielectric_crossing cross(glasses *g, dielectric_span *in, uint32_t which)
{
    dielectric_crossing c;

    dielectric_cross(&g->stack, *in, &g->model, which, -1.0f, &c);
    assert_true(dielectric_pass(&g->stack, &g->env, in, &c));
    return c;
}

static void assert_crossing(dielectric_crossing c, double before, double after)
{
    assert_near(c.before, before, 0.0);
    assert_near(c.after, after, 0.0);
}

static void the_dielectric_is_the_one_entered_last(void **state)
{
    glasses g;
    dielectric_span in = { 0, 0 };
    (void)state;
    setup(&g);

    assert_crossing(cross(&g, &in, 0), 1.0, 1.1);
    assert_crossing(cross(&g, &in, 1), 1.1, 1.2);
    assert_crossing(cross(&g, &in, 1), 1.2, 1.1);
    assert_crossing(cross(&g, &in, 0), 1.1, 1.0);
    assert_int_equal(in.count, 0);
    env_free(&g.env, g.stack.items);
}

static void leaving_a_dielectric_that_is_not_the_last_refracts_nothing(void **state)
{
    glasses g;
    dielectric_span in = { 0, 0 };
    (void)state;
    setup(&g);

    cross(&g, &in, 0);
    cross(&g, &in, 1);
    cross(&g, &in, 2);
    assert_crossing(cross(&g, &in, 1), 1.3, 1.3);
    assert_crossing(cross(&g, &in, 2), 1.3, 1.1);
    assert_crossing(cross(&g, &in, 0), 1.1, 1.0);
    env_free(&g.env, g.stack.items);
}

static void an_ior_of_zero_counts_as_one(void **state)
{
    glasses g;
    dielectric_span in = { 0, 0 };
    (void)state;
    setup(&g);

    assert_crossing(cross(&g, &in, 3), 1.0, 1.0);
    assert_crossing(cross(&g, &in, 0), 1.0, 1.1);
    env_free(&g.env, g.stack.items);
}

static void a_kept_list_stays_as_it_was(void **state)
{
    glasses g;
    dielectric_span in = { 0, 0 }, resident;
    (void)state;
    setup(&g);

    cross(&g, &in, 0);
    resident = in;
    cross(&g, &in, 1);
    assert_int_equal(resident.count, 1);
    assert_int_equal(g.stack.items[resident.first], 0);
    assert_int_equal(in.count, 2);
    assert_int_equal(g.stack.items[in.first], 0);
    assert_int_equal(g.stack.items[in.first + 1], 1);
    dielectric_compact(&g.stack, &in, 0);
    assert_int_equal(g.stack.count, 2);
    assert_int_equal(g.stack.items[1], 1);
    env_free(&g.env, g.stack.items);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(refract_obeys_snell_at_all_angles),
        cmocka_unit_test(refract_follows_an_ior_of_one_and_1e_11),
        cmocka_unit_test(refract_leaves_on_the_other_side_also_when_grazing),
        cmocka_unit_test(refract_many_gives_the_bits_of_refract),
        cmocka_unit_test(refract_ends_at_the_critical_angle),
        cmocka_unit_test(the_dielectric_is_the_one_entered_last),
        cmocka_unit_test(leaving_a_dielectric_that_is_not_the_last_refracts_nothing),
        cmocka_unit_test(an_ior_of_zero_counts_as_one),
        cmocka_unit_test(a_kept_list_stays_as_it_was),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
