/* guide.h - directions in which much light is likely: those of lamps, which are surfaces that emit much of it. */
#ifndef SHADE_GUIDE_H
#define SHADE_GUIDE_H

#include "base/sequence.h"
#include "world/world.h"

/* Draw a unit direction about the normal at a point: half of them by the cosine, half towards the boxes of lamps that are above
 * the surface, as far as there are some. by: what the ray counts, so that all together are spread by the cosine. False: the
 * direction is below the surface, where nothing counts. */
bool guide_draw(const world_lamps *lamps, pov_vec3 point, pov_vec3 normal, sequence_point p, pov_vec3 *dir, float *by);

#endif
