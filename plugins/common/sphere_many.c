/* Pairs of a sphere and a ray, side by side. */
#include "common/sphere.h"
#include "common/lanes.h"

/* Pairs of a sphere and a ray, with a crossing each for the normal. */
typedef struct sphere_lanes {
    common_rays rays;
    common_lane3 centre, centre_lo;
    common_lane radius, radius_lo, t, t_lo;
    common_lane tmin;            /* a ray that enters before that starts inside */
} sphere_lanes;

#ifndef COMMON_TRANSPOSES
static inline void put_sphere(sphere_lanes *l, uint32_t i, const common_sphere *s)
{
    common_put(&l->centre, i, pov_two3_hi(s->centre));
    common_put(&l->centre_lo, i, pov_two3_lo(s->centre));
    l->radius[i] = s->radius.hi;
    l->radius_lo[i] = s->radius.lo;
}
#endif

/* Load spheres of n pairs into four lanes from i on. */
COMMON_INLINE void put_four_spheres(sphere_lanes *l, uint32_t i, const void *const *selves, uint32_t n)
{
    const void *spheres[4];
    uint32_t j;

    for (j = 0; j < 4; j++)
        spheres[j] = selves[common_lane_of(i + j, n)];
#ifdef COMMON_TRANSPOSES
    common_four v[4];

    common_transpose(spheres, 0, v);
    common_store_four(l->centre.x, i, v[0]);
    common_store_four(l->centre_lo.x, i, v[1]);
    common_store_four(l->centre.y, i, v[2]);
    common_store_four(l->centre_lo.y, i, v[3]);
    common_transpose(spheres, 4 * sizeof(double), v);
    common_store_four(l->centre.z, i, v[0]);
    common_store_four(l->centre_lo.z, i, v[1]);
    common_store_four(l->radius, i, v[2]);
    common_store_four(l->radius_lo, i, v[3]);
#else
    for (j = 0; j < 4; j++)
        put_sphere(l, i + j, spheres[j]);
#endif
}

/* The same of pairs. */
COMMON_INLINE void put_four(sphere_lanes *l, uint32_t i, const void *const *selves, const pov_ray *const *rays,
                            uint32_t n)
{
    put_four_spheres(l, i, selves, n);
    common_put_four_of(&l->rays, i, rays, n);
}

static inline common_sphere get_sphere(const sphere_lanes *l, uint32_t i)
{
    common_sphere s;

    s.centre = pov_two3_of(common_get(&l->centre, i), common_get(&l->centre_lo, i));
    s.radius = pov_two_of(l->radius[i], l->radius_lo[i]);
    return s;
}

/* Entry of each ray, or its exit if it starts inside: that end of the chord in the shape's units, its error bound, and
 * half the chord; then bounds on the distance, and the distance. */
typedef struct end_lanes {
    common_lane root, root_lo, error, separation;
    common_lane lo, hi, t, t_lo;
    int64_t feature[COMMON_LANES];
    int64_t good[COMMON_LANES];  /* is it accurate enough? */
} end_lanes;

static inline void put_end(end_lanes *restrict out, uint32_t i, const common_root *r, double unit, int good)
{
    const double slack = common_slack(r);

    out->lo[i] = (r->t.hi - slack) * unit;
    out->hi[i] = (r->t.hi + slack) * unit;
    out->t[i] = r->t.hi * unit;
    out->t_lo[i] = r->t.lo * unit;
    out->good[i] = good & (int)common_is_fine(r, COMMON_FINE * COMMON_SLOWEST);
}

COMMON_CLONES static void find_ends(const sphere_lanes *restrict l, end_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i++) {
        const common_sphere s = get_sphere(l, i);
        const pov_ray ray = common_get_ray(&l->rays, i);
        const common_ray k = common_enter(&ray, s.centre, common_sphere_scale(&s));
        const common_chord h = common_find_chord(common_sphere_square(&s), &k);
        const common_root near = common_near_end(&h), far = common_far_end(&h);
        const int within = (near.t.hi + common_slack(&near)) * k.unit < l->tmin[i];
        const common_root r = { { within ? far.t.hi : near.t.hi, within ? far.t.lo : near.t.lo }, h.error, 0, 0 };
        const int sound = (int)common_sphere_is_near(&k) & (int)common_is_cut(&h);

        out->root[i] = r.t.hi;
        out->root_lo[i] = r.t.lo;
        out->error[i] = sound ? r.error : NAN;
        out->separation[i] = h.root * h.inverse;
        out->feature[i] = within;
        put_end(out, i, &r, k.unit, sound);
    }
}

