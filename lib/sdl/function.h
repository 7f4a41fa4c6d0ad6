/* function.h - function { }: formulas that a scene declares, and their values. */
#ifndef SDL_FUNCTION_H
#define SDL_FUNCTION_H

#include "sdl/state.h"

/* `function` has been taken: its parameters and its block. */
value function_read(pov_reader *in);
/* `(` is next: as many numbers as the function has parameters. The callee is dropped. */
value function_call(pov_reader *in, value callee);

#endif
