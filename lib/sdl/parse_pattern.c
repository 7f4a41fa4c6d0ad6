#include "sdl/parse_pattern.h"

#include "sdl/patterns.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"
#include "sdl/value.h"

/* Patterns: until they are drawn their first colour stands for them. */
const keyword_id parse_patterns[] = {
    KEYWORD_AGATE, KEYWORD_AOI, KEYWORD_AVERAGE, KEYWORD_BOXED, KEYWORD_BOZO, KEYWORD_BRICK, KEYWORD_BUMPS, KEYWORD_CELLS,
    KEYWORD_CHECKER, KEYWORD_CRACKLE, KEYWORD_CYLINDRICAL, KEYWORD_DENSITY_FILE, KEYWORD_DENTS, KEYWORD_FACETS,
    KEYWORD_GRADIENT, KEYWORD_GRANITE, KEYWORD_HEXAGON, KEYWORD_JULIA, KEYWORD_LEOPARD, KEYWORD_MAGNET, KEYWORD_MANDEL,
    KEYWORD_MARBLE, KEYWORD_OBJECT, KEYWORD_ONION, KEYWORD_PATTERN, KEYWORD_PAVEMENT, KEYWORD_PLANAR, KEYWORD_QUILTED,
    KEYWORD_RADIAL, KEYWORD_RIPPLES, KEYWORD_SLOPE, KEYWORD_SPHERICAL, KEYWORD_SPIRAL1, KEYWORD_SPIRAL2,
    KEYWORD_SPOTTED, KEYWORD_SQUARE, KEYWORD_TILING, KEYWORD_TRIANGULAR, KEYWORD_WAVES, KEYWORD_WOOD, KEYWORD_WRINKLES,
    KEYWORD_IMAGE_MAP, KEYWORD_BUMP_MAP, KEYWORD_IMAGE_PATTERN, KEYWORD_PIGMENT_PATTERN, KEYWORD_FUNCTION,
    KEYWORD_MATERIAL_MAP, KEYWORD_OTHER,
};

const keyword_id parse_pattern_modifiers[] = {
    KEYWORD_ACCURACY, KEYWORD_AGATE_TURB, KEYWORD_ALL, KEYWORD_BLACK_HOLE, KEYWORD_BRICK_SIZE, KEYWORD_BUMP_SIZE,
    KEYWORD_CONTROL0, KEYWORD_CONTROL1, KEYWORD_COORDS, KEYWORD_CUBIC_WAVE, KEYWORD_DISTANCE, KEYWORD_EXPONENT,
    KEYWORD_EXTERIOR, KEYWORD_FLIP, KEYWORD_FORM, KEYWORD_FREQUENCY, KEYWORD_INSIDE_VECTOR, KEYWORD_INTERPOLATE,
    KEYWORD_LAMBDA, KEYWORD_METRIC, KEYWORD_MORTAR, KEYWORD_NOISE_GENERATOR, KEYWORD_NUMBER_OF_SIDES,
    KEYWORD_NUMBER_OF_TILES, KEYWORD_OCTAVES, KEYWORD_OFFSET, KEYWORD_OMEGA, KEYWORD_ONCE, KEYWORD_ORIENTATION,
    KEYWORD_PHASE, KEYWORD_POLY_WAVE, KEYWORD_RAMP_WAVE, KEYWORD_REPEAT, KEYWORD_SCALLOP_WAVE, KEYWORD_SINE_WAVE,
    KEYWORD_SIZE, KEYWORD_SOLID, KEYWORD_STRENGTH, KEYWORD_TILE2, KEYWORD_TILES, KEYWORD_TOROIDAL, KEYWORD_TRIANGLE_WAVE,
    KEYWORD_TURB_DEPTH, KEYWORD_TURBULENCE, KEYWORD_USE_ALPHA, KEYWORD_USE_COLOR, KEYWORD_USE_COLOUR,
    KEYWORD_USE_INDEX, KEYWORD_WARP, KEYWORD_WIDTH, KEYWORD_QUICK_COLOR, KEYWORD_QUICK_COLOUR, KEYWORD_UV_MAPPING,
    KEYWORD_MAP_TYPE, KEYWORD_NO_BUMP_SCALE, KEYWORD_INTERIOR, KEYWORD_TYPE, KEYWORD_OTHER,
};


