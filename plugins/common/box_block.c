#include "common/box_block.h"

#include "common/floats.h"

#include <string.h>

void common_box_begin(common_box_block *b, uint32_t n)
{
    memset(b, 0, n > 1 ? sizeof *b : COMMON_BOX_SINGLE);
    b->count = n;
}

/* Consecutive planes of a box are `step` floats apart. */
COMMON_INLINE size_t step_of(const common_box_block *b) { return b->count > 1 ? POV_BLOCK_MAX : 1; }

void common_box_put(common_box_block *b, uint32_t lane, uint32_t p, double plane)
{
    float *const at = b->plane[0] + p * step_of(b) + lane;

    *at = (float)plane;
    if (p % 2 == 1 && *at == *(at - step_of(b)))
        b->thin = 1;
}

/* Along an axis a plane at p is crossed at p * inverse + start, with an error below pad. */
typedef struct axis { float inverse, start, pad; } axis;
typedef struct line { axis x, y, z; float smax, sure; } line;

/* A ray slower than this along an axis stays between two planes, or beside them, as far as floats can tell. */
#define SLOWEST 0x1p-30f

/* Planes are off by less than 8 e (1 + S), S being the sum of the sizes of the origin's coordinates, with all errors of
 * the distances to them: docs/numerics.md has the count. */
#define BLUR (8.0f * COMMON_E)

COMMON_INLINE axis axis_of(float o, float d, float blur)
{
    const float inverse = 1.0f / (fabsf(d) > SLOWEST ? d : SLOWEST);
    const axis a = { inverse, -o * inverse, blur * fabsf(inverse) };

    return a;
}

COMMON_INLINE line line_of(const pov_rays *rays, size_t at)
{
    const common_beam r = common_beam_of(rays, at);
    const float blur = BLUR * (1.0f + r.size);
    const line l = { axis_of(r.org.x, r.dir.x, blur), axis_of(r.org.y, r.dir.y, blur), axis_of(r.org.z, r.dir.z, blur),
                     r.smax, r.sure };
    return l;
}

typedef struct planes { float lower[3], upper[3]; } planes;

COMMON_INLINE planes planes_of(const void *block, uint32_t i, size_t step)
{
    const float *at = (const float *)block + offsetof(common_box_block, plane) / sizeof(float) + i;
    const planes p = { { at[0], at[2 * step], at[4 * step] }, { at[step], at[3 * step], at[5 * step] } };

    return p;
}

/* The ray is definitely outside before `near` and after `far`, and definitely inside from `last` to `first`. */
typedef struct span { float near, last, first, far; } span;

COMMON_INLINE span clip_axis(const axis *a, float lower, float upper)
{
    const float p = common_float_sum(lower, a->inverse, a->start), q = common_float_sum(upper, a->inverse, a->start);
    const float in = common_float_lesser(p, q), out = common_float_greater(p, q);
    const span s = { in - a->pad, in + a->pad, out - a->pad, out + a->pad };

    return s;
}

COMMON_INLINE span common(span a, span b)
{
    const span s = { common_float_greater(a.near, b.near), common_float_greater(a.last, b.last),
                     common_float_lesser(a.first, b.first), common_float_lesser(a.far, b.far) };
    return s;
}

/* Does the ray go through a slab while it definitely is within another two? */
COMMON_INLINE int goes_through(const span *a, const span *within)
{
    return (int)(within->last < a->near) & (int)(a->far < within->first);
}

/* Within a slab that is thin no ray is for certain, but there are those that go through it within the others. */
COMMON_INLINE int enters_thin(const span *x, const span *y, const span *z)
{
    const span xy = common(*x, *y), xz = common(*x, *z), yz = common(*y, *z);

    return goes_through(z, &xy) | goes_through(y, &xz) | goes_through(x, &yz);
}

