#include "sdl/parse_pattern.h"

#include "sdl/patterns.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"
#include "sdl/value.h"

#include <string.h>

void parse_surface_begin(const pov_reader *in, surface_parsed *s)
{
    *s = *in->defaults;
    s->has_look = false;
    s->layer.source = NULL;
}

/* ---- finish ---- */

static void read_ambient(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((surface_parsed *)self)->material.ambient = value_colour(in, true).colour;
}

/* The word is none of 3.7's reserved ones. */
static void skip_albedo(pov_reader *in)
{
    if (in->token.kind != TOKEN_WORD || strcmp(in->token.symbol->name, "albedo") != 0)
        return;
    unsupported_note(in, &in->token.at, KEYWORD_DIFFUSE, "\"albedo\"");
    state_advance(in);
}

static void read_diffuse(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    skip_albedo(in);
    ((surface_parsed *)self)->material.diffuse = value_float(in);
    if (state_accept(in, ',')) {
        unsupported_note(in, &in->token.at, KEYWORD_DIFFUSE, "light from behind");
        value_float(in);
    }
}

static void read_phong(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    skip_albedo(in);
    ((surface_parsed *)self)->material.phong = value_float(in);
}

static void read_phong_size(pov_reader *in, void *self, keyword_id keyword)
{
    float size = value_float(in);

    (void)keyword;
    if (size < 0.0f)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"phong_size\" must not be negative");
    ((surface_parsed *)self)->material.phong_size = size;
}

static void read_metallic(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((surface_parsed *)self)->material.metallic = value_follows(in) ? value_float(in) : 1.0f;
}

static const keyword_id reflection_words[] = { KEYWORD_FRESNEL, KEYWORD_FALLOFF, KEYWORD_EXPONENT, KEYWORD_METALLIC,
                                               KEYWORD_OTHER };

/* Of the two colours of a block the last one is taken: what reflects at most. */
static void read_reflection_block(pov_reader *in, surface_parsed *s)
{
    static const item_list list = { "an item of the reflection", NULL, 0, reflection_words, NULL, NULL, VALUE_NOTHING,
                                    NULL };
    block b;

    unsupported_note(in, &in->last, KEYWORD_REFLECTION, "\"reflection { }\"");
    items_open(in, &b);
    while (!in->failed && value_colour_follows(in, true)) {
        s->material.reflection = value_colour(in, true).colour;
        state_accept(in, ',');
    }
    items_close(in, &b, &list, s);
}

static void read_reflection(pov_reader *in, void *self, keyword_id keyword)
{
    surface_parsed *s = self;

    (void)keyword;
    if (in->token.kind == '{')
        read_reflection_block(in, s);
    else
        s->material.reflection = value_colour(in, true).colour;
}

static void take_finish(pov_reader *in, void *self, const value *v)
{
    surface_parsed *s = self;
    const material old = s->material;

    (void)in;
    s->material = *(const material *)v->as.part;
    s->material.pattern = old.pattern;
    s->material.pigment = old.pigment;
    s->material.filter = old.filter;
    s->material.transmit = old.transmit;
    s->material.has_interior = old.has_interior;
    s->material.ior = old.ior;
}

#define FINISH_ITEMS \
    { KEYWORD_AMBIENT, read_ambient }, { KEYWORD_DIFFUSE, read_diffuse }, { KEYWORD_PHONG, read_phong }, \
    { KEYWORD_PHONG_SIZE, read_phong_size }, { KEYWORD_METALLIC, read_metallic }, \
    { KEYWORD_REFLECTION, read_reflection }

static const keyword_id finish_coming[] = {
    KEYWORD_BRILLIANCE, KEYWORD_CRAND, KEYWORD_SPECULAR, KEYWORD_ROUGHNESS, KEYWORD_IRID, KEYWORD_EMISSION,
    KEYWORD_SUBSURFACE, KEYWORD_CONSERVE_ENERGY, KEYWORD_REFLECTION_EXPONENT, KEYWORD_OTHER,
};
/* Old scenes have here what is the interior's now. */
static void read_old_ior(pov_reader *in, void *self, keyword_id keyword)
{
    surface_parsed *s = self;
    const place at = in->last;
    double ior = value_number(in);

    (void)keyword;
    report_warn(in, &at, "\"ior\" belongs in the \"interior\"");
    if (!(ior > 0.0))
        return;
    s->material.has_interior = true;
    s->material.ior = ior;
}

static const keyword_id finish_old[] = {
    KEYWORD_REFRACTION, KEYWORD_CAUSTICS, KEYWORD_FADE_DISTANCE, KEYWORD_FADE_POWER, KEYWORD_OTHER,
};

void parse_finish(pov_reader *in, surface_parsed *s)
{
    static const item items[] = { FINISH_ITEMS, { KEYWORD_IOR, read_old_ior } };
    static const item_list list = { "an item of the finish", ITEMS(items), finish_old, NULL, finish_coming,
                                    VALUE_FINISH, take_finish };

    s->has_look = true;
    items_block(in, &list, s);
}

/* ---- texture ---- */

static void texture_pigment(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_pigment(in, self);
}

static void texture_finish(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_finish(in, self);
}

static void texture_normal(pov_reader *in, void *self, keyword_id keyword)
{
    unsupported_note(in, &in->last, keyword, "\"normal\"");
    parse_normal(in, self);
}

/* One that stands within another: a tile, or what a pattern begins with. */
static void texture_texture(pov_reader *in, void *self, keyword_id keyword)
{
    block b;

    (void)keyword;
    items_open(in, &b);
    parse_texture_content(in, self, '}');
    in->block = b.outer;
    state_close(in, '}');
}

