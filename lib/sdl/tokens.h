/* tokens.h - the token that the lexer makes of a stretch of text, and what is known of a word. */
#ifndef SDL_TOKENS_H
#define SDL_TOKENS_H

#include "sdl/keywords.h"
#include "sdl/source.h"

#include "plug/shape_class.h"

/* What is known of a keyword beforehand. */
enum {
    KEYWORD_FLAG_BASE = 1u << 0,    /* of the base language: does not make a file `povray` */
    KEYWORD_FLAG_SHAPE = 1u << 1,   /* a primitive of the language, whether its plugin is there or not */
    KEYWORD_FLAG_PAINT = 1u << 2,   /* a colour may begin with it */
    KEYWORD_FLAG_NAMED = 1u << 4    /* a message about the missing feature has been given */
};

#define TOKEN_IDENTIFIER(name, text, flags) KEYWORD_##name,
typedef enum keyword_id { KEYWORD_OTHER, TOKEN_KEYWORDS(TOKEN_IDENTIFIER) KEYWORDS } keyword_id;
#undef TOKEN_IDENTIFIER

typedef struct symbol {
    const char *name;            /* with an end mark */
    uint32_t length, hash;
    keyword_id id;               /* KEYWORD_OTHER: no word of the language */
    uint32_t flags;              /* KEYWORD_FLAG_* above */
    struct binding *binding;     /* the innermost value of that name; NULL: none is declared */
    const struct intrinsic *intrinsic;   /* a function of expressions; NULL: none of that name */
    const struct pattern_class *pattern; /* NULL: none of that name */
    int directive;               /* row among the directives, or -1 */
    const shape_class *shape;   /* NULL: not asked for yet, or none */
    void *last;                  /* what was written last of the shape; NULL: nothing yet */
} symbol;

/* The kind of punctuation is its character; <= >= and != are one token each. LEAVE stands behind the last
 * token of a macro's body and of an included file. */
enum {
    TOKEN_END = 0, TOKEN_NUMBER = 256, TOKEN_WORD, TOKEN_STRING, TOKEN_BAD, TOKEN_LEAVE,
    TOKEN_AT_MOST, TOKEN_AT_LEAST, TOKEN_UNEQUAL
};

typedef struct token {
    int kind;
    symbol *symbol;              /* of a word */
    double number;
    const char *fault;           /* what is wrong: an error if the kind is BAD, else worth a warning */
    place at;
} token;

const char *token_keyword_name(keyword_id id);
uint32_t token_keyword_flags(keyword_id id);

#endif
