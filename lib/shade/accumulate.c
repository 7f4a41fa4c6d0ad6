#include "shade/accumulate.h"

#include "base/simd.h"
#include "shade/layered.h"

/* What a layer gives of light, in all lanes. */
SIMD_CLONES static void weigh(colour_lanes *restrict lit, colour emitted, colour by, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        lit->red[i] = by.r * (emitted.r + lit->red[i]);
        lit->green[i] = by.g * (emitted.g + lit->green[i]);
        lit->blue[i] = by.b * (emitted.b + lit->blue[i]);
    }
}

/* Add what layers of surfaces give, which all have so many of them. A sum that is finite is one of finite terms. */
static inline void add_levels(const surfaces *s, const colour_lanes *given, uint32_t levels, colour *out)
{
    for (uint32_t i = 0; i < s->count; i++) {
        const path *p = s->at[i].from;
        colour sum = out[p->lane];

        for (uint32_t k = 0; k < levels; k++)
            sum = colour_add(sum, colour_mul(p->factor.by, colour_lane(&given[k], i)));
        if (isfinite(sum.r + sum.g + sum.b))
            out[p->lane] = sum;
        else
            for (uint32_t k = 0; k < levels; k++)
                accumulate(p, colour_lane(&given[k], i), out);
    }
}

SIMD_CLONES static bool are_finite(const float *x, uint32_t n)
{
    int out = 0;

    for (uint32_t i = 0; i < n; i++)
        out |= !(fabsf(x[i]) <= FLT_MAX);
    return !out;
}

/* Surfaces of all rays of the camera, whose colours are zero so far, and whose paths carry white. False: some sum is not finite. */
static bool put_surfaces(const colour_lanes *lit, uint32_t n, colour *out)
{
    if (!are_finite(lit->red, n) || !are_finite(lit->green, n) || !are_finite(lit->blue, n))
        return false;
    for (uint32_t i = 0; i < n; i++)
        out[i] = colour_of(0.0f + lit->red[i], 0.0f + lit->green[i], 0.0f + lit->blue[i]);
    return true;
}

/* Add what each of them emits, where that is not the same. */
SIMD_CLONES static void add_emitted(colour_lanes *restrict lit, const colour_lanes *restrict emitted, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        lit->red[i] = emitted->red[i] + lit->red[i];
        lit->green[i] = emitted->green[i] + lit->green[i];
        lit->blue[i] = emitted->blue[i] + lit->blue[i];
    }
}

void accumulate_surfaces(surfaces *s, bool firsts, colour *out)
{
    if (s->alike && s->count > 0) {
        if (s->coloured)
            add_emitted(&s->lit, &s->emitted, lanes_whole(s->count));
        else
            weigh(&s->lit, s->at[0].appearance->emitted, colour_of(1.0f, 1.0f, 1.0f), lanes_whole(s->count));
        if (!firsts || !put_surfaces(&s->lit, s->count, out))
            add_levels(s, &s->lit, 1, out);
        return;
    }
    for (uint32_t i = 0; i < s->count; i++)
        accumulate(s->at[i].from, colour_add(s->at[i].appearance->emitted, colour_lane(&s->lit, i)), out);
}

/* What the layers of a flat stack give. */
static void add_stack(const surface *s, const lit_stacks *from, uint32_t lane, colour *out)
{
    const stack *of = s->appearance->stack;

    for (uint32_t k = 0; k < of->count; k++) {
        const stack_layer *one = &of->layers[k];

        accumulate(s->from, colour_mul(one->of.by, colour_add(one->appearance.emitted, colour_lane(&from->lit[k], lane))), out);
    }
}

/* The same for surfaces of one stack. */
static void add_stacks_alike(const surfaces *s, const stack *of, lit_stacks *from, colour *out)
{
    for (uint32_t k = 0; k < of->count; k++)
        weigh(&from->lit[k], of->layers[k].appearance.emitted, of->layers[k].of.by, lanes_whole(s->count));
    add_levels(s, from->lit, of->count, out);
}

SIMD_CLONES static void weigh_each(colour_lanes *restrict lit, const colour_lanes *restrict emitted, const colour_lanes *restrict by, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        lit->red[i] = by->red[i] * (emitted->red[i] + lit->red[i]);
        lit->green[i] = by->green[i] * (emitted->green[i] + lit->green[i]);
        lit->blue[i] = by->blue[i] * (emitted->blue[i] + lit->blue[i]);
    }
}

/* The same for layers that differ by their pigments. */
static void add_layered(const surfaces *s, uint32_t levels, lit_stacks *from, colour *out)
{
    for (uint32_t k = 0; k < levels; k++)
        weigh_each(&from->lit[k], &s->layered[k].emitted, &s->layered[k].by, lanes_whole(s->count));
    add_levels(s, from->lit, levels, out);
}

static void add_stacks_each(const surfaces *s, const lit_stacks *from, colour *out)
{
    for (uint32_t i = 0; i < s->count; i++) {
        if (s->at[i].appearance->stack)
            add_stack(&s->at[i], from, i, out);
        else
            accumulate(s->at[i].from, colour_add(s->at[i].appearance->emitted, colour_lane(&from->lit[0], i)), out);
    }
}

void accumulate_stacks(const surfaces *s, lit_stacks *from, colour *out)
{
    if (s->layered)
        add_layered(s, s->at[0].appearance->stack->count, from, out);
    else if (s->alike && s->at[0].appearance->stack)
        add_stacks_alike(s, s->at[0].appearance->stack, from, out);
    else
        add_stacks_each(s, from, out);
}

void accumulate_layers(const layers *l, colour *out)
{
    for (uint32_t i = 0; i < l->on.count; i++) {
        const surface *s = &l->on.at[i];

        accumulate(s->from, colour_mul(l->of[i].by, colour_add(s->appearance->emitted, colour_lane(&l->on.lit, i))), out);
    }
}

void accumulate_end(colour *out, uint32_t n)
{
    if (are_finite(&out->r, 3 * n))
        return;
    for (uint32_t i = 0; i < n; i++)
        out[i] = accumulate_finite(out[i]);
}
