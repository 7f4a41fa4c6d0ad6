/* Unit vectors by one division each, against three divisions. */
#include "support/check.h"

#include "base/mix.h"
#include "shade/geometry.h"

#include <string.h>

enum { TRIES = 1000000 };

/* 52 random bits, with an exponent from -range to range. */
static double draw(uint64_t *seed, int range)
{
    const uint64_t bits = mix_bits(*seed += 0x9e3779b97f4a7c15u), other = mix_bits(bits);
    const double size = ldexp(1.0 + (double)(bits >> 12) * 0x1p-52, (int)(other % (uint64_t)(2 * range + 1)) - range);

    return other >> 63 ? -size : size;
}

static bool have_same_bits(double a, double b) { return memcmp(&a, &b, sizeof a) == 0; }

static void quotients_by_an_inverse_have_the_bits_of_divisions(void **state)
{
    uint64_t seed = 1;
    (void)state;

    for (int k = 0; k < TRIES; k++) {
        const double a = draw(&seed, k % 400), by = fabs(draw(&seed, k % 300));

        assert_true(pov_is_moderate(a));
        assert_true(have_same_bits(pov_quotient(a, by, 1.0 / by), a / by));
    }
}

/* Divisors next to powers of two, and quotients next to numbers half way between two doubles. */
static void quotients_that_are_hard_to_round_have_the_bits_of_divisions(void **state)
{
    uint64_t seed = 2;
    (void)state;

    for (int k = 0; k < TRIES; k++) {
        const double next = 1.0 + (double)(k % 64) * 0x1p-52, by = k & 64 ? next : 2.0 - (double)(k % 64 + 1) * 0x1p-52;
        const double of = fabs(draw(&seed, 0)), half = by * (of + 0x1p-53), near = k & 128 ? nextafter(half, 8.0) : half;
        const double other = of * (1.0 + 0x1p-53), a = of * other;

        assert_true(have_same_bits(pov_quotient(near, by, 1.0 / by), near / by));
        assert_true(have_same_bits(pov_quotient(of, by, 1.0 / by), of / by));
        assert_true(have_same_bits(pov_quotient(a, of, 1.0 / of), a / of));
    }
}

static void assert_unit(double x, double y, double z)
{
    const pov_vec3 is = pov_unit(pov_vec3_of(x, y, z));
    pov_vec3 unit;

    if (geometry_unit(x, y, z, &unit)) {
        assert_true(have_same_bits(unit.x, is.x));
        assert_true(have_same_bits(unit.y, is.y));
        assert_true(have_same_bits(unit.z, is.z));
    }
}

static void unit_vectors_have_the_bits_of_pov_unit_or_are_declined(void **state)
{
    static const double odd[] = { 0.0, -0.0, 0x1p-1074, -1e-308, 1e-290, 1e-151, 1e-149, 1e-119, 1e119, 1e150, 1e300, HUGE_VAL, NAN, 1.0 };
    const int n = (int)(sizeof odd / sizeof odd[0]);
    uint64_t seed = 3;
    pov_vec3 unit;
    (void)state;

    for (int k = 0; k < TRIES; k++)
        assert_unit(draw(&seed, k % 200), draw(&seed, k % 200), k % 3 ? draw(&seed, k % 200) : odd[k % n]);
    for (int k = 0; k < n * n * n; k++)
        assert_unit(odd[k % n], odd[k / n % n], odd[k / n / n]);
    assert_true(geometry_unit(0.0, -0.0, 3.0, &unit));
    assert_true(have_same_bits(unit.y, -0.0));
    assert_false(geometry_unit(0.0, 0.0, 0.0, &unit));
    assert_false(geometry_unit(1e125, 1.0, 1.0, &unit));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quotients_by_an_inverse_have_the_bits_of_divisions),
        cmocka_unit_test(quotients_that_are_hard_to_round_have_the_bits_of_divisions),
        cmocka_unit_test(unit_vectors_have_the_bits_of_pov_unit_or_are_declined),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
