/* sdl: names, expressions, directives, macros, as they come out of a scene. */
#include "support/check.h"
#include "support/reading.h"

#include <stdio.h>
#include <string.h>

/* The radii of all spheres that a text leaves behind. */
static void assert_radii(const char *text, int count, const double *radii)
{
    reading r;
    int i;

    reading_begin(&r, text);
    if (r.status != POV_OK)
        fail_msg("%s\n%d:%d %s", text, r.error.line, r.error.column, r.error.message);
    if (r.model.leaves.count != (size_t)count)
        fail_msg("%s\n%zu objects, not %d", text, r.model.leaves.count, count);
    for (i = 0; i < count; i++)
        if (reading_shape(&r, (size_t)i)->numbers[0] != radii[i])
            fail_msg("%s\nobject %d: %.17g, not %.17g", text, i, reading_shape(&r, (size_t)i)->numbers[0], radii[i]);
    reading_end(&r);
}

static void assert_radius(const char *text, double radius)
{
    assert_radii(text, 1, &radius);
}

typedef struct expression_case { const char *text; double value; } expression_case;

static const expression_case expressions[] = {
    { "1+2*3", 7 }, { "(1+2)*3", 9 }, { "2*-3+10", 4 }, { "--1", 1 }, { "-!0", -1 }, { "!-1", 0 }, { "!!5", 1 },
    { "6/2/3", 1 }, { "7-2-1", 4 }, { "(2 = 1 < 3)", 1 }, { "(1 | 1 & 0)", 0 }, { "(0 ? 1 : 0 ? 2 : 3)", 3 },
    { "(1e-10 ? 1 : 2)", 2 }, { "(1.1e-10 ? 1 : 2)", 1 }, { "(1e-10 = 0)", 1 }, { "(1 <= 1)", 1 }, { "(1 != 1)", 0 },
    { "(\"b\" > \"a\")", 1 }, { "(\"ab\" = \"ab\")", 1 }, { "x.x", 1 }, { "<1,2,3>.y", 2 }, { "(2*y+z).y", 2 },
    { "vlength(<1,2,2>.x)", 3 }, { "vdot(1, <5,7,2>.z*3 - <4,0,0>.x)", 11 }, { "vdot(1, -<1,2,2>.x)", 3 },
    { "vdot(1, 2*<1,2,2>.x)", 6 }, { "vdot(1, (<1,2,2>.x))", 3 }, { "vdot(1, (<1,2,2>).x*10)", 14 }, { "vdot(1, sin(<0,2,2>.x))", 0 },
    { "vdot(1, <1,2,2>.x + <1,1,1>)", 6 }, { "val(vstr(3, <1,2,3>.y + <1,2>, \"\", 0, 0))", 340 },
    { "vlength(<3,4>)", 5 }, { "vdot(<1,2,3>, 2)", 12 }, { "vcross(x, y).z", 1 }, { "vrotate(x, 90*z).y", 1 },
    { "vaxis_rotate(x, 2*z, 90).y", 1 }, { "max(1, 3, 2)", 3 }, { "min(2)", 2 }, { "select(-1, 5, 6)", 5 },
    { "select(0, 5, 6)", 6 }, { "select(0, 5, 6, 7)", 6 }, { "select(1e-11, 5, 6, 7)", 7 }, { "int(-1.9)", -1 },
    { "div(7.9, 2.9)", 2 }, { "mod(-5.5, 2)", -1.5 }, { "bitwise_xor(1, 3, 7)", 5 }, { "bitwise_or(-1, 255)", -1 },
    { "strlen(\"a\\u00e9b\")", 3 }, { "asc(\"\\u20ac\")", 8364 }, { "strcmp(\"a\", \"z\")", -25 },
    { "strcmp(\"a\", \"ab\")", -98 }, { "val(\"3abc\")", 3 }, { "val(\" -1.5.5\")", -1.5 }, { "val(\"0x10\")", 16 },
    { "val(\"1e+\")", 1 }, { "val(\"-\")", 0 }, { "defined(5)", 0 }, { "strlen(concat(\"a\", str(-5, -4, 0)))", 5 },
    { "strlen(str(1/3, 0, 252))", 254 }, { "strlen(str(1/3, 0, 253))", 56 }, { "strlen(str(1e250, 0, 3))", 254 },
    { "strlen(str(1e250, 0, 4))", 6 }, { "strlen(str(1, -254, 0))", 254 }, { "strlen(str(1, 255, 0))", 9 }, { "strlen(str(1/3, 0, 1e9))", 56 },
    { "strlen(vstr(2, <1e250, 0>, \"\", 0, 2))", 257 }, { "strlen(vstr(2, <1, 0>, \"\", 1000, 2))", 2000 },
    { "val(substr(\"12345\", 2, 3))", 234 }, { "asc(strupr(\"z\"))", 90 }, { "strlen(vstr(3, 1, \", \", 0, 1))", 13 },
    { "int(floor(-1.5))", -2 }, { "defined(Nobody)", 0 }, { "atan2(0, 1)", 0 }, { "pow(2, 10)", 1024 },
    { "version", 3.7 }, { "(true & yes & on)", 1 }, { "(1).gray", 0.297 }, { "<1,2>.gray", 0.297 * 1 + 0.589 * 2 }, { "defined(\"a\")", 0 },
    { "(mod(1, 0) ? 1 : 2)", 2 }, { "!mod(1, 0)", 1 }, { "(mod(1, 0) & 1)", 0 }, { "(mod(1, 0) | 0)", 0 },   /* as POV-Ray has it */
    { "(mod(1, 0) = 5)", 1 }, { "(mod(1, 0) != 5)", 0 }, { "(mod(1, 0) < 5)", 0 }, { "(mod(1, 0) <= 5)", 1 }, { "(1e400 = 1e400)", 1 },
    { "(1e400 = -1e400)", 0 }, { "defined(+)", 0 }, { "strlen(chr(0))", 0 }, { "strlen(\"a\\u0000b\")", 1 }, { "file_exists(\"\")", 0 },
    { "strcmp(datetime(-.00001), \"1999-12-31 23:59:59Z\")", 0 }, { "strcmp(datetime(8765.4321, \"%H:%M:%S\"), \"10:22:13\")", 0 },
    { "strcmp(datetime(0.999999, \"%j %d\"), \"002 02\")", 0 },
};

