/* Pairs of a sphere and a ray, side by side. */
#include "kit/ball.h"
#include "kit/lanes.h"

/* Pairs of a sphere and a ray, with a crossing each for the normal. */
typedef struct ball_lanes {
    kit_rays rays;
    kit_lane3 centre, centre_lo;
    kit_lane radius, radius_lo, t, t_lo;
    kit_lane tmin;               /* a ray that enters before that starts inside */
} ball_lanes;

#ifndef KIT_TRANSPOSES
static inline void put_ball(ball_lanes *l, uint32_t i, const kit_ball *s)
{
    kit_put(&l->centre, i, pov_two3_hi(s->centre));
    kit_put(&l->centre_lo, i, pov_two3_lo(s->centre));
    l->radius[i] = s->radius.hi;
    l->radius_lo[i] = s->radius.lo;
}
#endif

/* Load pairs into four lanes from i on. */
KIT_INLINE void put_four(ball_lanes *l, uint32_t i, const void *const *selves, const pov_ray *const *rays, uint32_t n)
{
    const void *balls[4];
    uint32_t j;

    for (j = 0; j < 4; j++)
        balls[j] = selves[kit_lane_of(i + j, n)];
    kit_put_four_of(&l->rays, i, rays, n);
#ifdef KIT_TRANSPOSES
    kit_four v[4];

    kit_transpose(balls, 0, v);
    kit_store_four(l->centre.x, i, v[0]);
    kit_store_four(l->centre_lo.x, i, v[1]);
    kit_store_four(l->centre.y, i, v[2]);
    kit_store_four(l->centre_lo.y, i, v[3]);
    kit_transpose(balls, 4 * sizeof(double), v);
    kit_store_four(l->centre.z, i, v[0]);
    kit_store_four(l->centre_lo.z, i, v[1]);
    kit_store_four(l->radius, i, v[2]);
    kit_store_four(l->radius_lo, i, v[3]);
#else
    for (j = 0; j < 4; j++)
        put_ball(l, i + j, balls[j]);
#endif
}

static inline kit_ball get_ball(const ball_lanes *l, uint32_t i)
{
    kit_ball s;

    s.centre = pov_two3_of(kit_get(&l->centre, i), kit_get(&l->centre_lo, i));
    s.radius = pov_two_of(l->radius[i], l->radius_lo[i]);
    return s;
}

/* Entry of each ray, or its exit if it starts inside: that end of the chord in the shape's units, its error bound, and
 * half the chord; then bounds on the distance, and the distance. */
typedef struct end_lanes {
    kit_lane root, root_lo, error, apart;
    kit_lane lo, hi, t, t_lo;
    int64_t part[KIT_LANES];
    int64_t good[KIT_LANES];     /* is it accurate enough? */
} end_lanes;

static inline void put_end(end_lanes *restrict out, uint32_t i, const kit_root *r, double unit, int good)
{
    const double slack = kit_slack(r);

    out->lo[i] = (r->t.hi - slack) * unit;
    out->hi[i] = (r->t.hi + slack) * unit;
    out->t[i] = r->t.hi * unit;
    out->t_lo[i] = r->t.lo * unit;
    out->good[i] = good & (int)kit_is_fine(r, KIT_FINE * KIT_SLOWEST);
}

KIT_CLONES static void find_ends(const ball_lanes *restrict l, end_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < KIT_LANES; i++) {
        const kit_ball s = get_ball(l, i);
        const pov_ray ray = kit_get_ray(&l->rays, i);
        const kit_ray k = kit_enter(&ray, s.centre, kit_ball_scale(&s));
        const kit_chord h = kit_find_chord(kit_ball_square(&s), &k);
        const kit_root near = kit_near_end(&h), far = kit_far_end(&h);
        const int within = (near.t.hi + kit_slack(&near)) * k.unit < l->tmin[i];
        const kit_root r = { { within ? far.t.hi : near.t.hi, within ? far.t.lo : near.t.lo }, h.error, 0, 0 };
        const int sound = (int)kit_ball_is_near(&k) & (int)kit_is_cut(&h);

        out->root[i] = r.t.hi;
        out->root_lo[i] = r.t.lo;
        out->error[i] = sound ? r.error : NAN;
        out->apart[i] = h.root * h.inverse;
        out->part[i] = within;
        put_end(out, i, &r, k.unit, sound);
    }
}

/* The refinement step of kit_report(), where double was not accurate enough. */
KIT_CLONES static void refine_ends(const ball_lanes *restrict l, end_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < KIT_LANES; i++) {
        const kit_ball s = get_ball(l, i);
        const pov_ray ray = kit_get_ray(&l->rays, i);
        const kit_ray k = kit_enter(&ray, s.centre, kit_ball_scale(&s));
        const double error = out->error[i], apart = out->apart[i];
        kit_root r = { { out->root[i], out->root_lo[i] }, 0.0, 0, 0 };
        const kit_residual f = kit_ball_residual(kit_ball_square(&s), &k, kit_along_two_parts(&k, r.t));
        const double step = kit_root_step(&f);
        const int good = (int)(error <= KIT_APART * apart) & (int)(fabs(step) <= 2.0 * error)
                         & (int)(fabs(r.t.hi) > error);

        r.error = kit_root_step_error(&f, step, apart);
        r.t = pov_two_add_double(r.t, step);
        put_end(out, i, &r, k.unit, good);
    }
}

