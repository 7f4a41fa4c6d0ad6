/* Crossings of one ray and a polynomial. */
#include "common/polynomial.h"

#include "common/bernstein.h"
#include "common/clip.h"
#include "common/dense.h"
#include "common/local.h"

enum { MOST = COMMON_ORDER_MAX + 1 };

/* Polynomials in the distance. */
#include "common/polynomial_line.h"

/* ---- roots ---- */

/* Coefficients about a base, and on the whole line what each is off by. */
typedef struct search {
    const common_polynomial *p;
    const common_ray *k;
    pov_vec3 from;
    double base, start, c[MOST + 1], off[MOST + 1];
    bool from_here;
    pov_hits *hits;
} search;

/* A part of the line: x = t / size from 0 to 1, or where it is beyond that x = size / t, with negative sizes towards the past. `b`, each off by
 * `noise`, is what is left where the root that a ray starts on is divided out, in t / unit; `sizes`: of the terms. ahead: it may be long. */
typedef struct part { double size, unit, noise, sizes, b[MOST]; int degree; bool beyond, ahead; } part;

static double distance_of(const part *of, double x) { return of->beyond ? of->size / x : of->size * x; }

/* A root of the polynomial in x as one of that along the ray. */
static common_polynomial_root root_of(const search *s, const part *of, double x)
{
    common_polynomial_root r = { s->base, distance_of(of, x), common_bernstein_slope(of->b, of->degree, x) / of->size, of->sizes, fabs(of->size) };

    if (of->beyond) {
        r.length = fabs(r.t);
        r.size = common_polynomial_size(s->p, common_polynomial_reach(s->k, s->from, r.length));
        r.slope *= -x * x;
        for (int i = 0; i < of->degree; i++)
            r.slope /= x;
    }
    if (s->from_here)
        r.slope *= r.t / of->unit;
    return r;
}

/* Of one that is known for where it is: certainly in the interval, where that is enough? */
static bool is_enough(const search *s, double t)
{
    const double at = (s->base + t) * s->k->unit, off = 0x1p-40 * (fabs(at) + fabs(s->base) * s->k->unit);

    return s->hits->want == POV_WANT_ANY && at - off > s->hits->tmin && at + off + s->hits->slack < s->hits->tmax;
}

/* The sum of the sizes of all terms at a point, with what the ray's distance adds to its coordinates. */
static double sizes_at(const common_polynomial *p, pov_vec3 at, double far)
{
    const pov_vec3 w = pov_vec3_of(fabs(at.x) + far, fabs(at.y) + far, fabs(at.z) + far);

    switch (p->order) {
    case 3: return common_dense_size(p->at, 3, w);
    case 4: return common_dense_size(p->at, 4, w);
    default: return common_polynomial_size(p, pov_largest(w));
    }
}

/* Without its slope. */
static double plain_value(const common_polynomial *p, pov_vec3 at)
{
    pov_vec3 slope;

    switch (p->order) {
    case 2: return common_dense_at(p->at, 2, at).value;
    case 3: return common_dense_at(p->at, 3, at).value;
    case 4: return common_dense_at(p->at, 4, at).value;
    default: return common_polynomial_at(p, at, &slope);
    }
}

/* With a bound of the sizes that is found in no time, or else with the sizes. */
static bool is_good(const search *s, const common_polynomial_root *r)
{
    const pov_two at = pov_two_sum(r->base, r->t);
    const pov_vec3 point = common_polynomial_point(s->k, at);
    const double far = common_far_slack(s->k), reach = pov_largest(point) + far, value = plain_value(s->p, point);
    const double step = common_polynomial_allowed(s->p, at.hi, reach);

    return common_polynomial_trust(s->p, r, value, common_polynomial_size(s->p, reach), step) > 0.0 ||
           common_polynomial_trust(s->p, r, value, sizes_at(s->p, point, far), step) > 0.0;
}

/* The next step of Newton's method: a long stretch makes much of what its coefficients are off by. */
static bool is_good_ahead(const search *s, double *t)
{
    const pov_vec3 point = common_along(s->k, *t);
    const double reach = pov_largest(point) + common_far_slack(s->k);
    pov_vec3 slope;
    const double value = common_polynomial_at(s->p, point, &slope);
    const common_polynomial_root next =
        common_polynomial_step(*t, value, pov_dot(slope, s->k->d), common_polynomial_size(s->p, reach), reach);
    const bool good = is_good(s, &next);

    *t = good ? next.t : *t;
    return good;
}

