/* Errors as text. */
#include <povtrace/base.h>

#include <stdio.h>
#include <string.h>

/* Text that may be longer than its place. */
typedef struct text { char *at; size_t size, length; } text;

static void put(text *t, const char *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++, t->length++)
        if (t->length + 1 < t->size)
            t->at[t->length] = bytes[i];
}

static void put_string(text *t, const char *string) { put(t, string, strlen(string)); }

static void put_place(text *t, const pov_error *err)
{
    char number[32];

    if (err->file[0])
        put_string(t, err->file);
    if (err->line > 0)
        put(t, number, (size_t)snprintf(number, sizeof number, ":%d", err->line));
    if (err->line > 0 && err->column > 0)
        put(t, number, (size_t)snprintf(number, sizeof number, ":%d", err->column));
    if (t->length > 0)
        put_string(t, ": ");
}

/* The line, and a caret under the place; tabs stay, so that it stands there whatever their width. */
static void put_excerpt(text *t, const pov_error *err)
{
    put_string(t, "\n    ");
    put_string(t, err->excerpt);
    put_string(t, "\n    ");
    for (int i = 0; i < err->caret && err->excerpt[i]; i++)
        if (((unsigned char)err->excerpt[i] & 0xc0) != 0x80)   /* a character of several bytes is one place */
            put(t, err->excerpt[i] == '\t' ? "\t" : " ", 1);
    put_string(t, "^");
}

size_t pov_error_format(const pov_error *err, char *out, size_t size)
{
    text t = { out, out ? size : 0, 0 };

    if (err) {
        put_place(&t, err);
        put_string(&t, err->message);
        if (err->hint[0]) {
            put_string(&t, "; did you mean \"");
            put_string(&t, err->hint);
            put_string(&t, "\"?");
        }
        if (err->line > 0 && err->excerpt[0] && err->caret >= 0)
            put_excerpt(&t, err);
    }
    if (t.size > 0)
        t.at[t.length < t.size ? t.length : t.size - 1] = '\0';
    return t.length;
}
