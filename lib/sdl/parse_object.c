#include "sdl/parse_texture.h"

#include "sdl/expression.h"
#include "sdl/host.h"
#include "sdl/object_query.h"
#include "sdl/parse_media.h"
#include "sdl/parse_photons.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"
#include "sdl/value.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

/* ---- modifiers ---- */

/* Transformations move the texture that stands before them, not what follows. */
static surface_parsed *surface_of(pov_reader *in, object_parsed *o)
{
    surface_parsed *s = &o->surface;

    if (s->moves > 0 && !in->failed)
        parse_surface_move(in, s, parse_last_transforms(in, o->map, s->moves));
    s->moves = 0;
    parse_surface_default(in->defaults, s);
    return s;
}

static void read_pigment(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_pigment(in, surface_of(in, self));
}

static void read_finish(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    object_parsed *o = self;

    parse_surface_default(in->defaults, &o->surface);
    parse_finish(in, &o->surface);
}

static void read_texture(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_texture(in, surface_of(in, self));
}

static void read_normal(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_normal(in, surface_of(in, self));
}

static void read_uv(pov_reader *in, void *self, keyword_id keyword)
{
    object_parsed *o = self;

    (void)keyword;
    o->surface.uv = value_optional(in, 1.0) != 0.0;
    o->surface.before_uv = o->map;
}

static void read_inside(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_interior_texture(in, surface_of(in, self));
}

static void read_interior(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_interior(in, &((object_parsed *)self)->surface);
}

static void read_material(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_material(in, surface_of(in, self));
}

/* So many transformations came behind what was read before. */
static void moved(pov_reader *in, object_parsed *o, uint32_t moves)
{
    const media **filling = &o->surface.material.interior.media;

    o->surface.moves += moves;
    if (*filling && moves > 0 && !in->failed)
        *filling = parse_media_move(in, *filling, parse_last_transforms(in, o->map, moves));
}

static void move_object(pov_reader *in, void *self, keyword_id keyword)
{
    object_parsed *o = self;
    const uint32_t before = parse_count_transforms(o->map);

    parse_transform(in, &o->map, keyword);
    moved(in, o, parse_count_transforms(o->map) - before);
}

bool parse_object_matrix(pov_reader *in, object_parsed *o, const double m[12])
{
    const transform *before = o->map;

    if (!parse_append_matrix(in, &o->map, m))
        return false;
    moved(in, o, o->map != before);
    return true;
}

typedef struct flag_word { keyword_id keyword; uint32_t flag; } flag_word;

/* The words that a number may switch off again. */
static uint32_t switched_flag(keyword_id keyword)
{
    static const flag_word words[] = {
        { KEYWORD_HOLLOW, LEAF_HOLLOW },           { KEYWORD_DOUBLE_ILLUMINATE, LEAF_DOUBLE_ILLUMINATE },
        { KEYWORD_NO_IMAGE, LEAF_NO_IMAGE },       { KEYWORD_NO_REFLECTION, LEAF_NO_REFLECTION },
        { KEYWORD_NO_RADIOSITY, LEAF_NO_RADIOSITY },
    };

    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (words[i].keyword == keyword)
            return words[i].flag;
    return 0;
}

/* `inverse` twice is the shape as it was. */
static void read_flag(pov_reader *in, void *self, keyword_id keyword)
{
    const uint32_t flag = switched_flag(keyword);
    object_parsed *o = self;

    if (keyword == KEYWORD_INVERSE)
        o->flags ^= LEAF_INVERSE;
    else if (keyword == KEYWORD_NO_SHADOW)
        o->flags |= LEAF_NO_SHADOW;
    else if (value_optional(in, 1.0) != 0.0)
        o->flags |= flag;
    else
        o->flags &= ~flag;
}

/* Neighbours mostly have one surface. NULL: no memory. */
static const surface_parsed *share_surface(pov_reader *in, const surface_parsed *s)
{
    surface_parsed *fresh;

    if (in->shared_surface && memcmp(in->shared_surface, s, sizeof *s) == 0)
        return in->shared_surface;
    fresh = arena_alloc(&in->members, sizeof *fresh, sizeof(double));
    if (fresh)
        in->shared_surface = memcpy(fresh, s, sizeof *s);
    return fresh;
}

