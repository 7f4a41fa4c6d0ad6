/* sphere { <centre>, radius }
 *
 * The ray is re-centred at its closest approach to the centre, where the roots are as large as the sphere
 * and not as the distance. docs/numerics.md derives the bounds. */
#include "kit/affine.h"
#include "kit/report.h"
#include "kit/simd.h"

/* A line of memory: what intersect() wants besides is made from these two as fast as it is fetched. */
typedef struct sphere {
    pov_two3 centre;
    pov_two radius;
} sphere;

typedef struct sphere_text { pov_vec3 centre; double radius; } sphere_text;

/* Lengths times this, a power of two, bring the radius into [1, 2). */
static inline double scale_of(const sphere *s) { return pov_inverse_power(s->radius.hi); }

/* The square of the scaled radius. */
static inline pov_two square_of(const sphere *s)
{
    pov_two r = pov_two_scale(s->radius, scale_of(s));
    return pov_two_mul(r, r);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    sphere_text *text = self;
    pov_vec3 centre;
    double radius;

    host->vector(in, &centre);
    host->accept(in, ",");
    if (host->more(in)) {
        radius = host->number(in);
    } else if (centre.x != centre.y || centre.y != centre.z) {
        radius = host->number(in);   /* fails: what was read is a centre */
    } else {
        host->warn(in, "a sphere without a centre stands about the origin");
        radius = centre.x;
        centre = zero;
    }
    if (radius < 0.0) {
        host->warn(in, "a negative radius is taken as positive");
        radius = -radius;
    }
    text->centre = centre;
    text->radius = radius;
}

static void prepare(void *self, const void *written)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const sphere_text *text = written;
    sphere *s = self;

    s->centre = pov_two3_of(text->centre, zero);
    s->radius = pov_two_of(text->radius, 0.0);
}

static void interval(pov_two centre, pov_two radius, double *lo, double *hi)
{
    *lo = kit_below(pov_two_sub(centre, radius).hi);
    *hi = kit_above(pov_two_add(centre, radius).hi);
}

static bool bounds(const void *self, pov_box *out)
{
    const sphere *s = self;

    interval(s->centre.x, s->radius, &out->lo.x, &out->hi.x);
    interval(s->centre.y, s->radius, &out->lo.y, &out->hi.y);
    interval(s->centre.z, s->radius, &out->lo.z, &out->hi.z);
    return true;
}

/* Roots that are wanted, as bits. A ray that left the sphere started on one of its two roots: going
 * outward on the far one, going inward on the near one. */
enum { NEAR_ROOT = 1, FAR_ROOT = 2 };

/* Two-part arithmetic from the start. */
static void decide(pov_two square, const kit_ray *k, bool leaving, pov_hits *hits)
{
    pov_two3 d = kit_direction(k), w;
    pov_two a = pov_two3_dot(d, d), fd = pov_two3_dot(k->f, d), b, discriminant, root;
    double middle = -fd.hi / a.hi;
    uint32_t wanted = !leaving ? NEAR_ROOT | FAR_ROOT : fd.hi < 0.0 ? FAR_ROOT : NEAR_ROOT;

    hits->decided++;
    w = kit_along_two(k, middle);
    b = pov_two3_dot(w, d);
    discriminant = pov_two_add(pov_two_mul(b, b), pov_two_mul(a, pov_two_sub(square, pov_two3_dot(w, w))));
    if (!(discriminant.hi >= 0.0))
        return;
    root = pov_two_sqrt(discriminant);
    if (wanted & NEAR_ROOT) {
        pov_two t = pov_two_add_double(pov_two_neg(pov_two_div(pov_two_add(b, root), a)), middle);
        if (!kit_report_decided(hits, t, k->unit, 0))
            return;
    }
    if (wanted & FAR_ROOT)
        kit_report_decided(hits, pov_two_add_double(pov_two_div(pov_two_sub(root, b), a), middle), k->unit, 1);
}

static kit_residual residual(const void *self, const kit_ray *k, pov_two3 w, uint32_t part)
{
    const pov_two *square = self;
    kit_residual r;

    (void)part;
    r.value = pov_two_sub(pov_two3_dot(w, w), *square).hi;
    r.error = 0x1p-100 * square->hi;
    r.half_slope = pov_dot(pov_two3_hi(w), k->d);
    r.slope_error = 6.0 * KIT_U * kit_sum_of_sizes(pov_two3_hi(w), k->d);
    return r;
}

