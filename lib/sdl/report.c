#include "sdl/report.h"

#include "base/err.h"
#include "base/str.h"

#include <stdio.h>
#include <string.h>

enum {
    QUOTE_MAX = 40,              /* bytes of text in a message */
    BEFORE_CARET = 120,          /* bytes of a long line shown before what is meant */
    STACK_SHOWN = 20,            /* macros and include files around an error */
    WARNINGS_SHOWN = 100         /* a million equal slips are no news */
};

/* ---- text that may be shown ---- */

/* Bytes of the UTF-8 character at `at`, 0 if there is none that can be shown. */
static size_t character(const char *at, const char *end)
{
    const unsigned char *c = (const unsigned char *)at;
    size_t n = c[0] < 0x80 ? 1 : c[0] < 0xC2 ? 0 : c[0] < 0xE0 ? 2 : c[0] < 0xF0 ? 3 : c[0] < 0xF5 ? 4 : 0, i;

    if (n == 1)
        return c[0] >= 0x20 && c[0] != 0x7F ? 1 : 0;
    if (n == 0 || n > (size_t)(end - at))
        return 0;
    for (i = 1; i < n; i++)
        if ((c[i] & 0xC0) != 0x80)
            return 0;
    /* Control characters above ASCII, overlong forms, surrogates, what lies beyond Unicode. */
    if ((c[0] == 0xC2 && c[1] < 0xA0) || (c[0] == 0xE0 && c[1] < 0xA0) || (c[0] == 0xED && c[1] >= 0xA0) ||
        (c[0] == 0xF0 && c[1] < 0x90) || (c[0] == 0xF4 && c[1] >= 0x90))
        return 0;
    return n;
}

/* Copy byte for byte, so that offsets stay; a question mark stands for each byte that cannot be shown. */
static void copy_shown(char *out, const char *at, const char *end)
{
    while (at < end) {
        size_t n = character(at, end);

        if (n == 0) {
            *out++ = *at == '\t' ? '\t' : '?';
            at++;
        }
        for (; n > 0; n--)
            *out++ = *at++;
    }
    *out = '\0';
}

static bool goes_on(char byte)
{
    return ((unsigned char)byte & 0xC0) == 0x80;
}

void report_quote(const place *at, char out[REPORT_QUOTE])
{
    size_t n = at->length;

    if (n <= QUOTE_MAX) {
        copy_shown(out, at->start, at->start + n);
        return;
    }
    for (n = QUOTE_MAX; n > QUOTE_MAX - 3 && goes_on(at->start[n]); n--)
        continue;
    copy_shown(out, at->start, at->start + n);
    strcat(out, "...");
}

static bool is_line_end(char byte)
{
    return byte == '\n' || byte == '\r';
}

/* The line around the place, or as much of it as has room. */
static void fill_excerpt(pov_error *e, const place *at)
{
    const char *line = at->start, *end = at->start;

    while (line > at->source->text && !is_line_end(line[-1]) && at->start - line < BEFORE_CARET)
        line--;
    while (line < at->start && goes_on(*line))
        line++;
    while (end < at->source->end && !is_line_end(*end) && end - line < (long)sizeof e->excerpt - 1)
        end++;
    while (end > at->start && end < at->source->end && goes_on(*end))
        end--;
    e->caret = (int)(at->start - line);
    copy_shown(e->excerpt, line, end);
}

static void fill_place(pov_error *e, const place *at)
{
    if (!at->source)
        return;
    str_copy(e->file, sizeof e->file, at->source->name);
    e->line = at->line;
    e->column = at->column;
    fill_excerpt(e, at);
}

/* A message is one line, whatever a plugin puts into it. */
static void fill_message(pov_error *e, pov_status status, const char *format, va_list args)
{
    char raw[sizeof e->message];

    err_setv(e, status, format, args);
    memcpy(raw, e->message, sizeof raw);
    copy_shown(e->message, raw, raw + strlen(raw));
}

/* ---- errors ---- */

