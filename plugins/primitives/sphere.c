/* sphere { <centre>, radius }
 *
 * The ray is re-centred at its closest approach to the centre, where the roots are as large as the sphere
 * and not as the distance. docs/numerics.md derives the bounds. */
#include "kit/affine.h"
#include "kit/lanes.h"
#include "kit/report.h"

/* A line of memory: what intersect() wants besides is made from these two as fast as it is fetched. */
typedef struct sphere {
    pov_two3 centre;
    pov_two radius;
} sphere;

typedef struct sphere_text { pov_vec3 centre; double radius; } sphere_text;

/* Lengths times this, a power of two, bring the radius into [1, 2). */
static inline double scale_of(const sphere *s) { return pov_inverse_power(s->radius.hi); }

/* The square of the scaled radius. */
static inline pov_two square_of(const sphere *s)
{
    pov_two r = pov_two_scale(s->radius, scale_of(s));
    return pov_two_mul(r, r);
}

static void parse(void *self, const pov_host *host, pov_reader *in)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    sphere_text *text = self;
    pov_vec3 centre;
    double radius;

    host->vector(in, &centre);
    host->accept(in, ",");
    if (host->more(in)) {
        radius = host->number(in);
    } else if (centre.x != centre.y || centre.y != centre.z) {
        radius = host->number(in);   /* fails: what was read is a centre */
    } else {
        host->warn(in, "a sphere without a centre stands about the origin");
        radius = centre.x;
        centre = zero;
    }
    if (radius < 0.0) {
        host->warn(in, "a negative radius is taken as positive");
        radius = -radius;
    }
    text->centre = centre;
    text->radius = radius;
}

static void prepare(void *self, const void *written)
{
    const pov_vec3 zero = { 0.0, 0.0, 0.0 };
    const sphere_text *text = written;
    sphere *s = self;

    s->centre = pov_two3_of(text->centre, zero);
    s->radius = pov_two_of(text->radius, 0.0);
}

static void interval(pov_two centre, pov_two radius, double *lo, double *hi)
{
    *lo = kit_below(pov_two_sub(centre, radius).hi);
    *hi = kit_above(pov_two_add(centre, radius).hi);
}

static bool bounds(const void *self, pov_box *out)
{
    const sphere *s = self;

    interval(s->centre.x, s->radius, &out->lo.x, &out->hi.x);
    interval(s->centre.y, s->radius, &out->lo.y, &out->hi.y);
    interval(s->centre.z, s->radius, &out->lo.z, &out->hi.z);
    return true;
}

/* Roots that are wanted, as bits. A ray that left the sphere started on one of its two roots: going
 * outward on the far one, going inward on the near one. */
enum { NEAR_ROOT = 1, FAR_ROOT = 2 };

/* Two-part arithmetic from the start. */
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
        if (!kit_report_decided(hits, t, k->unit, 0))
            return;
    }
    if (wanted & FAR_ROOT)
        kit_report_decided(hits, pov_two_add_double(pov_two_div(pov_two_sub(root, b), a), middle), k->unit, 1);
}

KIT_INLINE kit_residual residual_at(pov_two square, const kit_ray *k, pov_two3 w)
{
    kit_residual r;

    r.value = pov_two_sub(pov_two3_dot(w, w), square).hi;
    r.error = 0x1p-100 * square.hi;
    r.half_slope = pov_dot(pov_two3_hi(w), k->d);
    r.slope_error = 6.0 * KIT_U * kit_sum_of_sizes(pov_two3_hi(w), k->d);
    return r;
}

static kit_residual residual(const void *self, const kit_ray *k, pov_two3 w, uint32_t part)
{
    const pov_two *square = self;

    (void)part;
    return residual_at(*square, k, w);
}

/* The chord that a sphere cuts out of a ray, in double: its middle, and the middle's remaining distance b; the discriminant
 * with a bound on its error; and, where that is above zero for certain, its root and a bound on the error of both ends. */
typedef struct chord { double middle, inverse, b, d, d_error, root, error; } chord;

