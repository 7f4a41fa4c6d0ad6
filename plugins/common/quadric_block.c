/* Along a ray that starts p from the anchor, with direction d, the equation is a t^2 + 2 b t + c. All three
 * coefficients are taken at the ray's own start, and their errors from sums of sizes: docs/numerics.md derives the
 * bounds. */
#include "common/quadric_block.h"

#include "common/simd.h"

#include <float.h>

/* Each of a, b and c is off by less than this part of the sum of its terms' sizes. */
#define ERROR_UNIT (20.0 * COMMON_U)
/* Reported crossings are off by less than this part of their distance, with all roundings here. */
#define WIDER (24.0 * COMMON_U)

/* ---- packing ---- */

static bool put(common_quadric_block *b, uint32_t lane, const common_quadric *s)
{
    const pov_vec3 anchor = pov_two3_hi(s->anchor);
    const double length = 1.0 / s->scale, first = s->planar ? 1.0 : length,
        value = s->planar ? length : length * length;
    int i;

    if (!(length > 1e-60 && length < 1e60 && pov_largest(anchor) < 1e60)
        || !(s->planar ? s->sum1 > 0x1p-8 && s->sum1 < 0x1p8 : s->sum2 > 0x1p-8 && s->sum2 < 0x1p8))
        return false;
    for (i = 0; i < COEFFICIENTS; i++)
        b->q[i][lane] = s->approx[i] * (i < D ? 1.0 : i < G ? 0.5 : i < J ? 0.5 * first : value);
    b->anchor[0][lane] = anchor.x;
    b->anchor[1][lane] = anchor.y;
    b->anchor[2][lane] = anchor.z;
    b->reach[lane] = pov_largest(anchor) + 1e-60;
    b->sum2[lane] = s->planar ? 0.0 : s->sum2;
    b->half1[lane] = 0.5 * s->sum1 * first;
    b->sum0[lane] = s->size[J] * value;
    return true;
}

/* Is it an ellipsoid, with a box? Only speed depends on it, so the signs need no certainty. */
static bool is_ellipsoid(const common_quadric *s)
{
    const double *q = s->approx, d = 0.5 * q[D], e = 0.5 * q[E], f = 0.5 * q[F], minor = q[A] * q[B] - d * d;

    return q[A] > 0.0 && minor > 0.0
           && q[C] * minor + 2.0 * d * e * f - q[A] * f * f - q[B] * e * e > 0.0;
}

/* Hosts filter ellipsoids in leaves of a tree by themselves: blocks of ellipsoids need no filter here. */
bool common_quadric_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    common_quadric_block *b = block;
    uint32_t bounded = 0, i;

    (void)frame;
    for (i = 0; i < n; i++)
        bounded += is_ellipsoid(selves[i]);
    if (bounded == n)
        return false;
    b->lanes = (1 << n) - 1;
    b->planar = true;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const common_quadric *s = selves[i < n ? i : 0];

        if (!put(b, i, s))
            return false;
        b->planar = b->planar && s->planar;
    }
    return true;
}

/* ---- asking ---- */

/* A ray, and upper bounds of the largest components of its start and of its direction. */
typedef struct line { pov_vec3 o, d; double far, speed, tmax; } line;

/* Squares of coefficients must not overflow, nor may the differences from the error bounds underflow. */
static inline bool is_ordinary(double far, double speed) { return far < 1e60 && speed > 1e-80 && speed < 1e80; }

/* By lane: coefficients, negated where b is negative; the discriminant; and an error bound of each. */
typedef struct found {
    double a[POV_BLOCK_MAX], b[POV_BLOCK_MAX], c[POV_BLOCK_MAX], d[POV_BLOCK_MAX];
    double a_error[POV_BLOCK_MAX], b_error[POV_BLOCK_MAX], c_error[POV_BLOCK_MAX], d_error[POV_BLOCK_MAX];
} found;

static inline double three(double a, double b, double c, double x, double y, double z, double more)
{
    return common_sum_of(c, z, common_sum_of(b, y, common_sum_of(a, x, more)));
}

/* Lanes that are not definite misses: their discriminant may be positive, and their coefficients are not all of one
 * sign, which excludes positive roots. */
