/* Textures made of textures: layers, maps, lists and averages, as terms at points. */
#include "support/check.h"
#include "support/reading.h"

#include "texture/texture.h"

#include <stdio.h>
#include <string.h>

enum { TERMS_MAX = 64 };

static void read_text(reading *r, const char *text)
{
    reading_begin(r, text);
    if (r->status != POV_OK)
        fail_msg("%s: %d:%d %s", text, r->error.line, r->error.column, r->error.message);
}

static const material *material_of(const reading *r, size_t leaf)
{
    return &r->model.materials.items[r->model.leaves.items[leaf].material];
}

/* The terms of a leaf's texture at points along x, which have the same y and z. */
static uint32_t terms_beside(const reading *r, uint32_t leaf, const double *x, double y, uint32_t n, texture_term *out)
{
    const pov_vec3 zero = pov_vec3_of(0, 0, 0);
    const texture *of = material_of(r, leaf)->texture;
    texture_points points;
    inverse_map space;

    memset(&points, 0, sizeof points);
    for (uint32_t i = 0; i < n; i++)
        texture_point(&points, i, pov_vec3_of(x[i], y, y), zero);
    texture_points_map(model_texture_map(&r->model, leaf, &space), 0, n, &points);
    assert_non_null(of);
    return texture_eval(&r->model, of, &points, n, out);
}

static uint32_t terms_at(const reading *r, uint32_t leaf, const double *x, uint32_t n, texture_term *out)
{
    return terms_beside(r, leaf, x, 0.25, n, out);
}

static void assert_term(const texture_term *t, bool first, double share, double r, double g, double b)
{
    assert_int_equal(t->first, first);
    assert_true(fabs((double)t->share - share) < 1e-6);
    assert_true(fabs((double)t->pigment.color.r - r) < 1e-6 && fabs((double)t->pigment.color.g - g) < 1e-6 &&
                fabs((double)t->pigment.color.b - b) < 1e-6);
}

static const char layered[] =
    "#version 3.7; #declare Two = texture { pigment { rgbt <1, 0, 0, .5> } finish { phong 1 } } texture { pigment { rgbf <0, 1, 0, .5> } }\n"
    "sphere { 0, 1 texture { Two } texture { pigment { rgbt <0, 0, 1, .5> } finish { ambient 0 } } }";

static void layers_follow_one_another_from_the_top(void **state)
{
    const double x = 0.25;
    texture_term t[TERMS_MAX];
    reading r;

    (void)state;
    read_text(&r, layered);
    assert_int_equal(texture_most_terms(material_of(&r, 0)->texture), 3);
    assert_int_equal(terms_at(&r, 0, &x, 1, t), 3);
    assert_term(&t[0], true, 1, 0, 0, 1);
    assert_term(&t[1], false, 1, 0, 1, 0);
    assert_term(&t[2], false, 1, 1, 0, 0);
    assert_true(t[0].finish->ambient.r == 0.0f && t[1].finish->phong == 0.0f && t[2].finish->phong == 1.0f);
    /* What a scene needs is told by the most of each. */
    assert_true(material_of(&r, 0)->finish.phong == 1.0f && material_is_transparent(material_of(&r, 0)));
    reading_end(&r);
}

static void an_opaque_layer_hides_what_is_below(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; sphere { 0, 1 texture { pigment { rgbt <1, 0, 0, .5> } } texture { pigment { rgb y } } }\n"
                  "sphere { 0, 1 pigment { rgb x } texture { pigment { checker rgb y, rgb 1 } } texture { pigment { rgbt .5 } } }");
    assert_null(material_of(&r, 0)->texture);
    assert_true(material_of(&r, 0)->pigment.g == 1.0f && !material_is_transparent(material_of(&r, 0)));
    assert_int_equal(material_of(&r, 1)->texture->blend, BLEND_LAYERS);
    assert_int_equal(material_of(&r, 1)->texture->count, 2);
    reading_end(&r);
}

