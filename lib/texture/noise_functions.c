#include "texture/noise_functions.h"

#include "base/elementary.h"
#include "model/model.h"
#include "texture/noise.h"

/* Points that share their parameters. */
typedef struct asked {
    const model *scene;
    const double *p;             /* the parameters */
    const vec_lanes *at;
    uint32_t n;
} asked;

/* A value for each point. */
typedef void noise_function(const asked *a, double *value);

enum { AXES = 3, PARAMETERS_MAX = 6, GENERATOR = 5, LANES = NOISE_FUNCTION_LANES };

/* A parameter that names a generator: its last two bits, of which 0 acts as 1. */
static int generator_of(double parameter)
{
    const int bits = parameter >= -2147483648.0 && parameter < 2147483648.0 ? (int32_t)parameter & 3 : 0;

    return bits ? bits : 1;
}

static void noise3d(const asked *a, double *value)
{
    noise_values(a->scene->noise, a->scene->noise_generator, a->at, 1.0, a->n, value);
}

static void noise_generator(const asked *a, double *value)
{
    noise_values(a->scene->noise, generator_of(a->p[0]), a->at, 1.0, a->n, value);
}

/* More octaves than this add nothing, or leave the range of double. */
static double octaves_of(double parameter) { return parameter < 1000.0 ? parameter : 1000.0; }

/* Of the functions with six parameters. */
static void find_noise(const asked *a, double scale, double *noise)
{
    noise_values(a->scene->noise, generator_of(a->p[GENERATOR]), a->at, scale, a->n, noise);
}

/* ---- hetero_mf: H, lacunarity, octaves, offset, T, generator ---- */

static double power(double base, int exponent)
{
    double product = 1.0;

    for (int i = 0; i < exponent; i++)
        product *= base;
    return product;
}

static void hetero_terms(const asked *a, double scale, double octave, double *term)
{
    const double weight = elementary_pow(a->p[1], -a->p[0] * octave);

    find_noise(a, scale, term);
    for (uint32_t l = 0; l < a->n; l++)
        term[l] = (2.0 * term[l] - 1.0 + a->p[3]) * weight;
}

static void hetero_mf(const asked *a, double *value)
{
    const double *p = a->p;
    const int exponent = p[4] >= 1.0 ? (int)(p[4] < 64.0 ? p[4] : 64.0) : 0;
    const double octaves = octaves_of(p[2]), rest = octaves - floor(octaves);
    double scale = p[1], octave = 1.0, term[LANES];

    hetero_terms(a, 1.0, 0.0, value);
    for (; octave < octaves; octave += 1.0, scale *= p[1]) {
        hetero_terms(a, scale, octave, term);
        for (uint32_t l = 0; l < a->n; l++)
            value[l] += term[l] * power(value[l], exponent);
    }
    if (!(octaves > 0.0 && rest > 0.0))
        return;
    hetero_terms(a, scale, octave, term);
    for (uint32_t l = 0; l < a->n; l++)
        value[l] += rest * term[l] * value[l];
}

/* ---- ridge: lambda, octaves, omega, offset, ridge, generator ---- */

static double most(double a, double b) { return a > b ? a : b; }

static void ridge_terms(const asked *a, double scale, double *term)
{
    const double offset = a->p[3], ridge = a->p[4];

    find_noise(a, scale, term);
    for (uint32_t l = 0; l < a->n; l++)
        term[l] = (fabs(term[l] - ridge) / most(ridge, 1.0 - ridge) - offset) / most(offset, 1.0 - offset);
}

static void add_ridges(const asked *a, double scale, double weight, double *value)
{
    double term[LANES];

    ridge_terms(a, scale, term);
    for (uint32_t l = 0; l < a->n; l++)
        value[l] += weight * term[l];
}

