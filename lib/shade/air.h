/* air.h - what paths see where they hit nothing, and what fog, rainbows and media do on their way. */
#ifndef SHADE_AIR_H
#define SHADE_AIR_H

#include "shade/context.h"
#include "shade/fog.h"
#include "shade/surface.h"

/* Segments of paths of a batch that follow one another, and what fogs do on them. */
typedef struct air_segments {
    path *paths;
    const pov_ray *const *rays;
    bool camera;                 /* the batch is of camera rays */
    uint32_t first;              /* of the paths */
    vec_lanes dir;               /* directions as the rays have them */
    fog_segments on;             /* while they are added: ray parameters for lengths */
    fog_veils fogs;
} air_segments;

/* Do rays that hit nothing see one colour wherever they go, but for what dims them on their way, and but for pictures with alpha? */
bool air_is_plain(const model *m);
/* That colour. */
colour air_plain_colour(const model *m);
static inline bool air_dims(const model *m) { return m->fogs.count > 0 || m->rainbows.count > 0; }

/* Add what the rays see that hit nothing; bit i: ray i. In pictures with alpha, the rays that were not reflected see
 * through the background as far as the scene says: take that from their alpha. on: measured segments of these rays, endless ones,
 * where the scene dims them. */
void air_background(shade_context *c, batch *b, uint64_t rays, const air_segments *on, colour *out);
/* How many solids that are not hollow a path is in that has crossed the surface. */
uint32_t air_solids_across(const shading *scene, const surface *s);
/* Begin with some of a batch's paths, at least one. The caller sets the lengths, by ray parameters; HUGE_VAL: it is endless. */
void air_begin(air_segments *s, batch *b, uint32_t first, uint32_t count);
/* Complete the segments. */
void air_measure(const shade_context *c, air_segments *s);
/* Add what the air itself gives on these; their paths become those behind it. Bit i of `seen`: what ends segment i is; or it goes on there. */
void air_cross(shade_context *c, air_segments *s, uint64_t which, uint64_t seen, colour *out);

#endif
