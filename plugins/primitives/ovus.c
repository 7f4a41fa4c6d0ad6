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
    const double up = y - o->h, reach = sqrt(pov_max(o->arc * o->arc - up * up, 0.0)), radius = reach - o->a;

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
    add_sphere(o, -o->bottom, pov_min(o->low, o->bottom), 0.0, o->bottom);
    add_sphere(o, pov_max(o->high, o->bottom - o->top), o->bottom + o->top, o->bottom, o->top);
    for (int i = 0; i < ARCS && o->low < o->high; i++)
        add_arc(o, o->low + (o->high - o->low) * i / ARCS, o->low + (o->high - o->low) * (i + 1) / ARCS);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    ovus *o = self;
    double R = common_radius(host, in), r = (host->accept(in, ","), common_radius(host, in)), K, share;

    if (!(pov_max(R, r) > 0.0))
        host->fail(in, "the radii of an ovus must not be 0");
    if (r >= 2.0 * R)
        host->warn(in, "the second radius of an ovus should be less than double the first: it is a sphere");
    o->boxed.scale = pov_inverse_power(R + r);
    o->bottom = R * o->boxed.scale;
    o->top = r * o->boxed.scale;
    K = o->arc = 2.0 * pov_max(o->bottom, o->top);
    /* a^2 + h^2 = (K - R)^2 and a^2 + (h - R)^2 = (K - r)^2. */
    o->h = ((K - o->bottom) * (K - o->bottom) - (K - o->top) * (K - o->top) + o->bottom * o->bottom) / (2.0 * o->bottom);
    o->a = sqrt(pov_max((K - o->bottom) * (K - o->bottom) - o->h * o->h, 0.0));
    share = o->bottom / (K - o->bottom);
    o->low = -o->h * share;
    o->high = K - o->top > 0.0 ? o->bottom + (o->bottom - o->h) * o->top / (K - o->top) : o->bottom;
    o->foot = r < 2.0 * R ? o->bottom : o->top - o->bottom;
    if (r >= 2.0 * R)
        o->low = o->high = -2.0 * o->foot - o->bottom;
    o->wide = pov_max(pov_max(o->bottom, o->top), o->h >= o->low && o->h <= o->high ? K - o->a : 0.0) * (1.0 + 0x1p-40);
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

/* ---- along several rays ---- */

/* By lane: the line, and what is the square of its direction; crossings up to `begin` do not count. */
typedef struct lines { common_by_entry ox, oy, oz, dx, dy, dz, base, end, square, begin, low, high; } lines;

/* The arc's stretch: its equation, the sheet's, and 1 where there is one. */
typedef struct arcs { common_by_entry lo, length, g0, g1, g2, may; } arcs;

/* The first crossing, its part, and above 0 where it is open. */
typedef struct sums { common_by_entry t, part, open; } sums;

COMMON_SEPARATE static void find_lines(const common_entries *restrict l, lines *restrict n, sums *restrict of)
{
    for (uint32_t i = 0; i < COMMON_ENTRIES; i++) {
        const double base = l->lo[i], dx = l->d[0][i], dy = l->d[1][i], dz = l->d[2][i], end = l->hi[i] - base;
        const double y = pov_along(pov_two_of(l->f[2][i], l->f[3][i]), base, dy, l->d_lo[1][i]), far = y + end * dy, near = y + 0.0 * dy;

        n->ox[i] = pov_along(pov_two_of(l->f[0][i], l->f[1][i]), base, dx, l->d_lo[0][i]);
        n->oy[i] = y;
        n->oz[i] = pov_along(pov_two_of(l->f[4][i], l->f[5][i]), base, dz, l->d_lo[2][i]);
        n->dx[i] = dx;
        n->dy[i] = dy;
        n->dz[i] = dz;
        n->base[i] = base;
        n->end[i] = end;
        n->square[i] = dx * dx + dy * dy + dz * dz;
        n->begin[i] = l->least[i] - base;
        n->low[i] = (dy < 0.0 ? far : near) - MARGIN;
        n->high[i] = (dy < 0.0 ? near : far) + MARGIN;
        of->t[i] = HUGE_VAL;
        of->part[i] = 0.0;
        of->open[i] = fabs(dy) > 0x1p-100 ? 0.0 : 1.0;
    }
}

