#include "sdl/parse_air.h"

#include "base/vec.h"
#include "sdl/noise.h"
#include "sdl/parse_map.h"
#include "sdl/parse_texture.h"
#include "sdl/parse_warp.h"
#include "sdl/report.h"
#include "sdl/value.h"

#include <string.h>

static void *keep(pov_reader *in, const void *part, size_t bytes)
{
    void *copy = state_alloc(in, bytes, 16);

    if (copy)
        memcpy(copy, part, bytes);
    return copy;
}

/* ---- sky_sphere ---- */

enum { SKY_LAYERS = 64 };

typedef struct sky_reading { sky_sphere sky; const pigment_node *layers[SKY_LAYERS]; } sky_reading;

static void read_layer(pov_reader *in, void *self, keyword_id keyword)
{
    sky_reading *r = self;
    const pigment_node *p = parse_pigment_upon(in, NULL);

    (void)keyword;
    if (r->sky.count == SKY_LAYERS)
        report_fail(in, &in->last, POV_E_SYNTAX, "more than %d pigments in a sky", SKY_LAYERS);
    else if (p)
        r->layers[r->sky.count++] = p;
}

static void read_emission(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((sky_reading *)self)->sky.emission = value_colour(in, true).colour;
}

/* What was read so far is moved. */
static void move_sky(pov_reader *in, void *self, keyword_id keyword)
{
    sky_reading *r = self;
    const transform *moves = NULL;

    parse_transform(in, &moves, keyword);
    for (uint32_t i = 0; i < r->sky.count && !in->failed; i++)
        r->layers[i] = textures_move_pigment(in, r->layers[i], moves);
}

static void take_sky(pov_reader *in, void *self, const value *v)
{
    sky_reading *r = self;

    (void)in;
    r->sky = *(const sky_sphere *)v->as.part;
    if (r->sky.count > 0)
        memcpy(r->layers, r->sky.layers, r->sky.count * sizeof *r->layers);
}

const sky_sphere *parse_sky_node(pov_reader *in)
{
    static const item items[] = { { KEYWORD_PIGMENT, read_layer }, { KEYWORD_EMISSION, read_emission }, PARSE_MOVES(move_sky) };
    static const item_list list = { "an item of the sky", ITEMS(items), NULL, NULL, NULL, VALUE_SKY_SPHERE, take_sky };
    sky_reading r;

    memset(&r, 0, sizeof r);
    r.sky.emission = colour_of(1.0f, 1.0f, 1.0f);
    items_block(in, &list, &r);
    if (!in->failed && r.sky.count == 0)
        report_fail(in, &in->last, POV_E_SYNTAX, "this sky has no pigment");
    if (in->failed)
        return NULL;
    r.sky.layers = keep(in, r.layers, (r.sky.count + 1) * sizeof *r.layers);
    return keep(in, &r.sky, sizeof r.sky);
}

static const sky_sphere *draft_sky(pov_reader *in, const sky_sphere *of)
{
    const pigment_node *layers[SKY_LAYERS + 1] = { NULL };
    sky_sphere own = *of;

    for (uint32_t i = 0; i < of->count; i++)
        layers[i] = textures_draft_pigment(in, of->layers[i]);
    own.layers = keep(in, layers, (of->count + 1) * sizeof *layers);
    return in->failed ? NULL : keep(in, &own, sizeof own);
}

void parse_sky(pov_reader *in, void *self, keyword_id keyword)
{
    const sky_sphere *s = parse_sky_node(in);

    (void)self;
    (void)keyword;
    if (s && textures_are_drafts(in))
        s = draft_sky(in, s);
    for (uint32_t i = 0; s && i < s->count; i++)
        textures_settle_pigment(in, s->layers[i]);
    if (s)
        in->model->sky = s->count > 0 ? s : NULL;
}

/* ---- fog ---- */

static void read_fog_number(pov_reader *in, void *self, keyword_id keyword)
{
    const double number = value_number(in);
    fog *f = self;

    switch (keyword) {
    case KEYWORD_FOG_TYPE:
        f->layered = number == 2.0;
        break;
    case KEYWORD_DISTANCE:
        f->distance = number;
        break;
    case KEYWORD_FOG_OFFSET:
        f->offset = number;
        break;
    case KEYWORD_FOG_ALT:
        f->alt = number;
        break;
    default:
        f->depth = number;
    }
}

