/* test_povray.c - POV-Ray's command line and INI files: what they come to. */
#include "povray.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
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

static void ini_files_are_found_and_read_as_povray_does(void **state)
{
    (void)state;
    write_file("a.ini", "# a comment\nWidth=30 # wide\n[small]\nWidth=8\n");
    write_file("b.ini", "Include_Ini=a.ini[small]\n+I\"my scene.pov\" +H5\n");
    assert_true(parse("b.ini"));
    assert_true(p.width == 8 && p.height == 5);
    assert_string_equal(p.input, "my scene.pov");
    assert_true(parse("a s.pov"));
    assert_int_equal(p.width, 30);
    assert_int_equal(mkdir("lib", 0777), 0);
    write_file("lib/c.ini", "Width=7\n");
    write_file("lib/only.pov", "");
    assert_false(parse("c.ini +Llib s.pov"));
    assert_true(parse("+Llib c.ini +Ionly"));
    assert_int_equal(p.width, 7);
    assert_string_equal(p.found, "lib/only.pov");
    write_file("a.ini", "Include_Ini=a.ini\n");
    assert_false(parse("a.ini"));
    assert_non_null(strstr(p.problem, "include each other"));
    unlink("a.ini");
    unlink("b.ini");
    unlink("lib/c.ini");
    unlink("lib/only.pov");
    rmdir("lib");
}

/* POVINI, or else povray.ini in the working folder, or else the user's. */
static void default_files_are_povrays(void **state)
{
    (void)state;
    assert_true(mkdir(".povray", 0777) == 0 && mkdir(".povray/3.7", 0777) == 0);
    setenv("HOME", ".", 1);
    write_file(".povray/3.7/povray.ini", "Width=1\n");
    assert_true(parse("s.pov") && p.width == 1);
    write_file("povray.ini", "Height=2\n");
    assert_true(parse("s.pov") && p.width == 800 && p.height == 2);
    write_file("my.ini", "Width=3\n");
    setenv("POVINI", "my.ini", 1);
    assert_true(parse("s.pov") && p.width == 3 && p.height == 600 && p.doubts.count == 0);
    setenv("POVINI", "none.ini", 1);
    assert_true(parse("s.pov") && p.width == 800 && p.height == 2 && p.doubts.count == 1);
    unsetenv("POVINI");
    setenv("HOME", "/nowhere", 1);
    unlink("my.ini");
    unlink("povray.ini");
    unlink(".povray/3.7/povray.ini");
    rmdir(".povray/3.7");
    rmdir(".povray");
}

static void what_is_wrong_is_said_with_its_place(void **state)
{
    (void)state;
    assert_false(parse("+W10"));
    assert_string_equal(p.problem, "no scene is named: +ISCENE.pov, or SCENE.pov");
    assert_false(parse("scene.pov +Wx"));
    assert_string_equal(p.problem, "Width must be a whole number, not \"x\"");
    assert_true(parse("scene.pov +W9x +A0.1y Antialias=maybe"));
    assert_true(p.width == 9 && p.threshold == 0.1 && !p.antialias && p.doubts.count == 3);
    assert_string_equal(p.doubts.item[0], "Width=9x is read as 9");
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
    assert_true(parse("scene.pov +R4 +RFI +RFO +RFx.rad -RFI"));
    assert_int_equal(p.ignored.count, 3);
    assert_string_equal(p.ignored.item[2], "Radiosity_File_Name");
    assert_int_equal(p.depth, 4);
    assert_true(parse("scene.pov +RVP -RTR +TH +THFS"));
    assert_int_equal(p.ignored.count, 0);
}

static void expect_name(const char *line, int frame, const char *expected)
{
    char base[256], name[256];
    frames f;

    assert_true(parse(line));
    f = povray_frames(&p);
    assert_true(povray_output(&p, base, sizeof base));
    assert_true(frames_name(&f, frame, base, name, sizeof name));
    assert_string_equal(name, expected);
}

static void frames_have_clocks_and_names(void **state)
{
    frames f;

    (void)state;
    assert_true(parse("dir/scene.pov +KFI1 +KFF11 +KI2 +KF4"));
    f = povray_frames(&p);
    assert_true(f.asked && f.from == 1 && f.to == 11 && frames_count(&f) == 11);
    assert_true(frames_animation(&f, 1).clock == 2.0 && frames_animation(&f, 6).clock == 3.0 && frames_animation(&f, 11).clock == 4.0);
    assert_true(parse("scene.pov +KFF4 +KC +SF2 +EF3 +Oout/"));
    f = povray_frames(&p);
    assert_true(f.from == 2 && f.to == 3);
    assert_true(frames_animation(&f, 4).clock == 0.75 && frames_animation(&f, 4).final_frame == 5);
    assert_true(parse("scene.pov +K0.25 +O-"));
    assert_true(!povray_frames(&p).asked && p.clock == 0.25);
    expect_name("dir/scene.pov +KFF11", 3, "dir/scene03.png");
    expect_name("scene.pov +KFF4 +Oout/", 2, "out/scene2.png");
    expect_name("scene.pov +KFF4 +Oout.jpg", 2, "out.jpg2.png");
    expect_name("scene.pov +KFF4 +FJ +Oa.b/out.jpg", 2, "a.b/out2.jpg");
    expect_name("scene.pov +KFF4 +O-", 2, "-");
    expect_name("scene.pov +KFI11 +KFF30 +EF105", 31, "scene031.png");
}

