/* Segments to a part of the light lie around the one to its middle: at t within t times `spread` of it. Along that one steps are as long as the
 * surface is away, less this: where all of them stay outside until the end no segment meets it, and where one place is certainly outside and
 * another one certainly inside all segments cross it between both. Doubt is more than all roundings, as of area_cover.c. */
#include "shade/area_ring.h"

#include "base/lane_mask.h"
#include "base/vec3.h"

#include <math.h>

static const double skin = 0x1p-10, roundings = 0x1p-36, end = 1.0 - 0x1p-8, beyond = 1.0 + 0x1p-8, shorter = 1.0 - 0x1p-20;
static const double touching = 0x1p-40;
/* Where it is nearer than the first of these parts of `minor`, the next step is the second one. */
static const double near_by = 0x1p-5, step_in = 0.25;

enum { STEPS = 8, TOGETHER = AREA_TOGETHER };
typedef double lane[TOGETHER];

static pov_vec3 turn(const pov_own_map *own, pov_vec3 v)
{
    return pov_add(pov_add(pov_scale(own->column[0], v.x), pov_scale(own->column[1], v.y)), pov_scale(own->column[2], v.z));
}

/* Is all of the ring within a slab of the clip? Then that cuts nothing of it off, though both may touch. */
static bool is_within(const area_ring *r, uint32_t slab)
{
    const area_cover *c = &r->clip;
    const double *rate = c->rate[slab], lo = 0.5 * (c->lo[slab] + c->wide_lo[slab]), hi = 0.5 * (c->hi[slab] + c->wide_hi[slab]);
    const pov_vec3 cross[3] = { pov_cross_product(r->to[1], r->to[2]), pov_cross_product(r->to[2], r->to[0]), pov_cross_product(r->to[0], r->to[1]) };
    const pov_vec3 sum = pov_add(pov_add(pov_scale(cross[0], rate[0]), pov_scale(cross[1], rate[1])), pov_scale(cross[2], rate[2]));
    const pov_vec3 normal = pov_scale(sum, 1.0 / pov_dot(r->to[0], cross[0]));
    const double middle = -pov_dot(normal, r->from), reach = r->major * sqrt(normal.x * normal.x + normal.z * normal.z) + r->minor * sqrt(pov_dot(normal, normal));
    const double off = touching * (fabs(middle) + reach);

    return middle - reach >= lo - off && middle + reach <= hi + off;
}

bool area_ring_make(area_ring *r, const double radii[2], const pov_own_map *own, pov_vec3 from, pov_vec3 to, const pov_vec3 axes[2], const area_cover *clip,
                    const area_cover *hollow)
{
    const double turned = vec3_sum(own->column[0]) + vec3_sum(own->column[1]) + vec3_sum(own->column[2]);
    const double size = turned * (vec3_sum(from) + vec3_sum(own->anchor) + vec3_sum(to) + vec3_sum(axes[0]) + vec3_sum(axes[1])) + vec3_sum(own->from) + radii[0];

    r->major = radii[0];
    r->minor = radii[1];
    r->from = pov_add(turn(own, pov_sub(from, own->anchor)), own->from);
    r->to[0] = turn(own, to);
    for (int i = 0; i < 2; i++) {
        r->to[1 + i] = turn(own, axes[i]);
        r->square[i] = pov_dot(r->to[1 + i], r->to[1 + i]);
    }
    r->square[2] = 2.0 * fabs(pov_dot(r->to[1], r->to[2]));
    r->hides = (!clip || !clip->round) && (!hollow || !hollow->round);
    r->hollowed = hollow != NULL;
    if (hollow)
        r->hollow = *hollow;
    r->cuts = 0;
    if (clip) {
        r->clip = *clip;
        for (uint32_t i = 0; i < clip->slabs; i++)
            r->cuts |= is_within(r, i) ? 0 : 1u << i;
    }
    return skin * r->minor > roundings * size;
}

/* Some parts by their middles and half widths; where the segment to the middle may be near the surface that is there, and where all segments
 * are within the clip, and any may be within the hollow; and how far it has been followed. */
typedef struct SIMD_ALIGNED some_parts {
    lane middle[2], half[2], dir[3], spread, per;
    lane first, last, from, to, hollow_from, hollow_to, t, sign, since, passed, hidden;
    SIMD_ALIGNED int64_t open[TOGETHER];
} some_parts;

