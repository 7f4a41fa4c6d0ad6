#include "common/quadric_block.h"
#include "common/quadric_approx.h"

/* Along a ray a quadric is a t^2 + 2 b t + c. Where the ray's origin is too far for that, the equation is taken about the
 * ray's own vertex, where b is nearly zero and the discriminant does not cancel. The coefficients are double-double, so
 * that maps can be absorbed. */

typedef common_quadric quadric;

/* ---- in double-double ---- */

static bool report_escalated(pov_hits *hits, pov_two t, double unit, uint32_t feature, uint32_t flags)
{
    return !isfinite(t.hi) || common_report_escalated(hits, t, unit, feature, flags);
}

/* Wanted crossings. A ray that left the surface started on one of the two: on the exit if it goes to larger values,
 * else on the entry. */
enum { WANT_ENTRY = 1, WANT_EXIT = 2 };

/* a . b with both scaled by `power`; a zero stays zero. */
static pov_two fast_square(pov_two3 a, pov_two3 b, double power)
{
    const pov_two zero = { 0.0, 0.0 };
    const pov_two x = b.x.hi != 0.0 ? pov_two_mul(pov_two_scale(a.x, power), pov_two_scale(b.x, power)) : zero;
    const pov_two y = b.y.hi != 0.0 ? pov_two_mul(pov_two_scale(a.y, power), pov_two_scale(b.y, power)) : zero;
    const pov_two z = b.z.hi != 0.0 ? pov_two_mul(pov_two_scale(a.z, power), pov_two_scale(b.z, power)) : zero;

    return pov_two_add(pov_two_add(x, y), z);
}

/* The point where the equation is taken: the ray's vertex, where the discriminant does not cancel. If the vertex is
 * much further away than the ray's closest approach to the anchor, as for a ray almost along the axis of a paraboloid,
 * then the closest approach. */
static double middle_of(const quadric *s, const common_ray *k)
{
    const pov_two3 d = common_direction(k);
    const double nearest = -pov_dot(pov_two3_hi(k->f), k->d) / pov_dot(k->d, k->d);
    const pov_vec3 w = common_along(k, nearest);
    const double a = pov_two3_dot(d, common_half_gradient(s->q, d, false)).hi;
    const double vertex = nearest - along_first(s->approx, w, k->d) / a;

    return fabs(vertex - nearest) < 1024.0 * pov_largest(w) ? vertex : nearest;
}

/* A root so near to the ray's origin that the distance from `middle` nearly cancels: -c / (b + or - root), with the
 * value c at the origin itself. */
static pov_two near_origin(const quadric *s, const common_ray *k, pov_two root)
{
    const pov_two c = common_exact_value(s->q, k->f),
        b = pov_two3_dot(common_direction(k), common_half_gradient(s->q, k->f, true));

    return pov_two_neg(pov_two_div(c, b.hi < 0.0 ? pov_two_sub(b, root) : pov_two_add(b, root)));
}

/* Convert a root from `middle` to the origin. */
static pov_two from_origin(const quadric *s, const common_ray *k, double middle, pov_two t, pov_two root)
{
    const pov_two sum = pov_two_add_double(t, middle);

    return fabs(sum.hi) < 0x1p-24 * fabs(middle) ? near_origin(s, k, root) : sum;
}

/* Both roots, as distances from `middle`, and half of their distance times the second-order coefficient. */
typedef struct solution { pov_two entry, exit, root; } solution;

/* False: the ray misses. A missing root is infinite. */
static bool solve(const quadric *s, const common_ray *k, double middle, solution *out)
{
    const pov_two3 d = common_direction(k), w = common_along_two(k, middle), g = common_half_gradient(s->q, w, true);
    const pov_two3 turn = common_half_gradient(s->q, d, false);
    /* A ray along a straight line of the surface changes its distance so slowly that squares may underflow: its
     * direction is scaled by `power`. */
    const double power = pov_inverse_power(pov_max(pov_largest(pov_two3_hi(turn)), fabs(pov_two3_dot(d, g).hi)));
    const pov_two a = fast_square(d, turn, power), b = pov_two_scale(pov_two3_dot(d, g), power);
    const pov_two c = common_value(s->q, w, g);
    const pov_two discriminant = pov_two_sub(pov_two_mul(b, b), pov_two_mul(a, c));
    pov_two root, sum, entry = { HUGE_VAL, 0.0 }, exit = { HUGE_VAL, 0.0 };

    if (!(discriminant.hi >= 0.0))
        return false;
    root = pov_two_sqrt(discriminant);
    sum = b.hi < 0.0 ? pov_two_sub(root, b) : pov_two_neg(pov_two_add(b, root));
    if (sum.hi != 0.0) {
        const pov_two direct = pov_two_div(c, sum), other = a.hi != 0.0 ? pov_two_div(sum, a) : entry;
        entry = b.hi < 0.0 ? direct : other;
        exit = b.hi < 0.0 ? other : direct;
    } else if (a.hi != 0.0) {
        entry = exit = sum;
    }
    out->entry = pov_two_scale(entry, power);
    out->exit = pov_two_scale(exit, power);
    out->root = pov_two_scale(root, 1.0 / power);
    return true;
}

