/* image_heights.h - an image as heights, for plugins. */
#ifndef SDL_IMAGE_HEIGHTS_H
#define SDL_IMAGE_HEIGHTS_H

#include <povtrace/plugin.h>

/* See pov_host.heights. */
const uint16_t *image_heights_read(pov_reader *in, uint32_t *width, uint32_t *height);

#endif
