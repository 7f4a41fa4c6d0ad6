/* noise_patterns.c - patterns that are little else than noise: bozo, spotted, bumps, dents, wrinkles, granite. */
#include "texture/normal.h"
#include "texture/pattern.h"

/* ---- noise itself ---- */

static const colour_entry bozo_map[] = {
    { 0.0f, { { 1.0f, 1.0f, 1.0f }, 0.0f, 0.0f } },
    { 0.4f, { { 1.0f, 1.0f, 1.0f }, 0.0f, 0.0f } },
    { 0.4f, { { 0.0f, 1.0f, 0.0f }, 0.0f, 0.0f } },
    { 0.6f, { { 0.0f, 1.0f, 0.0f }, 0.0f, 0.0f } },
    { 0.6f, { { 0.0f, 0.0f, 1.0f }, 0.0f, 0.0f } },
    { 0.8f, { { 0.0f, 0.0f, 1.0f }, 0.0f, 0.0f } },
    { 0.8f, { { 1.0f, 0.0f, 0.0f }, 0.0f, 0.0f } },
    { 1.0f, { { 1.0f, 0.0f, 0.0f }, 0.0f, 0.0f } },
};

static void evaluate_noise(const pattern_input *in, double *value)
{
    noise_values(in->noise, in->generator, in->at, 1.0, in->n, value);
}

static void perturb_bumps(const pattern_input *in, double amount, vec_lanes *normal)
{
    vec_lanes bump;

    noise_vectors(in->noise, in->at, 1.0, in->n, &bump);
    normal_add(&bump, amount, in->n, normal);
}

/* ---- dents ---- */

static void evaluate_dents(const pattern_input *in, double *value)
{
    evaluate_noise(in, value);
    for (uint32_t i = 0; i < in->n; i++)
        value[i] = value[i] * value[i] * value[i];
}

static void perturb_dents(const pattern_input *in, double amount, vec_lanes *normal)
{
    double depth[LANES_MAX];
    vec_lanes bump;

    noise_vectors(in->noise, in->at, 1.0, in->n, &bump);
    evaluate_dents(in, depth);
    for (uint32_t i = 0; i < in->n; i++)
        lanes_put(&bump, i, pov_scale(lanes_at(&bump, i), depth[i]));
    normal_add(&bump, amount, in->n, normal);
}

/* ---- sums over octaves ---- */

enum { WRINKLES = 10, GRANITE = 6 };

static void evaluate_wrinkles(const pattern_input *in, double *value)
{
    noise_octaves(in->noise, in->generator, in->at, 1.0, WRINKLES, false, in->n, value);
}

SIMD_CLONES static void add_size(double factor, const double *restrict term, uint32_t n, double *restrict sum)
{
    for (uint32_t i = 0; i < n; i++)
        sum[i] += factor * fabs(term[i]);
}

static void perturb_wrinkles(const pattern_input *in, double amount, vec_lanes *normal)
{
    double scale = 1.0;
    vec_lanes term;

    for (int octave = 0; octave < WRINKLES; octave++, scale *= 2.0) {
        noise_vectors(in->noise, in->at, scale, in->n, &term);
        add_size(amount / scale, term.x, in->n, normal->x);
        add_size(amount / scale, term.y, in->n, normal->y);
        add_size(amount / scale, term.z, in->n, normal->z);
    }
}

static void evaluate_granite(const pattern_input *in, double *value)
{
    noise_octaves(in->noise, in->generator, in->at, 4.0, GRANITE, true, in->n, value);
}

const pattern_class pattern_bozo = { .keyword = "bozo", .map = bozo_map, .map_count = 8, .flags = PATTERN_NEEDS_NOISE, .evaluate = evaluate_noise };
const pattern_class pattern_spotted = { .keyword = "spotted", .flags = PATTERN_NEEDS_NOISE, .evaluate = evaluate_noise };
const pattern_class pattern_bumps = { .keyword = "bumps", .flags = PATTERN_NEEDS_NOISE, .evaluate = evaluate_noise,
                                      .perturb = perturb_bumps };
const pattern_class pattern_dents = { .keyword = "dents", .flags = PATTERN_NEEDS_NOISE, .evaluate = evaluate_dents,
                                      .perturb = perturb_dents };
const pattern_class pattern_wrinkles = { .keyword = "wrinkles", .flags = PATTERN_NEEDS_NOISE, .evaluate = evaluate_wrinkles,
                                         .perturb = perturb_wrinkles };
const pattern_class pattern_granite = { .keyword = "granite", .flags = PATTERN_NEEDS_NOISE, .evaluate = evaluate_granite };
