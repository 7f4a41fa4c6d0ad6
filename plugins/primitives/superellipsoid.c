/* superellipsoid { <e, n> }: (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1.
 *
 * The left side to the power n/2 is a size: of a point twice as far it is double. With e and n up to 2 that is a norm, which
 * is convex along a ray: Newton's method from outside comes to the first crossing without passing it, and the slope tells
 * a ray that misses. Stars, with e or n above 2, are searched by bounds (common/superellipsoid_star.c). */
#include "common/superellipsoid_lanes.h"
#include "common/superellipsoid_star.h"

/* Exponents below this make edges that no double tells from those of a box. */
static const double SHARPEST = 0x1p-10, NEAR = 0x1p-30, LAST = 0x1p-27;

static double exponent(const pov_host *host, pov_reader *in, double written)
{
    if (!(written >= SHARPEST))
        host->warn(in, "an exponent of a superellipsoid below %g counts as that", SHARPEST);
    return pov_max(written, SHARPEST);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    superellipsoid *s = self;
    double v[2];

    host->vector_of(in, v, 2);
    s->e = exponent(host, in, v[0]);
    s->n = exponent(host, in, v[1]);
    s->convex = s->e <= 2.0 && s->n <= 2.0;
    s->approx = pov_min(s->e, s->n) >= 0.0625 && pov_max(s->e, s->n) <= 16.0;
}

static bool bounds(const void *self, pov_box *out)
{
    (void)self;
    out->lo = pov_vec3_of(-1.0, -1.0, -1.0);
    out->hi = pov_vec3_of(1.0, 1.0, 1.0);
    return true;
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    return size_at(self, pov_add(point, point_lo)) <= 1.0;
}

/* ---- along a ray ---- */

/* Approximate values come near the root: a start for exact ones. False: there is none, beyond what those may be off. */
static bool come_near(const line *n, double sign, double *start)
{
    double t = *start, slope, value = approx_along(n, t, &slope);

    for (int turn = 0; turn < 100 && value > APPROX; turn++) {
        double next;

        if (!(slope * sign < 0.0))
            return value < 4.0 * APPROX;
        next = t - value / slope;
        if (!(next >= n->span.lo && next <= n->span.hi))
            return value < 4.0 * APPROX;
        t = next;
        value = approx_along(n, t, &slope);
    }
    *start = t;
    return true;
}

/* Does a step of Newton's method end at the crossing? It leaves a value of the step's square: of a ray that grazes, steps are long. */
static inline bool is_last_step(double value, double slope) { return fabs(value) < LAST && fabs(value) < LAST * (slope * slope); }

/* Newton's method from one end of a convex function; sign: 1 from the near end, -1 from the far one. False: no crossing. */
static bool approach(const line *n, double start, double sign, double *root, double *slope)
{
    double t = start, value;

    if (!come_near(n, sign, &t))
        return false;
    value = size_along(n, t, slope);
    for (int turn = 0; turn < 100 && fabs(value) > FINE; turn++) {
        double next;

        if (!(*slope * sign < 0.0))
            return false;
        next = t - value / *slope;
        if (!(next >= n->span.lo && next <= n->span.hi))
            return false;
        if (next == t || is_last_step(value, *slope)) {
            t = next;
            break;
        }
        t = next;
        value = size_along(n, t, slope);
    }
    *root = t;
    return true;
}

static bool goes_in(const line *n, const pov_ray *ray)
{
    double slope;

    if (ray->origin_mark.flags & (POV_MARK_INWARD | POV_MARK_OUTWARD))
        return ray->origin_mark.flags & POV_MARK_INWARD;
    size_along(n, 0.0, &slope);
    return slope < 0.0;
}

/* A ray that clearly goes in, where it counts, need not come out. */
static bool is_enough(const line *n, const common_ray *k, double in, double slope, const pov_hits *hits)
{
    return hits->want != POV_WANT_ALL && slope < -0x1p-10 && (n->base + in) * k->unit > hits->tmin;
}

