#include "sdl/parse_map.h"

#include "base/vec.h"
#include "sdl/parse_texture.h"
#include "sdl/report.h"
#include "sdl/value.h"
#include "texture/pattern.h"

#include <string.h>

/* Entries as they are read. */
typedef struct entry {
    float value;
    union { pigment pigment; slope_entry slope; const void *node; } as;
} entry;
typedef struct entry_list { entry *items; size_t count, capacity; } entry_list;

/* ---- kinds ---- */

typedef struct map_form {
    keyword_id keyword, member;  /* of the map, and of members' own blocks */
    value_kind kind;
    size_t size;
} map_form;

static const map_form forms[] = {
    { KEYWORD_COLOR_MAP, KEYWORD_OTHER, VALUE_COLOUR_MAP, sizeof(pigment) },
    { KEYWORD_COLOUR_MAP, KEYWORD_OTHER, VALUE_COLOUR_MAP, sizeof(pigment) },
    { KEYWORD_PIGMENT_MAP, KEYWORD_PIGMENT, VALUE_PIGMENT_MAP, sizeof(void *) },
    { KEYWORD_NORMAL_MAP, KEYWORD_NORMAL, VALUE_NORMAL_MAP, sizeof(void *) },
    { KEYWORD_TEXTURE_MAP, KEYWORD_TEXTURE, VALUE_TEXTURE_MAP, sizeof(void *) },
    { KEYWORD_SLOPE_MAP, KEYWORD_OTHER, VALUE_SLOPE_MAP, sizeof(slope_entry) },
    { KEYWORD_DENSITY_MAP, KEYWORD_DENSITY, VALUE_DENSITY_MAP, sizeof(void *) },
};

value_kind parse_map_kind(keyword_id keyword)
{
    for (size_t i = 0; i < sizeof forms / sizeof forms[0]; i++)
        if (forms[i].keyword == keyword)
            return forms[i].kind;
    return VALUE_NOTHING;
}

static const map_form *form_of(value_kind kind)
{
    size_t i = 0;

    while (forms[i].kind != kind)
        i++;
    return &forms[i];
}

/* ---- entries ---- */

static void push(pov_reader *in, entry_list *list, const entry *e)
{
    if (!in->failed && !VEC_PUSH(in->model->env, list, *e))
        report_memory(in);
}

static pigment read_colour(pov_reader *in)
{
    const paint p = value_colour(in, false);
    const pigment out = { p.colour, p.filter, p.transmit };

    return out;
}

/* In old scenes an entry is an interval: two numbers, two colours. What begins with a number may be a colour as well: 2*C. */
static void read_colours(pov_reader *in, entry *first, entry_list *out)
{
    entry second = *first;
    bool is_interval = false, has_colour = false;
    double c[5];

    if (value_follows(in) && !value_colour_follows(in, false)) {
        has_colour = value_components(in, 5, 5, c) > 1;
        is_interval = !has_colour;
        second.value = is_interval ? (float)c[0] : first->value;
        first->as.pigment = (pigment){ colour_of((float)c[0], (float)c[1], (float)c[2]), (float)c[3], (float)c[4] };
    }
    if (is_interval)
        state_accept(in, ',');
    if (!has_colour)
        first->as.pigment = read_colour(in);
    second.as.pigment = first->as.pigment;
    state_accept(in, ',');
    if (in->token.kind != ']')
        second.as.pigment = read_colour(in);
    push(in, out, first);
    if (is_interval)
        push(in, out, &second);
}

static void read_slope(pov_reader *in, entry *e)
{
    double v[2];

    value_components(in, 2, 2, v);
    e->as.slope.height = (float)v[0];
    e->as.slope.slope = (float)v[1];
}

static const void *read_node(pov_reader *in, value_kind kind, int end)
{
    switch (kind) {
    case VALUE_PIGMENT_MAP:
        return parse_pigment_content(in, VALUE_PIGMENT, in->defaults->pigment, end);
    case VALUE_DENSITY_MAP:
        return parse_pigment_content(in, VALUE_DENSITY, NULL, end);
    case VALUE_NORMAL_MAP:
        return parse_normal_content(in, in->defaults->normal, end);
    default:
        return parse_texture_node(in, end);
    }
}

