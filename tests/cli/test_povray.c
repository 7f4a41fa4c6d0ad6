/* test_povray.c - POV-Ray's command line and INI files: what they come to. */
#include "povray.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

enum { WORDS = 32 };

static povray p;

/* The words of a line, after the program's name. */
static bool parse(const char *line)
{
    static char copy[2048];
    char program[] = "povray", *argv[WORDS] = { program }, *rest = NULL, *word;
    int argc = 1;

    snprintf(copy, sizeof copy, "%s", line);
    for (word = strtok_r(copy, " ", &rest); word && argc < WORDS; word = strtok_r(NULL, " ", &rest))
        argv[argc++] = word;
    return povray_parse(&p, argc, argv);
}

static bool asked(const char *name, const char *first)
{
    char program[32], word[64], *argv[] = { program, word, NULL };

    snprintf(program, sizeof program, "%s", name);
    snprintf(word, sizeof word, "%s", first);
    return povray_is_asked(2, argv);
}

static void write_file(const char *path, const char *text)
{
    FILE *to = fopen(path, "w");

    assert_non_null(to);
    fputs(text, to);
    fclose(to);
}

static void it_is_asked_for_by_plus_ini_or_name(void **state)
{
    (void)state;
    assert_true(asked("povc", "+Iscene.pov"));
    assert_true(asked("povc", "scene.ini"));
    assert_true(asked("povc", "quick.ini[low]"));
    assert_true(asked("/usr/bin/povray", "scene.pov"));
    assert_false(asked("povc", "scene.pov"));
    assert_false(asked("povray-like", "scene.pov"));
}

static void switches_are_settings(void **state)
{
    (void)state;
    assert_true(parse("+Iscene.pov +Oout.png +W320 +H200 +A0.1 +AM2 +R4 -J +Q9 +WT2 +D -P -GA +V"));
    assert_string_equal(p.input, "scene.pov");
    assert_string_equal(p.output, "out.png");
    assert_true(p.width == 320 && p.height == 200 && p.threads == 2 && p.method == 2 && p.depth == 4);
    assert_true(p.antialias && p.threshold == 0.1 && p.verbose);
    assert_int_equal(p.ignored.count, 0);
    assert_true(parse("scene.pov +a -a"));
    assert_false(p.antialias);
    assert_true(parse("-iscene.pov +w1 +h2 -v"));
    assert_true(p.width == 1 && p.height == 2 && !p.verbose);
}

static void settings_stand_on_the_command_line_too(void **state)
{
    (void)state;
    assert_true(parse("scene.pov Width=64 height=48 Declare=N=5 Declare=M=2.5 Library_Path=a +Lb Antialias=on"));
    assert_true(p.width == 64 && p.height == 48 && p.antialias);
    assert_int_equal(p.declares.count, 2);
    assert_string_equal(p.declares.item[0], "N=5");
    assert_string_equal(p.library.item[1], "b");
}

static void an_ini_file_has_comments_quotes_sections_and_switches(void **state)
{
    (void)state;
    write_file("a.ini", "; a comment\n Width = 100 ; wide\nInput_File_Name=\"my scene.pov\"\n+H70 -D\n"
                        "[low]\nWidth=10\n[high]\nWidth=1000\nDeclare=Q=\"a;b\"\n");
    assert_true(parse("a.ini"));
    assert_true(p.width == 100 && p.height == 70);
    assert_string_equal(p.input, "my scene.pov");
    assert_true(parse("a.ini[low]"));
    assert_int_equal(p.width, 10);
    assert_true(parse("a[HIGH] +W5"));
    assert_int_equal(p.width, 5);
    assert_string_equal(p.declares.item[0], "Q=\"a;b\"");
    write_file("b.ini", "Include_Ini=a.ini\nHeight=7\n");
    assert_true(parse("b.ini"));
    assert_true(p.width == 100 && p.height == 7);
    unlink("a.ini");
    unlink("b.ini");
}

static void what_is_wrong_is_said_with_its_place(void **state)
{
    (void)state;
    assert_false(parse("+W10"));
    assert_string_equal(p.problem, "no scene is named: +ISCENE.pov, or SCENE.pov");
    assert_false(parse("scene.pov +Wx"));
    assert_string_equal(p.problem, "Width must be a whole number, not \"x\"");
    assert_false(parse("none.ini"));
    assert_string_equal(p.problem, "cannot read the INI file \"none.ini\"");
    write_file("c.ini", "\nHeight=tall\n");
    assert_false(parse("c.ini"));
    assert_string_equal(p.problem, "c.ini:2: Height must be a whole number, not \"tall\"");
    unlink("c.ini");
}

