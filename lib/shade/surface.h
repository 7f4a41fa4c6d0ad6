/* surface.h - a ray that meets a surface: what it gives of itself, and the rays that go on from there. */
#ifndef SHADE_SURFACE_H
#define SHADE_SURFACE_H

#include "shade/shade.h"

/* Seen from the path's start: what the surface sends along the ray by itself, and, where anything more can come of it,
 * all that lights and further rays ask of it. False: nothing more. s->from and s->at are set. */
bool surface_meet(pov_tracer *t, surface *s);
/* Do lights change anything about it? */
bool surface_answers_light(const pov_tracer *t, const surface *s);
/* The rays that go on: into t->mirrored and t->passed. */
void surface_branch(pov_tracer *t, const surface *s);

#endif
