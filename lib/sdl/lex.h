/* lex.h - bytes to tokens. */
#ifndef SDL_LEX_H
#define SDL_LEX_H

#include "sdl/symbols.h"

typedef struct lex {
    source_stack sources;
    const symbols *words;
} lex;

/* The next token; at the end of the last text TOKEN_END, as often as asked. After TOKEN_BAD the lexer stands
 * behind the stretch of text that is wrong. */
void lex_next(lex *l, token *out);

#endif