/* Double precision with a bound on its error. False: open. */
static bool quick(pov_two square, const kit_ray *k, bool leaving, pov_hits *hits)
{
    const double u = KIT_U;
    pov_vec3 f = pov_two3_hi(k->f), w;
    double a = pov_dot(k->d, k->d), inverse = 1.0 / a, fd = pov_dot(f, k->d), middle = -fd * inverse;
    double ww, b, b_error, c, c_error, d, d_error;
    double root, error;
    kit_equation equation = { &square, k, residual, 0.0 };
    kit_root roots[2];
    uint32_t first = 0, n = 2;

    if (leaving) {
        if (!(fabs(fd) > 8.0 * u * kit_sum_of_sizes(f, k->d)))
            return false;
        /* Outward, the other root is behind. */
        if (fd > 0.0 && hits->tmin >= 0.0)
            return true;
        first = fd < 0.0;
        n = 1;
    }
    if (!(pov_largest(f) < KIT_FAR))
        return false;
    w = kit_along(k, middle);
    ww = pov_dot(w, w);
    b = pov_dot(w, k->d);
    c = square.hi - ww;
    b_error = 10.0 * u * kit_sum_of_sizes(w, k->d) + u * u * a;
    c_error = u * (square.hi + 6.0 * ww);
    d = c * a + b * b;
    d_error = c_error * a + 2.0 * fabs(b) * b_error + b_error * b_error;
    if (d < -(d_error + 10.0 * u * fabs(d)))
        return true;
    if (!(d > 16.0 * d_error))
        return false;
    root = sqrt(d);
    error = (b_error + 0.52 * d_error / root + u * (13.0 * root + 9.0 * fabs(b))) * inverse;
    roots[0].t = pov_two_sum(middle, (-b - root) * inverse);
    roots[1].t = pov_two_sum(middle, (-b + root) * inverse);
    roots[0].error = roots[1].error = error;
    roots[0].part = 0;
    roots[1].part = 1;
    roots[0].flags = roots[1].flags = 0;
    equation.apart = root * inverse;
    return kit_report(roots + first, n, KIT_FINE * KIT_SLOWEST, &equation, hits);
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const sphere *s = self;
    bool leaving = ray->left == hits->owner;
    kit_ray k = kit_enter(ray, s->centre, scale_of(s));
    pov_two square = square_of(s);

    if (hits->always_exact || !quick(square, &k, leaving, hits))
        decide(square, &k, leaving, hits);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const sphere *s = self;
    kit_ray k = kit_enter(ray, s->centre, scale_of(s));

    *out = pov_unit(pov_two3_hi(kit_point(&k, at)));
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const sphere *s = self;
    pov_two3 w = kit_offset(point, point_lo, s->centre, scale_of(s));

    return pov_two_less(pov_two3_dot(w, w), square_of(s));
}

static bool absorb(void *self, const pov_affine *map)
{
    sphere *s = self;
    pov_two factor;

    if (!kit_is_similarity(map, &factor))
        return false;
    s->centre = kit_map_point(map, s->centre);
    s->radius = pov_two_mul(s->radius, factor);
    return true;
}

/* ---- blocks ---- */

typedef struct sphere_block {
    double x[POV_BLOCK_MAX], y[POV_BLOCK_MAX], z[POV_BLOCK_MAX];
    double inner[POV_BLOCK_MAX], outer[POV_BLOCK_MAX]; /* the radius, less and more what centre and radius lost */
    double reach;   /* no centre is further from the origin, by sum of sizes */
    int64_t lanes;  /* those that hold a sphere */
} sphere_block;