static inline uint32_t find(const common_quadric_block *s, const line *l, uint32_t n, found *restrict f)
{
    const double dx = l->d.x, dy = l->d.y, dz = l->d.z, square = l->speed * l->speed;
    const double xx = dx * dx, yy = dy * dy, zz = dz * dz, xy = 2.0 * dx * dy, xz = 2.0 * dx * dz, yz = 2.0 * dy * dz;
    const int64_t bit[POV_BLOCK_MAX] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    int64_t missed = 0;
    uint32_t i;

    for (i = 0; i < n; i++) {
        const double x = l->o.x - s->anchor[0][i], y = l->o.y - s->anchor[1][i], z = l->o.z - s->anchor[2][i];
        const double gx = three(s->q[A][i], s->q[D][i], s->q[E][i], x, y, z, s->q[G][i]);
        const double gy = three(s->q[D][i], s->q[B][i], s->q[F][i], x, y, z, s->q[H][i]);
        const double gz = three(s->q[E][i], s->q[F][i], s->q[C][i], x, y, z, s->q[I][i]);
        const double mixed = three(s->q[D][i], s->q[E][i], s->q[F][i], xy, xz, yz, 0.0);
        const double a = three(s->q[A][i], s->q[B][i], s->q[C][i], xx, yy, zz, mixed);
        const double b = three(gx, gy, gz, dx, dy, dz, 0.0);
        const double c = three(gx + s->q[G][i], gy + s->q[H][i], gz + s->q[I][i], x, y, z, s->q[J][i]);
        const double far = l->far + s->reach[i], first = common_sum_of(s->sum2[i], far, s->half1[i]);
        const double value = common_sum_of(first + s->half1[i], far, s->sum0[i]);
        const double a_size = b < 0.0 ? -a : a, c_size = b < 0.0 ? -c : c, d = common_sum_of(b, b, -a * c);
        const double a_error = ERROR_UNIT * s->sum2[i] * square, b_error = ERROR_UNIT * first * l->speed,
            c_error = ERROR_UNIT * value;
        const double d_error = 2.5 * ERROR_UNIT * common_sum_of(first, first, s->sum2[i] * value) * square;

        f->a[i] = a_size, f->b[i] = fabs(b), f->c[i] = c_size, f->d[i] = d;
        f->a_error[i] = a_error, f->b_error[i] = b_error, f->c_error[i] = c_error, f->d_error[i] = d_error;
        missed |= ((d < -d_error) | ((fabs(b) > b_error) & (c_size > c_error) & (a_size >= a_error))) ? bit[i] : 0;
    }
    return (uint32_t)(s->lanes & ~missed);
}

/* Bounds on a root as a distance. */
typedef struct bounds { double lo, hi; } bounds;

/* -c / m, for m between two positive values. */
static inline bounds near_root(double c, double error, double least, double most)
{
    const double down = -c - error, up = error - c;
    bounds r = { down / (down < 0.0 ? least : most), up / (up < 0.0 ? most : least) };

    r.lo -= WIDER * fabs(r.lo);
    r.hi += WIDER * fabs(r.hi);
    return r;
}

/* -m / a where that may be positive; a wide interval if the sign of a is uncertain, and an empty one if a is zero. */
static inline bounds other_root(double a, double error, double least, double most)
{
    bounds r = { HUGE_VAL, HUGE_VAL };

    if (a <= error && error > 0.0)
        r.lo = least / (fabs(a) + error) * (1.0 - WIDER);
    if (a < -error)
        r.hi = most / (-a - error) * (1.0 + WIDER);
    return r;
}

static inline bool may_be_within(bounds r, double end) { return !(r.lo > end || r.hi < 0.0); }
static inline bool is_within(bounds r, const line *l) { return r.lo > 0.0 && r.hi < l->tmax; }

