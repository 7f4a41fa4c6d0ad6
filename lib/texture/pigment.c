#include "texture/blend.h"
#include "texture/inner.h"
#include "texture/points.h"

static pigment scale(pigment p, float by)
{
    const pigment out = { colour_scale(p.color, by), p.filter * by, p.transmit * by };

    return out;
}

static pigment add(pigment a, pigment b)
{
    const pigment out = { colour_add(a.color, b.color), a.filter + b.filter, a.transmit + b.transmit };

    return out;
}

static pigment mix(const pigment *two, double between)
{
    if (between == 0.0)
        return two[0];
    return add(scale(two[0], (float)(1.0 - between)), scale(two[1], (float)between));
}

static void find(const model *m, const pigment_node *of, const texture_points *points, const vec_lanes *at, uint32_t n,
                 function_memo *memo, blending *b)
{
    pattern_input in = points_input(m, of->pattern, points, at, n);
    SIMD_ALIGNED double value[LANES_MAX];

    in.memo = memo;
    if (of->blend != BLEND_AVERAGE)
        points_values(&in, value);
    blend_find(b, of->blend, of->values, of->count, value, n);
}

static void find_colours(const model *m, const pigment_node *of, const texture_points *points, uint32_t n, function_memo *memo, pigment *out)
{
    vec_lanes at;
    blending b;

    points_place(m, of->pattern, points, n, &at, NULL);
    if (of->pattern->class->colours) {
        const pattern_input in = points_input(m, of->pattern, points, &at, n);

        of->pattern->class->colours(&in, out);
        return;
    }
    find(m, of, points, &at, n, memo, &b);
    for (uint32_t i = 0; i < n; i++)
        out[i] = mix(&of->colours[b.low[i]], b.between[i]);
}

static void eval(const model *m, const pigment_node *of, const texture_points *points, uint32_t n, function_memo *memo, pigment *out);

static void add_member(const model *m, const pigment_node *member, const blending *b, uint32_t number,
                       const texture_points *points, function_memo *memo, pigment *out)
{
    pigment part[LANES_MAX];
    uint8_t lane[LANES_MAX];
    float share[LANES_MAX];
    texture_points picked;
    const uint32_t n = blend_lanes(b, number, lane, share);

    if (n == 0)
        return;
    eval(m, member, points_pick(points, b->n, lane, n, &picked), n, memo, part);
    for (uint32_t i = 0; i < n; i++)
        out[lane[i]] = add(out[lane[i]], scale(part[i], share[i]));
}

static void blend_members(const model *m, const pigment_node *of, const texture_points *points, uint32_t n, pigment *out)
{
    const bool is_average = of->blend == BLEND_AVERAGE;
    texture_points inner;
    function_memo memo;
    blending b;

    memo.count = 0;
    points_enter(m, of->pattern, points, n, &inner);
    find(m, of, &inner, &inner.at, n, NULL, &b);
    blend_mark(&b);
    memset(out, 0, n * sizeof *out);
    for (uint32_t k = 0; k < of->count; k++)
        add_member(m, of->pigments[k], &b, k, &inner, is_average ? &memo : NULL, out);
}

static void eval(const model *m, const pigment_node *of, const texture_points *points, uint32_t n, function_memo *memo, pigment *out)
{
    if (of->pigments) {
        blend_members(m, of, points, n, out);
    } else if (of->pattern) {
        find_colours(m, of, points, n, memo, out);
    } else {
        for (uint32_t i = 0; i < n; i++)
            out[i] = of->most;
    }
}

void pigment_eval(const model *m, const pigment_node *of, const texture_points *points, uint32_t n, pigment *out)
{
    eval(m, of, points, n, NULL, out);
}
