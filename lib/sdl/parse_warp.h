/* parse_warp.h - reads `warp { }`, and the words of turbulence, which stand in other blocks too. */
#ifndef SDL_PARSE_WARP_H
#define SDL_PARSE_WARP_H

#include "model/warp.h"
#include "sdl/items.h"

/* The word was taken. The new warp stands before those of `list` and takes the transformations that were written since
 * the last one. NULL after an error. */
const warp *parse_warp(pov_reader *in, const transform *moves, const warp *list);

/* Readers for tables of items: octaves, lambda and omega of a turbulence, self. */
void parse_octaves(pov_reader *in, void *self, keyword_id keyword);
void parse_lambda(pov_reader *in, void *self, keyword_id keyword);
void parse_omega(pov_reader *in, void *self, keyword_id keyword);
#define PARSE_OCTAVES { KEYWORD_OCTAVES, parse_octaves }, { KEYWORD_LAMBDA, parse_lambda }, { KEYWORD_OMEGA, parse_omega }

#endif
