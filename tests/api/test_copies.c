/* Copies of a declared solid that is stored once: the picture is that of the same scene with every copy written out. */
#include "support/check.h"
#include "support/scenes.h"

#include <povtrace/build.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 32, HEIGHT = 24, TEXT_MAX = 1 << 13 };

/* M() is the solid's members and modifiers, OF "union" or another word; USE is a use of it that is still open. */
#define USE " #if (Copies) object { T #else OF { M() #end "
#define FIRST_SEED "#declare R = seed(11); "
#define SPREAD " #macro Place() <rand(R)-.5, rand(R)-.5, rand(R)-.5>*2 #end "
#define VIEW "camera { location <0,2,-9> look_at 0 angle 50 } light_source { <5,10,-8> rgb 1 } light_source { <-8,6,-3> rgb .4 } "
#define FLOOR "plane { y, -2.2 pigment { checker rgb 1 rgb .5 } } "
/* Turned, stretched, some mirrored. */
#define MOVED "scale <.3+.6*rand(R), (mod(I,5)=0 ? -1 : 1)*(.3+.6*rand(R)), .3+.6*rand(R)> rotate 360*<rand(R),rand(R),0> " \
              "translate <8*rand(R)-4, 4*rand(R)-2, 7*rand(R)-3>"
#define FOREST(more) "#for (I, 1, 420) " USE MOVED more " } #if (mod(I, 40) = 7) sphere { <8*rand(R)-4, 4*rand(R)-2, 2*rand(R)>, .3 " \
                     "pigment { rgb <.3,.3,1> } finish { reflection .4 } } #end #end "
/* Some 70 leaves. */
#define MEMBERS(texture) \
    "#macro M() #local R = seed(7); #for (K, 1, 14) sphere { Place(), .02+.06*rand(R) " texture " } " \
    "box { -1, 1 scale .06*<rand(R)+.1,rand(R)+.1,.5> rotate 90*Place() translate Place() } " \
    "difference { sphere { 0, .08 } box { 0, .1 } rotate 90*Place() translate Place() } " \
    "torus { .06, .02 rotate 90*Place() translate Place() pigment { checker rgb 1 rgb <1,0,0> scale .05 } } #end "

static char *make_text(const char *of, const char *scene, bool copies)
{
    static const char *const begin =
        "#version 3.7; global_settings { assumed_gamma 1 } #declare Copies = %d; " FIRST_SEED SPREAD;
    char *text = malloc(TEXT_MAX), *at = text;
    const char *s;

    assert_non_null(text);
    at += sprintf(at, begin, copies);
    for (s = scene; *s; s++)
        if (strncmp(s, "OF", 2) == 0) {
            at += sprintf(at, "%s", of);
            s++;
        } else {
            *at++ = *s;
        }
    *at = '\0';
    assert_true(at - text < TEXT_MAX);
    return text;
}

static pov_scene *load(pov_context *context, const char *of, const char *scene, bool copies)
{
    char *text = make_text(of, scene, copies);
    pov_scene *s = scenes_text(context, text);

    free(text);
    return s;
}

static bool has_copies(const pov_scene *s)
{
    pov_plan_row row = POV_INIT(row);

    for (size_t i = 0; pov_scene_get_plan(s, i, &row); i++)
        if (strcmp(row.subject, "copies") == 0)
            return row.used;
    fail_msg("the plan has no row for copies");
    return false;
}

static float *draw(const pov_scene *s)
{
    pov_render_desc d = POV_INIT(d);

    d.width = WIDTH;
    d.height = HEIGHT;
    d.samples = 1;
    d.threads = 1;
    return scenes_render(s, &d);
}

/* Doubles of crossings may differ in their last places, which no pixel shows. */
static void same_pictures(const float *a, const float *b)
{
    float light = 0.0f;

    for (int i = 0; i < WIDTH * HEIGHT * 4; i++) {
        if (!(fabsf(a[i] - b[i]) <= 1e-4f * (1.0f + fabsf(b[i]))))
            fail_msg("pixel %d,%d: %.7g and %.7g", i / 4 % WIDTH, i / 4 / WIDTH, (double)a[i], (double)b[i]);
        light = fmaxf(light, i % 4 < 3 ? b[i] : 0.0f);
    }
    assert_true(light > 0.0f);
}

