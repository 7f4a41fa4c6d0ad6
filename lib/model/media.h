/* media.h - what fills a solid or the whole scene: matter that absorbs, emits and scatters light on its way. */
#ifndef MODEL_MEDIA_H
#define MODEL_MEDIA_H

#include "model/texture.h"

/* How scattered light depends on the angle. NONE: the medium does not scatter. */
typedef enum scatter_type {
    SCATTER_NONE, SCATTER_ISOTROPIC, SCATTER_HAZE, SCATTER_MURK, SCATTER_RAYLEIGH, SCATTER_HENYEY, SCATTER_TYPES
} scatter_type;

/* Per unit of the world's length, where the density is 1. There is no padding: equal ones have equal bytes. */
typedef struct medium {
    colour absorption, emission, scattering;
    float extinction;            /* part of the scattered light that is lost to the ray */
    scatter_type type;
    float eccentricity;          /* of HENYEY: above 0 more light goes forward */
    uint32_t strata;             /* of samples on a segment, as the scene asks; 0: it does not */
    uint32_t density_count;
    const pigment_node *const *densities;   /* they multiply; their filter and transmit have no meaning */
} medium;

/* All of one interior, or of the atmosphere. */
typedef struct media { uint32_t count; const medium *items; } media;

static inline bool medium_varies(const medium *m)
{
    for (uint32_t i = 0; i < m->density_count; i++)
        if (m->densities[i]->pattern)
            return true;
    return false;
}

/* Does it take light from rays? Media that only shine do not. */
static inline bool medium_dims(const medium *m)
{
    return !colour_is_black(m->absorption) || (m->extinction != 0.0f && !colour_is_black(m->scattering));
}

static inline bool media_dim(const media *m)
{
    for (uint32_t i = 0; m && i < m->count; i++)
        if (medium_dims(&m->items[i]))
            return true;
    return false;
}

static inline bool media_scatter(const media *m)
{
    for (uint32_t i = 0; m && i < m->count; i++)
        if (!colour_is_black(m->items[i].scattering))
            return true;
    return false;
}

#endif
