#include "sdl/reader.h"

#include "base/str.h"
#include "sdl/parse.h"
#include "sdl/report.h"

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
    place here = { in->lex.sources.top, in->lex.sources.top->text, 0, 1, 1 };

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

static bool start(pov_reader *in, model *m, registry *plugins, const reader_options *options)
{
    memset(in, 0, sizeof *in);
    in->model = m;
    in->plugins = plugins;
    in->wanted_dialect = options ? options->dialect : POV_DIALECT_AUTO;
    parse_camera_defaults(&in->camera);
    m->adc_bailout = 1.0 / 255.0;
    m->max_trace_level = 5;
    source_init(&in->lex.sources, m->env);
    in->lex.words = &in->words;
    return symbols_init(&in->words, m->env);
}

static void free_reader(pov_reader *in)
{
    source_free(&in->lex.sources);
    symbols_free(&in->words);
    env_free(in->model->env, in->material_slots);
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

static void read(pov_reader *in, const char *text, size_t length, const char *name)
{
    if (!source_push(&in->lex.sources, text, length, name)) {
        report_memory(in);
        return;
    }
    refuse_other_files(in, text, length);
    state_advance(in);
    if (!in->failed && state_at_end(in) && !in->povray_word.source)
        report_fail(in, &in->token.at, POV_E_SYNTAX, "there is nothing in this text");
    parse_scene(in);
    if (!in->failed)
        decide_dialect(in);
    if (!in->failed)
        parse_camera_finish(in);
    if (!in->failed)
        parse_settings_finish(in);
}

pov_status reader_read(model *m, registry *plugins, const char *text, size_t length, const char *name,
                       const reader_options *options, pov_error *err)
{
    pov_reader in;
    pov_status status = POV_OK;

    if (start(&in, m, plugins, options))
        read(&in, text, length, name);
    else
        report_memory(&in);
    if (options && options->max_trace_level > 0)
        m->max_trace_level = options->max_trace_level;
    if (in.failed) {
        status = in.error.status;
        if (err)
            *err = in.error;
    }
    m->identity = in.lex.sources.hash;
    free_reader(&in);
    return status;
}