/* Which macros and include files it happened in, innermost first. */
static void tell_stack(pov_reader *in)
{
    size_t i, told = 0;

    for (i = in->frames.count; i-- > 0 && told < STACK_SHOWN;) {
        const frame *f = &in->frames.items[i];
        pov_error note;

        if (f->kind != FRAME_MACRO && f->kind != FRAME_INCLUDE)
            continue;
        memset(&note, 0, sizeof note);
        snprintf(note.message, sizeof note.message, f->kind == FRAME_MACRO ? "in the macro \"%.64s\", called here"
                                                                           : "in the file that is included here",
                 f->kind == FRAME_MACRO ? f->name->name : "");
        fill_place(&note, &f->call);
        env_log(in->model->env, POV_LOG_STACK, &note);
        told++;
    }
}

/* What recover() needs to know of the place. */
static void note_state(pov_reader *in)
{
    in->failed_at = in->token;
    in->failed_in_directive = in->hold.is_on;
    in->failed_depth = in->plugin_braces;
    for (const block *b = in->block; b; b = b->outer)
        in->failed_depth++;
}

static void stop(pov_reader *in)
{
    in->failed = true;
    note_state(in);
    tell_stack(in);
    in->token.kind = TOKEN_END;
    in->token.symbol = NULL;
    in->token.number = 0.0;
}

void report_failv(pov_reader *in, const place *at, pov_status status, const char *format, va_list args)
{
    if (in->failed)
        return;
    fill_message(&in->error, status, format, args);
    fill_place(&in->error, at);
    stop(in);
}

void report_fail(pov_reader *in, const place *at, pov_status status, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    report_failv(in, at, status, format, args);
    va_end(args);
}

void report_memory(pov_reader *in)
{
    if (in->failed)
        return;
    if (in->heap.is_full) {
        report_fail(in, &in->value, POV_E_MEMORY, "the values of this scene need more than %zu bytes",
                    in->heap.most_bytes);
        return;
    }
    err_memory(&in->error);
    fill_place(&in->error, &in->token.at);
    stop(in);
}

void report_pass_on(pov_reader *in, const place *at, const pov_error *error)
{
    if (in->failed)
        return;
    in->error = *error;
    if (!error->file[0] && error->status != POV_E_MEMORY)
        fill_place(&in->error, at);
    stop(in);
}

/* The end of a text is shown behind its last token: there something is missing, not on an empty last line. */
static place next_place(const pov_reader *in)
{
    place at = in->token.at;

    if ((in->token.kind == TOKEN_END || in->token.kind == TOKEN_LEAVE) && in->last.source == at.source && in->last.source) {
        at = in->last;
        at.start += at.length;
        at.column += (int)at.length;
        at.length = 0;
    }
    return at;
}

static void describe_next(const pov_reader *in, char *out, size_t size)
{
    char text[REPORT_QUOTE], keyword[REPORT_QUOTE];

    if (in->token.kind == TOKEN_LEAVE) {
        str_copy(out, size, in->top->kind == FRAME_MACRO ? "the end of the macro" : "the end of the included file");
    } else if (in->token.kind != TOKEN_END) {
        report_quote(&in->token.at, text);
        snprintf(out, size, in->token.kind == TOKEN_STRING ? "the string %s" : "\"%s\"", text);
    } else if (in->block) {
        report_quote(&in->block->keyword, keyword);
        snprintf(out, size, "the end of the text; the \"{\" of \"%s\" at %d:%d is still open", keyword,
                 in->block->brace.line, in->block->brace.column);
    } else {
        str_copy(out, size, "the end of the text");
    }
}

void report_expected(pov_reader *in, const char *wanted)
{
    char found[3 * REPORT_QUOTE], before[REPORT_QUOTE];
    place at;

    if (in->failed)
        return;
    at = next_place(in);
    describe_next(in, found, sizeof found);
    if (in->last.source) {
        report_quote(&in->last, before);
        report_fail(in, &at, POV_E_SYNTAX, "expected %s after \"%s\", found %s", wanted, before, found);
    } else {
        report_fail(in, &at, POV_E_SYNTAX, "expected %s, found %s", wanted, found);
    }
}

/* ---- warnings ---- */

static void log_note(pov_reader *in, const place *at, const char *format, va_list args)
{
    pov_error note;

    fill_message(&note, POV_OK, format, args);
    fill_place(&note, at);
    env_log(in->model->env, POV_LOG_WARN, &note);
}