/* Any crossing counts: is there one for certain? Then *at is near it. */
static bool is_certain(const line *n, const common_ray *k, const pov_hits *hits, double *at)
{
    double t = n->span.lo, slope, value, behind;

    if (hits->want != POV_WANT_ANY || !come_near(n, 1.0, &t))
        return false;
    value = approx_along(n, t, &slope);
    behind = t - (fabs(value) + 4.0 * APPROX) / slope;
    *at = t;
    return slope < 0.0 && (n->base + t) * k->unit > hits->tmin && (n->base + behind) * k->unit < hits->tmax &&
           approx_along(n, behind, &slope) < -APPROX;
}

static void cross_convex(const line *n, const common_ray *k, const pov_ray *ray, bool from_here, pov_hits *hits)
{
    double in, out, slope, slope_out;

    if (from_here) {
        if (goes_in(n, ray) && approach(n, n->span.hi, -1.0, &out, &slope) && out > 0.0)
            report(n, k, out, hits);
        return;
    }
    if (is_certain(n, k, hits, &in)) {
        report(n, k, in, hits);
        return;
    }
    if (!approach(n, n->span.lo, 1.0, &in, &slope))
        return;
    if (is_enough(n, k, in, slope, hits))
        report(n, k, in, hits);
    else if (approach(n, n->span.hi, -1.0, &out, &slope_out) && in < out && report(n, k, in, hits))
        report(n, k, out, hits);
}

static const pov_vec3 zero = { 0.0, 0.0, 0.0 }, one = { 1.0, 1.0, 1.0 };

/* False: the ray misses the box, or has no direction, so that it stays where it is for ever. */
static bool enter(line *n, const superellipsoid *s, const common_ray *k, bool from_here, const pov_hits *hits)
{
    if (!common_clip(k, pov_scale(one, -1.0), one, &n->span) || n->span.hi < 0.0 ||
        !(n->span.hi < HUGE_VAL) || n->span.lo * k->unit > hits->tmax)
        return false;
    n->s = s;
    n->base = from_here ? 0.0 : n->span.lo;
    n->o = common_along(k, n->base);
    n->d = k->d;
    n->span.lo -= n->base;
    n->span.hi -= n->base;
    return true;
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    const bool from_here = ray->origin_surface == hits->owner;
    line n;

    if (!enter(&n, self, &k, from_here, hits))
        return;
    if (n.s->convex)
        cross_convex(&n, &k, ray, from_here, hits);
    else
        common_superellipsoid_star(&n, &k, from_here ? NEAR : n.span.lo, hits);
}

/* ---- several rays side by side ---- */

/* One of them: where it is, and whether that is still being looked for. `near`: about the first crossing. */
typedef struct member { line n; common_ray k; bool open, near; } member;

/* A turn of come_near() from the near end. False: it ends, near the crossing or with a certain miss, or `unsure`. */
static bool turn_near(member *m, double value, double slope, double *t, bool *unsure)
{
    const double next = *t - value / slope;

    m->near = !(value > APPROX);
    if (!m->near && slope < 0.0 && next >= m->n.span.lo && next <= m->n.span.hi) {
        *t = next;
        return true;
    }
    *unsure = !m->near && value < 4.0 * APPROX;
    return false;
}

/* A turn of approach(). False: it ends, at the crossing or `unsure`. */
static bool turn_exact(member *m, double value, double slope, double *t, bool *unsure)
{
    const double next = *t - value / slope, at = *t;

    if (!(fabs(value) > FINE))
        return false;
    *unsure = !(slope < 0.0 && next >= m->n.span.lo && next <= m->n.span.hi);
    if (*unsure)
        return false;
    *t = next;
    return next != at && !is_last_step(value, slope);
}

typedef struct members { member at[TOGETHER]; line_lanes lanes; lane t, value, slope; bool unsure[TOGETHER]; } members;

