/* spline.h - spline { }: points along a parameter, and what lies between them. */
#ifndef SDL_SPLINE_H
#define SDL_SPLINE_H

#include "sdl/state.h"

/* `spline` has been taken: its block. */
value spline_read(pov_reader *in);
/* `(` is next: a parameter, and perhaps a type. The callee is dropped. */
value spline_call(pov_reader *in, value callee);

typedef struct spline spline;
/* A copy of a spline in the scene's memory, and its components at a parameter; any thread may ask. NULL: no memory. */
const spline *spline_keep(pov_reader *in, const value *v);
void spline_at(const spline *s, double t, double out[5]);

#endif
