/* A polynomial whose surface is finite is drawn within a box. Written with an order that has none it must look the same. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDE = 64, HIGH = 48 };

#define SCENE "#version 3.7; global_settings { assumed_gamma 1 } camera { location %s look_at 0 angle 40 } light_source { <3,5,-4>, 1 } " \
              "background { rgb <.1,.2,.3> } plane { y, -2 pigment { checker rgb 1, rgb .4 } } "

/* With terms that are nothing but for the order. */
static float *draw(int order, const char *terms, const char *camera)
{
    char text[2048];

    snprintf(text, sizeof text, SCENE "polynomial { %d, %s pigment { rgb <.8,.5,.3> } rotate <20,30,40> }", camera, order, terms);
    return scenes_draw(text, WIDE, HIGH, 1, 1);
}

static void assert_alike(const char *terms)
{
    static const char *const cameras[] = { "<.3,1.2,-5>", "<-4,.2,3>", "<.1,.05,.02>" };

    for (int k = 0; k < 3; k++) {
        float *one = draw(6, terms, cameras[k]), *other = draw(8, terms, cameras[k]);

        for (int i = 0; i < 3 * WIDE * HIGH; i++)
            if (!(fabsf(one[i] - other[i]) < 1e-5f))
                fail_msg("%s from %s: %g at %d, not %g", terms, cameras[k], (double)one[i], i, (double)other[i]);
        free(one);
        free(other);
    }
}

static void what_is_in_a_box_is_all_of_it(void **state)
{
    (void)state;
    assert_alike("xyz(4,0,0):1, xyz(2,0,0):-1, xyz(0,2,0):1, xyz(0,0,2):1");
    assert_alike("xyz(4,0,0):4, xyz(3,0,0):-4, xyz(0,2,0):1, xyz(0,0,2):1");
    assert_alike("xyz(6,0,0):1, xyz(0,4,0):2, xyz(0,0,2):1, xyz(3,0,1):1.2, xyz(1,2,0):-1, xyz(0,1,1):.5, xyz(0,0,0):-.4");
    assert_alike("xyz(2,0,0):1, xyz(0,6,0):1, xyz(0,0,6):1, xyz(0,3,3):-1.8, xyz(1,1,1):.7, xyz(0,0,0):-.3");
    assert_alike("xyz(2,0,0):1, xyz(0,2,0):3, xyz(0,0,2):1, xyz(1,1,0):1, xyz(0,0,0):-.8");
}

/* The highest terms of one coordinate are not those that count: it reaches as far as a ray goes. */
static void what_is_endless_has_none(void **state)
{
    (void)state;
    assert_alike("xyz(4,0,0):1, xyz(2,0,1):-2.5, xyz(0,0,2):1, xyz(0,2,0):1, xyz(0,0,0):-.2");
    assert_alike("xyz(4,0,0):1, xyz(0,2,0):1, xyz(0,0,2):1, xyz(1,2,0):-.5, xyz(0,0,0):-.5");
    assert_alike("xyz(6,0,0):1, xyz(0,3,0):1, xyz(0,0,2):1, xyz(0,0,0):-.5");
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(what_is_in_a_box_is_all_of_it), cmocka_unit_test(what_is_endless_has_none) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
