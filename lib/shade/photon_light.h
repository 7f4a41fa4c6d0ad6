/* photon_light.h - the light of photons at lit surfaces. */
#ifndef SHADE_PHOTON_LIGHT_H
#define SHADE_PHOTON_LIGHT_H

#include "photon/store.h"
#include "shade/brdf.h"

/* Photons at one point of a surface, each in a lane, as if each were a light. */
typedef struct photon_lanes {
    surfaces on;                 /* the surface in all lanes */
    finishes finishes;
    light_lanes in;
    light_sample sample;
    uint32_t count;
    colour sum;
} photon_lanes;

/* One thread's memory for photons. */
typedef struct photon_work {
    photon_seed *seed;           /* held; NULL: not yet */
    uint32_t seed_number;
    const photon_maps *known[PHOTON_MAPS];   /* its maps that were asked for */
    const photon_maps *maps[BATCH_MAX];      /* by lane of the camera ray */
    photon_view views[BATCH_MAX];            /* the same */
    photon_screen screen;                    /* of the camera, if it has one */
    bool on_screen;
    photon_lanes lanes;
} photon_work;

/* Add the light of photons to `lit` of these lit surfaces. */
void photon_light_add(photon_work *w, const shade_context *c, const finishes *lit, surfaces *on);

#endif
