/* Textures of parts of a shape. */
#include "base/vec.h"
#include "sdl/textures.h"

#include "sdl/parse_texture.h"

#include <string.h>

void parse_parts_begin(pov_reader *in, part_list *parts)
{
    memset(parts, 0, sizeof *parts);
    parts->outer = in->parts;
    in->parts = parts;
}

void parse_parts_end(pov_reader *in, part_list *parts, object_parsed *o)
{
    const size_t bytes = parts->count * sizeof *parts->items;
    const texture **kept = NULL;

    in->parts = parts->outer;
    if (parts->count > 0 && !in->failed) {
        kept = arena_alloc(&in->members, bytes, sizeof(void *));
        if (!kept)
            report_memory(in);
    }
    if (kept)
        memcpy(kept, parts->items, bytes);
    o->parts = kept;
    o->part_count = kept ? (uint32_t)parts->count : 0;
    o->both_sides = parts->of_components;
    env_free(in->model->env, parts->items);
}

/* Equal ones are one. */
static uint32_t number_of_texture(pov_reader *in, const texture *t)
{
    part_list *parts = in->parts;

    if (in->failed || !parts)
        return 0;
    for (size_t i = parts->count; i-- > 0;)
        if (parts->items[i] == t)
            return (uint32_t)i;
    if (!VEC_PUSH(in->model->env, parts, t))
        report_memory(in);
    return in->failed ? 0 : (uint32_t)(parts->count - 1);
}

static uint32_t number_of(pov_reader *in, surface_parsed *s)
{
    return number_of_texture(in, in->failed ? NULL : parse_surface_node(in, s));
}

uint32_t parse_part_content(pov_reader *in, int end) { return number_of_texture(in, parse_texture_node(in, end)); }

uint32_t parse_part_texture(pov_reader *in)
{
    surface_parsed s;

    parse_surface_begin(in, &s);
    parse_texture(in, &s);
    return number_of(in, &s);
}

static bool read_part(pov_reader *in, surface_parsed *s)
{
    switch (state_keyword(in)) {
    case KEYWORD_TEXTURE:
        state_advance(in);
        parse_texture(in, s);
        return true;
    case KEYWORD_PIGMENT:
        state_advance(in);
        parse_pigment(in, s);
        return true;
    case KEYWORD_NORMAL:
        state_advance(in);
        parse_normal(in, s);
        return true;
    case KEYWORD_FINISH:
        state_advance(in);
        parse_finish(in, s);
        return true;
    default:
        return false;
    }
}

bool parse_component_texture(pov_reader *in, uint32_t *number)
{
    part_list *parts = in->parts;
    bool read = false;

    if (in->failed || !parts)
        return false;
    if (*number == POV_OWN_TEXTURE) {
        parse_surface_begin(in, &parts->component);
        parts->textured = parts->stale = false;
        parts->before = parts->count;
    }
    while (!in->failed && read_part(in, &parts->component))
        read = true;
    parts->textured |= read;
    parts->of_components |= read;
    if (read || parts->stale) {
        parts->count = parts->before;
        *number = number_of(in, &parts->component);
    }
    parts->stale = false;
    return read;
}

void parse_component_move(pov_reader *in, const transform *moves)
{
    part_list *parts = in->parts;

    if (in->failed || !parts || !parts->textured)
        return;
    parse_surface_move(in, &parts->component, moves);
    parts->stale = true;
}

/* Textures of the object were written behind the first of the transformations, those of the parts before all of them. */
static const texture *own_texture(pov_reader *in, const texture *own, const surface_parsed *s, const transform *map, uint32_t moves)
{
    for (; map && moves > 0; moves--)
        map = map->before;
    return own && map && !s->uv ? textures_move(in, own, parse_invert_transforms(in, map)) : own;
}

/* What has moved a part's texture before it stands upon uv coordinates: behind a mesh's word nothing does, as of its own texture,
 * but of components all. */
static const transform *part_moves(const object_parsed *o, const transform *map, const surface_parsed *s)
{
    const surface_parsed *own = parse_surface_of(o);

    return !s->uv ? NULL : own->uv && !o->both_sides ? own->before_uv : map;
}

void parse_parts_surface(pov_reader *in, const object_parsed *o, const transform *map, uint32_t moves,
                         surface_parsed *s)
{
    const texture **all = env_resize(in->model->env, NULL, o->part_count + 1, sizeof *all);
    texture node;

    if (!all) {
        report_memory(in);
        return;
    }
    memset(&node, 0, sizeof node);
    for (uint32_t i = 0; i < o->part_count; i++)
        all[i] = textures_move(in, o->parts[i], part_moves(o, map, s));
    all[o->part_count] = own_texture(in, parse_surface_node(in, s), s, map, moves);
    s->inside = own_texture(in, s->inside, s, map, moves);
    node.blend = BLEND_PARTS;
    node.count = o->part_count + 1;
    node.textures = all;
    if (!in->failed)
        s->whole = textures_texture(in, &node);
    s->under = NULL;
    env_free(in->model->env, all);
}
