/* air.h - what rays see where they hit nothing, and on their way. */
#ifndef MODEL_AIR_H
#define MODEL_AIR_H

#include "model/texture.h"

/* Pigments over the background, by direction; the last one on top. */
typedef struct sky_sphere { uint32_t count; const pigment_node *const *layers; colour emission; } sky_sphere;

typedef struct fog {
    pigment pigment;
    double distance;             /* above 0 */
    bool layered;                /* type 2: thinner upwards from the offset on; by half at `alt` above it */
    pov_vec3 up;                 /* unit */
    double offset, alt;
    turbulence turbulence;
    double depth;                /* of the turbulence */
} fog;

typedef struct rainbow {
    pov_vec3 direction, up;      /* unit */
    double angle, width;         /* degrees */
    double least_cosine, most_cosine;   /* of all rays that meet the bow, and a few more: to its direction */
    double distance;
    double arc, falloff;         /* degrees from side to side, and in full colour */
    uint32_t count;              /* of the map's colours */
    const float *values;
    const pigment *colours;
} rainbow;

#endif
