#include "sdl/parse_texture.h"

#include "sdl/parse_finish.h"
#include "sdl/parse_map.h"
#include "sdl/parse_pattern.h"
#include "sdl/unsupported.h"
#include "sdl/value.h"

#include <string.h>

/* One texture{}: what is plain goes to the surface; a pattern makes the whole of members. */
typedef struct texture_reading {
    surface_parsed *surface;
    pattern_reading pattern;
    map_parsed map;
} texture_reading;

static bool has_pattern(const texture_reading *r) { return r->pattern.parsed.pattern.class != NULL; }

/* ---- plain ones ---- */

static void read_pigment(pov_reader *in, void *self, keyword_id keyword)
{
    texture_reading *r = self;

    if (has_pattern(r))
        report_fail(in, &in->last, POV_E_SYNTAX, "\"%s\" has no place beside a pattern of textures",
                    token_keyword_name(keyword));
    parse_pigment(in, r->surface);
}

static void read_normal(pov_reader *in, void *self, keyword_id keyword)
{
    texture_reading *r = self;

    if (has_pattern(r))
        report_fail(in, &in->last, POV_E_SYNTAX, "\"%s\" has no place beside a pattern of textures",
                    token_keyword_name(keyword));
    parse_normal(in, r->surface);
}

static void read_finish(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_finish(in, ((texture_reading *)self)->surface);
}

static void read_finish_item(pov_reader *in, void *self, keyword_id keyword)
{
    parse_finish_item(in, ((texture_reading *)self)->surface, keyword);
}

static void read_finish_reflection(pov_reader *in, void *self, keyword_id keyword)
{
    parse_finish_reflection(in, ((texture_reading *)self)->surface, keyword);
}

/* One within another, as entries of maps may have it. */
static void read_inner(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_texture(in, ((texture_reading *)self)->surface);
    state_accept(in, ',');
}

/* Before version 3 a texture had the items of pigment and finish in its own block. */
static bool read_old_colour(pov_reader *in, surface_parsed *s)
{
    pigment p;
    paint read;

    if (!(in->version > 0.0 && in->version < 3.0))
        return false;
    if (in->token.kind == TOKEN_NUMBER) {
        report_warn(in, &in->token.at, "a number right in a texture has no effect");
        value_number(in);
        return true;
    }
    if (!value_colour_follows(in, false))
        return false;
    report_warn(in, &in->token.at, "a colour belongs in a \"pigment\"");
    read = value_colour(in, false);
    p = (pigment){ read.colour, read.filter, read.transmit };
    s->pigment = textures_constant(in, &p);
    return true;
}

/* ---- patterns of textures ---- */

static void read_map(pov_reader *in, void *self, keyword_id keyword)
{
    parse_map(in, parse_map_kind(keyword), &((texture_reading *)self)->map);
}

/* tiles { A tile2 B }: the second is that of even cells. */
static void read_tiles(pov_reader *in, void *self, keyword_id keyword)
{
    texture_reading *r = self;
    map_parsed first, second;
    const void *both[2];
    block b;

    (void)keyword;
    items_open(in, &b);
    if (!parse_map_list(in, VALUE_TEXTURE_MAP, 1, &first))
        report_expected(in, "\"texture\"");
    if (!state_accept_keyword(in, KEYWORD_TILE2) || !parse_map_list(in, VALUE_TEXTURE_MAP, 1, &second))
        report_expected(in, "\"tile2\" and \"texture\"");
    in->block = b.outer;
    state_close(in, '}');
    if (in->failed)
        return;
    both[0] = *(const void *const *)second.members;
    both[1] = *(const void *const *)first.members;
    r->pattern.parsed.pattern.class = pattern_find("checker");
    r->map = (map_parsed){ VALUE_TEXTURE_MAP, 2, NULL, intern(in, both, sizeof both, sizeof both) };
}

static void read_material_map(pov_reader *in, void *self, keyword_id keyword)
{
    texture_reading *r = self;

    (void)keyword;
    parse_pattern_class(in, &r->pattern, &pattern_material_map);
    r->map = r->pattern.image.textures;
}

static bool read_pattern(pov_reader *in, texture_reading *r)
{
    const pattern_class *class;

    if (!parse_pattern_word(in, &r->pattern))
        return false;
    class = r->pattern.parsed.pattern.class;
    memset(&r->map, 0, sizeof r->map);
    if (class->count > 0 && !parse_map_list(in, VALUE_TEXTURE_MAP, class->count, &r->map))
        r->map.kind = VALUE_TEXTURE_MAP;
    parse_map_complete(in, class->count, &r->map);
    parse_pattern_close(in, &r->pattern);
    return true;
}

