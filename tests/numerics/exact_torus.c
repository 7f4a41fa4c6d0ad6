/* exact_torus.c - a torus and a line in 512 bits: the roots of a quartic between those of its derivatives. */
#include "numerics/exact_torus.h"

#include <math.h>

enum { ORDER = 4, TURNS = 2000 };

static real value_at(const real *a, int order, real x)
{
    real sum = a[order];

    for (int i = order - 1; i >= 0; i--)
        sum = real_add(real_mul(sum, x), a[i]);
    return sum;
}

static void derive(const real *a, int order, real *out)
{
    for (int i = 1; i <= order; i++)
        out[i - 1] = real_mul(a[i], real_of(i));
}

static real middle_of(real a, real b) { return real_mul(real_add(a, b), real_of(0.5)); }

/* The root between lo and hi, at whose ends the values have different signs: Newton's method, or halves where that leaves
 * them. */
static real root_between(const real *a, int order, real lo, real hi, int sign_hi)
{
    const real x = middle_of(lo, hi), below = real_add(lo, real_of(0.0)), above = real_add(hi, real_of(0.0));
    real slopes[ORDER];
    bool near = false;

    derive(a, order, slopes);
    for (int turn = 0, used = real_mark(); turn < TURNS && !near; turn++, real_release(used)) {
        const real value = value_at(a, order, x), slope = value_at(slopes, order - 1, x);
        real next = below;

        real_copy(real_sign(value) == sign_hi ? above : below, x);
        if (real_sign(slope) != 0)
            next = real_sub(x, real_div(value, slope));
        if (real_compare(next, below) <= 0 || real_compare(next, above) >= 0)
            next = middle_of(below, above);
        near = fabs(real_double(real_sub(next, x))) < 0x1p-300;
        real_copy(x, next);
    }
    return x;
}

/* The roots in -1..1, in growing order. */
static int roots_of(const real *a, int order, real *out)
{
    real slopes[ORDER], knots[ORDER + 1];
    int count = 0, n;

    if (order == 0)
        return 0;
    derive(a, order, slopes);
    knots[0] = real_of(-1.0);
    n = 1 + roots_of(slopes, order - 1, knots + 1);
    knots[n] = real_of(1.0);
    for (int i = 0; i < n; i++) {
        const int lo = real_sign(value_at(a, order, knots[i])), hi = real_sign(value_at(a, order, knots[i + 1]));

        if (lo != hi && hi != 0)
            out[count++] = root_between(a, order, knots[i], knots[i + 1], hi);
    }
    return count;
}

/* (p.p + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2) along w + x v. */
static void quartic(real3 w, real3 v, real ring, real hollow, real *a)
{
    const real two = real_of(2.0), four = real_mul(real_of(4.0), ring);
    const real vv = real3_dot(v, v), wv = real_mul(two, real3_dot(w, v)), g = real_add(real3_dot(w, w), hollow);
    const real fv = real_add(real_mul(v.x, v.x), real_mul(v.z, v.z)), fw = real_add(real_mul(w.x, w.x), real_mul(w.z, w.z));
    const real f = real_mul(two, real_add(real_mul(w.x, v.x), real_mul(w.z, v.z)));

    a[4] = real_mul(vv, vv);
    a[3] = real_mul(two, real_mul(vv, wv));
    a[2] = real_sub(real_add(real_mul(two, real_mul(vv, g)), real_mul(wv, wv)), real_mul(four, fv));
    a[1] = real_sub(real_mul(two, real_mul(wv, g)), real_mul(four, f));
    a[0] = real_sub(real_mul(g, g), real_mul(four, fw));
}

int exact_torus_roots(real R, real r, real3 o, real3 d, real t[4])
{
    const real reach = real_mul(real_add(R, r), real_of(1.125)), speed = real3_dot(d, d);
    const real nearest = real_neg(real_div(real3_dot(o, d), speed)), half = real_div(reach, real_sqrt(speed));
    const real3 w = real3_add(o, real3_scale(d, nearest));
    const real ring = real_mul(R, R), hollow = real_sub(ring, real_mul(r, r));
    real a[5], x[4];
    int n, count = 0;

    if (real_compare(real3_dot(w, w), real_mul(reach, reach)) > 0)
        return 0;
    quartic(w, real3_scale(d, half), ring, hollow, a);
    n = roots_of(a, ORDER, x);
    for (int i = 0; i < n; i++) {
        const real at = real_add(nearest, real_mul(x[i], half));
        const real3 p = real3_add(o, real3_scale(d, at));

        /* The inner sheet of a spindle is no surface. */
        if (real_compare(real3_dot(p, p), real_neg(hollow)) > 0)
            t[count++] = at;
    }
    return count;
}

/* Out of the circle in the middle of the tube. */
real3 exact_torus_normal(real R, real3 p, real *axis)
{
    real share;

    *axis = real_sqrt(real_add(real_mul(p.x, p.x), real_mul(p.z, p.z)));
    share = real_sub(real_of(1.0), real_div(R, *axis));
    return real3_of(real_mul(p.x, share), p.y, real_mul(p.z, share));
}
