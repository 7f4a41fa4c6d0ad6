/* Rays and one surface of the third or fourth order side by side: by the operations of polynomial.c. Lanes that are not certain are left to it. */
#include "common/polynomial.h"

#include "common/bernstein.h"
#include "common/clip.h"
#include "common/dense.h"
#include "common/lanes.h"

#include <math.h>

/* HALVED: roundings of eight halvings. */
enum { N = COMMON_LANES, HALF = N / 2, MOST = COMMON_DENSE_MAX, LEAST = 3, HALVED = 32 };

/* ---- a stretch of the ray ---- */

/* By lane: the interval of a ray, and its stretch in local distances. missed: above 0 where nothing of that is in the box. */
typedef struct stretches { common_lane tmin, tmax, base, length, unit, sizes, known, missed; } stretches;

/* As common_polynomial_size(). */
COMMON_INLINE double size_at(const double *size, int order, double reach)
{
    double sum = size[order];

    COMMON_UNROLLED for (int m = order - 1; m >= 0; m--)
        sum = sum * reach + size[m];
    return sum;
}

/* As common_clip_axis(). */
COMMON_INLINE void clip_axis(common_span *s, double from, double d, double lo, double hi)
{
    const double a = (lo - from) / d, b = (hi - from) / d, in = from >= lo ? from <= hi ? HUGE_VAL : -HUGE_VAL : -HUGE_VAL;
    const double near = d != 0.0 ? a < b ? a : b : -in, far = d != 0.0 ? a < b ? b : a : in;

    s->lo = near > s->lo ? near : s->lo;
    s->hi = far < s->hi ? far : s->hi;
}

/* As common_clip(). */
COMMON_INLINE common_span clip(const common_ray *k, pov_vec3 lo, pov_vec3 hi)
{
    const pov_vec3 f = pov_two3_hi(k->f);
    const double margin = 0x1p-40 + 0x1p-48 * pov_largest(f);
    common_span s = { -HUGE_VAL, HUGE_VAL };

    clip_axis(&s, f.x, k->d.x, lo.x - margin, hi.x + margin);
    clip_axis(&s, f.y, k->d.y, lo.y - margin, hi.y + margin);
    clip_axis(&s, f.z, k->d.z, lo.z - margin, hi.z + margin);
    return s;
}

/* As common_bernstein(), of stretches that are not missed. */
COMMON_INLINE void put_bernstein(double *a, int order, double missed, uint32_t i, common_bernsteins *out)
{
    double binomial = 1.0;

    COMMON_UNROLLED for (int k = 0; k <= order; k++) {
        a[k] = a[k] / binomial;
        binomial = binomial * (order - k) / (k + 1);
    }
    COMMON_UNROLLED for (int k = 1; k <= order; k++)
        COMMON_UNROLLED for (int j = order; j >= k; j--)
            a[j] += a[j - 1];
    COMMON_UNROLLED for (int k = 0; k <= order; k++)
        out->b[k][i] = missed > 0.0 ? 1.0 : a[k];
}

COMMON_INLINE void find_along(const common_polynomial *p, int order, bool bounded, const common_rays *l, uint32_t i, stretches *io,
                              common_bernsteins *out)
{
    static const pov_two3 zero = { { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 } };
    const pov_ray ray = common_get_ray(l, i);
    const common_ray k = common_enter(&ray, zero, 1.0);
    const common_span between = { io->tmin[i] * k.per_unit * (1.0 - 0x1p-40), io->tmax[i] * k.per_unit * (1.0 + 0x1p-40) };
    const common_span span = bounded ? clip(&k, p->box.lo, p->box.hi) : between;
    const double lo = span.lo, hi = span.hi, length = hi - lo, ahead = lo * k.unit > io->tmax[i] ? 1.0 : hi < 0.0 ? 1.0 : 0.0;
    const double missed = bounded ? lo <= hi ? ahead : 1.0 : 0.0;
    const double off = 0x1p-40 * (1.0 + fabs(lo)), least = io->tmin[i] * k.per_unit - lo + off, per_length = 1.0 / length;
    const pov_vec3 from = common_along(&k, lo);
    const double sizes = bounded ? p->sizes : size_at(p->size, order, common_polynomial_reach(&k, from, length));
    double a[MOST + 1];

    common_dense_along(p->at, order, from, pov_scale(k.d, length), a);
    put_bernstein(a, order, missed, i, out);
    out->noise[i] = missed > 0.0 ? 0.0 : (p->off + HALVED * COMMON_U) * sizes;
    out->beyond[i] = (least > 0.0 ? least : 0.0) * per_length;
    out->within[i] = -HUGE_VAL;
    io->base[i] = lo;
    io->length[i] = length;
    io->unit[i] = k.unit;
    io->sizes[i] = sizes;
    io->known[i] = bounded ? lo < 0x1p40 * p->wide ? 1.0 : missed : hi < HUGE_VAL ? 1.0 : 0.0;
    io->missed[i] = missed;
}

