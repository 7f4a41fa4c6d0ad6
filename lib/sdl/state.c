#include "sdl/state.h"

#include "sdl/directive.h"
#include "sdl/directive_kept.h"
#include "sdl/frame.h"
#include "sdl/limit.h"
#include "sdl/macro.h"
#include "sdl/report.h"

/* The reader's calls within each other: brackets in expressions, macros in arguments, objects in objects. */
enum { DEEPEST = 3000, BRACKETS_MAX = 2500 };

static void fail_bad(pov_reader *in)
{
    char text[REPORT_QUOTE];
    unsigned char byte = (unsigned char)*in->token.at.start;

    if (!in->token.fault) {
        report_memory(in);
        return;
    }
    report_quote(&in->token.at, text);
    if (byte == 0)
        report_fail(in, &in->token.at, POV_E_SYNTAX, "a zero byte: this is not a text");
    else if (byte == '"' || byte == '/')
        report_fail(in, &in->token.at, POV_E_SYNTAX, "%s", in->token.fault);
    else if (text[0] == '?')
        report_fail(in, &in->token.at, POV_E_SYNTAX, "the byte 0x%02X %s", byte, in->token.fault);
    else
        report_fail(in, &in->token.at, POV_E_SYNTAX, "\"%s\" %s", text, in->token.fault);
}

/* What is seldom, out of the way of what is not. */
static void look_closer(pov_reader *in)
{
    char text[REPORT_QUOTE];

    if (in->token.kind == TOKEN_BAD) {
        fail_bad(in);
    } else if (in->token.fault) {
        report_quote(&in->token.at, text);
        report_warn(in, &in->token.at, "\"%s\" %s", text, in->token.fault);
    }
}

/* Could the directive that is being read be at its end here? */
static bool waits(const pov_reader *in)
{
    const hold *h = &in->hold;

    return h->is_on && in->nesting == h->nesting && in->frames.count <= h->frames &&
           in->conditions.count <= h->conditions;
}

static bool is_call(const pov_reader *in)
{
    const token *t = &in->token;

    return t->kind == TOKEN_WORD && t->symbol->binding && t->symbol->binding->slot->kind == VALUE_MACRO &&
           !in->wants_name;
}

static void leave(pov_reader *in)
{
    if (in->top->kind == FRAME_MACRO)
        in->conditions.count = in->top->conditions;
    frame_pop(in);
    scope_pop(in);
}

void state_look(pov_reader *in)
{
    if (in->token.kind == TOKEN_WORD) {
        if (!(in->token.symbol->flags & KEYWORD_FLAG_BASE))
            state_note_povray(in, &in->token.at);
    } else if (in->token.fault && in->token.kind != TOKEN_BAD) {
        look_closer(in);
    }
}

/* A loop, so that a million directives in a row do not become a million calls deep. What stands before them is what
 * stands before the token behind them. */
static void run_directives(pov_reader *in, bool is_forced)
{
    const place last = in->last;

    while (!in->failed && (is_forced || !waits(in))) {
        if (in->token.kind == '#') {
            if (!directive_kept_run(in))
                directive_run(in);
        } else if (in->token.kind == TOKEN_LEAVE) {
            leave(in);
            frame_fetch(in, &in->token);
            state_look(in);
        } else if (in->token.kind == TOKEN_BAD) {
            look_closer(in);
        } else if (is_call(in)) {
            macro_call(in);
        } else {
            break;
        }
    }
    in->last = last;
}

static inline void next_of_text(pov_reader *in, source *text)
{
    lex_next(&in->words, text, &in->token);
    if (--in->until_told == 0)
        limit_tell(in);
}

void state_advance(pov_reader *in)
{
    frame *f = in->top;

    if (in->failed)
        return;
    in->last = in->token.at;
    in->tried_count = 0;
    if (f->at < f->end && !f->has_saved)
        in->token = f->tokens->items[f->at++];
    else if (f->text && !f->has_saved)
        next_of_text(in, f->text);
    else
        frame_fetch(in, &in->token);
    if (in->token.kind == TOKEN_END && !in->failed && in->top->kind != FRAME_SCENE)
        frame_fetch(in, &in->token);
    if (in->token.kind == TOKEN_WORD) {
        if (!(in->token.symbol->flags & KEYWORD_FLAG_BASE))
            state_note_povray(in, &in->token.at);
        if (is_call(in))
            run_directives(in, false);
    } else if (in->token.kind == '#' || in->token.kind == TOKEN_LEAVE || in->token.kind == TOKEN_BAD) {
        run_directives(in, false);
    } else if (in->token.fault) {
        look_closer(in);
    }
}

void state_settle(pov_reader *in)
{
    const int kind = in->token.kind;

    if (kind == '#' || kind == TOKEN_LEAVE || kind == TOKEN_BAD || is_call(in))
        run_directives(in, true);
}

bool state_accept_keyword(pov_reader *in, keyword_id keyword)
{
    if (state_keyword(in) != keyword)
        return false;
    state_advance(in);
    return true;
}

bool state_require(pov_reader *in, int punct)
{
    char wanted[4] = { '"', (char)punct, '"', '\0' };

    if (in->token.kind != punct)
        report_expected(in, wanted);
    return !in->failed;
}

void state_expect(pov_reader *in, int punct)
{
    if (state_require(in, punct))
        state_advance(in);
}

void state_open(pov_reader *in, int punct)
{
    if (in->token.kind != punct) {
        state_require(in, punct);
        return;
    }
    if (++in->nesting > BRACKETS_MAX)
        report_fail(in, &in->token.at, POV_E_SYNTAX, "too many levels within each other");
    state_advance(in);
}

void state_close(pov_reader *in, int punct)
{
    if (in->token.kind != punct) {
        state_require(in, punct);
        return;
    }
    in->nesting--;
    state_advance(in);
}

void state_note_povray(pov_reader *in, const place *word)
{
    if (!in->povray_word.source)
        in->povray_word = *word;
}

void *state_alloc(pov_reader *in, size_t bytes, size_t align)
{
    void *p = in->failed ? NULL : arena_alloc(&in->model->memory, bytes, align);

    if (!p)
        report_memory(in);
    return p;
}

bool state_enter(pov_reader *in)
{
    if (++in->depth > DEEPEST)
        report_fail(in, &in->token.at, POV_E_SYNTAX, "too many levels within each other");
    return !in->failed;
}
