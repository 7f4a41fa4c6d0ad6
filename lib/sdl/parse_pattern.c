#include "sdl/parse_pattern.h"

#include "sdl/parse_inner.h"
#include "sdl/parse_warp.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"
#include "sdl/value.h"

#include <string.h>

const keyword_id parse_patterns[] = {
    KEYWORD_AGATE, KEYWORD_AOI, KEYWORD_AVERAGE, KEYWORD_BOXED, KEYWORD_BOZO, KEYWORD_BRICK, KEYWORD_BUMPS, KEYWORD_CELLS,
    KEYWORD_CHECKER, KEYWORD_CRACKLE, KEYWORD_CUBIC, KEYWORD_CYLINDRICAL, KEYWORD_DENSITY_FILE, KEYWORD_DENTS,
    KEYWORD_FACETS, KEYWORD_GRADIENT, KEYWORD_GRANITE, KEYWORD_HEXAGON, KEYWORD_JULIA, KEYWORD_LEOPARD, KEYWORD_MAGNET,
    KEYWORD_MANDEL, KEYWORD_MARBLE, KEYWORD_OBJECT, KEYWORD_ONION, KEYWORD_PATTERN, KEYWORD_PAVEMENT, KEYWORD_PLANAR,
    KEYWORD_QUILTED, KEYWORD_RADIAL, KEYWORD_RIPPLES, KEYWORD_SLOPE, KEYWORD_SPHERICAL, KEYWORD_SPIRAL1, KEYWORD_SPIRAL2,
    KEYWORD_SPOTTED, KEYWORD_SQUARE, KEYWORD_TILING, KEYWORD_TRIANGULAR, KEYWORD_WAVES, KEYWORD_WOOD, KEYWORD_WRINKLES,
    KEYWORD_IMAGE_MAP, KEYWORD_BUMP_MAP, KEYWORD_IMAGE_PATTERN, KEYWORD_PIGMENT_PATTERN, KEYWORD_FUNCTION,
    KEYWORD_MATERIAL_MAP, KEYWORD_OTHER,
};

const keyword_id parse_pattern_modifiers[] = {
    KEYWORD_ACCURACY, KEYWORD_AGATE_TURB, KEYWORD_ALL, KEYWORD_BRICK_SIZE, KEYWORD_BUMP_SIZE, KEYWORD_CONTROL0,
    KEYWORD_CONTROL1, KEYWORD_COORDS, KEYWORD_EXPONENT, KEYWORD_EXTERIOR, KEYWORD_FORM, KEYWORD_INTERPOLATE,
    KEYWORD_METRIC, KEYWORD_MORTAR, KEYWORD_NUMBER_OF_SIDES, KEYWORD_NUMBER_OF_TILES, KEYWORD_OFFSET, KEYWORD_ONCE,
    KEYWORD_SIZE, KEYWORD_SOLID, KEYWORD_TURB_DEPTH, KEYWORD_USE_ALPHA, KEYWORD_USE_COLOR, KEYWORD_USE_COLOUR,
    KEYWORD_USE_INDEX, KEYWORD_QUICK_COLOR, KEYWORD_QUICK_COLOUR, KEYWORD_MAP_TYPE, KEYWORD_NO_BUMP_SCALE,
    KEYWORD_INTERIOR, KEYWORD_TYPE, KEYWORD_OTHER,
};

/* ---- begin and end ---- */

static void clear(pattern_parsed *p)
{
    memset(p, 0, sizeof *p);
    p->pattern.turbulence = turbulence_default();
    p->pattern.wave = wave_default(WAVE_RAMP);
}

void parse_pattern_begin(pattern_reading *r)
{
    memset(r, 0, sizeof *r);
    clear(&r->parsed);
}

void parse_pattern_take(pattern_reading *r, const pattern *p)
{
    const bool uv = r->parsed.pattern.uv;

    parse_pattern_begin(r);
    r->parsed = *textures_parsed(p);
    r->stays = p->uv;
    r->parsed.pattern.uv |= uv;
    r->parsed.pattern.self = r->self.bytes;
    if (p->self)
        memcpy(r->self.bytes, p->self, p->class->self_size);
}

const pattern *parse_pattern_end(pov_reader *in, pattern_reading *r)
{
    const pattern_class *class = r->parsed.pattern.class;
    const char *wrong = class->check && !in->failed ? class->check(r->self.bytes) : NULL;

    r->parsed.pattern.self = r->self.bytes;
    if (wrong)
        report_fail(in, &in->last, POV_E_SYNTAX, "%s", wrong);
    return textures_pattern(in, &r->parsed);
}

