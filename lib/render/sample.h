/* sample.h - the places within a pixel that are looked through. */
#ifndef RENDER_SAMPLE_H
#define RENDER_SAMPLE_H

#include <stdint.h>

typedef struct sample { double x, y; } sample;

enum { SAMPLES_MAX = 1 << 16 };

/* The index-th place of a pixel's `half` (0 or 1) under a seed, from its top left corner, within 0 .. 1. A place depends on
 * nothing but these numbers, so that samples may be taken by any thread, in any order, and again.
 *
 * Each half is Sobol's (0,2)-sequence, scrambled anew for each pixel and each half: 2^k samples of a half from 0 on
 * have one in each of 2^k cells, whatever their shape, and every place is as likely as any other. So the mean of a
 * half is right on average, the halves are independent of each other and of those of all other pixels, and what
 * they differ by tells how far their mean is from the truth. */
sample sample_at(uint32_t seed, int x, int y, int half, uint32_t index);

/* Samples are dealt to the halves in turn: how many of `count` the first and the second has. */
static inline uint32_t sample_half(uint32_t count, int half)
{
    return half == 0 ? count - count / 2 : count / 2;
}

#endif
