/* image_function.h - images that a function makes. */
#ifndef SDL_IMAGE_FUNCTION_H
#define SDL_IMAGE_FUNCTION_H

#include "model/image.h"
#include "sdl/state.h"

/* `function` was taken: `W, H { f }`. 16 bits, not encoded: f at x and y from 0 to 1, y downwards. It is grey; with
 * `colours` a pigment has its own, and 1 - transmit as alpha. NULL: the reader has failed. */
const image *image_function_parse(pov_reader *in, bool colours);

#endif
