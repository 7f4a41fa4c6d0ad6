#include "kit/ball_block.h"

#include "kit/simd.h"

bool kit_ball_pack(void *block, const void *const *selves, uint32_t n)
{
    kit_ball_block *b = block;
    uint32_t i;

    b->reach = b->most = b->band = 0.0;
    b->lanes = (1 << n) - 1;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const kit_ball *s = selves[i < n ? i : 0];
        pov_vec3 c = pov_two3_hi(s->centre);
        double far = fabs(c.x) + fabs(c.y) + fabs(c.z), lost = KIT_U * (2.0 * s->radius.hi + 2.0 * far);

        if (!kit_block_range(pov_largest(c)) || !kit_block_size(s->radius.hi))
            return false;
        b->x[i] = c.x;
        b->y[i] = c.y;
        b->z[i] = c.z;
        b->outer[i] = s->radius.hi + lost;
        /* The third pays for the roundings of outer, and of what the band is taken off. */
        b->band = fmax(b->band, 3.0 * lost);
        b->square[i] = i < n ? b->outer[i] * b->outer[i] * (1.0 + 12.0 * KIT_U) : -HUGE_VAL;
        b->most = fmax(b->most, b->outer[i]);
        b->reach = fmax(b->reach, far);
    }
    return true;
}

/* A lane that the line of the ray comes near to: where, and whether it is met. */
static inline void bound_lane(const kit_ball_block *s, uint32_t i, double middle, double ww, double slack,
                              double per_length, double tmin, double tmax, pov_block_answer *out)
{
    double outer = s->outer[i] + slack, inner = s->outer[i] - s->band - slack;
    double far = outer * outer * (1.0 + 8.0 * KIT_U) - ww, near = inner * inner * (1.0 - 8.0 * KIT_U) - ww;
    double wide = (sqrt(far) * (1.0 + 8.0 * KIT_U) + slack) * per_length;
    double shift = 8.0 * KIT_U * fabs(middle), narrow;
    int within;

    out->lo[i] = middle - wide - shift;
    if (!(out->lo[i] <= tmax && middle + wide + shift >= tmin))
        return;
    out->maybe |= 1u << i;
    if (!(inner > 0.0 && near > 0.0))
        return;
    narrow = (sqrt(near) * (1.0 - 8.0 * KIT_U) - slack) * per_length;
    if (!(narrow > 0.0))
        return;
    /* Who starts within comes to the far end. */
    within = middle - narrow + shift < tmin;
    out->lo[i] = within ? middle + narrow - shift : out->lo[i];
    out->hi[i] = within ? middle + wide + shift : middle - narrow + shift;
    if (!(out->lo[i] > tmin && out->hi[i] < tmax))
        return;
    out->surely |= 1u << i;
    if (!within && middle + wide + shift < tmax)
        out->twice |= 1u << i;
}

/* All of it in plain double. The point of closest approach is off by less than 16 u times the distance
 * from origin to centre, in each of its uses; radii that much smaller and larger make the answer safe. Most
 * blocks are passed by on every lane: that is found out first, for all lanes at once. */
KIT_CLONES static void filter(const void *block, const pov_ray *ray, double tmin, double tmax,
                                    pov_block_answer *out)
{
    const kit_ball_block *s = block;
    const pov_vec3 o = ray->org, d = ray->dir;
    const double a = pov_dot(d, d), inverse = 1.0 / a;
    const double slack = 18.0 * KIT_U * (fabs(o.x) + fabs(o.y) + fabs(o.z) + s->reach);
    double middle[POV_BLOCK_MAX], ww[POV_BLOCK_MAX], depth[POV_BLOCK_MAX], per_length;
    const int64_t bit[POV_BLOCK_MAX] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    int64_t met = 0;
    uint32_t i;

    if (!(a > 1e-200 && a < 1e200 && slack < 1e100)) {
        kit_block_decline(tmin, out);
        return;
    }
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        double x = o.x - s->x[i], y = o.y - s->y[i], z = o.z - s->z[i], outer = s->outer[i] + slack, wx, wy, wz;
        middle[i] = -(x * d.x + y * d.y + z * d.z) * inverse;
        wx = x + middle[i] * d.x;
        wy = y + middle[i] * d.y;
        wz = z + middle[i] * d.z;
        ww[i] = wx * wx + wy * wy + wz * wz;
        depth[i] = outer * outer * (1.0 + 8.0 * KIT_U) - ww[i];
        met |= depth[i] >= 0.0 ? bit[i] : 0;
    }
    out->maybe = out->surely = out->twice = 0;
    met &= s->lanes;
    if (!met)
        return;
    per_length = sqrt(inverse);
    for (; met; met &= met - 1) {
        i = kit_first_lane((uint32_t)met);
        bound_lane(s, i, middle[i], ww[i], slack, per_length, tmin, tmax, out);
    }
}

/* The lanes whose spheres the line of a ray may come near to, with its closest approach to each. The square of a sum
 * with the slack is at most the square of the one and what the slack adds to the largest. */
static inline uint32_t near_lines(const kit_ball_block *s, const pov_rays *rays, uint32_t at, double slack,
                                  double *restrict middle, double *restrict ww)
{
    const double ox = rays->org[0][at], oy = rays->org[1][at], oz = rays->org[2][at];
    const double dx = rays->dir[0][at], dy = rays->dir[1][at], dz = rays->dir[2][at];
    const double inverse = -rays->inverse[at], more = slack * (2.0 * s->most + slack) * (1.0 + 12.0 * KIT_U);
    const int64_t bit[POV_BLOCK_MAX] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    int64_t met = 0;
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const double x = ox - s->x[i], y = oy - s->y[i], z = oz - s->z[i];
        const double m = kit_sum_of(z, dz, kit_sum_of(y, dy, x * dx)) * inverse;
        const double wx = kit_sum_of(m, dx, x), wy = kit_sum_of(m, dy, y), wz = kit_sum_of(m, dz, z);

        middle[i] = m;
        ww[i] = kit_sum_of(wz, wz, kit_sum_of(wy, wy, wx * wx));
        met |= ww[i] <= s->square[i] + more ? bit[i] : 0;
    }
    return (uint32_t)met;
}

KIT_CLONES static uint64_t filter_many(const void *block, const pov_rays *rays, uint64_t lanes,
                                             pov_block_answer *out)
{
    const kit_ball_block *s = block;
    double middle[POV_BLOCK_MAX], ww[POV_BLOCK_MAX];
    uint64_t met = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t at = kit_first_lane64(lanes);
        const double slack = 18.0 * KIT_U * (rays->size[at] + s->reach);
        uint32_t near = near_lines(s, rays, at, slack, middle, ww);

        if (!near)
            continue;
        out[at].maybe = out[at].surely = out[at].twice = 0;
        for (; near; near &= near - 1) {
            const uint32_t i = kit_first_lane(near);
            bound_lane(s, i, middle[i], ww[i], slack, rays->per_length[at], 0.0, rays->tmax[at], &out[at]);
        }
        if (out[at].maybe)
            met |= (uint64_t)1 << at;
    }
    return met;
}

/* The clones are static, since their names would be seen from outside. */
void kit_ball_filter(const void *block, const pov_ray *ray, double tmin, double tmax, pov_block_answer *out)
{
    filter(block, ray, tmin, tmax, out);
}

uint64_t kit_ball_filter_many(const void *block, const pov_rays *rays, uint64_t lanes, pov_block_answer *out)
{
    return filter_many(block, rays, lanes, out);
}
