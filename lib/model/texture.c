#include "model/texture.h"

static float larger(float a, float b) { return fabsf(b) > fabsf(a) ? b : a; }

static colour larger_colour(colour a, colour b)
{
    return colour_of(larger(a.r, b.r), larger(a.g, b.g), larger(a.b, b.b));
}

pigment pigment_most(pigment a, pigment b)
{
    const pigment most = { larger_colour(a.color, b.color), larger(a.filter, b.filter), larger(a.transmit, b.transmit) };

    return most;
}

static void add_reflection(reflection *all, const reflection *one)
{
    all->min = larger_colour(all->min, one->min);
    all->max = larger_colour(all->max, one->max);
    all->metallic = larger(all->metallic, one->metallic);
    all->fresnel |= one->fresnel;
}

/* Only members that say whether there is something at all are joined; what it is like is asked where it is. */
static void add_finish(finish *all, const finish *one)
{
    all->ambient = larger_colour(all->ambient, one->ambient);
    all->emission = larger_colour(all->emission, one->emission);
    all->diffuse = larger(all->diffuse, one->diffuse);
    all->diffuse_back = larger(all->diffuse_back, one->diffuse_back);
    all->phong = larger(all->phong, one->phong);
    all->specular = larger(all->specular, one->specular);
    all->metallic = larger(all->metallic, one->metallic);
    all->crand = larger(all->crand, one->crand);
    all->irid.amount = larger(all->irid.amount, one->irid.amount);
    all->refraction = one->refraction != 1.0f ? one->refraction : all->refraction;
    all->conserve_energy |= one->conserve_energy;
    add_reflection(&all->reflection, &one->reflection);
}

static bool is_opaque(pigment most) { return most.filter == 0.0f && most.transmit == 0.0f; }

void texture_bounds(const texture *of, pigment *most, finish *all)
{
    bool opaque;

    if (of->blend == BLEND_NONE) {
        *most = of->pigment->most;
        *all = of->finish;
        return;
    }
    texture_bounds(of->textures[0], most, all);
    opaque = is_opaque(*most);
    for (uint32_t i = 1; i < of->count; i++) {
        pigment one;
        finish own;

        texture_bounds(of->textures[i], &one, &own);
        opaque |= is_opaque(one);
        *most = pigment_most(*most, one);
        add_finish(all, &own);
    }
    /* Nothing goes through layers of which one is opaque all over. */
    if (of->blend == BLEND_LAYERS && opaque)
        most->filter = most->transmit = 0.0f;
}

bool texture_has_normals(const texture *of)
{
    if (of->blend == BLEND_NONE)
        return of->normal != NULL;
    for (uint32_t i = 0; i < of->count; i++)
        if (texture_has_normals(of->textures[i]))
            return true;
    return false;
}

/* ---- uv ---- */

static bool pattern_has_uv(const pattern *p) { return p && (p->uv || p->inner_uv); }

bool pigment_has_uv(const pigment_node *of)
{
    bool has = pattern_has_uv(of->pattern);

    for (uint32_t i = 0; of->pigments && i < of->count; i++)
        has |= pigment_has_uv(of->pigments[i]);
    return has;
}

static bool normal_has_uv(const normal_node *of)
{
    bool has = of && pattern_has_uv(of->pattern);

    for (uint32_t i = 0; of && of->normals && i < of->count; i++)
        has |= normal_has_uv(of->normals[i]);
    return has;
}

bool texture_has_uv(const texture *of)
{
    bool has = pattern_has_uv(of->pattern);

    if (of->blend == BLEND_NONE)
        return pigment_has_uv(of->pigment) || normal_has_uv(of->normal);
    for (uint32_t i = 0; i < of->count; i++)
        has |= texture_has_uv(of->textures[i]);
    return has;
}
