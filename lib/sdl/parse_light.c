#include "sdl/parse.h"
#include "sdl/report.h"
#include "sdl/value.h"

#include "base/vec.h"

typedef struct light_text {
    pov_vec3 position;
    colour colour;
    const transform *map;
} light_text;

static void move_light(pov_reader *in, void *self, word_id word)
{
    parse_transform(in, &((light_text *)self)->map, word);
}

static void add_light(pov_reader *in, const light_text *text, const place *at)
{
    light l;
    pov_affine map;
    bool is_fine;

    if (in->failed)
        return;
    l.type = LIGHT_POINT;
    l.color = text->colour;
    l.position = text->position;
    l.position_lo = pov_vec3_of(0.0, 0.0, 0.0);
    is_fine = !text->map || transform_compose(text->map, &map);
    if (text->map && is_fine)
        transform_point(&map, text->position, &l.position, &l.position_lo);
    if (!is_fine || !parse_is_finite(l.position) || !parse_is_finite(l.position_lo))
        report_fail(in, at, POV_E_SYNTAX, "the light is moved beyond what a double holds");
    if (!in->failed && !VEC_PUSH(in->model->env, &in->model->lights, l))
        report_memory(in);
}

/* The colour stands behind the position, as in POV-Ray. */
void parse_light(pov_reader *in, void *self, word_id word)
{
    static const item items[] = {
        { WORD_TRANSLATE, move_light },
        { WORD_ROTATE, move_light },
        { WORD_SCALE, move_light },
        { WORD_MATRIX, move_light },
    };
    static const item_list list = ITEM_LIST("a transformation", items);
    light_text text = { { 0.0, 0.0, 0.0 }, { 0.0f, 0.0f, 0.0f }, NULL };
    place at = in->last;
    block b;

    (void)self;
    (void)word;
    items_open(in, &b);
    text.position = value_vector(in);
    state_accept(in, ',');
    if (value_colour_follows(in, true))
        text.colour = value_colour(in, true).colour;
    else if (in->token.kind == '}')
        report_warn(in, &at, "a light without a colour is black");
    items_close(in, &b, &list, &text);
    add_light(in, &text, &at);
}
