/* noise.h - the smooth random functions of POV-Ray, equal to its own within 1e-12.
 *
 * Scalar noise comes in three kinds (noise_generator 1 to 3). Vector noise and both kinds of turbulence are sums of it.
 * The tables are made for scenes that use them. */
#ifndef TEXTURE_NOISE_H
#define TEXTURE_NOISE_H

#include "base/arena.h"
#include "base/lanes.h"
#include "model/warp.h"

enum {
    NOISE_HASH = 4096, NOISE_MEASURED = 267, NOISE_GRADIENTS = 2048,
    NOISE_COPIES = 4, NOISE_COPY = 272,
    NOISE_WAVES = 10,
    NOISE_CELLS = NOISE_HASH + 2     /* random numbers by hash; a hash and the two behind it are a point in a cube */
};

typedef struct noise_wave { pov_vec3 source; double frequency; } noise_wave;

typedef struct noise_tables {
    SIMD_ALIGNED double gradient[NOISE_GRADIENTS][4];    /* of generator 3: 0, and a unit vector */
    double cell[NOISE_CELLS];                            /* in 0..1 */
    uint16_t hash[NOISE_HASH + 1];                       /* a permutation, and its first number once more */
    uint16_t order[NOISE_GRADIENTS];                     /* of generator 3 */
    uint16_t last[NOISE_HASH];                           /* by a hash: where measured numbers begin, from its low bits */
    SIMD_ALIGNED double measured[NOISE_COPIES][NOISE_COPY];   /* the same numbers, moved: so all begin where vectors do */
    noise_wave few[NOISE_WAVES];
    uint32_t waves;                                      /* sources of ripples and waves, NOISE_WAVES at least */
    const noise_wave *wave;                              /* the few, or in a scene's memory */
} noise_tables;

extern const double noise_measured[NOISE_MEASURED];
/* What places in a cube of side 2, each 1 or 0 and three coordinates, are seen from at its corners. */
enum { NOISE_CORNERS = 8, NOISE_PARTS = 4 };
extern const double noise_corner[NOISE_CORNERS][NOISE_PARTS];

/* From env_alloc_aligned(); NULL when memory ends. */
noise_tables *noise_create(const env *e);
/* Make at least so many sources of ripples and waves. False when memory ends. */
bool noise_want_waves(noise_tables *t, arena *memory, uint32_t count);

/* A whole number as an integer; what has no place there counts as 0. */
static inline int32_t noise_whole(double v) { return v >= -2147483648.0 && v < 2147483648.0 ? (int32_t)v : 0; }

/* The hash of a cube by its lowest corner, 0 to NOISE_HASH - 1. */
static inline uint32_t noise_hash(const noise_tables *t, int32_t x, int32_t y, int32_t z)
{
    const uint32_t mask = NOISE_HASH - 1;

    return t->hash[t->hash[t->hash[(uint32_t)x & mask] ^ ((uint32_t)y & mask)] ^ ((uint32_t)z & mask)];
}

/* ---- n points, scaled first; lanes up to lanes_whole(n) may be read and written ---- */

/* 0..1. */
void noise_values(const noise_tables *t, int generator, const vec_lanes *at, double scale, uint32_t n, double *value);
/* Three numbers, about -1..1; the same for all generators. */
void noise_vectors(const noise_tables *t, const vec_lanes *at, double scale, uint32_t n, vec_lanes *value);

/* Sums over octaves are made of generator 1 as it is, of the others as 2 noise - 1/2, clamped to 0..1.
 * Octaves from `scale` on, each of half the size and half the weight of the one before: half of their sum, or the sum of their
 * distances from 1/2. */
void noise_octaves(const noise_tables *t, int generator, const vec_lanes *at, double scale, uint32_t count, bool folds, uint32_t n,
                   double *value);
/* Turbulence, whose first octave alone is clamped. Its amount is the caller's to multiply with. */
void noise_turbulence(const noise_tables *t, int generator, const turbulence *of, const vec_lanes *at, uint32_t n,
                      double *value);
void noise_vector_turbulence(const noise_tables *t, const turbulence *of, const vec_lanes *at, uint32_t n,
                             vec_lanes *value);
/* x and y of it alone. */
void noise_flat_turbulence(const noise_tables *t, const turbulence *of, const vec_lanes *at, uint32_t n, vec_lanes *value);

/* ---- one point ---- */

double noise_value_at(const noise_tables *t, int generator, pov_vec3 at);
pov_vec3 noise_vector_turbulence_at(const noise_tables *t, const turbulence *of, pov_vec3 at);
double noise_turbulence_at(const noise_tables *t, int generator, const turbulence *of, pov_vec3 at);

#endif
