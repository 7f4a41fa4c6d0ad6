/* fade.h - light that fades inside solids. */
#ifndef SHADE_FADE_H
#define SHADE_FADE_H

#include "shade/context.h"
#include "shade/path.h"

/* What is left of light over a distance. */
colour fade_over(const interior *in, double distance);
/* The same; power: the fade_power-th one of the distance, in units of fade_distance. */
colour fade_by(const interior *in, double distance, double power);
/* What is left of light that a surface transmits, or reflects totally, through the solid to the path's start. Other light
 * of the surface does not fade, as POV-Ray has it. */
void fade_inside(const shade_context *c, const path *p, const pov_ray *ray, const hit *h, colour *by);
/* Put crossings in the order of their distances. */
void fade_sort(pov_crossing *at, uint32_t count);

#endif
