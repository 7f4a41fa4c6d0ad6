#include "common/polynomial.h"

#include "common/bernstein.h"
#include "common/curve.h"
#include "common/local.h"

enum { MOST = COMMON_ORDER_MAX + 1 };

/* ---- loading ---- */

static uint32_t count_of(int n) { return (uint32_t)((n + 1) * (n + 2) * (n + 3) / 6); }

bool common_polynomial_make(common_polynomial *p, const pov_host *host, pov_reader *in, int order)
{
    p->order = order;
    p->count = count_of(order);
    p->at = host->alloc(in, p->count * sizeof *p->at);
    return p->at != NULL;
}

/* Before it stand the terms of higher powers of x, then those of higher powers of y. */
uint32_t common_polynomial_place(int order, int i, int j, int k)
{
    const int rest = order - i, both = rest - j;

    return (uint32_t)(rest * (rest + 1) * (rest + 2) / 6 + both * (both + 1) / 2 + both - k);
}

void common_polynomial_read(common_polynomial *p, const pov_host *host, pov_reader *in, int order)
{
    if (!common_polynomial_make(p, host, in, order))
        return;
    host->accept(in, ",");
    host->expect(in, "<");
    for (uint32_t i = 0; i < p->count; i++) {
        if (i > 0)
            host->accept(in, ",");
        p->at[i] = host->number(in);
    }
    host->expect(in, ">");
    common_sturm_read(host, in);
}

bool common_polynomial_bounds(const void *self, pov_box *out)
{
    (void)self;
    (void)out;
    return false;
}

/* ---- along a ray ---- */

/* A polynomial in the distance; degree -1: zero. */
typedef struct series { int degree; double c[MOST]; } series;

/* s = s (o + d t) + a. */
static void times_plus(series *s, double o, double d, double a)
{
    if (s->degree >= 0) {
        s->c[s->degree + 1] = s->c[s->degree] * d;
        for (int i = s->degree; i > 0; i--)
            s->c[i] = s->c[i] * o + s->c[i - 1] * d;
        s->c[0] = s->c[0] * o + a;
        s->degree++;
    } else if (a != 0.0) {
        s->degree = 0;
        s->c[0] = a;
    }
}

static void add(series *s, const series *a)
{
    for (int i = s->degree + 1; i <= a->degree; i++)
        s->c[i] = 0.0;
    s->degree = a->degree > s->degree ? a->degree : s->degree;
    for (int i = 0; i <= a->degree; i++)
        s->c[i] += a->c[i];
}

/* Horner's scheme in x, of which each coefficient is one in y, of which each is one in z. */
static void along(const common_polynomial *p, pov_vec3 o, pov_vec3 d, series *out)
{
    const double *c = p->at;

    out->degree = -1;
    for (int i = p->order; i >= 0; i--) {
        series y = { -1, { 0.0 } };

        for (int j = p->order - i; j >= 0; j--) {
            series z = { -1, { 0.0 } };

            for (int k = p->order - i - j; k >= 0; k--)
                times_plus(&z, o.z, d.z, *c++);
            times_plus(&y, o.y, d.y, 0.0);
            add(&y, &z);
        }
        times_plus(out, o.x, d.x, 0.0);
        add(out, &y);
    }
}

/* ---- roots on the whole line ---- */

/* The power of two nearest to the size of a number. */
static int exponent_of(double x)
{
    int e;

    frexp(x, &e);
    return e;
}

/* A length about as large as the roots are in the mean. */
static double middle_size(const double *c, int degree)
{
    int least = 0, e;

    while (least < degree && c[least] == 0.0)
        least++;
    if (least == degree)
        return 1.0;
    e = (exponent_of(c[least]) - exponent_of(c[degree])) / (degree - least);
    return ldexp(1.0, e > 300 ? 300 : e < -300 ? -300 : e);
}

typedef struct search { const common_ray *k; double base, start; bool from_here; pov_hits *hits; } search;

static bool report(const search *s, double t)
{
    const pov_two at = pov_two_sum(s->base, t);
    const pov_mark mark = { 0, 0, 0.0, 0.0 };

    if (!isfinite(at.hi * s->k->unit))
        return true;
    return pov_cross(s->hits, at.hi * s->k->unit, at.lo * s->k->unit, mark);
}

/* Roots from 0 to `size` (negative: towards the past), or from there to infinity. False: nothing more is wanted. */
static bool search_part(const search *s, const double *c, int degree, double size, bool beyond)
{
    double a[MOST], b[MOST], root[MOST], power = 1.0, sum = 0.0;
    uint32_t found;

    for (int i = 0; i <= degree; i++) {
        a[beyond ? degree - i : i] = c[i] * power;
        sum += fabs(c[i] * power);
        power *= size;
    }
    common_bernstein(a, degree, b);
    found = common_bernstein_roots(b, degree, (degree + 4) * 0x1p-51 * sum, root);
    for (uint32_t i = 0; i < found; i++)
        if (!report(s, beyond ? size / root[i] : size * root[i]))
            return false;
    return true;
}

static void search_line(const search *s, const double *c, int degree)
{
    double size;

    while (degree > 0 && c[degree] == 0.0)
        degree--;
    if (degree < 1)
        return;
    size = middle_size(c, degree);
    if (s->start < 0.0 && !search_part(s, c, degree, -size, false))
        return;
    if (s->start < -size && !search_part(s, c, degree, -size, true))
        return;
    if (search_part(s, c, degree, size, false))
        search_part(s, c, degree, size, true);
}

void common_polynomial_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    search s = { &k, 0.0, 0.0, ray->origin_surface == hits->owner, hits };
    series c;

    if (!s.from_here)
        s.base = -pov_dot(pov_two3_hi(k.f), k.d) / pov_dot(k.d, k.d);
    s.start = -s.base;
    along(self, common_along(&k, s.base), k.d, &c);
    /* The root that a ray starts on is at 0: it is divided out. */
    if (s.from_here)
        search_line(&s, c.c + 1, c.degree - 1);
    else
        search_line(&s, c.c, c.degree);
}

/* ---- points ---- */

/* The value, and its slope. */
static double value_at(const common_polynomial *p, pov_vec3 at, pov_vec3 *slope)
{
    const double *c = p->at;
    double x = 0.0, by_x = 0.0, x_by_y = 0.0, x_by_z = 0.0;

    for (int i = p->order; i >= 0; i--) {
        double y = 0.0, by_y = 0.0, y_by_z = 0.0;

        for (int j = p->order - i; j >= 0; j--) {
            double z = 0.0, by_z = 0.0;

            for (int k = p->order - i - j; k >= 0; k--) {
                by_z = by_z * at.z + z;
                z = z * at.z + *c++;
            }
            by_y = by_y * at.y + y;
            y = y * at.y + z;
            y_by_z = y_by_z * at.y + by_z;
        }
        by_x = by_x * at.x + x;
        x = x * at.x + y;
        x_by_y = x_by_y * at.x + by_y;
        x_by_z = x_by_z * at.x + y_by_z;
    }
    *slope = pov_vec3_of(by_x, x_by_y, x_by_z);
    return x;
}

bool common_polynomial_inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    pov_vec3 slope;

    return value_at(self, pov_add(point, point_lo), &slope) <= 0.0;
}

void common_polynomial_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);

    value_at(self, pov_two3_hi(common_point(&k, at)), out);
    *out = pov_unit(*out);
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}
