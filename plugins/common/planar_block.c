#include "common/planar_block.h"

#include "common/floats.h"

/* Minimum length of an edge, and minimum distance of a corner from the line of an edge that it is not on. Then an
 * edge's line is known all over the figure to 128 roundings of a corner. */
static const double shortest = 0.125;

static double length(pov_vec3 a) { return sqrt(pov_dot(a, a)); }

/* Perpendicular to a direction in the plane, to the left seen from the normal's tip. */
static pov_vec3 across(pov_vec3 normal, pov_vec3 dir)
{
    const pov_vec3 side = pov_cross_product(normal, dir);

    return pov_scale(side, 1.0 / length(side));
}

/* Are the other corners on the inner side of all edges, if that is the left one (way = 1) or the right one (way =
 * -1)? */
static bool is_around(const pov_vec3 normal, const pov_vec3 *corner, uint32_t n, double dir)
{
    uint32_t i, j;

    for (i = 0; i < n; i++) {
        const pov_vec3 edge = pov_sub(corner[(i + 1) % n], corner[i]), side = across(normal, pov_scale(edge, dir));

        if (!(length(edge) >= shortest))
            return false;
        for (j = 2; j < n; j++)
            if (!(pov_dot(side, pov_sub(corner[(i + j) % n], corner[i])) >= shortest))
                return false;
    }
    return true;
}

bool common_planar_outline(common_planar *f, const pov_vec3 *corner, uint32_t n)
{
    const double dir = is_around(f->normal, corner, n, 1.0) ? 1.0 : -1.0;
    uint32_t i;

    if (!is_around(f->normal, corner, n, dir))
        return false;
    for (i = 0; i < COMMON_SIDES; i++) {
        const pov_vec3 from = corner[i % n], edge = pov_sub(corner[(i + 1) % n], from);

        f->side[i] = across(f->normal, pov_scale(edge, dir));
        f->offset[i] = pov_dot(f->side[i], from);
    }
    f->sure = true;
    return true;
}

void common_planar_begin(common_planar *f, pov_vec3 corner, pov_vec3 dir)
{
    uint32_t i;

    f->side[0] = across(f->normal, dir);
    f->side[1] = across(f->normal, f->side[0]);
    f->side[2] = pov_scale(f->side[0], -1.0);
    f->side[3] = pov_scale(f->side[1], -1.0);
    for (i = 0; i < COMMON_SIDES; i++)
        f->offset[i] = pov_dot(f->side[i], corner);
    f->sure = false;
}

void common_planar_extend(common_planar *f, pov_vec3 corner)
{
    uint32_t i;

    for (i = 0; i < COMMON_SIDES; i++)
        f->offset[i] = pov_min(f->offset[i], pov_dot(f->side[i], corner));
}

/* ---- blocks ---- */

typedef struct figure { common_three anchor, normal, side[COMMON_SIDES]; float offset[COMMON_SIDES], approx; } figure;

static common_three three_of(pov_vec3 v)
{
    const common_three r = { (float)v.x, (float)v.y, (float)v.z };
    return r;
}

/* A corner may lie off the plane by 111 u of the sum of sizes of the furthest point. Seen along a ray, an edge is off
 * by that over the plane's slope, and by 111 times that at the far end of the figure. The anchor's low part is less. */
static figure describe(const pov_frame *frame, const common_planar *f)
{
    const double reach = common_sum_of_components(f->anchor) + 8.0 / f->scale;
    figure out;
    uint32_t k;

    out.anchor = three_of(pov_scale(pov_sub(f->anchor, frame->centre), frame->scale));
    out.normal = three_of(pov_unit(f->normal));
    for (k = 0; k < COMMON_SIDES; k++) {
        out.side[k] = three_of(f->side[k]);
        out.offset[k] = (float)(f->offset[k] / f->scale * frame->scale);
    }
    out.approx = (float)(16384.0 * COMMON_U * reach * frame->scale);
    return out;
}

/* Consecutive numbers of a figure are `step` floats apart: POV_BLOCK_MAX, or one for a block of a single figure. */
static void put_three(float *to, size_t step, common_three v)
{
    to[0] = v.x;
    to[step] = v.y;
    to[2 * step] = v.z;
}

static void put(float *to, size_t step, const figure *f)
{
    uint32_t k;

    put_three(to, step, f->anchor);
    put_three(to + 3 * step, step, f->normal);
    for (k = 0; k < COMMON_SIDES; k++) {
        put_three(to + (6 + 3 * k) * step, step, f->side[k]);
        to[(6 + 3 * COMMON_SIDES + k) * step] = f->offset[k];
    }
    to[(COMMON_PLANAR_NUMBERS - 1) * step] = f->approx;
}

COMMON_INLINE common_three get_three(const float *at, size_t step)
{
    const common_three v = { at[0], at[step], at[2 * step] };
    return v;
}

COMMON_INLINE figure figure_of(const void *block, uint32_t i, size_t step)
{
    const float *at = (const float *)block + offsetof(common_planar_block, number) / sizeof(float) + i;
    const float *offset = at + (6 + 3 * COMMON_SIDES) * step;
    const figure f = { get_three(at, step), get_three(at + 3 * step, step),
                       { get_three(at + 6 * step, step), get_three(at + 9 * step, step), get_three(at + 12 * step, step),
                         get_three(at + 15 * step, step) },
                       { offset[0], offset[step], offset[2 * step], offset[3 * step] }, offset[4 * step] };
    return f;
}

