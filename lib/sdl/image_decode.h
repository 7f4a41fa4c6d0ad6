/* image_decode.h - from an image's stored numbers to colours of the scene, by the rules of the scene's version. */
#ifndef SDL_IMAGE_DECODE_H
#define SDL_IMAGE_DECODE_H

#include "sdl/image_file.h"

/* Filter and transmit of single entries of a palette: negative where nothing was written. */
typedef struct image_alphas { float filter[256], transmit[256]; bool has_transmit_all; } image_alphas;

/* A stored number as the gamma that was given says. */
double image_decoded(const image_gamma *given, double v);
/* The brightness of grey, in float, cut down to a byte. */
int image_cut_grey(double v);
/* Fill what the map needs of decoded numbers. is_plain: stored values count, unless gamma is given. */
void image_decode(pov_reader *in, image_map *map, const image_gamma *given, const image_alphas *alphas, bool is_plain);

#endif
