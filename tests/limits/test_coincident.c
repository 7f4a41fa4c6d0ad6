/* test_coincident.c - surfaces that lie on each other. The rule (docs/numerics.md): what a ray meets at one distance it
 * meets one after the other, first what it enters and then what it leaves, and of these the earlier object first; and
 * what starts there lies on the one side or the other of each of them, as the way there had it. */
#include "support/check.h"
#include "support/limits.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 64, HEIGHT = 48 };

static int begin(void **state)
{
    *state = scenes_context();
    return 0;
}

static int end(void **state)
{
    pov_context_destroy(*state);
    return 0;
}

static const char *const turns[] = { "", "rotate <0,25,0>", "rotate <23,31,47>", "scale <1.25,0.75,1.5> rotate <-35,15,80>",
                                     "rotate <10,20,30> translate <0.1,-0.2,0.3>" };
enum { TURNS = (int)(sizeof turns / sizeof *turns) };

static const char head[] =
    "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 12 } background { color rgb <0.25,0.5,1> }\n"
    "camera { location <0.5,1,-6> look_at <0,0,0> angle 40 right <1.3333333,0,0> }\n"
    "light_source { <-6,9,-12> color rgb 0.5 } light_source { <8,3,-7> color rgb <0.5,0.25,0.25> }\n"
    "sphere { <4,5,-9>, 2 pigment { color rgb <1,1,0> } finish { ambient 1 diffuse 0 } }\n"
    "sphere { <-3,-2,4>, 1.5 pigment { color rgb <1,0,1> } finish { ambient 1 diffuse 0 } }\n"
    "sphere { <2,1.5,5>, 1 pigment { color rgb <0,1,0> } finish { ambient 1 diffuse 0 } }\n";

/* One or two shapes, each with what follows it. */
static float *picture(void *context, const char *one, const char *sample_one, const char *two, const char *sample_two,
                      const char *turn)
{
    char text[4096];
    int n = sprintf(text, "%s", head);

    if (one)
        n += sprintf(text + n, "%s %s %s }\n", one, sample_one, turn);
    if (two)
        sprintf(text + n, "%s %s %s }\n", two, sample_two, turn);
    return limits_picture(context, text, &limits_home, WIDTH, HEIGHT);
}

static void expect_same(const float *a, const float *b, long most, const char *what, const char *turn)
{
    const long off = limits_count(a, b, WIDTH, HEIGHT, 1e-4f);

    if (off > most)
        print_error("%s %s: %ld pixels differ\n", what, turn, off);
    assert_true(off <= most);
}

typedef struct pair { const char *one, *two; } pair;

/* The second lies on the first, all of it or a part. */
static const pair pairs[] = {
    { "box { <-1,-1,-1>, <1,1,1>", "box { <-1,-1,-1>, <1,1,1>" },
    { "box { <-1,-1,-1>, <1,1,1>", "polygon { 4, <-1,-1,-1>, <1,-1,-1>, <1,1,-1>, <-1,1,-1>" },
    { "box { <-1,-1,-1>, <1,1,1>", "polygon { 3, <-0.7,-0.6,-1>, <0.9,-0.8,-1>, <0.3,0.75,-1>" },
    { "box { <-1,-1,-1>, <1,1,1>", "polygon { 4, <-1,1,-1>, <1,1,-1>, <1,1,1>, <-1,1,1>" },
    { "box { <-1,-1,-1>, <1,1,1>", "box { <-0.5,-0.5,-1>, <0.5,0.5,0>" },
    { "box { <-1,-1,-1>, <1,1,1>", "cylinder { <0.1,0,-1>, <0.1,0,0>, 0.7" },
    { "box { <-1,-1,-1>, <1,1,1>", "cone { <0,0.1,-1>, 0.8, <0,0.1,0>, 0.3" },
    { "sphere { <0,0,0>, 1.25", "sphere { <0,0,0>, 1.25" },
    { "sphere { <0.3,0.1,0>, 1.25", "sphere { <0.3,0.1,0>, 1.25" },
    { "sphere { <0,0,0>, 1.25", "quadric { <1,1,1>, <0,0,0>, <0,0,0>, -1.5625" },
    { "cylinder { <0,-1,0>, <0,1,0>, 1.25", "quadric { <1,0,1>, <0,0,0>, <0,0,0>, -1.5625" },
    { "cylinder { <0,-1,0>, <0,1,0>, 1", "cylinder { <0,-1,0>, <0,1,0>, 1 open" },
    { "cylinder { <0,-1,0>, <0,1,0>, 1", "cylinder { <0,1,0>, <0,-1,0>, 1" },
    { "cylinder { <0,-1,0>, <0,1,0>, 1", "cylinder { <0,-0.5,0>, <0,0.5,0>, 1" },
    { "cone { <0,-1,0>, 1.5, <0,1,0>, 0.5", "cone { <0,-0.5,0>, 1.25, <0,0.5,0>, 0.75" },
    { "cone { <0,-1,0>, 1.5, <0,1,0>, 0.5", "cone { <0,1,0>, 0.5, <0,-1,0>, 1.5" },
};
enum { PAIRS = (int)(sizeof pairs / sizeof *pairs) };

