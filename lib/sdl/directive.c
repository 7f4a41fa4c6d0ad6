#include "sdl/directive.h"

#include "base/str.h"
#include "sdl/condition.h"
#include "sdl/declare.h"
#include "sdl/expression.h"
#include "sdl/frame.h"
#include "sdl/include.h"
#include "sdl/loop.h"
#include "sdl/macro.h"
#include "sdl/message.h"
#include "sdl/parse.h"
#include "sdl/report.h"
#include "sdl/text_file.h"

#include <string.h>

static void run_version(pov_reader *in, const place *at)
{
    const bool must_end = in->version >= 3.5;
    double version;

    (void)at;
    state_advance(in);
    if (in->token.kind == TOKEN_WORD && strcmp(in->token.symbol->name, "unofficial") == 0)
        state_advance(in);
    version = expression_number(in);
    if (!in->failed && version > 3.7 + EXPRESSION_NEAR) {
        report_warn(in, &in->value, "version %g is taken as 3.7", version);
        version = 3.7;
    }
    if (!in->failed && must_end && in->token.kind != ';')
        report_warn(in, &in->value, "since version 3.5 a \"#version\" ends with \";\"");
    in->version = in->settings.version = version;
    if (!in->settings.has_noise_generator)
        in->model->noise_generator = version < 3.5 ? 1 : 2;
    state_accept(in, ';');
}

typedef struct row {
    const char *name;
    void (*run)(pov_reader *in, const place *at);   /* its name is the next token, the '#' stood at `at` */
    int nesting;
    bool is_bare;                /* old scenes have it without the '#' */
} row;

static const row rows[] = {
    { "break", loop_break, 0, false },          { "case", condition_case, 0, false },
    { "debug", message_run, 0, false },         { "declare", declare_run, 0, true },
    { "default", parse_default, 0, true },      { "else", condition_else, 0, false },
    { "elseif", condition_elseif, 0, false },   { "end", condition_end, -1, false },
    { "error", message_run, 0, false },         { "fclose", text_file_close, 0, false },
    { "fopen", text_file_open, 0, false },      { "for", loop_for, 1, false },
    { "if", condition_if, 1, false },           { "ifdef", condition_ifdef, 1, false },
    { "ifndef", condition_ifdef, 1, false },    { "include", include_run, 0, true },
    { "local", declare_run, 0, false },         { "macro", macro_define, 1, false },
    { "max_intersections", parse_old_limit, 0, true }, { "max_trace_level", parse_old_level, 0, true },
    { "range", condition_case, 0, false },      { "read", text_file_read, 0, false },
    { "render", message_run, 0, false },        { "statistics", message_run, 0, false },
    { "switch", condition_switch, 1, false },   { "undef", declare_forget, 0, false },
    { "version", run_version, 0, true },        { "warning", message_run, 0, false },
    { "while", loop_while, 1, false },          { "write", text_file_write, 0, false },
};

enum { ROWS = sizeof rows / sizeof rows[0] };

void directive_init(symbols *words)
{
    int i;

    for (i = 0; i < ROWS; i++)
        symbols_named(words, rows[i].name)->directive = i;
}

int directive_nesting(const token *word)
{
    return word->kind == TOKEN_WORD && word->symbol->directive >= 0 ? rows[word->symbol->directive].nesting : 0;
}

void directive_step(pov_reader *in)
{
    frame *f = in->top;

    if (in->failed)
        return;
    in->last = in->token.at;
    in->tried_count = 0;
    if (f->tokens && !f->has_saved && f->at < f->end)
        in->token = f->tokens->items[f->at++];      /* as frame_fetch() would */
    else
        frame_fetch(in, &in->token);
    if (in->token.kind == TOKEN_WORD || in->token.fault)
        state_look(in);
}

/* POV-Ray leaves a '#' out before the words of a scene. */
static bool is_left_out(pov_reader *in)
{
    symbol *word = in->token.kind == TOKEN_WORD ? in->token.symbol : NULL;

    return in->token.kind == '}' || in->token.kind == '#' ||
           (word && (word->id != KEYWORD_OTHER || word->binding || parse_shape_class(in, word)));
}

static void fail_unknown(pov_reader *in, const place *hash)
{
    char word[REPORT_QUOTE];
    guess g;
    int i;

    if (is_left_out(in)) {
        report_warn(in, hash, "a \"#\" that no directive follows is left out");
        return;
    }
    if (in->token.kind != TOKEN_WORD) {
        report_expected(in, "a directive");
        return;
    }
    report_quote(&in->token.at, word);
    report_guess_start(&g, in);
    for (i = 0; i < ROWS; i++)
        report_guess_try(&g, rows[i].name);
    report_fail(in, hash, POV_E_SYNTAX, "unknown directive \"#%s\"", word);
    str_copy(in->error.hint, sizeof in->error.hint, g.best);
}

/* The '#' and its word are one word for who asks why the file is `povray`. */
static void take_hash(pov_reader *in, const place *hash)
{
    state_note_povray(in, hash);
    directive_step(in);
    if (in->povray_word.start == hash->start && in->token.kind == TOKEN_WORD)
        in->povray_word.length = (uint32_t)(in->token.at.start - hash->start) + in->token.at.length;
}

static void run(pov_reader *in, const row *r, const place *at)
{
    const hold outer = in->hold;

    in->hold.is_on = true;
    in->hold.nesting = in->nesting;
    in->hold.frames = in->frames.count;
    in->hold.conditions = in->conditions.count;
    if (state_enter(in))         /* a directive may stand within the values of another */
        r->run(in, at);
    state_exit(in);
    in->hold = outer;
}

void directive_run(pov_reader *in)
{
    const place hash = in->token.at;

    take_hash(in, &hash);
    if (in->failed)
        return;
    if (in->token.kind != TOKEN_WORD || in->token.symbol->directive < 0)
        fail_unknown(in, &hash);
    else
        run(in, &rows[in->token.symbol->directive], &hash);
}

bool directive_run_bare(pov_reader *in)
{
    const place at = in->token.at;
    const int i = in->token.kind == TOKEN_WORD ? in->token.symbol->directive : -1;

    if (i < 0 || !rows[i].is_bare)
        return false;
    report_warn(in, &at, "\"%s\" without a \"#\"", rows[i].name);
    run(in, &rows[i], &at);
    state_settle(in);
    return true;
}

token directive_skip(pov_reader *in, const place *at, size_t depth, bool stops_at_branches)
{
    bool is_directive = false;
    token t;

    for (;;) {
        if (!is_directive && in->top->text && !in->top->has_saved)
            lex_skip(in->top->text);
        frame_fetch(in, &t);
        if (t.kind == TOKEN_LEAVE && in->top->kind == FRAME_INCLUDE) {
            frame_pop(in);
            scope_pop(in);
        } else if (t.kind == TOKEN_END || t.kind == TOKEN_LEAVE) {
            report_fail(in, at, POV_E_SYNTAX, "there is no \"#end\" for this");
            return t;
        } else if (is_directive && t.kind == TOKEN_WORD && t.symbol->directive >= 0) {
            const int nesting = rows[t.symbol->directive].nesting;

            if (stops_at_branches && depth == 1 && condition_is_branch(t.symbol->id))
                return t;
            depth = nesting < 0 ? depth - 1 : depth + (size_t)nesting;
            if (depth == 0)
                return t;
        }
        is_directive = t.kind == '#';
    }
}

void directive_skip_all(pov_reader *in, const place *at, size_t depth)
{
    directive_skip(in, at, depth, false);
}
