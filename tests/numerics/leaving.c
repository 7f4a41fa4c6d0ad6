#include "numerics/leaving.h"

#include "numerics/families.h"

#include <povtrace/exact.h>

#include <string.h>

uint32_t subject_ask(const subject *s, const pov_ray *ray, pov_crossing at[CROSSINGS_MAX], uint32_t *escalated)
{
    pov_hits hits = { 0.0, HUGE_VAL, POV_WANT_ALL, s->always_exact, false, OWNER, 0, CROSSINGS_MAX, 0, at, NULL, NULL, false, NULL, 0.0, false, s->always_exact };
    uint32_t i, j;

    s->shape->intersect(s->self, ray, &hits);
    *escalated = hits.escalated;
    for (i = 1; i < hits.count; i++) {
        const pov_crossing c = at[i];

        for (j = i; j > 0 && (at[j - 1].t > c.t || (at[j - 1].t == c.t && at[j - 1].t_lo > c.t_lo)); j--)
            at[j] = at[j - 1];
        at[j] = c;
    }
    return hits.count;
}

/* ---- measures ---- */

double probe_limit(kind k)
{
    if (k == PLANE)
        return 64.0;
    return k == SPHERE || k == QUADRIC ? 16.0 : k == BOX || kind_is_planar(k) ? 4.0 : 32.0;
}

double probe_ulps_off(real exact, double t)
{
    const double near = fabs(real_double(exact));
    return fabs(real_double(real_sub(exact, real_of(t)))) / (nextafter(near, HUGE_VAL) - near);
}

double probe_speed(const probe *p) { return pov_dot(pov_unit(p->ray.dir), p->ray.dir); }

bool probe_keep_positive(exact_result *e, const probe *p)
{
    const double speed = probe_speed(p);
    int i, n = 0;

    for (i = 0; i < e->count; i++) {
        const double t = fabs(real_double(e->at[i].t));

        if (t > 1e300 || (t < 1e-290 && real_sign(e->at[i].t) != 0) || t * speed > 1e60 * p->size)
            return false;
        if (real_sign(e->at[i].t) > 0)
            e->at[n++] = e->at[i];
    }
    e->count = n;
    return true;
}

/* ---- rays ---- */

static pov_two coordinate(double o, double o_lo, const pov_crossing *c, double d, double d_lo)
{
    pov_two t = pov_two_of(c->t, c->t_lo);
    return pov_two_add(pov_two_sum(o, o_lo), pov_two_mul(t, pov_two_of(d, d_lo)));
}

pov_vec3 leaving_direction(pov_vec3 normal)
{
    pov_vec3 along = families_direction();

    if (families_uniform() < 0.5) {
        const double tilt = pow(10.0, -6.0 * families_uniform());
        along = pov_sub(along, pov_scale(normal, pov_dot(along, normal) * (1.0 - tilt)));
    }
    return pov_unit(along);
}

pov_ray leaving_ray(const pov_ray *ray, const pov_crossing *c, pov_vec3 direction)
{
    const pov_two x = coordinate(ray->org.x, ray->org_lo.x, c, ray->dir.x, ray->dir_lo.x);
    const pov_two y = coordinate(ray->org.y, ray->org_lo.y, c, ray->dir.y, ray->dir_lo.y);
    const pov_two z = coordinate(ray->org.z, ray->org_lo.z, c, ray->dir.z, ray->dir_lo.z);
    pov_ray r;

    memset(&r, 0, sizeof r);
    r.org = pov_vec3_of(x.hi, y.hi, z.hi);
    r.org_lo = pov_vec3_of(x.lo, y.lo, z.lo);
    r.dir = direction;
    r.origin_surface = OWNER;
    r.origin_mark = c->mark;
    return r;
}

/* ---- the exact answer ---- */

static void take_out(exact_result *e, int i)
{
    for (; i + 1 < e->count; i++)
        e->at[i] = e->at[i + 1];
    e->count--;
}

/* Take the root that the ray starts on out of the exact answer. False: it cannot be told from another. */
static bool take_out_start(exact_result *e, kind k, uint32_t feature, double size)
{
    double nearest = HUGE_VAL, second = HUGE_VAL;
    int i, start = 0;

    /* The planes of a box have names, however near they are to each other; but of one without any thickness nobody
     * can tell whether the start was rounded to the other side. */
    for (i = 0; i < e->count && k == BOX; i++) {
        if (e->at[i].feature == feature && fabs(real_double(e->at[i].t)) < 1e-24 * size) {
            take_out(e, i);
            return e->count == 0 || fabs(real_double(e->at[0].t)) > 1e-24 * size;
        }
    }

    for (i = 0; i < e->count; i++) {
        const double t = fabs(real_double(e->at[i].t));

        if (t < nearest) {
            second = nearest;
            nearest = t;
            start = i;
        } else if (t < second) {
            second = t;
        }
    }
    /* At a rim the rounded start can lie beside the shape. */
    if (e->count == 0 || nearest > 1e-3 * size)
        return true;
    if (nearest > 1e-9 * size || (e->count > 1 && second < 1e-6 * size))
        return false;
    take_out(e, start);
    return true;
}

/* The start of a ray lies off the surface by what distances may be off by, 2^-44 sizes (kit/report.h). From within that of
 * a rim the ray may pass through the corner or miss it: it goes no deeper there than the start may be off. */
static bool cuts_a_corner(const pov_crossing *hit, const pov_crossing *left, double slope, double size)
{
    return hit->mark.feature != left->mark.feature && hit->t * slope < 0x1p-43 * size;
}

leaving_verdict leaving_judge(const subject *s, const probe *q, const pov_crossing *c, double dir, pov_vec3 normal,
                              int *expected)
{
    exact_result e;
    pov_crossing at[CROSSINGS_MAX];
    uint32_t n, escalated;
    int i;

    probe_exact(q, &e);
    if (kind_is_planar(q->kind))
        e.count = 0;
    else if (!take_out_start(&e, q->kind, c->mark.feature, q->size))
        return NOT_JUDGED;
    if (!probe_keep_positive(&e, q) || dir > 1e15 * q->size)
        return NOT_JUDGED;
    *expected = e.count;
    n = subject_ask(s, &q->ray, at, &escalated);
    if (n == 1 && e.count == 0 && cuts_a_corner(&at[0], c, fabs(pov_dot(normal, q->ray.dir)), q->size))
        return NOT_JUDGED;
    if (n != (uint32_t)e.count)
        return n > (uint32_t)e.count ? HIT_ITSELF : LEAKED;
    /* A chord along the surface is as long as the square root of what two parts lose: nobody could tell its last
     * bits. */
    if (fabs(pov_dot(normal, q->ray.dir)) < 1e-7)
        return LEFT_WELL;
    for (i = 0; i < e.count; i++) {
        if (probe_ulps_off(e.at[i].t, at[i].t) > probe_limit(q->kind))
            return MISPLACED;
    }
    return LEFT_WELL;
}
