/* ovus { R, r }: an egg about the y axis: a sphere of radius R about 0, one of radius r about <0, R, 0>, and between them the
 * arc of a circle turned about the axis, which touches both. Where r is 2 R or more, the upper sphere alone.
 *
 * It is convex, and the circle's centre lies beyond the axis, so between the two heights where the parts join it is where a
 * quartic is zero. Of each part the crossings at its own heights count. */
#include "common/bernstein.h"
#include "common/radius.h"
#include "common/revolved.h"
#include "common/turns.h"

typedef struct ovus {
    double bottom, top;          /* radii, scaled */
    double arc, a, h;            /* the circle: radius, and its centre at -a from the axis, at the height h */
    double low, high;            /* heights of the joints */
    double wide;
    common_boxed boxed;
    common_revolved filter;
    double foot;                 /* of the lowest point below 0, scaled */
} ovus;

enum { BOTTOM, ARC, TOP };

static const double NEAR = 0x1p-30, BESIDE = 0x1p-44;

/* The square of the radius of the arc and its slope. */
static double square_of_arc(const ovus *o, double y, double *slope)
{
    const double up = y - o->h, reach = sqrt(fmax(o->arc * o->arc - up * up, 0.0)), radius = reach - o->a;

    *slope = -2.0 * radius * up / reach;
    return radius * radius;
}

enum { SAMPLES = 16, ARCS = 2 };

/* A piece of the arc by its ends and slopes there, and how far off that is. */
static void add_arc(ovus *o, double low, double high)
{
    common_revolved_part *p = &o->filter.at[o->filter.count++];
    double slope[2], square[4], most = 0.0, unused;

    square[0] = square_of_arc(o, low, &slope[0]);
    square[3] = square_of_arc(o, high, &slope[1]);
    square[1] = square[0] + slope[0] * (high - low) / 3.0;
    square[2] = square[3] - slope[1] * (high - low) / 3.0;
    common_revolved_curve(p, low, high, square, UINT32_MAX);
    for (int i = 1; i < SAMPLES; i++) {
        const double y = low + (high - low) * i / SAMPLES, about = p->square[0] + y * (p->square[1] + y * (p->square[2] + y * p->square[3]));
        const double off = fabs(about - square_of_arc(o, y, &unused));

        if (off > most)
            most = off;
    }
    p->loose = 2.0 * most;
}

static void add_sphere(ovus *o, double low, double high, double middle, double radius)
{
    const double third = (high - low) / 3.0, a = low - middle, b = high - middle, rest = radius * radius;
    const double square[4] = { rest - a * a, rest - a * (a + 2.0 * third), rest - b * (b - 2.0 * third), rest - b * b };

    if (low < high)
        common_revolved_curve(&o->filter.at[o->filter.count++], low, high, square, UINT32_MAX);
}

/* For rays at the box. */
static void make_filter(ovus *o, const pov_host *host, pov_reader *in)
{
    o->filter.at = host->alloc(in, (2 + ARCS) * sizeof *o->filter.at);
    if (!o->filter.at)
        return;
    add_sphere(o, -o->bottom, fmin(o->low, o->bottom), 0.0, o->bottom);
    add_sphere(o, fmax(o->high, o->bottom - o->top), o->bottom + o->top, o->bottom, o->top);
    for (int i = 0; i < ARCS && o->low < o->high; i++)
        add_arc(o, o->low + (o->high - o->low) * i / ARCS, o->low + (o->high - o->low) * (i + 1) / ARCS);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    ovus *o = self;
    double R = common_radius(host, in), r = (host->accept(in, ","), common_radius(host, in)), K, share;

    if (!(fmax(R, r) > 0.0))
        host->fail(in, "the radii of an ovus must not be 0");
    if (r >= 2.0 * R)
        host->warn(in, "the second radius of an ovus should be less than double the first: it is a sphere");
    o->boxed.scale = pov_inverse_power(R + r);
    o->bottom = R * o->boxed.scale;
    o->top = r * o->boxed.scale;
    K = o->arc = 2.0 * fmax(o->bottom, o->top);
    /* a^2 + h^2 = (K - R)^2 and a^2 + (h - R)^2 = (K - r)^2. */
    o->h = ((K - o->bottom) * (K - o->bottom) - (K - o->top) * (K - o->top) + o->bottom * o->bottom) / (2.0 * o->bottom);
    o->a = sqrt(fmax((K - o->bottom) * (K - o->bottom) - o->h * o->h, 0.0));
    share = o->bottom / (K - o->bottom);
    o->low = -o->h * share;
    o->high = K - o->top > 0.0 ? o->bottom + (o->bottom - o->h) * o->top / (K - o->top) : o->bottom;
    o->foot = r < 2.0 * R ? o->bottom : o->top - o->bottom;
    if (r >= 2.0 * R)
        o->low = o->high = -2.0 * o->foot - o->bottom;
    o->wide = fmax(fmax(o->bottom, o->top), o->h >= o->low && o->h <= o->high ? K - o->a : 0.0) * (1.0 + 0x1p-40);
    o->boxed.lo = pov_vec3_of(-o->wide, -o->foot, -o->wide);
    o->boxed.hi = pov_vec3_of(o->wide, o->bottom + o->top, o->wide);
    make_filter(o, host, in);
}

