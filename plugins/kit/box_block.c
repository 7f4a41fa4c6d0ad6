#include "kit/box_block.h"

#include "kit/simd.h"

#include <float.h>

void kit_box_begin(kit_box_block *b, uint32_t n)
{
    uint32_t i, p;

    /* Never so small that a part u of it, times the inverse of a direction, would not be exact. */
    b->reach[0] = b->reach[1] = b->reach[2] = 0x1p-680;
    b->lanes = (1u << n) - 1;
    b->few = n <= POV_BLOCK_MAX / 2;
    for (p = 0; p < 6; p++)
        for (i = 0; i < POV_BLOCK_MAX; i++)
            b->plane[p][i] = p % 2 ? -HUGE_VAL : HUGE_VAL;
}

bool kit_box_put(kit_box_block *b, uint32_t lane, uint32_t p, double plane)
{
    b->plane[p][lane] = plane;
    b->reach[p / 2] = fmax(b->reach[p / 2], fabs(plane));
    return kit_block_range(fabs(plane));
}

/* What a ray is along one axis, to all lanes. `pad` has the direction's sign. */
typedef struct slab_view { const double *enter, *leave; double o, inverse, pad; } slab_view;

/* Of the distance to a plane, origin and plane as they are rounded make u of their sum; two sums, the inverse, its
 * product and the direction's low part as much each: less than 7 u in all. A ray along the planes is between them for
 * ever or never. */
static inline slab_view view_of(const kit_box_block *b, int axis, double o, double d)
{
    const int upper = d < 0.0;
    const double pad = 8.0 * KIT_U * (fabs(o) + b->reach[axis]);
    slab_view v;

    v.enter = b->plane[2 * axis + upper];
    v.leave = b->plane[2 * axis + !upper];
    v.o = o;
    v.inverse = d == 0.0 ? HUGE_VAL : 1.0 / d;
    v.pad = upper ? -pad : pad;
    return v;
}

/* For certain the ray is outside before `near` and after `far`, and inside from `last` to `first`. What is not a number
 * comes from a plane just so far off as the pad and the direction zero; it is passed over by the comparisons. */
static inline void filter_some(const kit_box_block *b, const pov_rays *rays, uint32_t at, uint32_t n,
                               kit_answer *restrict out)
{
    const int64_t bit[POV_BLOCK_MAX] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    const slab_view x = view_of(b, 0, rays->org[0][at], rays->dir[0][at]),
                    y = view_of(b, 1, rays->org[1][at], rays->dir[1][at]),
                    z = view_of(b, 2, rays->org[2][at], rays->dir[2][at]);
    const double tmax = rays->tmax[at], end = kit_lesser(tmax, DBL_MAX);
    int64_t maybe = 0, surely = 0, twice = 0;
    uint32_t i;

    for (i = 0; i < n; i++) {
        const double ax = x.enter[i] - x.o, ay = y.enter[i] - y.o, az = z.enter[i] - z.o;
        const double bx = x.leave[i] - x.o, by = y.leave[i] - y.o, bz = z.leave[i] - z.o;
        const double near_xy = kit_greater((ay - y.pad) * y.inverse, kit_greater((ax - x.pad) * x.inverse, -HUGE_VAL));
        const double last_xy = kit_greater((ay + y.pad) * y.inverse, kit_greater((ax + x.pad) * x.inverse, -HUGE_VAL));
        const double far_xy = kit_lesser((by + y.pad) * y.inverse, kit_lesser((bx + x.pad) * x.inverse, HUGE_VAL));
        const double first_xy = kit_lesser((by - y.pad) * y.inverse, kit_lesser((bx - x.pad) * x.inverse, HUGE_VAL));
        const double near = kit_greater((az - z.pad) * z.inverse, near_xy);
        const double last = kit_greater((az + z.pad) * z.inverse, last_xy);
        const double far = kit_lesser((bz + z.pad) * z.inverse, far_xy);
        const double first = kit_lesser((bz - z.pad) * z.inverse, first_xy);

        maybe |= ((near <= far) & (near <= end) & (far >= 0.0)) ? bit[i] : 0;
        surely |= ((last < first) & (near > 0.0) & (last < tmax)) ? bit[i] : 0;
        twice |= ((last < first) & (near > 0.0) & (far < tmax)) ? bit[i] : 0;
        out->lo[i] = near;
        out->hi[i] = last;
    }
    out->maybe = (uint32_t)maybe & b->lanes;
    out->surely = (uint32_t)(surely & maybe) & b->lanes;
    out->twice = (uint32_t)(twice & maybe) & b->lanes;
}

