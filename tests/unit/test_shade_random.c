/* The random numbers of paths. */
#include "shade/random.h"
#include "support/check.h"

#include <math.h>

enum { COUNT = 4, SAMPLES = 4, CELLS = COUNT * SAMPLES };

/* Bits of the cells that the points of a half's first samples lie in, if the square is divided into columns x rows. */
static uint32_t cells_hit(uint32_t half, uint32_t purpose, uint32_t columns)
{
    uint32_t hit = 0;

    for (uint32_t i = 0; i < SAMPLES; i++)
        for (uint32_t k = 0; k < COUNT; k++) {
            const sample_id id = sample_id_of(7, 31, 5, 2 * i + half);
            const sequence_point p = random_point(&id, k, COUNT, purpose);

            hit |= 1u << ((uint32_t)(p.y * (CELLS / columns)) * columns + (uint32_t)(p.x * columns));
        }
    return hit;
}

static void the_points_of_a_half_fill_the_square(void **state)
{
    (void)state;
    for (uint32_t columns = 1; columns <= CELLS; columns *= 2)
        for (uint32_t purpose = 0; purpose < 8; purpose++)
            assert_true(cells_hit(purpose & 1u, purpose, columns) == (1u << CELLS) - 1);
}

static void other_pixels_halves_and_purposes_have_other_points(void **state)
{
    const sample_id a = sample_id_of(7, 31, 5, 0), b = sample_id_of(7, 5, 31, 0), c = sample_id_of(7, 31, 5, 1), d = sample_id_of(8, 31, 5, 0);
    const double x = random_point(&a, 0, 1, 0).x;

    (void)state;
    assert_true(x != random_point(&b, 0, 1, 0).x && x != random_point(&c, 0, 1, 0).x && x != random_point(&d, 0, 1, 0).x);
    assert_true(x != random_point(&a, 0, 1, 1).x && x == random_point(&a, 0, 1, 0).x);
    assert_true(random_bits(&a, 0) != random_bits(&a, 1) && random_bits(&a, 0) != random_bits(&c, 0));
}

/* Each point is equally likely anywhere, whatever its number: the mean over pixels of products of coordinates. */
static void points_of_two_purposes_know_nothing_of_each_other(void **state)
{
    enum { PIXELS = 20000 };
    double sum[3] = { 0.0, 0.0, 0.0 };

    (void)state;
    for (int i = 0; i < PIXELS; i++) {
        const sample_id id = sample_id_of(1, i % 100, i / 100, 6);
        const sequence_point p = random_point(&id, 3, 4, 0), q = random_point(&id, 3, 1, 1);

        sum[0] += p.x * p.y;
        sum[1] += p.x * q.x;
        sum[2] += random_fraction(random_bits(&id, 2)) * q.y;
    }
    for (int k = 0; k < 3; k++)
        assert_float_equal(sum[k] / PIXELS, 0.25, 5.0 * sqrt(7.0 / 144.0 / PIXELS));
}

static void the_turns_of_a_set_are_those_of_no_other_seed(void **state)
{
    enum { SEEDS = 8, TURNS = 32, ALL = SEEDS * TURNS };
    uint64_t bits[ALL];

    (void)state;
    for (uint32_t i = 0; i < ALL; i++) {
        bits[i] = random_turn(random_set(i / TURNS, 40, 16, 32), i % TURNS) & 0xffffffff;
        for (uint32_t k = 0; k < i; k++)
            assert_true(bits[k] != bits[i]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_points_of_a_half_fill_the_square),
        cmocka_unit_test(other_pixels_halves_and_purposes_have_other_points),
        cmocka_unit_test(points_of_two_purposes_know_nothing_of_each_other),
        cmocka_unit_test(the_turns_of_a_set_are_those_of_no_other_seed),
    };

    return cmocka_run_group_tests_name("random numbers of paths", tests, NULL, NULL);
}
