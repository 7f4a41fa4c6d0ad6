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
