/* cells.h - the cells of a grid over a box in which a function of the scene may pass a threshold: found once, when the scene
 * loads, by the function's bounds. Rays ask nothing elsewhere. */
#ifndef COMMON_CELLS_H
#define COMMON_CELLS_H

#include "common/level.h"

enum { COMMON_CELLS_LEVELS = 4, COMMON_CELLS = 1 << COMMON_CELLS_LEVELS };   /* along each axis */

typedef enum common_cell { COMMON_CELL_ABOVE, COMMON_CELL_BELOW, COMMON_CELL_OPEN } common_cell;

typedef struct common_cells {
    pov_vec3 lo, size, per_size;         /* of a cell, and the inverse */
    pov_vec3 from, to;                   /* a box of all cells that are not above */
    const uint8_t *kind;                 /* common_cell by x + COMMON_CELLS (y + COMMON_CELLS z) */
} common_cells;

/* `is_outside`: does a box lie outside the container? Such cells are above. False after an error. */
bool common_cells_make(common_cells *c, const pov_host *host, pov_reader *in, const pov_function_bounds *f, double threshold,
                       pov_box box, bool (*is_outside)(const void *user, pov_vec3 middle, pov_vec3 half), const void *user);
common_cell common_cells_kind(const common_cells *c, pov_vec3 at);
/* common_level_search() from lo to hi within the box. */
bool common_cells_search(const common_cells *c, common_level *n, double lo, double hi);

#endif
