/* powers.h - powers by lane, with the bits of elementary_pow(). */
#ifndef BASE_POWERS_H
#define BASE_POWERS_H

#include <stdint.h>

/* Of up to LANES_MAX numbers. */
void powers_raise(double exponent, uint32_t n, double *value);
void powers_raise_each(const double *exponent, uint32_t n, double *value);

#endif
