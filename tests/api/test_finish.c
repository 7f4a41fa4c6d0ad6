/* Finishes: one pixel of a sphere under one light, against the numbers that POV-Ray 3.7 gives there. */
#include "support/check.h"
#include "support/near.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 64, HEIGHT = 48, COLUMN = 32, ROW = 24 };

typedef struct sample { const char *light, *look; double red, green, blue; } sample;

#define FRONT "<3,4,-6> rgb 1"
#define GOLD "pigment { rgb <.9,.6,.3> } "
/* In place of the sphere: rays enter at right angles and fall upon the slanted face at 45 degrees. */
#define PRISM "no_image no_reflection } intersection { plane { -z, 1 } plane { <1,0,1>, 0 } plane { -x, 1 } translate .3*x " \
              "interior { ior 1.5 fade_distance 2 fade_power 1001 fade_color <.2,.5,.9> } pigment { rgbt <.8,.8,.8,.9> } "
/* A slab of glass within a sphere: opaque solids hold rays too. */
#define SLAB "no_image no_reflection } sphere { 0, 99 hollow pigment { rgb <.5,.6,.7> } finish { ambient 1 diffuse 0 } } " \
             "box { <-3,-3,0>, <3,3,1> interior { ior 3 } pigment { rgbt <.8,.8,.8,.9> } "
/* From a bump of -2.9 on, the normal is beyond the horizon. */
#define LEANING(bump) "no_image no_reflection } disc { 0, <.94,0,-.34>, 1 pigment { rgb 0 } normal { function { z } " bump " translate .3*z } " \
                      "finish { ambient 0 diffuse 0 "
#define BARE GOLD "finish { ambient 0 diffuse 0 "

static void see(const sample *s, float *out)
{
    char text[1024];
    float *picture;

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <.5,.6,.7> }\n"
             "camera { orthographic location <0,0,-10> direction z right 4*x up 3*y }\n"
             "light_source { %s }\nsphere { 0, 1.45 %s }\n", s->light, s->look);
    picture = scenes_draw(text, WIDTH, HEIGHT, 0, 0);
    for (int i = 0; i < 3; i++)
        out[i] = picture[4 * (ROW * WIDTH + COLUMN) + i];
    free(picture);
}

static void check(const sample *samples, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const sample *s = &samples[i];
        float seen[3];

        see(s, seen);
        if (fabs((double)seen[0] - s->red) > 2e-5 || fabs((double)seen[1] - s->green) > 2e-5 || fabs((double)seen[2] - s->blue) > 2e-5)
            fail_msg("%s: %f %f %f", s->look, (double)seen[0], (double)seen[1], (double)seen[2]);
    }
}

#define CHECK(samples) check(samples, sizeof(samples) / sizeof((samples)[0]))

static void diffuse_light_follows_brilliance_and_albedo(void **state)
{
    static const sample samples[] = {
        { FRONT, GOLD, 0.45122, 0.30082, 0.15041 },
        { FRONT, GOLD "finish { ambient 0 diffuse .8 brilliance 3 }", 0.21550, 0.14368, 0.07184 },
        { FRONT, GOLD "finish { ambient 0 diffuse albedo .4 brilliance 3 }", 0.21550, 0.14368, 0.07184 },
        { FRONT, GOLD "finish { ambient 0 diffuse albedo .9 brilliance 3 diffuse .4 }", 0.21550, 0.14368, 0.07184 },
    };
    (void)state;

    CHECK(samples);
}

static void of_spotlight_cylinder_and_shadowless_the_last_counts(void **state)
{
    static const sample samples[] = {
        { "<3,4,-6> rgb 1 spotlight radius 5 falloff 10 point_at <9,0,0> shadowless", GOLD "finish { ambient 0 diffuse 1 }", 0.60203, 0.40136, 0.20067 },
        { "<3,4,-6> rgb 1 cylinder radius .5 falloff 1 point_at <9,0,0> shadowless", GOLD "finish { ambient 0 diffuse 1 }", 0.55470, 0.36980, 0.18489 },
        { "<3,4,-6> rgb 1 shadowless spotlight radius 5 falloff 10 point_at <9,0,0>", GOLD "finish { ambient 0 diffuse 1 }", 0.0, 0.0, 0.0 },
    };
    (void)state;

    CHECK(samples);
}

