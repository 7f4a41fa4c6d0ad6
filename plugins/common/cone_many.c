/* The normals of several cylinders or cones side by side. */
#include "common/cone_lanes.h"

/* As common_cone_normal(). good: nonzero where the usual path of that function applies, and pov_unit() does not
 * scale. */
COMMON_CLONES static void find_normals(const cone_lanes *restrict l, const double *restrict t,
                                       const double *restrict t_lo, common_lane3 *restrict out, double *restrict good)
{
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const pov_ray ray = common_get_ray(&l->rays, i);
        const common_cone s = get_shape(l, i);
        const common_ray k = common_enter(&ray, s.anchor, s.scale);
        view v = view_of(&s, &k, common_along_dd(&k, pov_two_of(t[i] * k.per_unit, t_lo[i] * k.per_unit)));
        const double step = side_step(&s, &v);
        pov_vec3 w;
        double length, largest;

        take_step(&s, &v, step);
        w = side_normal(&s, &v);
        length = sqrt(pov_dot(w, w));
        largest = pov_largest(w);
        good[i] = is_step(step) & (int)(fabs(v.p.x.hi) + fabs(v.p.y.hi) > 0.0) & (int)(largest > 1e-100) &
                          (int)(largest < 1e100)
                      ? 1.0
                      : 0.0;
        common_put(out, i, pov_vec3_of(w.x / length, w.y / length, w.z / length));
    }
}

/* Lanes of `which` hold sides. */
static void normals_of(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                       pov_vec3 *const *out, const uint32_t *which, uint32_t n)
{
    cone_lanes lanes;
    common_lane3 unit;
    common_lane t, t_lo, good;
    const void *shapes[TOGETHER];
    const pov_ray *some[TOGETHER];
    const pov_crossing *crossings[TOGETHER];
    uint32_t i, j;

    for (i = 0; i < TOGETHER; i++) {
        j = which[common_lane_of(i, n)];
        shapes[i] = selves[j];
        some[i] = rays[j];
        crossings[i] = at[j];
    }
    common_put_four_crossings(t, t_lo, 0, crossings);
    put_pairs(&lanes, shapes, some);
    find_normals(&lanes, t, t_lo, &unit, good);
    for (i = 0; i < TOGETHER && i < n; i++) {
        j = which[i];
        if (good[i] > 0.0)
            *out[j] = common_get(&unit, i);
        else
            common_cone_normal(selves[j], rays[j], at[j], out[j]);
    }
}

void common_cone_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                             pov_vec3 *const *out, uint32_t n)
{
    uint32_t which[TOGETHER], count = 0, i;

    for (i = 0; i < n; i++) {
        if (at[i]->mark.feature >= CAP_BASE)
            common_cone_normal(selves[i], rays[i], at[i], out[i]);
        else
            which[count++] = i;
        if (count == TOGETHER || (count > 1 && i + 1 == n)) {
            normals_of(selves, rays, at, out, which, count);
            count = 0;
        }
    }
    if (count)
        common_cone_normal(selves[which[0]], rays[which[0]], at[which[0]], out[which[0]]);
}
