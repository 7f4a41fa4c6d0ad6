/* subsurface.h - light that enters a surface, is scattered below it, and leaves it elsewhere. */
#ifndef SHADE_SUBSURFACE_H
#define SHADE_SUBSURFACE_H

#include "shade/brdf.h"

/* Add the light that leaves these lit surfaces to their `lit`. */
void subsurface_add(shade_context *c, const finishes *lit, surfaces *on);
/* What is left of a ray that enters there, after this way without being scattered; and the ior below the surface. */
colour subsurface_unscattered(const shading *scene, const surface *s, double length);
double subsurface_ior(const shading *scene, const surface *s);
/* The reduced albedo of a half-space that reflects this much of even light, of what goes in; and the reverse. */
double subsurface_albedo(double reflected);
double subsurface_reflected(double albedo);

#endif
