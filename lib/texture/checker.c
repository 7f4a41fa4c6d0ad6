#include "texture/pattern.h"

/* POV-Ray moves points by this in the pattern's space, so that faces on whole coordinates are of one colour. */
static const double nudge = 1e-10;

/* Cubes of side 1, alternating in all three directions. */
SIMD_CLONES static void find(const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++) {
        const double sum = floor(at->x[i] + nudge) + floor(at->y[i] + nudge) + floor(at->z[i] + nudge);

        value[i] = sum - 2.0 * floor(0.5 * sum);
    }
}

static void evaluate(const pattern_input *in, double *value)
{
    find(in->at, lanes_whole(in->n), value);
}

const pattern_class pattern_checker = {
    .keyword = "checker",
    .count = 2,
    .list = { { .color = { 0.0f, 0.0f, 1.0f } }, { .color = { 0.0f, 1.0f, 0.0f } } },
    .evaluate = evaluate,
};