static void take_texture(pov_reader *in, void *self, const value *v)
{
    surface_parsed *s = self;
    const material old = s->material;

    (void)in;
    s->material = ((const surface_parsed *)v->as.part)->material;
    s->material.has_interior = old.has_interior;
    s->material.ior = old.ior;
}

/* In a list of them commas may stand. */
static void texture_of_pattern(pov_reader *in, void *self, keyword_id keyword)
{
    texture_texture(in, self, keyword);
    state_accept(in, ',');
}

/* Before version 3 a texture had the items of pigment and finish in its own block. */
static bool read_old_colour(pov_reader *in, surface_parsed *s)
{
    paint p;

    if (in->token.kind == TOKEN_NUMBER) {
        report_warn(in, &in->token.at, "a number right in a texture has no effect");
        value_number(in);
        return true;
    }
    if (!value_colour_follows(in, false))
        return false;
    report_warn(in, &in->token.at, "a colour belongs in a \"pigment\"");
    p = value_colour(in, false);
    s->material.pattern = NULL;
    s->material.pigment = p.colour;
    s->material.filter = p.filter;
    s->material.transmit = p.transmit;
    return true;
}

void parse_texture_content(pov_reader *in, surface_parsed *s, int end)
{
    static const item items[] = {
        { KEYWORD_PIGMENT, texture_pigment }, { KEYWORD_FINISH, texture_finish }, { KEYWORD_NORMAL, texture_normal },
        PARSE_MOVES(patterns_move), PARSE_MAPS, { KEYWORD_TEXTURE, texture_of_pattern }, FINISH_ITEMS,
    };
    static const item_list list = { "an item of the texture", ITEMS(items), parse_pattern_modifiers, finish_coming,
                                    parse_patterns, VALUE_TEXTURE, take_texture };

    while (!in->failed && in->token.kind != end)
        if (!(in->version > 0.0 && in->version < 3.0 && read_old_colour(in, s)) && !items_try(in, &list, s))
            items_refuse(in, &list);
}

/* A texture begins with the defaults, whatever stood before it. Upon another look it is a layer: as long as
 * it is opaque it hides what is below. */
void parse_texture(pov_reader *in, surface_parsed *s)
{
    bool has_interior = s->material.has_interior;
    double ior = s->material.ior;

    if (s->has_look)
        s->layer = in->last;
    s->moves = 0;
    s->material = in->defaults->material;
    s->material.has_interior = has_interior;
    s->material.ior = ior;
    s->has_look = true;
    texture_texture(in, s, KEYWORD_TEXTURE);
}

/* ---- interior ---- */

static void read_ior(pov_reader *in, void *self, keyword_id keyword)
{
    double ior = value_number(in);

    (void)keyword;
    if (ior < 0.0)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"ior\" must not be negative");
    if (!in->failed && ior == 0.0) {
        report_warn(in, &in->value, "an ior of 0 counts as 1");
        ior = 1.0;
    }
    ((surface_parsed *)self)->material.ior = ior;
}

static void take_interior(pov_reader *in, void *self, const value *v)
{
    (void)in;
    ((surface_parsed *)self)->material.ior = ((const material *)v->as.part)->ior;
}

static const keyword_id interior_coming[] = {
    KEYWORD_CAUSTICS, KEYWORD_DISPERSION, KEYWORD_DISPERSION_SAMPLES, KEYWORD_FADE_DISTANCE, KEYWORD_FADE_POWER,
    KEYWORD_FADE_COLOR, KEYWORD_FADE_COLOUR, KEYWORD_MEDIA, KEYWORD_OTHER,
};

void parse_interior(pov_reader *in, surface_parsed *s)
{
    static const item items[] = { { KEYWORD_IOR, read_ior } };
    static const item_list list = { "an item of the interior", ITEMS(items), NULL, NULL, interior_coming,
                                    VALUE_INTERIOR, take_interior };

    s->material.has_interior = true;
    s->material.ior = 1.0;
    items_block(in, &list, s);
}

/* ---- material ---- */

static void material_texture(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_texture(in, self);
}

static void material_interior(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_interior(in, self);
}

static void take_material(pov_reader *in, void *self, const value *v)
{
    (void)in;
    *(surface_parsed *)self = *(const surface_parsed *)v->as.part;
}

void parse_material(pov_reader *in, surface_parsed *s)
{
    static const item items[] = { { KEYWORD_TEXTURE, material_texture }, { KEYWORD_INTERIOR, material_interior },
                                  PARSE_MOVES(patterns_move) };
    static const keyword_id coming[] = { KEYWORD_INTERIOR_TEXTURE, KEYWORD_OTHER };
    static const item_list list = { "an item of the material", ITEMS(items), NULL, NULL, coming, VALUE_MATERIAL,
                                    take_material };

    items_block(in, &list, s);
}

/* ---- #default ---- */

static void default_camera(pov_reader *in, void *self, keyword_id keyword)
{
    camera_parsed unused;

    (void)self;
    (void)keyword;
    parse_camera(in, &unused);
}

void parse_default(pov_reader *in, const place *at)
{
    static const item items[] = {
        { KEYWORD_TEXTURE, material_texture }, { KEYWORD_PIGMENT, texture_pigment }, { KEYWORD_FINISH, texture_finish },
        { KEYWORD_NORMAL, texture_normal },    { KEYWORD_CAMERA, default_camera },
    };
    static const item_list list = { "a texture or a part of one", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };
    surface_parsed s;

    (void)at;
    parse_surface_begin(in, &s);
    state_advance(in);
    items_block(in, &list, &s);
    if (!in->failed)
        in->defaults->material = s.material;
}
