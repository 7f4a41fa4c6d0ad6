#include "common/relief.h"

#include "common/floats.h"

enum { SIDE = COMMON_RELIEF_SIDE, PARTS = COMMON_RELIEF_PARTS, ALL = (1 << PARTS) - 1 };

typedef common_relief_square square;

/* ---- making ---- */

static square *make_room(common_relief_level *l, uint32_t wide, uint32_t deep, const pov_host *host, pov_reader *in)
{
    const uint32_t across = (wide + SIDE - 1) / SIDE, along = (deep + SIDE - 1) / SIDE;
    square *at = host->alloc(in, (size_t)across * along * sizeof *at);

    for (size_t i = 0; at && i < (size_t)across * along; i++)
        for (int k = 0; k < PARTS; k++)
            at[i].height[k] = UINT16_MAX;
    l->wide = across;
    l->deep = along;
    l->at = at;
    return at;
}

/* The part of a square that the part x, z of its level is in. */
static square *square_of(square *at, const common_relief_level *l, uint32_t x, uint32_t z, uint32_t *part)
{
    *part = x % SIDE + SIDE * (z % SIDE);
    return &at[(size_t)(z / SIDE) * l->wide + x / SIDE];
}

static uint16_t lesser(uint16_t a, uint16_t b) { return a < b ? a : b; }
static uint16_t greater(uint16_t a, uint16_t b) { return a > b ? a : b; }

static bool make_cells(common_relief *r, const pov_host *host, pov_reader *in, const uint16_t *height, double water)
{
    square *at = make_room(&r->level[0], r->wide - 1, r->deep - 1, host, in), *to;
    uint32_t part;

    for (uint32_t z = 0; at && z + 1 < r->deep; z++)
        for (uint32_t x = 0; x + 1 < r->wide; x++) {
            const uint16_t *a = height + (size_t)z * r->wide + x, *b = a + r->wide;
            const uint16_t most = greater(greater(a[0], a[1]), greater(b[0], b[1]));

            if (most < water)
                continue;
            to = square_of(at, &r->level[0], x, z, &part);
            to->height[part] = lesser(lesser(a[0], a[1]), lesser(b[0], b[1]));
            to->height[PARTS + part] = most;
        }
    return at;
}

static bool make_level(common_relief *r, uint32_t n, const pov_host *host, pov_reader *in)
{
    const common_relief_level *below = &r->level[n - 1];
    square *at = make_room(&r->level[n], below->wide, below->deep, host, in), *to;
    uint32_t part;

    for (uint32_t z = 0; at && z < below->deep; z++)
        for (uint32_t x = 0; x < below->wide; x++) {
            const square *from = &below->at[(size_t)z * below->wide + x];

            to = square_of(at, &r->level[n], x, z, &part);
            for (int i = 0; i < PARTS; i++) {
                to->height[part] = lesser(to->height[part], from->height[i]);
                to->height[PARTS + part] = greater(to->height[PARTS + part], from->height[PARTS + i]);
            }
        }
    return at;
}

bool common_relief_make(common_relief *r, const pov_host *host, pov_reader *in, const uint16_t *height, uint32_t wide, uint32_t deep,
                        double water)
{
    uint32_t n = 0;

    r->wide = wide;
    r->deep = deep;
    r->cell_wide = 1.0 / (wide - 1.0);
    r->cell_deep = 1.0 / (deep - 1.0);
    r->levels = 0;
    if (!make_cells(r, host, in, height, water))
        return false;
    while (r->level[n].wide > 1 || r->level[n].deep > 1)
        if (!make_level(r, ++n, host, in))
            return false;
    r->levels = n + 1;
    return true;
}

/* ---- a ray ---- */

/* What a place may be off in floats, in units of the unit square: coordinates are below four, and are rounded some ten times. */
#define MARGIN 0x1p-18

/* Along x or z: where the ray comes to the last level's square, how long it takes for a cell, and how much longer for what a
 * place may be off. A ray that does not move along an axis as good as takes for ever. */
typedef struct axis { float near, step, longer; bool back; } axis;

typedef struct search {
    axis x, z;
    float rise, enter, leave;    /* it comes to a height, in 1/65536, at rise height - enter, and is certainly past it at rise height - leave */
    float to;
    uint32_t first;              /* where in a square the heights are that it comes to first */
    uint32_t turned;             /* parts in the ray's order are these parts of the square, by exclusive or */
} search;

static double inverse_of(double d) { return fabs(d) > 0x1p-60 ? 1.0 / d : d < 0.0 ? -0x1p60 : 0x1p60; }

static axis axis_of(double o, double d, double size, double whole, double margin)
{
    const double inverse = fabs(inverse_of(d)), before = d < 0.0 ? whole - o : o;
    const axis a = { (float)(-(before + margin) * inverse), (float)(size * inverse), (float)(2.0 * margin * inverse), d < 0.0 };

    return a;
}

/* A square on the way down: where the ray comes to it along x and z, and its parts that are still to be looked at, in the ray's
 * order. */
typedef struct level { uint32_t x, z, left; float near_x, near_z; } level;