/* Beside others, which the light from behind counts for. */
static void light_without_shadows_from_behind_counts_where_the_finish_says_so(void **state)
{
#define BACKS "sphere { <-1.6,0,0>, 1.45 pigment { rgb 1 } finish { ambient 0 diffuse 1,1 } } sphere { <0,2.5,0>, 1.45 pigment { rgb 1 } finish { diffuse 1,1 } "
    static const sample samples[] = {
        { "<3,4,6> rgb 1 shadowless", GOLD "finish { ambient 0 diffuse 1 } } " BACKS, 0.0, 0.0, 0.0 },
    };
    (void)state;

    CHECK(samples);
#undef BACKS
}

static void light_without_shadows_is_projected_all_the_same(void **state)
{
    static const sample samples[] = {
        { "<3,4,-6> rgb 1 shadowless projected_through { sphere { <0,9,0>, 1 } }", GOLD "finish { ambient 0 diffuse 1 }", 0.0, 0.0, 0.0 },
        { "<3,4,-6> rgb 1 shadowless projected_through { sphere { <1.5,2,-3.7>, .9 } }", GOLD "finish { ambient 0 diffuse 1 }", 0.60203, 0.40136, 0.20067 },
        { "<3,4,-6> rgb 1 projected_through { sphere { <0,9,0>, 1 } }", GOLD "finish { ambient 0 diffuse 1 } no_shadow", 0.0, 0.0, 0.0 },
    };
    (void)state;

    CHECK(samples);
}

static void light_from_behind_counts_where_the_finish_says_so(void **state)
{
    static const sample samples[] = {
        { "<-6,4,6> rgb 1", GOLD "finish { ambient 0 diffuse .8 } no_shadow", 0.0, 0.0, 0.0 },
        { "<5,1,1> rgb 1", GOLD "finish { ambient 0 diffuse .5 phong .3 phong_size 3 } double_illuminate no_shadow", 0.18874, 0.12583, 0.06291 },
    };
    (void)state;

    CHECK(samples);
}

/* A light behind shows where the direction half way to it leans out of the surface, whatever the diffuse light is. */
static void highlights_are_on_the_side_of_the_normal(void **state)
{
    static const sample samples[] = {
        { "<5,1,1> rgb 1", BARE "specular .8 roughness .5 } double_illuminate no_shadow", 0.23812, 0.23812, 0.23812 },
        { "<0,1,60> rgb 1", GOLD "finish { ambient 0 diffuse .5 specular .8 roughness 5 } double_illuminate no_shadow", 0.44990, 0.29993, 0.14997 },
        { "<20,0,-4> rgb 1", "no_image no_shadow } disc { 0, <.94,0,-.34>, 1 pigment { rgb 1 } normal { function { z } -20 translate .3*z } "
          "finish { ambient 0 diffuse .1 specular .8 roughness 5 }", 0.01813, 0.01813, 0.01813 },
    };
    (void)state;

    CHECK(samples);
}

static void highlights_are_those_of_phong_and_of_blinn(void **state)
{
    static const sample samples[] = {
        { FRONT, BARE "phong .8 phong_size 10 }", 0.01344, 0.01344, 0.01344 },
        { FRONT, BARE "phong albedo .05 phong_size 10 }", 0.00462, 0.00462, 0.00462 },
        { FRONT, BARE "phong albedo .9 phong .05 phong_size 10 }", 0.00462, 0.00462, 0.00462 },
        { FRONT, BARE "specular .8 roughness .05 }", 0.12738, 0.12738, 0.12738 },
        { FRONT, BARE "specular .8 roughness 1 }", 0.72978, 0.72978, 0.72978 },
        { FRONT, BARE "specular albedo .1 roughness .1 }", 0.06081, 0.06081, 0.06081 },
        { FRONT, BARE "specular albedo .9 specular .1 roughness .1 }", 0.06081, 0.06081, 0.06081 },
        { FRONT, BARE "phong .8 phong_size 3 metallic }", 0.21209, 0.14380, 0.07550 },
    };
    (void)state;

    CHECK(samples);
}

