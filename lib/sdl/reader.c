#include "sdl/reader.h"

#include "base/clock.h"
#include "base/hash.h"
#include "base/str.h"
#include "base/vec.h"
#include "sdl/directive.h"
#include "sdl/frame.h"
#include "sdl/include.h"
#include "sdl/intrinsic.h"
#include "sdl/limit.h"
#include "sdl/macro.h"
#include "sdl/parse_copies.h"
#include "sdl/parse_arrays.h"
#include "sdl/parse_pattern.h"
#include "sdl/parse_radiosity.h"
#include "sdl/recover.h"
#include "sdl/report.h"
#include "sdl/text.h"
#include "sdl/text_file.h"

#include <stdlib.h>
#include <string.h>

/* ---- is it a text? ---- */

enum { LOOK_AT = 1024 };

static bool is_utf16(const unsigned char *t, size_t length)
{
    if (length < 2)
        return false;
    return (t[0] == 0xFF && t[1] == 0xFE) || (t[0] == 0xFE && t[1] == 0xFF) ||
           (length >= 4 && ((t[0] == 0 && t[1] != 0 && t[2] == 0) || (t[0] != 0 && t[1] == 0 && t[3] == 0)));
}

/* Said at once, for the first odd byte of such a file would puzzle more than it tells. */
static void refuse_other_files(pov_reader *in, const char *text, size_t length)
{
    const char *zero = memchr(text, '\0', length < LOOK_AT ? length : LOOK_AT), *at;
    place here = { in->top->text, in->top->text->text, 0, 1, 1 };

    if (is_utf16((const unsigned char *)text, length)) {
        report_fail(in, &here, POV_E_SYNTAX, "this text is in UTF-16; save it as UTF-8");
    } else if (zero) {
        for (at = here.start; at < zero; at++) {
            here.column++;
            if (*at == '\n') {
                here.line++;
                here.column = 1;
            }
        }
        here.start = zero;
        report_fail(in, &here, POV_E_SYNTAX, "a zero byte: this is not a text");
    }
}

/* ---- start and end ---- */

/* Where addresses are short a quarter of them. */
#define MEMORY_OF_VALUES (SIZE_MAX / 4 < (uint64_t)1 << 34 ? SIZE_MAX / 4 : (size_t)((uint64_t)1 << 34))

static const reader_limits default_limits = { 1200, (size_t)1 << 27, (size_t)1 << 28, (uint64_t)1 << 30,
                                              MEMORY_OF_VALUES, 3600.0, SIZE_MAX, SIZE_MAX };

static void choose_limits(reader_limits *l, const reader_options *options)
{
    *l = default_limits;
    if (!options)
        return;
    if (options->limits.depth)
        l->depth = options->limits.depth;
    if (options->limits.array)
        l->array = options->limits.array;
    if (options->limits.string)
        l->string = options->limits.string;
    if (options->limits.turns)
        l->turns = options->limits.turns;
    if (options->limits.memory)
        l->memory = options->limits.memory;
    if (options->limits.seconds > 0.0)
        l->seconds = options->limits.seconds;
    if (options->limits.input)
        l->input = options->limits.input;
    if (options->limits.images)
        l->images = options->limits.images;
}

/* What a shared item refers to is let go of. */
static void drop_shared(value_heap *heap, shared *dropped)
{
    size_t i;

    if (dropped->kind == VALUE_ARRAY) {
        for (i = 0; i < ((array *)dropped)->count; i++)
            value_drop(heap, &((array *)dropped)->items[i]);
    } else if (dropped->kind == VALUE_MACRO) {
        macro *m = (macro *)dropped;

        if (m->tokens)
            token_buffer_release(m->buffers, m->tokens);
    } else if (dropped->kind == VALUE_NOTHING) {
        binding *b = (binding *)dropped;

        value_drop(heap, &b->own);
        if (b->lender)
            value_unshare(heap, b->lender);
    }
}

