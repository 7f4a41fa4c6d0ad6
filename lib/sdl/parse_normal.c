#include "sdl/parse_texture.h"

#include "sdl/parse_map.h"
#include "sdl/parse_pattern.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"
#include "sdl/value.h"

#include <string.h>

typedef struct normal_reading {
    pattern_reading pattern;
    map_parsed map;              /* of normals */
    map_parsed slopes;
    float amount, accuracy;
    bool is_scaled;
} normal_reading;

/* ---- items ---- */

/* What is read changes the normal that was there before. */
static void take_base(normal_reading *r, const normal_node *from)
{
    if (from->space)
        parse_pattern_take_space(&r->pattern, from->space);
    if (from->pattern)
        parse_pattern_take(&r->pattern, from->pattern);
    r->amount = from->amount;
    r->accuracy = from->accuracy;
    r->is_scaled = from->is_scaled;
    memset(&r->map, 0, sizeof r->map);
    memset(&r->slopes, 0, sizeof r->slopes);
    if (from->normals)
        r->map = (map_parsed){ VALUE_NORMAL_MAP, from->count, from->values, from->normals };
    else if (from->slopes)
        r->slopes = (map_parsed){ VALUE_SLOPE_MAP, from->count, from->values, from->slopes };
}

static void take_node(pov_reader *in, void *self, const value *v)
{
    normal_reading *r = self;

    if (v->as.part)
        take_base(r, v->as.part);
    if (value_follows(in))
        r->amount = value_float(in);
}

/* Of several maps the last one counts. */
static void read_map(pov_reader *in, void *self, keyword_id keyword)
{
    normal_reading *r = self;
    const bool is_slopes = keyword == KEYWORD_SLOPE_MAP;

    parse_map(in, parse_map_kind(keyword), is_slopes ? &r->slopes : &r->map);
    memset(is_slopes ? &r->map : &r->slopes, 0, sizeof r->map);
}

static void read_number(pov_reader *in, void *self, keyword_id keyword)
{
    normal_reading *r = self;

    if (keyword == KEYWORD_BUMP_SIZE)
        r->amount = value_float(in);
    else if (keyword == KEYWORD_ACCURACY)
        r->accuracy = value_float(in);
    else
        r->is_scaled = value_optional(in, 1.0) == 0.0;
}

/* Behind the pattern: normals of a list, or the amount. */
static bool read_pattern(pov_reader *in, normal_reading *r)
{
    const pattern_class *class;

    if (!parse_pattern_word(in, &r->pattern))
        return false;
    class = r->pattern.parsed.pattern.class;
    if (r->map.values == NULL || class->count > 0)
        memset(&r->map, 0, sizeof r->map);
    if (r->pattern.image.has_bump_size)
        r->amount = r->pattern.image.bump_size;
    if (class->count > 0 && parse_map_list(in, VALUE_NORMAL_MAP, class->count, &r->map))
        parse_map_complete(in, class->count, &r->map);
    parse_pattern_close(in, &r->pattern);
    state_accept(in, ',');
    if (value_follows(in))
        r->amount = value_float(in);
    return true;
}

/* ---- the node ---- */

static const normal_node *make_node(pov_reader *in, normal_reading *r)
{
    const pattern_class *class = r->pattern.parsed.pattern.class;
    const bool is_average = class == &pattern_average;
    const map_parsed *map = r->map.kind != VALUE_NOTHING ? &r->map : &r->slopes;
    normal_node node;

    if (!in->failed && is_average && r->map.count == 0)
        report_fail(in, &in->last, POV_E_SYNTAX, "\"average\" needs a map of what it is the mean of");
    if (in->failed)
        return NULL;
    memset(&node, 0, sizeof node);
    node.pattern = class ? parse_pattern_end(in, &r->pattern) : NULL;
    node.space = class ? NULL : parse_pattern_space(in, &r->pattern);
    node.count = map->count;
    node.values = map->values;
    node.amount = r->amount;
    node.accuracy = r->accuracy;
    node.is_scaled = r->is_scaled;
    if (map == &r->map) {
        node.blend = is_average ? BLEND_AVERAGE : map->values ? BLEND_MAP : BLEND_LIST;
        node.normals = map->members;
    } else {
        node.slopes = map->members;
    }
    return textures_normal(in, &node);
}

/* ---- contents ---- */

static const item items[] = {
    { KEYWORD_NORMAL_MAP, read_map }, { KEYWORD_SLOPE_MAP, read_map },     { KEYWORD_BUMP_SIZE, read_number },
    { KEYWORD_ACCURACY, read_number }, { KEYWORD_NO_BUMP_SCALE, read_number },
};
static const item_list list = { "an item of the normal", ITEMS(items), parse_pattern_modifiers, NULL, parse_patterns,
                                VALUE_NORMAL, take_node };

const normal_node *parse_normal_content(pov_reader *in, const normal_node *base, int end)
{
    normal_reading r;

    memset(&r, 0, sizeof r);
    r.amount = 0.5f;
    r.accuracy = 0.02f;
    r.is_scaled = true;
    parse_pattern_begin(&r.pattern);
    if (base)
        take_base(&r, base);
    while (!in->failed && in->token.kind != end)
        if (!read_pattern(in, &r) && !parse_pattern_modifier(in, &r.pattern) && !items_try(in, &list, &r))
            items_refuse(in, &list);
    return make_node(in, &r);
}

const normal_node *parse_normal_upon(pov_reader *in, const normal_node *base)
{
    const normal_node *node;
    block b;

    items_open(in, &b);
    node = parse_normal_content(in, base, '}');
    in->block = b.outer;
    state_close(in, '}');
    return in->failed ? NULL : node;
}

const normal_node *parse_normal_node(pov_reader *in) { return parse_normal_upon(in, in->defaults->normal); }