const pattern *parse_pattern_space(pov_reader *in, const pattern_reading *r)
{
    pattern_parsed space = r->parsed, none;

    clear(&none);
    space.pattern.class = none.pattern.class = &pattern_average;
    space.pattern.self = NULL;
    space.pattern.map = space.pattern.turn = 0;
    return memcmp(&space, &none, sizeof none) == 0 ? NULL : textures_pattern(in, &space);
}

const pattern *parse_pattern_move_space(pov_reader *in, const pattern *space, const transform *moves)
{
    pattern_parsed own;

    clear(&own);
    own.pattern.class = &pattern_average;
    if (space)
        own = *textures_parsed(space);
    parse_append_transforms(in, &own.moves, moves, NULL);
    return in->failed ? NULL : textures_pattern(in, &own);
}

void parse_pattern_take_space(pattern_reading *r, const pattern *space)
{
    parse_pattern_take(r, space);
    r->parsed.pattern.class = NULL;
}

/* ---- words of a pattern ---- */

static void read_flag(pov_reader *in, bool *out)
{
    *out = value_optional(in, 1.0) != 0.0;
}

static void read_integer(pov_reader *in, int32_t *out)
{
    const double number = value_number(in);

    if (!(fabs(number) < 2147483647.0))
        report_fail(in, &in->value, POV_E_SYNTAX, "%g is too large here", number);
    else
        *out = (int32_t)number;
}

static void read_member(pov_reader *in, const pattern_word *word, unsigned char *self)
{
    void *at = self + word->offset;

    switch (word->type) {
    case PATTERN_FLAG: read_flag(in, at); break;
    case PATTERN_NUMBER: *(double *)at = value_number(in); break;
    case PATTERN_FLOAT: *(double *)at = (double)value_float(in); break;
    case PATTERN_INTEGER: read_integer(in, at); break;
    case PATTERN_UV: value_components(in, 2, 2, at); break;
    case PATTERN_VECTOR: *(pov_vec3 *)at = value_vector(in); break;
    }
}

/* Arguments from row i on, up to the next row with a keyword. */
static void read_arguments(pov_reader *in, const pattern_class *class, uint32_t i, unsigned char *self)
{
    for (; i < class->word_count && !class->words[i].keyword; i++) {
        const bool has_comma = state_accept(in, ',');

        if (class->words[i].is_optional && !has_comma && !value_follows(in))
            return;
        read_member(in, &class->words[i], self);
    }
}

static bool read_own_word(pov_reader *in, pattern_reading *r)
{
    const pattern_class *class = r->parsed.pattern.class;

    if (!class || in->token.kind != TOKEN_WORD)
        return false;
    for (uint32_t i = 0; i < class->word_count; i++) {
        if (!class->words[i].keyword || strcmp(class->words[i].keyword, in->token.symbol->name) != 0)
            continue;
        state_advance(in);
        read_member(in, &class->words[i], r->self.bytes);
        read_arguments(in, class, i + 1, r->self.bytes);
        return true;
    }
    return false;
}

/* ---- patterns ---- */

static void read_class(pov_reader *in, pattern_reading *r)
{
    const pattern_class *class = r->parsed.pattern.class;
    block b;

    if (class->flags & PATTERN_FILE) {
        parse_image(in, class, r->self.bytes, &r->image);
        return;
    }
    if (parse_inner(in, class, r->self.bytes, &r->block, &r->is_open))
        return;
    if (!(class->flags & PATTERN_BRACED) || in->token.kind != '{') {
        read_arguments(in, class, 0, r->self.bytes);
        /* At once, for words of magnet are patterns by themselves. */
        while (!in->failed && read_own_word(in, r))
            state_accept(in, ',');
        return;
    }
    items_open(in, &b);
    read_arguments(in, class, 0, r->self.bytes);
    state_accept(in, ',');
    while (!in->failed && read_own_word(in, r))
        state_accept(in, ',');
    in->block = b.outer;
    state_close(in, '}');
}

void parse_pattern_class(pov_reader *in, pattern_reading *r, const pattern_class *class)
{
    memset(&r->self, 0, sizeof r->self);
    if (class->self)
        memcpy(r->self.bytes, class->self, class->self_size);
    r->parsed.pattern.class = class;
    if (class->form != WAVE_RAMP)
        r->parsed.pattern.wave.form = class->form;
    if (class->count > 0 || class->flags & PATTERN_UNFOLDED || class->colours)
        r->parsed.pattern.wave.frequency = 0.0f;   /* numbers of members are not folded */
    read_class(in, r);
    r->parsed.pattern.inner_uv = !in->failed && class->inner && pigment_has_uv(class->inner(r->self.bytes));
}