static void a_map_of_textures_gives_shares_of_two(void **state)
{
    static const double x[] = { 0.1, 0.25, 0.5, 0.875 };
    texture_term t[TERMS_MAX];
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; #declare Red = texture { pigment { rgb x } } sphere { 0, 1 texture { gradient x frequency 0\n"
                  "texture_map { [.125 Red] [.5 pigment { rgb y }] [.75 texture { pigment { rgb z } }] } } }");
    assert_int_equal(texture_most_terms(material_of(&r, 0)->texture), 2);
    assert_int_equal(terms_at(&r, 0, &x[0], 1, t), 1);
    assert_term(&t[0], true, 1, 1, 0, 0);
    assert_int_equal(terms_at(&r, 0, &x[1], 1, t), 2);
    assert_term(&t[0], true, 2.0 / 3.0, 1, 0, 0);
    assert_term(&t[1], true, 1.0 / 3.0, 0, 1, 0);
    assert_int_equal(terms_at(&r, 0, &x[2], 1, t), 1);
    assert_term(&t[0], true, 1, 0, 1, 0);
    assert_int_equal(terms_at(&r, 0, &x[3], 1, t), 1);
    assert_term(&t[0], true, 1, 0, 0, 1);
    reading_end(&r);
}

static void an_average_has_shares_by_weight(void **state)
{
    const double x = 0.0;
    texture_term t[TERMS_MAX];
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; sphere { 0, 1 texture { average texture_map { [1 pigment { rgb x }] [3 pigment { rgb y }] } } }\n"
                  "sphere { 0, 1 pigment { average pigment_map { [rgb 1] [rgb 0] } } }");
    assert_int_equal(texture_most_terms(material_of(&r, 0)->texture), 2);
    assert_int_equal(terms_at(&r, 0, &x, 1, t), 2);
    assert_term(&t[0], true, 0.25, 1, 0, 0);
    assert_term(&t[1], true, 0.75, 0, 1, 0);
    assert_int_equal(terms_at(&r, 1, &x, 1, t), 1);
    assert_term(&t[0], true, 1, 0.5, 0.5, 0.5);
    reading_end(&r);
}

#define OF_FUNCTIONS \
    "#declare F = function { pigment { bozo turbulence .4 color_map { [0 rgb <.1, .9, .4>] [1 rgb <.8, .2, .7>] } } }\n" \
    "#declare G = function { pigment { granite color_map { [0 rgb <.3, .1, .6>] [1 rgb <.5, .8, .2>] } scale .3 } }\n" \
    "#declare H = function { pattern { agate } }\n" \
    "#declare A = pigment { function { pow(F(x, y, z).x, 1.5) } color_map { [0 rgb 0] [1 rgb <3, 0, 0>] } }\n" \
    "#declare B = pigment { function { F(x, y, z).y * F(y, x, z).z } color_map { [0 rgb 0] [1 rgb <0, 3, 0>] } }\n" \
    "#declare C = pigment { function { F(x, y, z).z + .1 * G(z, x, y).x * H(x, y, z) } color_map { [0 rgb 0] [1 rgb <0, 0, 3>] } }\n" \
    "#declare D = pigment { function { G(x, y, z).y * G(2 * x, y, z).x } color_map { [0 rgb 0] [1 rgb <0, 1, 3>] } translate x * .3 }\n"

/* Members that ask one pigment for its components, and others, of the same points and of others: each has what it has by itself. */
static void members_of_an_average_ask_functions_as_if_alone(void **state)
{
    enum { POINTS = 41, MEMBERS = 4 };
    texture_term all[POINTS], own[POINTS];
    colour sum[POINTS] = { { 0.0f, 0.0f, 0.0f } };
    double x[POINTS];
    reading r;

    (void)state;
    read_text(&r, "#version 3.7;" OF_FUNCTIONS "sphere { 0, 1 pigment { average pigment_map { [1 A] [1 B] [1 C] [1 D] } } }\n"
                  "sphere { 0, 1 pigment { A } } sphere { 0, 1 pigment { B } } sphere { 0, 1 pigment { C } } sphere { 0, 1 pigment { D } }");
    for (uint32_t i = 0; i < POINTS; i++)
        x[i] = 0.137 * (i % 23);
    assert_int_equal(terms_at(&r, 0, x, POINTS, all), POINTS);
    for (uint32_t k = 0; k < MEMBERS; k++) {
        assert_int_equal(terms_at(&r, 1 + k, x, POINTS, own), POINTS);
        for (uint32_t i = 0; i < POINTS; i++)
            sum[i] = colour_add(sum[i], colour_scale(own[i].pigment.color, 0.25f));
    }
    for (uint32_t i = 0; i < POINTS; i++)
        assert_memory_equal(&all[i].pigment.color, &sum[i], sizeof sum[i]);
    reading_end(&r);
}

