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

/* Pairs of a ray and one plane, in groups of eight lanes. Each step is taken for all groups before the next one: a lane's sums wait for each
 * other, and a processor that looks ahead finds other groups' sums only where steps are short. */
enum { GROUPS = 4, TOGETHER = GROUPS * COMMON_LANES };

/* The plane along each ray; unit: of its crossing. */
typedef struct along_lanes { common_lane value, value_lo, slope, slope_lo, value_size, slope_size, unit; } along_lanes;

/* Crossings in the plane's units. */
typedef struct root_lanes { common_lane t, t_lo; } root_lanes;

/* Crossings that are definite hits, in distances. NaN where report() may leave one open, or it may be behind the start. */
typedef struct sure_lanes { common_lane t, t_lo, feature; } sure_lanes;

COMMON_INLINE void put_along(along_lanes *restrict out, uint32_t i, const plane_along *a, double unit)
{
    out->value[i] = a->value.hi;
    out->value_lo[i] = a->value.lo;
    out->slope[i] = a->slope.hi;
    out->slope_lo[i] = a->slope.lo;
    out->value_size[i] = a->value_size;
    out->slope_size[i] = a->slope_size;
    out->unit[i] = unit;
}

COMMON_INLINE plane_along get_along(const along_lanes *l, uint32_t i)
{
    const plane_along a = { { l->value[i], l->value_lo[i] }, { l->slope[i], l->slope_lo[i] }, l->value_size[i], l->slope_size[i] };

    return a;
}

COMMON_CLONES static void find_tilted(const common_quadric *restrict s, const common_rays *restrict rays, along_lanes *restrict out)
{
    const pov_two3 anchor = s->anchor, n = { s->q[G], s->q[H], s->q[I] };
    const pov_two at_anchor = s->q[J];
    const double scale = s->scale;

    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        const pov_ray ray = common_get_ray(rays, i);
        const common_ray k = common_enter(&ray, anchor, scale);
        const plane_along a = along_plane(n, at_anchor, &k);

        put_along(out, i, &a, k.unit);
    }
}

/* Numbers of rays along one axis. */
typedef struct axis_lanes { const double *org, *org_lo, *dir, *dir_lo; } axis_lanes;

COMMON_INLINE axis_lanes lanes_along(const common_rays *r, int axis)
{
    const axis_lanes x = { r->org.x, r->org_lo.x, r->dir.x, r->dir_lo.x }, y = { r->org.y, r->org_lo.y, r->dir.y, r->dir_lo.y };
    const axis_lanes z = { r->org.z, r->org_lo.z, r->dir.z, r->dir_lo.z };

    return axis == AXIS_X ? x : axis == AXIS_Y ? y : z;
}

COMMON_CLONES static void find_level(const common_quadric *restrict s, const common_rays *restrict rays, int axis, along_lanes *restrict out)
{
    const axis_lanes l = lanes_along(rays, axis);
    const pov_two anchor = axis == AXIS_X ? s->anchor.x : axis == AXIS_Y ? s->anchor.y : s->anchor.z, at_anchor = s->q[J];
    const double n = s->q[G + axis].hi, scale = s->scale;

    for (uint32_t i = 0; i < COMMON_LANES; i++) {
        const double power = pov_inverse_power(pov_largest(common_get(&rays->dir, i)));
        const pov_two f = pov_two_scale(pov_two_offset(l.org[i], l.org_lo[i], anchor), scale);
        const plane_along a = along_level(n, at_anchor, f, pov_two_of(l.dir[i] * power, l.dir_lo[i] * power));

        put_along(out, i, &a, power * common_inverse(scale));
    }
}

static void find_along(const common_quadric *s, const common_rays *rays, uint32_t groups, along_lanes *out)
{
    const int axis = axis_of(s);

    for (uint32_t k = 0; k < groups; k++)
        if (axis == AXIS_NONE)
            find_tilted(s, &rays[k], &out[k]);
        else
            find_level(s, &rays[k], axis, &out[k]);
}

COMMON_CLONES static void find_roots(const along_lanes *restrict lines, uint32_t groups, root_lanes *restrict out)
{
    for (uint32_t k = 0; k < groups; k++)
        for (uint32_t i = 0; i < COMMON_LANES; i++) {
            const plane_along a = get_along(&lines[k], i);
            const pov_two t = plane_root(a.value, a.slope);

            out[k].t[i] = t.hi;
            out[k].t_lo[i] = t.lo;
        }
}

COMMON_CLONES static void find_sure(const along_lanes *restrict lines, const root_lanes *restrict roots, uint32_t groups, sure_lanes *restrict out)
{
    for (uint32_t k = 0; k < groups; k++)
        for (uint32_t i = 0; i < COMMON_LANES; i++) {
            const plane_along a = get_along(&lines[k], i);
            const double t = roots[k].t[i], error = plane_error(&a, t), size = t * fabs(a.slope.hi);
            const int sure = plane_is_sound(&a) & (int)(size > error + 2.0 * COMMON_U * size) & (int)(error <= COMMON_ULPS * COMMON_U * size);

            out[k].t[i] = sure ? t * lines[k].unit[i] : NAN;
            out[k].t_lo[i] = roots[k].t_lo[i] * lines[k].unit[i];
            out[k].feature[i] = a.slope.hi < 0.0 ? ENTERING : EXITING;
        }
}

COMMON_CLONES static void find_contacts(const common_rays *restrict rays, const sure_lanes *restrict ends, uint32_t groups, pov_vec3 normal,
                                        common_contact_lanes *restrict out)
{
    for (uint32_t k = 0; k < groups; k++)
        for (uint32_t i = 0; i < COMMON_LANES; i++) {
            const pov_ray ray = common_get_ray(&rays[k], i);

            common_put_point(&out[k], i, &ray, ends[k].t[i], ends[k].t_lo[i]);
            common_put(&out[k].normal, i, normal);
        }
}

