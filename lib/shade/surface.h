/* surface.h - a ray that meets a surface: what its material makes of it, and the rays that go on from there. */
#ifndef SHADE_SURFACE_H
#define SHADE_SURFACE_H

#include "shade/shade.h"

/* Can anything but its own glow come from what was met? It begins with s->at set. */
bool surface_meet(pov_tracer *t, surface *s);
/* The rays that go on from t->surfaces, whose geometry is known: into t->mirrored and t->passed, which are empty. */
void surface_branch(pov_tracer *t, uint32_t n);

#endif
