/* noise_functions.h - the functions of functions.inc that are made of noise. */
#ifndef TEXTURE_NOISE_FUNCTIONS_H
#define TEXTURE_NOISE_FUNCTIONS_H

#include <stdbool.h>
#include <stdint.h>

/* By their numbers in internal(): hetero_mf, ridge, ridged_mf, noise3d, noise_generator. */
bool noise_function_exists(uint32_t number);

/* Argument a of lane i is at [a * NOISE_FUNCTION_LANES + i]. */
enum { NOISE_FUNCTION_LANES = 16 };

/* The value at x, y, z and the parameters behind them; `scene` is the model. */
double noise_function_value(const void *scene, const double *v, uint32_t number);
/* The same of the first n lanes, with the same bits. `out` has room for all lanes; `memo` is for others (program.h). */
void noise_function_values(const void *scene, const double *v, uint32_t number, uint32_t n, void *memo, double *out);

#endif
