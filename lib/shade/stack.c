#include "shade/stack.h"

#include <string.h>

/* ---- weights ---- */

void layer_hide(layer *out, appearance *own)
{
    own->lit = own->gathers = own->reflective = own->transmissive = own->lasts = false;
    own->emitted = out->by = colour_of(0.0f, 0.0f, 0.0f);
}

/* A share does not count in the weight of a ray. */
static coefficient share_of(colour c, float share)
{
    const coefficient out = { colour_scale(c, share), colour_weight(c) };

    return out;
}

/* What a layer reflects is not filtered by those above it, but they count in its weight, as POV-Ray has it. */
bool layer_weigh(layer *out, const model *m, const appearance *a, const onward *on, colour *left)
{
    if (out->first)
        *left = colour_of(1.0f, 1.0f, 1.0f);
    if (!out->first && appearance_is_dark(m, *left))
        return false;
    out->by = colour_scale(*left, out->share);
    out->reflection = share_of(on->reflection.by, out->share);
    out->reflection.weight *= fabsf(colour_luminance(*left));
    *left = colour_mul(*left, on->filter.by);
    out->through = share_of(colour_scale(*left, a->finish->refraction), out->share);
    out->is_dark = appearance_is_dark(m, *left);
    return true;
}

/* ---- constant stacks ---- */

static bool is_constant(const texture *of)
{
    return of->blend == BLEND_NONE && !of->normal && !of->pigment->pattern && !of->pigment->pigments;
}

bool stack_is_there(const material *of)
{
    const texture *t = of->texture;

    if (!t || t->blend != BLEND_LAYERS || of->inside)
        return false;
    for (uint32_t i = 0; i < t->count; i++)
        if (!is_constant(t->textures[i]))
            return false;
    return true;
}

static void make_appearance(appearance *out, const plan *p, const model *m, const texture *of, bool upper)
{
    static const pigment none;
    appearance bare;

    memset(&bare, 0, sizeof bare);
    appearance_make(&bare, p, m, &of->finish, &none);
    appearance_paint(out, p, m, &bare, &of->pigment->most, upper);
}

stack *stack_create(const plan *p, const model *m, const material *of, bool weighed)
{
    const texture *t = of->texture;
    stack *out = env_alloc(m->env, 1, sizeof *out + t->count * sizeof out->layers[0]);
    colour left = colour_of(1.0f, 1.0f, 1.0f);

    if (!out)
        return NULL;
    out->count = t->count;
    for (uint32_t k = 0; k < t->count; k++) {
        constant_layer *one = &out->layers[k];

        make_appearance(&one->appearance, p, m, t->textures[t->count - 1 - k], k + 1 < t->count);
        appearance_set_material(&one->appearance, of);
        one->appearance.lasts = true;
        one->of.first = k == 0;
        one->of.last = k + 1 == t->count;
        one->of.share = 1.0f;
        one->of.is_weighed = weighed;
        if (weighed && !layer_weigh(&one->of, m, &one->appearance, &one->appearance.onward, &left))
            layer_hide(&one->of, &one->appearance);
    }
    return out;
}
