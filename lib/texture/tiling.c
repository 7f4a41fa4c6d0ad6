#include "texture/tiling.h"

#include "texture/pattern.h"
#include "texture/penrose.h"

/* Tiles of several kinds: the value is kind + 1 at their borders and falls towards kind inside, by the number of kinds. */
typedef struct tiling_choice { int32_t number; } tiling_choice;

#define COS15 0.96592582628906828675
#define SIN15 0.25881904510252076235
#define COS30 0.86602540378443864676
#define COS45 0.70710678118654752440

static const double cosines[TILING_DIRECTIONS] = { 1.0, COS15, COS30, COS45, 0.5, SIN15, 0.0, -SIN15, -0.5, -COS45, -COS30, -COS15,
                                                   -1.0, -COS15, -COS30, -COS45, -0.5, -SIN15, 0.0, SIN15, 0.5, COS45, COS30, COS15 };

/* How far a point, from the middle of a tile, is within a side. */
SIMD_INLINE double depth_behind(const tiling_outline *o, uint32_t side, double x, double z)
{
    const uint32_t d = o->direction[side], quarter = TILING_DIRECTIONS / 4;
    const double rest = o->distance[side % o->distances] - (x * cosines[d] + z * cosines[(d + 3 * quarter) % TILING_DIRECTIONS]);

    return o->gentle >> side & 1u ? rest * COS30 : rest;
}

/* Distance of a point, from the middle of a tile, to the side that it is nearest to; negative: outside. What is not above `least` does
 * not matter. */
static double depth_in(const tiling_outline *o, double x, double z, double least)
{
    double depth = HUGE_VAL;

    for (uint32_t i = 0; i < o->sides && depth > least; i++) {
        const double rest = depth_behind(o, i, x, z);

        depth = rest < depth ? rest : depth;
    }
    return depth;
}

/* Tiles do not overlap: a point that is this deep in one is in no other. */
static const double certain = 0x1p-20;

/* Which copy of a tile has its middle nearest, as the lattice counts. */
typedef struct copy_place { double u, v; } copy_place;

SIMD_INLINE copy_place nearest_copy(const tiling *t, double x, double z)
{
    const double area = t->across[0] * t->along[1] - t->across[1] * t->along[0];

    return (copy_place){ floor((x * t->along[1] - z * t->along[0]) / area + 0.5), floor((z * t->across[0] - x * t->across[1]) / area + 0.5) };
}

/* The same in those copies of a tile that are nearest. */
static double depth_in_copies(const tiling *t, const tiling_tile *tile, double x, double z, double least)
{
    const copy_place near = nearest_copy(t, x, z);
    double deepest = least;

    for (int i = -1; i <= 1 && deepest < certain; i++)
        for (int j = -1; j <= 1 && deepest < certain; j++) {
            const double u = near.u + i, v = near.v + j;
            const double depth = depth_in(&tiling_outlines[tile->outline], x - u * t->across[0] - v * t->along[0],
                                          z - u * t->across[1] - v * t->along[1], deepest);

            deepest = depth > deepest ? depth : deepest;
        }
    return deepest;
}

/* A side belongs to the tile behind it, along both axes, as in POV-Ray. */
static const double nudge = 1e-12;

static double value_of(const tiling *t, double deepest, uint32_t kind)
{
    const double border = 1.0 - deepest / t->inner;

    return (kind + (border > 0.0 ? border < 1.0 ? border : 1.0 : 0.0)) / t->kinds;
}

static double value_at(const tiling *t, double x_at, double z_at)
{
    const double x = x_at + nudge, z = z_at + nudge;
    double deepest = -HUGE_VAL;
    uint32_t kind = 0;

    for (uint32_t i = 0; i < t->count && deepest < certain; i++) {
        const double depth = depth_in_copies(t, &t->tiles[i], x - t->tiles[i].x, z - t->tiles[i].z, deepest);

        if (depth > deepest) {
            deepest = depth;
            kind = t->tiles[i].kind;
        }
    }
    return value_of(t, deepest, kind);
}

/* Depths in the nearest copies of a tile. */
SIMD_CLONES static void find_depths(const tiling *t, const tiling_tile *tile, const vec_lanes *restrict at, uint32_t n, double *restrict depth)
{
    const tiling_outline *o = &tiling_outlines[tile->outline];
    double x[LANES_MAX], z[LANES_MAX];

    for (uint32_t i = 0; i < n; i++) {
        const double from_x = at->x[i] + nudge - tile->x, from_z = at->z[i] + nudge - tile->z;
        const copy_place near = nearest_copy(t, from_x, from_z);

        x[i] = from_x - near.u * t->across[0] - near.v * t->along[0];
        z[i] = from_z - near.u * t->across[1] - near.v * t->along[1];
        depth[i] = HUGE_VAL;
    }
    for (uint32_t side = 0; side < o->sides; side++)
        for (uint32_t i = 0; i < n; i++) {
            const double rest = depth_behind(o, side, x[i], z[i]);

            depth[i] = rest < depth[i] ? rest : depth[i];
        }
}

/* Most points lie deep in the nearest copy of a tile; the others ask all copies. */
static void find_values(const tiling *t, const vec_lanes *at, uint32_t n, double *value)
{
    uint64_t open = n < 64 ? ((uint64_t)1 << n) - 1 : ~(uint64_t)0;
    double depth[LANES_MAX];

    for (uint32_t k = 0; k < t->count && open; k++) {
        find_depths(t, &t->tiles[k], at, lanes_whole(n), depth);
        for (uint64_t rest = open; rest; rest &= rest - 1) {
            const uint32_t i = first_of64(rest);

            if (depth[i] >= certain) {
                value[i] = value_of(t, depth[i], t->tiles[k].kind);
                open &= ~((uint64_t)1 << i);
            }
        }
    }
    for (; open; open &= open - 1)
        value[first_of64(open)] = value_at(t, at->x[first_of64(open)], at->z[first_of64(open)]);
}

static double penrose(int32_t number, double x, double z)
{
    switch (number) {
    case 25: return penrose_pentagons(x, z);
    case 26: return penrose_kites(x, z);
    default: return penrose_rhombi(x, z);
    }
}

static void evaluate(const pattern_input *in, double *value)
{
    const tiling_choice *c = in->of->self;

    if (c->number <= TILINGS)
        find_values(&tiling_table[c->number - 1], in->at, in->n, value);
    for (uint32_t i = 0; c->number > TILINGS && i < in->n; i++)
        value[i] = penrose(c->number, in->at->x[i], in->at->z[i]);
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