static inline chord find_chord(pov_two square, const kit_ray *k)
{
    const double u = KIT_U;
    const double a = pov_dot(k->d, k->d);
    pov_vec3 w;
    double ww, b_error, c, c_error;
    chord h;

    h.inverse = 1.0 / a;
    h.middle = -pov_dot(pov_two3_hi(k->f), k->d) * h.inverse;
    w = kit_along(k, h.middle);
    ww = pov_dot(w, w);
    h.b = pov_dot(w, k->d);
    c = square.hi - ww;
    b_error = 10.0 * u * kit_sum_of_sizes(w, k->d) + u * u * a;
    c_error = u * (square.hi + 6.0 * ww);
    h.d = c * a + h.b * h.b;
    h.d_error = c_error * a + 2.0 * fabs(h.b) * b_error + b_error * b_error;
    h.root = sqrt(h.d);
    h.error = (b_error + 0.52 * h.d_error / h.root + u * (13.0 * h.root + 9.0 * fabs(h.b))) * h.inverse;
    return h;
}

/* Are there two ends for certain? */
static inline bool is_cut(const chord *h) { return h->d > 16.0 * h->d_error; }

static inline kit_root near_end(const chord *h)
{
    kit_root r = { pov_two_sum(h->middle, (-h->b - h->root) * h->inverse), h->error, 0, 0 };
    return r;
}

static inline kit_root far_end(const chord *h)
{
    kit_root r = { pov_two_sum(h->middle, (-h->b + h->root) * h->inverse), h->error, 1, 0 };
    return r;
}

/* Re-centring to one part is exact enough. */
static inline bool is_near(const kit_ray *k) { return pov_largest(pov_two3_hi(k->f)) < KIT_FAR; }

/* Double precision with a bound on its error. False: open. */
static bool quick(pov_two square, const kit_ray *k, bool leaving, pov_hits *hits)
{
    pov_vec3 f = pov_two3_hi(k->f);
    double fd = pov_dot(f, k->d);
    kit_equation equation = { &square, k, residual, 0.0 };
    kit_root roots[2];
    chord h;

    if (leaving) {
        if (!(fabs(fd) > 8.0 * KIT_U * kit_sum_of_sizes(f, k->d)))
            return false;
        /* Outward, the other root is behind. */
        if (fd > 0.0 && hits->tmin >= 0.0)
            return true;
    }
    if (!is_near(k))
        return false;
    h = find_chord(square, k);
    if (h.d < -(h.d_error + 10.0 * KIT_U * fabs(h.d)))
        return true;
    if (!is_cut(&h))
        return false;
    roots[0] = near_end(&h);
    roots[1] = far_end(&h);
    equation.apart = h.root * h.inverse;
    if (leaving)
        return kit_report(roots + (fd < 0.0), 1, KIT_FINE * KIT_SLOWEST, &equation, hits);
    return kit_report(roots, 2, KIT_FINE * KIT_SLOWEST, &equation, hits);
}

static void intersect(const void *self, const pov_ray *ray, pov_hits *hits)
{
    const sphere *s = self;
    bool leaving = ray->left == hits->owner;
    kit_ray k = kit_enter(ray, s->centre, scale_of(s));
    pov_two square = square_of(s);

    if (hits->always_exact || !quick(square, &k, leaving, hits))
        decide(square, &k, leaving, hits);
}

/* From the centre to the crossing, scaled. */
static inline pov_vec3 offset(const sphere *s, const pov_ray *ray, const pov_crossing *at)
{
    kit_ray k = kit_enter(ray, s->centre, scale_of(s));

    return pov_two3_hi(kit_point(&k, at));
}

static void normal(const void *self, const pov_ray *ray, const pov_crossing *at, pov_vec3 *out)
{
    *out = pov_unit(offset(self, ray, at));
}

static bool inside(const void *self, pov_vec3 point, pov_vec3 point_lo)
{
    const sphere *s = self;
    pov_two3 w = kit_offset(point, point_lo, s->centre, scale_of(s));

    return pov_two_less(pov_two3_dot(w, w), square_of(s));
}

static bool absorb(void *self, const pov_affine *map)
{
    sphere *s = self;
    pov_two factor;

    if (!kit_is_similarity(map, &factor))
        return false;
    s->centre = kit_map_point(map, s->centre);
    s->radius = pov_two_mul(s->radius, factor);
    return true;
}

/* ---- many at once ---- */

