/* sor { n, <radius, height>, ... [open] [sturm] }: turned about the y axis; between two heights the square of the radius is a
 * cubic in the height.
 *
 * Within the slab of a piece the equation is a cubic along the ray. Its Bernstein coefficients are those of the piece,
 * which are known beforehand, less those of the ray's squared distance to the axis. Where two pieces touch, both have the
 * same value at the same point, and so have the caps at the ends: what goes in comes out. */
#include "common/bernstein.h"
#include "common/curve.h"
#include "common/revolved.h"
#include "common/turns.h"

/* Heights, the Bernstein coefficients of the squared radius between them, and the largest of these. */
typedef common_revolved_piece piece;

typedef struct sor {
    uint32_t count;
    piece *at;
    common_boxed boxed;
    common_revolved filter;
    double wide;
    pov_two low, high;             /* heights of the ends, scaled */
    bool open;
} sor;

/* Caps are features beyond the pieces. */
enum { LOW_CAP = 0x7ffffffe, HIGH_CAP = 0x7fffffff };

/* The box is by so much wider: on its sides no ray meets the surface. */
static const double NEAR = 0x1p-30, BESIDE = 1.0 + 0x1p-32;

/* ---- loading ---- */

static double slope_at(const double (*p)[2], uint32_t j)
{
    return 2.0 * p[j][0] * (p[j + 1][0] - p[j - 1][0]) / (p[j + 1][1] - p[j - 1][1]);
}

/* The first and the last point may be anywhere but at the height of the second but one. */
static bool is_usable(const double (*p)[2], uint32_t n)
{
    bool good = n >= 4 && p[0][1] != p[2][1] && p[n - 1][1] != p[n - 3][1];

    for (uint32_t i = 0; good && i < n; i++)
        good = p[i][0] >= 0.0 && (i < 2 || i + 1 == n || p[i][1] > p[i - 1][1]);
    return good;
}

static void make_piece(const sor *s, piece *out, const double (*p)[2], uint32_t i)
{
    const double length = (p[i + 1][1] - p[i][1]) / 3.0, area = s->boxed.scale * s->boxed.scale;
    double least = HUGE_VAL;

    out->low = (p[i][1] - s->boxed.anchor.y.hi) * s->boxed.scale;
    out->high = (p[i + 1][1] - s->boxed.anchor.y.hi) * s->boxed.scale;
    out->square[0] = p[i][0] * p[i][0] * area;
    out->square[3] = p[i + 1][0] * p[i + 1][0] * area;
    out->square[1] = out->square[0] + slope_at(p, i) * length * area;
    out->square[2] = out->square[3] - slope_at(p, i + 1) * length * area;
    out->widest = 0.0;
    common_bernstein_widen(out->square, 3, &least, &out->widest);
}

static void make(sor *s, const pov_host *host, pov_reader *in, const double (*p)[2], uint32_t n)
{
    const double low = p[1][1], high = p[n - 2][1];
    double wide = 0.0;

    s->at = host->alloc(in, (n - 3) * sizeof *s->at);
    if (!s->at)
        return;
    s->count = n - 3;
    s->boxed.anchor.y.hi = 0.5 * (low + high);
    s->boxed.scale = 1.0;
    for (int turn = 0; turn < 2; turn++) {
        for (uint32_t i = 0; i < s->count; i++) {
            make_piece(s, &s->at[i], p, i + 1);
            wide = pov_max(wide, s->at[i].widest);
        }
        s->wide = sqrt(wide) * BESIDE;
        if (turn == 0)
            s->boxed.scale = pov_inverse_power(pov_max(s->wide, high - low));
        wide = 0.0;
    }
    s->low = pov_two_scale(pov_two_sum(low, -s->boxed.anchor.y.hi), s->boxed.scale);
    s->high = pov_two_scale(pov_two_sum(high, -s->boxed.anchor.y.hi), s->boxed.scale);
    s->boxed.lo = pov_vec3_of(-s->wide, s->low.hi, -s->wide);
    s->boxed.hi = pov_vec3_of(s->wide, s->high.hi, s->wide);
}