/* tile2 has the odd cells. */
static void lists_of_textures_select_one(void **state)
{
    static const double x[] = { 0.5, 1.5 };
    texture_term t[TERMS_MAX];
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; sphere { 0, 1 texture { checker texture { pigment { rgb x } } texture { pigment { rgb y } } } }\n"
                  "sphere { 0, 1 texture { tiles { texture { pigment { rgb x } } tile2 texture { pigment { rgb y } } } } }");
    assert_int_equal(terms_at(&r, 0, x, 2, t), 2);
    assert_term(&t[0], true, 1, 1, 0, 0);
    assert_term(&t[1], true, 1, 0, 1, 0);
    assert_int_equal(terms_at(&r, 1, x, 2, t), 2);
    assert_true(t[0].lane == 0 && t[1].lane == 1 ? t[0].pigment.color.g == 1.0f : t[1].pigment.color.g == 1.0f);
    reading_end(&r);
}

/* Beside others a point has the same terms in the same order, bit for bit. */
static void a_point_has_the_same_terms_alone_and_beside_others(void **state)
{
    enum { MOST = 16 };
    static texture_term all[LANES_MAX * MOST], one[MOST];
    double x[LANES_MAX];
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; #declare Lays = texture { pigment { crackle } } texture { pigment { bozo color_map { [0 rgbt 1] [1 rgb x] } } }\n"
                  "sphere { 0, 1 texture { gradient x texture_map { [0 Lays] [.4 average texture_map { [1 Lays scale .3] [2 pigment { cells }] }]\n"
                  "[1 checker texture { pigment { rgb 1 } } texture { Lays } scale .1] } turbulence .4 scale 3 } }");
    assert_true(texture_most_terms(material_of(&r, 0)->texture) <= MOST);
    for (uint32_t i = 0; i < LANES_MAX; i++)
        x[i] = 0.173 * i - 4.0;
    const uint32_t count = terms_at(&r, 0, x, LANES_MAX, all);
    for (uint32_t i = 0; i < LANES_MAX; i++) {
        const uint32_t own = terms_at(&r, 0, &x[i], 1, one);
        uint32_t k = 0;

        for (uint32_t j = 0; j < count; j++) {
            if (all[j].lane != i)
                continue;
            assert_true(k < own && all[j].first == one[k].first && all[j].share == one[k].share);
            assert_memory_equal(&all[j].pigment, &one[k].pigment, sizeof one[k].pigment);
            assert_ptr_equal(all[j].finish, one[k].finish);
            k++;
        }
        assert_int_equal(k, own);
    }
    reading_end(&r);
}

static void equal_textures_are_one(void **state)
{
    reading r;

    (void)state;
    read_text(&r, "#version 3.7; #declare T = texture { pigment { marble turbulence .5 scale 2 } normal { bumps .2 } }\n"
                  "#declare I = 0; #while (I < 500) sphere { I, 1 texture { T rotate y*30 } }\n"
                  "sphere { I, 1 texture { pigment { marble turbulence .5 scale 2 rotate y*30 } normal { bumps .2 rotate y*30 } } }\n"
                  "box { I, I + 1 texture { pigment { bozo color_map { [0 rgb 0] [1 rgb x] } } } } #declare I = I + 1; #end");
    assert_int_equal(r.model.leaves.count, 1500);
    assert_int_equal(r.model.materials.count, 2);
    assert_int_equal(r.model.kept_maps.count, 2);
    reading_end(&r);
}

