#include "messages.h"
#include "text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { TEXT_SIZE = 600 };

typedef enum style { STYLE_PLAIN, STYLE_PLACE, STYLE_ERROR, STYLE_WARNING, STYLE_NOTE, STYLE_CARET } style;

static const char *escape(const messages *m, style s)
{
    static const char *const escapes[] = { "\033[0m", "\033[1m", "\033[1;31m", "\033[1;35m", "\033[1;36m",
                                           "\033[1;32m" };

    return m->color ? escapes[s] : "";
}

bool messages_on_terminal(void)
{
    const char *terminal = getenv("TERM");

    return isatty(STDERR_FILENO) && terminal && *terminal && strcmp(terminal, "dumb") != 0;
}

void messages_init(messages *m, const args *a)
{
    const char *no_color = getenv("NO_COLOR");

    memset(m, 0, sizeof *m);
    m->quiet = a->quiet;
    m->verbose = a->verbose;
    m->json = a->json;
    m->color = a->color == ARGS_COLOR_ALWAYS ||
               (a->color == ARGS_COLOR_AUTO && !(no_color && *no_color) && messages_on_terminal());
}

/* The line, a caret under the position, and below it the word that was probably meant. */
static void show_excerpt(const messages *m, const pov_error *note)
{
    char line[TEXT_SIZE], indent[TEXT_SIZE];

    text_printable(note->excerpt, line, sizeof line);
    text_indent(note->excerpt, note->caret, indent, sizeof indent);
    fprintf(stderr, "%5d | %s\n", note->line, line);
    fprintf(stderr, "      | %s%s^%s\n", indent, escape(m, STYLE_CARET), escape(m, STYLE_PLAIN));
    if (note->hint[0])
        fprintf(stderr, "      | %sdid you mean \"%s\"?\n", indent, note->hint);
}

/* Scene text from a pipe has no name; a message without a position is the program's own. */
static const char *name_of(const pov_error *note)
{
    if (note->line > 0 && strcmp(note->file, "-") == 0)
        return "<stdin>";
    return note->file[0] ? note->file : "povc";
}

static void put_json(const char *name, const char *text)
{
    fprintf(stderr, "\"%s\":\"", name);
    for (; *text; text++)
        if ((unsigned char)*text < 0x20 || *text == 0x7f)
            fprintf(stderr, "\\u%04x", (unsigned)(unsigned char)*text);
        else
            fprintf(stderr, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    fputc('"', stderr);
}

static void show_json(const char *kind, const pov_error *note)
{
    flockfile(stderr);
    fputc('{', stderr);
    put_json("kind", kind);
    if (note->file[0]) {
        fputc(',', stderr);
        put_json("file", note->file);
    }
    if (note->line > 0)
        fprintf(stderr, ",\"line\":%d,\"column\":%d", note->line, note->column);
    fputc(',', stderr);
    put_json("message", note->message);
    if (note->hint[0]) {
        fputc(',', stderr);
        put_json("hint", note->hint);
    }
    fputs("}\n", stderr);
    funlockfile(stderr);
}

static void show(const messages *m, style s, const char *kind, const pov_error *note)
{
    char text[TEXT_SIZE], file[TEXT_SIZE];
    bool excerpt = note->line > 0 && note->excerpt[0] && note->caret >= 0;

    if (m->json) {
        show_json(kind, note);
        return;
    }
    text_printable(note->message, text, sizeof text);
    text_printable(name_of(note), file, sizeof file);
    flockfile(stderr);
    fprintf(stderr, "%s%s:", escape(m, STYLE_PLACE), file);
    if (note->line > 0)
        fprintf(stderr, "%d:", note->line);
    if (note->line > 0 && note->column > 0)
        fprintf(stderr, "%d:", note->column);
    fprintf(stderr, "%s %s%s:%s %s", escape(m, STYLE_PLAIN), escape(m, s), kind, escape(m, STYLE_PLAIN),
            text);
    if (note->hint[0] && !excerpt)
        fprintf(stderr, "; did you mean \"%s\"?", note->hint);
    fputc('\n', stderr);
    if (excerpt)
        show_excerpt(m, note);
    funlockfile(stderr);
}

void messages_error(const messages *m, const pov_error *err)
{
    if (m->errors == 0)
        show(m, STYLE_ERROR, "error", err);
    else if (m->errors > 1)
        messages_say(m, "%u errors", m->errors);
}

void messages_log(void *user, pov_log_level level, const pov_error *note)
{
    messages *m = user;

    if (level == POV_LOG_SCENE) {
        fputs(note->message, stderr);
        return;
    }
    if (level == POV_LOG_ERROR) {
        m->errors++;
        show(m, STYLE_ERROR, "error", note);
        return;
    }
    if (level == POV_LOG_WARN) {
        flockfile(stderr);
        m->warnings++;
        funlockfile(stderr);
    }
    if (m->quiet || (level != POV_LOG_WARN && level != POV_LOG_STACK && !m->verbose))
        return;
    if (level == POV_LOG_WARN)
        show(m, STYLE_WARNING, "warning", note);
    else
        show(m, STYLE_NOTE, level != POV_LOG_DEBUG ? "note" : "debug", note);
}

void messages_say(const messages *m, const char *format, ...)
{
    pov_error note = { 0 };
    va_list list;

    if (m->quiet)
        return;
    va_start(list, format);
    vsnprintf(note.message, sizeof note.message, format, list);
    va_end(list);
    if (m->json) {
        show_json("note", &note);
        return;
    }
    flockfile(stderr);
    fprintf(stderr, "%spovc:%s %s\n", escape(m, STYLE_PLACE), escape(m, STYLE_PLAIN), note.message);
    funlockfile(stderr);
}

void messages_warn(const messages *m, const char *format, ...)
{
    pov_error note = { 0 };
    va_list list;

    va_start(list, format);
    vsnprintf(note.message, sizeof note.message, format, list);
    va_end(list);
    if (!m->quiet)
        show(m, STYLE_WARNING, "warning", &note);
}

void messages_notes(const messages *m, const args *a)
{
    for (int i = 0; i < a->note_count; i++)
        messages_warn(m, "%s", a->note[i]);
}
