/* function_host.h - functions of patterns, pigments and transformations, at a point: when the text calls them, and for
 * programs that do, of which any thread may ask. */
#ifndef SDL_FUNCTION_HOST_H
#define SDL_FUNCTION_HOST_H

#include "sdl/function.h"

/* One number of what a function gives at the point `at`, x y z: component `part` of a vector or colour. `self` is the
 * function. */
double function_host_value(const void *self, const double *at, uint32_t part);
/* The same at n points, as program_host has them; n is at most PROGRAM_LANES. */
void function_host_values(const void *self, const double *at, uint32_t part, uint32_t n, void *memo, double *out);
/* Colours of a pigment at n points, up to LANES_MAX. */
void function_host_colours(const function *f, const pov_vec3 *at, uint32_t n, double (*out)[5]);
pov_vec3 function_host_map(const function *f, const double *at);

#endif
