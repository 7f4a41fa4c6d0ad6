/* transmittance.h - transmittance between surfaces and lights. */
#ifndef SHADE_TRANSMITTANCE_H
#define SHADE_TRANSMITTANCE_H

#include "shade/context.h"
#include "shade/path.h"

/* Segments end at org + tmax dir. Where all end at one point, or ray i at the i-th (by_ray), which directions are rounded
 * to, `at` is that, and decides for surfaces that lie there; else NULL. */
typedef struct segment_end { double tmax; const light_origin *at; bool by_ray; } segment_end;

static inline segment_end segment_end_of(segment_end ends, uint32_t i)
{
    const segment_end end = { ends.tmax, ends.at && ends.by_ray ? ends.at + i : ends.at, false };

    return end;
}

/* Transmittance of open segments: white if they are free, else the product of the filters of transparent surfaces. Bit i:
 * ray i's is not zero, and is in through. n: at most WORLD_MANY. `from` are paths that were where the rays start: the
 * media around them are there too. It is used in scenes with media only, and may be NULL in others. */
uint64_t transmittance_find(const shade_context *c, const pov_ray *const *rays, const path *const *from, uint32_t n,
                            segment_end end, colour *through);
/* The same of rays by lane. filtered: `through` is written, as some light is filtered; else all of it is left where something is. */
uint64_t transmittance_find_lanes(const shade_context *c, const lane_rays *rays, const path *const *from, uint32_t n, segment_end end,
                                  colour *through, bool *filtered);
/* The same of a ray that starts on coincident surfaces. */
bool transmittance_from(const shade_context *c, const coincident_set *on, const pov_ray *ray, const path *from,
                        segment_end end, colour *through);
/* Shorten the ray to where it first crosses what the light is projected through. False: it does not. */
bool transmittance_shorten(const shade_context *c, const light *from, double tmax, pov_ray *ray);

#endif
