/* map_table.h - deduplicated maps that are still needed after shapes have absorbed their transformations: from the
 * world, or from object space, to the space in which a texture was written. */
#ifndef MODEL_MAP_TABLE_H
#define MODEL_MAP_TABLE_H

#include "base/env.h"

#include <povtrace/math.h>

#include <stdint.h>

/* p' = inv p with p = (x, y, z, 1), as in pov_affine. */
typedef struct inverse_map { double inv[3][4], inv_lo[3][4]; } inverse_map;

typedef struct map_table {
    inverse_map *items;
    size_t count, capacity;
    uint32_t *slots;             /* a hash table of the items: number, 0 is empty */
    size_t slot_count;
} map_table;

/* Add a map; the number of its inverse, from 1 on; 0: no memory. */
uint32_t map_table_add(map_table *t, const env *e, const pov_affine *map);
void map_table_free(map_table *t, const env *e);

/* NULL for number 0, which stands for the identity. */
static inline const inverse_map *map_table_at(const map_table *t, uint32_t number)
{
    return number ? &t->items[number - 1] : NULL;
}

#endif
