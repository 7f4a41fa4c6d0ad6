/* lighting.h - direct lighting of surfaces. */
#ifndef SHADE_LIGHTING_H
#define SHADE_LIGHTING_H

#include "shade/brdf.h"

/* The lighting of a batch's surfaces, and its rays to one light. */
typedef struct lighting {
    shade_context *context;
    surfaces *on;
    bool glossy;                 /* with highlights */
    uint32_t count;
    const pov_ray *rays[BATCH_MAX];
    uint8_t of[BATCH_MAX];       /* lanes of their origin surfaces */
    uint8_t seen[BATCH_MAX];     /* the same of all rays, while some of them are traced */
    finishes finishes;
    struct photon_work *photons; /* memory for the light of photons; NULL: there is none */
    pov_ray *own;                /* one ray for each surface, with the direction to the current light: memory of
                                  * BATCH_MAX rays that is unused until all lights are done */
} lighting;

/* The points of its surfaces. */
static inline light_points lighting_points(const lighting *l)
{
    const geometry *g = &l->on->geometry;
    const light_points at = { &g->to.point, &g->to.point_lo, l->on->count };

    return at;
}

/* Add diffuse light and highlights of all visible lights to `lit` of each surface. */
void light_gather(lighting *l, shade_context *c, surfaces *on);

#endif
