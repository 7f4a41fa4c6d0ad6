/* brdf.h - light that surfaces reflect towards the rays' start: diffuse light and highlights, by lane. */
#ifndef SHADE_BRDF_H
#define SHADE_BRDF_H

#include "light/light.h"
#include "shade/surface.h"

/* What only some finishes have. A whole power is repeated as such, up to 63 and APPEARANCE_POWER_LANES, where others have 0. */
typedef struct SIMD_ALIGNED rich_finishes {
    float back_weight[BATCH_MAX];   /* diffuse_weight for light from behind */
    float both_sides[BATCH_MAX];    /* 1: light from behind makes highlights too */
    float phong[BATCH_MAX], specular[BATCH_MAX], metallic[BATCH_MAX], irid[BATCH_MAX], crand[BATCH_MAX];
    double brilliance[BATCH_MAX], phong_size[BATCH_MAX], sharpness[BATCH_MAX], thickness[BATCH_MAX];
    int64_t course[BATCH_MAX];   /* brilliance */
    int64_t whole[BATCH_MAX];    /* sharpness, which is 1 / roughness */
} rich_finishes;

/* Finishes of lit surfaces, by lane, from their appearances. */
typedef struct SIMD_ALIGNED finishes {
    float red[BATCH_MAX], green[BATCH_MAX], blue[BATCH_MAX], diffuse_weight[BATCH_MAX], phong[BATCH_MAX];
    double highlight_cutoff[BATCH_MAX];
    int64_t power[BATCH_MAX];
    int64_t alike;               /* the power of all, where that is below 64; or 0 */
    const surfaces *on;
    uint32_t kinds;              /* FINISH_* that some surface has; rich is filled only if there is any */
    const appearance *held;      /* the first lanes are all of this one; NULL: there is none such */
    uint32_t held_count;
    uint32_t level;
    bool has_phong;              /* some surface's finish has */
    rich_finishes rich;
    uint32_t count;
    uint8_t lit[BATCH_MAX];      /* lanes of lit surfaces */
} finishes;

/* Collect the lit surfaces of a batch; level: of their stacks, the layers of this number. */
void brdf_begin(finishes *f, const model *m, const surfaces *on, uint32_t level);

/* One sample of a light source for each surface, by lane. */
typedef struct light_sample {
    vec_lanes unit;              /* the direction to it */
    double cosine[BATCH_MAX];    /* between that and the shading normal */
    double specular_cos[BATCH_MAX];   /* ... and the mirrored ray */
    float red[BATCH_MAX], green[BATCH_MAX], blue[BATCH_MAX];   /* reflected light if the source is not occluded */
    uint32_t odd[BATCH_MAX];     /* 1: not computed yet */
    uint32_t front[BATCH_MAX], contributes[BATCH_MAX];   /* 1: the light is in front; and the reflected light is not
                                                          * zero */
} light_sample;

/* Can light from behind count? */
static inline bool brdf_has_back(const finishes *f) { return (f->kinds & FINISH_BACK) != 0; }
/* Are there highlights? */
static inline bool brdf_shines(const finishes *f) { return f->has_phong || f->kinds; }
/* Set the cosines of n lanes, of highlights where there are any (shines). True: there may be one too small for world_origin_reflect(). */
bool brdf_cosines(light_sample *s, const geometry *g, const vec_lanes *dir, bool shines, uint32_t n);
/* Reflect the incident light; without highlights if `glossy` is false. */
void brdf_reflect(const finishes *f, const model *m, light_sample *s, const light_lanes *in, bool glossy, uint32_t n);
/* The same where some finish has more than diffuse light and phong. */
void brdf_reflect_rich(const finishes *f, const model *m, light_sample *s, const light_lanes *in, bool glossy, uint32_t n);
/* What films of some finishes make of the light that was reflected. */
void brdf_films(const finishes *f, const model *m, light_sample *s, uint32_t n);

static inline colour brdf_at(const light_sample *s, uint32_t i) { return colour_of(s->red[i], s->green[i], s->blue[i]); }

#endif
