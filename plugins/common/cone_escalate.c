#include "common/expansion.h"
#include "common/cone_internal.h"

/* o + o_lo - anchor + t (d + d_lo) - y axis, rounded once. */
static pov_two exact_offset(double o, double o_lo, pov_two anchor, double t, double d, double d_lo, double y,
                            pov_two axis)
{
    common_expansion e;

    common_expansion_clear(&e);
    common_expansion_add(&e, o);
    common_expansion_add(&e, o_lo);
    common_expansion_add(&e, -anchor.hi);
    common_expansion_add(&e, -anchor.lo);
    common_expansion_add_product(&e, t, d);
    common_expansion_add_product(&e, t, d_lo);
    common_expansion_add_product(&e, -y, axis.hi);
    common_expansion_add_product(&e, -y, axis.lo);
    return common_expansion_two(&e);
}

/* The ray's point at t. On a slender shape even a double-double length would leave few bits of a width, so the
 * component along the axis is subtracted first, without any error. */
static pov_two3 local_along(const common_cone *s, const common_ray *k, const pov_ray *ray, double t)
{
    pov_two3 w = common_along_two(k, t), p;
    double y, along = t * k->unit;

    if (!s->slender)
        return cone_local(s, w);
    y = pov_two3_dot(s->row[2], w).hi / s->height.hi;
    w.x = exact_offset(ray->org.x, ray->org_lo.x, s->anchor.x, along, ray->dir.x, ray->dir_lo.x, y, s->axis.x);
    w.y = exact_offset(ray->org.y, ray->org_lo.y, s->anchor.y, along, ray->dir.y, ray->dir_lo.y, y, s->axis.y);
    w.z = exact_offset(ray->org.z, ray->org_lo.z, s->anchor.z, along, ray->dir.z, ray->dir_lo.z, y, s->axis.z);
    p = cone_local(s, scaled(w, s->scale));
    p.z = pov_two_add(p.z, pov_two_mul_double(s->height, y));
    return p;
}

/* The interval of the ray within something convex: from lo to hi, either of which may be infinite. */
typedef struct span {
    bool empty, from_ever, for_ever;
    pov_two lo, hi;
    uint32_t lo_of, hi_of;
} span;

/* A ray nearly parallel to the side changes its distance so slowly that squares may underflow: its direction is scaled
 * by `power`. */
static double quicken(pov_two3 *d, pov_two *grow)
{
    const double power = pov_inverse_power(pov_largest(pov_vec3_of(d->x.hi, d->y.hi, grow->hi)));

    *d = scaled(*d, power);
    *grow = pov_two_scale(*grow, power);
    return power;
}

static span side_span(const common_cone *s, pov_two3 w, pov_two3 d)
{
    pov_two grow = pov_two_mul(s->slope, d.z);
    const double power = quicken(&d, &grow);
    const pov_two r = radius_at(s, w.z);
    const pov_two p = sum2(r, d.x, pov_two_neg(grow), w.x), q = sum2(r, d.y, pov_two_neg(grow), w.y);
    const pov_two x = sum2(w.x, d.y, pov_two_neg(w.y), d.x);
    const pov_two a = pov_two_sub(sum2(d.x, d.x, d.y, d.y), pov_two_mul(grow, grow));
    const pov_two b = pov_two_sub(sum2(w.x, d.x, w.y, d.y), pov_two_mul(r, grow));
    const pov_two c = pov_two_sub(sum2(w.x, w.x, w.y, w.y), pov_two_mul(r, r));
    const pov_two discriminant = pov_two_sub(sum2(p, p, q, q), pov_two_mul(x, x));
    span out = { true, false, false, { 0.0, 0.0 }, { 0.0, 0.0 }, SIDE_IN, SIDE_OUT };
    pov_two root, sum, first, second;

    if (a.hi == 0.0 && b.hi == 0.0) {
        out.empty = c.hi > 0.0 || r.hi < 0.0;
        out.from_ever = out.for_ever = true;
        return out;
    }
    if (discriminant.hi < 0.0 && a.hi >= 0.0)
        return out;
    root = pov_two_sqrt(discriminant);
    sum = b.hi < 0.0 ? pov_two_sub(root, b) : pov_two_neg(pov_two_add(b, root));
    if (a.hi >= 0.0 && sum2(r, a, pov_two_neg(grow), b).hi < 0.0)
        return out;     /* the other half of the double cone; also for rays along its side */
    out.empty = false;
    first = second = sum.hi == 0.0 ? sum : pov_two_div(c, sum);
    if (a.hi != 0.0 && sum.hi != 0.0)
        second = pov_two_div(sum, a);
    if (pov_two_less(second, first)) {
        pov_two swap = first;
        first = second;
        second = swap;
    }
    first = pov_two_scale(first, power);
    second = pov_two_scale(second, power);
    if (a.hi > 0.0) {
        out.lo = first;
        out.hi = second;
    } else if (grow.hi > 0.0) {
        out.lo = second;
        out.for_ever = true;
    } else {
        out.hi = first;
        out.from_ever = true;
    }
    return out;
}

