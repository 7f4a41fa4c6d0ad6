/* A surface that one convex solid clips, or cuts as it shows itself, is drawn as if several did, of which all but one hold nothing of it:
 * rays find its first crossing in another way. */
#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDE = 48, HIGH = 36 };

#define SCENE "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 6 } camera { location %s look_at <.1,0,.05> angle 40 } " \
              "light_source { <3,5,-4>, 1 } light_source { <-3,1,-4>, .4 } background { rgb <.1,.2,.3> } " \
              "plane { y, -1.3 pigment { checker rgb 1, rgb .4 } } "
#define LOOK "pigment { rgb <.8,.5,.3> } finish { reflection .2 } "
#define GLASS "pigment { rgbt <.9,.9,1,.8> } finish { reflection .1 } interior { ior 1.4 } "
#define CUBIC "cubic { <1.2,0,0,.4, 0,0,1,0,0,-.3, .9,.3,0,0,0,0, -.7,0,0,.1> "
#define TENT "mesh { triangle { <-2,-.4,-1>, <0,.5,-2>, <.1,.3,2> } triangle { <.1,.3,2>, <2,-.6,1>, <0,.5,-2> } " \
             "smooth_triangle { <-1,-1,.2>, <0,.1,-1>, <1,-1,.3>, <0,0,-1>, <1,.8,0>, <.3,.2,-1> } "
#define QUARTIC "poly { 4, <1,0,0,0,2,0,0,2,0,-1.3, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,.3,0,0,0,0, 1,0,-1.3,0,.2> "

static float *draw(const char *object, const char *clip, const char *rest, const char *camera, bool shows)
{
    char text[2048];

    snprintf(text, sizeof text, shows ? SCENE "intersection { object { %s } } object { %s } %s }" : SCENE "object { %s } clipped_by { %s } %s }",
             camera, object, clip, rest);
    return scenes_draw(text, WIDE, HIGH, 1, 1);
}

static void assert_each_alike(const char *object, const char *clip, const char *rest, const char *camera, bool shows)
{
    char several[512];
    float *one, *many;

    snprintf(several, sizeof several, "union { object { %s } sphere { <77,78,79>, .01 } }", clip);
    one = draw(object, clip, rest, camera, shows);
    many = draw(object, several, rest, camera, shows);
    for (int i = 0; i < 3 * WIDE * HIGH; i++)
        if (!(fabsf(one[i] - many[i]) < 1e-6f))
            fail_msg("%s %s by %s, %s: %g at %d, not %g", object, shows ? "cut" : "clipped", clip, rest, (double)one[i], i, (double)many[i]);
    free(one);
    free(many);
}

static void assert_alike(const char *object, const char *clip, const char *rest, const char *camera)
{
    assert_each_alike(object, clip, rest, camera, false);
    assert_each_alike(object, clip, rest, camera, true);
}

static void one_clip_is_like_several(void **state)
{
    static const char *const objects[] = { CUBIC, QUARTIC, "quadric { <1,0,-1>, <0,.3,0>, <0,0,.1>, -.1 ", "plane { <.3,1,-.5>, .1 ",
                                           "sphere { <.3,0,.2>, .8 ", "torus { .6, .25 rotate 60*x ", "plane { z, 0 rotate 30*x inverse ",
                                           TENT, TENT "inside_vector y ",
                                           "torus { .6, .25 rotate 60*x inverse ",
                                           "torus { 40, 30 rotate 80*x translate <-40,.3,0> " };   /* camera, lights and clips are inside */
    static const char *const clips[] = { "sphere { 0, 1 }", "box { <-.7,-.8,-.9>, <.8,.7,.6> rotate <20,30,40> }",
                                         "cylinder { -y, y, .7 rotate 50*z }" };
    static const char *const cameras[] = { "<.3,1.2,-5>", "<.1,.12,.05>", "<-4,.2,3>" };

    (void)state;
    for (size_t i = 0; i < sizeof objects / sizeof *objects; i++)
        for (size_t k = 0; k < 3; k++) {
            assert_alike(objects[i], clips[k], LOOK, cameras[(i + k) % 3]);
            assert_alike(objects[i], clips[k], GLASS "rotate <10,20,30>", cameras[(i + k + 1) % 3]);
        }
}

