/* array.h - arrays as values: making, filling, finding an element. */
#ifndef SDL_ARRAY_H
#define SDL_ARRAY_H

#include "sdl/state.h"

/* `array` has been taken: its sizes, and what stands in braces behind them. */
value array_read(pov_reader *in);
/* A '[' is next: as many subscripts as the array has dimensions. NULL: the reader has failed. */
value *array_slot(pov_reader *in, array *a);
/* Make the value that of an element. All elements are of one kind. */
void array_set(pov_reader *in, array *a, value *slot, value v);
/* Elements are copied, arrays in arrays too. */
value array_copy(pov_reader *in, const array *a);
/* Behind `defined` and #ifdef: `( NAME )`, or of an element. The closing bracket is taken. */
bool array_is_defined(pov_reader *in);
/* The same without what follows: the bracket is next. */
bool array_reads_defined(pov_reader *in);

#endif