/* Textures far from the origin and of any size are what they are near it, bit for bit. */
static void a_moved_and_scaled_texture_is_the_same(void **state)
{
    static const struct { const char *moves; double scale, move; } cases[] = {
        { "scale pow(2, -332)", 0x1p-332, 0 },
        { "translate x*pow(2, 30)", 1, 0x1p30 },
        { "scale pow(2, -332) translate x*pow(2, -302)", 0x1p-332, 0x1p-302 },
        { "translate x*pow(2, 30) scale pow(2, 300)", 0x1p300, 0x1p330 },
    };
    enum { POINTS = 16 };
    char text[1024];
    (void)state;

    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        texture_term near[TERMS_MAX], far[TERMS_MAX];
        double x[POINTS], there[POINTS];
        uint32_t count;
        reading r;

        snprintf(text, sizeof text, "#version 3.7; #declare T = texture { gradient x texture_map { [0 pigment { crackle scale .3 turbulence .2 }]\n"
                 "[1 pigment { wood warp { repeat y*.4 flip x } rotate 40 }] } scale 1.5 rotate z*20 };\n"
                 "sphere { 0, 1 texture { T } } sphere { 0, 1 texture { T } %s translate 0 rotate 0 }", cases[k].moves);
        read_text(&r, text);
        for (uint32_t i = 0; i < POINTS; i++) {
            x[i] = 0.203125 * i - 1.5;
            there[i] = x[i] * cases[k].scale + cases[k].move;
        }
        count = terms_beside(&r, 0, x, 0.25, POINTS, near);
        assert_int_equal(terms_beside(&r, 1, there, 0.25 * cases[k].scale, POINTS, far), count);
        for (uint32_t i = 0; i < count; i++) {
            assert_true(near[i].share == far[i].share && near[i].lane == far[i].lane);
            assert_memory_equal(&near[i].pigment, &far[i].pigment, sizeof near[i].pigment);
        }
        reading_end(&r);
    }
}

/* Light that crosses is filtered by all layers, and by the mean of a map's members. */
static void filters_are_products_of_layers_and_means_of_members(void **state)
{
    const pov_vec3 zero = pov_vec3_of(0, 0, 0);
    texture_points points;
    colour by;
    reading r;

    (void)state;
    memset(&points, 0, sizeof points);
    texture_point(&points, 0, pov_vec3_of(0.25, 0, 0), zero);
    read_text(&r, "#version 3.7; sphere { 0, 1 pigment { rgbf <1, .5, 0, 1> } texture { pigment { rgbft <.5, 1, 1, .5, .25> } } }\n"
                  "sphere { 0, 1 texture { gradient x texture_map { [0 pigment { rgbf <1, 1, 0, 1> }] [1 pigment { rgb 1 }] } } }");
    texture_filters(&r.model, material_of(&r, 0)->texture, &points, 1, &by);
    assert_true(by.r == 0.5f && by.g == 0.375f && by.b == 0.0f);
    texture_filters(&r.model, material_of(&r, 1)->texture, &points, 1, &by);
    assert_true(by.r == 0.75f && by.g == 0.75f && by.b == 0.0f);
    reading_end(&r);
}

/* POV-Ray's pictures: a layer upon another loses the colour of its filter where the version is below 3.5, for good, and
 * whatever the version of the whole scene is. Images keep theirs. */
static void layers_are_colourless_if_laid_before_version_3_5(void **state)
{
#define BELOW "pigment { rgbf <1, .5, 0, 1> }"
#define ABOVE "rgbft <.5, 1, 1, .5, .25>"
    static const struct { const char *text; float r, g; } cases[] = {
        { "#version 3.1; sphere { 0, 1 " BELOW " texture { pigment { " ABOVE " } } }", .75f, .375f },
        { "#version 3.1; sphere { 0, 1 " BELOW " texture { pigment { " ABOVE " } } } #version 3.7;", .75f, .375f },
        { "#version 3.7; sphere { 0, 1 " BELOW " texture { pigment { " ABOVE " } } } #version 3.1;", .5f, .375f },
        { "#version 3.5; sphere { 0, 1 " BELOW " texture { pigment { " ABOVE " } } }", .5f, .375f },
        { "#version 3.1; #declare T = texture { " BELOW " } texture { pigment { " ABOVE " } }\n#version 3.7;"
          "sphere { 0, 1 texture { T } }", .75f, .375f },
        { "#version 3.7; #declare T = texture { " BELOW " } texture { pigment { " ABOVE " } }\n#version 3.1;"
          "sphere { 0, 1 texture { T } }", .75f, .375f },
        { "#version 3.1; #declare T = texture { pigment { " ABOVE " } }\n#version 3.7;"
          "sphere { 0, 1 texture { " BELOW " } texture { T } }", .5f, .375f },
        { "#version 3.1; sphere { 0, 1 " BELOW " texture { pigment { gradient x pigment_map { [0 " ABOVE "] [1 gradient x "
          "color_map { [0 " ABOVE "] [1 " ABOVE "] }] } } } }", .75f, .375f },
        { "#version 3.1; sphere { 0, 1 " BELOW " texture { pigment { image_map { function 2, 2 { pigment { rgb <.5, 1, 1> } } "
          "filter all .5 transmit all .25 } } } }", .5f, .375f },
    };
#undef BELOW
#undef ABOVE
    const pov_vec3 zero = pov_vec3_of(0, 0, 0);
    texture_points points;

    (void)state;
    memset(&points, 0, sizeof points);
    texture_point(&points, 0, pov_vec3_of(0.25, 0.25, 0), zero);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        reading r;
        colour by;

        read_text(&r, cases[i].text);
        texture_filters(&r.model, material_of(&r, 0)->texture, &points, 1, &by);
        if (!(fabsf(by.r - cases[i].r) < 1e-3f && fabsf(by.g - cases[i].g) < 1e-3f && by.b == 0.0f))
            fail_msg("%s: <%g, %g, %g>", cases[i].text, (double)by.r, (double)by.g, (double)by.b);
        reading_end(&r);
    }
}

