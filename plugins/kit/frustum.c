#include "kit/frustum.h"

#include "kit/affine.h"
#include "kit/expansion.h"

enum { SIDE_IN = 0, SIDE_OUT = 1, CAP_BASE = 2, CAP_TOP = 3 };

/* Which crossings a ray that left the shape may still report. */
typedef enum leaving { NOT_LEAVING, INWARD, OUTWARD } leaving;

/* ---- making one ---- */

static pov_two3 scaled(pov_two3 a, double power)
{
    a.x = pov_two_scale(a.x, power);
    a.y = pov_two_scale(a.y, power);
    a.z = pov_two_scale(a.z, power);
    return a;
}

static pov_two3 unit(pov_two3 a, pov_two *length)
{
    pov_two3 r;

    *length = pov_two_sqrt(pov_two3_dot(a, a));
    r.x = pov_two_div(a.x, *length);
    r.y = pov_two_div(a.y, *length);
    r.z = pov_two_div(a.z, *length);
    return r;
}

/* Unit vectors across an axis: exact where the axis is one of the coordinates'. */
static void make_frame(pov_two3 axis, pov_two3 *across, pov_two3 *over)
{
    const pov_vec3 size = pov_vec3_of(fabs(axis.x.hi), fabs(axis.y.hi), fabs(axis.z.hi));
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    pov_vec3 pick = zero;
    pov_two length;

    if (size.x <= size.y && size.x <= size.z)
        pick.x = 1.0;
    else if (size.z <= size.y)
        pick.z = 1.0;
    else
        pick.y = 1.0;
    *across = unit(pov_two3_cross(axis, pov_two3_of(pick, zero)), &length);
    *over = pov_two3_cross(axis, *across);
}

/* Length and direction of an axis; along a coordinate axis both are exact. */
static pov_two3 measure(pov_two3 axis, pov_two *length)
{
    const pov_two zero = { 0.0, 0.0 };
    const int entries = (axis.x.hi != 0.0) + (axis.y.hi != 0.0) + (axis.z.hi != 0.0);
    pov_two3 way = { { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 } };
    pov_two sum;

    if (entries != 1)
        return unit(axis, length);
    sum = axis.x.hi != 0.0 ? axis.x : axis.y.hi != 0.0 ? axis.y : axis.z;
    way.x.hi = (axis.x.hi > 0.0) - (axis.x.hi < 0.0);
    way.y.hi = (axis.y.hi > 0.0) - (axis.y.hi < 0.0);
    way.z.hi = (axis.z.hi > 0.0) - (axis.z.hi < 0.0);
    *length = sum.hi < 0.0 ? pov_two_sub(zero, sum) : sum;
    return way;
}

static double largest_of(pov_two3 a) { return pov_largest(pov_two3_hi(a)); }

/* Bring everything to the order of one by powers of two: radii, height, and the rows for scaled points. */
static void normalise(kit_frustum *s)
{
    double largest_radius = fmax(s->radius.hi, pov_two_add(s->radius, pov_two_mul(s->slope, s->height)).hi);
    double across = pov_inverse_power(largest_radius), along = pov_inverse_power(s->height.hi), largest;
    int i;

    s->radius = pov_two_scale(s->radius, across);
    s->height = pov_two_scale(s->height, along);
    s->slope = pov_two_scale(s->slope, across / along);
    s->row[0] = scaled(s->row[0], across);
    s->row[1] = scaled(s->row[1], across);
    s->row[2] = scaled(s->row[2], along);
    largest = fmax(largest_of(s->row[0]), fmax(largest_of(s->row[1]), largest_of(s->row[2])));
    /* The rows lose a power of two, the points will gain it. */
    largest = pov_inverse_power(largest);
    for (i = 0; i < 3; i++)
        s->row[i] = scaled(s->row[i], largest);
    s->scale /= largest;
    s->slender = largest_of(s->row[0]) > 4096.0 * largest_of(s->row[2]);
}

