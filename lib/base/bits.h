/* bits.h - masks of lanes. */
#ifndef BASE_BITS_H
#define BASE_BITS_H

#include <stdint.h>

/* Index of the lowest set bit; the mask must not be zero. */
static inline uint32_t first_of(uint32_t mask)
{
#ifdef __GNUC__
    return (uint32_t)__builtin_ctz(mask);
#else
    uint32_t i = 0;
    while (!(mask >> i & 1))
        i++;
    return i;
#endif
}

static inline uint32_t first_of64(uint64_t mask)
{
#ifdef __GNUC__
    return (uint32_t)__builtin_ctzll(mask);
#else
    return (uint32_t)mask ? first_of((uint32_t)mask) : 32 + first_of((uint32_t)(mask >> 32));
#endif
}

#endif
