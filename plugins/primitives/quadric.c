/* quadric { <A,B,C>, <D,E,F>, <G,H,I>, J }: A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z +
 * J = 0, inside where it is not positive.
 *
 * Along a ray this is a t^2 + 2 b t + c. It is taken about the ray's own vertex, where b is nearly zero
 * and the discriminant has nothing to cancel; the coefficients have two parts, so that maps can be
 * absorbed. */
#include "kit/affine.h"
#include "kit/expansion.h"
#include "kit/report.h"

enum { A, B, C, D, E, F, G, H, I, J, COEFFICIENTS };

/* A crossing's part: where the ray comes to negative values, and where it leaves them. */
enum { ENTERING = 0, EXITING = 1 };

typedef struct quadric {
    pov_two3 anchor;
    pov_two raw[COEFFICIENTS];     /* about the anchor */
    /* Made from raw: for lengths times scale, multiplied so that the largest is of the order of one. */
    pov_two q[COEFFICIENTS];
    double rough[COEFFICIENTS], size[COEFFICIENTS];
    double scale;
    bool flat;                     /* nothing of the second order: a plane */
} quadric;

/* The binary exponent of the largest of n coefficients; a very small number for none. */
static int exponent_of(const pov_two *q, int n)
{
    double largest = 0.0;
    int i, exponent;

    for (i = 0; i < n; i++)
        largest = fmax(largest, fabs(q[i].hi));
    if (!(largest > 0.0) || !isfinite(largest))
        return -100000;
    frexp(largest, &exponent);
    return exponent;
}

static int larger(int a, int b) { return a > b ? a : b; }

/* The length at which terms of different order are of the same size. */
static int length_exponent(int second, int first, int constant)
{
    if (second > -100000)
        return first < -90000 && constant < -90000 ? 0 : larger(first - second, (constant - second) / 2);
    return first > -100000 && constant > -100000 ? constant - first : 0;
}

static void prepare(quadric *s)
{
    int second = exponent_of(s->raw + A, 6), first = exponent_of(s->raw + G, 3), constant = exponent_of(s->raw + J, 1);
    int length = length_exponent(second, first, constant), largest, i;

    length = length > 900 ? 900 : length < -900 ? -900 : length;
    largest = larger(larger(second + 2 * length, first + length), constant);
    for (i = 0; i < COEFFICIENTS; i++) {
        const int power = (i < G ? 2 * length : i < J ? length : 0) - largest;

        s->q[i] = pov_two_of(ldexp(s->raw[i].hi, power), ldexp(s->raw[i].lo, power));
        s->rough[i] = s->q[i].hi;
        s->size[i] = fabs(s->q[i].hi);
    }
    s->flat = second == -100000;
    s->scale = ldexp(1.0, -length);
}

/* ---- the anchor ---- */

/* Near the centre, if there is one: each axis' own extremum of what is left of the equation when the
 * others stand. */
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

/* The sum of n products of up to three factors each, rounded once into two parts. */
static pov_two exact_sum(double (*term)[3], int n)
{
    kit_expansion e;
    int i;

    kit_expansion_clear(&e);
    for (i = 0; i < n; i++)
        kit_expansion_add_product3(&e, term[i][0], term[i][1], term[i][2]);
    return kit_expansion_two(&e);
}

/* Written out about a far centre, the terms cancel to almost nothing at the surface. Taken about an anchor
 * near the centre, without any error on the way, they do not. */
static void settle(quadric *s)
{
    const pov_vec3 c = near_centre(s->raw), zero = { 0.0, 0.0, 0.0 };
    double q[COEFFICIENTS];
    pov_two level;
    int i;

    for (i = 0; i < COEFFICIENTS; i++)
        q[i] = s->raw[i].hi;
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
        s->raw[G] = exact_sum(x, 4);
        s->raw[H] = exact_sum(y, 4);
        s->raw[I] = exact_sum(z, 4);
        s->raw[J] = level;
    }
    s->anchor = pov_two3_of(c, zero);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    quadric *s = self;
    pov_vec3 v[3];
    double constant;
    int i;

    for (i = 0; i < 3; i++) {
        host->vector(in, &v[i]);
        host->accept(in, ",");
        s->raw[3 * i] = pov_two_of(v[i].x, 0.0);
        s->raw[3 * i + 1] = pov_two_of(v[i].y, 0.0);
        s->raw[3 * i + 2] = pov_two_of(v[i].z, 0.0);
    }
    constant = host->number(in);
    s->raw[J] = pov_two_of(constant, 0.0);
    settle(s);
    prepare(s);
}

