/* Members of solids that are clear are left out of what rays cross: pictures are as if they were crossed. An interior that does nothing
 * keeps them. */
#include "support/check.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>

enum { WIDE = 60, HIGH = 45 };

#define SCENE "#version 3.7; global_settings { assumed_gamma 1 } camera { location %s look_at <.1,0,.05> angle 40 } " \
              "light_source { <3,5,-4>, 1 } light_source { <-3,1,-4>, .4 } background { rgb <.1,.2,.3> } " \
              "plane { y, -1.3 pigment { checker rgb 1, rgb .4 } } " \
              "#declare Clear = material { texture { pigment { rgbf <1,1,1,.25> transmit .75 } finish { ambient 1 } } %s } " \
              "#default { pigment { rgb <.8,.5,.3> } finish { reflection .2 phong .5 } } "

static float *draw(const char *object, const char *interior, const char *camera)
{
    char text[2048];

    snprintf(text, sizeof text, SCENE "%s", camera, interior, object);
    return scenes_draw(text, WIDE, HIGH, 1, 1);
}

static void assert_left_out(const char *object)
{
    static const char *const cameras[] = { "<.3,1.2,-5>", "<.1,.12,.05>", "<-4,.2,3>" };

    for (size_t i = 0; i < sizeof cameras / sizeof *cameras; i++) {
        float *out = draw(object, "", cameras[i]), *kept = draw(object, "interior { ior 1 }", cameras[i]);

        for (int k = 0; k < 4 * WIDE * HIGH; k++)
            if (out[k] != kept[k])
                fail_msg("%s from %s: %g at %d, not %g", object, cameras[i], (double)out[k], k, (double)kept[k]);
        free(out);
        free(kept);
    }
}

static void what_is_clear_cuts_unseen(void **state)
{
    static const char *const objects[] = {
        ("intersection { poly { 4, <1,0,0,0,2,0,0,2,0,-1.3, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,.3,0,0,0,0, 1,0,-1.3,0,.2> } "
         "sphere { 0, 1 material { Clear } } }"),
        "difference { box { -.8, .8 } sphere { <.8,.8,-.8>, 1 material { Clear } } cylinder { -y, y, .3 material { Clear } } }",
        "difference { sphere { 0, 1 material { Clear } } torus { .6, .35 rotate 60*x } }",
        "merge { sphere { 0, .7 material { Clear } } box { -.4, <1,.5,.6> } }",
        "intersection { union { sphere { -.5*x, .8 } box { <-.2,-.3,-1>, <.9,.4,.5> } } cylinder { -z, z, .9 material { Clear } } }",
        "intersection { quadric { <1,0,-1>, 0, 0, -.1 } plane { y, .4 material { Clear } } plane { -y, .9 } sphere { 0, 2 material { Clear } } }",
        "intersection { object { sphere { 0, 1 material { Clear } } scale <1,.8,.5> } disc { 0, y, 2 } }",
    };

    (void)state;
    for (size_t i = 0; i < sizeof objects / sizeof *objects; i++)
        assert_left_out(objects[i]);
}

/* Faces in one place: the earliest in the text of those that are entered or left like the solid, seen or not. */
static void faces_in_one_place_are_as_they_were(void **state)
{
    (void)state;
    assert_left_out("difference { box { -.8, .8 } box { <-.8,-.3,-.8>, <.5,.8,.8> material { Clear } } }");
    assert_left_out("intersection { box { -.8, .8 } box { <-.8,-.3,-.8>, <.5,.8,.8> material { Clear } } }");
    assert_left_out("intersection { box { <-.8,-.3,-.8>, <.5,.8,.8> material { Clear } } box { -.8, .8 } }");
    assert_left_out("intersection { poly { 4, <1,0,0,0,2,0,0,2,0,-1, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0,-1,0,0,0,0, 1,0,-1,0,0> } "
                    "sphere { 0, 1 material { Clear } } }");
}

/* How many rays went through something. */
static uint64_t count_transmitted(const char *interior)
{
    const pov_render_desc desc = { .size = sizeof desc, .width = WIDE, .height = HIGH, .samples = 1, .threads = 1 };
    pov_context *context = scenes_context();
    pov_progress at = { .size = sizeof at };
    pov_scene *scene;
    pov_job *job;
    pov_error err;
    char text[2048];

    snprintf(text, sizeof text, SCENE "difference { box { -.8, .8 } sphere { <.8,.8,-.8>, 1 material { Clear } } }", "<.3,1.2,-5>", interior);
    scene = scenes_text(context, text);
    assert_int_equal(POV_OK, pov_job_create(&job, scene, &desc, &err));
    assert_int_equal(POV_OK, pov_job_start(job, &err));
    while (pov_job_wait(job, 10.0) == POV_JOB_RUNNING)
        continue;
    pov_job_get_progress(job, &at);
    pov_job_destroy(job);
    pov_scene_destroy(scene);
    pov_context_destroy(context);
    return at.counts.transmitted;
}

static void no_ray_stops_at_what_is_clear(void **state)
{
    (void)state;
    assert_true(count_transmitted("interior { ior 1 }") > 0);
    assert_true(count_transmitted("") == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_clear_cuts_unseen),
        cmocka_unit_test(faces_in_one_place_are_as_they_were),
        cmocka_unit_test(no_ray_stops_at_what_is_clear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
