/* quick_color: what pigments are in drafts. Colours beside POV-Ray's at +Q5. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BEGIN "#version 3.7; global_settings { assumed_gamma 1 } camera { orthographic location -10*z direction z right x up y } " \
    "#default { finish { ambient 1 diffuse 0 } } " \
    "#declare P = pigment { checker rgb x rgb y scale 9 translate 4 quick_color rgb <0,0,.6> } " \
    "#declare Q = pigment { rgb .3 quick_color rgb <.1,.2,.3> } "

static void assert_colour(const char *scene, bool quick, double r, double g, double b)
{
    const pov_load_desc load = { .size = sizeof load, .quick_colours = quick };
    const pov_render_desc render = { .size = sizeof render, .width = 1, .height = 1, .samples = 1, .threads = 1 };
    pov_context *c = scenes_context();
    pov_scene *s;
    pov_error err;
    char text[1024];
    float *p;

    snprintf(text, sizeof text, BEGIN "%s", scene);
    if (pov_scene_load_text(&s, c, text, strlen(text), "quick", &load, &err) < 0)
        fail_msg("%s: %s", scene, err.message);
    p = scenes_render(s, &render);
    if (fabs((double)p[0] - r) > 1e-5 || fabs((double)p[1] - g) > 1e-5 || fabs((double)p[2] - b) > 1e-5)
        fail_msg("%s: %f %f %f", scene, (double)p[0], (double)p[1], (double)p[2]);
    free(p);
    pov_scene_destroy(s);
    pov_context_destroy(c);
}

static void a_pigment_is_its_quick_colour_when_asked(void **state)
{
    (void)state;
    assert_colour("plane { z,0 pigment { P } }", false, 0, 1, 0);
    assert_colour("plane { z,0 pigment { P } }", true, 0, 0, .6);
    assert_colour("plane { z,0 pigment { Q } }", true, .1, .2, .3);
    assert_colour("plane { z,0 pigment { bozo color_map { [0 rgb x] [1 rgb x] } } }", true, 1, 0, 0);
}

static void changes_of_a_pigment_leave_its_quick_colour(void **state)
{
    (void)state;
    assert_colour("plane { z,0 pigment { P scale 3 } translate x }", true, 0, 0, .6);
    assert_colour("plane { z,0 pigment { Q rgb .7 } }", true, .1, .2, .3);
    assert_colour("#declare T = texture { pigment { P } } plane { z,0 texture { T pigment { rgb y } } }", true, 0, 0, .6);
    assert_colour("#default { pigment { rgb x quick_color rgb .4 } } plane { z,0 pigment { checker rgb y rgb y } }", true, .4, .4, .4);
}

static void members_of_maps_and_layers_have_their_own(void **state)
{
    (void)state;
    assert_colour("plane { z,0 pigment { gradient x pigment_map { [0 P] [1 P] } } }", true, 0, 0, .6);
    assert_colour("plane { z,0 pigment { average pigment_map { [1 P] [1 rgb x] } } }", true, .5, 0, .3);
    assert_colour("plane { z,0 texture { checker texture { pigment { P } } texture { pigment { P } } } }", true, 0, 0, .6);
    assert_colour("plane { z,0 texture { pigment { rgb y } } texture { pigment { rgbt <1,0,0,.5> quick_color rgbt <0,0,1,.5> } } }", true, 0, .5, .5);
    assert_colour("sky_sphere { pigment { rgb x quick_color rgb .4 } }", true, .4, .4, .4);
}

static void functions_ask_the_pigment_itself(void **state)
{
    (void)state;
    assert_colour("#declare F = function { pigment { P } } #declare V = F(0, 0, 0); plane { z,0 pigment { rgb V } }", true, 0, 1, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pigment_is_its_quick_colour_when_asked),
        cmocka_unit_test(changes_of_a_pigment_leave_its_quick_colour),
        cmocka_unit_test(members_of_maps_and_layers_have_their_own),
        cmocka_unit_test(functions_ask_the_pigment_itself),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
