/* budget_singles.h - the number of samples of each pixel after the next pass, where pixels have counts of their own. */
#ifndef RENDER_BUDGET_SINGLES_H
#define RENDER_BUDGET_SINGLES_H

#include "render/cells.h"

/* The mean count that a pass aims at: this or less, but not below `fewest`, where that suffices for the requested error
 * (`square`; 0: none). */
typedef struct goal { double mean, fewest, square; } goal;

/* Columns and rows of the least picture for that. */
enum { BUDGET_SINGLES_LEAST_EDGE = 4 };

/* Let each pixel have a count of its own. False: no memory. */
bool budget_singles_make(cells *c, const env *e);
/* Set the targets; no pixel gets fewer than `least`. False: none gets more than it has. */
bool budget_singles_next(cells *c, const goal *g, uint32_t least);
/* All pixels get `target` or what they have. False: none gets more. */
bool budget_singles_all(cells *c, uint32_t target);

#endif