bool kit_frustum_make(kit_frustum *s, pov_vec3 base, double base_radius, pov_vec3 top, double top_radius, bool open)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    double power = pov_inverse_power(pov_largest(pov_sub(top, base)));
    pov_two3 axis, way;
    pov_two length;

    if (top_radius < base_radius) {
        const pov_vec3 end = base;
        const double end_radius = base_radius;

        base = top;
        base_radius = top_radius;
        top = end;
        top_radius = end_radius;
    }
    axis.x = pov_two_sum(top.x, -base.x);
    axis.y = pov_two_sum(top.y, -base.y);
    axis.z = pov_two_sum(top.z, -base.z);
    if (!(largest_of(axis) > 0.0))
        return false;
    way = measure(scaled(axis, power), &length);
    s->anchor = pov_two3_of(base, zero);
    s->axis = axis;
    s->height = pov_two_scale(length, 1.0 / power);
    s->radius = pov_two_of(base_radius, 0.0);
    s->slope = pov_two_div(pov_two_sum(top_radius, -base_radius), s->height);
    s->row[2] = way;
    make_frame(way, &s->row[0], &s->row[1]);
    s->column[0] = pov_two3_hi(s->row[0]);
    s->column[1] = pov_two3_hi(s->row[1]);
    s->column[2] = pov_two3_hi(s->row[2]);
    s->radii[0] = base_radius;
    s->radii[1] = top_radius;
    s->length = s->height.hi;
    s->open = open;
    s->empty = !(base_radius > 0.0) && !(top_radius > 0.0);
    s->scale = 1.0;
    if (!s->empty)
        normalise(s);
    return true;
}

/* The box of two discs (ellipses, if a map squeezed them), wider by what the roundings here can have lost. */
static void extend(const kit_frustum *s, double anchor, double x, double y, double z, double *lo, double *hi)
{
    const double across = sqrt(x * x + y * y), shift = z * s->length;
    const double slack = 32.0 * KIT_U * (across * fmax(s->radii[0], s->radii[1]) + fabs(shift));
    const double low = fmin(-across * s->radii[0], shift - across * s->radii[1]);
    const double high = fmax(across * s->radii[0], shift + across * s->radii[1]);

    *lo = kit_below(anchor + kit_below(low - slack));
    *hi = kit_above(anchor + kit_above(high + slack));
}

bool kit_frustum_bounds(const void *self, pov_box *out)
{
    const kit_frustum *s = self;
    const pov_vec3 *c = s->column;

    extend(s, s->anchor.x.hi, c[0].x, c[1].x, c[2].x, &out->lo.x, &out->hi.x);
    extend(s, s->anchor.y.hi, c[0].y, c[1].y, c[2].y, &out->lo.y, &out->hi.y);
    extend(s, s->anchor.z.hi, c[0].z, c[1].z, c[2].z, &out->lo.z, &out->hi.z);
    return true;
}

static pov_two3 times_vector(const pov_two3 rows[3], pov_two3 w)
{
    pov_two3 p;

    p.x = pov_two3_dot(rows[0], w);
    p.y = pov_two3_dot(rows[1], w);
    p.z = pov_two3_dot(rows[2], w);
    return p;
}

/* The new rows are the old ones times the inverse map. An affine map of any shape can be taken in; one that is far
 * from keeping angles would cost precision in the products, unless it is axial. */
