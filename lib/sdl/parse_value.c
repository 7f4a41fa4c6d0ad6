#include "sdl/parse_air.h"
#include "sdl/parse_map.h"
#include "sdl/parse_media.h"
#include "sdl/parse_texture.h"

#include "sdl/array.h"
#include "sdl/function.h"
#include "sdl/spline.h"
#include "sdl/unsupported.h"

#include <string.h>

value parse_part(pov_reader *in, value_kind kind, const void *part, size_t bytes)
{
    void *copy = state_alloc(in, bytes, 16);

    if (copy)
        memcpy(copy, part, bytes);
    return value_of_part(kind, copy);
}

static value surface_value(pov_reader *in, value_kind kind, void (*read)(pov_reader *, surface_parsed *))
{
    surface_parsed s;

    parse_surface_begin(in, &s);
    read(in, &s);
    while (kind == VALUE_TEXTURE && state_accept_keyword(in, KEYWORD_TEXTURE))
        read(in, &s);            /* layers */
    if (kind == VALUE_TEXTURE || kind == VALUE_MATERIAL)
        return parse_part(in, kind, &s, sizeof s);
    return parse_part(in, kind, &s.material, sizeof s.material);
}

static value map_value(pov_reader *in, keyword_id keyword)
{
    const value_kind kind = parse_map_kind(keyword);
    map_parsed map;

    parse_map(in, kind, &map);
    return parse_part(in, kind, &map, sizeof map);
}

static value camera_value(pov_reader *in)
{
    camera_parsed c;

    parse_camera(in, &c);
    return parse_part(in, VALUE_CAMERA, &c, sizeof c);
}

static value object_value(pov_reader *in)
{
    object_parsed o;

    parse_object_try(in, &o);
    return parse_part(in, VALUE_OBJECT, &o, sizeof o);
}

static value read_keyword(pov_reader *in, keyword_id keyword)
{
    switch (keyword) {
    case KEYWORD_ARRAY:
        return array_read(in);
    case KEYWORD_FUNCTION:
        return function_read(in);
    case KEYWORD_SPLINE:
        return spline_read(in);
    case KEYWORD_TRANSFORM:
        return parse_transform_value(in);
    case KEYWORD_TEXTURE:
        return surface_value(in, VALUE_TEXTURE, parse_texture);
    case KEYWORD_PIGMENT:
        return value_of_part(VALUE_PIGMENT, parse_pigment_node(in));
    case KEYWORD_NORMAL:
        return value_of_part(VALUE_NORMAL, parse_normal_node(in));
    case KEYWORD_FINISH:
        return surface_value(in, VALUE_FINISH, parse_finish);
    case KEYWORD_MATERIAL:
        return surface_value(in, VALUE_MATERIAL, parse_material);
    case KEYWORD_INTERIOR:
        return surface_value(in, VALUE_INTERIOR, parse_interior);
    case KEYWORD_DENSITY:
        return value_of_part(VALUE_DENSITY, parse_density_node(in));
    case KEYWORD_CAMERA:
        return camera_value(in);
    case KEYWORD_MEDIA:
        return value_of_part(VALUE_MEDIA, parse_media_node(in));
    case KEYWORD_SKY_SPHERE:
        return value_of_part(VALUE_SKY_SPHERE, parse_sky_node(in));
    case KEYWORD_FOG:
        return value_of_part(VALUE_FOG, parse_fog_node(in));
    case KEYWORD_RAINBOW:
        return value_of_part(VALUE_RAINBOW, parse_rainbow_node(in));
    case KEYWORD_COLOR_MAP: case KEYWORD_COLOUR_MAP: case KEYWORD_PIGMENT_MAP: case KEYWORD_NORMAL_MAP:
    case KEYWORD_TEXTURE_MAP: case KEYWORD_SLOPE_MAP: case KEYWORD_DENSITY_MAP:
        return map_value(in, keyword);
    default:
        return value_of_part(VALUE_NOTHING, NULL);
    }
}

static bool begins_value(keyword_id keyword)
{
    switch (keyword) {
    case KEYWORD_ARRAY: case KEYWORD_FUNCTION: case KEYWORD_SPLINE: case KEYWORD_TRANSFORM: case KEYWORD_TEXTURE:
    case KEYWORD_PIGMENT: case KEYWORD_NORMAL: case KEYWORD_FINISH: case KEYWORD_MATERIAL: case KEYWORD_INTERIOR:
    case KEYWORD_DENSITY: case KEYWORD_CAMERA: case KEYWORD_MEDIA: case KEYWORD_SKY_SPHERE: case KEYWORD_FOG:
    case KEYWORD_RAINBOW: case KEYWORD_COLOR_MAP: case KEYWORD_COLOUR_MAP: case KEYWORD_PIGMENT_MAP:
    case KEYWORD_NORMAL_MAP: case KEYWORD_TEXTURE_MAP: case KEYWORD_SLOPE_MAP: case KEYWORD_DENSITY_MAP:
        return true;
    default:
        return false;
    }
}

bool parse_value(pov_reader *in, value *out)
{
    const keyword_id keyword = state_keyword(in);

    if (begins_value(keyword)) {
        state_advance(in);
        *out = read_keyword(in, keyword);
        return true;
    }
    if (!parse_object_follows(in))
        return false;
    *out = object_value(in);
    return true;
}
