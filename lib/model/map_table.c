#include "model/map_table.h"

#include "base/hash.h"
#include "base/vec.h"

#include <string.h>

/* -0 and 0 are the same entry. */
static void fill(inverse_map *out, const pov_affine *map)
{
    memset(out, 0, sizeof *out);
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 4; c++) {
            out->inv[r][c] = map->inv[r][c] + 0.0;
            out->inv_lo[r][c] = map->inv_lo[r][c] + 0.0;
        }
}

/* Slot that holds the map, or the empty slot for it. */
static uint32_t *slot_of(const map_table *t, const inverse_map *map)
{
    size_t i = (size_t)hash_bytes(0, map, sizeof *map) & (t->slot_count - 1);

    while (t->slots[i] && memcmp(&t->items[t->slots[i] - 1], map, sizeof *map) != 0)
        i = (i + 1) & (t->slot_count - 1);
    return &t->slots[i];
}

static bool grow(map_table *t, const env *e)
{
    const size_t count = t->slot_count ? 2 * t->slot_count : 64;
    uint32_t *slots = env_alloc(e, count, sizeof *slots);

    if (!slots)
        return false;
    env_free(e, t->slots);
    t->slots = slots;
    t->slot_count = count;
    for (size_t i = 0; i < t->count; i++)
        *slot_of(t, &t->items[i]) = (uint32_t)(i + 1);
    return true;
}

uint32_t map_table_add(map_table *t, const env *e, const pov_affine *map)
{
    inverse_map one;
    uint32_t *slot;

    if (2 * (t->count + 1) > t->slot_count && !grow(t, e))
        return 0;
    fill(&one, map);
    slot = slot_of(t, &one);
    if (!*slot) {
        if (!VEC_PUSH(e, t, one))
            return 0;
        *slot = (uint32_t)t->count;
    }
    return *slot;
}

void map_table_free(map_table *t, const env *e)
{
    env_free(e, t->items);
    env_free(e, t->slots);
    memset(t, 0, sizeof *t);
}