/* As report(): a crossing of a part counts at the part's own heights. Of two that are near each other, or one near the beginning, it is not
 * known which is the first. */
COMMON_INLINE void add(const ovus *o, const lines *restrict n, uint32_t i, double found, double t, double part, sums *restrict io)
{
    const double y = n->oy[i] + t * n->dy[i], at = y < o->low ? (double)BOTTOM : y > o->high ? (double)TOP : (double)ARC;
    const double off = 0x1p-40 * (1.0 + fabs(n->base[i])), begin = n->begin[i], own = at == part ? found : 0.0;
    const double ahead = t > begin + off ? own : 0.0, behind = t < begin - off ? own : 0.0, near = fabs(t - io->t[i]) > off ? 0.0 : ahead;
    const double first = t < io->t[i] ? ahead : 0.0;

    io->open[i] += own - (ahead + behind) + near;
    io->t[i] = first > 0.0 ? t : io->t[i];
    io->part[i] = first > 0.0 ? part : io->part[i];
}

/* As cross_sphere(). */
COMMON_SEPARATE static void add_sphere_lanes(const ovus *self, uint32_t part, const lines *restrict n, sums *restrict io)
{
    const ovus o = *self;
    const double radius = part == TOP ? o.top : o.bottom, middle_y = part == TOP ? o.bottom : 0.0, number = part;

    for (uint32_t i = 0; i < COMMON_ENTRIES; i++) {
        const double x = n->ox[i] - 0.0, y = n->oy[i] - middle_y, z = n->oz[i] - 0.0, dx = n->dx[i], dy = n->dy[i], dz = n->dz[i], a = n->square[i];
        const double middle = -(x * dx + y * dy + z * dz) / a, wx = x + dx * middle, wy = y + dy * middle, wz = z + dz * middle;
        const double rest = radius * radius - (wx * wx + wy * wy + wz * wz), half = sqrt(common_greater(rest, 0.0) / a), crossed = rest > 0.0 ? 1.0 : 0.0;
        const double here = part == TOP ? n->high[i] < o.high ? 0.0 : crossed : n->low[i] > o.low ? 0.0 : crossed;

        add(&o, n, i, here, middle - half, number, io);
        add(&o, n, i, here, middle + half, number, io);
    }
}