static void expressions_have_their_values(void **state)
{
    char text[200];
    size_t i;

    (void)state;
    for (i = 0; i < sizeof expressions / sizeof expressions[0]; i++) {
        snprintf(text, sizeof text, "sphere { 0, %s }", expressions[i].text);
        assert_radius(text, expressions[i].value);
    }
}

static void names_stand_where_values_are_read(void **state)
{
    (void)state;
    assert_radius("#declare R = 2; #declare C = <R, R, R>; sphere { C - R, R * 2 }", 4);
    assert_radius("#declare P = rgb <1, .5, 0>; sphere { 0, 1 pigment { P * .5 transmit .5 } }", 1);
    assert_radius("#declare S = sphere { 0, 3 } object { S }", 3);
    assert_radius("#declare T = texture { pigment { rgb 1 } } sphere { 0, 3 texture { T } }", 3);
}

static void the_operators_of_a_pigment_reach_the_model(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "#declare C = rgbt <1, .5, .25, .5>; sphere { 0, 1 pigment { C * .5 } }");
    assert_int_equal(r.status, POV_OK);
    assert_true(r.model.materials.items[0].pigment.r == 0.5f);
    assert_true(r.model.materials.items[0].transmit == 0.25f);
    reading_end(&r);
}

static void loops_turn_as_often_as_they_should(void **state)
{
    static const double three[] = { 1, 2, 3 }, four[] = { 0, 0.25, 0.5, 0.75 }, down[] = { 5, 3, 1 };

    (void)state;
    assert_radii("#for (I, 1, 3) sphere { 0, I } #end", 3, three);
    assert_radii("#declare I = 0; #while (I < 1) sphere { 0, I } #declare I = I + .25; #end", 4, four);
    assert_radii("#for (I, 5, 1, -2) sphere { 0, I } #end", 3, down);
    assert_radii("#for (I, 1, 9) #if (I > 3) #break #end sphere { 0, I } #end", 3, three);
    assert_radii("#for (I, 1, 2-1e-9) #for (J, 1, 3) sphere { 0, J } #end #end", 3, three);
    assert_radius("#for (I, 1, 3) #end sphere { 0, I }", 4);
}

