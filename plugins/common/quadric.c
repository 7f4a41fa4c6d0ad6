#include "common/quadric_approx.h"

#include "common/affine.h"
#include "common/expansion.h"

static pov_two sum3(pov_two a, pov_two b, pov_two c) { return pov_two_add(pov_two_add(a, b), c); }

/* ---- values ---- */

pov_two3 common_half_gradient(const pov_two *q, pov_two3 p, bool linear)
{
    pov_two3 g;

    g.x = sum3(pov_two_mul(q[A], p.x), half(pov_two_mul(q[D], p.y)), half(pov_two_mul(q[E], p.z)));
    g.y = sum3(pov_two_mul(q[B], p.y), half(pov_two_mul(q[D], p.x)), half(pov_two_mul(q[F], p.z)));
    g.z = sum3(pov_two_mul(q[C], p.z), half(pov_two_mul(q[E], p.x)), half(pov_two_mul(q[F], p.y)));
    if (linear) {
        g.x = pov_two_add(g.x, half(q[G]));
        g.y = pov_two_add(g.y, half(q[H]));
        g.z = pov_two_add(g.z, half(q[I]));
    }
    return g;
}

/* The value at a point with a known half gradient: p . (g + half the linear terms) + J. */
pov_two common_value(const pov_two *q, pov_two3 p, pov_two3 g)
{
    g.x = pov_two_add(g.x, half(q[G]));
    g.y = pov_two_add(g.y, half(q[H]));
    g.z = pov_two_add(g.z, half(q[I]));
    return pov_two_add(pov_two3_dot(p, g), q[J]);
}

/* Adds q a b, each in double-double. */
static void add_term(common_expansion *e, pov_two q, pov_two a, pov_two b)
{
    const double feature[3][2] = { { q.hi, q.lo }, { a.hi, a.lo }, { b.hi, b.lo } };
    int i;

    for (i = 0; i < 8; i++)
        common_expansion_add_product3(e, feature[0][i & 1], feature[1][i >> 1 & 1], feature[2][i >> 2]);
}

pov_two common_exact_value(const pov_two *q, pov_two3 p)
{
    const pov_two one = { 1.0, 0.0 };
    common_expansion e;

    common_expansion_clear(&e);
    add_term(&e, q[A], p.x, p.x);
    add_term(&e, q[B], p.y, p.y);
    add_term(&e, q[C], p.z, p.z);
    add_term(&e, q[D], p.x, p.y);
    add_term(&e, q[E], p.x, p.z);
    add_term(&e, q[F], p.y, p.z);
    add_term(&e, q[G], p.x, one);
    add_term(&e, q[H], p.y, one);
    add_term(&e, q[I], p.z, one);
    add_term(&e, q[J], one, one);
    return common_expansion_two(&e);
}

/* ---- loading ---- */

/* The binary exponent of the largest of n coefficients; a very small number for none. */
static int exponent_of(const pov_two *q, int n)
{
    double largest = 0.0;
    int i, exponent;

    for (i = 0; i < n; i++)
        largest = pov_max(largest, fabs(q[i].hi));
    if (!(largest > 0.0) || !isfinite(largest))
        return -100000;
    frexp(largest, &exponent);
    return exponent;
}

static int larger(int a, int b) { return a > b ? a : b; }

/* Rounded down, so that scaling lengths by a power of two changes the exponent by a whole number. */
static int half_of(int a) { return a >= 0 ? a / 2 : -((1 - a) / 2); }

/* The length at which terms of different order are of the same size. */
static int length_exponent(int second, int first, int constant)
{
    if (second > -100000)
        return first < -90000 && constant < -90000 ? 0 : larger(first - second, half_of(constant - second));
    return first > -100000 && constant > -100000 ? constant - first : 0;
}

/* Exponent of the power of two that a coefficient is multiplied by. */
static int power_of(const common_quadric *s, int i)
{
    return (i < G ? 2 * s->length : i < J ? s->length : 0) - s->largest;
}