/* Report rays that do not leave the sphere, or go into it, and whose end of the chord is definitely within the
 * interval. */
static inline bool is_answered(const end_lanes *e, uint32_t i, const pov_ray *ray, const pov_hits *h)
{
    return e->lo[i] <= h->tmax && e->hi[i] >= h->tmin && e->t[i] > h->tmin && h->want != POV_WANT_ALL
           && !h->always_exact && (h->owner != ray->left || kit_is_inward(ray, h));
}

/* Report these lanes; returns the lanes that are still to be intersected. */
static uint32_t report_ends(const end_lanes *e, uint32_t lanes, const pov_ray *const *rays, pov_hits *const *hits)
{
    uint32_t left = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = kit_first_lane(lanes);

        if (e->good[i] && is_answered(e, i, rays[i], hits[i]))
            pov_cross(hits[i], e->t[i], e->t_lo[i], kit_mark((uint32_t)e->part[i], POV_MARK_CLOSED));
        else
            left |= 1u << i;
    }
    return left;
}

/* Lanes that a refinement step would settle: a search for any crossing needs none. */
static uint32_t worth_a_step(const end_lanes *e, uint32_t lanes, const pov_ray *const *rays, pov_hits *const *hits)
{
    uint32_t worth = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = kit_first_lane(lanes);

        if (!e->good[i] && hits[i]->want != POV_WANT_ANY && is_answered(e, i, rays[i], hits[i]))
            worth |= 1u << i;
    }
    return worth;
}

static void intersect_lanes(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    ball_lanes lanes;
    end_lanes end;
    uint32_t i, left, worth;

    for (i = 0; i < KIT_LANES; i += 4)
        put_four(&lanes, i, selves, rays, n);
    for (i = 0; i < KIT_LANES; i++) {
        const uint32_t j = kit_lane_of(i, n);

        lanes.tmin[i] = kit_is_inward(rays[j], hits[j]) ? HUGE_VAL : hits[j]->tmin;
    }
    find_ends(&lanes, &end);
    left = report_ends(&end, (1u << n) - 1, rays, hits);
    worth = worth_a_step(&end, left, rays, hits);
    if (worth) {
        refine_ends(&lanes, &end);
        left = (left & ~worth) | report_ends(&end, worth, rays, hits);
    }
    for (; left; left &= left - 1) {
        i = kit_first_lane(left);
        kit_ball_intersect(selves[i], rays[i], hits[i]);
    }
}

void kit_ball_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    kit_intersect_pairs(selves, rays, hits, n, intersect_lanes, kit_ball_intersect);
}

/* Normals, and their lengths before normalisation: pov_unit() scales the very large and the very small. */
KIT_CLONES static void find_normals(const ball_lanes *restrict l, kit_lane3 *restrict out, double *restrict largest)
{
    uint32_t i;

    for (i = 0; i < KIT_LANES; i++) {
        kit_ball s = get_ball(l, i);
        pov_ray ray = kit_get_ray(&l->rays, i);
        pov_crossing at;
        pov_vec3 w;
        double length;

        at.t = l->t[i];
        at.t_lo = l->t_lo[i];
        w = kit_ball_offset(&s, &ray, &at);
        length = sqrt(pov_dot(w, w));
        largest[i] = pov_largest(w);
        kit_put(out, i, pov_vec3_of(w.x / length, w.y / length, w.z / length));
    }
}

static void normals_of(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                       pov_vec3 *const *out, uint32_t n)
{
    const pov_crossing *some[KIT_LANES];
    ball_lanes lanes;
    kit_lane3 unit;
    kit_lane largest;
    uint32_t i;

    for (i = 0; i < KIT_LANES; i++)
        some[i] = at[kit_lane_of(i, n)];
    for (i = 0; i < KIT_LANES; i += 4) {
        put_four(&lanes, i, selves, rays, n);
        kit_put_four_crossings(lanes.t, lanes.t_lo, i, some + i);
    }
    find_normals(&lanes, &unit, largest);
    for (i = 0; i < n; i++)
        if (largest[i] > 1e-100 && largest[i] < 1e100)
            *out[i] = kit_get(&unit, i);
        else
            kit_ball_normal(selves[i], rays[i], at[i], out[i]);
}

void kit_ball_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                        pov_vec3 *const *out, uint32_t n)
{
    uint32_t i;

    for (; n >= KIT_LEAST; n -= i, selves += i, rays += i, at += i, out += i) {
        i = n < KIT_LANES ? n : KIT_LANES;
        normals_of(selves, rays, at, out, i);
    }
    for (i = 0; i < n; i++)
        kit_ball_normal(selves[i], rays[i], at[i], out[i]);
}