/* As cross_arc(). */
COMMON_SEPARATE static bool find_arcs(const ovus *self, const lines *restrict n, arcs *restrict out, common_bernsteins *restrict to)
{
    const double low = self->low, high = self->high, h = self->h, a = self->a, arc = self->arc;
    double any[COMMON_ENTRIES / 2];

    for (uint32_t i = 0; i < COMMON_ENTRIES; i++) {
        const double oy = n->oy[i], ky = n->dy[i], one = (low - 0x1p-40 - oy) / ky, other = (high + 0x1p-40 - oy) / ky, end = n->end[i];
        const double near = one < other ? one : other, far = one < other ? other : one, lo = near > 0.0 ? near : 0.0, hi = far < end ? far : end;
        const double length = hi - lo, px = n->ox[i] + n->dx[i] * lo, py = oy + ky * lo - h, pz = n->oz[i] + n->dz[i] * lo;
        const double dx = n->dx[i] * length, dy = ky * length, dz = n->dz[i] * length, may = length > 0.0 ? 1.0 : 0.0;
        const double g0 = px * px + py * py + pz * pz + a * a - arc * arc, g1 = 2.0 * (px * dx + py * dy + pz * dz), g2 = dx * dx + dy * dy + dz * dz;
        const double q0 = 4.0 * a * a * (px * px + pz * pz), q1 = 8.0 * a * a * (px * dx + pz * dz), q2 = 4.0 * a * a * (dx * dx + dz * dz);
        const double c0 = g0 * g0 - q0, c1 = 2.0 * g0 * g1 - q1, c2 = 2.0 * g0 * g2 + g1 * g1 - q2, c3 = 2.0 * g1 * g2, c4 = g2 * g2;
        double b[5] = { c0, c1 / 4.0, c2 / 6.0, c3 / 4.0, c4 }, most;

        COMMON_UNROLLED for (int k = 1; k <= 4; k++)
            COMMON_UNROLLED for (int j = 4; j >= k; j--)
                b[j] += b[j - 1];
        most = common_greater(common_greater(common_greater(fabs(b[0]), fabs(b[1])), common_greater(fabs(b[2]), fabs(b[3]))), fabs(b[4]));
        to->b[0][i] = may > 0.0 ? b[0] : 1.0;
        to->b[1][i] = may > 0.0 ? b[1] : 1.0;
        to->b[2][i] = may > 0.0 ? b[2] : 1.0;
        to->b[3][i] = may > 0.0 ? b[3] : 1.0;
        to->b[4][i] = may > 0.0 ? b[4] : 1.0;
        to->noise[i] = 4.0 * 0x1p-53 * (4 + 1) * most;
        to->beyond[i] = to->within[i] = -HUGE_VAL;
        out->lo[i] = lo;
        out->length[i] = length;
        out->g0[i] = g0;
        out->g1[i] = g1;
        out->g2[i] = g2;
        out->may[i] = may;
    }
    for (uint32_t i = 0; i < COMMON_ENTRIES / 2; i++)
        any[i] = out->may[i] + out->may[i + COMMON_ENTRIES / 2];
    return any[0] + any[1] + any[2] + any[3] > 0.0;
}

/* The first root, if it is on the outer sheet and at the arc's heights; else others count. */
COMMON_SEPARATE static void add_arcs(const ovus *self, const lines *restrict n, const arcs *restrict s, const common_first_of_bernsteins *restrict at,
                                     sums *restrict io)
{
    const ovus o = *self;

    for (uint32_t i = 0; i < COMMON_ENTRIES; i++) {
        const double root = at->root[i], t = s->lo[i] + root * s->length[i], found = at->found[i] * s->may[i];
        const double outer = (s->g2[i] * root + s->g1[i]) * root + s->g0[i] <= 0.0 ? found : 0.0, y = n->oy[i] + t * n->dy[i];
        const double off = 0x1p-40 * (1.0 + fabs(n->base[i])), ahead = t > n->begin[i] + off ? outer : 0.0;
        const double counts = y < o.low ? 0.0 : y > o.high ? 0.0 : ahead;

        io->open[i] += s->may[i] * at->open[i] + (at->more[i] > 0.0 ? found - counts : 0.0);
        add(&o, n, i, outer, t, (double)ARC, io);
    }
}

COMMON_SEPARATE static void tell(const lines *restrict n, const sums *restrict of, common_first_crossings *restrict out)
{
    for (uint32_t i = 0; i < COMMON_ENTRIES; i++) {
        const pov_two t = pov_two_sum(n->base[i], of->t[i]);

        out->known[i] = of->open[i] > 0.0 ? 0.0 : of->t[i] < HUGE_VAL ? 1.0 : 0.0;
        out->t[i] = t.hi;
        out->t_lo[i] = t.lo;
        out->feature[i] = of->part[i];
        out->u[i] = 0.0;
        out->v[i] = 0.0;
    }
}

static void first(const void *self, const common_entries *restrict l, common_first_crossings *restrict out)
{
    common_first_of_bernsteins at;
    common_bernsteins all;
    lines n;
    sums of;
    arcs s;

    find_lines(l, &n, &of);
    add_sphere_lanes(self, BOTTOM, &n, &of);
    add_sphere_lanes(self, TOP, &n, &of);
    if (find_arcs(self, &n, &s, &all)) {
        common_bernstein_first_many(&all, 4, &at);
        add_arcs(self, &n, &s, &at, &of);
    }
    tell(&n, &of, out);
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

COMMON_ROUND_CLASS(ovus, cross, first, false, narrow, normal_at)

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
