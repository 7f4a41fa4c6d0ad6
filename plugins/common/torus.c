/* A torus and one ray: the quartic's roots are isolated, and completed in double-double. */
#include "common/torus.h"

/* A ray passes a pole of a spindle so near; crossings there are within the window of it. */
static const double near_pole = 0x1p-26, window = 0x1p-20;

/* The quartic in double-double, and its errors. */
static double coefficients_two(const stretch *s, pov_two a[5])
{
    const torus *t = s->torus;
    const pov_two3 w = s->w, dir = common_direction(&s->ray);
    const pov_two3 d = { pov_two_mul_double(dir.x, s->half), pov_two_mul_double(dir.y, s->half), pov_two_mul_double(dir.z, s->half) };
    const pov_two dd = pov_two3_dot(d, d), b = pov_two_scale(pov_two3_dot(w, d), 2.0);
    const pov_two g = pov_two_add(pov_two3_dot(w, w), t->hollow), four = pov_two_scale(t->ring, 4.0);
    const pov_two fd = pov_two_add(pov_two_mul(d.x, d.x), pov_two_mul(d.z, d.z));
    const pov_two fb = pov_two_scale(pov_two_add(pov_two_mul(w.x, d.x), pov_two_mul(w.z, d.z)), 2.0);
    const pov_two fw = pov_two_add(pov_two_mul(w.x, w.x), pov_two_mul(w.z, w.z));
    const double size = dd.hi + fabs(b.hi) + fw.hi + w.y.hi * w.y.hi + t->ring.hi + t->r * t->r;

    a[4] = pov_two_mul(dd, dd);
    a[3] = pov_two_scale(pov_two_mul(dd, b), 2.0);
    a[2] = pov_two_sub(pov_two_add(pov_two_scale(pov_two_mul(dd, g), 2.0), pov_two_mul(b, b)), pov_two_mul(four, fd));
    a[1] = pov_two_sub(pov_two_scale(pov_two_mul(b, g), 2.0), pov_two_mul(four, fb));
    a[0] = pov_two_sub(pov_two_mul(g, g), pov_two_mul(four, fw));
    return 0x1p-97 * size * size + 64.0 * s->lost;
}

/* Newton's method in double-double, kept in the bracket: a single step as a rule. */
pov_two common_torus_complete(const stretch *s, double start, const common_bracket *root)
{
    double lo = root->lo, hi = root->hi;
    pov_two x = { start, 0.0 };

    for (int turn = 0; turn < 100; turn++) {
        const pov_two3 p = common_along_dd(&s->ray, distance_at(s, x));
        const pov_two value = value_at(s->torus, p);
        int last;
        const double step = step_at(s, slope_at(s, p), value.hi, &last);

        *((value.hi > 0.0) == root->rising ? &hi : &lo) = x.hi;
        if (!(x.hi + step >= lo && x.hi + step <= hi)) {
            if (!(hi - lo > 0x1p-60))
                break;
            x = pov_two_of(0.5 * (lo + hi), 0.0);
            continue;
        }
        x = pov_two_add_double(x, step);
        if (last)
            break;
    }
    return x;
}

/* Newton's method for the outer sheet of a spindle alone, rho from the axis: p.p = 2 R rho - (R^2 - r^2). Near a pole the
 * equation of both sheets is nearly a square. */
static pov_two refine_outer(const stretch *s, pov_two t)
{
    for (int turn = 0; turn < 4; turn++) {
        const pov_two3 p = common_along_dd(&s->ray, t);
        const pov_vec3 at = pov_two3_hi(p), d = s->ray.d;
        const pov_two rho = pov_two_sqrt(pov_two_add(pov_two_mul(p.x, p.x), pov_two_mul(p.z, p.z)));
        const pov_two level = pov_two_add(pov_two3_dot(p, p), s->torus->hollow);
        const double value = pov_two_sub(level, pov_two_mul_double(rho, 2.0 * s->torus->R)).hi;
        const double slope = 2.0 * (pov_dot(at, d) - s->torus->R * (at.x * d.x + at.z * d.z) / rho.hi), step = -value / slope;

        if (!(rho.hi < near_pole && fabs(step) < near_pole))
            break;
        t = pov_two_add_double(t, step);
    }
    return t;
}