/* raw: coefficients about the anchor, as they are. */
static void prepare(common_quadric *s, const pov_two *raw)
{
    pov_box box;
    int second = exponent_of(raw + A, 6), first = exponent_of(raw + G, 3), constant = exponent_of(raw + J, 1);
    int length = length_exponent(second, first, constant), i;

    length = length > 900 ? 900 : length < -900 ? -900 : length;
    s->length = length;
    s->largest = larger(larger(second + 2 * length, first + length), constant);
    s->whole = true;
    s->stiff = false;
    for (i = 0; i < COEFFICIENTS; i++) {
        s->q[i] = pov_two_of(ldexp(raw[i].hi, power_of(s, i)), ldexp(raw[i].lo, power_of(s, i)));
        s->approx[i] = s->q[i].hi;
        s->size[i] = fabs(s->q[i].hi);
        s->whole = s->whole && (raw[i].hi == 0.0 || s->size[i] > 0x1p-900);
        s->stiff = s->stiff || (i < G && raw[i].hi != 0.0 && s->size[i] < 0x1p-180);
    }
    s->sum2 = s->size[A] + s->size[B] + s->size[C] + s->size[D] + s->size[E] + s->size[F];
    s->sum1 = s->size[G] + s->size[H] + s->size[I];
    s->planar = second == -100000;
    s->sizeless = !(s->sum1 > 0.0) && !(s->size[J] > 0.0);
    s->scale = ldexp(1.0, -length);
    s->closed = common_quadric_bounds(s, &box);
}

/* ---- the anchor ---- */

/* Near the centre, if there is one: the extremum along each axis of what remains of the equation with the other
 * coordinates fixed. */
static pov_vec3 near_centre(const pov_two *q)
{
    double m[3][4] = { { q[A].hi, 0.5 * q[D].hi, 0.5 * q[E].hi, -0.5 * q[G].hi },
                       { 0.5 * q[D].hi, q[B].hi, 0.5 * q[F].hi, -0.5 * q[H].hi },
                       { 0.5 * q[E].hi, 0.5 * q[F].hi, q[C].hi, -0.5 * q[I].hi } };
    double x[3] = { 0.0, 0.0, 0.0 };
    bool done[3] = { false, false, false };
    int step, i, j, k;

    for (step = 0; step < 3; step++) {
        int pivot = -1;

        for (i = 0; i < 3; i++) {
            const double own = fabs(i == 0 ? q[A].hi : i == 1 ? q[B].hi : q[C].hi);

            if (!done[i] && fabs(m[i][i]) > 0x1p-20 * own && (pivot < 0 || fabs(m[i][i]) > fabs(m[pivot][pivot])))
                pivot = i;
        }
        if (pivot < 0)
            break;
        done[pivot] = true;
        for (j = 0; j < 3; j++) {
            const double factor = m[j][pivot] / m[pivot][pivot];

            for (k = 0; j != pivot && k < 4; k++)
                m[j][k] -= factor * m[pivot][k];
        }
    }
    for (i = 0; i < 3; i++)
        x[i] = done[i] ? m[i][3] / m[i][i] : 0.0;
    return pov_vec3_of(x[0], x[1], x[2]);
}

/* The sum of n products of up to three factors each, rounded once to double-double. */
static pov_two exact_sum(double (*term)[3], int n)
{
    common_expansion e;
    int i;

    common_expansion_clear(&e);
    for (i = 0; i < n; i++)
        common_expansion_add_product3(&e, term[i][0], term[i][1], term[i][2]);
    return common_expansion_two(&e);
}

/* Expanded about a far centre, the terms cancel to almost nothing at the surface. Expanded exactly about an anchor near
 * the centre, they do not. */
