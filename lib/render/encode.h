/* encode.h - linear values to stored ones. */
#ifndef RENDER_ENCODE_H
#define RENDER_ENCODE_H

#include <povtrace/base.h>

enum { ENCODER_CELLS = 4096 };

/* For 8 bits: i + 1 is stored for linear values from above[i] on, so that a search replaces the curve. least[i] is the
 * byte at i / ENCODER_CELLS, where the search begins. */
typedef struct encoder {
    int bits;
    pov_transfer transfer;
    double gamma;                /* above 0: the curve is value ^ (1 / gamma), whatever the transfer */
    float above[256];            /* the last is beyond all values */
    unsigned char least[ENCODER_CELLS];
} encoder;

/* bits: 8 or 16 (native order): round(max * clamp(curve(value))); 32: the float as it is. */
void encoder_init(encoder *e, int bits, pov_transfer transfer, double gamma);
/* Convert one row of float RGBA pixels to `channels` values each: 3, or 4 with alpha, which no curve encodes. NaN is
 * stored as 0. */
void encoder_row(const encoder *e, const float *rgba, int width, int channels, void *out);

#endif
