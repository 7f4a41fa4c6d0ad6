/* test_progress.c - what progress says, and when. */
#include "progress.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void assert_percent(double fraction, const char *expected)
{
    char out[16];

    progress_percent(fraction, out, sizeof out);
    assert_string_equal(out, expected);
}

static void assert_duration(double seconds, const char *expected)
{
    char out[32];

    progress_duration(seconds, out, sizeof out);
    assert_string_equal(out, expected);
}

static void progress_never_rounds_up_to_100(void **state)
{
    (void)state;
    assert_percent(0.0, "0.0");
    assert_percent(0.4239, "42.3");
    assert_percent(0.99999999, "99.9");
    assert_percent(1.0, "100");
    assert_percent(-0.5, "0.0");
}

static void progress_says_durations_as_a_clock_does(void **state)
{
    (void)state;
    assert_duration(0.2, "1 s");
    assert_duration(59.0, "59 s");
    assert_duration(187.0, "3:07");
    assert_duration(7387.0, "2:03:07");
    assert_duration(1e30, "100000:00:00");
}

static void progress_is_silent_when_asked_to_be(void **state)
{
    args a = { .quiet = true, .progress = ARGS_PROGRESS_JSON };
    progress p;

    (void)state;
    progress_init(&p, &a);
    assert_false(progress_due(&p, 1e6));
}

static void progress_without_a_terminal_is_a_line_each_ten_seconds_at_most(void **state)
{
    args a = { .progress = ARGS_PROGRESS_AUTO };
    progress p;

    (void)state;
    setenv("TERM", "dumb", 1);
    progress_init(&p, &a);
    assert_true(p.lines);
    assert_false(progress_due(&p, 9.9));
    assert_true(progress_due(&p, 10.1));
    p.shown = 10.1;
    assert_false(progress_due(&p, 20.0));
}

static void assert_text(int columns, const char *expected)
{
    const pov_progress now = { .size = sizeof now, .fraction = 0.062, .seconds = 2.0, .spp_mean = 4.0, .est_rmse = 0.01,
                               .seconds_left = 95.0, .counts = { .camera = 8800000 } };
    char out[128];

    assert_int_equal(progress_text(&now, columns, out, sizeof out), strlen(expected));
    assert_string_equal(out, expected);
}

/* F10 and defect 3 of the review: "about 0 s to go" where nothing was known. */
static void progress_f10_says_no_time_left_that_is_not_known(void **state)
{
    const pov_progress now = { .size = sizeof now, .fraction = 0.0, .seconds = 11.0, .spp_mean = 1.0, .est_rmse = -1.0,
                               .seconds_left = -1.0, .counts = { .camera = 11000000 } };
    char out[128];

    (void)state;
    progress_text(&now, 80, out, sizeof out);
    assert_string_equal(out, "  0.0 %  1.0 M rays/s");
}

/* Defect 12 of the review. */
static void progress_defect_12_drops_whole_fields_where_the_terminal_is_narrow(void **state)
{
    (void)state;
    assert_text(80, "  6.2 %  4 spp  error 0.01  4.4 M rays/s  ETA 1:35");
    assert_text(51, "  6.2 %  4 spp  error 0.01  4.4 M rays/s  ETA 1:35");
    assert_text(50, "  6.2 %  4 spp  error 0.01  ETA 1:35");
    assert_text(36, "  6.2 %  ETA 1:35");
    assert_text(17, "  6.2 %");
    assert_text(3, "  6.2 %");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(progress_never_rounds_up_to_100),
        cmocka_unit_test(progress_says_durations_as_a_clock_does),
        cmocka_unit_test(progress_f10_says_no_time_left_that_is_not_known),
        cmocka_unit_test(progress_defect_12_drops_whole_fields_where_the_terminal_is_narrow),
        cmocka_unit_test(progress_is_silent_when_asked_to_be),
        cmocka_unit_test(progress_without_a_terminal_is_a_line_each_ten_seconds_at_most),
    };

    return cmocka_run_group_tests_name("povc's progress", tests, NULL, NULL);
}
