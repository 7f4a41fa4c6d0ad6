/* Entries of several rays into cylinders or cones, each into one of its own, or exits from those that they start on,
 * side by side. */
#include "common/cone_lanes.h"

static inline bounded choose(int first, bounded a, bounded b)
{
    return bounded_of(first ? a.v : b.v, first ? a.e : b.e);
}

/* Are both accurate enough to tell which is smaller? */
static inline int is_disjoint(bounded a, bounded b) { return fabs(a.v - b.v) > 2.0 * (a.e + b.e); }

/* Entry and exit of a line, and whether they are certain. */
typedef struct chord { bounded lo, hi; double separation; int certain; } chord;

/* As approx_side(), if the side is a closed curve for the ray, and is crossed. */
static inline chord cut_side(const common_cone *s, const approx *g)
{
    const approx_equation e = equation_of(g);
    const bounded axial = minus(times(g->r, e.a), times(g->grow, e.b));
    const double width = sqrt(e.discriminant.v);
    const bounded root = bounded_of(width, e.discriminant.e / width + COMMON_U * width);
    const bounded sum = choose(e.b.v < 0.0, minus(root, e.b), minus(bounded_of(-e.b.v, e.b.e), root));
    const bounded first = over(e.c, sum), second = over(sum, e.a);
    const int swapped = first.v > second.v;
    chord c;

    c.lo = choose(swapped, second, first);
    c.hi = choose(swapped, first, second);
    c.separation = width / fabs(e.a.v);
    c.certain = (int)(e.a.v > 2.0 * e.a.e) & (int)(e.a.v >= COMMON_TINY)
        & (int)(e.discriminant.v > 2.0 * e.discriminant.e)
                & ((int)(s->slope.hi == 0.0) | (int)(axial.v > 2.0 * axial.e));
    return c;
}

/* As approx_slab(), for a ray that goes through both ends, or stays between them. */
static inline chord cut_slab(const common_cone *s, const approx *g)
{
    const bounded base = bounded_of(-g->z.v, g->z.e), top = plus(bounded_of(s->height.hi, COMMON_U), base);
    const int up = g->dz.v > 0.0, level = (int)(g->dz.v == 0.0) & (int)(g->dz.e == 0.0);
    const int between = level & (int)(g->z.v > 2.0 * g->z.e) & (int)(top.v > 2.0 * top.e);
    chord c;

    c.lo = choose(level, bounded_of(-HUGE_VAL, 0.0), over(choose(up, base, top), g->dz));
    c.hi = choose(level, bounded_of(HUGE_VAL, 0.0), over(choose(up, top, base), g->dz));
    c.separation = 0.0;
    c.certain = (int)(fabs(g->dz.v) > 2.0 * g->dz.e) | between;
    return c;
}

/* Entry or exit of each ray: the root in the shape's units, its error bound, and half the distance between the side's
 * roots; then bounds on the distance, the distance, and the feature. good: not zero where it is accurate enough;
 * unsure: where a Newton step may make it so. */
typedef struct end_lanes {
    common_lane root, root_lo, error, separation, fine;
    common_lane lo, hi, t, t_lo, feature, good, unsure;
} end_lanes;

COMMON_INLINE void put_end(end_lanes *restrict out, uint32_t i, const common_root *r, double unit, int good)
{
    const double slack = common_slack(r);

    out->lo[i] = (r->t.hi - slack) * unit;
    out->hi[i] = (r->t.hi + slack) * unit;
    out->t[i] = r->t.hi * unit;
    out->t_lo[i] = r->t.lo * unit;
    out->good[i] = good ? 1.0 : 0.0;
}

/* As common_cone_intersect() for a capped shape that the ray does not leave, or that it enters. */
COMMON_CLONES static void find_ends(const cone_lanes *restrict l, const double *restrict inward,
                                    end_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const pov_ray ray = common_get_ray(&l->rays, i);
        const common_cone s = get_shape(l, i);
        const common_ray k = common_enter(&ray, s.anchor, s.scale);
        const int is_exit = inward[i] > 0.0;
        chord side, slab;
        common_root root;
        bounded lo, hi;
        double middle, speed, first, last;
        int certain;
        approx g;

        middle = find_middle(&s, &k, &g);
        find_point(&s, &k, middle, &g);
        speed = fabs(g.dx.v) + fabs(g.dy.v) + fabs(g.dz.v);
        side = cut_side(&s, &g);
        slab = cut_slab(&s, &g);
        lo = choose(side.lo.v < slab.lo.v, slab.lo, side.lo);
        hi = choose(slab.hi.v < side.hi.v, slab.hi, side.hi);
        certain = side.certain & slab.certain & is_disjoint(side.lo, slab.lo) & is_disjoint(slab.hi, side.hi)
                  & (is_exit | (is_disjoint(hi, lo) & (int)(hi.v > lo.v)))
                  & (int)(pov_largest(pov_two3_hi(k.f)) < COMMON_FAR);
        root = root_of(middle, choose(is_exit, hi, lo), 0, 0);
        out->root[i] = root.t.hi;
        out->root_lo[i] = root.t.lo;
        out->error[i] = root.error;
        out->separation[i] = side.separation;
        out->fine[i] = common_lesser(COMMON_FINE / speed, COMMON_SEPARATION * side.separation);
        first = g.dz.v > 0.0 ? CAP_BASE : CAP_TOP;
        first = side.lo.v < slab.lo.v ? first : SIDE_IN;
        last = g.dz.v > 0.0 ? CAP_TOP : CAP_BASE;
        last = slab.hi.v < side.hi.v ? last : SIDE_OUT;
        out->feature[i] = is_exit ? last : first;
        out->unsure[i] = certain & (int)(root.error <= COMMON_SEPARATION * side.separation) ? 1.0 : 0.0;
        put_end(out, i, &root, k.unit, certain & (int)common_is_fine(&root, out->fine[i]));
    }
}