void report_warnv(pov_reader *in, const place *at, const char *format, va_list args)
{
    if (in->failed)
        return;
    in->model->warnings++;
    if (in->model->warnings <= WARNINGS_SHOWN)
        log_note(in, at, format, args);
    if (in->model->warnings == WARNINGS_SHOWN + 1)
        env_logf(in->model->env, POV_LOG_WARN, "more than %d warnings; the rest is only counted",
                 WARNINGS_SHOWN);
}

void report_warn(pov_reader *in, const place *at, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    report_warnv(in, at, format, args);
    va_end(args);
}

/* In pieces that a note has room for. */
void report_text(pov_reader *in, const char *text, size_t length)
{
    pov_error note;
    size_t n;

    if (in->error_count > 0)     /* what a scene with errors says of itself is worth nothing */
        return;
    for (; length > 0; text += n, length -= n) {
        memset(&note, 0, sizeof note);
        n = length < sizeof note.message ? length : sizeof note.message - 1;
        memcpy(note.message, text, n);
        env_log(in->model->env, POV_LOG_SCENE, &note);
    }
}

/* ---- guesses ---- */

void report_guess_start(guess *g, const pov_reader *in)
{
    int i;

    memset(g, 0, sizeof *g);
    if (in->token.kind != TOKEN_WORD)
        return;
    report_quote(&in->token.at, g->word);
    for (i = 0; i < in->tried_count; i++)
        report_guess_try(g, in->tried[i]);
}

void report_guess_try(guess *g, const char *candidate)
{
    const char *best = g->best[0] ? g->best : NULL;

    if (!g->word[0])
        return;
    str_nearer(g->word, candidate, &best, &g->edits);
    if (best && best != g->best)
        str_copy(g->best, sizeof g->best, best);
}

void report_guess_names(guess *g, const pov_reader *in)
{
    for (size_t i = 0; i < in->words.capacity; i++)
        if (in->words.slots[i] && (in->words.slots[i]->binding || in->words.slots[i]->intrinsic))
            report_guess_try(g, in->words.slots[i]->name);
}

void report_expected_guess(pov_reader *in, const char *wanted, const guess *g)
{
    const bool is_first = !in->failed;

    report_expected(in, wanted);
    if (is_first)
        str_copy(in->error.hint, sizeof in->error.hint, g->best);
}

void report_undeclared(pov_reader *in)
{
    char name[REPORT_QUOTE];
    guess g;

    if (in->failed)
        return;
    report_quote(&in->token.at, name);
    report_guess_start(&g, in);
    report_guess_names(&g, in);
    report_fail(in, &in->token.at, POV_E_SYNTAX, "\"%s\" is not declared", name);
    str_copy(in->error.hint, sizeof in->error.hint, g.best);
}

void report_misplaced(pov_reader *in, const char *wanted, const guess *g)
{
    char word[REPORT_QUOTE], where[REPORT_QUOTE + 64] = "";
    place at = in->token.at;

    if (in->failed)
        return;
    if (in->token.kind != TOKEN_WORD) {
        report_expected(in, wanted);
        return;
    }
    report_quote(&at, word);
    if (in->block) {
        char keyword[REPORT_QUOTE];

        report_quote(&in->block->keyword, keyword);
        snprintf(where, sizeof where, " in \"%s\"", keyword);
    }
    if (in->token.symbol->binding) {
        report_fail(in, &at, POV_E_SYNTAX, "\"%s\" is %s, which does not belong %s", word,
                    value_name(in->token.symbol->binding->slot), where[0] ? where + 1 : "at the top level");
        return;
    }
    if (state_keyword(in) != KEYWORD_OTHER) {
        if (in->block && in->block->brace.line < at.line)   /* perhaps it was to end before */
            snprintf(where + strlen(where), sizeof where - strlen(where), ", whose \"{\" at %d:%d is still open",
                     in->block->brace.line, in->block->brace.column);
        report_fail(in, &at, POV_E_SYNTAX, "\"%s\" does not belong %s", word,
                    where[0] ? where + 1 : "at the top level");
        return;
    }
    report_fail(in, &at, POV_E_SYNTAX, "unknown word \"%s\"%s", word, where);
    str_copy(in->error.hint, sizeof in->error.hint, g->best);
}