static void the_size_of_a_scene_changes_nothing(void **state)
{
    (void)state;
    assert_alike(CUBIC, "sphere { 0, 1 }", LOOK "scale 1e-6", "<.3e-6,1.2e-6,-5e-6>");
    assert_alike(CUBIC, "sphere { 0, 1 }", LOOK "translate 1e7*x", "<10000000,1.2,-5>");
}

/* Whether a ray is within an open surface is asked beside its crossings: as near to them as it is thin. */
static void a_thin_open_surface_is_clipped_alike_by_small_and_large_ones(void **state)
{
    static const char *const objects[] = { "cone { 0, .7, .02*z, .9 open ", "cylinder { 0, <.03,.02,.05>, .8 open ",
                                           "cone { -.01*y, .9, .01*y, .7 open rotate 50*x " };
    /* They hold all of the objects, but not of their boxes. */
    static const char *const large[] = { "box { <-.98,-.98,-3>, <.98,.98,2000000> rotate 45*z }",
                                         "box { -2000000000, <.98,.98,3> rotate 45*z }",
                                         "sphere { <-1414213.5624,-1414213.5624,0>, 2000000.98 }" };

    (void)state;
    for (size_t i = 0; i < sizeof objects / sizeof *objects; i++) {
        float *small = draw(objects[i], "box { -3, 3 }", LOOK, "<.3,.2,-5>", false);

        for (size_t k = 0; k < sizeof large / sizeof *large; k++) {
            float *other = draw(objects[i], large[k], LOOK, "<.3,.2,-5>", false);

            for (int j = 0; j < 3 * WIDE * HIGH; j++)
                if (!(fabsf(small[j] - other[j]) < 1e-6f))
                    fail_msg("%s by %s: %g at %d, not %g", objects[i], large[k], (double)other[j], j, (double)small[j]);
            free(other);
        }
        free(small);
    }
}

/* What is inside a solid is the same whether its ends are open or closed, and a clip shows neither: one is asked for what it holds where
 * others are crossed, the other for its own crossings. */
static void a_clip_with_gaps_is_like_a_closed_one(void **state)
{
    static const char *const objects[] = { "sphere { 0, .8 ", "torus { .6, .25 rotate 60*x ", "box { -.6, <.7,.5,.6> rotate 20 ",
                                           "cylinder { <0,-.7,0>, <0,.7,0>, .7 ", "union { sphere { .3*x, .6 } sphere { -.4*x, .5 } ",
                                           "difference { box { -.7, .6 } sphere { <.1,.2,-.7>, .6 } ", "quadric { <1,0,-1>, <0,.3,0>, <0,0,.1>, -.1 " };
    static const char *const clips[] = { "cylinder { -.7*y, .7*y, .7 %s }", "cone { <-.9,-.1,0>, .9, <.8,.1,0>, .2 %s }",
                                         "cylinder { <.1,.2,-3>, <.2,-.1,3>, .4 %s inverse }", "cylinder { -.5*z, .6*z, .66 %s rotate 40*y }" };
    static const char *const cameras[] = { "<.3,1.2,-5>", "<.1,.12,.05>", "<-4,.2,3>" };

    (void)state;
    for (size_t i = 0; i < sizeof objects / sizeof *objects * (sizeof clips / sizeof *clips); i++) {
        const char *object = objects[i % 7], *camera = cameras[i % 3], *look = i % 2 ? LOOK : GLASS;
        char open[128], closed[128];
        float *a, *b;

        snprintf(open, sizeof open, clips[i / 7], "open");
        snprintf(closed, sizeof closed, clips[i / 7], "");
        a = draw(object, open, look, camera, false);
        b = draw(object, closed, look, camera, false);
        for (int k = 0; k < 3 * WIDE * HIGH; k++)
            if (!(fabsf(a[k] - b[k]) < 1e-6f))
                fail_msg("%s by %s from %s: %g at %d, not %g", object, open, camera, (double)a[k], k, (double)b[k]);
        free(a);
        free(b);
    }
}

static size_t infinite_in(const char *object)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, object);
    pov_scene_info info = { .size = sizeof info };

    pov_scene_get_info(scene, &info);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return info.infinite_objects;
}

static void a_height_field_has_its_box_whatever_clips_it(void **state)
{
    static const char field[] = "height_field { function 9, 9 { x*y } translate -.5 clipped_by { %s } }";
    char text[256];

    (void)state;
    snprintf(text, sizeof text, field, "quadric { <1,0,1>, 0, 0, -.1 }");
    assert_int_equal(infinite_in(text), 0);
    assert_int_equal(infinite_in("quadric { <1,0,1>, 0, 0, -.1 clipped_by { height_field { function 9, 9 { x*y } translate -.5 } } }"), 1);
}