/* ---- bounds, of ellipsoids ---- */

static pov_two half(pov_two a) { return pov_two_scale(a, 0.5); }

static pov_two minor(pov_two a, pov_two b, pov_two c, pov_two d)
{
    return pov_two_sub(pov_two_mul(a, b), pov_two_mul(c, d));
}

/* Is a pivot clear of rounding, against the diagonal entry that it was reduced from? */
static bool is_clear(pov_two pivot, pov_two entry) { return pivot.hi > 0x1p-12 * entry.hi && entry.hi > 0.0; }

static bool extent(pov_two anchor, double scale, pov_two middle, pov_two square, double *lo, double *hi)
{
    /* Pivots that lost at most 12 bits leave 2^-60 of relative error at most; a millionth is far more than
     * enough. */
    const double radius = sqrt(square.hi) * (1.0 + 0x1p-20) / scale, centre = anchor.hi + middle.hi / scale;

    *lo = kit_below(centre - radius - 8.0 * KIT_U * (fabs(anchor.hi) + fabs(middle.hi / scale)));
    *hi = kit_above(centre + radius + 8.0 * KIT_U * (fabs(anchor.hi) + fabs(middle.hi / scale)));
    return isfinite(*lo) && isfinite(*hi);
}

static bool bounds(const void *self, pov_box *out)
{
    const quadric *s = self;
    const pov_two *q = s->q, d = half(q[D]), e = half(q[E]), f = half(q[F]);
    const pov_two xx = minor(q[B], q[C], f, f), yy = minor(q[A], q[C], e, e), zz = minor(q[A], q[B], d, d);
    const pov_two xy = minor(e, f, d, q[C]), xz = minor(d, f, e, q[B]), yz = minor(d, e, f, q[A]);
    const pov_two det = pov_two_add(pov_two_add(pov_two_mul(q[A], xx), pov_two_mul(d, xy)), pov_two_mul(e, xz));
    const pov_two g = half(q[G]), h = half(q[H]), i = half(q[I]);
    pov_two x, y, z, level;

    if (!is_clear(q[A], q[A]) || !is_clear(zz, pov_two_mul(q[A], q[B])) || !is_clear(det, pov_two_mul(zz, q[C])))
        return false;
    x = pov_two_div(pov_two_add(pov_two_add(pov_two_mul(xx, g), pov_two_mul(xy, h)), pov_two_mul(xz, i)), det);
    y = pov_two_div(pov_two_add(pov_two_add(pov_two_mul(xy, g), pov_two_mul(yy, h)), pov_two_mul(yz, i)), det);
    z = pov_two_div(pov_two_add(pov_two_add(pov_two_mul(xz, g), pov_two_mul(yz, h)), pov_two_mul(zz, i)), det);
    /* The value at the centre, with its sign turned. */
    level = pov_two_add(pov_two_add(pov_two_mul(x, g), pov_two_mul(y, h)), pov_two_mul(z, i));
    if (!(level.hi - q[J].hi > 0x1p-40 * (fabs(level.hi) + fabs(q[J].hi))))
        return false;
    level = pov_two_div(pov_two_sub(level, q[J]), det);
    return extent(s->anchor.x, s->scale, pov_two_neg(x), pov_two_mul(level, xx), &out->lo.x, &out->hi.x)
           && extent(s->anchor.y, s->scale, pov_two_neg(y), pov_two_mul(level, yy), &out->lo.y, &out->hi.y)
           && extent(s->anchor.z, s->scale, pov_two_neg(z), pov_two_mul(level, zz), &out->lo.z, &out->hi.z);
}

/* ---- in two parts ---- */

static pov_two sum3(pov_two a, pov_two b, pov_two c) { return pov_two_add(pov_two_add(a, b), c); }

/* Half the gradient; and without the linear terms the matrix times p. */
static pov_two3 half_gradient(const pov_two *q, pov_two3 p, bool linear)
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