static void normalise(common_quadric *s, pov_two *raw)
{
    const pov_vec3 c = near_centre(raw), zero = { 0.0, 0.0, 0.0 };
    double q[COEFFICIENTS];
    pov_two level;
    int i;

    for (i = 0; i < COEFFICIENTS; i++)
        q[i] = raw[i].hi;
    {
        double x[4][3] = {{2.0 * q[A], c.x, 1.0}, {q[D], c.y, 1.0}, {q[E], c.z, 1.0}, {q[G], 1.0, 1.0}};
        double y[4][3] = {{2.0 * q[B], c.y, 1.0}, {q[D], c.x, 1.0}, {q[F], c.z, 1.0}, {q[H], 1.0, 1.0}};
        double z[4][3] = {{2.0 * q[C], c.z, 1.0}, {q[E], c.x, 1.0}, {q[F], c.y, 1.0}, {q[I], 1.0, 1.0}};
        double all[10][3] = { { q[A], c.x, c.x }, { q[B], c.y, c.y }, { q[C], c.z, c.z }, { q[D], c.x, c.y },
                              { q[E], c.x, c.z }, { q[F], c.y, c.z }, { q[G], c.x, 1.0 }, { q[H], c.y, 1.0 },
                              { q[I], c.z, 1.0 }, { q[J], 1.0, 1.0 } };

        level = exact_sum(all, 10);
        if (!(fabs(level.hi) < fabs(q[J])))
            return;
        raw[G] = exact_sum(x, 4);
        raw[H] = exact_sum(y, 4);
        raw[I] = exact_sum(z, 4);
        raw[J] = level;
    }
    s->anchor = pov_two3_of(c, zero);
}

void common_quadric_make_two(common_quadric *s, const pov_two coefficients[COEFFICIENTS])
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    pov_two raw[COEFFICIENTS];
    int i;

    s->anchor = pov_two3_of(zero, zero);
    for (i = 0; i < COEFFICIENTS; i++)
        raw[i] = coefficients[i];
    normalise(s, raw);
    prepare(s, raw);
}

void common_quadric_make(common_quadric *s, const double coefficients[COEFFICIENTS])
{
    pov_two q[COEFFICIENTS];
    int i;

    for (i = 0; i < COEFFICIENTS; i++)
        q[i] = pov_two_of(coefficients[i], 0.0);
    common_quadric_make_two(s, q);
}

/* ---- bounds, of ellipsoids ---- */

static pov_two minor(pov_two a, pov_two b, pov_two c, pov_two d)
{
    return pov_two_sub(pov_two_mul(a, b), pov_two_mul(c, d));
}

/* Is a pivot clear of rounding, against the diagonal entry that it was reduced from? */
static bool is_transparent(pov_two pivot, pov_two entry) { return pivot.hi > 0x1p-12 * entry.hi && entry.hi > 0.0; }

static bool extent(pov_two anchor, double scale, pov_two middle, pov_two square, double *lo, double *hi)
{
    /* Pivots that lost at most 12 bits have relative errors of at most 2^-60; the margin of a millionth is far more
     * than enough. */
    const double radius = sqrt(square.hi) * (1.0 + 0x1p-20) / scale, centre = anchor.hi + middle.hi / scale;

    *lo = common_below(centre - radius - 8.0 * COMMON_U * (fabs(anchor.hi) + fabs(middle.hi / scale)));
    *hi = common_above(centre + radius + 8.0 * COMMON_U * (fabs(anchor.hi) + fabs(middle.hi / scale)));
    return isfinite(*lo) && isfinite(*hi);
}

/* An ellipsoid: its centre relative to the anchor, the negated value there, the determinant, and minors. */
typedef struct ellipsoid { pov_two3 centre; pov_two level, det, xx, yy, zz; } ellipsoid;

