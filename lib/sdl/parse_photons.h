/* parse_photons.h - photons { } of the scene, of objects and of lights. */
#ifndef SDL_PARSE_PHOTONS_H
#define SDL_PARSE_PHOTONS_H

#include "sdl/parse.h"

/* The word was taken. */
void parse_photon_settings(pov_reader *in, void *self, keyword_id keyword);
/* Change flags of an object or a light as its block says. */
void parse_photons_object(pov_reader *in, uint32_t *flags);
void parse_photons_light(pov_reader *in, uint32_t *flags);

#endif
