/* wave.h - frequency, phase and wave form: the last step from a pattern's value to what a map is asked for. */
#ifndef TEXTURE_WAVE_H
#define TEXTURE_WAVE_H

#include "base/lanes.h"
#include "model/warp.h"

/* n values; those up to lanes_whole(n) may be read and written. */
void wave_shape(const wave *w, uint32_t n, double *value);

#endif
