/* box_lanes.h - several pairs of a box and a ray side by side, for box.c: the arithmetic of its single rays. */
#ifndef COMMON_BOX_LANES_H
#define COMMON_BOX_LANES_H

#include "common/lanes.h"
#include "common/local.h"

/* Are only low parts left of a distance? They may be all error: the mark says so. */
static inline int is_lost(double distance, double o) { return fabs(distance) <= 0x1p-90 * fabs(o); }

/* Pairs of a box and a ray. */
typedef struct box_lanes {
    common_rays rays;
    common_lane plane[12];       /* both parts of the first plane, and so on */
    common_lane sign;            /* 1 for the entry, -1 for the exit */
} box_lanes;

/* Entry of each ray, or its exit if it starts on the box and goes into it. NaN where a comparison is uncertain. */
typedef struct end_lanes { common_lane t, t_lo, feature; } end_lanes;

/* A plane, and the ray's components along its axis; t as that of slabs. */
typedef struct crossed { double t, plane, plane_lo, o, o_lo, d, d_lo, feature; } crossed;

/* A ray whose direction is scaled so that the quotients of distances stay within range. */
typedef struct scaled_ray { pov_ray ray; double power; pov_vec3 d, d_lo; } scaled_ray;

static inline scaled_ray get_scaled(const box_lanes *l, uint32_t i)
{
    const pov_ray ray = common_get_ray(&l->rays, i);
    const double power = pov_inverse_power(pov_largest(ray.dir));

    return (scaled_ray){ ray, power, pov_scale(ray.dir, power), pov_scale(ray.dir_lo, power) };
}

static inline crossed choose(int first, crossed a, crossed b)
{
    crossed c;

    c.t = first ? a.t : b.t;
    c.plane = first ? a.plane : b.plane;
    c.plane_lo = first ? a.plane_lo : b.plane_lo;
    c.o = first ? a.o : b.o;
    c.o_lo = first ? a.o_lo : b.o_lo;
    c.d = first ? a.d : b.d;
    c.d_lo = first ? a.d_lo : b.d_lo;
    c.feature = first ? a.feature : b.feature;
    return c;
}

/* The planes of an axis in the order in which the ray crosses them. For its exit the order is reversed and distances
 * are negated, so that the result is again the largest of the near ones. */
static inline void cross_axis(const box_lanes *l, uint32_t i, int axis, double o, double o_lo, double d, double d_lo,
                              crossed *near, double *far)
{
    const double lower = l->plane[4 * axis][i], lower_lo = l->plane[4 * axis + 1][i];
    const double upper = l->plane[4 * axis + 2][i], upper_lo = l->plane[4 * axis + 3][i];
    const double sign = l->sign[i];
    const double at = ((lower - o) + (lower_lo - o_lo)) / d * sign,
        beyond = ((upper - o) + (upper_lo - o_lo)) / d * sign;
    const int backward = d * sign < 0.0;

    near->t = backward ? beyond : at;
    near->plane = backward ? upper : lower;
    near->plane_lo = backward ? upper_lo : lower_lo;
    near->feature = backward ? 2.0 * axis + 1.0 : 2.0 * axis;
    near->o = o;
    near->o_lo = o_lo;
    near->d = d;
    near->d_lo = d_lo;
    *far = backward ? at : beyond;
}

/* As compare() without escalation. */
static inline int is_disjoint(double a, double b) { return fabs(a - b) > 8.0 * COMMON_U * (fabs(a) + fabs(b)); }

/* The first of an axis's planes. A definite hit without a component along the axis is between them, as if it had entered before
 * anything else: distances of three axes differ. */
static inline crossed enter_axis(const box_lanes *l, uint32_t i, int axis, double o, double o_lo, double d, double d_lo)
{
    const int backward = d < 0.0;
    crossed c = { 0.0, l->plane[4 * axis][i], l->plane[4 * axis + 1][i], o, o_lo, d, d_lo, 2.0 * axis };

    c.plane = backward ? l->plane[4 * axis + 2][i] : c.plane;
    c.plane_lo = backward ? l->plane[4 * axis + 3][i] : c.plane_lo;
    c.feature = backward ? 2.0 * axis + 1.0 : c.feature;
    c.t = d != 0.0 ? ((c.plane - o) + (c.plane_lo - o_lo)) / d : -0x1p996 * (axis + 1);
    return c;
}

