/* lighting.h - what the lights do to surfaces. */
#ifndef SHADE_LIGHTING_H
#define SHADE_LIGHTING_H

#include "shade/surface.h"

/* How lit surfaces answer light, by lane: what their appearances say. */
typedef struct SIMD_ALIGNED finishes {
    float red[BATCH_MAX], green[BATCH_MAX], blue[BATCH_MAX], diffuse_weight[BATCH_MAX], phong[BATCH_MAX];
    double highlight_cutoff[BATCH_MAX];
    int64_t power[BATCH_MAX];
} finishes;

/* The lighting of a batch's surfaces, and its rays to one light. */
typedef struct lighting {
    shade_context *context;
    surfaces *on;
    uint32_t count;
    const pov_ray *rays[BATCH_MAX];
    uint8_t of[BATCH_MAX];       /* lanes of the surfaces that they start on */
    uint32_t lit_count;
    uint8_t lit[BATCH_MAX];      /* lanes of the surfaces that lights change */
    finishes finishes;
    pov_ray *own;                /* each surface's, whose direction is the current light's: memory of BATCH_MAX rays that
                                  * nobody else needs until all lights are done */
} lighting;

/* Diffuse light and highlights of all lights that the surfaces see, into `lit` of each. */
void light_gather(lighting *l, shade_context *c, surfaces *on);

#endif
