/* parse_inner.h - patterns made of other parts of a scene. */
#ifndef SDL_PARSE_INNER_H
#define SDL_PARSE_INNER_H

#include "sdl/state.h"
#include "texture/pattern.h"

/* The word of the class was taken: read its parsed form. False: the class is read as others are. is_open: the block b is
 * read up to its end, where a list may stand before the '}', which is not taken. */
bool parse_inner(pov_reader *in, const pattern_class *class, void *self, block *b, bool *is_open);

#endif
