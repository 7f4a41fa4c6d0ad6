#include "texture/tiling.h"

#include "texture/pattern.h"

/* Tiles of several kinds: the value is kind + 1 at their borders and falls towards kind inside, by the number of kinds.
 * pavement has tiles of one kind. */
typedef struct tiling_choice { int32_t number, sides, tiles, pattern, interior, exterior, form; } tiling_choice;

static const double cos15 = 0.96592582628906828675, sin15 = 0.25881904510252076235;
static const double cos30 = 0.86602540378443864676, cos45 = 0.70710678118654752440;

/* Distance of a point, from the middle of a tile, to the side that it is nearest to; negative: outside. */
static double depth_in(const tiling_outline *o, double x, double z)
{
    const double cosines[] = { 1.0, cos15, cos30, cos45, 0.5, sin15, 0.0, -sin15, -0.5, -cos45, -cos30, -cos15,
                               -1.0, -cos15, -cos30, -cos45, -0.5, -sin15, 0.0, sin15, 0.5, cos45, cos30, cos15 };
    double depth = HUGE_VAL;

    for (uint32_t i = 0; i < o->sides; i++) {
        const uint32_t d = o->direction[i], quarter = TILING_DIRECTIONS / 4;
        const double rest = o->distance[i % o->distances] - (x * cosines[d] + z * cosines[(d + 3 * quarter) % TILING_DIRECTIONS]);

        depth = rest < depth ? rest : depth;
    }
    return depth;
}

/* The same in those copies of a tile that are nearest. */
static double depth_in_copies(const tiling *t, const tiling_tile *tile, double x, double z)
{
    const double area = t->across[0] * t->along[1] - t->across[1] * t->along[0];
    const double u = floor((x * t->along[1] - z * t->along[0]) / area + 0.5);
    const double v = floor((z * t->across[0] - x * t->across[1]) / area + 0.5);
    double deepest = -HUGE_VAL;

    for (int i = -1; i <= 1; i++)
        for (int j = -1; j <= 1; j++) {
            const double depth = depth_in(&tiling_outlines[tile->outline], x - (u + i) * t->across[0] - (v + j) * t->along[0],
                                          z - (u + i) * t->across[1] - (v + j) * t->along[1]);

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

    for (uint32_t i = 0; i < t->count; i++) {
        const double depth = depth_in_copies(t, &t->tiles[i], x - t->tiles[i].x, z - t->tiles[i].z);

        if (depth > deepest) {
            deepest = depth;
            kind = t->tiles[i].kind;
        }
    }
    border = 1.0 - deepest / t->inner;
    return (kind + (border > 0.0 ? border < 1.0 ? border : 1.0 : 0.0)) / t->kinds;
}

static void evaluate(const pattern_input *in, double *value)
{
    const tiling_choice *c = in->of->self;

    for (uint32_t i = 0; i < in->n; i++)
        value[i] = value_at(&tiling_table[c->number - 1], in->at->x[i], in->at->z[i]);
}

static const char *check_tiling(const void *self)
{
    const int32_t number = ((const tiling_choice *)self)->number;

    if (number < 1 || number > 27)
        return "the number of a tiling must be between 1 and 27";
    return number <= TILINGS ? NULL : "tilings 25 to 27, which never repeat, are not supported yet";
}

/* ---- pavement ---- */

/* The triangles of tiling 3 without their kinds; squares; hexagons. */
static double paved(int32_t sides, double x, double z)
{
    const double value = value_at(&tiling_table[sides == 3 ? 2 : sides == 4 ? 0 : TILINGS], x, z);

    return sides != 3 ? value : value > 0.5 ? 2.0 * value - 1.0 : 2.0 * value;
}

static void evaluate_pavement(const pattern_input *in, double *value)
{
    const tiling_choice *c = in->of->self;

    for (uint32_t i = 0; i < in->n; i++)
        value[i] = paved(c->sides, in->at->x[i], in->at->z[i]);
}

static const char *check_pavement(const void *self)
{
    const tiling_choice *c = self;

    if (c->sides != 3 && c->sides != 4 && c->sides != 6)
        return "\"number_of_sides\" of pavement must be 3, 4 or 6";
    if (c->tiles < 1 || c->tiles > 6)
        return "\"number_of_tiles\" of pavement must be between 1 and 6";
    return c->tiles == 1 ? NULL : "pavements whose tiles have several cells are not supported yet";
}

static const pattern_word tiling_words[] = { { NULL, PATTERN_INTEGER, offsetof(tiling_choice, number), false } };
static const pattern_word pavement_words[] = {
    { "number_of_sides", PATTERN_INTEGER, offsetof(tiling_choice, sides), false },
    { "number_of_tiles", PATTERN_INTEGER, offsetof(tiling_choice, tiles), false },
    { "pattern", PATTERN_INTEGER, offsetof(tiling_choice, pattern), false },
    { "interior", PATTERN_INTEGER, offsetof(tiling_choice, interior), false },
    { "exterior", PATTERN_INTEGER, offsetof(tiling_choice, exterior), false },
    { "form", PATTERN_INTEGER, offsetof(tiling_choice, form), false },
};
static const tiling_choice usual = { .number = 1, .sides = 3, .tiles = 1, .pattern = 1 };

#define TILING_CLASS(name, own, checks, evaluates) \
    const pattern_class pattern_##name = { \
        .keyword = #name, \
        .self_size = sizeof(tiling_choice), \
        .self = &usual, \
        .words = own, \
        .word_count = sizeof own / sizeof own[0], \
        .check = checks, \
        .evaluate = evaluates, \
    }

TILING_CLASS(tiling, tiling_words, check_tiling, evaluate);
TILING_CLASS(pavement, pavement_words, check_pavement, evaluate_pavement);
