/* shade/subsurface: light below surfaces against the closed forms of the dipole. */
#include "shade/subsurface.h"

#include "support/check.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 32, HEIGHT = 24, SAMPLES = 16 };

static float *draw(const char *text)
{
    return scenes_draw(text, WIDTH, HEIGHT, SAMPLES, 0);
}

static double mean_of(const char *text)
{
    float *p = draw(text);
    double sum = 0.0;

    for (int i = 0; i < WIDTH * HEIGHT; i++)
        sum += (double)p[4 * i];
    free(p);
    return sum / (WIDTH * HEIGHT);
}

static const double ior = 1.3;

/* Light that goes in and out across the surface. */
static double both_ways(void)
{
    const double r = (ior - 1.0) / (ior + 1.0), through = 1.0 - r * r;

    return through * through;
}

#define SCENE(settings) \
    "#version 3.7; global_settings { assumed_gamma 1 mm_per_unit 10 " settings " }" \
    "camera { orthographic location <0,0,-10> direction z right x*4 up y*3 }"

static void the_albedo_gives_what_it_was_solved_for(void **state)
{
    (void)state;
    for (double reflected = 0.05; reflected < 1.0; reflected += 0.1)
        assert_true(fabs(subsurface_reflected(subsurface_albedo(reflected)) - reflected) < 1e-6);
    assert_true(subsurface_albedo(1.0) == 1.0);
}

static void even_light_gives_the_albedo(void **state)
{
    static const double given[] = { 0.3, 0.7, 1.0 };

    (void)state;
    for (int i = 0; i < 3; i++) {
        const double wanted = (given[i] + subsurface_albedo(given[i]) / 24.0) * both_ways();
        char text[1024];
        double found;

        snprintf(text, sizeof text, SCENE("subsurface { }") "box { <-90,-90,0>, <90,90,60> pigment { rgb 1 } interior { ior 1.3 }"
                 "finish { ambient 0 diffuse %g subsurface { translucency 1 } } }"
                 "light_source { <0,0,-1000> rgb 1 parallel point_at 0 }", given[i]);
        found = mean_of(text);
        if (!(fabs(found / wanted - 1.0) < 0.01))
            fail_msg("%g instead of %g for %g", found, wanted, given[i]);
    }
}

/* Distances are drawn as the profile has them, for all channels together: one sample of a pixel is hardly noisy. */
static void even_light_has_little_noise(void **state)
{
    float *p = scenes_draw(SCENE("subsurface { }") "box { <-90,-90,0>, <90,90,60> pigment { rgb <.9,.5,.2> } interior { ior 1.3 }"
                           "finish { ambient 0 diffuse 1 subsurface { translucency <1,.5,2> } } }"
                           "light_source { <0,0,-1000> rgb 1 parallel point_at 0 }", WIDTH, HEIGHT, 1, 0);

    (void)state;
    for (int c = 0; c < 3; c++) {
        double sum = 0.0, squares = 0.0, mean;

        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            sum += (double)p[4 * i + c];
            squares += (double)p[4 * i + c] * (double)p[4 * i + c];
        }
        mean = sum / (WIDTH * HEIGHT);
        if (!(sqrt(squares / (WIDTH * HEIGHT) - mean * mean) < 0.03 * mean))
            fail_msg("channel %d: noise %g of %g", c, sqrt(squares / (WIDTH * HEIGHT) - mean * mean), mean);
    }
    free(p);
}

/* A plate half a mean free path thick. */
static void a_plate_lets_light_through(void **state)
{
    const double length = 1.0, image = length * 7.0 / 3.0, thick = 0.5;
    const double wanted = both_ways() * 0.5 * (length / hypot(thick, length) + image / hypot(thick, image));
    const double found = mean_of(SCENE("subsurface { }") "box { <-900,-900,0>, <900,900,.5> pigment { rgb 1 } interior { ior 1.3 }"
                                 "finish { ambient 0 diffuse 1 subsurface { translucency 10 } } }"
                                 "light_source { <0,0,1000> rgb 1 parallel point_at 0 }");

    (void)state;
    if (!(fabs(found / wanted - 1.0) < 0.02))
        fail_msg("%g instead of %g", found, wanted);
}