/* The value at a point whose half gradient is known: p . (g + half the linear terms) + J. */
static pov_two value(const pov_two *q, pov_two3 p, pov_two3 g)
{
    g.x = pov_two_add(g.x, half(q[G]));
    g.y = pov_two_add(g.y, half(q[H]));
    g.z = pov_two_add(g.z, half(q[I]));
    return pov_two_add(pov_two3_dot(p, g), q[J]);
}

static bool report_decided(pov_hits *hits, pov_two t, double unit, uint32_t part)
{
    return !isfinite(t.hi) || kit_report_decided(hits, t, unit, part);
}

/* Which crossings are wanted. A ray that left the surface started on one of the two: where it goes to
 * larger values, on the exit, else on the entry. */
enum { WANT_ENTRY = 1, WANT_EXIT = 2 };

/* Coefficients along the ray through w with direction d, from `q`: second order, first and value. With the
 * sizes of coefficients and components in place of themselves the sums of the sizes of all terms. */
static double along_second(const double *q, pov_vec3 d)
{
    return d.x * (q[A] * d.x + q[D] * d.y + q[E] * d.z) + d.y * (q[B] * d.y + q[F] * d.z) + q[C] * d.z * d.z;
}

static double along_first(const double *q, pov_vec3 w, pov_vec3 d)
{
    return d.x * (q[A] * w.x + 0.5 * (q[D] * w.y + q[E] * w.z + q[G]))
           + d.y * (q[B] * w.y + 0.5 * (q[D] * w.x + q[F] * w.z + q[H]))
           + d.z * (q[C] * w.z + 0.5 * (q[E] * w.x + q[F] * w.y + q[I]));
}

static double along_value(const double *q, pov_vec3 w)
{
    return w.x * (q[A] * w.x + q[D] * w.y + q[E] * w.z + q[G]) + w.y * (q[B] * w.y + q[F] * w.z + q[H])
           + w.z * (q[C] * w.z + q[I]) + q[J];
}

/* a . b for both taken `power` times; a zero stays one. */
static pov_two quick_square(pov_two3 a, pov_two3 b, double power)
{
    const pov_two zero = { 0.0, 0.0 };
    const pov_two x = b.x.hi != 0.0 ? pov_two_mul(pov_two_scale(a.x, power), pov_two_scale(b.x, power)) : zero;
    const pov_two y = b.y.hi != 0.0 ? pov_two_mul(pov_two_scale(a.y, power), pov_two_scale(b.y, power)) : zero;
    const pov_two z = b.z.hi != 0.0 ? pov_two_mul(pov_two_scale(a.z, power), pov_two_scale(b.z, power)) : zero;

    return sum3(x, y, z);
}

/* Where to take the equation: at the ray's vertex, where the discriminant does not cancel; but if that is
 * out of all proportion to where the ray passes the anchor, as with a ray almost along the axis of a
 * paraboloid, then there. */
static double middle_of(const quadric *s, const kit_ray *k)
{
    const pov_two3 d = kit_direction(k);
    const double nearest = -pov_dot(pov_two3_hi(k->f), k->d) / pov_dot(k->d, k->d);
    const pov_vec3 w = kit_along(k, nearest);
    const double a = pov_two3_dot(d, half_gradient(s->q, d, false)).hi;
    const double vertex = nearest - along_first(s->rough, w, k->d) / a;

    return fabs(vertex - nearest) < 1024.0 * pov_largest(w) ? vertex : nearest;
}

/* Adds q a b, each in two parts. */
static void add_term(kit_expansion *e, pov_two q, pov_two a, pov_two b)
{
    const double part[3][2] = { { q.hi, q.lo }, { a.hi, a.lo }, { b.hi, b.lo } };
    int i;

    for (i = 0; i < 8; i++)
        kit_expansion_add_product3(e, part[0][i & 1], part[1][i >> 1 & 1], part[2][i >> 2]);
}

/* The value at a point, without any error but that of rounding once. */
static pov_two exact_value(const pov_two *q, pov_two3 p)
{
    const pov_two one = { 1.0, 0.0 };
    kit_expansion e;

    kit_expansion_clear(&e);
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
    return kit_expansion_two(&e);
}

/* A root so near to the ray's origin that the way from `middle` is nearly all of it: -c / (b + or - root),
 * with the value c at the origin itself. */
