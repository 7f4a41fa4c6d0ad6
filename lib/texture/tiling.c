#include "texture/tiling.h"

#include "texture/pattern.h"
#include "texture/penrose.h"

/* Tiles of several kinds: the value is kind + 1 at their borders and falls towards kind inside, by the number of kinds. */
typedef struct tiling_choice { int32_t number; } tiling_choice;

static const double cos15 = 0.96592582628906828675, sin15 = 0.25881904510252076235;
static const double cos30 = 0.86602540378443864676, cos45 = 0.70710678118654752440;

/* Distance of a point, from the middle of a tile, to the side that it is nearest to; negative: outside. What is not above `least` does
 * not matter. */
static double depth_in(const tiling_outline *o, double x, double z, double least)
{
    const double cosines[] = { 1.0, cos15, cos30, cos45, 0.5, sin15, 0.0, -sin15, -0.5, -cos45, -cos30, -cos15,
                               -1.0, -cos15, -cos30, -cos45, -0.5, -sin15, 0.0, sin15, 0.5, cos45, cos30, cos15 };
    double depth = HUGE_VAL;

    for (uint32_t i = 0; i < o->sides && depth > least; i++) {
        const uint32_t d = o->direction[i], quarter = TILING_DIRECTIONS / 4;
        double rest = o->distance[i % o->distances] - (x * cosines[d] + z * cosines[(d + 3 * quarter) % TILING_DIRECTIONS]);

        if (o->gentle >> i & 1u)
            rest *= cos30;
        depth = rest < depth ? rest : depth;
    }
    return depth;
}

/* Tiles do not overlap: a point that is this deep in one is in no other. */
static const double certain = 0x1p-20;

/* The same in those copies of a tile that are nearest. */
static double depth_in_copies(const tiling *t, const tiling_tile *tile, double x, double z, double least)
{
    const double area = t->across[0] * t->along[1] - t->across[1] * t->along[0];
    const double u = floor((x * t->along[1] - z * t->along[0]) / area + 0.5);
    const double v = floor((z * t->across[0] - x * t->across[1]) / area + 0.5);
    double deepest = least;

    for (int i = -1; i <= 1 && deepest < certain; i++)
        for (int j = -1; j <= 1 && deepest < certain; j++) {
            const double depth = depth_in(&tiling_outlines[tile->outline], x - (u + i) * t->across[0] - (v + j) * t->along[0],
                                          z - (u + i) * t->across[1] - (v + j) * t->along[1], deepest);

            deepest = depth > deepest ? depth : deepest;
        }
    return deepest;
}

/* A side belongs to the tile behind it, along both axes, as in POV-Ray. */
static const double nudge = 1e-12;

static double value_at(const tiling *t, double x_at, double z_at)
{
    const double x = x_at + nudge, z = z_at + nudge;
    double deepest = -HUGE_VAL, border;
    uint32_t kind = 0;

    for (uint32_t i = 0; i < t->count && deepest < certain; i++) {
        const double depth = depth_in_copies(t, &t->tiles[i], x - t->tiles[i].x, z - t->tiles[i].z, deepest);

        if (depth > deepest) {
            deepest = depth;
            kind = t->tiles[i].kind;
        }
    }
    border = 1.0 - deepest / t->inner;
    return (kind + (border > 0.0 ? border < 1.0 ? border : 1.0 : 0.0)) / t->kinds;
}

static double tiled(int32_t number, double x, double z)
{
    switch (number) {
    case 25: return penrose_pentagons(x, z);
    case 26: return penrose_kites(x, z);
    case 27: return penrose_rhombi(x, z);
    default: return value_at(&tiling_table[number - 1], x, z);
    }
}

static void evaluate(const pattern_input *in, double *value)
{
    const tiling_choice *c = in->of->self;

    for (uint32_t i = 0; i < in->n; i++)
        value[i] = tiled(c->number, in->at->x[i], in->at->z[i]);
}

static const char *check(const void *self)
{
    const int32_t number = ((const tiling_choice *)self)->number;

    return number >= 1 && number <= TILINGS + 3 ? NULL : "the number of a tiling must be between 1 and 27";
}

static const pattern_word words[] = { { NULL, PATTERN_INTEGER, offsetof(tiling_choice, number), false } };
static const tiling_choice usual = { .number = 1 };

const pattern_class pattern_tiling = {
    .keyword = "tiling",
    .self_size = sizeof(tiling_choice),
    .self = &usual,
    .words = words,
    .word_count = sizeof words / sizeof words[0],
    .check = check,
    .evaluate = evaluate,
};
