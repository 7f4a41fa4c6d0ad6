/* torus { major, minor }: around the y axis: (p.p + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2), negative inside.
 *
 * Along a ray this is a quartic. It is taken about the point of the ray that is nearest to the centre, over the stretch
 * within the sphere around the torus, so that distance changes nothing. Its roots are isolated with certainty and
 * completed in double-double. On a ray that starts on the torus that root is divided out. Of a spindle (r > R) the
 * outer sheet alone is the surface: what it holds is inside, and no ray meets the inner one. */
#include "common/local.h"
#include "common/radius.h"
#include "common/roots.h"
#include "common/turns.h"

typedef struct torus {
    double major, minor;           /* as written */
    double R, r;                   /* times scale */
    double scale;                  /* a power of two that makes R + r of the order of one */
    pov_two ring, hollow, lens;    /* R^2; R^2 - r^2; what p.p is below on the inner sheet of a spindle, else 0 or less */
} torus;

enum { ENTERING, EXITING };

/* ---- loading ---- */

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    torus *t = self;
    pov_two minor_square;

    t->major = common_radius(host, in);
    host->accept(in, ",");
    t->minor = common_radius(host, in);
    if (host->accept(in, "sturm") && host->more(in))
        host->boolean(in);
    if (!(t->major > 0.0 && t->minor > 0.0))
        host->fail(in, "the radii of a torus must not be 0");
    t->scale = pov_inverse_power(fmax(t->major, t->minor));
    t->R = t->major * t->scale;
    t->r = t->minor * t->scale;
    minor_square = pov_two_product(t->r, t->r);
    t->ring = pov_two_product(t->R, t->R);
    t->hollow = pov_two_sub(t->ring, minor_square);
    t->lens = pov_two_neg(t->hollow);
}

static bool bounds(const void *self, pov_box *out)
{
    const torus *t = self;
    const double reach = common_above(t->major + t->minor), high = t->minor;

    out->lo = pov_vec3_of(-reach, -high, -reach);
    out->hi = pov_vec3_of(reach, high, reach);
    return true;
}

/* ---- the surface ---- */

/* The equation's value at a point. */
COMMON_INLINE pov_two value_at(const torus *t, pov_two3 p)
{
    const pov_two level = pov_two_add(pov_two_mul(p.x, p.x), pov_two_mul(p.z, p.z));
    const pov_two g = pov_two_add(pov_two_add(level, pov_two_mul(p.y, p.y)), t->hollow);

    return pov_two_sub(pov_two_mul(g, g), pov_two_scale(pov_two_mul(t->ring, level), 4.0));
}

static bool is_in_lens(const torus *t, pov_two3 p) { return t->lens.hi > 0.0 && pov_two_less(pov_two3_dot(p, p), t->lens); }

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const torus *t = self;
    const pov_two3 p = common_offset(point, point_lo, pov_two3_of(zero, zero), t->scale);

    return is_in_lens(t, p) || value_at(t, p).hi <= 0.0;
}

/* ---- along a ray ---- */

/* The interval of a ray that may hit the torus: points at `middle + x half`, x from -1 to 1. */
typedef struct stretch {
    const torus *torus;
    common_ray ray;
    double middle, half;
    pov_two3 w;                    /* the point at its middle */
    double lost;                   /* error of w from distant origins, in any arithmetic */
    double bend;                   /* the second derivative along x is not larger, from -1 to 1 */
} stretch;

/* False: the ray misses the sphere, or the slab, around the torus. */
static bool enter(stretch *s, const torus *t, const pov_ray *ray)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const double reach = t->R + t->r, square = reach * reach;
    double across, speed;
    pov_vec3 w;

    s->torus = t;
    s->bend = HUGE_VAL;
    s->ray = common_enter(ray, pov_two3_of(zero, zero), t->scale);
    speed = pov_dot(s->ray.d, s->ray.d);
    s->middle = -pov_dot(pov_two3_hi(s->ray.f), s->ray.d) / speed;
    s->w = common_along_two(&s->ray, s->middle);
    s->lost = 0x1p-98 * pov_largest(pov_two3_hi(s->ray.f));
    w = pov_two3_hi(s->w);
    across = pov_dot(w, w);
    if (!(across <= square * (1.0 + 0x1p-40) + 8.0 * s->lost * reach))
        return false;
    /* The nearest point was rounded, by less than 2^-48 of its distance. */
    s->half = sqrt(fmax(square * (1.0 + 0x1p-20) - across, 0x1p-30 * square) / speed) + 0x1p-48 * fabs(s->middle);
    return fabs(w.y) <= fabs(s->ray.d.y) * s->half + t->r * (1.0 + 0x1p-40) + s->lost;
}