static void same_numbers(pov_scene *a, pov_scene *b)
{
    const size_t n = pov_scene_object_count(b);
    const char *x, *y;
    int line, column;

    assert_int_equal(pov_scene_object_count(a), n);
    for (size_t i = 0; i < n; i += 1 + i / 50) {
        assert_true(pov_scene_get_object(a, i, &x, &line, &column));
        assert_true(pov_scene_get_object(b, i, &y, &line, &column));
        assert_string_equal(x, y);
    }
    assert_false(pov_scene_get_object(a, n, &x, &line, &column));
}

/* What single rays meet: the same objects at the same places. */
typedef struct met { pov_hit hits[64]; size_t count; } met;

static bool meet(void *user, const pov_hit *h)
{
    met *m = user;

    m->hits[m->count++] = *h;
    return m->count < 64;
}

static void same_rays(pov_scene *a, pov_scene *b)
{
    pov_tracer *x, *y;
    pov_error err;

    assert_int_equal(pov_tracer_create(&x, a, &err), POV_OK);
    assert_int_equal(pov_tracer_create(&y, b, &err), POV_OK);
    for (int i = 0; i < 200; i++) {
        const pov_vec3 org = pov_vec3_of(sin(i) * 9.0, cos(0.7 * i) * 3.0, -8.0);
        const pov_vec3 to = pov_vec3_of(sin(3.1 * i) * 3.0, cos(1.9 * i) * 1.5, sin(0.3 * i) * 2.0);
        static met one, other;

        one.count = other.count = 0;
        pov_trace_hits(x, org, pov_sub(to, org), meet, &one);
        pov_trace_hits(y, org, pov_sub(to, org), meet, &other);
        assert_int_equal(one.count, other.count);
        for (size_t k = 0; k < one.count; k++) {
            assert_int_equal(one.hits[k].object, other.hits[k].object);
            assert_true(fabs(one.hits[k].distance - other.hits[k].distance) <= 1e-12 * other.hits[k].distance);
            assert_true(pov_dot(one.hits[k].normal, other.hits[k].normal) > 1.0 - 1e-12);
        }
        assert_int_equal(pov_trace_blocked(x, org, to), pov_trace_blocked(y, org, to));
    }
    pov_tracer_destroy(x);
    pov_tracer_destroy(y);
}

static void assert_same_of(const char *of, const char *scene)
{
    pov_context *context = scenes_context();
    pov_scene *copies = load(context, of, scene, true), *written = load(context, of, scene, false);
    float *a, *b;

    assert_true(has_copies(copies));
    assert_false(has_copies(written));
    a = draw(copies);
    b = draw(written);
    same_pictures(a, b);
    same_numbers(copies, written);
    same_rays(copies, written);
    free(a);
    free(b);
    pov_scene_destroy(copies);
    pov_scene_destroy(written);
    pov_context_destroy(context);
}

static void assert_same(const char *scene) { assert_same_of("union", scene); }

/* The same scene, bit for bit, without copies. */
static void assert_written_out(const char *scene)
{
    pov_context *context = scenes_context();
    pov_scene *named = load(context, "union", scene, true), *written = load(context, "union", scene, false);
    float *a = draw(named), *b = draw(written);

    assert_false(has_copies(named));
    assert_memory_equal(a, b, sizeof *a * WIDTH * HEIGHT * 4);
    same_numbers(named, written);
    same_rays(named, written);
    free(a);
    free(b);
    pov_scene_destroy(named);
    pov_scene_destroy(written);
    pov_context_destroy(context);
}

#define T "#if (Copies) #declare T = OF { M() } #end "

