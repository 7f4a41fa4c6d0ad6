#include "sdl/parse_media.h"
#include "sdl/parse_texture.h"

#include <string.h>

void parse_surface_begin(const pov_reader *in, surface_parsed *s)
{
    *s = *in->defaults;
}

void parse_surface_default(const surface_parsed *defaults, surface_parsed *s)
{
    surface_parsed own;

    if (s->has_look)
        return;
    own = *s;
    *s = *defaults;
    s->material.interior = own.material.interior;
    s->inside = own.inside;
    s->uv = own.uv;
    s->before_uv = own.before_uv;
    s->moves = own.moves;
}

void parse_pigment(pov_reader *in, surface_parsed *s)
{
    s->pigment = parse_pigment_upon(in, s->pigment);
    s->whole = NULL;
    s->has_look = true;
}

void parse_surface_colour(pov_reader *in, surface_parsed *s, const pigment *p)
{
    s->pigment = parse_pigment_colour(in, s->pigment, p);
    s->whole = NULL;
    s->has_look = true;
}

void parse_normal(pov_reader *in, surface_parsed *s)
{
    s->normal = parse_normal_upon(in, s->normal);
    s->has_look = true;
}

/* ---- material ---- */

static void read_texture(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_texture(in, self);
}

static void read_inside(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_interior_texture(in, self);
}

static void read_interior(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_interior(in, self);
}

static void read_move(pov_reader *in, void *self, keyword_id keyword)
{
    const transform *moves = NULL;
    surface_parsed *s = self;

    parse_transform(in, &moves, keyword);
    parse_surface_move(in, s, moves);
    s->material.interior.media = parse_media_move(in, s->material.interior.media, moves);
}

static void take_material(pov_reader *in, void *self, const value *v)
{
    (void)in;
    *(surface_parsed *)self = *(const surface_parsed *)v->as.part;
}

void parse_material(pov_reader *in, surface_parsed *s)
{
    static const item items[] = { { KEYWORD_TEXTURE, read_texture },
                                  { KEYWORD_INTERIOR_TEXTURE, read_inside },
                                  { KEYWORD_INTERIOR, read_interior },
                                  PARSE_MOVES(read_move) };
    static const item_list list = { "an item of the material", ITEMS(items), NULL, NULL, NULL, VALUE_MATERIAL,
                                    take_material };

    items_block(in, &list, s);
}

/* ---- #default ---- */

static void read_pigment(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_pigment(in, self);
}

static void read_normal(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_normal(in, self);
}

static void read_finish(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_finish(in, self);
}

static void read_camera(pov_reader *in, void *self, keyword_id keyword)
{
    camera_parsed unused;

    (void)self;
    (void)keyword;
    parse_camera(in, &unused);
}

void parse_default(pov_reader *in, const place *at)
{
    static const item items[] = {
        { KEYWORD_TEXTURE, read_texture }, { KEYWORD_PIGMENT, read_pigment }, { KEYWORD_FINISH, read_finish },
        { KEYWORD_NORMAL, read_normal },   { KEYWORD_CAMERA, read_camera },
    };
    static const item_list list = { "a texture or a part of one", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };
    surface_parsed s;

    (void)at;
    parse_surface_begin(in, &s);
    state_advance(in);
    items_block(in, &list, &s);
    if (in->failed)
        return;
    s.has_look = false;
    s.albedos = 0;
    *in->defaults = s;
}
