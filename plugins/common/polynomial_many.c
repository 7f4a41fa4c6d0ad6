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

/* Where it is looked for: between two distances, in the box, or ahead as search_ahead() has it. */
typedef enum where { BETWEEN, BOXED, AHEAD } where;

/* By lane: the interval of a ray, and its stretch in local distances. missed: above 0 where nothing of that is in the box. empty: where
 * nothing is beyond the stretch. */
typedef struct stretches { common_lane tmin, tmax, base, length, unit, sizes, known, missed, empty; } stretches;

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
COMMON_INLINE void find_bernstein(double *a, int order)
{
    double binomial = 1.0;

    COMMON_UNROLLED for (int k = 0; k <= order; k++) {
        a[k] = a[k] / binomial;
        binomial = binomial * (order - k) / (k + 1);
    }
    COMMON_UNROLLED for (int k = 1; k <= order; k++)
        COMMON_UNROLLED for (int j = order; j >= k; j--)
            a[j] += a[j - 1];
}

/* Above 0 where the signs of all coefficients are certain, and alike. */
COMMON_INLINE double is_one_side(const double *b, int order, double noise)
{
    double least = b[0], most = b[0];

    COMMON_UNROLLED for (int k = 1; k <= order; k++) {
        least = b[k] < least ? b[k] : least;
        most = b[k] > most ? b[k] : most;
    }
    return least > noise ? 1.0 : most < -noise ? 1.0 : 0.0;
}

