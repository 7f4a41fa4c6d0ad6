/* lanes.h - several rays side by side, each at a shape of its own. What is asked of many pairs at once is the same
 * arithmetic as for one, inlined into a plain loop over lanes that the compiler turns into vector code: so it gives the
 * same bits. What a lane cannot decide goes to the function for one pair. */
#ifndef KIT_LANES_H
#define KIT_LANES_H

#include "kit/simd.h"

/* Lanes that hold nothing cost as much as others: fewer pairs than the least are better off alone. */
enum { KIT_LANES = 8, KIT_LEAST = 3 };

typedef double kit_lane[KIT_LANES];
typedef struct kit_lane3 { kit_lane x, y, z; } kit_lane3;
typedef struct kit_rays { kit_lane3 org, org_lo, dir, dir_lo; } kit_rays;

static inline void kit_put(kit_lane3 *l, uint32_t i, pov_vec3 v)
{
    l->x[i] = v.x;
    l->y[i] = v.y;
    l->z[i] = v.z;
}

static inline pov_vec3 kit_get(const kit_lane3 *l, uint32_t i) { return pov_vec3_of(l->x[i], l->y[i], l->z[i]); }

/* Of n pairs, the one that a lane holds: lanes past the end hold the last one again. */
static inline uint32_t kit_lane_of(uint32_t i, uint32_t n) { return i < n ? i : n - 1; }

static inline void kit_put_ray(kit_rays *l, uint32_t i, const pov_ray *ray)
{
    kit_put(&l->org, i, ray->org);
    kit_put(&l->org_lo, i, ray->org_lo);
    kit_put(&l->dir, i, ray->dir);
    kit_put(&l->dir_lo, i, ray->dir_lo);
}

/* The ray of a lane, but for what it left. */
static inline pov_ray kit_get_ray(const kit_rays *l, uint32_t i)
{
    pov_ray ray;

    ray.org = kit_get(&l->org, i);
    ray.org_lo = kit_get(&l->org_lo, i);
    ray.dir = kit_get(&l->dir, i);
    ray.dir_lo = kit_get(&l->dir_lo, i);
    return ray;
}

/* intersect_many() of a class: eight pairs at a time as long as that pays, and what is left one by one. */
KIT_INLINE void kit_intersect_pairs(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                    uint32_t n,
                                    void (*eight)(const void *const *selves, const pov_ray *const *rays,
                                                  pov_hits *const *hits, uint32_t n),
                                    void (*one)(const void *self, const pov_ray *ray, pov_hits *hits))
{
    uint32_t i;

    for (; n >= KIT_LEAST; n -= i, selves += i, rays += i, hits += i) {
        i = n < KIT_LANES ? n : KIT_LANES;
        eight(selves, rays, hits, i);
    }
    for (i = 0; i < n; i++)
        one(selves[i], rays[i], hits[i]);
}

#endif
