#include "base/simd.h"
#include "world/bits.h"
#include "world/placement_parts.h"

SIMD_INLINE double greater(double a, double b) { return a > b ? a : b; }
SIMD_INLINE double most_of(double a, double b, double c) { return greater(a, greater(b, c)); }
SIMD_INLINE double lesser(double a, double b) { return a < b ? a : b; }

/* The ray in the shape's own space, seen from the anchor, and what is lost there; all rounded. size: of the start seen
 * from the anchor, in the world. */
typedef struct own_line { pov_vec3 at, way, lost; double size; } own_line;

SIMD_INLINE pov_vec3 apply(const placement *p, pov_vec3 v)
{
    const pov_vec3 x = p->column[0], y = p->column[1], z = p->column[2];

    return pov_vec3_of(x.x * v.x + y.x * v.y + z.x * v.z, x.y * v.x + y.y * v.y + z.y * v.z,
                       x.z * v.x + y.z * v.y + z.z * v.z);
}

/* By row, the largest of the sizes. */
SIMD_INLINE pov_vec3 largest_of_rows(const placement *p)
{
    const pov_vec3 x = p->column[0], y = p->column[1], z = p->column[2];

    return pov_vec3_of(most_of(fabs(x.x), fabs(y.x), fabs(z.x)), most_of(fabs(x.y), fabs(y.y), fabs(z.y)),
                       most_of(fabs(x.z), fabs(y.z), fabs(z.z)));
}

static inline double sum_of_sizes(pov_vec3 v) { return fabs(v.x) + fabs(v.y) + fabs(v.z); }

SIMD_INLINE own_line line_of(const placement *p, pov_vec3 largest, pov_vec3 org, pov_vec3 org_lo, pov_vec3 dir)
{
    const pov_vec3 from = pov_sub(org, p->anchor);
    own_line l;

    l.at = apply(p, pov_add(from, org_lo));
    l.way = apply(p, dir);
    l.size = sum_of_sizes(from) + sum_of_sizes(org_lo);
    l.lost = pov_scale(largest, PLACEMENT_LOST * l.size);
    return l;
}

/* Before `near` and after `far` the ray is outside, from `late` to `soon` it is inside; if that is certain. */
typedef struct reach { double near, late, soon, far; int missed, certain; } reach;

SIMD_INLINE void meet_axis(reach *r, double half, double at, double per, double lost, double most_lost)
{
    const double middle = -at * per, size = fabs(per);
    const double outer = (half + lost) * size, inner = (PLACEMENT_INNER * half - most_lost) * size;

    r->near = greater(middle - outer, r->near);
    r->late = greater(middle - inner, r->late);
    r->soon = lesser(middle + inner, r->soon);
    r->far = lesser(middle + outer, r->far);
}

SIMD_INLINE reach meet_box(const placement *p, const own_line *l)
{
    const double x = 1.0 / l->way.x, y = 1.0 / l->way.y, z = 1.0 / l->way.z;
    const double lost = most_of(l->lost.x, l->lost.y, l->lost.z);
    reach r = { -HUGE_VAL, -HUGE_VAL, HUGE_VAL, HUGE_VAL, 0, 0 };

    meet_axis(&r, (double)p->half[0], l->at.x, x, l->lost.x, lost);
    meet_axis(&r, (double)p->half[1], l->at.y, y, l->lost.y, lost);
    meet_axis(&r, (double)p->half[2], l->at.z, z, l->lost.z, lost);
    r.missed = r.near > r.far;
    /* None of them is without end, or no number. */
    r.certain = (fabs(l->at.x * x) + fabs(l->at.y * y)) + (fabs(l->at.z * z) + fabs(x + y + z)) < HUGE_VAL;
    return r;
}

/* Where what is lost is as large as the ball, or squares of the direction leave the range, nothing is certain. A root
 * that is not there is no number, and not looked at. */
SIMD_INLINE reach meet_ball(const placement *p, const own_line *l)
{
    const double half = (double)p->half[0], lost = 2.0 * most_of(l->lost.x, l->lost.y, l->lost.z);
    const double square = pov_dot(l->way, l->way);
    const int sound = (int)(lost < 0.5 * half) & (int)(square > 1e-100) & (int)(square < 1e100);
    const double blur = sound ? lost : HUGE_VAL;
    const double outer = PLACEMENT_OUTER * half + blur, inner = PLACEMENT_INNER * half - blur;
    const double per = 1.0 / square, middle = -pov_dot(l->at, l->way) * per;
    const pov_vec3 nearest = pov_add(l->at, pov_scale(l->way, middle));
    const double across = pov_dot(nearest, nearest);
    const double to_outer = outer * outer - across, to_inner = inner * inner - across;
    const double wide = sqrt(to_outer * per), deep = sqrt(to_inner * per);
    reach r;

    r.near = middle - wide;
    r.late = middle - deep;
    r.soon = middle + deep;
    r.far = middle + wide;
    r.missed = to_outer < 0.0;
    r.certain = (inner > 0.0) & (to_inner > 0.0);
    return r;
}