/* Let m = |b| + the discriminant's root. The roots are -c / m and -m / a, with all signs as for a positive b. */
static inline void bound_lane(const found *f, uint32_t i, const line *l, common_result *out)
{
    const double end = common_lesser(l->tmax, DBL_MAX), root_most = sqrt(f->d[i] + f->d_error[i]);
    const bool is_real = f->d[i] > f->d_error[i];
    const double root_least = is_real ? sqrt(f->d[i] - f->d_error[i]) : 0.0;
    const double least = (f->b[i] - f->b_error[i] + root_least) * (1.0 - 8.0 * COMMON_U);
    const double most = (f->b[i] + f->b_error[i] + root_most) * (1.0 + 8.0 * COMMON_U);
    bounds one = { -HUGE_VAL, HUGE_VAL }, other = one;
    bool one_is_hit, other_is_hit;

    if (least > 0.0) {
        one = near_root(f->c[i], f->c_error[i], least, most);
        other = other_root(f->a[i], f->a_error[i], least, most);
    }
    one_is_hit = may_be_within(one, end);
    other_is_hit = may_be_within(other, end);
    if (!one_is_hit && !other_is_hit)
        return;
    out->maybe |= 1u << i;
    out->lo[i] = one_is_hit && other_is_hit ? common_lesser(one.lo, other.lo) : one_is_hit ? one.lo : other.lo;
    one_is_hit = is_real && is_within(one, l);
    other_is_hit = is_real && is_within(other, l);
    if (!one_is_hit && !other_is_hit)
        return;
    out->definite |= 1u << i;
    out->hi[i] = one_is_hit && other_is_hit ? common_lesser(one.hi, other.hi) : one_is_hit ? one.hi : other.hi;
}

/* ---- planes ---- */

/* A plane has one root, -c / 2 b, which is certain where the sign of b is: only there it has bounds. */
typedef struct plane { pov_vec3 anchor, half; double c, reach, half1, sum0; } plane;

static inline plane plane_of(const common_quadric_block *s, uint32_t i)
{
    const plane p = { { s->anchor[0][i], s->anchor[1][i], s->anchor[2][i] }, { s->q[G][i], s->q[H][i], s->q[I][i] },
                      s->q[J][i], s->reach[i], s->half1[i], s->sum0[i] };
    return p;
}

static inline bounds filter_plane(const plane *p, double ox, double oy, double oz, double far, double dx, double dy,
                                  double dz)
{
    const double speed = common_greater(fabs(dx), common_greater(fabs(dy), fabs(dz)));
    const double b = three(p->half.x, p->half.y, p->half.z, dx, dy, dz, 0.0), b_error = ERROR_UNIT * p->half1 * speed;
    const double half_c = three(p->half.x, p->half.y, p->half.z, ox - p->anchor.x, oy - p->anchor.y, oz - p->anchor.z,
                                0.5 * p->c);
    const double c_error = ERROR_UNIT * common_sum_of(p->half1, far + p->reach, 0.5 * p->sum0);
    const double c = b < 0.0 ? -half_c : half_c, down = -c - c_error, up = c_error - c;
    /* (b - e) / (b + e) is more than 1 - 2 e / (b - e), and by half a part more the roundings of this do not count. */
    const double least = fabs(b) - b_error, most_inverse = 1.0 / least;
    const double least_inverse = most_inverse * (1.0 - 2.5 * b_error * most_inverse);
    const double lo = common_lesser(down * most_inverse, down * least_inverse);
    const double hi = common_greater(up * most_inverse, up * least_inverse);
    const bool is_transparent = (least > 0.0) & (far < 1e60);
    const bounds r = { is_transparent ? lo - WIDER * fabs(lo) : -HUGE_VAL,
                       is_transparent ? hi + WIDER * fabs(hi) : HUGE_VAL };

    return r;
}

/* Rays side by side. */
enum { TOGETHER = 8 };

static inline void filter_together(const plane *p, const pov_rays *rays, uint32_t from, double *restrict lo,
                                   double *restrict hi)
{
    const double *ox = rays->org[0] + from, *oy = rays->org[1] + from, *oz = rays->org[2] + from;
    const double *dx = rays->dir[0] + from, *dy = rays->dir[1] + from, *dz = rays->dir[2] + from;
    const double *size = rays->size + from;
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const bounds r = filter_plane(p, ox[i], oy[i], oz[i], size[i], dx[i], dy[i], dz[i]);

        lo[i] = r.lo;
        hi[i] = r.hi;
    }
}

