#include "sdl/parse_texture.h"

#include "sdl/parse_map.h"
#include "sdl/parse_pattern.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"
#include "sdl/value.h"

#include <string.h>

typedef struct pigment_reading {
    pattern_reading pattern;
    value_kind kind;             /* VALUE_PIGMENT or VALUE_DENSITY */
    bool has_colour;
    bool has_map;                /* it says one itself, where `map` may be of what it is based on */
    pigment constant;
    const pigment_node *draft;   /* NULL: there is no other colour in drafts */
    map_parsed map;
} pigment_reading;

/* ---- items ---- */

static pigment read_colour(pov_reader *in)
{
    const paint p = value_colour(in, false);
    const pigment out = { p.colour, p.filter, p.transmit };

    return out;
}

static void set_colour(pigment_reading *r, pigment p)
{
    r->constant = p;
    r->has_colour = true;
    r->pattern.parsed.pattern.class = NULL;
}

static void take_colour(pov_reader *in, pigment_reading *r) { set_colour(r, read_colour(in)); }

static void take_map(pigment_reading *r, const pigment_node *from)
{
    memset(&r->map, 0, sizeof r->map);
    if (!from || from->own_map || (!from->colours && !from->pigments))
        return;
    r->map.kind = from->colours ? VALUE_COLOUR_MAP : VALUE_PIGMENT_MAP;
    r->map.count = from->count;
    r->map.values = from->values;
    r->map.members = from->colours ? (const void *)from->colours : (const void *)from->pigments;
}

/* What is read changes the pigment that was there before. */
static void take_base(pigment_reading *r, const pigment_node *from)
{
    r->constant = from->most;
    r->draft = from->draft;
    if (from->space)
        parse_pattern_take_space(&r->pattern, from->space);
    if (from->pattern)
        parse_pattern_take(&r->pattern, from->pattern);
    take_map(r, from->pattern ? from : from->map);
}

static void take_node(pov_reader *in, void *self, const value *v)
{
    const pigment_node *from = v->as.part;
    pigment_reading *r = self;
    const bool uv = r->pattern.parsed.pattern.uv;

    (void)in;
    parse_pattern_begin(&r->pattern);
    r->pattern.parsed.pattern.uv = uv;
    take_base(r, from);
    r->has_colour = false;       /* another one may follow */
}

static void read_map(pov_reader *in, void *self, keyword_id keyword)
{
    pigment_reading *r = self;

    parse_map(in, parse_map_kind(keyword), &r->map);
    r->has_map = true;
}

static void read_quick_colour(pov_reader *in, void *self, keyword_id keyword)
{
    const paint p = value_colour(in, true);

    (void)keyword;
    if (!in->failed)
        ((pigment_reading *)self)->draft = textures_constant(in, &(pigment){ p.colour, p.filter, p.transmit });
}

/* ---- lists ---- */

static void read_colours(pov_reader *in, pigment_reading *r, const pattern_class *class)
{
    pigment list[PATTERN_LIST_MAX];

    memcpy(list, class->list, sizeof list);
    for (uint32_t i = 0; i < class->count && value_colour_follows(in, true); i++) {
        const paint p = value_colour(in, true);

        list[i] = (pigment){ p.colour, p.filter, p.transmit };
        state_accept(in, ',');
    }
    r->map.kind = VALUE_COLOUR_MAP;
    r->map.count = class->count;
    r->map.values = NULL;
    r->map.members = intern(in, list, class->count * sizeof *list, class->count * sizeof *list);
}

static void read_list(pov_reader *in, pigment_reading *r)
{
    const pattern_class *class = r->pattern.parsed.pattern.class;
    const value_kind kind = r->kind == VALUE_DENSITY ? VALUE_DENSITY_MAP : VALUE_PIGMENT_MAP;

    if (parse_map_list(in, kind, class->count, &r->map))
        parse_map_complete(in, class->count, &r->map);
    else
        read_colours(in, r, class);
}

static bool read_pattern(pov_reader *in, pigment_reading *r)
{
    if (!parse_pattern_word(in, &r->pattern))
        return false;
    r->has_colour = false;
    if (r->pattern.parsed.pattern.class->count > 0)
        read_list(in, r);
    parse_pattern_close(in, &r->pattern);
    return true;
}

