/* rays.h - rays as tests write them: from a point in a direction, on no surface. */
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

#endif