static bool start(pov_reader *in, model *m, registry *plugins, const reader_options *options)
{
    memset(in, 0, sizeof *in);
    in->model = m;
    in->plugins = plugins;
    in->options = options;
    in->wanted = "a value";
    in->wanted_dialect = options ? options->dialect : POV_DIALECT_AUTO;
    choose_limits(&in->limits, options);
    in->started = clock_seconds();
    in->until_told = LIMIT_TELL_EVERY;
    include_init(in);
    parse_camera_defaults(&in->camera);
    m->adc_bailout = 1.0 / 255.0;
    m->max_trace_level = 5;
    parse_radiosity_init(m);
    m->subsurface.mm_per_unit = 10.0;
    m->photons.max_trace_level = -1;
    m->photons.adc_bailout = -1.0;
    source_init(&in->sources, m->env);
    in->buffers.env = m->env;
    in->heap.env = m->env;
    in->heap.drop = drop_shared;
    in->heap.most_bytes = in->limits.memory;
    arena_init(&in->members, m->env);
    if (!symbols_init(&in->words, m->env))
        return false;
    intrinsic_init(&in->words);
    directive_init(&in->words);
    parse_pattern_init(&in->words);
    return scope_push(in);
}

static void free_reader(pov_reader *in)
{
    const env *e = in->model->env;

    text_file_free_all(in);
    value_free_all(&in->heap);
    arena_free(&in->members);
    token_buffer_free_all(&in->buffers);
    source_free(&in->sources);
    symbols_free(&in->words);
    env_free(e, in->frames.items);
    env_free(e, in->conditions.items);
    env_free(e, in->scopes.items);
    env_free(e, in->arguments.items);
    env_free(e, in->randoms.items);
    env_free(e, in->material_slots);
    intern_free(&in->interned, e);
}

/* ---- names that are there from the beginning ---- */

enum { NAME_MAX_GIVEN = 256 };

static void declare(pov_reader *in, const char *name, value v)
{
    uint32_t hash = SYMBOLS_HASH_START, length = 0;
    symbol *word;

    for (; name[length]; length++)
        hash = symbols_hash(hash, (unsigned char)name[length]);
    word = symbols_add(&in->words, name, length, hash);
    if (word)
        scope_declare(in, word, v);
    else
        report_memory(in);
}

static string *named_string(pov_reader *in, const char *text, size_t length, value *out)
{
    string *s = text_copy(in, text, length);

    if (s) {
        out->kind = VALUE_STRING;
        out->as.shared = &s->head;
    }
    return s;
}

static void declare_name(pov_reader *in, const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    value v = value_of_number(0.0);

    if (named_string(in, name, strlen(name), &v))
        declare(in, "input_file_name", v);
}

/* NAME=VALUE from outside of the text. The value is a number, or a string in quotation marks. */
static void declare_given(pov_reader *in, const char *given)
{
    const char *equals = strchr(given, '='), *text = equals ? equals + 1 : given;
    const size_t length = strlen(text);
    value v = value_of_number(0.0);
    char name[NAME_MAX_GIVEN], *end;

    if (!equals || equals == given || (size_t)(equals - given) >= sizeof name) {
        report_fail(in, &in->token.at, POV_E_ARGUMENT, "\"%.100s\" does not declare a name: NAME=VALUE", given);
        return;
    }
    memcpy(name, given, (size_t)(equals - given));
    name[equals - given] = '\0';
    if (length >= 2 && text[0] == '"' && text[length - 1] == '"') {
        if (!named_string(in, text + 1, length - 2, &v))
            return;
    } else {
        v.as.v[0] = strtod(text, &end);
        if (end == text || *end != '\0') {
            report_fail(in, &in->token.at, POV_E_ARGUMENT,
                        "the value of %.60s must be a number or a string in quotation marks, not \"%.100s\"", name, text);
            return;
        }
    }
    in->sources.hash = hash_bytes(in->sources.hash, given, strlen(given));
    declare(in, name, v);
}

/* What is declared from outside is part of what the scene is: a checkpoint of another value is another scene's. */
static void declare_number(pov_reader *in, const char *name, double number)
{
    in->sources.hash = hash_bytes(in->sources.hash, &number, sizeof number);
    declare(in, name, value_of_number(number));
}

