/* draw.h - numbers and places drawn by chance, and a probe's vectors and ray. */
#ifndef NUMERICS_DRAW_H
#define NUMERICS_DRAW_H

#include "numerics/families.h"

#include <string.h>

#define U families_uniform

static inline double between(double lo, double hi) { return lo + (hi - lo) * U(); }
static inline double log_between(double lo, double hi) { return pow(10.0, between(lo, hi)); }
static inline double either(double x) { return U() < 0.5 ? x : -x; }

static inline pov_vec3 across(pov_vec3 n)
{
    return pov_unit(pov_cross_product(n, families_direction()));
}

static inline void put(probe *p, int at, pov_vec3 v)
{
    p->number[at] = v.x;
    p->number[at + 1] = v.y;
    p->number[at + 2] = v.z;
}

static inline pov_vec3 get(const probe *p, int at)
{
    return pov_vec3_of(p->number[at], p->number[at + 1], p->number[at + 2]);
}

static inline pov_vec3 small_place(double size)
{
    return pov_scale(families_direction(), size * between(0.0, 2.0));
}

static inline void ray_of(probe *p, pov_vec3 org, pov_vec3 dir)
{
    memset(&p->ray, 0, sizeof p->ray);
    p->ray.org = org;
    p->ray.dir = dir;
    p->ray.origin_surface = POV_NO_OWNER;
}

#endif
