/* tone.h - from linear light to display codes, with exposure. */
#ifndef VIEWER_TONE_H
#define VIEWER_TONE_H

#include <povtrace/image.h>

enum { TONE_STEPS = 16384 };

typedef struct tone { float gain; uint8_t codes[TONE_STEPS + 1]; } tone;

/* Codes are within one of the exact ones: a step is a quarter of the finest code of sRGB. */
void tone_init(tone *t, pov_transfer transfer, double gain);
/* One pixel with no gain, rounded correctly. */
void tone_exact(pov_transfer transfer, const float *rgba, uint8_t *out);
/* Convert so many pixels of four channels; pixels of alpha 0, not traced yet, stay so. */
void tone_row(const tone *t, const float *rgba, uint8_t *out, int count);

#endif
