/* test_piecewise.c - shapes whose equation along a ray is a polynomial, or some one after the other, against 512 bits: each crossing
 * that is there is found, and no other, unless two lie nearer than KIND_TOUCH to each other.
 *
 * Rays from near and far, aimed anywhere, and rays that graze the surface by 1e-1 to 1e-9 of its size. test_piecewise RAYS for
 * a long run of each shape. */
#include "numerics/draw.h"
#include "numerics/kinds.h"
#include "numerics/long_run.h"

#include "support/check.h"
#include "support/fake_reader.h"
#include "support/rays.h"

#include <string.h>

static long rays;

/* ---- of one polynomial ---- */

static void feed_list(shape *s, int first, pov_reader *in)
{
    fake_reader_word(in, "<");
    for (int i = first; i < s->count; i++)
        fake_reader_number(in, s->number[i]);
    fake_reader_word(in, ">");
}

/* Of an even order the powers of one coordinate are above zero, and the constant below. */
static void make_polynomial(shape *s, pov_reader *in, int order)
{
    const int first = s->count;

    for (int i = order; i >= 0; i--)
        for (int j = order - i; j >= 0; j--)
            for (int k = order - i - j; k >= 0; k--) {
                const bool pure = i + j + k == order && (i == order || j == order || k == order), bounded = order % 2 == 0;

                s->number[s->count++] = pure && bounded ? between(1.0, 2.0) : i + j + k == 0 && bounded ? -between(0.1, 1.0)
                                        : U() < 0.5 ? 0.0 : between(-0.3, 0.3);
            }
    feed_list(s, first, in);
}

static void make_cubic(shape *s, pov_reader *in)
{
    s->count = 0;
    make_polynomial(s, in, 3);
}

static void make_quartic(shape *s, pov_reader *in)
{
    s->count = 0;
    make_polynomial(s, in, 4);
}

/* Its order is its first number. */
static void make_poly(shape *s, pov_reader *in)
{
    static const int orders[] = { 2, 5, 6, 7, 8 };

    s->number[0] = orders[(int)(5.0 * U())];
    s->count = 1;
    fake_reader_number(in, s->number[0]);
    make_polynomial(s, in, (int)s->number[0]);
}

static void solve_polynomial(const double *number, const along *a, int order, answer *out)
{
    poly_real powers[3][PIECE_DEGREE], sum = poly_of(real_of(0.0));
    int at = 0;

    for (int axis = 0; axis < 3; axis++) {
        powers[axis][0] = poly_of(real_of(1.0));
        for (int k = 1; k <= order; k++)
            powers[axis][k] = poly_mul(&powers[axis][k - 1], axis == 0 ? &a->x : axis == 1 ? &a->y : &a->z);
    }
    for (int i = order; i >= 0; i--)
        for (int j = order - i; j >= 0; j--)
            for (int k = order - i - j; k >= 0; k--, at++) {
                poly_real term;

                if (number[at] == 0.0)
                    continue;
                term = poly_mul(&powers[0][i], &powers[1][j]);
                term = poly_mul(&term, &powers[2][k]);
                term = poly_scale(&term, real_of(number[at]));
                sum = poly_add(&sum, &term);
            }
    kinds_collect(&sum, real_of(0.0), a->end, out);
}

static void solve_cubic(const shape *s, const along *a, answer *out) { solve_polynomial(s->number, a, 3, out); }
static void solve_quartic(const shape *s, const along *a, answer *out) { solve_polynomial(s->number, a, 4, out); }
static void solve_poly(const shape *s, const along *a, answer *out) { solve_polynomial(s->number + 1, a, (int)s->number[0], out); }

/* ---- about the y axis ---- */

static poly_real square_across(const along *a)
{
    const poly_real x = poly_mul(&a->x, &a->x), z = poly_mul(&a->z, &a->z);

    return poly_add(&x, &z);
}

