#include "light/aim.h"
#include "light/edge.h"

#include "base/simd.h"

/* By the cosine c between the axis and the direction away from the light: 1 within the radius, from there down to nothing
 * at the falloff. */
SIMD_CLONES static void find_shares(double falloff, double radius, uint32_t n, const double *restrict c, double *restrict share)
{
    for (uint32_t i = 0; i < n; i++) {
        const double edge = light_edge(falloff, radius, c[i]), within = c[i] >= radius ? 1.0 : edge;

        share[i] = c[i] > 0.0 ? within : 0.0;
    }
}

/* ... times c^tightness. In loops of their own: compilers that know the bounds of the base do not vectorise it. */
SIMD_CLONES static void raise(double tightness, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = elementary_pow(value[i], tightness);
}

static void tighten(double tightness, uint32_t n, double *c, double *share)
{
    for (uint32_t i = 0; i < n; i++)
        c[i] = c[i] > 0.0 ? c[i] : 1.0;
    raise(tightness, n, c);
    for (uint32_t i = 0; i < n; i++)
        share[i] *= c[i];
}

/* Cosines between directions and the axis, bit for bit as with pov_unit(). False: some is out of range. */
SIMD_CLONES static bool find_cosines(const vec_lanes *restrict dir, pov_vec3 axis, uint32_t n, double *restrict out)
{
    int64_t whole = -1;

    for (uint32_t i = 0; i < n; i++) {
        const double x = dir->x[i], y = dir->y[i], z = dir->z[i], square = x * x + y * y + z * z, length = sqrt(square);

        out[i] = -(x / length * axis.x + y / length * axis.y + z / length * axis.z);
        whole &= ((square >= 1e-239) & (square <= 1e239)) ? -1 : 0;
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
    find_shares(l->falloff, l->radius, n, cosine, factor);
    if (l->tightness != 0.0)
        tighten(l->tightness, n, cosine, factor);
    if (light_fades(l))
        light_lengths(&out->dir, n, distance);
    light_dim(l, factor, distance, at->n, out);
}

const light_class light_spot = { incident, false };