object_parsed *parse_keep(pov_reader *in, const object_parsed *o)
{
    const bool is_whole = o->kind == OBJECT_LIGHT;
    const size_t bytes = is_whole ? sizeof *o : offsetof(object_parsed, surface);
    const surface_parsed *own = in->failed || is_whole || o->shared ? o->shared : share_surface(in, &o->surface);
    object_parsed *kept = in->failed || (!is_whole && !own) ? NULL : arena_alloc(&in->members, bytes, sizeof(double));

    if (!kept) {
        report_memory(in);
        return NULL;
    }
    memcpy(kept, o, bytes);
    kept->shared = own;
    return kept;
}

static void move_listed(pov_reader *in, void *self, keyword_id keyword) { parse_transform(in, self, keyword); }

static const item list_moves[] = { PARSE_MOVES(move_listed) };
static const item_list clip_items = { "an object that clips, a transformation", ITEMS(list_moves), NULL, NULL, NULL, VALUE_NOTHING, NULL };
static const item_list bound_items = { "an object that bounds, a transformation", ITEMS(list_moves), NULL, NULL, NULL, VALUE_NOTHING, NULL };

/* What is in the list already may be a named object's as well. */
static void put_before(pov_reader *in, object_parsed **list, const object_parsed *member)
{
    object_parsed *kept = parse_keep(in, member);

    if (!kept)
        return;
    kept->next = *list;
    *list = kept;
}

/* A word that is none may be a slip of another one, or of a name. */
static void expect_object(pov_reader *in)
{
    guess g = { .word = "" };

    if (in->token.kind == TOKEN_WORD && !in->token.symbol->binding && !in->token.symbol->intrinsic) {
        report_guess_start(&g, in);
        report_guess_names(&g, in);
        parse_shapes_guess(in, &g);
    }
    report_expected_guess(in, "an object", &g);
}

/* The objects of a block, or with the word of the other list those that are in it. */
static void read_list(pov_reader *in, const object_parsed *o, object_parsed **list, const object_parsed *other, keyword_id word)
{
    object_parsed member;

    if (state_accept_keyword(in, word)) {
        for (; other && !in->failed; other = other->next)
            put_before(in, list, other);
        return;
    }
    if (!parse_object_follows(in))
        expect_object(in);
    while (!in->failed && parse_object_try(in, &member)) {
        member.since = o->map;
        put_before(in, list, &member);
    }
}

/* Transformations at the end of the block move all its objects. */
static void read_block(pov_reader *in, const object_parsed *o, object_parsed **list, const object_parsed *other, keyword_id word,
                       const item_list *items)
{
    const object_parsed *before = *list;
    const transform *moves = NULL;
    block b;

    items_open(in, &b);
    read_list(in, o, list, other, word);
    items_close(in, &b, items, &moves);
    for (object_parsed *member = *list; moves && member != before && !in->failed; member = member->next)
        parse_append_transforms(in, &member->map, moves, NULL);
}

/* Each object there clips. */
static void read_clips(pov_reader *in, void *self, keyword_id keyword)
{
    object_parsed *o = self;

    (void)keyword;
    read_block(in, o, &o->clips, o->bounds, KEYWORD_BOUNDED_BY, &clip_items);
}

/* Bounds are found without these. */
static void read_bounds(pov_reader *in, void *self, keyword_id keyword)
{
    object_parsed *o = self;

    (void)keyword;
    read_block(in, o, &o->bounds, o->clips, KEYWORD_CLIPPED_BY, &bound_items);
}

/* Old scenes have a colour right in the object. */
static void skip_colour(pov_reader *in, void *self, keyword_id keyword)
{
    double unused[5];

    (void)self;
    report_warn(in, &in->last, "\"%s\" has no effect outside of a pigment", token_keyword_name(keyword));
    value_colour_components(in, true, unused);
}