static span slab_span(const common_cone *s, pov_two z, pov_two dz)
{
    span out = { false, false, false, { 0.0, 0.0 }, { 0.0, 0.0 }, CAP_BASE, CAP_TOP };
    const double power = pov_inverse_power(dz.hi);
    pov_two base, top;

    if (dz.hi == 0.0) {
        out.empty = z.hi < 0.0 || pov_two_less(s->height, z);
        out.from_ever = out.for_ever = true;
        return out;
    }
    dz = pov_two_scale(dz, power);
    base = pov_two_scale(pov_two_div(pov_two_neg(z), dz), power);
    top = pov_two_scale(pov_two_div(pov_two_sub(s->height, z), dz), power);
    out.lo = dz.hi > 0.0 ? base : top;
    out.hi = dz.hi > 0.0 ? top : base;
    if (dz.hi < 0.0) {
        out.lo_of = CAP_TOP;
        out.hi_of = CAP_BASE;
    }
    return out;
}

/* Rises below this are lost among the least numbers on the way from the ray's start. */
#define LEVEL 0x1p-900

/* The same of a ray that rises less than that and starts at height z: it is in a cap's plane at its start, or nowhere within
 * reach. The caps' planes are `below` and above it. */
static span level_span(const common_cone *s, pov_two z, double dz, double middle)
{
    const double below = dz > 0.0 ? z.hi : pov_two_sub(s->height, z).hi, above = dz > 0.0 ? pov_two_sub(s->height, z).hi : z.hi;
    span out = { false, true, true, { -middle, 0.0 }, { -middle, 0.0 }, CAP_BASE, CAP_TOP };

    out.from_ever = below > 0.0;
    out.for_ever = above > 0.0;
    out.empty = below < 0.0 || above < 0.0;
    if (dz < 0.0) {
        out.lo_of = CAP_TOP;
        out.hi_of = CAP_BASE;
    }
    return out;
}

/* Capped: the intersection of the intervals of side and slab. */
static span intersect_planes(span a, span b)
{
    if (a.empty || b.empty) {
        a.empty = true;
        return a;
    }
    if (a.from_ever || (!b.from_ever && pov_two_less(a.lo, b.lo))) {
        a.from_ever = b.from_ever;
        a.lo = b.lo;
        a.lo_of = b.lo_of;
    }
    if (a.for_ever || (!b.for_ever && pov_two_less(b.hi, a.hi))) {
        a.for_ever = b.for_ever;
        a.hi = b.hi;
        a.hi_of = b.hi_of;
    }
    return a;
}

static bool within(span slab, pov_two t)
{
    return !slab.empty && (slab.from_ever || !pov_two_less(t, slab.lo)) && (slab.for_ever || !pov_two_less(slab.hi, t));
}

static leaving leaving_of(const common_cone *s, const common_ray *k, pov_two3 d, uint32_t feature)
{
    pov_two3 f;
    double outward;

    if (feature == CAP_BASE)
        return d.z.hi > 0.0 ? INWARD : OUTWARD;
    if (feature == CAP_TOP)
        return d.z.hi < 0.0 ? INWARD : OUTWARD;
    f = cone_local(s, k->f);
    outward = pov_two_sub(sum2(f.x, d.x, f.y, d.y), pov_two_mul(pov_two_mul(s->slope, d.z), radius_at(s, f.z))).hi;
    return outward < 0.0 ? INWARD : OUTWARD;
}

/* Additional distance to a root that is much nearer to the apex than w is; 0 for none. */
static double to_apex(const common_cone *s, const span *side, pov_two3 w, pov_two3 d)
{
    const double r = s->radius.hi + s->slope.hi * w.z.hi, grow = s->slope.hi * d.z.hi;
    const double at_lo = side->from_ever ? HUGE_VAL : fabs(r + grow * side->lo.hi);
    const double at_hi = side->for_ever ? HUGE_VAL : fabs(r + grow * side->hi.hi);
    const double there = at_lo < at_hi ? side->lo.hi : side->hi.hi;

    return !side->empty && pov_min(at_lo, at_hi) < 0x1p-4 * fabs(r) && isfinite(there) ? there : 0.0;
}

