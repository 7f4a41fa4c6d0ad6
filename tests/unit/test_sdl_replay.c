/* sdl: what loops and macros read again has the values, and the faults, of the same text written out. */
#include "support/check.h"
#include "support/reading.h"

#include <stdio.h>
#include <string.h>

enum { TURNS = 4, LONGEST = 4000 };

static const char before[] =
    "#version 3.7; #declare F = .7; #declare G = -2; #declare V = <1,2,3>; #declare W = <4,5,6,7>;"
    "#declare C = rgbft <.5,.25,1,.125,.75>; #declare A = array[3] { 1, 2, 4 };"
    "#declare AV = array[2] { <1,2,3>, <3,4,5> }; #declare B = array[2][3] { { 1,2,3 }, { 4,5,6 } };"
    "#declare FN = function (a, b) { a*b - sin(a) }; #declare R = seed(3);"
    "#macro Twice(X) ((X)*2 + F) #end #macro Open(X, Y) X + Y #end #macro Minus(X) -X #end"
    "#macro Locals(X) #local Q = X*2; #local F = Q - 1; Twice(F) #end"
    "#macro Choose(X) #if (X < 3) 1 #else 2 #end #end #macro Change(X) #declare G = G + 1; X #end"
    "#macro Out(X) #declare X = X + 1; #end ";

/* Each leaves a radius in S; I counts from 1. */
static const char *const bodies[] = {
    "#declare S = I + F*2 - 1/I;", "#declare S = -I*-2 + !G;", "#declare S = (I < 3 ? F : V.y);",
    "#declare S = mod(I,3) + max(1,I,2) + select(I-2,5,6,7) + pow(I,.5);", "#declare S = asin(I/4) + ln(I) + sqrt(I);",
    "#declare S = A[mod(I,3)] + B[1][mod(I,3)];", "#declare A[mod(I,3)] = A[mod(I+1,3)] + I; #declare S = A[1];",
    "#declare B[1][2] = I; #declare S = B[1][2];", "#declare V = V*.5 + <I,1,2> + vcross(x,V); #declare S = V.z;",
    "#declare S = vlength(V*I) + vdot(V,y) + vnormalize(V).x;", "#declare S = (C*I).transmit + C.gray + (W + V).t;",
    "#declare S = vlength(V.y*I) + vlength((V.y)*I) + vlength(I*V.y) + vlength(-AV[1].z) + vdot(Minus(V.y), 1) + vlength(Open(V.z, I));",
    "#declare S = AV[mod(I,2)].y + (AV[0] + 1).z;", "#declare S = FN(I, F) + FN(FN(1,I), 2);",
    "#declare S = rand(R) + rand(R)*I;", "#declare S = rand(R) + A[int(rand(R)*2)];",
    "#declare S = Twice(I) + 2*Open(I,3) - Minus(I) + -Minus(F);", "#declare S = Locals(I) + F;",
    "#declare S = Choose(I) + Change(I) + G;", "Out(F) #declare S = F + I;", "#local F = I; #declare S = F;",
    "#declare S = 0; #if (mod(I,2) = 0) #declare S = I; #else #declare S = -I; #end",
    "#declare S = 1; #if (I > 2) #declare S = 5; #end #if (I > 9) #declare S = 6; #else #end",
    "#declare S = 0; #while (S < I & S*2 != 4) #declare S = S + 1; #end",
    "#declare S = 0; #for (J,1,I) #if (J = 3) #break #end #declare S = S + J; #end",
    "#declare P = #if (I < 3) 3; #else <1,2>; #end #declare S = vlength(P*I);",
    "#ifdef (T) #undef T #else #declare T = I; #end #declare S = I;", "#declare S = vstr(5, V.y, \",\", 0, 3);", "#declare S = vstr(5, V.y + <1,2>, \",\", 0, 3);",
    "#macro Again(X) X*I #end #declare S = Again(2); #if (I = 2) #undef Again #macro Again(X) X*I*100 #end #end",
    "#declare S = (I<2 ? 1 : 2)*3; #declare A = array[I+2] { #for (J,0,I+1) J, #end } #declare S = A[I+1] + A[2];",
    "#declare F = F*3 ;; #declare S = F;", "#declare S = <I, 2 3>.y;", "#declare S = -rgb_of;",
    /* faults of the fourth turn, or of all */
    "#declare S = 1/(I-4);", "#declare S = sqrt(3-I);", "#declare S = A[I-1];", "#declare S = rand(R) + ln(4-I);",
    "#declare S = V.x + Nobody;", "#declare S = (I < 4 ? 1 : x);", "#declare S = rand(R)*pow(0, 4-I) + rand(R);",
    "#declare A[I] = 1; #declare S = 1;", "#declare A[0] = V; #declare S = 1;", "#declare S = acos(I) + 1; #declare S = S;",
};

static void read_both(const char *body, reading *loop, reading *written)
{
    const char *radius = strstr(body, "vstr") ? "strlen(S)" : "S";
    char text[LONGEST];
    int i, n;

    snprintf(text, sizeof text, "%s#for (I,1,%d) %s sphere { 0, %s } #end", before, TURNS, body, radius);
    reading_begin(loop, text);
    n = snprintf(text, sizeof text, "%s#declare I = 1; ", before);
    for (i = 0; i < TURNS; i++)
        n += snprintf(text + n, sizeof text - (size_t)n, "%s sphere { 0, %s } #declare I = I + 1; ", body, radius);
    assert_true(n < LONGEST - 1);
    reading_begin(written, text);
}

static void loops_have_the_values_of_what_is_written_out(void **state)
{
    reading loop, written;
    size_t i, k;

    (void)state;
    for (i = 0; i < sizeof bodies / sizeof bodies[0]; i++) {
        read_both(bodies[i], &loop, &written);
        if (loop.status != written.status || strcmp(loop.error.message, written.error.message) != 0)
            fail_msg("%s\n%s\n%s", bodies[i], loop.error.message, written.error.message);
        assert_true(loop.status != POV_OK || loop.model.leaves.count == TURNS);
        assert_int_equal(loop.model.leaves.count, written.model.leaves.count);
        for (k = 0; k < loop.model.leaves.count; k++)
            if (reading_shape(&loop, k)->numbers[0] != reading_shape(&written, k)->numbers[0])
                fail_msg("%s\nturn %zu: %.17g, written out %.17g", bodies[i], k + 1,
                         reading_shape(&loop, k)->numbers[0], reading_shape(&written, k)->numbers[0]);
        reading_end(&loop);
        reading_end(&written);
    }
}

static void warnings_are_given_each_time(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "#declare S = 0; #for (I,1,5) #declare S = 1/(I-I); #end sphere { 0, 1 }");
    assert_int_equal(r.status, POV_OK);
    assert_int_equal(r.model.warnings, 5);
    reading_end(&r);
}

static void faults_in_loops_have_their_places(void **state)
{
    reading r;

    (void)state;
    reading_begin(&r, "#declare A = array[3] { 1,2,3 }\n#for (I,0,9)\n  #declare S = 1 + A[I];\n#end");
    assert_int_equal(r.status, POV_E_SYNTAX);
    assert_int_equal(r.error.line, 3);
    assert_int_equal(r.error.column, 22);
    reading_end(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loops_have_the_values_of_what_is_written_out),
        cmocka_unit_test(warnings_are_given_each_time),
        cmocka_unit_test(faults_in_loops_have_their_places),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