static void skip_named_colour(pov_reader *in, void *self, const value *v)
{
    (void)self;
    if (v->size != 5)
        report_fail(in, &in->value, POV_E_SYNTAX, "a vector does not belong in an object");
    else
        report_warn(in, &in->value, "a colour has no effect outside of a pigment");
}

static void read_global_lights(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    ((object_parsed *)self)->global_lights = value_optional(in, 1.0) != 0.0;
}

static void read_photons(pov_reader *in, void *self, keyword_id keyword)
{
    (void)keyword;
    parse_photons_object(in, &((object_parsed *)self)->flags);
}

/* Of other objects it makes no sense. */
static void read_cutaway(pov_reader *in, void *self, keyword_id keyword)
{
    object_parsed *o = self;

    if (o->kind != OBJECT_GROUP || (o->op != NODE_INTERSECTION && o->op != NODE_DIFFERENCE))
        report_fail(in, &in->last, POV_E_SYNTAX, "\"%s\" belongs to an intersection or a difference",
                    token_keyword_name(keyword));
    o->flags |= LEAF_CUTAWAY;
}

static const item modifier_items[] = {
    { KEYWORD_GLOBAL_LIGHTS, read_global_lights }, { KEYWORD_CUTAWAY_TEXTURES, read_cutaway },
    { KEYWORD_PIGMENT, read_pigment },   { KEYWORD_FINISH, read_finish },     { KEYWORD_TEXTURE, read_texture },
    PARSE_MOVES(move_object),            { KEYWORD_INTERIOR, read_interior }, { KEYWORD_NO_SHADOW, read_flag },
    { KEYWORD_INVERSE, read_flag },      { KEYWORD_HOLLOW, read_flag },       { KEYWORD_NORMAL, read_normal },
    { KEYWORD_MATERIAL, read_material }, { KEYWORD_COLOR, skip_colour },      { KEYWORD_COLOUR, skip_colour },
    { KEYWORD_RGB, skip_colour },        { KEYWORD_RGBF, skip_colour },        { KEYWORD_RGBT, skip_colour },
    { KEYWORD_RGBFT, skip_colour },        { KEYWORD_CLIPPED_BY, read_clips },
    { KEYWORD_BOUNDED_BY, read_bounds },
    { KEYWORD_INTERIOR_TEXTURE, read_inside }, { KEYWORD_UV_MAPPING, read_uv },
    { KEYWORD_DOUBLE_ILLUMINATE, read_flag }, { KEYWORD_NO_IMAGE, read_flag },
    { KEYWORD_NO_REFLECTION, read_flag }, { KEYWORD_NO_RADIOSITY, read_flag }, { KEYWORD_PHOTONS, read_photons },
};

static const keyword_id quiet[] = { KEYWORD_STURM, KEYWORD_HIERARCHY, KEYWORD_SPLIT_UNION,
                                    KEYWORD_QUICK_COLOR, KEYWORD_QUICK_COLOUR,
                                    KEYWORD_RADIOSITY, KEYWORD_OTHER };
static const keyword_id coming[] = { KEYWORD_NO_BUMP_SCALE, KEYWORD_OTHER };
static const item_list modifiers = { "an object modifier", ITEMS(modifier_items), quiet, NULL, coming, VALUE_VECTOR,
                                     skip_named_colour };

void parse_modifiers(pov_reader *in, object_parsed *o, int end) { items_until(in, end, &modifiers, o); }

void parse_object_colour(pov_reader *in, object_parsed *o, const pigment *p)
{
    parse_surface_colour(in, surface_of(in, o), p);
}

/* ---- the shape ---- */

/* No plugin offers the word: then it is missing, or a slip. */
static void refuse(pov_reader *in, const symbol *word)
{
    guess g;

    if (word->flags & KEYWORD_FLAG_SHAPE) {
        report_fail(in, &in->token.at, POV_E_PLUGIN, "no plugin for \"%s\" in %s", word->name,
                    registry_path(in->plugins));
        return;
    }
    report_guess_start(&g, in);
    parse_shapes_guess(in, &g);
    parse_scene_guess(&g);
    report_misplaced(in, "an object or a setting", &g);
}

