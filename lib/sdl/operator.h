/* operator.h - operators of two values: numbers, vectors component by component, strings compared. */
#ifndef SDL_OPERATOR_H
#define SDL_OPERATOR_H

#include "sdl/state.h"

/* a op b into a; both were the caller's, b is dropped. The operator stood at `at`. */
void operator_combine(pov_reader *in, int op, const place *at, value *a, value b);

#endif
