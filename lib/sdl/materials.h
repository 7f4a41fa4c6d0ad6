/* materials.h - equal materials are one: a million spheres of one colour share it. */
#ifndef SDL_MATERIALS_H
#define SDL_MATERIALS_H

#include "sdl/state.h"

/* The index in the model of a material like this one, which is added if there is none. */
uint32_t materials_index(pov_reader *in, const material *m);

#endif