/* ---- the node ---- */

static const pigment grey[] = { { { 0.0f, 0.0f, 0.0f }, 0.0f, 0.0f }, { { 1.0f, 1.0f, 1.0f }, 0.0f, 0.0f } };
static const float grey_values[] = { 0.0f, 1.0f };

static void use_default_map(pov_reader *in, const pattern_class *class, const void *self, map_parsed *map)
{
    enum { ENTRIES = 16 };
    pigment colours[ENTRIES];
    float values[ENTRIES];
    uint32_t count = class->has_map && !class->has_map(self) ? 0 : class->map_count;

    for (uint32_t i = 0; i < count; i++) {
        values[i] = class->map[i].value;
        colours[i] = class->map[i].pigment;
    }
    if (count == 0) {
        count = 2;
        memcpy(values, grey_values, sizeof grey_values);
        memcpy(colours, grey, sizeof grey);
    }
    map->kind = VALUE_COLOUR_MAP;
    map->count = count;
    map->values = intern(in, values, count * sizeof *values, count * sizeof *values);
    map->members = intern(in, colours, count * sizeof *colours, count * sizeof *colours);
}

/* Of a list before, its members are those of a map. */
static void number_map(pov_reader *in, map_parsed *map)
{
    float *values = env_alloc(in->model->env, map->count, sizeof *values);

    if (!values) {
        report_memory(in);
        return;
    }
    for (uint32_t i = 0; i < map->count; i++)
        values[i] = (float)i;
    map->values = intern(in, values, map->count * sizeof *values, map->count * sizeof *values);
    env_free(in->model->env, values);
}

/* An average needs nodes. */
static void make_nodes(pov_reader *in, map_parsed *map)
{
    const pigment *colours = map->members;
    const pigment_node **nodes = env_alloc(in->model->env, map->count, sizeof *nodes);

    if (!nodes) {
        report_memory(in);
        return;
    }
    for (uint32_t i = 0; i < map->count; i++)
        nodes[i] = textures_constant(in, &colours[i]);
    map->kind = VALUE_PIGMENT_MAP;
    map->members = intern(in, nodes, map->count * sizeof *nodes, map->count * sizeof *nodes);
    env_free(in->model->env, nodes);
}

static pigment most_of(const pigment_node *p)
{
    pigment most = p->colours ? p->colours[0] : p->pigments[0]->most;

    for (uint32_t i = 1; i < p->count; i++)
        most = pigment_most(most, p->colours ? p->colours[i] : p->pigments[i]->most);
    return most;
}

static void set_members(pigment_node *node, const map_parsed *map)
{
    node->count = map->count;
    node->values = map->values;
    if (map->kind == VALUE_COLOUR_MAP)
        node->colours = map->members;
    else
        node->pigments = map->members;
}

static const pigment_node *make_varying(pov_reader *in, pigment_reading *r)
{
    const pattern_class *class = r->pattern.parsed.pattern.class;
    const bool is_average = class == &pattern_average;
    pigment_node node;

    memset(&node, 0, sizeof node);
    node.pattern = parse_pattern_end(in, &r->pattern);
    node.draft = r->draft;
    if (class->colours) {
        node.most = class->most(r->pattern.self.bytes);
        return textures_pigment(in, &node);
    }
    if (is_average && r->map.kind == VALUE_NOTHING)
        report_fail(in, &in->last, POV_E_SYNTAX, "\"average\" needs a map of what it is the mean of");
    node.own_map = r->map.kind == VALUE_NOTHING;
    if (node.own_map)
        use_default_map(in, class, r->pattern.self.bytes, &r->map);
    if (class->count == 0 && !r->map.values && !in->failed)
        number_map(in, &r->map);
    if (is_average && r->map.kind == VALUE_COLOUR_MAP && !in->failed)
        make_nodes(in, &r->map);
    if (in->failed || r->map.count == 0)
        return NULL;
    node.blend = is_average ? BLEND_AVERAGE : r->map.values ? BLEND_MAP : BLEND_LIST;
    set_members(&node, &r->map);
    node.most = most_of(&node);
    return textures_pigment(in, &node);
}

