/* Cylinders and cones in double precision, with a running bound on every error. */
#include "common/cone_approx.h"

/* The same as span, in double. */
typedef struct approx_span {
    bool empty, from_ever, for_ever;
    bounded lo, hi;
    uint32_t lo_of, hi_of;
    double separation;       /* half the distance between the roots of the side */
} approx_span;

/* Is each of the row's products with the direction zero, without any rounding? */
static bool is_across(const pov_two3 *row, pov_vec3 d)
{
    return (row->x.hi == 0.0 || d.x == 0.0) && (row->y.hi == 0.0 || d.y == 0.0) && (row->z.hi == 0.0 || d.z == 0.0);
}

/* Along a cylinder's axis a ray is inside its side everywhere, or nowhere. */
static bool approx_along(bounded c, approx_span *out)
{
    out->empty = c.v > 0.0;
    out->from_ever = out->for_ever = true;
    out->lo = out->hi = bounded_of(0.0, 0.0);
    out->lo_of = SIDE_IN;
    out->hi_of = SIDE_OUT;
    out->separation = HUGE_VAL;
    return is_certain(c);
}

static bool approx_side(const common_cone *s, const approx *g, pov_vec3 d, approx_span *out)
{
    const approx_equation e = equation_of(g);
    const bounded a = e.a, b = e.b, c = e.c, discriminant = e.discriminant;
    bounded root, sum, first, second;

    if (a.v == 0.0 && s->slope.hi == 0.0 && is_across(&s->row[0], d) && is_across(&s->row[1], d))
        return approx_along(c, out);
    if (!is_certain(a) || !is_certain(discriminant) || fabs(a.v) < COMMON_TINY)
        return false;
    out->empty = discriminant.v < 0.0;
    out->from_ever = out->for_ever = false;
    out->lo_of = SIDE_IN;
    out->hi_of = SIDE_OUT;
    if (out->empty)
        return a.v > 0.0;
    if (a.v > 0.0 && s->slope.hi != 0.0) {
        const bounded axial = minus(times(g->r, a), times(g->grow, b));

        if (!is_certain(axial))
            return false;
        if (axial.v < 0.0) {
            out->empty = true;
            return true;
        }
    }
    root.v = sqrt(discriminant.v);
    root.e = discriminant.e / root.v + COMMON_U * root.v;
    sum = b.v < 0.0 ? minus(root, b) : minus(bounded_of(-b.v, b.e), root);
    first = over(c, sum);
    second = over(sum, a);
    out->separation = root.v / fabs(a.v);
    if (first.v > second.v) {
        const bounded swap = first;
        first = second;
        second = swap;
    }
    out->lo = a.v > 0.0 ? first : second;
    out->hi = a.v > 0.0 ? second : first;
    out->from_ever = a.v < 0.0 && g->grow.v < 0.0;
    out->for_ever = a.v < 0.0 && g->grow.v > 0.0;
    return a.v > 0.0 || is_certain(g->grow);
}

static bool approx_slab(const common_cone *s, const approx *g, approx_span *out)
{
    const bounded top = plus(bounded_of(s->height.hi, COMMON_U), bounded_of(-g->z.v, g->z.e));
    const bool up = g->dz.v > 0.0;

    out->empty = out->from_ever = out->for_ever = false;
    out->lo = out->hi = bounded_of(0.0, 0.0);
    out->lo_of = up ? CAP_BASE : CAP_TOP;
    out->hi_of = up ? CAP_TOP : CAP_BASE;
    if (g->dz.v == 0.0 && g->dz.e == 0.0) {
        out->from_ever = out->for_ever = true;
        out->empty = g->z.v < 0.0 || top.v < 0.0;
        return is_certain(g->z) && is_certain(top);
    }
    if (!is_certain(g->dz))
        return false;
    out->lo = over(up ? bounded_of(-g->z.v, g->z.e) : top, g->dz);
    out->hi = over(up ? top : bounded_of(-g->z.v, g->z.e), g->dz);
    return true;
}

/* Is a before b? Sets *certain to false when that is unknown. */
static inline bool is_before(bounded a, bounded b, bool *certain)
{
    if (!(fabs(a.v - b.v) > 2.0 * (a.e + b.e)))
        *certain = false;
    return a.v < b.v;
}

static approx_span approx_intersect(approx_span a, approx_span b, bool *certain)
{
    if (a.empty || b.empty) {
        a.empty = true;
        return a;
    }
    if (a.from_ever || (!b.from_ever && is_before(a.lo, b.lo, certain))) {
        a.from_ever = b.from_ever;
        a.lo = b.lo;
        a.lo_of = b.lo_of;
    }
    if (a.for_ever || (!b.for_ever && is_before(b.hi, a.hi, certain))) {
        a.for_ever = b.for_ever;
        a.hi = b.hi;
        a.hi_of = b.hi_of;
    }
    return a;
}