static void branches_are_chosen(void **state)
{
    static const double two[] = { 2, 3 };

    (void)state;
    assert_radius("#if (0) nonsense ( } #if (x #end #else sphere { 0, 1 } #end", 1);
    assert_radius("#if (0) #elseif (1) sphere { 0, 2 } #else sphere { 0, 3 } #end", 2);
    assert_radius("#ifdef (A) sphere { 0, 1 } #else sphere { 0, 2 } #end", 2);
    assert_radius("#ifndef (A) sphere { 0, 1 } #end", 1);
    assert_radii("#switch (2) #case (1) sphere { 0, 1 } #case (2) sphere { 0, 2 } #range (5, 6) sphere { 0, 3 } #break"
                 " #else sphere { 0, 4 } #end", 2, two);
    assert_radius("sphere { 0, #if (1) 5 #else 6 #end }", 5);
    assert_radius("#declare A = #if (1) 5 #else 6 #end; sphere { 0, A }", 5);
}

static void macros_give_and_take(void **state)
{
    (void)state;
    assert_radius("#macro Add(A, B) A + B #end sphere { 0, 2*Add(1, 2) }", 4);
    assert_radius("#macro Set(A) #declare A = 7; #end #declare R = 1; Set(R) sphere { 0, R }", 7);
    assert_radius("#macro Set(A) #declare A = 7; #end #declare R = 1; Set((R)) sphere { 0, R }", 1);
    assert_radius("#macro Open() sphere { 0, #end Open() 3 }", 3);
    assert_radius("#macro Fib(N) #if (N < 2) N #else (Fib(N-1) + Fib(N-2)) #end #end sphere { 0, Fib(10) }", 55);
    assert_radius("#macro M() 1 #break 2 #end sphere { 0, M() }", 1);
    assert_radius("#macro Set(A) #local A = 4; #end #declare B = array[2] { 1, 2 }; Set(B[1]) sphere { 0, B[1] }", 4);
    assert_radius("#declare A = array[1] { 5 }; #macro M() A[0] #end #declare Q = M(); sphere { 0, Q }", 5);
}

static void bodies_of_macros_wait_as_text(void **state)
{
    reading r;

    (void)state;
    assert_radius("#macro M() #macro N() 5 #end N() #end #macro P() M() #end sphere { 0, P() }", 5);
    assert_radius("#macro M() #macro M() 2 #end 3 #end sphere { 0, M() + M() }", 5);
    assert_radius("#macro M() \"#end\" /* #end */ // #end\n #if (0) #end 1 #end #declare N = 3; sphere { 0, N }", 3);
    assert_radius("#macro M(A) A + 1 #end #declare F = M(1); #for (I,1,3) #declare F = F + M(I); #end sphere { 0, F }", 11);
    assert_radius("#macro Never() @ \xC3\xA9 1.2.3 #nothing { #end sphere { 0, 4 }", 4);
    reading_begin(&r, "#macro In()\n\n oops #end\n\nsphere { 0, 1 }\nsphere { 0, In() }");
    assert_int_equal(r.error.line, 3);
    assert_int_equal(r.error.column, 2);
    reading_end(&r);
    reading_begin(&r, "#declare R = 1;\n #macro In() #if (1) #end \"#end\"");
    assert_string_equal(r.error.message, "there is no \"#end\" for this");
    assert_int_equal(r.error.line, 2);
    reading_end(&r);
}

static void scopes_end_with_their_macro(void **state)
{
    static const double radii[] = { 5, 6, 1 };

    (void)state;
    assert_radii("#declare A = 1; #macro M() #local A = 5; sphere { 0, A } #declare A = 6; sphere { 0, A } #end"
                 " M() sphere { 0, A }", 3, radii);
    assert_radius("#macro In() #declare L = L + 1; #end #macro Out() #local L = 1; In() sphere { 0, L } #end Out()", 2);
    assert_radius("#declare A = 3; #undef A #declare A = 4; sphere { 0, A }", 4);
}