static void wrong_textures_are_refused(void **state)
{
    static const struct { const char *text, *message; } cases[] = {
        { "sphere { 0, 1 texture { gradient x texture_map { [0 pigment { rgb 1 }] } } texture { pigment { rgbt 1 } } }",
          "no texture can lie upon a patterned one" },
        { "sphere { 0, 1 pigment { rgb 1 } texture { gradient x texture_map { [0 pigment { rgbt 1 }] } } }",
          "a patterned texture cannot lie upon another" },
        { "sphere { 0, 1 texture { checker texture { pigment { rgb 1 } } texture { } pigment { rgb 1 } } }",
          "\"pigment\" has no place beside a pattern of textures" },
        { "sphere { 0, 1 pigment { noise_generator 4 } }", "\"noise_generator\" must be 1, 2 or 3" },
        { "sphere { 0, 1 texture { tiles { texture { } } } }",
          "expected \"tile2\" and \"texture\" after \"}\", found \"}\"" },
    };
    (void)state;

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        reading r;

        reading_begin(&r, cases[i].text);
        assert_int_equal(r.status, POV_E_SYNTAX);
        assert_string_equal(r.error.message, cases[i].message);
        reading_end(&r);
    }
}

static void slopes_begin_again_before_their_waves_are_made(void **state)
{
    const pov_vec3 zero = pov_vec3_of(0, 0, 0), up = pov_vec3_of(0, 1, 0);
    static const struct { const char *slope; double value; } cases[] = { { "y, 0, .4", .125 }, { "-y, .7, .9", .125 }, { "y", .25 },
                                                                          { "point_at <0, 9, 0>, 0, .4", .125 } };
    char text[256];
    (void)state;

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        texture_points points;
        texture_term t[TERMS_MAX];
        reading r;

        snprintf(text, sizeof text, "#version 3.7; sphere { 0, 1 pigment { slope { %s } frequency .25 color_map { [0 rgb 0] [1 rgb 1] } } }",
                 cases[i].slope);
        read_text(&r, text);
        memset(&points, 0, sizeof points);
        texture_point(&points, 0, zero, zero);
        points.has_surface = true;
        lanes_put(&points.normal, 0, up);
        assert_int_equal(texture_eval(&r.model, material_of(&r, 0)->texture, &points, 1, t), 1);
        assert_term(t, true, 1.0, cases[i].value, cases[i].value, cases[i].value);
        reading_end(&r);
    }
}

static void a_slope_has_a_direction_or_a_place(void **state)
{
    static const char *texts[] = { "y point_at x", "point_at x altitude y" };
    char text[256];
    (void)state;

    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        reading r;

        snprintf(text, sizeof text, "#version 3.7; sphere { 0, 1 pigment { slope { %s } } }", texts[i]);
        reading_begin(&r, text);
        assert_non_null(strstr(r.error.message, "point_at takes the place"));
        reading_end(&r);
    }
}

