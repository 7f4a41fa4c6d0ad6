/* Area lights, and shading normals that are not those of the surface. */
#include "shade/scatter.h"
#include "support/near.h"
#include "support/tiny.h"

/* ---- area lights ---- */

/* A row of `count` points from (-1, 0, 1) to (1, 0, 1), seen from (0, 0, 5); half way there a small sphere. */
static colour see_row(uint32_t count, double screen_x, colour through)
{
    material m = tiny_glass(1.0);
    light *l;
    colour seen;
    tiny s;

    tiny_begin(&s, NULL);
    tiny_plane(&s, 0, 0, 1, 5, tiny_matt());
    m.transmit = 0.0f;
    m.filter = 1.0f;
    m.pigment = through;
    tiny_sphere(&s, screen_x, 0, 3, 0.1, m);
    tiny_light(&s, 0, 0, 1, 1.0f, 0.5f, 0.25f);
    l = &s.model.lights.items[0];
    l->flags = LIGHT_AREA;
    l->area.axes[0] = pov_vec3_of(2.0, 0.0, 0.0);
    l->area.counts[0] = count;
    l->area.counts[1] = 1;
    tiny_build(&s);
    seen = tiny_trace(&s, pov_vec3_of(0, 3, 2), 0, -1, 1);
    tiny_end(&s);
    return seen;
}

static void what_a_surface_sees_of_an_area_is_the_weighted_mean_over_its_points(void **state)
{
    const float lit = 0.6f;
    (void)state;

    assert_colour(see_row(2, 100.0, colour_of(0, 0, 0)), lit, 0.5 * lit, 0.25 * lit, 1e-6);
    assert_colour(see_row(2, -0.5, colour_of(0, 0, 0)), 0.5 * lit, 0.25 * lit, 0.125 * lit, 1e-6);
    assert_colour(see_row(2, 0.5, colour_of(0, 0, 0)), 0.5 * lit, 0.25 * lit, 0.125 * lit, 1e-6);
    /* The middle one of three has half of the weight, and one of seven has a quarter. */
    assert_colour(see_row(3, 0.0, colour_of(0, 0, 0)), 0.5 * lit, 0.25 * lit, 0.125 * lit, 1e-6);
    assert_colour(see_row(3, 0.5, colour_of(0, 0, 0)), 0.75 * lit, 0.375 * lit, 0.1875 * lit, 1e-6);
    assert_colour(see_row(7, 0.0, colour_of(0, 0, 0)), 0.75 * lit, 0.375 * lit, 0.1875 * lit, 1e-6);
    /* A sphere is crossed twice. */
    assert_colour(see_row(2, 0.5, colour_of(0.5f, 0, 1)), 0.5 * lit * 1.25, 0.25 * lit, 0.25 * lit, 1e-6);
}

/* ---- bent normals ---- */

/* What the camera ray's surface looks like when its shading normal is n: the lit colour, and the batches that go on. */
static colour light_bent(tiny *s, pov_ray *ray, pov_vec3 n)
{
    pov_tracer *t = s->tracer;
    colour out[BATCH_MAX] = { { 0.0f, 0.0f, 0.0f } };
    geometry *g = &t->surfaces.geometry;

    t->camera.count = 1;
    t->camera.rays[0] = ray;
    surfaces_find(&t->context, &t->surfaces, &t->camera, out);
    assert_int_equal(t->surfaces.count, 1);
    surfaces_complete(&t->context, &t->surfaces, &t->painted);
    lanes_put(&g->bent, 0, pov_unit(n));
    g->shading = &g->bent;
    geometry_turn(g, 1);
    batch_begin(&t->queue, out);
    t->lighting.own = t->queue.mirrored.items[0]->own;
    light_gather(&t->lighting, &t->context, &t->surfaces);
    scatter(&t->context, &t->surfaces, &t->queue);
    return colour_lane(&t->surfaces.lit, 0);
}