static void arrays_are_copied_and_shared(void **state)
{
    (void)state;
    assert_radius("#declare A = array[2] { 1, 2 }; #declare B = A; #declare B[0] = 9; sphere { 0, A[0] }", 1);
    assert_radius("#declare A = array[2][2] { { 1, 2 }, { 3, 4 }, }; sphere { 0, A[1][0] }", 3);
    assert_radius("#declare A = array[1] { sphere { 0, 8 } }; object { A[0] }", 8);
    assert_radius("#declare A = array[4] { 0, 1, 2, 3 }; sphere { 0, A[1 - 1e-10] }", 1);
}

static void a_loop_that_does_not_end_is_stopped(void **state)
{
    static const char text[] = "\n#while (1) #end";
    reader_options options = { .limits = { .turns = 1000 } };
    reading r;

    (void)state;
    reading_begin_bytes(&r, text, sizeof text - 1, &options, NULL);
    assert_int_equal(r.status, POV_E_SYNTAX);
    assert_string_equal(r.error.message, "more than 1000 turns of loops and calls of macros");
    assert_int_equal(r.error.line, 2);
    reading_end(&r);
}

static void macros_that_do_not_end_are_stopped(void **state)
{
    static const char text[] = "#macro M(N) #if (N > 0) M(N - 1) M(N - 1) #end #end M(900)";
    reader_options options = { .limits = { .turns = 5000 } };
    reading r;

    (void)state;
    reading_begin_bytes(&r, text, sizeof text - 1, &options, NULL);
    assert_int_equal(r.status, POV_E_SYNTAX);
    assert_string_equal(r.error.message, "more than 5000 turns of loops and calls of macros");
    reading_end(&r);
}

static void values_without_end_are_stopped(void **state)
{
    static const char text[] = "#declare S = \"0123456789\";\n#while (1)\n#declare S = concat(S, S);\n#end";
    reader_options options = { .limits = { .memory = 100000 } };
    reading r;

    (void)state;
    reading_begin_bytes(&r, text, sizeof text - 1, &options, NULL);
    assert_int_equal(r.status, POV_E_MEMORY);
    assert_string_equal(r.error.message, "the values of this scene need more than 100000 bytes");
    assert_int_equal(r.error.line, 3);
    reading_end(&r);
}

static void a_thousand_macros_run_within_each_other(void **state)
{
    (void)state;
    assert_radius("#macro Deep(N) #if (N = 0) 0 #else (1 + Deep(N - 1)) #end #end sphere { 0, Deep(1000) }", 1000);
}

static void errors_in_macros_tell_who_called(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "#macro In()\n oops #end\n#macro Out() In() #end\nsphere { 0, 1 Out() }");
    assert_int_equal(r.status, POV_E_SYNTAX);
    assert_int_equal(r.error.line, 2);
    assert_int_equal(r.note_count, 2);
    assert_string_equal(r.notes[0].message, "in the macro \"In\", called here");
    assert_int_equal(r.notes[0].line, 3);
    assert_string_equal(r.notes[1].message, "in the macro \"Out\", called here");
    assert_int_equal(r.notes[1].line, 4);
    reading_end(&r);
}

static void unions_hand_down_what_their_members_lack(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "union { sphere { 0, 1 } sphere { 0, 2 pigment { rgb 1 } translate x }"
                      " pigment { rgb .5 } translate 2*y no_shadow }");
    assert_int_equal(r.status, POV_OK);
    assert_int_equal(r.model.leaves.count, 2);
    assert_true(r.model.materials.items[r.model.leaves.items[0].material].pigment.r == 0.5f);
    assert_true(r.model.materials.items[r.model.leaves.items[1].material].pigment.r == 1.0f);
    assert_true(r.model.leaves.items[1].map->v[1] == 2.0 && r.model.leaves.items[1].map->before->v[0] == 1.0);
    assert_int_equal(r.model.leaves.items[1].flags, LEAF_NO_SHADOW);
    reading_end(&r);
}

static void what_a_scene_writes_it_can_read_again(void **state)
{
    (void)state;
    assert_radius("#fopen F \"t.txt\" write #write (F, 2*2, \",\", <1,2,3>, \",\\\"s\\\"\") #fclose F"
                  " #fopen G \"t.txt\" read #read (G, A, B, C) sphere { 0, A + B.z + strlen(C) }", 8);
}

