#include "sdl/lex.h"

#include "base/simd.h"
#include "sdl/number.h"

#include <string.h>

enum { ODD, BLANK, DIGIT, LETTER, LINE, PUNCT, QUOTE };

/* One class a byte, so that each byte is looked at once. ODD: has no business outside of comments and
 * strings. */
static const unsigned char class_of[256] = {
    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    /* 00 */
    ODD,    BLANK,  LINE,   BLANK,  BLANK,  LINE,   ODD,    ODD,    /* 08: tab, line feed, vt, ff, return */
    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    /* 10 */
    ODD,    ODD,    BLANK,  ODD,    ODD,    ODD,    ODD,    ODD,    /* 18: the end of a text in CP/M */
    BLANK,  PUNCT,   QUOTE,  PUNCT,   ODD,    ODD,    PUNCT,   ODD,    /* 20:   ! " # $ % & ' */
    PUNCT,   PUNCT,   PUNCT,   PUNCT,   PUNCT,   PUNCT,   PUNCT,   PUNCT,   /* 28: ( ) * + , - . / */
    DIGIT,  DIGIT,  DIGIT,  DIGIT,  DIGIT,  DIGIT,  DIGIT,  DIGIT,  /* 30 */
    DIGIT,  DIGIT,  PUNCT,   PUNCT,   PUNCT,   PUNCT,   PUNCT,   PUNCT,   /* 38: 8 9 : ; < = > ? */
    ODD,    LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, /* 40 */
    LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, /* 48 */
    LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, /* 50 */
    LETTER, LETTER, LETTER, PUNCT,   ODD,    PUNCT,   ODD,    LETTER, /* 58: X Y Z [ \ ] ^ _ */
    ODD,    LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, /* 60 */
    LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, /* 68 */
    LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, /* 70 */
    LETTER, LETTER, LETTER, PUNCT,   PUNCT,   PUNCT,   ODD,    ODD,    /* 78: x y z { | } ~ */
};

static int class_at(const char *at)
{
    return class_of[(unsigned char)*at];
}

/* ---- blanks and comments ---- */

/* Behind the end of a line: a line feed, a return, or both. */
static void take_line_end(source *s)
{
    if (*s->at == '\r' && s->at + 1 < s->end && s->at[1] == '\n')
        s->at++;
    s->at++;
    s->line++;
    s->line_start = s->at;
}

/* In pieces, for either end of a line may be the only one in the text. */
static void skip_line_comment(source *s)
{
    enum { PIECE = 256 };
    const char *feed, *back;

    do {
        size_t n = s->end - s->at < PIECE ? (size_t)(s->end - s->at) : PIECE;

        feed = memchr(s->at, '\n', n);
        n = feed ? (size_t)(feed - s->at) : n;
        back = memchr(s->at, '\r', n);
        s->at += back ? (size_t)(back - s->at) : n;
    } while (!feed && !back && s->at < s->end);
}

/* Comments nest. False: the text ends in it. */
static bool skip_comment(source *s)
{
    size_t depth = 1;

    s->at += 2;
    while (s->at < s->end && depth > 0) {
        char c = *s->at, next = s->at + 1 < s->end ? s->at[1] : '\0';

        if (c == '*' && next == '/') {
            depth--;
            s->at += 2;
        } else if (c == '/' && next == '*') {
            depth++;
            s->at += 2;
        } else if (class_at(s->at) == LINE) {
            take_line_end(s);
        } else {
            s->at++;
        }
    }
    return depth == 0;
}

static void place_here(place *p, const source *s)
{
    p->source = s;
    p->start = s->at;
    p->length = 0;
    p->line = s->line;
    p->column = (int)(s->at - s->line_start) + 1;
}