/* Where a coordinate of the ray is between two numbers. */
static void collect_within(const along *a, const poly_real *line, double low, double high, const poly_real *p, answer *out)
{
    real from = real_div(real_sub(real_of(low), line->c[0]), line->c[1]), to = real_div(real_sub(real_of(high), line->c[0]), line->c[1]);
    const real zero = real_of(0.0);

    if (real_compare(from, to) > 0) {
        const real swap = from;

        from = to;
        to = swap;
    }
    from = real_compare(from, zero) < 0 ? zero : from;
    to = real_compare(to, a->end) > 0 ? a->end : to;
    if (real_compare(from, to) < 0)
        kinds_collect(p, from, to, out);
}

/* Between two heights, where the square of the radius is a polynomial of the ray's distance. */
static void collect_between(const along *a, double low, double high, const poly_real *square, answer *out)
{
    const poly_real across = square_across(a), minus = poly_scale(square, real_of(-1.0)), p = poly_add(&across, &minus);

    collect_within(a, &a->y, low, high, &p, out);
}

static void make_points(shape *s, pov_reader *in, bool closed)
{
    const int n = 4 + (int)(4.0 * U());
    double y = between(-1.5, -0.5);

    s->count = 2 * n;
    fake_reader_number(in, n);
    for (int i = 0; i < n; i++) {
        s->number[2 * i] = closed && (i == 0 || i == n - 1) ? 0.0 : between(0.2, 1.0);
        s->number[2 * i + 1] = y;
        y += between(0.2, 0.6);
        fake_reader_word(in, "<");
        fake_reader_number(in, s->number[2 * i]);
        fake_reader_number(in, s->number[2 * i + 1]);
        fake_reader_word(in, ">");
    }
}

static void make_sor(shape *s, pov_reader *in) { make_points(s, in, false); }

static void make_lathe(shape *s, pov_reader *in)
{
    fake_reader_word(in, "linear_spline");
    make_points(s, in, true);
}

static real slope_at(const double *p)
{
    const real rise = real_sub(real_of(p[2]), real_of(p[-2])), run = real_sub(real_of(p[3]), real_of(p[-1]));

    return real_div(real_mul(real_mul(real_of(2.0), real_of(p[0])), rise), run);
}

/* From the values and slopes at both ends: with u from 0 to 1, v0 + s0 u + (3 (v1 - v0) - 2 s0 - s1) u^2 + (2 (v0 - v1) + s0 + s1) u^3. */
static poly_real square_of_sor(const double *p, const along *a)
{
    const real length = real_sub(real_of(p[3]), real_of(p[1]));
    const real v0 = real_mul(real_of(p[0]), real_of(p[0])), v1 = real_mul(real_of(p[2]), real_of(p[2]));
    const real s0 = real_mul(slope_at(p), length), s1 = real_mul(slope_at(p + 2), length), rise = real_sub(v1, v0);
    const real c2 = real_sub(real_mul(real_of(3.0), rise), real_add(real_mul(real_of(2.0), s0), s1));
    const real c3 = real_sub(real_add(s0, s1), real_mul(real_of(2.0), rise));
    const poly_real u = poly_line(real_div(real_sub(a->y.c[0], real_of(p[1])), length), real_div(a->y.c[1], length));
    poly_real sum = poly_scale(&u, c3), more = poly_of(c2);

    sum = poly_add(&sum, &more);
    sum = poly_mul(&sum, &u);
    more = poly_of(s0);
    sum = poly_add(&sum, &more);
    sum = poly_mul(&sum, &u);
    more = poly_of(v0);
    return poly_add(&sum, &more);
}

static void collect_cap(const along *a, double height, double radius, answer *out)
{
    const real t = real_div(real_sub(real_of(height), a->y.c[0]), a->y.c[1]);
    const poly_real across = square_across(a);
    const double off = sqrt(real_double(poly_at(&across, t))) - radius;

    if (real_sign(t) < 0 || real_compare(t, a->end) > 0)
        return;
    out->open = out->open || fabs(off) < KIND_TOUCH;
    if (off < 0.0)
        out->at[out->count++] = real_double(t);
}