bool common_planar_pack(common_planar_block *b, const pov_frame *frame, const common_planar *figures, uint32_t n)
{
    const size_t step = n > 1 ? POV_BLOCK_MAX : 1;
    uint32_t i;

    if (!frame)
        return false;
    b->count = n;
    b->sure = 0;
    for (i = 0; i < step; i++) {
        const figure f = describe(frame, &figures[i < n ? i : 0]);

        put(b->number[0] + i, step, &f);
        b->sure |= (uint32_t)(i < n && figures[i].sure) << i;
    }
    return true;
}

/* Let S be the sum of the sizes of the origin's coordinates, and n and d of length one. The distance to the plane is
 * off by less than 32 e (1 + S) / |n . d|. A point there is off by as much and 64 e (1 + S) in its distance to a
 * side. */
COMMON_INLINE void test(const figure *f, const common_beam *l, uint32_t i, common_chords *restrict out,
                        common_conditions *restrict say)
{
    const common_three from = { l->org.x - f->anchor.x, l->org.y - f->anchor.y, l->org.z - f->anchor.z };
    const float slope = common_dot(f->normal, l->dir),
        inverse = 1.0f / copysignf(common_float_greater(fabsf(slope), 0x1p-60f), slope);
    const float pad = common_float_sum(64.0f * COMMON_E, l->size, 64.0f * COMMON_E + f->approx) * fabsf(inverse),
        doubt = 2.0f * pad;
    const float t = -common_dot(f->normal, from) * inverse;
    const common_three p = { common_float_sum(t, l->dir.x, from.x), common_float_sum(t, l->dir.y, from.y),
                      common_float_sum(t, l->dir.z, from.z) };
    const float first = common_float_lesser(common_dot(f->side[0], p) - f->offset[0],
                                            common_dot(f->side[1], p) - f->offset[1]);
    const float second = common_float_lesser(common_dot(f->side[2], p) - f->offset[2],
                                             common_dot(f->side[3], p) - f->offset[3]);
    const float least = common_float_lesser(first, second), lo = t - pad, hi = t + pad;
    const int missed = (int)(least < -doubt) | (int)(lo > l->smax) | (int)(hi < 0.0f);

    out->lo[i] = common_float_greater(lo, -HUGE_VALF);
    out->hi[i] = hi;
    say->maybe.lane[i] = -!missed;
    say->definite.lane[i] = -((int)(least > doubt) & (int)(lo > 0.0f) & (int)(hi < l->sure) & (int)(pad < 0x1p-4f));
}

COMMON_INLINE void filter_lanes(const figure *f, bool sure, const pov_rays *rays, size_t from, uint32_t some,
                                common_chords *restrict out)
{
    common_conditions say = { .definite_pair = { { 0 } } };
    uint32_t i;

    for (i = 0; i < COMMON_FLOATS; i++) {
        const common_beam l = common_beam_of(rays, from + i);
        test(f, &l, i, out, &say);
    }
    common_gather(&say, COMMON_FLOATS, some, out);
    if (!sure)
        out->definite = 0;
}

COMMON_INLINE void filter_rays(const void *block, uint32_t which, const pov_rays *rays, size_t from, uint32_t some,
                               common_chords *restrict out)
{
    const figure f = figure_of(block, which, POV_BLOCK_MAX);

    filter_lanes(&f, ((const common_planar_block *)block)->sure >> which & 1, rays, from, some, out);
}

COMMON_INLINE void filter_figures(const void *block, const pov_rays *rays, size_t at, uint32_t some,
                                  common_chords *restrict out)
{
    const common_planar_block *b = block;
    const common_beam l = common_beam_of(rays, at);
    common_conditions say = { .definite_pair = { { 0 } } };
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const figure f = figure_of(block, i, POV_BLOCK_MAX);
        test(&f, &l, i, out, &say);
    }
    common_gather(&say, POV_BLOCK_MAX, some, out);
    out->definite &= b->sure;
}

/* The same for a block of a single figure. */
COMMON_INLINE void filter_rays_single(const void *block, uint32_t which, const pov_rays *rays, size_t from,
                                      uint32_t some, common_chords *restrict out)
{
    const figure f = figure_of(block, which, 1);

    filter_lanes(&f, ((const common_planar_block *)block)->sure, rays, from, some, out);
}

COMMON_INLINE void filter_single(const void *block, const pov_rays *rays, size_t at, uint32_t some,
                                 common_chords *restrict out)
{
    const figure f = figure_of(block, 0, 1);
    const common_beam l = common_beam_of(rays, at);
    common_conditions say;

    test(&f, &l, 0, out, &say);
    out->maybe = some & (uint32_t)say.maybe.lane[0];
    out->definite = ((const common_planar_block *)block)->sure & (uint32_t)say.definite.lane[0];
    out->definite_pair = 0;
}

/* Static, because the names of clones would be exported. */
COMMON_CLONES static uint32_t filter(const common_planar_block *b, const uint32_t *owners, const pov_rays *rays,
                                     uint64_t lanes, pov_candidate *out)
{
    if (b->count == 1)
        return common_filter_in_lanes(b, 1, owners, rays, lanes, filter_rays_single, filter_single, out);
    return common_filter_in_lanes(b, b->count, owners, rays, lanes, filter_rays, filter_figures, out);
}

uint32_t common_planar_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                              pov_candidate *out)
{
    return filter(block, owners, rays, lanes, out);
}
