/* reflectance.h - coefficients of reflected and transmitted rays that depend on the ray's direction. */
#ifndef SHADE_REFLECTANCE_H
#define SHADE_REFLECTANCE_H

#include "shade/surface.h"

/* Set the coefficients of all surfaces that have such ones, in appearances of their own. */
void reflectance_set(const shade_context *c, surfaces *s);
/* The same for layers: without what holds for the surface as a whole. Light that fades is left in `faded` only. */
void reflectance_set_layers(const shade_context *c, surfaces *s);
/* By Fresnel's equations for light that is not polarised; ratio: the ior ahead over that behind. */
double reflectance_fresnel(double cosine, double ratio);

#endif
