/* surface.h - the rays that go on from surfaces. */
#ifndef SHADE_SURFACE_H
#define SHADE_SURFACE_H

#include "shade/shade.h"

/* The rays that go on from t->surfaces, whose geometry is known: into t->mirrored and t->passed, which are empty. */
void surface_branch(pov_tracer *t, uint32_t n);

#endif
