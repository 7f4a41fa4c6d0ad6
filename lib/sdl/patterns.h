/* patterns.h - pigments that vary: their lists of colours, and where in space they stand. */
#ifndef SDL_PATTERNS_H
#define SDL_PATTERNS_H

#include "sdl/parse.h"

/* The word of a pattern that is drawn is next: read it and its list. False: it is not. */
bool patterns_read(pov_reader *in, surface_parsed *s);
/* One of PARSE_MOVES: the pigment moves. One colour fills the whole space, so moving it changes nothing. */
void patterns_move(pov_reader *in, void *self, keyword_id keyword);
/* Transformations of a list. */
uint32_t patterns_count_moves(const transform *list);
/* Before the material is stored: its pattern knows where it stands. */
void patterns_settle(pov_reader *in, material *m);
/* Of the last leaf's transformations so many came behind its texture, and moved it too. */
void patterns_place(pov_reader *in, const transform *map, uint32_t moves);

#endif
