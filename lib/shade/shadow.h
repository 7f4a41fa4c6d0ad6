/* shadow.h - rays from lit surfaces to one point of a light. */
#ifndef SHADE_SHADOW_H
#define SHADE_SHADOW_H

#include "shade/lighting.h"
#include "shade/transmittance.h"

/* The rays to one point of a light source that are not occluded. */
uint64_t shadow_trace(lighting *l, const light *from, segment_end end, colour *through);
/* Is all of the light left where a ray is not occluded? */
bool shadow_is_white(const lighting *l, const scene_light *from);
/* Can the rays to such a light be asked for by lane, so that records of them are made only where something needs them? */
bool shadow_is_by_lane(const lighting *l, const scene_light *from);
/* filtered: some of the light is, and `through` says how much of each ray's is left. */
uint64_t shadow_trace_lanes(lighting *l, segment_end end, colour *through, bool *filtered);
/* Of the rays to one point of a light those that cross what it is projected through: all that hides a light without shadows.
 * `rays` is not kept. */
void shadow_keep_crossing(lighting *l, const light *from, double tmax);
/* Set the origin surfaces of the rays, at these cosines. NULL: none is so small that it matters. */
void shadow_name_origins(lighting *l, const double *cosines);
/* Where the shading normal does not tell the side of a ray, the geometric one does: find the sides that these directions go to, and
 * name them for the rays. */
void shadow_find_sides(lighting *l, const vec_lanes *dir);
void shadow_put_sides(lighting *l);
/* The same of rays from these lanes, which are in `own`. */
void shadow_name_sides(lighting *l, const uint8_t *lanes, uint32_t count, const vec_lanes *dir);
/* The same of rays that stand in the order of l->of, several from one lane perhaps, with their directions. */
void shadow_name_rays(lighting *l, const vec_lanes *dir);

/* Where rays to a light end that comes from this point, or from these by ray. */
static inline segment_end shadow_end(const scene_light *from, const light_lanes *in, const light_origin *origin, bool by_ray)
{
    const segment_end end = { in->tmax, from->class->parallel ? NULL : origin, by_ray };

    return end;
}

#endif
