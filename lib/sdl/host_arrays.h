/* host_arrays.h - shapes that are read from arrays: their plugins' parse() takes numbers from these, not from text. */
#ifndef SDL_HOST_ARRAYS_H
#define SDL_HOST_ARRAYS_H

#include "build/parts.h"

#include <povtrace/plugin.h>

/* The object that is read next; pov_reader.rows points here while it is. */
typedef struct array_rows {
    const build_part *part;
    size_t row;
    int column;
} array_rows;

/* What a plugin is offered meanwhile. */
pov_host host_arrays(void);

#endif
