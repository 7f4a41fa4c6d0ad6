/* air.h - what paths see where they hit nothing, and what fog, rainbows and media do on their way. */
#ifndef SHADE_AIR_H
#define SHADE_AIR_H

#include "shade/context.h"
#include "shade/fog.h"
#include "shade/surface.h"

/* Segments of paths, and what fogs do on them. */
typedef struct air_segments {
    path *path[BATCH_MAX];
    const pov_ray *rays[BATCH_MAX];
    vec_lanes dir;               /* directions as the rays have them */
    fog_segments on;             /* while they are added: ray parameters for lengths */
    fog_veils fogs;
} air_segments;

/* Is there more than a background? */
static inline bool air_is_there(const model *m) { return m->sky || m->fogs.count > 0 || m->rainbows.count > 0; }
static inline bool air_dims(const model *m) { return m->fogs.count > 0 || m->rainbows.count > 0; }

/* Add what the rays see that hit nothing; bit i: ray i. In pictures with alpha, the rays that were not reflected see
 * through the background as far as the scene says: take that from their alpha. */
void air_background(shade_context *c, batch *b, uint64_t rays, colour *out);
/* How many solids that are not hollow a path is in that has crossed the surface. */
uint32_t air_solids_across(const shading *scene, const surface *s);
/* What fog leaves of light that it dims: most lights are not dimmed by it. The direction is a unit vector. */
colour air_fog_dims(const shading *scene, pov_vec3 from, pov_vec3 dir, double length);
/* One more, to ray parameter t; HUGE_VAL: it is endless. */
void air_add(air_segments *s, path *p, const pov_ray *ray, double t);
/* Complete segments, of which there is at least one. */
void air_measure(const shade_context *c, air_segments *s);
/* Add what the air itself gives on them; the paths become those behind it. Bit i of `seen`: what ends segment i is; or it goes on there. */
void air_cross(shade_context *c, const air_segments *s, uint64_t seen, colour *out);

#endif
