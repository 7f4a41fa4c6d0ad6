/* sample.h - the places within a pixel that are looked through. */
#ifndef RENDER_SAMPLE_H
#define RENDER_SAMPLE_H

#include "base/env.h"

typedef struct sample { double x, y; } sample;

enum { SAMPLES_MAX = 1 << 16 };

/* The same for every pixel: a regular grid when count is a square, else a Hammersley set; 1 is the centre.
 * Their mean is the centre, so that nothing moves when the count changes. NULL: no memory. env_free() it. */
sample *samples_make(const env *e, int count);

#endif