typedef void evaluate(const line_lanes *restrict l, const double *restrict t, double *restrict value, double *restrict slope);
typedef bool take_turn(member *m, double value, double slope, double *t, bool *unsure);

/* Turns until all have ended. */
static void take_turns(members *all, evaluate *sizes, take_turn *take)
{
    bool any = true;

    for (int turn = 0; turn < 100 && any; turn++) {
        sizes(&all->lanes, all->t, all->value, all->slope);
        any = false;
        for (uint32_t i = 0; i < TOGETHER; i++) {
            member *m = &all->at[i];

            if (m->open)
                m->open = take(m, all->value[i], all->slope[i], &all->t[i], &all->unsure[i]);
            any = any || m->open;
        }
    }
    for (uint32_t i = 0; any && i < TOGETHER; i++)
        all->unsure[i] = all->unsure[i] || all->at[i].open;
}

/* As is_certain(), of those near a crossing. */
static void find_certain(members *all, pov_hits *const *hits, uint32_t n, bool *certain)
{
    lane behind, value, slope;

    for (uint32_t i = 0; i < TOGETHER; i++)
        behind[i] = all->t[i] - (fabs(all->value[i]) + 4.0 * APPROX) / all->slope[i];
    approxes_along(&all->lanes, behind, value, slope);
    for (uint32_t i = 0; i < n; i++) {
        const member *m = &all->at[i];

        certain[i] = m->near && all->slope[i] < 0.0 && (m->n.base + all->t[i]) * m->k.unit > hits[i]->tmin &&
                     (m->n.base + behind[i]) * m->k.unit < hits[i]->tmax && value[i] < -APPROX;
    }
}

/* Rays that do not start on a convex shape. The first crossing of each is looked for; those that are not certain of one, or of a
 * miss, are left to cross_convex(). */
static void cross_lanes(members *all, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    bool certain[TOGETHER] = { false }, any = false, some = false;

    for (uint32_t i = 0; i < TOGETHER; i++) {
        put_line(&all->lanes, &all->at[i < n ? i : n - 1].n, i);
        all->at[i].open = i < n;
        all->at[i].near = all->unsure[i] = false;
        all->t[i] = all->at[i < n ? i : n - 1].n.span.lo;
    }
    take_turns(all, approxes_along, turn_near);
    for (uint32_t i = 0; i < n; i++) {
        any = any || (all->at[i].near && hits[i]->want == POV_WANT_ANY);
        all->at[i].open = all->at[i].near && hits[i]->want == POV_WANT_NEAREST;
        some = some || all->at[i].open;
    }
    if (any)
        find_certain(all, hits, n, certain);
    if (some)
        take_turns(all, sizes_along, turn_exact);
    for (uint32_t i = 0; i < n; i++) {
        const member *m = &all->at[i];
        const bool is_any = hits[i]->want == POV_WANT_ANY;

        if (!all->unsure[i] && !m->near)
            continue;
        if (!all->unsure[i] && (is_any ? certain[i] : hits[i]->want == POV_WANT_NEAREST &&
                                                      is_enough(&m->n, &m->k, all->t[i], all->slope[i], hits[i])))
            report(&m->n, &m->k, all->t[i], hits[i]);
        else
            cross_convex(&m->n, &m->k, rays[i], false, hits[i]);
    }
}

/* Stars among the rays. */
static void find_stars(const superellipsoid *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    star_ray all[STARS];
    uint32_t count = 0;

    for (uint32_t i = 0; i < n; i++) {
        star_ray *r = &all[count];
        const bool from_here = rays[i]->origin_surface == hits[i]->owner;

        r->k = common_enter(rays[i], pov_two3_of(zero, zero), 1.0);
        if (!enter(&r->n, selves[i], &r->k, from_here, hits[i]))
            continue;
        r->from = from_here ? NEAR : r->n.span.lo;
        r->hits = hits[i];
        count++;
    }
    if (count > 0)
        common_superellipsoid_stars(all, count);
}

