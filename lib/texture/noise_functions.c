#include "texture/noise_functions.h"

#include "base/elementary.h"
#include "model/model.h"
#include "texture/noise.h"

/* A parameter that names a generator: its last two bits, of which 0 acts as 1. */
static int generator_of(double parameter)
{
    const int bits = parameter >= -2147483648.0 && parameter < 2147483648.0 ? (int32_t)parameter & 3 : 0;

    return bits ? bits : 1;
}

static double noise_at(const void *scene, int generator, const double *v, double scale)
{
    const model *m = scene;

    return noise_value_at(m->noise, generator, pov_vec3_of(v[0] * scale, v[1] * scale, v[2] * scale));
}

static double noise3d(const void *scene, const double *v, uint32_t part)
{
    (void)part;
    return noise_at(scene, ((const model *)scene)->noise_generator, v, 1.0);
}

static double noise_generator(const void *scene, const double *v, uint32_t part)
{
    (void)part;
    return noise_at(scene, generator_of(v[3]), v, 1.0);
}

/* More octaves than this add nothing, or leave the range of double. */
static double octaves_of(double parameter) { return parameter < 1000.0 ? parameter : 1000.0; }

/* ---- hetero_mf: H, lacunarity, octaves, offset, T, generator ---- */

static double power(double base, int exponent)
{
    double product = 1.0;

    for (int i = 0; i < exponent; i++)
        product *= base;
    return product;
}

static double hetero_term(const void *scene, const double *v, double scale, double octave)
{
    const double noise = 2.0 * noise_at(scene, generator_of(v[8]), v, scale) - 1.0 + v[6];

    return noise * elementary_pow(v[4], -v[3] * octave);
}

static double hetero_mf(const void *scene, const double *v, uint32_t part)
{
    const int exponent = v[7] >= 1.0 ? (int)(v[7] < 64.0 ? v[7] : 64.0) : 0;
    const double octaves = octaves_of(v[5]), rest = octaves - floor(octaves);
    double value = hetero_term(scene, v, 1.0, 0.0), scale = v[4], octave = 1.0;

    (void)part;
    for (; octave < octaves; octave += 1.0, scale *= v[4])
        value += hetero_term(scene, v, scale, octave) * power(value, exponent);
    return octaves > 0.0 && rest > 0.0 ? value + rest * hetero_term(scene, v, scale, octave) * value : value;
}

/* ---- ridge: lambda, octaves, omega, offset, ridge, generator ---- */

static double most(double a, double b) { return a > b ? a : b; }

static double ridge_term(const void *scene, const double *v, double scale)
{
    const double noise = noise_at(scene, generator_of(v[8]), v, scale);

    return (fabs(noise - v[7]) / most(v[7], 1.0 - v[7]) - v[6]) / most(v[6], 1.0 - v[6]);
}

static double ridge(const void *scene, const double *v, uint32_t part)
{
    const double octaves = octaves_of(v[4]), whole = octaves < 0.0 ? ceil(octaves) : floor(octaves);
    double value = ridge_term(scene, v, 1.0), total = 1.0, scale = v[3], weight = v[5];

    (void)part;
    for (double octave = 1.0; octave < whole; octave += 1.0, scale *= v[3], weight *= v[5]) {
        value += weight * ridge_term(scene, v, scale);
        total += weight;
    }
    weight *= octaves - whole;
    if (weight == 0.0)
        return value / total;
    return (value + weight * ridge_term(scene, v, scale)) / (total + weight);
}

/* ---- ridged_mf: H, lacunarity, octaves, offset, gain, generator ---- */

static double ridged_term(const void *scene, const double *v, double scale)
{
    const double height = v[6] - fabs(2.0 * noise_at(scene, generator_of(v[8]), v, scale) - 1.0);

    return height * height;
}

static double clamp(double v) { return !(v > 0.0) ? 0.0 : v < 1.0 ? v : 1.0; }

static double ridged_mf(const void *scene, const double *v, uint32_t part)
{
    const double octaves = octaves_of(v[5]);
    double signal = ridged_term(scene, v, 1.0), value = signal, scale = v[4];

    (void)part;
    for (double octave = 1.0; octave < octaves; octave += 1.0, scale *= v[4]) {
        signal = ridged_term(scene, v, scale) * clamp(signal * v[7]);
        value += signal * elementary_pow(v[4], -v[3] * octave);
    }
    return value;
}

noise_function *noise_function_find(uint32_t number)
{
    switch (number) {
    case 29: return hetero_mf;
    case 58: return ridge;
    case 59: return ridged_mf;
    case 76: return noise3d;
    case 78: return noise_generator;
    default: return NULL;
    }
}