static void reflection_depends_on_the_angle_and_the_pigment(void **state)
{
    static const sample samples[] = {
        { FRONT, BARE "reflection rgb <.1,.5,.2> }", 0.05000, 0.30001, 0.14000 },
        { FRONT, BARE "reflection { .1, .9 } }", 0.05019, 0.06023, 0.07027 },
        { FRONT, BARE "reflection { rgb <.1,.2,.3>, rgb <.9,.8,.1> falloff 3 } }", 0.05000, 0.12000, 0.20999 },
        { FRONT, BARE "reflection { .1, .9 fresnel } } interior { ior 1.5 }", 0.06600, 0.07919, 0.09239 },
        { FRONT, BARE "reflection { 0, 1 fresnel } } interior { ior .7 }", 0.01556, 0.01869, 0.02181 },
        { FRONT, LEANING("-2.5") "reflection { 0, 1 fresnel } } interior { ior 1.5 }", 0.47947, 0.57536, 0.67126 },
        { FRONT, LEANING("-3") "reflection { 0, 1 fresnel } } interior { ior 1.5 }", 0.5, 0.6, 0.7 },
        { FRONT, LEANING("-20") "reflection { .1, .7 fresnel } } interior { ior 1.2 }", 0.35, 0.42, 0.49 },
        { FRONT, LEANING("-3") "reflection { .1, .7 } }", 0.36905, 0.44288, 0.51669 },
        { FRONT, BARE "reflection { .4 metallic } }", 0.18001, 0.14405, 0.08408 },
        { FRONT, BARE "reflection { .6 exponent 2 } }", 0.42426, 0.46476, 0.50199 },
        { FRONT, BARE "reflection { .5 fresnel } } interior { ior 1.5 }", 0.01, 0.012, 0.014 },
        { FRONT, BARE "reflection { .5 fresnel .9 } } interior { ior 1.5 }", 0.25, 0.3, 0.35 },
        { FRONT, BARE "reflection { .5 fresnel fresnel 0 } } interior { ior 1.5 }", 0.000116, 0.000139, 0.000163 },
        { FRONT, BARE "reflection .3 reflection { exponent 2 } }", 0.0, 0.0, 0.0 },
        /* A reflection without a block ends the course of an earlier one, and nothing else of it. */
        { FRONT, BARE "reflection { 0, .5 fresnel } reflection .3 reflection { .1, .9 } } interior { ior 1.5 }", 0.05019, 0.06023, 0.07027 },
        { FRONT, LEANING("-3") "reflection { 0, 1 falloff 3 } reflection .3 reflection { .1, .7 } }", 0.36905, 0.44288, 0.51669 },
        { FRONT, BARE "reflection { .5 metallic } reflection .4 }", 0.18001, 0.14405, 0.08408 },
    };
    (void)state;

    CHECK(samples);
}

static void what_is_reflected_is_not_transmitted_with_conserve_energy(void **state)
{
    static const sample samples[] = {
        { FRONT, "pigment { rgbft <.8,.9,.7,.5,.3> } finish { ambient 0 diffuse 0 reflection rgb <.5,.2,.1> conserve_energy }",
          0.36484, 0.38956, 0.33614 },
    };
    (void)state;

    CHECK(samples);
}