static void ridge(const asked *a, double *value)
{
    const double *p = a->p, octaves = octaves_of(p[1]), whole = octaves < 0.0 ? ceil(octaves) : floor(octaves);
    double total = 1.0, scale = p[0], weight = p[2];

    ridge_terms(a, 1.0, value);
    for (double octave = 1.0; octave < whole; octave += 1.0, scale *= p[0], weight *= p[2]) {
        add_ridges(a, scale, weight, value);
        total += weight;
    }
    weight *= octaves - whole;
    if (weight != 0.0) {
        add_ridges(a, scale, weight, value);
        total += weight;
    }
    for (uint32_t l = 0; l < a->n; l++)
        value[l] /= total;
}

/* ---- ridged_mf: H, lacunarity, octaves, offset, gain, generator ---- */

static double clamp(double v) { return !(v > 0.0) ? 0.0 : v < 1.0 ? v : 1.0; }

static void ridged_terms(const asked *a, double scale, double *term)
{
    find_noise(a, scale, term);
    for (uint32_t l = 0; l < a->n; l++) {
        const double height = a->p[3] - fabs(2.0 * term[l] - 1.0);

        term[l] = height * height;
    }
}

static void ridged_mf(const asked *a, double *value)
{
    const double *p = a->p, octaves = octaves_of(p[2]);
    double scale = p[1], signal[LANES], term[LANES];

    ridged_terms(a, 1.0, signal);
    for (uint32_t l = 0; l < a->n; l++)
        value[l] = signal[l];
    for (double octave = 1.0; octave < octaves; octave += 1.0, scale *= p[1]) {
        const double weight = elementary_pow(p[1], -p[0] * octave);

        ridged_terms(a, scale, term);
        for (uint32_t l = 0; l < a->n; l++) {
            signal[l] = term[l] * clamp(signal[l] * p[4]);
            value[l] += signal[l] * weight;
        }
    }
}

/* ---- all of them ---- */

static noise_function *function_of(uint32_t number)
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

bool noise_function_exists(uint32_t number) { return function_of(number) != NULL; }

/* Have the lanes the same parameters as the first? */
static bool are_same(const double *v, uint32_t parameters, uint32_t n)
{
    for (uint32_t k = 0; k < parameters; k++)
        for (uint32_t l = 1; l < n; l++)
            if (!(v[k * LANES + l] == v[k * LANES]))
                return false;
    return true;
}

/* Lanes from `first` on. */
static void find_some(const model *scene, const double *v, uint32_t parameters, uint32_t number, uint32_t first, uint32_t n, double *out)
{
    double p[PARAMETERS_MAX];
    vec_lanes at;
    const asked a = { scene, p, &at, n };

    for (uint32_t k = 0; k < parameters; k++)
        p[k] = v[(AXES + k) * LANES + first];
    for (uint32_t l = 0; l < lanes_whole(n); l++) {
        const uint32_t from = first + (l < n ? l : 0);

        lanes_put(&at, l, pov_vec3_of(v[from], v[LANES + from], v[2 * LANES + from]));
    }
    function_of(number)(&a, out);
}

static uint32_t parameters_of(uint32_t number) { return number == 76 ? 0 : number == 78 ? 1 : PARAMETERS_MAX; }

void noise_function_values(const void *scene, const double *v, uint32_t number, uint32_t n, void *memo, double *out)
{
    const uint32_t parameters = parameters_of(number);
    double one[LANES];

    (void)memo;
    if (are_same(v + AXES * LANES, parameters, n)) {
        find_some(scene, v, parameters, number, 0, n, out);
        return;
    }
    for (uint32_t l = 0; l < n; l++) {
        find_some(scene, v, parameters, number, l, 1, one);
        out[l] = one[0];
    }
}

double noise_function_value(const void *scene, const double *v, uint32_t number)
{
    double value[LANES];
    vec_lanes at;
    const asked a = { scene, v + AXES, &at, 1 };

    for (uint32_t l = 0; l < lanes_whole(1); l++)
        lanes_put(&at, l, pov_vec3_of(v[0], v[1], v[2]));
    function_of(number)(&a, value);
    return value[0];
}
