/* Several rays and a plane, side by side. */
#include "common/lanes.h"
#include "common/quadric_approx.h"

/* Planes across an axis, as most are: what is alike along it need not be looked at. */
enum { AXIS_NONE = -1, AXIS_X, AXIS_Y, AXIS_Z };

static bool is_power(double n) { return fabs(n) * pov_inverse_power(n) == 1.0; }

static int axis_of(const common_quadric *s)
{
    const pov_two *n = s->q + G;
    int axis = AXIS_NONE;

    for (int k = AXIS_X; k <= AXIS_Z; k++) {
        if (n[k].lo != 0.0 || (n[k].hi != 0.0 && (axis != AXIS_NONE || !is_power(n[k].hi))))
            return AXIS_NONE;
        axis = n[k].hi != 0.0 ? k : axis;
    }
    return axis;
}

/* Numbers of rays along one axis. */
typedef struct axis_lanes { const double *org, *org_lo, *dir, *dir_lo; } axis_lanes;

static axis_lanes lanes_along(const common_rays *r, int axis)
{
    const axis_lanes lanes[] = { { r->org.x, r->org_lo.x, r->dir.x, r->dir_lo.x }, { r->org.y, r->org_lo.y, r->dir.y, r->dir_lo.y },
                                 { r->org.z, r->org_lo.z, r->dir.z, r->dir_lo.z } };

    return lanes[axis];
}

/* A plane across an axis, and rays along it. */
typedef struct level_plane { axis_lanes along; pov_two anchor, at_anchor; double n, scale; } level_plane;

static level_plane level_of(const common_quadric *s, const common_rays *rays, int axis)
{
    const pov_two3 a = s->anchor;
    const level_plane l = { lanes_along(rays, axis), axis == AXIS_X ? a.x : axis == AXIS_Y ? a.y : a.z, s->q[J], s->q[G + axis].hi, s->scale };

    return l;
}

/* The crossing of lane i; unit makes it a distance. */
COMMON_INLINE plane_crossing cross_lane(const level_plane *l, const common_rays *rays, uint32_t i, double *unit)
{
    const double power = pov_inverse_power(pov_largest(common_get(&rays->dir, i)));
    const pov_two f = pov_two_scale(pov_two_offset(l->along.org[i], l->along.org_lo[i], l->anchor), l->scale);

    *unit = power * common_inverse(l->scale);
    return cross_level(l->n, l->at_anchor, f, pov_two_of(l->along.dir[i] * power, l->along.dir_lo[i] * power));
}

/* Crossings in the plane's units and what makes them distances. */
typedef struct crossing_lanes { common_lane t, t_lo, error, slope, unit; int64_t sound[COMMON_LANES]; } crossing_lanes;

COMMON_INLINE void put_crossing(crossing_lanes *restrict out, uint32_t i, const plane_crossing *c, double unit)
{
    out->t[i] = c->root.t.hi;
    out->t_lo[i] = c->root.t.lo;
    out->error[i] = c->root.error;
    out->slope[i] = c->slope;
    out->unit[i] = unit;
    out->sound[i] = c->is_sound;
}

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

        put_crossing(out, i, &c, k.unit);
    }
}

COMMON_CLONES static void find_level_crossings(const common_quadric *restrict s, const common_rays *restrict rays, int axis,
                                               crossing_lanes *restrict out)
{
    const level_plane l = level_of(s, rays, axis);

    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        double unit;
        const plane_crossing c = cross_lane(&l, rays, i, &unit);

        put_crossing(out, i, &c, unit);
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
    const int axis = axis_of(s);
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i++)
        some[i] = rays[which[common_lane_of(i, n)]];
    for (i = 0; i < COMMON_LANES; i += 4)
        common_put_four_rays(&of, i, some + i);
    if (axis == AXIS_NONE)
        find_crossings(s, &of, &lanes);
    else
        find_level_crossings(s, &of, axis, &lanes);
    for (i = 0; i < n; i++) {
        pov_hits *h = hits[which[i]];

        if (some[i]->origin_surface != h->owner && (h->always_exact || !lanes.sound[i] || !report(&lanes, i, h)))
            common_quadric_intersect(s, some[i], h);
    }
}

