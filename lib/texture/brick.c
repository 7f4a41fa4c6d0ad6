#include "texture/pattern.h"

/* POV-Ray moves points by this in the pattern's space, so that faces on whole coordinates are of one colour. */
static const double nudge = 1e-10;

typedef struct brick { pov_vec3 size; double mortar; } brick;

SIMD_INLINE double fraction(double v) { return v - floor(v); }

/* Mortar fills the upper end of each period. Odd courses are shifted along x, even ones along z. */
SIMD_CLONES static void find(const brick *restrict b, const vec_lanes *restrict at, uint32_t n, double *restrict value)
{
    const double sx = b->size.x, sy = b->size.y, sz = b->size.z, mortar = b->mortar;
    const double mx = 1.0 - mortar / sx, my = 1.0 - mortar / sy, mz = 1.0 - mortar / sz;

    for (uint32_t i = 0; i < n; i++) {
        const double x = (at->x[i] + nudge) / sx, y = (at->y[i] + nudge) / sy, z = (at->z[i] + nudge) / sz;
        const double course = floor(y), odd = course - 2.0 * floor(0.5 * course);
        const double over_x = fraction(x + 0.5 * odd) - mx, over_z = fraction(z + 0.5 - 0.5 * odd) - mz, over_y = (y - course) - my;
        const double a = over_x > over_y ? over_x : over_y, most = a > over_z ? a : over_z;

        value[i] = most >= 0.0 ? 0.0 : 1.0;
    }
}

static void evaluate(const pattern_input *in, double *value)
{
    find(in->of->self, in->at, lanes_whole(in->n), value);
}

static const char *check(const void *self)
{
    const brick *b = self;

    return b->size.x * b->size.y * b->size.z != 0.0 ? NULL : "the sides of a brick must not be 0";
}

static const brick usual = { { 8.0, 3.0, 4.5 }, 0.5 };
static const pattern_word words[] = {
    { "brick_size", PATTERN_VECTOR, offsetof(brick, size), false },
    { "mortar", PATTERN_NUMBER, offsetof(brick, mortar), false },
};

const pattern_class pattern_brick = {
    .keyword = "brick",
    .count = 2,
    .list = { { .color = { 0.5f, 0.5f, 0.5f } }, { .color = { 0.6f, 0.15f, 0.15f } } },
    .self_size = sizeof(brick),
    .self = &usual,
    .words = words,
    .word_count = sizeof words / sizeof words[0],
    .check = check,
    .evaluate = evaluate,
};
