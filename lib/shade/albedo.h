/* albedo.h - the colours of surfaces themselves, whatever their light. */
#ifndef SHADE_ALBEDO_H
#define SHADE_ALBEDO_H

#include "shade/tracer.h"

/* The pigment's colour at a completed hit; of layers, each as far as those above it let it be seen. */
colour albedo_of(pov_tracer *t, const pov_ray *ray, const hit *h);

#endif