static pov_two near_origin(const quadric *s, const kit_ray *k, pov_two root)
{
    const pov_two c = exact_value(s->q, k->f), b = pov_two3_dot(kit_direction(k), half_gradient(s->q, k->f, true));

    return pov_two_neg(pov_two_div(c, b.hi < 0.0 ? pov_two_sub(b, root) : pov_two_add(b, root)));
}

/* A root seen from `middle`, seen from the origin. */
static pov_two from_origin(const quadric *s, const kit_ray *k, double middle, pov_two t, pov_two root)
{
    const pov_two sum = pov_two_add_double(t, middle);

    return fabs(sum.hi) < 0x1p-24 * fabs(middle) ? near_origin(s, k, root) : sum;
}

/* Both roots, as distances from `middle`, and half their distance times the second-order coefficient. */
typedef struct solution { pov_two entry, exit, root; } solution;

/* False: the ray misses. A root that is not there is infinite. */
static bool solve(const quadric *s, const kit_ray *k, double middle, solution *out)
{
    const pov_two3 d = kit_direction(k), w = kit_along_two(k, middle), g = half_gradient(s->q, w, true);
    const pov_two3 turn = half_gradient(s->q, d, false);
    /* A ray along a surface that is straight that way hardly moves across it, so little at times that squares
     * underflow: it is followed faster by `power`. */
    const double power = pov_inverse_power(fmax(pov_largest(pov_two3_hi(turn)), fabs(pov_two3_dot(d, g).hi)));
    const pov_two a = quick_square(d, turn, power), b = pov_two_scale(pov_two3_dot(d, g), power);
    const pov_two c = value(s->q, w, g);
    const pov_two discriminant = pov_two_sub(pov_two_mul(b, b), pov_two_mul(a, c));
    pov_two root, sum, entry = { HUGE_VAL, 0.0 }, exit = { HUGE_VAL, 0.0 };

    if (!(discriminant.hi >= 0.0))
        return false;
    root = pov_two_sqrt(discriminant);
    sum = b.hi < 0.0 ? pov_two_sub(root, b) : pov_two_neg(pov_two_add(b, root));
    if (sum.hi != 0.0) {
        const pov_two direct = pov_two_div(c, sum), other = a.hi != 0.0 ? pov_two_div(sum, a) : entry;
        entry = b.hi < 0.0 ? direct : other;
        exit = b.hi < 0.0 ? other : direct;
    } else if (a.hi != 0.0) {
        entry = exit = sum;
    }
    out->entry = pov_two_scale(entry, power);
    out->exit = pov_two_scale(exit, power);
    out->root = pov_two_scale(root, 1.0 / power);
    return true;
}

/* How much further along the ray a root lies that is much nearer to the anchor than w is; 0 for none. */
static double to_anchor(const kit_ray *k, double middle, const solution *roots)
{
    const double here = pov_largest(kit_along(k, middle));
    const double at_entry = isfinite(roots->entry.hi) ? pov_largest(kit_along(k, middle + roots->entry.hi)) : HUGE_VAL;
    const double at_exit = isfinite(roots->exit.hi) ? pov_largest(kit_along(k, middle + roots->exit.hi)) : HUGE_VAL;
    const double there = at_entry < at_exit ? roots->entry.hi : roots->exit.hi;

    return isfinite(there) && fmin(at_entry, at_exit) < 0x1p-4 * here ? there : 0.0;
}

static void decide(const quadric *s, const kit_ray *k, bool leaving, pov_hits *hits)
{
    double middle = middle_of(s, k), further;
    uint32_t wanted = WANT_ENTRY | WANT_EXIT;
    solution roots;

    hits->decided++;
    if (leaving) {
        const double rise = pov_two3_dot(kit_direction(k), half_gradient(s->q, k->f, true)).hi;
        wanted = rise > 0.0 ? WANT_ENTRY : rise < 0.0 ? WANT_EXIT : 0;
    }
    if (!solve(s, k, middle, &roots))
        return;
    /* Near the apex of a cone everything is small; seen from further off it would be small differences. */
    further = to_anchor(k, middle, &roots);
    middle += further;
    if (further != 0.0 && !solve(s, k, middle, &roots))
        return;
    roots.entry = from_origin(s, k, middle, roots.entry, roots.root);
    roots.exit = from_origin(s, k, middle, roots.exit, roots.root);
    if (wanted & WANT_ENTRY && !report_decided(hits, roots.entry, k->unit, ENTERING))
        return;
    if (wanted & WANT_EXIT)
        report_decided(hits, roots.exit, k->unit, EXITING);
}

