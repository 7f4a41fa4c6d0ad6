/* noise_functions.h - the functions of functions.inc that are made of noise. */
#ifndef TEXTURE_NOISE_FUNCTIONS_H
#define TEXTURE_NOISE_FUNCTIONS_H

#include <stdint.h>

/* The value at x, y, z and the parameters behind them; `scene` is the model, `part` does nothing. */
typedef double noise_function(const void *scene, const double *v, uint32_t part);

/* By their numbers in internal(): hetero_mf, ridge, ridged_mf, noise3d, noise_generator; NULL for others. */
noise_function *noise_function_find(uint32_t number);

#endif