/* What the last term of a texture shows at a point whose normal is z. */
static float last_shown(const char *text)
{
    const pov_vec3 zero = pov_vec3_of(0, 0, 0);
    static texture_points points;
    texture_term t[TERMS_MAX];
    char scene[512];
    uint32_t last = 0, count;
    reading r;

    snprintf(scene, sizeof scene, "#version 3.7; #declare A = pigment { slope y } #declare B = normal { bumps 2 }\n"
                                  "sphere { 0, 1 %s }", text);
    read_text(&r, scene);
    memset(&points, 0, sizeof points);
    texture_point(&points, 0, pov_vec3_of(.3, .2, .4), zero);
    points.has_surface = true;
    lanes_put(&points.normal, 0, pov_vec3_of(0, 0, 1));
    count = texture_eval(&r.model, material_of(&r, 0)->texture, &points, 1, t);
    for (uint32_t i = 0; i < count; i++)
        last = !t[i].bent ? i : last;
    reading_end(&r);
    return t[last].pigment.color.r;
}

/* Measured by pictures: in POV-Ray slope and aoi see the normal that was bent last, in a layer above, in a member of an average
 * before them, or in the upper entry of a map. */
static void slopes_see_the_normal_that_was_bent_last(void **state)
{
    const float own = last_shown("texture { pigment { A } normal { B } }"), flat = last_shown("texture { pigment { A } }");
    (void)state;

    assert_true(own != flat);
    assert_true(last_shown("texture { pigment { A } } texture { pigment { rgbt .5 } normal { B } }") == own);
    assert_true(last_shown("texture { average texture_map { [1 pigment { rgb 0 } normal { B }] [1 pigment { A }] } }") == own);
    assert_true(last_shown("texture { average texture_map { [1 pigment { A }] [1 pigment { rgb 0 } normal { B }] } }") == flat);
    assert_true(last_shown("texture { gradient x texture_map { [0 pigment { A }] [1 pigment { rgb 0 } normal { B }] } }") == own);
    assert_true(last_shown("texture { gradient x texture_map { [0 pigment { rgb 0 } normal { B }] [1 pigment { A }] } }") == flat);
}

/* Points of one cube are measured together, as many as there is room for. */
static void crackle_gives_points_of_a_cube_what_it_gives_each(void **state)
{
    static const char *const kinds[] = { "", "form <.2, .4, .1>", "metric 3", "metric .5", "metric .5 form <1, -.5, .2> offset .1", "metric 1", "solid",
                                         "solid metric 3" };
    (void)state;

    for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
        static texture_term all[LANES_MAX], one;
        double x[LANES_MAX];
        char text[256];
        reading r;

        snprintf(text, sizeof text, "#version 3.7; sphere { 0, 1 pigment { crackle %s color_map { [0 rgb 0] [1 rgb 1] } } }", kinds[k]);
        read_text(&r, text);
        for (uint32_t i = 0; i < LANES_MAX; i++)
            x[i] = i < 50 ? 0.01 + 0.017 * i : 3.3 - 0.4 * i;
        assert_int_equal(terms_beside(&r, 0, x, 0.4, LANES_MAX, all), LANES_MAX);
        for (uint32_t i = 0; i < LANES_MAX; i++) {
            assert_int_equal(terms_beside(&r, 0, &x[i], 0.4, 1, &one), 1);
            assert_memory_equal(&one.pigment, &all[i].pigment, sizeof one.pigment);
        }
        assert_memory_not_equal(&all[0].pigment, &all[49].pigment, sizeof one.pigment);
        reading_end(&r);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slopes_see_the_normal_that_was_bent_last),
        cmocka_unit_test(slopes_begin_again_before_their_waves_are_made),
        cmocka_unit_test(a_slope_has_a_direction_or_a_place),
        cmocka_unit_test(layers_follow_one_another_from_the_top),
        cmocka_unit_test(an_opaque_layer_hides_what_is_below),
        cmocka_unit_test(a_map_of_textures_gives_shares_of_two),
        cmocka_unit_test(an_average_has_shares_by_weight),
        cmocka_unit_test(members_of_an_average_ask_functions_as_if_alone),
        cmocka_unit_test(lists_of_textures_select_one),
        cmocka_unit_test(a_point_has_the_same_terms_alone_and_beside_others),
        cmocka_unit_test(equal_textures_are_one),
        cmocka_unit_test(a_moved_and_scaled_texture_is_the_same),
        cmocka_unit_test(filters_are_products_of_layers_and_means_of_members),
        cmocka_unit_test(layers_are_colourless_if_laid_before_version_3_5),
        cmocka_unit_test(wrong_textures_are_refused),
        cmocka_unit_test(crackle_gives_points_of_a_cube_what_it_gives_each),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