/* A distance so small may be an exact zero. */
static const double at_start = 0x1p-60;

/* Newton's method ends where no bit of a double changes: a step more, so that only what double-double loses is lost. */
static pov_two sharpen(const stretch *s, pov_two t)
{
    const pov_two3 p = common_along_dd(&s->ray, t);
    const double step = -0.5 * value_at(s->torus, p).hi / slope_at(s, p) * s->half;

    return fabs(step) < at_start * s->half ? pov_two_add_double(t, step) : t;
}

/* At the distance t in local units. False: no more crossings are wanted. */
bool common_torus_report(const stretch *s, pov_two t, bool rising, bool escalated, pov_hits *hits)
{
    const bool is_near = fabs(t.hi) < at_start;
    const pov_mark mark = { rising ? EXITING : ENTERING, escalated || is_near ? POV_MARK_ESCALATED : 0, 0.0, 0.0 };
    double at;

    if (is_near || hits->always_exact)
        t = sharpen(s, t);
    if (s->torus->lens.hi > 0.0 && is_in_lens(s->torus, common_along_dd(&s->ray, t)))
        return true;
    if (s->torus->lens.hi >= 0.0)
        t = refine_outer(s, t);
    at = t.hi * s->ray.unit;
    return pov_cross(hits, at, t.lo * s->ray.unit, mark) && !(hits->want == POV_WANT_NEAREST && at > hits->tmin && hits->count > 0);
}

bool common_torus_wants_first(const torus *t, const pov_hits *hits)
{
    return hits->want != POV_WANT_ALL && !hits->always_exact && !(t->lens.hi > 0.0);
}

static common_range wanted_of(const stretch *s, const pov_hits *hits)
{
    static const common_range all = { -HUGE_VAL, HUGE_VAL, HUGE_VAL, false };

    return common_torus_wants_first(s->torus, hits) ? range_of(s, hits->tmin, hits->tmax + hits->slack) : all;
}

/* Where any crossing will do, does one certainly lie in the interval? Its distance need not be known. */
bool common_torus_is_blocked(const stretch *s, const common_bracket *root, common_range wanted, pov_hits *hits)
{
    const pov_mark mark = { root->rising ? EXITING : ENTERING, 0, 0.0, 0.0 };
    const double least = (s->middle + root->lo * s->half) * s->ray.unit, most = (s->middle + root->hi * s->half) * s->ray.unit;

    return hits->want == POV_WANT_ANY && wanted.first && root->lo > wanted.ahead &&
           most * (1.0 + 0x1p-40) + hits->slack < hits->tmax && !pov_cross(hits, least, 0.0, mark);
}

/* ---- from the surface ---- */

/* Taylor's shift and a scaling: the cubic in y where x = middle + y half. */
static void restrict_cubic(pov_two c[4], pov_two middle, pov_two half)
{
    pov_two power = half;
    int i, j;

    for (j = 0; j < 3; j++)
        for (i = 2; i >= j; i--)
            c[i] = pov_two_add(c[i], pov_two_mul(c[i + 1], middle));
    for (i = 1; i < 4; i++) {
        c[i] = pov_two_mul(c[i], power);
        power = pov_two_mul(power, half);
    }
}

/* Divide out the root that the ray starts on, and isolate those of the cubic that remains. */
static void isolate_two(search *r)
{
    pov_two a[5], c[4];
    double error = coefficients_two(&r->s, a), sum = 0.0;
    int i;

    if (!r->from_here) {
        common_isolate_two(a, error, 4, &r->roots);
        return;
    }
    c[3] = a[4];
    for (i = 2; i >= 0; i--)
        c[i] = pov_two_add(a[i + 1], pov_two_mul(c[i + 1], r->start));
    restrict_cubic(c, r->middle, r->half);
    for (i = 0; i < 4; i++) {
        r->cubic[i] = c[i].hi;
        sum += fabs(c[i].hi);
    }
    common_isolate_two(c, 64.0 * error + 0x1p-96 * sum, 3, &r->roots);
}

