/* mix.h - numbers that are as good as random, made of others. */
#ifndef BASE_MIX_H
#define BASE_MIX_H

#include <stdint.h>

/* The finaliser of Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA 2014. */
static inline uint64_t mix_bits(uint64_t v)
{
    v = (v ^ v >> 30) * 0xbf58476d1ce4e5b9u;
    v = (v ^ v >> 27) * 0x94d049bb133111ebu;
    return v ^ v >> 31;
}

#endif
