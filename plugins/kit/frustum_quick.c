/* Cylinders and cones in double precision, with a running bound on every error. */
#include "kit/frustum_parts.h"
#include "kit/simd.h"

typedef struct bounded { double v, e; } bounded;   /* the exact value is within e of v */

static inline bounded bounded_of(double v, double e) { bounded b; b.v = v; b.e = e; return b; }

/* A row times a vector that is off by a rounding of each component, and of `slack` more: six roundings in all, or one if
 * the row is a coordinate axis. */
static inline bounded row_times(const kit_frustum *s, int i, pov_vec3 w, double slack)
{
    const pov_two3 *row = &s->row[i];
    const double x = row->x.hi * w.x, y = row->y.hi * w.y, z = row->z.hi * w.z;
    const double lost = fabs(row->x.hi) + fabs(row->y.hi) + fabs(row->z.hi);

    return bounded_of(x + y + z, s->loss[i] * (fabs(x) + fabs(y) + fabs(z) + slack * lost));
}

static inline bounded times(bounded a, bounded b)
{
    const double v = a.v * b.v;
    return bounded_of(v, fabs(a.v) * b.e + a.e * (fabs(b.v) + b.e) + KIT_U * fabs(v));
}

static inline bounded plus(bounded a, bounded b)
{
    const double v = a.v + b.v;
    return bounded_of(v, a.e + b.e + KIT_U * fabs(v));
}

static inline bounded minus(bounded a, bounded b)
{
    b.v = -b.v;
    return plus(a, b);
}

static inline bounded over(bounded a, bounded b)
{
    const double v = a.v / b.v;
    return bounded_of(v, (a.e + fabs(v) * b.e) / (fabs(b.v) - b.e) + KIT_U * fabs(v));
}

/* The sign is certain: not even a bound twice as wide could turn it, which also pays for the bound's own
 * roundings. */
static inline bool is_certain(bounded a) { return fabs(a.v) > 2.0 * a.e; }

/* The same as span, in double. */
typedef struct rough_span {
    bool empty, from_ever, for_ever;
    bounded lo, hi;
    uint32_t lo_part, hi_part;
    double apart;            /* half the distance between the roots of the side */
} rough_span;

typedef struct rough { bounded x, y, z, dx, dy, dz, r, grow; } rough;

/* Two components across the axis: what either is off by at most, the larger of their sizes, and the sum. */
typedef struct rough_pair { double off, most, size; } rough_pair;

static inline rough_pair pair_of(bounded a, bounded b)
{
    rough_pair p;

    p.off = kit_greater(a.e, b.e);
    p.most = kit_greater(fabs(a.v), fabs(b.v));
    p.size = fabs(a.v) + fabs(b.v);
    return p;
}

/* What a product, a square, and the sum of two squares are off by for their factors. */
static inline double off_by(double a, double a_off, double b, double b_off) { return a * b_off + a_off * (b + b_off); }
static inline double off_by_square(double a, double off) { return off * (2.0 * a + off); }
static inline double off_by_squares(rough_pair a) { return 2.0 * a.off * (a.size + a.off); }

/* The equation of the side along the ray, a t^2 + 2 b t + c, and its discriminant p^2 + q^2 - m^2. The same rules as above,
 * once for what is alike. */
typedef struct rough_equation { bounded a, b, c, discriminant; } rough_equation;

static inline rough_equation equation_of(const rough *g)
{
    const double u = KIT_U, x = g->x.v, y = g->y.v, r = g->r.v, dx = g->dx.v, dy = g->dy.v, grow = g->grow.v;
    const double far = fabs(r), steep = fabs(grow), p = r * dx - grow * x, q = r * dy - grow * y, m = x * dy - y * dx;
    const double way2 = dx * dx + dy * dy, grow2 = grow * grow, out2 = x * x + y * y, r2 = r * r, pq2 = p * p + q * q;
    const rough_pair out = pair_of(g->x, g->y), way = pair_of(g->dx, g->dy);
    const double pq_off = off_by(far, g->r.e, way.most, way.off) + off_by(steep, g->grow.e, out.most, out.off)
                          + 2.0 * u * (far * way.most + steep * out.most);
    /* Of m, and of x dx + y dy. */
    const double m_off = out.size * way.off + out.off * (way.size + 2.0 * way.off) + 3.0 * u * out.size * way.most;
    const rough_pair pq = { pq_off, 0.0, fabs(p) + fabs(q) };
    rough_equation e;

    e.a = bounded_of(way2 - grow2, off_by_squares(way) + off_by_square(steep, g->grow.e) + 3.0 * u * (way2 + grow2));
    e.b = bounded_of(x * dx + y * dy - r * grow, m_off + off_by(far, g->r.e, steep, g->grow.e) + 3.0 * u * far * steep);
    e.c = bounded_of(out2 - r2, off_by_squares(out) + off_by_square(far, g->r.e) + 3.0 * u * (out2 + r2));
    e.discriminant = bounded_of(pq2 - m * m, off_by_squares(pq) + off_by_square(fabs(m), m_off) + 3.0 * u * (pq2 + m * m));
    return e;
}

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

