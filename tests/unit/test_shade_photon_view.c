/* photon/view: cells of pixels, and the photons that are counted in them. */
#include "photon/map.h"
#include "support/check.h"
#include "support/tiny.h"

#include <math.h>
#include <string.h>

enum { WIDE = 8, HIGH = 6 };

/* A camera at z = -4 that sees a piece of the plane z = 0, slanted or straight. */
static void make_screen(photon_screen *s, bool parallel, double lean)
{
    static const double at[3][2] = { { -0.5, 0.5 }, { 0.5, 0.5 }, { -0.5, -0.5 } };
    pov_ray corners[3];

    memset(corners, 0, sizeof corners);
    for (int i = 0; i < 3; i++) {
        const pov_vec3 across = pov_vec3_of(at[i][0], at[i][1], 0.0), to = pov_vec3_of(0.0, lean, 4.0), from = pov_vec3_of(0.0, -lean, -4.0);

        corners[i].org = parallel ? pov_add(from, across) : from;
        corners[i].dir = parallel ? to : pov_add(to, across);
    }
    assert_true(photon_screen_make(s, corners, WIDE, HIGH));
}

/* The ray through a place of that screen. */
static pov_ray ray_at(bool parallel, double lean, double x, double y)
{
    const pov_vec3 across = pov_vec3_of(x / WIDE - 0.5, 0.5 - y / HIGH, 0.0), to = pov_vec3_of(0.0, lean, 4.0), from = pov_vec3_of(0.0, -lean, -4.0);
    pov_ray r;

    memset(&r, 0, sizeof r);
    r.org = parallel ? pov_add(from, across) : from;
    r.dir = parallel ? to : pov_add(to, across);
    return r;
}

static void add(void *user, const photon *p, float density) { *(double *)user += (double)p->flux.r * (double)density; }

/* Photons of the plane z = 0, all but gathered in a point: their light per area is 1/r, all of it within r < 0.4. */
static void gather(photon_map *m, const env *e)
{
    enum { RINGS = 100, SPOKES = 40 };
    photon *all = env_resize(e, NULL, RINGS * SPOKES, sizeof *all);

    assert_non_null(all);
    memset(all, 0, RINGS * SPOKES * sizeof *all);
    for (int i = 0; i < RINGS * SPOKES; i++) {
        const double r = 0.4 * (i / SPOKES + 0.5) / RINGS, angle = 6.28318530718 * (i % SPOKES + 0.618 * (i / SPOKES)) / SPOKES;

        all[i].at = pov_vec3_of(0.03 + r * cos(angle), 0.02 + r * sin(angle), 0.0);
        all[i].flux.r = 1.0f / (RINGS * SPOKES);
        all[i].normal[2] = -1.0f;
    }
    assert_true(photon_map_make(m, e, all, RINGS * SPOKES, 8, PHOTON_SMOOTH));
}

/* The mean light of a pixel, of n samples in the middles of the n cells that sample `number` has, or less than 0: one has none. */
static double light_of(const photon_map *m, const photon_screen *s, bool parallel, double lean, int x, int y, uint32_t number)
{
    const pov_vec3 normal = pov_vec3_of(0.0, 0.0, -1.0);
    photon_view v = { .slope = 0.0, .width = 1.0 };
    double sum = 0.0;
    pov_ray ray = ray_at(parallel, lean, x, y);

    photon_view_begin(&v, s, &ray, number);
    for (int i = 0; i < v.parts[0] * v.parts[1]; i++) {
        const double dx = (i % v.parts[0] + 0.3) / v.parts[0], dy = (i / v.parts[0] + 0.6) / v.parts[1];
        photon_cell cell;

        ray = ray_at(parallel, lean, x + dx, y + dy);
        photon_view_begin(&v, s, &ray, number);
        if (!photon_view_cell(&v, pov_add(ray.org, pov_scale(ray.dir, -ray.org.z / ray.dir.z)), normal, &cell))
            return -1.0;
        photon_map_count(m, pov_add(ray.org, pov_scale(ray.dir, -ray.org.z / ray.dir.z)), normal, &cell, add, &sum);
    }
    return sum / (v.parts[0] * v.parts[1]);
}

