/* test_mirrors.c - long ways between mirrors and through glass, against what geometry says. */
#include "support/check.h"
#include "support/limits.h"
#include "support/scenes.h"

#include <stdio.h>
#include <stdlib.h>

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

/* Targets at x: red below y - wide, green from there to y + wide, blue above. */
static int put_targets(char *to, double x, double y, double wide)
{
    return sprintf(to,
                   "box { <%.17g,-9,-9>, <%.17g,%.17g,9> pigment { color rgb <1,0,0> } finish { ambient 1 diffuse 0 } }\n"
                   "box { <%.17g,%.17g,-9>, <%.17g,%.17g,9> pigment { color rgb <0,1,0> } finish { ambient 1 diffuse 0 } }\n"
                   "box { <%.17g,%.17g,-9>, <%.17g,9,9> pigment { color rgb <0,0,1> } finish { ambient 1 diffuse 0 } }\n",
                   x, x + 1.0, y - wide, x, y - wide, x + 1.0, y + wide, x, y + wide, x + 1.0);
}

static const char head[] = "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 300 adc_bailout 0 }\n";

/* ---- two mirrors ---- */

/* At y = 0 and 1, from x = 0 to 200: a ray of slope s that starts at (0, y) leaves at y + 200 s, folded. */
static double folded(double y)
{
    const double within = y - 2.0 * floor(0.5 * y);
    return within > 1.0 ? 2.0 - within : within;
}

static void hold_corridor(void *context, const char *mirrors, double slope, double wide, bool green)
{
    const double from = 0.25, end = 200.0, y = folded(from + slope * end);
    char text[2048];
    pov_scene *scene;
    float c[4];
    int n = sprintf(text, "%s%s", head, mirrors);

    put_targets(text + n, end, y + (green ? 0.0 : 2.0 * wide), wide);
    scene = limits_scene(context, text, &limits_home, NULL);
    limits_trace(scene, pov_vec3_of(0.0, from, 0.0), pov_vec3_of(1.0, slope, 0.0), c);
    if (c[1] != (green ? 1.0f : 0.0f) || c[0] != (green ? 0.0f : 1.0f))
        print_error("slope %g, %g wide: %g %g %g\n", slope, wide, (double)c[0], (double)c[1], (double)c[2]);
    assert_true(c[1] == (green ? 1.0f : 0.0f) && c[0] == (green ? 0.0f : 1.0f) && c[2] == 0.0f);
    pov_scene_destroy(scene);
}

static const char *const corridors[] = {
    "polygon { 4, <-1,0,-1>, <200,0,-1>, <200,0,1>, <-1,0,1> finish { ambient 0 diffuse 0 reflection 1 } }\n"
    "polygon { 4, <-1,1,-1>, <200,1,-1>, <200,1,1>, <-1,1,1> finish { ambient 0 diffuse 0 reflection 1 } }\n",
    "box { <-1,-1,-1>, <200,0,1> finish { ambient 0 diffuse 0 reflection 1 } }\n"
    "box { <-1,1,-1>, <200,2,1> finish { ambient 0 diffuse 0 reflection 1 } }\n",
    "quadric { <0,0,0>, <0,0,0>, <0,1,0>, 0 finish { ambient 0 diffuse 0 reflection 1 } }\n"
    "quadric { <0,0,0>, <0,0,0>, <0,1,0>, -1 finish { ambient 0 diffuse 0 reflection 1 } }\n",
};

/* 200 bounces: the strip of 2e-11 about the exact end is met, the one beside it is not. Each bounce rounds the direction
 * anew, and each such rounding is worth up to 200 times itself at the end. */
static void two_hundred_bounces_end_where_they_should(void **state)
{
    static const double slopes[] = { 1.0, 0.998046875, 1.0009765625, -1.0, 0.71234130859375, -0.3331298828125 };

    for (size_t m = 0; m < sizeof corridors / sizeof *corridors; m++)
        for (size_t i = 0; i < sizeof slopes / sizeof *slopes; i++) {
            hold_corridor(*state, corridors[m], slopes[i], 1e-11, true);
            hold_corridor(*state, corridors[m], slopes[i], 1e-11, false);
        }
}

/* ---- a mirrored room ---- */

typedef struct unfolding { int bounces; bool found, close; } unfolding;

/* The unit cube from 0 to 1, all mirrors, a sphere of radius r at c. Unfolded, the ray is straight and the sphere
 * stands mirrored in every cell, the first one maybe behind. Too close a pass for this arithmetic is `close`. */
static unfolding unfold(pov_vec3 o, pov_vec3 d, pov_vec3 c, double r, int most)
{
    const double from[3] = { o.x, o.y, o.z }, dir[3] = { d.x, d.y, d.z }, sphere[3] = { c.x, c.y, c.z };
    int cell[3] = { 0, 0, 0 };
    unfolding w = { 0, false, false };

    for (; w.bounces <= most; w.bounces++) {
        double a = 0.0, b = 0.0, q = 0.0, next = HUGE_VAL, second = HUGE_VAL;
        int axis = 0;

        for (int i = 0; i < 3; i++) {
            const double centre = cell[i] + ((cell[i] & 1) ? 1.0 - sphere[i] : sphere[i]);
            const double wall = dir[i] > 0.0 ? cell[i] + 1.0 : cell[i], t = (wall - from[i]) / dir[i];

            a += dir[i] * dir[i];
            b += dir[i] * (from[i] - centre);
            q += (from[i] - centre) * (from[i] - centre);
            if (t < next) {
                second = next;
                next = t;
                axis = i;
            } else if (t < second) {
                second = t;
            }
        }
        q -= b * b / a;
        w.close = w.close || fabs(q - r * r) < 1e-7 || second - next < 1e-7;
        if (q < r * r && b < 0.0) {
            w.found = true;
            return w;
        }
        cell[axis] += dir[axis] > 0.0 ? 1 : -1;
    }
    return w;
}