/* Crossings that are definite hits, in distances. NaN where report() may leave one open, or it may be behind the start. */
typedef struct sure_lanes { common_lane t, t_lo, feature; } sure_lanes;

/* unit: of the crossing. */
COMMON_INLINE void put_sure(sure_lanes *restrict out, uint32_t i, const plane_crossing *c, double unit)
{
    const double t = c->root.t.hi;
    const int sure = c->is_sound & (int)(t > common_slack(&c->root)) & (int)(c->root.error <= COMMON_ULPS * COMMON_U * t);

    out->t[i] = sure ? t * unit : NAN;
    out->t_lo[i] = c->root.t.lo * unit;
    out->feature[i] = c->slope < 0.0 ? ENTERING : EXITING;
}

COMMON_CLONES static void find_sure(const common_quadric *restrict s, const common_rays *restrict rays, sure_lanes *restrict out)
{
    const pov_two3 anchor = s->anchor, n = { s->q[G], s->q[H], s->q[I] };
    const pov_two at_anchor = s->q[J];
    const double scale = s->scale;

    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        const pov_ray ray = common_get_ray(rays, i);
        const common_ray k = common_enter(&ray, anchor, scale);
        const plane_crossing c = cross_plane(n, at_anchor, &k);

        put_sure(out, i, &c, k.unit);
    }
}

COMMON_CLONES static void find_level_sure(const common_quadric *restrict s, const common_rays *restrict rays, int axis, sure_lanes *restrict out)
{
    const level_plane l = level_of(s, rays, axis);

    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        double unit;
        const plane_crossing c = cross_lane(&l, rays, i, &unit);

        put_sure(out, i, &c, unit);
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

/* A plane, and what is the same for all of its pairs. */
typedef struct sure_plane { const common_quadric *of; int axis; pov_vec3 normal; } sure_plane;

static void look_at(sure_plane *p, const common_quadric *of)
{
    if (p->of == of)
        return;
    p->of = of;
    p->axis = axis_of(of);
    common_quadric_normal(of, NULL, NULL, &p->normal);
}

/* By lane: those that are left open. */
static uint32_t cross_sure_lanes(const sure_plane *of, const sure_pairs *p, bool with_contacts)
{
    common_contact_lanes contacts;
    sure_lanes end;
    uint32_t open = 0;

    if (of->axis == AXIS_NONE)
        find_sure(of->of, &p->rays, &end);
    else
        find_level_sure(of->of, &p->rays, of->axis, &end);
    for (uint32_t i = 0; i < p->n; i++)
        if (end.t[i] > 0.0)
            common_cross_sure(p->at[i], end.t[i], end.t_lo[i], (uint32_t)end.feature[i], 0);
        else
            open |= 1u << i;
    if (with_contacts) {
        find_contacts(&p->rays, &end, of->normal, &contacts);
        common_get_contacts(&contacts, p->contacts, p->n);
    }
    return open;
}

/* Most scenes have one plane or a few, and many rays meet each. */
void common_plane_intersect_pairs(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    enum { MOST = 64 };
    const uint32_t some = n < MOST ? n : MOST;
    uint64_t left = ~(uint64_t)0 >> (MOST - some);
    uint8_t which[COMMON_LANES];

    while (left) {
        const uint32_t count = common_take_same(selves, &left, which);

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
    sure_plane plane = { .of = NULL };

    while (left) {
        const pov_ray *some[COMMON_LANES];
        uint32_t i, not_sure;
        sure_pairs p;

        p.n = common_take_same(selves, &left, which);
        for (i = 0; i < COMMON_LANES; i++) {
            const uint32_t pair = which[common_lane_of(i, p.n)];

            some[i] = rays[pair];
            p.at[i] = at[pair];
            p.contacts[i] = contacts ? contacts[pair] : NULL;
        }
        for (i = 0; i < COMMON_LANES; i += 4)
            common_put_four_rays(&p.rays, i, some + i);
        look_at(&plane, selves[which[0]]);
        for (not_sure = cross_sure_lanes(&plane, &p, contacts != NULL); not_sure; not_sure &= not_sure - 1)
            open |= (uint64_t)1 << which[common_first_lane(not_sure)];
    }
    return open;
}
