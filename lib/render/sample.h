/* sample.h - sample positions within a pixel. */
#ifndef RENDER_SAMPLE_H
#define RENDER_SAMPLE_H

#include "base/mix.h"
#include "base/sequence.h"

typedef struct sample { double x, y; } sample;

enum { SAMPLES_MAX = 1 << 16 };

SIMD_INLINE uint64_t sample_key(uint32_t seed, int x, int y, int half)
{
    const uint64_t key = mix_bits((uint64_t)(uint32_t)half << 60 ^ (uint64_t)(uint32_t)y << 30 ^ (uint64_t)(uint32_t)x);

    return mix_bits(key + (uint64_t)seed * 0x9e3779b97f4a7c15u);
}

/* The index-th position of a pixel's `half` (0 or 1) for a seed, from the pixel's top left corner, within 0 .. 1. A
 * position depends on these numbers only, so that samples may be taken by any thread, in any order, and again.
 *
 * Each half is Sobol's (0,2)-sequence, scrambled separately for each pixel and each half: 2^k samples of a half from 0
 * on have one in each of 2^k cells of any elementary shape, and every position is equally likely. So the mean of a half
 * is unbiased, the halves are independent of each other and of those of all other pixels, and their difference
 * estimates the error of their mean. */
SIMD_INLINE sample sample_at(uint32_t seed, int x, int y, int half, uint32_t index)
{
    const sequence_point p = sequence_at(index, sample_key(seed, x, y, half));
    const sample s = { p.x, p.y };

    return s;
}

/* The same for the sample's place on the lens, within the unit square: a sequence of its own, in another order, so that the
 * pairs know nothing of each other. */
SIMD_INLINE sample sample_on_lens(uint32_t seed, int x, int y, int half, uint32_t index)
{
    const uint64_t key = mix_bits(sample_key(seed, x, y, half) + 0xd1342543de82ef95u);
    const sequence_point p = sequence_at(sequence_shuffle(index, (uint32_t)(key >> 13)), mix_bits(key));
    const sample s = { p.x, p.y };

    return s;
}

/* Samples alternate between the halves: the counts of the first and of the second half for `count` samples. */
static inline uint32_t sample_half(uint32_t count, int half)
{
    return half == 0 ? count - count / 2 : count / 2;
}

#endif