static void a_film_changes_all_light_by_its_wavelength(void **state)
{
    static const sample samples[] = {
        { FRONT, GOLD "finish { ambient 0 diffuse .5 irid { .4 thickness .5 } }", 0.34411, 0.13703, 0.09731 },
        { FRONT, BARE "irid { .3 thickness .5 } reflection .3 }", 0.10954, 0.22768, 0.26474 },
        { FRONT, BARE "irid { .3 thickness .5 } reflection { .3 exponent 2 } }", 0.18128, 0.26134, 0.28182 },
        { FRONT, PRISM "finish { ambient 0 diffuse 0 irid { .3 thickness .5 } }", 0.23645, 0.23848, 0.36132 },
    };
    (void)state;

    CHECK(samples);
}

static void a_finish_that_leaves_nothing_to_transmit_mirrors_where_light_would_be_turned_back(void **state)
{
    static const sample samples[] = {
        { FRONT, PRISM "finish { ambient 0 diffuse 0 reflection { .1, 1 fresnel } conserve_energy }", 0.29366, 0.38378, 0.50327 },
        { FRONT, PRISM "finish { ambient 0 diffuse 0 reflection { .1, .7 fresnel } conserve_energy }", 0.20165, 0.30060, 0.48049 },
    };
    (void)state;

    CHECK(samples);
}

static void a_dielectric_within_another_is_left_without_fresnels_reflection(void **state)
{
    static const sample samples[] = {
        { FRONT, SLAB "finish { ambient 0 diffuse 0 reflection { .1, 1 fresnel } conserve_energy }", 0.43560, 0.52273, 0.60984 },
    };
    (void)state;

    CHECK(samples);
}

static void strengths_below_zero_are_left_out(void **state)
{
    static const sample samples[] = {
        { FRONT, GOLD "finish { ambient 0 diffuse .6 phong -1 phong_size 5 specular -1 specular albedo -.5 metallic -1 crand -.1 irid { -.4 thickness .5 } reflection -.3 }",
          0.36122, 0.24081, 0.12041 },
        { FRONT, GOLD "finish { ambient .1 diffuse -.5 reflection { -.3, -.3 } }", 0.09, 0.06, 0.03 },
        { FRONT, GOLD "finish { ambient 0 diffuse 0 reflection rgb <-.3, .5, .2> }", -0.15, 0.3, 0.14 },
        { FRONT, GOLD "finish { ambient 0 diffuse 0 specular .5 roughness 0 }", 0.5, 0.5, 0.5 },
    };
    (void)state;

    CHECK(samples);
}

static void filters_below_zero_are_weighed_by_their_size(void **state)
{
    static const sample samples[] = {
        { FRONT, "pigment { rgb .5 transmit -.5 } finish { ambient 1 diffuse 0 }", 0.5, 0.525, 0.55 },
        { FRONT, "texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection .6 } }"
          " texture { pigment { rgb .5 transmit -.01 } finish { ambient 1 diffuse 0 } }", 0.805, 0.865, 0.925 },
    };
    (void)state;

    CHECK(samples);
}

/* What metal takes away does not count in the weight of the ray: it is followed although less is left than adc_bailout. */
static void metal_does_not_end_rays(void **state)
{
    float *p = scenes_draw("#version 3.7; global_settings { assumed_gamma 1 adc_bailout .03 } background { rgb 1 } "
                           "camera { orthographic location <0,0,-10> direction z right .001*x up .001*y } "
                           "sphere { 0, 1 pigment { rgb .5 } finish { ambient 0 diffuse 0 reflection { .05 metallic 1 } } }", 1, 1, 1, 1);

    (void)state;
    if (fabs((double)p[0] - 0.025) > 2e-5)
        fail_msg("%f", (double)p[0]);
    free(p);
}

/* A ray from a surface that mirrors more where it grazes has the weight of the larger share at any angle, as in POV-Ray; with
 * Fresnel's course it has the share at its own. */
