/* test_elementary.c - the errors of the elementary functions, against MPFR, are within what elementary.h says. */
#include "base/elementary.h"

#include "support/check.h"

#include <float.h>
#include <mpfr.h>
#include <stdio.h>
#include <stdlib.h>

enum { BITS = 256, ROUNDS = 40000 };
static const double u = DBL_EPSILON / 2.0;

/* ---- arguments: seeded, over many magnitudes ---- */

static uint64_t next(uint64_t *seed)
{
    *seed = *seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return *seed >> 11;
}

static double uniform(uint64_t *seed, double low, double high)
{
    return low + (high - low) * ((double)next(seed) * 0x1p-53);
}

/* 2^low to 2^high in size, of either sign. */
static double wide(uint64_t *seed, double low, double high)
{
    const double size = exp2(uniform(seed, low, high));

    return next(seed) & 1 ? size : -size;
}

/* ---- what is right ---- */

typedef double error_fn(mpfr_t exact, double found);

static double absolute(mpfr_t exact, double found)
{
    mpfr_sub_d(exact, exact, found, MPFR_RNDN);
    return fabs(mpfr_get_d(exact, MPFR_RNDN));
}

static double relative(mpfr_t exact, double found)
{
    const double size = fabs(mpfr_get_d(exact, MPFR_RNDN));

    return size > 0.0 ? absolute(exact, found) / size : fabs(found);
}

static void times_two_pi(mpfr_t v)
{
    mpfr_t pi;

    mpfr_init2(pi, BITS);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_mul(v, v, pi, MPFR_RNDN);
    mpfr_mul_ui(v, v, 2, MPFR_RNDN);
    mpfr_clear(pi);
}

#define CHECK(found, exact_call, error, bound)                                                                          \
    do {                                                                                                                \
        const double bound_ = (bound);                                                                                  \
        exact_call;                                                                                                     \
        const double error_ = error(exact, (found));                                                                    \
        if (!(error_ <= bound_)) {                                                                                      \
            print_error("%.17g, %.17g: error %g u, above %g u\n", a, b, error_ / u, bound_ / u);                        \
            fail();                                                                                                     \
        }                                                                                                               \
        if (error_ / bound_ > worst)                                                                                    \
            worst = error_ / bound_;                                                                                    \
    } while (0)

#define BEGIN(number)                                                                                                   \
    uint64_t seed = number;                                                                                             \
    double worst = 0.0, a = 0.0, b = 0.0;                                                                               \
    mpfr_t exact, other;                                                                                                \
    (void)state;                                                                                                        \
    (void)b;                                                                                                            \
    mpfr_init2(exact, BITS);                                                                                            \
    mpfr_init2(other, BITS);
#define END                                                                                                             \
    mpfr_clears(exact, other, (mpfr_ptr)NULL);                                                                          \
    /* Bounds that are ten times too wide would say nothing. */                                                         \
    assert_true(worst > 0.1)

static void sine_and_cosine_of_turns(void **state)
{
    BEGIN(1)
    for (int i = 0; i < ROUNDS; i++) {
        a = i & 1 ? uniform(&seed, -3.0, 3.0) : wide(&seed, -60.0, 40.0);
        CHECK(elementary_sin_turns(a), (mpfr_set_d(exact, a, MPFR_RNDN), times_two_pi(exact), mpfr_sin(exact, exact, MPFR_RNDN)),
              absolute, 3.0 * u);
        CHECK(elementary_cos_turns(a), (mpfr_set_d(exact, a, MPFR_RNDN), times_two_pi(exact), mpfr_cos(exact, exact, MPFR_RNDN)),
              absolute, 3.0 * u);
    }
    END;
}

static void sine_and_cosine_of_radians(void **state)
{
    BEGIN(2)
    for (int i = 0; i < ROUNDS; i++) {
        a = i & 1 ? uniform(&seed, -20.0, 20.0) : wide(&seed, -60.0, 19.9);
        CHECK(elementary_sin(a), (mpfr_set_d(exact, a, MPFR_RNDN), mpfr_sin(exact, exact, MPFR_RNDN)), absolute, 2.0 * u);
        CHECK(elementary_cos(a), (mpfr_set_d(exact, a, MPFR_RNDN), mpfr_cos(exact, exact, MPFR_RNDN)), absolute, 2.0 * u);
    }
    END;
}

