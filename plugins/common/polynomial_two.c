/* Surfaces of a polynomial in double-double: what double leaves open. All roots on the line are isolated, and those that the ray does not
 * start on are reported. */
#include "common/polynomial.h"

#include "common/roots.h"

enum { MOST = COMMON_ORDER_MAX + 1 };

#define LINE(name) two_##name
#define LINE_NUMBER pov_two
#define LINE_VECTOR pov_two3
#define LINE_OF(x) pov_two_of(x, 0.0)
#define LINE_ADD(a, b) pov_two_add(a, b)
#define LINE_MUL(a, b) pov_two_mul(a, b)
#define LINE_BY(a, c) pov_two_mul_double(a, c)
#include "common/polynomial_line.h"

/* What coefficients and values are off by, in sums of the sizes of their terms: each rounding that p->off counts is one of 7 u^2 at most. */
static double off_of(const common_polynomial *p) { return 8.0 * COMMON_U * p->off; }

/* With all terms of a small order: nothing is looked up. */
COMMON_INLINE pov_two dense_value(const double *c, int n, pov_two3 at)
{
    pov_two x = { 0.0, 0.0 };

    COMMON_UNROLLED for (int i = n; i >= 0; i--) {
        pov_two y = { 0.0, 0.0 };

        COMMON_UNROLLED for (int j = n - i; j >= 0; j--) {
            pov_two z = { *c++, 0.0 };

            COMMON_UNROLLED for (int k = n - i - j; k > 0; k--)
                z = pov_two_add_double(pov_two_mul(z, at.z), *c++);
            y = j < n - i ? pov_two_add(pov_two_mul(y, at.y), z) : z;
        }
        x = i < n ? pov_two_add(pov_two_mul(x, at.x), y) : y;
    }
    return x;
}

static pov_two value_at(const common_polynomial *p, pov_two3 at)
{
    static const pov_two3 zero = { { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 } };
    pov_two power[MOST], value;

    switch (p->order) {
    case 2: return dense_value(p->at, 2, at);
    case 3: return dense_value(p->at, 3, at);
    case 4: return dense_value(p->at, 4, at);
    default: two_along(p, p->order, 0, at, zero, power, &value); return value;
    }
}

bool common_polynomial_is_inside_two(const common_polynomial *p, pov_two3 at)
{
    return !pov_two_less(pov_two_of(0.0, 0.0), value_at(p, at));
}

/* ---- a root that is known to be there ---- */

/* A step of Newton's method with the slope that double has. False: that may be off by too much. */
static bool step_once(const common_polynomial *p, const common_ray *k, const common_polynomial_root *r, pov_two *t)
{
    const pov_two at = pov_two_sum(r->base, r->t);
    const double n = p->order, per = 1.0 / r->length, step = -value_at(p, common_along_dd(k, at)).hi / r->slope;
    double left;

    *t = pov_two_add_double(*t, step);
    left = fabs(step / r->slope) * n * r->size * per * (n * per * fabs(step) + 4.0 * p->off);
    return left <= 0x1p-60 * fabs(at.hi + step) && left <= 0x1p-60 * r->length;
}

/* Newton's method kept in the bracket, until a step is nothing, or steps are what rounding makes of them. */
pov_two common_polynomial_complete(const common_polynomial *p, const common_ray *k, const common_polynomial_root *root, double lo, double hi, bool rising)
{
    const pov_two3 d = common_direction(k);
    pov_two power[2 * MOST], value[2], x = { root->t, 0.0 };
    double last = HUGE_VAL;

    if (step_once(p, k, root, &x) && x.hi >= lo && x.hi <= hi)
        return x;
    x = pov_two_of(root->t, 0.0);
    for (int turn = 0; turn < 100; turn++) {
        double step;

        two_along(p, p->order, 1, common_along_dd(k, pov_two_add_double(x, root->base)), d, power, value);
        step = -value[0].hi / value[1].hi;
        *((value[0].hi > 0.0) == rising ? &hi : &lo) = x.hi;
        if (!(x.hi + step >= lo && x.hi + step <= hi)) {
            const double middle = isfinite(hi - lo) ? 0.5 * (lo + hi) : 2.0 * x.hi;

            if (!(middle > lo && middle < hi))
                break;
            x = pov_two_of(middle, 0.0);
            continue;
        }
        x = pov_two_add_double(x, step);
        if (fabs(step) <= 0x1p-106 * fabs(x.hi) || (fabs(step) >= 0.5 * last && fabs(step) <= 0x1p-40 * root->length))
            break;
        last = fabs(step);
    }
    return x;
}

