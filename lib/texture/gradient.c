/* gradient.c - patterns of directions: gradient, radial, leopard, cubic. */
#include "texture/pattern.h"

#include "base/elementary.h"

/* ---- gradient ---- */

typedef struct gradient { pov_vec3 direction; } gradient;
static const pattern_word gradient_words[] = { { NULL, PATTERN_VECTOR, offsetof(gradient, direction), false } };

/* Above 1 what is whole is left out; below 0 that is left to the wave. */
SIMD_CLONES static void find_gradient(const vec_lanes *restrict at, pov_vec3 unit, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++) {
        const double v = at->x[i] * unit.x + at->y[i] * unit.y + at->z[i] * unit.z;

        value[i] = v > 1.0 ? v - floor(v) : v;
    }
}

static void evaluate_gradient(const pattern_input *in, double *value)
{
    const gradient *self = in->of->self;

    find_gradient(in->at, pov_unit(self->direction), lanes_whole(in->n), value);
}

/* ---- radial ---- */

static const colour_entry radial_map[] = {
    { 0.0f, { { 0.0f, 1.0f, 1.0f }, 0.0f, 0.0f } },
    { 0.333f, { { 1.0f, 1.0f, 0.0f }, 0.0f, 0.0f } },
    { 0.666f, { { 1.0f, 0.0f, 1.0f }, 0.0f, 0.0f } },
    { 1.0f, { { 0.0f, 1.0f, 1.0f }, 0.0f, 0.0f } },
};

SIMD_CLONES static void find_radial(const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = 0.75 + 0.15915494309189535 * elementary_atan2(at->x[i], at->z[i]);
}

static void evaluate_radial(const pattern_input *in, double *value)
{
    find_radial(in->at, lanes_whole(in->n), value);
}

/* ---- leopard ---- */

SIMD_INLINE double sine(double v) { return elementary_sin_turns(elementary_turns_of(v)); }

SIMD_CLONES static void find_leopard(const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++) {
        const double mean = (sine(at->x[i]) + sine(at->y[i]) + sine(at->z[i])) / 3.0;

        value[i] = mean * mean;
    }
}

static void evaluate_leopard(const pattern_input *in, double *value)
{
    find_leopard(in->at, lanes_whole(in->n), value);
}

/* ---- cubic ---- */

/* The face of a cube about the origin: 0 to 2 towards x, y, z, 3 to 5 against them. On edges the first one counts. */
SIMD_CLONES static void find_face(const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = at->x[i], y = at->y[i], z = at->z[i], a = fabs(x), b = fabs(y), c = fabs(z);
        const double most = a > b ? (a > c ? a : c) : (b > c ? b : c);
        const double against = -x == most ? 3.0 : -y == most ? 4.0 : 5.0;

        value[i] = x == most ? 0.0 : y == most ? 1.0 : z == most ? 2.0 : against;
    }
}

static void evaluate_cubic(const pattern_input *in, double *value)
{
    find_face(in->at, lanes_whole(in->n), value);
}

const pattern_class pattern_gradient = { .keyword = "gradient", .self_size = sizeof(gradient), .words = gradient_words,
                                         .word_count = 1, .evaluate = evaluate_gradient };
const pattern_class pattern_radial = { .keyword = "radial", .map = radial_map, .map_count = 4, .evaluate = evaluate_radial };
const pattern_class pattern_leopard = { .keyword = "leopard", .evaluate = evaluate_leopard };
const pattern_class pattern_cubic = {
    .keyword = "cubic",
    .count = 6,
    .list = { { .color = { 1.0f, 0.0f, 0.0f } }, { .color = { 0.0f, 1.0f, 0.0f } }, { .color = { 0.0f, 0.0f, 1.0f } },
              { .color = { 1.0f, 1.0f, 0.0f } }, { .color = { 0.0f, 1.0f, 1.0f } }, { .color = { 1.0f, 0.0f, 1.0f } } },
    .evaluate = evaluate_cubic,
};
