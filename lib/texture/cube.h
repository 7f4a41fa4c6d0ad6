/* cube.h - numbers of cubes of side 1, and the random point in each. */
#ifndef TEXTURE_CUBE_H
#define TEXTURE_CUBE_H

#include "texture/noise.h"

#include <math.h>

/* A whole number, of any size, for noise_hash(), which repeats. NaN: 0. */
static inline int32_t cube_of(double whole)
{
    const double rest = whole - NOISE_HASH * floor(whole / NOISE_HASH);

    return rest >= 0.0 && rest < NOISE_HASH ? (int32_t)rest : 0;
}

/* The random point nearest to a point, which is the first of those equally near. */
pov_vec3 cube_nearest(const noise_tables *t, pov_vec3 at);

#endif
