#include "base/bits.h"
#include "base/simd.h"
#include "world/instance.h"

#include <string.h>

/* Rays go by eights, as floats in the frame that they stand in: docs/numerics.md has the bounds. */
enum { EIGHT = 8 };

SIMD_INLINE float greater(float a, float b) { return a > b ? a : b; }
SIMD_INLINE float lesser(float a, float b) { return a < b ? a : b; }

/* The bounds hold for one rounding as for two. */
SIMD_INLINE float sum_of(float a, float b, float c)
{
#ifdef __FMA__
    return fmaf(a, b, c);
#else
    return a * b + c;
#endif
}

typedef struct three { float x, y, z; } three;

SIMD_INLINE float dot(three a, three b) { return sum_of(a.z, b.z, sum_of(a.y, b.y, a.x * b.x)); }

/* Of what is lost of any row, in units of 1 + S. */
SIMD_INLINE float most_of(const stand *s) { return greater(s->lost[0], greater(s->lost[1], s->lost[2])); }

/* ---- in a frame ---- */

/* anchor, row: in the frame. */
static bool set_stand(stand *s, pov_vec3 anchor, const pov_vec3 row[3], uint32_t known)
{
    int i;

    s->known = known;
    s->anchor[0] = (float)anchor.x;
    s->anchor[1] = (float)anchor.y;
    s->anchor[2] = (float)anchor.z;
    for (i = 0; i < 3; i++) {
        s->row[i][0] = (float)row[i].x;
        s->row[i][1] = (float)row[i].y;
        s->row[i][2] = (float)row[i].z;
        s->lost[i] = PLACEMENT_LOST * (fabsf(s->row[i][0]) + fabsf(s->row[i][1]) + fabsf(s->row[i][2]));
    }
    if (known == PLACEMENT_IS_BALL)
        s->lost[0] = s->lost[1] = s->lost[2] = s->lost[0] + s->lost[1] + s->lost[2];
    return most_of(s) < (known == PLACEMENT_IS_BALL ? 1.0f : PLACEMENT_MOST);
}

bool placement_stand(const placement *p, const bvh_frame *f, stand *out)
{
    const double back = 1.0 / f->scale;
    const pov_vec3 *c = p->column, x = { c[0].x, c[1].x, c[2].x }, y = { c[0].y, c[1].y, c[2].y };
    const pov_vec3 z = { c[0].z, c[1].z, c[2].z };
    const pov_vec3 row[3] = { pov_scale(x, (double)p->per_half[0] * back), pov_scale(y, (double)p->per_half[1] * back),
                              pov_scale(z, (double)p->per_half[2] * back) };

    return p->known != PLACEMENT_UNKNOWN
           && set_stand(out, pov_scale(pov_sub(p->anchor, f->centre), f->scale), row, p->known);
}

bool placement_stand_ellipsoid(const pov_ellipsoid *e, const bvh_frame *f, stand *out)
{
    const double back = 1.0 / f->scale;
    const pov_vec3 row[3] = { pov_scale(e->row[0], back), pov_scale(e->row[1], back), pov_scale(e->row[2], back) };
    const pov_vec3 centre = pov_add(pov_sub(e->centre, f->centre), e->centre_lo);

    return set_stand(out, pov_scale(centre, f->scale), row, PLACEMENT_IS_BALL);
}

/* ---- rays ---- */

/* By lane, all bits or none; and as bits. */
typedef struct conditions { int32_t lane[EIGHT]; } conditions;

SIMD_INLINE uint32_t gather(const conditions *c)
{
#if defined(__AVX2__) && defined(__GNUC__)
    typedef float floats __attribute__((vector_size(32)));
    floats f;

    memcpy(&f, c->lane, sizeof f);
    return (uint32_t)__builtin_ia32_movmskps256(f);
#else
    uint32_t bits = 0, i;

    for (i = 0; i < EIGHT; i++)
        bits |= (uint32_t)c->lane[i] & 1u << i;
    return bits;
#endif
}

typedef struct answer { float lo[EIGHT], hi[EIGHT]; conditions maybe, surely, twice; } answer;

