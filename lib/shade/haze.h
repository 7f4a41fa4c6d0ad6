/* haze.h - media along paths and on segments of light. */
#ifndef SHADE_HAZE_H
#define SHADE_HAZE_H

#include "media/march.h"
#include "shade/crossings.h"

/* What the media of a path's next segment do: what is behind becomes by x behind + given. Where it does not end at a surface only the
 * atmosphere acts. */
void haze_cross(shade_context *c, const path *p, const media_segment *on, bool ends, colour *by, colour *given);
/* What media leave of light that crosses the surfaces that these rays (bits) do, in the order of their distances: every piece of its way
 * that ends at a surface counts, not the last one. */
void haze_dim(const shading *scene, interior_walk *around, const pov_ray *const *rays, const occlusion *found, uint64_t which, light_product *by);
/* Segments of light, up to BATCH_MAX: rays to org + tmax dir, each of which starts where its path was. */
typedef struct light_segments { const pov_ray *const *rays; const path *const *from; uint32_t count; double tmax; } light_segments;

/* What the atmosphere and fog leave of a light that they dim, on those of its segments that are lit. */
void haze_attenuate(const shade_context *c, const light *from, const light_segments *on, uint64_t lit, colour *through);

#endif
