/* spline.h - spline { }: points along a parameter, and what lies between them. */
#ifndef SDL_SPLINE_H
#define SDL_SPLINE_H

#include "sdl/state.h"

/* `spline` has been taken: its block. */
value spline_read(pov_reader *in);
/* `(` is next: a parameter, and perhaps a type. The callee is dropped. */
value spline_call(pov_reader *in, value callee);

#endif