/* ---- all roots ---- */

typedef struct line {
    const common_polynomial *p;
    const common_ray *k;
    pov_two3 from;
    pov_two c[MOST];             /* about the base */
    int degree;
    double base, off[MOST + 1];
    uint32_t count;
    pov_two at[2 * MOST];        /* crossings, in the ray's local units */
} line;

/* What each coefficient is off by: a part of the sizes of its terms, which are the coefficients of one polynomial in the largest coordinate, and
 * what the ray's distance adds to that coordinate. */
static void find_off(line *l)
{
    const double reach = pov_largest(pov_two3_hi(l->from)), speed = pov_largest(l->k->d), far = 0x1p-102 * pov_largest(pov_two3_hi(l->k->f));
    const int n = l->p->order;

    for (int i = 0; i <= n + 1; i++)
        l->off[i] = 0.0;
    for (int m = n; m >= 0; m--) {
        for (int i = n - m; i > 0; i--)
            l->off[i] = l->off[i] * reach + l->off[i - 1] * speed;
        l->off[0] = l->off[0] * reach + l->p->size[m];
    }
    for (int i = 0; i <= n; i++)
        l->off[i] = off_of(l->p) * l->off[i] + far * (i + 1) * l->off[i + 1];
}

static void find_along(line *l, double base)
{
    pov_two power[MOST * MOST];

    l->base = base;
    l->from = common_along_two(l->k, base);
    two_along(l->p, l->p->order, l->p->order, l->from, common_direction(l->k), power, l->c);
    find_off(l);
    for (l->degree = l->p->order; l->degree > 0 && l->c[l->degree].hi == 0.0;)
        l->degree--;
}

/* The value at u, with x = u / (1 - u). */
static pov_two value_of(const pov_two *a, int degree, pov_two u, pov_two v)
{
    pov_two sum = a[0], power = u;

    for (int i = 1; i <= degree; i++) {
        sum = pov_two_add(pov_two_mul(sum, v), pov_two_mul(a[i], power));
        power = pov_two_mul(power, u);
    }
    return sum;
}

static double slope_of(const pov_two *b, int degree, double u)
{
    const double v = 1.0 - u;
    double sum = pov_two_sub(b[1], b[0]).hi, power = u, binomial = degree - 1;

    for (int i = 1; i < degree; i++) {
        sum = sum * v + binomial * power * pov_two_sub(b[i + 1], b[i]).hi;
        power *= u;
        binomial = binomial * (degree - 1 - i) / (i + 1);
    }
    return degree * sum;
}

/* u of the only root in a bracket: Newton's method, until a step is nothing, or steps are what rounding makes of them. */
static pov_two find_root(const pov_two *a, const pov_two *b, int degree, const common_bracket *root)
{
    double lo = root->lo, hi = root->hi, last = HUGE_VAL;
    pov_two u = { 0.5 * (lo + hi), 0.0 };

    for (int turn = 0; turn < 200; turn++) {
        const pov_two v = pov_two_sub(pov_two_of(1.0, 0.0), u), value = value_of(a, degree, u, v);
        const double slope = slope_of(b, degree, u.hi), step = -value.hi / slope;

        *((value.hi > 0.0) == root->rising ? &hi : &lo) = u.hi;
        if (u.hi + step >= lo && u.hi + step <= hi) {
            u = pov_two_add_double(u, step);
            if (fabs(step) <= 0x1p-100 * u.hi || (fabs(step) >= 0.5 * last && fabs(step) <= 0x1p-40 * u.hi))
                break;
            last = fabs(step);
        } else {
            const double middle = 0.5 * (lo + hi);

            if (!(middle > lo && middle < hi))
                break;
            u = pov_two_of(middle, 0.0);
        }
    }
    return u;
}

/* Ahead of the base, or behind it: the powers of x as they are, less the binomials, are Bernstein coefficients in u. */
static void find_side(line *l, double size, bool behind)
{
    const pov_two one = { 1.0, 0.0 };
    double binomial = 1.0, power = 1.0, off[MOST];
    pov_two a[MOST], b[MOST];
    common_brackets found;

    for (int i = 0; i <= l->degree; i++) {
        a[i] = pov_two_scale(l->c[i], behind && i % 2 != 0 ? -power : power);
        b[i] = pov_two_div(a[i], pov_two_of(binomial, 0.0));
        off[i] = l->off[i] * power / binomial;
        binomial = binomial * (l->degree - i) / (i + 1);
        power *= size;
    }
    common_isolate_bernstein_two(b, off, l->degree, &found);
    for (uint32_t i = 0; i < found.count; i++) {
        const pov_two u = find_root(a, b, l->degree, &found.at[i]);
        const pov_two t = pov_two_scale(pov_two_div(u, pov_two_sub(one, u)), behind ? -size : size);

        if (isfinite(t.hi))
            l->at[l->count++] = pov_two_add_double(t, l->base);
    }
}