/* Both alike, opaque: the second changes nothing that shows, no spot of shadow and no mirrored one. (The quadric cylinder
 * has no end: there the first is added to the second.) */
static void what_lies_on_its_like_does_not_show(void **state)
{
    static const char *const looks[] = {
        "pigment { color rgb 1 } finish { ambient 0.125 diffuse 0.75 phong 0.5 }",
        "pigment { color rgb 0.5 } finish { ambient 0 diffuse 0.5 reflection 0.5 }",
    };
    long broken = 0;

    for (int i = 0; i < PAIRS; i++)
        for (int k = 0; k < TURNS * 2; k++) {
            const char *whole = strstr(pairs[i].two, "quadric { <1,0,1>") ? pairs[i].two : pairs[i].one;
            const char *sample = looks[k % 2];
            float *single = picture(*state, whole, sample, NULL, NULL, turns[k / 2]);
            float *first = picture(*state, pairs[i].one, sample, pairs[i].two, sample, turns[k / 2]);
            float *second = picture(*state, pairs[i].two, sample, pairs[i].one, sample, turns[k / 2]);
            const long off = limits_count(single, first, WIDTH, HEIGHT, 1e-4f) +
                             limits_count(single, second, WIDTH, HEIGHT, 1e-4f);

            if (off)
                print_error("%s on %s, %s: %ld pixels differ\n", pairs[i].two, pairs[i].one, turns[k / 2], off);
            broken += off;
            free(single);
            free(first);
            free(second);
        }
    assert_int_equal(broken, 0);
}

/* Where the second lies on the first all over, nothing is seen of the later one. */
static void the_earlier_of_two_is_seen(void **state)
{
    static const int covered[] = { 0, 7, 8, 9, 14 };
    const char *red = "pigment { color rgb <1,0,0> } finish { ambient 0.5 diffuse 0.5 reflection 0.25 }";
    const char *green = "pigment { color rgb <0,1,0> } finish { ambient 0.5 diffuse 0.5 reflection 0.25 }";
    long broken = 0;

    for (size_t i = 0; i < sizeof covered / sizeof *covered; i++)
        for (int k = 0; k < TURNS; k++) {
            const pair *p = &pairs[covered[i]];
            float *single = picture(*state, p->one, red, NULL, NULL, turns[k]);
            float *both = picture(*state, p->one, red, p->two, green, turns[k]);
            const long off = limits_count(single, both, WIDTH, HEIGHT, 1e-4f);

            if (off)
                print_error("%s over %s, %s: %ld pixels differ\n", p->one, p->two, turns[k], off);
            broken += off;
            free(single);
            free(both);
        }
    assert_int_equal(broken, 0);
}

static const char glass[] = "pigment { color rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 }";

/* Two halves that share a face are as one, at all angles: nothing is mirrored in between. Centres of pixels that lie on
 * an edge of the shared face may go either way. */
static void glass_against_glass_is_one_glass(void **state)
{
    static const pair halves[] = {
        { "box { <-1.25,-1,-1>, <0.1,1,1>", "box { <0.1,-1,-1>, <1.25,1,1>" },
        { "box { <-1.25,-1,-1>, <1.25,1,0.3>", "box { <-1.25,-1,0.3>, <1.25,1,1>" },
        { "cylinder { <-1.25,0,0>, <0.1,0,0>, 1", "cylinder { <0.1,0,0>, <1.25,0,0>, 1" },
    };
    static const char *const whole[] = { "box { <-1.25,-1,-1>, <1.25,1,1>", "box { <-1.25,-1,-1>, <1.25,1,1>",
                                         "cylinder { <-1.25,0,0>, <1.25,0,0>, 1" };

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < TURNS; k++) {
            float *one = picture(*state, whole[i], glass, NULL, NULL, turns[k]);
            float *there = picture(*state, halves[i].one, glass, halves[i].two, glass, turns[k]);
            float *back = picture(*state, halves[i].two, glass, halves[i].one, glass, turns[k]);

            expect_same(one, there, 2, whole[i], turns[k]);
            expect_same(there, back, 2, whole[i], turns[k]);
            free(one);
            free(there);
            free(back);
        }
}