static void textures_bumps_mirrors_and_shadows_move_with_copies(void **state)
{
    (void)state;
    assert_same(MEMBERS("texture { pigment { wood scale .1 rotate x*30 } normal { bumps 1 scale .1 } finish { reflection .2 } translate <.3,.1,0> }")
                "pigment { gradient y color_map { [0 rgb <.2,.5,.1>][1 rgb <.7,.4,.2>] } scale .3 } #end " T VIEW FLOOR FOREST(""));
}

static void glass_and_coloured_shadows_are_the_same(void **state)
{
    (void)state;
    assert_same(MEMBERS("pigment { rgbf <.9,1,.8,.8> } finish { reflection { .1, .5 fresnel } } interior { ior 1.4 }")
                "pigment { checker rgbf <1,1,.3,.7> rgb .8 scale .2 } #end " T VIEW FLOOR FOREST(""));
}

/* The camera is in a member of a copy, and in what the copies have in common. */
static void the_start_may_be_in_a_copy(void **state)
{
    (void)state;
    assert_same(MEMBERS("") "sphere { 0, 1.5 pigment { rgbf <.9,1,1,.9> } interior { ior 1.2 fade_distance 2 fade_power 1 } hollow } "
                "sphere { 0, 1.2 pigment { rgbf .95 } interior { ior 1.1 } hollow } pigment { rgb <1,.5,.2> } #end " T
                "camera { location <0,0,0> direction z } light_source { <3,9,-4> rgb 1 } fog { distance 20 rgb .5 } "
                "#for (I, 1, 300) " USE "scale 1+I/100 rotate 37*I*y translate <0,0,mod(I,9)*.1> } #end ");
}

/* Exactly upon each other: a copy twice, a label on a box of the same part, and boxes before and behind in the text. */
static void coincident_surfaces_keep_their_order(void **state)
{
    (void)state;
    assert_same(MEMBERS("") "box { -1, <1,1,0> pigment { rgb <1,0,0> } } box { <-.5,-.5,-1>, <.5,.5,0> pigment { rgb <0,1,0> } } "
                "box { <0,-.2,-1>, <1,.2,-.5> pigment { rgbf <1,1,0,.6> } } pigment { rgb 1 } #end " T VIEW FLOOR
                "box { <-3,-1,-1>, <-2.5,1,0> pigment { rgb <0,0,1> } } "
                "#for (I, 1, 300) " USE "translate <4*mod(int(I/2),8)-14,0,5*int(I/16)> } "
                "#if (mod(I,20)=3) box { <4*mod(int(I/2),8)-14.2,-1,-1+5*int(I/16)>, <4*mod(int(I/2),8)-14,1,5*int(I/16)> pigment { rgb <1,0,1> } } #end #end "
                "box { <1.8,-.1,-1>, <3,.1,0> pigment { rgb <0,1,1> } } ");
}

static void copies_of_a_difference_are_the_same(void **state)
{
    (void)state;
    assert_same_of("difference", "#macro M() sphere { 0, 1 pigment { agate scale .3 } } #local R = seed(7); "
                   "#for (K, 1, 70) sphere { vnormalize(Place()), .05 pigment { rgb <rand(R),rand(R),0> } } #end #end " T VIEW FLOOR FOREST(""));
    assert_same_of("merge", "#macro M() #local R = seed(7); #for (K, 1, 70) sphere { Place(), .1 } #end pigment { rgbf .9 } "
                   "interior { ior 1.2 } #end " T VIEW FLOOR FOREST(""));
}

static void a_union_with_an_interior_is_one_solid(void **state)
{
    (void)state;
    assert_same(MEMBERS("") "pigment { rgbf <.9,.95,1,.9> } interior { ior 1.3 fade_distance .5 fade_power 2 fade_color rgb <1,0,0> } #end " T VIEW
                FLOOR FOREST(""));
}

