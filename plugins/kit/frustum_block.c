/* Filters up to eight cylinders or cones at once, in floats: possible and definite hits, with bounds on their
 * distances. */
#include "kit/frustum_bounds.h"

static double sum_of(pov_vec3 a) { return kit_sum_of_components(a); }

static double middle_of(pov_two anchor, pov_two axis, double centre, double scale)
{
    return (anchor.hi - centre + anchor.lo + 0.5 * axis.hi) * scale;
}

/* Factor of the entries of a row. */
#define LOST (12.0 * (double)KIT_E)
#define TOO_SMALL 0x1p20

/* A shape that is too small for the frame is a possible hit of every ray that comes near. */
static kit_one describe(const pov_frame *frame, const kit_frustum *s)
{
    double sum[3];
    kit_one one;
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
    one.high = (float)(LOST * fmin(sum[2], TOO_SMALL)) + 16.0f * KIT_E;
    one.wide = (float)(LOST * fmin(1.5 * fmax(sum[0], sum[1]) + fabs(s->slope.hi) * sum[2], TOO_SMALL)) + 32.0f * KIT_E;
    one.closed = s->open ? 0.0f : HUGE_VALF;
    return one;
}

/* Consecutive numbers of a shape are `step` floats apart: POV_BLOCK_MAX, or one for a block of a single shape. */
static void put_three(float *to, size_t step, kit_three v)
{
    to[0] = v.x;
    to[step] = v.y;
    to[2 * step] = v.z;
}

static void put_one(float *to, size_t step, const kit_one *s)
{
    const float rest[6] = { s->radius, s->slope, s->half, s->wide, s->high, s->closed };
    uint32_t k;

    put_three(to, step, s->centre);
    for (k = 0; k < 3; k++)
        put_three(to + (3 + 3 * k) * step, step, s->row[k]);
    for (k = 0; k < 6; k++)
        to[(12 + k) * step] = rest[k];
}

KIT_INLINE kit_three get_three(const float *at, size_t step)
{
    const kit_three v = { at[0], at[step], at[2 * step] };
    return v;
}

KIT_INLINE kit_one get_one(const float *at, size_t step)
{
    const kit_one s = { get_three(at, step),
                        { get_three(at + 3 * step, step), get_three(at + 6 * step, step), get_three(at + 9 * step, step) },
                        at[12 * step], at[13 * step], at[14 * step], at[15 * step], at[16 * step], at[17 * step] };
    return s;
}

bool kit_frustum_pack(void *block, const pov_frame *frame, const void *const *selves, uint32_t n)
{
    const size_t step = n > 1 ? POV_BLOCK_MAX : 1;
    kit_frustum_block *b = block;
    uint32_t i;

    if (!frame)
        return false;
    b->count = n;
    for (i = 0; i < step; i++) {
        const kit_frustum *s = selves[i < n ? i : 0];
        kit_one one;

        if (s->empty)
            return false;
        one = describe(frame, s);
        put_one(b->number[0] + i, step, &one);
    }
    return true;
}

/* Numbers of lines that one loop leaves for the next. */
typedef struct lines {
    float x[KIT_FLOATS], y[KIT_FLOATS], z[KIT_FLOATS], dx[KIT_FLOATS], dy[KIT_FLOATS], dz[KIT_FLOATS];
    float middle[KIT_FLOATS], discriminant[KIT_FLOATS];
} lines;

/* Does a line possibly hit? */
KIT_INLINE int32_t find(const kit_one *s, const kit_beam *ray, uint32_t i, lines *restrict out)
{
    const kit_line l = kit_find_line(s, ray);

    out->x[i] = l.p.x;
    out->y[i] = l.p.y;
    out->z[i] = l.p.z;
    out->dx[i] = l.d.x;
    out->dy[i] = l.d.y;
    out->dz[i] = l.d.z;
    out->middle[i] = l.middle;
    out->discriminant[i] = l.discriminant;
    return -!kit_line_misses(s, ray, &l);
}

