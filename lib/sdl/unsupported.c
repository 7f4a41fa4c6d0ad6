#include "sdl/unsupported.h"

#include "sdl/directive.h"
#include "sdl/report.h"

#include <stdio.h>

/* A plugin may have brought the feature in the meantime. A broken one is no news here. */
static bool has_plugin(pov_reader *in, const symbol *word)
{
    const shape_class *shape = NULL;
    pov_error error;

    return registry_shape(in->plugins, word->name, &shape, &error) == POV_OK && shape;
}

static void name_word(pov_reader *in, const token *t)
{
    symbol *word = t->symbol;

    if (!word || !(word->flags & TRAIT_LATER) || (word->flags & TRAIT_NAMED))
        return;
    word->flags |= TRAIT_NAMED;
    if (!has_plugin(in, word))
        report_note(in, &t->at, "\"%s\" is not supported yet", word->name);
}

static void name_directive(pov_reader *in, const token *mark, const token *word, uint32_t *named)
{
    int index = directive_index(word);

    if (index < 0 || (*named & (1u << index)) || directive_is_supported(index))
        return;
    *named |= 1u << index;
    report_note(in, &mark->at, "\"#%s\" is not supported yet", directive_name(index));
}

/* Tokens only: what they mean together is unknown from here on. A fault in the text ends it quietly. */
static void name_the_rest(pov_reader *in, uint32_t named)
{
    token t = in->token, mark;

    while (t.kind != TOKEN_END && t.kind != TOKEN_BAD) {
        mark = t;
        if (t.kind == TOKEN_WORD)
            name_word(in, &t);
        lex_next(&in->lex, &t);
        if (mark.kind == '#' && t.kind == TOKEN_WORD) {
            name_directive(in, &mark, &t, &named);
            lex_next(&in->lex, &t);
        }
    }
}

/* The token that the reader stands at is lost when it fails, so the rest is named first; the error follows as
 * what the call returns. */
static void refuse(pov_reader *in, const place *at, const char *what, uint32_t named)
{
    const place here = *at;

    if (in->failed)
        return;
    name_the_rest(in, named);
    report_fail(in, &here, POV_E_UNSUPPORTED, "%s is not supported yet", what);
}

void unsupported_form(pov_reader *in, const place *at, const char *what)
{
    refuse(in, at, what, 0);
}

void unsupported_word(pov_reader *in)
{
    char what[REPORT_QUOTE + 2];

    snprintf(what, sizeof what, "\"%s\"", in->token.symbol->name);
    in->token.symbol->flags |= TRAIT_NAMED;
    refuse(in, &in->token.at, what, 0);
}

void unsupported_directive(pov_reader *in, const place *mark, int index)
{
    char what[REPORT_QUOTE + 3];

    snprintf(what, sizeof what, "\"#%s\"", directive_name(index));
    in->token.symbol = NULL;     /* behind a '#' the word means the directive alone */
    refuse(in, mark, what, 1u << index);
}