bool kit_frustum_absorb(void *self, const pov_affine *map)
{
    kit_frustum *s = self;
    pov_two3 inverse[3], columns[3], rows[3];
    int axis[3], i;

    if (!(kit_condition(map) < 1024.0) && !kit_is_axial(map, axis))
        return false;
    kit_inverse_linear(map, inverse);
    columns[0].x = inverse[0].x, columns[0].y = inverse[1].x, columns[0].z = inverse[2].x;
    columns[1].x = inverse[0].y, columns[1].y = inverse[1].y, columns[1].z = inverse[2].y;
    columns[2].x = inverse[0].z, columns[2].y = inverse[1].z, columns[2].z = inverse[2].z;
    s->anchor = kit_map_point(map, s->anchor);
    kit_linear(map, rows);
    s->axis = times_vector(rows, s->axis);
    for (i = 0; i < 3; i++) {
        const pov_two3 row = s->row[i];
        const pov_vec3 c = s->column[i];

        s->row[i].x = pov_two3_dot(row, columns[0]);
        s->row[i].y = pov_two3_dot(row, columns[1]);
        s->row[i].z = pov_two3_dot(row, columns[2]);
        s->column[i] = pov_sub(pov_affine_point(map, c), pov_affine_point(map, pov_vec3_of(0.0, 0.0, 0.0)));
    }
    if (!s->empty)
        normalise(s);
    return true;
}

/* ---- in two parts ---- */

static pov_two3 to_local(const kit_frustum *s, pov_two3 w) { return times_vector(s->row, w); }

/* o + o_lo - anchor + t (d + d_lo) - y axis, rounded once. */
static pov_two exact_offset(double o, double o_lo, pov_two anchor, double t, double d, double d_lo, double y, pov_two axis)
{
    kit_expansion e;
    pov_two sum = { 0.0, 0.0 };
    int i;

    kit_expansion_clear(&e);
    kit_expansion_add(&e, o);
    kit_expansion_add(&e, o_lo);
    kit_expansion_add(&e, -anchor.hi);
    kit_expansion_add(&e, -anchor.lo);
    kit_expansion_add_product(&e, t, d);
    kit_expansion_add_product(&e, t, d_lo);
    kit_expansion_add_product(&e, -y, axis.hi);
    kit_expansion_add_product(&e, -y, axis.lo);
    for (i = 0; i < e.count; i++)
        sum = pov_two_add_double(sum, e.part[i]);
    return sum;
}

/* The ray's point at t. On a slender shape even two parts of a length would leave little of a width, so there the part
 * along the axis is taken away first, without any error. */
static pov_two3 local_along(const kit_frustum *s, const kit_ray *k, const pov_ray *ray, double t)
{
    pov_two3 w = kit_along_two(k, t), p;
    double y, along = t * k->unit;

    if (!s->slender)
        return to_local(s, w);
    y = pov_two3_dot(s->row[2], w).hi / s->height.hi;
    w.x = exact_offset(ray->org.x, ray->org_lo.x, s->anchor.x, along, ray->dir.x, ray->dir_lo.x, y, s->axis.x);
    w.y = exact_offset(ray->org.y, ray->org_lo.y, s->anchor.y, along, ray->dir.y, ray->dir_lo.y, y, s->axis.y);
    w.z = exact_offset(ray->org.z, ray->org_lo.z, s->anchor.z, along, ray->dir.z, ray->dir_lo.z, y, s->axis.z);
    p = to_local(s, scaled(w, s->scale));
    p.z = pov_two_add(p.z, pov_two_mul_double(s->height, y));
    return p;
}

static pov_two radius_at(const kit_frustum *s, pov_two z) { return pov_two_add(s->radius, pov_two_mul(s->slope, z)); }

/* a b + c d */
static pov_two sum2(pov_two a, pov_two b, pov_two c, pov_two d)
{
    return pov_two_add(pov_two_mul(a, b), pov_two_mul(c, d));
}

/* Where the ray is within something convex: from lo to hi, either of which may be endless. */
typedef struct span {
    bool empty, from_ever, for_ever;
    pov_two lo, hi;
    uint32_t lo_part, hi_part;
} span;

/* A ray nearly along the side moves hardly at all across it, so much less at times that squares underflow: it is
 * followed faster by `power`. */
static double quicken(pov_two3 *d, pov_two *grow)
{
    const double power = pov_inverse_power(pov_largest(pov_vec3_of(d->x.hi, d->y.hi, grow->hi)));

    *d = scaled(*d, power);
    *grow = pov_two_scale(*grow, power);
    return power;
}

