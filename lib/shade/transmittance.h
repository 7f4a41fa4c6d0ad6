/* transmittance.h - transmittance between surfaces and lights. */
#ifndef SHADE_TRANSMITTANCE_H
#define SHADE_TRANSMITTANCE_H

#include "shade/context.h"

/* Transmittance of the open segments org .. org + tmax dir: white if they are free, else the product of the filters of
 * transparent surfaces. Bit i: ray i's is not zero, and is in through. n: at most WORLD_MANY. */
uint64_t transmittance_find(const shade_context *c, const pov_ray *const *rays, uint32_t n, double tmax,
                            colour *through);
/* The same of a ray that starts on coincident surfaces. */
bool transmittance_from(const shade_context *c, const coincident_set *from, const pov_ray *ray, double tmax,
                        colour *through);

#endif
