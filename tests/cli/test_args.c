/* test_args.c - povc's command line. */
#include "args.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST_WORDS = 40 };

/* The words of a line, split at blanks, as argv. */
static args_verdict parse(args *a, const char *line)
{
    static char text[512], name[] = "povc";
    char *argv[MOST_WORDS + 2] = { name };
    int argc = 1;

    assert_true(strlen(line) < sizeof text);
    strcpy(text, line);
    for (char *word = strtok(text, " "); word; word = strtok(NULL, " ")) {
        assert_true(argc <= MOST_WORDS);
        argv[argc++] = word;
    }
    return args_parse(a, argc, argv);
}

static void assert_refused(const char *line, const char *said)
{
    args a;

    if (parse(&a, line) != ARGS_WRONG)
        fail_msg("\"%s\" was taken", line);
    if (!strstr(a.problem, said))
        fail_msg("\"%s\": said \"%s\", not \"%s\"", line, a.problem, said);
}

static void args_reads_scene_sizes_and_output(void **state)
{
    args a;

    (void)state;
    assert_int_equal(parse(&a, "s.pov 1024 768 out.png"), ARGS_RUN);
    assert_string_equal(a.scene, "s.pov");
    assert_int_equal(a.width, 1024);
    assert_int_equal(a.height, 768);
    assert_string_equal(a.output, "out.png");
    assert_int_equal(a.crop.width, 0);
    assert_int_equal(a.threads, 0);
}

static void args_reads_options_wherever_they_stand(void **state)
{
    static const char *const lines[] = { "-t 3 --stats s.pov 10 20 o.png", "s.pov -t 3 10 --stats 20 o.png",
                                         "s.pov 10 20 o.png --stats --threads=3",
                                         "s.pov 10 20 o.png -t3 --stats" };

    (void)state;
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++) {
        args a;

        assert_int_equal(parse(&a, lines[i]), ARGS_RUN);
        assert_string_equal(a.scene, "s.pov");
        assert_int_equal(a.height, 20);
        assert_int_equal(a.threads, 3);
        assert_true(a.stats);
    }
}

static void args_reads_every_option(void **state)
{
    args a;

    (void)state;
    assert_int_equal(parse(&a, "s 9 9 o --spp 4 --max-depth 7 --bits 16 --transfer srgb --format .ppm "
                                "--dialect povray"), ARGS_RUN);
    assert_int_equal(a.samples, 4);
    assert_int_equal(a.max_depth, 7);
    assert_int_equal(a.bits, 16);
    assert_int_equal(a.transfer, ARGS_TRANSFER_SRGB);
    assert_string_equal(a.format, "ppm");
    assert_int_equal(a.dialect, POV_DIALECT_POVRAY);
    assert_int_equal(parse(&a, "s --aov depth d.pfm 9 9 o --accuracy max --aov certainty c.png"), ARGS_RUN);
    assert_int_equal(a.accuracy, POV_ACCURACY_MAX);
    assert_string_equal(a.aov[ARGS_AOV_DEPTH], "d.pfm");
    assert_string_equal(a.aov[ARGS_AOV_CERTAINTY], "c.png");
    assert_null(a.aov[ARGS_AOV_NORMAL]);
    assert_string_equal(a.output, "o");
    assert_int_equal(parse(&a, "s 9 9 o --accel none --crop 1,2,8,9 --preview 16 --progress json -q -v --alpha "
                                "--color never"), ARGS_RUN);
    assert_int_equal(a.accel, POV_ACCEL_NONE);
    assert_int_equal(a.crop.x, 1);
    assert_int_equal(a.crop.y, 2);
    assert_int_equal(a.crop.width, 7);
    assert_int_equal(a.crop.height, 7);
    assert_int_equal(a.preview, 16);
    assert_int_equal(a.progress, ARGS_PROGRESS_JSON);
    assert_true(a.quiet && a.verbose && a.alpha);
    assert_int_equal(a.color, ARGS_COLOR_NEVER);
}