/* The quartic in x, and the sum of its coefficients' error bounds. Each is a sum of at most twelve rounded products. */
static double coefficients(stretch *s, double a[5])
{
    const double u = 16.0 * COMMON_U, four = 4.0 * s->torus->R * s->torus->R;
    const pov_vec3 w = pov_two3_hi(s->w), d = pov_scale(s->ray.d, s->half);
    const double dd = pov_dot(d, d), ww = pov_dot(w, w), b = 2.0 * pov_dot(w, d), g = ww + s->torus->hollow.hi;
    const double size = ww + s->torus->R * s->torus->R + s->torus->r * s->torus->r, b_error = u * sqrt(dd * ww);
    const double fd = d.x * d.x + d.z * d.z, fb = 2.0 * (w.x * d.x + w.z * d.z), fw = w.x * w.x + w.z * w.z;

    a[4] = dd * dd;
    a[3] = 2.0 * dd * b;
    a[2] = 2.0 * dd * g + b * b - four * fd;
    a[1] = 2.0 * b * g - four * fb;
    a[0] = g * g - four * fw;
    s->bend = 12.0 * (a[4] + fabs(a[3]) + fabs(a[2])) + 1.0;
    return u * (dd * dd + 2.0 * dd * size + four * (fd + 2.0 * sqrt(fd * fw) + fw) + size * size + 2.0 * fabs(b) * size) +
           b_error * (2.0 * dd + 2.0 * fabs(b) + 2.0 * size) + 64.0 * s->lost;
}

/* The same in double-double. */
static double coefficients_two(const stretch *s, pov_two a[5])
{
    const torus *t = s->torus;
    const pov_two3 w = s->w, dir = common_direction(&s->ray);
    const pov_two3 d = { pov_two_mul_double(dir.x, s->half), pov_two_mul_double(dir.y, s->half), pov_two_mul_double(dir.z, s->half) };
    const pov_two dd = pov_two3_dot(d, d), b = pov_two_scale(pov_two3_dot(w, d), 2.0);
    const pov_two g = pov_two_add(pov_two3_dot(w, w), t->hollow), four = pov_two_scale(t->ring, 4.0);
    const pov_two fd = pov_two_add(pov_two_mul(d.x, d.x), pov_two_mul(d.z, d.z));
    const pov_two fb = pov_two_scale(pov_two_add(pov_two_mul(w.x, d.x), pov_two_mul(w.z, d.z)), 2.0);
    const pov_two fw = pov_two_add(pov_two_mul(w.x, w.x), pov_two_mul(w.z, w.z));
    const double size = dd.hi + fabs(b.hi) + fw.hi + w.y.hi * w.y.hi + t->ring.hi + t->r * t->r;

    a[4] = pov_two_mul(dd, dd);
    a[3] = pov_two_scale(pov_two_mul(dd, b), 2.0);
    a[2] = pov_two_sub(pov_two_add(pov_two_scale(pov_two_mul(dd, g), 2.0), pov_two_mul(b, b)), pov_two_mul(four, fd));
    a[1] = pov_two_sub(pov_two_scale(pov_two_mul(b, g), 2.0), pov_two_mul(four, fb));
    a[0] = pov_two_sub(pov_two_mul(g, g), pov_two_mul(four, fw));
    return 0x1p-97 * size * size + 64.0 * s->lost;
}

/* Half the equation's slope along x, in double. */
static double slope_at(const stretch *s, pov_two3 point)
{
    const torus *t = s->torus;
    const pov_vec3 p = pov_two3_hi(point), d = pov_scale(s->ray.d, s->half);
    const double g = pov_dot(p, p) + t->hollow.hi;

    return 2.0 * g * pov_dot(p, d) - 4.0 * t->ring.hi * (p.x * d.x + p.z * d.z);
}

static pov_two distance_at(const stretch *s, pov_two x)
{
    return pov_two_add_double(pov_two_mul_double(x, s->half), s->middle);
}

/* Newton's method in double-double, kept in the bracket. A step's error is its square times the second derivative over
 * the slope: a single step does as a rule. */
