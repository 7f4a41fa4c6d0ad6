/* pavement.h - the plane in tiles of several equal cells: triangles, squares or hexagons with sides of length 1. */
#ifndef TEXTURE_PAVEMENT_H
#define TEXTURE_PAVEMENT_H

#include <stdint.h>

enum { PAVING_CELLS = 6 };       /* of a tile, at most */

/* Walls between tiles repeat after `across` cells, and after `along` rows moved by `shift` cells. A digit a cell, row by
 * row: bit k is the wall at its side number k, in
 *   squares    towards x, z; cell (i, j) begins at (i, j)
 *   hexagons   at 30, 90, 150 degrees from x towards z; their middles are (1 + 3/2 i, sqrt(3) (j + i/2))
 *   triangles  at 30, 150, 270 degrees, of those that point towards z; they begin at (i + j/2, sqrt(3)/2 j)
 * The other sides are those of the neighbours. */
typedef struct paving { uint8_t across, along, shift; const char *walls; } paving;

/* Tiles of 1, 2, ... cells: how many there are of each; 0: none. */
typedef struct paving_set { uint32_t count; uint8_t patterns[PAVING_CELLS]; const paving *of; } paving_set;

extern const paving_set paving_triangles, paving_squares, paving_hexagons;

#endif