static void read_entry(pov_reader *in, value_kind kind, entry_list *out)
{
    entry e;

    memset(&e, 0, sizeof e);
    e.value = value_follows(in) ? value_float(in) : 1.0f;   /* entries of an average may have no weight */
    state_accept(in, ',');
    if (kind == VALUE_COLOUR_MAP) {
        read_colours(in, &e, out);
        return;
    }
    if (kind == VALUE_SLOPE_MAP)
        read_slope(in, &e);
    else
        e.as.node = read_node(in, kind, ']');
    push(in, out, &e);
}

static void read_entries(pov_reader *in, value_kind kind, entry_list *out)
{
    if (in->token.kind == '}')
        report_expected(in, "\"[\" and the first entry of the map");
    while (!in->failed && in->token.kind != '}') {
        state_open(in, '[');
        read_entry(in, kind, out);
        state_close(in, ']');
        state_accept(in, ',');
    }
}

/* ---- what is kept ---- */

static void keep(pov_reader *in, value_kind kind, const entry_list *list, bool has_values, map_parsed *out)
{
    const size_t size = form_of(kind)->size, count = list->count;
    unsigned char *members = env_alloc(in->model->env, count + 1, size);
    float *values = env_alloc(in->model->env, count + 1, sizeof *values);

    if (!members || !values)
        report_memory(in);
    for (size_t i = 0; i < count && members && values; i++) {
        values[i] = list->items[i].value;
        memcpy(members + i * size, &list->items[i].as, size);
    }
    memset(out, 0, sizeof *out);
    out->kind = kind;
    out->count = (uint32_t)count;
    out->members = in->failed ? NULL : intern(in, members, count * size, count * size);
    out->values = in->failed || !has_values ? NULL : intern(in, values, count * sizeof *values, count * sizeof *values);
    env_free(in->model->env, members);
    env_free(in->model->env, values);
}

static const void *default_of(pov_reader *in, value_kind kind)
{
    static const pigment black = { { 0.0f, 0.0f, 0.0f }, 0.0f, 0.0f };
    surface_parsed s;

    switch (kind) {
    case VALUE_PIGMENT_MAP:
        return in->defaults->pigment ? in->defaults->pigment : textures_constant(in, &black);
    case VALUE_DENSITY_MAP:
        report_expected(in, "\"density\"");
        return NULL;
    case VALUE_NORMAL_MAP:
        return in->defaults->normal;
    default:
        parse_surface_begin(in, &s);
        return parse_surface_node(in, &s);
    }
}

void parse_map_complete(pov_reader *in, uint32_t count, map_parsed *list)
{
    const void *members[PATTERN_LIST_MAX];

    if (in->failed || list->count >= count)
        return;
    if (list->count > 0)
        memcpy(members, list->members, list->count * sizeof *members);
    for (uint32_t i = list->count; i < count; i++)
        members[i] = default_of(in, list->kind);
    list->count = count;
    list->members = in->failed ? NULL : intern(in, members, count * sizeof *members, count * sizeof *members);
}

void parse_map(pov_reader *in, value_kind kind, map_parsed *out)
{
    entry_list list = { NULL, 0, 0 };
    value v;
    block b;

    memset(out, 0, sizeof *out);
    items_open(in, &b);
    if (items_read_named(in, kind, &v)) {
        if (!in->failed)
            *out = *(const map_parsed *)v.as.part;
    } else {
        read_entries(in, kind, &list);
        keep(in, kind, &list, true, out);
    }
    in->block = b.outer;
    state_close(in, '}');
    env_free(in->model->env, list.items);
}

bool parse_map_list(pov_reader *in, value_kind kind, uint32_t most, map_parsed *out)
{
    const keyword_id word = form_of(kind)->member;
    entry_list list = { NULL, 0, 0 };
    entry e;

    if (state_keyword(in) != word)
        return false;
    memset(&e, 0, sizeof e);
    while (!in->failed && list.count < most && state_accept_keyword(in, word)) {
        block b;

        items_open(in, &b);
        e.as.node = read_node(in, kind, '}');
        in->block = b.outer;
        state_close(in, '}');
        state_accept(in, ',');
        push(in, &list, &e);
    }
    keep(in, kind, &list, false, out);
    env_free(in->model->env, list.items);
    return true;
}
