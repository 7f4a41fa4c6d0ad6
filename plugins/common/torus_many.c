/* Several pairs of a torus and a ray side by side: their stretches and quartics, the step to the first crossing of each, and
 * normals. */
#include "common/torus.h"

enum { TOGETHER = 4, NUMBERS = 8 };
typedef double four[TOGETHER];

typedef struct pair_lanes { common_rays rays; double number[NUMBERS * TOGETHER]; } pair_lanes;

/* By lane: a stretch, its quartic, and whether there is one. */
typedef struct stretches {
    four f[6], d[3], d_lo[3], unit, per_unit, middle, half, w[6], lost, bend, a[5], error, reaches;
} stretches;

static inline torus get_torus(const pair_lanes *l, uint32_t i)
{
    torus t;

    t.R = l->number[i];
    t.r = l->number[1 * TOGETHER + i];
    t.scale = l->number[2 * TOGETHER + i];
    t.ring = pov_two_of(l->number[3 * TOGETHER + i], l->number[4 * TOGETHER + i]);
    t.hollow = pov_two_of(l->number[5 * TOGETHER + i], l->number[6 * TOGETHER + i]);
    return t;
}

COMMON_INLINE void put_two3(four *to, uint32_t i, pov_two3 p)
{
    to[0][i] = p.x.hi;
    to[1][i] = p.x.lo;
    to[2][i] = p.y.hi;
    to[3][i] = p.y.lo;
    to[4][i] = p.z.hi;
    to[5][i] = p.z.lo;
}

COMMON_INLINE pov_two3 get_two3(const four *from, uint32_t i)
{
    const pov_vec3 hi = { from[0][i], from[2][i], from[4][i] }, lo = { from[1][i], from[3][i], from[5][i] };

    return pov_two3_of(hi, lo);
}

COMMON_INLINE void put_vec3(four *to, uint32_t i, pov_vec3 p)
{
    to[0][i] = p.x;
    to[1][i] = p.y;
    to[2][i] = p.z;
}

COMMON_INLINE pov_vec3 get_vec3(const four *from, uint32_t i) { return pov_vec3_of(from[0][i], from[1][i], from[2][i]); }

COMMON_CLONES static void find_stretches(const pair_lanes *restrict l, stretches *restrict out)
{
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const pov_ray ray = common_get_ray(&l->rays, i);
        const torus t = get_torus(l, i);
        double a[5], error;
        stretch s;

        out->reaches[i] = enter(&s, &t, &ray) ? 1.0 : 0.0;
        error = coefficients(&s, a);
        out->error[i] = error;
        put_two3(out->f, i, s.ray.f);
        put_vec3(out->d, i, s.ray.d);
        put_vec3(out->d_lo, i, s.ray.d_lo);
        out->unit[i] = s.ray.unit;
        out->per_unit[i] = s.ray.per_unit;
        out->middle[i] = s.middle;
        out->half[i] = s.half;
        put_two3(out->w, i, s.w);
        out->lost[i] = s.lost;
        out->bend[i] = s.bend;
        out->a[0][i] = a[0];
        out->a[1][i] = a[1];
        out->a[2][i] = a[2];
        out->a[3][i] = a[3];
        out->a[4][i] = a[4];
    }
}

/* Of a lane: what steps need. */
COMMON_INLINE stretch get_steps(const stretches *l, uint32_t i)
{
    stretch s;

    s.ray.f = get_two3(l->f, i);
    s.ray.d = get_vec3(l->d, i);
    s.ray.d_lo = get_vec3(l->d_lo, i);
    s.ray.unit = l->unit[i];
    s.ray.per_unit = l->per_unit[i];
    s.middle = l->middle[i];
    s.half = l->half[i];
    s.bend = l->bend[i];
    return s;
}

static void get_search(const stretches *l, uint32_t i, const torus *t, search *out)
{
    out->s = get_steps(l, i);
    out->s.torus = t;
    out->s.w = get_two3(l->w, i);
    out->s.lost = l->lost[i];
    for (int k = 0; k < 5; k++)
        out->a[k] = l->a[k][i];
    out->error = l->error[i];
}

/* The first crossing of each lane: its root, and its distance if a single step finds it. */
typedef struct firsts { common_first_roots root; four t, t_lo, good; } firsts;