/* Of normals and densities, which are not drawn. */
void parse_pattern_move(pov_reader *in, void *self, keyword_id keyword)
{
    const transform *unused = NULL;

    (void)self;
    parse_transform(in, &unused, keyword);
}

/* ---- pigment ---- */

/* Guesses come from the words that a colour begins with. */
static void refuse_pigment(pov_reader *in)
{
    guess g;
    keyword_id keyword;

    report_guess_start(&g, in);
    for (keyword = (keyword_id)(KEYWORD_OTHER + 1); keyword < KEYWORDS; keyword = (keyword_id)(keyword + 1))
        if (token_keyword_flags(keyword) & KEYWORD_FLAG_PAINT)
            report_guess_try(&g, token_keyword_name(keyword));
    report_misplaced(in, "a colour or \"}\"", &g);
}

static void take_colour(pov_reader *in, surface_parsed *s)
{
    paint p = value_colour(in, false);

    s->material.pattern = NULL;
    s->material.pigment = p.colour;
    s->material.filter = p.filter;
    s->material.transmit = p.transmit;
}

static void take_pigment(pov_reader *in, void *self, const value *v)
{
    const material *from = v->as.part;
    surface_parsed *s = self;

    (void)in;
    s->moves = 0;
    s->material.pattern = from->pattern;
    s->material.pigment = from->pigment;
    s->material.filter = from->filter;
    s->material.transmit = from->transmit;
}

static void read_pigment(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_pigment(in, self);
    state_accept(in, ',');
}

static void pigment_content(pov_reader *in, surface_parsed *s, int end)
{
    static const item items[] = { PARSE_MOVES(patterns_move), PARSE_MAPS, { KEYWORD_PIGMENT, read_pigment } };
    static const item_list list = { "an item of the pigment", ITEMS(items), parse_pattern_modifiers, NULL,
                                    parse_patterns, VALUE_PIGMENT, take_pigment };

    bool has_colour = false;

    s->has_look = true;
    while (!in->failed && in->token.kind != end) {
        if (!has_colour && value_colour_follows(in, false)) {
            take_colour(in, s);
            has_colour = true;
        } else if (!patterns_read(in, s) && !items_try(in, &list, s)) {
            refuse_pigment(in);
        }
    }
}

static void content_block(pov_reader *in, surface_parsed *s, void (*read)(pov_reader *, surface_parsed *, int))
{
    block b;

    items_open(in, &b);
    read(in, s, '}');
    in->block = b.outer;
    state_close(in, '}');
}

void parse_pigment(pov_reader *in, surface_parsed *s)
{
    content_block(in, s, pigment_content);
}

/* ---- normal ---- */

static void take_normal(pov_reader *in, void *self, const value *v)
{
    (void)self;
    (void)v;
    value_optional(in, 0.0);
}

static void read_normal(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_normal(in, self);
    state_accept(in, ',');
}

static void normal_content(pov_reader *in, surface_parsed *s, int end)
{
    static const item items[] = { PARSE_MOVES(parse_pattern_move), PARSE_MAPS, { KEYWORD_NORMAL, read_normal } };
    static const item_list list = { "an item of the normal", ITEMS(items), parse_pattern_modifiers, parse_patterns,
                                    NULL, VALUE_NORMAL, take_normal };

    items_until(in, end, &list, s);
}

void parse_normal(pov_reader *in, surface_parsed *s)
{
    content_block(in, s, normal_content);
}

/* ---- densities of media ---- */

static void take_density(pov_reader *in, void *self, const value *v)
{
    (void)in;
    (void)self;
    (void)v;
}

