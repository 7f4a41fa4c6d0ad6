#include "model/map_table.h"

#include "base/hash.h"
#include "base/vec.h"

#include <math.h>
#include <string.h>

/* ---- records in hash tables ---- */

/* Where the records of one kind are. */
typedef struct records {
    const map_table *table;
    map_slots *slots;
    size_t count, bytes;
    const void *(*at)(const map_table *t, size_t i);
} records;

static const void *item_at(const map_table *t, size_t i) { return &t->items[i]; }
static const void *linear_at(const map_table *t, size_t i) { return t->linear[i]; }

static records items_of(map_table *t)
{
    return (records){ t, &t->slots, t->count, sizeof *t->items, item_at };
}

static records linear_of(map_table *t)
{
    return (records){ t, &t->linear_slots, t->linear_count, sizeof **t->linear, linear_at };
}

/* Slot that holds the record, or the empty slot for it. */
static uint32_t *slot_of(const records *r, const void *record)
{
    const map_slots *s = r->slots;
    size_t i = (size_t)hash_bytes(0, record, r->bytes) & (s->count - 1);

    while (s->at[i] && memcmp(r->at(r->table, s->at[i] - 1), record, r->bytes) != 0)
        i = (i + 1) & (s->count - 1);
    return &s->at[i];
}

/* NULL: no memory for one more record. */
static uint32_t *slot_for(const records *r, const env *e, const void *record)
{
    map_slots *s = r->slots, larger = { NULL, s->count ? 2 * s->count : 64 };

    if (2 * (r->count + 1) > s->count) {
        larger.at = env_alloc(e, larger.count, sizeof *larger.at);
        if (!larger.at)
            return NULL;
        env_free(e, s->at);
        *s = larger;
        for (size_t i = 0; i < r->count; i++)
            *slot_of(r, r->at(r->table, i)) = (uint32_t)(i + 1);
    }
    return slot_of(r, record);
}

/* ---- maps ---- */

/* -0 and 0 are the same entry. */
static void fill(linear_map *linear, inverse_map *out, const pov_affine *map)
{
    memset(out, 0, sizeof *out);
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++) {
            linear->m[r][c] = map->inv[r][c] + 0.0;
            linear->m_lo[r][c] = map->inv_lo[r][c] + 0.0;
        }
        out->move[r] = map->inv[r][3] + 0.0;
        out->move_lo[r] = map->inv_lo[r][3] + 0.0;
    }
}

static bool push_linear(map_table *t, const env *e, const linear_map *map)
{
    linear_map *kept;

    if (!vec_reserve(e, (void **)&t->linear, &t->linear_capacity, t->linear_count, sizeof *t->linear))
        return false;
    kept = env_alloc(e, 1, sizeof *kept);
    if (!kept)
        return false;
    *kept = *map;
    t->linear[t->linear_count++] = kept;
    return true;
}

/* Its number, from 1 on; 0: no memory. */
static uint32_t add_linear(map_table *t, const env *e, const linear_map *map)
{
    const records r = linear_of(t);
    uint32_t *slot = slot_for(&r, e, map);

    if (!slot)
        return 0;
    if (!*slot) {
        if (!push_linear(t, e, map))
            return 0;
        *slot = (uint32_t)t->linear_count;
    }
    return *slot;
}

static uint32_t add_whole(map_table *t, const env *e, const inverse_map *one)
{
    const records r = items_of(t);
    uint32_t *slot = slot_for(&r, e, one);

    if (!slot)
        return 0;
    if (!*slot) {
        if (!VEC_PUSH(e, t, *one))
            return 0;
        *slot = (uint32_t)t->count;
    }
    return *slot;
}

uint32_t map_table_add(map_table *t, const env *e, const pov_affine *map)
{
    inverse_map one;
    linear_map linear;
    uint32_t number;

    fill(&linear, &one, map);
    number = add_linear(t, e, &linear);
    if (number == 0)
        return 0;
    one.linear = t->linear[number - 1];
    return add_whole(t, e, &one);
}

/* ---- maps of objects ---- */

/* Which records a number counts; neither bit: whole maps. */
#define NUMBER_SHORT 0x80000000u
#define NUMBER_MOVED 0x40000000u

/* Words of a short map: an integer of 28 bits, a two's complement, below 4 bits: of the first word the index of what
 * divides the integers, of the others the linear part's number. */
enum { INTEGER_BITS = 28, INTEGER_END = 1 << (INTEGER_BITS - 1), LINEAR_END = 1 << 8 };

