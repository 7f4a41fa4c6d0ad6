/* haze.h - media along paths and on the way of light. */
#ifndef SHADE_HAZE_H
#define SHADE_HAZE_H

#include "media/march.h"
#include "shade/interior_walk.h"

/* What the media of a path's next segment do: what is behind becomes by x behind + given. Where it does not end at a surface only the
 * atmosphere acts. */
void haze_cross(shade_context *c, const path *p, const media_segment *on, bool ends, colour *by, colour *given);
/* What media leave of light that crosses these surfaces, in the order of their distances: every piece of its way that
 * ends at a surface counts, not the last one. */
void haze_dim(const shading *scene, interior_walk *w, const pov_ray *ray, const pov_crossing *at, uint32_t count, double by[3]);
/* What the atmosphere and fog leave of a light that they dim, for a ray to org + tmax dir that starts where the path was. */
void haze_attenuate(const shade_context *c, const light *from, const path *p, const pov_ray *ray, double tmax, colour *through);

#endif
