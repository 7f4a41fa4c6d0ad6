#include "numerics/spline_real.h"

#include <math.h>

const spline_basis spline_linear = { "linear_spline", 1, 2, 0, 1, 1.0, { { 1.0, 0.0 }, { -1.0, 1.0 } } };
const spline_basis spline_quadratic = { "quadratic_spline", 2, 3, 1, 1, 2.0, { { 0.0, 2.0, 0.0 }, { -1.0, 0.0, 1.0 }, { 1.0, -2.0, 1.0 } } };
const spline_basis spline_cubic = { "cubic_spline", 3, 4, 1, 1, 2.0,
    { { 0.0, 2.0, 0.0, 0.0 }, { -1.0, 0.0, 1.0, 0.0 }, { 2.0, -5.0, 4.0, -1.0 }, { -1.0, 3.0, -3.0, 1.0 } } };
const spline_basis spline_bezier = { "bezier_spline", 3, 4, 0, 4, 1.0,
    { { 1.0, 0.0, 0.0, 0.0 }, { -3.0, 3.0, 0.0, 0.0 }, { 3.0, -6.0, 3.0, 0.0 }, { -1.0, 3.0, -3.0, 1.0 } } };
const spline_basis spline_b = { "b_spline", 3, 4, 1, 1, 6.0,
    { { 1.0, 4.0, 1.0, 0.0 }, { -3.0, 0.0, 3.0, 0.0 }, { 3.0, -6.0, 3.0, 0.0 }, { -1.0, 3.0, -3.0, 1.0 } } };

poly_real spline_piece(const spline_basis *b, const double *first, int stride)
{
    poly_real p;

    p.degree = b->degree;
    for (int k = 0; k <= b->degree; k++) {
        p.c[k] = real_of(0.0);
        for (int j = 0; j < b->points; j++)
            p.c[k] = real_add(p.c[k], real_mul(real_of(b->row[k][j]), real_of(first[j * stride])));
        p.c[k] = real_div(p.c[k], real_of(b->by));
    }
    return p;
}

/* ---- swept ---- */

static void report(real t, real end, answer *out)
{
    if (real_sign(t) > 0 && real_compare(t, end) < 0 && out->count < KIND_CROSSINGS)
        out->at[out->count++] = real_double(t);
}

/* Is a cap crossed? Pieces are crossed by the half-line from there along x an odd number of times. */
static void cross_cap(const swept_real *s, const poly_real *x, const poly_real *y, const poly_real *height, double at, real end, answer *out)
{
    const real t = real_div(real_sub(real_of(at), height->c[0]), height->c[1]), size = real_of(s->conic ? at : 1.0);
    bool is_in = false;

    for (int i = 0; real_sign(size) != 0 && i < s->count; i++) {
        const poly_real level = poly_of(real_div(poly_at(y, t), size));
        const poly_piece piece = { poly_sub(&s->y[i], &level), real_of(0.0), real_of(1.0) };
        double u[3];
        const int n = poly_roots(&piece, u, 3);

        for (int k = 0; k < n; k++) {
            const double beside = real_double(real_sub(poly_at(&s->x[i], real_of(u[k])), real_div(poly_at(x, t), size)));

            out->open = out->open || fabs(beside) < KIND_TOUCH;
            is_in ^= beside > 0.0;
        }
    }
    if (is_in)
        report(t, end, out);
}

/* The distance where the ray meets a piece at (x, y): along that of the two axes in which it is faster. */
static real distance_at(const swept_real *s, const poly_real *rx, const poly_real *ry, const poly_real *height, real x, real y)
{
    const real base = s->conic ? height->c[0] : real_of(1.0), slope = s->conic ? height->c[1] : real_of(0.0);
    const real fast_x = real_sub(rx->c[1], real_mul(slope, x)), fast_y = real_sub(ry->c[1], real_mul(slope, y));

    if (fabs(real_double(fast_x)) > fabs(real_double(fast_y)))
        return real_div(real_sub(real_mul(base, x), rx->c[0]), fast_x);
    return real_div(real_sub(real_mul(base, y), ry->c[0]), fast_y);
}

/* (x, y) of the ray, less that of the piece times the height if it is conic, for some distance: without the distance that is linear
 * in x and y of the piece. */
static poly_real meets(const swept_real *s, const poly_real *rx, const poly_real *ry, const poly_real *height, int i)
{
    const real base = s->conic ? height->c[0] : real_of(1.0), slope = s->conic ? height->c[1] : real_of(0.0);
    const real of_x = real_sub(real_mul(ry->c[0], slope), real_mul(base, ry->c[1]));
    const real of_y = real_sub(real_mul(base, rx->c[1]), real_mul(rx->c[0], slope));
    const poly_real x = poly_scale(&s->x[i], of_x), y = poly_scale(&s->y[i], of_y), both = poly_add(&x, &y);
    const poly_real rest = poly_of(real_sub(real_mul(rx->c[0], ry->c[1]), real_mul(ry->c[0], rx->c[1])));

    return poly_add(&both, &rest);
}

void swept_solve(const swept_real *s, const poly_real *x, const poly_real *y, const poly_real *height, real end, answer *out)
{
    for (int i = 0; i < s->count; i++) {
        const poly_piece piece = { meets(s, x, y, height, i), real_of(0.0), real_of(1.0) };
        double u[3];
        const int n = poly_roots(&piece, u, 3);

        for (int k = 0; k < n; k++) {
            const real at = real_of(u[k]), t = distance_at(s, x, y, height, poly_at(&s->x[i], at), poly_at(&s->y[i], at));
            const double h = real_double(poly_at(height, t));

            out->open = out->open || fabs(h - s->low) < KIND_TOUCH || fabs(h - s->high) < KIND_TOUCH;
            if (h > s->low && h < s->high)
                report(t, end, out);
        }
    }
    cross_cap(s, x, y, height, s->low, end, out);
    cross_cap(s, x, y, height, s->high, end, out);
}
