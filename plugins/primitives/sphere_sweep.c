/* sphere_sweep { spline n, <centre>, radius, ... [tolerance t] }: all spheres whose centre and radius lie on a spline.
 *
 * A ray is within the sphere at u from s - sqrt(D) to s + sqrt(D), where s is where it passes the centre and D a polynomial in
 * u. Where D is not negative over a stretch of u, the spheres overlap one another, and the ray is within their union
 * from the least entry to the greatest exit. These are at the ends of the stretch, or where their slope is zero: roots
 * of another polynomial. So the ray is within each piece in intervals, and within the sweep in their union. */
#include "common/bernstein.h"
#include "common/clip.h"

enum { DEGREE = 3, FIELD = 2 * DEGREE, SLOPE = 2 * (2 * FIELD - 2), STRETCHES = FIELD / 2 + 1 };

/* Centre and radius as polynomials of u, and a box around them. */
typedef struct piece { double c[4][DEGREE + 1]; pov_vec3 lo, hi; } piece;

typedef struct sweep {
    uint32_t count;
    int degree;
    piece *at;
    pov_vec3 lo, hi;
    pov_two3 anchor;
    double scale;
} sweep;

static const double NEAR = 0x1p-24, BESIDE = 0x1p-40;   /* a grazed end is off by a root of the rounding */

/* ---- loading ---- */

typedef struct control { double v[4]; } control;

/* What a spline makes of its points: rows by power of u, columns by point. */
static const double linear[4][4] = { { 0.0, 1.0, 0.0, 0.0 }, { 0.0, -1.0, 1.0, 0.0 } };
static const double cubic[4][4] = { { 0.0, 1.0, 0.0, 0.0 }, { -0.5, 0.0, 0.5, 0.0 }, { 1.0, -2.5, 2.0, -0.5 }, { -0.5, 1.5, -1.5, 0.5 } };
static const double b_spline[4][4] = { { 1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0, 0.0 }, { -0.5, 0.0, 0.5, 0.0 },
                                       { 0.5, -1.0, 0.5, 0.0 }, { -1.0 / 6.0, 0.5, -0.5, 1.0 / 6.0 } };

static control *read_points(const pov_host *host, pov_reader *in, uint32_t *count)
{
    const double n = host->number(in);
    control *at;

    *count = n >= 2.0 && n <= 1e6 && n == floor(n) ? (uint32_t)n : 0;
    if (*count == 0)
        host->fail(in, "a sphere_sweep needs a whole number of at least 2 spheres");
    at = host->alloc(in, (*count + 2) * sizeof *at);
    for (uint32_t i = 0; at && i < *count; i++) {
        pov_vec3 centre;

        host->accept(in, ",");
        host->vector(in, &centre);
        host->accept(in, ",");
        at[i + 1].v[0] = centre.x;
        at[i + 1].v[1] = centre.y;
        at[i + 1].v[2] = centre.z;
        at[i + 1].v[3] = fabs(host->number(in));
    }
    return at;
}

/* A box around the Bezier points of both curves that are a radius from the centres, along each axis. */
static void find_box(const sweep *s, piece *p)
{
    double b[4][DEGREE + 1], lo[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL }, hi[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL }, beside = 0.0;

    for (int i = 0; i < 4; i++)
        common_bernstein(p->c[i], s->degree, b[i]);
    for (int k = 0; k <= s->degree; k++) {
        const double radius = fabs(b[3][k]);

        beside = pov_max(beside, radius * 0x1p-40);
        for (int i = 0; i < 3; i++) {
            lo[i] = pov_min(lo[i], b[i][k] - radius);
            hi[i] = pov_max(hi[i], b[i][k] + radius);
        }
    }
    p->lo = pov_vec3_of(lo[0] - beside, lo[1] - beside, lo[2] - beside);
    p->hi = pov_vec3_of(hi[0] + beside, hi[1] + beside, hi[2] + beside);
}

