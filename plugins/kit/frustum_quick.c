/* Cylinders and cones in double precision, with a running bound on every error. */
#include "kit/frustum_rough.h"

/* The same as span, in double. */
typedef struct rough_span {
    bool empty, from_ever, for_ever;
    bounded lo, hi;
    uint32_t lo_part, hi_part;
    double apart;            /* half the distance between the roots of the side */
} rough_span;

static bool rough_side(const kit_frustum *s, const rough *g, rough_span *out)
{
    const rough_equation e = equation_of(g);
    const bounded a = e.a, b = e.b, c = e.c, discriminant = e.discriminant;
    bounded root, sum, first, second;

    if (!is_certain(a) || !is_certain(discriminant) || fabs(a.v) < KIT_TINY)
        return false;
    out->empty = discriminant.v < 0.0;
    out->from_ever = out->for_ever = false;
    out->lo_part = SIDE_IN;
    out->hi_part = SIDE_OUT;
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
    root.e = discriminant.e / root.v + KIT_U * root.v;
    sum = b.v < 0.0 ? minus(root, b) : minus(bounded_of(-b.v, b.e), root);
    first = over(c, sum);
    second = over(sum, a);
    out->apart = root.v / fabs(a.v);
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

static bool rough_slab(const kit_frustum *s, const rough *g, rough_span *out)
{
    const bounded top = plus(bounded_of(s->height.hi, KIT_U), bounded_of(-g->z.v, g->z.e));
    const bool up = g->dz.v > 0.0;

    out->empty = out->from_ever = out->for_ever = false;
    out->lo = out->hi = bounded_of(0.0, 0.0);
    out->lo_part = up ? CAP_BASE : CAP_TOP;
    out->hi_part = up ? CAP_TOP : CAP_BASE;
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

static rough_span rough_meet(rough_span a, rough_span b, bool *certain)
{
    if (a.empty || b.empty) {
        a.empty = true;
        return a;
    }
    if (a.from_ever || (!b.from_ever && is_before(a.lo, b.lo, certain))) {
        a.from_ever = b.from_ever;
        a.lo = b.lo;
        a.lo_part = b.lo_part;
    }
    if (a.for_ever || (!b.for_ever && is_before(b.hi, a.hi, certain))) {
        a.for_ever = b.for_ever;
        a.hi = b.hi;
        a.hi_part = b.hi_part;
    }
    return a;
}

static bool rough_within(const rough_span *slab, bounded t, bool *certain)
{
    if (slab->empty)
        return false;
    return (slab->from_ever || !is_before(t, slab->lo, certain)) &&
           (slab->for_ever || !is_before(slab->hi, t, certain));
}

/* f: the ray's start. */
static leaving rough_leaving(const kit_frustum *s, pov_vec3 f, const rough *g, uint32_t part, bool *certain)
{
    const bounded x = row_times(s, 0, f, 0.0), y = row_times(s, 1, f, 0.0);
    bounded z = row_times(s, 2, f, 0.0), outward;

    if (part >= CAP_BASE) {
        *certain = *certain && (is_certain(g->dz) || (g->dz.v == 0.0 && g->dz.e == 0.0));
        return (part == CAP_BASE ? g->dz.v > 0.0 : g->dz.v < 0.0) ? INWARD : OUTWARD;
    }
    z = plus(bounded_of(s->radius.hi, KIT_U), times(slope_of(s), z));
    outward = minus(plus(times(x, g->dx), times(y, g->dy)), times(g->grow, z));
    *certain = *certain && is_certain(outward);
    return outward.v < 0.0 ? INWARD : OUTWARD;
}

static bool quick(const kit_frustum *s, const kit_ray *k, const rough *g, leaving way, double middle, pov_hits *hits)
{
    rough_span side, slab, both;
    bool certain = true, in, out;
    kit_equation equation = { s, k, kit_frustum_residual, 0.0 };
    const double speed = fabs(g->dx.v) + fabs(g->dy.v) + fabs(g->dz.v);
    kit_root roots[2];
    uint32_t n = 0;

    if (!rough_slab(s, g, &slab))
        return false;
    if (slab.empty)
        return true;
    if (!rough_side(s, g, &side))
        return false;
    if (side.empty)
        return true;
    both = s->open ? side : rough_meet(side, slab, &certain);
    in = way != INWARD && !both.from_ever;
    out = way != OUTWARD && !both.for_ever;
    if (s->open) {
        in = in && rough_within(&slab, both.lo, &certain);
        out = out && rough_within(&slab, both.hi, &certain);
    } else if (way == NOT_LEAVING && !both.from_ever && !both.for_ever && is_before(both.hi, both.lo, &certain)) {
        return certain;
    }
    if (!certain)
        return false;
    if (in)
        roots[n++] = root_of(middle, both.lo, both.lo_part, frustum_mark(s));
    if (out)
        roots[n++] = root_of(middle, both.hi, both.hi_part, frustum_mark(s));
    equation.apart = s->slender ? 0.0 : side.apart;
    return kit_report(roots, n, fmin(KIT_FINE / speed, KIT_APART * side.apart), &equation, hits);
}

/* A ray that enters a capped shape leaves it once, within its diameter, which is below sqrt(20): that suffices for
 * counting. */
static bool comes_out(const kit_frustum *s, const rough *g, double unit, pov_hits *hits)
{
    const double beyond = 8.0 * unit / (fabs(g->dx.v) + fabs(g->dy.v) + fabs(g->dz.v));

    if (s->open || !(hits->tmin <= 0.0 && beyond < hits->tmax))
        return false;
    pov_cross(hits, beyond, 0.0, kit_mark(SIDE_OUT, 0));
    return true;
}

void kit_frustum_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const kit_frustum *s = self;
    const kit_ray k = kit_enter(ray, s->anchor, s->scale);
    const pov_vec3 f = pov_two3_hi(k.f);
    leaving way = NOT_LEAVING;
    bool certain = pov_largest(f) < KIT_FAR && !hits->always_exact;
    double middle;
    rough g;

    if (s->empty)
        return;
    middle = find_middle(s, &k, &g);
    if (ray->left == hits->owner) {
        way = rough_leaving(s, f, &g, ray->left_mark.part, &certain);
        /* A capped shape is convex: all of it is behind a ray that goes outward. */
        if (certain && way == OUTWARD && !s->open && hits->tmin >= 0.0)
            return;
        if (certain && way == INWARD && hits->count_only && comes_out(s, &g, k.unit, hits))
            return;
    }
    find_point(s, &k, middle, &g);
    if (!certain || !quick(s, &k, &g, way, middle, hits))
        kit_frustum_decide(s, &k, ray, middle, hits);
}
