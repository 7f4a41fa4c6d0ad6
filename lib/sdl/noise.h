/* noise.h - the noise tables of a scene, made when something asks for them first. */
#ifndef SDL_NOISE_H
#define SDL_NOISE_H

#include "sdl/state.h"
#include "texture/noise.h"

/* NULL: the reader has failed. */
const noise_tables *noise_of(pov_reader *in);
/* Settings: which generator patterns use that name none, and how many sources ripples and waves have. */
void noise_read_generator(pov_reader *in, void *self, keyword_id keyword);
void noise_read_waves(pov_reader *in, void *self, keyword_id keyword);
/* All has been read. */
void noise_finish(pov_reader *in);

#endif
