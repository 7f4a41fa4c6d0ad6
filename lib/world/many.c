#include "world/parts.h"

uint64_t world_nearest_many(const world *w, walker *k, const pov_ray *const *rays, uint32_t n, double tmax, hit *out)
{
    uint64_t met = 0;
    uint32_t i;

    for (i = 0; i < n; i++)
        met |= (uint64_t)world_nearest(w, k, rays[i], tmax, &out[i]) << i;
    return met;
}

uint64_t world_light_path_many(const world *w, walker *k, const pov_ray *const *rays, uint32_t n, double tmax,
                               colour *through)
{
    uint64_t lit = 0;
    uint32_t i;

    for (i = 0; i < n; i++)
        lit |= (uint64_t)world_light_path(w, k, rays[i], tmax, &through[i]) << i;
    return lit;
}