static span side_span(const kit_frustum *s, pov_two3 w, pov_two3 d)
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
    if (a.hi > 0.0 && sum2(r, a, pov_two_neg(grow), b).hi < 0.0)
        return out;     /* the other half of a double cone */
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

static span slab_span(const kit_frustum *s, pov_two z, pov_two dz)
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
        out.lo_part = CAP_TOP;
        out.hi_part = CAP_BASE;
    }
    return out;
}

/* Capped: where side and slab are both around the ray. */
static span meet(span a, span b)
{
    if (a.empty || b.empty) {
        a.empty = true;
        return a;
    }
    if (a.from_ever || (!b.from_ever && pov_two_less(a.lo, b.lo))) {
        a.from_ever = b.from_ever;
        a.lo = b.lo;
        a.lo_part = b.lo_part;
    }
    if (a.for_ever || (!b.for_ever && pov_two_less(b.hi, a.hi))) {
        a.for_ever = b.for_ever;
        a.hi = b.hi;
        a.hi_part = b.hi_part;
    }
    return a;
}

static bool within(span slab, pov_two t)
{
    return !slab.empty && (slab.from_ever || !pov_two_less(t, slab.lo)) && (slab.for_ever || !pov_two_less(slab.hi, t));
}

static leaving leaving_of(const kit_frustum *s, const kit_ray *k, pov_two3 d, uint32_t part)
{
    pov_two3 f;
    double outward;

    if (part == CAP_BASE)
        return d.z.hi > 0.0 ? INWARD : OUTWARD;
    if (part == CAP_TOP)
        return d.z.hi < 0.0 ? INWARD : OUTWARD;
    f = to_local(s, k->f);
    outward = pov_two_sub(sum2(f.x, d.x, f.y, d.y), pov_two_mul(pov_two_mul(s->slope, d.z), radius_at(s, f.z))).hi;
    return outward < 0.0 ? INWARD : OUTWARD;
}

/* How much further along the ray a root lies that is much nearer to the apex than w is; 0 for none. */
static double to_apex(const kit_frustum *s, const span *side, pov_two3 w, pov_two3 d)
{
    const double r = s->radius.hi + s->slope.hi * w.z.hi, grow = s->slope.hi * d.z.hi;
    const double at_lo = side->from_ever ? HUGE_VAL : fabs(r + grow * side->lo.hi);
    const double at_hi = side->for_ever ? HUGE_VAL : fabs(r + grow * side->hi.hi);
    const double there = at_lo < at_hi ? side->lo.hi : side->hi.hi;

    return !side->empty && fmin(at_lo, at_hi) < 0x1p-4 * fabs(r) && isfinite(there) ? there : 0.0;
}

static void decide(const kit_frustum *s, const kit_ray *k, const pov_ray *ray, double middle, pov_hits *hits)
{
    const pov_two3 d = to_local(s, kit_direction(k));
    const leaving way = ray->left == hits->owner ? leaving_of(s, k, d, ray->left_mark.part) : NOT_LEAVING;
    pov_two3 w = local_along(s, k, ray, middle);
    span side = side_span(s, w, d), slab, both;
    double further;
    bool in, out;

    hits->decided++;
    /* Close to the apex everything is small; seen from further off it would be small differences. */
    further = to_apex(s, &side, w, d);
    if (further != 0.0 && s->slope.hi != 0.0) {
        middle += further;
        w = local_along(s, k, ray, middle);
        side = side_span(s, w, d);
    }
    slab = slab_span(s, w.z, d.z);
    both = s->open ? side : meet(side, slab);
    if (both.empty)
        return;
    in = way != INWARD && !both.from_ever;
    out = way != OUTWARD && !both.for_ever;
    if (s->open) {
        in = in && within(slab, both.lo);
        out = out && within(slab, both.hi);
    } else if (way == NOT_LEAVING && pov_two_less(both.hi, both.lo)) {
        return;
    }
    if (in && !kit_report_decided(hits, pov_two_add_double(both.lo, middle), k->unit, both.lo_part))
        return;
    if (out)
        kit_report_decided(hits, pov_two_add_double(both.hi, middle), k->unit, both.hi_part);
}

