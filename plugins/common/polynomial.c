#include "common/polynomial.h"

#include "common/bernstein.h"
#include "common/clip.h"
#include "common/curve.h"
#include "common/dense.h"
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
    common_polynomial_close(p, host, in);
}

static void list_terms(common_polynomial *p)
{
    uint32_t at = 0, row = 0, terms = 0;

    p->highest_x = p->highest_z = -1;
    for (int i = p->order; i >= 0; i--) {
        p->highest[i] = -1;
        for (int j = p->order - i; j >= 0; j--) {
            p->first[row++] = terms;
            for (int k = p->order - i - j; k >= 0; k--, at++)
                if (p->at[at] != 0.0) {
                    const common_term one = { p->at[at], k };

                    p->term[terms++] = one;
                    p->highest[i] = j > p->highest[i] ? j : p->highest[i];
                    p->highest_z = k > p->highest_z ? k : p->highest_z;
                    p->highest_x = i > p->highest_x ? i : p->highest_x;
                }
        }
    }
    p->first[row] = terms;
}

void common_polynomial_close(common_polynomial *p, const pov_host *host, pov_reader *in)
{
    const uint32_t n = (uint32_t)p->order;

    p->term = host->alloc(in, p->count * sizeof *p->term);
    p->first = host->alloc(in, ((n + 1) * (n + 2) / 2 + 1) * sizeof *p->first);
    p->highest = host->alloc(in, (n + 1) * sizeof *p->highest);
    if (!p->term || !p->first || !p->highest)
        return;
    list_terms(p);
    p->bounded = common_polynomial_find_box(p, &p->box);
}

bool common_polynomial_bounds(const void *self, pov_box *out)
{
    const common_polynomial *p = self;

    if (p->bounded)
        *out = p->box;
    return p->bounded;
}

/* ---- along a ray ---- */

/* Polynomials in the distance have n + 1 coefficients, of which the last ones may be zero. */

/* s = s (o + d t). */
COMMON_INLINE void times(double *s, int n, double o, double d)
{
    for (int i = n; i > 0; i--)
        s[i] = s[i] * o + s[i - 1] * d;
    s[0] *= o;
}

/* s += a c. */
COMMON_INLINE void add(double *s, int n, const double *a, double c)
{
    for (int i = 0; i <= n; i++)
        s[i] += a[i] * c;
}

/* The powers of z along the ray, one after the other. */
COMMON_INLINE void find_powers(double *power, int n, int highest, double o, double d)
{
    for (int i = 0; i <= n; i++)
        power[i] = i == 0 ? 1.0 : 0.0;
    for (int k = 1; k <= highest; k++) {
        for (int i = 0; i <= n; i++)
            power[k * (n + 1) + i] = power[(k - 1) * (n + 1) + i];
        times(power + k * (n + 1), n, o, d);
    }
}

/* Horner's scheme in x, of which each coefficient is one in y, of which each is a sum of powers of z. */
COMMON_INLINE void along_of(const common_polynomial *p, int n, pov_vec3 o, pov_vec3 d, double *power, double *out)
{
    const common_term *term = p->term;

    find_powers(power, n, p->highest_z, o.z, d.z);
    for (int i = 0; i <= n; i++)
        out[i] = 0.0;
    for (int i = p->highest_x; i >= 0; i--) {
        const uint32_t row = (uint32_t)((n - i) * (n - i + 1) / 2 + n - i);   /* of j = 0 */
        double y[MOST];

        if (i < p->highest_x)
            times(out, n, o.x, d.x);
        if (p->highest[i] < 0)
            continue;
        for (int k = 0; k <= n; k++)
            y[k] = 0.0;
        for (int j = p->highest[i]; j >= 0; j--) {
            const common_term *end = p->term + p->first[row - (uint32_t)j + 1];

            if (j < p->highest[i])
                times(y, n, o.y, d.y);
            for (; term < end; term++)
                add(y, n, power + term->k * (n + 1), term->c);
        }
        add(out, n, y, 1.0);
    }
}

/* The loops of order 6 are unrolled. */
static void along(const common_polynomial *p, pov_vec3 o, pov_vec3 d, double *out)
{
    double small[7 * 7], power[MOST * MOST];

    switch (p->order) {
    case 2: common_dense_along(p->at, 2, o, d, out); break;
    case 3: common_dense_along(p->at, 3, o, d, out); break;
    case 4: common_dense_along(p->at, 4, o, d, out); break;
    case 6: along_of(p, 6, o, d, small, out); break;
    default: along_of(p, p->order, o, d, power, out); break;
    }
}

/* ---- roots on the whole line ---- */

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
static double near_size(const double *c, int degree)
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

typedef struct search { const common_ray *k; double base, start; bool from_here; pov_hits *hits; } search;

static bool report(const search *s, double t)
{
    const pov_two at = pov_two_sum(s->base, t);
    const pov_mark mark = { 0, 0, 0.0, 0.0 };

    if (!isfinite(at.hi * s->k->unit))
        return true;
    return pov_cross(s->hits, at.hi * s->k->unit, at.lo * s->k->unit, mark);
}

