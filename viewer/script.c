#include "script.h"

#include "app.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct verb { const char *name; script_kind kind; int code; int numbers; bool word; } verb;

static const verb verbs[] = {
    { "tab", SCRIPT_KEY, APP_KEY_TAB, 0, false },   { "enter", SCRIPT_KEY, APP_KEY_ENTER, 0, false },
    { "esc", SCRIPT_KEY, APP_KEY_ESCAPE, 0, false }, { "f1", SCRIPT_KEY, APP_KEY_F1, 0, false },
    { "up", SCRIPT_KEY, APP_KEY_UP, 0, false },     { "down", SCRIPT_KEY, APP_KEY_DOWN, 0, false },
    { "pageup", SCRIPT_KEY, APP_KEY_PAGE_UP, 0, false }, { "pagedown", SCRIPT_KEY, APP_KEY_PAGE_DOWN, 0, false },
    { "f5", SCRIPT_KEY, APP_KEY_F5, 0, false },     { "home", SCRIPT_KEY, APP_KEY_HOME, 0, false },
    { "lt", SCRIPT_CHARACTER, '<', 0, false },
    { "drag", SCRIPT_DRAG, 0, 2, false },           { "pan", SCRIPT_PAN, 0, 2, false },
    { "look", SCRIPT_LOOK, 0, 2, false },           { "move", SCRIPT_MOVE, 0, 2, false },
    { "wheel", SCRIPT_WHEEL, 0, 1, false },         { "fly", SCRIPT_FLY, 0, 1, true },
    { "size", SCRIPT_SIZE, 0, 2, false },           { "load", SCRIPT_LOAD, 0, 0, true },
};

static const verb *find_verb(const char *name, size_t length)
{
    for (size_t i = 0; i < sizeof verbs / sizeof verbs[0]; i++)
        if (strlen(verbs[i].name) == length && strncmp(verbs[i].name, name, length) == 0)
            return &verbs[i];
    return NULL;
}

/* A number of ordinary size, and the comma behind it if another follows. */
static bool read_number(const char **at, double *out, bool comma)
{
    const double most = 1e6;
    char *end;

    *out = strtod(*at, &end);
    if (end == *at || !(*out >= -most && *out <= most))
        return false;
    *at = end;
    if (comma && *(*at)++ != ',')
        return false;
    return true;
}

static bool read_word(const char **at, const char *close, bool is_last, char *out, size_t size)
{
    size_t length = is_last ? (size_t)(close - *at) : strcspn(*at, " >");

    if (length == 0 || length >= size)
        return false;
    memcpy(out, *at, length);
    out[length] = '\0';
    *at += length;
    return true;
}

static bool read_arguments(const verb *v, const char *at, const char *close, script_step *out)
{
    bool good = true;

    at += strspn(at, " ");
    if (v->word)
        good = read_word(&at, close, v->numbers == 0, out->word, sizeof out->word);
    at += strspn(at, " ");
    if (good && v->numbers > 0)
        good = read_number(&at, &out->x, v->numbers > 1);
    if (good && v->numbers > 1)
        good = read_number(&at, &out->y, false);
    return good && at == close;
}

static bool is_possible(const script_step *s)
{
    if (s->kind == SCRIPT_FLY)
        return s->x >= 0.0 && strspn(s->word, "WASDQE") == strlen(s->word);
    if (s->kind == SCRIPT_SIZE)
        return s->x >= 1.0 && s->y >= 1.0 && s->x <= 16384.0 && s->y <= 16384.0;
    return true;
}

static bool read_bracket(const char **at, script_step *out, char *problem, size_t size)
{
    const char *start = *at + 1, *close = strchr(start, '>');
    size_t length = strcspn(start, " >");
    const verb *v = close ? find_verb(start, length) : NULL;

    if (!close) {
        snprintf(problem, size, "\"<\" in --keys has no \">\"; <lt> is the character itself");
        return false;
    }
    if (!v) {
        snprintf(problem, size, "--keys knows no <%.*s>", (int)length, start);
        return false;
    }
    out->kind = v->kind;
    out->code = v->code;
    if (!read_arguments(v, start + length, close, out) || !is_possible(out)) {
        snprintf(problem, size, "--keys cannot read <%.*s>", (int)(close - start), start);
        return false;
    }
    *at = close + 1;
    return true;
}

bool script_next(const char **at, script_step *out, char *problem, size_t size)
{
    memset(out, 0, sizeof *out);
    while (isspace((unsigned char)**at))
        (*at)++;
    if (**at == '\0')
        return true;
    if (**at == '<')
        return read_bracket(at, out, problem, size);
    out->kind = SCRIPT_CHARACTER;
    out->code = (unsigned char)*(*at)++;
    return true;
}

bool script_check(const char *text, char *problem, size_t size)
{
    script_step step;

    do {
        if (!script_next(&text, &step, problem, size))
            return false;
    } while (step.kind != SCRIPT_END);
    return true;
}