static pov_two complete(const stretch *s, double start, const common_bracket *root)
{
    double lo = root->lo, hi = root->hi;
    pov_two x = { start, 0.0 };

    for (int turn = 0; turn < 100; turn++) {
        const pov_two3 p = common_along_dd(&s->ray, distance_at(s, x));
        const pov_two value = value_at(s->torus, p);
        const double slope = slope_at(s, p), step = -0.5 * value.hi / slope;

        *((value.hi > 0.0) == root->rising ? &hi : &lo) = x.hi;
        if (!(x.hi + step >= lo && x.hi + step <= hi)) {
            if (!(hi - lo > 0x1p-60))
                break;
            x = pov_two_of(0.5 * (lo + hi), 0.0);
            continue;
        }
        x = pov_two_add_double(x, step);
        if (fabs(step) <= 0x1p-70 || step * step * s->bend <= 0x1p-80 * fabs(slope))
            break;
    }
    return x;
}

/* False: no more crossings are wanted. */
static bool report(const stretch *s, pov_two x, bool rising, bool escalated, pov_hits *hits)
{
    const pov_two t = distance_at(s, x);
    const pov_mark mark = { rising ? EXITING : ENTERING, escalated ? POV_MARK_ESCALATED : 0, 0.0, 0.0 };
    const double at = t.hi * s->ray.unit;

    if (s->torus->lens.hi > 0.0 && is_in_lens(s->torus, common_along_dd(&s->ray, t)))
        return true;
    return pov_cross(hits, at, t.lo * s->ray.unit, mark) && !(hits->want == POV_WANT_NEAREST && at > hits->tmin && hits->count > 0);
}

/* The part of the stretch that counts, with a margin. The inner sheet of a spindle is no hit. */
static common_range wanted_of(const stretch *s, const pov_hits *hits)
{
    static const common_range all = { -HUGE_VAL, HUGE_VAL, HUGE_VAL, false };
    const double margin = 0x1p-40 * (1.0 + fabs(s->middle) / s->half), per = s->ray.per_unit;
    const double start = (hits->tmin * per - s->middle) / s->half;
    const double end = ((hits->tmax + hits->slack) * per - s->middle) / s->half;
    const common_range part = { start - margin, start + margin, end + margin, true };

    return hits->want == POV_WANT_ALL || hits->always_exact || s->torus->lens.hi > 0.0 ? all : part;
}

/* Where any crossing will do, does one certainly lie in the interval? Its distance need not be known. */
static bool is_blocked(const stretch *s, const common_bracket *root, common_range wanted, pov_hits *hits)
{
    const pov_mark mark = { root->rising ? EXITING : ENTERING, 0, 0.0, 0.0 };
    const double t = (s->middle + root->hi * s->half) * s->ray.unit;

    return hits->want == POV_WANT_ANY && wanted.first && root->lo > wanted.ahead &&
           t * (1.0 + 0x1p-40) + hits->slack < hits->tmax && !pov_cross(hits, t, 0.0, mark);
}

static void intersect_from_outside(stretch *s, pov_hits *hits)
{
    const common_range wanted = wanted_of(s, hits);
    double a[5];
    pov_two exact[5];
    common_brackets roots;
    double error = coefficients(s, a);
    bool escalated = hits->always_exact || !common_isolate(a, error, 4, wanted, &roots);

    if (escalated) {
        error = coefficients_two(s, exact);
        common_isolate_two(exact, error, 4, &roots);
        hits->escalated++;
    }
    for (uint32_t i = 0; i < roots.count; i++)
        if (is_blocked(s, &roots.at[i], wanted, hits) ||
            !report(s, complete(s, common_polish(a, 4, &roots.at[i]), &roots.at[i]), roots.at[i].rising, escalated, hits))
            return;
}

/* ---- from the surface ---- */

/* Taylor's shift and a scaling: the cubic in y where x = middle + y half. */
static void restrict_cubic(pov_two c[4], pov_two middle, pov_two half)
{
    pov_two power = half;
    int i, j;

    for (j = 0; j < 3; j++)
        for (i = 2; i >= j; i--)
            c[i] = pov_two_add(c[i], pov_two_mul(c[i + 1], middle));
    for (i = 1; i < 4; i++) {
        c[i] = pov_two_mul(c[i], power);
        power = pov_two_mul(power, half);
    }
}

/* From the start to the end of the stretch: x = middle + y half. */
typedef struct cubic { stretch *s; pov_two start, middle, half; double approx[4]; } cubic;

