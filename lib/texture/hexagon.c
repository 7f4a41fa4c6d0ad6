#include "texture/hexagonal.h"
#include "texture/pattern.h"

/* Three colours, so that neighbours differ. */
SIMD_CLONES static void find(const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    for (uint32_t k = 0; k < n; k++) {
        const hexagonal_cell c = hexagonal_at(at->x[k], at->z[k]);
        const double sum = 2.0 * c.i + c.j;

        value[k] = sum - 3.0 * floor(sum / 3.0);
    }
}

static void evaluate(const pattern_input *in, double *value)
{
    find(in->at, lanes_whole(in->n), value);
}

const pattern_class pattern_hexagon = {
    .keyword = "hexagon",
    .count = 3,
    .list = { { .color = { 0.0f, 0.0f, 1.0f } }, { .color = { 0.0f, 1.0f, 0.0f } }, { .color = { 1.0f, 0.0f, 0.0f } } },
    .evaluate = evaluate,
};
