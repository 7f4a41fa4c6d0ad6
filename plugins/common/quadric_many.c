/* Several pairs of a quadric surface and a ray, side by side: entries, or exits from the surface that a ray starts on,
 * and normals. */
#include "common/lanes.h"
#include "common/quadric_approx.h"

/* Fewer lanes than COMMON_LANES: a shape has many numbers to copy, so unused lanes cost much. */
enum { TOGETHER = 4 };

/* Number of doubles at the start of a shape that rays need, rounded up to a multiple of four. */
#define NUMBER_OF(member) (offsetof(common_quadric, member) / sizeof(double))
enum { NUMBERS = (NUMBER_OF(approx) + 3) / 4 * 4 };

typedef struct pair_lanes {
    common_rays rays;
    double number[NUMBERS][TOGETHER];
} pair_lanes;

static inline pov_two get_two(const pair_lanes *l, uint32_t i, size_t number)
{
    return pov_two_of(l->number[number][i], l->number[number + 1][i]);
}

COMMON_INLINE void get_coefficient(const pair_lanes *l, uint32_t i, int which, common_quadric *s)
{
    s->q[which] = get_two(l, i, NUMBER_OF(q) + 2 * (size_t)which);
    s->approx[which] = s->q[which].hi;
    s->size[which] = fabs(s->q[which].hi);
}

/* Unrolled by hand: a loop here would keep the outer loop from being vectorised. */
COMMON_INLINE common_quadric get_shape(const pair_lanes *l, uint32_t i)
{
    common_quadric s;

    s.anchor.x = get_two(l, i, NUMBER_OF(anchor));
    s.anchor.y = get_two(l, i, NUMBER_OF(anchor) + 2);
    s.anchor.z = get_two(l, i, NUMBER_OF(anchor) + 4);
    get_coefficient(l, i, A, &s);
    get_coefficient(l, i, B, &s);
    get_coefficient(l, i, C, &s);
    get_coefficient(l, i, D, &s);
    get_coefficient(l, i, E, &s);
    get_coefficient(l, i, F, &s);
    get_coefficient(l, i, G, &s);
    get_coefficient(l, i, H, &s);
    get_coefficient(l, i, I, &s);
    get_coefficient(l, i, J, &s);
    s.sum2 = l->number[NUMBER_OF(sum2)][i];
    s.sum1 = l->number[NUMBER_OF(sum1)][i];
    s.scale = l->number[NUMBER_OF(scale)][i];
    return s;
}

/* Bounds on the distance, the distance, and whether it is accurate enough. */
typedef struct end_lanes { common_lane lo, hi, t, t_lo, good; } end_lanes;

/* As the double-precision path at the ray's origin, for a shape whose second order is positive along the ray: the
 * nearer crossing, or the further one for a ray that starts on the nearer. Nearly all need the refinement step. */
COMMON_CLONES static void find_ends(const pair_lanes *restrict l, const double *restrict inward,
                                    end_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const pov_ray ray = common_get_ray(&l->rays, i);
        const common_quadric s = get_shape(l, i);
        const common_ray k = common_enter(&ray, s.anchor, s.scale);
        const along r = measure_at_origin(&s, &k);
        const int is_exit = inward[i] > 0.0;
        const double d = discriminant_of(&r), d_error = discriminant_error(&r), root = sqrt(d);
        const double t = (-r.b + (is_exit ? root : -root)) / r.a, separation = root / fabs(r.a);
        const double error = root_error(&r, t, roots_error(&r, root, d_error));
        const double fine = common_lesser(COMMON_FINE * COMMON_SLOWEST, COMMON_SEPARATION * separation);
        const common_root first = { pov_two_of(t, 0.0), error, 0, 0 };
        const common_residual f = quadric_residual(&s, &k, common_along_dd(&k, first.t));
        const double step = common_root_step(&f);
        const common_root end = { pov_two_add_double(first.t, step), common_root_step_error(&f, step, separation), 0,
                                  0 };
        const int needs_step = (int)!common_is_fine(&first, fine) & (int)(error <= COMMON_SEPARATION * separation)
                               & (int)(fabs(step) <= 2.0 * error) & (int)(fabs(t) > error);
        const double slack = common_slack(&end);

        out->lo[i] = (end.t.hi - slack) * k.unit;
        out->hi[i] = (end.t.hi + slack) * k.unit;
        out->t[i] = end.t.hi * k.unit;
        out->t_lo[i] = end.t.lo * k.unit;
        out->good[i] = is_cut(&r, d, d_error) & (int)(r.a > 0.0) & (!is_exit | (int)(-r.b > r.b_error)) & needs_step
                               & (int)common_is_fine(&end, fine)
                           ? 1.0
                           : 0.0;
    }
}

