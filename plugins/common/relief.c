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
        memset(at[i].low, 0xff, sizeof at[i].low);
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
            to->low[part] = lesser(lesser(a[0], a[1]), lesser(b[0], b[1]));
            to->high[part] = most;
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
                to->low[part] = lesser(to->low[part], from->low[i]);
                to->high[part] = greater(to->high[part], from->high[i]);
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

/* What a place may be off in floats, in units of the square: coordinates are below one or so, and are rounded a dozen times. */
#define MARGIN 0x1p-20

/* The ray comes to a plane at `plane` cells, or 1/65536, behind `enter`, and leaves it behind `leave`: rounded outward. */
typedef struct axis { float step, enter, leave; bool back; } axis;

typedef struct search {
    axis x, y, z;
    float to;
    uint32_t turned;             /* parts in the ray's order are these parts of the square, by exclusive or */
} search;

/* A ray that does not move along an axis as good as never reaches a plane across it. */
static axis axis_of(double o, double d, double size, double margin)
{
    const double inverse = fabs(d) > 0x1p-60 ? 1.0 / d : d < 0.0 ? -0x1p60 : 0x1p60, beside = d < 0.0 ? -margin : margin;
    const axis a = { (float)(size * inverse), (float)((o + beside) * inverse), (float)((o - beside) * inverse), d < 0.0 };

    return a;
}

/* By part: where the ray comes to it, and leaves it. */
typedef struct stretches { float from[PARTS], to[PARTS]; } stretches;

/* The parts, of so many cells each, of a square that begins at x and z. */
COMMON_CLONES static uint32_t reach(const search *restrict s, const square *restrict of, float x, float z, float cells,
                                    stretches *restrict out)
{
    static const float column[PARTS] = { 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3 };
    static const float row[PARTS] = { 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3 };
    const uint16_t *first = s->y.back ? of->high : of->low, *last = s->y.back ? of->low : of->high;
    const float by_x = cells * s->x.step, by_z = cells * s->z.step, rise = s->y.step, enter = s->y.enter, leave = s->y.leave, to = s->to;
    const float near_x = (s->x.back ? x + cells : x) * s->x.step - s->x.enter, far_x = (s->x.back ? x : x + cells) * s->x.step - s->x.leave;
    const float near_z = (s->z.back ? z + cells : z) * s->z.step - s->z.enter, far_z = (s->z.back ? z : z + cells) * s->z.step - s->z.leave;
    int32_t hit[PARTS];

    for (int i = 0; i < PARTS; i++) {
        const float beside_x = column[i] * by_x, beside_z = row[i] * by_z;
        const float from = common_float_greater(common_float_greater(near_x + beside_x, near_z + beside_z), common_float_greater((float)first[i] * rise - enter, 0.0f));
        const float end = common_float_lesser(common_float_lesser(far_x + beside_x, far_z + beside_z), common_float_lesser((float)last[i] * rise - leave, to));

        out->from[i] = from;
        out->to[i] = end;
        hit[i] = -(from <= end);
    }
    return common_gather_lanes(hit) | common_gather_lanes(hit + PARTS / 2) << PARTS / 2;
}

/* Bits of parts in the order in which the ray comes to them: from the far end along an axis if it goes back. */
static inline uint32_t turn(uint32_t bits, uint32_t turned)
{
    if (turned & 3) {
        bits = (bits & 0x5555) << 1 | (bits >> 1 & 0x5555);
        bits = (bits & 0x3333) << 2 | (bits >> 2 & 0x3333);
    }
    if (turned & 12) {
        bits = (bits & 0x0f0f) << 4 | (bits >> 4 & 0x0f0f);
        bits = (bits & 0x00ff) << 8 | bits >> 8;
    }
    return bits;
}

/* A square on the way down, and its parts that are still to be looked at. */
typedef struct level { uint32_t x, z, left; stretches of; } level;

static inline void begin(const common_relief *r, const search *s, uint32_t n, level *at, uint32_t x, uint32_t z)
{
    const common_relief_level *l = &r->level[n];
    const uint32_t hit = reach(s, &l->at[(size_t)z * l->wide + x], (float)(x << 2 * (n + 1)), (float)(z << 2 * (n + 1)), (float)(1u << 2 * n), &at->of);

    at->x = x * SIDE;
    at->z = z * SIDE;
    at->left = turn(hit, s->turned);
}

static float float_above(double t) { return t < 0x1p60 ? (float)(t + MARGIN + 0x1p-22 * fabs(t)) : 0x1p60f; }

void common_relief_search(const common_relief *r, pov_vec3 o, pov_vec3 d, double to, common_relief_visit *visit, void *user)
{
    const double margin = MARGIN * (1.0 + pov_largest(o));
    search s = { axis_of(o.x, d.x, 1.0 / (r->wide - 1.0), margin), axis_of(o.y, d.y, 0x1p-16, margin),
                 axis_of(o.z, d.z, 1.0 / (r->deep - 1.0), margin), float_above(to), 0 };
    level stack[COMMON_RELIEF_LEVELS];
    uint32_t n = r->levels - 1;

    s.turned = (s.x.back ? 3 : 0) | (s.z.back ? 12 : 0);
    begin(r, &s, n, &stack[n], 0, 0);
    for (;;) {
        level *l = &stack[n];
        uint32_t part, x, z;

        if (!l->left) {
            if (++n == r->levels)
                return;
            continue;
        }
        part = common_first_lane(l->left) ^ s.turned;
        l->left &= l->left - 1;
        if (l->of.from[part] > s.to)
            continue;
        x = l->x + part % SIDE;
        z = l->z + part / SIDE;
        if (n > 0) {
            n--;
            begin(r, &s, n, &stack[n], x, z);
        } else {
            const common_span stretch = { l->of.from[part], l->of.to[part] };
            const double before = to;

            if (!visit(user, x, z, stretch, &to))
                return;
            if (to < before)
                s.to = float_above(to);
        }
    }
}