static void read_density(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_density(in, self);
    state_accept(in, ',');
}

static void density_content(pov_reader *in, surface_parsed *s, int end)
{
    static const item items[] = { PARSE_MOVES(parse_pattern_move), PARSE_MAPS, { KEYWORD_DENSITY, read_density } };
    static const item_list list = { "an item of the density", ITEMS(items), parse_pattern_modifiers, parse_patterns,
                                    NULL, VALUE_DENSITY, take_density };

    while (!in->failed && in->token.kind != end)
        if (value_colour_follows(in, false))
            take_colour(in, s);
        else if (!items_try(in, &list, s))
            items_refuse(in, &list);
}

void parse_density(pov_reader *in, surface_parsed *s)
{
    content_block(in, s, density_content);
}

/* ---- maps ---- */

/* In old scenes an entry is an interval: two numbers, two colours. */
static void colour_content(pov_reader *in, surface_parsed *s, int end)
{
    surface_parsed unused = *s;

    state_accept(in, ',');
    if (value_follows(in) && !value_colour_follows(in, false)) {
        value_number(in);
        state_accept(in, ',');
    }
    take_colour(in, s);
    state_accept(in, ',');
    if (in->token.kind != end)
        take_colour(in, &unused);
}

static void slope_content(pov_reader *in, surface_parsed *s, int end)
{
    double v[2];

    (void)s;
    (void)end;
    state_accept(in, ',');
    value_components(in, 2, 2, v);
}

static void entry_content(pov_reader *in, surface_parsed *s, keyword_id keyword)
{
    switch (keyword) {
    case KEYWORD_PIGMENT_MAP:
        pigment_content(in, s, ']');
        break;
    case KEYWORD_TEXTURE_MAP:
        parse_texture_content(in, s, ']');
        break;
    case KEYWORD_NORMAL_MAP:
        normal_content(in, s, ']');
        break;
    case KEYWORD_DENSITY_MAP:
        density_content(in, s, ']');
        break;
    case KEYWORD_SLOPE_MAP:
        slope_content(in, s, ']');
        break;
    default:
        colour_content(in, s, ']');
    }
}

static value_kind kind_of(keyword_id keyword)
{
    switch (keyword) {
    case KEYWORD_PIGMENT_MAP:
        return VALUE_PIGMENT_MAP;
    case KEYWORD_TEXTURE_MAP:
        return VALUE_TEXTURE_MAP;
    case KEYWORD_NORMAL_MAP:
        return VALUE_NORMAL_MAP;
    case KEYWORD_DENSITY_MAP:
        return VALUE_DENSITY_MAP;
    case KEYWORD_SLOPE_MAP:
        return VALUE_SLOPE_MAP;
    default:
        return VALUE_COLOUR_MAP;
    }
}

static void read_entries(pov_reader *in, surface_parsed *s, keyword_id keyword)
{
    bool is_first = true;

    if (in->token.kind == '}')
        report_expected(in, "\"[\" and the first entry of the map");
    while (!in->failed && in->token.kind != '}') {
        surface_parsed other = *s;

        state_open(in, '[');
        if (value_follows(in))   /* entries of an average may have no weight */
            value_number(in);
        state_accept(in, ',');
        entry_content(in, is_first ? s : &other, keyword);
        state_close(in, ']');
        state_accept(in, ',');
        is_first = false;
    }
}

void parse_map(pov_reader *in, surface_parsed *s, keyword_id keyword)
{
    value v;
    block b;

    items_open(in, &b);
    if (items_read_named(in, kind_of(keyword), &v)) {
        if (!in->failed)
            s->material = ((const surface_parsed *)v.as.part)->material;
    } else {
        read_entries(in, s, keyword);
    }
    in->block = b.outer;
    state_close(in, '}');
}

void parse_pattern_map(pov_reader *in, void *self, keyword_id keyword)
{
    parse_map(in, self, keyword);
}
