#include "base/simd.h"
#include "world/instance.h"

#include <string.h>

/* Rays are processed in groups of eight, as floats in their frame: docs/numerics.md has the bounds. */
enum { EIGHT = 8 };

SIMD_INLINE float greater(float a, float b) { return a > b ? a : b; }
SIMD_INLINE float lesser(float a, float b) { return a < b ? a : b; }

/* The bounds hold for fused and separate rounding. */
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

/* Largest error of any row, in units of 1 + S. */
SIMD_INLINE float most_of(const instance_filter *s) { return greater(s->lost[0], greater(s->lost[1], s->lost[2])); }

/* ---- in a frame ---- */

/* anchor, row: in the frame. */
static bool set_filter(instance_filter *s, pov_vec3 anchor, const pov_vec3 row[3], uint32_t known)
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
        s->lost[i] = INSTANCE_LOST * (fabsf(s->row[i][0]) + fabsf(s->row[i][1]) + fabsf(s->row[i][2]));
    }
    if (known == INSTANCE_IS_SPHERE)
        s->lost[0] = s->lost[1] = s->lost[2] = s->lost[0] + s->lost[1] + s->lost[2];
    return most_of(s) < (known == INSTANCE_IS_SPHERE ? 1.0f : INSTANCE_MOST);
}

bool instance_filter_make(const instance_xform *p, const bvh_frame *f, instance_filter *out)
{
    const double back = 1.0 / f->scale;
    const pov_vec3 *c = p->column, x = { c[0].x, c[1].x, c[2].x }, y = { c[0].y, c[1].y, c[2].y };
    const pov_vec3 z = { c[0].z, c[1].z, c[2].z };
    const pov_vec3 row[3] = { pov_scale(x, (double)p->per_half[0] * back), pov_scale(y, (double)p->per_half[1] * back),
                              pov_scale(z, (double)p->per_half[2] * back) };

    return p->known != INSTANCE_UNKNOWN
           && set_filter(out, pov_scale(pov_sub(p->anchor, f->centre), f->scale), row, p->known);
}

bool instance_filter_make_ellipsoid(const pov_ellipsoid *e, const bvh_frame *f, instance_filter *out)
{
    const double back = 1.0 / f->scale;
    const pov_vec3 row[3] = { pov_scale(e->row[0], back), pov_scale(e->row[1], back), pov_scale(e->row[2], back) };
    const pov_vec3 centre = pov_add(pov_sub(e->centre, f->centre), e->centre_lo);

    return set_filter(out, pov_scale(centre, f->scale), row, INSTANCE_IS_SPHERE);
}

/* ---- rays ---- */

/* Masks by lane, all bits or none; and packed. */
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

typedef struct filter_result { float lo[EIGHT], hi[EIGHT]; conditions maybe, definite, definite_pair; } filter_result;

/* The ray is definitely outside before `near` and after `far`, and inside from `last` to `first` if `certain`. */
typedef struct reach { float near, last, first, far; int certain; } reach;

/* A ray in units of the box, and its 1 + S. */
typedef struct line { three at, dir; float spread, smax; } line;

SIMD_INLINE line line_of(const instance_filter *s, const pov_rays *rays, size_t at)
{
    const three row[3] = { { s->row[0][0], s->row[0][1], s->row[0][2] },
                           { s->row[1][0], s->row[1][1], s->row[1][2] },
                           { s->row[2][0], s->row[2][1], s->row[2][2] } };
    const three dir = { rays->local.dir[0][at], rays->local.dir[1][at], rays->local.dir[2][at] };
    const three from = { rays->local.org[0][at] - s->anchor[0], rays->local.org[1][at] - s->anchor[1],
                         rays->local.org[2][at] - s->anchor[2] };
    const line l = { { dot(row[0], from), dot(row[1], from), dot(row[2], from) },
                     { dot(row[0], dir), dot(row[1], dir), dot(row[2], dir) },
                     1.0f + rays->local.size[at], rays->local.smax[at] };
    return l;
}

/* NaN changes nothing. */
SIMD_INLINE void clip_axis(reach *r, float middle, float size, float lost)
{
    const float outer = 1.0f + lost, inner = INSTANCE_INNER - lost;

    r->near = greater(sum_of(-outer, size, middle), r->near);
    r->last = greater(sum_of(-inner, size, middle), r->last);
    r->first = lesser(sum_of(inner, size, middle), r->first);
    r->far = lesser(sum_of(outer, size, middle), r->far);
}

/* For a ray parallel to a side the middle is infinite or NaN. */
SIMD_INLINE reach test_box(const instance_filter *s, const line *l)
{
    const float x = 1.0f / l->dir.x, y = 1.0f / l->dir.y, z = 1.0f / l->dir.z;
    const float to_x = -l->at.x * x, to_y = -l->at.y * y, to_z = -l->at.z * z;
    reach r = { 0.0f, 0.0f, l->smax, l->smax, fabsf(to_x + to_y + to_z) < HUGE_VALF };

    clip_axis(&r, to_x, fabsf(x), s->lost[0] * l->spread);
    clip_axis(&r, to_y, fabsf(y), s->lost[1] * l->spread);
    clip_axis(&r, to_z, fabsf(z), s->lost[2] * l->spread);
    return r;
}