static bool bounds(const void *self, pov_box *out)
{
    const ovus *o = self;
    const double wide = o->wide / o->boxed.scale, high = (o->bottom + o->top) / o->boxed.scale, low = -o->foot / o->boxed.scale;

    out->lo = pov_vec3_of(-wide, common_below(low), -wide);
    out->hi = pov_vec3_of(wide, common_above(high), wide);
    return true;
}

static uint32_t part_of(const ovus *o, double y) { return y < o->low ? BOTTOM : y > o->high ? TOP : ARC; }

/* ---- along a ray ---- */

typedef struct line {
    const common_ray *k;
    pov_vec3 o, d;
    double base;
    common_span span;
    double low, high;            /* heights that it has within the box */
    bool from_here;
    const pov_ray *ray;
} line;

static const double MARGIN = 0x1p-30;

static bool report(const line *n, const ovus *o, double t, uint32_t part, pov_hits *hits)
{
    const pov_two at = pov_two_sum(n->base, t);
    const pov_mark mark = { part, 0, 0.0, 0.0 };

    if (part_of(o, n->o.y + t * n->d.y) != part)
        return true;
    if (n->from_here && fabs(t) < (n->ray->origin_mark.feature == part ? NEAR : BESIDE))
        return true;
    return pov_cross(hits, at.hi * n->k->unit, at.lo * n->k->unit, mark);
}

static bool cross_sphere(const line *n, const ovus *o, uint32_t part, pov_hits *hits)
{
    const pov_vec3 from = pov_sub(n->o, pov_vec3_of(0.0, part == TOP ? o->bottom : 0.0, 0.0));
    const double radius = part == TOP ? o->top : o->bottom, a = pov_dot(n->d, n->d), middle = -pov_dot(from, n->d) / a;
    const pov_vec3 w = pov_add(from, pov_scale(n->d, middle));
    const double rest = radius * radius - pov_dot(w, w), half = rest > 0.0 ? sqrt(rest / a) : 0.0;

    return !(rest > 0.0) || (report(n, o, middle - half, part, hits) && report(n, o, middle + half, part, hits));
}

/* With g = p.p - 2 h y + a^2 + h^2 - K^2: (g)^2 = 4 a^2 (x^2 + z^2), of whose two sheets the outer one counts, where g < 0. */
static bool cross_arc(const line *n, const ovus *o, pov_hits *hits)
{
    common_span s = n->span;
    double c[5], b[5], root[4], g[3], q[3], length;
    pov_vec3 p, d;
    uint32_t found;

    common_clip_axis(&s, n->o.y, n->d.y, o->low, o->high, 0x1p-40);
    length = s.hi - s.lo;
    if (!(length > 0.0))
        return true;
    p = pov_add(n->o, pov_scale(n->d, s.lo));
    d = pov_scale(n->d, length);
    p.y -= o->h;
    g[0] = pov_dot(p, p) + o->a * o->a - o->arc * o->arc;
    g[1] = 2.0 * pov_dot(p, d);
    g[2] = pov_dot(d, d);
    q[0] = 4.0 * o->a * o->a * (p.x * p.x + p.z * p.z);
    q[1] = 8.0 * o->a * o->a * (p.x * d.x + p.z * d.z);
    q[2] = 4.0 * o->a * o->a * (d.x * d.x + d.z * d.z);
    c[0] = g[0] * g[0] - q[0];
    c[1] = 2.0 * g[0] * g[1] - q[1];
    c[2] = 2.0 * g[0] * g[2] + g[1] * g[1] - q[2];
    c[3] = 2.0 * g[1] * g[2];
    c[4] = g[2] * g[2];
    common_bernstein(c, 4, b);
    found = common_bernstein_roots(b, 4, common_bernstein_noise(b, 4), root);
    for (uint32_t i = 0; i < found; i++)
        if ((g[2] * root[i] + g[1]) * root[i] + g[0] <= 0.0 && !report(n, o, s.lo + root[i] * length, ARC, hits))
            return false;
    return true;
}