/* The refinement step of common_report(), where double was not accurate enough. */
COMMON_CLONES static void refine_ends(const sphere_lanes *restrict l, end_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i++) {
        const common_sphere s = get_sphere(l, i);
        const pov_ray ray = common_get_ray(&l->rays, i);
        const common_ray k = common_enter(&ray, s.centre, common_sphere_scale(&s));
        const double error = out->error[i], separation = out->separation[i];
        common_root r = { { out->root[i], out->root_lo[i] }, 0.0, 0, 0 };
        const common_residual f = common_sphere_residual(common_sphere_square(&s), &k, common_along_dd(&k, r.t));
        const double step = common_root_step(&f);
        const int good = (int)(error <= COMMON_SEPARATION * separation) & (int)(fabs(step) <= 2.0 * error)
                         & (int)(fabs(r.t.hi) > error);

        r.error = common_root_step_error(&f, step, separation);
        r.t = pov_two_add_double(r.t, step);
        put_end(out, i, &r, k.unit, good);
    }
}

static inline bool is_ahead(const end_lanes *e, uint32_t i, const pov_hits *h)
{
    return e->lo[i] <= h->tmax && e->hi[i] >= h->tmin && e->t[i] > h->tmin && !h->always_exact;
}

/* Report rays that do not leave the sphere, or go into it, and whose end of the chord is definitely within the
 * interval; where all crossings are wanted only those that start inside, which have no other one. */
static inline bool is_answered(const end_lanes *e, uint32_t i, const pov_ray *ray, const pov_hits *h)
{
    return is_ahead(e, i, h) && (h->want != POV_WANT_ALL || e->feature[i]) && (h->owner != ray->origin_surface || common_is_inward(ray, h));
}

/* Report these lanes; returns the lanes that are still to be intersected. */
static uint32_t report_ends(const end_lanes *e, uint32_t lanes, const pov_ray *const *rays, pov_hits *const *hits)
{
    uint32_t left = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = common_first_lane(lanes);

        if (e->good[i] && is_answered(e, i, rays[i], hits[i]))
            pov_cross(hits[i], e->t[i], e->t_lo[i], common_mark((uint32_t)e->feature[i], POV_MARK_CLOSED));
        else
            left |= 1u << i;
    }
    return left;
}

/* Leave out rays that do not leave the sphere, or go into it, and certainly end before that end of its chord: the other one is behind
 * their start, or farther still. So it is with light of lamps in a sphere that is a sky. */
static uint32_t drop_short(const end_lanes *e, uint32_t lanes, const pov_ray *const *rays, pov_hits *const *hits)
{
    uint32_t left = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = common_first_lane(lanes);
        const pov_hits *h = hits[i];
        const bool sound = e->error[i] >= 0.0 && !h->always_exact, starts = h->owner == rays[i]->origin_surface;

        if (!(sound && e->lo[i] > h->tmax && (!starts || common_is_inward(rays[i], h))))
            left |= 1u << i;
    }
    return left;
}

/* Lanes that a refinement step would settle: a search for any crossing needs none. */
static uint32_t worth_a_step(const end_lanes *e, uint32_t lanes, const pov_ray *const *rays, pov_hits *const *hits)
{
    uint32_t worth = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = common_first_lane(lanes);

        if (!e->good[i] && hits[i]->want != POV_WANT_ANY && is_answered(e, i, rays[i], hits[i]))
            worth |= 1u << i;
    }
    return worth;
}

