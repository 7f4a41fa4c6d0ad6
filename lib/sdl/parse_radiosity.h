/* parse_radiosity.h - radiosity { } of the scene. */
#ifndef SDL_PARSE_RADIOSITY_H
#define SDL_PARSE_RADIOSITY_H

#include "sdl/parse.h"

/* The word was taken. */
void parse_radiosity(pov_reader *in, void *self, keyword_id keyword);
void parse_radiosity_init(model *m);

#endif