static void arc_tangents(void **state)
{
    BEGIN(3)
    for (int i = 0; i < ROUNDS; i++) {
        a = i & 1 ? uniform(&seed, -2.0, 2.0) : wide(&seed, -60.0, 60.0);
        b = i & 2 ? uniform(&seed, -2.0, 2.0) : wide(&seed, -60.0, 60.0);
        CHECK(elementary_atan2(a, b), (mpfr_set_d(exact, a, MPFR_RNDN), mpfr_set_d(other, b, MPFR_RNDN),
                                       mpfr_atan2(exact, exact, other, MPFR_RNDN)), relative, 4.0 * u);
    }
    END;
}

static void arc_sines_and_cosines(void **state)
{
    BEGIN(4)
    for (int i = 0; i < ROUNDS; i++) {
        a = i & 1 ? uniform(&seed, -1.0, 1.0) : copysign(1.0 - exp2(uniform(&seed, -52.0, -1.0)), uniform(&seed, -1.0, 1.0));
        CHECK(elementary_asin(a), (mpfr_set_d(exact, a, MPFR_RNDN), mpfr_asin(exact, exact, MPFR_RNDN)), absolute, 8.0 * u);
        CHECK(elementary_acos(a), (mpfr_set_d(exact, a, MPFR_RNDN), mpfr_acos(exact, exact, MPFR_RNDN)), absolute, 8.0 * u);
    }
    END;
}

static void logarithms_and_exponentials(void **state)
{
    BEGIN(5)
    for (int i = 0; i < ROUNDS; i++) {
        a = i & 1 ? uniform(&seed, 0.5, 2.0) : fabs(wide(&seed, -1000.0, 1000.0));
        CHECK(elementary_log(a), (mpfr_set_d(exact, a, MPFR_RNDN), mpfr_log(exact, exact, MPFR_RNDN)), relative,
              4.0 * u);
        CHECK(elementary_log2(a), (mpfr_set_d(exact, a, MPFR_RNDN), mpfr_log2(exact, exact, MPFR_RNDN)), relative,
              4.0 * u);
        a = i & 1 ? uniform(&seed, -700.0, 700.0) : wide(&seed, -40.0, 4.0);
        CHECK(elementary_exp(a), (mpfr_set_d(exact, a, MPFR_RNDN), mpfr_exp(exact, exact, MPFR_RNDN)), relative, 4.0 * u);
        a = i & 1 ? uniform(&seed, -1022.0, 1023.99) : wide(&seed, -40.0, 4.0);
        CHECK(elementary_exp2(a), (mpfr_set_d(exact, a, MPFR_RNDN), mpfr_exp2(exact, exact, MPFR_RNDN)), relative, 4.0 * u);
    }
    END;
}

static void powers(void **state)
{
    BEGIN(6)
    for (int i = 0; i < ROUNDS; i++) {
        a = fabs(wide(&seed, -60.0, 20.0));
        b = uniform(&seed, -10.0, 10.0);
        CHECK(elementary_pow(a, b), (mpfr_set_d(exact, a, MPFR_RNDN), mpfr_set_d(other, b, MPFR_RNDN),
                                     mpfr_pow(exact, exact, other, MPFR_RNDN)), relative, 4.0 * u);
    }
    END;
}

static void what_is_exact(void **state)
{
    (void)state;
    assert_true(elementary_sin_turns(0.0) == 0.0 && elementary_sin_turns(0.5) == 0.0 && elementary_sin_turns(1e300) == 0.0);
    assert_true(elementary_cos_turns(0.25) == 0.0 && elementary_cos_turns(-7.75) == 0.0);
    assert_true(elementary_atan2(0.0, 0.0) == 0.0 && elementary_atan2(0.0, 5.0) == 0.0);
    assert_true(elementary_atan2(0.0, -5.0) == atan2(0.0, -5.0));
    assert_true(elementary_log(1.0) == 0.0 && elementary_exp(0.0) == 1.0);
    assert_true(elementary_log2(8.0) == 3.0 && elementary_exp2(10.0) == 1024.0);
    assert_true(elementary_exp(-1e9) == 0.0 && isinf(elementary_exp(1e9)));
    assert_true(elementary_pow(0.0, 0.0) == 1.0 && elementary_pow(0.0, 2.0) == 0.0 && isinf(elementary_pow(0.0, -1.0)));
    assert_true(elementary_pow(1.0, 5.5) == 1.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sine_and_cosine_of_turns),
        cmocka_unit_test(sine_and_cosine_of_radians),
        cmocka_unit_test(arc_tangents),
        cmocka_unit_test(arc_sines_and_cosines),
        cmocka_unit_test(logarithms_and_exponentials),
        cmocka_unit_test(powers),
        cmocka_unit_test(what_is_exact),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