/* As common_bernstein_slope(). */
COMMON_INLINE double slope_at(const common_bernsteins *all, int order, uint32_t i, double u)
{
    const double v = 1.0 - u;
    double sum = all->b[1][i] - all->b[0][i], power = u, binomial = order - 1;

    COMMON_UNROLLED for (int k = 1; k < order; k++) {
        sum = sum * v + binomial * power * (all->b[k + 1][i] - all->b[k][i]);
        power *= u;
        binomial = binomial * (order - 1 - k) / (k + 1);
    }
    return order * sum;
}

/* Above 0 where the distance is good enough. */
COMMON_INLINE double is_good(const common_polynomial *p, int order, const common_rays *l, uint32_t i, const stretches *s,
                             const common_bernsteins *all, double x)
{
    static const pov_two3 zero = { { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 } };
    const pov_ray ray = common_get_ray(l, i);
    const common_ray k = common_enter(&ray, zero, 1.0);
    const double slope = slope_at(all, order, i, x) / s->length[i];
    const common_polynomial_root root = { s->base[i], x * s->length[i], slope, s->sizes[i], s->length[i] };
    const pov_two at = pov_two_sum(root.base, root.t);
    const pov_vec3 point = common_polynomial_point(&k, at);
    const double reach = pov_largest(point) + common_far_slack(&k), sizes = size_at(p->size, order, reach);

    return common_polynomial_trust(p, &root, common_dense_at(p->at, order, point).value, sizes, common_polynomial_allowed(p, at.hi, reach));
}

/* A normal, and not 0 where pov_unit() does not scale. */
COMMON_INLINE double find_normal(const common_polynomial *p, int order, const common_rays *l, uint32_t i, double t, double t_lo, common_lane3 *out)
{
    static const pov_two3 zero = { { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 } };
    const pov_ray ray = common_get_ray(l, i);
    const common_ray k = common_enter(&ray, zero, 1.0);
    const pov_two3 at = common_along_dd(&k, pov_two_of(t * k.per_unit, t_lo * k.per_unit));
    const common_sloped s = common_dense_at(p->at, order, pov_two3_hi(at));
    const pov_vec3 w = pov_vec3_of(s.x, s.y, s.z);
    const double length = sqrt(pov_dot(w, w)), largest = pov_largest(w);

    common_put(out, i, pov_vec3_of(w.x / length, w.y / length, w.z / length));
    return (int)(largest > 1e-100) & (int)(largest < 1e100) ? 1.0 : 0.0;
}

/* Functions an order, whose loops are unrolled. */
#define OF_ORDER(n)                                                                                                                        \
    COMMON_SEPARATE static void find_between_##n(const common_polynomial *p, const common_rays *restrict l, stretches *restrict io,        \
                                                 common_bernsteins *restrict out)                                                         \
    {                                                                                                                                      \
        for (uint32_t i = 0; i < N; i++)                                                                                                   \
            find_along(p, n, false, l, i, io, out);                                                                                        \
    }                                                                                                                                      \
    COMMON_SEPARATE static void find_boxed_##n(const common_polynomial *p, const common_rays *restrict l, stretches *restrict io,          \
                                               common_bernsteins *restrict out)                                                           \
    {                                                                                                                                      \
        for (uint32_t i = 0; i < N; i++)                                                                                                   \
            find_along(p, n, true, l, i, io, out);                                                                                         \
    }                                                                                                                                      \
    COMMON_SEPARATE static void find_good_##n(const common_polynomial *p, const common_rays *restrict l, const stretches *restrict s,      \
                                              const common_bernsteins *restrict all, const double *restrict x, double *restrict good)     \
    {                                                                                                                                      \
        for (uint32_t i = 0; i < N; i++)                                                                                                   \
            good[i] = is_good(p, n, l, i, s, all, x[i]);                                                                                   \
    }                                                                                                                                      \
    COMMON_SEPARATE static void find_normals_##n(const common_polynomial *p, const common_rays *restrict l, const double *restrict t,      \
                                                 const double *restrict t_lo, common_lane3 *restrict out, double *restrict good)          \
    {                                                                                                                                      \
        for (uint32_t i = 0; i < N; i++)                                                                                                   \
            good[i] = find_normal(p, n, l, i, t[i], t_lo[i], out);                                                                         \
    }

OF_ORDER(3)
OF_ORDER(4)

/* ---- crossings ---- */

static bool is_known(const stretches *s, const common_first_of_bernsteins *of, uint32_t i, const pov_ray *ray, const pov_hits *hits)
{
    return s->known[i] > 0.0 && !(of->open[i] > 0.0) && hits->want != POV_WANT_ALL && !hits->always_exact &&
           ray->origin_surface != hits->owner;
}