/* The root near zero that a ray's start stands for. */
static pov_two find_start(const line *l)
{
    pov_two x = { 0.0, 0.0 };

    for (int turn = 0; turn < 4; turn++) {
        pov_two value = l->c[l->degree], slope = { 0.0, 0.0 };

        for (int i = l->degree - 1; i >= 0; i--) {
            slope = pov_two_add(pov_two_mul(slope, x), value);
            value = pov_two_add(pov_two_mul(value, x), l->c[i]);
        }
        x = pov_two_sub(x, pov_two_div(value, slope));
    }
    return x;
}

/* About the start, with that root divided out. False: it is not told from another one. */
static bool divide_start(line *l)
{
    double lost, shift;
    pov_two x;

    find_along(l, 0.0);
    if (l->degree < 1 || !(fabs(l->c[1].hi) > 2.0 * l->off[1]))
        return false;
    x = find_start(l);
    shift = l->off[0] / fabs(l->c[1].hi);
    for (int i = l->degree - 1; i > 0; i--) {
        l->c[i] = pov_two_add(l->c[i], pov_two_mul(l->c[i + 1], x));
        l->off[i] += fabs(x.hi) * l->off[i + 1] + 4.0 * shift * fabs(l->c[i + 1].hi);
    }
    lost = fabs(pov_two_add(l->c[0], pov_two_mul(l->c[1], x)).hi);
    l->degree--;
    for (int i = 0; i <= l->degree; i++) {
        l->c[i] = l->c[i + 1];
        l->off[i] = l->off[i + 1];
    }
    return lost <= 4.0 * (l->off[0] * fabs(x.hi) + shift * fabs(l->c[0].hi)) && fabs(l->c[0].hi) > 2.0 * l->off[0];
}

/* The crossing that a ray starts on is the nearest one to its start. */
static void drop_start(line *l, double size)
{
    uint32_t nearest = 0;

    for (uint32_t i = 1; i < l->count; i++)
        nearest = fabs(l->at[i].hi) < fabs(l->at[nearest].hi) ? i : nearest;
    if (l->count > 0 && fabs(l->at[nearest].hi) <= 0x1p-20 * (pov_largest(pov_two3_hi(l->k->f)) + size))
        l->at[nearest] = l->at[--l->count];
}

static double near_of(const line *l)
{
    double c[MOST];

    for (int i = 0; i <= l->degree; i++)
        c[i] = l->c[i].hi;
    return common_polynomial_near(c, l->degree);
}

/* The place about which both sides are searched must not be a root. */
static double find_base(line *l)
{
    static const double aside[] = { 0.0, 0.375, -0.4375, 0.5625, -0.6875, 1.3125 };
    const double base = -pov_dot(pov_two3_hi(l->k->f), l->k->d) / pov_dot(l->k->d, l->k->d);
    double size = 1.0;

    for (size_t i = 0; i < sizeof aside / sizeof *aside; i++) {
        find_along(l, base + aside[i] * size);
        size = near_of(l);
        if (fabs(l->c[0].hi) > 2.0 * l->off[0])
            break;
    }
    return size;
}

/* On the whole line, about the place nearest to the origin. */
static void find_all(line *l, bool from_here)
{
    const double size = find_base(l);

    if (l->degree < 1)
        return;
    find_side(l, size, false);
    find_side(l, size, true);
    if (from_here)
        drop_start(l, size);
}

void common_polynomial_intersect_two(const common_polynomial *p, const pov_ray *ray, pov_hits *hits)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    const bool from_here = ray->origin_surface == hits->owner;
    line l;

    hits->escalated++;
    l.p = p;
    l.k = &k;
    l.count = 0;
    if (!from_here || !divide_start(&l))
        find_all(&l, from_here);
    else if (l.degree > 0)
        find_side(&l, near_of(&l), false);
    for (uint32_t i = 0; i < l.count; i++)
        if (!common_polynomial_report(&k, l.at[i], POV_MARK_ESCALATED, hits))
            return;
}
