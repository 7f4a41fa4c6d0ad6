/* The normals of several cylinders or cones side by side. */
#include "common/cone_lanes.h"

/* As common_cone_normal(). good: nonzero where the usual path of that function applies, and pov_unit() does not
 * scale. */
COMMON_INLINE void find_normal(const common_cone *s, const common_rays *restrict rays, uint32_t i, const double *restrict t,
                               const double *restrict t_lo, common_lane3 *restrict out, double *restrict good)
{
    const pov_ray ray = common_get_ray(rays, i);
    const common_ray k = common_enter(&ray, s->anchor, s->scale);
    view v = view_of(s, &k, common_along_dd(&k, pov_two_of(t[i] * k.per_unit, t_lo[i] * k.per_unit)));
    const double step = side_step(s, &v);
    pov_vec3 w;
    double length, largest;

    take_step(s, &v, step);
    w = side_normal(s, &v);
    length = sqrt(pov_dot(w, w));
    largest = pov_largest(w);
    good[i] = is_step(step) & (int)(fabs(v.p.x.hi) + fabs(v.p.y.hi) > 0.0) & (int)(largest > 1e-100) & (int)(largest < 1e100)
                  ? 1.0
                  : 0.0;
    common_put(out, i, pov_vec3_of(w.x / length, w.y / length, w.z / length));
}

COMMON_CLONES static void find_normals(const cone_lanes *restrict l, const double *restrict t, const double *restrict t_lo,
                                       common_lane3 *restrict out, double *restrict good)
{
    for (uint32_t i = 0; i < TOGETHER; i++) {
        const common_cone s = get_shape(l, i);

        find_normal(&s, &l->rays, i, t, t_lo, out, good);
    }
}

COMMON_CLONES static void find_normals_of_one(const common_cone *restrict s, const common_rays *restrict rays, const double *restrict t,
                                          const double *restrict t_lo, common_lane3 *restrict out, double *restrict good)
{
    COMMON_LOOP for (uint32_t i = 0; i < COMMON_LANES; i++)
        find_normal(s, rays, i, t, t_lo, out, good);
}

static void take_normals(const common_lane3 *unit, const double *good, const void *const *selves, const pov_ray *const *rays,
                         const pov_crossing *const *at, pov_vec3 *const *out, const uint8_t *which, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        const uint32_t j = which[i];

        if (good[i] > 0.0)
            *out[j] = common_get(unit, i);
        else
            common_cone_normal(selves[j], rays[j], at[j], out[j]);
    }
}

/* Pairs of `which`, up to TOGETHER of them. */
static void normals_of(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at, pov_vec3 *const *out,
                       const uint8_t *which, uint32_t n)
{
    cone_lanes lanes;
    common_lane3 unit;
    common_lane t, t_lo, good;
    const void *shapes[TOGETHER];
    const pov_ray *some[TOGETHER];
    const pov_crossing *crossings[TOGETHER];

    for (uint32_t i = 0; i < TOGETHER; i++) {
        const uint32_t j = which[common_lane_of(i, n)];

        shapes[i] = selves[j];
        some[i] = rays[j];
        crossings[i] = at[j];
    }
    common_put_four_crossings(t, t_lo, 0, crossings);
    put_pairs(&lanes, shapes, some);
    find_normals(&lanes, t, t_lo, &unit, good);
    take_normals(&unit, good, selves, rays, at, out, which, n);
}

/* The same of one shape, up to COMMON_LANES of them. */
static void normals_of_one(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at, pov_vec3 *const *out,
                           const uint8_t *which, uint32_t n)
{
    common_rays lanes;
    common_lane3 unit;
    common_lane t, t_lo, good;
    const pov_ray *some[COMMON_LANES];
    const pov_crossing *crossings[COMMON_LANES];

    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        some[i] = rays[which[common_lane_of(i, n)]];
        crossings[i] = at[which[common_lane_of(i, n)]];
    }
    for (uint32_t i = 0; i < COMMON_LANES; i += 4) {
        common_put_four_crossings(t, t_lo, i, crossings + i);
        common_put_four_rays(&lanes, i, some + i);
    }
    find_normals_of_one(selves[which[0]], &lanes, t, t_lo, &unit, good);
    take_normals(&unit, good, selves, rays, at, out, which, n);
}

/* Pairs whose crossings are on sides, as bits; the others are done. */
static uint64_t sides_of(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at, pov_vec3 *const *out, uint32_t n)
{
    uint64_t sides = 0;

    for (uint32_t i = 0; i < n; i++)
        if (at[i]->mark.feature < CAP_BASE)
            sides |= (uint64_t)1 << i;
        else
            common_cone_normal(selves[i], rays[i], at[i], out[i]);
    return sides;
}

void common_cone_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                             pov_vec3 *const *out, uint32_t n)
{
    enum { MOST = 64 };
    const uint32_t some = n < MOST ? n : MOST;
    uint64_t left = sides_of(selves, rays, at, out, some);
    uint8_t same[COMMON_LANES], others[TOGETHER];
    uint32_t count = 0;

    while (left) {
        const uint32_t taken = common_take_same(selves, &left, same);

        if (taken > 1)
            normals_of_one(selves, rays, at, out, same, taken);
        else
            others[count++] = same[0];
        if (count == TOGETHER || (count > 0 && !left)) {
            normals_of(selves, rays, at, out, others, count);
            count = 0;
        }
    }
    if (n > some)
        common_cone_normal_many(selves + some, rays + some, at + some, out + some, n - some);
}
