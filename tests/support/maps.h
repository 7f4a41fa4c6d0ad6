/* maps.h - random transformations for shapes in spaces of their own, and what they are random of. */
#ifndef SUPPORT_MAPS_H
#define SUPPORT_MAPS_H

#include "support/shapes.h"

/* 10 to a power between lo and hi. */
double test_power(test_random *r, double lo, double hi);
/* Of that size but for up to so many powers of ten, of either sign. */
double test_factor(test_random *r, double size, double uneven);
/* Scaled by factors that differ by up to 1e9, mirrored, turned, sometimes squeezed again; tiny or large, near or far. */
const transform *test_random_map(model *m, test_random *r);
/* About zero, or ten times its size away. */
pov_box test_random_cube(test_random *r);

#endif
