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

SIMD_INLINE uint64_t sample_lens_key(uint32_t seed, int x, int y, int half)
{
    return mix_bits(sample_key(seed, x, y, half) + 0xd1342543de82ef95u);
}

/* The point of the unit square that says where on the lens a sample starts. These fill the square as evenly as those of
 * sample_at() do, and both together fill the four dimensions of pixel and lens. */
SIMD_INLINE sample sample_on_lens(uint32_t seed, int x, int y, int half, uint32_t index)
{
    const sequence_point p = sequence_at(sequence_partner(index), sample_lens_key(seed, x, y, half));
    const sample s = { p.x, p.y };

    return s;
}

/* The same where a pixel has no other sample. */
SIMD_INLINE sample sample_on_lens_alone(uint32_t seed, int x, int y)
{
    const uint64_t key = sample_lens_key(seed, x, y, 0);
    const sequence_point p = sequence_at(sequence_shuffle(0, (uint32_t)(key >> 13)), mix_bits(key));
    const sample s = { p.x, p.y };

    return s;
}

/* Points of the unit disc for those of the unit square, all alike. Squares around the middle become circles, and a small square
 * stays nearly one: Shirley and Chiu, A low distortion map between disk and square, JGT 2(3), 1997. */
SIMD_INLINE sample sample_of_disc(sample square)
{
    const double a = 2.0 * square.x - 1.0, b = 2.0 * square.y - 1.0;
    const int wide = fabs(a) > fabs(b);
    const double radius = wide ? a : b, turn = 0.125 * (wide ? b : a) / radius;   /* no place is the middle itself */
    const double along = radius * elementary_cos_turns(turn), across = radius * elementary_sin_turns(turn);
    const sample s = { wide ? along : across, wide ? across : along };

    return s;
}

/* By radius and angle. */
SIMD_INLINE sample sample_of_disc_alone(sample square)
{
    const double radius = sqrt(square.x);
    const sample s = { radius * elementary_cos_turns(square.y), radius * elementary_sin_turns(square.y) };

    return s;
}

/* Samples alternate between the halves: the counts of the first and of the second half for `count` samples. */
static inline uint32_t sample_half(uint32_t count, int half)
{
    return half == 0 ? count - count / 2 : count / 2;
}

#endif
