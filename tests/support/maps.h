/* maps.h - random transformations for shapes in spaces of their own, and their random numbers. */
#ifndef SUPPORT_MAPS_H
#define SUPPORT_MAPS_H

#include "support/shapes.h"

/* 10 to a power between lo and hi. */
double test_power(test_random *r, double lo, double hi);
/* A number of that size times up to so many powers of ten, of either sign. */
double test_factor(test_random *r, double size, double uneven);
/* A map scaled by factors that differ by up to 1e9, mirrored, turned, sometimes squeezed again; tiny or large, near or
 * far. */
const transform *test_random_map(model *m, test_random *r);
/* A shape near zero, or ten times its size away. */
pov_box test_random_cube(test_random *r);

#endif
