/* lex.h - bytes to tokens. */
#ifndef SDL_LEX_H
#define SDL_LEX_H

#include "sdl/symbols.h"

/* The next token of a text; at its end TOKEN_END, as often as asked. After TOKEN_BAD the text stands behind
 * the stretch that is wrong. Words that are new become symbols. */
void lex_next(symbols *words, source *s, token *out);
/* To the next '#' that is a token, or to the end of the text; the tokens before it are not made. */
void lex_skip(source *s);
/* The bytes between the quotes of a string token: as written, and with escapes resolved into `out`, which has
 * room for the token's length. *bad: an escape that there is none of, or NULL. Returns the length. */
size_t lex_unescape(const place *string, char *out, const char **bad);
/* A character below 0x10000 as UTF-8; returns its bytes. */
size_t lex_put_character(char out[3], unsigned code);

#endif
