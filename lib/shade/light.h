/* light.h - what the lights do to a surface. */
#ifndef SHADE_LIGHT_H
#define SHADE_LIGHT_H

#include "shade/surface.h"

/* Diffuse light and highlights of all lights that the surface sees. */
colour light_gather(pov_tracer *t, const surface *s);

#endif
