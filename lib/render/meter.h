/* meter.h - what the cells of a tile take of the processor's time, where somebody asks for it. */
#ifndef RENDER_METER_H
#define RENDER_METER_H

#include "render/cells.h"
#include "render/worker.h"

struct meter {
    double since;                      /* the clock of the worker's thread at the last reading */
    double spent[TILE_CELLS_MAX];      /* seconds, by the claimed tile's cells */
};

/* Each takes NULL, for nobody asks: then no clock is read. */
/* A tile has been claimed. */
void meter_begin(meter *m);
/* The time since the last reading went into these cells of the tile, alike; one may be there many times. */
void meter_cells(meter *m, const int *of, uint32_t count);
/* It went into the pixels of a lattice within a square of the tile, alike. */
void meter_square(meter *m, pov_rect tile, lattice l, int left, int top, int edge);

#endif