void parse_pattern_init(symbols *words)
{
    const pattern_class *class;
    symbol *word;
    size_t i;

    for (i = 0; (class = pattern_at(i)) != NULL; i++) {
        word = symbols_named(words, class->keyword);
        if (word)
            word->pattern = class;
    }
}

bool parse_pattern_word(pov_reader *in, pattern_reading *r)
{
    const bool is_word = in->token.kind == TOKEN_WORD && in->token.symbol->id != KEYWORD_OTHER;
    const pattern_class *class = is_word ? in->token.symbol->pattern : NULL;

    if (!class)
        return false;
    state_advance(in);
    parse_pattern_class(in, r, class);
    return true;
}

void parse_pattern_close(pov_reader *in, pattern_reading *r)
{
    if (!r->is_open)
        return;
    r->is_open = false;
    in->block = r->block.outer;
    state_close(in, '}');
}

/* ---- modifiers ---- */

static void read_generator(pov_reader *in, pattern *p)
{
    const double number = value_number(in);

    if (number != 1.0 && number != 2.0 && number != 3.0)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"noise_generator\" must be 1, 2 or 3");
    else
        p->noise_generator = (int)number;
}

static void read_turbulence(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((pattern_reading *)self)->parsed.pattern.turbulence.amount = value_vector(in);
}

static void read_octave_word(pov_reader *in, void *self, keyword_id keyword)
{
    turbulence *t = &((pattern_reading *)self)->parsed.pattern.turbulence;

    if (keyword == KEYWORD_OCTAVES)
        parse_octaves(in, t, keyword);
    else if (keyword == KEYWORD_LAMBDA)
        parse_lambda(in, t, keyword);
    else
        parse_omega(in, t, keyword);
}

static void read_wave(pov_reader *in, void *self, keyword_id keyword)
{
    wave *w = &((pattern_reading *)self)->parsed.pattern.wave;

    switch (keyword) {
    case KEYWORD_FREQUENCY: w->frequency = value_float(in); break;
    case KEYWORD_PHASE: w->phase = value_float(in); break;
    case KEYWORD_TRIANGLE_WAVE: w->form = WAVE_TRIANGLE; break;
    case KEYWORD_SINE_WAVE: w->form = WAVE_SINE; break;
    case KEYWORD_SCALLOP_WAVE: w->form = WAVE_SCALLOP; break;
    case KEYWORD_CUBIC_WAVE: w->form = WAVE_CUBIC; break;
    case KEYWORD_POLY_WAVE:
        w->form = WAVE_POLY;
        w->exponent = (float)value_optional(in, 1.0);
        break;
    default: w->form = WAVE_RAMP; break;
    }
}

static void read_warp(pov_reader *in, void *self, keyword_id keyword)
{
    pattern_parsed *p = &((pattern_reading *)self)->parsed;

    (void)keyword;
    p->pattern.warps = parse_warp(in, p->moves, p->pattern.warps);
    p->moves = NULL;
}

static void read_move(pov_reader *in, void *self, keyword_id keyword)
{
    pattern_reading *r = self;
    const transform *none = NULL, **list = &r->parsed.moves;

    if (r->stays)
        list = r->parsed.pattern.uv_turns ? &r->parsed.turns : &none;
    parse_transform(in, list, keyword);
}

static void read_other(pov_reader *in, void *self, keyword_id keyword)
{
    pattern *p = &((pattern_reading *)self)->parsed.pattern;

    if (keyword == KEYWORD_UV_MAPPING)
        p->uv = value_optional(in, 1.0) != 0.0;
    else
        read_generator(in, p);
}

bool parse_pattern_modifier(pov_reader *in, pattern_reading *r)
{
    static const item items[] = {
        PARSE_MOVES(read_move),
        { KEYWORD_TURBULENCE, read_turbulence },
        { KEYWORD_OCTAVES, read_octave_word },
        { KEYWORD_LAMBDA, read_octave_word },
        { KEYWORD_OMEGA, read_octave_word },
        { KEYWORD_FREQUENCY, read_wave },
        { KEYWORD_PHASE, read_wave },
        { KEYWORD_RAMP_WAVE, read_wave },
        { KEYWORD_TRIANGLE_WAVE, read_wave },
        { KEYWORD_SINE_WAVE, read_wave },
        { KEYWORD_SCALLOP_WAVE, read_wave },
        { KEYWORD_CUBIC_WAVE, read_wave },
        { KEYWORD_POLY_WAVE, read_wave },
        { KEYWORD_WARP, read_warp },
        { KEYWORD_NOISE_GENERATOR, read_other },
        { KEYWORD_UV_MAPPING, read_other },
    };
    static const item_list list = { "a modifier", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };

    return read_own_word(in, r) || items_try(in, &list, r);
}
