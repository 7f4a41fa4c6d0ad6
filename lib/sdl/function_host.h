/* function_host.h - functions of patterns, pigments and transformations, at a point: when the text calls them, and for
 * programs that do, of which any thread may ask. */
#ifndef SDL_FUNCTION_HOST_H
#define SDL_FUNCTION_HOST_H

#include "base/lanes.h"
#include "sdl/function.h"

/* One number of what a function gives at the point `at`, x y z: component `part` of a vector or colour. `self` is the
 * function. */
double function_host_value(const void *self, const double *at, uint32_t part);
/* Of a function of a pattern, at n points (LANES_MAX at most). */
void function_host_values(const function *f, const vec_lanes *at, uint32_t n, double *out);
void function_host_colour(const function *f, const double *at, double out[5]);
pov_vec3 function_host_map(const function *f, const double *at);

#endif
