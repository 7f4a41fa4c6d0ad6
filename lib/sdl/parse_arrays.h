/* parse_arrays.h - objects from arrays of a program. */
#ifndef SDL_PARSE_ARRAYS_H
#define SDL_PARSE_ARRAYS_H

#include "sdl/state.h"

/* The objects of a part become objects of the scene, as those of its text would. */
void parse_arrays(pov_reader *in, const scene_parts *all, const build_part *part);
void parse_array_lights(pov_reader *in, const scene_parts *all, const build_part *part);
/* The camera becomes that of the scene, as it is. */
void parse_given_camera(pov_reader *in, const build_part *part);

#endif
