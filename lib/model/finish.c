#include "model/finish.h"

#include <string.h>

void finish_init(finish *f)
{
    memset(f, 0, sizeof *f);
    f->ambient = colour_of(0.1f, 0.1f, 0.1f);
    f->diffuse = 0.6f;
    f->phong_size = 40.0f;
    f->roughness = 0.05;
    f->brilliance = 1.0;
    f->written = 1.0f;
    f->refraction = 1.0f;
    f->reflection.falloff = f->reflection.exponent = 1.0f;
    f->old_ior = -1.0;
    f->old_caustics = -1.0f;
}

static bool reflection_equal(const reflection *a, const reflection *b)
{
    return colour_equal(a->min, b->min) && colour_equal(a->max, b->max) && a->falloff == b->falloff &&
           a->exponent == b->exponent && a->metallic == b->metallic && a->fresnel == b->fresnel;
}

/* Most that are equal are so byte for byte. */
bool finish_equal(const finish *a, const finish *b)
{
    if (memcmp(a, b, sizeof *a) == 0)
        return true;
    return colour_equal(a->ambient, b->ambient) && colour_equal(a->emission, b->emission) && colour_equal(a->translucency, b->translucency) && a->diffuse == b->diffuse &&
           a->diffuse_back == b->diffuse_back && a->written == b->written && a->phong == b->phong && a->phong_size == b->phong_size &&
           a->specular == b->specular && a->metallic == b->metallic && a->brilliance == b->brilliance &&
           a->roughness == b->roughness && a->crand == b->crand && a->refraction == b->refraction &&
           a->conserve_energy == b->conserve_energy && a->irid.amount == b->irid.amount &&
           a->irid.thickness == b->irid.thickness && a->irid.turbulence == b->irid.turbulence &&
           reflection_equal(&a->reflection, &b->reflection);
}