/* The same glass twice in one place: one of the squared filter. (Where glass mirrors from within, which a sphere never
 * does to what comes from outside, the outer of both does, and the inner one is passed twice more.) */
static void glass_in_glass_counts_twice(void **state)
{
    static const char *const solids[] = { "sphere { <0.2,0,0>, 1.25 interior { ior 1.25 }", "box { <-1,-1,-1>, <1,1,1>",
                                          "cylinder { <0,-1,0>, <0,1,0>, 1.25", "cone { <0,-1,0>, 1.5, <0,1,0>, 0.5" };
    const char *half = "pigment { color rgbf <1,1,1,0.5> } finish { ambient 0 diffuse 0 }";
    const char *quarter = "pigment { color rgbf <1,1,1,0.25> } finish { ambient 0 diffuse 0 }";

    for (int i = 0; i < 4; i++)
        for (int k = 0; k < (i == 0 ? 3 : TURNS); k++) {
            float *one = picture(*state, solids[i], quarter, NULL, NULL, turns[k]);
            float *two = picture(*state, solids[i], half, solids[i], half, turns[k]);

            expect_same(one, two, 0, solids[i], turns[k]);
            free(one);
            free(two);
        }
}

/* A pane that lies on an opaque block filters what is seen and lit through it by its outer face alone, each way: the
 * ray enters the block before it leaves the pane. */
static void a_pane_on_a_block_filters_its_light(void **state)
{
    const char *block = "box { <-9,-9,0>, <9,9,1>", *pane = "box { <-8,-8,-0.25>, <8,8,0>";
    const char *matt = "pigment { color rgb 1 } finish { ambient 0 diffuse 1 }";
    const char *filter = "pigment { color rgbf <1,1,1,0.5> } finish { ambient 0 diffuse 0 }";
    static const char *const still[] = { "", "rotate <10,20,30>", "rotate <-20,-10,45>" };

    for (int k = 0; k < 3; k++) {
        float *bare = picture(*state, block, matt, NULL, NULL, still[k]);
        float *there = picture(*state, block, matt, pane, filter, still[k]);
        float *back = picture(*state, pane, filter, block, matt, still[k]);
        long off = 0, lit = 0;

        for (long i = 0; i < WIDTH * HEIGHT; i++) {
            const bool seen = bare[4 * i + 1] > 0.0f && bare[4 * i + 1] < 0.75f && bare[4 * i] > 0.0f;
            lit += seen;
            off += seen && !(fabsf(4.0f * there[4 * i] - bare[4 * i]) < 1e-4f);
        }
        assert_true(lit > WIDTH * HEIGHT / 2);
        if (off)
            print_error("%s: %ld pixels differ\n", still[k], off);
        assert_int_equal(off, 0);
        expect_same(there, back, 0, "a pane", still[k]);
        free(bare);
        free(there);
        free(back);
    }
}

/* A mirror glued to the back of a plate of glass, before or after it in the text. */
static void a_silvered_plate_is_a_mirror(void **state)
{
    const char *plate = "box { <-2,-2,0>, <2,2,0.25>", *silver = "polygon { 4, <-2,-2,0.25>, <2,-2,0.25>, <2,2,0.25>, <-2,2,0.25>";
    const char *near = "polygon { 4, <-2,-2,0.2499999999>, <2,-2,0.2499999999>, <2,2,0.2499999999>, <-2,2,0.2499999999>";
    const char *mirror = "finish { ambient 0 diffuse 0 reflection 1 }";

    for (int k = 0; k < 2; k++) {
        float *there = picture(*state, plate, glass, silver, mirror, turns[k]);
        float *back = picture(*state, silver, mirror, plate, glass, turns[k]);
        float *inside = picture(*state, plate, glass, near, mirror, turns[k]);

        expect_same(there, back, 0, "a plate", turns[k]);
        expect_same(there, inside, 4, "a plate", turns[k]);
        free(there);
        free(back);
        free(inside);
    }
}

