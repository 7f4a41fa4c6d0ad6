#include "model/map_table.h"

#include "base/hash.h"
#include "base/vec.h"

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

/* NULL: no memory. */
static const linear_map *add_linear(map_table *t, const env *e, const linear_map *map)
{
    const records r = linear_of(t);
    uint32_t *slot = slot_for(&r, e, map);

    if (!slot)
        return NULL;
    if (!*slot) {
        if (!push_linear(t, e, map))
            return NULL;
        *slot = (uint32_t)t->linear_count;
    }
    return t->linear[*slot - 1];
}

uint32_t map_table_add(map_table *t, const env *e, const pov_affine *map)
{
    const records r = items_of(t);
    linear_map linear;
    inverse_map one;
    uint32_t *slot;

    fill(&linear, &one, map);
    one.linear = add_linear(t, e, &linear);
    slot = one.linear ? slot_for(&r, e, &one) : NULL;
    if (!slot)
        return 0;
    if (!*slot) {
        if (!VEC_PUSH(e, t, one))
            return 0;
        *slot = (uint32_t)t->count;
    }
    return *slot;
}

void map_table_free(map_table *t, const env *e)
{
    for (size_t i = 0; i < t->linear_count; i++)
        env_free(e, t->linear[i]);
    env_free(e, t->linear);
    env_free(e, t->items);
    env_free(e, t->slots.at);
    env_free(e, t->linear_slots.at);
    memset(t, 0, sizeof *t);
}