/* Additional distance to a root that is much nearer to the anchor than w is; 0 for none. */
static double to_anchor(const common_ray *k, double middle, const solution *roots)
{
    const double here = pov_largest(common_along(k, middle));
    const double at_entry = isfinite(roots->entry.hi) ? pov_largest(common_along(k, middle + roots->entry.hi))
        : HUGE_VAL;
    const double at_exit = isfinite(roots->exit.hi) ? pov_largest(common_along(k, middle + roots->exit.hi)) : HUGE_VAL;
    const double there = at_entry < at_exit ? roots->entry.hi : roots->exit.hi;

    return isfinite(there) && pov_min(at_entry, at_exit) < 0x1p-4 * here ? there : 0.0;
}

/* Is the value at a crossing zero, as far as its point is known? A discriminant of coefficients that are too far apart may
 * be noise alone. */
static bool is_plausible(const quadric *s, const common_ray *k, pov_two t)
{
    const pov_two3 p = common_along_dd(k, t);
    const double lost = 0x1p-96 * pov_largest(pov_two3_hi(k->f));
    const pov_vec3 size = sizes(pov_two3_hi(p), lost), off = pov_vec3_of(lost, lost, lost);
    const double value = common_value(s->q, p, common_half_gradient(s->q, p, true)).hi;

    return fabs(value) <= 0x1p-80 * along_value(s->size, size) + 2.0 * along_first(s->size, size, off);
}

static void escalate(const quadric *s, const common_ray *k, bool leaving, pov_hits *hits)
{
    double middle = middle_of(s, k), further;
    uint32_t wanted = WANT_ENTRY | WANT_EXIT;
    solution roots;

    hits->escalated++;
    if (leaving) {
        const double rise = pov_two3_dot(common_direction(k), common_half_gradient(s->q, k->f, true)).hi;
        wanted = rise > 0.0 ? WANT_ENTRY : rise < 0.0 ? WANT_EXIT : 0;
    }
    if (!solve(s, k, middle, &roots))
        return;
    /* Recompute near the apex of a cone, where all numbers are small; seen from further off they would be small
     * differences. */
    further = to_anchor(k, middle, &roots);
    middle += further;
    if (further != 0.0 && !solve(s, k, middle, &roots))
        return;
    roots.entry = from_origin(s, k, middle, roots.entry, roots.root);
    roots.exit = from_origin(s, k, middle, roots.exit, roots.root);
    if (s->stiff)
        wanted &= (is_plausible(s, k, roots.entry) ? WANT_ENTRY : 0) | (is_plausible(s, k, roots.exit) ? WANT_EXIT : 0);
    if (wanted & WANT_ENTRY && !report_escalated(hits, roots.entry, k->unit, ENTERING, quadric_mark(s)))
        return;
    if (wanted & WANT_EXIT)
        report_escalated(hits, roots.exit, k->unit, EXITING, quadric_mark(s));
}

/* ---- in double ---- */

/* Each term is a product of at most four rounded factors and passes through at most six sums. */
static along measure(const quadric *s, const common_ray *k, pov_vec3 w)
{
    const pov_vec3 d_size = sizes(k->d, 0.0), w_size = sizes(w, common_far_slack(k));
    along r;

    r.a = along_second(s->approx, k->d);
    r.b = along_first(s->approx, w, k->d);
    r.c = along_value(s->approx, w);
    r.a_error = 10.0 * COMMON_U * along_second(s->size, d_size);
    r.b_error = 11.0 * COMMON_U * along_first(s->size, w_size, d_size);
    r.c_error = 12.0 * COMMON_U * along_value(s->size, w_size);
    return r;
}

static common_root root_of(double middle, double t, double error, uint32_t feature, uint32_t flags)
{
    common_root r;

    r.t = pov_two_sum(middle, t);
    r.error = error;
    r.feature = feature;
    r.flags = flags;
    return r;
}

static common_residual residual(const void *self, const common_ray *k, pov_two3 w, uint32_t feature)
{
    (void)feature;
    return quadric_residual(self, k, w);
}

static bool fast_plane(const quadric *s, const common_ray *k, pov_hits *hits)
{
    const pov_two3 n = { s->q[G], s->q[H], s->q[I] };
    const plane_along a = along_plane(n, s->q[J], k);
    const common_root root = plane_cross(&a);
    common_verdict verdict;

    if (!plane_is_sound(&a))
        return false;
    verdict = common_judge(&root, k->unit, HUGE_VAL, hits);
    if (verdict == COMMON_GOOD)
        pov_cross(hits, root.t.hi * k->unit, root.t.lo * k->unit, common_mark(a.slope.hi < 0.0 ? ENTERING : EXITING, 0));
    return verdict != COMMON_OPEN;
}

