/* parse_air.h - what stands around the scene: background, sky, fog, rainbow. */
#ifndef SDL_PARSE_AIR_H
#define SDL_PARSE_AIR_H

#include "sdl/parse.h"

/* The word was taken. Statements; each as a value of a name is in the scene's memory. NULL: the reader has failed. */
const sky_sphere *parse_sky_node(pov_reader *in);
const fog *parse_fog_node(pov_reader *in);
const rainbow *parse_rainbow_node(pov_reader *in);
void parse_sky(pov_reader *in, void *self, keyword_id keyword);
void parse_fog(pov_reader *in, void *self, keyword_id keyword);
void parse_rainbow(pov_reader *in, void *self, keyword_id keyword);

#endif