/* The first step of common_torus_complete(). */
COMMON_CLONES static void step_all(const pair_lanes *restrict l, const stretches *restrict from, firsts *restrict io)
{
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const torus t = get_torus(l, i);
        stretch s = get_steps(from, i);
        const pov_two x = { io->root.x[i], 0.0 };
        const pov_two3 p = common_along_dd(&s.ray, distance_at(&s, x));
        const double value = value_at(&t, p).hi;
        double slope, step;
        pov_two at;
        int last;

        s.torus = &t;
        slope = slope_at(&s, p);
        step = step_at(&s, slope, value, &last);
        at = distance_at(&s, pov_two_add_double(x, step));
        io->t[i] = at.hi;
        io->t_lo[i] = at.lo;
        io->good[i] = last & (int)(slope * io->root.rise[i] > 0.0) & (int)(x.hi + step >= io->root.lo[i]) &
                              (int)(x.hi + step <= io->root.hi[i]) ? 1.0 : 0.0;
    }
}

/* ---- roots ---- */

/* Where each ray ends, and 1 where one root is enough, and the ray does not start on the torus. */
typedef struct wishes { four tmin, tmax, first; } wishes;

static void find_wishes(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n, wishes *out)
{
    for (uint32_t i = 0; i < TOGETHER; i++) {
        const uint32_t k = common_lane_of(i, n);

        out->tmin[i] = hits[k]->tmin;
        out->tmax[i] = hits[k]->tmax + hits[k]->slack;
        out->first[i] = common_torus_wants_first(selves[k], hits[k]) && rays[k]->origin_surface != hits[k]->owner ? 1.0 : 0.0;
    }
}

COMMON_CLONES static void find_ranges(const stretches *restrict l, const wishes *restrict w, common_quartics *restrict q)
{
    for (uint32_t i = 0; i < TOGETHER; i++) {
        stretch s;
        common_range range;

        s.middle = l->middle[i];
        s.half = l->half[i];
        s.ray.per_unit = l->per_unit[i];
        range = range_of(&s, w->tmin[i], w->tmax[i]);
        q->from[i] = range.from;
        q->ahead[i] = range.ahead;
        q->to[i] = range.to;
    }
}

static common_bracket bracket_of(const common_first_roots *r, uint32_t i)
{
    const common_bracket b = { r->lo[i], r->hi[i], 0.0, r->rise[i] > 0.0 };

    return b;
}

/* Of common_torus_is_blocked(), for a root that is known. */
static bool is_blocked(const stretches *l, uint32_t i, const common_first_roots *root, pov_hits *hits)
{
    static const common_range first = { -HUGE_VAL, -HUGE_VAL, HUGE_VAL, true };
    const common_bracket b = bracket_of(root, i);
    stretch s;

    s.middle = l->middle[i];
    s.half = l->half[i];
    s.ray.unit = l->unit[i];
    return hits->want == POV_WANT_ANY && common_torus_is_blocked(&s, &b, first, hits);
}

/* The first roots of those lanes that want no more. Others are left open. */
static void find_roots(const stretches *l, const wishes *w, pov_hits *const *hits, uint32_t n, common_first_roots *out)
{
    common_quartics q;
    bool any = false;

    memcpy(q.a, l->a, sizeof q.a);
    memcpy(q.error, l->error, sizeof q.error);
    find_ranges(l, w, &q);
    common_isolate_four(&q, out);
    for (uint32_t i = 0; i < TOGETHER; i++) {
        const bool counts = i < n && l->reaches[i] > 0.0 && w->first[i] > 0.0;

        out->open[i] = counts ? out->open[i] : 1.0;
        out->found[i] = counts && out->found[i] > 0.0 && !is_blocked(l, i, out, hits[i]) ? 1.0 : 0.0;
        any = any || out->found[i] > 0.0;
    }
    if (any)
        common_polish_four(&q, out);
}

/* Puts the first root of a search into its lane. False: there is nothing to be done. */
static bool put_first(const search *r, uint32_t i, common_first_roots *out, pov_hits *hits)
{
    common_bracket x;

    if (r->roots.count == 0)
        return false;
    x = common_torus_bracket(r, 0);
    if (common_torus_is_blocked(&r->s, &x, r->wanted, hits))
        return false;
    out->x[i] = common_torus_start(r, 0);
    out->lo[i] = x.lo;
    out->hi[i] = x.hi;
    out->rise[i] = x.rising ? 1.0 : -1.0;
    return true;
}

