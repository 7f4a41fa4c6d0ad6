/* Where several rays enter cylinders or cones, each one of its own, side by side. */
#include "kit/frustum_rough.h"
#include "kit/lanes.h"

/* Fewer than KIT_LANES: the numbers of a shape are many to copy, so places that hold nothing are dear. */
enum { TOGETHER = 4 };

/* Shapes, as far as they are needed, each with its ray. */
typedef struct pair_lanes {
    kit_rays rays;
    kit_lane3 anchor, anchor_lo, row[3];
    kit_lane loss[3], radius, slope, height, scale;
} pair_lanes;

static inline void put_shape(pair_lanes *l, uint32_t i, const kit_frustum *s)
{
    int k;

    kit_put(&l->anchor, i, pov_two3_hi(s->anchor));
    kit_put(&l->anchor_lo, i, pov_two3_lo(s->anchor));
    for (k = 0; k < 3; k++) {
        kit_put(&l->row[k], i, pov_two3_hi(s->row[k]));
        l->loss[k][i] = s->loss[k];
    }
    l->radius[i] = s->radius.hi;
    l->slope[i] = s->slope.hi;
    l->height[i] = s->height.hi;
    l->scale[i] = s->scale;
}

static inline void get_shape(const pair_lanes *l, uint32_t i, kit_frustum *s)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    int k;

    s->anchor = pov_two3_of(kit_get(&l->anchor, i), kit_get(&l->anchor_lo, i));
    for (k = 0; k < 3; k++) {
        s->row[k] = pov_two3_of(kit_get(&l->row[k], i), zero);
        s->loss[k] = l->loss[k][i];
    }
    s->radius = pov_two_of(l->radius[i], 0.0);
    s->slope = pov_two_of(l->slope[i], 0.0);
    s->height = pov_two_of(l->height[i], 0.0);
    s->scale = l->scale[i];
}

static inline bounded choose(int first, bounded a, bounded b)
{
    return bounded_of(first ? a.v : b.v, first ? a.e : b.e);
}

/* Both are known well enough to say which is smaller. */
static inline int is_apart(bounded a, bounded b) { return fabs(a.v - b.v) > 2.0 * (a.e + b.e); }

/* Where a line goes into something and out of it, and whether that is certain. */
typedef struct chord { bounded lo, hi; double apart; int certain; } chord;

/* As rough_side() where the side is a closed curve to the ray, and is cut. */
static inline chord cut_side(const kit_frustum *s, const rough *g)
{
    const rough_equation e = equation_of(g);
    const bounded axial = minus(times(g->r, e.a), times(g->grow, e.b));
    const double width = sqrt(e.discriminant.v);
    const bounded root = bounded_of(width, e.discriminant.e / width + KIT_U * width);
    const bounded sum = choose(e.b.v < 0.0, minus(root, e.b), minus(bounded_of(-e.b.v, e.b.e), root));
    const bounded first = over(e.c, sum), second = over(sum, e.a);
    const int swapped = first.v > second.v;
    chord c;

    c.lo = choose(swapped, second, first);
    c.hi = choose(swapped, first, second);
    c.apart = width / fabs(e.a.v);
    c.certain = (int)(e.a.v > 2.0 * e.a.e) & (int)(e.a.v >= KIT_TINY) & (int)(e.discriminant.v > 2.0 * e.discriminant.e)
                & ((int)(s->slope.hi == 0.0) | (int)(axial.v > 2.0 * axial.e));
    return c;
}

/* As rough_slab() of a ray that goes through both ends. */
static inline chord cut_slab(const kit_frustum *s, const rough *g)
{
    const bounded base = bounded_of(-g->z.v, g->z.e), top = plus(bounded_of(s->height.hi, KIT_U), base);
    const int up = g->dz.v > 0.0;
    chord c;

    c.lo = over(choose(up, base, top), g->dz);
    c.hi = over(choose(up, top, base), g->dz);
    c.apart = 0.0;
    c.certain = fabs(g->dz.v) > 2.0 * g->dz.e;
    return c;
}

