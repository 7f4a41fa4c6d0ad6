/* budget.h - how many samples each group shall have after the next pass. */
#ifndef RENDER_BUDGET_H
#define RENDER_BUDGET_H

#include "render/cells.h"
#include "render/settings.h"

/* Samples that every pixel has before an estimate steers anything, and on average before one ends anything: a thing that
 * the first ones missed. */
enum { BUDGET_PILOT = 4, BUDGET_LEAST = 8 };

/* Set the targets, from what the cells have shown so far and nothing else. `scratch` has room for a number a group.
 * False: none may have more. */
bool budget_next(cells *c, const settings *s, const pov_pass *now, double *scratch);

#endif
