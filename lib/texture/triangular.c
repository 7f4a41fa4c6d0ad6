#include "texture/hexagonal.h"
#include "texture/pattern.h"

/* The sixth of a hexagon, by its angle, in which a point lies: bounds belong to the sixth behind them, but for that along -x. */
SIMD_INLINE double sixth(double x, double z)
{
    const double line = hexagonal_root3 * x;
    const double upper = z < line ? 0.0 : z > -line ? 1.0 : 2.0, lower = -z < -line ? 3.0 : -z > line ? 4.0 : 5.0;

    return z >= 0.0 ? upper : lower;
}

SIMD_CLONES static void find(const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    for (uint32_t k = 0; k < n; k++) {
        const hexagonal_cell c = hexagonal_at(at->x[k], at->z[k]);

        value[k] = sixth(c.x, c.z);
    }
}

static void evaluate(const pattern_input *in, double *value)
{
    find(in->at, lanes_whole(in->n), value);
}

const pattern_class pattern_triangular = {
    .keyword = "triangular",
    .count = 6,
    .list = { { .color = { 1.0f, 0.0f, 0.0f } }, { .color = { 0.0f, 1.0f, 0.0f } }, { .color = { 0.0f, 0.0f, 1.0f } },
              { .color = { 1.0f, 1.0f, 0.0f } }, { .color = { 0.0f, 1.0f, 1.0f } }, { .color = { 1.0f, 0.0f, 1.0f } } },
    .evaluate = evaluate,
};