/* Where rays meet the plane they are as far apart as on the screen. */
static void cells_hold_all_light_once(bool parallel, double lean, uint32_t number)
{
    double all = 0.0;
    photon_screen screen;
    photon_map m;
    tiny s;

    tiny_begin(&s, NULL);
    make_screen(&screen, parallel, lean);
    gather(&m, &s.env);
    for (int y = 0; y < HIGH; y++)
        for (int x = 0; x < WIDE; x++) {
            const double seen = light_of(&m, &screen, parallel, lean, x, y, number);

            assert_true(seen >= 0.0);
            all += seen / (WIDE * HIGH);
        }
    if (!(fabs(all - 1.0) < 1e-6))
        fail_msg("%.9f of the light, by sample %d", all, (int)number);
    photon_map_free(&m, &s.env);
    tiny_end(&s);
}

static void each_photon_counts_once_however_light_gathers(void **state)
{
    static const uint32_t numbers[] = { 0, 1, 8, 33, 130 };

    (void)state;
    for (int i = 0; i < 5; i++) {
        cells_hold_all_light_once(true, 0.0, numbers[i]);
        cells_hold_all_light_once(true, 3.0, numbers[i]);
        cells_hold_all_light_once(false, 0.0, numbers[i]);
        cells_hold_all_light_once(false, 3.0, numbers[i]);
    }
}

static void add_passed(void *user, const photon *p, double at, float density)
{
    (void)at;
    *(double *)user += (double)p->flux.r * (double)density;
}

/* The same of photons in a medium that rays pass: those lie on the plane z = 0 by chance, and light counts across the rays. */
static double passed_of(const photon_map *m, const photon_screen *s, bool parallel, double lean, int x, int y, uint32_t number)
{
    photon_view v = { .slope = parallel ? 0.0 : 1.0, .width = parallel ? 1.0 : 0.0 };
    double sum = 0.0;
    pov_ray ray = ray_at(parallel, lean, x, y);

    photon_view_begin(&v, s, &ray, number);
    for (int i = 0; i < v.parts[0] * v.parts[1]; i++) {
        const double dx = (i % v.parts[0] + 0.3) / v.parts[0], dy = (i / v.parts[0] + 0.6) / v.parts[1];
        photon_ray along = { .length = 50.0 };
        photon_cell cell;

        ray = ray_at(parallel, lean, x + dx, y + dy);
        photon_view_begin(&v, s, &ray, number);
        along.dir = pov_unit(ray.dir);
        along.from = pov_add(ray.org, pov_scale(along.dir, 0.5));
        assert_true(photon_view_along(&v, along.from, along.dir, &cell));
        along.cell = &cell;
        photon_map_follow(m, &along, add_passed, &sum);
    }
    return sum / (v.parts[0] * v.parts[1]);
}

/* An image of 1 x 1 in the plane that is straight before the camera; what is seen from there at a cosine counts for as much less of it. */
static void rays_hold_all_light_of_a_medium_once(bool parallel, double lean, uint32_t number, double wanted)
{
    double all = 0.0;
    photon_screen screen;
    photon_map m;
    tiny s;

    tiny_begin(&s, NULL);
    make_screen(&screen, parallel, lean);
    gather(&m, &s.env);
    for (int y = 0; y < HIGH; y++)
        for (int x = 0; x < WIDE; x++)
            all += passed_of(&m, &screen, parallel, lean, x, y, number) / (WIDE * HIGH);
    if (!(fabs(all / wanted - 1.0) < 0.01))
        fail_msg("%.6f instead of %.6f, by sample %d", all, wanted, (int)number);
    photon_map_free(&m, &s.env);
    tiny_end(&s);
}

