#include "texture/cube.h"
#include "texture/pattern.h"

/* Normals that are the same in each cell of `size`: of the space where `coords` says how far they turn, else of
 * directions. */
typedef struct facets { double coords, size; } facets;

static pov_vec3 of_cell(const pattern_input *in, double amount, pov_vec3 cell, pov_vec3 n)
{
    const pov_vec3 at = cube_nearest(in->noise, cell);
    const turbulence one = { { 0.0, 0.0, 0.0 }, 1, 2.0f, 0.5f };
    const pov_vec3 d = noise_vector_turbulence_at(in->noise, &one, at);

    return pov_add(n, pov_scale(pov_sub(d, pov_scale(n, pov_dot(n, d))), amount));
}

static void perturb(const pattern_input *in, double amount, vec_lanes *normal)
{
    const facets *f = in->of->self;

    (void)amount;
    for (uint32_t i = 0; i < in->n; i++) {
        const pov_vec3 unit = pov_unit(lanes_at(normal, i));

        lanes_put(normal, i, f->coords != 0.0 ? of_cell(in, f->coords, pov_scale(lanes_at(in->at, i), 1.0 / f->size), unit)
                                              : cube_nearest(in->noise, pov_scale(unit, 1.0 / f->size)));
    }
}

static const char *check(const void *self)
{
    return ((const facets *)self)->size > 0.0 ? NULL : "the size of facets must be above 0";
}

static void evaluate(const pattern_input *in, double *value)
{
    for (uint32_t i = 0; i < in->n; i++)
        value[i] = 0.0;
}

static const facets usual = { 0.0, 0.1 };
static const pattern_word words[] = {
    { "coords", PATTERN_NUMBER, offsetof(facets, coords), false },
    { "size", PATTERN_NUMBER, offsetof(facets, size), false },
};

const pattern_class pattern_facets = {
    .keyword = "facets",
    .self_size = sizeof(facets),
    .self = &usual,
    .words = words,
    .word_count = sizeof words / sizeof words[0],
    .check = check,
    .flags = PATTERN_NEEDS_NOISE,
    .evaluate = evaluate,
    .perturb = perturb,
};
