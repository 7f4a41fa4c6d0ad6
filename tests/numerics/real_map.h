/* real_map.h - affine maps in 512 bits. */
#ifndef NUMERICS_REAL_MAP_H
#define NUMERICS_REAL_MAP_H

#include "numerics/real.h"

/* A place p goes to m p, with the translation in the last column; `inverse` is that of the other three. */
typedef struct real_map { real m[3][4], inverse[3][3]; } real_map;

void real_map_invert(real_map *f);
real3 real_times(real m[3][3], real3 v);

#endif