static void args_needs_no_sizes_to_check_or_explain(void **state)
{
    args a;

    (void)state;
    assert_int_equal(parse(&a, "--check s.pov"), ARGS_RUN);
    assert_true(a.check && !a.output);
    assert_int_equal(parse(&a, "s.pov --explain"), ARGS_RUN);
    assert_true(a.explain && !a.output);
    assert_refused("s.pov 10", "HEIGHT is missing");
    assert_refused("s.pov 10 10", "OUTPUT is missing");
    assert_refused("s.pov 10x10 o.png", "WIDTH must be a whole number");
    assert_refused("s.pov 10 o.png", "HEIGHT must be a whole number");
    assert_refused("--check s.pov 10", "HEIGHT is missing");
}

/* The size and the output have defaults, and options of their own. */
static void args_defect_16_draws_a_scene_alone(void **state)
{
    args a;

    (void)state;
    assert_int_equal(parse(&a, "in/s.pov"), ARGS_RUN);
    assert_string_equal(a.output, "s.png");
    assert_true(a.width == 800 && a.height == 600);
    assert_int_equal(parse(&a, ".scene --format ppm -s 64x48"), ARGS_RUN);
    assert_string_equal(a.output, ".scene.ppm");
    assert_true(a.width == 64 && a.height == 48);
    assert_int_equal(parse(&a, "s.pov o.pfm -j 3"), ARGS_RUN);
    assert_string_equal(a.output, "o.pfm");
    assert_int_equal(a.threads, 3);
    assert_int_equal(parse(&a, "s.pov 12 9 -o o.png"), ARGS_RUN);
    assert_true(a.width == 12 && a.height == 9);
    assert_int_equal(parse(&a, "-V"), ARGS_VERSION);
    assert_refused("-", "OUTPUT is missing");
    assert_refused("12 9 s.pov o.png", "\"12\" stands where SCENE belongs");
    assert_refused("s.pov 12 9 o.png -o p.png", "OUTPUT is given twice");
    assert_refused("s.pov 12 9 o.png -s 3x4", "the size is given twice");
    assert_refused("s.pov -s 12x", "-s wants WIDTHxHEIGHT");
    assert_refused("s.pov -s 0x4", "-s wants WIDTHxHEIGHT");
}

static void args_takes_a_dash_for_both_ends_and_names_that_look_like_options_after_two(void **state)
{
    args a;

    (void)state;
    assert_int_equal(parse(&a, "- 4 4 -"), ARGS_RUN);
    assert_string_equal(a.scene, "-");
    assert_string_equal(a.output, "-");
    assert_int_equal(parse(&a, "-q -- -s.pov 4 4 --o.png"), ARGS_RUN);
    assert_string_equal(a.scene, "-s.pov");
    assert_string_equal(a.output, "--o.png");
}

static void args_refuses_sizes_that_are_no_whole_numbers_above_zero(void **state)
{
    static const char *const sizes[] = { "1024x", "0", "1e3", "1.5", "0x10", "+4", "99999999999999999999",
                                         "1000001", "4294967297", "ten", "1,024" };

    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        char line[128];

        strcpy(line, "s.pov ");
        strcat(line, sizes[i]);
        strcat(line, " 10 o.png");
        assert_refused(line, "WIDTH must be a whole number from 1 to 1000000");
        strcpy(line, "s.pov 10 ");
        strcat(line, sizes[i]);
        strcat(line, " o.png");
        assert_refused(line, "HEIGHT must be a whole number from 1 to 1000000");
    }
    assert_refused("s.pov -5 10 o.png", "no option \"-5\"");
    assert_refused("s.pov -- -5 10 o.png", "WIDTH must be a whole number from 1 to 1000000, not \"-5\"");
}

