/* interior_walk.h - what is around a point that moves along a ray: solids that are not hollow, those with media, and those
 * in which light fades. */
#ifndef SHADE_INTERIOR_WALK_H
#define SHADE_INTERIOR_WALK_H

#include "media/set.h"
#include "shade/context.h"
#include "shade/path.h"

/* Objects with media or in which light fades, by the first leaf of each. More than WALK_MAX around one point are not told apart from those
 * outside. */
enum { WALK_MAX = 32 };
typedef struct interior_walk { uint32_t solids, count, in[WALK_MAX]; } interior_walk;

/* Around the start of a path's ray. */
void walk_begin(const shade_context *c, const path *p, interior_walk *w);
/* Across a surface of the object: it is left if it is around, and else entered, whichever way the surface faces. */
void walk_cross(const shading *scene, interior_walk *w, uint32_t object, bool entering);
/* Is it around? */
bool walk_holds(const interior_walk *w, uint32_t solid);
/* The objects' media; none inside of a solid that is not hollow. */
void walk_media(const shading *scene, const interior_walk *w, media_set *out);
/* The same of the atmosphere. */
void walk_atmosphere(const shading *scene, uint32_t solids, media_set *out);

#endif