static inline bool is_answered(const end_lanes *e, uint32_t i, const pov_ray *ray, const pov_hits *h)
{
    return e->good[i] > 0.0 && e->lo[i] <= h->tmax && e->hi[i] >= h->tmin && e->t[i] > h->tmin
           && h->want == POV_WANT_NEAREST && !h->always_exact &&
               (h->owner != ray->origin_surface || common_is_inward(ray, h));
}

/* Pairs of shapes that are neither flat nor without a size. */
static void intersect_lanes(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n,
                            common_intersect *one)
{
    const void *shapes[TOGETHER];
    const pov_ray *some[TOGETHER];
    common_lane inward;
    pair_lanes lanes;
    end_lanes end;
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const uint32_t j = common_lane_of(i, n);

        shapes[i] = selves[j];
        some[i] = rays[j];
        inward[i] = common_is_inward(rays[j], hits[j]) ? 1.0 : 0.0;
    }
    common_put_four_shapes(lanes.number[0], TOGETHER, NUMBERS, shapes);
    common_put_four_rays(&lanes.rays, 0, some);
    find_ends(&lanes, inward, &end);
    for (i = 0; i < n; i++) {
        const common_quadric *s = selves[i];

        if (is_answered(&end, i, rays[i], hits[i]) && !s->planar && !s->sizeless)
            pov_cross(hits[i], end.t[i], end.t_lo[i],
                      common_mark(inward[i] > 0.0 ? EXITING : ENTERING, quadric_mark(s)));
        else
            one(s, rays[i], hits[i]);
    }
}

void common_quadric_intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits,
                                   uint32_t n, common_intersect *one)
{
    uint32_t i;

    for (; n > 1; n -= i, selves += i, rays += i, hits += i) {
        i = n < TOGETHER ? n : TOGETHER;
        intersect_lanes(selves, rays, hits, i, one);
    }
    if (n)
        one(selves[0], rays[0], hits[0]);
}

/* ---- normals ---- */

/* good: not zero where the refinement step applies, and pov_unit() does not scale. */
COMMON_CLONES static void find_normals(const pair_lanes *restrict l, const double *restrict t,
                                       const double *restrict t_lo, common_lane3 *restrict out, double *restrict good)
{
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const pov_ray ray = common_get_ray(&l->rays, i);
        const common_quadric s = get_shape(l, i);
        const common_ray k = common_enter(&ray, s.anchor, s.scale);
        const pov_two3 p = common_along_dd(&k, pov_two_of(t[i] * k.per_unit, t_lo[i] * k.per_unit));
        const pov_two3 g = fast_half_gradient(s.q, p);
        const double step = step_to(&s, &k, p, g);
        const pov_vec3 w = gradient_beyond(&s, &k, g, step);
        const double length = sqrt(pov_dot(w, w)), largest = pov_largest(w);

        good[i] = (int)(fabs(step) < QUADRIC_STEP) & (int)(largest > 1e-100) & (int)(largest < 1e100) ? 1.0 : 0.0;
        common_put(out, i, pov_vec3_of(w.x / length, w.y / length, w.z / length));
    }
}

static void normals_of(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                       pov_vec3 *const *out, uint32_t n, common_normal *one)
{
    const void *shapes[TOGETHER];
    const pov_ray *some[TOGETHER];
    const pov_crossing *crossings[TOGETHER];
    common_lane t, t_lo, good;
    pair_lanes lanes;
    common_lane3 unit;
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const uint32_t j = common_lane_of(i, n);

        shapes[i] = selves[j];
        some[i] = rays[j];
        crossings[i] = at[j];
    }
    common_put_four_crossings(t, t_lo, 0, crossings);
    common_put_four_shapes(lanes.number[0], TOGETHER, NUMBERS, shapes);
    common_put_four_rays(&lanes.rays, 0, some);
    find_normals(&lanes, t, t_lo, &unit, good);
    for (i = 0; i < n; i++) {
        const common_quadric *s = selves[i];

        if (good[i] > 0.0 && !s->planar && !s->sizeless)
            *out[i] = common_get(&unit, i);
        else
            one(s, rays[i], at[i], out[i]);
    }
}

void common_quadric_normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                                pov_vec3 *const *out, uint32_t n, common_normal *one)
{
    uint32_t i;

    for (; n > 1; n -= i, selves += i, rays += i, at += i, out += i) {
        i = n < TOGETHER ? n : TOGETHER;
        normals_of(selves, rays, at, out, i, one);
    }
    if (n)
        one(selves[0], rays[0], at[0], out[0]);
}
