/* host_parts.h - functions and transformations within the braces of a plugin's shape. */
#ifndef SDL_HOST_PARTS_H
#define SDL_HOST_PARTS_H

#include <povtrace/plugin.h>

/* See pov_host. */
const pov_function *host_function(pov_reader *in, uint32_t n);
const pov_function_bounds *host_function_bounds(pov_reader *in, const pov_function *f);
/* What host_function() made it of. */
const struct function *host_function_of(const pov_function *f);
bool host_transform(pov_reader *in, pov_affine *map);

#endif