/* What stands between the brackets of #write and #read may close the file, and open another of its name. */
static void numbers_are_written_as_bytes(void **state)
{
    static const struct { const char *word, *numbers, *bytes; } cases[] = {
        { "uint8", "64.5", "A" },             { "uint8", "<65, 66>", "AB" },
        { "uint8", "65 66", "AB" },           { "uint8", "65, 7", "A7" },
        { "sint8", "300", "\\u007f" },        { "uint16be", "16706", "AB" },
        { "uint16le", "16706", "BA" },        { "sint16be", "16706", "AB" },
        { "sint16le", "16706", "BA" },        { "sint32be", "1094861636", "ABCD" },
        { "sint32le", "1094861636", "DCBA" }, { "sint32be", "1094861636, \"!\"", "ABCD!" },
    };
    char text[400];
    size_t i;

    (void)state;
    for (i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        snprintf(text, sizeof text,
                 "#fopen F \"a.txt\" write #write (F, \"\\\"\", %s %s, \"\\\"\") #fclose F "
                 "#fopen F \"a.txt\" read #read (F, S) sphere { 0, 1 + strcmp(S, \"%s\") }",
                 cases[i].word, cases[i].numbers, cases[i].bytes);
        assert_radius(text, 1);
    }
}

static void a_file_may_be_closed_while_it_is_used(void **state)
{
    (void)state;
    assert_radius("#fopen F \"t.txt\" write #write (F, \"1,\" #fclose F, 2) sphere { 0, 3 }", 3);
    assert_radius("#fopen F \"t.txt\" write #write (F, \"7\") #fclose F #declare A = 0;"
                  " #fopen F \"t.txt\" read #read (F, #fclose F A) sphere { 0, A }", 7);
}

static void a_file_that_is_included_again_is_read_again(void **state)
{
    static const double radii[] = { 1, 2, 3, 7, 4 };

    (void)state;
    assert_radii("#declare N = 0; #fopen F \"t.inc\" write #write (F, \"#declare N = N + 1; sphere { 0, N }\") #fclose F"
                 " #include \"t.inc\" #include \"t.inc\" #for (I, 1, 1) #include \"t.inc\" #end"
                 " #fopen F \"t.inc\" write #write (F, \"sphere { 0, 7 }\") #fclose F #include \"t.inc\""
                 " #fopen F \"t.inc\" write #write (F, \"#declare N = N + 1; sphere { 0, N }\") #fclose F"
                 " #include \"t.inc\"", 5, radii);
    assert_radius("#declare N = 0; #fopen F \"t.inc\" write #write (F, \"#macro M(A) A + 1 #end #declare N = M(N);\") #fclose F"
                  " #for (I, 1, 9) #include \"t.inc\" #end sphere { 0, N }", 9);
}

