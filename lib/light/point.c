#include "light/aim.h"

static void incident(const light *l, const light_origin *from, const light_points *at, light_lanes *out)
{
    light_aim(from, at, &out->dir);
    out->tmax = 1.0;
    out->uniform = true;
    out->color = l->color;
}

const light_class light_point = { incident, false };

/* The same, darker with the distance. */
static void incident_fading(const light *l, const light_origin *from, const light_points *at, light_lanes *out)
{
    SIMD_ALIGNED double factor[LANES_MAX], distance[LANES_MAX];

    light_aim(from, at, &out->dir);
    out->tmax = 1.0;
    for (uint32_t i = 0; i < lanes_whole(at->n); i++)
        factor[i] = 1.0;
    light_lengths(&out->dir, at->n, distance);
    light_dim(l, factor, distance, at->n, out);
}

const light_class light_fading = { incident_fading, false };
