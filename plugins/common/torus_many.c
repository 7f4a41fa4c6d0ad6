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

/* The first crossing of each lane: its bracket, 1 or -1 for rising or falling, where it is about, and its distance if a
 * single step finds it. */
typedef struct firsts { four lo, hi, rise, x, t, t_lo, good; } firsts;

/* The first step of common_torus_complete(). */
COMMON_CLONES static void step_all(const pair_lanes *restrict l, const stretches *restrict from, firsts *restrict io)
{
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const torus t = get_torus(l, i);
        stretch s = get_steps(from, i);
        const pov_two x = { io->x[i], 0.0 };
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
        io->good[i] = last & (int)(slope * io->rise[i] > 0.0) & (int)(x.hi + step >= io->lo[i]) & (int)(x.hi + step <= io->hi[i]) ? 1.0 : 0.0;
    }
}

/* Puts the first root of a search into its lane. False: there is nothing to be done. */
static bool put_first(const search *r, uint32_t i, firsts *out, pov_hits *hits)
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

static void end_first(const search *r, uint32_t i, const firsts *at, pov_hits *hits)
{
    const common_bracket x = { at->lo[i], at->hi[i], 0.0, r->roots.at[0].rising };
    const pov_two t = at->good[i] > 0.0 ? pov_two_of(at->t[i], at->t_lo[i])
                                        : distance_at(&r->s, common_torus_complete(&r->s, at->x[i], &x));

    if (common_torus_report(&r->s, t, x.rising, r->escalated, hits))
        common_torus_finish(r, 1, hits);
}

static void load(pair_lanes *out, const void *const *selves, const pov_ray *const *rays, uint32_t n)
{
    const void *const shapes[TOGETHER] = { selves[0], selves[common_lane_of(1, n)], selves[common_lane_of(2, n)],
                                           selves[common_lane_of(3, n)] };

    common_put_four_shapes(out->number, TOGETHER, NUMBERS, shapes);
    common_put_four_of(&out->rays, 0, rays, n);
}

static void intersect_four(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    static const firsts none;
    search found[TOGETHER];
    bool open[TOGETHER] = { false };
    pair_lanes lanes;
    stretches all;
    firsts first = none;
    bool any = false;

    load(&lanes, selves, rays, n);
    find_stretches(&lanes, &all);
    for (uint32_t i = 0; i < n; i++) {
        if (!(all.reaches[i] > 0.0))
            continue;
        get_search(&all, i, selves[i], &found[i]);
        common_torus_begin(&found[i], rays[i]->origin_surface == hits[i]->owner, hits[i]);
        open[i] = put_first(&found[i], i, &first, hits[i]);
        any = any || open[i];
    }
    if (any)
        step_all(&lanes, &all, &first);
    for (uint32_t i = 0; i < n; i++)
        if (open[i])
            end_first(&found[i], i, &first, hits[i]);
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