static void args_refuses_option_values_out_of_range(void **state)
{
    (void)state;
    assert_refused("s 9 9 o -t 0", "--threads must be a whole number from 1");
    assert_refused("s 9 9 o -t 2x", "not \"2x\"");
    assert_refused("s 9 9 o --threads=", "--threads must");
    assert_refused("s 9 9 o --spp 0", "--spp must be a whole number from 1 to 65536");
    assert_refused("s 9 9 o --spp -3", "not \"-3\"");
    assert_refused("s 9 9 o --max-depth 1e9", "--max-depth must");
    assert_refused("s 9 9 o --bits 12", "--bits must be 8 or 16");
    assert_refused("s 9 9 o --preview 3", "--preview must be 0, 2, 4, 8 or 16");
    assert_refused("s 9 9 o --transfer gamma", "--transfer must be scene, srgb or linear, not \"gamma\"");
    assert_refused("s 9 9 o --dialect c", "--dialect must be auto, course or povray");
    assert_refused("s 9 9 o --accel grid", "--accel must be tree or none");
    assert_refused("s 9 9 o --accuracy float", "--accuracy must be certified or max");
    assert_refused("s 9 9 o --aov shadow x.png", "--aov must be certainty, normal, depth, time, object, position, albedo or alpha");
    assert_refused("s 9 9 o --aov normal", "--aov normal wants the name of an image file");
}

static void args_refuses_crops_that_are_malformed_empty_or_outside(void **state)
{
    (void)state;
    assert_refused("s 9 9 o --crop 1,2,3", "four whole numbers");
    assert_refused("s 9 9 o --crop 1,2,3,4,5", "four whole numbers");
    assert_refused("s 9 9 o --crop 1,2,,4", "four whole numbers");
    assert_refused("s 9 9 o --crop -1,2,3,4", "four whole numbers");
    assert_refused("s 9 9 o --crop 5,2,5,4", "holds no pixel");
    assert_refused("s 9 9 o --crop 0,0,10,9", "reaches out of the picture of 9 x 9");
}

static void args_refuses_unknown_options_and_guesses_what_was_meant(void **state)
{
    (void)state;
    assert_refused("s 9 9 o --thraeds 4", "did you mean \"--threads\"?");
    assert_refused("s 9 9 o --colour never", "did you mean \"--color\"?");
    assert_refused("s 9 9 o --wombat", "there is no option \"--wombat\"");
    assert_refused("s 9 9 o -x", "there is no option \"-x\"");
    assert_refused("s 9 9 o --stats=3", "takes no value");
    assert_refused("s 9 9 o --threads", "wants a value");
    assert_refused("s 9 9 o p", "\"p\" is one word too many");
    assert_refused("", "SCENE is missing");
}

static void args_defect_17_points_povray_s_users_to_their_words(void **state)
{
    (void)state;
    assert_refused("s -W64 -H48", "POV-Ray's words if one begins with +");
    assert_refused("-H48 s", "POV-Ray's words if one begins with +");
}

static void args_answers_help_and_version_first(void **state)
{
    args a;

    (void)state;
    assert_int_equal(parse(&a, "--help"), ARGS_HELP);
    assert_int_equal(parse(&a, "s.pov -h"), ARGS_HELP);
    assert_int_equal(parse(&a, "--version"), ARGS_VERSION);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(args_reads_scene_sizes_and_output),
        cmocka_unit_test(args_reads_options_wherever_they_stand),
        cmocka_unit_test(args_reads_every_option),
        cmocka_unit_test(args_defect_16_draws_a_scene_alone),
        cmocka_unit_test(args_needs_no_sizes_to_check_or_explain),
        cmocka_unit_test(args_takes_a_dash_for_both_ends_and_names_that_look_like_options_after_two),
        cmocka_unit_test(args_refuses_sizes_that_are_no_whole_numbers_above_zero),
        cmocka_unit_test(args_refuses_option_values_out_of_range),
        cmocka_unit_test(args_refuses_crops_that_are_malformed_empty_or_outside),
        cmocka_unit_test(args_refuses_unknown_options_and_guesses_what_was_meant),
        cmocka_unit_test(args_defect_17_points_povray_s_users_to_their_words),
        cmocka_unit_test(args_answers_help_and_version_first),
    };

    return cmocka_run_group_tests_name("povc's command line", tests, NULL, NULL);
}