static bool report(const search *s, const part *of, const common_root *found)
{
    pov_two t = { distance_of(of, found->known ? found->x : found->lo), 0.0 };
    uint32_t flags = 0;

    if (!isfinite(t.hi * s->k->unit))
        return true;
    if (found->known && !is_enough(s, t.hi)) {
        const common_polynomial_root r = root_of(s, of, found->x);

        if (!(of->ahead ? is_good_ahead(s, &t.hi) : is_good(s, &r))) {
            const double one = distance_of(of, found->lo), other = distance_of(of, found->hi);
            const bool rising = found->rising == ((of->size < 0.0) == of->beyond);

            t = common_polynomial_complete(s->p, s->k, &r, pov_min(one, other), pov_max(one, other), rising);
            flags = POV_MARK_ESCALATED;
        }
    }
    return common_polynomial_report(s->k, pov_two_add_double(t, s->base), flags, s->hits);
}

/* Do the ray's crossings end before a local distance, from its start? */
static bool ends_before(const search *s, double t)
{
    return t * s->k->unit * (1.0 - 0x1p-40) > s->hits->tmax + s->hits->slack;
}

/* What a search of a part ends with: OPEN, where double leaves it so. */
typedef enum outcome { OPEN, ENOUGH, MORE } outcome;

/* *left: how many roots there may be. */
static outcome search_part(const search *s, int degree, double size, bool beyond, int *left)
{
    const double *c = s->c + s->from_here;
    double a[MOST], power = 1.0;
    common_roots found;
    part of;

    of.size = size;
    of.unit = 1.0;
    of.degree = degree;
    of.beyond = beyond;
    of.ahead = false;
    of.noise = 0.0;
    for (int i = 0; i <= degree; i++) {
        a[beyond ? degree - i : i] = c[i] * power;
        of.noise += s->off[i + s->from_here] * fabs(power);
        power *= size;
    }
    of.sizes = of.noise / s->p->off;
    common_bernstein(a, degree, of.b);
    if (!common_bernstein_certain(of.b, degree, of.noise, HUGE_VAL, -HUGE_VAL, &found))
        return OPEN;
    *left -= (int)found.count;
    for (uint32_t i = 0; i < found.count; i++)
        if (!report(s, &of, &found.at[i]))
            return ENOUGH;
    return MORE;
}

/* No more roots are ahead, or behind, than the coefficients change their sign there (Descartes' rule), those that are open in the way
 * that makes most of it. */
static int most_roots(const search *s, int degree, bool behind)
{
    const double *c = s->c + s->from_here, *off = s->off + s->from_here;
    bool above = c[0] > 0.0, open = !(fabs(c[0]) > off[0]);
    int changes = 0;

    for (int i = 1; i <= degree; i++) {
        open |= !(fabs(c[i]) > off[i]);
        if (((c[i] > 0.0) != (behind && i % 2 != 0)) != above) {
            above = !above;
            changes++;
        }
    }
    return open ? degree : changes;
}

/* What the coefficients are off by: those of the one polynomial in the largest coordinate that has the sizes of all. */
static void find_off(search *s)
{
    const double reach = common_polynomial_reach(s->k, s->from, 0.0), speed = pov_largest(s->k->d);
    const int n = s->p->order;

    for (int i = 0; i <= n; i++)
        s->off[i] = 0.0;
    for (int m = n; m >= 0; m--) {
        line_times(s->off, n - m, reach, speed);
        s->off[0] += s->p->size[m];
    }
    for (int i = 0; i <= n; i++)
        s->off[i] *= s->p->off;
}

/* The highest power along a direction, of which some components are zero. */
static int degree_along(const common_polynomial *p, pov_vec3 d)
{
    int most = 0;
    uint32_t at = 0;

    for (int i = p->order; i >= 0; i--)
        for (int j = p->order - i; j >= 0; j--)
            for (int k = p->order - i - j; k >= 0; k--, at++) {
                const int degree = (d.x != 0.0 ? i : 0) + (d.y != 0.0 ? j : 0) + (d.z != 0.0 ? k : 0);

                most = p->at[at] != 0.0 && degree > most ? degree : most;
            }
    return most;
}

/* From there on coefficients are zero, and certainly so. */
static int degree_of(const search *s)
{
    int degree = s->p->order;

    while (degree > 0 && s->c[degree] == 0.0)
        degree--;
    if (degree == s->p->order)
        return degree;
    return degree_along(s->p, pov_vec3_of(s->k->d.x != 0.0 ? 1.0 : s->k->d_lo.x, s->k->d.y != 0.0 ? 1.0 : s->k->d_lo.y,
                                          s->k->d.z != 0.0 ? 1.0 : s->k->d_lo.z));
}