static inline void answer_alone(const kit_box_block *b, const pov_rays *rays, uint32_t at, kit_answer *out)
{
    if (b->few)
        filter_some(b, rays, at, POV_BLOCK_MAX / 2, out);
    else
        filter_some(b, rays, at, POV_BLOCK_MAX, out);
}

/* Some rays side by side. The distance to a plane is the plane times `inverse`, and `start`, off by less than the pad.
 * That is without end where a ray goes along the planes of an axis. */
enum { TOGETHER = 8 };
typedef struct starts { double inverse[3][TOGETHER], start[3][TOGETHER], pad[TOGETHER]; } starts;

/* How far off, as a part of origin and plane times the inverse: u for these two as they are rounded, u each for the
 * inverse, both products, their sum, and what comes of taking the pad off. That is less than 7 u; the worst axis speaks
 * for all. */
static inline double start_axis(starts *restrict s, uint32_t i, int axis, double o, double d, double reach)
{
    const double inverse = 1.0 / d;

    s->inverse[axis][i] = inverse;
    s->start[axis][i] = -o * inverse;
    return 8.0 * KIT_U * (fabs(o) + reach) * fabs(inverse);
}

static inline void start_some(const kit_box_block *b, const pov_rays *rays, uint32_t from, starts *restrict s)
{
    const double rx = b->reach[0], ry = b->reach[1], rz = b->reach[2];
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const double x = start_axis(s, i, 0, rays->org[0][from + i], rays->dir[0][from + i], rx);
        const double y = start_axis(s, i, 1, rays->org[1][from + i], rays->dir[1][from + i], ry);
        const double z = start_axis(s, i, 2, rays->org[2][from + i], rays->dir[2][from + i], rz);

        s->pad[i] = kit_greater(x, kit_greater(y, z));
    }
}

/* As filter_some() from 0 to tmax, with one pad for all axes. A lane without a box would hold all of space here. */
static inline void meet_some(const kit_box_block *b, const starts *s, uint32_t at, uint32_t n, double tmax,
                             kit_answer *restrict out)
{
    const int64_t bit[POV_BLOCK_MAX] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    const double rx = s->inverse[0][at], ry = s->inverse[1][at], rz = s->inverse[2][at];
    const double sx = s->start[0][at], sy = s->start[1][at], sz = s->start[2][at], pad = s->pad[at];
    int64_t met = 0, twice = 0;
    uint32_t i;

    for (i = 0; i < n; i++) {
        const double ax = kit_sum_of(b->plane[0][i], rx, sx), bx = kit_sum_of(b->plane[1][i], rx, sx);
        const double ay = kit_sum_of(b->plane[2][i], ry, sy), by = kit_sum_of(b->plane[3][i], ry, sy);
        const double az = kit_sum_of(b->plane[4][i], rz, sz), bz = kit_sum_of(b->plane[5][i], rz, sz);
        const double entry = kit_greater(kit_greater(kit_lesser(ax, bx), kit_lesser(ay, by)), kit_lesser(az, bz));
        const double exit = kit_lesser(kit_lesser(kit_greater(ax, bx), kit_greater(ay, by)), kit_greater(az, bz));
        const double near = entry - pad, last = entry + pad, far = exit + pad, first = exit - pad;

        met |= kit_greater(near, 0.0) <= kit_lesser(far, tmax) ? bit[i] : 0;
        met |= ((near > 0.0) & (last < kit_lesser(first, tmax))) ? bit[i] << POV_BLOCK_MAX : 0;
        twice |= ((near > 0.0) & (last < first) & (far < tmax)) ? bit[i] : 0;
        out->lo[i] = near;
        out->hi[i] = last;
    }
    out->maybe = (uint32_t)met & b->lanes;
    out->surely = (uint32_t)met >> POV_BLOCK_MAX & b->lanes;
    out->twice = (uint32_t)twice & b->lanes;
}