static void what_povc_does_not_have_is_kept_for_a_warning(void **state)
{
    (void)state;
    assert_true(parse("scene.pov +MV3.5 Create_Ini=x.ini Nonsense=1 +Zfoo Append_File=off"));
    assert_int_equal(p.ignored.count, 4);
    assert_string_equal(p.ignored.item[2], "Nonsense");
    assert_string_equal(p.ignored.item[3], "+Zfoo");
}

static void frames_have_clocks_and_names(void **state)
{
    char name[256];
    int first, last;

    (void)state;
    assert_true(parse("dir/scene.pov +KFI1 +KFF11 +KI2 +KF4"));
    povray_frames(&p, &first, &last);
    assert_true(first == 1 && last == 11);
    assert_true(povray_clock(&p, 1) == 2.0 && povray_clock(&p, 6) == 3.0 && povray_clock(&p, 11) == 4.0);
    assert_true(povray_output(&p, 3, name, sizeof name));
    assert_string_equal(name, "scene03.png");
    assert_true(parse("scene.pov +KFF4 +KC +SF2 +EF3 +Oout/"));
    povray_frames(&p, &first, &last);
    assert_true(first == 2 && last == 3);
    assert_true(povray_clock(&p, 4) == 0.75);
    assert_true(povray_output(&p, 2, name, sizeof name));
    assert_string_equal(name, "out/scene2.png");
    assert_true(parse("scene.pov +K0.25 +O-"));
    povray_frames(&p, &first, &last);
    assert_true(first == 0 && last == 0 && povray_clock(&p, 0) == 0.25);
    assert_true(povray_output(&p, 0, name, sizeof name));
    assert_string_equal(name, "-");
}

static void the_output_has_the_types_ending(void **state)
{
    char name[256];

    (void)state;
    assert_true(parse("scene.pov +FN16 +Oa"));
    assert_true(povray_output(&p, 0, name, sizeof name) && p.bits == 16);
    assert_string_equal(name, "a.png");
    assert_true(parse("scene.pov +FP +Oa.ppm"));
    assert_true(povray_output(&p, 0, name, sizeof name));
    assert_string_equal(name, "a.ppm");
    assert_true(parse("scene.pov +FP +Oa.b"));
    assert_true(povray_output(&p, 0, name, sizeof name));
    assert_string_equal(name, "a.b.ppm");
    assert_false(parse("scene.pov +FX"));
}

/* As POV-Ray 3.7 drew them: +W20 +H10 with each of these. */
static void a_part_is_pixels_from_1_or_parts_of_all(void **state)
{
    pov_rect r;

    (void)state;
    assert_true(parse("s.pov +W20 +H10 +SC0.25 +EC0.75"));
    assert_true(povray_crop(&p, &r) && r.x == 5 && r.width == 10 && r.y == 0 && r.height == 10);
    assert_true(parse("s.pov +W20 +H10 +SC5 +EC10 +SR3 +ER6"));
    assert_true(povray_crop(&p, &r) && r.x == 4 && r.width == 6 && r.y == 2 && r.height == 4);
    assert_true(parse("s.pov +W20 +H10 +SC0.26 +EC0.5"));
    assert_true(povray_crop(&p, &r) && r.x == 5 && r.width == 5);
    assert_true(parse("s.pov +W20 +H10"));
    assert_true(povray_crop(&p, &r) && r.width == 0);
    assert_true(parse("s.pov +W20 +H10 +SC15 +EC10"));
    assert_false(povray_crop(&p, &r));
}

static int in_an_empty_folder(void **state)
{
    static char folder[] = "/tmp/povtrace-povray-XXXXXX";

    (void)state;
    unsetenv("POVINI");
    setenv("HOME", "/nowhere", 1);
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_asked_for_by_plus_ini_or_name),
        cmocka_unit_test(switches_are_settings),
        cmocka_unit_test(settings_stand_on_the_command_line_too),
        cmocka_unit_test(an_ini_file_has_comments_quotes_sections_and_switches),
        cmocka_unit_test(what_is_wrong_is_said_with_its_place),
        cmocka_unit_test(what_povc_does_not_have_is_kept_for_a_warning),
        cmocka_unit_test(frames_have_clocks_and_names),
        cmocka_unit_test(the_output_has_the_types_ending),
        cmocka_unit_test(a_part_is_pixels_from_1_or_parts_of_all),
    };

    return cmocka_run_group_tests_name("povray", tests, in_an_empty_folder, NULL);
}