/* Lanes that want both ends of their chord, the first of which is ahead. */
static uint32_t want_both(const end_lanes *e, uint32_t lanes, const pov_ray *const *rays, pov_hits *const *hits)
{
    uint32_t both = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = common_first_lane(lanes);
        const pov_hits *h = hits[i];

        if (h->want == POV_WANT_ALL && !e->feature[i] && h->owner != rays[i]->origin_surface && is_ahead(e, i, h))
            both |= 1u << i;
    }
    return both;
}

/* A refinement step for those of these lanes that need one. */
static void refine_open(const sphere_lanes *lanes, end_lanes *io, uint32_t which)
{
    const end_lanes before = *io;
    uint32_t open = 0;

    for (; which; which &= which - 1)
        open |= before.good[common_first_lane(which)] ? 0 : 1u << common_first_lane(which);
    if (!open)
        return;
    refine_ends(lanes, io);
    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        if (open >> i & 1)
            continue;
        io->lo[i] = before.lo[i];
        io->hi[i] = before.hi[i];
        io->t[i] = before.t[i];
        io->t_lo[i] = before.t_lo[i];
        io->good[i] = before.good[i];
    }
}

/* Report both ends of these lanes; returns the lanes that are still to be intersected. */
static uint32_t report_both(sphere_lanes *lanes, end_lanes *near, uint32_t both, pov_hits *const *hits)
{
    uint32_t left = 0;
    end_lanes far;

    for (uint32_t i = 0; i < COMMON_LANES; i++)
        lanes->tmin[i] = HUGE_VAL;
    find_ends(lanes, &far);
    refine_open(lanes, near, both);
    refine_open(lanes, &far, both);
    for (; both; both &= both - 1) {
        const uint32_t i = common_first_lane(both);

        if (!near->good[i] || !far.good[i] || !is_ahead(near, i, hits[i]) || !is_ahead(&far, i, hits[i]))
            left |= 1u << i;
        else if (pov_cross(hits[i], near->t[i], near->t_lo[i], common_mark(0, POV_MARK_CLOSED)))
            pov_cross(hits[i], far.t[i], far.t_lo[i], common_mark(1, POV_MARK_CLOSED));
    }
    return left;
}

static void intersect_lanes(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    sphere_lanes lanes;
    end_lanes end;
    uint32_t i, left, worth, both;

    for (i = 0; i < COMMON_LANES; i += 4)
        put_four(&lanes, i, selves, rays, n);
    for (i = 0; i < COMMON_LANES; i++) {
        const uint32_t j = common_lane_of(i, n);

        lanes.tmin[i] = common_is_inward(rays[j], hits[j]) ? HUGE_VAL : hits[j]->tmin;
    }
    find_ends(&lanes, &end);
    left = drop_short(&end, report_ends(&end, (1u << n) - 1, rays, hits), rays, hits);
    both = want_both(&end, left, rays, hits);
    left = both ? (left & ~both) | report_both(&lanes, &end, both, hits) : left;
    worth = worth_a_step(&end, left & ~both, rays, hits);
    if (worth) {
        refine_ends(&lanes, &end);
        left = (left & ~worth) | report_ends(&end, worth, rays, hits);
    }
    for (; left; left &= left - 1) {
        i = common_first_lane(left);
        common_sphere_intersect(selves[i], rays[i], hits[i]);
    }
}

void common_sphere_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                  uint32_t n)
{
    common_intersect_pairs(selves, rays, hits, n, intersect_lanes, common_sphere_intersect);
}

/* A normal, and its largest component before normalisation, or 0 where some component is too small beside it:
 * pov_unit() scales the very large and the very small. */
static inline double put_unit(common_lane3 *restrict out, uint32_t i, pov_vec3 w)
{
    const double length = sqrt(pov_dot(w, w)), inverse = 1.0 / length;
    const int moderate = pov_is_moderate(w.x) & pov_is_moderate(w.y) & pov_is_moderate(w.z);

    common_put(out, i, pov_vec3_of(pov_quotient(w.x, length, inverse), pov_quotient(w.y, length, inverse), pov_quotient(w.z, length, inverse)));
    return moderate ? pov_largest(w) : 0.0;
}

