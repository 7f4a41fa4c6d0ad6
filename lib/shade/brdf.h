/* brdf.h - light that surfaces reflect towards the rays' start: diffuse light and highlights, by lane. */
#ifndef SHADE_BRDF_H
#define SHADE_BRDF_H

#include "light/light.h"
#include "shade/surface.h"

/* Finishes of lit surfaces, by lane, from their appearances. */
typedef struct SIMD_ALIGNED finishes {
    float red[BATCH_MAX], green[BATCH_MAX], blue[BATCH_MAX], diffuse_weight[BATCH_MAX], phong[BATCH_MAX];
    double highlight_cutoff[BATCH_MAX];
    int64_t power[BATCH_MAX];
    const surfaces *on;
    uint32_t count;
    uint8_t lit[BATCH_MAX];      /* lanes of lit surfaces */
} finishes;

/* Collect the lit surfaces of a batch. */
void brdf_begin(finishes *f, const surfaces *on);

/* One sample of a light source for each surface, by lane. */
typedef struct light_sample {
    double cosine[BATCH_MAX];    /* between the direction to it and the shading normal */
    double specular_cos[BATCH_MAX];   /* ... and the mirrored ray */
    float red[BATCH_MAX], green[BATCH_MAX], blue[BATCH_MAX];   /* reflected light if the source is not occluded */
    uint32_t odd[BATCH_MAX];     /* 1: not computed yet */
    uint32_t front[BATCH_MAX], contributes[BATCH_MAX];   /* 1: the light is in front; and the reflected light is not
                                                          * zero */
} light_sample;

/* Set the cosines of n lanes. True: there may be one too small for world_origin_reflect(). */
bool brdf_cosines(light_sample *s, const geometry *g, const vec_lanes *dir, uint32_t n);
/* Reflect the incident light. */
void brdf_reflect(const finishes *f, const model *m, light_sample *s, const light_lanes *in, uint32_t n);

static inline colour brdf_at(const light_sample *s, uint32_t i) { return colour_of(s->red[i], s->green[i], s->blue[i]); }

#endif
