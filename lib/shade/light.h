/* light.h - what the lights do to surfaces. */
#ifndef SHADE_LIGHT_H
#define SHADE_LIGHT_H

#include "shade/surface.h"

/* Diffuse light and highlights of all lights that the surfaces see, into `lit` of each. */
void light_gather(pov_tracer *t, surface *const *surfaces, uint32_t n);

#endif