/* False: not an ellipsoid, or nearly degenerate. */
static bool find_ellipsoid(const common_quadric *s, ellipsoid *out)
{
    const pov_two *q = s->q, d = half(q[D]), e = half(q[E]), f = half(q[F]);
    const pov_two xx = minor(q[B], q[C], f, f), yy = minor(q[A], q[C], e, e), zz = minor(q[A], q[B], d, d);
    const pov_two xy = minor(e, f, d, q[C]), xz = minor(d, f, e, q[B]), yz = minor(d, e, f, q[A]);
    const pov_two det = pov_two_add(pov_two_add(pov_two_mul(q[A], xx), pov_two_mul(d, xy)), pov_two_mul(e, xz));
    const pov_two g = half(q[G]), h = half(q[H]), i = half(q[I]);
    pov_two x, y, z, level;

    if (!is_transparent(q[A], q[A]) || !is_transparent(zz, pov_two_mul(q[A], q[B])) ||
        !is_transparent(det, pov_two_mul(zz, q[C]))) return false;
    x = pov_two_div(pov_two_add(pov_two_add(pov_two_mul(xx, g), pov_two_mul(xy, h)), pov_two_mul(xz, i)), det);
    y = pov_two_div(pov_two_add(pov_two_add(pov_two_mul(xy, g), pov_two_mul(yy, h)), pov_two_mul(yz, i)), det);
    z = pov_two_div(pov_two_add(pov_two_add(pov_two_mul(xz, g), pov_two_mul(yz, h)), pov_two_mul(zz, i)), det);
    /* The negated value at the centre. */
    level = pov_two_add(pov_two_add(pov_two_mul(x, g), pov_two_mul(y, h)), pov_two_mul(z, i));
    if (!(level.hi - q[J].hi > 0x1p-40 * (fabs(level.hi) + fabs(q[J].hi))))
        return false;
    out->centre.x = pov_two_neg(x), out->centre.y = pov_two_neg(y), out->centre.z = pov_two_neg(z);
    out->level = pov_two_sub(level, q[J]);
    out->det = det;
    out->xx = xx, out->yy = yy, out->zz = zz;
    return true;
}

bool common_quadric_bounds(const common_quadric *s, pov_box *out)
{
    pov_two level;
    ellipsoid e;

    if (!find_ellipsoid(s, &e))
        return false;
    level = pov_two_div(e.level, e.det);
    return extent(s->anchor.x, s->scale, e.centre.x, pov_two_mul(level, e.xx), &out->lo.x, &out->hi.x)
           && extent(s->anchor.y, s->scale, e.centre.y, pov_two_mul(level, e.yy), &out->lo.y, &out->hi.y)
           && extent(s->anchor.z, s->scale, e.centre.z, pov_two_mul(level, e.zz), &out->lo.z, &out->hi.z);
}

/* The Cholesky factor, with the pivots as quotients of minors. Its square is off by less than 24 u in units of the
 * roots of the diagonal. Pivots are above 2^-12 of their entries, so the least value of the form in these units is
 * above 2^-26, and lengths are off by less than 2^-22. */
bool common_quadric_ellipsoid(const common_quadric *s, pov_ellipsoid *out)
{
    const double *q = s->approx;
    double factor, a, b, c, d, e, f;
    pov_two x, y, z;
    ellipsoid found;

    if (!s->closed || !find_ellipsoid(s, &found))
        return false;
    a = sqrt(q[A]), b = sqrt(found.zz.hi / q[A]), c = sqrt(found.det.hi / found.zz.hi);
    d = 0.5 * q[D] / a, e = 0.5 * q[E] / a, f = (0.5 * q[F] - d * e) / b;
    factor = s->scale / sqrt(found.level.hi);
    out->row[0] = pov_scale(pov_vec3_of(a, d, e), factor);
    out->row[1] = pov_scale(pov_vec3_of(0.0, b, f), factor);
    out->row[2] = pov_scale(pov_vec3_of(0.0, 0.0, c), factor);
    x = pov_two_add(s->anchor.x, pov_two_scale(found.centre.x, 1.0 / s->scale));
    y = pov_two_add(s->anchor.y, pov_two_scale(found.centre.y, 1.0 / s->scale));
    z = pov_two_add(s->anchor.z, pov_two_scale(found.centre.z, 1.0 / s->scale));
    out->centre = pov_vec3_of(x.hi, y.hi, z.hi);
    out->centre_lo = pov_vec3_of(x.lo, y.lo, z.lo);
    return true;
}

/* ---- maps ---- */

static pov_two3 column(const pov_two3 rows[3], int i)
{
    pov_two3 c;

    c.x = i == 0 ? rows[0].x : i == 1 ? rows[0].y : rows[0].z;
    c.y = i == 0 ? rows[1].x : i == 1 ? rows[1].y : rows[1].z;
    c.z = i == 0 ? rows[2].x : i == 1 ? rows[2].y : rows[2].z;
    return c;
}