/* As meet_some(), one box and all rays of `starts`. */
static inline void meet_rays(const kit_box_block *b, uint32_t which, const starts *s, const double *restrict tmax,
                             kit_found *restrict out)
{
    const int64_t bit[TOGETHER] = { 1, 2, 4, 8, 16, 32, 64, 128 };
    const double lower_x = b->plane[0][which], lower_y = b->plane[2][which], lower_z = b->plane[4][which];
    const double upper_x = b->plane[1][which], upper_y = b->plane[3][which], upper_z = b->plane[5][which];
    int64_t maybe = 0, surely = 0, twice = 0;
    uint32_t i;

    for (i = 0; i < TOGETHER; i++) {
        const double rx = s->inverse[0][i], ry = s->inverse[1][i], rz = s->inverse[2][i], pad = s->pad[i];
        const double ax = kit_sum_of(lower_x, rx, s->start[0][i]), bx = kit_sum_of(upper_x, rx, s->start[0][i]);
        const double ay = kit_sum_of(lower_y, ry, s->start[1][i]), by = kit_sum_of(upper_y, ry, s->start[1][i]);
        const double az = kit_sum_of(lower_z, rz, s->start[2][i]), bz = kit_sum_of(upper_z, rz, s->start[2][i]);
        const double entry = kit_greater(kit_greater(kit_lesser(ax, bx), kit_lesser(ay, by)), kit_lesser(az, bz));
        const double exit = kit_lesser(kit_lesser(kit_greater(ax, bx), kit_greater(ay, by)), kit_greater(az, bz));
        const double near = entry - pad, last = entry + pad, far = exit + pad, first = exit - pad;

        maybe |= kit_greater(near, 0.0) <= kit_lesser(far, tmax[i]) ? bit[i] : 0;
        surely |= ((near > 0.0) & (last < kit_lesser(first, tmax[i]))) ? bit[i] : 0;
        twice |= ((near > 0.0) & (last < first) & (far < tmax[i])) ? bit[i] : 0;
        out->lo[i] = near;
        out->hi[i] = last;
    }
    out->maybe = (uint32_t)maybe;
    out->surely = (uint32_t)surely;
    out->twice = (uint32_t)twice;
}

/* Rays of which the filter for some knows nothing. */
static inline uint32_t find_odd(const starts *s)
{
    uint32_t odd = 0, i;

    for (i = 0; i < TOGETHER; i++)
        odd |= (uint32_t)!(s->pad[i] < HUGE_VAL) << i;
    return odd;
}

/* One ray by all boxes, without those that it goes away from. */
static inline uint32_t meet_all(const kit_box_block *b, const starts *s, uint32_t i, const uint32_t *owners,
                                const pov_rays *rays, uint32_t at, pov_meeting *out, uint32_t n)
{
    const uint32_t left = kit_owned_by(owners, rays->away[at]);
    kit_answer a;

    if (!(b->lanes & ~left))
        return n;
    if (!s || !(s->pad[i] < HUGE_VAL))
        answer_alone(b, rays, at, &a);
    else if (b->few)
        meet_some(b, s, i, POV_BLOCK_MAX / 2, rays->tmax[at], &a);
    else
        meet_some(b, s, i, POV_BLOCK_MAX, rays->tmax[at], &a);
    a.maybe &= ~left;
    return kit_tell(&a, at, out, n);
}

KIT_CLONES static uint32_t filter(const kit_box_block *b, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                                  pov_meeting *out)
{
    uint32_t n = 0, from, some;
    kit_found f;
    starts s;

    if ((lanes & (lanes - 1)) == 0)
        return meet_all(b, NULL, 0, owners, rays, kit_first_lane64(lanes), out, 0);
    if (b->lanes == 1)
        lanes = kit_stay(rays, lanes, owners[0]);
    for (from = 0; from < POV_RAYS_MAX; from += TOGETHER) {
        some = (uint32_t)(lanes >> from) & ((1u << TOGETHER) - 1);
        if (!some)
            continue;
        start_some(b, rays, from, &s);
        if (b->lanes == 1) {
            const uint32_t odd = find_odd(&s);
            meet_rays(b, 0, &s, rays->tmax + from, &f);
            f.maybe &= some & ~odd;
            n = kit_tell_rays(&f, from, 0, out, n);
            some &= odd;
        }
        for (; some; some &= some - 1) {
            const uint32_t i = kit_first_lane(some);
            n = meet_all(b, &s, i, owners, rays, from + i, out, n);
        }
    }
    return n;
}

uint32_t kit_box_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_meeting *out)
{
    return filter(block, owners, rays, lanes, out);
}
