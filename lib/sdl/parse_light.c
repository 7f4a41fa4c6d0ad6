#include "sdl/parse.h"
#include "sdl/report.h"
#include "sdl/value.h"

static void move_light(pov_reader *in, void *self, keyword_id keyword)
{
    parse_transform(in, &((object_parsed *)self)->map, keyword);
}

static const keyword_id coming[] = {
    KEYWORD_SPOTLIGHT, KEYWORD_SHADOWLESS, KEYWORD_CYLINDER, KEYWORD_PARALLEL, KEYWORD_POINT_AT, KEYWORD_RADIUS,
    KEYWORD_FALLOFF, KEYWORD_TIGHTNESS, KEYWORD_AREA_LIGHT, KEYWORD_ADAPTIVE, KEYWORD_AREA_ILLUMINATION, KEYWORD_JITTER,
    KEYWORD_CIRCULAR, KEYWORD_ORIENT, KEYWORD_FADE_DISTANCE, KEYWORD_FADE_POWER, KEYWORD_LOOKS_LIKE,
    KEYWORD_PROJECTED_THROUGH, KEYWORD_MEDIA_ATTENUATION, KEYWORD_MEDIA_INTERACTION, KEYWORD_PHOTONS, KEYWORD_OTHER,
};

/* The colour stands behind the position, as in POV-Ray. */
void parse_light(pov_reader *in, object_parsed *out)
{
    static const item items[] = { PARSE_MOVES(move_light) };
    static const item_list list = { "a transformation", ITEMS(items), NULL, NULL, coming, VALUE_NOTHING, NULL };
    place at = in->last;
    block b;

    out->kind = OBJECT_LIGHT;
    out->light.type = LIGHT_POINT;
    out->leaf.line = (uint32_t)at.line;
    out->leaf.column = (uint32_t)at.column;
    items_open(in, &b);
    if (parse_object_follows(in)) {
        parse_object_try(in, out);
        items_close(in, &b, &list, out);
        return;
    }
    out->light.position = value_vector(in);
    state_accept(in, ',');
    if (value_colour_follows(in, true))
        out->light.color = value_colour(in, true).colour;
    else if (in->token.kind == '}')
        report_warn(in, &at, "a light without a colour is black");
    items_close(in, &b, &list, out);
}
