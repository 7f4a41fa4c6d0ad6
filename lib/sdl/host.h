/* host.h - what the reader offers to a plugin's parse(). */
#ifndef SDL_HOST_H
#define SDL_HOST_H

#include <povtrace/plugin.h>

extern const pov_host host_functions;

#endif
