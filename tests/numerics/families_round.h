/* families_round.h - tori, planes and discs: the shapes, points on them, and families of their own. */
#ifndef NUMERICS_FAMILIES_ROUND_H
#define NUMERICS_FAMILIES_ROUND_H

#include "numerics/families.h"

/* A shape of that size about a place, but for a torus, which has none. */
void round_make(probe *p, double size, pov_vec3 place);
/* A point on it, and the normal there, in double. */
void round_point(const probe *p, pov_vec3 place, pov_vec3 *at, pov_vec3 *normal);

void round_tubes(probe *p, double parameter);
void round_tangents(probe *p, double parameter);
void round_axes(probe *p, double parameter);
void round_rims(probe *p, double parameter);

#endif
