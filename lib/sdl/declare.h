/* declare.h - #declare, #local, #undef, and what may stand behind their '='. */
#ifndef SDL_DECLARE_H
#define SDL_DECLARE_H

#include "sdl/state.h"

/* A value of any kind: an expression, a colour, a string, an array, any statement that a name can be given to. */
value declare_value(pov_reader *in);
void declare_run(pov_reader *in, const place *at);
void declare_forget(pov_reader *in, const place *at);

#endif