/* The direction in local coordinates. A rise that was lost there, where the shape is small along its axis, is the least that
 * there is. */
static pov_two3 direction_of(const common_cone *s, const common_ray *k)
{
    const pov_two3 world = common_direction(k);
    pov_two3 d = cone_local(s, world);
    const double rise = d.z.hi == 0.0 ? pov_two3_dot(s->row[2], scaled(world, 0x1p60)).hi : 0.0;

    if (rise != 0.0)
        d.z.hi = rise > 0.0 ? 0x1p-1074 : -0x1p-1074;
    return d;
}

/* Does the slab certainly begin at the end of the interval, or behind it? So does what is within: nothing is reported, but that the end is
 * near. */
static bool begins_behind(const span *slab, const common_ray *k, double middle, pov_hits *hits)
{
    const pov_two t = pov_two_add_double(slab->lo, middle);
    const double gap = (hits->tmax - t.hi * k->unit) - t.lo * k->unit;

    if (!(hits->slack > 0.0) || (hits->want != POV_WANT_ALL && hits->count > 0) || slab->empty || slab->from_ever || !(gap < 0.25 * hits->slack))
        return false;
    hits->near_end = hits->near_end || fabs(gap) < hits->slack;
    return true;
}

/* Does it end where the interval begins, or before? */
static bool ends_before(const span *slab, const common_ray *k, double middle, const pov_hits *hits)
{
    const pov_two t = pov_two_add_double(slab->hi, middle);
    const double at = t.hi * k->unit;

    return !slab->empty && !slab->for_ever && (at < hits->tmin || (at == hits->tmin && !(t.lo * k->unit > 0.0)));
}

/* Does the slab alone tell that nothing is in the interval? Rays often start in the plane of a cap, and lights lie in it: the axis alone is
 * looked at first. */
static bool slab_decides(const common_cone *s, const common_ray *k, double middle, pov_hits *hits)
{
    const pov_two dz = pov_two3_dot(s->row[2], common_direction(k));
    span slab;

    if (s->slender || fabs(dz.hi) < LEVEL)
        return false;
    slab = slab_span(s, pov_two3_dot(s->row[2], common_along_two(k, middle)), dz);
    return ends_before(&slab, k, middle, hits) || begins_behind(&slab, k, middle, hits);
}

void common_cone_escalate(const common_cone *s, const common_ray *k, const pov_ray *ray, double middle, pov_hits *hits)
{
    const bool starts = ray->origin_surface == hits->owner;
    span side, slab, both;
    leaving leaves;
    double further;
    pov_two3 d, w;
    bool in, out;

    hits->escalated++;
    if (!s->open && !starts && s->slope.hi == 0.0 && slab_decides(s, k, middle, hits))
        return;
    d = direction_of(s, k);
    leaves = starts ? leaving_of(s, k, d, ray->origin_mark.feature) : NOT_LEAVING;
    w = local_along(s, k, ray, middle);
    side = side_span(s, w, d);
    /* Recompute close to the apex, where all numbers are small; seen from further off they would be small
     * differences. */
    further = to_apex(s, &side, w, d);
    if (further != 0.0 && s->slope.hi != 0.0) {
        middle += further;
        w = local_along(s, k, ray, middle);
        side = side_span(s, w, d);
    }
    slab = d.z.hi != 0.0 && fabs(d.z.hi) < LEVEL ? level_span(s, cone_local(s, k->f).z, d.z.hi, middle) : slab_span(s, w.z, d.z);
    both = s->open ? side : intersect_planes(side, slab);
    if (both.empty)
        return;
    in = leaves != INWARD && !both.from_ever;
    out = leaves != OUTWARD && !both.for_ever;
    if (s->open) {
        in = in && within(slab, both.lo);
        out = out && within(slab, both.hi);
    } else if (leaves == NOT_LEAVING && pov_two_less(both.hi, both.lo)) {
        return;
    }
    if (in && !common_report_escalated(hits, pov_two_add_double(both.lo, middle), k->unit, both.lo_of,
                                       cone_mark(s)))
        return;
    if (out)
        common_report_escalated(hits, pov_two_add_double(both.hi, middle), k->unit, both.hi_of, cone_mark(s));
}