/* A dark room of boxes: rays to its very edges and corners, lights outside all around. */
static void the_edges_of_a_room_do_not_leak(void **state)
{
    static const char *const lights[] = { "<9,7,8>", "<-9,-7,-8>", "<-8,9,7>", "<0.5,-9,0.5>", "<0.5,0.5,-9>", "<9,0.5,0.5>" };
    static const char *const walls[] = { "<-1,-1,-1>, <2,0,2>", "<-1,1,-1>, <2,2,2>", "<-1,0,-1>, <0,1,2>",
                                         "<1,0,-1>, <2,1,2>",   "<0,0,-1>, <1,1,0>",  "<0,0,1>, <1,1,2>" };
    const pov_vec3 eye = { 0.375, 0.625, 0.4375 };
    char text[4096];
    pov_scene *scene;
    long leaks = 0;
    int n = sprintf(text, "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 3 } background { color rgb 1 }\n");

    for (int i = 0; i < 6; i++)
        n += sprintf(text + n,
                     "light_source { %s color rgb 1 }\n"
                     "box { %s pigment { color rgb 1 } finish { ambient 0 diffuse 1 reflection 0.5 } }\n", lights[i], walls[i]);
    scene = limits_scene(*state, text, &limits_home, NULL);
    for (int i = 0; i < 12 * 65; i++) {
        const double along = (i / 12) / 64.0, a = i % 4 / 2, b = i % 2;
        const int axis = i % 12 / 4;
        const pov_vec3 to = axis == 0   ? pov_vec3_of(along, a, b)
                            : axis == 1 ? pov_vec3_of(a, along, b)
                                        : pov_vec3_of(a, b, along);
        float c[4];

        limits_trace(scene, eye, pov_sub(to, eye), c);
        leaks += c[0] != 0.0f || c[1] != 0.0f || c[2] != 0.0f;
    }
    pov_scene_destroy(scene);
    assert_int_equal(leaks, 0);
}

/* All of it at once: tree and list, one thread and three, give the same bits. */
static void the_rule_asks_neither_tree_nor_threads(void **state)
{
    char text[8192];
    pov_load_desc list = POV_INIT(list);
    pov_render_desc one = POV_INIT(one), three = POV_INIT(three);
    pov_scene *a, *b;
    float *p, *q, *r;
    int n = sprintf(text, "%s", head);

    for (int i = 0; i < PAIRS; i++) {
        n += sprintf(text + n, "%s pigment { color rgb <0.5,0.25,1> } finish { reflection 0.25 } scale 0.25 translate <%g,%g,0> }\n",
                     pairs[i].one, -1.5 + 0.75 * (i % 5), -0.75 + 0.75 * (i / 5));
        n += sprintf(text + n, "%s pigment { color rgbf <0.5,1,0.25,0.5> } scale 0.25 translate <%g,%g,0> }\n",
                     pairs[i].two, -1.5 + 0.75 * (i % 5), -0.75 + 0.75 * (i / 5));
    }
    list.accel = POV_ACCEL_NONE;
    one.width = three.width = 2 * WIDTH;
    one.height = three.height = 2 * HEIGHT;
    one.threads = 1;
    three.threads = 3;
    a = limits_scene(*state, text, &limits_home, NULL);
    b = limits_scene(*state, text, &limits_home, &list);
    p = scenes_render(a, &one);
    q = scenes_render(b, &one);
    r = scenes_render(a, &three);
    assert_int_equal(limits_count(p, q, 2 * WIDTH, 2 * HEIGHT, 0.0f), 0);
    assert_int_equal(limits_count(p, r, 2 * WIDTH, 2 * HEIGHT, 0.0f), 0);
    pov_scene_destroy(a);
    pov_scene_destroy(b);
    free(p);
    free(q);
    free(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_lies_on_its_like_does_not_show),
        cmocka_unit_test(the_earlier_of_two_is_seen),
        cmocka_unit_test(glass_against_glass_is_one_glass),
        cmocka_unit_test(glass_in_glass_counts_twice),
        cmocka_unit_test(a_pane_on_a_block_filters_its_light),
        cmocka_unit_test(a_silvered_plate_is_a_mirror),
        cmocka_unit_test(the_edges_of_a_room_do_not_leak),
        cmocka_unit_test(the_rule_asks_neither_tree_nor_threads),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