/* The map that a constant keeps for a pattern of another block. NULL: there is none. */
static const pigment_node *keep_map(pov_reader *in, const map_parsed *map)
{
    pigment_node node;

    if (map->kind == VALUE_NOTHING)
        return NULL;
    memset(&node, 0, sizeof node);
    set_members(&node, map);
    return textures_pigment(in, &node);
}

/* A map that nothing chooses from leaves black. */
static void refuse_map(pov_reader *in, const pigment_reading *r)
{
    const place at = in->last;

    if (r->has_colour)
        report_fail(in, &at, POV_E_SYNTAX, "a map needs a pattern that chooses from it, and this pigment is one colour");
    else
        report_warn(in, &at, "a map has no effect without a pattern: the pigment is black until one follows");
}

static const pigment_node *make_node(pov_reader *in, pigment_reading *r)
{
    pigment_node node;

    if (in->failed)
        return NULL;
    if (r->pattern.parsed.pattern.class)
        return make_varying(in, r);
    if (r->has_map)
        refuse_map(in, r);
    memset(&node, 0, sizeof node);
    node.most = r->constant;
    node.draft = r->draft;
    node.space = parse_pattern_space(in, &r->pattern);
    node.map = keep_map(in, &r->map);
    return textures_pigment(in, &node);
}

/* ---- contents ---- */

/* Guesses come from the words that a colour begins with. */
static void refuse(pov_reader *in)
{
    guess g;
    keyword_id keyword;

    report_guess_start(&g, in);
    for (keyword = (keyword_id)(KEYWORD_OTHER + 1); keyword < KEYWORDS; keyword = (keyword_id)(keyword + 1))
        if (token_keyword_flags(keyword) & KEYWORD_FLAG_PAINT)
            report_guess_try(&g, token_keyword_name(keyword));
    report_misplaced(in, "a colour or \"}\"", &g);
}

static const item items[] = {
    { KEYWORD_COLOR_MAP, read_map },     { KEYWORD_COLOUR_MAP, read_map },
    { KEYWORD_PIGMENT_MAP, read_map },   { KEYWORD_DENSITY_MAP, read_map },
    { KEYWORD_QUICK_COLOR, read_quick_colour }, { KEYWORD_QUICK_COLOUR, read_quick_colour },
};

static void read_item(pov_reader *in, pigment_reading *r)
{
    const item_list list = { "an item of the pigment", ITEMS(items), parse_pattern_modifiers, NULL, parse_patterns,
                             r->kind, take_node };

    if (!r->has_colour && value_colour_follows(in, false))
        take_colour(in, r);
    else if (!read_pattern(in, r) && !parse_pattern_modifier(in, &r->pattern) && !items_try(in, &list, r))
        refuse(in);
}

static void begin(pigment_reading *r, value_kind kind, const pigment_node *base)
{
    parse_pattern_begin(&r->pattern);
    r->kind = kind;
    r->has_colour = r->has_map = false;
    r->draft = NULL;
    memset(&r->constant, 0, sizeof r->constant);
    memset(&r->map, 0, sizeof r->map);
    if (base)
        take_base(r, base);
}

const pigment_node *parse_pigment_content(pov_reader *in, value_kind kind, const pigment_node *base, int end)
{
    pigment_reading r;

    begin(&r, kind, base);
    while (!in->failed && in->token.kind != end)
        read_item(in, &r);
    return make_node(in, &r);
}

const pigment_node *parse_pigment_colour(pov_reader *in, const pigment_node *base, const pigment *p)
{
    pigment_reading r;

    begin(&r, VALUE_PIGMENT, base);
    set_colour(&r, *p);
    return make_node(in, &r);
}

static const pigment_node *read_block(pov_reader *in, value_kind kind, const pigment_node *base)
{
    const pigment_node *node;
    block b;

    items_open(in, &b);
    node = parse_pigment_content(in, kind, base, '}');
    in->block = b.outer;
    state_close(in, '}');
    return in->failed ? NULL : node;
}

const pigment_node *parse_pigment_upon(pov_reader *in, const pigment_node *base)
{
    return read_block(in, VALUE_PIGMENT, base);
}

const pigment_node *parse_pigment_node(pov_reader *in) { return read_block(in, VALUE_PIGMENT, in->defaults->pigment); }
const pigment_node *parse_density_node(pov_reader *in) { return read_block(in, VALUE_DENSITY, NULL); }
