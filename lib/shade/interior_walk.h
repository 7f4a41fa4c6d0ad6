/* interior_walk.h - what is around a point that moves along a ray: solids that are not hollow, and media. */
#ifndef SHADE_INTERIOR_WALK_H
#define SHADE_INTERIOR_WALK_H

#include "media/set.h"
#include "shade/context.h"
#include "shade/path.h"

/* Objects with media, by the first leaf of each. More than WALK_MAX around one point are not told apart from those
 * outside. */
enum { WALK_MAX = 32 };
typedef struct interior_walk { uint32_t solids, count, in[WALK_MAX]; } interior_walk;

/* Around the start of a path's ray. */
void walk_begin(const shade_context *c, const path *p, interior_walk *w);
/* Across a surface of the object: its media are left if they are around, and else entered. */
void walk_cross(const shading *scene, interior_walk *w, uint32_t object, bool entering);
/* The objects' media; none inside of a solid that is not hollow. */
void walk_media(const shading *scene, const interior_walk *w, media_set *out);
/* The same of the atmosphere. */
void walk_atmosphere(const shading *scene, uint32_t solids, media_set *out);

#endif
