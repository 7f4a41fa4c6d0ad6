#include "shade/film.h"

#include "base/elementary.h"
#include "texture/noise.h"

#include <math.h>

double film_thickness(const model *m, const finish *f, pov_vec3 point)
{
    turbulence t = turbulence_default();

    t.octaves = 5;
    if (f->irid.turbulence == 0.0f || f->irid.amount == 0.0f)
        return (double)f->irid.thickness;
    return (double)f->irid.thickness *
           (1.0 + (double)f->irid.turbulence * (2.0 * noise_turbulence_at(m->noise, m->noise_generator, &t, point) - 1.0));
}

static float factor(const finish *f, double length, float wavelength)
{
    const double full_turn = 6.28318530717958647693;

    return 1.0f + f->irid.amount * (float)elementary_cos(full_turn * length / (double)wavelength);
}

colour film_mirrored(const model *m, const finish *f, double cosines, pov_vec3 point)
{
    const double length = film_thickness(m, f, point) * cosines;
    const colour waves = m->irid_wavelength;

    return colour_of(factor(f, length, waves.r), factor(f, length, waves.g), factor(f, length, waves.b));
}