static void read_fog_colour(pov_reader *in, fog *f)
{
    const paint p = value_colour(in, true);

    f->pigment.color = p.colour;
    f->pigment.filter = p.filter;
    f->pigment.transmit = p.transmit;
}

/* Any word of it makes a fog turbulent, as in POV-Ray even where no point is moved. Before that it has no octaves. */
static turbulence *turbulence_of(fog *f)
{
    if (f->turbulence.octaves == 0)
        f->turbulence = turbulence_default();
    return &f->turbulence;
}

static void read_fog_turbulence(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    turbulence_of(self)->amount = value_vector(in);
}

static void read_fog_up(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((fog *)self)->up = pov_unit(value_vector(in));
}

#define FOG_OCTAVES(name) \
    static void fog_##name(pov_reader *in, void *self, keyword_id keyword) { parse_##name(in, turbulence_of(self), keyword); }
FOG_OCTAVES(octaves)
FOG_OCTAVES(lambda)
FOG_OCTAVES(omega)

/* It fills all space: what moves is where its top is. */
static void move_fog(pov_reader *in, void *self, keyword_id keyword)
{
    fog *f = self;
    const transform *moves = NULL;
    pov_affine m;

    parse_transform(in, &moves, keyword);
    if (!in->failed && moves && transform_compose(moves, &m))
        f->up = pov_unit(transform_direction(&m, f->up));
}

static void take_fog(pov_reader *in, void *self, const value *v)
{
    (void)in;
    *(fog *)self = *(const fog *)v->as.part;
}

/* Old scenes leave the word out. */
static void read_bare_distance(pov_reader *in, fog *f)
{
    report_warn(in, &in->token.at, "the \"distance\" of a fog needs its word");
    f->distance = value_number(in);
}

static void read_fog_items(pov_reader *in, fog *f)
{
    static const item items[] = {
        { KEYWORD_FOG_TYPE, read_fog_number },   { KEYWORD_DISTANCE, read_fog_number }, { KEYWORD_FOG_OFFSET, read_fog_number },
        { KEYWORD_FOG_ALT, read_fog_number },    { KEYWORD_TURB_DEPTH, read_fog_number }, { KEYWORD_TURBULENCE, read_fog_turbulence },
        { KEYWORD_UP, read_fog_up },             { KEYWORD_OCTAVES, fog_octaves },     { KEYWORD_LAMBDA, fog_lambda },
        { KEYWORD_OMEGA, fog_omega },            PARSE_MOVES(move_fog),
    };
    static const item_list list = { "an item of the fog", ITEMS(items), NULL, NULL, NULL, VALUE_FOG, take_fog };

    while (!in->failed && in->token.kind != '}')
        if (value_colour_follows(in, in->token.kind == '<'))
            read_fog_colour(in, f);
        else if (in->token.kind == TOKEN_NUMBER)
            read_bare_distance(in, f);
        else if (!items_try(in, &list, f))
            items_refuse(in, &list);
}

const fog *parse_fog_node(pov_reader *in)
{
    fog f;
    block b;

    memset(&f, 0, sizeof f);
    f.up = pov_vec3_of(0.0, 1.0, 0.0);
    f.depth = 0.5;
    items_open(in, &b);
    read_fog_items(in, &f);
    in->block = b.outer;
    state_close(in, '}');
    return in->failed ? NULL : keep(in, &f, sizeof f);
}

void parse_fog(pov_reader *in, void *self, keyword_id keyword)
{
    const place at = in->last;
    const fog *f = parse_fog_node(in);

    (void)self;
    (void)keyword;
    if (!f)
        return;
    if (!(f->distance > 0.0)) {
        report_warn(in, &at, "a fog without a \"distance\" above 0 is left out");
        return;
    }
    if (f->turbulence.octaves > 0)
        noise_of(in);
    if (!in->failed && !VEC_PUSH(in->model->env, &in->model->fogs, *f))
        report_memory(in);
}

/* ---- rainbow ---- */

