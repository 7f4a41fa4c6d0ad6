/* disc { <centre>, <normal>, radius [, hole] }: a flat ring, without a hole if none is given.
 *
 * A whole primitive against the installed headers alone; docs/plugins.md explains it part by part. It
 * calculates in double-double throughout, the shortest way to a right answer. A filter in plain double in
 * front of that would make it faster. */
#include <povtrace/exact.h>
#include <povtrace/shape.h>

typedef struct disc {
    pov_vec3 centre, normal;       /* normal: unit */
    double radius, hole;
    double scale;                  /* a power of two: times this, the radius is in [1, 2) */
    pov_two outer, inner;          /* the squares of the scaled radii */
    pov_two3 across;               /* the normal as written, times a power of two: rounding it would move the plane */
} disc;

/* ---- loading ---- */

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    disc *d = self;
    pov_vec3 normal;

    host->vector(in, &d->centre);
    host->accept(in, ",");
    host->vector(in, &normal);
    d->normal = pov_unit(normal);
    if (!(pov_largest(d->normal) > 0.0))
        host->fail(in, "the normal of a disc must have a direction");
    host->accept(in, ",");
    d->radius = host->number(in);
    if (d->radius < 0.0) {
        host->warn(in, "a negative radius is taken as positive");
        d->radius = -d->radius;
    }
    if (host->accept(in, ","))
        d->hole = host->number(in);
    if (d->hole < 0.0 || d->hole > d->radius)
        host->fail(in, "the hole of a disc must be smaller than the disc");
    d->across = pov_two3_of(pov_scale(normal, pov_inverse_power(pov_largest(normal))), zero);
    d->scale = pov_inverse_power(d->radius);
    d->outer = pov_two_product(d->radius * d->scale, d->radius * d->scale);
    d->inner = pov_two_product(d->hole * d->scale, d->hole * d->scale);
}

/* Half the extent along an axis: the radius times the sine of the normal's angle to it. The last factor is
 * far larger than what the few roundings here can lose. */
static double reach(double radius, double a, double b)
{
    return radius * sqrt(a * a + b * b) * (1.0 + 0x1p-48);
}

static bool bounds(const void *self, pov_box *out)
{
    const disc *d = self;
    const pov_vec3 n = d->normal, r = pov_vec3_of(reach(d->radius, n.y, n.z), reach(d->radius, n.x, n.z),
                                                  reach(d->radius, n.x, n.y));
    const pov_vec3 lo = pov_sub(d->centre, r), hi = pov_add(d->centre, r);

    out->lo = pov_vec3_of(nextafter(lo.x, -HUGE_VAL), nextafter(lo.y, -HUGE_VAL), nextafter(lo.z, -HUGE_VAL));
    out->hi = pov_vec3_of(nextafter(hi.x, HUGE_VAL), nextafter(hi.y, HUGE_VAL), nextafter(hi.z, HUGE_VAL));
    return true;
}

/* ---- rays ---- */

/* One coordinate of the ray's origin relative to the centre, scaled. */
static pov_two offset(const disc *d, double org, double org_lo, double centre)
{
    return pov_two_scale(pov_two_offset(org, org_lo, pov_two_of(centre, 0.0)), d->scale);
}

static pov_two3 along(pov_two3 from, double t, pov_two3 dir)
{
    pov_two3 p;

    p.x = pov_two_along(from.x, t, dir.x.hi, dir.x.lo);
    p.y = pov_two_along(from.y, t, dir.y.hi, dir.y.lo);
    p.z = pov_two_along(from.z, t, dir.z.hi, dir.z.lo);
    return p;
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const disc *d = self;
    const double power = pov_inverse_power(pov_largest(ray->dir)), unit = power / d->scale;
    const pov_two3 dir = pov_two3_of(pov_scale(ray->dir, power), pov_scale(ray->dir_lo, power));
    const pov_two slope = pov_two3_dot(d->across, dir);
    const pov_mark mark = { 0, 0, 0.0, 0.0 };
    pov_two3 from, point;
    pov_two t, rest, square;

    /* The disc is flat: a ray that starts on it never meets it again. */
    if (ray->origin_surface == hits->owner || slope.hi == 0.0)
        return;
    from.x = offset(d, ray->org.x, ray->org_lo.x, d->centre.x);
    from.y = offset(d, ray->org.y, ray->org_lo.y, d->centre.y);
    from.z = offset(d, ray->org.z, ray->org_lo.z, d->centre.z);
    /* One division leads near the plane; solved again about that point, the equation gives what is missing. */
    t = pov_two_of(-pov_two3_dot(d->across, from).hi / slope.hi, 0.0);
    point = along(from, t.hi, dir);
    rest = pov_two_neg(pov_two_div(pov_two3_dot(d->across, point), slope));
    t = pov_two_add(t, rest);
    point = along(point, rest.hi, dir);
    square = pov_two3_dot(point, point);
    if (pov_two_less(d->outer, square) || pov_two_less(square, d->inner) || !isfinite(t.hi * unit))
        return;
    pov_cross(hits, t.hi * unit, t.lo * unit, mark);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)ray;
    (void)at;
    *out = ((const disc *)self)->normal;
}

/* ---- what the host sees ---- */

static const pov_shape_class disc_class = {
    .size = sizeof(pov_shape_class),
    .keyword = "disc",
    .instance_size = sizeof(disc),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
};

static const pov_shape_class *const shapes[] = { &disc_class, NULL };

POV_PLUGIN(disc) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "disc",
    .version = "1",
    .shapes = shapes,
};