/* Spheres, each with its ray and, for its normal, a crossing. */
typedef struct sphere_lanes {
    kit_rays rays;
    kit_lane3 centre, centre_lo;
    kit_lane radius, radius_lo, t, t_lo, tmin;
} sphere_lanes;

static inline void put_sphere(sphere_lanes *l, uint32_t i, const sphere *s)
{
    kit_put(&l->centre, i, pov_two3_hi(s->centre));
    kit_put(&l->centre_lo, i, pov_two3_lo(s->centre));
    l->radius[i] = s->radius.hi;
    l->radius_lo[i] = s->radius.lo;
}

static inline sphere get_sphere(const sphere_lanes *l, uint32_t i)
{
    sphere s;

    s.centre = pov_two3_of(kit_get(&l->centre, i), kit_get(&l->centre_lo, i));
    s.radius = pov_two_of(l->radius[i], l->radius_lo[i]);
    return s;
}

/* Where rays come in, or, of those that start within, where they leave: that end of the chord in the shape's units, what it
 * may be off by, and half the chord; then bounds on the distance, and the distance. */
typedef struct end_lanes {
    kit_lane root, root_lo, error, apart;
    kit_lane lo, hi, t, t_lo;
    int64_t part[KIT_LANES];
    int64_t good[KIT_LANES];     /* is it found well enough? */
} end_lanes;

static inline void put_end(end_lanes *restrict out, uint32_t i, const kit_root *r, double unit, int good)
{
    const double slack = kit_slack(r);

    out->lo[i] = (r->t.hi - slack) * unit;
    out->hi[i] = (r->t.hi + slack) * unit;
    out->t[i] = r->t.hi * unit;
    out->t_lo[i] = r->t.lo * unit;
    out->good[i] = good & (int)kit_is_fine(r, KIT_FINE * KIT_SLOWEST);
}

KIT_CLONES static void find_ends(const sphere_lanes *restrict l, end_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < KIT_LANES; i++) {
        const sphere s = get_sphere(l, i);
        const pov_ray ray = kit_get_ray(&l->rays, i);
        const kit_ray k = kit_enter(&ray, s.centre, scale_of(&s));
        const chord h = find_chord(square_of(&s), &k);
        const kit_root near = near_end(&h), far = far_end(&h);
        const int within = (near.t.hi + kit_slack(&near)) * k.unit < l->tmin[i];
        const kit_root r = { { within ? far.t.hi : near.t.hi, within ? far.t.lo : near.t.lo }, h.error, 0, 0 };
        const int sound = (int)is_near(&k) & (int)is_cut(&h);

        out->root[i] = r.t.hi;
        out->root_lo[i] = r.t.lo;
        out->error[i] = sound ? r.error : NAN;
        out->apart[i] = h.root * h.inverse;
        out->part[i] = within;
        put_end(out, i, &r, k.unit, sound);
    }
}

/* The step that kit_report() takes where double was not fine enough. */
KIT_CLONES static void refine_ends(const sphere_lanes *restrict l, end_lanes *restrict out)
{
    uint32_t i;

    for (i = 0; i < KIT_LANES; i++) {
        const sphere s = get_sphere(l, i);
        const pov_ray ray = kit_get_ray(&l->rays, i);
        const kit_ray k = kit_enter(&ray, s.centre, scale_of(&s));
        const double error = out->error[i], apart = out->apart[i];
        kit_root r = { { out->root[i], out->root_lo[i] }, 0.0, 0, 0 };
        const kit_residual f = residual_at(square_of(&s), &k, kit_along_two_parts(&k, r.t));
        const double step = kit_root_step(&f);
        const int good = (int)(error <= KIT_APART * apart) & (int)(fabs(step) <= 2.0 * error) & (int)(fabs(r.t.hi) > error);

        r.error = kit_root_step_error(&f, step, apart);
        r.t = pov_two_add_double(r.t, step);
        put_end(out, i, &r, k.unit, good);
    }
}

/* Whoever does not leave the sphere, and comes to this end of the chord within the interval for certain. */
static inline bool is_answered(const end_lanes *e, uint32_t i, const pov_ray *ray, const pov_hits *h)
{
    return e->lo[i] <= h->tmax && e->hi[i] >= h->tmin && e->t[i] > h->tmin && h->want != POV_WANT_ALL && !h->always_exact
           && h->owner != ray->left;
}

