#include "sdl/parse_finish.h"
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
    s->material.interior = old.interior;
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
        PARSE_MOVES(patterns_move), PARSE_MAPS, { KEYWORD_TEXTURE, texture_of_pattern }, PARSE_FINISH_ITEMS,
    };
    static const item_list list = { "an item of the texture", ITEMS(items), parse_pattern_modifiers, parse_finish_coming,
                                    parse_patterns, VALUE_TEXTURE, take_texture };

    while (!in->failed && in->token.kind != end)
        if (!(in->version > 0.0 && in->version < 3.0 && read_old_colour(in, s)) && !items_try(in, &list, s))
            items_refuse(in, &list);
}

/* A texture begins with the defaults, whatever stood before it. Upon another look it is a layer: as long as
 * it is opaque it hides what is below. */
void parse_texture(pov_reader *in, surface_parsed *s)
{
    const interior kept = s->material.interior;

    if (s->has_look)
        s->layer = in->last;
    s->moves = 0;
    s->material = in->defaults->material;
    s->material.interior = kept;
    s->has_look = true;
    texture_texture(in, s, KEYWORD_TEXTURE);
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