static bool is_any(const double *flags)
{
    bool any = false;

    for (uint32_t i = 0; i < N; i++)
        any |= flags[i] > 0.0;
    return any;
}

static void report(const stretches *s, const common_first_of_bernsteins *of, uint32_t i, pov_hits *hits)
{
    const pov_two at = pov_two_sum(s->base[i], of->root[i] * s->length[i]);
    const pov_mark mark = { 0, 0, 0.0, 0.0 };

    pov_cross(hits, at.hi * s->unit[i], at.lo * s->unit[i], mark);
}

/* Only any crossing is wanted, and this one certainly is in the interval? */
static bool is_enough(const stretches *s, uint32_t i, double x, const pov_hits *hits)
{
    const double at = (s->base[i] + x * s->length[i]) * s->unit[i], off = 0x1p-40 * (fabs(at) + fabs(s->base[i]) * s->unit[i]);

    return hits->want == POV_WANT_ANY && at - off > hits->tmin && at + off + hits->slack < hits->tmax;
}

static void find_stretches(const common_polynomial *p, const common_rays *l, stretches *io, common_bernsteins *out)
{
    if (p->order == 3)
        (p->bounded ? find_boxed_3 : find_between_3)(p, l, io, out);
    else
        (p->bounded ? find_boxed_4 : find_between_4)(p, l, io, out);
}

/* Between the two distances of each, or in the box. */
static void intersect_some(const common_polynomial *p, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    common_first_of_bernsteins first;
    common_bernsteins all;
    common_rays lanes;
    common_lane good;
    stretches s;

    common_put_four_of(&lanes, 0, rays, n);
    common_put_four_of(&lanes, HALF, rays, n);
    for (uint32_t i = 0; i < N; i++) {
        const pov_hits *h = hits[common_lane_of(i, n)];

        s.tmin[i] = h->tmin;
        s.tmax[i] = h->tmax;
    }
    find_stretches(p, &lanes, &s, &all);
    common_bernstein_certain_many(&all, p->order, &first);
    if (is_any(first.found))
        (p->order == 3 ? find_good_3 : find_good_4)(p, &lanes, &s, &all, first.root, good);
    for (uint32_t i = 0; i < n; i++) {
        const bool found = first.found[i] > 0.0;

        if (s.missed[i] > 0.0 && !hits[i]->always_exact && rays[i]->origin_surface != hits[i]->owner)
            continue;
        if (!is_known(&s, &first, i, rays[i], hits[i]) || (found && !(good[i] > 0.0) && !is_enough(&s, i, first.root[i], hits[i])))
            common_polynomial_intersect_between(p, rays[i], hits[i]);
        else if (found)
            report(&s, &first, i, hits[i]);
    }
}

/* How many of n are one surface of such an order, up to as many as there are lanes. */
static uint32_t count_alike(const void *const *selves, uint32_t n)
{
    const common_polynomial *p = selves[0];
    uint32_t some = 1;

    while ((p->order == 3 || p->order == 4) && some < N && some < n && selves[some] == selves[0])
        some++;
    return some;
}

/* Between the two distances of each, or all of it. */
static void intersect_alike(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n, bool between)
{
    for (uint32_t some; n > 0; n -= some, selves += some, rays += some, hits += some) {
        const common_polynomial *p = selves[0];

        some = count_alike(selves, n);
        if (some >= LEAST && (between || p->bounded))
            intersect_some(p, rays, hits, some);
        else
            for (uint32_t i = 0; i < some; i++)
                (between ? common_polynomial_intersect_between : common_polynomial_intersect)(p, rays[i], hits[i]);
    }
}

void common_polynomial_intersect_between_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    intersect_alike(selves, rays, hits, n, true);
}

void common_polynomial_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    intersect_alike(selves, rays, hits, n, false);
}

/* ---- normals ---- */

static void normals_of(const common_polynomial *p, const pov_ray *const *rays, const pov_crossing *const *at, pov_vec3 *const *out, uint32_t n)
{
    common_lane t, t_lo, good;
    common_lane3 unit;
    common_rays lanes;

    common_put_crossings_of(&lanes, t, t_lo, rays, at, n);
    (p->order == 3 ? find_normals_3 : find_normals_4)(p, &lanes, t, t_lo, &unit, good);
    for (uint32_t i = 0; i < n; i++)
        if (good[i] > 0.0)
            *out[i] = common_get(&unit, i);
        else
            common_polynomial_normal(p, rays[i], at[i], out[i]);
}

void common_polynomial_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                                   pov_vec3 *const *out, uint32_t n)
{
    for (uint32_t some; n > 0; n -= some, selves += some, rays += some, at += some, out += some) {
        some = count_alike(selves, n);
        if (some >= LEAST)
            normals_of(selves[0], rays, at, out, some);
        else
            for (uint32_t i = 0; i < some; i++)
                common_polynomial_normal(selves[0], rays[i], at[i], out[i]);
    }
}