/* Do the ray's crossings end before a local distance, from its start? */
static bool ends_before(const search *s, double t)
{
    return t * s->k->unit * (1.0 - 0x1p-40) > s->hits->tmax + s->hits->slack;
}

/* Roots from 0 to `size` (negative: towards the past), or from there to infinity. *left: how many there may be. False: nothing more
 * is wanted. */
static bool search_part(const search *s, const double *c, int degree, double size, bool beyond, int *left)
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
    *left -= (int)found;
    for (uint32_t i = 0; i < found; i++)
        if (!report(s, beyond ? size / root[i] : size * root[i]))
            return false;
    return true;
}

/* No more roots are ahead, or behind, than the coefficients change their sign there (Descartes' rule). */
static int most_roots(const double *c, int degree, bool behind)
{
    bool above = c[0] > 0.0;
    int changes = 0;

    if (c[0] == 0.0)
        return degree + 1;
    for (int i = 1; i <= degree; i++)
        if (c[i] != 0.0 && ((c[i] > 0.0) != (behind && i % 2 != 0)) != above) {
            above = !above;
            changes++;
        }
    return changes;
}

static void search_line(const search *s, const double *c, int degree)
{
    int ahead, behind;
    double size;

    while (degree > 0 && c[degree] == 0.0)
        degree--;
    ahead = ends_before(s, s->base) ? 0 : most_roots(c, degree, false);
    behind = s->start < 0.0 ? most_roots(c, degree, true) : 0;
    if (degree < 1 || ahead + behind == 0)
        return;
    size = near_size(c, degree);
    if (behind > 0 && !search_part(s, c, degree, -size, false, &behind))
        return;
    if (behind > 0 && s->start < -size && !search_part(s, c, degree, -size, true, &behind))
        return;
    if (ahead > 0 && !ends_before(s, s->base) && search_part(s, c, degree, size, false, &ahead) && ahead > 0 && !ends_before(s, s->base + size))
        search_part(s, c, degree, size, true, &ahead);
}

/* Of what is bounded only the stretch within the box counts. The root that a ray starts on is at 0: it is divided out. */
static void search_stretch(search *s, const common_polynomial *p, double lo, double hi)
{
    double c[MOST], b[MOST], root[MOST], sum = 0.0;
    const int degree = p->order - s->from_here;
    const double length = hi - lo, per_length = 1.0 / length;
    const common_wanted wanted = common_wants(s->k, lo, 0.0, s->hits);
    uint32_t found;

    s->base = lo;
    along(p, common_along(s->k, lo), pov_scale(s->k->d, length), c);
    for (int i = 0; i <= degree; i++)
        sum += fabs(c[i + s->from_here]);
    common_bernstein(c + s->from_here, degree, b);
    found = common_bernstein_first(b, degree, (degree + 4) * 0x1p-51 * sum, wanted.enough * per_length, wanted.within * per_length, root);
    for (uint32_t i = 0; i < found; i++)
        if (!report(s, root[i] * length))
            return;
}

static void search_box(search *s, const common_polynomial *p, const pov_hits *hits)
{
    common_span span;

    if (!common_clip(s->k, p->box.lo, p->box.hi, &span) || span.hi < 0.0 || span.lo * s->k->unit > hits->tmax)
        return;
    if (!s->from_here)
        search_stretch(s, p, span.lo, span.hi);
    else
        search_stretch(s, p, 0.0, span.hi);
}

void common_polynomial_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_polynomial *p = self;
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    search s = { &k, 0.0, 0.0, ray->origin_surface == hits->owner, hits };
    double c[MOST];

    if (p->bounded) {
        search_box(&s, p, hits);
        return;
    }
    if (!s.from_here)
        s.base = -pov_dot(pov_two3_hi(k.f), k.d) / pov_dot(k.d, k.d);
    s.start = -s.base;
    along(p, common_along(&k, s.base), k.d, c);
    /* The root that a ray starts on is at 0: it is divided out. */
    search_line(&s, c + s.from_here, p->order - s.from_here);
}

void common_polynomial_intersect_between(const void *self, const pov_ray *ray, pov_hits *hits)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_polynomial *p = self;
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    search s = { &k, 0.0, 0.0, ray->origin_surface == hits->owner, hits };
    const double lo = s.from_here ? 0.0 : hits->tmin * k.per_unit * (1.0 - 0x1p-40), hi = hits->tmax * k.per_unit * (1.0 + 0x1p-40);

    if (p->bounded || !isfinite(hi))
        common_polynomial_intersect(self, ray, hits);
    else
        search_stretch(&s, p, lo, hi);
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

static double value_at(const common_polynomial *p, pov_vec3 at, pov_vec3 *out)
{
    switch (p->order) {
    case 2: return dense_at(p->at, 2, at, out);
    case 3: return dense_at(p->at, 3, at, out);
    case 4: return dense_at(p->at, 4, at, out);
    default: return sparse_at(p, at, out);
    }
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