static void solve_sor(const shape *s, const along *a, answer *out)
{
    const int n = s->count / 2;

    for (int i = 1; i + 2 < n; i++) {
        const poly_real square = square_of_sor(s->number + 2 * i, a);

        collect_between(a, s->number[2 * i + 1], s->number[2 * i + 3], &square, out);
    }
    collect_cap(a, s->number[3], s->number[2], out);
    collect_cap(a, s->number[2 * n - 3], s->number[2 * n - 4], out);
}

static void solve_lathe(const shape *s, const along *a, answer *out)
{
    for (int i = 0; 2 * i + 3 < s->count; i++) {
        const double *p = s->number + 2 * i;
        const real slope = real_div(real_sub(real_of(p[2]), real_of(p[0])), real_sub(real_of(p[3]), real_of(p[1])));
        const real at_zero = real_add(real_of(p[0]), real_mul(slope, real_sub(a->y.c[0], real_of(p[1]))));
        const poly_real radius = poly_line(at_zero, real_mul(slope, a->y.c[1])), square = poly_mul(&radius, &radius);

        collect_between(a, p[1], p[3], &square, out);
    }
}

/* ---- blobs of spheres ---- */

static void make_blob(shape *s, pov_reader *in)
{
    const int n = 2 + (int)(4.0 * U());

    s->count = 5 * n + 1;
    s->number[0] = between(0.1, 0.6);
    fake_reader_word(in, "threshold");
    fake_reader_number(in, s->number[0]);
    for (int i = 0; i < n; i++) {
        double *c = s->number + 1 + 5 * i;

        for (int k = 0; k < 3; k++)
            c[k] = between(-0.6, 0.6);
        c[3] = between(0.4, 0.9);
        c[4] = U() < 0.2 ? -between(0.2, 0.8) : between(0.5, 1.5);
        fake_reader_word(in, "sphere");
        fake_reader_word(in, "{");
        fake_reader_word(in, "<");
        for (int k = 0; k < 3; k++)
            fake_reader_number(in, c[k]);
        fake_reader_word(in, ">");
        fake_reader_number(in, c[3]);
        fake_reader_number(in, c[4]);
        fake_reader_word(in, "}");
    }
}

/* 1 - d^2 / r^2 along the ray, and where it is above zero. */
typedef struct depth { poly_real p; real from, to; double strength; bool crossed; } depth;

static poly_real square_from(const poly_real *line, double centre)
{
    const poly_real minus = poly_of(real_of(-centre)), off = poly_add(line, &minus);

    return poly_mul(&off, &off);
}

static depth depth_of(const double *c, const along *a)
{
    const poly_real x = square_from(&a->x, c[0]), y = square_from(&a->y, c[1]), z = square_from(&a->z, c[2]);
    const real radius = real_of(c[3]), by = real_div(real_of(-1.0), real_mul(radius, radius));
    const poly_real one = poly_of(real_of(1.0));
    poly_real p = poly_add(&x, &y);
    real half, square, root;
    depth d;

    p = poly_add(&p, &z);
    p = poly_scale(&p, by);
    d.p = poly_add(&p, &one);
    d.strength = c[4];
    half = real_div(d.p.c[1], real_mul(real_of(-2.0), d.p.c[2]));
    square = real_sub(real_mul(half, half), real_div(d.p.c[0], d.p.c[2]));
    d.crossed = real_sign(square) > 0;
    root = d.crossed ? real_sqrt(square) : real_of(0.0);
    d.from = real_sub(half, root);
    d.to = real_add(half, root);
    return d;
}

static void put_end(real *ends, int *count, real t, const along *a)
{
    int i = *count;

    if (real_sign(t) < 0 || real_compare(t, a->end) > 0)
        return;
    for (; i > 0 && real_compare(t, ends[i - 1]) < 0; i--)
        ends[i] = ends[i - 1];
    ends[i] = t;
    ++*count;
}

