/* Up to eight cylinders or cones at once, in plain double: which of them a ray may meet, which surely, and where.
 *
 * A lane's ray is taken about the point nearest to the middle of its shape, in local coordinates, where all is as large
 * as one. There it is off by less than half of sigma = 64 u N (O + R) in each coordinate, with N the largest entry of
 * the rows and O + R what origin and shape can be: docs/numerics.md has the count. All bounds are made of that. */
#include "kit/frustum.h"
#include "kit/simd.h"

/* A ray of ordinary length and a shape as small as that leave room for the sixth power of either. */
static bool is_ordinary(double speed) { return speed > 1e-40 && speed < 1e40; }

static double sum_of(pov_vec3 a) { return kit_sum_of_components(a); }

/* How far from the origin points may lie that are considered: those within four times the shape. */
static double reach_of(const kit_frustum *s)
{
    const double across = fmax(sum_of(s->column[0]), sum_of(s->column[1])) * fmax(s->radii[0], s->radii[1]);

    return sum_of(pov_two3_hi(s->anchor)) + 8.0 * (across + sum_of(s->column[2]) * s->length);
}

static bool pack_lane(kit_frustum_block *b, uint32_t i, const kit_frustum *s)
{
    double largest = 0.0;
    int k;

    if (s->empty || !kit_block_range(reach_of(s)))
        return false;
    b->anchor[0][i] = s->anchor.x.hi;
    b->anchor[1][i] = s->anchor.y.hi;
    b->anchor[2][i] = s->anchor.z.hi;
    for (k = 0; k < 3; k++) {
        const pov_vec3 row = pov_scale(pov_two3_hi(s->row[k]), s->scale);

        b->row[k][0][i] = row.x;
        b->row[k][1][i] = row.y;
        b->row[k][2][i] = row.z;
        largest = fmax(largest, pov_largest(row));
    }
    b->radius[i] = s->radius.hi;
    b->slope[i] = s->slope.hi;
    b->height[i] = s->height.hi;
    b->size[i] = largest;
    b->reach = fmax(b->reach, reach_of(s));
    b->open |= (uint32_t)s->open << i;
    return is_ordinary(largest);
}

bool kit_frustum_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    kit_frustum_block *b = block;
    uint32_t i;

    (void)frame;
    b->reach = 0.0;
    b->lanes = (1u << n) - 1;
    b->open = 0;
    for (i = 0; i < POV_BLOCK_MAX; i++)
        if (!pack_lane(b, i, selves[i < n ? i : 0]))
            return false;
    return true;
}

/* A ray in local coordinates, about its point at `middle`, and the discriminant of the side there. */
typedef struct local_rays {
    double x[POV_BLOCK_MAX], y[POV_BLOCK_MAX], z[POV_BLOCK_MAX];
    double dx[POV_BLOCK_MAX], dy[POV_BLOCK_MAX], dz[POV_BLOCK_MAX];
    double middle[POV_BLOCK_MAX], discriminant[POV_BLOCK_MAX];
} local_rays;

/* A ray: sigma of a lane is `blur` times its size. */
typedef struct glance { pov_vec3 org, dir; double blur, speed, tmax; } glance;

/* A local point off by sigma / 2 moves the value x^2 + y^2 - r(z)^2 by less than 12 sigma, and so the discriminant by
 * that times its leading coefficient, which is below 4 G^2; G, size times speed, is no less than a component of the
 * direction. Its own roundings are below 13 sigma G^2. */
static inline double doubt_of(double sigma, double g) { return 64.0 * sigma * g * g; }

static inline double dot(double ax, double ay, double az, double bx, double by, double bz)
{
    return kit_sum_of(az, bz, kit_sum_of(ay, by, ax * bx));
}

static inline double row_times(const kit_frustum_block *b, int row, uint32_t i, double x, double y, double z)
{
    return dot(b->row[row][0][i], b->row[row][1][i], b->row[row][2][i], x, y, z);
}

/* Lanes that the line does not miss for certain. Its nearest point lies no further out than the shape's corners, of
 * which the square is below 6; where sigma is no small thing, or not a number, nothing is certain. */
