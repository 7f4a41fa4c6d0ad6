/* marble.c - patterns that turbulence bends by a number of its own: marble, agate, wood, spiral1, spiral2. */
#include "texture/pattern.h"

#include "base/elementary.h"
#include "base/powers.h"

/* The scalar turbulence of the pattern, times the amount along x. */
static bool find_turbulence(const pattern_input *in, double *value)
{
    const turbulence *t = &in->of->turbulence;

    if (t->amount.x == 0.0)
        return false;
    noise_turbulence(in->noise, in->generator, t, in->at, in->n, value);
    for (uint32_t i = 0; i < in->n; i++)
        value[i] *= t->amount.x;
    return true;
}

static void add_turbulence(const pattern_input *in, double *value)
{
    SIMD_ALIGNED double t[LANES_MAX];

    if (find_turbulence(in, t))
        for (uint32_t i = 0; i < in->n; i++)
            value[i] += t[i];
}

/* ---- marble ---- */

static const colour_entry marble_map[] = {
    { 0.0f, { { 0.9f, 0.8f, 0.8f }, 0.0f, 0.0f } },
    { 0.9f, { { 0.9f, 0.08f, 0.08f }, 0.0f, 0.0f } },
    { 0.9f, { { 0.0f, 0.0f, 0.0f }, 0.0f, 0.0f } },
    { 1.0f, { { 0.0f, 0.0f, 0.0f }, 0.0f, 0.0f } },
};

static void evaluate_marble(const pattern_input *in, double *value)
{
    memcpy(value, in->at->x, in->n * sizeof *value);
    add_turbulence(in, value);
}

/* ---- agate ---- */

static const colour_entry agate_map[] = {
    { 0.0f, { { 1.0f, 1.0f, 1.0f }, 0.0f, 0.0f } },
    { 0.5f, { { 0.95f, 0.75f, 0.5f }, 0.0f, 0.0f } },
    { 0.5f, { { 0.9f, 0.7f, 0.5f }, 0.0f, 0.0f } },
    { 0.6f, { { 0.9f, 0.7f, 0.4f }, 0.0f, 0.0f } },
    { 0.6f, { { 1.0f, 0.7f, 0.4f }, 0.0f, 0.0f } },
    { 1.0f, { { 0.6f, 0.3f, 0.0f }, 0.0f, 0.0f } },
};

typedef struct agate { double turbulence; } agate;
static const agate agate_default = { 1.0 };
static const pattern_word agate_words[] = { { "agate_turb", PATTERN_FLOAT, offsetof(agate, turbulence), false } };

SIMD_CLONES static void to_bands(double amount, const double *restrict z, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++) {
        const double v = 0.5 * (elementary_sin_turns(1.3 * amount * value[i] + 1.1 * z[i]) + 1.0);

        value[i] = v < 1.0 ? v : 1.0;
    }
}

static void evaluate_agate(const pattern_input *in, double *value)
{
    const agate *self = in->of->self;

    noise_turbulence(in->noise, in->generator, &in->of->turbulence, in->at, in->n, value);
    to_bands(self->turbulence, in->at->z, in->n, value);
    powers_raise(0.77, in->n, value);
}

/* ---- wood ---- */

static const colour_entry wood_map[] = {
    { 0.6f, { { 0.666f, 0.312f, 0.2f }, 0.0f, 0.0f } },
    { 0.6f, { { 0.4f, 0.1333f, 0.066f }, 0.0f, 0.0f } },
};

SIMD_CLONES static void to_rings(const double *restrict x, const double *restrict y, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = sqrt(x[i] * x[i] + y[i] * y[i]);
}

SIMD_CLONES static void distort(double amount, const double *restrict at, uint32_t n, double *restrict v)
{
    for (uint32_t i = 0; i < n; i++)
        v[i] = at[i] + elementary_sin_turns(amount * (v[i] + at[i]));
}

static void evaluate_wood(const pattern_input *in, double *value)
{
    const turbulence *t = &in->of->turbulence;
    const uint32_t n = lanes_whole(in->n);
    vec_lanes v;

    if (turbulence_is_none(t)) {
        to_rings(in->at->x, in->at->y, n, value);
        return;
    }
    noise_flat_turbulence(in->noise, t, in->at, in->n, &v);
    distort(t->amount.x, in->at->x, in->n, v.x);
    distort(t->amount.y, in->at->y, in->n, v.y);
    to_rings(v.x, v.y, in->n, value);
}

/* ---- spirals ---- */

typedef struct spiral { int32_t arms; } spiral;
static const pattern_word spiral_words[] = { { NULL, PATTERN_INTEGER, offsetof(spiral, arms), false } };

SIMD_CLONES static void to_spiral(double arms, const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = at->x[i], y = at->y[i], turn = 0.15915494309189535 * elementary_atan2(y, x) + 0.25;

        value[i] = at->z[i] + sqrt(x * x + y * y) + arms * (turn < 0.0 ? turn + 1.0 : turn);
    }
}

static void evaluate_spiral1(const pattern_input *in, double *value)
{
    to_spiral(((const spiral *)in->of->self)->arms, in->at, lanes_whole(in->n), value);
    add_turbulence(in, value);
}

SIMD_INLINE double triangle(double v)
{
    const double t = v - floor(v);

    return t < 0.5 ? 2.0 * t : 2.0 - 2.0 * t;
}

SIMD_CLONES static void cross(const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++)
        value[i] = triangle(value[i]) + triangle(sqrt(at->x[i] * at->x[i] + at->y[i] * at->y[i]));
}

static void evaluate_spiral2(const pattern_input *in, double *value)
{
    evaluate_spiral1(in, value);
    cross(in->at, in->n, value);
}

const pattern_class pattern_marble = { .keyword = "marble", .map = marble_map, .map_count = 4, .form = WAVE_TRIANGLE,
                                       .flags = PATTERN_OWN_TURBULENCE, .evaluate = evaluate_marble };
const pattern_class pattern_agate = {
    .keyword = "agate", .map = agate_map, .map_count = 6, .self_size = sizeof(agate), .self = &agate_default,
    .words = agate_words, .word_count = 1, .flags = PATTERN_NEEDS_NOISE, .evaluate = evaluate_agate,
};
const pattern_class pattern_wood = { .keyword = "wood", .map = wood_map, .map_count = 2, .form = WAVE_TRIANGLE,
                                     .flags = PATTERN_OWN_TURBULENCE, .evaluate = evaluate_wood };
const pattern_class pattern_spiral1 = {
    .keyword = "spiral1", .self_size = sizeof(spiral), .words = spiral_words, .word_count = 1, .form = WAVE_TRIANGLE,
    .evaluate = evaluate_spiral1,
};
const pattern_class pattern_spiral2 = {
    .keyword = "spiral2", .self_size = sizeof(spiral), .words = spiral_words, .word_count = 1, .form = WAVE_TRIANGLE,
    .evaluate = evaluate_spiral2,
};