static void cross(const void *self, const pov_ray *ray, const common_entry *e, pov_hits *hits)
{
    const ovus *o = self;
    line n;

    n.k = &e->k;
    n.ray = ray;
    n.from_here = ray->origin_surface == hits->owner;
    n.base = n.from_here ? 0.0 : e->span.lo;
    n.o = common_along(n.k, n.base);
    n.d = n.k->d;
    n.span.lo = e->span.lo - n.base;
    n.span.hi = e->span.hi - n.base;
    n.low = n.o.y + (n.d.y < 0.0 ? n.span.hi : n.span.lo) * n.d.y - MARGIN;
    n.high = n.o.y + (n.d.y < 0.0 ? n.span.lo : n.span.hi) * n.d.y + MARGIN;
    if ((n.low > o->low || cross_sphere(&n, o, BOTTOM, hits)) && (n.high < o->high || cross_sphere(&n, o, TOP, hits)))
        cross_arc(&n, o, hits);
}

/* ---- points ---- */

/* Outward, of any length. */
static pov_vec3 across_at(const ovus *o, pov_vec3 p, uint32_t part)
{
    const double ring = sqrt(p.x * p.x + p.z * p.z), out_by = ring > 0.0 ? (ring + o->a) / ring : 0.0;

    return part == ARC ? pov_vec3_of(p.x * out_by, p.y - o->h, p.z * out_by) : pov_sub(p, pov_vec3_of(0.0, part == TOP ? o->bottom : 0.0, 0.0));
}

/* Rays that clearly go outward from where they start on it do not come back: it is convex. */
static const double OUTWARD = 0x1p-16;

static void look(const void *self, const common_beams *restrict l, common_verdicts *restrict out)
{
    const ovus *o = self;

    common_revolved_look(&o->filter, l, out);
    for (uint32_t i = 0; i < COMMON_BEAMS; i++) {
        const pov_vec3 p = pov_vec3_of(l->org[0][i], l->org[1][i], l->org[2][i]), d = pov_vec3_of(l->dir[0][i], l->dir[1][i], l->dir[2][i]);

        if (l->feature[i] == UINT32_MAX)
            continue;
        out->passed[i] = pov_dot(across_at(o, p, l->feature[i]), d) > OUTWARD ? 1.0 : 0.0;
        out->hit[i] = 0.0;
    }
}

static uint32_t narrow(const void *self, const pov_own_map *map, uint32_t owner, const pov_rays *rays, pov_candidate *io, uint32_t n)
{
    const ovus *o = self;

    return o->filter.count > 0 ? common_narrow(&o->boxed, look, o, map, owner, rays, io, n) : n;
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const ovus *o = self;
    const pov_vec3 p = pov_two3_hi(common_offset(point, point_lo, pov_two3_of(zero, zero), o->boxed.scale));
    const double ring = sqrt(p.x * p.x + p.z * p.z), top = p.y - o->bottom, arc = p.y - o->h;

    switch (part_of(o, p.y)) {
    case BOTTOM:
        return pov_dot(p, p) <= o->bottom * o->bottom;
    case TOP:
        return ring * ring + top * top <= o->top * o->top;
    default:
        return (ring + o->a) * (ring + o->a) + arc * arc <= o->arc * o->arc;
    }
}

static void normal_at(const void *self, pov_vec3 p, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    (void)ray;
    *out = pov_unit(across_at(self, p, at->mark.feature));
}

COMMON_ROUND_CLASS(ovus, cross, NULL, narrow, normal_at)

/* v is the height's angle, seen from the middle of the axis. Source: measured on POV-Ray 3.7. */
static void uv(const void *self, pov_vec3 point, const pov_mark *mark, double out[2])
{
    const ovus *o = self;
    const double ring = sqrt(point.x * point.x + point.z * point.z) * o->boxed.scale, y = point.y * o->boxed.scale;

    (void)mark;
    out[0] = common_whole_turn(point.z, point.x);
    out[1] = 0.5 + 2.0 * common_turn(y - 0.5 * (o->bottom + o->top - o->foot), ring);
}

static const pov_shape_class ovus_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "ovus",
    .instance_size = sizeof(ovus),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .extension = extension,
    .uv = uv,
};

static const pov_shape_class *const shapes[] = { &ovus_class, NULL };

POV_PLUGIN(ovus) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "ovus",
    .version = "1",
    .shapes = shapes,
};
