/* affine.h - affine maps with double-double entries, for shapes that absorb them. */
#ifndef COMMON_AFFINE_H
#define COMMON_AFFINE_H

#include <povtrace/exact.h>

static inline pov_two common_entry(const pov_affine *map, int row, int column)
{
    return pov_two_of(map->m[row][column], map->m_lo[row][column]);
}

static inline pov_two common_inverse_entry(const pov_affine *map, int row, int column)
{
    return pov_two_of(map->inv[row][column], map->inv_lo[row][column]);
}

/* Linear part of the map, or of its inverse, row by row. */
void common_linear(const pov_affine *map, pov_two3 rows[3]);
void common_inverse_linear(const pov_affine *map, pov_two3 rows[3]);

pov_two3 common_map_point(const pov_affine *map, pov_two3 p);

/* Does the map keep all angles, to within 2^-90? Then *factor is its factor of lengths. */
bool common_is_similarity(const pov_affine *map, pov_two *factor);

/* Has each row of the linear part only one entry, so that boxes stay boxes? axis[i] is the column of that entry in row
 * i. */
bool common_is_axial(const pov_affine *map, int axis[3]);

/* Upper estimate of the ratio of the largest to the smallest stretch: the product of the largest entries of the map and
 * its inverse. */
double common_condition(const pov_affine *map);

#endif