/* A ray without the first root misses: `far` is NaN then. */
SIMD_INLINE reach test_sphere(const instance_filter *s, const line *l)
{
    const float lost = s->lost[0] * l->spread, outer = INSTANCE_OUTER + lost, inner = INSTANCE_INNER - lost;
    const float per = 1.0f / dot(l->dir, l->dir), middle = -dot(l->at, l->dir) * per;
    const three nearest = { sum_of(l->dir.x, middle, l->at.x), sum_of(l->dir.y, middle, l->at.y),
                            sum_of(l->dir.z, middle, l->at.z) };
    const float across = dot(nearest, nearest);
    const float to_outer = outer * outer - across, to_inner = inner * inner - across;
    const float wide = sqrtf(to_outer * per), deep = sqrtf(to_inner * per);
    const reach r = { middle - wide, middle - deep, middle + deep, lesser(l->smax, middle + wide), to_inner > 0.0f };
    return r;
}

typedef reach slab_test(const instance_filter *s, const line *l);

SIMD_INLINE void filter_lanes(const instance_filter *s, slab_test *test, const pov_rays *rays, size_t from, uint32_t n,
                              filter_result *restrict out)
{
    uint32_t i;

    for (i = 0; i < n; i++) {
        const line l = line_of(s, rays, from + i);
        const reach r = test(s, &l);
        const float sure = l.smax * (1.0f - 16.0f * INSTANCE_E) - 8.0f * INSTANCE_E * l.spread;
        const int known = r.certain & (int)(most_of(s) * l.spread < INSTANCE_UNSURE);
        const int enters = known & (int)(r.near > 0.0f) & (int)(r.last < r.first);

        out->lo[i] = r.near;
        out->hi[i] = r.last;
        out->maybe.lane[i] = -((int)(r.near <= r.far) & (int)(r.far >= 0.0f));
        out->definite.lane[i] = -(enters & (int)(r.last < sure));
        out->definite_pair.lane[i] = -(enters & (int)(r.far < sure));
    }
}

/* Not inlined: the calling loop would otherwise first spread all numbers of the instance transform over lanes and store
 * them. */
SIMD_NOINLINE SIMD_CLONES static void filter_boxes(const instance_filter *s, const pov_rays *rays, size_t from,
                                                   filter_result *restrict out)
{
    filter_lanes(s, test_box, rays, from, EIGHT, out);
}

SIMD_NOINLINE SIMD_CLONES static void filter_spheres(const instance_filter *s, const pov_rays *rays, size_t from,
                                                     filter_result *restrict out)
{
    filter_lanes(s, test_sphere, rays, from, EIGHT, out);
}

/* A single lane: other lanes may hold anything, and products of denormals are slow. */
SIMD_NOINLINE static void filter_one(const instance_filter *s, const pov_rays *rays, size_t at,
                                     filter_result *restrict out)
{
    if (s->known == INSTANCE_IS_SPHERE)
        filter_lanes(s, test_sphere, rays, at, 1, out);
    else
        filter_lanes(s, test_box, rays, at, 1, out);
}

/* Lanes that exclude `owner`. */
static inline uint32_t excluded_lanes(const uint32_t *excluded, uint32_t owner)
{
    conditions same;
    uint32_t i;

    for (i = 0; i < EIGHT; i++)
        same.lane[i] = -(excluded[i] == owner);
    return gather(&same);
}

/* Results of lanes, as bits. */
typedef struct said { uint32_t maybe, definite, definite_pair; } said;

static inline said said_of_eight(const filter_result *a, uint32_t lanes)
{
    const said r = { lanes & gather(&a->maybe), gather(&a->definite), gather(&a->definite_pair) };
    return r;
}

static inline said said_of_one(const filter_result *a)
{
    const said r = { a->maybe.lane[0] & 1u, a->definite.lane[0] & 1u, a->definite_pair.lane[0] & 1u };
    return r;
}

static inline uint32_t tell(const filter_result *a, const pov_rays *rays, uint32_t from, said what, bool sure,
                            pov_candidate *out, uint32_t n)
{
    const uint32_t definite = sure ? what.definite : 0, definite_pair = definite & what.definite_pair;
    uint32_t lanes;

    for (lanes = what.maybe; lanes; lanes &= lanes - 1, n++) {
        const uint32_t i = first_of(lanes), at = from + i;
        const double shift = rays->local.shift[at], unit = rays->local.unit[at];

        out[n].lo = shift + (double)a->lo[i] * unit;
        out[n].hi = shift + (double)a->hi[i] * unit;
        out[n].ray = (uint8_t)at;
        out[n].lane = 0;
        out[n].definite = (definite >> i & 1) != 0;
        out[n].definite_pair = (definite_pair >> i & 1) != 0;
    }
    return n;
}

uint32_t instance_filter_rays(const instance_filter *s, uint32_t owner, const pov_rays *rays, uint64_t lanes,
                              pov_candidate *out)
{
    const uint32_t known = s->known;
    uint32_t n = 0;
    filter_result a;

    while (lanes) {
        const uint32_t from = first_of64(lanes) / EIGHT * EIGHT;
        uint32_t some = (uint32_t)(lanes >> from) & 255u;

        lanes &= ~((uint64_t)255 << from);
        if (known != INSTANCE_IN_BOX)
            some &= ~excluded_lanes(rays->excluded + from, owner);
        if (!some)
            continue;
        if (!(some & (some - 1))) {
            const uint32_t at = from + first_of(some);

            filter_one(s, rays, at, &a);
            n = tell(&a, rays, at, said_of_one(&a), known != INSTANCE_IN_BOX, out, n);
            continue;
        }
        if (known == INSTANCE_IS_SPHERE)
            filter_spheres(s, rays, from, &a);
        else
            filter_boxes(s, rays, from, &a);
        n = tell(&a, rays, from, said_of_eight(&a, some), known != INSTANCE_IN_BOX, out, n);
    }
    return n;
}
