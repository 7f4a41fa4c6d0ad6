#include "kit/ball.h"

/* Wanted roots, as bits. A ray that left the sphere started on one of its two roots: on the far one if it goes outward,
 * on the near one if it goes inward. */
enum { NEAR_ROOT = 1, FAR_ROOT = 2 };

/* Double-double arithmetic from the start. */
static void decide(pov_two square, const kit_ray *k, bool leaving, pov_hits *hits)
{
    pov_two3 d = kit_direction(k), w;
    pov_two a = pov_two3_dot(d, d), fd = pov_two3_dot(k->f, d), b, discriminant, root;
    double middle = -fd.hi / a.hi;
    uint32_t wanted = !leaving ? NEAR_ROOT | FAR_ROOT : fd.hi < 0.0 ? FAR_ROOT : NEAR_ROOT;

    hits->decided++;
    w = kit_along_two(k, middle);
    b = pov_two3_dot(w, d);
    discriminant = pov_two_add(pov_two_mul(b, b), pov_two_mul(a, pov_two_sub(square, pov_two3_dot(w, w))));
    if (!(discriminant.hi >= 0.0))
        return;
    root = pov_two_sqrt(discriminant);
    if (wanted & NEAR_ROOT) {
        pov_two t = pov_two_add_double(pov_two_neg(pov_two_div(pov_two_add(b, root), a)), middle);
        if (!kit_report_decided(hits, t, k->unit, 0, POV_MARK_CLOSED))
            return;
    }
    if (wanted & FAR_ROOT)
        kit_report_decided(hits, pov_two_add_double(pov_two_div(pov_two_sub(root, b), a), middle), k->unit, 1,
                           POV_MARK_CLOSED);
}

static kit_residual residual(const void *self, const kit_ray *k, pov_two3 w, uint32_t part)
{
    const pov_two *square = self;

    (void)part;
    return kit_ball_residual(*square, k, w);
}

/* Double precision with a bound on its error. False: open. */
static bool quick(pov_two square, const kit_ray *k, bool leaving, pov_hits *hits)
{
    pov_vec3 f = pov_two3_hi(k->f);
    double fd = pov_dot(f, k->d);
    kit_equation equation = { &square, k, residual, 0.0 };
    kit_root roots[2];
    kit_chord h;

    if (leaving) {
        if (!(fabs(fd) > 8.0 * KIT_U * kit_sum_of_sizes(f, k->d)))
            return false;
        /* A ray that goes outward has the other root behind its start. */
        if (fd > 0.0 && hits->tmin >= 0.0)
            return true;
    }
    if (!kit_ball_is_near(k))
        return false;
    h = kit_find_chord(square, k);
    if (h.d < -(h.d_error + 10.0 * KIT_U * fabs(h.d)))
        return true;
    if (!kit_is_cut(&h))
        return false;
    roots[0] = kit_near_end(&h);
    roots[1] = kit_far_end(&h);
    equation.apart = h.root * h.inverse;
    if (leaving)
        return kit_report(roots + (fd < 0.0), 1, KIT_FINE * KIT_SLOWEST, &equation, hits);
    return kit_report(roots, 2, KIT_FINE * KIT_SLOWEST, &equation, hits);
}

void kit_ball_intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const kit_ball *s = self;
    bool leaving = ray->left == hits->owner;
    kit_ray k = kit_enter(ray, s->centre, kit_ball_scale(s));
    pov_two square = kit_ball_square(s);

    if (hits->always_exact || !quick(square, &k, leaving, hits))
        decide(square, &k, leaving, hits);
}

void kit_ball_normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    *out = pov_unit(kit_ball_offset(self, ray, at));
}
