/* transmittance.h - what is left of light on its way from a surface to a light. */
#ifndef SHADE_TRANSMITTANCE_H
#define SHADE_TRANSMITTANCE_H

#include "shade/context.h"

/* On the open segments org .. org + tmax dir: white where nothing stands, else the product
 * of what transparent surfaces let through. Bit i: something is left for ray i, and is in through. n: at most WORLD_MANY. */
uint64_t transmittance_find(const shade_context *c, const pov_ray *const *rays, uint32_t n, double tmax,
                            colour *through);
/* The same of a ray that starts on coincident surfaces. */
bool transmittance_from(const shade_context *c, const coincident_set *from, const pov_ray *ray, double tmax,
                        colour *through);

#endif