static void solve_blob(const shape *s, const along *a, answer *out)
{
    const int n = (s->count - 1) / 5;
    depth d[8];
    real ends[20];
    int count = 0;

    put_end(ends, &count, real_of(0.0), a);
    for (int i = 0; i < n; i++) {
        d[i] = depth_of(s->number + 1 + 5 * i, a);
        if (!d[i].crossed)
            continue;
        put_end(ends, &count, d[i].from, a);
        put_end(ends, &count, d[i].to, a);
    }
    for (int k = 0; k + 1 < count; k++) {
        poly_real sum = poly_of(real_of(-s->number[0]));

        for (int i = 0; i < n; i++) {
            poly_real square;

            if (!d[i].crossed || real_compare(d[i].from, ends[k]) > 0 || real_compare(d[i].to, ends[k + 1]) < 0)
                continue;
            square = poly_mul(&d[i].p, &d[i].p);
            square = poly_scale(&square, real_of(d[i].strength));
            sum = poly_add(&sum, &square);
        }
        kinds_collect(&sum, ends[k], ends[k + 1], out);
    }
}

/* ---- superellipsoids of even powers ---- */

static poly_real power_of(const poly_real *p, int power)
{
    poly_real out = poly_of(real_of(1.0));

    for (int i = 0; i < power; i++)
        out = poly_mul(&out, p);
    return out;
}

/* |x|^a + |y|^a and |z|^b, where one of the powers divides the other. */
static void make_superellipsoid(shape *s, pov_reader *in)
{
    static const int powers[][2] = { { 2, 2 }, { 4, 4 }, { 6, 6 }, { 8, 8 }, { 2, 4 }, { 4, 2 }, { 2, 8 }, { 8, 2 }, { 4, 8 }, { 8, 4 }, { 2, 6 }, { 6, 2 } };
    const int *p = powers[(int)(12.0 * U())];

    s->count = 2;
    s->number[0] = p[0];
    s->number[1] = p[1];
    fake_reader_word(in, "<");
    fake_reader_number(in, 2.0 / p[0]);
    fake_reader_number(in, 2.0 / p[1]);
    fake_reader_word(in, ">");
}

/* (x^a + y^a)^(b/a) = 1 - z^b, or x^a + y^a = (1 - z^b)^(a/b). */
static void solve_superellipsoid(const shape *s, const along *a, answer *out)
{
    const int m = (int)s->number[0], n = (int)s->number[1];
    const poly_real x = power_of(&a->x, m), y = power_of(&a->y, m), z = power_of(&a->z, n), one = poly_of(real_of(1.0));
    const poly_real ring = poly_add(&x, &y), minus = poly_scale(&z, real_of(-1.0)), rest = poly_add(&one, &minus);
    const poly_real left = n > m ? power_of(&ring, n / m) : ring, right = n > m ? rest : power_of(&rest, m / n);
    const poly_real less = poly_scale(&right, real_of(-1.0)), p = poly_add(&left, &less);

    collect_within(a, &a->z, -1.0, 1.0, &p, out);
}

/* ---- stars: superellipsoids of roots ---- */

/* Of e and n one or both are four. */
static void make_star(shape *s, pov_reader *in)
{
    static const double exponents[][2] = { { 1.0, 4.0 }, { 4.0, 1.0 }, { 4.0, 4.0 } };
    const int which = (int)(3.0 * U());

    s->count = 3;
    s->number[0] = which;
    s->number[1] = exponents[which][0];
    s->number[2] = exponents[which][1];
    fake_reader_word(in, "<");
    fake_reader_number(in, s->number[1]);
    fake_reader_number(in, s->number[2]);
    fake_reader_word(in, ">");
}

/* (r + a)^2 = 4 b, squared until no root is left. */
static poly_real less_square(const poly_real *a, double by, const poly_real *b)
{
    const poly_real square = poly_mul(a, a), rest = poly_scale(b, real_of(-by));

    return poly_add(&square, &rest);
}