/* ---- in double ---- */

/* Absolute values, and on each a slack. */
static pov_vec3 sizes(pov_vec3 a, double slack)
{
    return pov_vec3_of(fabs(a.x) + slack, fabs(a.y) + slack, fabs(a.z) + slack);
}

typedef struct along {
    double a, b, c, a_error, b_error, c_error;
} along;

/* Each term is a product of at most four rounded factors and passes through at most six sums. */
static along measure(const quadric *s, const kit_ray *k, pov_vec3 w)
{
    const pov_vec3 d_size = sizes(k->d, 0.0), w_size = sizes(w, kit_far_slack(k));
    along r;

    r.a = along_second(s->rough, k->d);
    r.b = along_first(s->rough, w, k->d);
    r.c = along_value(s->rough, w);
    r.a_error = 10.0 * KIT_U * along_second(s->size, d_size);
    r.b_error = 11.0 * KIT_U * along_first(s->size, w_size, d_size);
    r.c_error = 12.0 * KIT_U * along_value(s->size, w_size);
    return r;
}

static kit_root root_of(double middle, double t, double error, uint32_t part)
{
    kit_root r;

    r.t = pov_two_sum(middle, t);
    r.error = error;
    r.part = part;
    r.flags = 0;
    return r;
}

static kit_residual residual(const void *self, const kit_ray *k, pov_two3 w, uint32_t part)
{
    const quadric *s = self;
    const pov_two3 g = half_gradient(s->q, w, true);
    kit_residual r;

    (void)part;
    r.value = value(s->q, w, g).hi;
    r.error = 0x1p-98 * along_value(s->size, sizes(pov_two3_hi(w), 0.0));
    r.half_slope = pov_dot(pov_two3_hi(g), k->d);
    r.slope_error = 6.0 * KIT_U * kit_sum_of_sizes(pov_two3_hi(g), k->d);
    return r;
}

/* No second order: a plane. */
static bool quick_plane(const quadric *s, const kit_ray *k, const along *r, double middle, pov_hits *hits)
{
    const kit_equation equation = { s, k, residual, HUGE_VAL };
    const double t = -r->c / (2.0 * r->b);
    kit_root root;

    if (!(fabs(r->b) > 16.0 * r->b_error))
        return false;
    root = root_of(middle, t, (r->c_error + 2.0 * fabs(t) * r->b_error) / (1.8 * fabs(r->b)) + KIT_U * fabs(t),
                   r->b < 0.0 ? ENTERING : EXITING);
    return kit_report(&root, 1, HUGE_VAL, &equation, hits);
}

static bool quick_curved(const quadric *s, const kit_ray *k, const along *r, double middle, uint32_t wanted,
                         pov_hits *hits)
{
    const double d = r->b * r->b - r->a * r->c;
    const double d_error = (2.0 * fabs(r->b) + r->b_error) * r->b_error + (fabs(r->a) + r->a_error) * r->c_error +
                           fabs(r->c) * r->a_error + 3.0 * KIT_U * (r->b * r->b + fabs(r->a * r->c));
    kit_equation equation = { s, k, residual, 0.0 };
    double root, error, entry, exit;
    kit_root roots[2];
    uint32_t n = 0, i;

    if (d < -2.0 * d_error)
        return true;
    if (!(d > 16.0 * d_error))
        return false;
    root = sqrt(d);
    entry = (-r->b - root) / r->a;
    exit = (-r->b + root) / r->a;
    error = (r->b_error + 0.52 * d_error / root + KIT_U * (root + fabs(r->b))) / (0.9 * fabs(r->a));
    for (i = 0; i < 2; i++) {
        const bool is_entry = (i == 0) == (r->a > 0.0);
        const double t = is_entry ? entry : exit;

        if (wanted & (is_entry ? WANT_ENTRY : WANT_EXIT))
            roots[n++] = root_of(middle, t, error + fabs(t) * (1.1 * r->a_error / fabs(r->a) + 2.0 * KIT_U),
                                 is_entry ? ENTERING : EXITING);
    }
    equation.apart = root / fabs(r->a);
    return kit_report(roots, n, fmin(KIT_FINE / sqrt(pov_dot(k->d, k->d)), KIT_APART * equation.apart), &equation, hits);
}