/* ---- in double, with bounds ---- */

typedef struct bounded { double v, e; } bounded;   /* the exact value is within e of v */

static inline bounded bounded_of(double v, double e) { bounded b; b.v = v; b.e = e; return b; }

/* A row times a vector that is off by a rounding itself: six roundings in all. */
static inline bounded row_times(const pov_two3 *row, pov_vec3 w)
{
    const double x = row->x.hi * w.x, y = row->y.hi * w.y, z = row->z.hi * w.z;

    return bounded_of(x + y + z, 7.0 * KIT_U * (fabs(x) + fabs(y) + fabs(z)));
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

/* The sign is certain: not even a bound twice as wide could turn it, which also pays for the bound's own roundings. */
static inline bool is_certain(bounded a) { return fabs(a.v) > 2.0 * a.e; }

/* The same as span, in double. */
typedef struct rough_span {
    bool empty, from_ever, for_ever;
    bounded lo, hi;
    uint32_t lo_part, hi_part;
} rough_span;

typedef struct rough { bounded x, y, z, dx, dy, dz, r, grow; } rough;

static bool rough_side(const kit_frustum *s, const rough *g, rough_span *out)
{
    const bounded p = minus(times(g->r, g->dx), times(g->grow, g->x)), q = minus(times(g->r, g->dy), times(g->grow, g->y));
    const bounded x = minus(times(g->x, g->dy), times(g->y, g->dx));
    const bounded a = minus(plus(times(g->dx, g->dx), times(g->dy, g->dy)), times(g->grow, g->grow));
    const bounded b = minus(plus(times(g->x, g->dx), times(g->y, g->dy)), times(g->r, g->grow));
    const bounded c = minus(plus(times(g->x, g->x), times(g->y, g->y)), times(g->r, g->r));
    const bounded discriminant = minus(plus(times(p, p), times(q, q)), times(x, x));
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
    return (slab->from_ever || !is_before(t, slab->lo, certain)) && (slab->for_ever || !is_before(slab->hi, t, certain));
}

static leaving rough_leaving(const kit_frustum *s, const kit_ray *k, const rough *g, uint32_t part, bool *certain)
{
    const pov_vec3 f = pov_two3_hi(k->f);
    bounded x, y, z, outward;

    if (part >= CAP_BASE) {
        *certain = *certain && (is_certain(g->dz) || (g->dz.v == 0.0 && g->dz.e == 0.0));
        return (part == CAP_BASE ? g->dz.v > 0.0 : g->dz.v < 0.0) ? INWARD : OUTWARD;
    }
    x = row_times(&s->row[0], f);
    y = row_times(&s->row[1], f);
    z = row_times(&s->row[2], f);
    z = plus(bounded_of(s->radius.hi, KIT_U), times(bounded_of(s->slope.hi, KIT_U * fabs(s->slope.hi)), z));
    outward = minus(plus(times(x, g->dx), times(y, g->dy)), times(g->grow, z));
    *certain = *certain && is_certain(outward);
    return outward.v < 0.0 ? INWARD : OUTWARD;
}

/* How far off a crossing may be for a normal within 1e-13: a part of the radius there. */
static double fine_at(const rough *g, bounded t, uint32_t part)
{
    const double speed = fabs(g->dx.v) + fabs(g->dy.v) + fabs(g->dz.v);

    return KIT_FINE * (part >= CAP_BASE ? 1.0 : fabs(g->r.v + t.v * g->grow.v)) / speed;
}

static inline kit_root root_of(double middle, bounded t, uint32_t part)
{
    kit_root r;

    r.t = pov_two_sum(middle, t.v);
    r.error = t.e;
    r.part = part;
    return r;
}

static bool quick(const kit_frustum *s, const kit_ray *k, const pov_ray *ray, const rough *g, double middle, pov_hits *hits)
{
    rough_span side, slab, both;
    leaving way = NOT_LEAVING;
    bool certain = true, in, out;
    kit_root roots[2];
    double fine = HUGE_VAL;
    uint32_t n = 0;

    if (!rough_slab(s, g, &slab))
        return false;
    if (slab.empty)
        return true;
    if (!rough_side(s, g, &side))
        return false;
    if (side.empty)
        return true;
    if (ray->left == hits->owner)
        way = rough_leaving(s, k, g, ray->left_mark.part, &certain);
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
    if (in) {
        roots[n++] = root_of(middle, both.lo, both.lo_part);
        fine = fine_at(g, both.lo, both.lo_part);
    }
    if (out) {
        roots[n++] = root_of(middle, both.hi, both.hi_part);
        fine = fmin(fine, fine_at(g, both.hi, both.hi_part));
    }
    return kit_report(roots, n, k->unit, fine, hits);
}

void kit_frustum_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const kit_frustum *s = self;
    const kit_ray k = kit_enter(ray, s->anchor, s->scale);
    const pov_vec3 f = pov_two3_hi(k.f);
    double middle;
    pov_vec3 w;
    rough g;

    if (s->empty)
        return;
    g.dx = row_times(&s->row[0], k.d);
    g.dy = row_times(&s->row[1], k.d);
    g.dz = row_times(&s->row[2], k.d);
    /* Closest approach to the middle of the axis, in local lengths. Any point near the shape would do. */
    middle = -(row_times(&s->row[0], f).v * g.dx.v + row_times(&s->row[1], f).v * g.dy.v
               + (row_times(&s->row[2], f).v - 0.5 * s->height.hi) * g.dz.v)
             / (g.dx.v * g.dx.v + g.dy.v * g.dy.v + g.dz.v * g.dz.v);
    w = kit_along(&k, middle);
    g.x = row_times(&s->row[0], w);
    g.y = row_times(&s->row[1], w);
    g.z = row_times(&s->row[2], w);
    g.r = plus(bounded_of(s->radius.hi, KIT_U * s->radius.hi),
               times(bounded_of(s->slope.hi, KIT_U * fabs(s->slope.hi)), g.z));
    g.grow = times(bounded_of(s->slope.hi, KIT_U * fabs(s->slope.hi)), g.dz);
    if (hits->always_exact || !(pov_largest(f) < KIT_FAR) || !quick(s, &k, ray, &g, middle, hits))
        decide(s, &k, ray, middle, hits);
}