COMMON_INLINE void test(const planes *p, const line *l, uint32_t i, bool thin, common_chords *restrict out,
                        common_conditions *restrict say)
{
    const span x = clip_axis(&l->x, p->lower[0], p->upper[0]), y = clip_axis(&l->y, p->lower[1], p->upper[1]);
    const span z = clip_axis(&l->z, p->lower[2], p->upper[2]), s = common(common(x, y), z);
    const int is_ahead = s.near > 0.0f, enters = is_ahead & (int)(s.last < s.first);
    const int stays = (int)(s.last < 0.0f) & (int)(s.first > l->smax), hits = thin ? enters | (is_ahead & enters_thin(&x, &y, &z)) : enters;

    out->lo[i] = s.near;
    out->hi[i] = s.last;
    say->maybe.lane[i] = -((common_float_greater(s.near, 0.0f) <= common_float_lesser(s.far, l->smax)) & !stays);
    say->definite.lane[i] = -(hits & (int)(s.last < l->sure));
    say->definite_pair.lane[i] = -(enters & (int)(s.far < l->sure));
}

COMMON_INLINE bool is_thin(const void *block) { return ((const common_box_block *)block)->thin != 0; }

COMMON_INLINE void test_rays(const planes *p, const pov_rays *rays, size_t from, bool thin, common_chords *restrict out,
                             common_conditions *restrict say)
{
    for (uint32_t i = 0; i < COMMON_FLOATS; i++) {
        const line l = line_of(rays, from + i);
        test(p, &l, i, thin, out, say);
    }
}

COMMON_INLINE void filter_lanes(const planes *p, const pov_rays *rays, size_t from, uint32_t some, bool thin,
                                common_chords *restrict out)
{
    common_conditions say;

    if (thin)
        test_rays(p, rays, from, true, out, &say);
    else
        test_rays(p, rays, from, false, out, &say);
    common_gather(&say, COMMON_FLOATS, some, out);
}

COMMON_INLINE void filter_rays(const void *block, uint32_t which, const pov_rays *rays, size_t from, uint32_t some,
                               common_chords *restrict out)
{
    const planes p = planes_of(block, which, POV_BLOCK_MAX);

    filter_lanes(&p, rays, from, some, is_thin(block), out);
}

COMMON_INLINE void test_boxes(const void *block, const line *l, bool thin, common_chords *restrict out, common_conditions *restrict say)
{
    for (uint32_t i = 0; i < POV_BLOCK_MAX; i++) {
        const planes p = planes_of(block, i, POV_BLOCK_MAX);
        test(&p, l, i, thin, out, say);
    }
}

COMMON_INLINE void filter_boxes(const void *block, const pov_rays *rays, size_t at, uint32_t some,
                                common_chords *restrict out)
{
    const line l = line_of(rays, at);
    common_conditions say;

    if (is_thin(block))
        test_boxes(block, &l, true, out, &say);
    else
        test_boxes(block, &l, false, out, &say);
    common_gather(&say, POV_BLOCK_MAX, some, out);
}

/* The same for a block of a single box. */
COMMON_INLINE void filter_rays_single(const void *block, uint32_t which, const pov_rays *rays, size_t from,
                                      uint32_t some, common_chords *restrict out)
{
    const planes p = planes_of(block, which, 1);

    filter_lanes(&p, rays, from, some, is_thin(block), out);
}

COMMON_INLINE void filter_single(const void *block, const pov_rays *rays, size_t at, uint32_t some,
                                 common_chords *restrict out)
{
    const line l = line_of(rays, at);
    const planes p = planes_of(block, 0, 1);
    common_conditions say;

    test(&p, &l, 0, is_thin(block), out, &say);
    out->maybe = some & (uint32_t)say.maybe.lane[0];
    out->definite = (uint32_t)say.definite.lane[0];
    out->definite_pair = (uint32_t)say.definite_pair.lane[0];
}

/* Static, because the names of clones would be exported. */
COMMON_CLONES static uint32_t filter(const common_box_block *b, const uint32_t *owners, const pov_rays *rays,
                                     uint64_t lanes, pov_candidate *out)
{
    if (b->count == 1)
        return common_filter_in_lanes(b, 1, owners, rays, lanes, filter_rays_single, filter_single, out);
    return common_filter_in_lanes(b, b->count, owners, rays, lanes, filter_rays, filter_boxes, out);
}

uint32_t common_box_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                           pov_candidate *out)
{
    return filter(block, owners, rays, lanes, out);
}
