/* Elementary functions, against the system's in long double. */
#include "base/elementary.h"
#include "base/lanes.h"
#include "base/powers.h"
#include "support/check.h"

#include <float.h>

enum { TRIES = 20000 };

/* Numbers from lo to hi, spread without a pattern. */
static double spread(int k, double lo, double hi)
{
    const double x = (double)k * 0.61803398874989485;

    return lo + (hi - lo) * (x - floor(x));
}

/* The difference in units of the last place of the true value. */
static double units(double x, long double is)
{
    int exponent;

    frexpl(is, &exponent);
    return (double)fabsl(((long double)x - is) / ldexpl(1.0L, exponent - 53));
}

static double larger(double a, double b) { return a > b ? a : b; }

static void exponentials_and_logarithms_are_off_by_two_units_at_most(void **state)
{
    double worst = 0.0;
    (void)state;

    for (int k = 1; k <= TRIES; k++) {
        const double x = spread(k, -700.0, 700.0), near = 1.0 + spread(k, -0.5, 1.0), wide = ldexp(near, k % 2000 - 1000);

        worst = larger(worst, units(elementary_exp(x), expl((long double)x)));
        worst = larger(worst, units(elementary_exp2(x), exp2l((long double)x)));
        worst = larger(worst, units(elementary_log(near), logl((long double)near)));
        worst = larger(worst, units(elementary_log2(near), log2l((long double)near)));
        worst = larger(worst, units(elementary_log(wide), logl((long double)wide)));
        worst = larger(worst, units(elementary_log2(wide), log2l((long double)wide)));
    }
    assert_true(worst < 2.0);
}

/* Zeros, infinities and what has no value among them. */
static void powers_by_lane_have_the_bits_of_one(void **state)
{
    static const double ends[8] = { 0.0, -0.0, HUGE_VAL, -1.0, NAN, 0x1p-1074, 1.0, 1e308 };
    double exponent[LANES_MAX], value[LANES_MAX], one[LANES_MAX];
    (void)state;

    for (int k = 0; k < 2 * LANES_MAX; k += LANES_MAX) {
        for (int i = 0; i < LANES_MAX; i++) {
            exponent[i] = i % 7 == 3 ? ends[i / 7 % 8] : spread(k + i, -50.0, 50.0);
            value[i] = i % 5 == 3 ? ends[i / 5 % 8] : spread(3 * (k + i), 0.0, 2.0);
            one[i] = elementary_pow(value[i], exponent[i]);
        }
        powers_raise_each(exponent, LANES_MAX, value);
        assert_memory_equal(value, one, sizeof one);
        for (int i = 0; i < LANES_MAX; i++)
            one[i] = elementary_pow(value[i] = spread(k + i, 0.0, 9.0), 0.77);
        powers_raise(0.77, LANES_MAX, value);
        assert_memory_equal(value, one, sizeof one);
    }
}

static void powers_are_off_by_two_units_whatever_the_exponent(void **state)
{
    double worst = 0.0;
    (void)state;

    for (int k = 1; k <= TRIES; k++) {
        const double x = spread(k, 0.0, 1.0), y = spread(7 * k, 0.0, 100.0), near = 1.0 - 0x1p-10 * x, large = 5000.0 * y;

        worst = larger(worst, units(elementary_pow(x + 0.01, y), powl((long double)(x + 0.01), (long double)y)));
        worst = larger(worst, units(elementary_pow(x + 1.0, -y), powl((long double)(x + 1.0), (long double)-y)));
        worst = larger(worst, units(elementary_pow(near, large), powl((long double)near, (long double)large)));
    }
    assert_true(worst < 2.0);
}

static void angles_are_off_by_three_units_at_most(void **state)
{
    double worst = 0.0, waves = 0.0;
    (void)state;

    for (int k = 1; k <= TRIES; k++) {
        const double x = spread(k, -1.0, 1.0), y = spread(7 * k, -2.0, 2.0), angle = spread(k, -1e5, 1e5);

        worst = larger(worst, units(elementary_atan2(y, x), atan2l((long double)y, (long double)x)));
        worst = larger(worst, units(elementary_acos(x), acosl((long double)x)));
        worst = larger(worst, units(elementary_asin(x), asinl((long double)x)));
        waves = larger(waves, (double)fabsl((long double)elementary_sin(angle) - sinl((long double)angle)));
        waves = larger(waves, (double)fabsl((long double)elementary_cos(angle) - cosl((long double)angle)));
    }
    assert_true(worst < 3.0);
    assert_true(waves < DBL_EPSILON);
}

static void the_edges_are_those_of_the_system(void **state)
{
    static const double values[] = { 0.0, 1.0, 2.0, 0.5, DBL_MIN, DBL_MAX, 0x1p-1074, 0x1p-1060, HUGE_VAL };
    (void)state;

    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        assert_true(elementary_log2(values[i]) == log2(values[i]));
        for (size_t k = 0; k < sizeof values / sizeof values[0] - 1; k++)
            if (values[k] >= 0.5 || values[i] == 0.0)
                assert_true(fabs(elementary_pow(values[i], values[k]) - pow(values[i], values[k])) <=
                            4.0 * DBL_EPSILON * pow(values[i], values[k]) ||
                            elementary_pow(values[i], values[k]) == pow(values[i], values[k]));
    }
    assert_true(elementary_exp(800.0) == HUGE_VAL && elementary_exp(-800.0) == 0.0 && elementary_exp(0.0) == 1.0);
    assert_true(isnan(elementary_log(-1.0)) && isnan(elementary_pow(-1.0, 2.0)) && isnan(elementary_exp(NAN)));
    assert_true(elementary_atan2(0.0, 0.0) == 0.0 && elementary_atan2(0.0, -1.0) == acos(-1.0));
    assert_true(elementary_atan2(-1.0, 0.0) == -acos(0.0) && elementary_acos(1.0) == 0.0);
    assert_true(isnan(elementary_sin(HUGE_VAL)) && elementary_cos(0.0) == 1.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exponentials_and_logarithms_are_off_by_two_units_at_most),
        cmocka_unit_test(powers_by_lane_have_the_bits_of_one),
        cmocka_unit_test(powers_are_off_by_two_units_whatever_the_exponent),
        cmocka_unit_test(angles_are_off_by_three_units_at_most),
        cmocka_unit_test(the_edges_are_those_of_the_system),
    };

    return cmocka_run_group_tests_name("elementary functions", tests, NULL, NULL);
}