/* A start is off the root that it stands for by the first coefficient over the second: what is left of the coefficients once that root is
 * divided out is off by no more than that part of all. False: another root may be meant. */
static bool leave(const double *c, double sizes, double *noise)
{
    if (!(8.0 * (fabs(c[0]) + *noise) * sizes <= c[1] * c[1]))
        return false;
    *noise += 2.0 * fabs(c[0] / c[1]) * sizes;
    return true;
}

/* The same of each coefficient by itself. */
static bool leave_line(search *s)
{
    const double per = 1.0 / s->p->off, start = fabs(s->c[0] / s->c[1]), first = fabs(s->c[0]) + s->off[0];
    double more = 0.0;

    for (int i = s->p->order; i > 1; i--) {
        const double size = s->off[i] * per + more;

        s->off[i] += 2.0 * more;
        more = start * size;
        if (i == 2 && !(8.0 * first * size <= s->c[1] * s->c[1]))
            return false;
    }
    s->off[1] += 2.0 * more;
    return true;
}

/* Is the nearest crossing one of those that were found? What is left lies beyond these. */
static bool has_nearest(const search *s)
{
    const pov_hits *h = s->hits;

    return h->want == POV_WANT_NEAREST && h->count > 0 && h->at->owner == h->owner;
}

static outcome search_line(search *s)
{
    const int degree = degree_of(s) - s->from_here;
    int ahead, behind;
    double size;
    outcome found = MORE;

    if (degree < 1)
        return ENOUGH;
    if (s->from_here && !leave_line(s))
        return OPEN;
    ahead = ends_before(s, s->base) ? 0 : most_roots(s, degree, false);
    behind = s->start < 0.0 ? most_roots(s, degree, true) : 0;
    if (ahead + behind == 0)
        return ENOUGH;
    size = common_polynomial_near(s->c + s->from_here, degree);
    if (behind > 0)
        found = search_part(s, degree, -size, false, &behind);
    if (found == MORE && behind > 0 && s->start < -size)
        found = search_part(s, degree, -size, true, &behind);
    if (found == MORE && has_nearest(s))
        return ENOUGH;
    if (found == MORE && ahead > 0 && !ends_before(s, s->base))
        found = search_part(s, degree, size, false, &ahead);
    if (found == MORE && has_nearest(s))
        return ENOUGH;
    if (found == MORE && ahead > 0 && !ends_before(s, s->base + size))
        found = search_part(s, degree, size, true, &ahead);
    return found;
}

/* In double-double, and not what was found on the way. */
static void escalate(const search *s, const pov_ray *ray, uint32_t count)
{
    if (s->hits->want == POV_WANT_ALL)
        s->hits->count = count;
    common_polynomial_intersect_two(s->p, ray, s->hits);
}

/* Where there are terms of these sizes. The root that a ray starts on is at 0: it is divided out. */
static outcome search_stretch(search *s, double lo, double hi, double sizes)
{
    const double length = hi - lo, per_length = 1.0 / length;
    const common_wanted wanted = common_wants(s->k, lo, 0.0, s->hits);
    common_roots found;
    part of;

    s->base = lo;
    common_polynomial_along(s->p, s->from, pov_scale(s->k->d, length), s->c);
    of.size = of.unit = length;
    of.sizes = sizes;
    of.noise = s->p->off * of.sizes;
    of.degree = s->p->order - s->from_here;
    of.beyond = of.ahead = false;
    if (s->from_here && !leave(s->c, of.sizes, &of.noise))
        return OPEN;
    common_bernstein(s->c + s->from_here, of.degree, of.b);
    if (!common_bernstein_certain(of.b, of.degree, of.noise, wanted.enough * per_length, wanted.within * per_length, &found))
        return OPEN;
    for (uint32_t i = 0; i < found.count; i++)
        if (!report(s, &of, &found.at[i]))
            break;
    return ENOUGH;
}

/* Of what is bounded only the stretch within the box counts. */
static outcome search_box(search *s)
{
    common_span span;
    double lo;

    if (!common_clip(s->k, s->p->box.lo, s->p->box.hi, &span) || span.hi < 0.0 || span.lo * s->k->unit > s->hits->tmax)
        return ENOUGH;
    lo = s->from_here ? 0.0 : span.lo;
    s->from = common_along(s->k, lo);
    return lo < 0x1p40 * s->p->wide ? search_stretch(s, lo, span.hi, s->p->sizes) : OPEN;
}

static outcome search_between(search *s, double lo, double hi)
{
    s->from = common_along(s->k, lo);
    return search_stretch(s, lo, hi, common_polynomial_size(s->p, common_polynomial_reach(s->k, s->from, hi - lo)));
}

