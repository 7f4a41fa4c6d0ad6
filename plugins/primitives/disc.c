/* disc { <centre>, <normal>, radius [, hole] }: a flat ring, without a hole if none is given. Its rim does not belong to
 * it, the rim of its hole does.
 *
 * As a solid it is the half-space behind it, of whose plane only the ring is seen. */
#include "common/lanes.h"
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
COMMON_INLINE double judge_ring(const disc *d, const common_ray *k, const common_root *root, double first, pov_vec3 w)
{
    const pov_vec3 p = pov_add(w, pov_scale(k->d, root->t.hi - first));
    const double square = pov_dot(p, p), size = pov_largest(p) + pov_largest(w);
    const double off = 4.0 * root->error + 8.0 * COMMON_U * size + common_far_slack(k);
    const double error = 4.0 * size * off + 4.0 * off * off + 8.0 * COMMON_U * (square + d->outer.hi);
    const int is_off = (int)(square - error > d->outer.hi) | (int)(square + error < d->inner.hi);
    const int is_on = (int)(square + error < d->outer.hi) & (int)(square - error > d->inner.hi);

    return !(error < HUGE_VAL) ? 0.0 : is_off ? -1.0 : is_on ? 1.0 : 0.0;
}

/* Where a ray crosses the plane, a first quotient of that, and whether on the ring. */
typedef struct plane_hit { common_root root; double first, ring; } plane_hit;

COMMON_INLINE plane_hit look(const disc *d, const common_ray *k)
{
    const pov_vec3 n = pov_two3_hi(d->across);
    const double slope = pov_dot(n, k->d), first = -pov_dot(n, pov_two3_hi(k->f)) / slope;
    const pov_vec3 w = common_along(k, first);
    const common_root root = common_polygon_distance(n, k, slope, 6.0 * COMMON_U * common_sum_of_sizes(n, k->d), first, w);

    return (plane_hit){ root, first, judge_ring(d, k, &root, first, w) };
}

static void report(pov_hits *hits, double unit, pov_two t, bool escalated)
{
    const uint32_t flags = POV_MARK_OUTWARD | (escalated ? POV_MARK_ESCALATED : 0);

    if (isfinite(t.hi * unit))
        pov_cross(hits, t.hi * unit, t.lo * unit, common_mark(0, flags));
}

/* False: it is left open. */
static bool is_answered(const common_root *root, double unit, double ring, pov_hits *hits)
{
    const common_verdict verdict = common_judge(root, unit, COMMON_FINE, hits);
    const bool crosses = ring > 0.0 && verdict == COMMON_GOOD && !hits->always_exact;

    if (verdict == COMMON_OUTSIDE || (ring < 0.0 && !hits->always_exact))
        return true;
    if (crosses)
        report(hits, unit, root->t, false);
    return crosses;
}

/* A flat shape is never hit again by a ray that starts on it. */
static bool is_passed(const disc *d, const pov_ray *ray, const pov_hits *hits) { return !d->seen || ray->origin_surface == hits->owner; }

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const disc *d = self;
    common_ray k;
    plane_hit at;
    pov_two t;

    if (is_passed(d, ray, hits))
        return;
    k = common_enter(ray, d->centre, d->scale);
    at = look(d, &k);
    if (is_answered(&at.root, k.unit, at.ring, hits))
        return;
    t = escalate_distance(d, &k, at.first);
    hits->escalated++;
    if (is_on_ring(d, &k, t))
        report(hits, k.unit, t, true);
}

/* ---- several rays ---- */

typedef struct hit_lanes { common_lane t, t_lo, error, unit, ring; } hit_lanes;

COMMON_CLONES static void look_in_lanes(const disc *restrict d, const common_rays *restrict rays, hit_lanes *restrict out)
{
    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        const pov_ray ray = common_get_ray(rays, i);
        const common_ray k = common_enter(&ray, d->centre, d->scale);
        const plane_hit at = look(d, &k);

        out->t[i] = at.root.t.hi;
        out->t_lo[i] = at.root.t.lo;
        out->error[i] = at.root.error;
        out->unit[i] = k.unit;
        out->ring[i] = at.ring;
    }
}

/* Most are rays of one disc. */
static void intersect_lanes(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    const disc *const d = selves[0];
    common_rays of;
    hit_lanes l;

    for (uint32_t i = 0; i < COMMON_LANES; i += 4)
        common_put_four_of(&of, i, rays, n);
    look_in_lanes(d, &of, &l);
    for (uint32_t i = 0; i < n; i++) {
        const common_root root = { { l.t[i], l.t_lo[i] }, l.error[i], 0, 0 };

        if (selves[i] != d || is_passed(d, rays[i], hits[i]) || !is_answered(&root, l.unit[i], l.ring[i], hits[i]))
            intersect(selves[i], rays[i], hits[i]);
    }
}

static void intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    common_intersect_pairs(selves, rays, hits, n, intersect_lanes, intersect);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)ray;
    (void)at;
    *out = ((const disc *)self)->normal;
}

static const pov_shape_fast disc_fast = {
    .size = sizeof(pov_shape_fast),
    .intersect_many = intersect_many,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &disc_fast : NULL; }

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
    .extension = extension,
};

static const pov_shape_class *const shapes[] = { &disc_class, NULL };

POV_PLUGIN(disc) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "disc",
    .version = "1",
    .shapes = shapes,
};
