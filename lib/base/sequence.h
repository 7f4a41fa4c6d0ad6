/* sequence.h - points that fill the unit square evenly, in any number: for one index and in a loop over lanes. */
#ifndef BASE_SEQUENCE_H
#define BASE_SEQUENCE_H

#include "base/elementary.h"

typedef struct sequence_point { double x, y; } sequence_point;

SIMD_INLINE uint32_t sequence_mirrored(uint32_t v)
{
    v = (v >> 1 & 0x55555555u) | (v & 0x55555555u) << 1;
    v = (v >> 2 & 0x33333333u) | (v & 0x33333333u) << 2;
    v = (v >> 4 & 0x0f0f0f0fu) | (v & 0x0f0f0f0fu) << 4;
    v = (v >> 8 & 0x00ff00ffu) | (v & 0x00ff00ffu) << 8;
    return v >> 16 | v << 16;
}

/* Owen scrambling of a fraction with mirrored digits: each digit is flipped or not by a hash of the digits before it.
 * The hash is that of Laine and Karras: Stratified sampling for stochastic transparency, EGSR 2011. Burley showed that
 * it makes an Owen scrambling of a mirrored number: Practical hash-based Owen scrambling, JCGT 9(4), 2020. */
SIMD_INLINE uint32_t sequence_scrambled(uint32_t v, uint32_t seed)
{
    v += seed;
    v ^= v * 0x6c50b47cu;
    v ^= v * 0xb82f1e52u;
    v ^= v * 0xc7afe638u;
    v ^= v * 0x8d22f6e6u;
    return v;
}

/* Sobol's second dimension, mirrored: the columns of Pascal's triangle modulo 2, which is a Kronecker power. */
SIMD_INLINE uint32_t sequence_second_dimension(uint32_t index)
{
    index ^= (index & 0xaaaaaaaau) >> 1;
    index ^= (index & 0xccccccccu) >> 2;
    index ^= (index & 0xf0f0f0f0u) >> 4;
    index ^= (index & 0xff00ff00u) >> 8;
    return index ^ index >> 16;
}

/* (digits + 1/2) / 2^32, exactly. */
SIMD_INLINE double sequence_fraction(uint32_t digits)
{
    return (elementary_of_bits(0x4330000000000000 | (uint64_t)digits) - (0x1p52 - 0.5)) * 0x1p-32;
}

/* The index-th point of Sobol's (0,2)-sequence, scrambled by the bits of `seeds`: 2^k points from a multiple of 2^k on have
 * one in each of 2^k cells of any elementary shape, and each is equally likely anywhere. Its first component. */
SIMD_INLINE double sequence_first(uint32_t index, uint32_t seed)
{
    /* The index itself is the first dimension, mirrored. */
    return sequence_fraction(sequence_mirrored(sequence_scrambled(index, seed)));
}

SIMD_INLINE sequence_point sequence_at(uint32_t index, uint64_t seeds)
{
    const uint32_t second = sequence_scrambled(sequence_second_dimension(index), (uint32_t)(seeds >> 32));
    const sequence_point p = { sequence_first(index, (uint32_t)seeds), sequence_fraction(sequence_mirrored(second)) };

    return p;
}

/* Pairs of bits as numbers of the field of four elements, times w of w^2 = w + 1. */
SIMD_INLINE uint32_t sequence_times_w(uint32_t v) { return (v >> 1 & 0x55555555u) | ((v << 1 ^ v) & 0xaaaaaaaau); }
SIMD_INLINE uint32_t sequence_times_w2(uint32_t v) { return sequence_times_w(v) ^ v; }

/* The index of another point of the sequence for the same sample, such that both points together fill four dimensions evenly:
 * 4^k samples from a multiple of 4^k on have one in each of 4^k boxes of any shape whose edges are 1 over powers of 4, and each
 * pair stays what it is. Faure's (0,4)-sequence in base 4 has Pascal's triangle to the powers 0, 1, w and w^2 = 1 + w in that field:
 * 0 and 1 are Sobol's two dimensions, but for a last step within pairs of bits, and the others are these at the index times the triangle
 * to the w, which is a Kronecker power too. The last line changes no box; of 2^k boxes for odd k it leaves fewer empty. */
SIMD_INLINE uint32_t sequence_partner(uint32_t index)
{
    index ^= sequence_times_w((index & 0xccccccccu) >> 2);
    index ^= sequence_times_w2((index & 0xf0f0f0f0u) >> 4);
    index ^= sequence_times_w((index & 0xff00ff00u) >> 8);
    index ^= sequence_times_w2(index >> 16);
    return index ^ (index >> 1 & 0x55555555u);
}

/* Another order of the indices, in which blocks of 2^k stay together: for a pair of dimensions that is to know nothing of
 * another pair. */
SIMD_INLINE uint32_t sequence_shuffle(uint32_t index, uint32_t seed)
{
    return sequence_mirrored(sequence_scrambled(sequence_mirrored(index), seed));
}

#endif