/* To the next byte that belongs to a token. False: a comment has no end; the place is its beginning. */
static bool skip_blanks(source *s, place *comment)
{
    while (s->at < s->end) {
        switch (class_at(s->at)) {
        case BLANK:
            s->at++;
            break;
        case LINE:
            take_line_end(s);
            break;
        default:
            if (*s->at != '/' || s->at + 1 == s->end)
                return true;
            if (s->at[1] == '/') {
                skip_line_comment(s);
            } else if (s->at[1] == '*') {
                place_here(comment, s);
                if (!skip_comment(s))
                    return false;
            } else {
                return true;
            }
        }
    }
    return true;
}

/* ---- tokens ---- */

static void finish(source *s, token *t, int kind, const char *after)
{
    t->kind = kind;
    t->at.length = (uint32_t)(after - s->at);
    s->at = after;
}

SIMD_APART static void lex_word(symbols *words, source *s, token *t)
{
    const char *at = s->at;
    uint32_t hash = SYMBOLS_HASH_START;

    while (at < s->end && (class_at(at) == LETTER || class_at(at) == DIGIT))
        hash = symbols_hash(hash, (unsigned char)*at++);
    finish(s, t, TOKEN_WORD, at);
    t->symbol = symbols_find(words, t->at.start, t->at.length, hash);
    if (!t->symbol)
        t->symbol = symbols_add(words, t->at.start, t->at.length, hash);
    if (!t->symbol)
        t->kind = TOKEN_BAD;     /* without a fault: memory */
}

SIMD_APART static void lex_number(source *s, token *t)
{
    const char *after;

    switch (number_read(s->at, s->end, &after, &t->number)) {
    case NUMBER_FINE:
        break;
    case NUMBER_TINY:
        t->fault = "is too small for a double and counts as 0";
        break;
    case NUMBER_HUGE:
        t->fault = "is too large for a double and counts as infinite";
        break;
    case NUMBER_MALFORMED:
        t->fault = "is not a number";
        finish(s, t, TOKEN_BAD, after);
        return;
    }
    finish(s, t, TOKEN_NUMBER, after);
}

/* A backslash keeps the next byte from ending the string, which may go over several lines. */
SIMD_APART static void lex_string(source *s, token *t)
{
    const char *at = s->at + 1, *begin = s->at, *line_end = NULL;

    for (; at < s->end && *at != '"'; at++) {
        if (class_at(at) == LINE && !line_end)
            line_end = at;
        if (*at == '\\' && at + 1 < s->end)
            at++;
    }
    if (at == s->end) {
        t->fault = "the string that begins here has no end";
        finish(s, t, TOKEN_BAD, line_end ? line_end : at);
        s->at = s->end;
        return;
    }
    for (s->at = line_end ? line_end : at; s->at < at;) {
        if (class_at(s->at) == LINE)
            take_line_end(s);
        else
            s->at++;
    }
    t->kind = TOKEN_STRING;
    t->at.length = (uint32_t)(at + 1 - begin);
    s->at = at + 1;
}

/* A whole character of UTF-8 is one stretch, so that a message can show it. */
SIMD_APART static void lex_odd(source *s, token *t)
{
    const char *after = s->at + 1;

    while (after < s->end && after < s->at + 4 && ((unsigned char)*s->at & 0xC0) == 0xC0 &&
           ((unsigned char)*after & 0xC0) == 0x80)
        after++;
    t->fault = "does not belong outside of comments and strings";
    finish(s, t, TOKEN_BAD, after);
}

static void lex_punct(source *s, token *t)
{
    const char *at = s->at;

    if (at + 1 < s->end && at[1] == '=' && (*at == '<' || *at == '>' || *at == '!'))
        finish(s, t, *at == '<' ? TOKEN_AT_MOST : *at == '>' ? TOKEN_AT_LEAST : TOKEN_UNEQUAL, at + 2);
    else
        finish(s, t, (unsigned char)*at, at + 1);
}

