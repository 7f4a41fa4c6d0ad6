/* internal.h - internal(0) to internal(78): surfaces and curves that POV-Ray's functions.inc gives names to. */
#ifndef FUNCTION_INTERNAL_H
#define FUNCTION_INTERNAL_H

#include <stdbool.h>
#include <stdint.h>

/* Arguments: x, y, z, then the parameters. 0: there is no such function. */
uint32_t internal_arguments(uint32_t number);
/* Noise is not this room's: its functions have the value 0 here. */
double internal_value(uint32_t number, const double *v);

#endif