/* Double precision with bounds. False: open. */
static bool quick(const quadric *s, const kit_ray *k, bool leaving, pov_hits *hits)
{
    const pov_vec3 f = pov_two3_hi(k->f);
    const along at_start = measure(s, k, f);
    const bool is_plane = s->flat;
    uint32_t wanted = WANT_ENTRY | WANT_EXIT;
    double middle;
    along there;

    if (leaving && is_plane)
        return true;
    if (leaving) {
        if (!(fabs(at_start.b) > 2.0 * at_start.b_error))
            return false;
        wanted = at_start.b > 0.0 ? WANT_ENTRY : WANT_EXIT;
    }
    if (!is_plane && !(fabs(at_start.a) > 1024.0 * at_start.a_error && fabs(at_start.a) > KIT_TINY))
        return false;
    middle = is_plane ? -at_start.c / (2.0 * at_start.b) : -at_start.b / at_start.a;
    if (!isfinite(middle))
        return false;
    there = measure(s, k, kit_along(k, middle));
    return is_plane ? quick_plane(s, k, &there, middle, hits) : quick_curved(s, k, &there, middle, wanted, hits);
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const quadric *s = self;
    const kit_ray k = kit_enter(ray, s->anchor, s->scale);
    const bool leaving = ray->left == hits->owner;

    if (hits->always_exact || !quick(s, &k, leaving, hits))
        decide(s, &k, leaving, hits);
}

/* The point of a crossing, brought onto the surface: where that curves much, the distance alone is not fine enough for
 * a normal. */
static pov_two3 surface_point(const quadric *s, const kit_ray *k, const pov_crossing *at)
{
    const pov_two3 p = kit_point(k, at), g = half_gradient(s->q, p, true);

    return kit_step(k, p, value(s->q, p, g).hi, pov_dot(pov_two3_hi(g), k->d));
}

/* Where the gradient vanishes, at the apex of a cone, no normal is better than another. */
static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    const quadric *s = self;
    const kit_ray k = kit_enter(ray, s->anchor, s->scale);

    *out = pov_unit(pov_two3_hi(half_gradient(s->q, surface_point(s, &k, at), true)));
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const quadric *s = self;
    const pov_two3 p = kit_offset(point, point_lo, s->anchor, s->scale);

    return value(s->q, p, half_gradient(s->q, p, true)).hi <= 0.0;
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

/* The matrix becomes the inverse's transpose times it times the inverse. Maps far from keeping angles
 * would cost precision in these products, unless they are axial. */
static bool absorb(void *self, const pov_affine *map)
{
    static const int row_of[6] = { 0, 1, 2, 0, 0, 1 }, column_of[6] = { 0, 1, 2, 1, 2, 2 };
    quadric *s = self;
    pov_two3 rows[3], columns[3], linear;
    pov_two raw[COEFFICIENTS];
    int axis[3], i;

    if (!(kit_condition(map) < 1024.0) && !kit_is_axial(map, axis))
        return false;
    kit_inverse_linear(map, rows);
    for (i = 0; i < 3; i++)
        columns[i] = column(rows, i);
    linear.x = s->raw[G], linear.y = s->raw[H], linear.z = s->raw[I];
    for (i = 0; i < 6; i++) {
        const pov_two3 product = half_gradient(s->raw, columns[column_of[i]], false);
        raw[i] = pov_two_scale(pov_two3_dot(columns[row_of[i]], product), i < D ? 1.0 : 2.0);
    }
    for (i = 0; i < 3; i++)
        raw[G + i] = pov_two3_dot(columns[i], linear);
    raw[J] = s->raw[J];
    for (i = 0; i < COEFFICIENTS; i++) {
        if (!isfinite(raw[i].hi) || !isfinite(raw[i].lo))
            return false;
    }
    s->anchor = kit_map_point(map, s->anchor);
    memcpy(s->raw, raw, sizeof raw);
    prepare(s);
    return true;
}

static const pov_shape_class quadric_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "quadric",
    .instance_size = sizeof(quadric),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .absorb = absorb,
};

static const pov_shape_class *const shapes[] = { &quadric_class, NULL };

POV_PLUGIN(quadric) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "quadric",
    .version = "1",
    .shapes = shapes,
};
