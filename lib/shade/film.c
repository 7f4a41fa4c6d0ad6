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

static float factor(const finish *f, double length, float wavelength)
{
    const double full_turn = 6.28318530717958647693;

    return 1.0f + f->irid.amount * (float)elementary_cos(full_turn * length / (double)wavelength);
}

colour film_mirrored(const model *m, const finish *f, double thickness, double cosines)
{
    const double length = thickness * cosines;
    const colour waves = m->irid_wavelength;

    return colour_of(factor(f, length, waves.r), factor(f, length, waves.g), factor(f, length, waves.b));
}
