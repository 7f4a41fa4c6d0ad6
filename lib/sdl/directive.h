/* directive.h - words behind a '#': what steers the reading itself. */
#ifndef SDL_DIRECTIVE_H
#define SDL_DIRECTIVE_H

#include "sdl/state.h"

/* The next token is a '#'. Carry out the directive; the next token is then what stands behind it, which may
 * be the '#' of another. */
void directive_run(pov_reader *in);

/* Of the word behind a '#': its row among the directives, or -1. There are at most 32. */
int directive_index(const token *word);
const char *directive_name(int index);
bool directive_is_supported(int index);

#endif
