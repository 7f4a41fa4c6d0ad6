#include "base/sequence.h"

static uint32_t mirrored(uint32_t v)
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
static uint32_t scrambled(uint32_t v, uint32_t seed)
{
    v += seed;
    v ^= v * 0x6c50b47cu;
    v ^= v * 0xb82f1e52u;
    v ^= v * 0xc7afe638u;
    v ^= v * 0x8d22f6e6u;
    return v;
}

/* Sobol's second dimension, mirrored: the columns of Pascal's triangle modulo 2, which is a Kronecker power. */
static uint32_t second_dimension(uint32_t index)
{
    index ^= (index & 0xaaaaaaaau) >> 1;
    index ^= (index & 0xccccccccu) >> 2;
    index ^= (index & 0xf0f0f0f0u) >> 4;
    index ^= (index & 0xff00ff00u) >> 8;
    return index ^ index >> 16;
}

static double fraction(uint32_t digits)
{
    return ((double)digits + 0.5) / 4294967296.0;
}

double sequence_first(uint32_t index, uint32_t seed) { return fraction(mirrored(scrambled(index, seed))); }

sequence_point sequence_at(uint32_t index, uint64_t seeds)
{
    sequence_point p;

    /* The index itself is the first dimension, mirrored. */
    p.x = fraction(mirrored(scrambled(index, (uint32_t)seeds)));
    p.y = fraction(mirrored(scrambled(second_dimension(index), (uint32_t)(seeds >> 32))));
    return p;
}

uint32_t sequence_shuffle(uint32_t index, uint32_t seed) { return mirrored(scrambled(mirrored(index), seed)); }