static void make_filter(sor *s, const pov_host *host, pov_reader *in)
{
    common_revolved *f = &s->filter;
    const double ends[2] = { s->at[0].square[0], s->at[s->count - 1].square[3] };

    f->at = host->alloc(in, (s->count + 2) * sizeof *f->at);
    for (uint32_t i = 0; f->at && i < s->count; i++)
        common_revolved_curve(&f->at[f->count++], s->at[i].low, s->at[i].high, s->at[i].square, i);
    for (uint32_t k = 0; f->at && !s->open && k < 2; k++)
        common_revolved_ring(&f->at[f->count++], k ? s->high.hi : s->low.hi, 0.0, sqrt(ends[k]), k ? HIGH_CAP : LOW_CAP);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    sor *s = self;
    uint32_t n;
    double (*at)[2] = common_points_read(host, in, &n);
    bool read = true;

    if (at && !is_usable((const double (*)[2])at, n))
        host->fail(in, "a sor needs at least 4 points, radii that are not negative, and heights that rise between the first and the last");
    else if (at)
        make(s, host, in, (const double (*)[2])at, n);
    while (read) {
        read = common_sturm_read(host, in);
        if (host->accept(in, "open"))
            read = s->open = true;
    }
    if (s->at)
        make_filter(s, host, in);
}

static bool bounds(const void *self, pov_box *out)
{
    const sor *s = self;
    const double back = common_inverse(s->boxed.scale), wide = common_above(s->wide * back);

    out->lo = pov_vec3_of(-wide, common_below(s->low.hi * back + s->boxed.anchor.y.hi), -wide);
    out->hi = pov_vec3_of(wide, common_above(s->high.hi * back + s->boxed.anchor.y.hi), wide);
    return true;
}

/* ---- along a ray ---- */

typedef struct line {
    const common_ray *k;
    pov_vec3 o, d;
    double base;
    common_span span;            /* within the box, from the base */
    uint32_t origin;             /* the feature that the ray starts on */
    double a, b, c, foot;        /* the square of the distance to the axis: a t^2 + 2 b t + c, least at the foot */
    common_wanted wanted;
} line;

/* The square of the distance to the axis, and its half mixed with another point. */
static double across(pov_vec3 a, pov_vec3 b) { return a.x * b.x + a.z * b.z; }

static void make_line(line *n, const common_entry *e, const pov_ray *ray, const pov_hits *hits)
{
    const common_ray *k = &e->k;

    n->k = k;
    n->origin = ray->origin_surface == hits->owner ? ray->origin_mark.feature : UINT32_MAX;
    n->base = n->origin != UINT32_MAX ? 0.0 : e->span.lo;
    n->o = common_along(k, n->base);
    n->d = k->d;
    n->span.lo = e->span.lo - n->base;
    n->span.hi = e->span.hi - n->base;
    n->a = across(n->d, n->d);
    n->b = across(n->o, n->d);
    n->c = across(n->o, n->o);
    n->foot = n->a > 0.0 ? -n->b / n->a : 0.0;
    n->wanted = common_wants(k, n->base, n->origin != UINT32_MAX ? NEAR : -HUGE_VAL, hits);
}

static double mix(double a, double b, double t) { return (1.0 - t) * a + t * b; }

/* The cubic's Bernstein coefficients from an end to a parameter. */
static void restrict_half(const double *b, double t, bool from_start, double *out)
{
    const double p = mix(b[0], b[1], t), q = mix(b[1], b[2], t), r = mix(b[2], b[3], t), left = mix(p, q, t), right = mix(q, r, t);

    out[0] = from_start ? b[0] : b[3];
    out[1] = from_start ? p : r;
    out[2] = from_start ? left : right;
    out[3] = mix(left, right, t);
}

/* Between two parameters inside. */
static void restrict_inside(const double *b, double from, double to, double *out)
{
    double t[3] = { from, from, from };

    for (int k = 0; k < 4; k++) {
        double w[4] = { b[0], b[1], b[2], b[3] };

        for (int j = 0; j < 3; j++)
            for (int i = 0; i < 3 - j; i++)
                w[i] = mix(w[i], w[i + 1], t[j]);
        out[k] = w[0];
        if (k < 3)
            t[k] = to;
    }
}

static void restrict_to(const double *b, double from, double to, double *out)
{
    double back[4];

    if (from == 0.0 || from == 1.0) {
        restrict_half(b, to, from == 0.0, out);
    } else if (to == 0.0 || to == 1.0) {
        restrict_half(b, from, to == 0.0, back);
        for (int k = 0; k < 4; k++)
            out[k] = back[3 - k];
    } else {
        restrict_inside(b, from, to, out);
    }
}