static inline uint32_t find_met(const kit_frustum_block *b, const glance *g, uint32_t n, local_rays *restrict l)
{
    const int64_t bit[POV_BLOCK_MAX] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    const pov_vec3 o = g->org, d = g->dir;
    const double blur = g->blur, speed = g->speed;
    int64_t missed = 0;
    uint32_t i;

    for (i = 0; i < n; i++) {
        const double wx = o.x - b->anchor[0][i], wy = o.y - b->anchor[1][i], wz = o.z - b->anchor[2][i];
        const double dx = row_times(b, 0, i, d.x, d.y, d.z), fx = row_times(b, 0, i, wx, wy, wz);
        const double dy = row_times(b, 1, i, d.x, d.y, d.z), fy = row_times(b, 1, i, wx, wy, wz);
        const double dz = row_times(b, 2, i, d.x, d.y, d.z), fz = row_times(b, 2, i, wx, wy, wz);
        const double half = 0.5 * b->height[i];
        const double middle = -dot(fx, fy, fz - half, dx, dy, dz) / dot(dx, dy, dz, dx, dy, dz);
        const double x = kit_sum_of(middle, dx, fx), y = kit_sum_of(middle, dy, fy), z = kit_sum_of(middle, dz, fz);
        const double r = kit_sum_of(b->slope[i], z, b->radius[i]), grow = b->slope[i] * dz;
        const double p = kit_sum_of(r, dx, -(grow * x)), q = kit_sum_of(r, dy, -(grow * y));
        const double m = kit_sum_of(x, dy, -(y * dx)), sigma = blur * b->size[i];
        const double discriminant = kit_sum_of(p, p, kit_sum_of(q, q, -(m * m)));
        const double square = dot(x, y, z - half, x, y, z - half), doubt = doubt_of(sigma, b->size[i] * speed);
        const bool misses = ((discriminant < -doubt) | (square > 8.0)) & (sigma < 0x1p-8);

        l->x[i] = x;
        l->y[i] = y;
        l->z[i] = z;
        l->dx[i] = dx;
        l->dy[i] = dy;
        l->dz[i] = dz;
        l->middle[i] = middle;
        l->discriminant[i] = discriminant;
        missed |= misses ? bit[i] : 0;
    }
    return ~(uint32_t)missed & b->lanes;
}

/* Bounds on where a ray enters and leaves something: before `lo` and after `hi` it is outside, from `late` to `soon` it
 * is inside. */
typedef struct reach { double lo, late, soon, hi; } reach;

/* The side. With a coefficient a of one sign or the other the roots are (-b -+ sqrt D) / a. Where a is all but zero, or
 * below zero and the ray comes near to the apex, nothing is said. */
static inline reach side_of(const kit_frustum_block *b, uint32_t i, const local_rays *l, double sigma, double g)
{
    const double r = kit_sum_of(b->slope[i], l->z[i], b->radius[i]), grow = b->slope[i] * l->dz[i];
    const double a = dot(l->dx[i], l->dy[i], grow, l->dx[i], l->dy[i], -grow);
    const double half = dot(l->x[i], l->y[i], r, l->dx[i], l->dy[i], -grow), doubt = doubt_of(sigma, g);
    const double least = l->discriminant[i] - doubt, most = l->discriminant[i] + doubt;
    const double small = sqrt(kit_greater(least, 0.0)), large = sqrt(kit_greater(most, 0.0));
    const double inverse = 1.0 / a, gain = g * inverse;
    /* Of half 100 u g, of a 20 u g^2, of quotient and root 3 u; both parts of the numerator together are below 50 g. */
    const double slack = 4096.0 * KIT_U * g * gain * gain + 4.0 * KIT_U * fabs(l->middle[i]);
    reach out = { -HUGE_VAL, HUGE_VAL, -HUGE_VAL, HUGE_VAL };

    if (!(fabs(a) > 0x1p-26 * g * g) || (a < 0.0 && !(least > 0.0)))
        return out;
    if (a > 0.0 || grow > 0.0) {
        out.lo = l->middle[i] + (-half - (a > 0.0 ? large : small)) * inverse - slack;
        out.late = l->middle[i] + (-half - (a > 0.0 ? small : large)) * inverse + slack;
    } else {
        out.late = -HUGE_VAL;
    }
    if (a > 0.0 || grow < 0.0) {
        out.hi = l->middle[i] + (-half + (a > 0.0 ? large : small)) * inverse + slack;
        out.soon = l->middle[i] + (-half + (a > 0.0 ? small : large)) * inverse - slack;
    } else {
        out.soon = HUGE_VAL;
    }
    if (!(least > 0.0))
        out.soon = -HUGE_VAL;
    return out;
}