static void read_rainbow_number(pov_reader *in, void *self, keyword_id keyword)
{
    const double number = value_number(in);
    rainbow *r = self;

    switch (keyword) {
    case KEYWORD_ANGLE:
        r->angle = number;
        break;
    case KEYWORD_WIDTH:
        r->width = number;
        break;
    case KEYWORD_DISTANCE:
        r->distance = number;
        break;
    case KEYWORD_ARC_ANGLE:
        r->arc = number;
        break;
    default:
        r->falloff = number;
    }
}

static void read_rainbow_axis(pov_reader *in, void *self, keyword_id keyword)
{
    pov_vec3 axis = value_vector(in);

    if (!in->failed && !(pov_largest(axis) > 0.0))
        report_fail(in, &in->value, POV_E_SYNTAX, "\"%s\" of a rainbow must not be zero", token_keyword_name(keyword));
    axis = pov_unit(axis);
    if (keyword == KEYWORD_UP)
        ((rainbow *)self)->up = axis;
    else
        ((rainbow *)self)->direction = axis;
}

static void read_rainbow_map(pov_reader *in, void *self, keyword_id keyword)
{
    rainbow *r = self;
    map_parsed map;

    (void)keyword;
    parse_map(in, VALUE_COLOUR_MAP, &map);
    r->count = in->failed ? 0 : map.count;
    r->values = map.values;
    r->colours = map.members;
}

static void take_rainbow(pov_reader *in, void *self, const value *v)
{
    (void)in;
    *(rainbow *)self = *(const rainbow *)v->as.part;
}

const rainbow *parse_rainbow_node(pov_reader *in)
{
    static const item items[] = {
        { KEYWORD_ANGLE, read_rainbow_number },     { KEYWORD_WIDTH, read_rainbow_number },
        { KEYWORD_DISTANCE, read_rainbow_number },  { KEYWORD_ARC_ANGLE, read_rainbow_number },
        { KEYWORD_FALLOFF_ANGLE, read_rainbow_number }, { KEYWORD_DIRECTION, read_rainbow_axis },
        { KEYWORD_UP, read_rainbow_axis },          { KEYWORD_COLOR_MAP, read_rainbow_map },
        { KEYWORD_COLOUR_MAP, read_rainbow_map },
    };
    static const keyword_id quiet[] = { KEYWORD_JITTER, KEYWORD_OTHER };
    static const item_list list = { "an item of the rainbow", ITEMS(items), quiet, NULL, NULL, VALUE_RAINBOW, take_rainbow };
    rainbow r;

    memset(&r, 0, sizeof r);
    r.up = pov_vec3_of(0.0, 1.0, 0.0);
    r.arc = r.falloff = 360.0;
    r.distance = 1e7;
    items_block(in, &list, &r);
    if (!in->failed && !(pov_largest(r.direction) > 0.0))
        report_fail(in, &in->last, POV_E_SYNTAX, "a rainbow needs a \"direction\"");
    return in->failed ? NULL : keep(in, &r, sizeof r);
}

/* Between which cosines rays are that may meet the bow. */
static void set_cosines(rainbow *r)
{
    const double degree = 3.14159265358979323846 / 180.0, half = 0.5 * fabs(r->width), spare = 0x1p-30;

    r->least_cosine = cos(pov_min(180.0, pov_max(0.0, r->angle + half)) * degree) - spare;
    r->most_cosine = cos(pov_min(180.0, pov_max(0.0, r->angle - half)) * degree) + spare;
}

void parse_rainbow(pov_reader *in, void *self, keyword_id keyword)
{
    const place at = in->last;
    const rainbow *r = parse_rainbow_node(in);
    rainbow kept;

    (void)self;
    (void)keyword;
    if (!r)
        return;
    if (!(r->distance > 0.0 && r->width != 0.0 && r->count > 0)) {
        report_warn(in, &at, "a rainbow without a \"width\" and a \"color_map\", or whose \"distance\" is not above 0, is left out");
        return;
    }
    kept = *r;
    set_cosines(&kept);
    if (!VEC_PUSH(in->model->env, &in->model->rainbows, kept))
        report_memory(in);
}