/* Is a before b? False in *certain when that cannot be told. */
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

/* x, y, z: where the ray starts. */
static leaving rough_leaving(const kit_frustum *s, bounded x, bounded y, bounded z, const rough *g, uint32_t part,
                             bool *certain)
{
    bounded outward;

    if (part >= CAP_BASE) {
        *certain = *certain && (is_certain(g->dz) || (g->dz.v == 0.0 && g->dz.e == 0.0));
        return (part == CAP_BASE ? g->dz.v > 0.0 : g->dz.v < 0.0) ? INWARD : OUTWARD;
    }
    z = plus(bounded_of(s->radius.hi, KIT_U), times(bounded_of(s->slope.hi, KIT_U * fabs(s->slope.hi)), z));
    outward = minus(plus(times(x, g->dx), times(y, g->dy)), times(g->grow, z));
    *certain = *certain && is_certain(outward);
    return outward.v < 0.0 ? INWARD : OUTWARD;
}

static inline kit_root root_of(double middle, bounded t, uint32_t part)
{
    kit_root r;

    r.t = pov_two_sum(middle, t.v);
    r.error = t.e;
    r.part = part;
    r.flags = 0;
    return r;
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
        roots[n++] = root_of(middle, both.lo, both.lo_part);
    if (out)
        roots[n++] = root_of(middle, both.hi, both.hi_part);
    equation.apart = s->slender ? 0.0 : side.apart;
    return kit_report(roots, n, fmin(KIT_FINE / speed, KIT_APART * side.apart), &equation, hits);
}

/* Who goes into a capped one comes out once, and no further on than its diameter, which is below sqrt(20): for whoever
 * counts that is enough. */
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
    const double slack = kit_far_slack(&k);
    leaving way = NOT_LEAVING;
    bool certain = pov_largest(f) < KIT_FAR && !hits->always_exact;
    bounded x, y, z;
    double middle;
    pov_vec3 w;
    rough g;

    if (s->empty)
        return;
    x = row_times(s, 0, f, 0.0);
    y = row_times(s, 1, f, 0.0);
    z = row_times(s, 2, f, 0.0);
    g.dx = row_times(s, 0, k.d, 0.0);
    g.dy = row_times(s, 1, k.d, 0.0);
    g.dz = row_times(s, 2, k.d, 0.0);
    g.grow = times(bounded_of(s->slope.hi, KIT_U * fabs(s->slope.hi)), g.dz);
    if (ray->left == hits->owner) {
        way = rough_leaving(s, x, y, z, &g, ray->left_mark.part, &certain);
        /* With its caps it is convex: from there on all of it is behind. */
        if (certain && way == OUTWARD && !s->open && hits->tmin >= 0.0)
            return;
        if (certain && way == INWARD && hits->count_only && comes_out(s, &g, k.unit, hits))
            return;
    }
    /* Closest approach to the middle of the axis, in local lengths. Any point near the shape would do. */
    middle = -(x.v * g.dx.v + y.v * g.dy.v + (z.v - 0.5 * s->height.hi) * g.dz.v)
             / (g.dx.v * g.dx.v + g.dy.v * g.dy.v + g.dz.v * g.dz.v);
    w = kit_along(&k, middle);
    g.x = row_times(s, 0, w, slack);
    g.y = row_times(s, 1, w, slack);
    g.z = row_times(s, 2, w, slack);
    g.r = plus(bounded_of(s->radius.hi, KIT_U * s->radius.hi),
               times(bounded_of(s->slope.hi, KIT_U * fabs(s->slope.hi)), g.z));
    if (!certain || !quick(s, &k, &g, way, middle, hits))
        kit_frustum_decide(s, &k, ray, middle, hits);
}
