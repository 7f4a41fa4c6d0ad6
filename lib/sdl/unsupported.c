#include "sdl/unsupported.h"

#include "sdl/expression.h"
#include "sdl/report.h"

#include <stdio.h>

void unsupported_note(pov_reader *in, const place *at, keyword_id keyword, const char *what)
{
    symbol *word = &in->words.keywords[keyword];
    const bool is_strict = in->options && in->options->strict;

    if (in->failed || (word->flags & KEYWORD_FLAG_NAMED))
        return;
    word->flags |= KEYWORD_FLAG_NAMED;
    if (is_strict)
        report_fail(in, at, POV_E_UNSUPPORTED, "%s is not supported yet", what);
    else
        report_warn(in, at, "%s is not supported yet and is left out", what);
}

/* What stands there may draw random numbers, or set a normal: that is done. */
static bool has_effects(const pov_reader *in)
{
    switch (state_keyword(in)) {
    case KEYWORD_RAND: case KEYWORD_SEED: case KEYWORD_TRACE:
        return true;
    default:
        return false;
    }
}

static void skip_token(pov_reader *in)
{
    value v;

    if (has_effects(in)) {
        v = expression_read(in);
        value_drop(&in->heap, &v);
    } else {
        state_advance(in);
    }
}

void unsupported_skip_rest(pov_reader *in)
{
    int depth = 0;

    while (!in->failed && !state_at_end(in) && (depth > 0 || in->token.kind != '}')) {
        if (in->token.kind == '{')
            depth++;
        else if (in->token.kind == '}')
            depth--;
        skip_token(in);
    }
}

void unsupported_skip_block(pov_reader *in)
{
    block b;

    b.keyword = in->last;
    b.brace = in->token.at;
    b.outer = in->block;
    in->block = &b;
    state_open(in, '{');
    unsupported_skip_rest(in);
    state_close(in, '}');
    in->block = b.outer;
}

static bool is_value(const pov_reader *in)
{
    return value_colour_follows(in, true) || in->token.kind == TOKEN_STRING || in->token.kind == '(';
}

static void skip_value(pov_reader *in)
{
    double numbers[5];
    value v;

    if (value_colour_follows(in, false)) {
        value_colour_components(in, true, numbers);
        return;
    }
    v = expression_read(in);
    value_drop(&in->heap, &v);
}

static bool is_format(keyword_id keyword)
{
    switch (keyword) {
    case KEYWORD_DF3: case KEYWORD_EXR: case KEYWORD_GIF: case KEYWORD_HDR: case KEYWORD_IFF: case KEYWORD_JPEG:
    case KEYWORD_PGM: case KEYWORD_PNG: case KEYWORD_POT: case KEYWORD_PPM: case KEYWORD_SYS: case KEYWORD_TGA:
    case KEYWORD_TIFF: case KEYWORD_TTF: case KEYWORD_INTERNAL:
        return true;
    default:
        return false;
    }
}

static void skip_values(pov_reader *in)
{
    in->nesting++;
    while (!in->failed && is_value(in)) {
        skip_value(in);
        state_accept(in, ',');
    }
    in->nesting--;
}

void unsupported_skip_item(pov_reader *in)
{
    state_advance(in);
    while (is_format(state_keyword(in)))
        state_advance(in);
    skip_values(in);
    if (in->token.kind == '{')
        unsupported_skip_block(in);
    state_accept(in, ',');
    skip_values(in);
}

void unsupported_item(pov_reader *in)
{
    char what[REPORT_QUOTE + 2];

    snprintf(what, sizeof what, "\"%s\"", in->token.symbol->name);
    unsupported_note(in, &in->token.at, in->token.symbol->id, what);
    unsupported_skip_item(in);
}

void unsupported_skip_file(pov_reader *in, keyword_id keyword, const char *of)
{
    const place at = in->last;
    value v = expression_read(in);

    value_drop(&in->heap, &v);
    report_warn(in, &at, "\"%s\" of %s is not needed: nothing is kept in files", token_keyword_name(keyword), of);
}
