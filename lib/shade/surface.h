/* surface.h - the surfaces that a batch's rays hit. */
#ifndef SHADE_SURFACE_H
#define SHADE_SURFACE_H

#include "shade/context.h"
#include "shade/geometry.h"
#include "shade/path.h"

/* A hit, seen from the ray's start. */
typedef struct surface {
    const path *from;
    const pov_ray *ray;          /* the path's */
    hit *at;
    const appearance *appearance;
    uint32_t coincident, above, on;   /* it coincides with others: as in a path; which of them it is */
    colour lit;                  /* what it sends along the ray of what the lights send it */
} surface;

typedef struct surfaces {
    SIMD_ALIGNED hit hits[BATCH_MAX];   /* by ray of the batch */
    uint32_t count;
    surface at[BATCH_MAX];
    const pov_ray *rays[BATCH_MAX];   /* theirs, in their order, and what these hit */
    hit *found[BATCH_MAX];
    geometry geometry;           /* theirs, in their order */
    appearance varying[BATCH_MAX];   /* of surfaces whose texture varies */
} surfaces;

/* The surfaces that the batch's rays hit and of which more is seen than their emission. That, and the background where
 * rays hit nothing, is added to out. */
void surfaces_find(shade_context *c, surfaces *s, const batch *b, colour *out);
/* Points, normals and directions there, and what the surfaces look like where that varies. */
void surfaces_complete(shade_context *c, surfaces *s);

#endif