/* Do rays ask a tree of shapes, when the scene is drawn? */
static bool asks_tree(const char *object)
{
    pov_context *context = scenes_context();
    pov_scene *scene = scenes_text(context, object);
    pov_render_desc desc = { .size = sizeof desc, .width = 8, .height = 8, .threads = 1 };
    pov_class_counts counts = { .size = sizeof counts };
    bool asks = false;
    pov_job *job;

    assert_int_equal(pov_job_create(&job, scene, &desc, NULL), POV_OK);
    assert_int_equal(pov_job_start(job, NULL), POV_OK);
    pov_job_wait(job, -1.0);
    for (size_t i = 0; pov_job_get_class(job, i, &counts); i++)
        asks |= strcmp(counts.keyword, "csg") == 0;
    pov_job_destroy(job);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return asks;
}

static void assert_clips(const char *object, bool clips)
{
    if (asks_tree(object) != clips)
        fail_msg("%s: the clip is %s", object, clips ? "left out" : "not left out");
}

/* What certainly holds all of an object leaves nothing of it out. */
static void a_clip_around_all_of_it_is_left_out(void **state)
{
    (void)state;
    assert_clips("sphere { 0, 1 clipped_by { box { -2, 2 } } }", false);
    assert_clips("sphere { 0, 1 clipped_by { box { -2, 2 } box { <-1, -2, -2>, 2 } } }", true);   /* they touch */
    assert_clips("sphere { 0, 1 clipped_by { box { -.9, 2 } } }", true);
    assert_clips("sphere { 0, 1 clipped_by { box { -2, 2 inverse } } }", true);
    assert_clips("sphere { 0, 1 inverse clipped_by { box { -2, 2 } } }", true);
    assert_clips("sphere { 0, 1 clipped_by { plane { y, 1.001 } } }", false);
    assert_clips("plane { y, 0 clipped_by { box { -2, 2 } } }", true);
    assert_clips("disc { 0, y, 1 clipped_by { box { -2, 2 } } }", true);   /* below it is its inside, all of it */
    assert_clips("sphere { 0, 1 clipped_by { torus { 3, 2.5 } } }", true);
    assert_clips("sphere { 0, 1 clipped_by { union { box { -2, 2 } } } }", true);
    /* By where both are. */
    assert_clips("sphere { 0, 1 scale 3 clipped_by { box { -2, 2 } } }", true);
    assert_clips("sphere { 0, 1 clipped_by { box { -2, 2 } } scale 3 rotate 20 translate 1e6 }", false);
    assert_clips("sphere { 0, 1 clipped_by { box { -2, 2 rotate 45*z translate 2 } } }", true);
    assert_clips("sphere { 0, 1 translate 2 clipped_by { box { -2, 2 rotate 45*z translate 2 } } }", false);
    assert_clips("torus { 1, .25 translate 2 clipped_by { box { -2, 2 } } }", true);
    assert_clips("torus { 1, .25 translate 2 clipped_by { box { -2, 2 translate 2 } } }", false);
    assert_clips("sphere { 0, 1 translate 1e6 clipped_by { box { -1.000000000001, 2 translate 1e6 } } }", true);   /* 1e6 loses that */
    assert_clips("sphere { 0, 1 translate 1e6 clipped_by { box { -1.00000001, 2 translate 1e6 } } }", true);
    assert_clips("sphere { 0, 1 translate 1e6 clipped_by { box { -1.000001, 2 translate 1e6 } } }", false);
    /* A union if that holds of each. */
    assert_clips("union { sphere { 0, 1 } cone { 0, 1, y, 2 } scale .9 clipped_by { box { -2, 2 } } }", false);
    assert_clips("union { sphere { 0, 1 } cone { 0, 1, 3*y, 2 } clipped_by { box { -2, 2 } } }", true);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(one_clip_is_like_several), cmocka_unit_test(the_size_of_a_scene_changes_nothing),
                                        cmocka_unit_test(a_thin_open_surface_is_clipped_alike_by_small_and_large_ones),
                                        cmocka_unit_test(a_clip_with_gaps_is_like_a_closed_one),
                                        cmocka_unit_test(a_height_field_has_its_box_whatever_clips_it),
                                        cmocka_unit_test(a_clip_around_all_of_it_is_left_out) };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