/* Moves are written in decimals mostly: quotients of integers that a double holds exactly are the doubles that are written so. */
static const double divisors[] = { 1, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 16, 256, 4096, 65536, 0x1p20, 0x1p24 };

static bool as_integers(const double *move, double divisor, int32_t *n)
{
    for (int i = 0; i < 3; i++) {
        const double whole = nearbyint(move[i] * divisor);

        if (!(fabs(whole) < INTEGER_END) || whole / divisor != move[i])
            return false;
        n[i] = (int32_t)whole;
    }
    return true;
}

static bool shorten(const double *move, uint32_t linear, short_map *out)
{
    const uint32_t above[3] = { 0, linear & 15, linear >> 4 };
    int32_t n[3];

    for (uint32_t k = 0; linear < LINEAR_END && k < sizeof divisors / sizeof divisors[0]; k++) {
        if (!as_integers(move, divisors[k], n))
            continue;
        for (int i = 0; i < 3; i++)
            out->word[i] = ((uint32_t)n[i] & (2u * INTEGER_END - 1)) | (i == 0 ? k : above[i]) << INTEGER_BITS;
        return true;
    }
    return false;
}

static void read_short(const map_table *t, const short_map *s, inverse_map *out)
{
    const double divisor = divisors[s->word[0] >> INTEGER_BITS];

    out->linear = t->linear[(s->word[1] >> INTEGER_BITS | s->word[2] >> INTEGER_BITS << 4) - 1];
    for (int i = 0; i < 3; i++) {
        const int32_t n = (int32_t)(s->word[i] & (2u * INTEGER_END - 1));

        out->move[i] = (n < INTEGER_END ? n : n - 2 * INTEGER_END) / divisor;
        out->move_lo[i] = 0.0;
    }
}

static uint32_t add_short(map_table *t, const env *e, const short_map *s)
{
    const short_maps *l = &t->brief;
    const bool same = l->count > 0 && memcmp(&l->items[l->count - 1], s, sizeof *s) == 0;

    if (!same && (l->count + 1 >= NUMBER_MOVED || !VEC_PUSH(e, &t->brief, *s)))
        return 0;
    return (uint32_t)t->brief.count | NUMBER_SHORT;
}

static void read_moved(const map_table *t, const moved_map *s, inverse_map *out)
{
    memset(out, 0, sizeof *out);
    out->linear = t->linear[s->word[0] - 1];
    memcpy(out->move, &s->word[1], sizeof out->move);
}

static uint32_t add_moved(map_table *t, const env *e, const double *move, uint32_t linear)
{
    const moved_maps *l = &t->moved;
    moved_map s;
    bool same;

    s.word[0] = linear;
    memcpy(&s.word[1], move, 3 * sizeof *move);
    same = l->count > 0 && memcmp(&l->items[l->count - 1], &s, sizeof s) == 0;
    if (!same && (l->count + 1 >= NUMBER_MOVED || !VEC_PUSH(e, &t->moved, s)))
        return 0;
    return (uint32_t)t->moved.count | NUMBER_MOVED;
}

uint32_t map_table_add_own(map_table *t, const env *e, const pov_affine *map)
{
    inverse_map one;
    linear_map linear;
    uint32_t number;
    short_map brief;

    fill(&linear, &one, map);
    number = add_linear(t, e, &linear);
    if (number == 0)
        return 0;
    one.linear = t->linear[number - 1];
    if (one.move_lo[0] != 0.0 || one.move_lo[1] != 0.0 || one.move_lo[2] != 0.0)
        return add_whole(t, e, &one);
    return shorten(one.move, number, &brief) ? add_short(t, e, &brief) : add_moved(t, e, one.move, number);
}

const inverse_map *map_table_read(const map_table *t, uint32_t number, inverse_map *space)
{
    const uint32_t index = (number & (NUMBER_MOVED - 1)) - 1;

    if (!(number & (NUMBER_SHORT | NUMBER_MOVED)))
        return map_table_at(t, number);
    if (number & NUMBER_SHORT)
        read_short(t, &t->brief.items[index], space);
    else
        read_moved(t, &t->moved.items[index], space);
    return space;
}

void map_table_free(map_table *t, const env *e)
{
    for (size_t i = 0; i < t->linear_count; i++)
        env_free(e, t->linear[i]);
    env_free(e, t->linear);
    env_free(e, t->items);
    env_free(e, t->moved.items);
    env_free(e, t->brief.items);
    env_free(e, t->slots.at);
    env_free(e, t->linear_slots.at);
    memset(t, 0, sizeof *t);
}
