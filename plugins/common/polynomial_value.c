/* A polynomial as double has it: its coefficients along a ray, about how large the roots of such are, and its value and slope at points,
 * which tell the inside and normals. */
#include "common/polynomial.h"

#include "common/dense.h"
#include "common/local.h"

enum { MOST = COMMON_ORDER_MAX + 1 };

/* ---- along a ray ---- */

/* Polynomials in the distance have n + 1 coefficients, of which the last ones may be zero. */
#include "common/polynomial_line.h"

/* The loops of order 6 are unrolled. */
void common_polynomial_along(const common_polynomial *p, pov_vec3 o, pov_vec3 d, double *out)
{
    double small[7 * 7], power[MOST * MOST];

    switch (p->order) {
    case 2: common_dense_along(p->at, 2, o, d, out); break;
    case 3: common_dense_along(p->at, 3, o, d, out); break;
    case 4: common_dense_along(p->at, 4, o, d, out); break;
    case 6: line_along(p, 6, 6, o, d, small, out); break;
    default: line_along(p, p->order, p->order, o, d, power, out); break;
    }
}

/* ---- how large roots are ---- */

/* The power of two above the size of a number, as frexp() has it. */
static inline int exponent_of(double x)
{
    uint64_t bits;
    int e;

    memcpy(&bits, &x, sizeof bits);
    e = (int)(bits >> 52 & 0x7ff);
    if (e == 0 || e == 0x7ff)
        frexp(x, &e);
    else
        e -= 1022;
    return e;
}

/* By its exponent, a length about as large as the roots are in the mean. */
static int middle_size(const double *c, int degree)
{
    int least = 0, e;

    while (least < degree && c[least] == 0.0)
        least++;
    if (least == degree)
        return 0;
    e = (exponent_of(c[least]) - exponent_of(c[degree])) / (degree - least);
    return e > 300 ? 300 : e < -300 ? -300 : e;
}

/* Where the highest powers hardly count among the other roots, theirs are much farther: the length is that of the others. So it is
 * along a line that the surface comes near to at infinity. */
double common_polynomial_near(const double *c, int degree)
{
    enum { NEGLIGIBLE = 20 };
    int top = degree, size = middle_size(c, degree);

    for (int next = degree - 1; next > 0; next--) {
        const int smaller = middle_size(c, next);

        if (c[next] == 0.0)
            continue;
        if (exponent_of(c[top]) + (top - next) * smaller + NEGLIGIBLE > exponent_of(c[next]))
            break;
        top = next;
        size = smaller;
    }
    return ldexp(1.0, size);
}

/* ---- points ---- */

/* The coefficient of x^i y^j: a sum of powers of z. */
static common_sloped row_at(const common_polynomial *p, uint32_t row, double z)
{
    const common_term *term = p->term + p->first[row], *end = p->term + p->first[row + 1];
    common_sloped s = { 0.0, 0.0, 0.0, 0.0 };

    if (term == end)
        return s;
    for (int k = term->k; k >= 0; k--) {
        s.z = s.z * z + s.value;
        s.value *= z;
        if (term < end && term->k == k)
            s.value += term++->c;
    }
    return s;
}

/* Horner's scheme from the highest powers that are there. */
static double sparse_at(const common_polynomial *p, pov_vec3 at, pov_vec3 *out)
{
    const int n = p->order;
    common_sloped s = { 0.0, 0.0, 0.0, 0.0 };

    for (int i = p->highest_x; i >= 0; i--) {
        const uint32_t row = (uint32_t)((n - i) * (n - i + 1) / 2 + n - i);   /* of j = 0 */
        common_sloped y = { 0.0, 0.0, 0.0, 0.0 };

        for (int j = p->highest[i]; j >= 0; j--) {
            const common_sloped z = row_at(p, row - (uint32_t)j, at.z);

            common_take_row(&y, z, at.y);
        }
        common_take_plane(&s, y, at.x);
    }
    *out = pov_vec3_of(s.x, s.y, s.z);
    return s.value;
}

/* The same of a small order. */
COMMON_INLINE double dense_at(const double *c, int n, pov_vec3 at, pov_vec3 *out)
{
    const common_sloped s = common_dense_at(c, n, at);

    *out = pov_vec3_of(s.x, s.y, s.z);
    return s.value;
}

double common_polynomial_at(const common_polynomial *p, pov_vec3 at, pov_vec3 *out)
{
    switch (p->order) {
    case 2: return dense_at(p->at, 2, at, out);
    case 3: return dense_at(p->at, 3, at, out);
    case 4: return dense_at(p->at, 4, at, out);
    default: return sparse_at(p, at, out);
    }
}

/* ---- the class ---- */

bool common_polynomial_bounds(const void *self, pov_box *out)
{
    const common_polynomial *p = self;

    if (p->bounded)
        *out = p->box;
    return p->bounded;
}

bool common_polynomial_inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const common_polynomial *p = self;
    const pov_vec3 at = pov_add(point, point_lo);
    pov_vec3 slope;
    const double value = common_polynomial_at(p, at, &slope);

    if (fabs(value) > common_polynomial_value_off(p, common_polynomial_size(p, pov_largest(at))))
        return value < 0.0;
    return common_polynomial_is_inside_two(p, pov_two3_of(point, point_lo));
}

void common_polynomial_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);

    common_polynomial_at(self, pov_two3_hi(common_point(&k, at)), out);
    *out = pov_unit(*out);
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}