/* A stretch of the ray within a piece's slab and the box. */
typedef struct stretch { double lo, hi, from, to; } stretch;

/* False: there is none, or it begins too far away. */
static bool find_stretch(const line *n, const piece *p, stretch *out)
{
    const bool rises = n->d.y > 0.0, level = n->d.y == 0.0;
    const double least = ((rises ? p->low : p->high) - n->o.y) / n->d.y;
    double most;

    out->lo = n->span.lo;
    out->hi = n->span.hi;
    if (level ? !(n->o.y >= p->low && n->o.y < p->high) : !(least < out->hi) || least > n->wanted.far)
        return false;
    most = ((rises ? p->high : p->low) - n->o.y) / n->d.y;
    if (!level && !(most > out->lo))
        return false;
    if (!level && least > out->lo) {
        out->lo = least;
        out->from = rises ? 0.0 : 1.0;
    } else {
        out->from = (n->o.y + out->lo * n->d.y - p->low) / (p->high - p->low);
    }
    if (!level && most < out->hi) {
        out->hi = most;
        out->to = rises ? 1.0 : 0.0;
    } else {
        out->to = (n->o.y + out->hi * n->d.y - p->low) / (p->high - p->low);
    }
    return out->lo < out->hi;
}

/* Is the ray farther from the axis than the piece all along the stretch? */
static bool passes(const line *n, const piece *p, const stretch *s)
{
    const double t = n->foot > s->lo ? n->foot < s->hi ? n->foot : s->hi : s->lo;

    return (n->a * t + 2.0 * n->b) * t + n->c > p->widest * (1.0 + 0x1p-30) + 0x1p-40;
}

/* `is_own`: the ray starts on the piece. That root is divided out. */
static uint32_t cross_piece(const line *n, const piece *p, bool is_own, double *root)
{
    double c[4], h[4], noise, enough, within;
    pov_vec3 a, b;
    stretch s;
    uint32_t found;

    if (!find_stretch(n, p, &s) || s.lo > n->wanted.far || passes(n, p, &s))
        return 0;
    a = pov_add(n->o, pov_scale(n->d, s.lo));
    b = pov_add(n->o, pov_scale(n->d, s.hi));
    restrict_to(p->square, s.from, s.to, h);
    c[0] = across(a, a) - h[0];
    c[1] = (across(a, a) + 2.0 * across(a, b)) / 3.0 - h[1];
    c[2] = (across(b, b) + 2.0 * across(a, b)) / 3.0 - h[2];
    c[3] = across(b, b) - h[3];
    if (c[0] > 0.0 && c[1] > 0.0 && c[2] > 0.0 && c[3] > 0.0)
        return 0;
    noise = common_bernstein_noise(c, 3);
    enough = (n->wanted.enough - s.lo) / (s.hi - s.lo);
    within = (n->wanted.within - s.lo) / (s.hi - s.lo);
    if (is_own && s.lo <= 0.0 && s.hi >= 0.0) {
        common_bernstein_divide(c, 3, -s.lo / (s.hi - s.lo), h);
        found = common_bernstein_first(h, 2, 3.0 * noise, enough, within, root);
    } else {
        found = common_bernstein_first(c, 3, noise, enough, within, root);
    }
    for (uint32_t i = 0; i < found; i++)
        root[i] = s.lo + root[i] * (s.hi - s.lo);
    return found;
}

static bool report(const line *n, pov_two t, uint32_t feature, pov_hits *hits)
{
    const pov_mark mark = { feature, 0, 0.0, 0.0 };

    return pov_cross(hits, t.hi * n->k->unit, t.lo * n->k->unit, mark);
}

static bool report_cap(const line *n, const sor *s, bool is_high, pov_hits *hits)
{
    const piece *p = &s->at[is_high ? s->count - 1 : 0];
    const uint32_t feature = is_high ? HIGH_CAP : LOW_CAP;
    const pov_two3 dir = common_direction(n->k);
    const double at = ((is_high ? p->high : p->low) - n->o.y) / n->d.y;
    const pov_vec3 q = pov_add(n->o, pov_scale(n->d, at));

    if (s->open || n->origin == feature || n->d.y == 0.0 || !(across(q, q) < p->square[is_high ? 3 : 0]))
        return true;
    return report(n, pov_two_div(pov_two_sub(is_high ? s->high : s->low, n->k->f.y), dir.y), feature, hits);
}

