/* rays.h - rays as tests write them, from a point in a direction, on no surface; and what is asked of a shape along one. */
#ifndef SUPPORT_RAYS_H
#define SUPPORT_RAYS_H

#include <povtrace/shape.h>

#include <string.h>

static inline pov_ray ray_from(pov_vec3 org, pov_vec3 dir)
{
    pov_ray ray;

    memset(&ray, 0, sizeof ray);
    ray.org = org;
    ray.dir = dir;
    ray.origin_surface = POV_NO_OWNER;
    return ray;
}

/* Room for crossings up to tmax, none of them found yet. */
static inline pov_hits hits_to(double tmax, pov_want want, pov_crossing *at, uint32_t capacity)
{
    pov_hits hits;

    memset(&hits, 0, sizeof hits);
    hits.tmax = tmax;
    hits.want = want;
    hits.at = at;
    hits.capacity = capacity;
    return hits;
}

#endif
