#include "sdl/parse.h"

#include "base/vec.h"
#include "sdl/host.h"
#include "sdl/materials.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"

#include <string.h>

/* ---- modifiers ---- */

typedef struct object_text {
    surface_text surface;
    const transform *map;
    uint32_t flags;
} object_text;

static void read_pigment(pov_reader *in, void *self, word_id word)
{
    (void)word;
    parse_pigment(in, &((object_text *)self)->surface);
}

static void read_finish(pov_reader *in, void *self, word_id word)
{
    (void)word;
    parse_finish(in, &((object_text *)self)->surface);
}

static void read_texture(pov_reader *in, void *self, word_id word)
{
    (void)word;
    parse_texture(in, &((object_text *)self)->surface);
}

static void read_interior(pov_reader *in, void *self, word_id word)
{
    (void)word;
    parse_interior(in, &((object_text *)self)->surface);
}

static void move_object(pov_reader *in, void *self, word_id word)
{
    parse_transform(in, &((object_text *)self)->map, word);
}

/* `inverse` twice is the shape as it was. */
static void read_flag(pov_reader *in, void *self, word_id word)
{
    object_text *o = self;

    (void)in;
    if (word == WORD_INVERSE)
        o->flags ^= LEAF_INVERSE;
    else
        o->flags |= word == WORD_NO_SHADOW ? LEAF_NO_SHADOW : LEAF_HOLLOW;
}

static const item modifier_items[] = {
    { WORD_PIGMENT, read_pigment },   { WORD_FINISH, read_finish },   { WORD_TRANSLATE, move_object },
    { WORD_ROTATE, move_object },     { WORD_SCALE, move_object },    { WORD_TEXTURE, read_texture },
    { WORD_INTERIOR, read_interior }, { WORD_MATRIX, move_object },   { WORD_NO_SHADOW, read_flag },
    { WORD_INVERSE, read_flag },      { WORD_HOLLOW, read_flag },
};

static const item_list modifiers = ITEM_LIST("an object modifier", modifier_items);

/* ---- the shape ---- */

static void guess_keyword(void *user, const char *keyword)
{
    report_guess_try(user, keyword);
}

/* No plugin offers the word: then it is to come, or missing, or a slip. */
static void refuse(pov_reader *in, const symbol *word)
{
    guess g;
    size_t i;
    const char *name;
    word_id id;
    uint32_t flags;

    if (word->flags & TRAIT_SHAPE) {
        report_fail(in, &in->token.at, POV_E_PLUGIN, "no plugin for \"%s\" in %s", word->name,
                    registry_path(in->plugins));
        return;
    }
    report_guess_start(&g, in);
    for (i = 0; (name = token_word(i, &id, &flags)) != NULL; i++)
        if (flags & TRAIT_SHAPE)
            report_guess_try(&g, name);
    parse_scene_guess(&g);
    registry_each_keyword(in->plugins, "primitives", guess_keyword, &g);
    report_misplaced(in, "an object or a setting", &g);
}

/* The word that is next, which names a class; NULL: none does, and the reader has failed. */
static symbol *find_shape(pov_reader *in)
{
    symbol *word = in->token.symbol;
    pov_error error;

    if (!word)
        word = symbols_add(&in->words, &in->model->memory, in->token.at.start, in->token.at.length);
    if (!word) {
        report_memory(in);
        return NULL;
    }
    if (word->shape)
        return word;
    if (registry_shape(in->plugins, word->name, &word->shape, &error) < 0)
        report_pass_on(in, &in->token.at, &error);
    else if (!word->shape)
        refuse(in, word);
    return word->shape ? word : NULL;
}

/* An opaque layer hides what is below it; one that can be seen through does not. */
static void check_layers(pov_reader *in, const surface_text *s)
{
    if (s->layer.source && material_is_transparent(&s->material))
        unsupported_form(in, &s->layer, "a transparent texture upon another");
}

static void add_object(pov_reader *in, leaf_node *o, const object_text *text)
{
    o->map = text->map;
    o->flags = text->flags;
    o->material = materials_index(in, &text->surface.material);
    if (!in->failed && !VEC_PUSH(in->model->env, &in->model->leaves, *o))
        report_memory(in);
}

static size_t parsed_size(const shape_class *shape)
{
    return shape->prepare ? shape->parsed_size : shape->instance_size;
}

/* Many a scene is of a few shapes in many places: what was written as it was the last time that its word stood there is
 * kept once. */
static void share_text(pov_reader *in, symbol *word, leaf_node *o)
{
    const size_t bytes = parsed_size(o->shape);

    if (word->last && memcmp(word->last, o->instance, bytes) == 0 &&
        arena_give_back(&in->model->memory, o->instance, bytes))
        o->instance = word->last;
    word->last = o->instance;
}

void parse_object(pov_reader *in)
{
    symbol *word = find_shape(in);
    leaf_node o;
    object_text text;
    block b;

    if (!word)
        return;
    o.shape = word->shape;
    o.line = (uint32_t)in->token.at.line;
    o.column = (uint32_t)in->token.at.column;
    memset(&text, 0, sizeof text);
    material_init(&text.surface.material);
    in->value = in->token.at;
    state_advance(in);
    items_open(in, &b);
    o.instance = state_alloc(in, parsed_size(o.shape), 32);
    if (o.instance)
        o.shape->parse(o.instance, &host_functions, in);
    if (!in->failed)
        share_text(in, word, &o);
    items_close(in, &b, &modifiers, &text);
    check_layers(in, &text.surface);
    add_object(in, &o, &text);
}
