/* parse_inner.h - patterns made of other parts of a scene. */
#ifndef SDL_PARSE_INNER_H
#define SDL_PARSE_INNER_H

#include "sdl/state.h"
#include "texture/pattern.h"

/* The word of the class was taken: read its parsed form. True: it was, up to the end of its block, where a list may
 * stand before the '}', which is not taken. False: the class is read as others are. */
bool parse_inner(pov_reader *in, const pattern_class *class, void *self, block *b);

#endif
