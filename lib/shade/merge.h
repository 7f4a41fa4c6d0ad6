/* merge.h - textures of several terms that are as one: their sum is what one plain surface shows. */
#ifndef SHADE_MERGE_H
#define SHADE_MERGE_H

#include "shade/paint.h"

/* Surfaces whose terms all have matt finishes and the surface's own normal are lit once: light is linear in colours.
 * Sets their appearances and marks them in p->merged. It depends on nothing but the surface's own terms. */
void merge_terms(const shading *scene, surfaces *s, painted *p);

#endif
