#include "sdl/state.h"

#include "sdl/directive.h"
#include "sdl/report.h"

static void fail_bad(pov_reader *in)
{
    char text[REPORT_QUOTE];
    unsigned char byte = (unsigned char)*in->token.at.start;

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

/* A loop, so that a million directives in a row do not become a million calls deep. What stands before them is what
 * stands before the token behind them. */
static void run_directives(pov_reader *in)
{
    const place last = in->last;

    while (in->token.kind == '#')
        directive_run(in);
    in->last = last;
}

void state_advance(pov_reader *in)
{
    if (in->failed)
        return;
    in->last = in->token.at;
    in->tried_count = 0;
    lex_next(&in->lex, &in->token);
    if (in->token.kind == TOKEN_WORD) {
        if (!in->token.symbol || !(in->token.symbol->flags & TRAIT_BASE))
            state_note_povray(in, &in->token.at);
    } else if (in->token.fault) {
        look_closer(in);
    }
    if (in->token.kind == '#' && !in->in_directive)
        run_directives(in);
}

void state_expect(pov_reader *in, int mark)
{
    char wanted[4] = { '"', (char)mark, '"', '\0' };

    if (!state_accept(in, mark))
        report_expected(in, wanted);
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
