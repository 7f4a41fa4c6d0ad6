/* affine.h - maps with two-part entries, for shapes that take them in. */
#ifndef KIT_AFFINE_H
#define KIT_AFFINE_H

#include <povtrace/exact.h>

static inline pov_two kit_entry(const pov_affine *map, int row, int column)
{
    return pov_two_of(map->m[row][column], map->m_lo[row][column]);
}

static inline pov_two kit_inverse_entry(const pov_affine *map, int row, int column)
{
    return pov_two_of(map->inv[row][column], map->inv_lo[row][column]);
}

/* The linear part of the map, or of its inverse, row by row. */
void kit_linear(const pov_affine *map, pov_two3 rows[3]);
void kit_inverse_linear(const pov_affine *map, pov_two3 rows[3]);

pov_two3 kit_map_point(const pov_affine *map, pov_two3 p);

/* Does the map keep all angles, to within 2^-90? Then *factor is what it multiplies lengths with. */
bool kit_is_similarity(const pov_affine *map, pov_two *factor);

/* Has each row of the linear part just one entry, so that boxes stay boxes? axis[i] is the column of row
 * i's. */
bool kit_is_axial(const pov_affine *map, int axis[3]);

/* Largest over smallest stretch, roughly: the product of the largest entries of the map and its inverse. */
double kit_condition(const pov_affine *map);

#endif
