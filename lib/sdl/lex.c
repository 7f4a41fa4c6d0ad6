#include "sdl/lex.h"

#include "sdl/number.h"

#include <string.h>

enum { ODD, BLANK, LINE, DIGIT, LETTER, MARK, QUOTE };

/* One class a byte, so that each byte is looked at once. ODD: has no business outside of comments and
 * strings. */
static const unsigned char class_of[256] = {
    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    /* 00 */
    ODD,    BLANK,  LINE,   BLANK,  BLANK,  LINE,   ODD,    ODD,    /* 08: tab, line feed, vt, ff, return */
    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    /* 10 */
    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    ODD,    /* 18 */
    BLANK,  MARK,   QUOTE,  MARK,   ODD,    ODD,    MARK,   ODD,    /* 20:   ! " # $ % & ' */
    MARK,   MARK,   MARK,   MARK,   MARK,   MARK,   MARK,   MARK,   /* 28: ( ) * + , - . / */
    DIGIT,  DIGIT,  DIGIT,  DIGIT,  DIGIT,  DIGIT,  DIGIT,  DIGIT,  /* 30 */
    DIGIT,  DIGIT,  MARK,   MARK,   MARK,   MARK,   MARK,   MARK,   /* 38: 8 9 : ; < = > ? */
    ODD,    LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, /* 40 */
    LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, /* 48 */
    LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, /* 50 */
    LETTER, LETTER, LETTER, MARK,   ODD,    MARK,   ODD,    LETTER, /* 58: X Y Z [ \ ] ^ _ */
    ODD,    LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, /* 60 */
    LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, /* 68 */
    LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, LETTER, /* 70 */
    LETTER, LETTER, LETTER, MARK,   MARK,   MARK,   ODD,    ODD,    /* 78: x y z { | } ~ */
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

static void skip_line_comment(source *s)
{
    while (s->at < s->end && *s->at != '\n' && *s->at != '\r')
        s->at++;
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

static void lex_word(const lex *l, source *s, token *t)
{
    const char *at = s->at;
    uint32_t hash = SYMBOLS_HASH_START;

    while (at < s->end && (class_at(at) == LETTER || class_at(at) == DIGIT))
        hash = symbols_hash(hash, (unsigned char)*at++);
    finish(s, t, TOKEN_WORD, at);
    t->symbol = symbols_find(l->words, t->at.start, t->at.length, hash);
}

static void lex_number(source *s, token *t)
{
    const char *after;

    switch (number_read(s->at, s->end, &after, &t->number)) {
    case NUMBER_FINE:
        break;
    case NUMBER_TINY:
        t->fault = "is too small for a double and counts as 0";
        break;
    case NUMBER_HUGE:
        t->fault = "is too large a number";
        finish(s, t, TOKEN_BAD, after);
        return;
    case NUMBER_MALFORMED:
        t->fault = "is not a number";
        finish(s, t, TOKEN_BAD, after);
        return;
    }
    finish(s, t, TOKEN_NUMBER, after);
}

/* A backslash keeps the next byte from ending the string. */
static void lex_string(source *s, token *t)
{
    const char *at = s->at + 1;

    while (at < s->end && *at != '"' && class_at(at) != LINE)
        at += *at == '\\' && at + 1 < s->end && class_at(at + 1) != LINE ? 2 : 1;
    if (at < s->end && *at == '"') {
        finish(s, t, TOKEN_STRING, at + 1);
        return;
    }
    t->fault = "the string that begins here does not end on its line";
    finish(s, t, TOKEN_BAD, at);
}

/* A whole character of UTF-8 is one stretch, so that a message can show it. */
static void lex_odd(source *s, token *t)
{
    const char *after = s->at + 1;

    while (after < s->end && after < s->at + 4 && ((unsigned char)*s->at & 0xC0) == 0xC0 &&
           ((unsigned char)*after & 0xC0) == 0x80)
        after++;
    t->fault = "does not belong outside of comments and strings";
    finish(s, t, TOKEN_BAD, after);
}

static void lex_end(lex *l, token *t)
{
    place_here(&t->at, l->sources.top);
    t->kind = TOKEN_END;
}

void lex_next(lex *l, token *t)
{
    source *s;

    t->symbol = NULL;
    t->number = 0.0;
    t->fault = NULL;
    do {
        s = l->sources.top;
        if (!skip_blanks(s, &t->at)) {
            t->kind = TOKEN_BAD;
            t->at.length = 2;
            t->fault = "the comment that begins here has no end";
            return;
        }
    } while (s->at == s->end && source_pop(&l->sources));
    if (s->at == s->end) {
        lex_end(l, t);
        return;
    }
    place_here(&t->at, s);
    switch (class_at(s->at)) {
    case LETTER:
        lex_word(l, s, t);
        break;
    case DIGIT:
        lex_number(s, t);
        break;
    case QUOTE:
        lex_string(s, t);
        break;
    case MARK:
        if (*s->at == '.' && s->at + 1 < s->end && class_at(s->at + 1) == DIGIT)
            lex_number(s, t);
        else
            finish(s, t, (unsigned char)*s->at, s->at + 1);
        break;
    default:
        lex_odd(s, t);
    }
}
