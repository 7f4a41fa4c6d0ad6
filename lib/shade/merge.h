/* merge.h - textures of several terms that are as one: their sum is what one plain surface shows. */
#ifndef SHADE_MERGE_H
#define SHADE_MERGE_H

#include "shade/paint.h"

/* Can terms be as one in this scene? Other light than that of the light sources is not linear in the colour, or asks for each
 * layer. */
bool merge_is_possible(const shading *scene);
/* Can terms of this finish? */
bool merge_takes(const appearance *of);

/* Surfaces whose terms all have matt finishes and the surface's own normal are lit once: light is linear in colours.
 * Sets their appearances and marks them in p->merged. It depends on nothing but the surface's own terms. */
void merge_terms(const shading *scene, surfaces *s, painted *p);

/* The same without terms, for surfaces of one texture whose layers can be as one. */
bool merge_takes_layers(const shading *scene, const texture *of);
/* At the points of all surfaces, by lane. */
void merge_layers(const shading *scene, const texture *of, const texture_points *points, surfaces *s);

#endif
