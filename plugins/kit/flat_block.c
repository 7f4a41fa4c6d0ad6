#include "kit/flat_block.h"

#include "kit/floats.h"

/* Minimum length of an edge, and minimum distance of a corner from the line of an edge that it is not on. Then an
 * edge's line is known all over the figure to 128 roundings of a corner. */
static const double shortest = 0.125;

static double length(pov_vec3 a) { return sqrt(pov_dot(a, a)); }

/* Perpendicular to a direction in the plane, to the left seen from the normal's tip. */
static pov_vec3 across(pov_vec3 normal, pov_vec3 way)
{
    const pov_vec3 side = pov_cross_product(normal, way);

    return pov_scale(side, 1.0 / length(side));
}

/* Are the other corners on the inner side of all edges, if that is the left one (way = 1) or the right one (way =
 * -1)? */
static bool is_around(const pov_vec3 normal, const pov_vec3 *corner, uint32_t n, double way)
{
    uint32_t i, j;

    for (i = 0; i < n; i++) {
        const pov_vec3 edge = pov_sub(corner[(i + 1) % n], corner[i]), side = across(normal, pov_scale(edge, way));

        if (!(length(edge) >= shortest))
            return false;
        for (j = 2; j < n; j++)
            if (!(pov_dot(side, pov_sub(corner[(i + j) % n], corner[i])) >= shortest))
                return false;
    }
    return true;
}

bool kit_flat_outline(kit_flat *f, const pov_vec3 *corner, uint32_t n)
{
    const double way = is_around(f->normal, corner, n, 1.0) ? 1.0 : -1.0;
    uint32_t i;

    if (!is_around(f->normal, corner, n, way))
        return false;
    for (i = 0; i < KIT_SIDES; i++) {
        const pov_vec3 from = corner[i % n], edge = pov_sub(corner[(i + 1) % n], from);

        f->side[i] = across(f->normal, pov_scale(edge, way));
        f->offset[i] = pov_dot(f->side[i], from);
    }
    f->sure = true;
    return true;
}

void kit_flat_begin(kit_flat *f, pov_vec3 corner, pov_vec3 way)
{
    uint32_t i;

    f->side[0] = across(f->normal, way);
    f->side[1] = across(f->normal, f->side[0]);
    f->side[2] = pov_scale(f->side[0], -1.0);
    f->side[3] = pov_scale(f->side[1], -1.0);
    for (i = 0; i < KIT_SIDES; i++)
        f->offset[i] = pov_dot(f->side[i], corner);
    f->sure = false;
}

void kit_flat_extend(kit_flat *f, pov_vec3 corner)
{
    uint32_t i;

    for (i = 0; i < KIT_SIDES; i++)
        f->offset[i] = fmin(f->offset[i], pov_dot(f->side[i], corner));
}

/* ---- blocks ---- */

typedef struct figure { kit_three anchor, normal, side[KIT_SIDES]; float offset[KIT_SIDES], rough; } figure;

static kit_three three_of(pov_vec3 v)
{
    const kit_three r = { (float)v.x, (float)v.y, (float)v.z };
    return r;
}

/* A corner may lie off the plane by 111 u of the sum of sizes of the furthest point. Seen along a ray, an edge is off
 * by that over the plane's slope, and by 111 times that at the far end of the figure. The anchor's low part is less. */
static figure describe(const pov_frame *frame, const kit_flat *f)
{
    const double reach = kit_sum_of_components(f->anchor) + 8.0 / f->scale;
    figure out;
    uint32_t k;

    out.anchor = three_of(pov_scale(pov_sub(f->anchor, frame->centre), frame->scale));
    out.normal = three_of(pov_unit(f->normal));
    for (k = 0; k < KIT_SIDES; k++) {
        out.side[k] = three_of(f->side[k]);
        out.offset[k] = (float)(f->offset[k] / f->scale * frame->scale);
    }
    out.rough = (float)(16384.0 * KIT_U * reach * frame->scale);
    return out;
}

/* Consecutive numbers of a figure are `step` floats apart: POV_BLOCK_MAX, or one for a block of a single figure. */
static void put_three(float *to, size_t step, kit_three v)
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
    for (k = 0; k < KIT_SIDES; k++) {
        put_three(to + (6 + 3 * k) * step, step, f->side[k]);
        to[(6 + 3 * KIT_SIDES + k) * step] = f->offset[k];
    }
    to[(KIT_FLAT_NUMBERS - 1) * step] = f->rough;
}

KIT_INLINE kit_three get_three(const float *at, size_t step)
{
    const kit_three v = { at[0], at[step], at[2 * step] };
    return v;
}

KIT_INLINE figure figure_of(const void *block, uint32_t i, size_t step)
{
    const float *at = (const float *)block + offsetof(kit_flat_block, number) / sizeof(float) + i;
    const float *offset = at + (6 + 3 * KIT_SIDES) * step;
    const figure f = { get_three(at, step), get_three(at + 3 * step, step),
                       { get_three(at + 6 * step, step), get_three(at + 9 * step, step), get_three(at + 12 * step, step),
                         get_three(at + 15 * step, step) },
                       { offset[0], offset[step], offset[2 * step], offset[3 * step] }, offset[4 * step] };
    return f;
}

