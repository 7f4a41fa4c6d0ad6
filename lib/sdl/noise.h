/* noise.h - the noise tables of a scene, made when something asks for them first. */
#ifndef SDL_NOISE_H
#define SDL_NOISE_H

#include "sdl/state.h"
#include "texture/noise.h"

/* NULL: the reader has failed. */
const noise_tables *noise_of(pov_reader *in);
/* All has been read: there are as many waves as the settings ask for. */
void noise_finish(pov_reader *in);

#endif