static bool block_pack(void *block, const void *const *selves, uint32_t n)
{
    sphere_block *b = block;
    uint32_t i;

    b->reach = 0.0;
    b->lanes = (1 << n) - 1;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const sphere *s = selves[i < n ? i : 0];
        pov_vec3 c = pov_two3_hi(s->centre);
        double far = fabs(c.x) + fabs(c.y) + fabs(c.z), lost = KIT_U * (2.0 * s->radius.hi + 2.0 * far);

        if (!kit_block_range(pov_largest(c)) || !kit_block_size(s->radius.hi))
            return false;
        b->x[i] = c.x;
        b->y[i] = c.y;
        b->z[i] = c.z;
        b->inner[i] = s->radius.hi - lost;
        b->outer[i] = s->radius.hi + lost;
        b->reach = fmax(b->reach, far);
    }
    return true;
}

/* A lane that the line of the ray comes near to: where, and whether it is met. */
static inline void bound_lane(const sphere_block *s, uint32_t i, double middle, double ww, double slack,
                              double per_length, double tmin, double tmax, pov_block_answer *out)
{
    double outer = s->outer[i] + slack, inner = s->inner[i] - slack;
    double far = outer * outer * (1.0 + 8.0 * KIT_U) - ww, near = inner * inner * (1.0 - 8.0 * KIT_U) - ww;
    double wide = (sqrt(far) * (1.0 + 8.0 * KIT_U) + slack) * per_length;
    double shift = 8.0 * KIT_U * fabs(middle), narrow;

    out->lo[i] = middle - wide - shift;
    if (!(out->lo[i] <= tmax && middle + wide + shift >= tmin))
        return;
    out->maybe |= 1u << i;
    if (!(inner > 0.0 && near > 0.0))
        return;
    narrow = (sqrt(near) * (1.0 - 8.0 * KIT_U) - slack) * per_length;
    out->hi[i] = middle - narrow + shift;
    if (narrow > 0.0 && out->lo[i] > tmin && out->hi[i] < tmax)
        out->surely |= 1u << i;
}

/* All of it in plain double. The point of closest approach is off by less than 16 u times the distance
 * from origin to centre, in each of its uses; radii that much smaller and larger make the answer safe. Most
 * blocks are passed by on every lane: that is found out first, for all lanes at once. */
KIT_CLONES static void block_filter(const void *block, const pov_ray *ray, double tmin, double tmax,
                                    pov_block_answer *out)
{
    const sphere_block *s = block;
    const pov_vec3 o = ray->org, d = ray->dir;
    const double a = pov_dot(d, d), inverse = 1.0 / a;
    const double slack = 18.0 * KIT_U * (fabs(o.x) + fabs(o.y) + fabs(o.z) + s->reach);
    double middle[POV_BLOCK_MAX], ww[POV_BLOCK_MAX], depth[POV_BLOCK_MAX], per_length;
    const int64_t bit[POV_BLOCK_MAX] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    int64_t met = 0;
    uint32_t i;

    if (!(a > 1e-200 && a < 1e200 && slack < 1e100) && kit_block_declines(ray, tmin, out))
        return;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        double x = o.x - s->x[i], y = o.y - s->y[i], z = o.z - s->z[i], outer = s->outer[i] + slack, wx, wy, wz;
        middle[i] = -(x * d.x + y * d.y + z * d.z) * inverse;
        wx = x + middle[i] * d.x;
        wy = y + middle[i] * d.y;
        wz = z + middle[i] * d.z;
        ww[i] = wx * wx + wy * wy + wz * wz;
        depth[i] = outer * outer * (1.0 + 8.0 * KIT_U) - ww[i];
        met |= depth[i] >= 0.0 ? bit[i] : 0;
    }
    out->maybe = out->surely = 0;
    met &= s->lanes;
    if (!met)
        return;
    per_length = sqrt(inverse);
    for (; met; met &= met - 1) {
        i = kit_first_lane((uint32_t)met);
        bound_lane(s, i, middle[i], ww[i], slack, per_length, tmin, tmax, out);
    }
}

static const pov_shape_class sphere_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "sphere",
    .instance_size = sizeof(sphere),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .absorb = absorb,
    .block_size = sizeof(sphere_block),
    .block_pack = block_pack,
    .block_filter = block_filter,
    .text_size = sizeof(sphere_text),
    .prepare = prepare,
};

static const pov_shape_class *const shapes[] = { &sphere_class, NULL };

POV_PLUGIN(sphere) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "sphere",
    .version = "1",
    .shapes = shapes,
};
