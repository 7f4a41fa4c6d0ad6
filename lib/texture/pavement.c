#include "texture/pavement.h"

#include "texture/pattern.h"

/* A cell is divided among its corners. Near each of them its value is a formula of a and b, the way along the two sides
 * that meet there: 1 at walls between tiles, and falling. Which formula it is depends on the walls around the corner, on
 * `exterior` where both sides are walls, on `interior` where the tile turns about the corner, and on `form`. */
typedef struct pavement {
    int32_t sides, tiles, pattern, interior, exterior, form;
} pavement;

static const double sqrt3 = 1.7320508075688772;

static double clamped(double v) { return v > 0.0 ? v < 1.0 ? v : 1.0 : 0.0; }
static double least(double a, double b) { return a < b ? a : b; }
static double most(double a, double b) { return a > b ? a : b; }

static bool wall(const paving *p, int64_t i, int64_t j, int side)
{
    const int64_t along = p->along, row = (j % along + along) % along;
    const int64_t across = p->across, column = ((i - (j - row) / along * p->shift) % across + across) % across;

    return (p->walls[row * across + column] - '0') >> side & 1;
}

static double nearest(double v) { return floor(v + 0.5); }

/* ---- squares ---- */

/* Walls that meet in a corner of cells, and belong to none of the tile's own sides there, or to all. */
static bool walls_meet(const paving *p, int64_t i, int64_t j)
{
    return wall(p, i, j - 1, 1) || wall(p, i - 1, j, 0) || wall(p, i - 1, j - 1, 1) || wall(p, i - 1, j - 1, 0);
}

/* The tile turns about a corner that the cell has opposite two walls: a band about that corner. */
static double square_turn(int32_t form, double a, double b)
{
    return clamped(fabs(form == 1 ? 2.0 * (a + b) - 1.0 : 2.0 * sqrt(a * a + b * b) - 1.0));
}

static double square_outer(int32_t exterior, double a, double b)
{
    const double from_x = 1.0 - 2.0 * a, from_z = 1.0 - 2.0 * b;

    return exterior == 1 ? clamped(from_x + from_z) : exterior == 2 ? clamped(sqrt(from_x * from_x + from_z * from_z))
                                                                    : most(from_x, from_z);
}

static double square_inner(int32_t inner, double a, double b)
{
    return clamped(1.0 - 2.0 * (inner == 1 ? a + b : inner == 2 ? sqrt(a * a + b * b) : most(a, b)));
}

static double paved_square(const pavement *c, const paving *p, double x, double z)
{
    const int64_t i = noise_whole(floor(x)), j = noise_whole(floor(z));
    const int32_t form = c->form % 4;
    const bool right = wall(p, i, j, 0), upper = wall(p, i, j, 1), left = wall(p, i - 1, j, 0), lower = wall(p, i, j - 1, 1);
    const double u = x - (double)i, v = z - (double)j, a = least(u, 1.0 - u), b = least(v, 1.0 - v);
    const bool turns = right != left && upper != lower && walls_meet(p, i + left, j + lower);
    const bool by_x = u < 0.5 ? left : right, by_z = v < 0.5 ? lower : upper;

    if (turns && (form == 1 || form == 2))
        return square_turn(form, left ? 1.0 - u : u, lower ? 1.0 - v : v);
    if (by_x && by_z)
        return square_outer(turns && form == 0 ? 0 : c->exterior, a, b);
    if (by_x || by_z)
        return 1.0 - 2.0 * (by_x ? a : b);
    return walls_meet(p, i + (u >= 0.5), j + (v >= 0.5)) ? square_inner(turns && form != 3 ? 0 : c->interior, a, b) : 0.0;
}

/* ---- triangles ---- */

/* Of the six sides that meet in the corner (i, j), that at 60 n degrees. */
static bool spoke(const paving *p, int64_t i, int64_t j, int n)
{
    switch (n % 6) {
    case 0: return wall(p, i, j, 2);
    case 1: return wall(p, i, j, 1);
    case 2: return wall(p, i - 1, j, 0);
    case 3: return wall(p, i - 1, j, 2);
    case 4: return wall(p, i, j - 1, 1);
    default: return wall(p, i, j - 1, 0);
    }
}