/* True: more crossings are wanted. */
static bool end_first(const stretch *s, uint32_t i, const firsts *at, bool escalated, pov_hits *hits)
{
    const common_bracket x = bracket_of(&at->root, i);
    const pov_two t = at->good[i] > 0.0 ? pov_two_of(at->t[i], at->t_lo[i])
                                        : distance_at(s, common_torus_complete(s, at->root.x[i], &x));

    return common_torus_report(s, t, x.rising, escalated, hits);
}

static void load(pair_lanes *out, const void *const *selves, const pov_ray *const *rays, uint32_t n)
{
    const void *const shapes[TOGETHER] = { selves[0], selves[common_lane_of(1, n)], selves[common_lane_of(2, n)],
                                           selves[common_lane_of(3, n)] };

    common_put_four_shapes(out->number, TOGETHER, NUMBERS, shapes);
    common_put_four_of(&out->rays, 0, rays, n);
}

/* Lanes that are open are searched one by one. Returns those of them that have a root. */
static uint32_t search_open(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n,
                            const stretches *all, common_first_roots *io, search *found)
{
    uint32_t searched = 0;

    for (uint32_t i = 0; i < n; i++) {
        if (!(all->reaches[i] > 0.0 && io->open[i] > 0.0))
            continue;
        get_search(all, i, selves[i], &found[i]);
        common_torus_begin(&found[i], rays[i]->origin_surface == hits[i]->owner, hits[i]);
        searched |= put_first(&found[i], i, io, hits[i]) ? 1u << i : 0;
    }
    return searched;
}

static void intersect_four(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    search found[TOGETHER];
    uint32_t searched, direct = 0;
    pair_lanes lanes;
    stretches all;
    wishes wants;
    firsts first;

    load(&lanes, selves, rays, n);
    find_stretches(&lanes, &all);
    find_wishes(selves, rays, hits, n, &wants);
    find_roots(&all, &wants, hits, n, &first.root);
    searched = search_open(selves, rays, hits, n, &all, &first.root, found);
    for (uint32_t i = 0; i < n; i++)
        direct |= first.root.found[i] > 0.0 ? 1u << i : 0;
    if (searched | direct)
        step_all(&lanes, &all, &first);
    for (uint32_t i = 0; i < n; i++)
        if (direct >> i & 1) {
            stretch s = get_steps(&all, i);

            s.torus = selves[i];
            end_first(&s, i, &first, false, hits[i]);
        } else if ((searched >> i & 1) && end_first(&found[i].s, i, &first, found[i].escalated, hits[i])) {
            common_torus_finish(&found[i], 1, hits[i]);
        }
}

void common_torus_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    for (uint32_t i; n > 1; n -= i, selves += i, rays += i, hits += i) {
        i = n < TOGETHER ? n : TOGETHER;
        intersect_four(selves, rays, hits, i);
    }
    if (n > 0)
        common_torus_intersect(selves[0], rays[0], hits[0]);
}

/* ---- normals ---- */

/* good: not zero where pov_unit() does not scale. */
COMMON_CLONES static void find_normals(const pair_lanes *restrict l, const double *restrict at, const double *restrict at_lo,
                                       common_lane3 *restrict out, double *restrict good)
{
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const pov_ray ray = common_get_ray(&l->rays, i);
        const torus t = get_torus(l, i);
        const pov_vec3 w = normal_at(&t, &ray, at[i], at_lo[i]);
        const double length = sqrt(pov_dot(w, w)), largest = pov_largest(w);

        good[i] = (int)(largest > 1e-100) & (int)(largest < 1e100) ? 1.0 : 0.0;
        common_put(out, i, pov_vec3_of(w.x / length, w.y / length, w.z / length));
    }
}

void common_torus_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                        pov_vec3 *const *out, uint32_t n)
{
    for (uint32_t some; n > 0; n -= some, selves += some, rays += some, at += some, out += some) {
        const pov_crossing *const crossings[TOGETHER] = { at[0], at[common_lane_of(1, n)], at[common_lane_of(2, n)],
                                                          at[common_lane_of(3, n)] };
        common_lane t, t_lo, good;
        common_lane3 unit;
        pair_lanes lanes;

        some = n < TOGETHER ? n : TOGETHER;
        load(&lanes, selves, rays, some);
        common_put_four_crossings(t, t_lo, 0, crossings);
        find_normals(&lanes, t, t_lo, &unit, good);
        for (uint32_t i = 0; i < some; i++)
            if (good[i] > 0.0)
                *out[i] = common_get(&unit, i);
            else
                common_torus_normal(selves[i], rays[i], at[i], out[i]);
    }
}
