/* Filters up to eight cylinders or cones at once, in floats: possible and definite hits, with bounds on their
 * distances. */
#include "common/cone_bounds.h"

static double sum_of(pov_vec3 a) { return common_sum_of_components(a); }

static double middle_of(pov_two anchor, pov_two axis, double centre, double scale)
{
    return (anchor.hi - centre + anchor.lo + 0.5 * axis.hi) * scale;
}

/* Factor of the entries of a row. */
#define LOST (12.0 * (double)COMMON_E)
#define TOO_SMALL 0x1p20

/* A shape that is too small for the frame is a possible hit of every ray that comes near. */
static common_one describe(const pov_frame *frame, const common_cone *s)
{
    double sum[3];
    common_one one;
    int k;

    one.centre.x = (float)middle_of(s->anchor.x, s->axis.x, frame->centre.x, frame->scale);
    one.centre.y = (float)middle_of(s->anchor.y, s->axis.y, frame->centre.y, frame->scale);
    one.centre.z = (float)middle_of(s->anchor.z, s->axis.z, frame->centre.z, frame->scale);
    for (k = 0; k < 3; k++) {
        const pov_vec3 row = pov_scale(pov_two3_hi(s->row[k]), s->scale / frame->scale);

        sum[k] = sum_of(row);
        one.row[k].x = sum[k] < TOO_SMALL ? (float)row.x : 0.0f;
        one.row[k].y = sum[k] < TOO_SMALL ? (float)row.y : 0.0f;
        one.row[k].z = sum[k] < TOO_SMALL ? (float)row.z : 0.0f;
    }
    one.radius = (float)(s->radius.hi + 0.5 * s->slope.hi * s->height.hi);
    one.slope = (float)s->slope.hi;
    one.half = (float)(0.5 * s->height.hi);
    one.high = (float)(LOST * pov_min(sum[2], TOO_SMALL)) + 16.0f * COMMON_E;
    one.wide = (float)(LOST * pov_min(1.5 * pov_max(sum[0], sum[1]) + fabs(s->slope.hi) * sum[2], TOO_SMALL))
        + 32.0f * COMMON_E;
    one.closed = s->open ? 0.0f : HUGE_VALF;
    return one;
}

/* Consecutive numbers of a shape are `step` floats apart: POV_BLOCK_MAX, or one for a block of a single shape. */
static void put_three(float *to, size_t step, common_three v)
{
    to[0] = v.x;
    to[step] = v.y;
    to[2 * step] = v.z;
}

static void put_one(float *to, size_t step, const common_one *s)
{
    const float rest[6] = { s->radius, s->slope, s->half, s->wide, s->high, s->closed };
    uint32_t k;

    put_three(to, step, s->centre);
    for (k = 0; k < 3; k++)
        put_three(to + (3 + 3 * k) * step, step, s->row[k]);
    for (k = 0; k < 6; k++)
        to[(12 + k) * step] = rest[k];
}

COMMON_INLINE common_three get_three(const float *at, size_t step)
{
    const common_three v = { at[0], at[step], at[2 * step] };
    return v;
}

COMMON_INLINE common_one get_one(const float *at, size_t step)
{
    const common_one s = { get_three(at, step),
                        { get_three(at + 3 * step, step), get_three(at + 6 * step, step), get_three(at + 9 * step, step) },
                        at[12 * step], at[13 * step], at[14 * step], at[15 * step], at[16 * step], at[17 * step] };
    return s;
}

bool common_cone_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    const size_t step = n > 1 ? POV_BLOCK_MAX : 1;
    common_cone_block *b = block;
    uint32_t i;

    if (!frame)
        return false;
    b->count = n;
    for (i = 0; i < step; i++) {
        const common_cone *s = selves[i < n ? i : 0];
        common_one one;

        if (s->empty)
            return false;
        one = describe(frame, s);
        put_one(b->number[0] + i, step, &one);
    }
    return true;
}

/* Numbers of lines that one loop leaves for the next. */
typedef struct lines {
    float x[COMMON_FLOATS], y[COMMON_FLOATS], z[COMMON_FLOATS], dx[COMMON_FLOATS], dy[COMMON_FLOATS], dz[COMMON_FLOATS];
    float middle[COMMON_FLOATS], discriminant[COMMON_FLOATS];
} lines;

/* Does a line possibly hit? */
COMMON_INLINE int32_t find(const common_one *s, const common_beam *ray, uint32_t i, lines *restrict out)
{
    const common_line l = common_find_line(s, ray);

    out->x[i] = l.p.x;
    out->y[i] = l.p.y;
    out->z[i] = l.p.z;
    out->dx[i] = l.d.x;
    out->dy[i] = l.d.y;
    out->dz[i] = l.d.z;
    out->middle[i] = l.middle;
    out->discriminant[i] = l.discriminant;
    return -!common_line_misses(s, ray, &l);
}