/* Between the ends. The inner one stays so far from an apex that the radius there is above zero for certain. Along the
 * ends a slope too small to matter stands for none. */
static inline reach slab_of(const kit_frustum_block *b, uint32_t i, const local_rays *l, double sigma, double g)
{
    const double dz = fabs(l->dz[i]) > 0x1p-200 * g ? l->dz[i] : 0x1p-200 * g, inverse = 1.0 / dz;
    const double slack = 4.0 * KIT_U * fabs(l->middle[i]);
    const double base_out = (-sigma - l->z[i]) * inverse, base_in = (8.0 * sigma - l->z[i]) * inverse;
    const double top_out = (b->height[i] + sigma - l->z[i]) * inverse;
    const double top_in = (b->height[i] - sigma - l->z[i]) * inverse;
    reach out;

    out.lo = l->middle[i] + (dz > 0.0 ? base_out : top_out) - slack;
    out.late = l->middle[i] + (dz > 0.0 ? base_in : top_in) + slack;
    out.soon = l->middle[i] + (dz > 0.0 ? top_in : base_in) - slack;
    out.hi = l->middle[i] + (dz > 0.0 ? top_out : base_out) + slack;
    return out;
}

static inline void bound_lane(const kit_frustum_block *b, uint32_t i, const local_rays *l, const glance *ray, kit_answer *out)
{
    const double tmax = ray->tmax, sigma = ray->blur * b->size[i], g = ray->speed * b->size[i];
    const uint32_t bit = 1u << i;
    reach side, slab;
    double lo, late, hi;

    out->lo[i] = 0.0;
    if (!(sigma < 0x1p-8)) {
        out->maybe |= bit;
        return;
    }
    side = side_of(b, i, l, sigma, g);
    slab = slab_of(b, i, l, sigma, g);
    lo = kit_greater(side.lo, slab.lo);
    late = kit_greater(side.late, slab.late);
    hi = kit_lesser(side.hi, slab.hi);
    out->lo[i] = lo;
    out->hi[i] = late;
    if (!(lo <= hi && lo <= tmax && hi >= 0.0))
        return;
    out->maybe |= bit;
    /* An open one has to be entered by its side. */
    if (!(late < kit_lesser(side.soon, slab.soon) && lo > 0.0 && late < tmax
          && (!(b->open & bit) || side.lo > slab.late)))
        return;
    out->surely |= bit;
    if (hi < tmax && !(b->open & bit))
        out->twice |= bit;
}

static inline void answer(const kit_frustum_block *b, const pov_rays *rays, uint32_t at, kit_answer *out)
{
    glance g = { kit_origin(rays, at), kit_way(rays, at), 0.0, 0.0, rays->tmax[at] };
    local_rays l;
    uint32_t met;

    g.speed = sum_of(g.dir);
    g.blur = 64.0 * KIT_U * (rays->size[at] + b->reach);
    if (!(is_ordinary(g.speed) && kit_block_range(g.blur))) {
        kit_decline(b->lanes, out);
        return;
    }
    met = b->lanes < 16 ? find_met(b, &g, POV_BLOCK_MAX / 2, &l) : find_met(b, &g, POV_BLOCK_MAX, &l);
    out->maybe = out->surely = out->twice = 0;
    for (; met; met &= met - 1)
        bound_lane(b, kit_first_lane(met), &l, &g, out);
}

/* Static, since the names of clones would be seen from outside. */
KIT_CLONES static uint32_t filter(const kit_frustum_block *b, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                                  pov_meeting *out)
{
    uint32_t n = 0;
    kit_answer a;

    for (; lanes; lanes &= lanes - 1) {
        const uint32_t at = kit_first_lane64(lanes);

        const uint32_t left = kit_owned_by(owners, rays->away[at]);

        if (!(b->lanes & ~left))
            continue;
        answer(b, rays, at, &a);
        a.maybe &= ~left;
        n = kit_tell(&a, at, out, n);
    }
    return n;
}

uint32_t kit_frustum_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_meeting *out)
{
    return filter(block, owners, rays, lanes, out);
}
