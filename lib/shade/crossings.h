/* crossings.h - what surfaces and solids do to light that crosses them, for many rays side by side. */
#ifndef SHADE_CROSSINGS_H
#define SHADE_CROSSINGS_H

#include "query/query.h"
#include "shade/interior_walk.h"

/* What is left of light. The places of filters along its way do not matter to the product. */
typedef struct light_product { double r, g, b; } light_product;

static inline void light_take(light_product *p, colour filter)
{
    p->r *= (double)filter.r;
    p->g *= (double)filter.g;
    p->b *= (double)filter.b;
}

/* Multiply by the filters of all surfaces that these rays (bits) cross, in the order of the objects: the same for the tree and
 * the list. */
void crossings_filter(const shading *scene, const pov_ray *const *rays, const occlusion *found, uint64_t which, light_product *out);
/* Sort what each ray crosses along it, and multiply by how surfaces focus light and how it fades in solids; around: solids where
 * the rays start. */
void crossings_fade(const shading *scene, const interior_walk *around, const pov_ray *const *rays, const occlusion *found, uint64_t which,
                    light_product *out);

#endif
