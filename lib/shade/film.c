#include "shade/film.h"

#include "base/elementary.h"
#include "texture/noise.h"

#include <math.h>

static bool is_turbulent(const finish *f) { return f->irid.turbulence != 0.0f && f->irid.amount != 0.0f; }

void films_find(films *f, const model *m)
{
    turbulence t = turbulence_default();
    SIMD_ALIGNED double noise[LANES_MAX];
    bool any = false;

    t.octaves = 5;
    for (uint32_t i = 0; i < f->count; i++)
        any = any || is_turbulent(f->of[i]);
    for (uint32_t i = f->count; any && i < lanes_whole(f->count); i++)
        lanes_put(&f->at, i, lanes_at(&f->at, 0));
    if (any)
        noise_turbulence(m->noise, m->noise_generator, &t, &f->at, f->count, noise);
    for (uint32_t i = 0; i < f->count; i++) {
        const double thickness = (double)f->of[i]->irid.thickness, by = (double)f->of[i]->irid.turbulence;

        f->thickness[i] = is_turbulent(f->of[i]) ? thickness * (1.0 + by * (2.0 * noise[i] - 1.0)) : thickness;
    }
}

double film_thickness(const model *m, const finish *f, pov_vec3 point)
{
    films one;

    one.count = 0;
    films_add(&one, f, point);
    films_find(&one, m);
    return one.thickness[0];
}

static inline float factor(float amount, double length, float wavelength)
{
    const double full_turn = 6.28318530717958647693;

    return 1.0f + amount * (float)elementary_cos(full_turn * length / (double)wavelength);
}

SIMD_CLONES static void find_factors(const float *restrict amount, const double *restrict thickness, const double *restrict cosines, float wavelength,
                                     uint32_t n, float *restrict out)
{
    for (uint32_t i = 0; i < n; i++)
        out[i] = factor(amount[i], thickness[i] * cosines[i], wavelength);
}

void films_mirrored(films *f, const model *m)
{
    const colour waves = m->irid_wavelength;
    float amount[LANES_MAX];

    for (uint32_t i = 0; i < f->count; i++)
        amount[i] = f->of[i]->irid.amount;
    find_factors(amount, f->thickness, f->cosines, waves.r, f->count, f->factor[0]);
    find_factors(amount, f->thickness, f->cosines, waves.g, f->count, f->factor[1]);
    find_factors(amount, f->thickness, f->cosines, waves.b, f->count, f->factor[2]);
}

colour film_mirrored(const model *m, const finish *f, double thickness, double cosines)
{
    const colour waves = m->irid_wavelength;
    const double length = thickness * cosines;
    const float amount = f->irid.amount;

    return colour_of(factor(amount, length, waves.r), factor(amount, length, waves.g), factor(amount, length, waves.b));
}
