/* subsurface.h - light that enters a surface, is scattered below it, and leaves it elsewhere. */
#ifndef SHADE_SUBSURFACE_H
#define SHADE_SUBSURFACE_H

#include "shade/brdf.h"

/* Add the light that leaves these lit surfaces to their `lit`. */
void subsurface_add(shade_context *c, const finishes *lit, surfaces *on);
/* The reduced albedo of a half-space that reflects this much of even light, of what goes in; boundary: (1 + F)/(1 - F) for
 * the diffuse Fresnel reflectance F inside. */
double subsurface_albedo(double reflected, double boundary);
double subsurface_reflected(double albedo, double boundary);

#endif