/* Where no coordinate is negative: sqrt(r) + sqrt(z) = 1 of r^2 = x^2 + y^2; (sqrt(x) + sqrt(y))^2 = sqrt(1 - z^2); and the sum of three
 * roots. */
static poly_real star_of(int which, const poly_real *x, const poly_real *y, const poly_real *z)
{
    const poly_real one = poly_of(real_of(1.0)), xy = poly_mul(x, y), sum = poly_add(x, y), high = poly_add(&one, z);
    const poly_real square = less_square(&sum, 2.0, &xy), flat = poly_sub(&high, &sum);
    poly_real a, b;

    if (which == 0) {
        a = less_square(&high, 4.0, z);
        a = poly_add(&a, &square);
        b = poly_mul(&high, &high);
        b = poly_mul(&b, &square);
        return less_square(&a, 4.0, &b);
    }
    if (which == 1) {
        const poly_real far = poly_mul(z, z), w = poly_sub(&one, &far), all = less_square(&sum, 4.0, &xy);

        a = poly_add(&w, &all);
        b = poly_mul(&sum, &sum);
        b = poly_mul(&b, &w);
        return less_square(&a, 4.0, &b);
    }
    a = poly_add(z, &xy);
    a = less_square(&flat, 4.0, &a);
    b = poly_mul(&xy, z);
    return less_square(&a, 64.0, &b);
}

static double size_of_star(const shape *s, double x, double y, double z)
{
    return pow(pow(fabs(x), 2.0 / s->number[1]) + pow(fabs(y), 2.0 / s->number[1]), s->number[1] / s->number[2]) + pow(fabs(z), 2.0 / s->number[2]);
}

/* Squares have added roots. */
static void solve_star(const shape *s, const along *a, answer *out)
{
    for (int octant = 0; octant < 8; octant++) {
        const poly_real x = poly_scale(&a->x, real_of(octant & 1 ? -1.0 : 1.0)), y = poly_scale(&a->y, real_of(octant & 2 ? -1.0 : 1.0));
        const poly_real z = poly_scale(&a->z, real_of(octant & 4 ? -1.0 : 1.0)), p = star_of((int)s->number[0], &x, &y, &z);
        int kept = out->count, before = out->count;

        kinds_collect(&p, real_of(0.0), a->end, out);
        for (int i = before; i < out->count; i++) {
            const real t = real_of(out->at[i]);
            const double at[3] = { real_double(poly_at(&x, t)), real_double(poly_at(&y, t)), real_double(poly_at(&z, t)) };
            const double off = fabs(size_of_star(s, at[0], at[1], at[2]) - 1.0);

            if (!(at[0] > 0.0 && at[1] > 0.0 && at[2] > 0.0 && off < 1e-3))
                continue;
            out->open = out->open || off > 1e-6;
            out->at[kept++] = out->at[i];
        }
        out->count = kept;
    }
}

/* ---- eggs ---- */

static void make_ovus(shape *s, pov_reader *in)
{
    s->count = 2;
    s->number[0] = between(0.3, 0.8);
    s->number[1] = s->number[0] * between(0.2, 1.8);
    fake_reader_number(in, s->number[0]);
    fake_reader_number(in, s->number[1]);
}

static poly_real sphere_along(const along *a, real height, real radius)
{
    const poly_real across = square_across(a), minus = poly_of(real_neg(height)), rise = poly_add(&a->y, &minus);
    const poly_real square = poly_mul(&rise, &rise), size = poly_of(real_neg(real_mul(radius, radius)));
    const poly_real all = poly_add(&across, &square);

    return poly_add(&all, &size);
}

/* The arc's circle has the radius K about (-b, h): (p.p - K^2 + b^2)^2 = 4 b^2 (x^2 + z^2), seen from the height h, on the sheet
 * where the left side's root is below zero. */