/* Of these lanes, bit by bit; those that are still to be asked are returned. */
static uint32_t report_ends(const end_lanes *e, uint32_t lanes, const pov_ray *const *rays, pov_hits *const *hits)
{
    uint32_t left = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = kit_first_lane(lanes);

        if (e->good[i] && is_answered(e, i, rays[i], hits[i]))
            pov_cross(hits[i], e->t[i], e->t_lo[i], kit_mark((uint32_t)e->part[i], 0));
        else
            left |= 1u << i;
    }
    return left;
}

/* Those whom a step would help: to look for any crossing none is needed. */
static uint32_t worth_a_step(const end_lanes *e, uint32_t lanes, const pov_ray *const *rays, pov_hits *const *hits)
{
    uint32_t worth = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t i = kit_first_lane(lanes);

        if (!e->good[i] && hits[i]->want != POV_WANT_ANY && is_answered(e, i, rays[i], hits[i]))
            worth |= 1u << i;
    }
    return worth;
}

static void intersect_lanes(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    sphere_lanes lanes;
    end_lanes end;
    uint32_t i, j, left, worth;

    for (i = 0; i < KIT_LANES; i++) {
        j = kit_lane_of(i, n);
        kit_put_ray(&lanes.rays, i, rays[j]);
        put_sphere(&lanes, i, selves[j]);
        lanes.tmin[i] = hits[j]->tmin;
    }
    find_ends(&lanes, &end);
    left = report_ends(&end, (1u << n) - 1, rays, hits);
    worth = worth_a_step(&end, left, rays, hits);
    if (worth) {
        refine_ends(&lanes, &end);
        left = (left & ~worth) | report_ends(&end, worth, rays, hits);
    }
    for (; left; left &= left - 1) {
        i = kit_first_lane(left);
        intersect(selves[i], rays[i], hits[i]);
    }
}

static void intersect_many(const void *const *selves, const pov_ray *const *rays, pov_hits *const *hits, uint32_t n)
{
    uint32_t i;

    for (; n >= KIT_LEAST; n -= i, selves += i, rays += i, hits += i) {
        i = n < KIT_LANES ? n : KIT_LANES;
        intersect_lanes(selves, rays, hits, i);
    }
    for (i = 0; i < n; i++)
        intersect(selves[i], rays[i], hits[i]);
}

/* Normals, and how large they were before they were unit: pov_unit() scales the very large and the very small. */
KIT_CLONES static void find_normals(const sphere_lanes *restrict l, kit_lane3 *restrict out, double *restrict largest)
{
    uint32_t i;

    for (i = 0; i < KIT_LANES; i++) {
        sphere s = get_sphere(l, i);
        pov_ray ray = kit_get_ray(&l->rays, i);
        pov_crossing at;
        pov_vec3 w;
        double length;

        at.t = l->t[i];
        at.t_lo = l->t_lo[i];
        w = offset(&s, &ray, &at);
        length = sqrt(pov_dot(w, w));
        largest[i] = pov_largest(w);
        kit_put(out, i, pov_vec3_of(w.x / length, w.y / length, w.z / length));
    }
}

static void normals_of(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                       pov_vec3 *const *out, uint32_t n)
{
    sphere_lanes lanes;
    kit_lane3 unit;
    kit_lane largest;
    uint32_t i, j;

    for (i = 0; i < KIT_LANES; i++) {
        j = kit_lane_of(i, n);
        kit_put_ray(&lanes.rays, i, rays[j]);
        put_sphere(&lanes, i, selves[j]);
        lanes.t[i] = at[j]->t;
        lanes.t_lo[i] = at[j]->t_lo;
    }
    find_normals(&lanes, &unit, largest);
    for (i = 0; i < n; i++)
        if (largest[i] > 1e-100 && largest[i] < 1e100)
            *out[i] = kit_get(&unit, i);
        else
            normal(selves[i], rays[i], at[i], out[i]);
}

static void normal_many(const void *const *selves, const pov_ray *const *rays, const pov_crossing *const *at,
                        pov_vec3 *const *out, uint32_t n)
{
    uint32_t i;

    for (; n >= KIT_LEAST; n -= i, selves += i, rays += i, at += i, out += i) {
        i = n < KIT_LANES ? n : KIT_LANES;
        normals_of(selves, rays, at, out, i);
    }
    for (i = 0; i < n; i++)
        normal(selves[i], rays[i], at[i], out[i]);
}