/* 60 degrees between two walls. */
static double triangle_outer(int32_t exterior, double a, double b)
{
    const double c = 1.0 / 3.0 - a, d = 1.0 / 3.0 - b, sharp = 1.0 - 3.0 * least(a, b);

    return exterior == 1 ? clamped(most(sharp, 2.0 - 3.0 * (a + b)))
         : exterior == 2 ? clamped(2.0 * sqrt3 * sqrt(c * c + c * d + d * d)) : sharp;
}

/* One wall, that of a. If `turns`, the next one is at 120 degrees. */
static double triangle_side(int32_t form, bool turns, double a, double b)
{
    const double rest = 1.0 - b;

    if (turns && form == 1)
        return clamped(2.0 - 2.0 * a - 4.0 * b);
    if (turns && form == 2)
        return clamped(2.0 * sqrt3 * sqrt(a * a - a * rest + rest * rest) - 2.0);
    return clamped(1.0 - 3.0 * b);
}

static double triangle_inner(int32_t inner, double a, double b)
{
    return clamped(1.0 - 3.0 * (inner == 1 ? most(a, b) + 0.5 * least(a, b)
                                : inner == 2 ? sqrt(a * a + a * b + b * b) : a + b));
}

static double paved_triangle(const pavement *c, const paving *p, double x, double z)
{
    const double along = z / (0.5 * sqrt3), across = x - 0.5 * along;
    const int64_t i = noise_whole(floor(across)), j = noise_whole(floor(along));
    const double u = across - (double)i, v = along - (double)j;
    const bool down = u + v >= 1.0;
    /* Shares of the corners, counterclockwise with x to the right and z up. */
    const double share[] = { down ? u + v - 1.0 : 1.0 - u - v, down ? 1.0 - u : u, down ? 1.0 - v : v };
    const int k = share[1] > share[0] ? share[2] > share[1] ? 2 : 1 : share[2] > share[0] ? 2 : 0;
    const double a = share[(k + 1) % 3], b = share[(k + 2) % 3];
    const int64_t ci = i + (down ? k != 1 : k == 1), cj = j + (down ? k != 2 : k == 2);
    const int first = (2 * k + (down ? 3 : 0)) % 6;      /* the side of a */
    const bool by_a = spoke(p, ci, cj, first), by_b = spoke(p, ci, cj, first + 1);

    if (by_a && by_b)
        return triangle_outer(c->exterior, a, b);
    if (by_a)
        return triangle_side(c->form % 3, spoke(p, ci, cj, first + 2), a, b);
    if (by_b)
        return triangle_side(c->form % 3, spoke(p, ci, cj, first + 5), b, a);
    for (int n = 2; n < 6; n++)
        if (spoke(p, ci, cj, first + n))
            return triangle_inner(c->interior, a, b);
    return 0.0;
}

/* ---- hexagons ---- */

static bool hexagon_wall(const paving *p, int64_t i, int64_t j, int side)
{
    switch (side) {
    case 0: case 1: case 2: return wall(p, i, j, side);
    case 3: return wall(p, i - 1, j, 0);
    case 4: return wall(p, i, j - 1, 1);
    default: return wall(p, i + 1, j - 1, 2);
    }
}

/* 120 degrees between two walls. */
static double hexagon_outer(int32_t form, double a, double b)
{
    const double c = 1.0 - a, d = 1.0 - b;

    return clamped(form == 1 ? 2.0 * (c + d) - 2.0 : form == 2 ? 2.0 * sqrt3 * sqrt(c * c - c * d + d * d) - 2.0
                                                               : 1.0 - 3.0 * least(a, b));
}

/* One wall, that of a: the tile turns about the corner, and the other side halves the angle. */
static double hexagon_inner(int32_t inner, double a, double b)
{
    if (b > a && inner == 1)
        return clamped(1.0 - 3.0 * most(b - 0.5 * a, 0.5 * (a + b)));
    if (b > a && inner == 2)
        return clamped(1.0 - 3.0 * sqrt(a * a - a * b + b * b));
    return clamped(1.0 - 3.0 * b);
}

