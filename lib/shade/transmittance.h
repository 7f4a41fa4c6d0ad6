/* transmittance.h - transmittance between surfaces and lights. */
#ifndef SHADE_TRANSMITTANCE_H
#define SHADE_TRANSMITTANCE_H

#include "shade/context.h"

/* Segments end at org + tmax dir. Where all end at one point, which directions are rounded to, `at` is that point, and
 * decides for surfaces that lie there; else NULL. */
typedef struct segment_end { double tmax; const light_origin *at; } segment_end;

/* Transmittance of open segments: white if they are free, else the product of the filters of transparent surfaces. Bit i:
 * ray i's is not zero, and is in through. n: at most WORLD_MANY. */
uint64_t transmittance_find(const shade_context *c, const pov_ray *const *rays, uint32_t n, segment_end end,
                            colour *through);
/* The same of a ray that starts on coincident surfaces. */
bool transmittance_from(const shade_context *c, const coincident_set *from, const pov_ray *ray, segment_end end,
                        colour *through);

#endif