static inline bool is_moderate(double largest) { return largest > 1e-100 && largest < 1e100; }

COMMON_CLONES static void find_normals(const sphere_lanes *restrict l, common_lane3 *restrict out,
                                       double *restrict largest)
{
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i++) {
        common_sphere s = get_sphere(l, i);
        pov_ray ray = common_get_ray(&l->rays, i);
        pov_crossing at;

        at.t = l->t[i];
        at.t_lo = l->t_lo[i];
        largest[i] = put_unit(out, i, common_sphere_offset(&s, &ray, &at));
    }
}

static void normals_of(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                       pov_vec3 *const *out, uint32_t n)
{
    const pov_crossing *some[COMMON_LANES];
    sphere_lanes lanes;
    common_lane3 unit;
    common_lane largest;
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i++)
        some[i] = at[common_lane_of(i, n)];
    for (i = 0; i < COMMON_LANES; i += 4) {
        put_four(&lanes, i, selves, rays, n);
        common_put_four_crossings(lanes.t, lanes.t_lo, i, some + i);
    }
    find_normals(&lanes, &unit, largest);
    for (i = 0; i < n; i++)
        if (is_moderate(largest[i]))
            *out[i] = common_get(&unit, i);
        else
            common_sphere_normal(selves[i], rays[i], at[i], out[i]);
}

void common_sphere_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                        pov_vec3 *const *out, uint32_t n)
{
    uint32_t i;

    for (; n >= COMMON_LEAST; n -= i, selves += i, rays += i, at += i, out += i) {
        i = n < COMMON_LANES ? n : COMMON_LANES;
        normals_of(selves, rays, at, out, i);
    }
    for (i = 0; i < n; i++)
        common_sphere_normal(selves[i], rays[i], at[i], out[i]);
}

/* ---- at points ---- */

/* Load points of n pairs into four lanes from i on, in place of rays' starts. */
COMMON_INLINE void put_four_points(sphere_lanes *l, uint32_t i, const pov_vec3 *const *points, uint32_t n)
{
    uint32_t j;
#ifdef COMMON_TRANSPOSES
    const void *const from[4] = { points[common_lane_of(i, n)], points[common_lane_of(i + 1, n)], points[common_lane_of(i + 2, n)],
                                  points[common_lane_of(i + 3, n)] };
    common_four v[4];

    common_transpose(from, 0, v);
    for (j = 0; j < 3; j++)
        common_store_four(j == 0 ? l->rays.org.x : j == 1 ? l->rays.org.y : l->rays.org.z, i, v[j]);
    common_store_four(l->rays.org_lo.x, i, v[3]);
    common_transpose(from, 4 * sizeof(double), v);
    common_store_four(l->rays.org_lo.y, i, v[0]);
    common_store_four(l->rays.org_lo.z, i, v[1]);
#else
    for (j = 0; j < 4; j++) {
        common_put(&l->rays.org, i + j, points[common_lane_of(i + j, n)][0]);
        common_put(&l->rays.org_lo, i + j, points[common_lane_of(i + j, n)][1]);
    }
#endif
}

COMMON_CLONES static void find_normals_at(const sphere_lanes *restrict l, common_lane3 *restrict out, double *restrict largest)
{
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i++) {
        const common_sphere s = get_sphere(l, i);

        largest[i] = put_unit(out, i, common_sphere_offset_of(&s, common_get(&l->rays.org, i), common_get(&l->rays.org_lo, i)));
    }
}

static void normal_at(const common_sphere *s, const pov_vec3 *point, pov_vec3 *out)
{
    *out = pov_unit(common_sphere_offset_of(s, point[0], point[1]));
}

static void normals_at(const void *const *selves, const pov_vec3 *const *points, pov_vec3 *const *out, uint32_t n)
{
    sphere_lanes lanes;
    common_lane3 unit;
    common_lane largest;
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i += 4) {
        put_four_spheres(&lanes, i, selves, n);
        put_four_points(&lanes, i, points, n);
    }
    find_normals_at(&lanes, &unit, largest);
    for (i = 0; i < n; i++)
        if (is_moderate(largest[i]))
            *out[i] = common_get(&unit, i);
        else
            normal_at(selves[i], points[i], out[i]);
}