/* The new matrix is the inverse's transpose times the matrix times the inverse. Maps that change angles much would lose
 * precision in these products, unless they are axial. */
/* a . b, or zero where that is not told from what rounding leaves of zero: errors are taken in proportion to coefficients. */
static pov_two certain_dot(pov_two3 a, pov_two3 b)
{
    const pov_two dot = pov_two3_dot(a, b);
    const double terms = fabs(a.x.hi * b.x.hi) + fabs(a.y.hi * b.y.hi) + fabs(a.z.hi * b.z.hi);
    const pov_two zero = { 0.0, 0.0 };

    return fabs(dot.hi) <= 0x1p-96 * terms ? zero : dot;
}

bool common_quadric_absorb(common_quadric *s, const pov_affine *map)
{
    static const int row_of[6] = { 0, 1, 2, 0, 0, 1 }, column_of[6] = { 0, 1, 2, 1, 2, 2 };
    pov_two3 rows[3], columns[3], linear;
    pov_two old[COEFFICIENTS], raw[COEFFICIENTS];
    int axis[3], i;

    if (!s->whole || (!(common_condition(map) < 1024.0) && !common_is_axial(map, axis)))
        return false;
    common_inverse_linear(map, rows);
    for (i = 0; i < 3; i++)
        columns[i] = column(rows, i);
    for (i = 0; i < COEFFICIENTS; i++)
        old[i] = pov_two_of(ldexp(s->q[i].hi, -power_of(s, i)), ldexp(s->q[i].lo, -power_of(s, i)));
    linear.x = old[G], linear.y = old[H], linear.z = old[I];
    for (i = 0; i < 6; i++) {
        const pov_two3 product = common_half_gradient(old, columns[column_of[i]], false);
        raw[i] = pov_two_scale(pov_two3_dot(columns[row_of[i]], product), i < D ? 1.0 : 2.0);
    }
    for (i = 0; i < 3; i++)
        raw[G + i] = certain_dot(columns[i], linear);
    raw[J] = old[J];
    for (i = 0; i < COEFFICIENTS; i++) {
        if (!isfinite(raw[i].hi) || !isfinite(raw[i].lo))
            return false;
    }
    s->anchor = common_map_point(map, s->anchor);
    prepare(s, raw);
    return true;
}

/* The half-space is gradient . (p - anchor) scale + J <= 0. */
bool common_quadric_half_space(const void *self, pov_half_space *out)
{
    const common_quadric *s = self;
    const pov_vec3 g = { s->q[G].hi, s->q[H].hi, s->q[I].hi };
    const double length = sqrt(pov_dot(g, g));

    if (!s->planar || !(length > 0x1p-100) || !isfinite(length))
        return false;
    out->normal = pov_scale(g, 1.0 / length);
    out->distance = pov_dot(out->normal, pov_two3_hi(s->anchor)) - s->q[J].hi / (length * s->scale);
    return isfinite(out->distance);
}

bool common_quadric_outline(const void *self, pov_outline *out)
{
    const common_quadric *s = self;
    const double *q = s->approx, second = s->scale * s->scale, first = 0.5 * s->scale;
    pov_outline o = { .centre = pov_two3_hi(s->anchor), .constant = q[J], .round = true };
    pov_half_space h;

    if (s->planar) {
        const pov_outline slab = { .lo = { -HUGE_VAL }, .slabs = 1 };

        *out = slab;
        if (!common_quadric_half_space(self, &h))
            return false;
        out->normal[0] = h.normal;
        out->hi[0] = h.distance;
        return true;
    }
    for (int i = 0; i < 6; i++)
        o.square[i] = (i < 3 ? 1.0 : 0.5) * second * q[A + i];
    o.linear = pov_scale(pov_vec3_of(q[G], q[H], q[I]), first);
    *out = o;
    return s->whole && !s->stiff;
}