/* points: one before those of the piece comes first. */
static void make_piece(const sweep *s, piece *p, const double (*m)[4], const control *points)
{
    const double middle[4] = { s->anchor.x.hi, s->anchor.y.hi, s->anchor.z.hi, 0.0 };

    for (int i = 0; i < 4; i++)
        for (int k = 0; k <= s->degree; k++) {
            double sum = 0.0;

            for (int j = 0; j < 4; j++)
                sum += m[k][j] != 0.0 ? m[k][j] * (points[j].v[i] - middle[i]) * s->scale : 0.0;
            p->c[i][k] = sum;
        }
    find_box(s, p);
}

static void make(sweep *s, const double (*m)[4], const control *points)
{
    for (uint32_t i = 0; i < s->count; i++) {
        piece *p = &s->at[i];

        make_piece(s, p, m, points + i);
        s->lo = i == 0 ? p->lo : pov_vec3_of(pov_min(s->lo.x, p->lo.x), pov_min(s->lo.y, p->lo.y), pov_min(s->lo.z, p->lo.z));
        s->hi = i == 0 ? p->hi : pov_vec3_of(pov_max(s->hi.x, p->hi.x), pov_max(s->hi.y, p->hi.y), pov_max(s->hi.z, p->hi.z));
    }
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const bool is_linear = host->accept(in, "linear_spline"), is_cubic = !is_linear && host->accept(in, "cubic_spline");
    const double (*m)[4] = is_linear ? linear : is_cubic ? cubic : b_spline;
    sweep *s = self;
    control *points;
    uint32_t n;

    if (!is_linear && !is_cubic && !host->accept(in, "b_spline"))
        host->fail(in, "a sphere_sweep begins with linear_spline, cubic_spline or b_spline");
    host->accept(in, ",");
    points = read_points(host, in, &n);
    if (host->accept(in, "tolerance"))
        host->number(in);
    if (!points)
        return;
    if (!is_linear && n < 4) {
        host->fail(in, "a sphere_sweep of this spline needs at least 4 spheres");
        return;
    }
    s->degree = is_linear ? 1 : DEGREE;
    s->count = is_linear ? n - 1 : n - 3;
    s->at = host->alloc(in, s->count * sizeof *s->at);
    if (!s->at)
        return;
    s->scale = 1.0;
    make(s, m, is_linear ? points : points + 1);
    s->scale = pov_inverse_power(pov_largest(pov_sub(s->hi, s->lo)));
    s->anchor = pov_two3_of(pov_scale(pov_add(s->lo, s->hi), 0.5), zero);
    make(s, m, is_linear ? points : points + 1);
}

static bool bounds(const void *self, pov_box *out)
{
    const sweep *s = self;
    const pov_vec3 middle = pov_two3_hi(s->anchor), lo = pov_add(pov_scale(s->lo, 1.0 / s->scale), middle);
    const pov_vec3 hi = pov_add(pov_scale(s->hi, 1.0 / s->scale), middle);

    out->lo = pov_vec3_of(common_below(lo.x), common_below(lo.y), common_below(lo.z));
    out->hi = pov_vec3_of(common_above(hi.x), common_above(hi.y), common_above(hi.z));
    return true;
}

/* ---- polynomials ---- */

COMMON_INLINE void multiply(const double *a, int m, const double *b, int n, double *out)
{
    for (int k = 0; k <= m + n; k++)
        out[k] = 0.0;
    for (int i = 0; i <= m; i++)
        for (int k = 0; k <= n; k++)
            out[i + k] += a[i] * b[k];
}

COMMON_INLINE double value_of(const double *a, int n, double u)
{
    double sum = a[n];

    for (int i = n - 1; i >= 0; i--)
        sum = sum * u + a[i];
    return sum;
}

COMMON_INLINE uint32_t roots_of(const double *a, int n, double *root)
{
    double b[SLOPE + 1];

    while (n > 0 && a[n] == 0.0)
        n--;
    if (n == 0)
        return 0;
    common_bernstein(a, n, b);
    return common_bernstein_roots(b, n, common_bernstein_noise(b, n), root);
}

/* ---- along a ray ---- */

typedef struct interval { double lo, hi, u_lo, u_hi; uint32_t piece_lo, piece_hi; } interval;