/* The refinement step of common_report(), where double was not accurate enough. */
COMMON_CLONES static void refine_ends(const cone_lanes *restrict l, end_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const pov_ray ray = common_get_ray(&l->rays, i);
        const common_cone s = get_shape(l, i);
        const common_ray k = common_enter(&ray, s.anchor, s.scale);
        const double error = out->error[i], separation = out->separation[i];
        common_root r = { { out->root[i], out->root_lo[i] }, 0.0, 0, 0 };
        const pov_two3 w = common_along_dd(&k, r.t);
        const view v = view_of(&s, &k, w);
        const common_residual cap = cap_residual(&s, &v, out->feature[i] < CAP_TOP), side = side_residual(&s, &v);
        const int is_cap = out->feature[i] > SIDE_OUT;
        const common_residual f = { is_cap ? cap.value : side.value, cone_value_error(w),
                                 is_cap ? cap.half_slope : side.half_slope,
                                 is_cap ? cap.slope_error : side.slope_error };
        const double step = common_root_step(&f);
        const int good = (int)(fabs(step) <= 2.0 * error) & (int)(fabs(r.t.hi) > error);

        r.error = common_root_step_error(&f, step, separation);
        r.t = pov_two_add_double(r.t, step);
        put_end(out, i, &r, k.unit, good & (int)common_is_fine(&r, out->fine[i]));
    }
}

static inline bool is_answered(const end_lanes *e, uint32_t i, const common_cone *s, const pov_ray *ray,
                               const pov_hits *h)
{
    return e->lo[i] <= h->tmax && e->hi[i] >= h->tmin && e->t[i] > h->tmin && !s->open && !s->empty
           && h->want != POV_WANT_ALL && !h->always_exact &&
               (h->owner != ray->origin_surface || common_is_inward(ray, h));
}

/* Report these lanes; returns the lanes that are still to be intersected. */
static uint32_t report_ends(const end_lanes *e, uint32_t lanes, const void *const *selves, const pov_ray *const *rays,
                            pov_hits *const *hits)
{
    uint32_t left = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = common_first_lane(lanes);

        if (e->good[i] > 0.0 && is_answered(e, i, selves[i], rays[i], hits[i]))
            pov_cross(hits[i], e->t[i], e->t_lo[i], common_mark((uint32_t)e->feature[i], POV_MARK_CLOSED));
        else
            left |= 1u << i;
    }
    return left;
}

/* Lanes that a refinement step would settle: a search for any crossing needs none. */
static uint32_t worth_a_step(const end_lanes *e, uint32_t lanes, const void *const *selves, const pov_ray *const *rays,
                             pov_hits *const *hits)
{
    uint32_t worth = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = common_first_lane(lanes);
        const common_cone *s = selves[i];

        if (e->unsure[i] > 0.0 && !s->slender && hits[i]->want != POV_WANT_ANY
            && is_answered(e, i, s, rays[i], hits[i]))
            worth |= 1u << i;
    }
    return worth;
}

static void intersect_lanes(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    const void *shapes[TOGETHER];
    const pov_ray *some[TOGETHER];
    common_lane inward;
    end_lanes end;
    cone_lanes lanes;
    uint32_t i, left, worth;

    for (i = 0; i < TOGETHER; i++) {
        const uint32_t j = common_lane_of(i, n);

        shapes[i] = selves[j];
        some[i] = rays[j];
        inward[i] = common_is_inward(rays[j], hits[j]) ? 1.0 : 0.0;
    }
    put_pairs(&lanes, shapes, some);
    find_ends(&lanes, inward, &end);
    left = report_ends(&end, (1u << n) - 1, selves, rays, hits);
    worth = worth_a_step(&end, left, selves, rays, hits);
    if (worth) {
        refine_ends(&lanes, &end);
        left = (left & ~worth) | report_ends(&end, worth, selves, rays, hits);
    }
    for (; left; left &= left - 1) {
        i = common_first_lane(left);
        common_cone_intersect(selves[i], rays[i], hits[i]);
    }
}

void common_cone_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                uint32_t n)
{
    uint32_t i;

    for (; n > 1; n -= i, selves += i, rays += i, hits += i) {
        i = n < TOGETHER ? n : TOGETHER;
        intersect_lanes(selves, rays, hits, i);
    }
    if (n)
        common_cone_intersect(selves[0], rays[0], hits[0]);
}