static void collect_arc(const along *a, real K, real h, real square_b, double low, double high, answer *out)
{
    const poly_real g = sphere_along(a, h, K), more = poly_of(square_b), left = poly_add(&g, &more), across = square_across(a);
    const poly_real square = poly_mul(&left, &left), right = poly_scale(&across, real_mul(real_of(-4.0), square_b));
    const poly_real p = poly_add(&square, &right);
    const int before = out->count;
    int kept = before;

    collect_within(a, &a->y, low, high, &p, out);
    for (int i = before; i < out->count; i++)
        if (real_sign(poly_at(&left, real_of(out->at[i]))) < 0)
            out->at[kept++] = out->at[i];
    out->count = kept;
}

static void solve_ovus(const shape *s, const along *a, answer *out)
{
    const real R = real_of(s->number[0]), r = real_of(s->number[1]), two = real_of(2.0);
    const real K = real_mul(two, real_of(fmax(s->number[0], s->number[1]))), KR = real_sub(K, R), Kr = real_sub(K, r);
    const real rest = real_add(real_sub(real_mul(KR, KR), real_mul(Kr, Kr)), real_mul(R, R)), h = real_div(rest, real_mul(two, R));
    const real low = real_neg(real_div(real_mul(h, R), KR)), high = real_add(R, real_div(real_mul(real_sub(R, h), r), Kr));
    const poly_real bottom = sphere_along(a, real_of(0.0), R), top = sphere_along(a, R, r);

    collect_within(a, &a->y, -10.0, real_double(low), &bottom, out);
    collect_within(a, &a->y, real_double(high), 10.0, &top, out);
    collect_arc(a, K, h, real_sub(real_mul(KR, KR), real_mul(h, h)), real_double(low), real_double(high), out);
}

static const kind_row kinds[] = {
    { "cubic", make_cubic, solve_cubic }, { "quartic", make_quartic, solve_quartic }, { "sor", make_sor, solve_sor },
    { "lathe", make_lathe, solve_lathe }, { "blob", make_blob, solve_blob },
    { "superellipsoid", make_superellipsoid, solve_superellipsoid }, { "ovus", make_ovus, solve_ovus },
    { "poly", make_poly, solve_poly }, { "superellipsoid", make_star, solve_star },
};

static void a_cubic_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&kinds[0], rays); }
static void a_quartic_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&kinds[1], rays); }
static void a_sor_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&kinds[2], rays); }
static void a_straight_lathe_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&kinds[3], rays); }
static void a_blob_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&kinds[4], rays); }
static void a_superellipsoid_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&kinds[5], rays); }
static void an_ovus_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&kinds[6], rays); }

static void a_poly_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&kinds[7], rays); }

static void a_star_has_its_crossings(void **state) { (void)state; kinds_keep_crossings(&kinds[8], rays); }

/* ---- of lines along which a cubic is nearly of a lower degree ---- */

static uint32_t ask_cubic(const double *number, pov_vec3 org, pov_vec3 dir, pov_crossing at[3])
{
    const shape_class *c = fake_reader_shape("cubic");
    pov_reader *in = fake_reader_create();
    const pov_ray ray = ray_from(org, dir);
    pov_hits hits = hits_to(40.0, POV_WANT_ALL, at, 3);
    union { char bytes[1 << 12]; double aligned; } scratch;
    shape s = { .count = 20 };
    void *self;

    assert_non_null(c);
    memcpy(s.number, number, 20 * sizeof *number);
    feed_list(&s, 0, in);
    self = fake_reader_parse(in, c);
    assert_non_null(self);
    hits.scratch = &scratch;
    c->intersect(self, &ray, &hits);
    fake_reader_destroy(in);
    return hits.count;
}