/* The ray from a point near, along a direction of length one. */
typedef struct line { pov_vec3 o, d; double base, unit; const common_ray *k; uint32_t flags; } line;

/* Where it passes the centre, and the square of half its way within the sphere. */
COMMON_INLINE void find_field(const line *n, const piece *p, int degree, double *pass, double *field)
{
    double w[3][DEGREE + 1], square[FIELD + 1];
    const double o[3] = { n->o.x, n->o.y, n->o.z }, d[3] = { n->d.x, n->d.y, n->d.z };

    for (int k = 0; k <= degree; k++) {
        pass[k] = 0.0;
        for (int i = 0; i < 3; i++) {
            w[i][k] = p->c[i][k] - (k == 0 ? o[i] : 0.0);
            pass[k] += w[i][k] * d[i];
        }
    }
    multiply(p->c[3], degree, p->c[3], degree, field);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k <= degree; k++)
            w[i][k] -= pass[k] * d[i];
        multiply(w[i], degree, w[i], degree, square);
        for (int k = 0; k <= 2 * degree; k++)
            field[k] -= square[k];
    }
}

/* Where entry or exit may be extreme: 4 D pass'^2 = D'^2. */
COMMON_INLINE uint32_t find_extremes(const double *pass, const double *field, int degree, double *root)
{
    double slope[FIELD], pass_slope[DEGREE], square[FIELD], left[SLOPE + 1], right[SLOPE + 1];
    const int n = 2 * degree;

    for (int k = 1; k <= n; k++)
        slope[k - 1] = k * field[k];
    for (int k = 1; k <= degree; k++)
        pass_slope[k - 1] = k * pass[k];
    multiply(pass_slope, degree - 1, pass_slope, degree - 1, square);
    multiply(field, n, square, n - 2, left);
    multiply(slope, n - 1, slope, n - 1, right);
    for (int k = 0; k <= 2 * n - 2; k++)
        left[k] = 4.0 * left[k] - right[k];
    return roots_of(left, 2 * n - 2, root);
}

static inline double root_of(double square) { return square > 0.0 ? sqrt(square) : 0.0; }

COMMON_INLINE void widen(interval *v, const double *pass, const double *field, int degree, double u)
{
    const double middle = value_of(pass, degree, u), half = root_of(value_of(field, 2 * degree, u));

    if (middle - half < v->lo) {
        v->lo = middle - half;
        v->u_lo = u;
    }
    if (middle + half > v->hi) {
        v->hi = middle + half;
        v->u_hi = u;
    }
}

/* How the entry grows with u, times a number above zero; `side` -1. Or how the exit does; 1. */
static double growth_of(const double *pass, const double *field, int degree, double u, double side)
{
    double pass_slope = degree * pass[degree], slope = 2 * degree * field[2 * degree];

    for (int k = degree - 1; k > 0; k--)
        pass_slope = pass_slope * u + k * pass[k];
    for (int k = 2 * degree - 1; k > 0; k--)
        slope = slope * u + k * field[k];
    return 2.0 * root_of(value_of(field, 2 * degree, u)) * pass_slope + side * slope;
}

/* Of a stretch without an extreme: the polynomial for these hides two in its noise where the ray hardly comes within the spheres. Its
 * ends tell whether there is a least entry, or a greatest exit, in between. */
static void seek_extreme(interval *v, const double *pass, const double *field, int degree, double from, double to, double side)
{
    enum { HALVINGS = 40 };

    if (!(side * growth_of(pass, field, degree, from, side) > 0.0 && side * growth_of(pass, field, degree, to, side) < 0.0))
        return;
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = 0.5 * (from + to);

        if (side * growth_of(pass, field, degree, middle, side) > 0.0)
            from = middle;
        else
            to = middle;
    }
    widen(v, pass, field, degree, from);
}