/* As report(), for a lane. */
static inline void put_end(end_lanes *out, uint32_t i, const crossed *end, int certain, double power)
{
    const pov_two distance = pov_two_neg(pov_two_offset(end->o, end->o_lo, pov_two_of(end->plane, end->plane_lo)));
    const double t = distance.hi / end->d;
    const pov_two p = pov_two_product(t, end->d);
    const double rest = ((distance.hi - p.hi) - p.lo) + (distance.lo - t * end->d_lo);
    const pov_two sum = pov_fast_two_sum(t, rest / end->d);

    const int lost = is_lost(distance.hi, end->o);

    out->t[i] = (certain & (int)(fabs(sum.lo) < HUGE_VAL) & !lost) ? sum.hi * power : NAN;
    out->t_lo[i] = sum.lo * power;
    out->feature[i] = end->feature;
}

/* Where an axis is left; of one along which the box has no extent, if the ray enters there: where the others are left. */
static inline double leave_axis(const box_lanes *l, uint32_t i, int axis, const crossed *end, double far)
{
    const int is_planar = (l->plane[4 * axis][i] == l->plane[4 * axis + 2][i]) & (l->plane[4 * axis + 1][i] == l->plane[4 * axis + 3][i]);

    return is_planar & (int)(end->feature >= 2.0 * axis) & (int)(end->feature < 2.0 * axis + 2.0) ? HUGE_VAL : far;
}

/* As begin(), find() and report() for one end. A direction without a component along some axis gives infinite
 * distances, which are not certain. */
COMMON_CLONES static void find_ends(const box_lanes *restrict l, end_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i++) {
        const scaled_ray r = get_scaled(l, i);
        crossed x, y, z, xy, end;
        double far_x, far_y, far_z, far_xy, far;   /* far: where it is left for certain */
        int certain;

        cross_axis(l, i, 0, r.ray.org.x, r.ray.org_lo.x, r.d.x, r.d_lo.x, &x, &far_x);
        cross_axis(l, i, 1, r.ray.org.y, r.ray.org_lo.y, r.d.y, r.d_lo.y, &y, &far_y);
        cross_axis(l, i, 2, r.ray.org.z, r.ray.org_lo.z, r.d.z, r.d_lo.z, &z, &far_z);
        xy = choose(y.t > x.t, y, x);
        far_xy = common_lesser(far_y, far_x);
        end = choose(z.t > xy.t, z, xy);
        far = common_lesser(leave_axis(l, i, 2, &end, far_z), common_lesser(leave_axis(l, i, 1, &end, far_y), leave_axis(l, i, 0, &end, far_x)));
        certain = is_disjoint(y.t, x.t) & is_disjoint(z.t, xy.t) & is_disjoint(far_y, far_x)
            & is_disjoint(far_z, far_xy) &
                  ((int)(l->sign[i] < 0.0) | (is_disjoint(end.t, far) & (int)(end.t < far)));
        put_end(out, i, &end, certain, r.power);
    }
}

/* As above for definite hits: which plane is the last of the three near ones. */
COMMON_CLONES static void find_entries(const box_lanes *restrict l, end_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i++) {
        const scaled_ray r = get_scaled(l, i);
        const crossed x = enter_axis(l, i, 0, r.ray.org.x, r.ray.org_lo.x, r.d.x, r.d_lo.x);
        const crossed y = enter_axis(l, i, 1, r.ray.org.y, r.ray.org_lo.y, r.d.y, r.d_lo.y);
        const crossed z = enter_axis(l, i, 2, r.ray.org.z, r.ray.org_lo.z, r.d.z, r.d_lo.z);
        const crossed xy = choose(y.t > x.t, y, x), end = choose(z.t > xy.t, z, xy);

        put_end(out, i, &end, is_disjoint(y.t, x.t) & is_disjoint(z.t, xy.t), r.power);
    }
}

/* Points at the ends. */
COMMON_CLONES static void find_points(const box_lanes *restrict l, const end_lanes *restrict e, common_contact_lanes *restrict out)
{
    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        const pov_ray ray = common_get_ray(&l->rays, i);
        const double face = e->feature[i], sign = face == 1.0 || face == 3.0 || face == 5.0 ? 1.0 : -1.0;

        common_put_point(out, i, &ray, e->t[i], e->t_lo[i]);
        common_put(&out->normal, i, pov_vec3_of(face < 2.0 ? sign : 0.0, face >= 2.0 && face < 4.0 ? sign : 0.0, face >= 4.0 ? sign : 0.0));
    }
}

#endif