static const object_parsed *named_object(const pov_reader *in)
{
    const value *slot = in->token.kind == TOKEN_WORD ? scope_value(in->token.symbol) : NULL;

    if (!slot)
        return NULL;
    if (slot->kind == VALUE_OBJECT)
        return slot->as.part;
    return NULL;
}

/* Is an array of these, or of arrays of these. */
static bool holds_objects(const array *a)
{
    size_t i;

    for (i = 0; a->kind == VALUE_ARRAY && i < a->count; i++)
        if (a->items[i].kind == VALUE_ARRAY)
            return holds_objects(value_array(&a->items[i]));
    return a->kind == VALUE_OBJECT;
}

static bool element_follows(const pov_reader *in)
{
    const value *slot = in->token.kind == TOKEN_WORD ? scope_value(in->token.symbol) : NULL;

    return slot && slot->kind == VALUE_ARRAY && holds_objects(value_array(slot));
}

/* The name of an object, or of an element of an array of them, is next. */
static void take_named(pov_reader *in, object_parsed *o)
{
    value v = expression_read(in);

    if (!in->failed && v.kind == VALUE_OBJECT)
        *o = *(const object_parsed *)v.as.part;
    else if (!in->failed)
        report_fail(in, &in->value, POV_E_SYNTAX, "expected an object, found %s", value_name(&v));
    o->next = NULL;
    o->is_named = true;
    if (value_is_shared(&v))
        value_drop(&in->heap, &v);
}

/* An object has the defaults that hold at its last brace; what comes behind may change them before it is added. */
static void close_object(pov_reader *in, block *b, object_parsed *o)
{
    items_until(in, '}', &modifiers, o);
    if (!b->outer && in->placing) {
        *in->placing = *in->defaults;
        in->placing = NULL;
    }
    items_close(in, b, &modifiers, o);
}

static void read_leaf(pov_reader *in, symbol *word, object_parsed *o)
{
    part_list parts;
    block b;

    o->kind = OBJECT_LEAF;
    o->leaf.shape = word->shape;
    in->value = in->token.at;
    state_advance(in);
    items_open(in, &b);
    if (named_object(in) || element_follows(in)) {   /* any object's word may stand before the block of a name */
        take_named(in, o);
        close_object(in, &b, o);
        return;
    }
    o->leaf.instance = state_alloc(in, parse_shape_size(word->shape), 32);
    parse_parts_begin(in, &parts);
    in->has_faces = word->shape->face != NULL;
    if (o->leaf.instance)
        word->shape->parse(o->leaf.instance, &host_functions, in);
    parse_parts_end(in, &parts, o);
    if (!in->failed)
        parse_share_shape(in, word, &o->leaf);
    close_object(in, &b, o);
}

/* ---- other objects ---- */

static void read_members(pov_reader *in, const place *at, object_parsed *o)
{
    object_parsed **end = &o->first, member;

    while (!in->failed && parse_object_try(in, &member)) {
        *end = parse_keep(in, &member);
        if (*end)
            end = &(*end)->next;
    }
    o->content = object_content_of_members(o);
    if (!in->failed && !(o->first && o->first->next))
        report_warn(in, at, o->first ? "there is only one object in this %s" : "there is nothing in this %s", model_op_keyword(o->op));
}

static void read_group(pov_reader *in, node_op op, object_parsed *o)
{
    const place at = in->token.at;
    block b;

    o->kind = OBJECT_GROUP;
    o->op = op;
    state_advance(in);
    items_open(in, &b);
    if (named_object(in))        /* a name that stands first is the whole */
        take_named(in, o);
    else
        read_members(in, &at, o);
    close_object(in, &b, o);
}

static void read_light_group(pov_reader *in, object_parsed *o)
{
    o->is_light_group = true;
    read_group(in, NODE_UNION, o);
}