/* Divide out the root that the ray starts on, and isolate those of the cubic that remains. */
static void isolate_two(cubic *r, common_brackets *roots)
{
    pov_two a[5], c[4];
    double error = coefficients_two(r->s, a), sum = 0.0;
    int i;

    c[3] = a[4];
    for (i = 2; i >= 0; i--)
        c[i] = pov_two_add(a[i + 1], pov_two_mul(c[i + 1], r->start));
    restrict_cubic(c, r->middle, r->half);
    for (i = 0; i < 4; i++) {
        r->approx[i] = c[i].hi;
        sum += fabs(c[i].hi);
    }
    common_isolate_two(c, 64.0 * error + 0x1p-96 * sum, 3, roots);
}

/* The same in double. The start lies in -1..1, so no coefficient of the cubic is off by more than 4 times the errors of
 * those of the quartic, and none after the shift by more than 8 times these. False: open. */
static bool isolate(cubic *r, common_range wanted, common_brackets *roots)
{
    const double start = r->start.hi, middle = r->middle.hi, half = r->half.hi;
    double a[5], *c = r->approx, error = coefficients(r->s, a), sum = 0.0, power = half;
    int i, j;

    for (i = 0; i < 5; i++)
        sum += fabs(a[i]);
    c[3] = a[4];
    for (i = 2; i >= 0; i--)
        c[i] = a[i + 1] + c[i + 1] * start;
    for (j = 0; j < 3; j++)
        for (i = 2; i >= j; i--)
            c[i] += c[i + 1] * middle;
    for (i = 1; i < 4; i++) {
        c[i] *= power;
        power *= half;
    }
    return fabs(start) <= 1.0 && common_isolate(c, 64.0 * (error + 8.0 * COMMON_U * sum), 3, wanted, roots);
}

static void intersect_from_surface(stretch *s, pov_hits *hits)
{
    const common_range wanted = { -HUGE_VAL, -HUGE_VAL, HUGE_VAL, wanted_of(s, hits).first };
    cubic r = { .s = s, .start = pov_two_div(pov_two_of(-s->middle, 0.0), pov_two_of(s->half, 0.0)) };
    common_brackets roots;
    bool escalated;

    r.middle = pov_two_scale(pov_two_add_double(r.start, 1.0), 0.5);
    r.half = pov_two_scale(pov_two_sub(pov_two_of(1.0, 0.0), r.start), 0.5);
    if (!(r.half.hi > 0.0))
        return;
    escalated = hits->always_exact || !isolate(&r, wanted, &roots);
    hits->escalated += escalated;
    if (escalated)
        isolate_two(&r, &roots);
    for (uint32_t k = 0; k < roots.count; k++) {
        const common_bracket *y = &roots.at[k];
        const common_bracket x = { r.middle.hi + r.half.hi * y->lo, r.middle.hi + r.half.hi * y->hi, 0.0, y->rising };
        double near;

        /* Ahead of the start the divided-out factor is positive, so the quartic rises where the cubic does. */
        if (is_blocked(s, &x, wanted, hits))
            return;
        near = pov_two_add(r.middle, pov_two_mul_double(r.half, common_polish(r.approx, 3, y))).hi;
        if (!report(s, complete(s, near, &x), y->rising, escalated, hits))
            return;
    }
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    stretch s;

    if (!enter(&s, self, ray))
        return;
    if (ray->origin_surface == hits->owner)
        intersect_from_surface(&s, hits);
    else
        intersect_from_outside(&s, hits);
}

/* The normal points out of the circle in the middle of the tube. */
static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const torus *t = self;
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), t->scale);
    const pov_two3 p = common_point(&k, at);
    const pov_two axis = pov_two_sqrt(pov_two_add(pov_two_mul(p.x, p.x), pov_two_mul(p.z, p.z)));
    const double outward = axis.hi > 0.0 ? pov_two_add_double(axis, -t->R).hi / axis.hi : 0.0;

    *out = pov_unit(pov_vec3_of(p.x.hi * outward, p.y.hi, p.z.hi * outward));
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

static void uv(const void *self, pov_vec3 point, const pov_mark *mark, double out[2])
{
    const torus *t = self;

    (void)mark;
    out[0] = 0.5 - common_turn(point.z, point.x);
    out[1] = 0.5 + common_turn(point.y, sqrt(point.x * point.x + point.z * point.z) - t->major);
}

static const pov_shape_class torus_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_CERTIFIED,
    .keyword = "torus",
    .instance_size = sizeof(torus),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .uv = uv,
};

static const pov_shape_class *const shapes[] = { &torus_class, NULL };

POV_PLUGIN(torus) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "torus",
    .version = "1",
    .shapes = shapes,
};