static const texture *make_whole(pov_reader *in, texture_reading *r)
{
    texture whole;

    if (!in->failed && r->map.count == 0)
        report_expected(in, "\"texture_map\"");
    if (in->failed)
        return NULL;
    memset(&whole, 0, sizeof whole);
    whole.blend = r->pattern.parsed.pattern.class == &pattern_average ? BLEND_AVERAGE :
                  r->map.values ? BLEND_MAP : BLEND_LIST;
    r->pattern.parsed.pattern.uv_turns = r->pattern.parsed.pattern.uv;
    whole.pattern = parse_pattern_end(in, &r->pattern);
    whole.count = r->map.count;
    whole.values = r->map.values;
    whole.textures = r->map.members;
    return textures_texture(in, &whole);
}

static void take_whole(texture_reading *r, const texture *whole)
{
    parse_pattern_take(&r->pattern, whole->pattern);
    r->map = (map_parsed){ VALUE_TEXTURE_MAP, whole->count, whole->values, whole->textures };
}

static void take_texture(pov_reader *in, void *self, const value *v)
{
    const surface_parsed *from = v->as.part;
    texture_reading *r = self;
    const interior kept = r->surface->material.interior;
    const bool uv = r->pattern.parsed.pattern.uv;

    (void)in;
    *r->surface = *from;
    r->surface->material.interior = kept;
    parse_pattern_begin(&r->pattern);
    r->pattern.parsed.pattern.uv = uv;
    if (from->whole)
        take_whole(r, from->whole);
}

static void check_plain(pov_reader *in, const texture_reading *r)
{
    if (has_pattern(r))
        report_fail(in, &in->last, POV_E_SYNTAX, "a part of a texture has no place beside a pattern of textures");
}

/* The name of a part stands for its block, as in POV-Ray. */
static bool take_part(pov_reader *in, texture_reading *r)
{
    surface_parsed *s = r->surface;
    value v;

    if (items_read_named(in, VALUE_PIGMENT, &v)) {
        check_plain(in, r);
        s->pigment = in->failed ? NULL : v.as.part;
        s->whole = NULL;
    } else if (items_read_named(in, VALUE_NORMAL, &v)) {
        check_plain(in, r);
        s->normal = in->failed ? NULL : v.as.part;
    } else if (items_read_named(in, VALUE_FINISH, &v)) {
        if (!in->failed)
            parse_finish_take(in, s, &v);
    } else {
        return false;
    }
    return true;
}

/* ---- contents ---- */

static bool is_move(keyword_id keyword)
{
    switch (keyword) {
    case KEYWORD_TRANSLATE: case KEYWORD_ROTATE: case KEYWORD_SCALE: case KEYWORD_MATRIX: case KEYWORD_TRANSFORM:
        return true;
    default:
        return false;
    }
}

/* Transformations move what stands before them, all that follow one another at once. */
static void move_plain(pov_reader *in, texture_reading *r)
{
    if (has_pattern(r) || !r->pattern.parsed.moves || is_move(state_keyword(in)))
        return;
    parse_surface_move(in, r->surface, r->pattern.parsed.moves);
    r->pattern.parsed.moves = NULL;
}

static void finish_texture(pov_reader *in, texture_reading *r)
{
    surface_parsed *s = r->surface;

    if (in->failed)
        return;
    if (has_pattern(r)) {
        s->whole = make_whole(in, r);
        return;
    }
    if (r->pattern.parsed.pattern.uv) {
        s->pigment = textures_uv_pigment(in, s->pigment);
        s->normal = textures_uv_normal(in, s->normal);
        s->under = textures_uv(in, s->under, true);
    }
}

static const item items[] = {
    { KEYWORD_PIGMENT, read_pigment },
    { KEYWORD_FINISH, read_finish },
    { KEYWORD_NORMAL, read_normal },
    { KEYWORD_TEXTURE, read_inner },
    { KEYWORD_TEXTURE_MAP, read_map },
    { KEYWORD_TILES, read_tiles },
    { KEYWORD_MATERIAL_MAP, read_material_map },
    PARSE_FINISH_ROWS(read_finish_item, read_finish_reflection),
};
static const item_list list = { "an item of the texture", ITEMS(items), parse_pattern_modifiers, parse_finish_coming,
                                parse_patterns, VALUE_TEXTURE, take_texture };

static void read_content(pov_reader *in, surface_parsed *s, int end)
{
    texture_reading r;

    memset(&r, 0, sizeof r);
    r.surface = s;
    parse_pattern_begin(&r.pattern);
    while (!in->failed && in->token.kind != end) {
        if (!read_pattern(in, &r) && !parse_pattern_modifier(in, &r.pattern) && !read_old_colour(in, s) &&
            !items_try(in, &list, &r) && !take_part(in, &r))
            items_refuse(in, &list);
        move_plain(in, &r);
    }
    finish_texture(in, &r);
}