static const float part_columns[2][PARTS] = { { 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3 }, { 3, 2, 1, 0, 3, 2, 1, 0, 3, 2, 1, 0, 3, 2, 1, 0 } };
static const float part_rows[2][PARTS] = { { 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3 }, { 3, 3, 3, 3, 2, 2, 2, 2, 1, 1, 1, 1, 0, 0, 0, 0 } };

/* The parts of a square, of so many cells each, that the ray may hit. */
COMMON_CLONES static uint32_t reach(const search *restrict s, const square *restrict of, float near_x, float near_z, float cells)
{
    const float *column = part_columns[s->x.back], *row = part_rows[s->z.back];
    const uint16_t *first = of->height + s->first, *last = of->height + (PARTS - s->first);
    const float by_x = cells * s->x.step, by_z = cells * s->z.step, long_x = by_x + s->x.longer, long_z = by_z + s->z.longer;
    const float rise = s->rise, enter = s->enter, leave = s->leave, to = s->to;
    int32_t hit[PARTS];

    for (int i = 0; i < PARTS; i++) {
        const float x = near_x + column[i] * by_x, z = near_z + row[i] * by_z;
        const float from = common_float_greater(common_float_greater(x, z), common_float_greater((float)first[i] * rise - enter, 0.0f));
        const float end = common_float_lesser(common_float_lesser(x + long_x, z + long_z), common_float_lesser((float)last[i] * rise - leave, to));

        hit[i] = -(from <= end);
    }
    return common_gather_lanes(hit) | common_gather_lanes(hit + PARTS / 2) << PARTS / 2;
}

/* Bits of parts in the order in which the ray comes to them: from the far end along an axis if it goes back. */
static inline uint32_t turn(uint32_t bits, const search *s)
{
    if (s->x.back) {
        bits = (bits & 0x5555) << 1 | (bits >> 1 & 0x5555);
        bits = (bits & 0x3333) << 2 | (bits >> 2 & 0x3333);
    }
    if (s->z.back) {
        bits = (bits & 0x0f0f) << 4 | (bits >> 4 & 0x0f0f);
        bits = (bits & 0x00ff) << 8 | bits >> 8;
    }
    return bits;
}

static inline level begin(const common_relief *r, const search *s, uint32_t n, uint32_t x, uint32_t z, float near_x, float near_z)
{
    static const float cells[COMMON_RELIEF_LEVELS] = { 0x1p0f, 0x1p2f, 0x1p4f, 0x1p6f, 0x1p8f, 0x1p10f, 0x1p12f, 0x1p14f };
    const common_relief_level *l = &r->level[n];
    const level at = { x * SIDE, z * SIDE, turn(reach(s, &l->at[(size_t)z * l->wide + x], near_x, near_z, cells[n]), s), near_x, near_z };

    return at;
}

static float float_above(double t) { return t < 0x1p60 ? (float)(t + MARGIN + 0x1p-22 * fabs(t)) : 0x1p60f; }

static search search_of(const common_relief *r, pov_vec3 o, pov_vec3 d, double to)
{
    const double margin = MARGIN * (1.0 + pov_largest(o)), inverse = inverse_of(d.y), beside = d.y < 0.0 ? -margin : margin;
    const double whole = (double)(1u << 2 * r->levels);
    search s;

    s.x = axis_of(o.x, d.x, r->cell_wide, r->cell_wide * whole, margin);
    s.z = axis_of(o.z, d.z, r->cell_deep, r->cell_deep * whole, margin);
    s.rise = (float)(0x1p-16 * inverse);
    s.enter = (float)((o.y + beside) * inverse);
    s.leave = (float)((o.y - beside) * inverse);
    s.to = float_above(to);
    s.first = d.y < 0.0 ? PARTS : 0;
    s.turned = (s.x.back ? 3 : 0) | (s.z.back ? 12 : 0);
    return s;
}

void common_relief_search(const common_relief *r, pov_vec3 o, pov_vec3 d, double to, common_relief_visit *visit, void *user)
{
    const search s = search_of(r, o, d, to);
    level stack[COMMON_RELIEF_LEVELS];
    float by_x = s.x.step * (float)(1u << 2 * (r->levels - 1)), by_z = s.z.step * (float)(1u << 2 * (r->levels - 1));
    uint32_t n = r->levels - 1;

    stack[n] = begin(r, &s, n, 0, 0, s.x.near, s.z.near);
    while (n < r->levels) {
        level *l = &stack[n];
        uint32_t which, part, x, z;

        if (!l->left) {
            n++;
            by_x *= SIDE;
            by_z *= SIDE;
            continue;
        }
        which = common_first_lane(l->left);
        part = which ^ s.turned;
        l->left &= l->left - 1;
        x = l->x + part % SIDE;
        z = l->z + part / SIDE;
        if (n > 0) {
            n--;
            stack[n] = begin(r, &s, n, x, z, l->near_x + part_columns[0][which] * by_x, l->near_z + part_rows[0][which] * by_z);
            by_x *= 1.0f / SIDE;
            by_z *= 1.0f / SIDE;
        } else if (!visit(user, x, z)) {
            return;
        }
    }
}
