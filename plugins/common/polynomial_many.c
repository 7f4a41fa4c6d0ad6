/* Rays and one surface of the third order side by side: by the operations of polynomial.c. Lanes that are not certain are left to it. */
#include "common/polynomial.h"

#include "common/bernstein.h"
#include "common/clip.h"
#include "common/dense.h"
#include "common/lanes.h"

#include <math.h>

/* HALVED: roundings of eight halvings. */
enum { N = COMMON_LANES, HALF = N / 2, ORDER = 3, LEAST = 3, HALVED = 32 };

/* ---- between two distances ---- */

/* By lane: the interval of a ray, and its stretch in local distances. */
typedef struct stretches { common_lane tmin, tmax, base, length, unit, sizes, known; } stretches;

COMMON_SEPARATE static void find_along(const common_polynomial *p, const common_rays *restrict l, stretches *restrict io, common_bernsteins *restrict out)
{
    static const pov_two3 zero = { { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 } };
    const double *const c = p->at;

    for (uint32_t i = 0; i < N; i++) {
        const pov_ray ray = common_get_ray(l, i);
        const common_ray k = common_enter(&ray, zero, 1.0);
        const double lo = io->tmin[i] * k.per_unit * (1.0 - 0x1p-40), hi = io->tmax[i] * k.per_unit * (1.0 + 0x1p-40), length = hi - lo;
        const double off = 0x1p-40 * (1.0 + fabs(lo)), least = io->tmin[i] * k.per_unit - lo + off, per_length = 1.0 / length;
        const pov_vec3 from = common_along(&k, lo);
        const double reach = common_polynomial_reach(&k, from, length);
        const double sizes = ((p->size[3] * reach + p->size[2]) * reach + p->size[1]) * reach + p->size[0];
        double a[ORDER + 1], one, two;

        common_dense_along(c, ORDER, from, pov_scale(k.d, length), a);
        one = a[1] / 3.0;
        two = a[2] / 3.0;
        out->b[0][i] = a[0];
        out->b[1][i] = one + a[0];
        out->b[2][i] = (two + one) + (one + a[0]);
        out->b[3][i] = ((a[3] + two) + (two + one)) + ((two + one) + (one + a[0]));
        out->noise[i] = (p->off + HALVED * COMMON_U) * sizes;
        out->beyond[i] = (least > 0.0 ? least : 0.0) * per_length;
        out->within[i] = -HUGE_VAL;
        io->base[i] = lo;
        io->length[i] = length;
        io->unit[i] = k.unit;
        io->sizes[i] = sizes;
        io->known[i] = hi < HUGE_VAL ? 1.0 : 0.0;
    }
}

static bool is_known(const stretches *s, const common_first_of_bernsteins *of, uint32_t i, const pov_ray *ray, const pov_hits *hits)
{
    return s->known[i] > 0.0 && !(of->open[i] > 0.0) && hits->want == POV_WANT_NEAREST && !hits->always_exact &&
           ray->origin_surface != hits->owner;
}

/* By lane, above 0 where the distance is good enough. */
COMMON_SEPARATE static void find_good(const common_polynomial *p, const common_rays *restrict l, const stretches *restrict s,
                                      const common_bernsteins *restrict all, const double *restrict x, double *restrict good)
{
    static const pov_two3 zero = { { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 } };
    const double *const c = p->at;

    for (uint32_t i = 0; i < N; i++) {
        const pov_ray ray = common_get_ray(l, i);
        const common_ray k = common_enter(&ray, zero, 1.0);
        const double v = 1.0 - x[i], square = x[i] * x[i], one = all->b[1][i] - all->b[0][i], two = all->b[2][i] - all->b[1][i];
        const double slope = 3.0 * ((one * v + 2.0 * x[i] * two) * v + square * (all->b[3][i] - all->b[2][i])) / s->length[i];
        const common_polynomial_root root = { s->base[i], x[i] * s->length[i], slope, s->sizes[i], s->length[i] };
        const pov_two at = pov_two_sum(root.base, root.t);
        const pov_vec3 point = common_polynomial_point(&k, at);
        const double reach = pov_largest(point) + common_far_slack(&k);
        const double sizes = ((p->size[3] * reach + p->size[2]) * reach + p->size[1]) * reach + p->size[0];

        good[i] = common_polynomial_trust(p, &root, common_dense_at(c, ORDER, point).value, sizes, common_polynomial_allowed(p, at.hi, reach));
    }
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
    find_along(p, &lanes, &s, &all);
    common_bernstein_certain_many(&all, &first);
    if (is_any(first.found))
        find_good(p, &lanes, &s, &all, first.root, good);
    for (uint32_t i = 0; i < n; i++)
        if (!is_known(&s, &first, i, rays[i], hits[i]) || (first.found[i] > 0.0 && !(good[i] > 0.0)))
            common_polynomial_intersect_between(p, rays[i], hits[i]);
        else if (first.found[i] > 0.0)
            report(&s, &first, i, hits[i]);
}

/* How many of n are one surface of that order, up to as many as there are lanes. */
static uint32_t count_alike(const void *const *selves, uint32_t n)
{
    const common_polynomial *p = selves[0];
    uint32_t some = 1;

    while (p->order == ORDER && some < N && some < n && selves[some] == selves[0])
        some++;
    return some;
}

void common_polynomial_intersect_between_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    for (uint32_t some; n > 0; n -= some, selves += some, rays += some, hits += some) {
        const common_polynomial *p = selves[0];

        some = count_alike(selves, n);
        if (some >= LEAST && !p->bounded)
            intersect_some(p, rays, hits, some);
        else
            for (uint32_t i = 0; i < some; i++)
                common_polynomial_intersect_between(p, rays[i], hits[i]);
    }
}

/* ---- normals ---- */

/* good: not zero where pov_unit() does not scale. */
COMMON_SEPARATE static void find_normals(const common_polynomial *p, const common_rays *restrict l, const double *restrict t,
                                         const double *restrict t_lo, common_lane3 *restrict out, double *restrict good)
{
    static const pov_two3 zero = { { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 } };
    const double *const c = p->at;

    for (uint32_t i = 0; i < N; i++) {
        const pov_ray ray = common_get_ray(l, i);
        const common_ray k = common_enter(&ray, zero, 1.0);
        const pov_two3 at = common_along_dd(&k, pov_two_of(t[i] * k.per_unit, t_lo[i] * k.per_unit));
        const common_sloped s = common_dense_at(c, ORDER, pov_two3_hi(at));
        const pov_vec3 w = pov_vec3_of(s.x, s.y, s.z);
        const double length = sqrt(pov_dot(w, w)), largest = pov_largest(w);

        good[i] = (int)(largest > 1e-100) & (int)(largest < 1e100) ? 1.0 : 0.0;
        common_put(out, i, pov_vec3_of(w.x / length, w.y / length, w.z / length));
    }
}

static void normals_of(const common_polynomial *p, const pov_ray *const *rays, const pov_crossing *const *at, pov_vec3 *const *out, uint32_t n)
{
    common_lane t, t_lo, good;
    common_lane3 unit;
    common_rays lanes;

    common_put_crossings_of(&lanes, t, t_lo, rays, at, n);
    find_normals(p, &lanes, t, t_lo, &unit, good);
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
