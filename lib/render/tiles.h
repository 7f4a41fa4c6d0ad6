/* tiles.h - a picture cut into squares, and the order in which they are traced. */
#ifndef RENDER_TILES_H
#define RENDER_TILES_H

#include "base/env.h"

#include <povtrace/render.h>

/* Edges are multiples of the coarsest lattice of a preview, so that every tile holds whole lattices. */
enum { TILE_EDGE_MIN = 16, TILE_EDGE_MAX = 128 };

typedef struct tiles {
    int width, height;           /* of the picture, pixels */
    int edge, columns, rows;
    size_t count;
    uint32_t *order;             /* from the centre of the picture outwards; by tiles_sort() */
    size_t own;                  /* that many of the order are traced: all of them, or those of a part */
} tiles;

/* Choose tiles small enough that `threads` threads have even work to the end, and few enough to be cheap to hand
 * out. together: pixels have something to do with their neighbours, and every tile's edge costs. */
void tiles_make(tiles *t, int width, int height, int threads, bool together);
/* False: no memory. */
bool tiles_sort(tiles *t, const env *e);
/* Leave in the order only the tiles of the part-th of so many parts, which are spread evenly; it does not begin at the
 * centre. */
void tiles_deal(tiles *t, int part, int parts);
void tiles_free(tiles *t, const env *e);
/* The last column and row may be narrower. */
pov_rect tiles_rect(const tiles *t, size_t index);

/* One pass over a tile: pixels at multiples of `step` from its corner. finer: a coarser pass has traced multiples of 2 step;
 * they are left out, or traced again if `again`. */
typedef struct lattice { int step; bool finer, again; } lattice;

static inline bool lattice_has(lattice l, int x, int y)
{
    int coarser = 2 * l.step - 1;

    return ((x | y) & (l.step - 1)) == 0 && (!l.finer || l.again || ((x | y) & coarser) != 0);
}

/* Those that no coarser pass has traced. */
size_t lattice_pixels(lattice l, int width, int height);

#endif
