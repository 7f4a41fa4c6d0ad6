/* exact_torus.h - a torus around the y axis in 512 bits. */
#ifndef NUMERICS_EXACT_TORUS_H
#define NUMERICS_EXACT_TORUS_H

#include "numerics/real.h"

/* Where a line meets it, in growing order; of a spindle the outer sheet alone. Touching it counts twice or
 * not at all. */
int exact_torus_roots(real R, real r, real3 o, real3 d, real t[4]);
/* The normal there, of any length; axis: how far from the axis. */
real3 exact_torus_normal(real R, real3 p, real *axis);

#endif
