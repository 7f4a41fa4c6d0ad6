#include "light/aim.h"
#include "light/edge.h"

#include "base/simd.h"

/* By the cosine c between the axis and the direction away from the light: c^tightness within the radius, from there down
 * to nothing at the falloff. */
static double cone(const light *l, double c)
{
    if (!(c > 0.0))
        return 0.0;
    return light_tighten(c, l->tightness) * (c >= l->radius ? 1.0 : light_edge(l->falloff, l->radius, c));
}

/* Cosines between directions and the axis, bit for bit as with pov_unit(). False: some is out of range. */
SIMD_CLONES static bool find_cosines(const vec_lanes *restrict dir, pov_vec3 axis, uint32_t n, double *restrict out)
{
    int64_t whole = -1;

    for (uint32_t i = 0; i < n; i++) {
        const double x = dir->x[i], y = dir->y[i], z = dir->z[i], square = x * x + y * y + z * z, length = sqrt(square);

        out[i] = -(x / length * axis.x + y / length * axis.y + z / length * axis.z);
        whole &= (square >= 1e-239) & (square <= 1e239) ? -1 : 0;
    }
    return whole;
}

static void incident(const light *l, const light_origin *from, const light_points *at, light_lanes *out)
{
    SIMD_ALIGNED double factor[LANES_MAX], distance[LANES_MAX], cosine[LANES_MAX];
    const uint32_t n = lanes_whole(at->n);

    light_aim(from, at, &out->dir);
    out->tmax = 1.0;
    if (!find_cosines(&out->dir, l->axis, n, cosine))
        for (uint32_t i = 0; i < n; i++)
            cosine[i] = -pov_dot(pov_unit(lanes_at(&out->dir, i)), l->axis);
    for (uint32_t i = 0; i < n; i++)
        factor[i] = cone(l, cosine[i]);
    for (uint32_t i = 0; light_fades(l) && i < n; i++)
        distance[i] = light_length(lanes_at(&out->dir, i));
    light_dim(l, factor, distance, at->n, out);
}

const light_class light_spot = { incident, false };