static bool fast_curved(const quadric *s, const common_ray *k, const along *r, double middle, uint32_t wanted,
                        pov_hits *hits)
{
    const double d = discriminant_of(r), d_error = discriminant_error(r);
    common_equation equation = { s, k, residual, 0.0 };
    double root, error, entry, exit, size;
    common_root roots[2];
    uint32_t n = 0, i;

    if (d < -2.0 * d_error)
        return true;
    if (!is_cut(r, d, d_error))
        return false;
    root = sqrt(d);
    entry = (-r->b - root) / r->a;
    exit = (-r->b + root) / r->a;
    error = roots_error(r, root, d_error);
    for (i = 0; i < 2; i++) {
        const bool is_entry = (i == 0) == (r->a > 0.0);
        const double t = is_entry ? entry : exit;

        if (wanted & (is_entry ? WANT_ENTRY : WANT_EXIT))
            roots[n++] = root_of(middle, t, root_error(r, t, error),
                                 is_entry ? ENTERING : EXITING, quadric_mark(s));
    }
    equation.separation = root / fabs(r->a);
    size = s->sizeless ? pov_largest(pov_two3_hi(k->f)) : 1.0;
    return common_report(roots, n, pov_min(COMMON_FINE * COMMON_SLOWEST * size, COMMON_SEPARATION * equation.separation),
                         &equation, hits);
}

/* Coefficients of one sign have no positive root. If one root is the start, which is left out, the other has the sign
 * of -b / a, whatever remains of c there. */
static bool is_behind(const along *r, bool leaving, double tmin)
{
    const double sign = r->b > 0.0 ? 1.0 : -1.0;

    return tmin >= 0.0 && sign * r->b > r->b_error && sign * r->a > r->a_error && (leaving || sign * r->c > r->c_error);
}

/* Double precision with bounds, at the ray's origin and, if that is not enough, at its vertex. False: open. */
static bool fast(const quadric *s, const common_ray *k, bool leaving, pov_hits *hits)
{
    uint32_t wanted = WANT_ENTRY | WANT_EXIT;
    along r;
    double middle;

    if (s->planar)
        return fast_plane(s, k, hits);
    r = measure_at_origin(s, k);
    if (is_behind(&r, leaving, hits->tmin))
        return true;
    if (leaving) {
        if (!(fabs(r.b) > r.b_error)
            && !(fabs(r.b) > 22.0 * COMMON_U * along_first(s->size, sizes(pov_two3_hi(k->f), 0.0), sizes(k->d, 0.0))))
            return false;
        wanted = r.b > 0.0 ? WANT_ENTRY : WANT_EXIT;
    }
    if (fast_curved(s, k, &r, 0.0, wanted, hits))
        return true;
    middle = -r.b / r.a;
    if (!isfinite(middle))
        return false;
    r = measure(s, k, common_along(k, middle));
    return fast_curved(s, k, &r, middle, wanted, hits);
}

void common_quadric_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const quadric *s = self;
    const bool leaving = ray->origin_surface == hits->owner;
    common_ray k;

    /* A plane is not hit again. */
    if (leaving && s->planar)
        return;
    k = common_enter(ray, s->anchor, s->scale);
    if (hits->always_exact || !fast(s, &k, leaving, hits))
        escalate(s, &k, leaving, hits);
}

static pov_vec3 gradient(const quadric *s, const pov_ray *ray, const pov_crossing *at)
{
    pov_two3 p, g;
    double step;
    common_ray k;

    if (s->planar)
        return pov_vec3_of(s->approx[G], s->approx[H], s->approx[I]);
    k = common_enter(ray, s->anchor, s->scale);
    p = common_point(&k, at);
    g = fast_half_gradient(s->q, p);
    step = step_to(s, &k, p, g);
    if (!(fabs(step) < QUADRIC_STEP * (s->sizeless ? pov_largest(pov_two3_hi(p)) : 1.0)))
        step = 0.0;
    return gradient_beyond(s, &k, g, step);
}

/* Where the gradient vanishes, at the apex of a cone, no normal is better than another. */
void common_quadric_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    *out = pov_unit(gradient(self, ray, at));
    if (!(pov_largest(*out) > 0.0))
        *out = pov_scale(pov_unit(ray->dir), -1.0);
}

bool common_quadric_inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const quadric *s = self;
    const pov_two3 p = common_offset(point, point_lo, s->anchor, s->scale), n = { s->q[G], s->q[H], s->q[I] };
    const double about = along_value(s->approx, pov_two3_hi(p));

    if (fabs(about) > value_error(s, pov_largest(pov_two3_hi(p))))
        return about < 0.0;
    /* Bit for bit what the other terms, all zero, would leave of it. */
    if (s->planar)
        return pov_two_add(pov_two3_dot(p, n), s->q[J]).hi <= 0.0;
    return common_value(s->q, p, common_half_gradient(s->q, p, true)).hi <= 0.0;
}

void common_quadric_intersect_pairs(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                    uint32_t n)
{
    common_quadric_intersect_many(selves, rays, hits, n, common_quadric_intersect);
}

void common_quadric_normal_pairs(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                                 pov_vec3 *const *out, uint32_t n)
{
    common_quadric_normal_many(selves, rays, at, out, n, common_quadric_normal);
}
