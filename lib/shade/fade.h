/* fade.h - light that fades inside solids, and light that solids focus. */
#ifndef SHADE_FADE_H
#define SHADE_FADE_H

#include "shade/context.h"
#include "shade/interior_walk.h"
#include "shade/path.h"

/* What is left of light over a distance. */
colour fade_over(const interior *in, double distance);
/* What is left of light that a surface transmits, or reflects totally, through the solid to the path's start. Other light
 * of the surface does not fade, as POV-Ray has it. */
void fade_inside(const shade_context *c, const path *p, const pov_ray *ray, const hit *h, colour *by);
/* Put crossings in the order of their distances. */
void fade_sort(pov_crossing *at, uint32_t count);
/* What the solids leave of light that crosses these surfaces, besides the surfaces' own filters; `around` are those that
 * hold the ray's start. The crossings are put in the order of their distances. */
void fade_crossings(const shading *scene, const interior_walk *around, const pov_ray *ray, pov_crossing *at, uint32_t count,
                    double by[3]);

#endif
