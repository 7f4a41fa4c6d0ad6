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

/* A plain comparison: no NaN comes here. */
static inline float at_most_one(float x) { return x < 1.0f ? x : 1.0f; }

/* What a layer reflects is not filtered by those above it, but they count in its weight as far as they take light, as POV-Ray
 * has it. */
bool layer_weigh(layer *out, float share, const model *m, const appearance *a, const onward *on, colour *left)
{
    if (out->first)
        *left = colour_of(1.0f, 1.0f, 1.0f);
    if (!out->first && appearance_is_dark(m, *left))
        return false;
    out->by = colour_scale(*left, share);
    out->reflection.by = colour_scale(on->reflection.by, share);
    out->reflection.weight = on->reflection.weight * at_most_one(fabsf(colour_luminance(*left)));
    *left = colour_mul(*left, on->filter.by);
    out->through = share_of(colour_scale(*left, a->finish->refraction), share);
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

static void make_appearance(appearance *out, const plan *p, const model *m, const texture *of)
{
    static const pigment none;
    appearance bare;

    memset(&bare, 0, sizeof bare);
    appearance_make(&bare, p, m, &of->finish, &none);
    appearance_paint(out, p, m, &bare, &of->pigment->most);
}

void stack_weigh(stack *of, const plan *p, const model *m)
{
    colour left = colour_of(1.0f, 1.0f, 1.0f);

    of->weighed = !p->fading;
    for (uint32_t k = 0; k < of->count; k++)
        of->weighed &= !of->layers[k].appearance.angular;
    for (uint32_t k = 0; of->weighed && k < of->count; k++) {
        stack_layer *one = &of->layers[k];

        one->of.is_weighed = true;
        if (!layer_weigh(&one->of, 1.0f, m, &one->appearance, &one->appearance.onward, &left))
            layer_hide(&one->of, &one->appearance);
    }
}

stack *stack_create(const plan *p, const model *m, const material *of)
{
    const texture *t = of->texture;
    stack *out = env_alloc(m->env, 1, sizeof *out + t->count * sizeof out->layers[0]);

    if (!out)
        return NULL;
    out->count = t->count;
    out->layers = (stack_layer *)(out + 1);
    for (uint32_t k = 0; k < t->count; k++) {
        stack_layer *one = &out->layers[k];

        make_appearance(&one->appearance, p, m, t->textures[t->count - 1 - k]);
        appearance_set_material(&one->appearance, of);
        one->appearance.lasts = true;
        one->of.first = k == 0;
        one->of.last = k + 1 == t->count;
        one->of.share = 1.0f;
    }
    stack_weigh(out, p, m);
    return out;
}

/* ---- stacks lit at one hit ---- */

/* What all layers mirror, as one ray. False: it is several, or raised to a power. */
static bool find_mirror(const stack *of, bool *any, coefficient *out)
{
    *any = false;
    for (uint32_t k = 0; k < of->count; k++) {
        const stack_layer *one = &of->layers[k];

        if (!one->appearance.reflective)
            continue;
        if (one->appearance.powered || (*any && one->of.reflection.weight != out->weight))
            return false;
        out->by = *any ? colour_add(out->by, one->of.reflection.by) : one->of.reflection.by;
        out->weight = one->of.reflection.weight;
        *any = true;
    }
    return true;
}

void stack_make_flat(stack *of, appearance *whole)
{
    const stack_layer *top = &of->layers[0], *last = &of->layers[of->count - 1];
    bool reflects;
    coefficient mirrored = { { 0.0f, 0.0f, 0.0f }, 0.0f };

    of->flat = of->weighed && of->count <= STACK_LEVELS && find_mirror(of, &reflects, &mirrored);
    if (!of->flat)
        return;
    whole->reflective = reflects;
    whole->transmissive = top->appearance.transmissive && last->appearance.transmissive;
    whole->angular = whole->fresnel = whole->powered = whole->clear = false;
    whole->onward.reflection = mirrored;
    whole->onward.filter = last->of.through;
    whole->onward.dark = last->of.is_dark;
    whole->finish = top->appearance.finish;
}