static void what_povray_takes_is_taken(void **state)
{
    (void)state;
    assert_radius("#declare A = array[2] { sphere { 0, 1 }, sphere { 0, 2 } } box { A[1] translate x }", 2);
    assert_radius("max_trace_level 5 sphere { 0, 2 }", 2);
    assert_radius("max_intersections 64 sphere { 0, 2 }", 2);
    assert_radius("#max_intersections 64 global_settings { max_intersections 64 } sphere { 0, 2 }", 2);
    assert_radius("fog { color rgb 1 200 } sphere { 0, 2 }", 2);
    assert_radius("#for (I 2 2) sphere { 0, I } #end", 2);
    assert_radius("sphere { 0, 2 matrix <1,0,0, 1,0,0, 0,0,1, 0,0,0> }", 2);
    assert_radius("#declare F = function { u * 10 + v } sphere { 0, F(1, 2, 3) }", 12);
    assert_radius("#declare F = function (x, v) { x + y } sphere { 0, F(3, 4) }", 7);
    assert_radius("#declare S = spline { 0, 1 2, 3 4, 8 2, 5 } sphere { 0, S(2).x }", 5);
    assert_radius("#declare S = spline { 0, 1 0, 2 1, 3 } sphere { 0, S(0).x }", 2);
    assert_radius("#declare A = array[1] { spline { 0, 1 1, 3 } } #declare S = spline { A[0] 3, 9 } sphere { 0, S(2).x }", 6);
    assert_radius("#declare S = spline { 0, 1 1, 3 } #declare T = spline { S -1, 9 } sphere { 0, T(-.5).x }", 5);
    assert_radius("#declare A = intersection { box { 0, 1 } box { <-1, .2, 0>, <.5, 2, 3> } } sphere { 0, 3 + trace(A, <.3, .5, -3>, z).z }", 3);
    assert_radius("#declare L = light_source { 0, 1 } light_source { L rgb <1, 0, 0> color rgb 1 translate x } sphere { 0, 2 }", 2);
    assert_radius("sphere { 0, 2 interior { ior 1.5 refraction 1 } interior { refraction } }", 2);
    assert_radius("#macro M() #local P = 1; P + 1; #end #macro N() #local P = M(); sphere { 0, P } #end N()", 2);
    assert_radius("#macro M() #local P = 1; P + 1; #end #declare P = 7; #declare P = M(); sphere { 0, P }", 2);
    assert_radius("#macro M() #local A[0] = 9; sphere { 0, A[0] } #end #declare A = array[1] { 1 } M()", 1);
    assert_radius("#declare P = pigment { rgb 1 } #declare N = normal { bumps } #declare F = finish { phong 1 }"
                  " sphere { 0, 2 texture { P N F } }", 2);
    assert_radius("#declare C = rgb 1; sphere { 0, 2 C }", 2);
    assert_radius("#fopen W \"w\" write #write (W) #fclose W sphere { 0, 2 texture { object { box { 0, 1 } } } }", 2);
    assert_radius("sphere { 0, 2 texture { checker } finish { diffuse .5 .2 } }", 2);
    assert_radius("#declare C = rgb 1; #declare F = function { pigment { gradient x color_map { [0 2*C] [1, 1 - C] } } } sphere { 0, F(0, 0, 0).red }",
                  2);
    assert_radius("#macro M(A) sphere { 0, val(vstr(5, A, \"\", 0, 0)) } #end #declare V = <1, 2, 3>; M(V.y)", 20000);
    assert_radius("#fopen W \"w\" write #write (W, \"2 0 3\") #fclose W #fopen R \"w\" read #read (R A B) sphere { 0, A + B }", 5);
    assert_radius("#for (I, 2, 2,) sphere { 0, I } #end", 2);
    assert_radius("#declare F = function (a, a) { a } sphere { 0, F(1, 2) }", 1);
}

static void what_povray_refuses_is_refused(void **state)
{
    static const char *const texts[] = {
        "sphere { 0, 1 pigment { average } }", "sphere { 0, 1 normal { average .5 } }", "#declare P = pigment { average scale 2 }",
        "sky_sphere { }", "#declare S = sky_sphere { emission 2 }", "media { method 4 }", "media { method 0 }",
        "media { scattering { 2, 1 eccentricity .5 } }",
        "#declare B = box { -1, 1 } #declare N = <1, 2>; #declare P = trace(B, 3*y, -y, N);",
        "#declare B = box { -1, 1 } #declare A = array[1] { 1 } #declare P = trace(B, 3*y, -y, A[0]);",
        "#declare S = (1 ? \"a\" : \"b\");", "#declare F = function (a) { a; }",
        "#declare F = function (a) { min(a) }", "#declare F = 5; #declare F = function { x }",
        "#macro M() #local A[0] = 9; #debug str(A[0], 0, 0) #end #declare A = array[1]; M()",
        "#fopen W \"w\" write #write (W, \"1\") #fclose W #fopen R \"w\" read #declare A = array[1]; #read (R, A[0])",
        "#fopen W \"w\" write #write (W, \"--1\") #fclose W #fopen R \"w\" read #read (R, A)",
        "#declare C = rgb 1; #declare D = C red 1;", "#declare F = function (a) { --a }",
        "#declare F = function (a, b) { a } #declare G = function (a, b) { F(a b) }", "#declare A = min(3 1);",
        "#declare S = sphere { 0, 1 clipped_by { } }", "#declare T = light_source { 0, 1 } #declare A = inside(T, 0);",
        "#declare F = finish { phong 1 } sphere { 0, 1 finish { ambient 1 F } }", "#declare I = interior { ior 2 } sphere { 0, 1 interior { I I } }",
        "rainbow { angle 40 width 5 color_map { [0 rgb 1] } }", "rainbow { direction 0 angle 40 width 5 color_map { [0 rgb 1] } }",
        "#declare C = camera { location x } camera { location y C }",
        "#declare polynomial = 1;", "#declare importance = 1;", "#declare datetime = 1;", "#declare A = datetime(0, \"\");",
    };
    reading r;
    size_t i;

    (void)state;
    for (i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        reading_begin(&r, texts[i]);
        if (r.status == POV_OK)
            fail_msg("%s", texts[i]);
        reading_end(&r);
    }
}

