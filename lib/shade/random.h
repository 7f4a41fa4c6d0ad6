/* random.h - the random numbers of paths.
 *
 * They are made of the sample that the path belongs to and of a number that says what they are for. So they depend on no
 * thread, no order and no packet. */
#ifndef SHADE_RANDOM_H
#define SHADE_RANDOM_H

#include "base/mix.h"
#include "base/sequence.h"

/* A camera ray: its pixel, mixed with the job's seed, and which of the pixel's samples it is. Samples alternate between the
 * pixel's halves, whose numbers are independent of each other. set: rays of the same are traced together, each in a place of
 * its own among RANDOM_PLACES, and may use what others of them find; 0: it is alone. */
typedef struct sample_id { uint64_t pixel; uint32_t number, place; uint64_t set; } sample_id;
enum { RANDOM_PLACES = 64 };

static inline sample_id sample_id_of(uint32_t seed, int x, int y, uint32_t number)
{
    const uint64_t key = mix_bits((uint64_t)(uint32_t)y << 32 ^ (uint64_t)(uint32_t)x);
    const sample_id id = { mix_bits(key + (uint64_t)seed * 0xd1342543de82ef95u + 1), number, 0, 0 };

    return id;
}

/* A set, by what its rays are and where they are in the picture. */
static inline uint64_t random_set(uint32_t seed, uint32_t what, int x, int y)
{
    const uint64_t key = mix_bits((uint64_t)what << 58 ^ (uint64_t)(uint32_t)y << 29 ^ (uint64_t)(uint32_t)x);

    return mix_bits(key + (uint64_t)seed * 0xa0761d6478bd642fu + 1) | 1;
}

/* 64 bits for the k-th samples of a set. Those of a seed are no other seed's at another k. */
static inline uint64_t random_turn(uint64_t set, uint32_t k) { return mix_bits(set + k * 0x9e3779b97f4a7c15u); }

/* 64 bits that know nothing of those for other purposes. */
static inline uint64_t random_bits(const sample_id *of, uint32_t purpose)
{
    return mix_bits(mix_bits(of->pixel + (uint64_t)(purpose + 1) * 0x9e3779b97f4a7c15u) + of->number);
}

/* 0 <= u < 1. */
static inline double random_fraction(uint64_t bits) { return (double)(bits >> 11) * 0x1p-53; }

/* The k-th of `count` points (a power of two) that a sample needs for one purpose. Together with those of the other samples
 * of the pixel's half they fill the square evenly. */
static inline sequence_point random_point(const sample_id *of, uint32_t k, uint32_t count, uint32_t purpose)
{
    const uint64_t key = mix_bits(of->pixel + (((uint64_t)purpose << 1 | (of->number & 1u)) + 1) * 0x9e3779b97f4a7c15u);

    return sequence_at(sequence_shuffle((of->number >> 1) * count + k, (uint32_t)(key >> 13)), mix_bits(key));
}

/* The first component alone of the only point of a sample. */
static inline double random_number(const sample_id *of, uint32_t purpose)
{
    const uint64_t key = mix_bits(of->pixel + (((uint64_t)purpose << 1 | (of->number & 1u)) + 1) * 0x9e3779b97f4a7c15u);

    return sequence_first(sequence_shuffle(of->number >> 1, (uint32_t)(key >> 13)), (uint32_t)mix_bits(key));
}

/* The same of a sample that may belong to a set: then the points of all of the set fill the square evenly. */
static inline sequence_point random_point_of_set(const sample_id *of, uint32_t k, uint32_t count, uint32_t purpose)
{
    const uint32_t number = (of->number >> 1) * RANDOM_PLACES + of->place;
    const sample_id set = { of->set, number << 1 | (of->number & 1u), 0, 0 };

    return random_point(of->set ? &set : of, k, count, purpose);
}

#endif
