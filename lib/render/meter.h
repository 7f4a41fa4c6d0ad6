/* meter.h - processor time of the cells of a tile, where it is asked for. */
#ifndef RENDER_METER_H
#define RENDER_METER_H

#include "render/cells.h"
#include "render/worker.h"

struct meter {
    double since;                      /* the clock of the worker's thread at the last reading */
    double spent[TILE_CELLS_MAX];      /* seconds, by the claimed tile's cells */
};

/* Each accepts NULL: then no clock is read. */
/* A tile has been claimed. */
void meter_begin(meter *m);
/* Add the time since the last reading to these cells of the tile, in equal shares; a cell may be listed several
 * times. */
void meter_cells(meter *m, const int *of, uint32_t count);
/* Add it to the pixels of a lattice within a block of the tile, in equal shares. */
void meter_block(meter *m, pov_rect tile, lattice l, int left, int top, int width, int height);

#endif