/* beyond: of rays ahead, what lies there. */
COMMON_INLINE void find_along(const common_polynomial *p, int order, where in, bool leaves, const common_rays *l, uint32_t i, stretches *io,
                              common_bernsteins *out, common_bernsteins *beyond)
{
    static const pov_two3 zero = { { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 } };
    const pov_ray ray = common_get_ray(l, i);
    const common_ray k = common_enter(&ray, zero, 1.0);
    const common_span between = { io->tmin[i] * k.per_unit * (1.0 - 0x1p-40), io->tmax[i] * k.per_unit * (1.0 + 0x1p-40) };
    const common_span ahead_of = { 0.0, common_polynomial_ahead(&k) };
    const bool bounded = in == BOXED;
    const common_span span = bounded ? clip(&k, p->box.lo, p->box.hi) : in == AHEAD ? ahead_of : between;
    const double lo = leaves ? 0.0 : span.lo, hi = span.hi, length = hi - lo;
    const double ahead = span.lo * k.unit > io->tmax[i] ? 1.0 : hi < 0.0 ? 1.0 : 0.0, missed = bounded ? span.lo <= hi ? ahead : 1.0 : 0.0;
    const int degree = order - leaves;
    const double off = 0x1p-40 * (1.0 + fabs(lo)), least = io->tmin[i] * k.per_unit - lo + off, per_length = 1.0 / length;
    const pov_vec3 from = common_along(&k, lo);
    const double sizes = bounded ? p->sizes : size_at(p->size, order, common_polynomial_reach(&k, from, length));
    double noise = (p->off + HALVED * COMMON_U) * sizes, all[MOST + 1], far[MOST + 1], left = 1.0, *a = all + leaves;

    common_dense_along(p->at, order, from, pov_scale(k.d, length), all);
    if (leaves) {
        left = 8.0 * (fabs(all[0]) + noise) * sizes <= all[1] * all[1] ? 1.0 : 0.0;
        noise += 2.0 * fabs(all[0] / all[1]) * sizes;
    }
    if (in == AHEAD) {
        COMMON_UNROLLED for (int j = 0; j <= degree; j++)
            far[j] = a[degree - j];
        find_bernstein(far, degree);
        io->empty[i] = is_one_side(far, degree, noise);
        COMMON_UNROLLED for (int j = 0; j <= degree; j++)
            beyond->b[j][i] = far[j];
    }
    find_bernstein(a, degree);
    COMMON_UNROLLED for (int j = 0; j <= degree; j++)
        out->b[j][i] = missed > 0.0 ? 1.0 : a[j];
    out->noise[i] = missed > 0.0 ? 0.0 : noise;
    out->beyond[i] = (least > 0.0 ? least : 0.0) * per_length;
    out->within[i] = -HUGE_VAL;
    io->base[i] = lo;
    io->length[i] = length;
    io->unit[i] = k.unit;
    io->sizes[i] = sizes;
    io->known[i] = bounded ? lo < 0x1p40 * p->wide ? left > 0.0 ? 1.0 : missed : missed : hi < HUGE_VAL ? length > 0.0 ? left : 0.0 : 0.0;
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
COMMON_INLINE double is_root_good(const common_polynomial *p, int order, const common_ray *k, const common_polynomial_root *root)
{
    const pov_two at = pov_two_sum(root->base, root->t);
    const pov_vec3 point = common_polynomial_point(k, at);
    const double far = common_far_slack(k), reach = pov_largest(point) + far, sizes = size_at(p->size, order, reach);
    const double value = common_dense_at(p->at, order, point).value, step = common_polynomial_allowed(p, at.hi, reach);
    const pov_vec3 wide = pov_vec3_of(fabs(point.x) + far, fabs(point.y) + far, fabs(point.z) + far);
    const double first = common_polynomial_trust(p, root, value, sizes, step);
    const double second = common_polynomial_trust(p, root, value, common_dense_size(p->at, order, wide), step);

    return first > 0.0 ? first : second;
}

/* The distance, from the base, of a root. */
COMMON_INLINE double is_good(const common_polynomial *p, int order, bool leaves, const common_rays *l, uint32_t i, const stretches *s,
                             const common_bernsteins *all, double x, double *t)
{
    static const pov_two3 zero = { { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 } };
    const pov_ray ray = common_get_ray(l, i);
    const common_ray k = common_enter(&ray, zero, 1.0);
    const double length = s->length[i], at = x * length, slope = slope_at(all, order - leaves, i, x) / length;
    const common_polynomial_root root = { s->base[i], at, leaves ? slope * (at / length) : slope, s->sizes[i], length };

    *t = root.t;
    return is_root_good(p, order, &k, &root);
}

COMMON_INLINE double is_good_ahead(const common_polynomial *p, int order, const common_rays *l, uint32_t i, const stretches *s, double x,
                                   double *t)
{
    static const pov_two3 zero = { { 0.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 0.0 } };
    const pov_ray ray = common_get_ray(l, i);
    const common_ray k = common_enter(&ray, zero, 1.0);
    const double from = x * s->length[i];
    const pov_vec3 point = common_along(&k, from);
    const double reach = pov_largest(point) + common_far_slack(&k);
    const common_sloped here = common_dense_at(p->at, order, point);
    const common_polynomial_root next = common_polynomial_step(from, here.value, pov_dot(pov_vec3_of(here.x, here.y, here.z), k.d),
                                                               size_at(p->size, order, reach), reach);

    *t = next.t;
    return is_root_good(p, order, &k, &next);
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

/* Functions an order, whose loops are unrolled. leaves: rays start on the surface, and that root is divided out. */
#define FIND_ALONG(name, n, in, leaves)                                                                                                    \
    COMMON_SEPARATE static void name(const common_polynomial *p, const common_rays *restrict l, stretches *restrict io,                    \
                                     common_bernsteins *restrict out, common_bernsteins *restrict beyond)                                  \
    {                                                                                                                                      \
        for (uint32_t i = 0; i < N; i++)                                                                                                   \
            find_along(p, n, in, leaves, l, i, io, out, beyond);                                                                           \
    }

#define FIND_GOOD(name, n, leaves)                                                                                                         \
    COMMON_SEPARATE static void name(const common_polynomial *p, const common_rays *restrict l, const stretches *restrict s,               \
                                     const common_bernsteins *restrict all, const double *restrict x, double *restrict t,                  \
                                     double *restrict good)                                                                                \
    {                                                                                                                                      \
        for (uint32_t i = 0; i < N; i++)                                                                                                   \
            good[i] = is_good(p, n, leaves, l, i, s, all, x[i], &t[i]);                                                                    \
    }

#define OF_ORDER(n)                                                                                                                        \
    COMMON_SEPARATE static void find_good_ahead_##n(const common_polynomial *p, const common_rays *restrict l,                             \
                                                    const stretches *restrict s, const double *restrict x, double *restrict t,             \
                                                    double *restrict good)                                                                 \
    {                                                                                                                                      \
        for (uint32_t i = 0; i < N; i++)                                                                                                   \
            good[i] = is_good_ahead(p, n, l, i, s, x[i], &t[i]);                                                                           \
    }                                                                                                                                      \
    COMMON_SEPARATE static void find_normals_##n(const common_polynomial *p, const common_rays *restrict l, const double *restrict t,      \
                                                 const double *restrict t_lo, common_lane3 *restrict out, double *restrict good)           \
    {                                                                                                                                      \
        for (uint32_t i = 0; i < N; i++)                                                                                                   \
            good[i] = find_normal(p, n, l, i, t[i], t_lo[i], out);                                                                         \
    }                                                                                                                                      \
    FIND_ALONG(find_between_##n, n, BETWEEN, false)                                                                                        \
    FIND_ALONG(find_boxed_##n, n, BOXED, false)                                                                                            \
    FIND_ALONG(find_ahead_##n, n, AHEAD, false)                                                                                            \
    FIND_GOOD(find_good_##n, n, false)

OF_ORDER(3)
OF_ORDER(4)
FIND_ALONG(leave_between_4, 4, BETWEEN, true)
FIND_ALONG(leave_boxed_4, 4, BOXED, true)
FIND_ALONG(leave_ahead_4, 4, AHEAD, true)
FIND_GOOD(leave_good_4, 4, true)

/* ---- crossings ---- */

/* What is asked of n rays, which all start on the surface or beside it. */
typedef struct asked { const common_polynomial *p; where in; bool leaves; const pov_ray *rays[N]; pov_hits *hits[N]; uint32_t n; } asked;

static bool is_known(const stretches *s, const common_first_of_bernsteins *of, uint32_t i, const pov_hits *hits)
{
    return s->known[i] > 0.0 && !(of->open[i] > 0.0) && hits->want != POV_WANT_ALL && !hits->always_exact;
}

static bool is_any(const double *flags)
{
    bool any = false;

    for (uint32_t i = 0; i < N; i++)
        any |= flags[i] > 0.0;
    return any;
}

static void report(const stretches *s, double t, uint32_t i, pov_hits *hits)
{
    const pov_two at = pov_two_sum(s->base[i], t);
    const pov_mark mark = { 0, 0, 0.0, 0.0 };

    pov_cross(hits, at.hi * s->unit[i], at.lo * s->unit[i], mark);
}

/* Only any crossing is wanted, and this one certainly is in the interval? */
static bool is_enough(const stretches *s, uint32_t i, double x, const pov_hits *hits)
{
    const double at = (s->base[i] + x * s->length[i]) * s->unit[i], off = 0x1p-40 * (fabs(at) + fabs(s->base[i]) * s->unit[i]);

    return hits->want == POV_WANT_ANY && at - off > hits->tmin && at + off + hits->slack < hits->tmax;
}

static void find_stretches(const asked *k, const common_rays *l, stretches *io, common_bernsteins *out, common_bernsteins *beyond)
{
    if (k->leaves)
        (k->in == BOXED ? leave_boxed_4 : k->in == AHEAD ? leave_ahead_4 : leave_between_4)(k->p, l, io, out, beyond);
    else if (k->p->order == 3)
        (k->in == BOXED ? find_boxed_3 : k->in == AHEAD ? find_ahead_3 : find_between_3)(k->p, l, io, out, beyond);
    else
        (k->in == BOXED ? find_boxed_4 : k->in == AHEAD ? find_ahead_4 : find_between_4)(k->p, l, io, out, beyond);
}

static void find_good(const asked *k, const common_rays *l, const stretches *s, const common_bernsteins *all, const double *x, double *t,
                      double *good)
{
    if (k->in == AHEAD)
        (k->p->order == 3 ? find_good_ahead_3 : find_good_ahead_4)(k->p, l, s, x, t, good);
    else if (k->leaves)
        leave_good_4(k->p, l, s, all, x, t, good);
    else
        (k->p->order == 3 ? find_good_3 : find_good_4)(k->p, l, s, all, x, t, good);
}

/* What is not decided here. */
static void intersect_one(const asked *k, uint32_t i)
{
    (k->in == BETWEEN ? common_polynomial_intersect_between : common_polynomial_intersect_single)(k->p, k->rays[i], k->hits[i]);
}

/* Is there nothing beyond the stretch, or nothing that counts? */
static bool is_all(const stretches *s, where in, uint32_t i, const pov_hits *hits)
{
    return in != AHEAD || s->empty[i] > 0.0 || s->length[i] * s->unit[i] * (1.0 - 0x1p-40) > hits->tmax + hits->slack;
}

/* Where nothing is on the stretch of a ray ahead: is there certainly nothing beyond it? */
static void look_beyond(const asked *k, const common_first_of_bernsteins *first, const common_bernsteins *all, common_bernsteins *beyond,
                        stretches *io)
{
    const int degree = k->p->order - k->leaves;
    common_first_of_bernsteins found;
    common_lane asks;

    for (uint32_t i = 0; i < N; i++) {
        asks[i] = first->found[i] + first->open[i] > 0.0 || i >= k->n || is_all(io, k->in, i, k->hits[i]) ? 0.0 : 1.0;
        for (int j = 0; j <= degree && !(asks[i] > 0.0); j++)
            beyond->b[j][i] = 1.0;
        beyond->noise[i] = asks[i] > 0.0 ? all->noise[i] : 0.0;
        beyond->beyond[i] = -HUGE_VAL;
        beyond->within[i] = HUGE_VAL;
    }
    if (!is_any(asks))
        return;
    common_bernstein_certain_many(beyond, degree, &found);
    for (uint32_t i = 0; i < N; i++)
        io->empty[i] = asks[i] > 0.0 && !(found.found[i] + found.open[i] > 0.0) ? 1.0 : io->empty[i];
}

static void intersect_some(const asked *k)
{
    common_first_of_bernsteins first;
    common_bernsteins all, beyond;
    common_rays lanes;
    common_lane good, t;
    stretches s;

    common_put_four_of(&lanes, 0, k->rays, k->n);
    common_put_four_of(&lanes, HALF, k->rays, k->n);
    for (uint32_t i = 0; i < N; i++) {
        const pov_hits *h = k->hits[common_lane_of(i, k->n)];

        s.tmin[i] = h->tmin;
        s.tmax[i] = h->tmax;
    }
    find_stretches(k, &lanes, &s, &all, &beyond);
    common_bernstein_certain_many(&all, k->p->order - k->leaves, &first);
    if (k->in == AHEAD)
        look_beyond(k, &first, &all, &beyond, &s);
    if (is_any(first.found))
        find_good(k, &lanes, &s, &all, first.root, t, good);
    for (uint32_t i = 0; i < k->n; i++) {
        const bool found = first.found[i] > 0.0;
        pov_hits *hits = k->hits[i];

        if (s.missed[i] > 0.0 && !hits->always_exact)
            continue;
        if (!is_known(&s, &first, i, hits) || (found && !(good[i] > 0.0) && !is_enough(&s, i, first.root[i], hits)))
            intersect_one(k, i);
        else if (found)
            report(&s, good[i] > 0.0 ? t[i] : first.root[i] * s.length[i], i, hits);
        else if (!is_all(&s, k->in, i, hits))
            intersect_one(k, i);
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

static void intersect_asked(const asked *k)
{
    const uint32_t least = k->in == AHEAD ? 1 : LEAST;
    const int order = k->p->order;

    if (k->n >= least && (k->leaves ? order == 4 : order == 3 || order == 4))
        intersect_some(k);
    else
        for (uint32_t i = 0; i < k->n; i++)
            intersect_one(k, i);
}

/* Between the two distances of each, or all of it. */
static void intersect_alike(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n, bool between)
{
    for (uint32_t some; n > 0; n -= some, selves += some, rays += some, hits += some) {
        const common_polynomial *p = selves[0];
        asked k[2];

        some = count_alike(selves, n);
        for (int leaves = 0; leaves < 2; leaves++) {
            k[leaves].p = p;
            k[leaves].in = p->bounded ? BOXED : between ? BETWEEN : AHEAD;
            k[leaves].leaves = leaves;
            k[leaves].n = 0;
        }
        for (uint32_t i = 0; i < some; i++) {
            asked *to = &k[rays[i]->origin_surface == hits[i]->owner];

            to->rays[to->n] = rays[i];
            to->hits[to->n++] = hits[i];
        }
        intersect_asked(&k[0]);
        intersect_asked(&k[1]);
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