void kit_frustum_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const kit_frustum *s = self;
    const kit_ray k = kit_enter(ray, s->anchor, s->scale);
    const pov_two3 p = to_local(s, kit_point(&k, at));
    const pov_two z = pov_two_neg(pov_two_mul(s->slope, radius_at(s, p.z)));
    pov_two3 n;

    if (at->mark.part >= CAP_BASE || (p.x.hi == 0.0 && p.y.hi == 0.0)) {
        *out = pov_scale(pov_unit(pov_two3_hi(s->row[2])), at->mark.part == CAP_BASE ? -1.0 : 1.0);
        return;
    }
    n.x = pov_two_add(sum2(p.x, s->row[0].x, p.y, s->row[1].x), pov_two_mul(z, s->row[2].x));
    n.y = pov_two_add(sum2(p.x, s->row[0].y, p.y, s->row[1].y), pov_two_mul(z, s->row[2].y));
    n.z = pov_two_add(sum2(p.x, s->row[0].z, p.y, s->row[1].z), pov_two_mul(z, s->row[2].z));
    *out = pov_unit(pov_two3_hi(n));
}

bool kit_frustum_inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const kit_frustum *s = self;
    const pov_two3 p = to_local(s, kit_offset(point, point_lo, s->anchor, s->scale));
    const pov_two r = radius_at(s, p.z);

    return !s->empty && p.z.hi > 0.0 && pov_two_less(p.z, s->height)
           && pov_two_less(sum2(p.x, p.x, p.y, p.y), pov_two_mul(r, r));
}