/* Within the ray's interval, it is outside before `near` and after `far`, and inside from `last` to `first` if that is
 * certain. */
typedef struct reach { float near, last, first, far; int certain; } reach;

/* A ray in the units of the box, and what 1 + S is of it. */
typedef struct line { three at, way; float spread, smax; } line;

SIMD_INLINE line line_of(const stand *s, const pov_rays *rays, size_t at)
{
    const three row[3] = { { s->row[0][0], s->row[0][1], s->row[0][2] },
                           { s->row[1][0], s->row[1][1], s->row[1][2] },
                           { s->row[2][0], s->row[2][1], s->row[2][2] } };
    const three dir = { rays->framed.dir[0][at], rays->framed.dir[1][at], rays->framed.dir[2][at] };
    const three from = { rays->framed.org[0][at] - s->anchor[0], rays->framed.org[1][at] - s->anchor[1],
                         rays->framed.org[2][at] - s->anchor[2] };
    const line l = { { dot(row[0], from), dot(row[1], from), dot(row[2], from) },
                     { dot(row[0], dir), dot(row[1], dir), dot(row[2], dir) },
                     1.0f + rays->framed.size[at], rays->framed.smax[at] };
    return l;
}

/* What is no number changes nothing. */
SIMD_INLINE void meet_axis(reach *r, float middle, float size, float lost)
{
    const float outer = 1.0f + lost, inner = PLACEMENT_INNER - lost;

    r->near = greater(sum_of(-outer, size, middle), r->near);
    r->last = greater(sum_of(-inner, size, middle), r->last);
    r->first = lesser(sum_of(inner, size, middle), r->first);
    r->far = lesser(sum_of(outer, size, middle), r->far);
}

/* A ray along a side has a middle without end, or none. */
SIMD_INLINE reach meet_box(const stand *s, const line *l)
{
    const float x = 1.0f / l->way.x, y = 1.0f / l->way.y, z = 1.0f / l->way.z;
    const float to_x = -l->at.x * x, to_y = -l->at.y * y, to_z = -l->at.z * z;
    reach r = { 0.0f, 0.0f, l->smax, l->smax, fabsf(to_x + to_y + to_z) < HUGE_VALF };

    meet_axis(&r, to_x, fabsf(x), s->lost[0] * l->spread);
    meet_axis(&r, to_y, fabsf(y), s->lost[1] * l->spread);
    meet_axis(&r, to_z, fabsf(z), s->lost[2] * l->spread);
    return r;
}

/* A ray without the first root misses: `far` is no number then. */
SIMD_INLINE reach meet_ball(const stand *s, const line *l)
{
    const float lost = s->lost[0] * l->spread, outer = PLACEMENT_OUTER + lost, inner = PLACEMENT_INNER - lost;
    const float per = 1.0f / dot(l->way, l->way), middle = -dot(l->at, l->way) * per;
    const three nearest = { sum_of(l->way.x, middle, l->at.x), sum_of(l->way.y, middle, l->at.y),
                            sum_of(l->way.z, middle, l->at.z) };
    const float across = dot(nearest, nearest);
    const float to_outer = outer * outer - across, to_inner = inner * inner - across;
    const float wide = sqrtf(to_outer * per), deep = sqrtf(to_inner * per);
    const reach r = { middle - wide, middle - deep, middle + deep, lesser(l->smax, middle + wide), to_inner > 0.0f };
    return r;
}

typedef reach meeting(const stand *s, const line *l);

SIMD_INLINE void meet_lanes(const stand *s, meeting *meet, const pov_rays *rays, size_t from, uint32_t n,
                            answer *restrict out)
{
    uint32_t i;

    for (i = 0; i < n; i++) {
        const line l = line_of(s, rays, from + i);
        const reach r = meet(s, &l);
        const float sure = l.smax * (1.0f - 16.0f * PLACEMENT_E) - 8.0f * PLACEMENT_E * l.spread;
        const int known = r.certain & (int)(most_of(s) * l.spread < PLACEMENT_UNSURE);
        const int enters = known & (int)(r.near > 0.0f) & (int)(r.last < r.first);

        out->lo[i] = r.near;
        out->hi[i] = r.last;
        out->maybe.lane[i] = -((int)(r.near <= r.far) & (int)(r.far >= 0.0f));
        out->surely.lane[i] = -(enters & (int)(r.last < sure));
        out->twice.lane[i] = -(enters & (int)(r.far < sure));
    }
}