static void intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    const pov_ray *some[TOGETHER], *star_rays[STARS];
    pov_hits *of[TOGETHER], *star_hits[STARS];
    const superellipsoid *stars[STARS];
    members all;
    uint32_t count = 0, star_count = 0;

    for (uint32_t i = 0; i < n; i++) {
        const superellipsoid *s = selves[i];

        if (!s->convex && s->approx && !hits[i]->always_exact) {
            stars[star_count] = s;
            star_rays[star_count] = rays[i];
            star_hits[star_count++] = hits[i];
            if (star_count == STARS) {
                find_stars(stars, star_rays, star_hits, star_count);
                star_count = 0;
            }
            continue;
        }
        if (!s->convex || rays[i]->origin_surface == hits[i]->owner || hits[i]->always_exact) {
            intersect(s, rays[i], hits[i]);
            continue;
        }
        all.at[count].k = common_enter(rays[i], pov_two3_of(zero, zero), 1.0);
        if (!enter(&all.at[count].n, s, &all.at[count].k, false, hits[i]))
            continue;
        some[count] = rays[i];
        of[count++] = hits[i];
        if (count == TOGETHER) {
            cross_lanes(&all, some, of, count);
            count = 0;
        }
    }
    find_stars(stars, star_rays, star_hits, star_count);
    if (count > 1)
        cross_lanes(&all, some, of, count);
    else if (count > 0)
        cross_convex(&all.at[0].n, &all.at[0].k, some[0], false, of[0]);
}

/* ---- normals ---- */

/* The point of a crossing. */
static pov_vec3 point_of(const pov_ray *ray, const pov_crossing *at)
{
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);

    return pov_two3_hi(common_point(&k, at));
}

static pov_vec3 unit_of(pov_vec3 slope, const pov_ray *ray)
{
    const pov_vec3 unit = pov_unit(slope);

    return pov_largest(unit) > 0.0 ? unit : pov_scale(pov_unit(ray->dir), -1.0);
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    pov_vec3 slope;

    size_and_slope(self, point_of(ray, at), false, &slope);
    *out = unit_of(slope, ray);
}

/* Of the points o. */
COMMON_SEPARATE static void find_slopes(const line_lanes *restrict l, double (*restrict out)[TOGETHER])
{
    for (uint32_t i = 0; i < TOGETHER; i++) {
        superellipsoid s;
        const line n = get_line(l, &s, i);
        pov_vec3 slope;

        size_and_slope(&s, n.o, false, &slope);
        out[0][i] = slope.x;
        out[1][i] = slope.y;
        out[2][i] = slope.z;
    }
}

static void normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                        pov_vec3 *const *out, uint32_t n)
{
    lane slopes[3];
    line_lanes lanes;

    for (uint32_t some; n > 0; n -= some, selves += some, rays += some, at += some, out += some) {
        some = n < TOGETHER ? n : TOGETHER;
        for (uint32_t i = 0; i < TOGETHER; i++) {
            const uint32_t j = i < some ? i : some - 1;
            const line place = { .s = selves[j], .o = point_of(rays[j], at[j]) };

            put_line(&lanes, &place, i);
        }
        find_slopes(&lanes, slopes);
        for (uint32_t i = 0; i < some; i++)
            *out[i] = unit_of(pov_vec3_of(slopes[0][i], slopes[1][i], slopes[2][i]), rays[i]);
    }
}

static const pov_shape_fast superellipsoid_fast = {
    .size = sizeof(pov_shape_fast),
    .intersect_many = intersect_many,
    .normal_many = normal_many,
};

static const void *extension(const char *name) { return common_is_fast(name) ? &superellipsoid_fast : NULL; }

static const pov_shape_class superellipsoid_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID,
    .keyword = "superellipsoid",
    .instance_size = sizeof(superellipsoid),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .extension = extension,
};

static const pov_shape_class *const shapes[] = { &superellipsoid_class, NULL };

POV_PLUGIN(superellipsoid) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "superellipsoid",
    .version = "1",
    .shapes = shapes,
};
