#include "say.h"

#include <stdio.h>

/* Control characters in scene text would reach the terminal as commands. */
static void make_printable(char *text)
{
    for (; *text; text++)
        if ((unsigned char)*text < 0x20 || *text == 0x7f)
            *text = '?';
}

void say(const char *kind, const pov_error *err)
{
    pov_error e = *err;

    make_printable(e.file);
    make_printable(e.message);
    make_printable(e.hint);
    flockfile(stderr);
    fprintf(stderr, "%s:", e.file[0] ? e.file : "povview");
    if (e.line > 0)
        fprintf(stderr, "%d:%d:", e.line, e.column);
    fprintf(stderr, " %s: %s", kind, e.message);
    if (e.hint[0])
        fprintf(stderr, "; did you mean \"%s\"?", e.hint);
    fputc('\n', stderr);
    funlockfile(stderr);
}