/* Of each use: a texture of its own, moved or not; flags. */
static void uses_may_differ(void **state)
{
    (void)state;
    assert_same(MEMBERS("") "scale 1.1 #end " T VIEW FLOOR
                FOREST("#if (mod(I,2)) pigment { rgb <1,.2,.1> } #else no_shadow #end"));
    assert_same(MEMBERS("") "translate .1*x pigment { marble scale .3 } rotate 30*z #end " T VIEW FLOOR FOREST("no_reflection"));
    assert_same(MEMBERS("") "#end " T "#declare U = " USE "rotate 20*x pigment { marble scale .3 } scale 1.2 } " VIEW FLOOR
                "#for (I, 1, 300) #if (Copies) object { U #else OF { M() rotate 20*x pigment { marble scale .3 } scale 1.2 #end " MOVED " no_image } " USE MOVED " } #end ");
}

/* It is moved otherwise than textures. */
static void a_solid_with_an_interior_texture_is_written_out(void **state)
{
    (void)state;
    assert_written_out(MEMBERS("") "disc { 0, x, 1 } pigment { rgb .8 } scale 1.1 interior_texture { pigment { gradient x scale .2 } } #end " T VIEW
                       FLOOR FOREST(""));
}

/* Each use moves its texture by something else before uv coordinates take the place of points. */
static void a_solid_whose_members_have_uv_coordinates_is_written_out(void **state)
{
    (void)state;
    assert_written_out(MEMBERS("pigment { gradient x scale .2 }") "uv_mapping pigment { rgb .8 } #end " T VIEW FLOOR FOREST(""));
    assert_written_out(MEMBERS("uv_mapping") "pigment { gradient x scale .2 } #end " T VIEW FLOOR FOREST(""));
}

static void scenes_of_any_size_are_the_same(void **state)
{
    static const char *const forest = MEMBERS("pigment { rgbf .5 }") "pigment { gradient y scale .3 } #end " T
        "camera { location <0,2,-9>*S look_at 0 angle 50 } light_source { <5,10,-8>*S rgb 1 } "
        "#for (I, 1, 300) " USE MOVED " scale S } #end ";
    static const char *const sizes[] = { "1e-6", "1e6", "1e-60" };
    char text[TEXT_MAX];

    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        snprintf(text, sizeof text, "#declare S = %s; %s", sizes[i], forest);
        assert_same(text);
    }
}

/* Unions within unions; the solid is used in front of, between and behind other objects, lights and light groups. */
static void copies_stand_anywhere(void **state)
{
    (void)state;
    assert_same(MEMBERS("") "pigment { rgb .8 } #end " T VIEW "difference { box { -1, 1 } sphere { 0, 1.2 } pigment { rgb <1,1,0> } translate <-2,1,0> } "
                "union { #for (I, 1, 210) " USE MOVED " } #end sphere { 0, .3 } rotate 20*y scale .9 translate .1*x } "
                "light_group { light_source { <0,5,-5> rgb <1,0,0> } sphere { <1,1,-2>, .5 pigment { rgb 1 } } " USE "scale .2 } } " FLOOR
                "union { union { #for (I, 1, 210) " USE MOVED " } #end } cone { 0, .3, y, 0 } translate .2*y } "
                "difference { " USE "scale 2 } box { -1, <0,1,1> } } " USE "clipped_by { sphere { 0, 1 } } } sphere { <2,2,-2>, .4 pigment { rgb <0,1,0> } } ");
}

static void area_lights_and_uv_textures_are_the_same(void **state)
{
    (void)state;
    assert_same(MEMBERS("uv_mapping pigment { checker rgb 1 rgb <0,.5,0> scale .2 }") "mesh { smooth_triangle { <0,0,-1>, y-z, <1,0,-1>, x, <0,1,-1>, -z "
                "} triangle { <0,0,-1>, <-1,0,-1>, <0,-1,-1> uv_vectors <0,0>, <1,0>, <0,1> } uv_mapping pigment { checker scale .1 } } "
                "pigment { rgb .8 } #end " T "camera { location <0,2,-9> look_at 0 angle 50 } "
                "light_source { <5,10,-8> rgb 1 area_light 4*x, 4*y, 4, 4 adaptive 1 } " FLOOR FOREST(""));
}