/* Bounds on the distance, the distance, and which part is met; good: not zero where it is found well enough. */
typedef struct entry_lanes { kit_lane lo, hi, t, t_lo, part, good; } entry_lanes;

static inline void put_entry(entry_lanes *restrict out, uint32_t i, const kit_root *r, double unit)
{
    const double slack = kit_slack(r);

    out->lo[i] = (r->t.hi - slack) * unit;
    out->hi[i] = (r->t.hi + slack) * unit;
    out->t[i] = r->t.hi * unit;
    out->t_lo[i] = r->t.lo * unit;
}

/* As kit_frustum_intersect() of one that has its ends, and that the ray does not leave. */
KIT_CLONES static void find_entries(const pair_lanes *restrict l, entry_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const pov_ray ray = kit_get_ray(&l->rays, i);
        kit_frustum s;
        chord side, slab;
        kit_root root;
        bounded lo, hi;
        double middle, fine, speed;
        kit_ray k;
        rough g;

        get_shape(l, i, &s);
        k = kit_enter(&ray, s.anchor, s.scale);
        middle = find_middle(&s, &k, &g);
        find_point(&s, &k, middle, &g);
        speed = fabs(g.dx.v) + fabs(g.dy.v) + fabs(g.dz.v);
        side = cut_side(&s, &g);
        slab = cut_slab(&s, &g);
        lo = choose(side.lo.v < slab.lo.v, slab.lo, side.lo);
        hi = choose(slab.hi.v < side.hi.v, slab.hi, side.hi);
        root = root_of(middle, lo, 0);
        fine = kit_lesser(KIT_FINE / speed, KIT_APART * side.apart);
        put_entry(out, i, &root, k.unit);
        out->part[i] = side.lo.v < slab.lo.v ? (g.dz.v > 0.0 ? CAP_BASE : CAP_TOP) : SIDE_IN;
        out->good[i] = side.certain & slab.certain & is_apart(side.lo, slab.lo) & is_apart(slab.hi, side.hi)
                               & is_apart(hi, lo) & (int)(hi.v > lo.v) & (int)kit_is_fine(&root, fine)
                               & (int)(pov_largest(pov_two3_hi(k.f)) < KIT_FAR)
                           ? 1.0
                           : 0.0;
    }
}

static inline bool is_answered(const entry_lanes *e, uint32_t i, const kit_frustum *s, const pov_ray *ray,
                               const pov_hits *h)
{
    return e->good[i] > 0.0 && e->lo[i] <= h->tmax && e->hi[i] >= h->tmin && e->t[i] > h->tmin && !s->open && !s->empty
           && h->want != POV_WANT_ALL && !h->always_exact && h->owner != ray->left;
}

static void intersect_lanes(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    entry_lanes entry;
    pair_lanes lanes;
    uint32_t i;

    kit_put_four_of(&lanes.rays, 0, rays, n);
    for (i = 0; i < TOGETHER; i++)
        put_shape(&lanes, i, selves[kit_lane_of(i, n)]);
    find_entries(&lanes, &entry);
    for (i = 0; i < n; i++)
        if (is_answered(&entry, i, selves[i], rays[i], hits[i]))
            pov_cross(hits[i], entry.t[i], entry.t_lo[i], kit_mark((uint32_t)entry.part[i], 0));
        else
            kit_frustum_intersect(selves[i], rays[i], hits[i]);
}

void kit_frustum_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                uint32_t n)
{
    uint32_t i;

    for (; n > 1; n -= i, selves += i, rays += i, hits += i) {
        i = n < TOGETHER ? n : TOGETHER;
        intersect_lanes(selves, rays, hits, i);
    }
    if (n)
        kit_frustum_intersect(selves[0], rays[0], hits[0]);
}