/* Half a square's side, and what POV-Ray 3.7 shows in the middle of such a face of a box in even light of 1: the light that enters further
 * away is missing. */
typedef struct face { double half, given[3]; } face;

static void check_face(const face *f, const char *look, double within)
{
    char text[1024];
    float *p;

    snprintf(text, sizeof text, "#version 3.7; global_settings { assumed_gamma 1 mm_per_unit 1 subsurface { } }"
             "camera { orthographic location <0,0,-10> direction z right x*%g up y*%g }"
             "box { <-%g,-%g,0>, <%g,%g,99> %s }"
             "light_source { <0,0,-1000> rgb 1 parallel point_at 0 }", f->half * 0.1, f->half * 0.1, f->half, f->half, f->half, f->half, look);
    p = draw(text);
    for (int c = 0; c < 3; c++) {
        double mean = 0.0;

        for (int k = 0; k < WIDTH * HEIGHT; k++)
            mean += (double)p[4 * k + c] / (WIDTH * HEIGHT);
        if (!(fabs(mean / f->given[c] - 1.0) < within))
            fail_msg("%g instead of %g, channel %d of a half side of %g", mean, f->given[c], c, f->half);
    }
    free(p);
}

static void faces_give_what_enters_near_by(void **state)
{
    static const face faces[] = { { 2.0, { 0.4486, 0.4453, 0.3669 } }, { 8.0, { 0.8219, 0.8032, 0.5169 } }, { 32.0, { 0.9588, 0.9038, 0.5211 } } };

    (void)state;
    for (int i = 0; i < 3; i++)
        check_face(&faces[i], "pigment { rgb <1,.9,.5> } interior { ior 1.3 } finish { ambient 0 diffuse 1 subsurface { translucency 1 } }", 0.03);
}

/* The translucency is the way between two places where light is scattered: what is absorbed shortens it. */
static void dark_faces_give_what_enters_nearer_by(void **state)
{
    static const face faces[] = { { 0.5, { 0.0447, 0.0404, 0.0285 } }, { 2.0, { 0.1117, 0.1017, 0.0760 } }, { 8.0, { 0.3860, 0.2870, 0.1213 } } };

    (void)state;
    for (int i = 0; i < 3; i++)
        check_face(&faces[i], "pigment { rgb <.5,.3,.1> } finish { ambient 0 diffuse 1 subsurface { translucency 4 } }", 0.015);
}

/* What POV-Ray 3.7 shows of a plane, pigment .7, seen straight on, in light that comes at this angle: beyond .7 of what enters it is light that
 * was scattered once. */
static void light_scattered_once_depends_on_where_it_comes_from(void **state)
{
    static const struct { double degrees, more; } ways[] = { { 0.0, 0.0408 }, { 60.0, 0.0204 }, { 75.0, 0.0087 } };

    (void)state;
    for (int i = 0; i < 3; i++) {
        const double angle = ways[i].degrees / 57.29577951308232;
        char text[1024];
        double found;

        snprintf(text, sizeof text, SCENE("subsurface { }") "box { <-90,-90,0>, <90,90,60> pigment { rgb .7 } interior { ior 1.001 }"
                 "finish { ambient 0 diffuse 1 subsurface { translucency 1 } } }"
                 "light_source { <%g,0,%g> rgb 1 parallel point_at 0 }", 1000.0 * sin(angle), -1000.0 * cos(angle));
        found = mean_of(text) / cos(angle) - 0.7;
        if (!(fabs(found - ways[i].more) < 0.0015))
            fail_msg("%g instead of %g at %g degrees", found, ways[i].more, ways[i].degrees);
    }
}

