/* Several rays and a plane, side by side. */
#include "common/lanes.h"
#include "common/quadric_approx.h"

/* Crossings in the plane's units and what makes them distances. */
typedef struct crossing_lanes { common_lane t, t_lo, error, slope, unit; int64_t sound[COMMON_LANES]; } crossing_lanes;

COMMON_CLONES static void find_crossings(const common_quadric *restrict s, const common_rays *restrict rays,
                                         crossing_lanes *restrict out)
{
    const pov_two3 anchor = s->anchor, n = { s->q[G], s->q[H], s->q[I] };
    const pov_two at_anchor = s->q[J];
    const double scale = s->scale;
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i++) {
        const pov_ray ray = common_get_ray(rays, i);
        const common_ray k = common_enter(&ray, anchor, scale);
        const plane_crossing c = cross_plane(n, at_anchor, &k);

        out->t[i] = c.root.t.hi;
        out->t_lo[i] = c.root.t.lo;
        out->error[i] = c.root.error;
        out->slope[i] = c.slope;
        out->unit[i] = k.unit;
        out->sound[i] = c.is_sound;
    }
}

/* As for a single ray. False: it is left open. */
static bool report(const crossing_lanes *l, uint32_t i, pov_hits *hits)
{
    const common_root root = { { l->t[i], l->t_lo[i] }, l->error[i], 0, 0 };
    const double unit = l->unit[i];
    const common_verdict verdict = common_judge(&root, unit, HUGE_VAL, hits);

    if (verdict == COMMON_GOOD)
        pov_cross(hits, root.t.hi * unit, root.t.lo * unit, common_mark(l->slope[i] < 0.0 ? ENTERING : EXITING, 0));
    return verdict != COMMON_OPEN;
}

/* which: pairs of this plane. */
static void intersect_lanes(const common_quadric *s, const uint8_t *which, const pov_ray *const *rays,
                            pov_hits *const *hits, uint32_t n)
{
    const pov_ray *some[COMMON_LANES];
    crossing_lanes lanes;
    common_rays of;
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i++)
        some[i] = rays[which[common_lane_of(i, n)]];
    for (i = 0; i < COMMON_LANES; i += 4)
        common_put_four_rays(&of, i, some + i);
    find_crossings(s, &of, &lanes);
    for (i = 0; i < n; i++) {
        pov_hits *h = hits[which[i]];

        if (some[i]->origin_surface != h->owner && (h->always_exact || !lanes.sound[i] || !report(&lanes, i, h)))
            common_quadric_intersect(s, some[i], h);
    }
}

/* Crossings that are definite hits, in distances. NaN where report() may leave one open, or it may be behind the start. */
typedef struct sure_lanes { common_lane t, t_lo, feature; } sure_lanes;

COMMON_CLONES static void find_sure(const common_quadric *restrict s, const common_rays *restrict rays, sure_lanes *restrict out)
{
    const pov_two3 anchor = s->anchor, n = { s->q[G], s->q[H], s->q[I] };
    const pov_two at_anchor = s->q[J];
    const double scale = s->scale;

    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        const pov_ray ray = common_get_ray(rays, i);
        const common_ray k = common_enter(&ray, anchor, scale);
        const plane_crossing c = cross_plane(n, at_anchor, &k);
        const double t = c.root.t.hi;
        const int sure = c.is_sound & (int)(t > common_slack(&c.root)) & (int)(c.root.error <= COMMON_ULPS * COMMON_U * t);

        out->t[i] = sure ? t * k.unit : NAN;
        out->t_lo[i] = c.root.t.lo * k.unit;
        out->feature[i] = c.slope < 0.0 ? ENTERING : EXITING;
    }
}

COMMON_CLONES static void find_contacts(const common_rays *restrict rays, const sure_lanes *restrict e, pov_vec3 normal,
                                        common_contact_lanes *restrict out)
{
    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        const pov_ray ray = common_get_ray(rays, i);

        common_put_point(out, i, &ray, e->t[i], e->t_lo[i]);
        common_put(&out->normal, i, normal);
    }
}

/* Pairs of one plane and where their crossings are written to. */
typedef struct sure_pairs {
    common_rays rays;
    pov_crossing *at[COMMON_LANES];
    pov_contact *contacts[COMMON_LANES];
    uint32_t n;
} sure_pairs;

/* By lane: those that are left open. */
static uint32_t cross_sure_lanes(const common_quadric *s, const sure_pairs *p, bool with_contacts)
{
    common_contact_lanes contacts;
    sure_lanes end;
    pov_vec3 normal;
    uint32_t open = 0;

    find_sure(s, &p->rays, &end);
    for (uint32_t i = 0; i < p->n; i++)
        if (end.t[i] > 0.0)
            common_cross_sure(p->at[i], end.t[i], end.t_lo[i], (uint32_t)end.feature[i], 0);
        else
            open |= 1u << i;
    if (with_contacts) {
        common_quadric_normal(s, NULL, NULL, &normal);
        find_contacts(&p->rays, &end, normal, &contacts);
        common_get_contacts(&contacts, p->contacts, p->n);
    }
    return open;
}

/* Take up to COMMON_LANES pairs of the first one's plane out of `left`. */
static uint32_t take_same(const void *const *selves, uint64_t *left, uint8_t *which)
{
    const void *first = selves[common_first_lane64(*left)];
    uint64_t rest;
    uint32_t n = 0;

    for (rest = *left; rest && n < COMMON_LANES; rest &= rest - 1) {
        const uint32_t i = common_first_lane64(rest);

        if (selves[i] != first)
            continue;
        which[n++] = (uint8_t)i;
        *left &= ~((uint64_t)1 << i);
    }
    return n;
}

/* Most scenes have one plane or a few, and many rays meet each. */
void common_plane_intersect_pairs(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    enum { MOST = 64 };
    const uint32_t some = n < MOST ? n : MOST;
    uint64_t left = ~(uint64_t)0 >> (MOST - some);
    uint8_t which[COMMON_LANES];

    while (left) {
        const uint32_t count = take_same(selves, &left, which);

        if (count >= COMMON_LEAST)
            intersect_lanes(selves[which[0]], which, rays, hits, count);
        else
            for (uint32_t i = 0; i < count; i++)
                common_quadric_intersect(selves[which[i]], rays[which[i]], hits[which[i]]);
    }
    if (n > some)
        common_plane_intersect_pairs(selves + some, rays + some, hits + some, n - some);
}

uint64_t common_plane_cross_sure(const void *const *selves, const pov_ray *const *rays, pov_crossing *const *at, pov_contact *const *contacts,
                                 uint32_t n)
{
    uint64_t left = ~(uint64_t)0 >> (POV_RAYS_MAX - n), open = 0;
    uint8_t which[COMMON_LANES];

    while (left) {
        const pov_ray *some[COMMON_LANES];
        uint32_t i, not_sure;
        sure_pairs p;

        p.n = take_same(selves, &left, which);
        for (i = 0; i < COMMON_LANES; i++) {
            const uint32_t pair = which[common_lane_of(i, p.n)];

            some[i] = rays[pair];
            p.at[i] = at[pair];
            p.contacts[i] = contacts ? contacts[pair] : NULL;
        }
        for (i = 0; i < COMMON_LANES; i += 4)
            common_put_four_rays(&p.rays, i, some + i);
        for (not_sure = cross_sure_lanes(selves[which[0]], &p, contacts != NULL); not_sure; not_sure &= not_sure - 1)
            open |= (uint64_t)1 << which[common_first_lane(not_sure)];
    }
    return open;
}
