#include "common/sphere.h"

/* Wanted roots, as bits. A ray that left the sphere started on one of its two roots: on the far one if it goes outward,
 * on the near one if it goes inward. */
enum { NEAR_ROOT = 1, FAR_ROOT = 2 };

/* Double-double arithmetic from the start. */
static void escalate(pov_two square, const common_ray *k, bool leaving, pov_hits *hits)
{
    pov_two3 d = common_direction(k), w;
    pov_two a = pov_two3_dot(d, d), fd = pov_two3_dot(k->f, d), b, discriminant, root;
    double middle = -fd.hi / a.hi;
    uint32_t wanted = !leaving ? NEAR_ROOT | FAR_ROOT : fd.hi < 0.0 ? FAR_ROOT : NEAR_ROOT;

    hits->escalated++;
    w = common_along_two(k, middle);
    b = pov_two3_dot(w, d);
    discriminant = pov_two_add(pov_two_mul(b, b), pov_two_mul(a, pov_two_sub(square, pov_two3_dot(w, w))));
    if (!(discriminant.hi >= 0.0))
        return;
    root = pov_two_sqrt(discriminant);
    if (wanted & NEAR_ROOT) {
        pov_two t = pov_two_add_double(pov_two_neg(pov_two_div(pov_two_add(b, root), a)), middle);
        if (!common_report_escalated(hits, t, k->unit, 0, POV_MARK_CLOSED))
            return;
    }
    if (wanted & FAR_ROOT)
        common_report_escalated(hits, pov_two_add_double(pov_two_div(pov_two_sub(root, b), a), middle), k->unit, 1,
                                POV_MARK_CLOSED);
}

static common_residual residual(const void *self, const common_ray *k, pov_two3 w, uint32_t feature)
{
    const pov_two *square = self;

    (void)feature;
    return common_sphere_residual(*square, k, w);
}

/* Double precision with a bound on its error. False: open. */
static bool fast(pov_two square, const common_ray *k, bool leaving, pov_hits *hits)
{
    pov_vec3 f = pov_two3_hi(k->f);
    double fd = pov_dot(f, k->d);
    common_equation equation = { &square, k, residual, 0.0 };
    common_root roots[2];
    common_chord h;

    if (leaving) {
        if (!(fabs(fd) > 8.0 * COMMON_U * common_sum_of_sizes(f, k->d)))
            return false;
        /* A ray that goes outward has the other root behind its start. */
        if (fd > 0.0 && hits->tmin >= 0.0)
            return true;
    }
    if (!common_sphere_is_near(k))
        return false;
    h = common_find_chord(square, k);
    if (h.d < -(h.d_error + 10.0 * COMMON_U * fabs(h.d)))
        return true;
    if (!common_is_cut(&h))
        return false;
    roots[0] = common_near_end(&h);
    roots[1] = common_far_end(&h);
    equation.separation = h.root * h.inverse;
    if (leaving)
        return common_report(roots + (fd < 0.0), 1, COMMON_FINE * COMMON_SLOWEST, &equation, hits);
    return common_report(roots, 2, COMMON_FINE * COMMON_SLOWEST, &equation, hits);
}

void common_sphere_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const common_sphere *s = self;
    bool leaving = ray->origin_surface == hits->owner;
    common_ray k = common_enter(ray, s->centre, common_sphere_scale(s));
    pov_two square = common_sphere_square(s);

    if (hits->always_exact || !fast(square, &k, leaving, hits))
        escalate(square, &k, leaving, hits);
}

void common_sphere_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    *out = pov_unit(common_sphere_offset(self, ray, at));
}