static double uniform(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) * 0x1p-53;
}

/* Each bounce takes a two-hundredth, so that the colour counts them. */
static void a_mirrored_room_counts_its_bounces(void **state)
{
    static const char *const rooms[] = {
        "box { <0,0,0>, <1,1,1> pigment { color rgb 0 } finish { ambient 0 diffuse 0 reflection 0.995 } }\n",
        "polygon { 4, <0,0,0>, <1,0,0>, <1,1,0>, <0,1,0> finish { ambient 0 diffuse 0 reflection 0.995 } }\n"
        "polygon { 4, <0,0,1>, <1,0,1>, <1,1,1>, <0,1,1> finish { ambient 0 diffuse 0 reflection 0.995 } }\n"
        "polygon { 4, <0,0,0>, <1,0,0>, <1,0,1>, <0,0,1> finish { ambient 0 diffuse 0 reflection 0.995 } }\n"
        "polygon { 4, <0,1,0>, <1,1,0>, <1,1,1>, <0,1,1> finish { ambient 0 diffuse 0 reflection 0.995 } }\n"
        "polygon { 4, <0,0,0>, <0,1,0>, <0,1,1>, <0,0,1> finish { ambient 0 diffuse 0 reflection 0.995 } }\n"
        "polygon { 4, <1,0,0>, <1,1,0>, <1,1,1>, <1,0,1> finish { ambient 0 diffuse 0 reflection 0.995 } }\n",
    };
    const char *sphere =
        "sphere { <0.5625,0.4375,0.65625>, 0.0625 pigment { color rgb 1 } finish { ambient 1 diffuse 0 } }\n";
    const pov_vec3 eye = { 0.25, 0.3125, 0.1875 }, centre = { 0.5625, 0.4375, 0.65625 };
    uint64_t seed = 1;
    int found = 0, longest = 0, tried;

    for (size_t m = 0; m < 2; m++) {
        char text[2048];
        pov_scene *scene;

        sprintf(text, "%s%s%s", head, rooms[m], sphere);
        scene = limits_scene(*state, text, &limits_home, NULL);
        for (tried = 0; tried < 3000; tried++) {
            const pov_vec3 d = { uniform(&seed) - 0.5, uniform(&seed) - 0.5, uniform(&seed) - 0.5 };
            const unfolding w = unfold(eye, d, centre, 0.0625, 240);
            float c[4], wanted = (float)pow(0.995, w.bounces);

            if (w.close || w.bounces > 200)
                continue;
            limits_trace(scene, eye, d, c);
            if (!(fabsf(c[0] - wanted) < 1e-4f * wanted))
                print_error("%a %a %a: %d bounces, seen %g\n", d.x, d.y, d.z, w.bounces, (double)c[0]);
            assert_true(fabsf(c[0] - wanted) < 1e-4f * wanted);
            found++;
            longest = w.bounces > longest ? w.bounces : longest;
        }
        pov_scene_destroy(scene);
    }
    assert_true(found > 3000 && longest > 150);
}

/* ---- indices of refraction ---- */

/* Where a ray that starts at the origin with this slope is at x = 4, when a slab of ior n stands from x = 1 to 2. What
 * is near zero for n near one is computed as that: y = 4 s - shift, with the slope s' inside, s - s' in full. */
static double behind_slab(double slope, double n)
{
    const double inner = slope / sqrt(n * n + (n - 1.0) * (n + 1.0) * slope * slope);
    return 3.0 * slope + inner;
}

static void hold_slab(void *context, const char *slab, double slope, const char *n_text, double wide, bool green)
{
    const double y = behind_slab(slope, strtod(n_text, NULL));
    char text[2048];
    pov_scene *scene;
    float c[4];
    int n = sprintf(text, "%s%s pigment { color rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior %s } }\n", head, slab,
                    n_text);

    put_targets(text + n, 4.0, y + (green ? 0.0 : 2.0 * wide), wide);
    scene = limits_scene(context, text, &limits_home, NULL);
    limits_trace(scene, pov_vec3_of(0.0, 0.0, 0.0), pov_vec3_of(1.0, slope, 0.0), c);
    if (c[1] != (green ? 1.0f : 0.0f))
        print_error("%s, ior %s, slope %g: %g %g %g\n", slab, n_text, slope, (double)c[0], (double)c[1], (double)c[2]);
    assert_true(c[1] == (green ? 1.0f : 0.0f));
    pov_scene_destroy(scene);
}

static void any_index_refracts_as_snell_says(void **state)
{
    static const char *const slabs[] = {
        "box { <1,-8,-8>, <2,8,8>",
        "cylinder { <1,0,0>, <2,0,0>, 8",
        "cone { <1,0,0>, 9, <2,0,0>, 8",
    };
    static const char *const indices[] = { "1.00000000001", "1.0000001", "1.001", "1.5", "2.4", "10", "0.9999999", "0.99" };
    static const double slopes[] = { 0.125, 0.5, 1.0, -1.5 };

    for (size_t s = 0; s < sizeof slabs / sizeof *slabs; s++)
        for (size_t i = 0; i < sizeof indices / sizeof *indices; i++)
            for (size_t k = 0; k < sizeof slopes / sizeof *slopes; k++) {
                hold_slab(*state, slabs[s], slopes[k], indices[i], 1e-14, true);
                hold_slab(*state, slabs[s], slopes[k], indices[i], 1e-14, false);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_hundred_bounces_end_where_they_should),
        cmocka_unit_test(a_mirrored_room_counts_its_bounces),
        cmocka_unit_test(any_index_refracts_as_snell_says),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