/* Of one that stands for itself: the textures with what the defaults add. */
const texture *parse_surface_node(pov_reader *in, const surface_parsed *s);

const texture *parse_texture_node(pov_reader *in, int end)
{
    surface_parsed s;

    parse_surface_begin(in, &s);
    read_content(in, &s, end);
    s.material.finish.refraction = 1.0f;    /* the old factor is an object's, not that of what its texture is made of */
    return parse_surface_node(in, &s);
}

/* ---- layers ---- */

static bool is_opaque(const texture *t)
{
    return t->blend == BLEND_NONE && t->pigment->most.filter == 0.0f && t->pigment->most.transmit == 0.0f;
}

static void check_layers(pov_reader *in, const texture *below, const texture *above)
{
    if (below->blend != BLEND_NONE && below->blend != BLEND_LAYERS)
        report_fail(in, &in->last, POV_E_SYNTAX, "no texture can lie upon a patterned one");
    else if (above->blend != BLEND_NONE && above->blend != BLEND_LAYERS)
        report_fail(in, &in->last, POV_E_SYNTAX, "a patterned texture cannot lie upon another");
}

static uint32_t add_layers(const texture **out, uint32_t count, const texture *of)
{
    if (of->blend != BLEND_LAYERS) {
        out[count] = of;
        return count + 1;
    }
    memcpy(&out[count], of->textures, of->count * sizeof *out);
    return count + of->count;
}

/* A ray goes on from the lowest layer, by the old `refraction` of the one on top. */
static const texture *take_refraction(pov_reader *in, const texture *lowest, const texture *top)
{
    texture own = *lowest;

    own.finish.refraction = top->finish.refraction;
    return textures_texture(in, &own);
}

/* One upon another; an opaque layer hides those below it. */
static const texture *lay(pov_reader *in, const texture *below, const texture *above)
{
    const texture **layers, *result = above;
    uint32_t count, first;
    texture all;

    check_layers(in, below, above);
    layers = in->failed ? NULL : env_alloc(in->model->env, (size_t)below->count + above->count + 2, sizeof *layers);
    if (!layers) {
        report_memory(in);
        return NULL;
    }
    count = add_layers(layers, add_layers(layers, 0, below), above);
    for (first = count - 1; first > 0 && !is_opaque(layers[first]);)
        first--;
    layers[first] = take_refraction(in, layers[first], layers[count - 1]);
    memset(&all, 0, sizeof all);
    all.blend = BLEND_LAYERS;
    all.count = count - first;
    all.textures = &layers[first];
    result = all.count == 1 ? layers[first] : textures_texture(in, &all);
    env_free(in->model->env, layers);
    return result;
}

/* The layers from `first` on. */
static const texture *colourless_from(pov_reader *in, const texture *t, uint32_t first)
{
    const texture **layers, *changed = NULL;
    texture own;

    if (!t || in->failed || (t->blend == BLEND_NONE ? first > 0 : t->blend != BLEND_LAYERS))
        return t;
    own = *t;
    if (t->blend == BLEND_NONE) {
        own.pigment = textures_colourless(in, t->pigment);
        return textures_texture(in, &own);
    }
    layers = env_alloc(in->model->env, t->count, sizeof *layers);
    if (!layers) {
        report_memory(in);
        return t;
    }
    for (uint32_t i = 0; i < t->count; i++)
        layers[i] = i < first ? t->textures[i] : colourless_from(in, t->textures[i], 0);
    own.textures = layers;
    if (!in->failed)
        changed = textures_texture(in, &own);
    env_free(in->model->env, layers);
    return changed;
}

/* Before version 3.5 layers above others let light through by filter + transmit, whatever their colours. This is so for
 * good from where they are laid. */
static void make_upper_colourless(pov_reader *in, surface_parsed *s, bool is_layer)
{
    const uint32_t first = is_layer ? 0 : 1;

    if (is_layer || s->under)
        s->pigment = textures_colourless(in, s->pigment);
    s->under = colourless_from(in, s->under, first);
    s->whole = colourless_from(in, s->whole, first);
}

static bool is_old(const pov_reader *in) { return in->version > 0.0 && in->version < 3.5; }

/* The normal, if it has a pattern. */
static const normal_node *perturbing(const surface_parsed *s)
{
    return s->normal && s->normal->pattern ? s->normal : NULL;
}

/* What no pattern can take the place of any more. */
static const pigment_node *without_space(pov_reader *in, const pigment_node *p)
{
    pigment_node own = *p;

    own.space = NULL;
    return p->space ? textures_pigment(in, &own) : p;
}