static inline uint32_t plane_candidates(double lo, double hi, const pov_rays *rays, uint32_t at, uint32_t lane,
                                        pov_candidate *out, uint32_t n)
{
    if (lo > rays->tmax[at] || hi < 0.0)
        return n;
    out[n].lo = lo;
    out[n].hi = hi;
    out[n].ray = (uint8_t)at;
    out[n].lane = (uint8_t)lane;
    out[n].definite = (lo > 0.0) & (hi < rays->tmax[at]);
    out[n].definite_pair = false;
    return n + 1;
}

static inline uint32_t planar_single(const plane *p, uint32_t lane, const pov_rays *rays, uint32_t at,
                                     pov_candidate *out, uint32_t n)
{
    const bounds r = filter_plane(p, rays->org[0][at], rays->org[1][at], rays->org[2][at], rays->size[at],
                                  rays->dir[0][at], rays->dir[1][at], rays->dir[2][at]);

    return plane_candidates(r.lo, r.hi, rays, at, lane, out, n);
}

static inline uint32_t planar_some(const plane *p, uint32_t lane, const pov_rays *rays, uint32_t from, uint32_t some,
                                   pov_candidate *out, uint32_t n)
{
    double lo[TOGETHER], hi[TOGETHER];

    filter_together(p, rays, from, lo, hi);
    for (; some; some &= some - 1) {
        const uint32_t i = common_first_lane(some);

        n = plane_candidates(lo[i], hi[i], rays, from + i, lane, out, n);
    }
    return n;
}

static inline uint32_t filter_planar(const common_quadric_block *s, const pov_rays *rays, uint64_t lanes,
                                     pov_candidate *out)
{
    const uint32_t all = (1u << TOGETHER) - 1;
    uint32_t planes = (uint32_t)s->lanes, n = 0, from;

    for (; planes; planes &= planes - 1) {
        const uint32_t lane = common_first_lane(planes);
        const plane p = plane_of(s, lane);

        if ((lanes & (lanes - 1)) == 0) {
            n = planar_single(&p, lane, rays, common_first_lane64(lanes), out, n);
            continue;
        }
        for (from = 0; from < POV_RAYS_MAX; from += TOGETHER)
            if (lanes >> from & all)
                n = planar_some(&p, lane, rays, from, (uint32_t)(lanes >> from) & all, out, n);
    }
    return n;
}

/* ---- rays ---- */

static inline void result(const common_quadric_block *s, const line *l, common_result *out)
{
    found f;
    uint32_t hit;

    out->maybe = out->definite = out->definite_pair = 0;
    hit = s->lanes < 16 ? find(s, l, POV_BLOCK_MAX / 2, &f) : find(s, l, POV_BLOCK_MAX, &f);
    for (; hit; hit &= hit - 1)
        bound_lane(&f, common_first_lane(hit), l, out);
}

/* Static, because the names of clones would be exported. */
COMMON_CLONES static uint32_t filter(const common_quadric_block *s, const pov_rays *rays, uint64_t lanes,
                                     pov_candidate *out)
{
    uint32_t n = 0;
    common_result a;

    if (s->planar)
        return filter_planar(s, rays, lanes, out);
    for (; lanes; lanes &= lanes - 1) {
        const uint32_t at = common_first_lane64(lanes);
        const pov_vec3 d = common_dir(rays, at);
        const line l = { common_origin(rays, at), d, rays->size[at], pov_largest(d), rays->tmax[at] };

        if (is_ordinary(l.far, l.speed))
            result(s, &l, &a);
        else
            common_decline((uint32_t)s->lanes, &a);
        n = common_candidates(&a, at, out, n);
    }
    return n;
}

uint32_t common_quadric_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_candidate *out)
{
    (void)owners;
    return filter(block, rays, lanes, out);
}

COMMON_CLONES static void bound_plane(const common_quadric_block *s, uint32_t lane, const pov_rays *rays, uint64_t lanes, double *restrict lo,
                                      double *restrict hi)
{
    const plane p = plane_of(s, lane);

    for (uint32_t from = 0; from < POV_RAYS_MAX && lanes >> from; from += TOGETHER)
        filter_together(&p, rays, from, lo + from, hi + from);
}

void common_plane_bounds(const void *block, uint32_t lane, const pov_rays *rays, uint64_t lanes, double *lo, double *hi)
{
    bound_plane(block, lane, rays, lanes, lo, hi);
}