static bool approx_within(const approx_span *slab, bounded t, bool *certain)
{
    if (slab->empty)
        return false;
    return (slab->from_ever || !is_before(t, slab->lo, certain)) &&
           (slab->for_ever || !is_before(slab->hi, t, certain));
}

/* f: the ray's start. */
static leaving approx_leaving(const common_cone *s, pov_vec3 f, const approx *g, uint32_t feature, bool *certain)
{
    const bounded x = row_times(s, 0, f, 0.0), y = row_times(s, 1, f, 0.0);
    bounded z = row_times(s, 2, f, 0.0), outward;

    if (feature >= CAP_BASE) {
        *certain = *certain && (is_certain(g->dz) || (g->dz.v == 0.0 && g->dz.e == 0.0));
        return (feature == CAP_BASE ? g->dz.v > 0.0 : g->dz.v < 0.0) ? INWARD : OUTWARD;
    }
    z = plus(bounded_of(s->radius.hi, COMMON_U), times(slope_of(s), z));
    outward = minus(plus(times(x, g->dx), times(y, g->dy)), times(g->grow, z));
    *certain = *certain && is_certain(outward);
    return outward.v < 0.0 ? INWARD : OUTWARD;
}

/* Does the slab end about where the ray starts? Then more precision is needed for whatever is within. */
static bool ends_at_start(const approx_span *slab, double middle, const pov_hits *hits)
{
    return hits->tmin == 0.0 && !slab->for_ever && fabs(middle + slab->hi.v) <= slab->hi.e;
}

static bool fast(const common_cone *s, const common_ray *k, const approx *g, leaving leaves, double middle,
                 pov_hits *hits)
{
    approx_span side, slab, both;
    bool certain = true, in, out;
    common_equation equation = { s, k, common_cone_residual, 0.0 };
    const double speed = fabs(g->dx.v) + fabs(g->dy.v) + fabs(g->dz.v);
    common_root roots[2];
    uint32_t n = 0;

    if (!approx_slab(s, g, &slab))
        return false;
    if (slab.empty)
        return true;
    if (!s->open && leaves == NOT_LEAVING && ends_at_start(&slab, middle, hits))
        return false;
    if (!approx_side(s, g, k->d, &side))
        return false;
    if (side.empty)
        return true;
    both = s->open ? side : approx_intersect(side, slab, &certain);
    in = leaves != INWARD && !both.from_ever;
    out = leaves != OUTWARD && !both.for_ever;
    if (s->open) {
        in = in && approx_within(&slab, both.lo, &certain);
        out = out && approx_within(&slab, both.hi, &certain);
    } else if (leaves == NOT_LEAVING && !both.from_ever && !both.for_ever && is_before(both.hi, both.lo, &certain)) {
        return certain;
    }
    if (!certain)
        return false;
    if (in)
        roots[n++] = root_of(middle, both.lo, both.lo_of, cone_mark(s));
    if (out)
        roots[n++] = root_of(middle, both.hi, both.hi_of, cone_mark(s));
    equation.separation = s->slender ? 0.0 : side.separation;
    return common_report(roots, n, pov_min(COMMON_FINE / speed, COMMON_SEPARATION * side.separation), &equation, hits);
}

/* A ray that enters a capped shape leaves it once, within its diameter, which is below sqrt(20): that suffices for
 * counting. */
static bool exits(const common_cone *s, const approx *g, double unit, pov_hits *hits)
{
    const double beyond = 8.0 * unit / (fabs(g->dx.v) + fabs(g->dy.v) + fabs(g->dz.v));

    if (s->open || !(hits->tmin <= 0.0 && beyond < hits->tmax))
        return false;
    pov_cross(hits, beyond, 0.0, common_mark(SIDE_OUT, 0));
    return true;
}

void common_cone_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const common_cone *s = self;
    const common_ray k = common_enter(ray, s->anchor, s->scale);
    const pov_vec3 f = pov_two3_hi(k.f);
    leaving leaves = NOT_LEAVING;
    bool certain = pov_largest(f) < COMMON_FAR && !hits->always_exact;
    double middle;
    approx g;

    if (s->empty)
        return;
    middle = find_middle(s, &k, &g);
    if (ray->origin_surface == hits->owner) {
        leaves = approx_leaving(s, f, &g, ray->origin_mark.feature, &certain);
        /* A capped shape is convex: all of it is behind a ray that goes outward. */
        if (certain && leaves == OUTWARD && !s->open && hits->tmin >= 0.0)
            return;
        if (certain && leaves == INWARD && hits->count_only && exits(s, &g, k.unit, hits))
            return;
    }
    if (certain)
        find_point(s, &k, middle, &g);
    if (!certain || !fast(s, &k, &g, leaves, middle, hits))
        common_cone_escalate(s, &k, ray, middle, hits);
}