static const texture *top_of(pov_reader *in, const surface_parsed *s)
{
    texture top;

    if (s->whole)
        return s->whole;
    memset(&top, 0, sizeof top);
    top.pigment = s->pigment ? without_space(in, s->pigment) : textures_constant(in, &(pigment){ { 0.0f, 0.0f, 0.0f }, 0.0f, 0.0f });
    top.normal = perturbing(s);
    top.finish = s->material.finish;
    return textures_texture(in, &top);
}

const texture *parse_surface_node(pov_reader *in, const surface_parsed *s)
{
    const texture *top = in->failed ? NULL : top_of(in, s);

    return in->failed || !s->under ? top : lay(in, s->under, top);
}

/* A pattern that takes the place of a colour stands where that was moved to. */
static const pigment_node *move_pigment(pov_reader *in, const pigment_node *p, const transform *moves)
{
    pigment_node own;

    if (!p || p->pattern || !moves || in->failed)
        return textures_move_pigment(in, p, moves);
    own = *p;
    own.space = parse_pattern_move_space(in, p->space, moves);
    return in->failed ? p : textures_pigment(in, &own);
}

void parse_surface_move(pov_reader *in, surface_parsed *s, const transform *moves)
{
    s->pigment = move_pigment(in, s->pigment, moves);
    s->normal = textures_move_normal(in, s->normal, moves);
    s->whole = textures_move(in, s->whole, moves);
    s->under = textures_move(in, s->under, moves);
    s->inside = textures_move(in, s->inside, moves);
}

static void read_block(pov_reader *in, surface_parsed *s)
{
    block b;

    items_open(in, &b);
    read_content(in, s, '}');
    in->block = b.outer;
    state_close(in, '}');
}

/* A texture begins with the defaults. Upon another look it is a layer. */
void parse_texture(pov_reader *in, surface_parsed *s)
{
    const surface_parsed outer = *s;
    const bool colourless = is_old(in);

    parse_surface_begin(in, s);
    s->material.interior = outer.material.interior;
    read_block(in, s);
    if (colourless)
        make_upper_colourless(in, s, outer.has_look);
    s->inside = outer.inside;
    s->uv = outer.uv;
    s->before_uv = outer.before_uv;
    s->has_look = true;
    s->moves = 0;
    if (outer.has_look && !in->failed) {
        const texture *below = parse_surface_node(in, &outer);

        s->under = s->under && !in->failed ? lay(in, below, s->under) : below;
        parse_surface_node(in, s);          /* errors belong here */
    }
}

void parse_interior_texture(pov_reader *in, surface_parsed *s)
{
    const bool colourless = is_old(in);
    surface_parsed inside;

    parse_surface_begin(in, &inside);
    read_block(in, &inside);
    if (colourless)
        make_upper_colourless(in, &inside, s->inside != NULL);
    if (s->inside && !in->failed)
        s->inside = lay(in, s->inside, parse_surface_node(in, &inside));
    else
        s->inside = parse_surface_node(in, &inside);
}

/* ---- surfaces ---- */

static bool is_constant(const surface_parsed *s)
{
    return !s->whole && !s->under && !perturbing(s) && !s->inside && !(s->pigment && s->pigment->pattern);
}

static void set_constant(const surface_parsed *s, material *out)
{
    const pigment black = { { 0.0f, 0.0f, 0.0f }, 0.0f, 0.0f };

    material_set_pigment(out, s->pigment ? s->pigment->most : black);
}

/* Many objects have the texture of the one before. */
static void settle(pov_reader *in, const texture *outside, const texture *inside)
{
    material *last = &in->textured;

    if (in->failed || (last->texture == outside && last->inside == inside))
        return;
    textures_settle(in, outside);
    if (inside)
        textures_settle(in, inside);
    material_set_textures(last, outside, inside);
}

static void make_material(pov_reader *in, const surface_parsed *s, material *out)
{
    const texture *outside;

    *out = s->material;
    if (is_constant(s)) {
        set_constant(s, out);
        return;
    }
    outside = parse_surface_node(in, s);
    if (in->failed)
        return;
    if (outside->blend == BLEND_NONE && !s->inside && !outside->normal && !outside->pigment->pattern) {
        set_constant(s, out);
        return;
    }
    if (s->uv)
        outside = textures_uv(in, outside, false);
    settle(in, outside, s->uv ? textures_uv(in, s->inside, false) : s->inside);
    *out = in->textured;
    out->interior = s->material.interior;
}

void parse_surface_material(pov_reader *in, const surface_parsed *s, material *out)
{
    surface_parsed draft;

    if (!textures_are_drafts(in)) {
        make_material(in, s, out);
        return;
    }
    draft = *s;
    draft.pigment = textures_draft_pigment(in, s->pigment);
    draft.whole = textures_draft(in, s->whole);
    draft.under = textures_draft(in, s->under);
    draft.inside = textures_draft(in, s->inside);
    make_material(in, &draft, out);
}
