/* photon/map: discs of photons, and how wide they have to be for who looks. */
#include "photon/map.h"
#include "support/check.h"
#include "support/tiny.h"

#include <math.h>
#include <string.h>

enum { COUNT = 1000 };
static const pov_vec3 up = { 0.0, 0.0, -1.0 };

/* Photons that all but meet in one point of the plane z = 1: together a light of 1. */
static void gather(photon_map *m, const env *e)
{
    photon *all = env_resize(e, NULL, COUNT, sizeof *all);

    assert_non_null(all);
    memset(all, 0, COUNT * sizeof *all);
    for (int i = 0; i < COUNT; i++) {
        all[i].at = pov_vec3_of(1e-6 * cos(i), 1e-6 * sin(i), 1.0);
        all[i].flux = colour_of(1.0f / COUNT, 1.0f / COUNT, 1.0f / COUNT);
        all[i].dir[2] = 1.0f;
        all[i].normal[2] = -1.0f;
    }
    assert_true(photon_map_make(m, e, all, COUNT, 20, PHOTON_SMOOTH));
}

static void add(void *user, const photon *p, float density)
{
    *(double *)user += (double)(p->flux.r * density);
}

static void add_passed(void *user, const photon *p, double at, float density)
{
    assert_true(fabs(at - 1.0) < 0.01);
    *(double *)user += (double)(p->flux.r * density);
}

static double light_at(const photon_map *m, double x, double y, double least)
{
    double sum = 0.0;

    photon_map_find(m, pov_vec3_of(x, y, 1.0), up, least, add, &sum);
    return sum;
}

static void assert_near(double found, double wanted, double by)
{
    if (!(fabs(found - wanted) <= by))
        fail_msg("%g instead of %g", found, wanted);
}

static void narrow_discs_are_as_wide_as_samples_lie_apart(void **state)
{
    tiny s;
    photon_map m;

    (void)state;
    tiny_begin(&s, NULL);
    gather(&m, &s.env);
    assert_near(light_at(&m, 0.05, 0.0, 0.0), 0.0, 0.0);
    assert_near(light_at(&m, 0.05, 0.0, 0.1), 0.75 * 0.75 * 3.0 / (3.14159265358979 * 0.01), 1e-3);
    assert_near(light_at(&m, 0.0, 0.11, 0.1), 0.0, 0.0);
    photon_map_free(&m, &s.env);
    tiny_end(&s);
}

static void wide_discs_hold_all_light(void **state)
{
    const int n = 200;
    double sum = 0.0;
    tiny s;
    photon_map m;

    (void)state;
    tiny_begin(&s, NULL);
    gather(&m, &s.env);
    for (int y = 0; y < n; y++)
        for (int x = 0; x < n; x++)
            sum += light_at(&m, 0.3 * ((x + 0.5) / n - 0.5), 0.3 * ((y + 0.5) / n - 0.5), 0.1) * (0.3 / n) * (0.3 / n);
    assert_near(sum, 1.0, 1e-3);
    photon_map_free(&m, &s.env);
    tiny_end(&s);
}

/* Photons in a grid of the plane z = 1, whose light per area is 1 + x^2. */
static void curve(photon_map *m, const env *e, photon_kernel kernel)
{
    const int edge = 100;
    photon *all = env_resize(e, NULL, (size_t)edge * (size_t)edge, sizeof *all);

    assert_non_null(all);
    memset(all, 0, (size_t)edge * (size_t)edge * sizeof *all);
    for (int i = 0; i < edge * edge; i++) {
        const double x = (i % edge + 0.5) / edge - 0.5, y = (i / edge + 0.5) / edge - 0.5;
        const float flux = (float)((1.0 + x * x) / (edge * edge));

        all[i].at = pov_vec3_of(x, y, 1.0);
        all[i].flux = colour_of(flux, flux, flux);
        all[i].dir[2] = 1.0f;
        all[i].normal[2] = -1.0f;
    }
    assert_true(photon_map_make(m, e, all, (uint32_t)(edge * edge), 20, kernel));
}

/* The mean square of x over a disc of radius r is r^2/8 by the one kernel, and 0 by the other: what their sum is wrong by, their
 * difference shows. */
static void the_difference_of_the_kernels_is_what_they_blur(void **state)
{
    double found[2];
    tiny s;

    (void)state;
    tiny_begin(&s, NULL);
    for (int k = 0; k < 2; k++) {
        photon_map m;

        curve(&m, &s.env, k == 0 ? PHOTON_SMOOTH : PHOTON_SHARP);
        found[k] = light_at(&m, 0.0, 0.0, 0.3);
        photon_map_free(&m, &s.env);
    }
    assert_near(found[0], 1.0 + 0.3 * 0.3 / 8.0, 2e-4);
    assert_near(found[1], 1.0, 2e-4);
    tiny_end(&s);
}

static void discs_that_a_ray_passes_widen_along_it(void **state)
{
    const photon_ray narrow = { { 0.05, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, 3.0, 0.02, 0.0, NULL };
    const photon_ray wide = { { 0.05, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, 3.0, 0.02, 0.08, NULL };
    double sum = 0.0;
    tiny s;
    photon_map m;

    (void)state;
    tiny_begin(&s, NULL);
    gather(&m, &s.env);
    photon_map_follow(&m, &narrow, add_passed, &sum);
    assert_near(sum, 0.0, 0.0);
    photon_map_follow(&m, &wide, add_passed, &sum);
    assert_near(sum, 0.75 * 0.75 * 3.0 / (3.14159265358979 * 0.01), 1e-3);
    photon_map_free(&m, &s.env);
    tiny_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(narrow_discs_are_as_wide_as_samples_lie_apart),
        cmocka_unit_test(wide_discs_hold_all_light),
        cmocka_unit_test(the_difference_of_the_kernels_is_what_they_blur),
        cmocka_unit_test(discs_that_a_ray_passes_widen_along_it),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
