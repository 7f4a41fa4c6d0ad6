/* The normals of several cylinders or cones side by side. */
#include "kit/frustum_parts.h"
#include "kit/lanes.h"

/* Fewer than KIT_LANES: the numbers of a shape are many to copy, so places that hold nothing are dear. */
enum { TOGETHER = 4 };

/* Shapes, as far as normals of sides need them, each with its ray and a crossing. */
typedef struct side_lanes {
    kit_rays rays;
    kit_lane3 anchor, anchor_lo, row[3], row_lo[3];
    kit_lane radius, radius_lo, slope, slope_lo, scale, t, t_lo;
} side_lanes;

static inline void put_side(side_lanes *l, uint32_t i, const kit_frustum *s, const pov_crossing *at)
{
    int k;

    kit_put(&l->anchor, i, pov_two3_hi(s->anchor));
    kit_put(&l->anchor_lo, i, pov_two3_lo(s->anchor));
    for (k = 0; k < 3; k++) {
        kit_put(&l->row[k], i, pov_two3_hi(s->row[k]));
        kit_put(&l->row_lo[k], i, pov_two3_lo(s->row[k]));
    }
    l->radius[i] = s->radius.hi;
    l->radius_lo[i] = s->radius.lo;
    l->slope[i] = s->slope.hi;
    l->slope_lo[i] = s->slope.lo;
    l->scale[i] = s->scale;
    l->t[i] = at->t;
    l->t_lo[i] = at->t_lo;
}

static inline void get_side(const side_lanes *l, uint32_t i, kit_frustum *s, pov_crossing *at)
{
    s->anchor = pov_two3_of(kit_get(&l->anchor, i), kit_get(&l->anchor_lo, i));
    s->row[0] = pov_two3_of(kit_get(&l->row[0], i), kit_get(&l->row_lo[0], i));
    s->row[1] = pov_two3_of(kit_get(&l->row[1], i), kit_get(&l->row_lo[1], i));
    s->row[2] = pov_two3_of(kit_get(&l->row[2], i), kit_get(&l->row_lo[2], i));
    s->radius = pov_two_of(l->radius[i], l->radius_lo[i]);
    s->slope = pov_two_of(l->slope[i], l->slope_lo[i]);
    s->scale = l->scale[i];
    at->t = l->t[i];
    at->t_lo = l->t_lo[i];
}

/* As kit_frustum_normal(). good: not zero where that takes its usual way, and pov_unit() neither scales. */
KIT_CLONES static void find_normals(const side_lanes *restrict l, kit_lane3 *restrict out, double *restrict good)
{
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const pov_ray ray = kit_get_ray(&l->rays, i);
        pov_crossing at;
        kit_frustum s;
        kit_ray k;
        pov_vec3 w;
        view v;
        double step, length, largest;

        get_side(l, i, &s, &at);
        k = kit_enter(&ray, s.anchor, s.scale);
        v = view_of(&s, &k, kit_point(&k, &at));
        step = side_step(&s, &v);
        take_step(&s, &v, step);
        w = side_normal(&s, &v);
        length = sqrt(pov_dot(w, w));
        largest = pov_largest(w);
        good[i] = is_step(step) & (int)(fabs(v.p.x.hi) + fabs(v.p.y.hi) > 0.0) & (int)(largest > 1e-100) &
                          (int)(largest < 1e100)
                      ? 1.0
                      : 0.0;
        kit_put(out, i, pov_vec3_of(w.x / length, w.y / length, w.z / length));
    }
}

/* The places of `which` are sides. */
static void normals_of(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                       pov_vec3 *const *out, const uint32_t *which, uint32_t n)
{
    side_lanes lanes;
    kit_lane3 unit;
    kit_lane good;
    const pov_ray *some[TOGETHER];
    uint32_t i, j;

    for (i = 0; i < TOGETHER; i++) {
        j = which[kit_lane_of(i, n)];
        some[i] = rays[j];
        put_side(&lanes, i, selves[j], at[j]);
    }
    kit_put_four_rays(&lanes.rays, 0, some);
    find_normals(&lanes, &unit, good);
    for (i = 0; i < TOGETHER && i < n; i++) {
        j = which[i];
        if (good[i] > 0.0)
            *out[j] = kit_get(&unit, i);
        else
            kit_frustum_normal(selves[j], rays[j], at[j], out[j]);
    }
}

void kit_frustum_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                             pov_vec3 *const *out, uint32_t n)
{
    uint32_t which[TOGETHER], count = 0, i;

    for (i = 0; i < n; i++) {
        if (at[i]->mark.part >= CAP_BASE)
            kit_frustum_normal(selves[i], rays[i], at[i], out[i]);
        else
            which[count++] = i;
        if (count == TOGETHER || (count > 1 && i + 1 == n)) {
            normals_of(selves, rays, at, out, which, count);
            count = 0;
        }
    }
    if (count)
        kit_frustum_normal(selves[which[0]], rays[which[0]], at[which[0]], out[which[0]]);
}
