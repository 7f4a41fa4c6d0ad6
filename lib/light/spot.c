#include "light/aim.h"
#include "light/edge.h"

/* By the cosine c between the axis and the direction away from the light: c^tightness within the radius, from there down
 * to nothing at the falloff. */
static double cone(const light *l, double c)
{
    if (!(c > 0.0))
        return 0.0;
    return light_tighten(c, l->tightness) * (c >= l->radius ? 1.0 : light_edge(l->falloff, l->radius, c));
}

static void incident(const light *l, const light_origin *from, const light_points *at, light_lanes *out)
{
    SIMD_ALIGNED double factor[LANES_MAX], distance[LANES_MAX];

    light_aim(from, at, &out->dir);
    out->tmax = 1.0;
    for (uint32_t i = 0; i < lanes_whole(at->n); i++) {
        const pov_vec3 dir = lanes_at(&out->dir, i);

        distance[i] = light_length(dir);
        factor[i] = cone(l, -pov_dot(pov_unit(dir), l->axis));
    }
    light_dim(l, factor, distance, at->n, out);
}

const light_class light_spot = { incident, false };