COMMON_INLINE uint32_t intervals_of(const line *n, const sweep *s, int degree, uint32_t number, interval *out)
{
    const piece *p = &s->at[number];
    double pass[DEGREE + 1], field[FIELD + 1], end[FIELD + 2], extreme[SLOPE];
    uint32_t ends = 0, extremes, count = 0;

    find_field(n, p, degree, pass, field);
    end[0] = 0.0;
    ends = 1 + roots_of(field, 2 * degree, end + 1);
    end[ends] = 1.0;
    if (ends == 1 && !(value_of(field, 2 * degree, 0.5) >= 0.0))
        return 0;
    extremes = find_extremes(pass, field, degree, extreme);
    for (uint32_t i = 0; i < ends; i++) {
        interval v = { HUGE_VAL, -HUGE_VAL, 0.0, 0.0, number, number };
        bool turns = false;

        if (!(value_of(field, 2 * degree, 0.5 * (end[i] + end[i + 1])) >= 0.0))
            continue;
        widen(&v, pass, field, degree, end[i]);
        widen(&v, pass, field, degree, end[i + 1]);
        for (uint32_t j = 0; j < extremes; j++)
            if (extreme[j] > end[i] && extreme[j] < end[i + 1]) {
                widen(&v, pass, field, degree, extreme[j]);
                turns = true;
            }
        for (int side = -1; !turns && side <= 1; side += 2)
            seek_extreme(&v, pass, field, degree, end[i], end[i + 1], side);
        out[count++] = v;
    }
    return count;
}

/* The loops of each degree are unrolled. */
static uint32_t find_intervals(const line *n, const sweep *s, uint32_t number, interval *out)
{
    return s->degree == 1 ? intervals_of(n, s, 1, number, out) : intervals_of(n, s, DEGREE, number, out);
}

static size_t scratch(const void *self) { return ((const sweep *)self)->count * STRETCHES * sizeof(interval); }

/* Put it among the others, in order, one with those that it touches. */
static uint32_t unite(interval *at, uint32_t count, interval v)
{
    uint32_t i = 0, j;

    while (i < count && at[i].hi < v.lo)
        i++;
    for (j = i; j < count && at[j].lo <= v.hi; j++) {
        if (at[j].lo < v.lo) {
            v.lo = at[j].lo;
            v.u_lo = at[j].u_lo;
            v.piece_lo = at[j].piece_lo;
        }
        if (at[j].hi > v.hi) {
            v.hi = at[j].hi;
            v.u_hi = at[j].u_hi;
            v.piece_hi = at[j].piece_hi;
        }
    }
    memmove(at + i + 1, at + j, (count - j) * sizeof *at);
    at[i] = v;
    return count + 1 - (j - i);
}

static bool report(const line *n, double s, uint32_t number, double u, pov_hits *hits)
{
    const pov_two t = pov_two_sum(n->base, s * n->unit);
    const pov_mark mark = { number, n->flags, u, 0.0 };

    return pov_cross(hits, t.hi * n->k->unit, t.lo * n->k->unit, mark);
}

/* Is it the crossing that the ray starts on? */
static bool is_start(const pov_ray *ray, bool from_here, double s, uint32_t number)
{
    return from_here && fabs(s) < (number == ray->origin_mark.feature ? NEAR : BESIDE);
}

/* Does the line certainly pass beside all spheres of a linear piece? Squares of radii less those of distances, by the square of the
 * direction's length, are a polynomial of degree two: its Bernstein coefficients are below zero. */
static bool misses_piece(const piece *p, const common_ray *k)
{
    const pov_vec3 f = pov_two3_hi(k->f), d = k->d, from = pov_sub(pov_vec3_of(p->c[0][0], p->c[1][0], p->c[2][0]), f);
    const pov_vec3 a = pov_cross_product(from, d), b = pov_add(a, pov_cross_product(pov_vec3_of(p->c[0][1], p->c[1][1], p->c[2][1]), d));
    const double r = p->c[3][0], q = r + p->c[3][1], dd = pov_dot(d, d), size = 1.0 + pov_largest(f), off = 0x1p-40 * dd * size * size;

    return r * r * dd - pov_dot(a, a) < -off && r * q * dd - pov_dot(a, b) < -off && q * q * dd - pov_dot(b, b) < -off;
}

/* The first piece that the line may pass; their number if there is none. Only linear ones tell. */
static uint32_t first_piece(const sweep *s, const common_ray *k)
{
    uint32_t i = 0;

    while (s->degree == 1 && i < s->count && misses_piece(&s->at[i], k))
        i++;
    return i;
}