/* The same in double. The start lies in -1..1, so no coefficient of the cubic is off by more than 4 times the errors of
 * those of the quartic, and none after the shift by more than 8 times these. False: open. */
static bool isolate(search *r)
{
    const double start = r->start.hi, middle = r->middle.hi, half = r->half.hi, *a = r->a;
    double *c = r->cubic, sum = 0.0, power = half;
    int i, j;

    if (!r->from_here)
        return common_isolate(a, r->error, 4, r->wanted, &r->roots);
    for (i = 0; i < 5; i++)
        sum += fabs(a[i]);
    c[3] = a[4];
    for (i = 2; i >= 0; i--)
        c[i] = a[i + 1] + c[i + 1] * start;
    for (j = 0; j < 3; j++)
        for (i = 2; i >= j; i--)
            c[i] += c[i + 1] * middle;
    for (i = 1; i < 4; i++) {
        c[i] *= power;
        power *= half;
    }
    return fabs(start) <= 1.0 && common_isolate(c, 64.0 * (r->error + 8.0 * COMMON_U * sum), 3, r->wanted, &r->roots);
}

/* ---- the poles of a spindle ----
 *
 * Its two sheets meet in two points of the axis, and where the radii are equal the torus touches itself in its middle. So near to
 * one that the roots of both sheets pass for one that touches zero, sides tell where the outer sheet is crossed: around what is
 * outside there it is a convex cone, so once at most on either side of the place that is farthest outside. */

static bool is_inside_at(const stretch *s, double x)
{
    const pov_two3 p = common_along_dd(&s->ray, distance_at(s, pov_two_of(x, 0.0)));

    return is_in_lens(s->torus, p) || value_at(s->torus, p).hi <= 0.0;
}

/* The change of sides between lo and hi, to the last bit: outside, so that it is not taken for one of the inner sheet. */
static double find_change(const stretch *s, double lo, double hi, bool before)
{
    for (double middle = 0.5 * (lo + hi); middle > lo && middle < hi; middle = 0.5 * (lo + hi))
        *(is_inside_at(s, middle) == before ? &lo : &hi) = middle;
    return before ? hi : lo;
}

/* The root of the outer sheet at x. In y, where the ray starts on the torus. */
static void put_root(search *r, double x, bool rising)
{
    const double at = r->from_here ? (x - r->middle.hi) / r->half.hi : x;
    const common_bracket root = { at, at, at, rising };
    uint32_t i = r->roots.count;

    if (i == COMMON_ROOTS_MAX)
        return;
    for (; i > 0 && r->roots.at[i - 1].lo >= at; i--)
        r->roots.at[i] = r->roots.at[i - 1];
    r->roots.at[i] = root;
    r->roots.count++;
}

/* Forget the roots between lo and hi. */
static void drop_between(search *r, double lo, double hi)
{
    uint32_t kept = 0;

    for (uint32_t i = 0; i < r->roots.count; i++) {
        const common_bracket at = common_torus_bracket(r, i);
        bool is_between = at.lo <= hi && at.hi >= lo;

        if (is_between) {
            const double x = common_torus_complete(&r->s, common_torus_start(r, i), &at).hi;

            is_between = x >= lo && x <= hi;
        }
        if (!is_between)
            r->roots.at[kept++] = r->roots.at[i];
    }
    r->roots.count = kept;
}

/* Near a pole the outer sheet is a cone, and the ray is farthest outside of it where p.p grows by as much as 2 R rho. */
static double find_outmost(const stretch *s, double x)
{
    const pov_vec3 d = pov_scale(s->ray.d, s->half), p = pov_two3_hi(common_along_dd(&s->ray, distance_at(s, pov_two_of(x, 0.0))));
    const double across = d.x * d.x + d.z * d.z, nearest = -(p.x * d.x + p.z * d.z) / across;
    const double rho = fabs(p.x * d.z - p.z * d.x) / sqrt(across), share = pov_dot(p, d) / (s->torus->R * sqrt(across));
    const double off = nearest + rho * share / sqrt((1.0 - share * share) * across);

    return fabs(off) < window ? x + off : x;
}