/* Roots of a part, from its start on. MORE: none of them is certainly the first that counts. */
static outcome take_roots(const search *s, const part *of, double enough, double within)
{
    common_roots found;

    if (!common_bernstein_certain(of->b, of->degree, of->noise, enough, within, &found))
        return OPEN;
    for (uint32_t i = 0; i < found.count; i++)
        if (!report(s, of, &found.at[i]) || found.at[i].lo >= enough)
            return ENOUGH;
    return MORE;
}

/* From the ray's start on, to a length and beyond it, by coefficients about the start: of a surface about the origin that the ray does not
 * begin far from. OPEN: it may. */
static outcome search_ahead(search *s)
{
    const int order = s->p->order, degree = order - s->from_here;
    const double length = common_polynomial_ahead(s->k), per_length = 1.0 / length;
    const common_wanted wanted = common_wants(s->k, 0.0, 0.0, s->hits);
    part of = { .size = length, .unit = length, .degree = degree, .ahead = true };
    double far[MOST];
    outcome found;

    s->from = common_along(s->k, 0.0);
    common_polynomial_along(s->p, s->from, pov_scale(s->k->d, length), s->c);
    of.sizes = common_polynomial_size(s->p, common_polynomial_reach(s->k, s->from, length));
    of.noise = s->p->off * of.sizes;
    if (!(length > 0.0) || s->c[order] == 0.0 || (s->from_here && !leave(s->c, of.sizes, &of.noise)))
        return OPEN;
    common_bernstein(s->c + s->from_here, degree, of.b);
    found = take_roots(s, &of, wanted.enough * per_length, wanted.within * per_length);
    if (found != MORE || ends_before(s, length))
        return found == OPEN ? OPEN : ENOUGH;
    for (int i = 0; i <= degree; i++)
        far[i] = s->c[order - i];
    of.beyond = true;
    common_bernstein(far, degree, of.b);
    return take_roots(s, &of, HUGE_VAL, -HUGE_VAL);
}

/* On the whole line, about the place nearest to the origin. */
static outcome search_about_middle(search *s)
{
    if (!s->from_here)
        s->base = -pov_dot(pov_two3_hi(s->k->f), s->k->d) / pov_dot(s->k->d, s->k->d);
    s->start = -s->base;
    s->from = common_along(s->k, s->base);
    common_polynomial_along(s->p, s->from, s->k->d, s->c);
    find_off(s);
    return search_line(s);
}

/* Where all roots are asked for, most of them are not the first: those about the middle are found to more digits. */
static outcome search_all(search *s)
{
    const outcome found = s->hits->want == POV_WANT_ALL ? OPEN : search_ahead(s);

    return found == OPEN ? search_about_middle(s) : found;
}

static void begin(search *s, const common_polynomial *p, const common_ray *k, const pov_ray *ray, pov_hits *hits)
{
    s->p = p;
    s->k = k;
    s->base = 0.0;
    s->from_here = ray->origin_surface == hits->owner;
    s->hits = hits;
}

void common_polynomial_intersect_single(const void *self, const pov_ray *ray, pov_hits *hits)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_polynomial *p = self;
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    const uint32_t count = hits->count;
    search s;

    begin(&s, p, &k, ray, hits);
    if (hits->always_exact || (p->bounded ? search_box(&s) : search_all(&s)) == OPEN)
        escalate(&s, ray, count);
}

/* What is searched ahead goes by lanes even alone: lanes decide about a few rays that single ones leave to the search about the middle,
 * whose last bits are other ones. */
void common_polynomial_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const common_polynomial *p = self;

    if (p->bounded || hits->want == POV_WANT_ALL)
        common_polynomial_intersect_single(self, ray, hits);
    else
        common_polynomial_intersect_many(&self, &ray, &hits, 1);
}

void common_polynomial_intersect_between(const void *self, const pov_ray *ray, pov_hits *hits)
{
    static const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const common_polynomial *p = self;
    const common_ray k = common_enter(ray, pov_two3_of(zero, zero), 1.0);
    const uint32_t count = hits->count;
    double lo, hi;
    search s;

    begin(&s, p, &k, ray, hits);
    lo = s.from_here ? 0.0 : hits->tmin * k.per_unit * (1.0 - 0x1p-40);
    hi = hits->tmax * k.per_unit * (1.0 + 0x1p-40);
    if (p->bounded || !isfinite(hi))
        common_polynomial_intersect(self, ray, hits);
    else if (hits->always_exact || search_between(&s, lo, hi) == OPEN)
        escalate(&s, ray, count);
}