SIMD_INLINE void take(const area_ring *r, const area_parts *restrict p, uint32_t from, uint32_t n, some_parts *restrict s)
{
    const pov_vec3 *to = r->to;
    const double by_u = r->square[0], by_v = r->square[1], by_both = r->square[2], hollow_to = r->hollowed ? HUGE_VAL : -1.0;

    for (int axis = 0; axis < 2; axis++)
        SIMD_LOOP for (uint32_t i = 0; i < n; i++) {
            const double lo = p->lo[axis][from + i], hi = p->hi[axis][from + i];

            s->middle[axis][i] = 0.5 * (lo + hi);
            s->half[axis][i] = 0.5 * (hi - lo);
        }
    SIMD_LOOP for (uint32_t i = 0; i < n; i++) {
        const double u = s->middle[0][i], v = s->middle[1][i], broad = s->half[0][i], high = s->half[1][i];
        const double x = to[0].x + u * to[1].x + v * to[2].x, y = to[0].y + u * to[1].y + v * to[2].y, z = to[0].z + u * to[1].z + v * to[2].z;

        s->dir[0][i] = x;
        s->dir[1][i] = y;
        s->dir[2][i] = z;
        s->spread[i] = (1.0 + skin) * sqrt(by_u * broad * broad + by_v * high * high + by_both * broad * high);
        s->per[i] = shorter / (sqrt(x * x + y * y + z * z) + s->spread[i]);
        s->first[i] = s->from[i] = s->hollow_from[i] = s->sign[i] = s->since[i] = s->hidden[i] = 0.0;
        s->hollow_to[i] = hollow_to;
        s->last[i] = beyond;
        s->to[i] = end;
        s->passed[i] = 1.0;
    }
}

/* Where lo <= t (rate . (1, u, v)) <= hi of all segments to a part, or with side = -1, where it may be so of any. */
SIMD_INLINE void cut(double one, double by_u, double by_v, double lo, double hi, double side, uint32_t n, const some_parts *restrict s,
                     double *restrict first, double *restrict last)
{
    const double off = roundings * (fabs(one) + fabs(by_u) + fabs(by_v)), broad = fabs(by_u), high = fabs(by_v), never = 0x1p-1000;

    SIMD_LOOP for (uint32_t i = 0; i < n; i++) {
        const double at = one + by_u * s->middle[0][i] + by_v * s->middle[1][i], wide = side * (broad * s->half[0][i] + high * s->half[1][i] + off);
        const double most = at + wide, least = at - wide;
        const double a = hi / (most == 0.0 ? never : most), b = lo / (least == 0.0 ? -never : least);
        const double begin_a = most < 0.0 ? a : 0.0, end_a = most < 0.0 ? HUGE_VAL : a, begin_b = least > 0.0 ? b : 0.0, end_b = least > 0.0 ? HUGE_VAL : b;
        const double begin = begin_a > begin_b ? begin_a : begin_b, stop = end_a < end_b ? end_a : end_b;

        first[i] = begin > first[i] ? begin : first[i];
        last[i] = stop < last[i] ? stop : last[i];
    }
}

SIMD_INLINE void find_ends(const area_ring *r, uint32_t n, some_parts *restrict s)
{
    const double high = (1.0 + skin) * r->minor, ahead = step_in * r->minor, reach = r->major + high;
    const pov_vec3 *to = r->to, at = r->from;

    cut(to[0].x, to[1].x, to[2].x, -reach - at.x, reach - at.x, -1.0, n, s, s->first, s->last);
    cut(to[0].y, to[1].y, to[2].y, -high - at.y, high - at.y, -1.0, n, s, s->first, s->last);
    cut(to[0].z, to[1].z, to[2].z, -reach - at.z, reach - at.z, -1.0, n, s, s->first, s->last);
    for (uint32_t left = r->cuts; left; left &= left - 1) {
        const uint32_t i = first_of(left);
        const double *rate = r->clip.rate[i];

        cut(rate[0], rate[1], rate[2], r->clip.wide_lo[i], r->clip.wide_hi[i], -1.0, n, s, s->first, s->last);
        cut(rate[0], rate[1], rate[2], r->clip.lo[i], r->clip.hi[i], 1.0, n, s, s->from, s->to);
    }
    for (uint32_t i = 0; r->hollowed && i < r->hollow.slabs; i++) {
        const double *rate = r->hollow.rate[i];

        cut(rate[0], rate[1], rate[2], r->hollow.wide_lo[i], r->hollow.wide_hi[i], -1.0, n, s, s->hollow_from, s->hollow_to);
    }
    SIMD_LOOP for (uint32_t i = 0; i < n; i++) {
        const double begin = s->first[i] - (ahead + s->spread[i]) * s->per[i];

        s->t[i] = begin > 0.0 ? begin : 0.0;
        s->open[i] = s->first[i] <= s->last[i];
    }
}