static void declare_names(pov_reader *in, const char *path)
{
    static const reader_options none;
    const reader_options *o = in->options ? in->options : &none;
    const reader_frames *f = &o->frames;
    size_t i;

    declare_number(in, "image_width", o->width > 0 ? o->width : 320);
    declare_number(in, "image_height", o->height > 0 ? o->height : 240);
    declare_number(in, "frame_number", f->frame);
    declare_number(in, "initial_frame", f->first);
    declare_number(in, "final_frame", f->last);
    declare_number(in, "initial_clock", f->first_clock);
    declare_number(in, "final_clock", f->last_clock);
    declare_number(in, "clock_delta", f->delta);
    declare_name(in, path);
    for (i = 0; o->declares && o->declares[i]; i++)
        declare_given(in, o->declares[i]);
}

static void decide_dialect(pov_reader *in)
{
    model *m = in->model;
    char word[REPORT_QUOTE];

    m->dialect = in->wanted_dialect;
    if (m->dialect != POV_DIALECT_AUTO) {
        m->dialect_reason = "it was asked for";
        return;
    }
    m->dialect = in->povray_word.source ? POV_DIALECT_POVRAY : POV_DIALECT_COURSE;
    m->dialect_reason = "no \"#version\", and every word is one of the base language";
    if (!in->povray_word.source)
        return;
    report_quote(&in->povray_word, word);
    m->dialect_reason = arena_printf(&m->memory, "the word \"%s\" at %d:%d", word, in->povray_word.line,
                                     in->povray_word.column);
    if (!m->dialect_reason)
        report_memory(in);
}

static void read_text(pov_reader *in, const build_part *part)
{
    frame_begin_text(in, part->text, part->length, part->name);
    if (in->failed)
        return;
    if (!limit_input(in, part->length)) {
        report_fail(in, &in->token.at, POV_E_IO, "the text is larger than the %zu bytes that may be read", in->limits.input);
        return;
    }
    refuse_other_files(in, part->text, part->length);
    state_advance(in);
    parse_scene(in);
    if (!in->failed && in->conditions.count > 0)
        report_fail(in, &in->conditions.items[in->conditions.count - 1].at, POV_E_SYNTAX,
                    "there is no \"#end\" for this");
}

static void read_part(pov_reader *in, const scene_parts *all, const build_part *part)
{
    switch (part->kind) {
    case BUILD_TEXT:
        read_text(in, part);
        break;
    case BUILD_SHAPES:
        parse_arrays(in, all, part);
        break;
    case BUILD_LIGHTS:
        parse_array_lights(in, all, part);
        break;
    case BUILD_CAMERA:
        parse_given_camera(in, part);
        break;
    }
}

static void read(pov_reader *in, copies_read *copies, const scene_parts *parts, const char *name)
{
    surface_parsed defaults;

    memset(&defaults, 0, sizeof defaults);
    material_init(&defaults.material);
    in->defaults = &defaults;
    in->copies = copies;
    frame_begin_text(in, "", 0, name);
    declare_names(in, name);
    for (size_t i = 0; i < parts->parts.count && !in->failed; i++)
        read_part(in, parts, &parts->parts.items[i]);
    text_file_store_open(in);
    if (!in->failed)
        decide_dialect(in);
    if (!in->failed)
        parse_camera_finish(in);
    if (!in->failed)
        parse_settings_finish(in);
    if (!in->failed)
        parse_copies_finish(in);
}

pov_status reader_read(model *m, registry *plugins, const char *text, size_t length, const char *name,
                       const reader_options *options, pov_error *err)
{
    build_part part = { .kind = BUILD_TEXT, .text = text, .name = name, .length = length };
    const scene_parts one = { .parts = { &part, 1, 1 } };

    return reader_read_parts(m, plugins, &one, name, options, err);
}

pov_status reader_read_parts(model *m, registry *plugins, const scene_parts *parts, const char *name,
                             const reader_options *options, pov_error *err)
{
    copies_read copies = { .defaults = NULL };
    pov_status status = POV_OK;
    pov_reader in;

    if (start(&in, m, plugins, options))
        read(&in, &copies, parts, name);
    else
        report_memory(&in);
    if (options && options->max_trace_level > 0)
        m->max_trace_level = options->max_trace_level;
    recover_finish(&in);
    if (in.failed) {
        status = in.error.status;
        if (err)
            *err = in.error;
    }
    m->identity = in.sources.hash;
    parse_copies_free(&copies, m->env);
    free_reader(&in);
    return status;
}
