#include "common/edges.h"

#include "common/expansion.h"

common_view common_view_make(pov_vec3 org, pov_vec3 org_lo, const common_ray *k, pov_vec3 w, bool always_exact)
{
    common_view s;

    s.forward = common_forward(k->d);
    s.across = (s.forward + 1) % 3;
    s.up = (s.forward + 2) % 3;
    common_set3(s.o, org);
    common_set3(s.o_lo, org_lo);
    common_set3(s.d, k->d);
    common_set3(s.d_lo, k->d_lo);
    common_set3(s.w, w);
    s.error = common_view_blur(w);
    s.exact = always_exact || !(pov_largest(pov_two3_hi(k->f)) < COMMON_FAR);
    s.escalated = false;
    return s;
}

/* A corner seen from the ray's origin, off by less than 2^-100 of its size. */
static pov_two from_origin(const common_view *s, const double *corner, int i)
{
    return pov_two_add_double(pov_two_sum(corner[i], -s->o[i]), -s->o_lo[i]);
}

/* Adds sign (v - o) d for one coordinate of the corner and one of the direction. */
static void add_terms(common_expansion *e, const common_view *s, const double *v, int i, int j, double sign)
{
    const double from[3] = { v[i], -s->o[i], -s->o_lo[i] };
    int n;

    for (n = 0; n < 3; n++) {
        common_expansion_add_product(e, from[n], sign * s->d[j]);
        common_expansion_add_product(e, from[n], sign * s->d_lo[j]);
    }
}

/* The same products and their difference in double-double, each within 2^-98 of its size. */
static pov_two height_in_two(const common_view *s, const double *v, double *size)
{
    const pov_two up = from_origin(s, v, s->up), forward = from_origin(s, v, s->forward);
    const pov_two rise = pov_two_of(s->d[s->up], s->d_lo[s->up]), run = pov_two_of(s->d[s->forward], s->d_lo[s->forward]);

    *size = fabs(up.hi * run.hi) + fabs(forward.hi * rise.hi);
    return pov_two_sub(pov_two_mul(up, run), pov_two_mul(forward, rise));
}

bool common_view_is_above(const common_view *s, const pov_vec3 *corner)
{
    common_expansion e;
    double v[3], size;
    pov_two height;

    common_set3(v, *corner);
    height = height_in_two(s, v, &size);
    if (fabs(height.hi) > 0x1p-94 * size + 0x1p-900)
        return height.hi > 0.0;
    common_expansion_clear(&e);
    add_terms(&e, s, v, s->up, s->forward, 1.0);
    add_terms(&e, s, v, s->forward, s->up, -1.0);
    return common_expansion_sign(&e) > 0;
}

/* The sign in double-double: each of the six products of three is off by less than 2^-97 of its size, and so is their sum.
 * 0: it leaves that open. */
static int sign_in_two(const common_view *s, const double *p, const double *q)
{
    pov_two sum = pov_two_of(0.0, 0.0);
    double size = 0.0;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const pov_two pj = from_origin(s, p, j), pk = from_origin(s, p, k);
        const pov_two qj = from_origin(s, q, j), qk = from_origin(s, q, k);
        const pov_two d = pov_two_of(s->d[i], s->d_lo[i]);

        sum = pov_two_add(sum, pov_two_mul(pov_two_sub(pov_two_mul(pj, qk), pov_two_mul(pk, qj)), d));
        size += (fabs(pj.hi * qk.hi) + fabs(pk.hi * qj.hi)) * fabs(d.hi);
    }
    if (!(fabs(sum.hi) > 0x1p-94 * size + 0x1p-900))
        return 0;
    return sum.hi > 0.0 ? 1 : -1;
}

/* The sign of d . ((a - o) x (b - o)). */
static int orientation(const common_view *s, const pov_vec3 *a, const pov_vec3 *b)
{
    double p[3], q[3];
    common_expansion e;
    int i, m, n, l;

    common_set3(p, *a);
    common_set3(q, *b);
    i = sign_in_two(s, p, q);
    if (i != 0)
        return i;
    common_expansion_clear(&e);
    for (i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double pj[3] = { p[j], -s->o[j], -s->o_lo[j] }, pk[3] = { p[k], -s->o[k], -s->o_lo[k] };
        const double qj[3] = { q[j], -s->o[j], -s->o_lo[j] }, qk[3] = { q[k], -s->o[k], -s->o_lo[k] };
        const double d[2] = { s->d[i], s->d_lo[i] };

        for (l = 0; l < 2; l++) {
            for (m = 0; m < 3; m++) {
                for (n = 0; n < 3; n++) {
                    common_expansion_add_product3(&e, pj[m], qk[n], d[l]);
                    common_expansion_add_product3(&e, pk[m], qj[n], -d[l]);
                }
            }
        }
    }
    return common_expansion_sign(&e);
}

bool common_view_passes(const common_view *s, const pov_vec3 *a, const pov_vec3 *b, bool upward)
{
    int sign = orientation(s, a, b);

    if (s->d[s->forward] < 0.0)
        sign = -sign;
    return upward ? sign >= 0 : sign <= 0;
}