/* The text stands at a token, which begins with a byte of this class. */
static inline void lex_token(symbols *words, source *s, token *t, int class)
{
    t->symbol = NULL;
    t->number = 0.0;
    t->fault = NULL;
    place_here(&t->at, s);
    switch (class) {
    case LETTER:
        lex_word(words, s, t);
        break;
    case DIGIT:
        lex_number(s, t);
        break;
    case QUOTE:
        lex_string(s, t);
        break;
    case PUNCT:
        if (*s->at == '.' && s->at + 1 < s->end && class_at(s->at + 1) == DIGIT)
            lex_number(s, t);
        else
            lex_punct(s, t);
        break;
    default:
        lex_odd(s, t);
    }
}

/* Behind ends of lines and comments. */
SIMD_APART static void lex_behind(symbols *words, source *s, token *t)
{
    if (!skip_blanks(s, &t->at)) {
        t->symbol = NULL;
        t->number = 0.0;
        t->kind = TOKEN_BAD;
        t->at.length = 2;
        t->fault = "the comment that begins here has no end";
    } else if (s->at < s->end) {
        lex_token(words, s, t, class_at(s->at));
    } else {
        t->symbol = NULL;
        t->number = 0.0;
        t->fault = NULL;
        place_here(&t->at, s);
        t->kind = TOKEN_END;
    }
}

void lex_next(symbols *words, source *s, token *t)
{
    const char *at = s->at;
    int class = LINE;

    while (at < s->end && (class = class_at(at)) == BLANK)
        at++;
    s->at = at;
    if (at == s->end || class == LINE || *at == '/')
        lex_behind(words, s, t);
    else
        lex_token(words, s, t, class);
}

static bool is_comment(const source *s)
{
    return *s->at == '/' && s->at + 1 < s->end && (s->at[1] == '/' || s->at[1] == '*');
}

void lex_skip(source *s)
{
    token unused;

    while (s->at < s->end && *s->at != '#') {
        const int class = class_at(s->at);

        if (class == LINE)
            take_line_end(s);
        else if (class == QUOTE)
            lex_string(s, &unused);
        else if (class == PUNCT && is_comment(s))
            skip_blanks(s, &unused.at);
        else
            s->at++;
    }
}

/* ---- what stands between quotes ---- */

size_t lex_put_character(char out[3], unsigned code)
{
    if (code < 0x80) {
        out[0] = (char)code;
        return 1;
    }
    if (code < 0x800) {
        out[0] = (char)(0xC0 | code >> 6);
        out[1] = (char)(0x80 | (code & 0x3F));
        return 2;
    }
    out[0] = (char)(0xE0 | code >> 12);
    out[1] = (char)(0x80 | (code >> 6 & 0x3F));
    out[2] = (char)(0x80 | (code & 0x3F));
    return 3;
}

static bool read_hex(const char *at, const char *end, unsigned *code)
{
    static const char digits[] = "0123456789abcdef";
    int i;

    *code = 0;
    for (i = 0; i < 4; i++, at++) {
        const char *digit = at < end ? strchr(digits, *at | 0x20) : NULL;

        if (!digit || *at < '0')
            return false;
        *code = *code * 16 + (unsigned)(digit - digits);
    }
    return true;
}

size_t lex_unescape(const place *string, char *out, const char **bad)
{
    static const char names[] = "abfnrtv\\\"'", values[] = "\a\b\f\n\r\t\v\\\"'";
    const char *at = string->start + 1, *end = string->start + string->length - 1, *name;
    size_t n = 0;
    unsigned code;

    *bad = NULL;
    while (at < end) {
        if (*at != '\\') {
            out[n++] = *at++;
            continue;
        }
        name = at + 1 < end && at[1] ? strchr(names, at[1]) : NULL;
        if (name) {
            out[n++] = values[name - names];
            at += 2;
        } else if (at + 1 < end && at[1] == 'u' && read_hex(at + 2, end, &code)) {
            n += lex_put_character(out + n, code);
            at += 6;
        } else {
            *bad = at;
            return n;
        }
    }
    return n;
}