bool kit_flat_pack(kit_flat_block *b, const pov_frame *frame, const kit_flat *figures, uint32_t n)
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
KIT_INLINE void meet(const figure *f, const kit_beam *l, uint32_t i, kit_chords *restrict out, kit_conditions *restrict say)
{
    const kit_three from = { l->org.x - f->anchor.x, l->org.y - f->anchor.y, l->org.z - f->anchor.z };
    const float slope = kit_dot(f->normal, l->dir), inverse = 1.0f / copysignf(kit_float_greater(fabsf(slope), 0x1p-60f), slope);
    const float pad = kit_float_sum(64.0f * KIT_E, l->size, 64.0f * KIT_E + f->rough) * fabsf(inverse), doubt = 2.0f * pad;
    const float t = -kit_dot(f->normal, from) * inverse;
    const kit_three p = { kit_float_sum(t, l->dir.x, from.x), kit_float_sum(t, l->dir.y, from.y),
                      kit_float_sum(t, l->dir.z, from.z) };
    const float first = kit_float_lesser(kit_dot(f->side[0], p) - f->offset[0], kit_dot(f->side[1], p) - f->offset[1]);
    const float second = kit_float_lesser(kit_dot(f->side[2], p) - f->offset[2], kit_dot(f->side[3], p) - f->offset[3]);
    const float least = kit_float_lesser(first, second), lo = t - pad, hi = t + pad;
    const int missed = (int)(least < -doubt) | (int)(lo > l->smax) | (int)(hi < 0.0f);

    out->lo[i] = kit_float_greater(lo, -HUGE_VALF);
    out->hi[i] = hi;
    say->maybe.lane[i] = -!missed;
    say->surely.lane[i] = -((int)(least > doubt) & (int)(lo > 0.0f) & (int)(hi < l->sure) & (int)(pad < 0x1p-4f));
}

KIT_INLINE void meet_lanes(const figure *f, bool sure, const pov_rays *rays, size_t from, uint32_t some,
                           kit_chords *restrict out)
{
    kit_conditions say = { .twice = { { 0 } } };
    uint32_t i;

    for (i = 0; i < KIT_FLOATS; i++) {
        const kit_beam l = kit_beam_of(rays, from + i);
        meet(f, &l, i, out, &say);
    }
    kit_gather(&say, KIT_FLOATS, some, out);
    if (!sure)
        out->surely = 0;
}

KIT_INLINE void meet_rays(const void *block, uint32_t which, const pov_rays *rays, size_t from, uint32_t some,
                          kit_chords *restrict out)
{
    const figure f = figure_of(block, which, POV_BLOCK_MAX);

    meet_lanes(&f, ((const kit_flat_block *)block)->sure >> which & 1, rays, from, some, out);
}

KIT_INLINE void meet_figures(const void *block, const pov_rays *rays, size_t at, uint32_t some, kit_chords *restrict out)
{
    const kit_flat_block *b = block;
    const kit_beam l = kit_beam_of(rays, at);
    kit_conditions say = { .twice = { { 0 } } };
    uint32_t i;

    for (i = 0; i < POV_BLOCK_MAX; i++) {
        const figure f = figure_of(block, i, POV_BLOCK_MAX);
        meet(&f, &l, i, out, &say);
    }
    kit_gather(&say, POV_BLOCK_MAX, some, out);
    out->surely &= b->sure;
}

/* The same for a block of a single figure. */
KIT_INLINE void meet_rays_alone(const void *block, uint32_t which, const pov_rays *rays, size_t from, uint32_t some,
                                kit_chords *restrict out)
{
    const figure f = figure_of(block, which, 1);

    meet_lanes(&f, ((const kit_flat_block *)block)->sure, rays, from, some, out);
}

KIT_INLINE void meet_alone(const void *block, const pov_rays *rays, size_t at, uint32_t some, kit_chords *restrict out)
{
    const figure f = figure_of(block, 0, 1);
    const kit_beam l = kit_beam_of(rays, at);
    kit_conditions say;

    meet(&f, &l, 0, out, &say);
    out->maybe = some & (uint32_t)say.maybe.lane[0];
    out->surely = ((const kit_flat_block *)block)->sure & (uint32_t)say.surely.lane[0];
    out->twice = 0;
}

/* Static, because the names of clones would be exported. */
KIT_CLONES static uint32_t filter(const kit_flat_block *b, const uint32_t *owners, const pov_rays *rays, uint64_t lanes,
                                  pov_meeting *out)
{
    if (b->count == 1)
        return kit_filter_in_lanes(b, 1, owners, rays, lanes, meet_rays_alone, meet_alone, out);
    return kit_filter_in_lanes(b, b->count, owners, rays, lanes, meet_rays, meet_figures, out);
}

uint32_t kit_flat_filter(const void *block, const uint32_t *owners, const pov_rays *rays, uint64_t lanes, pov_meeting *out)
{
    return filter(block, owners, rays, lanes, out);
}
