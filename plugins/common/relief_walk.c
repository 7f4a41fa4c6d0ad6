#include "common/relief_walk.h"

#include "common/simd.h"

enum { N = COMMON_WALK_LANES, SIDE = COMMON_RELIEF_SIDE, PARTS = COMMON_RELIEF_PARTS };

/* ---- making ---- */

static uint32_t range_of(const common_relief_level *l, uint32_t x, uint32_t z)
{
    const common_relief_square *s = &l->at[(size_t)(z / SIDE) * l->wide + x / SIDE];
    const uint32_t part = x % SIDE + SIDE * (z % SIDE);

    return s->height[part] | (uint32_t)s->height[PARTS + part] << 16;
}

static uint32_t parts_along(uint32_t cells, uint32_t level) { return (cells + (1u << 2 * level) - 1) >> 2 * level; }

/* Where a level begins: count (1 + 1/16 + ...), of which the fifteenth is exact by the inverse of 15. */
static inline uint32_t first_of(uint32_t count, uint32_t level) { return ((count - (count >> 4 * level)) * 0xeeeeeeefu) << 4; }

bool common_relief_ranges_make(common_relief_ranges *g, const common_relief *r, const pov_host *host, pov_reader *in)
{
    const uint32_t wide = r->wide - 1, deep = r->deep - 1, top = r->levels - 1;
    uint32_t *at;

    g->wide = (int32_t)wide;
    g->deep = (int32_t)deep;
    g->top = (int32_t)top;
    g->off = 0x1p-20f * (float)(wide > deep ? wide : deep);
    g->pitch = parts_along(wide, top) << 2 * top;
    if (wide > COMMON_WALK_MOST || deep > COMMON_WALK_MOST)
        return true;
    g->count = g->pitch * (parts_along(deep, top) << 2 * top);
    g->at = at = host->alloc(in, ((size_t)first_of(g->count, top) + (g->count >> 4 * top)) * sizeof *at);
    for (uint32_t n = 0; at && n < r->levels; n++)
        for (uint32_t z = 0; z < parts_along(deep, n); z++)
            for (uint32_t x = 0; x < parts_along(wide, n); x++)
                at[first_of(g->count, n) + z * (g->pitch >> 2 * n) + x] = range_of(&r->level[n], x, z);
    return g->at != NULL;
}

/* ---- rays ---- */

static inline float greater(float a, float b) { return a > b ? a : b; }
static inline float lesser(float a, float b) { return a < b ? a : b; }
static inline int32_t between(int32_t a, int32_t least, int32_t most) { return a < least ? least : a > most ? most : a; }
static inline float inverse_of(float d) { return fabsf(d) > 1e-18f ? 1.0f / d : d < 0.0f ? -1e18f : 1e18f; }

/* Rays that miss the box may be anywhere, or nowhere. */
static inline float held(float at, int32_t cells) { return lesser(greater(at, -1.0f), (float)(cells + 1)); }

/* How far it is from the next line between cells. */
static inline float beside_line(float at) { return fabsf(at - (float)(int32_t)(at + 0.5f)); }

/* Is a start so near a line that it may be beyond it? Not at the border, if it goes inward. */
COMMON_INLINE int32_t starts_at_line(float o, float d, int32_t cells, float off)
{
    const int32_t line = (int32_t)(o + 0.5f), near = fabsf(o - (float)line) < off ? -1 : 0;
    const int32_t enters = line <= 0 ? d > 0.0f ? -1 : 0 : line >= cells ? d < 0.0f ? -1 : 0 : 0;

    return near & ~enters;
}

COMMON_SEPARATE static void begin(const common_relief_ranges *restrict g, common_walk *restrict w)
{
    for (uint32_t i = 0; i < N; i++) {
        const float x = held(w->o[0][i], g->wide), z = held(w->o[2][i], g->deep);

        w->inverse[0][i] = inverse_of(w->d[0][i]);
        w->inverse[1][i] = inverse_of(w->d[2][i]);
        w->t[i] = w->behind[i] = 0.0f;
        w->x[i] = between((int32_t)x, 0, g->wide - 1);
        w->z[i] = between((int32_t)z, 0, g->deep - 1);
        w->level[i] = g->top > 0 ? g->top - 1 : 0;   /* the last one seldom leaves anything out */
        w->is_near[i] = w->past[i] = 0;
        w->unsure[i] = starts_at_line(x, w->d[0][i], g->wide, g->off) | starts_at_line(z, w->d[2][i], g->deep, g->off);
        w->goes[i] &= ~w->unsure[i];
    }
}

void common_walk_begin(const common_relief_ranges *g, common_walk *w) { begin(g, w); }