/* As for a single ray. False: it is left open. */
static bool report(const along_lanes *lines, const root_lanes *roots, uint32_t i, pov_hits *hits)
{
    const plane_along a = get_along(lines, i);
    const common_root root = { { roots->t[i], roots->t_lo[i] }, plane_error(&a, roots->t[i]) / fabs(a.slope.hi), 0, 0 };
    const double unit = lines->unit[i];
    common_verdict verdict;

    if (!plane_is_sound(&a))
        return false;
    verdict = common_judge(&root, unit, HUGE_VAL, hits);
    if (verdict == COMMON_GOOD)
        pov_cross(hits, root.t.hi * unit, root.t.lo * unit, common_mark(a.slope.hi < 0.0 ? ENTERING : EXITING, 0));
    return verdict != COMMON_OPEN;
}

/* which: pairs of this plane. */
static void intersect_lanes(const common_quadric *s, const uint8_t *which, const pov_ray *const *rays,
                            pov_hits *const *hits, uint32_t n)
{
    const pov_ray *some[COMMON_LANES];
    along_lanes lines;
    root_lanes roots;
    common_rays of;
    uint32_t i;

    for (i = 0; i < COMMON_LANES; i++)
        some[i] = rays[which[common_lane_of(i, n)]];
    for (i = 0; i < COMMON_LANES; i += 4)
        common_put_four_rays(&of, i, some + i);
    find_along(s, &of, 1, &lines);
    find_roots(&lines, 1, &roots);
    for (i = 0; i < n; i++) {
        pov_hits *h = hits[which[i]];

        if (some[i]->origin_surface != h->owner && (h->always_exact || !report(&lines, &roots, i, h)))
            common_quadric_intersect(s, some[i], h);
    }
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

/* Pairs of one plane whose crossings are definite. */
typedef struct sure_pairs {
    common_rays rays[GROUPS];
    sure_lanes ends[GROUPS];
    common_contact_lanes contacts[GROUPS];
    uint32_t n, groups;
    uint8_t which[TOGETHER];
} sure_pairs;

/* Those of the pairs that are of this plane. */
COMMON_CLONES static uint64_t find_same(const void *const *selves, const void *plane, uint32_t n)
{
    uint64_t same = 0;

    for (uint32_t i = 0; i < n; i++)
        same |= (uint64_t)(selves[i] == plane) << i;
    return same;
}

/* Take some of those pairs. Returns what is left of them. */
static uint64_t take(const pov_ray *const *rays, uint64_t pairs, sure_pairs *out)
{
    for (out->n = 0; pairs && out->n < TOGETHER; pairs &= pairs - 1)
        out->which[out->n++] = (uint8_t)common_first_lane64(pairs);
    out->groups = (out->n + COMMON_LANES - 1) / COMMON_LANES;
    for (uint32_t i = 0; i < COMMON_LANES * out->groups; i += 4) {
        const pov_ray *some[4];

        for (uint32_t j = 0; j < 4; j++)
            some[j] = rays[out->which[common_lane_of(i + j, out->n)]];
        common_put_four_rays(&out->rays[i / COMMON_LANES], i % COMMON_LANES, some);
    }
    return pairs;
}

static void cross_sure(const common_quadric *plane, sure_pairs *p)
{
    along_lanes lines[GROUPS];
    root_lanes roots[GROUPS];

    find_along(plane, p->rays, p->groups, lines);
    find_roots(lines, p->groups, roots);
    find_sure(lines, roots, p->groups, p->ends);
}

/* Returns the pairs that are left open. */
static uint64_t report_sure(const sure_pairs *p, pov_crossing *const *at)
{
    uint64_t open = 0;

    for (uint32_t k = 0; k < p->n; k++) {
        const sure_lanes *e = &p->ends[k / COMMON_LANES];
        const uint32_t i = k % COMMON_LANES;

        if (e->t[i] > 0.0)
            common_cross_sure(at[p->which[k]], e->t[i], e->t_lo[i], (uint32_t)e->feature[i], 0);
        else
            open |= (uint64_t)1 << p->which[k];
    }
    return open;
}

static void report_contacts(const sure_pairs *p, pov_contact *const *contacts)
{
    for (uint32_t k = 0; k < p->n; k += COMMON_LANES) {
        const uint32_t n = p->n - k < COMMON_LANES ? p->n - k : COMMON_LANES;
        pov_contact *some[COMMON_LANES];

        for (uint32_t i = 0; i < n; i++)
            some[i] = contacts[p->which[k + i]];
        common_get_contacts(&p->contacts[k / COMMON_LANES], some, n);
    }
}

uint64_t common_plane_cross_sure(const void *const *selves, const pov_ray *const *rays, pov_crossing *const *at, pov_contact *const *contacts,
                                 uint32_t n)
{
    uint64_t left = ~(uint64_t)0 >> (POV_RAYS_MAX - n), open = 0;
    sure_pairs p;

    while (left) {
        const common_quadric *plane = selves[common_first_lane64(left)];
        uint64_t same = find_same(selves, plane, n);
        pov_vec3 normal;

        left &= ~same;
        common_quadric_normal(plane, NULL, NULL, &normal);
        while (same) {
            same = take(rays, same, &p);
            cross_sure(plane, &p);
            open |= report_sure(&p, at);
            if (!contacts)
                continue;
            find_contacts(p.rays, p.ends, p.groups, normal, p.contacts);
            report_contacts(&p, contacts);
        }
    }
    return open;
}