/* Which frames POV-Ray 3.7 drew. A part counts from the animation's beginning. */
static void frames_are_chosen_as_povray_does(void **state)
{
    static const struct { const char *line; int from, to, step; } rows[] = {
        { "+KFF10 +SF0.5 +EF0.7", 5, 7, 1 }, { "+KFF10 +SF0.55 +EF0.75", 5, 7, 1 }, { "+KFF10 +SF0.95", 9, 10, 1 },
        { "+KFF10 +EF0.1", 1, 1, 1 }, { "+KFF10 +SF1.0 +EF3", 1, 3, 1 }, { "+KFF10 +SF0 +EF2", 1, 2, 1 },
        { "+KFI11 +KFF30 +SF3 +EF13", 11, 13, 1 }, { "+KFI11 +KFF30 +SF28 +EF40", 28, 40, 1 }, { "+KFI-1 +KFF2", 0, 2, 1 },
        { "+KFI2 +KFF2", 2, 2, 1 }, { "+KFF1", 1, 1, 1 }, { "+KFI5", 5, 5, 1 }, { "+KFI3 +KFF1", 3, 3, 1 },
        { "+KFF10 Frame_Step=3", 1, 10, 3 }, { "+KFF10 Frame_Step=-3", 1, 10, 1 }, { "+KFF10 +EF1e300", 1, 1000000000, 1 },
    };

    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char line[128];
        frames f;

        snprintf(line, sizeof line, "s.pov %s", rows[i].line);
        assert_true(parse(line));
        f = povray_frames(&p);
        assert_true(f.asked);
        assert_int_equal(f.from, rows[i].from);
        assert_int_equal(f.to, rows[i].to);
        assert_int_equal(f.step, rows[i].step);
    }
}

static void frames_from_0_to_0_and_from_1_to_1_are_one_picture(void **state)
{
    (void)state;
    assert_true(parse("s.pov +KFI1 +KFF1 +K2") && !povray_frames(&p).asked);
    assert_true(parse("s.pov +KFI0 +KFF0") && !povray_frames(&p).asked);
    assert_true(parse("s.pov +KFF0") && !povray_frames(&p).asked);
    assert_true(parse("s.pov +KFI0 +KFF1") && povray_frames(&p).asked);
}

static void the_output_has_the_types_ending(void **state)
{
    char name[256];

    (void)state;
    assert_true(parse("scene.pov +FN16 +Oa"));
    assert_true(povray_output(&p, name, sizeof name) && p.bits == 16);
    assert_string_equal(name, "a.png");
    assert_true(parse("scene.pov +FP +Oa.ppm"));
    assert_true(povray_output(&p, name, sizeof name));
    assert_string_equal(name, "a.ppm");
    assert_true(parse("scene.pov +FP +Oa.b"));
    assert_true(povray_output(&p, name, sizeof name));
    assert_string_equal(name, "a.b.ppm");
    assert_true(parse("scene.pov +FNg Output_File_Type=PPM"));
    assert_true(p.type == 'P' && p.doubts.count == 2);
    assert_false(parse("scene.pov +FX"));
    assert_false(parse("scene.pov +FS"));
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
    assert_true(parse("s.pov +W20 +H10 +SC1 +EC1e300"));
    assert_false(povray_crop(&p, &r));
}

static char folder[] = "/tmp/povtrace-povray-XXXXXX";

static int in_an_empty_folder(void **state)
{
    (void)state;
    unsetenv("POVINI");
    setenv("HOME", "/nowhere", 1);
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static int out_of_it(void **state)
{
    (void)state;
    return chdir("/") == 0 ? rmdir(folder) : -1;
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
        cmocka_unit_test(frames_are_chosen_as_povray_does),
        cmocka_unit_test(frames_from_0_to_0_and_from_1_to_1_are_one_picture),
        cmocka_unit_test(ini_files_are_found_and_read_as_povray_does),
        cmocka_unit_test(default_files_are_povrays),
        cmocka_unit_test(the_output_has_the_types_ending),
        cmocka_unit_test(a_part_is_pixels_from_1_or_parts_of_all),
    };

    return cmocka_run_group_tests_name("povray", tests, in_an_empty_folder, out_of_it);
}
