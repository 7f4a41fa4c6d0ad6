/* refract.h - Snell's law. */
#ifndef SHADE_REFRACT_H
#define SHADE_REFRACT_H

#include "shade/geometry.h"

/* View is the unit direction of the ray, normal the unit normal facing its start, cosine the one between them (>= 0).
 * False: total internal reflection. */
bool refract(pov_vec3 view, pov_vec3 normal, double cosine, double before, double after, pov_vec3 *out);

/* The same by lane, bit for bit. */
typedef struct refraction_lanes {
    double before[WORLD_MANY], after[WORLD_MANY];   /* also for lanes that complete the last four */
    double squared_cosine[WORLD_MANY];              /* of the transmitted direction; 0 or less: total internal
                                                     * reflection */
    vec_lanes dir;
} refraction_lanes;
void refract_lanes(refraction_lanes *b, const vec_lanes *view, const vec_lanes *normal, const double *cosines,
                   uint32_t n);

#endif
