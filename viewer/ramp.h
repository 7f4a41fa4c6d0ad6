/* ramp.h - numbers as colours that get brighter all the way, so that they can be told apart in print and by everybody. */
#ifndef VIEWER_RAMP_H
#define VIEWER_RAMP_H

#include <stdint.h>

/* 0 is dark, 1 is bright, what is beyond is the end; below 0 is not known, and grey. Bytes red, green, blue, alpha. */
void ramp_color(double t, uint8_t *rgba);

#endif