static void weights_of_mirrors_that_graze(void **state)
{
    static const char *const mirrors[] = { "reflection { .05, .31 }", "reflection { .05, .31 falloff 3 }", "reflection { .05, .31 fresnel } } interior { ior 1.5" };
    static const double wanted[] = { 0.05, 0.05, 0.0 };
    char text[512];

    (void)state;
    for (int i = 0; i < 3; i++) {
        float *p;

        snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 adc_bailout .2 } background { rgb 1 } "
                                    "camera { orthographic location <0,0,-10> direction z right .001*x up .001*y } "
                                    "sphere { 0, 1 pigment { rgb .5 } finish { ambient 0 diffuse 0 %s } }", mirrors[i]);
        p = scenes_draw(text, 1, 1, 1, 1);
        if (fabs((double)p[0] - wanted[i]) > 2e-5)
            fail_msg("%s: %f", mirrors[i], (double)p[0]);
        free(p);
    }
}

/* A pigment that is painted at each hit, and the same one that is painted once as only the normal varies. */
static void one_pigment_with_a_bent_normal_is_as_one_that_varies(void **state)
{
    static const char *const looks[][2] = {
        { "rgb <.9,.6,.3>", "diffuse .6 ambient .2 emission .1 phong .5 reflection .3" },
        { "rgb <.9,.6,.3>", "metallic specular .7 roughness .02 brilliance 2 reflection { .1, .5 metallic }" },
        { "rgbft <.9,.6,.3,.3,.4>", "diffuse .6 phong .7 metallic .5 reflection { 0, 1 fresnel } conserve_energy" },
        { "rgb <.9,.6,.3>", "diffuse .6, .3 irid { .3 thickness .5 } reflection .2" },
    };
    (void)state;

    for (size_t i = 0; i < sizeof looks / sizeof looks[0]; i++) {
        char text[1024];
        float *pictures[2];

        for (int varies = 0; varies < 2; varies++) {
            const char *c = looks[i][0];

            snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 } background { rgb <.5,.6,.7> }\n"
                     "camera { location <0,1,-4> look_at 0 } light_source { <3,4,-6> rgb 1 } plane { y, -1 pigment { checker rgb 1, rgb 0 } }\n"
                     "sphere { 0, 1.45 pigment { %s%s%s%s } normal { bumps .4 scale .2 } finish { %s } interior { ior 1.3 } }\n",
                     varies ? "checker " : "", c, varies ? ", " : "", varies ? c : "", looks[i][1]);
            pictures[varies] = scenes_draw(text, WIDTH, HEIGHT, 1, 1);
        }
        assert_memory_equal(pictures[0], pictures[1], sizeof(float) * 4 * WIDTH * HEIGHT);
        free(pictures[0]);
        free(pictures[1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(diffuse_light_follows_brilliance_and_albedo),
        cmocka_unit_test(of_spotlight_cylinder_and_shadowless_the_last_counts),
        cmocka_unit_test(light_without_shadows_is_projected_all_the_same),
        cmocka_unit_test(light_without_shadows_from_behind_counts_where_the_finish_says_so),
        cmocka_unit_test(light_from_behind_counts_where_the_finish_says_so),
        cmocka_unit_test(highlights_are_on_the_side_of_the_normal),
        cmocka_unit_test(highlights_are_those_of_phong_and_of_blinn),
        cmocka_unit_test(reflection_depends_on_the_angle_and_the_pigment),
        cmocka_unit_test(what_is_reflected_is_not_transmitted_with_conserve_energy),
        cmocka_unit_test(a_finish_that_leaves_nothing_to_transmit_mirrors_where_light_would_be_turned_back),
        cmocka_unit_test(a_dielectric_within_another_is_left_without_fresnels_reflection),
        cmocka_unit_test(strengths_below_zero_are_left_out),
        cmocka_unit_test(filters_below_zero_are_weighed_by_their_size),
        cmocka_unit_test(a_film_changes_all_light_by_its_wavelength),
        cmocka_unit_test(metal_does_not_end_rays),
        cmocka_unit_test(weights_of_mirrors_that_graze),
        cmocka_unit_test(one_pigment_with_a_bent_normal_is_as_one_that_varies),
    };

    return cmocka_run_group_tests_name("finishes", tests, NULL, NULL);
}
