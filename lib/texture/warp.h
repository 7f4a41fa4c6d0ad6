/* warp.h - moves points by warps and by turbulence. */
#ifndef TEXTURE_WARP_H
#define TEXTURE_WARP_H

#include "texture/noise.h"

/* Those of a list, the last of the text first, and the transformations between them. The tables may be NULL where
 * warp_needs_noise() is false. n is at least 1; lanes up to lanes_whole(n) are read and written. */
void warp_apply(const warp *list, const noise_tables *noise, vec_lanes *at, uint32_t n);
bool warp_needs_noise(const warp *list);
/* Points plus turbulence. */
void warp_displace(const turbulence *by, const noise_tables *noise, vec_lanes *at, uint32_t n);

#endif
