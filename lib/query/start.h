/* start.h - rays that start exactly on surfaces that they do not name, as cameras do: what lies at the start is not ahead. */
#ifndef QUERY_START_H
#define QUERY_START_H

#include "query/context.h"

/* Can the nearest crossing of a ray lie at its start? Quick, and true for whatever start_leave() has to look at. */
static inline bool start_may_be_here(const world *w, const pov_ray *ray, double t)
{
    return ray->origin_surface == POV_NO_OWNER && t * pov_largest(ray->dir) < 0x1p-30 * (w->extent + pov_largest(ray->org));
}

/* Is the hit at the start? Then it and all others there are left out: `from` names them, the hit becomes the next one.
 * False: no hit is left. */
bool start_leave(const world *w, query_context *k, const pov_ray *ray, double tmax, coincident_set *from, hit *h);
/* Names what lies at the start of a ray; from->count is 0 where nothing does. False: double-double finds no crossing on the
 * ray. */
bool start_find(const world *w, query_context *k, const pov_ray *ray, double tmax, coincident_set *from);

#endif