/* The cell whose middle is nearest; x and z become the way from there. */
static void find_hexagon(double *x, double *z, int64_t *i, int64_t *j)
{
    const double column = nearest((*x - 1.0) / 1.5);
    double best = HUGE_VAL, best_x = 0.0, best_z = 0.0;

    for (int k = -1; k <= 1; k++) {
        const double row = nearest(*z / sqrt3 - 0.5 * (column + k));
        const double dx = *x - 1.0 - 1.5 * (column + k), dz = *z - sqrt3 * (row + 0.5 * (column + k));

        if (dx * dx + dz * dz < best) {
            best = dx * dx + dz * dz;
            best_x = dx;
            best_z = dz;
            *i = noise_whole(column + k);
            *j = noise_whole(row);
        }
    }
    *x = best_x;
    *z = best_z;
}

static double paved_hexagon(const pavement *c, const paving *p, double x, double z)
{
    static const double cosines[] = { 1.0, 0.5, -0.5, -1.0, -0.5, 0.5 }, sines[] = { 0.0, 0.5, 0.5, 0.0, -0.5, -0.5 };
    int64_t i = 0, j = 0;
    double sum, difference;
    int k = 0;
    bool by_a, by_b;

    find_hexagon(&x, &z, &i, &j);
    for (int n = 1; n < 6; n++)
        if ((cosines[n] - cosines[k]) * x + (sines[n] - sines[k]) * sqrt3 * z > 0.0)
            k = n;
    sum = 2.0 * (1.0 - cosines[k] * x - sines[k] * sqrt3 * z);
    difference = 2.0 / sqrt3 * (cosines[k] * z - sines[k] * sqrt3 * x);
    by_a = hexagon_wall(p, i, j, k);
    by_b = hexagon_wall(p, i, j, (k + 5) % 6);
    {
        const double a = 0.5 * (sum + difference), b = 0.5 * (sum - difference);

        return by_a && by_b ? hexagon_outer(c->form % 3, a, b) : by_a ? hexagon_inner(c->interior, a, b)
             : by_b ? hexagon_inner(c->interior, b, a) : 0.0;
    }
}

/* ---- the pattern ---- */

static const paving_set *set_of(int32_t sides)
{
    return sides == 3 ? &paving_triangles : sides == 4 ? &paving_squares : sides == 6 ? &paving_hexagons : NULL;
}

static void evaluate(const pattern_input *in, double *value)
{
    const pavement *c = in->of->self;
    const paving_set *set = set_of(c->sides);
    const paving *p = set->of + c->pattern - 1;

    for (int32_t t = 1; t < c->tiles; t++)
        p += set->patterns[t - 1];
    for (uint32_t i = 0; i < in->n; i++) {
        const double x = in->at->x[i], z = in->at->z[i];

        value[i] = c->sides == 3 ? paved_triangle(c, p, x, z) : c->sides == 4 ? paved_square(c, p, x, z)
                                                              : paved_hexagon(c, p, x, z);
    }
}

static const char *check(const void *self)
{
    const pavement *c = self;
    const paving_set *set = set_of(c->sides);

    if (!set)
        return "\"number_of_sides\" of pavement must be 3, 4 or 6";
    if (c->tiles < 1 || c->tiles > PAVING_CELLS || set->patterns[c->tiles - 1] == 0)
        return c->sides == 6 ? "\"number_of_tiles\" of pavement must be between 1 and 5 where sides are 6"
                             : "\"number_of_tiles\" of pavement must be between 1 and 6";
    return c->pattern >= 1 && c->pattern <= set->patterns[c->tiles - 1] ? NULL
         : "there is no \"pattern\" of this number with so many tiles in pavement";
}

static const pattern_word words[] = {
    { "number_of_sides", PATTERN_INTEGER, offsetof(pavement, sides), false },
    { "number_of_tiles", PATTERN_INTEGER, offsetof(pavement, tiles), false },
    { "pattern", PATTERN_INTEGER, offsetof(pavement, pattern), false },
    { "interior", PATTERN_INTEGER, offsetof(pavement, interior), false },
    { "exterior", PATTERN_INTEGER, offsetof(pavement, exterior), false },
    { "form", PATTERN_INTEGER, offsetof(pavement, form), false },
};
static const pavement usual = { .sides = 3, .tiles = 1, .pattern = 1 };

const pattern_class pattern_pavement = {
    .keyword = "pavement",
    .self_size = sizeof(pavement),
    .self = &usual,
    .words = words,
    .word_count = sizeof words / sizeof words[0],
    .check = check,
    .evaluate = evaluate,
};