/* ---- blocks ---- */

typedef struct sphere_block {
    double x[POV_BLOCK_MAX], y[POV_BLOCK_MAX], z[POV_BLOCK_MAX];
    double inner[POV_BLOCK_MAX], outer[POV_BLOCK_MAX]; /* the radius, less and more what centre and radius lost */
    double square[POV_BLOCK_MAX];   /* of outer, rounded up; below all for lanes without a sphere */
    double most;    /* the largest outer */
    double reach;   /* no centre is further from the origin, by sum of sizes */
    int64_t lanes;  /* those that hold a sphere */
} sphere_block;

static bool block_pack(void *block, const void *const *selves, uint32_t n)
{
    sphere_block *b = block;
    uint32_t i;

    b->reach = b->most = 0.0;
    b->lanes = (1 << n) - 1;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const sphere *s = selves[i < n ? i : 0];
        pov_vec3 c = pov_two3_hi(s->centre);
        double far = fabs(c.x) + fabs(c.y) + fabs(c.z), lost = KIT_U * (2.0 * s->radius.hi + 2.0 * far);

        if (!kit_block_range(pov_largest(c)) || !kit_block_size(s->radius.hi))
            return false;
        b->x[i] = c.x;
        b->y[i] = c.y;
        b->z[i] = c.z;
        b->inner[i] = s->radius.hi - lost;
        b->outer[i] = s->radius.hi + lost;
        b->square[i] = i < n ? b->outer[i] * b->outer[i] * (1.0 + 12.0 * KIT_U) : -HUGE_VAL;
        b->most = fmax(b->most, b->outer[i]);
        b->reach = fmax(b->reach, far);
    }
    return true;
}

/* A lane that the line of the ray comes near to: where, and whether it is met. */
static inline void bound_lane(const sphere_block *s, uint32_t i, double middle, double ww, double slack,
                              double per_length, double tmin, double tmax, pov_block_answer *out)
{
    double outer = s->outer[i] + slack, inner = s->inner[i] - slack;
    double far = outer * outer * (1.0 + 8.0 * KIT_U) - ww, near = inner * inner * (1.0 - 8.0 * KIT_U) - ww;
    double wide = (sqrt(far) * (1.0 + 8.0 * KIT_U) + slack) * per_length;
    double shift = 8.0 * KIT_U * fabs(middle), narrow;
    int within;

    out->lo[i] = middle - wide - shift;
    if (!(out->lo[i] <= tmax && middle + wide + shift >= tmin))
        return;
    out->maybe |= 1u << i;
    if (!(inner > 0.0 && near > 0.0))
        return;
    narrow = (sqrt(near) * (1.0 - 8.0 * KIT_U) - slack) * per_length;
    if (!(narrow > 0.0))
        return;
    /* Who starts within comes to the far end. */
    within = middle - narrow + shift < tmin;
    out->lo[i] = within ? middle + narrow - shift : out->lo[i];
    out->hi[i] = within ? middle + wide + shift : middle - narrow + shift;
    if (out->lo[i] > tmin && out->hi[i] < tmax)
        out->surely |= 1u << i;
}

/* All of it in plain double. The point of closest approach is off by less than 16 u times the distance
 * from origin to centre, in each of its uses; radii that much smaller and larger make the answer safe. Most
 * blocks are passed by on every lane: that is found out first, for all lanes at once. */