static void each_photon_of_a_medium_counts_once(void **state)
{
    (void)state;
    for (uint32_t number = 1; number < 200; number = 4 * number + 5) {
        rays_hold_all_light_of_a_medium_once(true, 0.0, number, 1.0);
        rays_hold_all_light_of_a_medium_once(true, 3.0, number, 1.0 / 0.8);
        rays_hold_all_light_of_a_medium_once(false, 0.0, number, 1.0);
    }
}

/* m samples of a half have about sqrt(m) cells. */
static void cells_shrink_as_samples_grow(void **state)
{
    static const struct { uint32_t number; int across, down; } wanted[] = {
        { 0, 1, 1 }, { 1, 1, 1 }, { 7, 1, 1 }, { 8, 2, 1 }, { 31, 2, 1 }, { 32, 2, 2 }, { 127, 2, 2 }, { 128, 4, 2 }, { 131071, 16, 8 }
    };
    const pov_ray ray = ray_at(false, 0.0, 3.5, 2.5);
    photon_screen s;

    (void)state;
    make_screen(&s, false, 0.0);
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        photon_view v = { .slope = 1.0 };

        photon_view_begin(&v, &s, &ray, wanted[i].number);
        assert_int_equal(v.parts[0], wanted[i].across);
        assert_int_equal(v.parts[1], wanted[i].down);
    }
}

static void what_is_not_seen_straight_or_too_flat_has_no_cell(void **state)
{
    const pov_ray ray = ray_at(false, 0.0, 3.5, 2.5);
    const pov_vec3 at = pov_add(ray.org, ray.dir), normal = pov_vec3_of(0.0, 0.0, -1.0);
    photon_view v = { .slope = 1.0 };
    photon_screen s;
    photon_cell cell;

    (void)state;
    make_screen(&s, false, 0.0);
    photon_view_begin(&v, &s, &ray, 0);
    assert_true(photon_view_cell(&v, at, normal, &cell));
    assert_true(cell.lo[0] == 3.0 && cell.hi[0] == 4.0 && cell.lo[1] == 2.0 && cell.hi[1] == 3.0);
    assert_false(photon_view_cell(&v, pov_add(at, pov_vec3_of(0.01, 0.0, 0.0)), normal, &cell));
    assert_false(photon_view_cell(&v, pov_sub(ray.org, ray.dir), normal, &cell));
    assert_false(photon_view_cell(&v, at, pov_unit(pov_vec3_of(1.0, 0.0, 0.0)), &cell));
    assert_true(photon_view_along(&v, ray.org, pov_unit(ray.dir), &cell));
    assert_false(photon_view_along(&v, ray.org, pov_unit(pov_add(ray.dir, pov_vec3_of(0.01, 0.0, 0.0))), &cell));
    assert_false(photon_view_along(&v, at, pov_unit(pov_vec3_of(1.0, 0.0, 0.0)), &cell));
    photon_view_begin(&v, NULL, &ray, 0);
    assert_false(photon_view_cell(&v, at, normal, &cell));
    assert_false(photon_view_along(&v, ray.org, pov_unit(ray.dir), &cell));
}

static void rays_that_neither_meet_nor_are_parallel_have_no_screen(void **state)
{
    pov_ray corners[3] = { ray_at(false, 0.0, 0, 0), ray_at(false, 0.0, WIDE, 0), ray_at(false, 0.0, 0, HIGH) };
    photon_screen s;

    (void)state;
    assert_true(photon_screen_make(&s, corners, WIDE, HIGH));
    corners[1].org.x += 0.1;
    assert_false(photon_screen_make(&s, corners, WIDE, HIGH));
    corners[1] = corners[0];
    assert_false(photon_screen_make(&s, corners, WIDE, HIGH));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_photon_counts_once_however_light_gathers),
        cmocka_unit_test(each_photon_of_a_medium_counts_once),
        cmocka_unit_test(cells_shrink_as_samples_grow),
        cmocka_unit_test(what_is_not_seen_straight_or_too_flat_has_no_cell),
        cmocka_unit_test(rays_that_neither_meet_nor_are_parallel_have_no_screen),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