SIMD_INLINE void go_on(const area_ring *r, uint32_t n, some_parts *restrict s)
{
    const double major = r->major, minor = r->minor, least = near_by * minor, more = step_in * minor, off = skin * minor, hides = r->hides ? 1.0 : 0.0;
    const pov_vec3 at = r->from;

    SIMD_LOOP for (uint32_t i = 0; i < n; i++) {
        const double t = s->t[i], from = s->from[i], to = s->to[i], last = s->last[i], before = s->sign[i], was_passed = s->passed[i], was_hidden = s->hidden[i];
        const int64_t open = s->open[i];
        const double x = at.x + t * s->dir[0][i], y = at.y + t * s->dir[1][i], z = at.z + t * s->dir[2][i];
        const double across = sqrt(x * x + z * z) - major, depth = sqrt(across * across + y * y) - minor, doubt = s->spread[i] * t + off;
        const double outside = depth > doubt ? 1.0 : 0.0, sign = depth < -doubt ? -1.0 : outside, late = t > to ? 0.0 : sign, known = t < from ? 0.0 : late;
        const double clear = fabs(depth) - doubt, step = clear > least ? clear : more, next = t + step * s->per[i], stop = next > from ? from : next;
        const double safe = depth - doubt > least ? was_passed : 0.0, passed = open ? safe : was_passed;
        const double since = s->since[i], whole = since > s->hollow_to[i] ? hides : t < s->hollow_from[i] ? hides : was_hidden;
        const double hidden = known * before < 0.0 ? whole : was_hidden;

        s->sign[i] = known * known > 0.0 ? known : before;
        s->since[i] = known * known > 0.0 ? t : since;
        s->passed[i] = passed;
        s->hidden[i] = hidden;
        s->t[i] = t < from ? stop : next;
        s->open[i] = (next <= last) & (hidden == 0.0) & (passed + hides > 0.0);
    }
}

SIMD_INLINE void follow(const area_ring *r, uint32_t n, some_parts *restrict s)
{
    for (uint32_t turn = 0; turn < STEPS; turn++) {
        int64_t open = 0;

        SIMD_LOOP for (uint32_t i = 0; i < n; i++)
            open |= s->open[i];
        if (!open)
            return;
        go_on(r, n, s);
    }
    SIMD_LOOP for (uint32_t i = 0; i < n; i++)
        s->passed[i] = s->open[i] ? 0.0 : s->passed[i];
}

/* n of them from one on: a number that the compiler knows. */
SIMD_INLINE void follow_some(const area_ring *r, const area_parts *restrict p, uint32_t from, uint32_t n, some_parts *restrict s)
{
    take(r, p, from, n, s);
    find_ends(r, n, s);
    follow(r, n, s);
}

SIMD_CLONES uint64_t area_ring_misses_of(const area_ring *r, const area_parts *p, uint64_t which, uint64_t *hidden)
{
    SIMD_ALIGNED uint32_t missed[AREA_PARTS] = { 0 }, crossed[AREA_PARTS] = { 0 };

    for (uint32_t from = 0; from < p->count; from += TOGETHER) {
        some_parts s;

        if (!(which >> from & ((1u << TOGETHER) - 1)))
            continue;
        follow_some(r, p, from, TOGETHER, &s);
        SIMD_LOOP for (uint32_t i = 0; i < TOGETHER; i++) {
            missed[from + i] = s.passed[i] > 0.0 ? 1 : 0;
            crossed[from + i] = s.hidden[i] > 0.0 ? 1 : 0;
        }
    }
    *hidden = lane_mask_of(crossed, p->count) & which;
    return lane_mask_of(missed, p->count) & which;
}

bool area_ring_misses(const area_ring *r, const grid_part *part, bool *hidden)
{
    const area_parts one = area_parts_of(part);
    some_parts s;

    follow_some(r, &one, 0, 1, &s);
    *hidden = s.hidden[0] > 0.0;
    return s.passed[0] > 0.0;
}