static void diffuse_light_goes_by_the_shading_normal(void **state)
{
    pov_ray ray = { .org = { 0, 0, 0 }, .dir = { 0, 0, 1 }, .origin_surface = POV_NO_OWNER };
    tiny s;
    (void)state;

    tiny_begin(&s, NULL);
    tiny_plane(&s, 0, 0, 1, 5, tiny_matt());
    tiny_light(&s, 4, 0, 2, 1.0f, 1.0f, 1.0f);
    tiny_build(&s);
    assert_near(light_bent(&s, &ray, pov_vec3_of(0.6, 0, -0.8)).r, 0.6 * (0.6 * 0.8 + 0.8 * 0.6), 1e-6);
    assert_near(light_bent(&s, &ray, pov_vec3_of(-0.8, 0, -0.6)).r, 0.0, 0.0);
    tiny_end(&s);
}

/* Behind the surface and before the shading normal: a flat surface is lit, a solid one throws its own shadow. */
static void light_from_behind_the_surface_is_told_by_the_geometric_normal(void **state)
{
    pov_ray ray = { .org = { 0, 0, 0 }, .dir = { 0, 0, 1 }, .origin_surface = POV_NO_OWNER };
    const pov_vec3 bent = { 0.8, 0, -0.6 };
    tiny s;
    (void)state;

    tiny_begin(&s, NULL);
    tiny_plane(&s, 0, 0, 1, 5, tiny_matt());
    tiny_light(&s, 4, 0, 6, 1.0f, 1.0f, 1.0f);
    tiny_build(&s);
    assert_near(light_bent(&s, &ray, bent).r, 0.6 * (4 * 0.8 - 0.6) / sqrt(17.0), 1e-6);
    tiny_end(&s);

    tiny_begin(&s, NULL);
    tiny_sphere(&s, 0, 0, 8, 3, tiny_matt());
    tiny_light(&s, 40, 0, 6, 1.0f, 1.0f, 1.0f);
    tiny_build(&s);
    assert_near(light_bent(&s, &ray, bent).r, 0.0, 0.0);
    tiny_end(&s);
}

/* By the bent normal alone the ray would go on into the ground, and be said to have left it upwards. */
static void a_mirrored_ray_stays_before_the_surface(void **state)
{
    pov_ray ray = { .org = { -1, 0, 4 }, .dir = { 1, 0, 1 }, .origin_surface = POV_NO_OWNER };
    material mirror = tiny_matt();
    pov_tracer *t;
    pov_vec3 d;
    tiny s;
    (void)state;

    tiny_begin(&s, NULL);
    mirror.finish.reflection.min = mirror.finish.reflection.max = colour_of(1.0f, 1.0f, 1.0f);
    mirror.transmit = 0.5f;
    tiny_plane(&s, 0, 0, 1, 5, mirror);
    tiny_light(&s, 4, 0, 2, 1.0f, 1.0f, 1.0f);
    tiny_build(&s);
    t = s.tracer;
    light_bent(&s, &ray, pov_vec3_of(1, 0, -2));
    /* (1, 0, 1) about (1, 0, -2)/sqrt 5 is (1.4, 0, 0.2), and that about the plane (1.4, 0, -0.2). */
    d = pov_unit(pov_vec3_of(1.4, 0, -0.2));
    assert_int_equal(t->queue.mirrored.items[0]->count, 1);
    assert_near(pov_dot(t->queue.mirrored.items[0]->own[0].dir, d), 1.0, 1e-12);
    assert_int_equal(t->queue.transmitted.items[0]->count, 1);
    tiny_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_a_surface_sees_of_an_area_is_the_weighted_mean_over_its_points),
        cmocka_unit_test(diffuse_light_goes_by_the_shading_normal),
        cmocka_unit_test(light_from_behind_the_surface_is_told_by_the_geometric_normal),
        cmocka_unit_test(a_mirrored_ray_stays_before_the_surface),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
