/* lanes.h - vectors by lane, for loops that compilers vectorise. */
#ifndef BASE_LANES_H
#define BASE_LANES_H

#include "base/simd.h"

#include <povtrace/math.h>

#include <stdint.h>

enum { LANES_MAX = 64 };
typedef struct SIMD_ALIGNED vec_lanes { double x[LANES_MAX], y[LANES_MAX], z[LANES_MAX]; } vec_lanes;

static inline pov_vec3 lanes_at(const vec_lanes *l, uint32_t i) { return pov_vec3_of(l->x[i], l->y[i], l->z[i]); }
static inline void lanes_put(vec_lanes *l, uint32_t i, pov_vec3 v)
{
    l->x[i] = v.x;
    l->y[i] = v.y;
    l->z[i] = v.z;
}

/* Loops over lanes run over whole vectors of the processor, without a remainder. Lanes past the end hold earlier
 * values, and are not used. */
static inline uint32_t lanes_whole(uint32_t n) { return (n + 3) & ~3u; }

#endif
