#include "sdl/directive.h"

#include "base/str.h"
#include "sdl/report.h"
#include "sdl/unsupported.h"
#include "sdl/value.h"

#include <string.h>

typedef struct directive {
    const char *name;
    void (*run)(pov_reader *in);   /* its name has been taken; NULL: not supported yet */
} directive;

/* The last one holds for the whole scene: what depends on it is decided when the text has been read. */
static void run_version(pov_reader *in)
{
    double version = value_number(in);

    if (!in->failed && version <= 0.0)
        report_fail(in, &in->value, POV_E_SYNTAX, "a version is above 0");
    in->settings.version = version;
    state_accept(in, ';');
}

static const directive directives[] = {
    { "break", NULL },   { "case", NULL },    { "debug", NULL },  { "declare", NULL }, { "default", NULL },
    { "else", NULL },    { "elseif", NULL },  { "end", NULL },    { "error", NULL },   { "fclose", NULL },
    { "fopen", NULL },   { "for", NULL },     { "if", NULL },     { "ifdef", NULL },   { "ifndef", NULL },
    { "include", NULL }, { "local", NULL },   { "macro", NULL },  { "range", NULL },   { "read", NULL },
    { "render", NULL },  { "statistics", NULL }, { "switch", NULL }, { "undef", NULL },
    { "version", run_version },
    { "warning", NULL }, { "while", NULL },   { "write", NULL },
};

enum { DIRECTIVES = sizeof directives / sizeof directives[0] };

int directive_index(const token *word)
{
    int i;

    for (i = 0; word->kind == TOKEN_WORD && i < DIRECTIVES; i++)
        if (strlen(directives[i].name) == word->at.length &&
            memcmp(directives[i].name, word->at.start, word->at.length) == 0)
            return i;
    return -1;
}

const char *directive_name(int index)
{
    return directives[index].name;
}

bool directive_is_supported(int index)
{
    return directives[index].run != NULL;
}

static void fail_unknown(pov_reader *in, const place *mark)
{
    char word[REPORT_QUOTE];
    guess g;
    int i;

    if (in->token.kind != TOKEN_WORD) {
        report_expected(in, "a directive");
        return;
    }
    report_quote(&in->token.at, word);
    report_guess_start(&g, in);
    for (i = 0; i < DIRECTIVES; i++)
        report_guess_try(&g, directives[i].name);
    report_fail(in, mark, POV_E_SYNTAX, "unknown directive \"#%s\"", word);
    str_copy(in->error.hint, sizeof in->error.hint, g.best);
}

/* The '#' and its word are one word for who asks why the file is `povray`. */
static void note_povray(pov_reader *in, const place *mark)
{
    state_note_povray(in, mark);
    state_advance(in);
    if (in->povray_word.start == mark->start && in->token.kind == TOKEN_WORD)
        in->povray_word.length = (uint32_t)(in->token.at.start - mark->start) + in->token.at.length;
}

void directive_run(pov_reader *in)
{
    place mark = in->token.at;
    int index;

    in->in_directive = true;
    note_povray(in, &mark);
    index = directive_index(&in->token);
    if (in->failed) {
        in->in_directive = false;
        return;
    }
    if (index < 0) {
        fail_unknown(in, &mark);
    } else if (!directives[index].run) {
        unsupported_directive(in, &mark, index);
    } else {
        state_advance(in);
        directives[index].run(in);
    }
    in->in_directive = false;
}