static bool may_hit(const sweep *s, uint32_t i, const common_ray *k)
{
    common_span own;

    return s->degree == 1 ? !misses_piece(&s->at[i], k) : common_clip(k, s->at[i].lo, s->at[i].hi, &own);
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const sweep *s = self;
    const common_ray k = common_enter(ray, s->anchor, s->scale);
    const bool from_here = ray->origin_surface == hits->owner;
    interval *at = hits->scratch, found[STRETCHES];
    const uint32_t first = first_piece(s, &k);
    common_span span;
    uint32_t count = 0;
    line n;

    if (first == s->count || !common_clip(&k, s->lo, s->hi, &span) || span.hi < 0.0 || span.lo * k.unit > hits->tmax)
        return;
    n.k = &k;
    n.flags = s->count == 1 && s->degree == 1 ? POV_MARK_CLOSED : 0;   /* it is the convex hull of two spheres */
    n.base = from_here ? 0.0 : span.lo;
    n.unit = 1.0 / sqrt(pov_dot(k.d, k.d));
    n.o = common_along(&k, n.base);
    n.d = pov_scale(k.d, n.unit);
    for (uint32_t i = first; i < s->count; i++) {
        const bool is_told = i == first && (s->degree == 1 || s->count == 1);
        const uint32_t more = is_told || may_hit(s, i, &k) ? find_intervals(&n, s, i, found) : 0;

        for (uint32_t j = 0; j < more; j++)
            count = unite(at, count, found[j]);
    }
    for (uint32_t i = 0; i < count; i++) {
        if (!is_start(ray, from_here, at[i].lo, at[i].piece_lo) && !report(&n, at[i].lo, at[i].piece_lo, at[i].u_lo, hits))
            return;
        if (!is_start(ray, from_here, at[i].hi, at[i].piece_hi) && !report(&n, at[i].hi, at[i].piece_hi, at[i].u_hi, hits))
            return;
    }
}

/* ---- points ---- */

static pov_vec3 centre_at(const sweep *s, const piece *p, double u)
{
    return pov_vec3_of(value_of(p->c[0], s->degree, u), value_of(p->c[1], s->degree, u), value_of(p->c[2], s->degree, u));
}

/* Is the point in a sphere of the piece? Its depth in them is a polynomial, which is above 0 somewhere. */
static bool is_in(const sweep *s, const piece *p, pov_vec3 at)
{
    const double point[3] = { at.x, at.y, at.z };
    double field[FIELD + 1], square[FIELD + 1], w[DEGREE + 1], root[FIELD];

    multiply(p->c[3], s->degree, p->c[3], s->degree, field);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k <= s->degree; k++)
            w[k] = p->c[i][k] - (k == 0 ? point[i] : 0.0);
        multiply(w, s->degree, w, s->degree, square);
        for (int k = 0; k <= 2 * s->degree; k++)
            field[k] -= square[k];
    }
    return field[0] >= 0.0 || value_of(field, 2 * s->degree, 1.0) >= 0.0 || roots_of(field, 2 * s->degree, root) > 0;
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const sweep *s = self;
    const pov_vec3 p = pov_two3_hi(common_offset(point, point_lo, s->anchor, s->scale));

    for (uint32_t i = 0; i < s->count; i++)
        if (is_in(s, &s->at[i], p))
            return true;
    return false;
}

/* Away from the centre of the sphere there. */
static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const sweep *s = self;
    const common_ray k = common_enter(ray, s->anchor, s->scale);
    const pov_vec3 p = pov_two3_hi(common_point(&k, at));

    *out = pov_unit(pov_sub(p, centre_at(s, &s->at[at->mark.feature], at->mark.u)));
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

static const pov_shape_class sphere_sweep_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "sphere_sweep",
    .instance_size = sizeof(sweep),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .scratch = scratch,
};

static const pov_shape_class *const shapes[] = { &sphere_sweep_class, NULL };

POV_PLUGIN(sphere_sweep) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "sphere_sweep",
    .version = "1",
    .shapes = shapes,
};
