/* The points of area lights. */
#include "light/grid.h"
#include "support/check.h"
#include "support/near.h"

#include <math.h>
#include <string.h>

static env memory;

static const pov_vec3 axes[2] = { { 2.0, 0.0, 0.0 }, { 0.0, 0.0, 4.0 } };

static light area_of(uint32_t columns, uint32_t rows, uint32_t flags)
{
    light l;

    memset(&l, 0, sizeof l);
    l.flags = LIGHT_AREA | flags;
    l.area.axes[0] = axes[0];
    l.area.axes[1] = axes[1];
    l.area.counts[0] = columns;
    l.area.counts[1] = rows;
    return l;
}

static light_grid *grid_of(const light *l, bool soft)
{
    light_grid *g = grid_create(&memory, l, soft);

    assert_non_null(g);
    return g;
}

static void expect_weights(uint32_t columns, uint32_t rows, const float *first_row)
{
    const light l = area_of(columns, rows, 0);
    light_grid *g = grid_of(&l, false);
    float sum = 0.0f;

    for (uint32_t k = 0; k < g->count; k++)
        sum += g->points[k].weight;
    for (uint32_t k = 0; k < columns; k++)
        assert_near(g->points[k].weight, first_row[k], 1e-7);
    assert_near(sum, 1.0, 1e-6);
    env_free(&memory, g);
}

static void weights_of_points_are_those_of_a_grid_that_is_halved(void **state)
{
    static const float two[2] = { 0.5f, 0.5f }, three[3] = { 0.25f, 0.5f, 0.25f };
    static const float five[5] = { 0.125f, 0.25f, 0.25f, 0.25f, 0.125f };
    static const float seven[7] = { 0.125f, 0.125f, 0.125f, 0.25f, 0.125f, 0.125f, 0.125f };
    static const float five_by_three[5] = { 0.03125f, 0.0625f, 0.0625f, 0.0625f, 0.03125f };

    (void)state;
    expect_weights(2, 1, two);
    expect_weights(3, 1, three);
    expect_weights(5, 1, five);
    expect_weights(7, 1, seven);
    expect_weights(5, 3, five_by_three);
}

/* Offsets of the k-th point at many lit points, which look at the light along y. */
static void offsets_at(const light *l, const light_grid *g, uint32_t k, uint32_t draw, vec_lanes *out)
{
    vec_lanes point, none, to;
    uint32_t points[LANES_MAX];
    const light_points at = { &point, &none, LANES_MAX };

    memset(&none, 0, sizeof none);
    for (uint32_t i = 0; i < LANES_MAX; i++) {
        lanes_put(&point, i, pov_vec3_of(0.1 * i, 1.0, 0.3));
        lanes_put(&to, i, pov_vec3_of(0.0, 5.0, 0.0));
        points[i] = k;
    }
    grid_aim(l, g, points, draw, &at, &to, out, NULL);
    for (uint32_t i = 0; i < LANES_MAX; i++)
        out->y[i] -= 5.0;
}

/* The second moment of u tells how far the points reach: 1/12 of the square of an evenly lit width. */
static void a_soft_light_is_lit_all_over(void **state)
{
    const light l = area_of(8, 8, 0);
    light_grid *g = grid_of(&l, true);
    double sum = 0.0, square = 0.0;
    vec_lanes offset;

    (void)state;
    for (uint32_t k = 0; k < g->count; k++)
        for (uint32_t draw = 0; draw < 16; draw++) {
            offsets_at(&l, g, k, draw, &offset);
            for (uint32_t i = 0; i < LANES_MAX; i++) {
                assert_true(fabs(offset.x[i]) <= 1.0 && offset.y[i] == 0.0 && fabs(offset.z[i]) <= 2.0);
                sum += g->points[k].weight * offset.z[i] / (16.0 * LANES_MAX);
                square += g->points[k].weight * offset.z[i] * offset.z[i] / (16.0 * LANES_MAX);
            }
        }
    assert_near(sum, 0.0, 0.05);
    assert_near(square, 16.0 / 12.0, 0.05);
    env_free(&memory, g);
}

static void points_that_jitter_stay_within_half_a_step(void **state)
{
    const light l = area_of(5, 1, LIGHT_JITTER);
    light_grid *g = grid_of(&l, false);
    vec_lanes offset, other;
    uint32_t same = 0;

    (void)state;
    for (uint32_t k = 0; k < g->count; k++) {
        const double middle = 2.0 * ((double)k / 4.0 - 0.5);

        offsets_at(&l, g, k, 0, &offset);
        offsets_at(&l, g, k, 1, &other);
        for (uint32_t i = 0; i < LANES_MAX; i++) {
            assert_true(fabs(offset.x[i] - middle) <= 0.25 && offset.z[i] == 0.0);
            same += offset.x[i] == other.x[i];
        }
    }
    assert_int_equal(same, 0);
    env_free(&memory, g);
}

static void a_disc_has_no_corners(void **state)
{
    const light l = area_of(4, 4, LIGHT_CIRCULAR);
    light_grid *soft = grid_of(&l, true), *g = grid_of(&l, false);
    vec_lanes offset;

    (void)state;
    for (uint32_t k = 0; k < soft->count; k++) {
        offsets_at(&l, soft, k, 0, &offset);
        for (uint32_t i = 0; i < LANES_MAX; i++)
            assert_true(hypot(offset.x[i], offset.z[i] / 2.0) <= 1.0 + 1e-12);
    }
    assert_near(hypot(g->points[0].u, g->points[0].v), 0.499, 1e-12);
    assert_false(g->moves);
    env_free(&memory, soft);
    env_free(&memory, g);
}

static void an_area_that_is_turned_lies_across_the_direction(void **state)
{
    const light l = area_of(3, 3, LIGHT_ORIENT);
    light_grid *g = grid_of(&l, false);
    vec_lanes offset;

    (void)state;
    for (uint32_t k = 0; k < g->count; k++) {
        offsets_at(&l, g, k, 0, &offset);
        assert_near(offset.y[0], 0.0, 1e-12);
        assert_near(hypot(offset.x[0], offset.z[0]), k == 4 ? 0.0 : 1.0, 0.0021);
        /* Two sides are along z. */
        assert_near(fabs(offset.z[0]), k % 2 == 0 ? (k == 4 ? 0.0 : sqrt(0.5)) : k == 1 || k == 7 ? 1.0 : 0.0, 0.003);
    }
    env_free(&memory, g);
}

/* As POV-Ray's are, before the square becomes a disc. */
static void discs_are_a_little_off_the_middle(void **state)
{
    const light l = area_of(3, 3, LIGHT_CIRCULAR);
    light_grid *g = grid_of(&l, false);

    (void)state;
    assert_near(g->points[4].u, 0.001 * sqrt(0.5), 1e-15);
    assert_near(g->points[4].v, 0.001 * sqrt(0.5), 1e-15);
    assert_near(g->points[0].u, -0.499 * sqrt(0.5), 1e-15);
    assert_near(g->points[8].v, 0.501 * sqrt(0.5), 1e-15);
    env_free(&memory, g);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(weights_of_points_are_those_of_a_grid_that_is_halved),
        cmocka_unit_test(a_soft_light_is_lit_all_over),
        cmocka_unit_test(points_that_jitter_stay_within_half_a_step),
        cmocka_unit_test(a_disc_has_no_corners),
        cmocka_unit_test(discs_are_a_little_off_the_middle),
        cmocka_unit_test(an_area_that_is_turned_lies_across_the_direction),
    };

    env_init(&memory, NULL, NULL, NULL);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
