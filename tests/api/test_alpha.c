/* Pictures with alpha: what POV-Ray 3.7 writes with Output_Alpha. */
#include "support/check.h"
#include "support/near.h"
#include "support/scenes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 9, HEIGHT = 7 };

typedef struct bytes_kept { unsigned char data[64]; size_t count; } bytes_kept;

#define SPHERE(pigment) "sphere { 0, 1.2 pigment { " pigment " } finish { ambient 1 diffuse 0 } } "
#define GLASS SPHERE("rgbft <.8, .5, .2, .3, .2>")

/* The picture of a scene, seen along z, four numbers a pixel. */
static float *draw(const char *head, const char *body, int samples)
{
    pov_render_desc desc = POV_INIT(desc);
    char text[1024];

    snprintf(text, sizeof text, "%s camera { orthographic location <0,0,-10> right 4*x up 3*y }\n%s", head, body);
    desc.width = WIDTH;
    desc.height = HEIGHT;
    desc.samples = samples;
    desc.alpha = 1;
    return scenes_draw_as(text, &desc);
}

#define NEW "#version 3.7; global_settings { assumed_gamma 1 } "

static float *pixel(float *picture, int x, int y) { return picture + 4 * (WIDTH * y + x); }

static void assert_pixel(const float *seen, double red, double green, double blue, double alpha)
{
    const double wanted[4] = { red, green, blue, alpha };

    for (int i = 0; i < 4; i++)
        if (fabs((double)seen[i] - wanted[i]) > 2e-6)
            fail_msg("channel %d is %f, not %f", i, (double)seen[i], wanted[i]);
}

static void assert_corner(const char *head, const char *body, double red, double green, double blue, double alpha)
{
    float *picture = draw(head, body, 0);

    assert_pixel(picture, red, green, blue, alpha);
    free(picture);
}

static void assert_middle(const char *head, const char *body, double red, double green, double blue, double alpha)
{
    float *picture = draw(head, body, 0);

    assert_pixel(pixel(picture, WIDTH / 2, HEIGHT / 2), red, green, blue, alpha);
    free(picture);
}

static double grey(double r, double g, double b) { return 0.297 * r + 0.589 * g + 0.114 * b; }

/* Each surface lets through the grey of its colour. */
static void clear_solids_hide_by_the_grey_of_their_surfaces(void **state)
{
    const double through = grey(0.44, 0.35, 0.26);

    (void)state;
    assert_corner(NEW, GLASS, 0.0, 0.0, 0.0, 0.0);
    assert_middle(NEW, GLASS, 0.5 * 0.8 * 1.44, 0.5 * 0.5 * 1.35, 0.5 * 0.2 * 1.26, 1.0 - through * through);
    assert_middle(NEW, SPHERE("rgb <1, 2, .5>"), 1.0, 2.0, 0.5, 1.0);
}

static void backgrounds_hide_by_what_they_let_through(void **state)
{
    static const char behind[] = "background { rgbft <.5, .6, .7, .2, .3> }";

    (void)state;
    assert_corner(NEW, behind, 0.25, 0.3, 0.35, 1.0 - grey(0.4, 0.42, 0.44));
    assert_corner(NEW, "background { rgb <.5, .6, .7> }", 0.5, 0.6, 0.7, 1.0);
    assert_corner("#version 3.6; ", "background { rgb <.5, .6, .7> }", 0.0, 0.0, 0.0, 0.0);
}

/* A sky's colours count before the grey is taken. */
static void skies_hide_by_what_they_let_through(void **state)
{
    static const char sky[] = "background { rgbft <.5, .6, .7, .2, .3> } sky_sphere { pigment { rgbft <.2, .4, .9, .5, .2> } }";

    (void)state;
    assert_corner(NEW, sky, 0.06 + 0.3 * 0.25, 0.12 + 0.4 * 0.3, 0.27 + 0.65 * 0.35, 1.0 - grey(0.3 * 0.4, 0.4 * 0.42, 0.65 * 0.44));
    assert_corner("#version 3.6; ", sky, 0.0, 0.0, 0.0, 0.0);
}

static void mirrors_are_opaque_and_see_the_plain_background(void **state)
{
    static const char mirror[] = "background { rgbft <.5, .6, .7, .2, .3> }"
                                 "plane { z, 0 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }";

    (void)state;
    assert_middle(NEW, mirror, 0.5, 0.6, 0.7, 1.0);
}

static void fog_hides_by_the_grey_of_what_it_lets_through(void **state)
{
    (void)state;
    assert_corner(NEW, "fog { distance 6 rgbft <.2, .8, .4, .5, .3> }", 0.2 * 0.7, 0.8 * 0.7, 0.4 * 0.7,
                  1.0 - grey(0.3 * 0.6, 0.3 * 0.9, 0.3 * 0.7));
}