/* An open shape can be entered through its side only. */
COMMON_INLINE void bound(const common_one *s, const common_beam *ray, const lines *all, uint32_t i,
                         common_chords *restrict out, common_conditions *restrict say)
{
    const common_line l = { { all->x[i], all->y[i], all->z[i] }, { all->dx[i], all->dy[i], all->dz[i] }, all->middle[i],
                         all->discriminant[i] };
    const common_reach side = common_side(s, ray, &l), slab = common_slab(s, ray, &l);
    const float first = common_float_greater(side.lo - slab.late, s->closed);
    const float lo = common_float_greater(side.lo, slab.lo), late = common_float_greater(side.late, slab.late);
    const float hi = common_float_lesser(side.hi, slab.hi), soon = common_float_lesser(side.soon, slab.soon);
    const float blur = common_blur(s, ray, l.middle);
    const int blind = !(blur < 1.0f);
    const int within = (int)(lo <= hi) & (int)(lo <= ray->smax) & (int)(hi >= 0.0f);
    const int enters = (int)(late < soon) & (int)(lo > 0.0f) & (int)(late < ray->sure) & (int)(first > 0.0f) &
                       (int)(blur < COMMON_BLURRED);

    out->lo[i] = blind ? -HUGE_VALF : lo;
    out->hi[i] = late;
    say->maybe.lane[i] = -(blind | within);
    say->definite.lane[i] = -enters;
    say->definite_pair.lane[i] = -(enters & (int)(hi < common_float_lesser(ray->sure, s->closed)));
}

/* Floats before the numbers of a block. */
enum { HEAD = offsetof(common_cone_block, number) / sizeof(float) };

/* Some rays at one shape. */
COMMON_INLINE void filter_lanes(const common_one *s, const pov_rays *rays, size_t from, uint32_t some,
                                common_chords *restrict out)
{
    common_conditions say;
    uint32_t i;
    lines l;

    for (i = 0; i < COMMON_FLOATS; i++) {
        const common_beam ray = common_beam_of(rays, from + i);
        say.maybe.lane[i] = find(s, &ray, i, &l);
    }
    some &= common_bits_of(&say.maybe, COMMON_FLOATS);
    out->maybe = 0;
    if (!some)
        return;
    for (i = 0; i < COMMON_FLOATS; i++) {
        const common_beam ray = common_beam_of(rays, from + i);
        bound(s, &ray, &l, i, out, &say);
    }
    common_gather(&say, COMMON_FLOATS, some, out);
}

COMMON_INLINE void filter_rays(const void *block, uint32_t which, const pov_rays *rays, size_t from, uint32_t some,
                               common_chords *restrict out)
{
    const common_one s = get_one((const float *)block + HEAD + which, POV_BLOCK_MAX);

    filter_lanes(&s, rays, from, some, out);
}

COMMON_INLINE void filter_shapes(const void *block, const pov_rays *rays, size_t at, uint32_t some,
                                 common_chords *restrict out)
{
    const common_beam ray = common_beam_of(rays, at);
    common_conditions say;
    uint32_t i;
    lines l;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const common_one s = get_one((const float *)block + HEAD + i, POV_BLOCK_MAX);
        say.maybe.lane[i] = find(&s, &ray, i, &l);
    }
    some &= common_bits_of(&say.maybe, POV_BLOCK_MAX);
    out->maybe = 0;
    if (!some)
        return;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const common_one s = get_one((const float *)block + HEAD + i, POV_BLOCK_MAX);
        bound(&s, &ray, &l, i, out, &say);
    }
    common_gather(&say, POV_BLOCK_MAX, some, out);
}

/* The same for a block of a single shape. */
COMMON_INLINE void filter_rays_single(const void *block, uint32_t which, const pov_rays *rays, size_t from,
                                      uint32_t some, common_chords *restrict out)
{
    const common_one s = get_one((const float *)block + HEAD, 1);

    (void)which;
    filter_lanes(&s, rays, from, some, out);
}

COMMON_INLINE void filter_single(const void *block, const pov_rays *rays, size_t at, uint32_t some,
                                 common_chords *restrict out)
{
    const common_one s = get_one((const float *)block + HEAD, 1);
    const common_beam ray = common_beam_of(rays, at);
    common_conditions say;
    lines l;

    out->maybe = 0;
    if (!find(&s, &ray, 0, &l))
        return;
    bound(&s, &ray, &l, 0, out, &say);
    out->maybe = some & (uint32_t)say.maybe.lane[0];
    out->definite = (uint32_t)say.definite.lane[0];
    out->definite_pair = (uint32_t)say.definite_pair.lane[0];
}

/* Static, because the names of clones would be exported. */
COMMON_CLONES static uint32_t filter(const common_cone_block *b, const uint32_t *owners, const pov_rays *rays,
                                     uint64_t lanes, pov_candidate *out)
{
    if (b->count == 1)
        return common_filter_in_lanes(b, 1, owners, rays, lanes, filter_rays_single, filter_single, out);
    return common_filter_in_lanes(b, b->count, owners, rays, lanes, filter_rays, filter_shapes, out);
}

uint32_t common_cone_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                            pov_candidate *out)
{
    return filter(block, owners, rays, lanes, out);
}