static bool is_array_of_objects(const pov_reader *in)
{
    const value *slot = in->token.kind == TOKEN_WORD ? scope_value(in->token.symbol) : NULL;

    return slot && slot->kind == VALUE_ARRAY && value_array(slot)->kind != VALUE_NUMBER &&
           value_array(slot)->kind != VALUE_VECTOR;
}

/* `object { S ... }`, or any object's word before such a block. */
static void read_wrapped(pov_reader *in, object_parsed *o)
{
    object_parsed inner;
    block b;

    state_advance(in);
    items_open(in, &b);
    if (parse_object_try(in, &inner)) {
        const uint32_t line = o->leaf.line, column = o->leaf.column;

        *o = inner;
        o->leaf.line = line;
        o->leaf.column = column;
    } else {
        expect_object(in);
    }
    close_object(in, &b, o);
}

/* A word of a plugin that no object of the scene has had yet. */
static bool is_new_shape(pov_reader *in, symbol *word)
{
    return word->id == KEYWORD_OTHER && !word->binding && !word->intrinsic && parse_shape_class(in, word);
}

bool parse_object_follows(pov_reader *in)
{
    symbol *word = in->token.symbol;

    if (in->token.kind != TOKEN_WORD)
        return false;
    switch (word->id) {
    case KEYWORD_OBJECT: case KEYWORD_UNION: case KEYWORD_COMPOSITE: case KEYWORD_MERGE: case KEYWORD_INTERSECTION:
    case KEYWORD_DIFFERENCE: case KEYWORD_LIGHT_SOURCE: case KEYWORD_LIGHT_GROUP:
        return true;
    default:
        return (word->flags & KEYWORD_FLAG_SHAPE) || word->shape || named_object(in) || is_array_of_objects(in) || is_new_shape(in, word);
    }
}

void parse_object_begin(pov_reader *in, object_parsed *o)
{
    memset(o, 0, sizeof *o);
    parse_surface_begin(in, &o->surface);
    o->leaf.line = (uint32_t)in->token.at.line;
    o->leaf.column = (uint32_t)in->token.at.column;
}

static bool is_shape_keyword(const symbol *word)
{
    return (word->flags & KEYWORD_FLAG_SHAPE) != 0;
}

bool parse_object_try(pov_reader *in, object_parsed *o)
{
    symbol *word = in->token.symbol;

    parse_object_begin(in, o);
    if (in->token.kind != TOKEN_WORD)
        return false;
    switch (word->id) {
    case KEYWORD_OBJECT:
        read_wrapped(in, o);
        break;
    case KEYWORD_UNION: case KEYWORD_COMPOSITE:
        read_group(in, NODE_UNION, o);
        break;
    case KEYWORD_MERGE:
        read_group(in, NODE_MERGE, o);
        break;
    case KEYWORD_INTERSECTION:
        read_group(in, NODE_INTERSECTION, o);
        break;
    case KEYWORD_DIFFERENCE:
        read_group(in, NODE_DIFFERENCE, o);
        break;
    case KEYWORD_LIGHT_GROUP:
        read_light_group(in, o);
        break;
    case KEYWORD_LIGHT_SOURCE:
        state_advance(in);
        parse_light(in, o);
        break;
    default:
        if (word->binding && parse_object_follows(in))
            take_named(in, o);
        else if (word->binding || (word->id != KEYWORD_OTHER && !is_shape_keyword(word)))
            return false;
        else if (parse_shape_class(in, word))
            read_leaf(in, word, o);
        else
            return false;
    }
    if (!in->failed && parse_surface_of(o)->inside && !parse_surface_of(o)->has_look)
        report_fail(in, &in->value, POV_E_SYNTAX, "an interior_texture needs a texture of the same object beside it");
    return !in->failed;
}

/* ---- a statement ---- */

void parse_object(pov_reader *in)
{
    surface_parsed defaults = *in->defaults;
    object_parsed o;

    in->object = in->token.at;
    in->placed = in->placing = &defaults;
    if (parse_object_try(in, &o))
        parse_add_object(in, &o);
    else if (!in->failed)
        refuse(in, in->token.symbol);
    in->placing = NULL;
}