void common_sphere_normal_at_many(const void *const *selves, const pov_vec3 *const *points, pov_vec3 *const *out, uint32_t n)
{
    uint32_t i;

    for (; n >= COMMON_LEAST; n -= i, selves += i, points += i, out += i) {
        i = n < COMMON_LANES ? n : COMMON_LANES;
        normals_at(selves, points, out, i);
    }
    for (i = 0; i < n; i++)
        normal_at(selves[i], points[i], out[i]);
}

/* ---- crossings, and where they are ---- */

/* Write the lanes whose ends are good; returns the others. */
static inline uint32_t write_ends(const end_lanes *e, uint32_t lanes, pov_crossing *const *at)
{
    uint32_t open = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = common_first_lane(lanes);

        if (e->good[i] && e->t[i] > 0.0)
            common_cross_sure(at[i], e->t[i], e->t_lo[i], (uint32_t)e->feature[i], POV_MARK_CLOSED);
        else
            open |= 1u << i;
    }
    return open;
}

/* Points and normals at the ends, as find_normals_at() below. */
COMMON_CLONES static void find_contacts(const sphere_lanes *restrict l, const end_lanes *restrict e, common_contact_lanes *restrict out,
                                      double *restrict largest)
{
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i++) {
        const common_sphere s = get_sphere(l, i);
        const pov_ray ray = common_get_ray(&l->rays, i);

        common_put_point(out, i, &ray, e->t[i], e->t_lo[i]);
        largest[i] = put_unit(&out->normal, i, common_sphere_offset_of(&s, common_get(&out->point, i), common_get(&out->point_lo, i)));
    }
}

static void put_contacts(const sphere_lanes *l, const end_lanes *e, const void *const *selves, pov_contact *const *contacts, uint32_t n)
{
    common_contact_lanes found;
    common_lane largest;

    find_contacts(l, e, &found, largest);
    common_get_contacts(&found, contacts, n);
    for (uint32_t i = 0; i < n; i++)
        if (!is_moderate(largest[i]))
            normal_at(selves[i], &contacts[i]->point, &contacts[i]->normal);
}

/* Ends that are good already stay as they are. */
static void refine_others(const sphere_lanes *l, end_lanes *e)
{
    end_lanes finer = *e;

    refine_ends(l, &finer);
    for (uint32_t i = 0; i < COMMON_LANES; i++)
        if (!e->good[i]) {
            e->t[i] = finer.t[i];
            e->t_lo[i] = finer.t_lo[i];
            e->good[i] = finer.good[i];
        }
}

static uint32_t cross_sure_lanes(const void *const *selves, const pov_ray *const *rays, pov_crossing *const *at, pov_contact *const *contacts,
                                 uint32_t n)
{
    const double tmin = common_are_sure_inward(rays, at) ? HUGE_VAL : 0.0;
    sphere_lanes lanes;
    end_lanes end;
    uint32_t left;

    for (uint32_t i = 0; i < COMMON_LANES; i += 4)
        put_four(&lanes, i, selves, rays, n);
    for (uint32_t i = 0; i < COMMON_LANES; i++)
        lanes.tmin[i] = tmin;
    find_ends(&lanes, &end);
    left = write_ends(&end, (1u << n) - 1, at);
    if (left) {
        refine_others(&lanes, &end);
        left = write_ends(&end, left, at);
    }
    if (contacts)
        put_contacts(&lanes, &end, selves, contacts, n);
    return left;
}

uint64_t common_sphere_cross_sure(const void *const *selves, const pov_ray *const *rays, pov_crossing *const *at, pov_contact *const *contacts,
                                  uint32_t n)
{
    uint64_t open = 0;

    for (uint32_t i = 0; i < n; i += COMMON_LANES)
        open |= (uint64_t)cross_sure_lanes(selves + i, rays + i, at + i, contacts ? contacts + i : NULL,
                                           n - i < COMMON_LANES ? n - i : COMMON_LANES) << i;
    return open;
}
