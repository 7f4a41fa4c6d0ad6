/* disc { <centre>, <normal>, radius [, hole] }: a flat ring, without a hole if none is given. Its rim does not belong to
 * it, the rim of its hole does.
 *
 * As a solid it is the half-space behind it, of whose plane only the ring is seen. */
#include "common/polygon.h"
#include "common/radius.h"

typedef struct disc {
    pov_two3 centre, across;       /* across: the normal as written, times a power of two */
    pov_two outer, inner;          /* the squares of the scaled radii */
    double scale;                  /* a power of two: times this, the radius is in [1, 2) */
    double radius;
    pov_vec3 normal;               /* unit */
    bool seen;
} disc;

/* ---- loading ---- */

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    disc *d = self;
    pov_vec3 centre, normal;
    double hole = 0.0;

    host->vector(in, &centre);
    host->accept(in, ",");
    host->vector(in, &normal);
    host->accept(in, ",");
    d->radius = common_radius(host, in);
    host->accept(in, ",");
    if (host->more(in))
        hole = common_radius(host, in);
    d->centre = pov_two3_of(centre, zero);
    d->normal = pov_unit(normal);
    d->across = pov_two3_of(pov_scale(normal, pov_inverse_power(pov_largest(normal))), zero);
    d->scale = pov_inverse_power(d->radius);
    d->outer = pov_two_product(d->radius * d->scale, d->radius * d->scale);
    d->inner = pov_two_product(hole * d->scale, hole * d->scale);
    d->seen = pov_largest(d->normal) > 0.0 && hole < d->radius;
    if (!d->seen)
        host->warn(in, hole < d->radius ? "the normal of this disc has no direction: it is not seen"
                                        : "the hole of this disc is as large as the disc: it is not seen");
}

/* Half the extent along an axis: the radius times the sine of the normal's angle to it. The factor is far larger than
 * what the few roundings here can lose. */
static double reach(double radius, double a, double b) { return radius * sqrt(a * a + b * b) * (1.0 + 0x1p-48); }

static bool bounds(const void *self, pov_box *out)
{
    const disc *d = self;
    const pov_vec3 n = d->normal, c = pov_two3_hi(d->centre);
    const pov_vec3 r = pov_vec3_of(reach(d->radius, n.y, n.z), reach(d->radius, n.x, n.z), reach(d->radius, n.x, n.y));

    out->lo = pov_vec3_of(common_below(c.x - r.x), common_below(c.y - r.y), common_below(c.z - r.z));
    out->hi = pov_vec3_of(common_above(c.x + r.x), common_above(c.y + r.y), common_above(c.z + r.z));
    return true;
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const disc *d = self;

    return pov_two3_dot(d->across, common_offset(point, point_lo, d->centre, d->scale)).hi < 0.0;
}

/* Beyond the rim and in the hole a ray comes in without a crossing. */
static bool open(const void *self)
{
    (void)self;
    return true;
}

/* ---- rays ---- */

/* The crossing with the plane, in double-double. */
static pov_two escalate_distance(const disc *d, const common_ray *k, double first)
{
    const pov_two slope = pov_two3_dot(d->across, common_direction(k));
    const pov_two height = pov_two3_dot(d->across, isfinite(first) ? common_along_two(k, first) : k->f);
    const pov_two t = pov_two_neg(pov_two_div(height, slope));

    return isfinite(first) ? pov_two_add_double(t, first) : t;
}

static bool is_on_ring(const disc *d, const common_ray *k, pov_two t)
{
    const pov_two3 p = common_along_dd(k, t);
    const pov_two square = pov_two3_dot(p, p);

    return pov_two_less(square, d->outer) && !pov_two_less(square, d->inner);
}

/* 1: certainly on the ring; -1: certainly not; 0: undecided. The point is off by the error of the distance along a
 * direction shorter than 4, its own rounding and that of the ray's far start; its square by twice that of its length. */
static int judge_ring(const disc *d, const common_ray *k, const common_root *root, double first, pov_vec3 w)
{
    const pov_vec3 p = pov_add(w, pov_scale(k->d, root->t.hi - first));
    const double square = pov_dot(p, p), size = pov_largest(p) + pov_largest(w);
    const double off = 4.0 * root->error + 8.0 * COMMON_U * size + common_far_slack(k);
    const double error = 4.0 * size * off + 4.0 * off * off + 8.0 * COMMON_U * (square + d->outer.hi);

    if (!(error < HUGE_VAL))
        return 0;
    if (square - error > d->outer.hi || square + error < d->inner.hi)
        return -1;
    return square + error < d->outer.hi && square - error > d->inner.hi;
}

static void report(pov_hits *hits, const common_ray *k, pov_two t, bool escalated)
{
    const uint32_t flags = POV_MARK_OUTWARD | (escalated ? POV_MARK_ESCALATED : 0);

    if (isfinite(t.hi * k->unit))
        pov_cross(hits, t.hi * k->unit, t.lo * k->unit, common_mark(0, flags));
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const disc *d = self;
    const pov_vec3 n = pov_two3_hi(d->across);
    common_verdict verdict;
    common_root root;
    common_ray k;
    double slope, first;
    pov_vec3 w;
    int ring;

    if (!d->seen || ray->origin_surface == hits->owner)   /* a flat shape is never met again */
        return;
    k = common_enter(ray, d->centre, d->scale);
    slope = pov_dot(n, k.d);
    first = -pov_dot(n, pov_two3_hi(k.f)) / slope;
    w = common_along(&k, first);
    root = common_polygon_distance(n, &k, slope, 6.0 * COMMON_U * common_sum_of_sizes(n, k.d), first, w);
    verdict = common_judge(&root, k.unit, COMMON_FINE, hits);
    if (verdict == COMMON_OUTSIDE)
        return;
    ring = hits->always_exact ? 0 : judge_ring(d, &k, &root, first, w);
    if (ring < 0)
        return;
    if (ring > 0 && verdict == COMMON_GOOD) {
        report(hits, &k, root.t, false);
        return;
    }
    root.t = escalate_distance(d, &k, first);
    hits->escalated++;
    if (is_on_ring(d, &k, root.t))
        report(hits, &k, root.t, true);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)ray;
    (void)at;
    *out = ((const disc *)self)->normal;
}

static const pov_shape_class disc_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_CONVEX | POV_SHAPE_FACETED | POV_SHAPE_CERTIFIED | POV_SHAPE_ENDLESS,
    .keyword = "disc",
    .instance_size = sizeof(disc),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .open = open,
};

static const pov_shape_class *const shapes[] = { &disc_class, NULL };

POV_PLUGIN(disc) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "disc",
    .version = "1",
    .shapes = shapes,
};
