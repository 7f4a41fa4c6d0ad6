/* The complement of what is clipped is the complement of the solid, clipped by the same, wherever in a tree it stands. */
#include "support/check.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 48, HEIGHT = 36 };

#define HEAD "#version 3.7; global_settings { assumed_gamma 1 } camera { location <-2,3.5,-5> look_at 0 angle 40 }\n" \
             "light_source { <5,8,-6> rgb 1 } background { rgb <.2,.3,.4> }\n"
#define BLOCK "box { -1, 1 pigment { rgb <.2,.5,.9> } }"
#define CUT "sphere { <1,1,-1>, .8 clipped_by { plane { y, .9 } } pigment { rgb <.3,.9,.2> } }"
#define WHOLE "sphere { <0,0,-1>, .5 pigment { rgb <.9,.2,.2> } }"

static float *draw(const char *body)
{
    char text[2048];

    snprintf(text, sizeof text, "%s%s", HEAD, body);
    return scenes_draw(text, WIDTH, HEIGHT, 0, 0);
}

static void assert_same(const char *a, const char *b)
{
    float *first = draw(a), *second = draw(b);

    if (memcmp(first, second, 4 * WIDTH * HEIGHT * sizeof *first) != 0)
        fail_msg("%s\nlooks different from\n%s", a, b);
    free(first);
    free(second);
}

static void what_is_cut_out_may_be_a_union(void **state)
{
    (void)state;
    assert_same("difference { " BLOCK " union { " CUT WHOLE " } }", "difference { " BLOCK CUT WHOLE " }");
    assert_same("difference { " BLOCK " merge { " WHOLE " union { " CUT " sphere { <-1,1,0>, .6 } } } }",
                "difference { " BLOCK WHOLE CUT " sphere { <-1,1,0>, .6 } }");
}

static void a_union_may_be_inverse(void **state)
{
    (void)state;
    assert_same("intersection { " BLOCK " union { " CUT WHOLE " inverse } }", "difference { " BLOCK CUT WHOLE " }");
}

static void what_is_cut_out_of_a_cutter_stays(void **state)
{
    (void)state;
    assert_same("difference { " BLOCK " difference { " WHOLE CUT " } }",
                "merge { difference { " BLOCK WHOLE " } intersection { " BLOCK CUT " } }");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_cut_out_may_be_a_union),
        cmocka_unit_test(a_union_may_be_inverse),
        cmocka_unit_test(what_is_cut_out_of_a_cutter_stays),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