/* One was found where the ray is nearest to the origin: just behind that place is another root, which no part of the line has. */
static void a_line_beside_a_plane_of_a_cubic_meets_it_once(void **state)
{
    static const double number[20] = { 0.15103664045397724, 0, 0, 0, 0, 0, 0.24268823431520276, 0, 0, 0.2052543836591218 };
    pov_crossing at[3];

    (void)state;
    assert_int_equal(ask_cubic(number, pov_vec3_of(0x1.4fd7b616ead28p-24, 0x1.683f7cb4a3bdap+2, 0x1.f2727bc4049d4p-2),
                               pov_vec3_of(0x1.d196d6ba245ffp-56, -0x1.fd79c2924fb1bp-1, 0x1.963d03fb0f12dp-4), at), 1);
    assert_true(fabs(at[0].t - 6.5067090883626495) < 1e-9);
}

/* Both distances were wrong: they were looked for on the scale of the third root, which is 1e25 away. */
static void a_line_that_ends_on_a_cubic_keeps_its_near_crossings(void **state)
{
    static const double number[20] = {
        0, 0, 0, -0.18977261620712735, 0, 0, 0.095753213384867086, 0, 0.037745637347717687, 0,
        -0.13712862974252485, 0, 0, 0, 0, 0, 0, -0.036794471905893855, 0.040135411629142359, 0.24341423170739612,
    };
    pov_crossing at[3];

    (void)state;
    assert_int_equal(ask_cubic(number, pov_vec3_of(0x1.916e7dd7c9bb2p+1, 0x1.79ed2f458eb93p-2, 0x1.78f58dc98a914p+2),
                               pov_vec3_of(-0x1.02f0f72674874p-1, -0x1.c2875e814ad3fp-29, -0x1.b9b19d4165fcep-1), at), 2);
    assert_true(fabs(fmin(at[0].t, at[1].t) - 3.9071881197664506) < 1e-9);
    assert_true(fabs(fmax(at[0].t, at[1].t) - 8.0155807718873557) < 1e-9);
}

/* Three planes through one line, of which two are not real: rays nearly along the third pass the line by 2e-6 and 1e-8. For a stretch the
 * polynomial is below 1e-16, where double finds two crossings. */
static void a_ray_past_the_line_of_three_planes_misses_them(void **state)
{
    static const double number[20] = { 0x1.0e2b558cfd581p-2, 0x1.75dbadd1e2a76p-3, 0, 0, 0, 0, 0, 0, 0, 0, 0x1.343b997449508p-4 };
    pov_crossing at[3];

    (void)state;
    assert_int_equal(ask_cubic(number, pov_vec3_of(0x1.526d73acf758fp+1, -0x1.57642b5c7b08dp+1, 0x1.140894a1a9afdp+1),
                               pov_vec3_of(-0x1.54e8939d133c9p-2, 0x1.59e88b4c2ae58p-2, -0x1.c2c02e23aff21p-1), at), 0);
    assert_int_equal(ask_cubic(number, pov_vec3_of(0x1.e7d9c00da0913p+0, -0x1.ef016ce0fe29bp+0, 0x1.72be40380e9f8p-3),
                               pov_vec3_of(-0x1.61829c86452edp-1, 0x1.66b1e49b78feep-1, -0x1.710d95fc3c597p-3), at), 0);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cubic_has_its_crossings), cmocka_unit_test(a_quartic_has_its_crossings),
        cmocka_unit_test(a_sor_has_its_crossings), cmocka_unit_test(a_straight_lathe_has_its_crossings),
        cmocka_unit_test(a_blob_has_its_crossings), cmocka_unit_test(a_superellipsoid_has_its_crossings),
        cmocka_unit_test(an_ovus_has_its_crossings), cmocka_unit_test(a_poly_has_its_crossings),
        cmocka_unit_test(a_star_has_its_crossings),
        cmocka_unit_test(a_line_beside_a_plane_of_a_cubic_meets_it_once),
        cmocka_unit_test(a_line_that_ends_on_a_cubic_keeps_its_near_crossings),
        cmocka_unit_test(a_ray_past_the_line_of_three_planes_misses_them),
    };

    rays = long_run_rays(argc, argv, 3000);
    return cmocka_run_group_tests(tests, NULL, long_run_end);
}