/* Apart, for in the loop that calls them a placement's numbers would all be spread over lanes and put by beforehand. */
SIMD_APART SIMD_CLONES static void meet_boxes(const stand *s, const pov_rays *rays, size_t from, answer *restrict out)
{
    meet_lanes(s, meet_box, rays, from, EIGHT, out);
}

SIMD_APART SIMD_CLONES static void meet_balls(const stand *s, const pov_rays *rays, size_t from, answer *restrict out)
{
    meet_lanes(s, meet_ball, rays, from, EIGHT, out);
}

/* One by itself: beside a ray that goes alone there may be anything, and products of what is all but zero are slow. */
SIMD_APART static void meet_one(const stand *s, const pov_rays *rays, size_t at, answer *restrict out)
{
    if (s->known == PLACEMENT_IS_BALL)
        meet_lanes(s, meet_ball, rays, at, 1, out);
    else
        meet_lanes(s, meet_box, rays, at, 1, out);
}

/* Those that go away from `owner`. */
static inline uint32_t away_from(const uint32_t *away, uint32_t owner)
{
    conditions same;
    uint32_t i;

    for (i = 0; i < EIGHT; i++)
        same.lane[i] = -(away[i] == owner);
    return gather(&same);
}

/* What is said of lanes, as bits. */
typedef struct said { uint32_t maybe, surely, twice; } said;

static inline said said_of_eight(const answer *a, uint32_t lanes)
{
    const said r = { lanes & gather(&a->maybe), gather(&a->surely), gather(&a->twice) };
    return r;
}

static inline said said_of_one(const answer *a)
{
    const said r = { a->maybe.lane[0] & 1u, a->surely.lane[0] & 1u, a->twice.lane[0] & 1u };
    return r;
}

static inline uint32_t tell(const answer *a, const pov_rays *rays, uint32_t from, said what, bool sure,
                            pov_meeting *out, uint32_t n)
{
    const uint32_t surely = sure ? what.surely : 0, twice = surely & what.twice;
    uint32_t lanes;

    for (lanes = what.maybe; lanes; lanes &= lanes - 1, n++) {
        const uint32_t i = first_of(lanes), at = from + i;
        const double shift = rays->framed.shift[at], unit = rays->framed.unit[at];

        out[n].lo = shift + (double)a->lo[i] * unit;
        out[n].hi = shift + (double)a->hi[i] * unit;
        out[n].ray = (uint8_t)at;
        out[n].lane = 0;
        out[n].surely = (surely >> i & 1) != 0;
        out[n].twice = (twice >> i & 1) != 0;
    }
    return n;
}

uint32_t placement_filter(const stand *s, uint32_t owner, const pov_rays *rays, uint64_t lanes, pov_meeting *out)
{
    const uint32_t known = s->known;
    uint32_t n = 0;
    answer a;

    while (lanes) {
        const uint32_t from = first_of64(lanes) / EIGHT * EIGHT;
        uint32_t some = (uint32_t)(lanes >> from) & 255u;

        lanes &= ~((uint64_t)255 << from);
        if (known != PLACEMENT_IN_BOX)
            some &= ~away_from(rays->away + from, owner);
        if (!some)
            continue;
        if (!(some & (some - 1))) {
            const uint32_t at = from + first_of(some);

            meet_one(s, rays, at, &a);
            n = tell(&a, rays, at, said_of_one(&a), known != PLACEMENT_IN_BOX, out, n);
            continue;
        }
        if (known == PLACEMENT_IS_BALL)
            meet_balls(s, rays, from, &a);
        else
            meet_boxes(s, rays, from, &a);
        n = tell(&a, rays, from, said_of_eight(&a, some), known != PLACEMENT_IN_BOX, out, n);
    }
    return n;
}