/* What POV-Ray 3.7 shows through a plate, as thick as a translucency of 1, of a background of 1: what is neither scattered nor absorbed. */
static void light_goes_straight_through_without_being_scattered(void **state)
{
    static const struct { const char *plate; double given; } plates[] = {
        { "finish { ambient 0 diffuse 1 subsurface { translucency 1 } }", 0.3679 },
        { "finish { ambient 0 diffuse .5 subsurface { translucency 1 } }", 0.3473 },
        { "finish { ambient 0 diffuse 1 subsurface { translucency 1 } } interior { ior 1.5 } rotate 60*y", 0.2938 },
        { "finish { ambient 0 diffuse 0 subsurface { translucency 1 } }", 0.0 },
        { "finish { ambient 0 diffuse 1 subsurface { translucency 1 } } pigment { onion color_map { [0 rgb 1] [1 rgb 1] } }", 0.3679 },
        { "texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 subsurface { translucency 1 } } }"
          "texture { pigment { rgbt <1, 1, 1, 1> } finish { ambient 0 } }", 0.3679 },
        { "finish { ambient 0 diffuse 1 subsurface { translucency 1 } } } box { <-9, -9, .03>, <9, 9, .06> pigment { rgb 1 }", 0.0 },
    };

    (void)state;
    for (size_t i = 0; i < sizeof plates / sizeof plates[0]; i++) {
        char text[1024];
        double found;

        snprintf(text, sizeof text, SCENE("subsurface { }") "background { rgb 1 } box { <-30,-30,0>, <30,30,.1> pigment { rgb 1 } %s }",
                 plates[i].plate);
        found = mean_of(text);
        if (!(fabs(found - plates[i].given) < 1e-4))
            fail_msg("%g instead of %g: %s", found, plates[i].given, plates[i].plate);
    }
}

static void without_the_setting_light_is_diffuse(void **state)
{
    const double found = mean_of(SCENE("") "box { <-90,-90,0>, <90,90,60> pigment { rgb 1 } interior { ior 1.3 }"
                                 "finish { ambient 0 diffuse .7 subsurface { translucency 1 } } }"
                                 "light_source { <0,0,-1000> rgb 1 parallel point_at 0 }");

    (void)state;
    assert_true(fabs(found - 0.7) < 1e-6);
}

/* Light that enters where a line leaves the solid is seen from outside, whatever the shape and also where it cuts another. */
static void one_solid_is_lit_alike_by_any_shape(void **state)
{
#define ISO "isosurface { function { x*x + y*y + z*z - 1 } max_gradient 3 contained_by { box { -1.1, 1.1 } }"
    static const char *const pairs[][2] = {
        { "sphere { 0, 1", ISO },
        { "sphere { 0, 1", "superellipsoid { <1, 1>" },
        { "difference { sphere { 0, 1.2 } sphere { 0, 1 }", "difference { sphere { 0, 1.2 } " ISO " }" },
        { "difference { sphere { 0, 1 } box { <-2,0,-2>, 2 }", "difference { " ISO " } box { <-2,0,-2>, 2 }" },
    };
    static const char scene[] = SCENE("subsurface { }") "%s pigment { rgb .8 } interior { ior 1.3 }"
                                "finish { ambient 0 subsurface { translucency 2 } } } light_source { <300,300,-100> rgb 1 }";

    (void)state;
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        char text[2][1024];
        double found[2];

        for (int k = 0; k < 2; k++) {
            snprintf(text[k], sizeof text[k], scene, pairs[i][k]);
            found[k] = mean_of(text[k]);
        }
        if (!(fabs(found[1] / found[0] - 1.0) < 0.002))
            fail_msg("%g instead of %g: %s", found[1], found[0], pairs[i][1]);
    }
#undef ISO
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_albedo_gives_what_it_was_solved_for),
        cmocka_unit_test(even_light_gives_the_albedo),
        cmocka_unit_test(even_light_has_little_noise),
        cmocka_unit_test(a_plate_lets_light_through),
        cmocka_unit_test(faces_give_what_enters_near_by),
        cmocka_unit_test(dark_faces_give_what_enters_nearer_by),
        cmocka_unit_test(light_scattered_once_depends_on_where_it_comes_from),
        cmocka_unit_test(light_goes_straight_through_without_being_scattered),
        cmocka_unit_test(without_the_setting_light_is_diffuse),
        cmocka_unit_test(one_solid_is_lit_alike_by_any_shape),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
