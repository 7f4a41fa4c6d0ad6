/* map_table.h - deduplicated maps that are still needed after shapes have absorbed their transformations: from the
 * world, or from object space, to the space in which a texture was written.
 *
 * Many objects are copies of one that are only moved: their maps share a linear part, and have a translation each. */
#ifndef MODEL_MAP_TABLE_H
#define MODEL_MAP_TABLE_H

#include "base/env.h"

#include <povtrace/math.h>

#include <stdint.h>

typedef struct linear_map { double m[3][3], m_lo[3][3]; } linear_map;

/* p' = linear p + move, as the inverse in pov_affine. */
typedef struct inverse_map { const linear_map *linear; double move[3], move_lo[3]; } inverse_map;

/* A map of an object whose move has no low part, and one whose move is three short decimal or binary fractions: as words, so
 * that nothing is lost to alignment. */
typedef struct moved_map { uint32_t word[7]; } moved_map;
typedef struct short_map { uint32_t word[3]; } short_map;

typedef struct moved_maps { moved_map *items; size_t count, capacity; } moved_maps;
typedef struct short_maps { short_map *items; size_t count, capacity; } short_maps;

/* Hash table of records: number, 0 is empty. */
typedef struct map_slots { uint32_t *at; size_t count; } map_slots;

typedef struct map_table {
    inverse_map *items;
    size_t count, capacity;
    linear_map **linear;         /* each is allocated by itself, so that items may refer to it */
    size_t linear_count, linear_capacity;
    map_slots slots, linear_slots;
    moved_maps moved;            /* of objects; consecutive ones that are equal are one */
    short_maps brief;
} map_table;

/* Add a map; the number of its inverse, from 1 on; 0: no memory. */
uint32_t map_table_add(map_table *t, const env *e, const pov_affine *map);
/* The same of an object, of which there may be millions, in the fewest bytes; for map_table_read() only. */
uint32_t map_table_add_own(map_table *t, const env *e, const pov_affine *map);
/* The map of an object, which may be written to `space`. NULL for number 0, which stands for the identity. */
const inverse_map *map_table_read(const map_table *t, uint32_t number, inverse_map *space);
void map_table_free(map_table *t, const env *e);

/* NULL for number 0, which stands for the identity. */
static inline const inverse_map *map_table_at(const map_table *t, uint32_t number)
{
    return number ? &t->items[number - 1] : NULL;
}

#endif
