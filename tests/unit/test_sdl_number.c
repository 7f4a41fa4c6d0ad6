/* sdl/number: digits to the nearest double. */
#include "support/check.h"

#include "sdl/number.h"

#include <locale.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static number_state read_all(const char *text, double *out)
{
    const char *after;
    number_state state = number_read(text, text + strlen(text), &after, out);

    if (state != NUMBER_MALFORMED)
        assert_ptr_equal(after, text + strlen(text));
    return state;
}

static void assert_reads(const char *text, double wanted)
{
    double value;

    assert_int_equal(read_all(text, &value), NUMBER_FINE);
    if (value != wanted)
        fail_msg("%s gave %.17g, not %.17g", text, value, wanted);
}

static void number_reads_every_form_of_the_language(void **state)
{
    (void)state;
    assert_reads("0", 0.0);
    assert_reads("5", 5.0);
    assert_reads("5.", 5.0);
    assert_reads(".5", 0.5);
    assert_reads("0.5", 0.5);
    assert_reads("1e-3", 0.001);
    assert_reads("1.e2", 100.0);
    assert_reads("1E+2", 100.0);
    assert_reads("007", 7.0);
    assert_reads("0e999", 0.0);
}

static void number_stops_where_it_ends(void **state)
{
    static const char text[] = "1.5,2";
    const char *after;
    double value;

    (void)state;
    assert_int_equal(number_read(text, text + 5, &after, &value), NUMBER_FINE);
    assert_ptr_equal(after, text + 3);
    assert_int_equal(number_read(text, text + 1, &after, &value), NUMBER_FINE);
    assert_true(value == 1.0);
}

static void number_refuses_what_is_none(void **state)
{
    static const char *const wrong[] = {"1.2.3", "1..2", "1.5.", "1e5.5"};
    double value;
    size_t i;

    (void)state;
    for (i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
        assert_int_equal(read_all(wrong[i], &value), NUMBER_MALFORMED);
}

/* A word may stand right behind a number, and an exponent without digits is 0. */
static void number_ends_before_a_word(void **state)
{
    static const struct { const char *text; int length; double value; } cases[] = {
        { "0x10", 1, 0.0 }, { "2x", 1, 2.0 }, { "1e", 2, 1.0 }, { "3e+", 3, 3.0 }, { "1e5x", 3, 1e5 }, { "7_", 1, 7.0 },
    };
    const char *after;
    double value;
    size_t i;

    (void)state;
    for (i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const char *text = cases[i].text;

        assert_int_equal(number_read(text, text + strlen(text), &after, &value), NUMBER_FINE);
        assert_int_equal(after - text, cases[i].length);
        assert_true(value == cases[i].value);
    }
}

static void number_tells_what_does_not_fit(void **state)
{
    double value;

    (void)state;
    assert_int_equal(read_all("1e400", &value), NUMBER_HUGE);
    assert_int_equal(read_all("1.8e308", &value), NUMBER_HUGE);
    assert_int_equal(read_all("1e99999999999999999999", &value), NUMBER_HUGE);
    assert_int_equal(read_all("1e-400", &value), NUMBER_TINY);
    assert_int_equal(read_all("1e-99999999999999999999", &value), NUMBER_TINY);
    assert_true(value == 0.0);
    assert_reads("1.7976931348623157e308", 1.7976931348623157e308);
    assert_reads("4.9406564584124654e-324", 4.9406564584124654e-324);
}

static uint64_t next_random(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return *seed ^ *seed >> 29;
}

/* strtod of the C library is correctly rounded; every form of a random double must come out as the same bits.
 * */
static void number_is_rounded_correctly(void **state)
{
    static const char *const forms[] = {"%.17g", "%.16e", "%.15g", "%.20e", "%.6f", "%.19f", "%.30e"};
    uint64_t seed = 7, bits;
    char text[512];
    double value, sample;
    int i;

    (void)state;
    for (i = 0; i < 200000; i++) {
        bits = next_random(&seed) & 0x7FFFFFFFFFFFFFFFu;
        if (i % 2)
            bits = (bits & 0x000FFFFFFFFFFFFFu) | (uint64_t)(1023 - 40 + (int)(bits >> 52) % 80) << 52;
        memcpy(&sample, &bits, sizeof sample);
        if (!(fabs(sample) < 1e300))
            continue;
        snprintf(text, sizeof text, forms[i % 7], sample);
        if (read_all(text, &value) == NUMBER_HUGE || value != strtod(text, NULL))
            fail_msg("%s gave %.17g, not %.17g", text, value, strtod(text, NULL));
    }
}

/* The exact middle between two doubles goes to the even one, and anything beyond it to the next. */
static void number_decides_the_middle_of_two_doubles(void **state)
{
    char text[1200] = "9007199254740993.";

    (void)state;
    assert_reads("9007199254740993", 9007199254740992.0);
    assert_reads("9007199254740993.0000000000000000000000", 9007199254740992.0);
    assert_reads("9007199254740993.00000000000000000001", 9007199254740994.0);
    assert_reads("1125899906842624.125", 1125899906842624.0);
    assert_reads("1125899906842624.1250001", 1125899906842624.25);
    memset(text + strlen(text), '0', 1000);
    strcpy(text + 1017, "1");
    assert_reads(text, 9007199254740994.0);
}

static void number_reads_absurd_lengths(void **state)
{
    const size_t length = 1 << 20;
    char *text = malloc(length + 32);
    double value;

    (void)state;
    assert_non_null(text);
    memset(text, '9', length);
    strcpy(text + length, "e-1048576");
    assert_int_equal(read_all(text, &value), NUMBER_FINE);
    assert_true(value == 1.0);
    memset(text, '0', length);
    text[1] = '.';
    strcpy(text + length, "125e1048575");
    assert_int_equal(read_all(text, &value), NUMBER_FINE);
    assert_true(value == 1.25);
    free(text);
}

/* Only where the machine has such a locale; the point is the language's, whatever the program speaks. */
static void number_does_not_know_the_locale(void **state)
{
    (void)state;
    if (!setlocale(LC_ALL, "de_DE.UTF-8") && !setlocale(LC_ALL, "fr_FR.UTF-8") &&
        !setlocale(LC_ALL, "de_DE")) {
        setlocale(LC_ALL, "C");
        print_message("neither German nor French is installed");
        skip();
    }
    assert_reads("123456789012345678901234567890.5", 123456789012345678901234567890.5);
    assert_reads("0.1234567890123456789012345", 0.1234567890123456789012345);
    setlocale(LC_ALL, "C");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(number_reads_every_form_of_the_language),
        cmocka_unit_test(number_stops_where_it_ends),
        cmocka_unit_test(number_refuses_what_is_none),
        cmocka_unit_test(number_ends_before_a_word),
        cmocka_unit_test(number_tells_what_does_not_fit),
        cmocka_unit_test(number_is_rounded_correctly),
        cmocka_unit_test(number_decides_the_middle_of_two_doubles),
        cmocka_unit_test(number_reads_absurd_lengths),
        cmocka_unit_test(number_does_not_know_the_locale),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