/* Does the ray start there, beside the end of another piece, or on its own? */
static bool is_start(const line *n, uint32_t piece_at, double root)
{
    return n->origin < LOW_CAP && fabs(root) < (n->origin == piece_at ? NEAR : 0x1p-44);
}

static void cross(const void *self, const pov_ray *ray, const common_entry *e, pov_hits *hits)
{
    const sor *s = self;
    line n;

    make_line(&n, e, ray, hits);
    for (uint32_t part = 0; part < s->count; part++) {
        const uint32_t i = n.d.y < 0.0 ? s->count - 1 - part : part;   /* nearer ones first */
        double root[3];
        const uint32_t found = cross_piece(&n, &s->at[i], i == n.origin, root);

        for (uint32_t j = 0; j < found; j++)
            if (!is_start(&n, i, root[j]) && !report(&n, pov_two_sum(n.base, root[j]), i, hits))
                return;
        if (found > 0)
            n.wanted.far = common_wants(n.k, n.base, 0.0, hits).far;
    }
    if (report_cap(&n, s, false, hits))
        report_cap(&n, s, true, hits);
}

static void first(const void *self, const common_entries *restrict l, common_first_crossings *restrict out)
{
    const sor *s = self;
    const common_revolved_pieces all = { s->count, s->at, s->low, s->high, LOW_CAP, s->open };

    common_revolved_first(&all, l, out);
}

static uint32_t narrow(const void *self, const pov_own_map *map, uint32_t owner, const pov_rays *rays, pov_candidate *io, uint32_t n)
{
    const sor *s = self;

    return common_narrow(&s->boxed, common_revolved_look, &s->filter, map, owner, rays, io, n);
}

/* ---- points ---- */

/* The cubic and its slope at a height of the piece. */
static double square_at(const piece *p, double y, double *slope)
{
    const double length = p->high - p->low, u = (y - p->low) / length, v = 1.0 - u, *b = p->square;

    *slope = 3.0 * (((b[1] - b[0]) * v + 2.0 * (b[2] - b[1]) * u) * v + (b[3] - b[2]) * u * u) / length;
    return ((b[0] * v + 3.0 * b[1] * u) * v + 3.0 * b[2] * u * u) * v + b[3] * u * u * u;
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const sor *s = self;
    const pov_vec3 p = pov_two3_hi(common_offset(point, point_lo, s->boxed.anchor, s->boxed.scale));
    double slope;

    for (uint32_t i = 0; i < s->count; i++)
        if (p.y >= s->at[i].low && p.y <= s->at[i].high)
            return across(p, p) <= square_at(&s->at[i], p.y, &slope);
    return false;
}

static void normal_at(const void *self, pov_vec3 p, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const sor *s = self;
    double slope;

    if (at->mark.feature >= LOW_CAP) {
        *out = pov_vec3_of(0.0, at->mark.feature == LOW_CAP ? -1.0 : 1.0, 0.0);
        return;
    }
    square_at(&s->at[at->mark.feature], p.y, &slope);
    *out = pov_unit(pov_vec3_of(2.0 * p.x, -slope, 2.0 * p.z));
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

COMMON_ROUND_CLASS(sor, cross, first, false, narrow, normal_at)

static bool open(const void *self) { return ((const sor *)self)->open; }

/* Caps go on from their rims, by 1 to the axis, as in POV-Ray. */
static void uv(const void *self, pov_vec3 point, const pov_mark *mark, double out[2])
{
    const sor *s = self;
    const uint32_t i = mark->feature;
    const double y = (point.y - s->boxed.anchor.y.hi) * s->boxed.scale, r = sqrt(point.x * point.x + point.z * point.z) * s->boxed.scale;

    out[0] = common_whole_turn(point.z, point.x);
    if (i == LOW_CAP)
        out[1] = r / sqrt(s->at[0].square[0]) - 1.0;
    else if (i == HIGH_CAP)
        out[1] = 2.0 - r / sqrt(s->at[s->count - 1].square[3]);
    else
        out[1] = (i + (y - s->at[i].low) / (s->at[i].high - s->at[i].low)) / s->count;
}

static const pov_shape_class sor_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "sor",
    .instance_size = sizeof(sor),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .open = open,
    .extension = extension,
    .uv = uv,
};

static const pov_shape_class *const shapes[] = { &sor_class, NULL };

POV_PLUGIN(sor) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "sor",
    .version = "1",
    .shapes = shapes,
};
