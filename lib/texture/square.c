#include "texture/pattern.h"

/* The parity of a whole number. */
static inline double parity(double whole) { return whole - 2.0 * floor(0.5 * whole); }

/* Four squares of side 1 around a corner with even coordinates, numbered around it. */
SIMD_CLONES static void find(const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    for (uint32_t i = 0; i < n; i++) {
        const double x = parity(floor(at->x[i])), z = parity(floor(at->z[i]));

        value[i] = z + x * (3.0 - 2.0 * z);
    }
}

static void evaluate(const pattern_input *in, double *value)
{
    find(in->at, lanes_whole(in->n), value);
}

const pattern_class pattern_square = {
    .keyword = "square",
    .count = 4,
    .list = { { .color = { 1.0f, 0.0f, 0.0f } },
              { .color = { 0.0f, 1.0f, 0.0f } },
              { .color = { 0.0f, 0.0f, 1.0f } },
              { .color = { 1.0f, 1.0f, 0.0f } } },
    .evaluate = evaluate,
};
