/* ramp.h - numbers as colours of increasing lightness, distinguishable in print and with colour blindness. */
#ifndef VIEWER_RAMP_H
#define VIEWER_RAMP_H

#include <stdint.h>

/* 0 is dark, 1 is bright, values beyond are clamped; below 0 is unknown, and grey. Bytes red, green, blue, alpha. */
void ramp_color(double t, uint8_t *rgba);

#endif
