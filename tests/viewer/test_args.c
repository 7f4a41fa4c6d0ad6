/* povview's command line, and what --keys says. */
#include "app.h"
#include "args.h"
#include "script.h"
#include "support/check.h"

#include <string.h>

static args_verdict parse(args *a, const char *first, const char *second, const char *third, const char *fourth)
{
    const char *words[] = { "povview", first, second, third, fourth, NULL };
    char copies[5][128], *argv[6];
    int argc = 0;

    for (; words[argc]; argc++) {
        strcpy(copies[argc], words[argc]);
        argv[argc] = copies[argc];
    }
    argv[argc] = NULL;
    return args_parse(a, argc, argv);
}

static void args_are_read(void **state)
{
    args a;

    (void)state;
    assert_int_equal(parse(&a, "s.pov", NULL, NULL, NULL), ARGS_RUN);
    assert_int_equal(a.width, 0);
    assert_true(a.samples > 1 && a.error > 0.0);
    assert_true(a.remember);
    assert_int_equal(parse(&a, NULL, NULL, NULL, NULL), ARGS_RUN);
    assert_null(a.scene);
    assert_int_equal(parse(&a, "s.pov", "--spp=7", NULL, NULL), ARGS_RUN);
    assert_true(a.samples == 7 && a.error == 0.0);
    assert_int_equal(parse(&a, "s.pov", "--error=0.01", NULL, NULL), ARGS_RUN);
    assert_true(a.samples > 1000 && a.error == 0.01);
    assert_int_equal(parse(&a, "s.pov", "640", "480", NULL), ARGS_RUN);
    assert_int_equal(a.width, 640);
    assert_int_equal(a.height, 480);
    assert_int_equal(parse(&a, "--shot=x.png", "s.pov", "--frames=3", "--keys=h<drag 10,-5>"), ARGS_RUN);
    assert_int_equal(a.frames, 3);
    assert_false(a.remember);
    assert_true(a.samples == 1 && a.error == 0.0);
    assert_int_equal(parse(&a, "s.pov", "--reference=r.png", NULL, NULL), ARGS_RUN);
    assert_string_equal(a.reference, "r.png");
    assert_int_equal(parse(&a, "--help", NULL, NULL, NULL), ARGS_HELP);
    assert_int_equal(parse(&a, "--version", NULL, NULL, NULL), ARGS_VERSION);
}

static void assert_refused(const char *first, const char *second, const char *third, const char *fourth,
                           const char *problem)
{
    args a;

    assert_int_equal(parse(&a, first, second, third, fourth), ARGS_WRONG);
    assert_string_equal(a.problem, problem);
}

static void args_that_are_wrong_are_named(void **state)
{
    (void)state;
    assert_refused("--bench", NULL, NULL, NULL, "SCENE is missing: povview wants SCENE [WIDTH HEIGHT]");
    assert_refused("--shot=x.png", NULL, NULL, NULL, "SCENE is missing: povview wants SCENE [WIDTH HEIGHT]");
    assert_refused("s.pov", "640", NULL, NULL, "HEIGHT is missing: povview wants SCENE [WIDTH HEIGHT]");
    assert_refused("s.pov", "640", "48x", NULL, "HEIGHT must be a whole number from 1 to 16384, not \"48x\"");
    assert_refused("s.pov", "640x480", NULL, NULL, "WIDTH must be a whole number from 1 to 16384, not \"640x480\"");
    assert_refused("s.ini", NULL, NULL, NULL, "\"s.ini\" is for POV-Ray: povc reads that, and povview wants SCENE [WIDTH HEIGHT]");
    assert_refused("+Is.pov", "+W64", NULL, NULL, "\"+Is.pov\" is for POV-Ray: povc reads that, and povview wants SCENE [WIDTH HEIGHT]");
    assert_refused("s.pov", "0", "480", NULL, "WIDTH must be a whole number from 1 to 16384, not \"0\"");
    assert_refused("s.pov", "--frames=3", NULL, NULL, "--frames goes with --shot");
    assert_refused("s.pov", "--error=nan", NULL, NULL, "--error must be a number above 0 and below 1, not \"nan\"");
    assert_refused("s.pov", "--bench", "--shot=x.png", NULL, "--shot and --bench do not go together");
    assert_refused("s.pov", "--shot=x.png", "--keys=<fly>", NULL, "--keys cannot read <fly>");
    assert_refused("s.pov", "--nonsense", NULL, NULL, "there is no option \"--nonsense\"");
    assert_refused("s.pov", "--threads", NULL, NULL, "\"--threads\" wants a value");
}

static void script_reads_characters_keys_and_motions(void **state)
{
    const char *at = "h ] <tab><drag 40,-20.5> <fly WD 0.5><load my scene.pov>";
    script_step s;
    char problem[100];

    (void)state;
    assert_true(script_next(&at, &s, problem, sizeof problem));
    assert_true(s.kind == SCRIPT_CHARACTER && s.code == 'h');
    assert_true(script_next(&at, &s, problem, sizeof problem));
    assert_true(s.kind == SCRIPT_CHARACTER && s.code == ']');
    assert_true(script_next(&at, &s, problem, sizeof problem));
    assert_true(s.kind == SCRIPT_KEY && s.code == APP_KEY_TAB);
    assert_true(script_next(&at, &s, problem, sizeof problem));
    assert_true(s.kind == SCRIPT_DRAG && s.x == 40.0 && s.y == -20.5);
    assert_true(script_next(&at, &s, problem, sizeof problem));
    assert_true(s.kind == SCRIPT_FLY && s.x == 0.5);
    assert_string_equal(s.word, "WD");
    assert_true(script_next(&at, &s, problem, sizeof problem));
    assert_true(s.kind == SCRIPT_LOAD);
    assert_string_equal(s.word, "my scene.pov");
    assert_true(script_next(&at, &s, problem, sizeof problem));
    assert_int_equal(s.kind, SCRIPT_END);
}

static void script_refuses_what_it_cannot_read(void **state)
{
    static const char *const wrong[] = { "<", "<drag>", "<drag 1>", "<drag 1;2>", "<drag 1,2 3>", "<move nan,1>",
                                         "<wheel 1e9>", "<fly X 1>", "<fly W -1>", "<size 0,5>", "<load>", "<what 1>" };
    char problem[100];

    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++)
        if (script_check(wrong[i], problem, sizeof problem))
            fail_msg("%s was read", wrong[i]);
    assert_true(script_check("", problem, sizeof problem));
    assert_true(script_check(" <lt> <esc> ", problem, sizeof problem));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(args_are_read),
        cmocka_unit_test(args_that_are_wrong_are_named),
        cmocka_unit_test(script_reads_characters_keys_and_motions),
        cmocka_unit_test(script_refuses_what_it_cannot_read),
    };

    return cmocka_run_group_tests_name("povview's command line", tests, NULL, NULL);
}