void common_walk_load(common_walk *w, uint32_t lane, const common_walk *from, uint32_t i)
{
    for (int k = 0; k < 3; k++) {
        w->o[k][lane] = from->o[k][i];
        w->d[k][lane] = from->d[k][i];
    }
    w->to[lane] = from->to[i];
    w->inverse[0][lane] = from->inverse[0][i];
    w->inverse[1][lane] = from->inverse[1][i];
    w->t[lane] = from->t[i];
    w->behind[lane] = from->behind[i];
    w->x[lane] = from->x[i];
    w->z[lane] = from->z[i];
    w->level[lane] = from->level[i];
    w->goes[lane] = from->goes[i];
    w->is_near[lane] = from->is_near[i];
    w->unsure[lane] = from->unsure[i];
    w->past[lane] = from->past[i];
}

static const int32_t bit_of[N] = { 1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768 };

/* Of each lane that goes on one step: down a level where it may hit the part that it is in, else to the next part. Those that go on then, as
 * bits. */
COMMON_SEPARATE static int32_t step(const common_relief_ranges *restrict g, const uint32_t *restrict at, common_walk *restrict w)
{
    const float off = g->off;
    int32_t some = 0;

    for (uint32_t i = 0; i < N; i++) {
        const int32_t x = w->x[i], z = w->z[i], level = w->level[i], goes = w->goes[i], past = w->past[i], shift = 2 * level;
        const int32_t part_x = x >> shift, part_z = z >> shift, last = (1 << shift) - 1;
        const uint32_t range = at[(int32_t)(first_of(g->count, (uint32_t)level) + (uint32_t)part_z * (g->pitch >> shift) + (uint32_t)part_x)];
        const float low = (float)(int32_t)(range & 0xffff), high = (float)(int32_t)(range >> 16);
        const float ox = w->o[0][i], oy = w->o[1][i], oz = w->o[2][i], dx = w->d[0][i], dy = w->d[1][i], dz = w->d[2][i];
        const float by_x = w->inverse[0][i], by_z = w->inverse[1][i], t = w->t[i], to = w->to[i];
        const int32_t right = by_x > 0.0f ? 1 : 0, up = by_z > 0.0f ? 1 : 0;
        const float end_x = ((float)((part_x + right) << shift) - ox) * by_x, end_z = ((float)((part_z + up) << shift) - oz) * by_z;
        const int32_t is_x = end_x < end_z ? -1 : 0;
        const float end = is_x ? end_x : end_z, inverse = fabsf(is_x ? by_x : by_z), reach = lesser(end, to), aside = is_x ? dz : dx;
        const float there = (is_x ? oz : ox) + reach * aside, ahead = off * inverse;
        const float from = oy + (t - w->behind[i]) * dy, until = oy + (reach + ahead) * dy;
        const int32_t is_low = lesser(from, until) - 1.0f <= high ? -1 : 0, may_hit = greater(from, until) + 1.0f >= low ? is_low & ~past : 0;
        const int32_t onward = goes & ~may_hit, ends = end > to ? onward : 0;
        const float near = off * greater(inverse * fabsf(aside), 1.0f);
        const int32_t corner = beside_line(there) < near ? onward & ~ends : 0;
        const int32_t along = is_x ? right : up, next = (((is_x ? part_x : part_z) + along) << shift) - 1 + along;
        const int32_t first = (is_x ? part_z : part_x) << shift, beside = between((int32_t)there, first, first + last);
        const int32_t next_x = is_x ? next : beside, next_z = is_x ? beside : next;
        const int32_t outside = (next_x | next_z | (g->wide - 1 - next_x) | (g->deep - 1 - next_z)) >> 31;
        const int32_t on = onward & ~ends & ~corner & ~outside, higher = ((next_x ^ x) | (next_z ^ z)) >> shift >> 2 != 0 ? on : 0;
        const int32_t stops = goes & may_hit & (level == 0 ? -1 : 0), deeper = goes & may_hit & ~stops;
        const int32_t changed = level - (higher & (level < g->top ? -1 : 0));

        w->x[i] = on ? next_x : x;
        w->z[i] = on ? next_z : z;
        w->t[i] = on ? end : t;
        w->behind[i] = on ? ahead : w->behind[i];
        w->level[i] = changed + deeper;
        w->past[i] = past & ~goes;
        w->unsure[i] |= corner;
        w->is_near[i] = goes ? stops : w->is_near[i];
        w->goes[i] = on | deeper;
        some |= bit_of[i] & (on | deeper);
    }
    return some;
}

uint32_t common_walk_on(const common_relief_ranges *g, common_walk *w, uint32_t most)
{
    uint32_t some;

    do
        some = (uint32_t)step(g, g->at, w);
    while (common_count(some) > most);
    return some;
}
