/* cell_box.h - a box around what a shape's own test leaves of a larger one. */
#ifndef COMMON_CELL_BOX_H
#define COMMON_CELL_BOX_H

#include "common/local.h"

/* False: nothing of the shape is in the cell. */
typedef bool common_may_hold(const void *shape, const pov_box *cell);

/* The box around all cells that may hold some of it, of sixteen along each axis. False: none does. */
bool common_cell_box(const void *shape, const pov_box *whole, common_may_hold *may_hold, pov_box *out);

#endif
