#include "sdl/parse.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"
#include "sdl/value.h"

/* ---- pigment ---- */

/* One colour fills the whole space, so moving it changes nothing; real scenes do it all the same. */
static void move_look(pov_reader *in, void *self, word_id word)
{
    const transform *unused = NULL;

    (void)self;
    parse_transform(in, &unused, word);
}

static const item look_moves[] = {
    { WORD_TRANSLATE, move_look },
    { WORD_ROTATE, move_look },
    { WORD_SCALE, move_look },
    { WORD_MATRIX, move_look },
};

/* Guesses come from the words that a colour begins with. */
static void refuse_pigment(pov_reader *in)
{
    guess g;
    word_id word;

    report_guess_start(&g, in);
    for (word = (word_id)(WORD_OTHER + 1); word < WORD_COUNT; word = (word_id)(word + 1))
        if (token_word_flags(word) & TRAIT_PAINT)
            report_guess_try(&g, token_word_name(word));
    report_misplaced(in, "a colour or \"}\"", &g);
}

void parse_pigment(pov_reader *in, surface_text *s)
{
    static const item_list list = ITEM_LIST("a transformation", look_moves);
    block b;
    paint p;

    s->has_look = true;
    items_open(in, &b);
    if (value_colour_follows(in, false)) {
        p = value_colour(in, false);
        s->material.pigment = p.colour;
        s->material.filter = p.filter;
        s->material.transmit = p.transmit;
    } else if (in->token.kind != '}' && !items_try(in, &list, NULL)) {
        refuse_pigment(in);
    }
    items_close(in, &b, &list, NULL);
}

/* ---- finish ---- */

static void read_ambient(pov_reader *in, void *self, word_id word)
{
    (void)word;
    ((material *)self)->ambient = value_colour(in, true).colour;
}

static void read_diffuse(pov_reader *in, void *self, word_id word)
{
    (void)word;
    ((material *)self)->diffuse = value_float(in);
}

static void read_phong(pov_reader *in, void *self, word_id word)
{
    (void)word;
    ((material *)self)->phong = value_float(in);
}

static void read_phong_size(pov_reader *in, void *self, word_id word)
{
    float size = value_float(in);

    (void)word;
    if (size < 0.0f)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"phong_size\" must not be negative");
    ((material *)self)->phong_size = size;
}

static void read_metallic(pov_reader *in, void *self, word_id word)
{
    (void)word;
    ((material *)self)->metallic = value_follows(in) ? value_float(in) : 1.0f;
}

static void read_reflection(pov_reader *in, void *self, word_id word)
{
    place at = in->last;

    (void)word;
    if (in->token.kind == '{')
        unsupported_form(in, &at, "\"reflection { }\"");
    ((material *)self)->reflection = value_colour(in, true).colour;
}

void parse_finish(pov_reader *in, surface_text *s)
{
    static const item items[] = {
        { WORD_AMBIENT, read_ambient },       { WORD_DIFFUSE, read_diffuse },
        { WORD_PHONG, read_phong },           { WORD_PHONG_SIZE, read_phong_size },
        { WORD_METALLIC, read_metallic },     { WORD_REFLECTION, read_reflection },
    };
    static const item_list list = ITEM_LIST("an item of the finish", items);

    s->has_look = true;
    items_block(in, &list, &s->material);
}

/* ---- texture ---- */

static void texture_pigment(pov_reader *in, void *self, word_id word)
{
    (void)word;
    parse_pigment(in, self);
}

static void texture_finish(pov_reader *in, void *self, word_id word)
{
    (void)word;
    parse_finish(in, self);
}

/* A texture begins with the defaults, whatever stood before it. Upon another look it is a layer: as long as
 * it is opaque it hides what is below. */
void parse_texture(pov_reader *in, surface_text *s)
{
    static const item items[] = {
        { WORD_PIGMENT, texture_pigment }, { WORD_FINISH, texture_finish },
        { WORD_TRANSLATE, move_look },     { WORD_ROTATE, move_look },
        { WORD_SCALE, move_look },         { WORD_MATRIX, move_look },
    };
    static const item_list list = ITEM_LIST("an item of the texture", items);
    bool has_interior = s->material.has_interior;
    double ior = s->material.ior;

    if (s->has_look)
        s->layer = in->last;
    material_init(&s->material);
    s->material.has_interior = has_interior;
    s->material.ior = ior;
    s->has_look = true;
    items_block(in, &list, s);
}

/* ---- interior ---- */

static void read_ior(pov_reader *in, void *self, word_id word)
{
    double ior = value_number(in);

    (void)word;
    if (ior < 0.0)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"ior\" must not be negative");
    if (!in->failed && ior == 0.0) {
        report_warn(in, &in->value, "an ior of 0 counts as 1");
        ior = 1.0;
    }
    ((material *)self)->ior = ior;
}

void parse_interior(pov_reader *in, surface_text *s)
{
    static const item items[] = { { WORD_IOR, read_ior } };
    static const item_list list = ITEM_LIST("an item of the interior", items);

    s->material.has_interior = true;
    s->material.ior = 1.0;
    items_block(in, &list, &s->material);
}