/* An open shape can be entered through its side only. */
KIT_INLINE void bound(const kit_one *s, const kit_beam *ray, const lines *all, uint32_t i, kit_chords *restrict out,
                      kit_conditions *restrict say)
{
    const kit_line l = { { all->x[i], all->y[i], all->z[i] }, { all->dx[i], all->dy[i], all->dz[i] }, all->middle[i],
                         all->discriminant[i] };
    const kit_reach side = kit_side(s, ray, &l), slab = kit_slab(s, ray, &l);
    const float first = kit_float_greater(side.lo - slab.late, s->closed);
    const float lo = kit_float_greater(side.lo, slab.lo), late = kit_float_greater(side.late, slab.late);
    const float hi = kit_float_lesser(side.hi, slab.hi), soon = kit_float_lesser(side.soon, slab.soon);
    const float blur = kit_blur(s, ray, l.middle);
    const int blind = !(blur < 1.0f);
    const int within = (int)(lo <= hi) & (int)(lo <= ray->smax) & (int)(hi >= 0.0f);
    const int enters = (int)(late < soon) & (int)(lo > 0.0f) & (int)(late < ray->sure) & (int)(first > 0.0f) &
                       (int)(blur < KIT_BLURRED);

    out->lo[i] = blind ? -HUGE_VALF : lo;
    out->hi[i] = late;
    say->maybe.lane[i] = -(blind | within);
    say->surely.lane[i] = -enters;
    say->twice.lane[i] = -(enters & (int)(hi < kit_float_lesser(ray->sure, s->closed)));
}

/* Floats before the numbers of a block. */
enum { HEAD = offsetof(kit_frustum_block, number) / sizeof(float) };

/* Some rays at one shape. */
KIT_INLINE void meet_lanes(const kit_one *s, const pov_rays *rays, size_t from, uint32_t some, kit_chords *restrict out)
{
    kit_conditions say;
    uint32_t i;
    lines l;

    for (i = 0; i < KIT_FLOATS; i++) {
        const kit_beam ray = kit_beam_of(rays, from + i);
        say.maybe.lane[i] = find(s, &ray, i, &l);
    }
    some &= kit_bits_of(&say.maybe, KIT_FLOATS);
    out->maybe = 0;
    if (!some)
        return;
    for (i = 0; i < KIT_FLOATS; i++) {
        const kit_beam ray = kit_beam_of(rays, from + i);
        bound(s, &ray, &l, i, out, &say);
    }
    kit_gather(&say, KIT_FLOATS, some, out);
}

KIT_INLINE void meet_rays(const void *block, uint32_t which, const pov_rays *rays, size_t from, uint32_t some,
                          kit_chords *restrict out)
{
    const kit_one s = get_one((const float *)block + HEAD + which, POV_BLOCK_MAX);

    meet_lanes(&s, rays, from, some, out);
}

KIT_INLINE void meet_shapes(const void *block, const pov_rays *rays, size_t at, uint32_t some, kit_chords *restrict out)
{
    const kit_beam ray = kit_beam_of(rays, at);
    kit_conditions say;
    uint32_t i;
    lines l;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const kit_one s = get_one((const float *)block + HEAD + i, POV_BLOCK_MAX);
        say.maybe.lane[i] = find(&s, &ray, i, &l);
    }
    some &= kit_bits_of(&say.maybe, POV_BLOCK_MAX);
    out->maybe = 0;
    if (!some)
        return;
    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const kit_one s = get_one((const float *)block + HEAD + i, POV_BLOCK_MAX);
        bound(&s, &ray, &l, i, out, &say);
    }
    kit_gather(&say, POV_BLOCK_MAX, some, out);
}

/* The same for a block of a single shape. */
KIT_INLINE void meet_rays_alone(const void *block, uint32_t which, const pov_rays *rays, size_t from, uint32_t some,
                                kit_chords *restrict out)
{
    const kit_one s = get_one((const float *)block + HEAD, 1);

    (void)which;
    meet_lanes(&s, rays, from, some, out);
}

KIT_INLINE void meet_alone(const void *block, const pov_rays *rays, size_t at, uint32_t some, kit_chords *restrict out)
{
    const kit_one s = get_one((const float *)block + HEAD, 1);
    const kit_beam ray = kit_beam_of(rays, at);
    kit_conditions say;
    lines l;

    out->maybe = 0;
    if (!find(&s, &ray, 0, &l))
        return;
    bound(&s, &ray, &l, 0, out, &say);
    out->maybe = some & (uint32_t)say.maybe.lane[0];
    out->surely = (uint32_t)say.surely.lane[0];
    out->twice = (uint32_t)say.twice.lane[0];
}

/* Static, because the names of clones would be exported. */
KIT_CLONES static uint32_t filter(const kit_frustum_block *b, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                                  pov_meeting *out)
{
    if (b->count == 1)
        return kit_filter_in_lanes(b, 1, owners, rays, lanes, meet_rays_alone, meet_alone, out);
    return kit_filter_in_lanes(b, b->count, owners, rays, lanes, meet_rays, meet_shapes, out);
}

uint32_t kit_frustum_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                            pov_meeting *out)
{
    return filter(block, owners, rays, lanes, out);
}