static void splines_and_functions_are_called(void **state)
{
    (void)state;
    assert_radius("#declare S = spline { linear_spline 0, <1, 2>, 2, <3, 6> } sphere { 0, S(1).y }", 4);
    assert_radius("#declare S = spline { cubic_spline 0, 1, 1, 3, 2, 3, 3, 9 } sphere { 0, S(1.5, linear_spline).x }", 3);
    assert_radius("#declare F = function (a, b) { a*b + (a < b & b > 0) } sphere { 0, F(2, 3) }", 7);
    assert_radius("#declare F = function { spline { 0, <1,2,3>, 2, <3,6,1> } } #declare G = function (a) { F(a).y*10 }"
                  "sphere { 0, G(1) + F(1).z }", 42);
    assert_radius("#declare F = function (a) { a } #declare G = function (a) { 4 } sphere { 0, F(3) + G(1) }", 7);
    assert_radius("#declare F = function { spline { natural_spline 0, 0, 1, 8, 2, 0 } }"
                  "#declare G = function (a) { F(a).x } sphere { 0, G(.5) }", 5.5);
    assert_radius("#declare F = function { x + 10*y + 100*z } #declare G = function (t0) { F(t0, 2, sum(i, 1, 3, i)) }"
                  " sphere { 0, G(1) }", 621);
    assert_radius("#declare T = transform { scale 2 translate x } #declare F = function { transform { T } }"
                  " sphere { 0, F(1, 0, 0).x }", 3);
    assert_radius("#declare T = transform { scale 2 translate 6*x inverse } #declare F = function { transform { T } }"
                  " sphere { 0, F(8, 0, 0).x }", 1);
    assert_radius("#declare P = function { pigment { rgb <.25, .5, .75> } } #declare F = function { P(x, y, z).hf } sphere { 0, F(0, 0, 0) }",
                  0.996093 * (0.25 + 0.5 / 255.0));
    assert_radius("#declare P = pigment { rgb <.5, .25, 0> } #declare F = function { pigment { P } }"
                  " sphere { 0, F(1, 2, 3).green }", .25);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(expressions_have_their_values),
        cmocka_unit_test(names_stand_where_values_are_read),
        cmocka_unit_test(the_operators_of_a_pigment_reach_the_model),
        cmocka_unit_test(loops_turn_as_often_as_they_should),
        cmocka_unit_test(branches_are_chosen),
        cmocka_unit_test(macros_give_and_take),
        cmocka_unit_test(bodies_of_macros_wait_as_text),
        cmocka_unit_test(scopes_end_with_their_macro),
        cmocka_unit_test(arrays_are_copied_and_shared),
        cmocka_unit_test(a_loop_that_does_not_end_is_stopped),
        cmocka_unit_test(macros_that_do_not_end_are_stopped),
        cmocka_unit_test(values_without_end_are_stopped),
        cmocka_unit_test(a_thousand_macros_run_within_each_other),
        cmocka_unit_test(errors_in_macros_tell_who_called),
        cmocka_unit_test(unions_hand_down_what_their_members_lack),
        cmocka_unit_test(what_a_scene_writes_it_can_read_again),
        cmocka_unit_test(numbers_are_written_as_bytes),
        cmocka_unit_test(a_file_may_be_closed_while_it_is_used),
        cmocka_unit_test(a_file_that_is_included_again_is_read_again),
        cmocka_unit_test(what_povray_takes_is_taken),
        cmocka_unit_test(what_povray_refuses_is_refused),
        cmocka_unit_test(splines_and_functions_are_called),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
