#include "sdl/host.h"

#include "base/str.h"
#include "sdl/report.h"
#include "sdl/value.h"

#include <string.h>

enum { ALIGNMENT = 16 };

static void *alloc(pov_reader *in, size_t bytes)
{
    return state_alloc(in, bytes, ALIGNMENT);
}

static double number(pov_reader *in)
{
    return value_number(in);
}

static void vector(pov_reader *in, pov_vec3 *out)
{
    *out = value_vector(in);
}

static bool is_punct(const char *word)
{
    return word[0] != '\0' && word[1] == '\0' && !strchr("abcdefghijklmnopqrstuvwxyz_", word[0]);
}

static bool is_next(const pov_reader *in, const char *word)
{
    const token *t = &in->token;

    if (is_punct(word))
        return t->kind == (unsigned char)word[0];
    return t->kind == TOKEN_WORD && strcmp(t->symbol->name, word) == 0;
}

static bool accept(pov_reader *in, const char *word)
{
    if (is_next(in, word)) {
        state_advance(in);
        return true;
    }
    if (in->token.kind == TOKEN_WORD && in->tried_count < TRIED_MAX && !is_punct(word))
        str_copy(in->tried[in->tried_count++], TRIED_LENGTH, word);
    return false;
}

static void expect(pov_reader *in, const char *word)
{
    char wanted[REPORT_QUOTE + 2] = "\"";
    bool is_first = !in->failed;
    guess g;

    if (accept(in, word))
        return;
    report_guess_start(&g, in);
    str_copy(wanted + 1, REPORT_QUOTE - 1, word);
    strcat(wanted, "\"");
    report_expected(in, wanted);
    if (is_first)
        str_copy(in->error.hint, sizeof in->error.hint, g.best);
}

static bool more(pov_reader *in)
{
    return value_follows(in);
}

static void fail(pov_reader *in, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    report_failv(in, &in->value, POV_E_SYNTAX, format, args);
    va_end(args);
}

static void warn(pov_reader *in, const char *format, ...)
{
    va_list args;

    /* After an error what was read is made up, and warnings of it would be too. */
    if (in->failed)
        return;
    va_start(args, format);
    report_warnv(in, &in->value, format, args);
    va_end(args);
}

const pov_host host_functions = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_host),
    .alloc = alloc,
    .number = number,
    .vector = vector,
    .accept = accept,
    .expect = expect,
    .more = more,
    .fail = fail,
    .warn = warn,
};
