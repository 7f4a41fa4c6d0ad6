/* sequence.h - points that fill the unit square evenly, in any number. */
#ifndef BASE_SEQUENCE_H
#define BASE_SEQUENCE_H

#include <stdint.h>

typedef struct sequence_point { double x, y; } sequence_point;

/* The index-th point of Sobol's (0,2)-sequence, scrambled by the bits of `seeds`: 2^k points from a multiple of 2^k on have
 * one in each of 2^k cells of any elementary shape, and each is equally likely anywhere. */
sequence_point sequence_at(uint32_t index, uint64_t seeds);
/* Its first component alone. */
double sequence_first(uint32_t index, uint32_t seed);
/* Another order of the indices, in which blocks of 2^k stay together: for a pair of dimensions that is to know nothing of
 * another pair. */
uint32_t sequence_shuffle(uint32_t index, uint32_t seed);

#endif