/* What is asked of a reach. */
SIMD_INLINE double later(double t) { return t + t * PLACEMENT_LATE; }

SIMD_INLINE int is_missed(const reach *r, double tmax)
{
    return r->missed | (r->near > later(tmax)) | (r->far < 0.0);
}

SIMD_INLINE int is_entered(const reach *r, double tmax)
{
    return r->certain & (int)(r->near > 0.0) & (int)(r->late < r->soon) & (int)(later(r->late) < tmax);
}

enum { TOGETHER = 4 };

typedef struct masks { int64_t missed, surely, twice; double lo[TOGETHER], hi[TOGETHER]; } masks;

SIMD_INLINE pov_vec3 lane_of(const double v[3][POV_RAYS_MAX], size_t i)
{
    return pov_vec3_of(v[0][i], v[1][i], v[2][i]);
}

typedef reach meeting(const placement *p, const own_line *l);

SIMD_INLINE void meet_some(const placement *p, meeting *meet, pov_vec3 largest, const pov_rays *rays, size_t from,
                           masks *restrict out)
{
    const int64_t bit[TOGETHER] = { 1, 2, 4, 8 };
    int64_t missed = 0, surely = 0, twice = 0;
    size_t i;

    for (i = 0; i < TOGETHER; i++) {
        const size_t at = from + i;
        const pov_vec3 org = lane_of(rays->org, at), org_lo = lane_of(rays->org_lo, at), dir = lane_of(rays->dir, at);
        const own_line l = line_of(p, largest, org, org_lo, dir);
        const reach r = meet(p, &l);

        missed |= is_missed(&r, rays->tmax[at]) ? bit[i] : 0;
        surely |= is_entered(&r, rays->tmax[at]) ? bit[i] : 0;
        twice |= later(r.far) < rays->tmax[at] ? bit[i] : 0;
        out->lo[i] = r.near;
        out->hi[i] = r.late;
    }
    out->missed = missed;
    out->surely = p->known == PLACEMENT_IN_BOX ? 0 : surely;
    out->twice = twice;
}

SIMD_INLINE uint32_t tell(const masks *m, uint32_t from, uint32_t lanes, pov_meeting *out, uint32_t n)
{
    for (lanes &= ~(uint32_t)m->missed; lanes; lanes &= lanes - 1, n++) {
        const uint32_t i = first_of(lanes);

        out[n].lo = m->lo[i];
        out[n].hi = m->hi[i];
        out[n].ray = (uint8_t)(from + i);
        out[n].lane = 0;
        out[n].surely = m->surely >> i & 1;
        out[n].twice = (m->surely & m->twice) >> i & 1;
    }
    return n;
}

/* Four after four, as far as there are any. */
SIMD_INLINE uint32_t meet_many(const placement *p, meeting *meet, const pov_rays *rays, uint64_t lanes, pov_meeting *out)
{
    const pov_vec3 largest = largest_of_rows(p);
    const uint32_t all = (1u << TOGETHER) - 1;
    uint32_t n = 0;
    masks m;

    while (lanes) {
        const uint32_t from = first_of64(lanes) / TOGETHER * TOGETHER;

        meet_some(p, meet, largest, rays, from, &m);
        n = tell(&m, from, (uint32_t)(lanes >> from) & all, out, n);
        lanes &= ~((uint64_t)all << from);
    }
    return n;
}

SIMD_CLONES static uint32_t meet_boxes(const placement *p, const pov_rays *rays, uint64_t lanes, pov_meeting *out)
{
    return meet_many(p, meet_box, rays, lanes, out);
}

SIMD_CLONES static uint32_t meet_balls(const placement *p, const pov_rays *rays, uint64_t lanes, pov_meeting *out)
{
    return meet_many(p, meet_ball, rays, lanes, out);
}

uint32_t placement_filter(const placement *p, const pov_rays *rays, uint64_t lanes, pov_meeting *out)
{
    return p->known == PLACEMENT_IS_BALL ? meet_balls(p, rays, lanes, out) : meet_boxes(p, rays, lanes, out);
}
