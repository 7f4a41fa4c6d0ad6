/* geometry.h - directions at surfaces, many at once. */
#ifndef SHADE_GEOMETRY_H
#define SHADE_GEOMETRY_H

#include "shade/shade.h"

/* Of no surfaces yet: lanes hold what is computed with like any other. */
void geometry_begin(geometry *g);
/* From t->surfaces to t->geometry; of surfaces that lie on no others the hits are completed first. */
void geometry_find(pov_tracer *t, uint32_t n);

/* The unit vector along one whose squares stay within double's range; it is pov_unit()'s to the bit. 0 and not -1: it
 * is one of the others, and what was put out is worth nothing. (An integer as wide as a double makes the shortest
 * loops.) */
static inline int64_t geometry_unit(double x, double y, double z, pov_vec3 *out)
{
    const double square = x * x + y * y + z * z, length = sqrt(square);

    *out = pov_vec3_of(x / length, y / length, z / length);
    return ((square >= 1e-239) & (square <= 1e239)) ? -1 : 0;
}

#endif
