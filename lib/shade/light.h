/* light.h - what the lights do to surfaces. */
#ifndef SHADE_LIGHT_H
#define SHADE_LIGHT_H

#include "shade/shade.h"

/* Diffuse light and highlights of all lights that t->surfaces see, into `lit` of each; t->geometry is known. */
void light_gather(pov_tracer *t, uint32_t n);

#endif