KIT_CLONES static void block_filter(const void *block, const pov_ray *ray, double tmin, double tmax,
                                    pov_block_answer *out)
{
    const sphere_block *s = block;
    const pov_vec3 o = ray->org, d = ray->dir;
    const double a = pov_dot(d, d), inverse = 1.0 / a;
    const double slack = 18.0 * KIT_U * (fabs(o.x) + fabs(o.y) + fabs(o.z) + s->reach);
    double middle[POV_BLOCK_MAX], ww[POV_BLOCK_MAX], depth[POV_BLOCK_MAX], per_length;
    const int64_t bit[POV_BLOCK_MAX] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    int64_t met = 0;
    uint32_t i;

    if (!(a > 1e-200 && a < 1e200 && slack < 1e100)) {
        kit_block_decline(tmin, out);
        return;
    }
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        double x = o.x - s->x[i], y = o.y - s->y[i], z = o.z - s->z[i], outer = s->outer[i] + slack, wx, wy, wz;
        middle[i] = -(x * d.x + y * d.y + z * d.z) * inverse;
        wx = x + middle[i] * d.x;
        wy = y + middle[i] * d.y;
        wz = z + middle[i] * d.z;
        ww[i] = wx * wx + wy * wy + wz * wz;
        depth[i] = outer * outer * (1.0 + 8.0 * KIT_U) - ww[i];
        met |= depth[i] >= 0.0 ? bit[i] : 0;
    }
    out->maybe = out->surely = 0;
    met &= s->lanes;
    if (!met)
        return;
    per_length = sqrt(inverse);
    for (; met; met &= met - 1) {
        i = kit_first_lane((uint32_t)met);
        bound_lane(s, i, middle[i], ww[i], slack, per_length, tmin, tmax, out);
    }
}

/* The lanes whose spheres the line of a ray may come near to, with its closest approach to each. The square of a sum with
 * the slack is at most the square of the one and what the slack adds to the largest. */
static inline uint32_t near_lines(const sphere_block *s, const pov_rays *rays, uint32_t at, double slack,
                                  double *restrict middle, double *restrict ww)
{
    const double ox = rays->org[0][at], oy = rays->org[1][at], oz = rays->org[2][at];
    const double dx = rays->dir[0][at], dy = rays->dir[1][at], dz = rays->dir[2][at];
    const double inverse = -rays->inverse[at], more = slack * (2.0 * s->most + slack) * (1.0 + 12.0 * KIT_U);
    const int64_t bit[POV_BLOCK_MAX] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    int64_t met = 0;
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const double x = ox - s->x[i], y = oy - s->y[i], z = oz - s->z[i];
        const double m = kit_sum_of(z, dz, kit_sum_of(y, dy, x * dx)) * inverse;
        const double wx = kit_sum_of(m, dx, x), wy = kit_sum_of(m, dy, y), wz = kit_sum_of(m, dz, z);

        middle[i] = m;
        ww[i] = kit_sum_of(wz, wz, kit_sum_of(wy, wy, wx * wx));
        met |= ww[i] <= s->square[i] + more ? bit[i] : 0;
    }
    return (uint32_t)met;
}

KIT_CLONES static uint64_t block_filter_many(const void *block, const pov_rays *rays, uint64_t lanes,
                                             pov_block_answer *out)
{
    const sphere_block *s = block;
    double middle[POV_BLOCK_MAX], ww[POV_BLOCK_MAX];
    uint64_t met = 0;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t at = kit_first_lane64(lanes);
        const double slack = 18.0 * KIT_U * (rays->size[at] + s->reach);
        uint32_t near = near_lines(s, rays, at, slack, middle, ww);

        if (!near)
            continue;
        out[at].maybe = out[at].surely = 0;
        for (; near; near &= near - 1) {
            const uint32_t i = kit_first_lane(near);
            bound_lane(s, i, middle[i], ww[i], slack, rays->per_length[at], 0.0, rays->tmax[at], &out[at]);
        }
        if (out[at].maybe)
            met |= (uint64_t)1 << at;
    }
    return met;
}

static const pov_shape_class sphere_class = {
    .size = sizeof(pov_shape_class),
    .flags = POV_SHAPE_SOLID | POV_SHAPE_CONVEX,
    .keyword = "sphere",
    .instance_size = sizeof(sphere),
    .parse = parse,
    .bounds = bounds,
    .intersect = intersect,
    .normal = normal,
    .inside = inside,
    .absorb = absorb,
    .block_size = sizeof(sphere_block),
    .block_pack = block_pack,
    .block_filter = block_filter,
    .text_size = sizeof(sphere_text),
    .prepare = prepare,
    .intersect_many = intersect_many,
    .normal_many = normal_many,
    .block_filter_many = block_filter_many,
};

static const pov_shape_class *const shapes[] = { &sphere_class, NULL };

POV_PLUGIN(sphere) = {
    .abi = POV_PLUGIN_ABI,
    .size = sizeof(pov_plugin),
    .name = "sphere",
    .version = "1",
    .shapes = shapes,
};