/* What does not pay is written out, where it stood. */
static void a_few_uses_are_written_out_in_their_places(void **state)
{
    (void)state;
    assert_written_out(MEMBERS("pigment { rgbf .5 }") "pigment { gradient y scale .3 } #end " T VIEW
        "sphere { 0, .5 pigment { rgb <1,0,0> } } " USE "translate x } difference { sphere { 0, 1 } box { 0, 2 } translate -x pigment { agate } } "
        USE "rotate 40*y } union { " USE "translate -x } cone { 0, 1, y, 0 } pigment { rgb .5 } } " FLOOR);
}

static float *draw_with(pov_context *context, const char *text, pov_accel accel, pov_accuracy accuracy)
{
    pov_load_desc d = POV_INIT(d);
    pov_scene *s;
    pov_error err;
    float *p;

    d.accel = accel;
    d.accuracy = accuracy;
    if (pov_scene_load_text(&s, context, text, strlen(text), NULL, &d, &err) < 0)
        fail_msg("%s", err.message);
    assert_true(has_copies(s));
    p = draw(s);
    pov_scene_destroy(s);
    return p;
}

static void tree_and_list_give_the_same_picture(void **state)
{
    static const char *const scene = MEMBERS("pigment { rgb x }") "pigment { gradient y scale .3 } finish { ambient 1 } #end " T
        "camera { location <0,2,-9> look_at 0 angle 50 } #for (I, 1, 150) " USE MOVED " } #end ";
    pov_context *context = scenes_context();
    char *text = make_text("union", scene, true);
    float *tree = draw_with(context, text, POV_ACCEL_TREE, POV_ACCURACY_CERTIFIED);
    float *list = draw_with(context, text, POV_ACCEL_NONE, POV_ACCURACY_CERTIFIED);
    float *exact = draw_with(context, text, POV_ACCEL_TREE, POV_ACCURACY_MAX);

    (void)state;
    assert_memory_equal(tree, list, sizeof *tree * WIDTH * HEIGHT * 4);
    same_pictures(tree, exact);
    free(tree);
    free(list);
    free(exact);
    free(text);
    pov_context_destroy(context);
}

/* A name that stands for more than there are names. */
static void too_many_copies_are_refused(void **state)
{
    pov_context *context = scenes_context();
    static const char text[] = "#version 3.7; camera { location -5*z } #declare A = union { #for (I, 1, 50000) sphere { I, .1 } #end } "
                               "#for (I, 1, 100000) object { A translate I*y } #end";
    pov_scene *s = NULL;
    pov_error err;

    (void)state;
    assert_int_equal(pov_scene_load_text(&s, context, text, sizeof text - 1, NULL, NULL, &err), POV_E_UNSUPPORTED);
    assert_null(s);
    pov_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(textures_bumps_mirrors_and_shadows_move_with_copies),
        cmocka_unit_test(glass_and_coloured_shadows_are_the_same),
        cmocka_unit_test(the_start_may_be_in_a_copy),
        cmocka_unit_test(coincident_surfaces_keep_their_order),
        cmocka_unit_test(copies_of_a_difference_are_the_same),
        cmocka_unit_test(a_union_with_an_interior_is_one_solid),
        cmocka_unit_test(uses_may_differ),
        cmocka_unit_test(a_solid_with_an_interior_texture_is_written_out),
        cmocka_unit_test(a_solid_whose_members_have_uv_coordinates_is_written_out),
        cmocka_unit_test(scenes_of_any_size_are_the_same),
        cmocka_unit_test(copies_stand_anywhere),
        cmocka_unit_test(area_lights_and_uv_textures_are_the_same),
        cmocka_unit_test(a_few_uses_are_written_out_in_their_places),
        cmocka_unit_test(tree_and_list_give_the_same_picture),
        cmocka_unit_test(too_many_copies_are_refused),
    };

    return cmocka_run_group_tests_name("copies", tests, NULL, NULL);
}
