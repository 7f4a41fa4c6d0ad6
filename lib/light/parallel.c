#include "light/aim.h"

static void incident(const light *l, const light_origin *from, const light_points *at, light_lanes *out)
{
    SIMD_ALIGNED double factor[LANES_MAX], distance[LANES_MAX];

    light_aim_parallel(l, from, at, &out->dir, distance);
    out->tmax = 1.0;
    for (uint32_t i = 0; i < lanes_whole(at->n); i++)
        factor[i] = distance[i] > 0.0 || !(l->flags & LIGHT_AHEAD) ? 1.0 : 0.0;
    light_dim(l, factor, distance, at->n, out);
}

const light_class light_parallel = { incident, true };