static void cross_between(search *r, double lo, double hi)
{
    const bool before = is_inside_at(&r->s, lo);

    if (is_inside_at(&r->s, hi) != before)
        put_root(r, find_change(&r->s, lo, hi, before), before);
}

static void cross_pole(search *r, double height)
{
    const stretch *s = &r->s;
    const pov_vec3 d = pov_scale(s->ray.d, s->half), up = pov_sub(pov_vec3_of(0.0, height, 0.0), pov_two3_hi(s->w));
    const double x = pov_dot(up, d) / pov_dot(d, d);
    const pov_vec3 off = pov_sub(up, pov_scale(d, x));
    double outmost;

    if (!(pov_dot(off, off) < near_pole * near_pole) || (r->from_here && !(x - r->start.hi > 4.0 * window)))
        return;
    outmost = find_outmost(s, x);
    drop_between(r, x - 2.0 * window, x + 2.0 * window);
    cross_between(r, x - 2.0 * window, outmost);
    cross_between(r, outmost, x + 2.0 * window);
}

/* Isolates the roots: those that count, if double does. */
void common_torus_begin(search *r, bool from_here, pov_hits *hits)
{
    r->from_here = from_here;
    r->wanted = wanted_of(&r->s, hits);
    r->roots.count = 0;
    if (from_here) {
        r->wanted.from = r->wanted.ahead = -HUGE_VAL;
        r->wanted.to = HUGE_VAL;
        r->wanted.first = r->wanted.first && hits->tmin <= 0.0;
        r->start = pov_two_div(pov_two_of(-r->s.middle, 0.0), pov_two_of(r->s.half, 0.0));
        r->middle = pov_two_scale(pov_two_add_double(r->start, 1.0), 0.5);
        r->half = pov_two_scale(pov_two_sub(pov_two_of(1.0, 0.0), r->start), 0.5);
        if (!(r->half.hi > 0.0))
            return;
    }
    r->escalated = hits->always_exact || !isolate(r);
    hits->escalated += r->escalated;
    if (!r->escalated)
        return;
    isolate_two(r);
    if (r->s.torus->lens.hi >= 0.0)
        cross_pole(r, sqrt(r->s.torus->lens.hi));
    if (r->s.torus->lens.hi > 0.0)
        cross_pole(r, -sqrt(r->s.torus->lens.hi));
}

/* The bracket of a root in x. Ahead of the start the divided-out factor is positive, so the quartic rises where the cubic
 * does. */
common_bracket common_torus_bracket(const search *r, uint32_t i)
{
    const common_bracket *y = &r->roots.at[i];
    const common_bracket x = { r->middle.hi + r->half.hi * y->lo, r->middle.hi + r->half.hi * y->hi, 0.0, y->rising };

    return r->from_here ? x : *y;
}

/* Where it is about. */
double common_torus_start(const search *r, uint32_t i)
{
    if (!r->from_here)
        return common_polish(r->a, 4, &r->roots.at[i]);
    return pov_two_add(r->middle, pov_two_mul_double(r->half, common_polish(r->cubic, 3, &r->roots.at[i]))).hi;
}

/* Reports the crossings from the i-th on. */
void common_torus_finish(const search *r, uint32_t i, pov_hits *hits)
{
    for (; i < r->roots.count; i++) {
        const common_bracket x = common_torus_bracket(r, i);

        pov_two t;

        if (common_torus_is_blocked(&r->s, &x, r->wanted, hits))
            return;
        t = distance_at(&r->s, common_torus_complete(&r->s, common_torus_start(r, i), &x));
        if (!common_torus_report(&r->s, t, x.rising, r->escalated, hits))
            return;
    }
}

void common_torus_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    search r;

    if (!enter(&r.s, self, ray))
        return;
    r.error = coefficients(&r.s, r.a);
    common_torus_begin(&r, ray->origin_surface == hits->owner, hits);
    common_torus_finish(&r, 0, hits);
}

void common_torus_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    *out = pov_unit(normal_at(self, ray, at->t, at->t_lo));
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}
