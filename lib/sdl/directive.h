/* directive.h - words behind a '#': what steers the reading itself. */
#ifndef SDL_DIRECTIVE_H
#define SDL_DIRECTIVE_H

#include "sdl/state.h"

/* Note at the words of the language which of them are directives. */
void directive_init(symbols *words);
/* The next token is a '#'. Carry out the directive; the next token is then what stands behind it, which may
 * be the '#' of another. */
void directive_run(pov_reader *in);
/* The next token is a directive's word that stands without its '#', as old scenes have it. False: it is none. */
bool directive_run_bare(pov_reader *in);
/* What the word behind a '#' adds to the #end that are still to come: 1, 0 or -1. */
int directive_nesting(const token *word);

/* Take the token and fetch the next, which is not carried out even if it is a '#'. */
void directive_step(pov_reader *in);
/* Tokens are left out until `depth` more #end than beginnings were met, or, where asked for, until #else and its like
 * stand at the outermost level. Returns the word that ended it; what stood at `at` has no end if there is none. */
token directive_skip(pov_reader *in, const place *at, size_t depth, bool stops_at_branches);
void directive_skip_all(pov_reader *in, const place *at, size_t depth);

#endif
