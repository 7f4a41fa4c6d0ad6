#include "light/aim.h"
#include "light/edge.h"

/* By the distance q from the axis. */
static double beam(const light *l, double q)
{
    if (!(q < l->falloff))
        return 0.0;
    return light_tighten(1.0 - q / l->falloff, l->tightness) * (q <= l->radius ? 1.0 : 1.0 - light_edge(l->radius, l->falloff, q));
}

static void incident(const light *l, const light_origin *from, const light_points *at, light_lanes *out)
{
    SIMD_ALIGNED double factor[LANES_MAX], distance[LANES_MAX];
    vec_lanes to;

    light_aim(from, at, &to);
    light_aim_parallel(l, from, at, &out->dir, distance);
    out->tmax = 1.0;
    for (uint32_t i = 0; i < lanes_whole(at->n); i++)
        factor[i] = beam(l, light_length(pov_cross_product(lanes_at(&to, i), l->axis)));
    light_dim(l, factor, distance, at->n, out);
}

const light_class light_cylinder = { incident, true };