/* What light loses in a solid hides as well, and glass that disperses hides all. */
static void solids_hide_by_what_they_fade_and_disperse(void **state)
{
    static const char box[] = "box { <-2, -2, 0>, <2, 2, 1> pigment { rgbt <1, 1, 1, .9> } finish { ambient 0 diffuse 0 } interior { %s } }";
    char body[256];

    (void)state;
    snprintf(body, sizeof body, box, "fade_distance 1 fade_power 1 fade_color <0, .5, 1>");
    assert_middle(NEW, body, 0.0, 0.0, 0.0, 1.0 - 0.81 * grey(0.5, 0.75, 1.0));
    snprintf(body, sizeof body, box, "ior 1.5 dispersion 1.1");
    assert_middle(NEW, body, 0.0, 0.0, 0.0, 1.0);
}

/* Half of the pixels of one column are covered. */
static void alpha_is_the_mean_of_the_samples(void **state)
{
    float *picture = draw(NEW, "box { <0, -9, 0>, <9, 9, 1> pigment { rgb <.5, 1, .25> } finish { ambient 1 diffuse 0 } }", 256);
    const float *edge = pixel(picture, WIDTH / 2, 3);

    (void)state;
    assert_pixel(pixel(picture, 0, 3), 0.0, 0.0, 0.0, 0.0);
    assert_pixel(pixel(picture, WIDTH - 1, 3), 0.5, 1.0, 0.25, 1.0);
    assert_true(fabsf(edge[3] - 0.5f) < 0.01f);
    assert_pixel(edge, 0.5 * (double)edge[3], (double)edge[3], 0.25 * (double)edge[3], (double)edge[3]);
    free(picture);
}

/* A gamma of the scene acts on the opaque colour. */
static void colours_are_decoded_as_if_they_were_opaque(void **state)
{
    static const char half[] = SPHERE("rgbt <.5, 1, .25, .5>") "plane { -z, -5 pigment { rgb 0 } no_image }";

    (void)state;
    assert_middle("#version 3.7; global_settings { assumed_gamma 2 } ", half, 0.75 * 0.25, 0.75, 0.75 * 0.0625, 0.75);
}

static void nothing_is_outside_of_a_round_picture(void **state)
{
    (void)state;
    assert_corner(NEW, "background { rgb 1 } camera { fisheye location -10*z right x up y }", 0.0, 0.0, 0.0, 0.0);
}

static bool keep(void *user, const void *bytes, size_t count)
{
    bytes_kept *k = user;

    if (k->count + count > sizeof k->data)
        return false;
    memcpy(k->data + k->count, bytes, count);
    k->count += count;
    return true;
}

/* POV-Ray 3.7.0.10, +UA +FN16, rgbt colours without light: red, green, blue and alpha of the file. 8 bits of them. */
static void what_is_brighter_than_opaque_is_made_opaque(void **state)
{
    static const struct { float rgb[3], transmit, file[4]; } rows[] = {
        { { 3, .5f, .25f }, .6f, { 1, .674f, .4911f, .4856f } }, { { 1, 1, 1 }, .6f, { 1, 1, 1, .4f } },
        { { 1.2f, 1.1f, 1 }, .5f, { 1, .9928f, .952f, .5592f } }, { { 0, 0, 9 }, .7f, { 0, 0, 1, .3078f } },
        { { 5, 5, 5 }, .9f, { 1, 1, 1, .5f } }, { { 1.5f, .2f, .2f }, .5f, { 1, .4845f, .4845f, .5f } },
        { { 3, .5f, .25f }, 0, { 1, .7354f, .5371f, 1 } }, { { 3, .5f, .25f }, 1, { 0, 0, 0, 0 } },
    };
    pov_image_options options = POV_INIT(options);
    pov_context *context = scenes_context();
    pov_error err;

    (void)state;
    options.alpha = 1;
    options.format = "tga";
    options.transfer = POV_TRANSFER_SRGB;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        static const int places[4] = { 20, 19, 18, 21 };   /* behind the header of 18 bytes: blue, green, red, alpha */
        float rgba[4] = { 0, 0, 0, 1.0f - rows[i].transmit };
        bytes_kept kept = { { 0 }, 0 };
        const pov_output to = { &kept, keep };

        for (int c = 0; c < 3; c++)
            rgba[c] = rows[i].rgb[c] * rgba[3];
        assert_int_equal(pov_image_put(context, &to, 1, 1, rgba, sizeof rgba, &options, &err), POV_OK);
        for (int c = 0; c < 4; c++)
            assert_true(fabs(kept.data[places[c]] - 255.0 * (double)rows[i].file[c]) < 1.0);
    }
    pov_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clear_solids_hide_by_the_grey_of_their_surfaces),
        cmocka_unit_test(backgrounds_hide_by_what_they_let_through),
        cmocka_unit_test(skies_hide_by_what_they_let_through),
        cmocka_unit_test(mirrors_are_opaque_and_see_the_plain_background),
        cmocka_unit_test(solids_hide_by_what_they_fade_and_disperse),
        cmocka_unit_test(fog_hides_by_the_grey_of_what_it_lets_through),
        cmocka_unit_test(alpha_is_the_mean_of_the_samples),
        cmocka_unit_test(colours_are_decoded_as_if_they_were_opaque),
        cmocka_unit_test(nothing_is_outside_of_a_round_picture),
        cmocka_unit_test(what_is_brighter_than_opaque_is_made_opaque),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
