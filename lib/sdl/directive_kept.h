/* directive_kept.h - directives of kept tokens, compiled: those that loops and macros are made of. */
#ifndef SDL_DIRECTIVE_KEPT_H
#define SDL_DIRECTIVE_KEPT_H

#include "sdl/state.h"

/* The '#' is next: the directive has run, and the token behind it is next. False: nothing happened. */
bool directive_kept_run(pov_reader *in);

#endif
